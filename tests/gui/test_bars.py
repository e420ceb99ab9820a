"""Bars that come and go while somebody clicks."""

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QApplication, QToolButton

from procc_annotator.gui.theme import set_text_size
from procc_annotator.gui.window.status import Readout, SteadyLabel
from tests.gui.conftest import all_done


@pytest.mark.parametrize("zoomed", [False, True])
def test_no_bar_moves_what_is_under_the_cursor(window, hand, qtbot, zoomed):
    all_done(qtbot)  # the strip below the picture comes a moment after the frame
    canvas = window.canvas
    if zoomed:
        canvas.set_scale(4.0)

    def on_screen() -> QPoint:
        return canvas.viewport().mapToGlobal(hand.at(320, 180))

    before, tall = on_screen(), window.bars.height()
    window.services.say("saving failed: " + "the disk is full " * 20, "error")
    qtbot.waitUntil(lambda: window.bars.height() > tall)
    assert window.message_bar.isVisible()
    assert on_screen() == before
    window.message_bar.hide()
    qtbot.waitUntil(lambda: window.bars.height() == tall)
    assert on_screen() == before


def test_no_bar_moves_the_next_frame_either(window, hand, qtbot):
    all_done(qtbot)
    window.panels.turn_to("judge")
    corner = hand.at(0, 0), hand.at(600, 300)
    window.services.say("a colleague has this frame", "warning")
    qtbot.waitUntil(lambda: window.bars.height() > 0)
    window.services.navigator.next_frame()
    assert window.message_bar.isVisible()
    assert (hand.at(0, 0), hand.at(600, 300)) == corner


def test_a_warning_is_shown_though_something_else_is_said_at_once(window):
    services = window.services
    with services.store.transaction():
        services.say("a colleague has this frame", "warning")
        services.say("the frame is in progress again", "info")
    assert window.message_bar.isVisible()
    assert "a colleague has this frame" in window.message_bar.label.text()
    assert "the frame is in progress again" in window.status.hint.text()


def test_words_of_the_bars_have_room_when_texts_become_larger(window, qtbot):
    all_done(qtbot)
    application = QApplication.instance()
    assert isinstance(application, QApplication)
    desks = window.workspace_switch.findChildren(QToolButton)
    labels = [label for label in window.top_bar.findChildren(SteadyLabel) if label.text()]
    readouts = window.findChildren(Readout)
    assert desks
    assert len(labels) >= 2
    assert readouts
    usual = [readout.width() for readout in readouts]
    try:
        set_text_size(application, 150)
        QApplication.processEvents()
        for desk in desks:
            assert desk.maximumHeight() > desk.fontMetrics().height()
        for label in labels:
            assert label.width() >= label.fontMetrics().horizontalAdvance(label.text())
            assert label.height() >= label.fontMetrics().height()
        assert all(r.width() > 1.3 * w for r, w in zip(readouts, usual, strict=True))
    finally:
        set_text_size(application, 100)
    QApplication.processEvents()
    assert [readout.width() for readout in readouts] == usual
