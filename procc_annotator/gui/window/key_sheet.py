"""All actions and their keys on one sheet, with a search."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFrame,
    QLineEdit,
    QScrollArea,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.field.model import Field
from procc_annotator.gui.actions import ACTIONS, MENUS
from procc_annotator.gui.element_keys import element_keys, key_text
from procc_annotator.gui.keymap import GESTURES, NATIVE, Keymap
from procc_annotator.gui.panels.widgets import empty_state
from procc_annotator.gui.window.key_columns import KeyColumns, Section, SheetRow
from procc_annotator.gui.window.menus import in_menu
from procc_annotator.translation import tr

_SIZE = QSize(1240, 860)
_ACTION, _ELEMENT = "action:", "element:"  # what a row calls, before its name
_MARGIN = 40  # of the window behind the sheet that stays in sight


def sections_of(field: Field, keymap: Keymap) -> tuple[Section, ...]:
    """The sheet: actions by menu, gestures of the mouse, elements of the field."""
    sections = []
    for menu in MENUS:
        rows = []
        for spec in ACTIONS:
            if spec.menu.split("/")[0] == menu:
                keys = _native(keymap.of_action(spec))
                text = in_menu(spec.menu, tr(spec.text.lstrip("-")))
                english = f"{spec.menu} {spec.text}"
                rows.append(SheetRow(keys, text, f"{_ACTION}{spec.name}", english))
        sections.append(Section(tr(menu), tuple(rows)))
    gestures = (SheetRow((tr(k),), tr(does), "", f"{k} {does}") for k, does in GESTURES)
    sections.append(Section(tr("In the picture"), tuple(gestures)))
    elements = [
        SheetRow((key_text(field, name, keymap),), tr(title), f"{_ELEMENT}{name}", title)
        for name, title in ((name, field.title_of(name)) for name in element_keys(field, keymap))
    ]
    if elements:
        sections.append(Section(tr("Choose an element"), tuple(elements)))
    return tuple(sections)


class KeySheet(QDialog):
    """A window with the sheet; typing searches it, a click calls a row, Esc closes it."""

    actionCalled = Signal(str)
    elementCalled = Signal(str)

    def __init__(self, field: Field, keymap: Keymap, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("keySheet")
        self.setWindowTitle(tr("Keys"))
        self.search = QLineEdit()
        self.search.setObjectName("keySearch")
        self.search.setPlaceholderText(
            tr("Search: a word, or a key. A click does what a row says.")
        )
        self.search.setAccessibleName(tr("Search the keys"))
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._show)
        self.search.returnPressed.connect(self._call_only)
        self.columns = KeyColumns()
        self.columns.called.connect(self._call)
        scrolled = QScrollArea()
        scrolled.setFrameShape(QFrame.Shape.NoFrame)
        scrolled.setWidgetResizable(True)
        # Always there: that a bar comes and goes would change the width it is laid out for.
        scrolled.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        scrolled.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        scrolled.setWidget(self.columns)
        scrolled.setAccessibleName(tr("Actions and their keys"))
        self.nothing = empty_state("", "keys_nothing")
        self.pages = QStackedWidget()
        self.pages.addWidget(scrolled)
        self.pages.addWidget(self.nothing)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.button(QDialogButtonBox.StandardButton.Close).setAutoDefault(False)
        buttons.rejected.connect(self.close)
        layout = QVBoxLayout(self)
        layout.addWidget(self.search)
        layout.addWidget(self.pages)
        layout.addWidget(buttons)
        self._sections: tuple[Section, ...] = ()
        self.show_field(field, keymap)
        room = parent.window().size() - QSize(_MARGIN, _MARGIN)
        self.resize(_SIZE.boundedTo(room))

    def show_field(self, field: Field, keymap: Keymap) -> None:
        """All keys, with those of a field's elements."""
        self._sections = sections_of(field, keymap)
        self.search.clear()
        self.search.setFocus()
        self._show()

    def _call(self, calls: str) -> None:
        self.close()  # first: what is called may ask something itself
        if calls.startswith(_ACTION):
            self.actionCalled.emit(calls.removeprefix(_ACTION))
        else:
            self.elementCalled.emit(calls.removeprefix(_ELEMENT))

    def _call_only(self) -> None:
        """Enter calls what alone is found."""
        rows = [row.calls for section in self.columns.sections for row in section.rows if row.calls]
        if len(rows) == 1:
            self._call(rows[0])

    def _show(self) -> None:
        words = self.search.text().casefold().split()
        found = tuple(shown for s in self._sections if (shown := s.matching(words)).rows)
        self.columns.set_sections(found)
        text = self.search.text().strip()
        self.nothing.setText(tr("No key, action or element has “{text}”.", text=text))
        self.pages.setCurrentIndex(0 if found else 1)


def _native(keys: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(QKeySequence(k).toString(NATIVE) for k in keys)
