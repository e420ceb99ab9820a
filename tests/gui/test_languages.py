"""The window in other languages."""

import copy
import importlib.util
import re
import shutil
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QSize, Qt, QTranslator
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QApplication,
    QCheckBox,
    QComboBox,
    QHeaderView,
    QLabel,
    QPushButton,
    QRadioButton,
    QTabBar,
    QToolButton,
    QWidget,
)
from shiboken6 import isValid

from procc_annotator import translation
from procc_annotator.calibration.label_check.element_rules import few_points_finding
from procc_annotator.calibration.label_check.evidence import AnnotatedElement
from procc_annotator.dataset import editing
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.registry import FORMATS
from procc_annotator.gui.actions import ACTIONS, MENUS
from procc_annotator.gui.keymap import NATIVE
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.element_states import short_titles
from procc_annotator.gui.settings import CONTEXT, LANGUAGES, take_up
from procc_annotator.gui.window.key_dialogs import KeymapDialog
from procc_annotator.gui.window.menus import mnemonics
from procc_annotator.gui.window.top_bar import WordsButton
from procc_annotator.gui.window.workspaces import WORKSPACES
from procc_annotator.report.tables.data_files import json_bytes
from procc_annotator.translation import (
    tr,
    tr_count,
    translatable,
    translatable_all,
    translatable_count,
    translatable_joined,
)
from tests.gui.conftest import Hand, all_done, sheet_text
from tests.gui.shown_texts import Asked, paint_spy, texts_of, unsaid_words


@pytest.fixture
def pseudo() -> Iterator[None]:
    """A language that puts brackets around whatever is translated, so that the rest shows."""

    def look_up(text: str, about: str, count: int) -> str:
        return f"⟦{text}⟧"

    translation.set_translator(look_up)
    yield
    translation.set_translator(None)


def test_texts_are_english_where_no_language_is_taken_up():
    assert tr("{a} of {b}", a=1, b=2) == "1 of 2"
    assert tr("100 % {of it}") == "100 % {of it}"
    assert tr_count(1, "{n} frame of {all}", "{n} frames of {all}", all=3) == "1 frame of 3"
    assert tr_count(2, "{n} frame of {all}", "{n} frames of {all}", all=3) == "2 frames of 3"


def test_texts_and_their_values_go_through_the_language(pseudo):
    assert tr("{a} of {b}", a=1, b=2) == "⟦1 of 2⟧"
    assert tr_count(1, "{n} frame", "{n} frames") == "⟦1 frames⟧"


def test_what_is_kept_in_a_file_is_english_and_shown_in_the_language(pseudo):
    step = translatable("drop {what}", what=translatable_count(1, "{n} line", "{n} lines"))
    assert step == "drop 1 line"
    assert tr(step) == "⟦drop ⟦1 lines⟧⟧"
    assert tr("saved") == "⟦saved⟧"


def test_what_rooms_below_say_is_english_until_the_window_says_it(pseudo):
    titles = [translatable("Left line"), translatable("Arc"), translatable("Goal")]
    lines = translatable_count(
        1, "{n} line of {titles}", "{n} lines of {titles}", titles=translatable_all(titles)
    )
    found = translatable_joined("; ", [lines, translatable("{px:.1f} px off", px=2)])
    assert found == "1 line of Left line, Arc and Goal; 2.0 px off"
    assert (
        json_bytes({"found": found})
        == b'{\n "found": "1 line of Left line, Arc and Goal; 2.0 px off"\n}\n'
    )
    for words in (found, copy.copy(found)):  # taken apart as on the way out of a process
        shown = tr("why: {found}", found=words)
        assert shown.count("⟦") == shown.count("⟧") == 9
        assert "⟦1 lines of ⟦⟦⟦Left line⟧, ⟦Arc⟧⟧ and ⟦Goal⟧⟧⟧" in shown
        assert "⟦2.0 px off⟧" in shown


def test_a_finding_is_said_with_the_titles_of_its_elements(pseudo):
    element = load_field("soccer").element("Middle line")
    assert element is not None
    found = few_points_finding(AnnotatedElement(element, np.array([[1.0, 2.0]]), (0,)))
    assert found.reason == "Halfway line has 1 point, a line takes two"
    assert tr(found.reason) == "⟦⟦Halfway line⟧ has 1 points, a line takes two⟧"
    assert tr(found.remedies[0].text) == "⟦look at it⟧"


# --- no word of the window is left out ------------------------------------------------------------

