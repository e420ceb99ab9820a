"""Other keys for actions and elements: one by one, as another program has them, or from a file."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QHBoxLayout,
    QHeaderView,
    QKeySequenceEdit,
    QLabel,
    QLineEdit,
    QPushButton,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.errors import ProccError, SaveError
from procc_annotator.field.model import Element, Field
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_source import read_file
from procc_annotator.gui.actions import ACTIONS, ActionSpec
from procc_annotator.gui.keymap import (
    NATIVE,
    PRESETS,
    Keymap,
    clashes,
    from_values,
    to_values,
)
from procc_annotator.gui.panels.tables import Index, RowsModel, list_rows
from procc_annotator.gui.panels.widgets import note_label, show_note
from procc_annotator.gui.window.key_columns import keys_text
from procc_annotator.translation import tr, word

_SIZE = QSize(760, 620)
_MARGIN = 40
_OWN = word("Keys of your own")
_FILES = word("Keys (*.json)")
_WHAT, _KEYS, _CLASH = range(3)


@dataclass(frozen=True, slots=True)
class KeyRow:
    """One line of the table: something that keys call.

    Attributes:
        called: an action of the table, or an element of the field.
        place: its menu, or that it is an element.
        title: its name.
        keys: as they are now.
        clash: what else they call; "" for nothing.
        english: what it is in English, which finds it whatever the language.
    """

    called: ActionSpec | Element
    place: str
    title: str
    keys: tuple[str, ...]
    clash: str
    english: str

    @property
    def text(self) -> str:
        """Return what it is and where it is found."""
        return tr("{menu}: {action}", menu=self.place, action=self.title)

    @property
    def keys_text(self) -> str:
        """Its keys as people write them."""
        return keys_text(tuple(QKeySequence(key).toString(NATIVE) for key in self.keys))

    def holds(self, words: list[str]) -> bool:
        """Return whether it has all of some words, in small letters."""
        text = f"{self.text} {self.keys_text} {self.english}".casefold()
        return all(word in text for word in words)


class KeymapDialog(QDialog):
    """Edits a copy; `keymap` holds what was chosen."""

    def __init__(self, field: Field, keymap: Keymap, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("keymapDialog")
        self.setWindowTitle(tr("Change keys"))
        self.keymap = keymap
        self._field = field
        self._build()
        self._show()
        size = _SIZE.expandedTo(self.sizeHint())
        self.resize(size.boundedTo(parent.window().size() - QSize(_MARGIN, _MARGIN)))

    # --- building -----------------------------------------------------------------------------

    def _build(self) -> None:
        words = tr("Search: a word, or a key")
        self.search = QLineEdit(placeholderText=words, clearButtonEnabled=True)
        self.search.setObjectName("keymapSearch")
        self.search.setAccessibleName(tr("Search"))
        self.presets = QComboBox()
        self.presets.setObjectName("keymapPresets")
        self.presets.setAccessibleName(tr("All keys at once"))
        for name in (*PRESETS, _OWN):
            self.presets.addItem(tr(name), name)
        self.presets.activated.connect(self._take_preset)
        above = QHBoxLayout()
        above.addWidget(self.search, 1)
        above.addWidget(self.presets)
        self.model = _KeyRows()
        self.search.textChanged.connect(self._show)
        self.table = QTableView()
        self.table.setObjectName("keymapTable")
        self.table.setAccessibleName(tr("Keys"))
        self.table.setModel(self.model)
        list_rows(self.table)
        header = self.table.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setSectionResizeMode(_WHAT, QHeaderView.ResizeMode.Stretch)
        header.setSectionResizeMode(_KEYS, QHeaderView.ResizeMode.ResizeToContents)
        header.setSectionResizeMode(_CLASH, QHeaderView.ResizeMode.ResizeToContents)
        self.table.selectionModel().currentRowChanged.connect(lambda *_: self._show_chosen())
        self.problem = note_label("keymapProblem")
        layout = QVBoxLayout(self)
        layout.addLayout(above)
        layout.addWidget(self.table, 1)
        layout.addLayout(self._editing())
        layout.addWidget(self.problem)
        layout.addWidget(self._buttons())

    def _editing(self) -> QHBoxLayout:
        """Return what changes the keys of the row that is chosen."""
        self.chosen = QLabel()
        self.pressed = _PressedKeys()
        self.add = QPushButton(tr("Add"))
        self.only = QPushButton(tr("Only these"))
        self.none = QPushButton(tr("No keys"))
        self.usual = QPushButton(tr("Usual keys"))
        self.add.clicked.connect(lambda: self._give((*self._row_keys(), self._typed())))
        self.only.clicked.connect(lambda: self._give((self._typed(),)))
        self.none.clicked.connect(lambda: self._give(()))
        self.usual.clicked.connect(self._give_usual)
        self.pressed.keySequenceChanged.connect(lambda _: self._show_chosen())
        row = QHBoxLayout()
        row.addWidget(self.chosen, 1)
        row.addWidget(self.pressed)
        for button in (self.add, self.only, self.none, self.usual):
            button.setAutoDefault(False)
            row.addWidget(button)
        return row

    def _buttons(self) -> QDialogButtonBox:
        box = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        self.ok = box.button(QDialogButtonBox.StandardButton.Ok)
        self.ok.setAutoDefault(False)
        role = QDialogButtonBox.ButtonRole.ResetRole
        self.export_button = box.addButton(tr("Export…"), role)
        self.import_button = box.addButton(tr("Import…"), role)
        self.export_button.clicked.connect(self._ask_export)
        self.import_button.clicked.connect(self._ask_import)
        for button in (self.export_button, self.import_button):
            button.setAutoDefault(False)
        box.accepted.connect(self.accept)
        box.rejected.connect(self.reject)
        return box

    # --- showing ------------------------------------------------------------------------------

    def _show(self) -> None:
        """Show the keymap as it is now."""
        clashing = clashes(self.keymap, self._field.elements)
        hard = clashes(self.keymap)  # an element's keys are given up for an action's
        words = self.search.text().casefold().split()
        rows = [*self._action_rows(clashing), *self._element_rows(clashing)]
        before = self._row()
        found = [row for row in rows if row.holds(words)]
        self.model.replace(found)
        if before is not None:  # what is chosen stays chosen
            at = next((i for i, row in enumerate(found) if row.called is before.called), -1)
            self.table.setCurrentIndex(self.model.index(at, _WHAT))
        kept = next((name for name, preset in PRESETS.items() if preset == self.keymap), _OWN)
        self.presets.setCurrentIndex(self.presets.findData(kept))
        text = ""
        if hard:
            text = tr("⚠ Keys that call two actions call neither: give one of them other keys.")
        show_note(self.problem, text)
        self.ok.setEnabled(not hard)
        self._show_chosen()

    def _action_rows(self, clashing: dict[str, str]) -> list[KeyRow]:
        return [
            KeyRow(
                spec,
                " › ".join(map(tr, spec.menu.split("/"))),
                tr(spec.text.lstrip("-")),
                self.keymap.of_action(spec),
                clashing.get(f"action:{spec.name}", ""),  # not shown
                f"{spec.menu} {spec.text}",
            )
            for spec in ACTIONS
        ]

    def _element_rows(self, clashing: dict[str, str]) -> list[KeyRow]:
        rows = []
        for element in self._field.elements:
            keys = self.keymap.of_element(element)
            clash = clashing.get(f"element:{element.name}", "")  # not shown
            english, title = f"Element {element.title}", tr(element.title)  # not shown
            given = (keys,) if keys else ()
            rows.append(KeyRow(element, tr("Element"), title, given, clash, english))
        return rows

    def _show_chosen(self) -> None:
        row, typed = self._row(), bool(self._typed())
        nothing = tr("Choose a row, then press its keys")
        self.chosen.setText(row.title if row is not None else nothing)
        one_only = row is not None and isinstance(row.called, Element)
        self.add.setEnabled(row is not None and typed and not (one_only and row.keys))
        self.only.setEnabled(row is not None and typed)
        self.none.setEnabled(row is not None and bool(row.keys))
        self.usual.setEnabled(row is not None)

    # --- changing -----------------------------------------------------------------------------

    def _row(self) -> KeyRow | None:
        index = self.table.currentIndex()
        return self.model.rows[index.row()] if index.isValid() else None

    def _row_keys(self) -> tuple[str, ...]:
        row = self._row()
        return () if row is None else row.keys

    def _typed(self) -> str:
        return self.pressed.keySequence().toString(QKeySequence.SequenceFormat.PortableText)

    def _give(self, keys: tuple[str, ...]) -> None:
        row = self._row()
        if row is None:
            return
        keys = tuple(dict.fromkeys(keys))
        if isinstance(row.called, Element):
            self.keymap = self.keymap.with_element(row.called, keys[0] if keys else "")
        else:
            self.keymap = self.keymap.with_action(row.called, keys)
        self.pressed.clear()
        self._show()

    def _give_usual(self) -> None:
        row = self._row()
        if row is not None:
            called = row.called
            shortcut = called.shortcut if isinstance(called, Element) else ""
            usual = (shortcut,) * bool(shortcut)
            self._give(usual if isinstance(called, Element) else called.keys)

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
    """What keys call, their keys, and what else they would call."""

    def __init__(self) -> None:
        super().__init__((tr("Action or element"), tr("Keys"), ""))

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        row = self.rows[index.row()]
        if role == Qt.ItemDataRole.ToolTipRole and isinstance(row.called, ActionSpec):
            return tr(row.called.tip)
        if role != Qt.ItemDataRole.DisplayRole:
            return None
        if index.column() == _WHAT:
            return row.text
        if index.column() == _KEYS:
            return row.keys_text
        return tr("⚠ also: {what}", what=row.clash) if row.clash else ""


class _PressedKeys(QKeySequenceEdit):
    """Takes the keys that are pressed while it has the keyboard."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("keymapPressed")
        self.setAccessibleName(tr("New keys: press them here"))
        self.setMaximumSequenceLength(1)
        self.setClearButtonEnabled(True)
        words = self.findChildren(QLineEdit)[0].placeholderText()  # Qt's own
        beside = 2 * self.fontMetrics().height()
        self.setMinimumWidth(self.fontMetrics().horizontalAdvance(words) + beside)
