"""Every text that a window shows, and what of it no translation reaches."""

import re
from collections.abc import Callable, Iterator
from typing import Any

import pytest
from PySide6.QtCore import (
    QAbstractItemModel,
    QAbstractListModel,
    QAbstractTableModel,
    QModelIndex,
    QObject,
    Qt,
)
from PySide6.QtGui import QAction, QPainter
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QDialog,
    QFileDialog,
    QGraphicsTextItem,
    QGraphicsView,
    QHeaderView,
    QInputDialog,
    QLineEdit,
    QMenu,
    QMessageBox,
    QPlainTextEdit,
    QTabBar,
    QTextEdit,
    QWidget,
)

from procc_annotator.gui import main_window

OPEN, CLOSE = "⟦", "⟧"  # around whatever is translated in the pseudo language

# Properties of texts that nobody sees.
_HIDDEN = {"objectName", "styleSheet", "inputMask", "windowFilePath", "windowRole", "whatsThis"}
# Those that say the same again, or what somebody wrote.
_TWICE = {"displayText", "selectedText", "currentText", "cleanText", "html", "markdown"}
_WRITTEN = {"text", "plainText", "documentTitle"}
_ROLES = (
    Qt.ItemDataRole.DisplayRole,
    Qt.ItemDataRole.ToolTipRole,
    Qt.ItemDataRole.AccessibleTextRole,
    Qt.ItemDataRole.AccessibleDescriptionRole,
)
_MOST_ROWS = 60
_TAG = re.compile(r"<[^>]*>")
_LETTERS = re.compile(r"[^\W\d_]{2,}")


def untranslated(text: str) -> str:
    """What of a text lies outside of all brackets; one whose beginning or end is cut off counts as
    cut within its brackets."""
    depth, left = 0, ""
    for letter in _TAG.sub("", text):
        if letter == OPEN:
            depth += 1
        elif letter == CLOSE:
            left = left if depth else ""
            depth = max(0, depth - 1)
        elif depth == 0:
            left += letter
    return left


def unsaid_words(text: str, names: re.Pattern[str]) -> list[str]:
    """Words of a text that are not translated.

    Args:
        names: what is the same in every language.
    """
    return _LETTERS.findall(names.sub(" ", untranslated(text)))


def texts_of(root: QWidget) -> Iterator[tuple[str, str]]:
    """(where, text) of a window and all that is in it, shown now or later."""
    for widget in (root, *root.findChildren(QWidget)):
        where = _name(widget)
        for text in _of_widget(widget):
            yield where, text
    for action in root.findChildren(QAction):
        for text in (action.text(), action.toolTip(), action.iconText(), action.statusTip()):
            yield f"action {action.objectName()}", text


def _name(widget: QObject) -> str:
    parent = widget.parent()
    inside = f" in {type(parent).__name__} {parent.objectName()}" if parent is not None else ""
    return f"{type(widget).__name__} {widget.objectName()}{inside}"


def _of_widget(widget: QWidget) -> Iterator[str]:
    meta = widget.metaObject()
    written = isinstance(widget, (QLineEdit, QTextEdit, QPlainTextEdit))
    skipped = _HIDDEN | _TWICE | (_WRITTEN if written else set())
    for index in range(meta.propertyCount()):
        known = meta.property(index)
        if known.typeName() == "QString" and known.name() not in skipped:
            yield str(widget.property(known.name()) or "")
    if isinstance(widget, QTabBar):
        for tab in range(widget.count()):
            yield widget.tabText(tab)
            yield widget.tabToolTip(tab)
    elif isinstance(widget, QComboBox):
        yield from _of_model(widget.model())
    elif isinstance(widget, QAbstractItemView) and not isinstance(widget, QHeaderView):
        if widget.model() is not None:
            yield from _of_model(widget.model())
    elif isinstance(widget, QGraphicsView) and widget.scene() is not None:
        for item in widget.scene().items():
            if isinstance(item, QGraphicsTextItem):
                yield item.toPlainText()


def _of_model(model: QAbstractItemModel, parent: QModelIndex | None = None) -> Iterator[str]:
    parent = parent or QModelIndex()
    columns = 1 if isinstance(model, QAbstractListModel) else model.columnCount(parent)
    for column in range(columns):
        for role in _ROLES[:2]:
            heading = model.headerData(column, Qt.Orientation.Horizontal, role)
            yield heading if isinstance(heading, str) else ""
    for row in range(min(model.rowCount(parent), _MOST_ROWS)):
        for column in range(columns):
            index = model.index(row, column, parent)
            for role in _ROLES:
                value = model.data(index, role)
                yield value if isinstance(value, str) else ""
            flat = isinstance(model, (QAbstractListModel, QAbstractTableModel))
            if column == 0 and not flat and model.hasChildren(index):
                yield from _of_model(model, index)


class Asked:
    """Answers "no" to whatever asks, and remembers what it said; nothing waits for a person."""

    def __init__(
        self, monkeypatch: pytest.MonkeyPatch, look: Callable[[QWidget], object] | None = None
    ) -> None:
        """Begin to answer.

        Args:
            look: called with each dialog that waits for an answer.
        """
        self.texts: list[tuple[str, str]] = []

        def run(dialog: QDialog, *_: object) -> int:
            self.texts += texts_of(dialog)
            if look is not None:
                dialog.show()
                look(dialog)
                dialog.hide()
            return 0

        monkeypatch.setattr(QDialog, "exec", run)
        show = main_window.canvas_menu

        def menu(*args: Any, **more: Any) -> QMenu:
            made = show(*args, **more)
            self.texts += texts_of(made)
            made.exec = lambda *_: None
            return made

        monkeypatch.setattr(main_window, "canvas_menu", menu)
        for kind, names, answer in (
            (QMessageBox, ("about", "question", "warning", "information", "critical"), None),
            (QInputDialog, ("getInt", "getDouble", "getText", "getItem"), ("", False)),
            (QFileDialog, ("getOpenFileName", "getSaveFileName"), ("", "")),
            (QFileDialog, ("getExistingDirectory",), ""),
        ):
            for name in names:
                monkeypatch.setattr(kind, name, self._static(f"{kind.__name__}.{name}", answer))

    def _static(self, name: str, answer: object) -> Callable[..., object]:
        def ask(*args: object, **more: object) -> object:
            words = [one for one in (*args[1:], *more.values()) if isinstance(one, str)]
            self.texts += [(name, text) for text in words]
            return answer

        return ask


def paint_spy(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, str]]:
    """What is painted as text from now on, by the program's own painting."""
    painted: list[tuple[str, str]] = []
    paint = QPainter.drawText

    def draw(self: QPainter, *args: object) -> object:
        painted.extend(("painted", one) for one in args if isinstance(one, str))
        return paint(self, *args)

    monkeypatch.setattr(QPainter, "drawText", draw)
    return painted
