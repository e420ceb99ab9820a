"""Routing of messages and unexpected errors to the bars and the status bar."""

from __future__ import annotations

import sys

from PySide6.QtCore import (
    QMessageLogContext,
    QObject,
    Qt,
    QtMsgType,
    Signal,
    qInstallMessageHandler,
)
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QMainWindow

from procc_annotator import error_log
from procc_annotator.gui.messages import ConflictBar, FrameBar, MessageBar
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.messages import Message
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import UNSAVED
from procc_annotator.gui.window.status import StatusLine
from procc_annotator.translation import tr

_TITLE = "ProCC Annotator[*]"  # not shown


class MessageRouter(QObject):
    """Puts each thing that is said in its place: what matters stays until it is dealt with."""

    def __init__(
        self,
        services: Services,
        bars: tuple[MessageBar, FrameBar, ConflictBar],
        status: StatusLine,
        window: QMainWindow,
    ) -> None:
        super().__init__(window)
        self._services, self._status, self._window = services, status, window
        self._messages, self._frame_bar, self._conflicts = bars
        services.store.watch(select.dataset, self._messages.hide)
        services.store.watch(select.frame, self._tell_frame)
        services.store.watch(select.annotation, self._tell_broken)
        services.store.watch(select.unsaved, self._tell_saved)
        services.store.watch(select.frame, self._tell_saved)
        services.store.watch(select.mode, self._tell_broken)
        services.store.watch(select.frame, status.forget)
        services.store.watch(select.blind, self._hide_told)
        services.store.watch(lambda s: s.notices, self._keep_notices)
        services.store.events.message.connect(self._tell)
        self._conflicts.reload_chosen.connect(services.editing.reload_frame)
        self._conflicts.overwrite_chosen.connect(services.editing.overwrite_frame)
        self._tell_frame()
        self._tell_saved()

    def _tell_frame(self) -> None:
        if not self._services.saver.problems:
            self._messages.grow_old()  # it was said of the frame before
        self._tell_broken()

    def _tell_broken(self) -> None:
        self._frame_bar.tell(self._services.state.why_not_editable)

    def _tell_saved(self) -> None:
        saver, frame = self._services.saver, self._services.state.frame
        conflict = saver.conflict(self._services.state.frame_index)
        self._conflicts.tell(str(conflict) if conflict is not None else "")
        self._window.setWindowTitle(f"{frame.name}[*]" if frame is not None else _TITLE)
        self._window.setWindowModified(bool(saver.problems))

    def _hide_told(self) -> None:
        if self._services.state.blind:  # it may say how a camera does
            self._status.forget(just_told=True)

    def _keep_notices(self) -> None:
        self._messages.keep(self._services.state.notices)

    def _tell(self, message: Message) -> None:
        services = self._services
        conflict = services.saver.conflict(services.state.frame_index)
        if message.level == "info":
            self._status.tell(message.text)
        elif message.text == services.state.why_broken:
            self._status.tell(tr("not editable: the bar over the picture says why"))
        elif message.key != UNSAVED:
            # What is not saved stays in sight, whatever else fails meanwhile (a full disk fails
            # everything).
            unsaved = [notice for notice in services.state.notices if notice.key == UNSAVED]
            self._messages.tell(message, above=unsaved)
        elif conflict is None or message.text != str(conflict):  # that one has a bar of its own
            self._messages.tell(message)


class ErrorReports(QObject):
    """Shows what `error_log` reports. The event loop goes on, and with it saving."""

    _happened = Signal(str, str)  # perhaps in another thread

    def __init__(self, services: Services, parent: QObject) -> None:
        super().__init__(parent)
        self._services, self._details = services, ""
        self._happened.connect(self._show, Qt.ConnectionType.QueuedConnection)

    def install(self) -> None:
        """Report every unexpected error of this process here, and log the warnings of Qt."""
        error_log.install_handlers(self._happened.emit)
        qInstallMessageHandler(_log_qt)

    def copy(self) -> None:
        """Copy the details of the last unexpected error, or say that there was none."""
        path = error_log.log_path()
        if self._details:
            QGuiApplication.clipboard().setText(self._details)
            text = tr("the details are copied; they are in {path}, too", path=path)
        else:
            text = tr("there was no unexpected error; they are logged in {path}", path=path)
        self._services.say(text)

    def _show(self, line: str, details: str) -> None:
        self._details = details
        text = tr("unexpected error ({what}); saving goes on, the details are in {path}",
                  what=line, path=error_log.log_path())  # fmt: skip
        self._services.say(text, "error", remedy="copy_error")


def _log_qt(kind: QtMsgType, _: QMessageLogContext, text: str) -> None:
    if kind not in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg):
        error_log.log_line(f"Qt: {text}")  # not shown
    if sys.stderr is not None:
        print(text, file=sys.stderr)
