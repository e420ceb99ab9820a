"""Lines are drawn first and named after; nothing of them is lost meanwhile."""

import json

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import KEPT, Hand

LEFT = Qt.MouseButton.LeftButton
UNKNOWN = "Line unknown"


def drawn(window: MainWindow, hand: Hand, qtbot: QtBot, *points: tuple[float, float]) -> QMenu:
    """Draw a line with no class chosen; the menu that asks its name."""
    window.services.selection.select_class(None)
    window.naming.menu = None
    for point in points:
        hand.click(*point)
    hand.key(Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: window.naming.menu is not None and window.naming.menu.isVisible())
    menu = window.naming.menu
    assert menu is not None
    return menu


def offered(menu: QMenu) -> list[str]:
    return [str(action.data()) for action in menu.actions() if action.data()]


def middle_of(window: MainWindow, name: str) -> list[tuple[float, float]]:
    """Two places on a ghost, some px beside it."""
    ghost = next(g for g in window.services.ghosts.known if g.name == name)
    px = ghost.pieces[0].points_px
    chosen = px[[len(px) // 4, 3 * len(px) // 4]]
    return [(float(x) + 2.0, float(y) + 2.0) for x, y in chosen]


def test_a_line_without_a_class_is_kept_and_named(window, hand, qtbot, saved):
    menu = drawn(window, hand, qtbot, (100, 100), (300, 120), (500, 130))
    assert len(saved(UNKNOWN)) == 3  # kept before anybody says what it is
    name = "Big rect. left main"
    assert offered(menu)[1] != name  # its own key, whatever stands second
    QTest.keyClick(menu, Qt.Key.Key_2)
    assert not menu.isVisible()
    assert len(saved(name)) == 3
    assert len(saved(UNKNOWN)) == 0
    assert window.services.state.selected_class is None  # the next line is drawn first, too


def test_two_points_are_no_curve_without_a_word(window, hand, qtbot, saved):
    menu = drawn(window, hand, qtbot, (100, 100), (300, 120))
    assert not window.canvas.editor.curved & set(offered(menu))
    circle = window.services.state.field.element("Circle central")
    QTest.keySequence(menu, circle.shortcut)
    assert len(saved("Circle central")) == 2
    assert "Centre circle is a curve" in window.message_bar.label.text()
    hand.click(200, 200)  # and it goes on
    hand.key(Qt.Key.Key_Return)
    assert len(saved("Circle central")) == 3


@pytest.mark.parametrize("by_key", [True, False])
def test_any_element_is_found_by_its_name(window, hand, qtbot, saved, by_key):
    menu = drawn(window, hand, qtbot, (100, 100), (300, 120))
    if by_key:
        QTest.keyClick(menu, "/")
    else:
        QTest.mouseClick(menu, LEFT, pos=menu.actionGeometry(menu.actions()[-2]).center())
    palette = window.palette_
    qtbot.waitUntil(palette.isVisible)
    assert palette.model.rowCount() >= len(window.services.state.field.elements)
    QTest.keyClicks(palette.search, "right goal cross")
    QTest.keyClick(palette.search, Qt.Key.Key_Return)
    assert len(saved("Goal right crossbar")) == 2
    assert len(saved(UNKNOWN)) == 0


def test_enter_takes_the_first(window, hand, qtbot, saved):
    menu = drawn(window, hand, qtbot, (100, 100), (300, 120))
    assert len(offered(menu)) == 3
    name = offered(menu)[0]
    QTest.keyClick(menu, Qt.Key.Key_Return)
    assert len(saved(name)) == 2


def test_escape_leaves_it_as_it_is(window, hand, qtbot, saved):
    QTest.keyClick(drawn(window, hand, qtbot, (100, 100), (300, 120)), Qt.Key.Key_Escape)
    assert len(saved(UNKNOWN)) == 2
    QTest.keyClick(drawn(window, hand, qtbot, (100, 200), (300, 220)), Qt.Key.Key_Escape)
    assert len(saved(UNKNOWN)) == 2  # the second one is a line of its own
    assert len(saved(f"{UNKNOWN} (2)")) == 2


def test_an_elements_key_names_the_line_under_way(window, hand, saved):
    window.services.selection.select_class(None)
    hand.click(100, 100)
    hand.click(300, 120)
    assert "an element's key names it" in window.canvas.hint
    hand.key(Qt.Key.Key_9)
    hand.click(500, 140)
    hand.key(Qt.Key.Key_Return)
    assert len(saved("Middle line")) == 3
    assert len(saved(UNKNOWN)) == 0


def test_a_frame_that_is_left_keeps_its_line(window, hand, saved):
    window.services.selection.select_class(None)
    hand.click(100, 100)
    hand.click(300, 120)
    hand.key(Qt.Key.Key_D)
    assert window.services.state.frame_index == 1
    hand.key(Qt.Key.Key_A)
    assert len(saved(UNKNOWN)) == 0
    assert len(window.services.state.annotation.get_unconfirmed(UNKNOWN).points) == 2


def test_undo_takes_back_the_name_then_the_line(window, hand, qtbot, saved):
    menu = drawn(window, hand, qtbot, (100, 100), (300, 120))
    name = offered(menu)[0]
    QTest.keyClick(menu, Qt.Key.Key_Return)
    hand.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert len(saved(UNKNOWN)) == 2
    assert len(saved(name)) == 0
    hand.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert len(saved(UNKNOWN)) == 0


def test_where_a_camera_is_known_the_line_below_the_pen_comes_first(begun, hand_on, qtbot):
    hand = hand_on(begun)
    names = [ghost.name for ghost in begun.services.ghosts.known][:4]
    assert len(names) == 4
    for name in names:
        menu = drawn(begun, hand, qtbot, *middle_of(begun, name))
        assert offered(menu)[0] == name
        QTest.keyClick(menu, Qt.Key.Key_Escape)
        hand.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        qtbot.waitUntil(lambda: len(begun.services.ghosts.known) >= 4)


def test_it_can_be_switched_off(window, hand):
    window.actions_["draw_first"].trigger()
    window.services.selection.select_class(None)
    hand.click(100, 100)
    assert not window.canvas.editor.drawing
    assert "choose an element first" in window.status.hint.text_for(2000)


def test_a_camera_known_from_few_clicks_names_every_line_in_sight(begun, sample_data):
    """Also those that it knows too little of for a ghost, and while it is fitted anew."""
    size = begun.services.state.picture_size
    truth = json.loads((sample_data / "00002.json").read_text())
    missing = [name for name in truth if name not in KEPT and len(truth[name]) > 1]
    assert len(missing) >= 5
    for name in missing:
        points = np.array([(p["x"], p["y"]) for p in truth[name]]) * (size[0] - 1, size[1] - 1)
        assert begun.naming._likely(points)[0] == name


def test_without_a_camera_directions_and_named_neighbours_decide(window, hand, qtbot, sample_data):
    """On a first frame, with nothing but two elements that have names."""
    services = window.services
    services.live_fit.set_wanted(False)
    truth = json.loads((sample_data / "00003.json").read_text())
    places = {
        name: [(p["x"] * 639, p["y"] * 359) for p in points] for name, points in truth.items()
    }
    given = ("Big rect. right main", "Side line top")
    for name in given:
        hand.draw(name, places[name][0], places[name][-1])
    asked = ("Big rect. right top", "Big rect. right bottom", "Small rect. right main")
    right = 0
    for name in asked:
        menu = drawn(window, hand, qtbot, places[name][0], places[name][-1])
        right += name in offered(menu)
        assert not set(offered(menu)) & set(given)
        QTest.keyClick(menu, Qt.Key.Key_Escape)
    assert right == len(asked)
