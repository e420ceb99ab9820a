"""Unexpected errors, shown as a message with a button that copies their details."""

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

from procc_annotator import error_log
from procc_annotator.gui.state.document import Document
from procc_annotator.translation import tr


class ErrorReports(QObject):
    """Shows what `error_log` reports. The event loop goes on, and with it saving."""

    _happened = Signal(str, str)  # perhaps in another thread

    def __init__(self, document: Document, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._details = document, ""
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
        self._document.say(text)

    def _show(self, line: str, details: str) -> None:
        self._details = details
        text = tr("unexpected error ({what}); saving goes on, the details are in {path}",
                  what=line, path=error_log.log_path())  # fmt: skip
        self._document.say(text, "error", remedy="copy_error")


def _log_qt(kind: QtMsgType, _: QMessageLogContext, text: str) -> None:
    if kind not in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg):
        error_log.log_line(f"Qt: {text}")  # not shown
    if sys.stderr is not None:
        print(text, file=sys.stderr)
