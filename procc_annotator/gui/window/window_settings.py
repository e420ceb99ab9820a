"""Settings of the window: bound to actions and services, restored, saved, and their dialog."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide6.QtCore import QEvent, QSignalBlocker, QSize, Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialogButtonBox,
    QGridLayout,
    QLabel,
    QLineEdit,
    QMainWindow,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from procc_annotator.dataset.records import default_author
from procc_annotator.gui import settings as rows
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.commands.dialogs import NamedDialog
from procc_annotator.gui.panels.widgets import (
    Pages,
    ScrolledContent,
    make_button,
    make_label,
    named,
    range_box,
    scrolling,
    search_line,
    vbox,
)
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
from procc_annotator.gui.theme import bold, running_application, set_text_size, set_theme
from procc_annotator.gui.window.workspaces import Workspaces
from procc_annotator.translation import tr

Bound = tuple[Callable[[], Any], Callable[[Any], object]]  # reads and changes a value


class BoundSettings:
    """Reads and changes what the window does; what is kept nowhere else is kept in the file."""

    def __init__(
        self,
        settings: Settings,
        services: Services,
        canvas: Canvas,
        action: Callable[[str], QAction],
    ) -> None:
        self._settings = settings
        self._bound = _bound(services, canvas, action)
        self._applied: dict[str, Callable[[Any], object]] = {
            rows.AUTHOR.key: lambda name: services.set_author(name or default_author()),
            rows.KEYS.key: lambda keymap: services.store.update(keymap=keymap),
            rows.THEME.key: partial(set_theme, running_application()),
        }
        # A program that is killed loses no choice, least of all blind mode.
        store = services.store
        store.watch(lambda s: (s.options, s.blind), self.write_down, When.AFTER_PAINT)

    def value(self, setting: Setting[T]) -> T:
        """Return what holds now."""
        bound = self._bound.get(setting.key)
        value: T = self._settings.get(setting) if bound is None else bound[0]()
        return value

    def change(self, setting: Setting[T], value: T) -> None:
        """Have something else hold from now on, and remember it."""
        self._settings.set(setting, value)
        self.take_up(setting)

    def take_up(self, setting: Setting[T]) -> None:
        """Have hold what is remembered."""
        bound = self._bound.get(setting.key)
        apply = self._applied.get(setting.key) if bound is None else bound[1]
        if apply is not None:
            apply(self._settings.get(setting))

    def take_up_all(self) -> None:
        """Have hold all that is remembered; how the application looks does already."""
        for setting in (rows.KEYS, *rows.OFFERED):
            if setting is not rows.THEME:
                self.take_up(setting)

    def write_down(self) -> None:
        """Remember all of them as they are."""
        for setting in rows.OFFERED:
            if setting.key in self._bound:
                self._settings.set(setting, self.value(setting))


def _bound(
    services: Services, canvas: Canvas, action: Callable[[str], QAction]
) -> dict[str, Bound]:
    """Return how to read and change the settings that services or actions hold."""

    def switch(name: str) -> Bound:
        def turn(on: bool) -> None:
            if on != action(name).isChecked():
                action(name).trigger()

        return lambda: action(name).isChecked(), turn

    switches = {name: switch(name) for name in SWITCHES}
    evaluation, live_fit, source = services.evaluation, services.live_fit, services.fit_source
    return {
        **switches,
        # A locked dataset may hold what a person chose for all of them.
        "blind": (lambda: services.blind_lock.wanted, switches["blind"][1]),
        "live_fit": (lambda: live_fit.chosen, switches["live_fit"][1]),
        rows.TAU.key: (lambda: services.state.tau, evaluation.set_tau),
        rows.PROTOCOL.key: (lambda: services.state.setup.protocol, evaluation.set_protocol),
        rows.OFF_PLANE.key: (
            lambda: services.state.setup.off_plane,
            lambda choice: evaluation.set_protocol(off_plane=choice),
        ),
        rows.COLOUR_BY.key: (
            lambda: canvas.drawing.colour_by,
            lambda choice: action(f"colour_{choice}").trigger(),
        ),
        rows.FIT_MODEL.key: (lambda: live_fit.model, live_fit.set_model),
        rows.JUDGE_FIT.key: (lambda: source.preferred, partial(setattr, source, "preferred")),
    }


def apply_appearance(settings: Settings) -> None:
    """Have the application look as it is remembered, before anything of it is made."""
    if (theme := settings.get(rows.THEME)) != rows.THEME.default:
        set_theme(running_application(), theme)
    set_text_size(running_application(), settings.get(rows.FONT_PERCENT))


_SIZE = QSize(1440, 900)
_AROUND = QSize(16, 48)  # what a desktop puts around a window, and its title; known too late


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
        self.setting, self._shown, self.group = setting, setting.shown, setting.shown.group
        self._options, self._changed = options, changed
        self.setObjectName(f"setting_{setting.key}")
        self.editor, self._show = self._make_editor(setting.shown)
        if setting.kind is not FLAG:
            self.editor.setMinimumWidth(self.fontMetrics().averageCharWidth() * _LINES)
        title, text = tr(self._shown.title), tr(setting.text)
        self.editor.setAccessibleName(title)
        self.editor.setAccessibleDescription(text)
        default = self._words(setting.default)
        tip = tr("{setting}: back to {value}", setting=title, value=default)
        self.back = named(QToolButton(), tip=tip, title=tip)
        self.back.setText("↺")
        self.back.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.back.clicked.connect(lambda: self._take(setting.default))
        name = QLabel(title)
        name.setBuddy(self.editor)
        does = make_label(text, faint=True)
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
        with QSignalBlocker(self.editor):
            self._show(value)
        self.back.setEnabled(value != self.setting.default)

    def _make_editor(self, shown: Shown) -> tuple[QWidget, Callable[[Any], object]]:
        """Return the widget that edits the value, and what shows a value in it."""
        if self.setting.kind is FLAG:
            box = QCheckBox()
            box.toggled.connect(self._take)
            return box, box.setChecked
        if shown.choices:
            combo = QComboBox()
            for value, title in shown.choices:
                combo.addItem(tr(title), value)
            combo.activated.connect(lambda index: self._take(combo.itemData(index)))
            return combo, lambda value: combo.setCurrentIndex(combo.findData(value))
        if self.setting.kind is NUMBER:
            least, most, step = shown.limits
            decimals = 0 if step == int(step) else 1
            number = range_box(least, most, step, shown.unit, decimals=decimals)
            number.valueChanged.connect(lambda entered: self._take(entered / shown.times))
            return number, lambda value: number.setValue(value * shown.times)
        line = QLineEdit()
        line.editingFinished.connect(lambda: self._take(line.text().strip()))
        return line, line.setText

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


class SettingsDialog(NamedDialog):
    """Stays open next to the window; what is changed holds at once."""

    def __init__(
        self, options: BoundSettings, change_keys: Callable[[], object], parent: QWidget
    ) -> None:
        super().__init__(parent, "settingsDialog", tr("Settings"))
        self._options = options
        self.search = search_line(tr("Search the settings"), "settingsSearch", self._find)
        self.rows = [SettingRow(setting, options, self.refresh) for setting in OFFERED]
        self._heads: dict[str, QLabel] = {}
        self._area = self._make_area()
        self._pages = Pages(self._area, "settingsNothing")
        vbox(self.search, (self._pages, 1), self._make_buttons(change_keys), of=self)
        self.resize(_DIALOG_SIZE.boundedTo(parent.window().size() - QSize(_MARGIN, _MARGIN)))

    def _make_area(self) -> QScrollArea:
        content, column = ScrolledContent(), vbox(spacing=0)
        content.setLayout(column)
        for group in dict.fromkeys(row.group for row in self.rows):
            head = self._heads[group] = QLabel(tr(group))
            head.setFont(bold(head.font()))
            head.setContentsMargins(0, 10, 0, 2)
            column.addWidget(head)
            for row in self.rows:
                if row.group == group:
                    column.addWidget(row)
        column.addStretch(1)
        area = scrolling(content)
        area.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        return area

    def _make_buttons(self, change_keys: Callable[[], object]) -> QDialogButtonBox:
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        reset = QDialogButtonBox.ButtonRole.ResetRole
        self.all_back = make_button(tr("Reset all"), self._take_all_back)
        for button in (self.all_back, make_button(tr("Change keys…"), change_keys)):
            box.addButton(button, reset)
        for made in box.findChildren(QPushButton):
            made.setAutoDefault(False)
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
        layout = self.layout()
        assert layout is not None
        layout.activate()  # or it is not known yet where the row lies
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
            if found:
                seen.add(row.group)
        for group, head in self._heads.items():
            head.setVisible(group in seen)
        why = tr("No setting has “{text}”.", text=self.search.text().strip())
        self._pages.explain("" if seen else why)

    def _take_all_back(self) -> None:
        for row in self.rows:
            if self._options.value(row.setting) != row.setting.default:
                self._options.change(row.setting, row.setting.default)
        self.refresh()
