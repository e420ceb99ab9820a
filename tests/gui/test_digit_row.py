"""Keys of the digits on keyboards that write other things with them."""

import sys

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QWidget

pytestmark = pytest.mark.skipif(
    sys.platform in ("win32", "darwin"), reason="the codes of X11's keys are written here"
)

PLAIN, SHIFT = Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.ShiftModifier
ALTGR = Qt.KeyboardModifier.GroupSwitchModifier


def wanted(
    widget: QWidget, place: int, key: Qt.Key, text: str, held: Qt.KeyboardModifier = PLAIN
) -> bool:
    """Whether somebody wants a key of the digit row before the shortcuts, as the platform asks."""
    override = QKeyEvent(QEvent.Type.ShortcutOverride, key.value, held, 9 + place, 0, 0, text)
    override.ignore()
    QApplication.sendEvent(widget, override)
    return override.isAccepted()


def strike(
    widget: QWidget, place: int, key: Qt.Key, text: str, held: Qt.KeyboardModifier = PLAIN
) -> bool:
    """A key of the digit row as the platform sends it: who wants it is asked first.

    Returns:
        Whether somebody wanted it before the shortcuts.
    """
    before = wanted(widget, place, key, text, held)
    press = QKeyEvent(QEvent.Type.KeyPress, key.value, held, 9 + place, 0, 0, text)
    QApplication.sendEvent(widget, press)
    return before


def test_french_digits_without_shift(window):
    for place, key, text in (
        (1, Qt.Key.Key_Ampersand, "&"),
        (2, Qt.Key.Key_Eacute, "é"),
        (10, Qt.Key.Key_Agrave, "à"),
    ):
        window.services.selection.select_class(None)
        assert strike(window.canvas, place, key, text)
        shortcut = str(place % 10)
        expected = next(
            e.name for e in window.services.state.field.elements if e.shortcut == shortcut
        )
        assert window.services.state.selected_class == expected


def test_french_digits_with_shift(window):
    strike(window.canvas, 1, Qt.Key.Key_1, "1", SHIFT)
    expected = next(e.name for e in window.services.state.field.elements if e.shortcut == "Shift+1")
    assert window.services.state.selected_class == expected


def test_the_french_sixth_key_is_no_minus(window):
    # What is wanted is pressed without asking the shortcuts; an event sent by hand asks them.
    assert wanted(window.canvas, 6, Qt.Key.Key_Minus, "-")
    assert not wanted(window.canvas, 20, Qt.Key.Key_Minus, "-")  # the key of other keyboards


def test_the_german_slash_is_a_digit_with_shift(window):
    assert strike(window.canvas, 7, Qt.Key.Key_Slash, "/", SHIFT)
    expected = next(e.name for e in window.services.state.field.elements if e.shortcut == "Shift+7")
    assert window.services.state.selected_class == expected
    assert window.canvas.hasFocus()


def test_what_is_typed_stays_text(window):
    window.frames.focus_filter()
    box: QLineEdit = window.frames.filter
    before = window.services.state.selected_class
    strike(box, 1, Qt.Key.Key_Ampersand, "&")
    assert box.text() == "&"
    assert window.services.state.selected_class == before
    box.clear()


def test_third_level_keys_are_none_of_its_business(window):
    window.services.selection.select_class(None)
    assert not strike(window.canvas, 7, Qt.Key.Key_BraceLeft, "{", ALTGR)
    assert window.services.state.selected_class is None


def test_the_german_and_swiss_point_says_not_visible(window):
    window.services.selection.select_class("Middle line")
    strike(window.canvas, 51, Qt.Key.Key_Period, ".")
    frame = window.services.state.frame
    assert "Middle line" in window.services.review.not_visible(frame.name)


def test_the_swiss_and_german_comma_blinks_as_it_is_held(window):
    strike(window.canvas, 50, Qt.Key.Key_Comma, ",")
    assert "blink" in window.status.hint.text()


@pytest.mark.parametrize(
    ("place", "key", "text"),
    [(7, Qt.Key.Key_Slash, "/"), (8, Qt.Key.Key_ParenLeft, "("), (1, Qt.Key.Key_Plus, "+")],
)
def test_swiss_digits_with_shift(window, place, key, text):
    window.services.selection.select_class(None)
    before = window.services.state.tau
    strike(window.canvas, place, key, text, SHIFT)
    chosen = window.services.state.selected_class
    shortcuts = {e.shortcut: e.name for e in window.services.state.field.elements}
    assert chosen == shortcuts.get(f"Shift+{place}")
    assert window.services.state.tau == before
