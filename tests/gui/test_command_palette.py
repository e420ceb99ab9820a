"""The command palette finds whatever has a name, and calls it; the sheet's rows call, too."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import CALLED, RECENT, Settings
from procc_annotator.gui.window.key_dialogs import KeySheet

CTRL = Qt.KeyboardModifier.ControlModifier
K = Qt.Key.Key_K


def _titles(window: MainWindow) -> list[str]:
    model = window.palette_.list.model()
    return [str(model.index(row, 1).data()).removeprefix("✓ ") for row in range(model.rowCount())]


def _type(window: MainWindow, text: str) -> None:
    """Ctrl+K wherever the keyboard is, then letters."""
    QTest.keyClick(QApplication.focusWidget(), K, CTRL)
    assert QApplication.focusWidget() is window.palette_.search
    QTest.keyClicks(window.palette_.search, text)


def _enter(window: MainWindow) -> None:
    QTest.keyClick(window.palette_.search, Qt.Key.Key_Return)


def test_an_action_is_called_by_a_few_letters(window):
    before = window.services.state.blind
    _type(window, "blind mo")
    assert _titles(window)[0] == "Blind mode"
    _enter(window)
    assert window.services.state.blind is not before
    assert not window.palette_.isVisible()
    assert window.canvas.hasFocus()


@pytest.mark.parametrize(
    ("text", "title"),
    [
        ("Shift+R", "Regularise all elements"),  # a key finds what it does
        ("regulraise all", "Regularise all elements"),  # misspelt
        ("regall", "Regularise all elements"),  # letters in order
        ("colour class", "Colour by: Class"),  # a submenu's name
        ("two clicks make", "Regularise"),  # what it does
        ("cent circ", "Centre circle"),  # an element
        ("frame_2", "frame_2"),  # a frame
        ("7.5", "Threshold 7.5 px"),
        ("panel rev", "Panel Review"),
        ("model R+", "Live fit: model R+"),
    ],
)
def test_everything_is_found(window, text, title):
    _type(window, text)
    assert title in _titles(window)[:3]


def test_elements_frames_and_thresholds_are_chosen(window):
    _type(window, "centre circle")
    _enter(window)
    assert window.services.state.selected_class == "Circle central"
    _type(window, "frame_2")
    _enter(window)
    assert window.services.state.frame.name == "frame_2"
    _type(window, "7,5")
    _enter(window)
    assert window.services.state.tau == 7.5
    _type(window, "3")
    QTest.keyClick(window.palette_.search, Qt.Key.Key_Down)
    _enter(window)
    assert window.services.state.frame_index == 2


def test_folders_of_before_are_opened(make_window, dataset, tmp_path):
    other = tmp_path / "second match"
    other.mkdir()
    (other / "kick.png").write_bytes((dataset / "frame_0.png").read_bytes())
    Settings().put_first(RECENT, other)
    window = make_window(dataset)
    _type(window, "second match")
    _enter(window)
    assert window.services.state.frame.name == "kick"


def test_what_was_called_last_comes_first(window):
    for text in ("loupe", "snap to lines"):
        _type(window, text)
        _enter(window)
    QTest.keyClick(window.canvas, K, CTRL)
    assert _titles(window)[:2] == ["Snap to lines", "Loupe"]
    assert len(set(_titles(window))) == len(_titles(window))
    assert Settings().get(CALLED) == ("action:snapping", "action:loupe")


def test_no_key_reaches_what_lies_below(window, hand, saved):
    window.services.selection.select_class("Middle line")
    hand.click(300, 100)
    QTest.keyClick(window.canvas, K, CTRL)
    search = window.palette_.search
    for key in (Qt.Key.Key_D, Qt.Key.Key_Backspace, Qt.Key.Key_PageDown, Qt.Key.Key_Delete):
        QTest.keyClick(search, key)
    QTest.keyClick(search, Qt.Key.Key_Z, CTRL)
    QTest.keyClick(search, Qt.Key.Key_Escape)
    assert window.services.state.frame_index == 0
    assert window.canvas.hasFocus()
    hand.click(300, 200)
    hand.key(Qt.Key.Key_Return)
    assert len(saved("Middle line")) == 2  # the first click, too


def test_it_goes_by_the_key_and_by_a_click_elsewhere(window):
    QTest.keyClick(window.canvas, K, CTRL)
    QTest.keyClick(window.palette_.search, K, CTRL)
    assert not window.palette_.isVisible()
    QTest.keyClick(window.canvas, K, CTRL)
    window.frames.focus_filter()
    assert not window.palette_.isVisible()
    assert window.frames.filter.hasFocus()


def test_undo_and_redo_say_which_step(window, hand, qtbot):
    assert window.actions_["undo"].text() == "Undo"
    hand.draw("Middle line", (300, 100), (300, 200))
    qtbot.waitUntil(lambda: window.actions_["undo"].text().startswith("Undo: "))
    undo = window.actions_["undo"].text()
    assert len(undo) > len("Undo: ")
    hand.key(Qt.Key.Key_Z, CTRL)
    qtbot.waitUntil(lambda: window.actions_["undo"].text() == "Undo")
    assert window.actions_["redo"].text() == undo.replace("Undo", "Redo")
    _type(window, "undo")
    assert "Undo" in _titles(window)
    QTest.keyClick(window.palette_.search, Qt.Key.Key_Escape)
    hand.key(Qt.Key.Key_D)  # another frame has steps of its own
    qtbot.waitUntil(lambda: window.actions_["redo"].text() == "Redo")


def test_what_is_not_there_is_said(window):
    _type(window, "qqxyz")
    assert not _titles(window)
    assert window.palette_.hint.text() == "Nothing is called “qqxyz”."
    _enter(window)
    assert window.palette_.isVisible()


@pytest.mark.parametrize("size", [(1280, 720), (2560, 1440)])
def test_it_lies_within_the_window(make_window, dataset, size):
    window = make_window(dataset, size=size)
    QTest.keyClick(window.canvas, K, CTRL)
    assert window.rect().contains(window.palette_.geometry())
    window.resize(900, 640)
    QApplication.processEvents()
    assert window.rect().contains(window.palette_.geometry())


def test_a_row_of_the_sheet_is_called_by_a_click(window, qtbot):
    QTest.keyClick(window.canvas, Qt.Key.Key_F1)
    sheet = window.findChild(KeySheet, "keySheet")
    QTest.keyClicks(sheet.search, "halfway line")
    at = sheet.table.visualRect(sheet.table.model().index(0, 0)).center()
    QTest.mouseClick(sheet.table.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert window.services.state.selected_class == "Middle line"
    assert not sheet.isVisible()
    QTest.keyClick(window.canvas, Qt.Key.Key_F1)
    qtbot.waitUntil(sheet.search.hasFocus)  # or Enter is the picture's
    before = window.canvas.loupe_always
    QTest.keyClicks(sheet.search, "loupe shift")  # one row is left
    QTest.keyClick(sheet.search, Qt.Key.Key_Return)
    assert window.canvas.loupe_always is not before
