"""Where the camera that is judged shows the paint of the field's lines, worked out beside."""

from __future__ import annotations

from typing import TYPE_CHECKING

from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.metric.painted import project_paint
from procc_annotator.metric.project import ProjectedField
from procc_annotator.metric.setup import EvaluationSetup

if TYPE_CHECKING:
    from procc_annotator.gui.state.judged_frame import JudgedFrame


class PaintedWidth(Derived[ProjectedField]):
    """The borders of painted lines, once somebody wants to see them."""

    def __init__(self, document: JudgedFrame) -> None:
        super().__init__(self._made_of, _project, Where.BESIDE, document, wanted=False)
        self._document = document
        self.failed.connect(self._say)
        document.scoreChanged.connect(self.try_again)

    def _made_of(self) -> Inputs | None:
        camera = self._document.camera
        return None if camera is None else (camera, self._document.setup)

    def _say(self, text: str) -> None:
        self._document.message.emit(f"the painted width cannot be drawn: {text}", "warning")


def _project(camera: CameraOrProjections, setup: EvaluationSetup) -> ProjectedField | None:
    return project_paint(camera, setup)
