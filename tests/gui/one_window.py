"""One window for all tests of a module: it is made like new, or else a new one is made."""

from __future__ import annotations

from dataclasses import dataclass, field

from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtWidgets import QAbstractSpinBox, QApplication, QDockWidget, QLineEdit, QTabBar

from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.app import build_window
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.state import DEFAULT_TAU


@dataclass
class OneWindow:
    """Lends a window; it is shown all the time, which is most of what a window costs."""

    _window: MainWindow | None = None
    _new: dict[str, object] = field(default_factory=dict)

    def lend(self) -> MainWindow:
        """A window that nothing tells from a new one."""
        window = self._window
        if window is not None and not _like_new(window, self._new):
            self.end()
            window = None
        if window is None:
            window = self._window = build_window()
            window.show()
            QApplication.processEvents()
            self._new = _settings_of(window)
        return window

    def end(self) -> None:
        """Close it; nothing of it is left."""
        if self._window is not None:
            self._window.document.close()
            self._window.close()
            self._window.deleteLater()
            self._window = None
            QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)


def _like_new(window: MainWindow, new: dict[str, object]) -> bool:
    """Take back what a test chose; whether that is all."""
    if not window.isVisible():  # closed, which ends its services
        return False
    for other in QApplication.topLevelWidgets():
        if other is not window and other.isVisible():
            other.close()
    document = window.document
    window.settings._store.clear()
    document.camera_sources.clear_sources()
    document.set_noise_floor(None)
    document.set_mode("draw")
    document.select_class(None)
    # Of several that exclude each other, the one that was chosen goes first.
    for name, checked in sorted(_switches(window).items(), key=lambda item: not new[item[0]]):
        if checked != new[name] and window.actions_[name].isChecked() != new[name]:
            window.actions_[name].trigger()
    document.set_tau(DEFAULT_TAU)
    document.live_fit.set_model(new["model"])
    document.fit_source.preferred = False
    if _layout_of(window) != new["layout"]:
        window.reset_layout()
    window.frames.filter.clear()
    window.message_bar.hide()
    window.status.forget(just_told=True)
    return _settings_of(window) == new


def _settings_of(window: MainWindow) -> dict[str, object]:
    """Everything somebody can choose in a window, whatever is open in it."""
    state, canvas = window.document.state, window.canvas
    found: dict[str, object] = {
        "state": (state.mode, state.options, state.tau, state.blind, state.sources, state.author),
        "terms": (state.setup.protocol, state.setup.off_plane, state.noise_floor),
        "selected": state.selection,
        "model": window.document.live_fit.model,
        "canvas": (canvas.colour_by, canvas.keep_zoom, canvas.overlays_hidden, canvas.loupe_always),
        "layout": _layout_of(window),
    }
    found |= _switches(window)
    for edit in window.findChildren(QLineEdit):
        if edit.objectName() and not isinstance(edit.parent(), QAbstractSpinBox):
            found[f"text {edit.objectName()}"] = edit.text()
    return found


def _switches(window: MainWindow) -> dict[str, bool]:
    actions = {spec.name: window.actions_[spec.name] for spec in ACTIONS}
    return {name: action.isChecked() for name, action in actions.items() if action.isCheckable()}


def _layout_of(window: MainWindow) -> tuple[dict[str, bool], list[str]]:
    """Which panels are hidden, and which are in front of their tabs."""
    hidden = {dock.objectName(): dock.isHidden() for dock in window.findChildren(QDockWidget)}
    tabs = window.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)
    return hidden, sorted(tab.tabText(tab.currentIndex()) for tab in tabs if tab.isVisible())