_KEYS = "Ctrl|Shift|Alt|Tab|Return|Enter|Space|Del|Backspace|Esc|Pg(?:Up|Down)|Home|End|Ins"
_KEYS += "|Left|Right|Up|Down"
_UNITS = "px|kB|MB|GB|fps|JaC|TP|FP|FN|JSON|CSV"
_FILES = r"(?<![\w<])/[\w./-]+|\b[\w*]+\.\w{3,4}\b|\*\.\w+"
_SOURCES = "true|bad|pinhole|fit|sample|soccernet|procc"
_NAMED = [
    *(element.name.strip() for element in load_field("soccer").elements),
    *(known.title for known in FORMATS),
    "{instant}_{view}",
]
_CLASSES = "|".join(sorted(map(re.escape, _NAMED), key=len, reverse=True))
_NAMES = re.compile(rf"{_CLASSES}|{_FILES}|\b(?:{_KEYS}|{_UNITS}|{_SOURCES})\b")

# What Qt says by itself, in its own translations, and the pages of the guide, which are English.
_OF_QT = ("qt_", "Scroll", "guide")
_EXAMPLE = re.compile(r"^.*?   ", re.MULTILINE)  # of what is typed into the filter of frames
_BUTTONS = {"OK", "Cancel", "Close", "Save", "Press shortcut"}
_BUTTONS |= {"Export", "Export..."}  # of the plots' library; its menus are not shown
# They would leave the dataset, or the test.
_NOT_CALLED = {"quit", "open_sample", "tour"}


def _left_out(found: Iterable[tuple[str, str]]) -> dict[str, str]:
    return {
        text: where
        for where, text in found
        if unsaid_words(_EXAMPLE.sub("", text), _NAMES)
        and not any(f" {name}" in where for name in _OF_QT)
        and text.replace("&", "") not in _BUTTONS
    }


def _opened(main: MainWindow) -> Iterator[QWidget]:
    """The windows that lie beside the main one; each is closed again."""
    for window in QApplication.topLevelWidgets():
        if isValid(window) and window is not main and window.isVisible():
            yield window
            window.close()


def _draw_and_ask(window: MainWindow) -> None:
    """Hints and menus of all that can be under the hand."""
    hand, services = Hand(window), window.services
    hand.move(200, 200)
    window._show_menu(QPoint(0, 0))
    services.selection.select_class("Middle line")
    hand.click(300, 100)
    window._show_menu(QPoint(0, 0))
    hand.click(310, 300)
    hand.key(Qt.Key.Key_Return)
    services.selection.set_mode("edit")
    services.selection.select_point("Middle line", 0)
    window._show_menu(QPoint(0, 0))
    services.editing.undo()
    services.selection.set_mode("draw")


@pytest.mark.new_window
def test_no_word_of_the_window_is_left_out(pseudo, audited, monkeypatch):
    asked, found = Asked(monkeypatch), paint_spy(monkeypatch)
    audited.services.store.events.message.connect(lambda m: found.append(("told", m.text)))
    audited.canvas.hintChanged.connect(lambda text: found.append(("hint", text)))
    _draw_and_ask(audited)
    for desk in WORKSPACES:
        audited.panels.turn_to(desk)
        for name in WORKSPACES[desk]:
            audited.panels.show(name)
            QApplication.processEvents()
    found += texts_of(audited)
    for spec in ACTIONS:
        if spec.name in _NOT_CALLED:
            continue
        audited.actions_[spec.name].trigger()
        for window in _opened(audited):
            found += texts_of(window)
    QApplication.processEvents()
    found += texts_of(audited)
    assert len(found) > 5_000
    assert _left_out([*found, *asked.texts]) == {}


@pytest.mark.new_window
def test_nor_is_one_of_ghosts_findings_and_a_second_annotator(
    pseudo, begun, monkeypatch, qtbot, tmp_path
):
    asked, found = Asked(monkeypatch), paint_spy(monkeypatch)
    services, workspace = begun.services, begun.services.state.workspace
    services.store.events.message.connect(lambda m: found.append(("told", m.text)))
    begun.canvas.hintChanged.connect(lambda text: found.append(("hint", text)))
    second = shutil.copytree(workspace.root, tmp_path / "second")
    qtbot.waitUntil(lambda: bool(services.ghosts.painted))
    for action in ("next_ghost", "not_visible", "visible_again", "accept_ghost"):
        begun.actions_[action].trigger()
        begun._show_menu(QPoint(0, 0))
    all_done(qtbot)
    swapped = editing.swap_classes(services.state.annotation, "Big rect. left main", "Circle left")
    services.editing.commit_edit("swap", swapped)
    all_done(qtbot)
    assert services.label_check.shown
    for action in ("next_finding", "check_set"):
        begun.actions_[action].trigger()
        all_done(qtbot)
    services.selection.select_class("Circle left")
    begun._show_menu(QPoint(0, 0))
    begun.services.second_annotator.open(second)
    all_done(qtbot)
    found += texts_of(begun)
    assert _left_out([*found, *asked.texts]) == {}


