"""All actions and their keys on one sheet."""

from __future__ import annotations

from html import escape

from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QTextBrowser, QVBoxLayout, QWidget

from procc_annotator.field.model import Field
from procc_annotator.gui.actions import ACTIONS, GESTURES, MENUS

_COLUMNS = 3


def _keys(keys: tuple[str, ...]) -> str:
    native = [QKeySequence(k).toString(QKeySequence.SequenceFormat.NativeText) for k in keys]
    return " or ".join(f"<b>{escape(k)}</b>" for k in native)


def _section(title: str, rows: list[tuple[str, str]]) -> str:
    cells = "".join(
        f"<tr><td style='padding:1px 10px 1px 0'>{keys}</td><td>{escape(text)}</td></tr>"
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
    elements = [(_keys((e.shortcut,)), e.title) for e in field.elements if e.shortcut]
    if elements:
        sections.append((len(elements), _section("Choose an element", elements)))
    return f"<table width='100%'><tr>{_columns(sections)}</tr></table>"


def _columns(sections: list[tuple[int, str]]) -> str:
    """Sections in reading order, in columns of about equal height."""
    total = sum(rows + 2 for rows, _ in sections)
    columns: list[str] = [""]
    used = 0
    for rows, html in sections:
        if used >= total / _COLUMNS * len(columns) and len(columns) < _COLUMNS:
            columns.append("")
        columns[-1] += html
        used += rows + 2
    return "".join(f"<td valign='top' style='padding-right:24px'>{c}</td>" for c in columns)


class KeySheet(QDialog):
    """A window with the sheet; Esc closes it."""

    def __init__(self, field: Field, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("keySheet")
        self.setWindowTitle("Keys")
        self.browser = QTextBrowser()
        self.browser.setHtml(sheet_html(field))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        layout = QVBoxLayout(self)
        layout.addWidget(self.browser)
        layout.addWidget(buttons)
        self.resize(1120, 680)
