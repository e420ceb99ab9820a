"""Drawing and editing with mouse and keys on the real window."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QNativeGestureEvent, QPointingDevice, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import heard

ALT = Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier
MIDDLE = "Middle line"
TOP = "Side line top"
SIZE = (640, 360)


def wheel(window: MainWindow, at: QPointF, steps: int) -> None:
    view = window.canvas.viewport()
    event = QWheelEvent(
        at, view.mapToGlobal(at), QPointF(0, 0).toPoint(), QPointF(0, 120 * steps).toPoint(),
        Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(view, event)


class TestWhere:
    def test_the_corner_pixels_have_the_coordinates_of_the_format(self, window):
        canvas = window.canvas
        canvas.set_scale(8.0)
        for x, y in ((0.0, 0.0), (SIZE[0] - 1.0, SIZE[1] - 1.0), (17.25, 3.5)):
            canvas.fly_to(x, y)
            assert canvas.to_picture(canvas.to_view(x, y)) == pytest.approx((x, y), abs=1e-9)
            in_scene = canvas.mapToScene(canvas.to_view(x, y).toPoint())
            assert abs(in_scene.x() - (x + 0.5)) <= 1 / canvas.view_scale

    def test_at_actual_size_a_screen_pixel_is_the_centre_of_its_picture_pixel(self, window):
        window.canvas.actual_size()
        x, y = window.canvas.to_picture(QPointF(100, 100))
        assert x == pytest.approx(round(x), abs=1e-9)
        assert y == pytest.approx(round(y), abs=1e-9)

    def test_the_status_bar_shows_the_cursor_in_picture_pixels(self, window, hand):
        hand.move(200, 100)
        x, y = hand.picture(200, 100)
        assert window.status.pixels.text() == f"{x:.1f} {y:.1f} px"


def scroll(
    window: MainWindow,
    moved: tuple[int, int],
    *,
    fingers: bool = False,
    held: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
) -> None:
    """Two fingers, by so many px, or a wheel, by so many eighths of a degree."""
    view = window.canvas.viewport()
    at = QPointF(view.rect().center())
    pixels = QPoint(*moved) if fingers else QPoint()
    phase = Qt.ScrollPhase.ScrollUpdate if fingers else Qt.ScrollPhase.NoScrollPhase
    event = QWheelEvent(
        at, view.mapToGlobal(at), pixels, QPoint(*moved), Qt.MouseButton.NoButton, held, phase,
        False,
    )  # fmt: skip
    QApplication.sendEvent(view, event)


def pinch(window: MainWindow, at: QPointF, by: float) -> None:
    view = window.canvas.viewport()
    touchpad = QPointingDevice.primaryPointingDevice()
    kind = Qt.NativeGestureType.ZoomNativeGesture
    none = QPointF()
    event = QNativeGestureEvent(
        kind, touchpad, 2, at, at, QPointF(view.mapToGlobal(at)), by, none
    )  # fmt: skip
    QApplication.sendEvent(view, event)


class TestZoomAndPan:
    def test_two_fingers_pan(self, window):
        canvas = window.canvas
        canvas.set_scale(4.0)
        before = canvas.to_picture(QPointF(200, 200))
        scroll(window, (30, -50), fingers=True)
        assert canvas.view_scale == 4.0
        assert canvas.to_picture(QPointF(230, 150)) == pytest.approx(before, abs=0.3)

    def test_ctrl_makes_two_fingers_zoom(self, window):
        window.canvas.set_scale(4.0)
        scroll(window, (0, 120), fingers=True, held=CTRL)
        assert window.canvas.view_scale == pytest.approx(4.8)

    def test_a_pinch_zooms_at_the_fingers(self, window, hand):
        canvas = window.canvas
        canvas.set_scale(4.0)
        at = QPointF(300, 200)
        before = canvas.to_picture(at)
        pinch(window, at, 0.25)
        assert canvas.view_scale == pytest.approx(5.0)
        assert canvas.to_picture(at) == pytest.approx(before, abs=0.3)

    @pytest.mark.parametrize(
        ("turned", "held"),
        [((120, 0), Qt.KeyboardModifier.NoModifier), ((0, 120), SHIFT)],
        ids=["tilted", "with Shift"],
    )
    def test_a_wheel_goes_sideways(self, window, turned, held):
        canvas = window.canvas
        canvas.set_scale(4.0)
        before = canvas.to_picture(QPointF(200, 200))
        scroll(window, turned, held=held)
        assert canvas.view_scale == 4.0
        assert canvas.to_picture(QPointF(260, 200)) == pytest.approx(before, abs=0.3)

    def test_the_wheel_keeps_what_is_under_the_cursor(self, window, hand):
        at = QPointF(hand.at(500, 80))
        before = window.canvas.to_picture(at)
        scale = window.canvas.view_scale
        wheel(window, at, 5)
        assert window.canvas.view_scale == pytest.approx(scale * 1.2**5)
        after = window.canvas.to_picture(at)
        assert np.hypot(after[0] - before[0], after[1] - before[1]) * window.canvas.view_scale < 1.5

    def test_zoom_ends_at_6400_percent_and_at_the_whole_picture(self, window, hand):
        at = QPointF(hand.at(320, 180))
        wheel(window, at, 60)
        assert window.canvas.view_scale == 64.0
        wheel(window, at, -90)
        assert window.canvas.view_scale == pytest.approx(min(1.0, window.canvas.fit_scale))

    @pytest.mark.parametrize("mode", ["draw", "edit"])
    def test_the_middle_button_pans_and_draws_nothing(self, window, hand, mode):
        window.services.selection.set_mode(mode)
        window.services.selection.select_class(MIDDLE)
        window.canvas.set_scale(4.0)
        before = window.canvas.to_picture(QPointF(200, 200))
        hand.drag((300, 150), (310, 155), Qt.MouseButton.MiddleButton)
        after = window.canvas.to_picture(QPointF(200, 200))
        assert (after[0] - before[0], after[1] - before[1]) == pytest.approx((-10, -5), abs=0.6)
        assert not window.canvas.editor.drawing

    def test_space_and_drag_pans_while_drawing(self, window, hand):
        window.services.selection.select_class(MIDDLE)
        hand.click(300, 100)
        window.canvas.set_scale(4.0)
        before = window.canvas.to_picture(QPointF(200, 200))
        QTest.keyPress(window.canvas, Qt.Key.Key_Space)
        hand.drag((300, 150), (310, 155))
        QTest.keyRelease(window.canvas, Qt.Key.Key_Space)
        after = window.canvas.to_picture(QPointF(200, 200))
        assert (after[0] - before[0], after[1] - before[1]) == pytest.approx((-10, -5), abs=0.6)
        hand.click(310, 160)
        hand.key(Qt.Key.Key_Return)
        polyline = window.services.state.annotation.get(MIDDLE)
        assert len(polyline.points) == 2

    def test_zoom_stays_across_frames_on_request_only(self, window, hand):
        window.canvas.set_scale(6.0)
        hand.key(Qt.Key.Key_D)
        assert window.canvas.view_scale == pytest.approx(window.canvas.fit_scale)
        hand.key(Qt.Key.Key_K, CTRL | SHIFT)
        window.canvas.set_scale(6.0)
        hand.key(Qt.Key.Key_A)
        assert window.services.state.frame_index == 0
        assert window.canvas.view_scale == 6.0

    def test_magnified_pixels_are_not_smoothed(self, window):
        window.canvas.set_scale(32.0)
        window.canvas.fly_to(40.0, 100.0)  # a border between two stripes
        window.canvas.drawing.set_hidden(True)
        shown = window.canvas.viewport().grab().toImage()
        greens = {shown.pixelColor(x, shown.height() // 2).green() for x in range(shown.width())}
        assert len(greens) == 2


class TestDraw:
    def test_clicks_and_enter_make_an_element_saved_where_it_was_clicked(self, window, hand, saved):
        clicked = hand.draw(MIDDLE, (100, 50), (150, 200), (180, 300))
        np.testing.assert_allclose(saved(), clicked, atol=1e-9)

    def test_a_double_click_finishes_without_doubling_the_point(self, window, hand, saved):
        window.services.selection.select_class(MIDDLE)
        first = hand.click(100, 50)
        last = hand.double_click(400, 250)
        np.testing.assert_allclose(saved(), [first, last], atol=1e-9)
        assert not window.canvas.editor.drawing

    def test_backspace_takes_back_the_last_point_and_escape_all(self, window, hand, saved):
        window.services.selection.select_class(MIDDLE)
        kept = [hand.click(100, 50), hand.click(120, 90)]
        hand.click(500, 300)
        hand.key(Qt.Key.Key_Backspace)
        hand.key(Qt.Key.Key_Return)
        np.testing.assert_allclose(saved(), kept, atol=1e-9)
        window.services.selection.select_class(TOP)
        hand.click(10, 10)
        hand.key(Qt.Key.Key_Escape)
        assert saved(TOP).size == 0
        assert window.services.state.annotation.annotated == (MIDDLE,)

    def test_points_of_a_draft_survive_a_change_of_frame(self, window, hand, saved):
        window.services.selection.select_class(MIDDLE)
        clicked = [hand.click(100, 50), hand.click(120, 90)]
        hand.key(Qt.Key.Key_D)
        assert window.services.state.frame_index == 1
        assert "Halfway line" in window.status.hint.text()
        hand.key(Qt.Key.Key_A)
        hand.draw(MIDDLE, (140, 130))
        np.testing.assert_allclose(saved()[:2], clicked, atol=1e-9)

    def test_undo_while_drawing_takes_back_a_point(self, window, hand):
        window.services.selection.select_class(MIDDLE)
        hand.click(100, 50)
        hand.click(120, 90)
        hand.key(Qt.Key.Key_Z, CTRL)
        hand.key(Qt.Key.Key_Return)
        polyline = window.services.state.annotation.get(MIDDLE)
        assert len(polyline.points) == 1

    def test_the_hint_says_what_the_next_click_does(self, window, hand):
        without = window.canvas.hint
        window.services.selection.select_class(MIDDLE)
        chosen = window.canvas.hint
        hand.click(100, 50)
        drawing = window.canvas.hint
        assert len({without, chosen, drawing}) == 3
        assert "Halfway line" in chosen
        assert "Enter" in drawing
        assert "Esc" in drawing


class TestEdit:
    def test_dragging_a_point_moves_it_in_one_step(self, window, hand, saved):
        hand.draw(MIDDLE, (100, 50), (150, 200))
        window.services.selection.set_mode("edit")
        start, end = hand.picture(100, 50), hand.picture(220, 90)
        hand.drag((100, 50), (220, 90))
        expected = np.array(saved())[0]
        assert expected == pytest.approx(end, abs=0.6)
        assert start != end
        hand.key(Qt.Key.Key_Z, CTRL)
        assert saved()[0] == pytest.approx(start, abs=1e-6)

    def test_a_point_is_picked_within_ten_screen_pixels_only(self, window, hand, saved):
        hand.draw(MIDDLE, (100, 50), (150, 200))
        before = saved()
        window.services.selection.set_mode("edit")
        screen = 1 / window.canvas.view_scale
        hand.drag((100 - 14 * screen, 50), (300, 50))
        np.testing.assert_array_equal(saved(), before)
        hand.drag((100 - 7 * screen, 50), (300, 50))
        assert saved()[0][0] > 250

    def test_alt_click_on_a_segment_inserts_a_point_there(self, window, hand, saved):
        hand.draw(MIDDLE, (100, 50), (100, 250))
        window.services.selection.set_mode("edit")
        hand.click(100, 150, ALT)
        points = saved()
        assert len(points) == 3
        assert points[1] == pytest.approx((100, 150), abs=1.5)

    def test_alt_shift_click_and_delete_remove_points(self, window, hand, saved):
        hand.draw(MIDDLE, (100, 50), (100, 150), (100, 250))
        window.services.selection.set_mode("edit")
        hand.click(100, 150, ALT | SHIFT)
        assert len(saved()) == 2
        hand.click(100, 250)
        hand.key(Qt.Key.Key_Delete)
        assert len(saved()) == 1

    def test_arrows_nudge_by_one_and_a_tenth_of_a_pixel(self, window, hand, saved):
        hand.draw(MIDDLE, (100, 50), (100, 150))
        window.services.selection.set_mode("edit")
        hand.click(100, 50)
        before = saved()[0]
        hand.key(Qt.Key.Key_Right)
        hand.key(Qt.Key.Key_Up, SHIFT)
        assert saved()[0] - before == pytest.approx((1.0, -0.1), abs=1e-9)

    def test_undo_and_redo_have_no_limit(self, window, hand, saved):
        hand.draw(MIDDLE, (100, 50), (100, 150))
        window.services.selection.set_mode("edit")
        hand.click(100, 50)
        start = saved()
        for _ in range(60):
            hand.key(Qt.Key.Key_Right)
        end = saved()
        for _ in range(60):
            hand.key(Qt.Key.Key_Z, CTRL)
        np.testing.assert_allclose(saved(), start, atol=1e-9)
        for _ in range(60):
            hand.key(Qt.Key.Key_Z, CTRL | SHIFT)
        np.testing.assert_allclose(saved(), end, atol=1e-9)

    def test_undo_belongs_to_its_frame(self, window, hand, saved):
        hand.draw(MIDDLE, (100, 50), (100, 150))
        hand.key(Qt.Key.Key_D)
        hand.key(Qt.Key.Key_Z, CTRL)
        assert len(saved()) == 2
        hand.key(Qt.Key.Key_A)
        hand.key(Qt.Key.Key_Z, CTRL)
        assert len(saved()) == 0


def test_hovering_a_line_tells_every_widget(window, hand):
    hand.draw(MIDDLE, (100, 50), (100, 250))
    window.services.selection.set_mode("edit")
    hand.move(100, 150)
    assert window.services.state.hovered_class == MIDDLE
    hand.move(300, 150)
    assert window.services.state.hovered_class is None


def test_holding_x_shows_the_bare_picture(window, hand, qtbot):
    hand.draw(MIDDLE, (100, 50), (100, 250))
    assert any(len(s.segments) for s in window.canvas.overlay_item.overlay.strokes)
    QTest.keyPress(window.canvas, Qt.Key.Key_X)
    assert not window.canvas.overlay_item.overlay.strokes
    QTest.keyRelease(window.canvas, Qt.Key.Key_X)
    assert any(len(s.segments) for s in window.canvas.overlay_item.overlay.strokes)


def test_ctrl_delete_removes_the_element_while_drawing_too(window, hand, saved):
    told = heard(window.services)
    hand.draw("Middle line", (300, 60), (310, 300))
    hand.draw("Side line top", (100, 60), (500, 60))
    window.services.selection.select_class("Middle line", continues=True)
    hand.click(320, 340)  # one more point is on its way
    assert window.canvas.editor.drawing
    hand.key(Qt.Key.Key_Delete, CTRL)
    assert not window.canvas.editor.drawing
    assert len(saved("Middle line")) == 0
    window.services.editing.undo()
    assert len(saved("Middle line")) == 2
    window.services.selection.select_class("Side line left")
    hand.key(Qt.Key.Key_Delete, CTRL)
    assert told[-1] == "Left goal line has no points in this frame: choose the element to delete"
    hand.click(50, 100)
    hand.key(Qt.Key.Key_Delete, CTRL)
    assert told[-1].startswith("dropped 1 point of ")
    window.services.selection.select_class(None)
    hand.key(Qt.Key.Key_Delete, CTRL)
    assert told[-1].startswith("choose the element to delete first")
    assert len(saved("Side line top")) == 2
