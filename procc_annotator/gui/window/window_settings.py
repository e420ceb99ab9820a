"""Settings of the window: bound to actions and services, restored, saved, and their dialog."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from PySide6.QtCore import QEvent, QSize, Qt, Signal
from PySide6.QtGui import QAction, QPalette
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFrame,
    QGridLayout,
    QLabel,
    QLineEdit,
    QMainWindow,
    QScrollArea,
    QSizePolicy,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.dataset.records import default_author
from procc_annotator.gui import settings as rows
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.panels.widgets import RangeBox, ScrolledContent, empty_state
from procc_annotator.gui.settings import (
    FLAG,
    NUMBER,
    OFFERED,
    SWITCHES,
    Setting,
    Settings,
    Shown,
    T,
)
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.store import When
from procc_annotator.gui.theme import set_text_size, set_theme
from procc_annotator.gui.window.workspaces import Workspaces
from procc_annotator.translation import tr

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


_DIALOG_SIZE = QSize(680, 640)
_MARGIN = 40  # of the window behind that stays in sight
_LINES = 18  # letters across a box


class SettingRow(QWidget):
    """One setting: its name, what is chosen, the way back to the default, what it does."""

    def __init__(self, setting: Setting[Any], options: BoundSettings, changed: Callable[[], None]):
        super().__init__()
        assert setting.shown is not None
        self.setting, self._shown = setting, setting.shown
        self._options, self._changed = options, changed
        self.setObjectName(f"setting_{setting.key}")
        self.editor = self._make_editor(setting.shown)
        title, text = tr(self._shown.title), tr(setting.text)
        self.editor.setAccessibleName(title)
        self.editor.setAccessibleDescription(text)
        self.back = QToolButton()
        self.back.setText("↺")
        default = self._words(setting.default)
        self.back.setToolTip(tr("{setting}: back to {value}", setting=title, value=default))
        self.back.setAccessibleName(self.back.toolTip())
        self.back.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.back.clicked.connect(lambda: self._take(setting.default))
        name = QLabel(title)
        name.setBuddy(self.editor)
        does = QLabel(text)
        does.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        does.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        does.setWordWrap(True)  # which says that its height follows from its width
        grid = QGridLayout(self)
        grid.setContentsMargins(8, 4, 4, 4)
        grid.setVerticalSpacing(1)
        grid.setColumnStretch(0, 1)
        grid.addWidget(name, 0, 0)
        grid.addWidget(self.editor, 0, 1)
        grid.addWidget(self.back, 0, 2)
        grid.addWidget(does, 1, 0, 1, 3)
        self.refresh()

    def holds(self, words: list[str]) -> bool:
        """Return whether it has all of some words, in small letters, as they are shown or in
        English."""
        shown = self._shown
        choices = [title for _, title in shown.choices]
        english = [shown.group, shown.title, self.setting.text, *choices]
        text = " ".join([*english, *map(tr, english)]).casefold()
        return all(word in text for word in words)

    def refresh(self) -> None:
        """Show what holds now."""
        value = self._options.value(self.setting)
        editor = self.editor
        editor.blockSignals(True)
        if isinstance(editor, QCheckBox):
            editor.setChecked(bool(value))
        elif isinstance(editor, QComboBox):
            editor.setCurrentIndex(editor.findData(value))
        elif isinstance(editor, RangeBox):
            editor.setValue(float(value) * self._shown.times)
        elif isinstance(editor, QLineEdit):
            editor.setText(str(value))
        editor.blockSignals(False)
        self.back.setEnabled(value != self.setting.default)

    def _make_editor(self, shown: Shown) -> QWidget:
        if self.setting.kind is FLAG:
            box = QCheckBox()
            box.toggled.connect(self._take)
            return box
        if shown.choices:
            combo = QComboBox()
            for value, title in shown.choices:
                combo.addItem(tr(title), value)
            combo.activated.connect(lambda index: self._take(combo.itemData(index)))
            made: QWidget = combo
        elif self.setting.kind is NUMBER:
            number = RangeBox()
            number.refused.connect(number.tell_refused)
            least, most, step = shown.limits
            number.setDecimals(0 if step == int(step) else 1)
            number.setRange(least, most)
            number.setSingleStep(step)
            number.setSuffix(shown.unit)
            number.setKeyboardTracking(False)
            number.valueChanged.connect(lambda shown_: self._take(shown_ / shown.times))
            made = number
        else:
            line = QLineEdit()
            line.editingFinished.connect(lambda: self._take(line.text().strip()))
            made = line
        made.setMinimumWidth(made.fontMetrics().averageCharWidth() * _LINES)
        return made

    def _words(self, value: Any) -> str:
        if self.setting.kind is FLAG:
            return tr("on") if value else tr("off")
        if self.setting.kind is NUMBER:
            return f"{float(value) * self._shown.times:g}{self._shown.unit}"
        words = dict(self._shown.choices).get(value)
        return tr(words) if words else str(value) or tr("none of your own")

    def _take(self, value: Any) -> None:
        if value != self._options.value(self.setting):
            self._options.change(self.setting, value)
            self._changed()


class SettingsDialog(QDialog):
    """Stays open next to the window; what is changed holds at once."""

    keysWanted = Signal()

    def __init__(self, options: BoundSettings, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("settingsDialog")
        self.setWindowTitle(tr("Settings"))
        self._options = options
        find = tr("Search the settings")
        self.search = QLineEdit(placeholderText=find, clearButtonEnabled=True)
        self.search.setObjectName("settingsSearch")
        self.search.setAccessibleName(find)
        self.search.textChanged.connect(self._find)
        self.rows = [SettingRow(setting, options, self.refresh) for setting in OFFERED]
        self._heads: dict[str, QLabel] = {}
        self._area = self._make_area()
        self._nothing = empty_state("", "settingsNothing")
        self._pages = QStackedWidget()
        self._pages.addWidget(self._area)
        self._pages.addWidget(self._nothing)
        layout = self._column = QVBoxLayout(self)
        layout.addWidget(self.search)
        layout.addWidget(self._pages, 1)
        layout.addWidget(self._make_buttons())
        self.resize(_DIALOG_SIZE.boundedTo(parent.window().size() - QSize(_MARGIN, _MARGIN)))

    def _make_area(self) -> QScrollArea:
        content = ScrolledContent()
        column = QVBoxLayout(content)
        column.setSpacing(0)
        groups = dict.fromkeys(row.setting.shown.group for row in self.rows if row.setting.shown)
        for group in groups:
            head = QLabel(tr(group))
            font = head.font()
            font.setBold(True)
            head.setFont(font)
            head.setContentsMargins(0, 10, 0, 2)
            self._heads[group] = head
            column.addWidget(head)
            for row in self.rows:
                if row.setting.shown is not None and row.setting.shown.group == group:
                    column.addWidget(row)
        column.addStretch(1)
        area = QScrollArea()
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(content)
        return area

    def _make_buttons(self) -> QDialogButtonBox:
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        reset = QDialogButtonBox.ButtonRole.ResetRole
        self.all_back = box.addButton(tr("All to their defaults"), reset)
        self.all_back.clicked.connect(self._take_all_back)
        keys = box.addButton(tr("Change keys…"), reset)
        keys.clicked.connect(self.keysWanted)
        for button in box.buttons():
            button.setAutoDefault(False)  # type: ignore[attr-defined]
        box.rejected.connect(self.close)
        return box

    # --- showing --------------------------------------------------------------------------

    def open_at(self, key: str = "") -> None:
        """Show the dialog, with the keyboard in a setting, or in the search."""
        self.refresh()
        self.search.clear()
        self.show()
        self.raise_()
        self.activateWindow()
        row = next((row for row in self.rows if row.setting.key == key), None)
        if row is None:
            self.search.setFocus()
            return
        self._column.activate()  # or it is not known yet where the row lies
        self._area.ensureWidgetVisible(row)
        row.editor.setFocus(Qt.FocusReason.OtherFocusReason)

    def refresh(self) -> None:
        """Show what holds now, anyone who changed it."""
        for row in self.rows:
            row.refresh()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.ActivationChange and self.isActiveWindow():
            self.refresh()

    def _find(self) -> None:
        words = self.search.text().casefold().split()
        seen = set()
        for row in self.rows:
            found = row.holds(words)
            row.setVisible(found)
            if found and row.setting.shown is not None:
                seen.add(row.setting.shown.group)
        for group, head in self._heads.items():
            head.setVisible(group in seen)
        text = self.search.text().strip()
        self._nothing.setText(tr("No setting has “{text}”.", text=text))
        self._pages.setCurrentIndex(0 if seen else 1)

    def _take_all_back(self) -> None:
        for row in self.rows:
            if self._options.value(row.setting) != row.setting.default:
                self._options.change(row.setting, row.setting.default)
        self.refresh()
