"""The three steps of the first run go away by being done, for ever, and are in nobody's way."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import COACHED, Settings
from procc_annotator.gui.window.coach import Coach
from tests.gui.conftest import Hand, wait_for_ghosts

pytestmark = [
    pytest.mark.qt_log_ignore("This plugin does not support", extend=True),
    pytest.mark.new_window,
]


def test_it_goes_by_doing(begun: MainWindow, qtbot: QtBot) -> None:
    coach, hand = begun.coach, Hand(begun)
    coach.begin()
    assert coach.card.isVisible()
    assert "Shift+R" in coach.card.accessibleName()
    hand.draw("Side line top", (100, 60), (300, 65))
    assert coach.done == [True, False, False]
    assert "Enter, done" in coach.card.accessibleName()
    hand.key(Qt.Key.Key_R, Qt.KeyboardModifier.ShiftModifier)
    assert coach.done == [True, True, False]
    begun.document.editing.undo()
    begun.document.editing.undo()
    wait_for_ghosts(begun, qtbot)
    qtbot.waitUntil(lambda: bool(begun.document.ghosts.painted), timeout=20_000)
    assert coach.card.isVisible()
    hand.key(Qt.Key.Key_Tab)
    current = begun.document.ghosts.current
    assert current is not None
    qtbot.waitUntil(lambda: begun.document.ghosts.found(current.name) is not None)
    hand.key(Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: all(coach.done))
    assert not coach.card.isVisible()
    assert Settings().get(COACHED)
    again = Coach(begun.document, begun.canvas, begun.actions_, begun.settings)
    again.begin()
    assert not again.card.isVisible()


def test_clicks_go_through_it_and_a_cross_puts_it_away(window: MainWindow) -> None:
    coach, canvas = window.coach, window.canvas
    coach.begin()
    card = coach.card
    assert window.rect().contains(card.mapTo(window, QPoint(card.width(), card.height())))
    window.document.selecting.select_class("Middle line")
    below = card.geometry().center()
    assert canvas.viewport().childAt(below) in (None, coach.card)
    under = window.childAt(canvas.viewport().mapTo(window, below))
    assert under is canvas.viewport()  # which is who gets the click
    window.document.say("a colleague has this frame", "warning")
    bars = window.bars
    bottom = bars.mapTo(window, QPoint(0, bars.height())).y()
    assert card.mapTo(window, QPoint(0, 0)).y() >= bottom  # no bar lies over it
    QTest.mouseClick(coach.close_button, Qt.MouseButton.LeftButton)
    assert not card.isVisible()
    assert Settings().get(COACHED)


def test_it_waits_for_a_frame(make_window) -> None:
    window = make_window()
    window.coach.begin()
    assert not window.coach.card.isVisible()
