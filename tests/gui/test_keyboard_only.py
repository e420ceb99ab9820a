"""A frame is annotated, and every part of the window reached, without a mouse."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolBar, QToolButton

from procc_annotator.gui.window.keyboard_focus import FocusRegions
from tests.gui.conftest import Hand

KEY = Qt.Key
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier


def go(hand: Hand, x: float, y: float) -> None:
    """Bring the crosshair to a whole pixel."""
    keys = hand.canvas.keys
    if not keys.active:
        hand.key(KEY.Key_Left)
    for axis, target, less, more in (
        (0, x, KEY.Key_Left, KEY.Key_Right),
        (1, y, KEY.Key_Up, KEY.Key_Down),
    ):
        for step, held in ((100, CTRL | SHIFT), (10, CTRL), (1, Qt.KeyboardModifier.NoModifier)):
            while abs(gap := target - keys.crosshair.px[axis]) >= step:
                hand.key(more if gap > 0 else less, held)
        while abs(gap := target - keys.crosshair.px[axis]) > 0.05:
            hand.key(more if gap > 0 else less, SHIFT)


def test_an_element_is_drawn_moved_and_deleted_by_keys_alone(window, hand, saved):
    window.services.selection.select_class("Middle line")
    for x, y in ((320, 40), (330, 250)):
        go(hand, x, y)
        hand.key(KEY.Key_Space, CTRL)
    assert window.canvas.editor.drawing
    hand.key(KEY.Key_Return)
    assert saved() == pytest.approx(np.array([(320, 40), (330, 250)]), abs=0.06)

    window.services.selection.set_mode("edit")
    go(hand, 331, 250)
    hand.key(KEY.Key_Space)
    assert window.services.state.selection.point == ("Middle line", 1)
    hand.key(KEY.Key_Down, CTRL)
    hand.key(KEY.Key_Left)
    assert saved()[1] == pytest.approx((329, 260), abs=0.06)
    hand.key(KEY.Key_Delete)
    assert len(saved()) == 1


def test_a_point_is_put_on_a_line_by_keys_alone(window, hand, saved):
    window.services.selection.select_class("Middle line")
    for x, y in ((320, 40), (320, 250)):
        go(hand, x, y)
        hand.key(KEY.Key_Space, CTRL)
    hand.key(KEY.Key_Return)
    window.services.selection.select_class(None)
    go(hand, 322, 150)
    hand.key(KEY.Key_Insert)
    assert saved() == pytest.approx(np.array([(320, 40), (320, 150), (320, 250)]), abs=0.06)
    assert window.services.state.selection.point == ("Middle line", 1)
    hand.key(KEY.Key_Right)  # it is chosen: the arrows move it
    assert saved()[1] == pytest.approx((321, 150), abs=0.06)
    window.services.selection.select_class(None)
    go(hand, 500, 150)
    hand.key(KEY.Key_Insert)
    assert len(saved()) == 3
    assert "no line here" in window.status.hint.text()


def test_the_crosshair_begins_in_the_middle_and_goes_with_the_mouse(window, hand):
    services, keys = window.services, window.canvas.keys
    QApplication.sendEvent(window.canvas, QEvent(QEvent.Type.Leave))  # of tests before
    services.selection.select_class("Middle line")
    hand.key(KEY.Key_Right)
    assert keys.crosshair.px == pytest.approx((320.5, 179.5), abs=1)
    assert (
        window.status.pixels.text() == f"{keys.crosshair.px[0]:.1f} {keys.crosshair.px[1]:.1f} px"
    )
    assert "Space clicks" in window.status.hint.text()
    at = window.canvas.to_view(*keys.crosshair.px).toPoint()
    with_cross = window.canvas.viewport().grab().toImage()
    assert QColor(with_cross.pixelColor(at.x() + 10, at.y())).lightness() > 200
    hand.move(100, 100)
    assert not keys.active
    hand.key(KEY.Key_Up)
    assert keys.crosshair.px == pytest.approx((100, 99), abs=1)
    services.selection.select_class(None)
    hand.key(KEY.Key_Escape)
    assert not keys.active


def test_the_view_follows_the_crosshair_and_the_picture_ends_it(window, hand):
    canvas = window.canvas
    canvas.fly_to(320, 180)
    for _ in range(8):
        hand.key(KEY.Key_Right, CTRL | SHIFT)
    px = canvas.keys.crosshair.px
    assert px[0] == 639
    assert canvas.viewport().rect().contains(canvas.to_view(*px).toPoint())


def test_space_still_pans(window, hand):
    window.services.selection.select_class("Middle line")
    hand.key(KEY.Key_Right)
    canvas = window.canvas
    QTest.keyPress(canvas, KEY.Key_Space)
    hand.drag((300, 200), (320, 200))
    QTest.keyRelease(canvas, KEY.Key_Space)
    assert not canvas.editor.drawing


def test_the_keyboard_goes_round_all_parts(window, hand):
    regions = FocusRegions(window).all()
    seen = []
    for _ in regions:
        QTest.keyClick(QApplication.focusWidget(), KEY.Key_F6)
        focus = QApplication.focusWidget()
        seen.append(next(r for r in regions if r is focus or r.isAncestorOf(focus)))
    assert {id(r) for r in seen} == {id(r) for r in regions}
    assert {window.menuWidget(), window.strips, window.docks["elements"]} <= set(seen)
    assert any(isinstance(r, QToolBar) for r in seen)
    assert QApplication.focusWidget() is window.canvas
    QTest.keyClick(window.canvas, KEY.Key_F6, SHIFT)
    assert window.centralWidget() is not seen[-2]
    assert seen[-2].isAncestorOf(QApplication.focusWidget())


def test_a_ring_shows_what_has_the_keyboard(window, hand):
    ring = window.focus_ring
    window.regions.all()  # which lets the keyboard reach the bars
    buttons = [b for bar in window.findChildren(QToolBar) for b in bar.findChildren(QToolButton)]
    button = next(b for b in buttons if b.isVisible() and b.isEnabled())
    button.setFocus(Qt.FocusReason.TabFocusReason)
    assert ring.widget is button
    assert ring.shown
    at = button.mapTo(window, button.rect().topLeft())
    shown = window.grab().toImage()
    colour = window.palette().link().color()
    assert shown.pixelColor(at.x() + button.width() // 2, at.y()) == colour
    hand.click(200, 100)
    assert not ring.shown


def test_elements_are_chosen_on_the_field_map_by_the_arrows(window, hand):
    panel, services = window.field_map, window.services
    panel.setFocus(Qt.FocusReason.TabFocusReason)
    services.selection.select_class("Middle line")
    middle = panel.position_of("Middle line")
    QTest.keyClick(panel, KEY.Key_Right)
    right = services.state.selected_class
    assert right not in (None, "Middle line")
    assert panel.position_of(right).x() > middle.x()
    reached = set()
    for key in (KEY.Key_Left, KEY.Key_Up, KEY.Key_Right, KEY.Key_Down) * 3:
        for _ in range(30):
            before = services.state.selected_class
            QTest.keyClick(panel, key)
            reached.add(services.state.selected_class)
            if services.state.selected_class == before:
                break
    assert len(reached) > 15
