"""Dialogs about the open dataset, and tasks that ask in one; both end with the dataset."""

from __future__ import annotations

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QProgressBar, QPushButton, QWidget

from procc_annotator.gui.panels.widgets import note_label, show_note
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import LatestOnlyTask, Priority
from procc_annotator.gui.state.services import Services

CANCEL, CLOSE = QDialogButtonBox.StandardButton.Cancel, QDialogButtonBox.StandardButton.Close


def dialog_buttons(
    dialog: QDialog,
    verb: str | QDialogButtonBox.StandardButton,
    leave: QDialogButtonBox.StandardButton = CANCEL,
) -> tuple[QDialogButtonBox, QPushButton]:
    """Return the buttons of a dialog, and the one that Enter presses: it accepts the dialog, or
    does something in it if the other one closes it."""
    buttons = QDialogButtonBox(leave, dialog)
    buttons.button(leave).setAutoDefault(False)
    roles = QDialogButtonBox.ButtonRole
    if isinstance(verb, str):
        does = buttons.addButton(verb, roles.AcceptRole if leave is CANCEL else roles.ActionRole)
    else:
        does = buttons.addButton(verb)
    does.setDefault(True)
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    return buttons, does


class NamedDialog(QDialog):
    """A dialog with an object name and a title."""

    def __init__(self, parent: QWidget | None, name: str, title: str) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setWindowTitle(title)


class TaskDialog(NamedDialog):
    """Shows the progress of the work that it asked for, and its outcome."""

    def __init__(self, parent: QWidget, name: str, title: str) -> None:
        super().__init__(parent, name, title)
        self.bar = QProgressBar(self)
        self.bar.hide()
        self.note = note_label(f"{name}_note")

    def set_running(self, running: bool) -> None:
        """Show whether the work is running."""
        self.bar.setVisible(running)
        self.bar.setRange(0, 0)

    def advance(self, done: int, total: int) -> None:
        """Show the progress of the work."""
        self.bar.setRange(0, total)
        self.bar.setValue(done)

    def tell(self, text: str) -> None:
        """Show the outcome."""
        show_note(self.note, text)


class DialogTask(QObject):
    """Shows one dialog at a time, and the outcome of the work it asked for."""

    def __init__(
        self, services: Services, parent: QWidget, *, priority: Priority = Priority.LOW
    ) -> None:
        super().__init__(parent)
        self._services = services
        self._parent = parent
        self._work = LatestOnlyTask(self, self._fail, priority=priority)
        self.dialog: TaskDialog | None = None
        services.store.watch(select.dataset, self._leave)

    def _leave(self) -> None:
        self._work.cancel()
        dialog, self.dialog = self.dialog, None
        if dialog is not None:
            dialog.blockSignals(True)
            dialog.hide()
            dialog.deleteLater()

    def _fail(self, text: str) -> None:
        if self.dialog is None:
            self._services.say(text, "error")
        else:
            self.dialog.set_running(False)
            self.dialog.tell(text)
