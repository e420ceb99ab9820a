"""Where the camera that is judged shows the paint of the field's lines, worked out next to."""

from __future__ import annotations

from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.judge import Judge
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.store import Store
from procc_annotator.metrics.projection import ProjectedField, project_markings
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.translation import tr


class PaintedWidth(Derived[ProjectedField]):
    """The borders of painted lines, once a person wants to see them."""

    def __init__(self, store: Store, signals: Signals, judge: Judge) -> None:
        super().__init__(self._made_of, _project, Where.BESIDE, store, wanted=False)
        self._store, self._judge = store, judge
        self.failed.connect(self._say)
        signals.scoreChanged.connect(self.try_again)
        signals.frameChanged.connect(self.try_again)

    def _made_of(self) -> Inputs | None:
        camera = self._judge.camera
        return None if camera is None else (camera, self._judge.frame_setup)

    def _say(self, text: str) -> None:
        say(self._store, tr("the painted width cannot be drawn: {why}", why=text), "warning")


def _project(camera: CameraOrProjections, setup: EvaluationSetup) -> ProjectedField | None:
    return project_markings(camera, setup)