# --- it is found by the words of both languages ---------------------------------------------------

_GERMAN = {
    "Blind mode": "Blindmodus",
    "Halfway line": "Mittellinie",
    "Text size": "Textgröße",
    "Hold X": "X halten",
}


@pytest.fixture
def german() -> Iterator[None]:
    """A few words of another language."""
    translation.set_translator(lambda text, about, count: _GERMAN.get(text, text))
    yield
    translation.set_translator(None)


@pytest.mark.new_window
def test_what_is_looked_for_is_found_by_its_name_and_its_english_one(german, window):
    commands = window.commands
    window.find_anything()
    for words, title in (
        ("blindm", "Blindmodus"),
        ("blind mo", "Blindmodus"),
        ("mittel", "Mittellinie"),
        ("halfway", "Mittellinie"),
        ("textgr", "Textgröße…"),
        ("text si", "Textgröße…"),
    ):
        window.palette_.search.setText(words)
        model = window.palette_.list.model()
        assert model.index(0, 1).data() == title
    window.palette_.put_away()

    commands.show_keys()
    sheet = commands._sheet
    for words, text in (
        ("mittellinie", "Mittellinie"),
        ("halfway", "Mittellinie"),
        ("blind mode", "Blindmodus"),
        ("hold x", "X halten"),
    ):
        sheet.search.setText(words)
        assert text in sheet_text(sheet)
    sheet.close()

    commands.show_settings()
    dialog = commands._dialog
    for words in ("textgröße", "text size"):
        dialog.search.setText(words)
        shown = [row.setting.key for row in dialog.rows if not row.isHidden()]
        assert shown == ["font_percent"]
    dialog.close()

    keys = KeymapDialog(window.services.state.field, window.services.state.keymap, window)
    for words in ("blindmodus", "blind mode"):
        keys.search.setText(words)
        assert "Blindmodus" in keys.table.shown()[0].text
    keys.deleteLater()


def test_menus_open_by_letters_of_their_own_language(german):
    titles = {"File": "ファイル", "Edit": "Bearbeiten", "Frame": "Bild"}
    translation.set_translator(lambda text, about, count: titles.get(text, text))
    said = mnemonics(MENUS)
    assert said["File"] == "ファイル(&F)"
    assert said["Edit"] == "&Bearbeiten"
    assert said["Frame"] == "B&ild"
    letters = [words[words.index("&") + 1].lower() for words in said.values()]
    assert len(set(letters)) == len(MENUS)


@pytest.mark.new_window
def test_a_title_says_below_its_group_what_the_group_does_not(qapp):
    take_up(qapp, "de")
    shown = short_titles(load_field("soccer"))
    take_up(qapp, "en")
    assert shown["Big rect. left main"] == "Vorn"
    assert shown["Goal left post left "] == "Linker Pfosten"
    assert shown["Circle left"] == "Linker Teilkreis"  # no part of it is only the group's


@pytest.mark.new_window
def test_how_cameras_are_read_is_said_in_the_language(qapp, request, qtbot):
    take_up(qapp, "de")
    try:
        window: MainWindow = request.getfixturevalue("window")
        window.panels.show("cameras")
        format_box = window.cameras.format
        qtbot.waitUntil(lambda: format_box.itemText(0) == "nach Dateityp und Inhalt")
    finally:
        take_up(qapp, "en")


def test_the_guide_says_that_it_is_in_english(german, window):
    window.commands.show_guide()
    guide = window.commands._guide
    assert guide.findChild(QLabel, "guideLanguage") is not None
    guide.close()


# --- nothing is cut off ---------------------------------------------------------------------------


_DIALOGS = ("settings", "keys", "keymap", "import_annotations", "export_as", "save_overlay",
            "versions", "group_views", "field_dimensions", "guide")  # fmt: skip


def _longer(text: str, about: str, count: int) -> str:
    """English that takes three tenths more room."""
    letters = "".join(filter(str.isalpha, re.sub("{[^}]*}", "", text)))
    return f"{text} {letters[: round(0.3 * len(letters))]}"


@pytest.fixture(params=["longer", "de", "fr"])
def longest(request, qapp) -> Iterator[str]:
    """The languages with the longest words."""
    if request.param == "longer":
        translation.set_translator(_longer)
    else:
        take_up(qapp, request.param)
    yield request.param
    take_up(qapp, "en")


