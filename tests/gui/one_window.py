"""One window for all tests of a module: it is made like new, or else a new one is made."""

from dataclasses import dataclass, field
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QDockWidget,
    QLineEdit,
)

from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.app import build_window
from procc_annotator.gui.commands.dialogs import DialogTask
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.state import DEFAULT_TAU


@dataclass
class OneWindow:
    """Lends a window; it is shown all the time, which is most of what a window costs."""

    _window: MainWindow | None = None
    _new: dict[str, object] = field(default_factory=dict)

    def lend(self, path: Path) -> MainWindow:
        """A window that nothing tells from a new one, with a dataset."""
        window = self._like_new()
        before = window.services.state.workspace
        window.opening.open_path(path)
        if window.services.state.workspace is before is not None:  # it keeps what cannot be saved
            self.end()
            window = self._like_new()
            window.opening.open_path(path)
        return window

    def _like_new(self) -> MainWindow:
        window = self._window
        if window is not None and (
            window.settings._store.allKeys() or not _like_new(window, self._new)
        ):
            self.end()
            window = None
        if window is None:
            window = self._window = build_window()
            window.show()
            QApplication.processEvents()
            window.cameras.list.refresh()  # as it is between tests, when its panel is not seen
            self._new = _settings_of(window)
        return window

    def end(self) -> None:
        """Close it; nothing of it is left, nor is anything remembered."""
        if self._window is not None:
            store = self._window.settings._store
            kept = {key: store.value(key) for key in store.allKeys()}
            self._window.services.close()
            self._window.services.saver.set_workspace(None)  # a test that failed would be asked
            self._window.close()
            self._window.deleteLater()
            self._window = None
            QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
            store.clear()
            for key, value in kept.items():
                store.setValue(key, value)


def _like_new(window: MainWindow, new: dict[str, object]) -> bool:
    """Take back what a test chose; whether that is all."""
    if not window.isVisible():  # closed, which ends its services
        return False
    for other in QApplication.topLevelWidgets():
        if other is not window and other.isVisible():
            other.close()
    services = window.services
    if services.state.workspace is not None and services.review.database is None:
        return False  # the services alone were closed
    for task in window.findChildren(DialogTask):
        task._leave()  # as another dataset has them do
    services.camera_sources.clear_sources()
    window.cameras.list.refresh()  # or its rows stay until the panel is seen, and are found by name
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
    services.evaluation.take_field(new["field"])
    services.evaluation.set_noise_floor(None)
    services.set_author(new["state"][-1])
    services.selection.set_mode("draw")
    services.selection.select_class(None)
    # Of several that exclude each other, the one that was chosen goes first.
    for name, checked in sorted(_switches(window).items(), key=lambda item: not new[item[0]]):
        if name == "lock_blind":  # asks, and the next dataset has its own
            continue
        if checked != new[name] and window.actions_[name].isChecked() != new[name]:
            window.actions_[name].trigger()
    services.evaluation.set_tau(DEFAULT_TAU)
    services.evaluation.set_protocol(new["terms"][0], off_plane=new["terms"][1])
    services.live_fit.set_model(new["model"])
    services.fit_source.preferred = False
    for edit in window.findChildren(QLineEdit):
        if f"text {edit.objectName()}" in new or edit.objectName().startswith("landmark"):
            edit.clear()
    for combo in window.findChildren(QComboBox):
        index = new.get(f"choice {combo.objectName()}")
        if index not in (None, combo.currentIndex()):
            combo.setCurrentIndex(index)
    for button in window.findChildren(QAbstractButton):
        if button.isChecked() is not new.get(f"button {button.objectName()}", button.isChecked()):
            button.click()
    for page in window.plots._made.values():  # they keep what was chosen in them
        page.setParent(None)
        page.deleteLater()
    window.plots._made.clear()
    window.plots._turn_page()
    window.canvas.comparison.split.move_to(window.canvas.viewport().width() / 2)
    if _layout_of(window) != new["layout"]:
        window.panels.reset_layout()
    window.message_bar.hide()
    window.message_bar.label.clear()
    window.status.forget(just_told=True)
    now = _settings_of(window)
    return {name: now.get(name) for name in new} == new  # rows come and go with what they are of


def _settings_of(window: MainWindow) -> dict[str, object]:
    """Everything somebody can choose in a window, whatever is open in it."""
    state, canvas = window.services.state, window.canvas
    found: dict[str, object] = {
        "state": (state.mode, state.options, state.tau, state.blind, state.sources, state.author),
        "terms": (state.setup.protocol, state.setup.off_plane, state.noise_floor),
        "selected": state.selection,
        "field": state.setup.field,
        "model": window.services.live_fit.model,
        "canvas": (canvas.keep_zoom, canvas.loupe_always),
        "drawing": (canvas.drawing.colour_by, canvas.drawing.hidden),
        "layout": _layout_of(window),
    }
    found |= _switches(window)
    for edit in window.findChildren(QLineEdit):
        of_dataset = edit.objectName().startswith("landmark")
        if edit.objectName() and not of_dataset and not isinstance(edit.parent(), QAbstractSpinBox):
            found[f"text {edit.objectName()}"] = edit.text()
    for combo in window.findChildren(QComboBox):
        if combo.objectName():
            # One that is filled when it is first seen stands on its first choice then.
            found[f"choice {combo.objectName()}"] = max(combo.currentIndex(), 0)
    for button in window.findChildren(QAbstractButton):
        if button.objectName() and button.isCheckable():
            found[f"button {button.objectName()}"] = button.isChecked()
    found["dialogs"] = len(window.findChildren(QDialog))
    return found


def _switches(window: MainWindow) -> dict[str, bool]:
    actions = {spec.name: window.actions_[spec.name] for spec in ACTIONS}
    return {name: action.isChecked() for name, action in actions.items() if action.isCheckable()}


def _layout_of(window: MainWindow) -> tuple[object, ...]:
    """Which panels are hidden, which are in sight, and which another kind of work will show."""
    docks = window.findChildren(QDockWidget)
    shown = {d.objectName(): (d.isHidden(), not d.visibleRegion().isEmpty()) for d in docks}
    left = {name: (look.open, look.front) for name, look in window.panels._looks.items()}
    return shown, left
