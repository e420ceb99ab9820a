"""Where the camera that is judged shows the paint of the field's lines, worked out beside."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.gui.worker import Job, run_in_background
from procc_annotator.metric.painted import project_paint
from procc_annotator.metric.project import ProjectedField
from procc_annotator.metric.setup import EvaluationSetup

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document

_Asked = tuple[CameraOrProjections, EvaluationSetup]


class PaintedWidth(QObject):
    """The borders of painted lines while somebody wants to see them; never those of another camera
    or field than the ones that are shown.

    Attributes:
        wanted: whether somebody wants to see them.
    """

    changed = Signal()

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.wanted = False
        self._asked: _Asked | None = None
        self._found: ProjectedField | None = None
        self._job: Job | None = None
        self._told = ""  # what failed: it is tried again at every look, and told once
        document.scoreChanged.connect(self.look)

    @property
    def shown(self) -> ProjectedField | None:
        """What to draw; None while it is worked out, and where there is nothing."""
        return self._found if self._asked is not None else None

    def set_shown(self, shown: bool) -> None:
        """Draw the painted width, or do not."""
        if shown != self.wanted:
            self.wanted, self._told = shown, ""
            self.look()

    def look(self) -> None:
        """The camera, the frame or the field may be another one."""
        camera, setup = self._document.camera, self._document.setup
        if not self.wanted or camera is None:
            self._forget()
            return
        asked = camera, setup
        before = self._asked
        if before is not None and before[0] is camera and before[1] is setup:
            return
        self._forget(tell=False)
        self._asked = asked
        self._job = run_in_background(
            lambda _: project_paint(*asked),
            on_result=partial(self._take, asked),
            on_error=partial(self._fail, asked),
            owner=self,
            urgent=True,
        )
        if before is not None:
            self.changed.emit()

    def close(self) -> None:
        """Work nothing out any more."""
        self.wanted = False
        self._forget(tell=False)

    def _take(self, asked: _Asked, found: ProjectedField | None) -> None:
        if asked is self._asked:
            self._job, self._found, self._told = None, found, ""
            self.changed.emit()

    def _fail(self, asked: _Asked, text: str) -> None:
        if asked is not self._asked:
            return
        self._job = self._asked = None
        if text != self._told:
            self._told = text
            self._document.message.emit(f"the painted width cannot be drawn: {text}", "warning")

    def _forget(self, *, tell: bool = True) -> None:
        if self._job is not None:
            self._job.cancel()
        had = self._found
        self._asked = self._found = self._job = None
        if tell and had is not None:
            self.changed.emit()
