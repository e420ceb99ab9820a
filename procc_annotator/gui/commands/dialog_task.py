"""Tasks that ask in a dialog about the open dataset; dialog and work end with the dataset."""

from __future__ import annotations

from typing import Protocol

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import LatestOnlyTask, Priority
from procc_annotator.gui.state.services import Services


class TaskDialog(Protocol):
    """Interface of such a dialog."""

    def set_running(self, running: bool) -> None:
        """Show whether the work is running."""
        ...

    def tell(self, text: str, /) -> None:
        """Say what came of it."""
        ...

    def blockSignals(self, block: bool) -> bool: ...
    def hide(self) -> None: ...
    def deleteLater(self) -> None: ...


class DialogTask(QObject):
    """Shows one dialog at a time, and what became of the work it asked for."""

    def __init__(
        self, services: Services, parent: QWidget, *, priority: Priority = Priority.LOW
    ) -> None:
        """Nothing is shown yet.

        Args:
            services: whose dataset the dialog is about.
            parent: the dialog's.
            priority: of its work.
        """
        super().__init__(parent)
        self._services = services
        self._parent = parent
        self._work = LatestOnlyTask(self, self._fail, priority=priority)
        self.dialog: TaskDialog | None = None
        services.store.watch(select.dataset, self._leave)

    def _leave(self) -> None:
        """Put the dialog away, and forget its work."""
        self._work.cancel()
        dialog, self.dialog = self.dialog, None
        if dialog is not None:
            dialog.blockSignals(True)
            dialog.hide()
            dialog.deleteLater()

    def _fail(self, text: str) -> None:
        if self.dialog is not None:
            self.dialog.set_running(False)
            self.dialog.tell(text)
