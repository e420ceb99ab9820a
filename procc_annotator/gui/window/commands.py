"""Commands of actions that step through values and open dialogs; the user guide."""

from __future__ import annotations

import re
from pathlib import Path

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QAction, QDesktopServices, QTextBlock, QTextCursor
from PySide6.QtWidgets import (
    QDialog,
    QListWidget,
    QListWidgetItem,
    QMessageBox,
    QSplitter,
    QTextBrowser,
    QWidget,
)

from procc_annotator.field.model import Element
from procc_annotator.gui.actions import ActionSpec
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.panels.widgets import hbox, make_label, named, search_line, vbox
from procc_annotator.gui.settings import KEYS
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import Mode
from procc_annotator.gui.window.key_dialogs import KeymapDialog, KeySheet
from procc_annotator.gui.window.window_settings import BoundSettings, SettingsDialog
from procc_annotator.translation import is_english, tr
from procc_annotator.version import __version__

_CONTENTS, _FIRST = "", "start.md"
_SECTIONS = ("tutorials", "how-to", "reference", "explanation")
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
        self.search = search_line(tr("Find words in this page"), "guideSearch")
        self.search.returnPressed.connect(self._find)
        self.headings = named(QListWidget(), "guideHeadings", title=tr("Headings"))
        self.headings.itemClicked.connect(self._go)
        self.headings.itemActivated.connect(self._go)
        self.page = named(QTextBrowser(), "guidePage", title=tr("User guide"))
        self.page.setOpenLinks(False)
        self.page.anchorClicked.connect(self._follow)
        parts = QSplitter(Qt.Orientation.Horizontal)
        parts.addWidget(self.headings)
        parts.addWidget(self.page)
        parts.setSizes([_SIZE[0] // 4, _SIZE[0] * 3 // 4])
        note = make_label(tr("The user guide is in English."), "guideLanguage", faint=True)
        note.setHidden(is_english())
        vbox(hbox(self.search), note, (parts, 1), of=self)
        screen = self.screen().availableGeometry().size()
        self.resize(min(_SIZE[0], screen.width()), min(_SIZE[1], screen.height()))
        self.open_page(_CONTENTS)

    def open_page(self, name: str) -> None:
        """Show a page of the folder, or the list of all; one that is not there changes nothing."""
        path = (self._folder / name).resolve()
        if name and not (path.is_file() and path.is_relative_to(self._folder)):
            return
        self.page_name = path.relative_to(self._folder).as_posix() if name else _CONTENTS
        text = path.read_text(encoding="utf-8") if name else _contents(self._folder)
        self.page.setMarkdown(_PICTURE.sub("", text))
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
            self.open_page(str(Path(self.page_name).parent / url.path()))
        wanted = url.fragment()
        for row in range(self.headings.count() if wanted else 0):
            item = self.headings.item(row)
            if _anchor(item.text()) == wanted:
                self._go(item)


def _contents(folder: Path) -> str:
    """List the titles of all pages by section."""
    lines = [f"# {tr('User guide')}", _entry(folder / _FIRST, folder)]
    for section in _SECTIONS:
        lines += [f"\n## {section.capitalize()}\n"]
        lines += [_entry(page, folder) for page in sorted((folder / section).glob("*.md"))]
    return "\n".join(lines)


def _entry(page: Path, folder: Path) -> str:
    title = page.read_text(encoding="utf-8").split("\n", 1)[0].lstrip("# ")
    return f"- [{title}]({page.relative_to(folder).as_posix()})"


def _anchor(heading: str) -> str:
    """A heading as links name it."""
    return re.sub(r"\s+", "-", re.sub(r"[^\w\s-]", "", heading.strip().lower()))


_TAU_STEP = 0.5


class Commands:
    """Slots of the action table, by name."""

    def __init__(
        self, services: Services, canvas: Canvas, options: BoundSettings, window: QWidget
    ) -> None:
        self._services = services
        self._canvas = canvas
        self._options = options
        self._dialog: SettingsDialog | None = None
        self._window = window
        self._sheet: KeySheet | None = None
        self._guide: Guide | None = None
        services.store.watch(lambda s: (s.field, s.keymap), self._fill_sheet)

    # --- stepping and choosing ------------------------------------------------------------

    def take_tool(self, mode: Mode) -> None:
        """Draw or edit from now on, without the tool that moves the picture."""
        self._canvas.set_pan(False)
        self._services.selection.set_mode(mode)

    def switch_mode(self) -> None:
        """From drawing to editing and back."""
        self.take_tool("edit" if self._services.state.mode == "draw" else "draw")

    def step_element(self, step: int) -> None:
        """Choose the next class of the field (1) or the one before (-1)."""
        field = self._services.state.field
        names = [*(e.name for e in field.elements), *field.classes_without_geometry]
        current = self._services.state.selected_class
        if current in names:
            index = (names.index(current) + step) % len(names)
        else:
            index = 0 if step > 0 else -1
        self._services.selection.select_class(names[index], continues=True)

    def step_camera(self, step: int) -> None:
        """Judge with the next source (1) or the one before (-1)."""
        services = self._services
        if not services.state.sources:
            services.say(tr("no cameras are loaded (Ctrl+L)"))
            return
        active = services.state.active
        if active is None:
            services.camera_sources.set_active_camera(
                0 if step > 0 else len(services.state.sources) - 1
            )
            return
        index = services.state.sources.index(active) + step
        services.camera_sources.set_active_camera(index % len(services.state.sources))

    def step_tau(self, steps: int) -> None:
        """Allow larger (1) or smaller (-1) distances."""
        self._services.evaluation.set_tau(self._services.state.tau + steps * _TAU_STEP)

    def set_off_plane(self, choice: str) -> None:
        """Choose how elements count that a homography cannot project."""
        self._services.evaluation.set_protocol(off_plane=choice)

    # --- comparing sources ----------------------------------------------------------------

    def set_split(self, split: bool) -> None:
        """Divide the picture between the active and the compared source."""
        self._canvas.drawing.set_split(split)
        if split:
            self._say_if_alone(tr("load a second set of cameras to see side by side (Ctrl+L)"))

    def set_disagreement(self, shown: bool) -> None:
        """Show where the active and the compared source disagree."""
        self._services.disagreement.set_enabled(shown)
        if shown:
            self._say_if_alone(tr("load a second set of cameras to compare (Ctrl+L)"))

    def _say_if_alone(self, text: str) -> None:
        if self._services.state.compared is None:
            self._services.say(text)

    # --- the program ----------------------------------------------------------------------

    def show_settings(self, key: str = "") -> None:
        """Open the dialog of settings, at one of them if it is named."""
        if self._dialog is None:
            self._dialog = SettingsDialog(self._options, self.change_keys, self._window)
        self._dialog.open_at(key)

    def show_guide(self) -> None:
        """Open the user guide next to the window, or bring it to the front."""
        folder = guide_folder()
        if folder is None:
            text = tr("this installation came without its user guide")
            self._services.say(text, "warning")
            return
        if self._guide is None:
            self._guide = Guide(folder, self._window)
        _bring_up(self._guide)

    def show_keys(self) -> None:
        """Open the sheet of keys."""
        if self._sheet is None:
            state = self._services.state
            self._sheet = KeySheet(state.field, state.keymap, self._call, self._window)
        self._fill_sheet()
        _bring_up(self._sheet)

    def _fill_sheet(self) -> None:
        if self._sheet is not None:
            self._sheet.show_field(self._services.state.field, self._services.state.keymap)

    def change_keys(self) -> None:
        """Ask for other keys, and have them call what they stand for from now on."""
        services = self._services
        dialog = KeymapDialog(services.state.field, services.state.keymap, self._window)
        if dialog.exec() == QDialog.DialogCode.Accepted:
            self._options.change(KEYS, dialog.keymap)
        dialog.deleteLater()

    def _call(self, called: ActionSpec | Element) -> None:
        if isinstance(called, Element):
            self._services.selection.select_class(called.name)
            return
        action = self._window.findChild(QAction, f"action_{called.name}")
        assert isinstance(action, QAction)
        action.trigger()

    def about(self) -> None:
        """Say which version this is."""
        QMessageBox.about(
            self._window,
            tr("About ProCC Annotator"),
            tr("ProCC Annotator {version}\nAnnotate and audit sports-camera calibrations.",
               version=__version__),
        )  # fmt: skip


def _bring_up(dialog: QDialog) -> None:
    dialog.show()
    dialog.raise_()
    dialog.activateWindow()
