"""What the window says of the frame and of what went wrong: bars, status line, title."""

from __future__ import annotations

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QMainWindow

from procc_annotator.gui.messages import ConflictBar, FrameBar, MessageBar
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.messages import UNSAVED, Told
from procc_annotator.gui.state.state import State
from procc_annotator.gui.window.status import StatusLine
from procc_annotator.translation import tr

_TITLE = "ProCC Annotator[*]"  # not shown


class Telling(QObject):
    """Puts each thing that is said in its place: what matters stays until it is dealt with."""

    def __init__(
        self,
        document: Document,
        bars: tuple[MessageBar, FrameBar, ConflictBar],
        status: StatusLine,
        window: QMainWindow,
    ) -> None:
        super().__init__(window)
        self._document, self._status, self._window = document, status, window
        self._messages, self._frame_bar, self._conflicts = bars
        document.datasetChanged.connect(self._messages.hide)
        document.frameChanged.connect(self._tell_frame)
        document.annotationChanged.connect(self._tell_broken)
        document.saveStateChanged.connect(self._tell_saved)
        document.frameChanged.connect(self._tell_saved)
        document.modeChanged.connect(self._tell_broken)
        document.frameChanged.connect(lambda: status.forget())
        document.blindChanged.connect(self._hide_told)
        document.store.watch(lambda state: state.notices, self._messages.keep)
        document.store.changed.connect(self._hear)  # a watch would miss lines said together
        self._conflicts.reload_chosen.connect(document.editing.reload_frame)
        self._conflicts.overwrite_chosen.connect(document.editing.overwrite_frame)
        self._tell_frame()
        self._tell_saved()

    def _tell_frame(self) -> None:
        if not self._document.saver.problems:
            self._messages.grow_old()  # it was said of the frame before
        self._tell_broken()

    def _tell_broken(self) -> None:
        self._frame_bar.tell(self._document.state.why_not_editable)

    def _tell_saved(self) -> None:
        saver, frame = self._document.saver, self._document.state.frame
        conflict = saver.conflict(self._document.state.frame_index)
        self._conflicts.tell(str(conflict) if conflict is not None else "")
        self._window.setWindowTitle(f"{frame.name}[*]" if frame is not None else _TITLE)
        self._window.setWindowModified(bool(saver.problems))

    def _hide_told(self, blind: bool) -> None:
        if blind:  # it may say how a camera does
            self._status.forget(just_told=True)

    def _hear(self, before: State, after: State) -> None:
        if after.told is not None and after.told is not before.told:
            self._tell(after.told)

    def _tell(self, told: Told) -> None:
        document = self._document
        conflict = document.saver.conflict(document.state.frame_index)
        if told.level == "info":
            self._status.tell(told.text)
        elif told.text == document.state.why_broken:
            self._status.tell(tr("not editable: the bar over the picture says why"))
        elif told.key != UNSAVED:
            # What is not saved stays in sight, whatever else fails meanwhile (a full disk fails
            # everything).
            unsaved = [notice for notice in document.state.notices if notice.key == UNSAVED]
            self._messages.tell(told, above=unsaved)
        elif conflict is None or told.text != str(conflict):  # that one has a bar of its own
            self._messages.tell(told)