def _too_narrow(widget: QWidget) -> str:
    """What of a widget's text has no room; "" where it has, or its tip has all of it."""
    text = getattr(widget, "text", str)()
    if isinstance(widget, WordsButton):
        return "" if widget.width() >= widget.minimumSizeHint().width() else widget.words()
    if isinstance(widget, QLabel):
        if not text or text in widget.toolTip():
            return ""
        if widget.wordWrap():
            lack = widget.heightForWidth(widget.width()) - widget.height()
        else:
            lack = widget.sizeHint().width() - widget.width()
    elif isinstance(widget, QHeaderView):
        return _narrow_columns(widget)
    elif isinstance(widget, QTabBar):
        text = " | ".join(map(widget.tabText, range(widget.count())))
        lack = 0 if widget.usesScrollButtons() else widget.sizeHint().width() - widget.width()
    else:
        lack = widget.sizeHint().width() - widget.width()
    return f"{text!r}: {lack} px" if lack > 0 else ""


def _narrow_columns(header: QHeaderView) -> str:
    titles, wide = header.model(), Qt.Orientation.Horizontal
    lacking = []
    for column in range(header.count() if header.orientation() == wide else 0):
        title = str(titles.headerData(column, wide) or "")
        tip = str(titles.headerData(column, wide, Qt.ItemDataRole.ToolTipRole) or "")
        room = header.sectionSize(column)
        if title and title not in tip and 0 < room < header.sectionSizeHint(column):
            lacking.append(f"{title!r}: {header.sectionSizeHint(column) - room} px")
    return ", ".join(lacking)


def _cut_off(window: QWidget) -> dict[str, str]:
    """What is in sight and has no room for its words."""
    QApplication.processEvents()
    kinds = (QLabel, QPushButton, QToolButton, QCheckBox, QComboBox, QRadioButton, QTabBar)
    kinds = (*kinds, QHeaderView)
    shown = [
        widget
        for widget in window.findChildren(QWidget)
        if isinstance(widget, kinds) and not widget.visibleRegion().isEmpty()
        and not widget.objectName().startswith("Scroll")  # arrows of tabs
    ]  # fmt: skip
    assert shown
    return {
        f"{window.windowTitle()}: {type(widget).__name__} {widget.objectName()}": lack
        for widget in shown
        if (lack := _too_narrow(widget))
    }


@pytest.mark.new_window
def test_nothing_is_cut_off(longest, audited, monkeypatch):
    audited.resize(1280, 720)
    cut: dict[str, str] = {}
    for desk in WORKSPACES:
        audited.panels.turn_to(desk)
        for name in WORKSPACES[desk]:
            audited.panels.show(name)
            cut |= _cut_off(audited)
    assert audited.size() == QSize(1280, 720)
    Asked(monkeypatch, lambda dialog: cut.update(_cut_off(dialog)))
    for name in _DIALOGS:
        audited.actions_[name].trigger()
        for window in _opened(audited):
            cut |= _cut_off(window)
    assert cut == {}


# --- the translations -----------------------------------------------------------------------------


@pytest.fixture(scope="module")
def tool() -> ModuleType:
    """What collects the texts, as a module."""
    path = Path(__file__).parents[2] / "packaging" / "languages.py"
    spec = importlib.util.spec_from_file_location("languages_tool", path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module  # its dataclasses look for it there
    spec.loader.exec_module(module)
    return module


def test_no_words_of_the_code_are_out_of_reach(tool):
    assert tool.unsaid() == []


_TRANSLATED = [name for name in LANGUAGES if name != "en"]


def _forms(text: Any, forms: tuple[str, ...]) -> dict[int, str]:
    """What is said of one thing and of five, or without a number."""
    return {1: forms[0], 5: forms[-1]} if text.one else {-1: forms[0]}


def test_translations_are_complete_have_no_faults_and_are_compiled(tool):
    texts = {(text.source, text.about): text for text in tool.collected()}
    for name in _TRANSLATED:
        known = {key: forms for key, forms in tool.translations(name).items() if key in texts}
        assert texts.keys() - known.keys() == set(), name
        faulty = {key: tool.faults_of(texts[key], name, forms) for key, forms in known.items()}
        assert {key: fault for key, fault in faulty.items() if fault} == {}, name
        translator = QTranslator()
        assert translator.load(str(tool.FOLDER / f"{name}.qm"))
        for (source, about), forms in known.items():
            for number, form in _forms(texts[source, about], forms).items():
                found = translator.translate(CONTEXT, source, about or None, number)
                assert found == form, f"{name}.qm is older than {name}.ts"


@pytest.mark.parametrize("name", _TRANSLATED)
def test_a_language_is_spoken_once_it_is_taken_up(qapp, name):
    take_up(qapp, name)
    said, of_qt = tr("Undo"), QKeySequence("Space").toString(NATIVE)
    take_up(qapp, "en")
    assert said != "Undo"
    assert (tr("Undo"), QKeySequence("Space").toString(NATIVE)) == ("Undo", "Space")
    assert of_qt != "Space" or name in ("ja", "zh_CN")  # Qt's own words come along
    assert translation.is_english()
