"""Settings of the window: values bound to actions and services, restored and saved."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QSize
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication, QMainWindow

from procc_annotator.dataset.records import default_author
from procc_annotator.gui import settings as rows
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.settings import SWITCHES, Setting, Settings, T
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.store import When
from procc_annotator.gui.theme import set_text_size, set_theme
from procc_annotator.gui.window.workspaces import Workspaces

# Settings that an action each sets: its name begins so, and ends with the value.
_CHOICES = {
    rows.PROTOCOL.key: "protocol",
    rows.OFF_PLANE.key: "off_plane",
    rows.COLOUR_BY.key: "colour",
}


@dataclass(frozen=True, slots=True)
class _Place:
    """Getter and setter of a setting; the setter is empty if an action sets it."""

    get: Callable[[], Any]
    put: Callable[[Any], object] = lambda value: None


class BoundSettings:
    """Reads and changes what the window does; what is kept nowhere else is kept in the file."""

    def __init__(
        self,
        settings: Settings,
        services: Services,
        canvas: Canvas,
        action: Callable[[str], QAction],
    ) -> None:
        self._settings, self._services = settings, services
        self._action = action
        self._places = _places(services, canvas)
        # A locked dataset may hold what a person chose for all of them.
        self._chosen: Mapping[str, Callable[[], bool]] = {
            "blind": lambda: services.blind_lock.wanted,
            "live_fit": lambda: services.live_fit.chosen,
        }
        # A program that is killed loses no choice, least of all blind mode.
        store = services.store
        store.watch(lambda s: (s.options, s.blind), self.write_down, When.AFTER_PAINT)

    def value(self, setting: Setting[T]) -> T:
        """Return what holds now."""
        if setting.key in SWITCHES:
            shown = self._action(setting.key).isChecked
            return self._chosen.get(setting.key, shown)()  # type: ignore[return-value]
        place = self._places.get(setting.key)
        return place.get() if place is not None else self._settings.get(setting)

    def change(self, setting: Setting[T], value: T) -> None:
        """Have something else hold from now on, and remember it."""
        self._settings.set(setting, value)
        self.take_up(setting)

    def take_up(self, setting: Setting[T]) -> None:
        """Have hold what is remembered."""
        value = self._settings.get(setting)
        key = setting.key
        if key in SWITCHES:
            if value != self._action(key).isChecked():
                self._action(key).trigger()
        elif key in _CHOICES:
            if value != self.value(setting):
                self._action(f"{_CHOICES[key]}_{value}").trigger()
        elif setting is rows.AUTHOR:
            self._services.set_author(str(value) or default_author())
        elif setting is rows.KEYS:
            self._services.store.update(keymap=value)
        elif setting is rows.THEME:
            set_theme(_application(), str(value))
        elif key in self._places:
            self._places[key].put(value)

    def take_up_all(self) -> None:
        """Have hold all that is remembered; how the application looks does already."""
        for setting in (rows.KEYS, *rows.OFFERED):
            if setting is not rows.THEME:
                self.take_up(setting)

    def write_down(self) -> None:
        """Remember all of them as they are."""
        for setting in rows.OFFERED:
            if setting.key in SWITCHES or setting.key in self._places:
                self._settings.set(setting, self.value(setting))


def apply_appearance(settings: Settings) -> None:
    """Have the application look as it is remembered, before anything of it is made."""
    if (theme := settings.get(rows.THEME)) != rows.THEME.default:
        set_theme(_application(), theme)
    set_text_size(_application(), settings.get(rows.FONT_PERCENT))


def _application() -> QApplication:
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    return application


def _places(services: Services, canvas: Canvas) -> dict[str, _Place]:
    fit_source = services.fit_source

    def prefer(fit: bool) -> None:
        fit_source.preferred = fit

    return {
        rows.TAU.key: _Place(lambda: services.state.tau, services.evaluation.set_tau),
        rows.PROTOCOL.key: _Place(lambda: services.state.setup.protocol),
        rows.OFF_PLANE.key: _Place(lambda: services.state.setup.off_plane),
        rows.COLOUR_BY.key: _Place(lambda: canvas.drawing.colour_by),
        rows.FIT_MODEL.key: _Place(lambda: services.live_fit.model, services.live_fit.set_model),
        rows.JUDGE_FIT.key: _Place(lambda: fit_source.preferred, prefer),
    }


_SIZE = QSize(1440, 900)
_AROUND = QSize(16, 48)  # what a desktop puts around a window, and its title; it tells too late


class WindowState:
    """Puts a window in the state it was left in."""

    def __init__(
        self,
        settings: Settings,
        window: QMainWindow,
        options: BoundSettings,
        workspaces: Workspaces,
    ) -> None:
        self._settings = settings
        self._window = window
        self._options = options
        self._workspaces = workspaces

    def take_up(self) -> None:
        """Give the window what is remembered."""
        settings, window = self._settings, self._window
        window.resize(_SIZE.boundedTo(window.screen().availableGeometry().size() - _AROUND))
        if not (geometry := settings.get(rows.GEOMETRY)).isEmpty():
            window.restoreGeometry(geometry)
            if self._workspaces.restore(settings.get(rows.LAYOUT)):
                self._workspaces.restore_kept(settings.get(rows.DESKS))
        self._options.take_up_all()

    def write_down(self) -> None:
        """Remember the window as it is."""
        settings = self._settings
        settings.set(rows.GEOMETRY, self._window.saveGeometry())
        settings.set(rows.LAYOUT, self._workspaces.state())
        settings.set(rows.DESKS, self._workspaces.kept())
        self._options.write_down()
        settings.sync()
