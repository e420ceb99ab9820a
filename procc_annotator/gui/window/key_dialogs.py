"""Keys of actions and elements: all of them to search and call, and a dialog that changes them."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import reduce
from pathlib import Path

from PySide6.QtCore import QSize, Qt, Slot
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QComboBox,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QKeySequenceEdit,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableView,
    QWidget,
)

from procc_annotator.errors import ProccError, SaveError
from procc_annotator.field.model import Element, Field
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_source import read_file
from procc_annotator.gui.actions import ACTIONS, MENUS, ActionSpec
from procc_annotator.gui.commands.dialogs import NamedDialog
from procc_annotator.gui.keymap import (
    GESTURES,
    NATIVE,
    PRESETS,
    Keymap,
    clashes,
    element_keys,
    from_values,
    to_values,
)
from procc_annotator.gui.panels.widgets import (
    ROW,
    SEARCHED,
    Index,
    Pages,
    RowsModel,
    hbox,
    list_rows,
    make_button,
    named,
    note_label,
    search_line,
    searched_rows,
    show_note,
    vbox,
)
from procc_annotator.translation import tr, word

_SIZE = QSize(760, 620)
_MARGIN = 40  # of the window behind a dialog that stays in sight
_OWN = word("Keys of your own")
_FILES = word("Keys (*.json)")
_WHAT, _KEYS, _CLASH = range(3)


@dataclass(frozen=True, slots=True)
class KeyRow:
    """One line of the table: something that keys call.

    Attributes:
        called: an action of the table, an element of the field, or None for a gesture.
        place: its menu, or what it is.
        keys: as people write them.
        own: the same keys in Qt's portable form.
        clash: what else they call; "" for nothing.
        english: what it is in English, which finds it whatever the language.
    """

    called: ActionSpec | Element | None
    place: str
    title: str
    keys: str
    own: tuple[str, ...]
    clash: str
    english: str

    @property
    def text(self) -> str:
        """Return what it is and where it is found."""
        return tr("{menu}: {action}", menu=self.place, action=self.title)


def key_rows(field: Field, keymap: Keymap) -> list[KeyRow]:
    """Return the actions in the order of the menus, then the elements of the field."""
    clashing = clashes(keymap, field.elements)
    rows = []
    for spec in sorted(ACTIONS, key=lambda spec: MENUS.index(spec.menu.split("/")[0])):
        place = " › ".join(map(tr, spec.menu.split("/")))
        keys, title = keymap.of_action(spec), tr(spec.text.lstrip("-"))
        clash = clashing.get(f"action:{spec.name}", "")  # not shown
        english = f"{spec.menu} {spec.text}"
        rows.append(KeyRow(spec, place, title, _words(keys), keys, clash, english))
    for element in field.elements:
        own = keymap.of_element(element)
        keys, title = (own,) if own else (), tr(element.title)
        clash = clashing.get(f"element:{element.name}", "")  # not shown
        english = f"Element {element.title}"  # not shown
        rows.append(KeyRow(element, tr("Element"), title, _words(keys), keys, clash, english))
    return rows


def _words(keys: tuple[str, ...]) -> str:
    """Keys that mean the same, as people write them: "A or PgUp"."""
    native = [QKeySequence(key).toString(NATIVE) for key in keys] or [""]
    return reduce(lambda one, other: tr("{one} or {other}", one=one, other=other), native)


class KeyTable(QTableView):
    """Table of keys; shows the rows that hold all the words of a search line."""

    def __init__(self, name: str, search: QLineEdit) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAccessibleName(tr("Keys"))
        self.rows = _KeyRows()
        self.setModel(searched_rows(self.rows, search))
        list_rows(self, widest=_WHAT)

    def shown(self) -> list[KeyRow]:
        """Return the rows that the search found, in their order."""
        model = self.model()
        return [self.row_at(model.index(i, 0)) for i in range(model.rowCount())]

    def row_at(self, index: Index) -> KeyRow:
        """Return the row of an index of the view."""
        row = index.data(ROW)
        assert isinstance(row, KeyRow)
        return row


class KeySheet(NamedDialog):
    """All keys, with a search; a click on a row or Enter runs it, Esc closes the dialog."""

    def __init__(
        self,
        field: Field,
        keymap: Keymap,
        call: Callable[[ActionSpec | Element], object],
        parent: QWidget,
    ) -> None:
        super().__init__(parent, "keySheet", tr("Keys"))
        self._do = call
        words = tr("Search: a word, or a key. A click does what a row says.")
        self.search = search_line(words, "keySearch", title=tr("Search the keys"))
        self.search.returnPressed.connect(self._call_only)
        self.table = KeyTable("keyTable", self.search)
        self.table.setColumnHidden(_CLASH, True)
        self.table.clicked.connect(self._call)
        self.table.activated.connect(self._call)
        self.pages = Pages(self.table, "keys_nothing")
        self.nothing = self.pages.empty
        self.search.textChanged.connect(self._show_page)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.button(QDialogButtonBox.StandardButton.Close).setAutoDefault(False)
        buttons.rejected.connect(self.close)
        vbox(self.search, self.pages, buttons, of=self)
        self.show_field(field, keymap)
        room = parent.window().size() - QSize(_MARGIN, _MARGIN)
        self.resize(QSize(_SIZE.width(), room.height()).boundedTo(room))

    def show_field(self, field: Field, keymap: Keymap) -> None:
        """Show all keys, with those of a field's elements."""
        free = element_keys(field, keymap)  # without keys that an action takes
        rows = [
            row
            for row in key_rows(field, keymap)
            if not isinstance(row.called, Element) or row.called.name in free
        ]
        place = tr("In the picture")
        for keys, does in GESTURES:
            rows.append(KeyRow(None, place, tr(does), tr(keys), (), "", f"{keys} {does}"))
        self.table.rows.replace(rows)
        self.search.clear()
        self.search.setFocus()

    def _call(self, index: Index) -> None:
        called = self.table.row_at(index).called
        if called is not None:
            self.close()  # first: what is called may ask something itself
            self._do(called)

    def _call_only(self) -> None:
        """Enter calls what alone is found."""
        model = self.table.model()
        if model.rowCount() == 1:
            self._call(model.index(0, 0))

    def _show_page(self, text: str) -> None:
        why = tr("No key, action or element has “{text}”.", text=text.strip())
        self.pages.explain("" if self.table.model().rowCount() else why)


