"""The user guide, as it comes with the program: read without a network."""

from __future__ import annotations

import re
from pathlib import Path

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices, QPalette, QTextBlock, QTextCursor
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QSplitter,
    QTextBrowser,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.translation import is_english, tr

_FIRST = "user-guide.md"
_SIZE = (980, 700)
_INDENT = "    "
_PICTURE = re.compile(r"!\[[^\]]*\]\([^)]*\)|<picture>.*?</picture>|<img[^>]*>", re.DOTALL)


def guide_folder() -> Path | None:
    """Return where the pages are; a package of others may have left them out."""
    package = Path(__file__).resolve().parents[2]
    folders = (package / "_guide", package.parent / "docs")  # installed, or a checkout
    return next((folder for folder in folders if (folder / _FIRST).is_file()), None)


class Guide(QDialog):
    """Pages with their headings next to them, and a line that finds words in a page."""

    def __init__(self, folder: Path, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("guide")
        self.setWindowTitle(tr("User guide"))
        self._folder, self.page_name = folder, ""
        find = tr("Find words in this page")
        self.search = QLineEdit(placeholderText=find, clearButtonEnabled=True)
        self.search.setObjectName("guideSearch")
        self.search.setAccessibleName(find)
        self.search.returnPressed.connect(self._find)
        self.headings = QListWidget()
        self.headings.setObjectName("guideHeadings")
        self.headings.setAccessibleName(tr("Headings"))
        self.headings.itemClicked.connect(self._go)
        self.headings.itemActivated.connect(self._go)
        self.page = QTextBrowser()
        self.page.setObjectName("guidePage")
        self.page.setAccessibleName(tr("User guide"))
        self.page.setOpenLinks(False)
        self.page.anchorClicked.connect(self._follow)
        parts = QSplitter(Qt.Orientation.Horizontal)
        parts.addWidget(self.headings)
        parts.addWidget(self.page)
        parts.setSizes([_SIZE[0] // 4, _SIZE[0] * 3 // 4])
        row = QHBoxLayout()
        row.addWidget(self.search)
        column = QVBoxLayout(self)
        column.addLayout(row)
        if not is_english():
            column.addWidget(_language_note())
        column.addWidget(parts, 1)
        screen = self.screen().availableGeometry().size()
        self.resize(min(_SIZE[0], screen.width()), min(_SIZE[1], screen.height()))
        self.open_page(_FIRST)

    def open_page(self, name: str) -> None:
        """Show a page of the folder; one that is not there changes nothing."""
        path = self._folder / name
        if path.parent != self._folder or not path.is_file():
            return
        self.page_name = name
        self.page.setMarkdown(_PICTURE.sub("", path.read_text(encoding="utf-8")))
        self.headings.clear()
        block = self.page.document().begin()
        while block.isValid():
            if level := block.blockFormat().headingLevel():
                item = QListWidgetItem(_INDENT * (level - 1) + block.text())
                item.setData(Qt.ItemDataRole.UserRole, block.blockNumber())
                self.headings.addItem(item)
            block = block.next()

    # --- inside ---

    def _go(self, item: QListWidgetItem) -> None:
        number = item.data(Qt.ItemDataRole.UserRole)
        self._show(self.page.document().findBlockByNumber(number))

    def _show(self, block: QTextBlock) -> None:
        self.page.moveCursor(QTextCursor.MoveOperation.End)  # what is found comes to the top
        self.page.setTextCursor(QTextCursor(block))

    def _find(self) -> None:
        """The next place of the words; after the last one the first again."""
        words = self.search.text().strip()
        if words and not self.page.find(words):
            self.page.moveCursor(QTextCursor.MoveOperation.Start)
            self.page.find(words)

    def _follow(self, url: QUrl) -> None:
        """Another page of the guide, a heading, or a place in the web."""
        if url.scheme() in ("http", "https"):
            QDesktopServices.openUrl(url)
            return
        if url.path():
            self.open_page(url.path())
        wanted = url.fragment()
        for row in range(self.headings.count() if wanted else 0):
            item = self.headings.item(row)
            if _anchor(item.text()) == wanted:
                self._go(item)


def _language_note() -> QLabel:
    note = QLabel(tr("The user guide is in English."))
    note.setObjectName("guideLanguage")
    note.setForegroundRole(QPalette.ColorRole.PlaceholderText)
    return note


def _anchor(heading: str) -> str:
    """A heading as links name it."""
    return re.sub(r"\s+", "-", re.sub(r"[^\w\s-]", "", heading.strip().lower()))
