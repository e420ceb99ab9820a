"""All actions and their keys on one sheet."""

from __future__ import annotations

from html import escape

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QTextBrowser, QVBoxLayout, QWidget

from procc_annotator.field.model import Field
from procc_annotator.gui.actions import ACTIONS, MENUS
from procc_annotator.gui.element_keys import element_keys, key_text
from procc_annotator.gui.gestures import GESTURES

_COLUMNS = 4


def _keys(keys: tuple[str, ...]) -> str:
    native = [QKeySequence(k).toString(QKeySequence.SequenceFormat.NativeText) for k in keys]
    return " or ".join(f"<b>{escape(k)}</b>" for k in native)


def _section(title: str, rows: list[tuple[str, str]]) -> str:
    cells = "".join(
        f"<tr><td style='padding:0 8px 0 0; white-space:nowrap'>{keys}</td>"
        f"<td>{escape(text)}</td></tr>"
        for keys, text in rows
    )
    return f"<h3>{escape(title)}</h3><table cellspacing='0'>{cells}</table>"


def sheet_html(field: Field) -> str:
    """The sheet: actions by menu, gestures of the mouse, elements of the field."""
    sections = []
    for menu in MENUS:
        rows = []
        for spec in ACTIONS:
            if spec.menu.split("/")[0] == menu:
                place = spec.menu.split("/", 1)[1] + ": " if "/" in spec.menu else ""
                rows.append((_keys(spec.keys), place + spec.text.lstrip("-")))
        sections.append((len(rows), _section(menu, rows)))
    mouse = [(f"<b>{escape(keys)}</b>", text) for keys, text in GESTURES]
    sections.append((len(mouse), _section("In the picture", mouse)))
    elements = [
        (f"<b>{escape(key_text(field, name))}</b>", field.title_of(name))
        for name in element_keys(field)
    ]
    if elements:
        sections.append((len(elements), _section("Choose an element", elements)))
    return f"<table width='99%'><tr>{_columns(sections)}</tr></table>"


def _columns(sections: list[tuple[int, str]]) -> str:
    """Sections in reading order, in columns as short as that allows."""
    heights = [rows + 2 for rows, _ in sections]
    limit = max(heights)
    while len(columns := _fill(heights, limit)) > _COLUMNS:
        limit += 1
    cells = ("".join(sections[i][1] for i in column) for column in columns)
    return "".join(f"<td valign='top' style='padding-right:18px'>{c}</td>" for c in cells)


def _fill(heights: list[int], limit: int) -> list[list[int]]:
    """Indices of the sections of each column when none may be higher than ``limit``."""
    columns: list[list[int]] = [[]]
    used = 0
    for index, height in enumerate(heights):
        if used + height > limit and columns[-1]:
            columns.append([])
            used = 0
        columns[-1].append(index)
        used += height
    return columns


class KeySheet(QDialog):
    """A window with the sheet; Esc closes it."""

    def __init__(self, field: Field, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("keySheet")
        self.setWindowTitle("Keys")
        self.browser = QTextBrowser()
        font = self.browser.font()
        font.setPointSizeF(font.pointSizeF() * 0.9)
        self.browser.setFont(font)
        self.browser.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.show_field(field)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        layout = QVBoxLayout(self)
        layout.addWidget(self.browser)
        layout.addWidget(buttons)
        self.resize(1270, 640)

    def show_field(self, field: Field) -> None:
        """List the keys of another field's elements."""
        self.browser.setHtml(sheet_html(field))