class KeymapDialog(NamedDialog):
    """Edits a copy; `keymap` holds what was chosen."""

    def __init__(self, field: Field, keymap: Keymap, parent: QWidget) -> None:
        super().__init__(parent, "keymapDialog", tr("Change keys"))
        self.keymap = keymap
        self._field = field
        self._build()
        self._show()
        size = _SIZE.expandedTo(self.sizeHint())
        self.resize(size.boundedTo(parent.window().size() - QSize(_MARGIN, _MARGIN)))

    # --- building -----------------------------------------------------------------------------

    def _build(self) -> None:
        words = tr("Search: a word, or a key")
        self.search = search_line(words, "keymapSearch", title=tr("Search"))
        self.presets = named(QComboBox(), "keymapPresets", title=tr("All keys at once"))
        for name in (*PRESETS, _OWN):
            self.presets.addItem(tr(name), name)
        self.presets.activated.connect(self._take_preset)
        self.table = KeyTable("keymapTable", self.search)
        self.table.selectionModel().currentRowChanged.connect(self._show_chosen)
        self.problem = note_label("keymapProblem")
        above = hbox((self.search, 1), self.presets)
        parts = (above, (self.table, 1), self._editing(), self.problem, self._buttons())
        vbox(*parts, of=self)
        for button in self.findChildren(QPushButton):
            button.setAutoDefault(False)

    def _editing(self) -> QHBoxLayout:
        """Return what changes the keys of the row that is chosen."""
        self.chosen = QLabel()
        self.pressed = _PressedKeys()
        self.pressed.keySequenceChanged.connect(self._show_chosen)
        self.add = make_button(tr("Add"), lambda: self._give((*self._row_keys(), self._typed())))
        self.only = make_button(tr("Only these"), lambda: self._give((self._typed(),)))
        self.none = make_button(tr("No keys"), lambda: self._give(()))
        self.usual = make_button(tr("Default keys"), self._give_usual)
        buttons = (self.add, self.only, self.none, self.usual)
        return hbox((self.chosen, 1), self.pressed, *buttons)

    def _buttons(self) -> QDialogButtonBox:
        box = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.ok = box.button(QDialogButtonBox.StandardButton.Ok)
        role = QDialogButtonBox.ButtonRole.ResetRole
        self.export_button = make_button(tr("Export…"), self._ask_export)
        self.import_button = make_button(tr("Import…"), self._ask_import)
        for button in (self.export_button, self.import_button):
            box.addButton(button, role)
        box.accepted.connect(self.accept)
        box.rejected.connect(self.reject)
        return box

    # --- showing ------------------------------------------------------------------------------

    def _show(self) -> None:
        self.table.rows.replace(key_rows(self._field, self.keymap))
        hard = clashes(self.keymap)  # an element's keys are given up for an action's
        kept = next((name for name, preset in PRESETS.items() if preset == self.keymap), _OWN)
        self.presets.setCurrentIndex(self.presets.findData(kept))
        text = ""
        if hard:
            text = tr("⚠ Keys that call two actions call neither: give one of them other keys.")
        show_note(self.problem, text)
        self.ok.setEnabled(not hard)
        self._show_chosen()

    @Slot()
    def _show_chosen(self) -> None:
        row, typed = self._row(), bool(self._typed())
        nothing = tr("Choose a row, then press its keys")
        self.chosen.setText(row.title if row is not None else nothing)
        one_only = row is not None and isinstance(row.called, Element)
        self.add.setEnabled(row is not None and typed and not (one_only and row.own))
        self.only.setEnabled(row is not None and typed)
        self.none.setEnabled(row is not None and bool(row.own))
        self.usual.setEnabled(row is not None)

    # --- changing -----------------------------------------------------------------------------

    def _row(self) -> KeyRow | None:
        index = self.table.currentIndex()
        return self.table.row_at(index) if index.isValid() else None

    def _row_keys(self) -> tuple[str, ...]:
        row = self._row()
        return () if row is None else row.own

    def _typed(self) -> str:
        return self.pressed.keySequence().toString(QKeySequence.SequenceFormat.PortableText)

    def _give(self, keys: tuple[str, ...]) -> None:
        row = self._row()
        if row is None:
            return
        keys = tuple(dict.fromkeys(keys))
        if isinstance(row.called, Element):
            self.keymap = self.keymap.with_element(row.called, keys[0] if keys else "")
        elif row.called is not None:
            self.keymap = self.keymap.with_action(row.called, keys)
        self.pressed.clear()
        self._show()

    def _give_usual(self) -> None:
        row = self._row()
        if row is not None and isinstance(row.called, ActionSpec):
            self._give(row.called.keys)
        elif row is not None and isinstance(row.called, Element):
            self._give((row.called.shortcut,) if row.called.shortcut else ())

    def _take_preset(self, index: int) -> None:
        preset = PRESETS.get(self.presets.itemData(index))
        if preset is not None:
            self.keymap = preset
        self._show()

    # --- files --------------------------------------------------------------------------------

    def _ask_export(self) -> None:
        chosen, _ = QFileDialog.getSaveFileName(self, tr("Export keys"), "keys.json", tr(_FILES))
        if not chosen:
            return
        data = json.dumps(to_values(self.keymap), indent=1, ensure_ascii=False) + "\n"
        try:
            write_atomic(Path(chosen), data.encode())
        except SaveError as error:
            show_note(self.problem, str(error))

    def _ask_import(self) -> None:
        chosen, _ = QFileDialog.getOpenFileName(self, tr("Import keys"), "", tr(_FILES))
        if not chosen:
            return
        try:
            self.keymap = from_values(json.loads(read_file(Path(chosen))))
        except (ProccError, ValueError, RecursionError) as error:
            text = tr("{file}: {error}; the keys stay as they are", file=chosen, error=error)
            show_note(self.problem, text)
            return
        self._show()


class _KeyRows(RowsModel[KeyRow]):
    """Actions and elements with their keys and clashes."""

    def __init__(self) -> None:
        super().__init__((tr("Action or element"), tr("Keys"), ""))

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        row = self.rows[index.row()]
        if role == ROW:
            return row
        if role == SEARCHED:
            return f"{row.text} {row.keys} {row.english}"
        return super().data(index, role)

    def texts(self, row: KeyRow) -> tuple[str, ...]:
        return row.text, row.keys, tr("⚠ also: {what}", what=row.clash) if row.clash else ""

    def tip(self, row: KeyRow) -> str:
        return tr(row.called.tip) if isinstance(row.called, ActionSpec) else ""


class _PressedKeys(QKeySequenceEdit):
    """Takes the keys that are pressed while it has the keyboard."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("keymapPressed")
        self.setAccessibleName(tr("New keys: press them here"))
        self.setMaximumSequenceLength(1)
        self.setClearButtonEnabled(True)
        words = self.findChildren(QLineEdit)[0].placeholderText()  # Qt's own
        clear = 2 * self.fontMetrics().height()
        self.setMinimumWidth(self.fontMetrics().horizontalAdvance(words) + clear)
