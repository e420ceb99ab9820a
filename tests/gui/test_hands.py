"""Snapping, the loupe, regularising, copying, several points at once: the annotator's hands."""

import shutil
from functools import cache
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu, QToolTip
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import FrameAnnotation, Polyline, points_px
from procc_annotator.dataset.records import OriginKind
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.window.menus import canvas_menu
from procc_annotator.image.pixels import DisplayAdjustment
from tests.bench.paint.measures import clicks_on
from tests.bench.paint.truth import truth_frames
from tests.gui.conftest import Hand, all_done, heard

SIZE = (960, 540)
CTRL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
MIDDLE, TOP = "Middle line", "Side line top"
# The painted line's centre: x of the upright line, y of the level one.
UPRIGHT, LEVEL = 480.0, 120.0


@cache
def draw_pitch(shift: int) -> bytes:
    """A JPEG of a pitch with an upright and a level line, ``shift`` px further to the right."""
    rng = np.random.default_rng(5)
    wide = np.zeros((SIZE[1], SIZE[0] + 400, 3), dtype=np.uint8)
    wide[:] = (50, 120, 50)
    crowd = rng.integers(0, 255, (10, 170, 3), dtype=np.uint8)
    wide[:80] = cv2.resize(crowd, (wide.shape[1], 80), interpolation=cv2.INTER_NEAREST)
    cv2.line(wide, (0, int(LEVEL)), (wide.shape[1], int(LEVEL)), (235, 240, 235), 5)
    cv2.line(wide, (int(UPRIGHT) + 200, 120), (int(UPRIGHT) + 200, 540), (235, 240, 235), 5)
    for x in range(60, wide.shape[1], 230):
        cv2.circle(wide, (x, 400), 30, (235, 240, 235), 4)
    picture = wide[:, 200 + shift : 200 + shift + SIZE[0]]
    blurred = cv2.GaussianBlur(picture, (0, 0), 0.8).astype(np.int16)
    noisy = np.clip(blurred + rng.normal(0, 3, blurred.shape), 0, 255).astype(np.uint8)
    return cv2.imencode(".jpg", noisy, [cv2.IMWRITE_JPEG_QUALITY, 90])[1].tobytes()


@pytest.fixture
def pitch(tmp_path) -> Path:
    """Two frames of a camera that pans by a tenth of the picture's width."""
    folder = tmp_path / "pitch"
    folder.mkdir()
    for i, shift in enumerate((0, SIZE[0] // 10)):
        (folder / f"{i}.jpg").write_bytes(draw_pitch(shift))
    return folder


@pytest.fixture
def on_pitch(make_window, pitch) -> MainWindow:
    return make_window(pitch)


@pytest.fixture
def clicks(on_pitch, hand_on) -> Hand:
    return hand_on(on_pitch)


def px(window: MainWindow, name: str) -> np.ndarray:
    polyline = window.services.state.annotation.get(name)
    assert polyline is not None
    return points_px(polyline, SIZE)


def kinds(window: MainWindow) -> dict[OriginKind, int]:
    services = window.services
    return services.review.origin_counts(services.state.frame.name, services.state.annotation)


class TestSnapping:
    def test_clicks_beside_the_line_land_on_its_centre_across_only(self, on_pitch, clicks):
        clicked = clicks.draw(MIDDLE, (484, 200), (476.5, 480))
        found = px(on_pitch, MIDDLE)
        assert found[:, 0] == pytest.approx(UPRIGHT, abs=0.5)
        assert found[:, 1] == pytest.approx(clicked[:, 1], abs=0.6)
        assert kinds(on_pitch) == {OriginKind.SNAPPED: 2}

    def test_on_plain_grass_the_click_stays_where_it_was(self, on_pitch, clicks):
        clicked = clicks.draw(MIDDLE, (350, 250), (360, 330))
        assert px(on_pitch, MIDDLE) == pytest.approx(clicked, abs=1e-9)
        assert kinds(on_pitch) == {OriginKind.CLICKED: 2}

    def test_ctrl_and_the_toggle_suspend_it(self, on_pitch, clicks):
        on_pitch.services.selection.select_class(MIDDLE)
        first = clicks.click(484, 200, CTRL)
        clicks.key(Qt.Key.Key_S)
        second = clicks.click(484, 300)
        clicks.key(Qt.Key.Key_S)
        clicks.click(484, 400)
        clicks.key(Qt.Key.Key_Return)
        found = px(on_pitch, MIDDLE)
        assert found[:2] == pytest.approx(np.array([first, second]), abs=1e-9)
        assert found[2, 0] == pytest.approx(UPRIGHT, abs=0.5)
        assert kinds(on_pitch) == {OriginKind.CLICKED: 2, OriginKind.SNAPPED: 1}

    def test_a_dragged_point_snaps_too(self, on_pitch, clicks):
        clicks.draw(MIDDLE, (480, 200), (480, 480))
        clicks.key(Qt.Key.Key_W)
        clicks.drag((480, 200), (484, 260))
        found = px(on_pitch, MIDDLE)
        assert found[0, 0] == pytest.approx(UPRIGHT, abs=0.5)
        assert found[0, 1] == pytest.approx(260, abs=1.5)

    def test_the_ring_shows_where_the_click_will_land(self, on_pitch, clicks):
        on_pitch.services.selection.select_class(MIDDLE)
        clicks.move(484, 300)
        draft = on_pitch.canvas.editor.draft(on_pitch.canvas.cursor_px)
        assert draft.landing is not None
        landed = draft.landing
        clicks.click(484, 300)
        clicks.key(Qt.Key.Key_Return)
        assert px(on_pitch, MIDDLE)[0] == pytest.approx(landed, abs=1e-9)


class TestLoupe:
    def test_it_follows_the_cursor_while_z_is_held(self, on_pitch, clicks):
        loupe = on_pitch.canvas.loupe
        clicks.move(300, 300)
        assert not loupe.isVisible()
        QTest.keyPress(on_pitch.canvas, Qt.Key.Key_Z)
        assert loupe.isVisible()
        before = loupe.pos()
        clicks.move(340, 330)
        assert loupe.pos() != before
        QTest.keyRelease(on_pitch.canvas, Qt.Key.Key_Z)
        assert not loupe.isVisible()

    def test_it_comes_while_a_point_is_dragged(self, on_pitch, clicks):
        clicks.draw(MIDDLE, (300, 300), (300, 400))
        clicks.key(Qt.Key.Key_W)
        viewport, none = on_pitch.canvas.viewport(), Qt.KeyboardModifier.NoModifier
        QTest.mousePress(viewport, Qt.MouseButton.LeftButton, none, clicks.at(300, 300))
        clicks._move(clicks.at(310, 310), Qt.MouseButton.LeftButton)
        assert on_pitch.canvas.loupe.isVisible()
        QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, none, clicks.at(310, 310))
        clicks.move(315, 315)
        assert not on_pitch.canvas.loupe.isVisible()

    def test_it_can_stay(self, on_pitch, clicks):
        clicks.key(Qt.Key.Key_Z, SHIFT)
        clicks.move(300, 300)
        assert on_pitch.canvas.loupe.isVisible()


class TestLooks:
    def test_a_look_stays_across_frames_and_touches_no_pixel_of_the_frame(self, on_pitch, qtbot):
        services, canvas = on_pitch.services, on_pitch.canvas
        before = services.navigator.picture.copy()
        on_pitch.side_bar.looks.set_look(DisplayAdjustment(brightness=0.3))
        canvas.shown.set_look(DisplayAdjustment(brightness=0.3))
        assert canvas.shown.pixels.mean() > before.mean() + 10
        assert np.array_equal(services.navigator.picture, before)
        services.navigator.next_frame()
        assert canvas.shown.pixels.mean() > services.navigator.picture.mean() + 10
        canvas.shown.set_look(DisplayAdjustment(enhance=True))
        qtbot.waitUntil(lambda: not np.array_equal(canvas.shown.pixels, services.navigator.picture))


class TestNextElement:
    def test_the_next_element_is_announced_and_then_chosen(self, on_pitch, clicks):
        services = on_pitch.services
        services.selection.select_class("Big rect. left main")
        clicks.click(300, 300)
        announced = on_pitch.canvas.editor.upcoming
        assert announced is not None
        element = services.state.field.element(announced)
        assert element.title in on_pitch.canvas.hint
        clicks.key(Qt.Key.Key_Return)
        assert services.state.selected_class == announced

    def test_shift_enter_and_the_option_refuse_it(self, on_pitch, clicks):
        services = on_pitch.services
        services.selection.select_class("Big rect. left main")
        clicks.click(300, 300)
        clicks.key(Qt.Key.Key_Return, SHIFT)
        assert services.state.selected_class == "Big rect. left main"
        on_pitch.actions_["auto_advance"].trigger()
        services.selection.select_class("Big rect. left main", continues=True)
        clicks.click(300, 400)
        clicks.key(Qt.Key.Key_Return)
        assert services.state.selected_class == "Big rect. left main"

    def test_two_clicks_finish_a_straight_element_on_request(self, on_pitch, clicks):
        on_pitch.actions_["two_clicks"].trigger()
        on_pitch.services.selection.select_class(MIDDLE)
        clicks.click(300, 300)
        clicks.click(300, 400)
        assert not on_pitch.canvas.editor.drawing
        assert len(px(on_pitch, MIDDLE)) == 2


class TestLeaving:
    """A frame is left, or the program dies, while something is drawn."""

    @pytest.mark.parametrize("count", [1, 2])
    def test_clicks_wait_unfinished_and_are_no_element(self, on_pitch, clicks, pitch, qtbot, count):
        services = on_pitch.services
        services.selection.select_class(MIDDLE)
        for y in (130, 330)[:count]:
            clicks.click(480, y)
        told = qtbot.waitSignal(
            services.store.events.message,
            check_params_cb=lambda m: m.text.startswith(f"kept {count} click"),
        )
        with told:
            services.navigator.next_frame()
        clicks.click(480, 130)  # begins a line of its own
        clicks.key(Qt.Key.Key_Escape)
        assert services.state.annotation.polylines == ()
        services.editing.save_now()
        assert not (pitch / "0.json").exists()
        services.navigator.previous_frame()
        assert services.state.annotation.get_unconfirmed(MIDDLE) is not None
        clicks.draw(MIDDLE, (480, 530))
        assert len(px(on_pitch, MIDDLE)) == count + 1
        assert kinds(on_pitch) == {OriginKind.SNAPPED: count + 1}

    @pytest.mark.new_window
    def test_clicks_under_way_outlive_the_program(self, on_pitch, clicks, pitch, make_window):
        services = on_pitch.services
        services.selection.select_class(MIDDLE)
        clicks.click(480, 130)
        clicks.click(480, 530)
        assert services.review.database.flush()
        left = pitch.with_name("left")  # as it lies there while the hand is still at it
        shutil.copytree(pitch, left, ignore=shutil.ignore_patterns("locks"))
        window = make_window(left)
        waiting = window.services.state.annotation.get_unconfirmed(MIDDLE)
        assert len(waiting.points) == 2
        assert "unfinished elements were kept: Halfway line" in window.status.hint.text()
        on_pitch.canvas.key("Enter")
        assert services.review.database.flush()
        assert not services.review.database.drafts()

    def test_an_unnamed_unfinished_line_goes_on_where_its_end_is_clicked(self, on_pitch, clicks):
        services = on_pitch.services
        clicks.click(480, 130)
        clicks.click(480, 330)
        services.navigator.next_frame()
        services.navigator.previous_frame()
        assert len(services.state.annotation.unconfirmed) == 1
        clicks.click(480, 131)
        clicks.click(480, 60)
        clicks.key(Qt.Key.Key_9)  # names it
        clicks.key(Qt.Key.Key_Return)
        assert px(on_pitch, MIDDLE)[:, 1].round() == pytest.approx([330, 130, 60], abs=2)
        assert services.state.annotation.unconfirmed == ()


class TestRegularise:
    def test_two_clicks_become_a_line_of_points_on_the_line(self, on_pitch, clicks, qtbot):
        clicks.draw(MIDDLE, (482, 130), (478, 530))
        on_pitch.services.selection.select_class(MIDDLE)
        with qtbot.waitSignal(on_pitch.services.store.events.annotationEdited):
            clicks.key(Qt.Key.Key_R)
        found = px(on_pitch, MIDDLE)
        assert len(found) > 3
        assert np.abs(found[:, 0] - UPRIGHT).max() < 0.6
        assert (np.diff(found[:, 1]) > 0).all()
        assert OriginKind.REGULARISED in kinds(on_pitch)
        clicks.key(Qt.Key.Key_Z, CTRL)
        assert len(px(on_pitch, MIDDLE)) == 2

    def test_the_whole_frame_is_one_step_of_undo(self, on_pitch, clicks, qtbot):
        clicks.draw(MIDDLE, (482, 130), (478, 530))
        clicks.draw(TOP, (5, 121), (955, 119))
        before = on_pitch.services.state.annotation
        with qtbot.waitSignal(on_pitch.services.store.events.annotationEdited):
            clicks.key(Qt.Key.Key_R, SHIFT)
        assert len(px(on_pitch, MIDDLE)) > 3
        assert len(px(on_pitch, TOP)) > 3
        on_pitch.services.editing.undo()
        assert on_pitch.services.state.annotation == before

    def test_r_reaches_what_was_just_drawn(self, on_pitch, clicks, qtbot):
        """Finished, with the next element chosen already; and not finished yet."""
        for finish in (True, False):
            on_pitch.services.selection.select_class(MIDDLE)
            clicks.click(484, 130)
            clicks.click(477, 530)
            if finish:
                clicks.key(Qt.Key.Key_Return)
                assert on_pitch.services.state.selected_class != MIDDLE
            with qtbot.waitSignal(
                on_pitch.services.store.events.message,
                check_params_cb=lambda m: "regularised" in m.text,
            ):
                clicks.key(Qt.Key.Key_R)
            assert len(px(on_pitch, MIDDLE)) > 2
            while on_pitch.services.state.annotation.annotated:
                clicks.key(Qt.Key.Key_Z, CTRL)

    @pytest.mark.parametrize("key", [(Qt.Key.Key_Z, CTRL), (Qt.Key.Key_Escape,)])
    def test_taken_back_before_it_is_there_nothing_else_is(self, on_pitch, clicks, qtbot, key):
        clicks.draw(MIDDLE, (484, 130), (477, 530))
        clicks.draw(TOP, (5, 118), (955, 122))
        before = on_pitch.services.state.annotation
        clicks.key(Qt.Key.Key_R, SHIFT)
        clicks.key(*key)
        assert "taken back" in on_pitch.status.hint.text_for(2000)
        all_done(qtbot)
        assert on_pitch.services.state.annotation == before
        clicks.key(Qt.Key.Key_Z, CTRL)  # and this takes back the last step
        assert on_pitch.services.state.annotation.annotated == (MIDDLE,)

    def test_a_frame_that_is_left_is_not_regularised_and_that_is_said(
        self, on_pitch, clicks, qtbot
    ):
        clicks.draw(MIDDLE, (484, 130), (477, 530))
        before, said = on_pitch.services.state.annotation, []
        on_pitch.services.store.events.message.connect(lambda m: said.append(m.text))
        clicks.key(Qt.Key.Key_R, SHIFT)
        clicks.key(Qt.Key.Key_D)
        assert "the frame was left: nothing was regularised" in said
        clicks.key(Qt.Key.Key_A)
        all_done(qtbot)
        assert on_pitch.services.state.annotation == before

    def test_what_is_regular_stays(self, on_pitch, clicks, qtbot):
        clicks.draw(MIDDLE, (484, 130), (477, 530))
        said = on_pitch.services.store.events.message
        with qtbot.waitSignal(said, check_params_cb=lambda m: "regularised" in m.text):
            clicks.key(Qt.Key.Key_R)
        once = px(on_pitch, MIDDLE)
        with qtbot.waitSignal(said, check_params_cb=lambda m: "regular already" in m.text):
            clicks.key(Qt.Key.Key_R)
        assert np.array_equal(px(on_pitch, MIDDLE), once)

    def test_what_was_thinned_out_is_regularised_again(self, on_pitch, clicks, qtbot):
        clicks.draw(MIDDLE, (484, 130), (477, 530))
        services = on_pitch.services
        for _ in range(2):
            with qtbot.waitSignal(
                services.store.events.message, check_params_cb=lambda m: "regularised" in m.text
            ):
                clicks.key(Qt.Key.Key_R)
            line = services.state.annotation.get(MIDDLE)
            assert len(line.points) > 3
            thin = Polyline(MIDDLE, (line.points[0], line.points[-1]))
            services.editing.edit(
                "thin out", lambda annotation, thin=thin: annotation.with_polyline(thin)
            )

    def test_on_a_real_frame_it_is_done_once_and_lies_on_the_paint(
        self, make_window, hand_on, qtbot, shared_data, tmp_path
    ):
        frame = next(frame for frame in truth_frames() if frame.clip == "bra_mex")
        shutil.copy(shared_data / "frames" / "bra_mex.jpg", tmp_path)
        rng = np.random.default_rng(4)
        hands = [frame.polyline(e.name, clicks_on(e, rng)) for e in frame.elements]
        annotation = FrameAnnotation(tuple(hands))
        (tmp_path / "bra_mex.json").write_bytes(write_annotation(annotation))
        window = make_window(tmp_path)
        hand, said = hand_on(window), window.services.store.events.message
        with qtbot.waitSignal(said, check_params_cb=lambda m: "regularised" in m.text):
            hand.key(Qt.Key.Key_R, SHIFT)
        once = window.services.state.annotation
        assert once != annotation
        with qtbot.waitSignal(said, check_params_cb=lambda m: "regular already" in m.text):
            hand.key(Qt.Key.Key_R, SHIFT)
            all_done(qtbot)
        assert window.services.state.annotation == once
        bars = [e for e in frame.elements if e.kind in ("post", "crossbar")]
        assert len(bars) == 3
        for bar in bars:
            away = bar.away(points_px(once.get(bar.name), frame.size))
            assert np.nanmax(away) < 0.7

    def test_a_click_without_paint_stays_and_is_told(self, on_pitch, clicks, qtbot):
        aside = (UPRIGHT + 30, 330)
        clicks.draw(MIDDLE, (482, 130), (481, 230), aside, (479, 430), (478, 530))
        with qtbot.waitSignal(
            on_pitch.services.store.events.message,
            check_params_cb=lambda m: "1 point unconfirmed by paint" in m.text,
        ):
            clicks.key(Qt.Key.Key_R)
        found = px(on_pitch, MIDDLE)
        assert np.hypot(*(found - aside).T).min() < 1.0  # a click is a whole screen pixel
        assert kinds(on_pitch)[OriginKind.UNCONFIRMED] == 1


class TestCopying:
    def copy(self, window: MainWindow, clicks: Hand, qtbot: QtBot) -> None:
        clicks.draw(MIDDLE, (480, 130), (480, 530))
        clicks.draw(TOP, (5, 120), (955, 120))
        window.services.navigator.next_frame()
        with qtbot.waitSignal(window.services.store.events.annotationEdited):
            clicks.key(Qt.Key.Key_V)

    def test_copies_move_with_the_camera_and_count_for_nothing(
        self, on_pitch, clicks, qtbot, pitch
    ):
        self.copy(on_pitch, clicks, qtbot)
        services = on_pitch.services
        assert services.state.annotation.annotated == ()
        waiting = services.state.annotation.get_unconfirmed(MIDDLE)
        assert waiting is not None
        assert points_px(waiting, SIZE)[:, 0] == pytest.approx(UPRIGHT - SIZE[0] // 10, abs=1.5)
        services.editing.save_now()
        assert not (pitch / "1.json").exists()

    def test_elements_that_are_not_copied_are_named(self, on_pitch, clicks, qtbot):
        said = heard(on_pitch.services)
        clicks.draw("Side line left", (20, 150), (30, 500))  # soon out of the picture
        self.copy(on_pitch, clicks, qtbot)
        assert said[-1].endswith("not in the picture or no line seen: Left goal line")

    def test_shift_v_confirms_all_and_they_are_saved_as_copied(
        self, on_pitch, clicks, qtbot, pitch
    ):
        self.copy(on_pitch, clicks, qtbot)
        clicks.key(Qt.Key.Key_V, SHIFT)
        assert set(on_pitch.services.state.annotation.annotated) == {MIDDLE, TOP}
        qtbot.waitUntil((pitch / "1.json").exists)
        assert set(kinds(on_pitch)) == {OriginKind.COPIED}

    @pytest.mark.parametrize("goes_on", [True, False])
    @pytest.mark.parametrize(
        "done", ["finished", "seen again", "left", "copied", "confirmed", "all"]
    )
    def test_a_stray_click_goes_into_no_element_that_is_done(
        self, on_pitch, clicks, qtbot, done, goes_on
    ):
        services = on_pitch.services
        services.selection.set_option("auto_advance", goes_on)
        if done in ("finished", "seen again", "left"):
            clicks.draw(MIDDLE, (480, 130), (480, 530))
            services.selection.select_class(MIDDLE)
            if done != "finished":
                services.navigator.next_frame()
            if done == "seen again":
                services.navigator.previous_frame()
        else:
            self.copy(on_pitch, clicks, qtbot)
            for _ in range(2 if done == "confirmed" else 0):
                clicks.key(Qt.Key.Key_Return)
            if done == "all":
                clicks.key(Qt.Key.Key_V, SHIFT)
        before = services.state.annotation
        clicks.click(300, 300)
        clicks.key(Qt.Key.Key_Return)
        for name in (MIDDLE, TOP):
            assert services.state.annotation.get(name) == before.get(name)
            assert services.state.annotation.get_unconfirmed(name) == before.get_unconfirmed(name)

    def test_dragging_a_copy_confirms_it_alone(self, on_pitch, clicks, qtbot):
        self.copy(on_pitch, clicks, qtbot)
        clicks.key(Qt.Key.Key_W)
        waiting = on_pitch.services.state.annotation.get_unconfirmed(MIDDLE)
        assert waiting is not None
        (x, y), *_ = points_px(waiting, SIZE)
        clicks.drag((x, y), (x, y + 12))
        assert on_pitch.services.state.annotation.annotated == (MIDDLE,)
        assert on_pitch.services.state.annotation.get_unconfirmed(TOP) is not None

    def test_clicking_on_goes_on_from_the_copy(self, on_pitch, clicks, qtbot):
        self.copy(on_pitch, clicks, qtbot)
        clicks.draw(MIDDLE, (384, 535))
        assert len(px(on_pitch, MIDDLE)) == 3
        assert kinds(on_pitch)[OriginKind.COPIED] == 2

    def test_enter_confirms_one_after_the_other(self, on_pitch, clicks, qtbot):
        self.copy(on_pitch, clicks, qtbot)
        assert on_pitch.services.state.selected_class == MIDDLE  # chosen by itself
        clicks.key(Qt.Key.Key_Return)
        assert on_pitch.services.state.annotation.annotated == (MIDDLE,)
        with qtbot.waitSignal(
            on_pitch.services.store.events.message, check_params_cb=lambda m: "regular" in m.text
        ):
            clicks.key(Qt.Key.Key_R)  # means the one just confirmed
        assert on_pitch.services.state.annotation.annotated == (MIDDLE,)
        clicks.key(Qt.Key.Key_Return)
        assert set(on_pitch.services.state.annotation.annotated) == {MIDDLE, TOP}

    def test_shift_delete_drops_them_and_undo_brings_them_back(self, on_pitch, clicks, qtbot):
        self.copy(on_pitch, clicks, qtbot)
        clicks.key(Qt.Key.Key_Delete, SHIFT)
        assert on_pitch.services.state.annotation.unconfirmed == ()
        clicks.key(Qt.Key.Key_Z, CTRL)
        assert len(on_pitch.services.state.annotation.unconfirmed) == 2

    def test_reversing_a_copy_confirms_it(self, on_pitch, clicks, qtbot):
        self.copy(on_pitch, clicks, qtbot)
        waiting = on_pitch.services.state.annotation.get_unconfirmed(MIDDLE)
        assert waiting is not None
        on_pitch.services.selection.select_class(MIDDLE)
        clicks.key(Qt.Key.Key_R, CTRL)
        assert px(on_pitch, MIDDLE) == pytest.approx(points_px(waiting, SIZE)[::-1], abs=1e-9)

    def test_copies_wait_across_a_restart(self, on_pitch, clicks, qtbot, make_window, pitch):
        self.copy(on_pitch, clicks, qtbot)
        on_pitch.close()
        again = make_window(pitch)
        assert again.services.state.frame.name == "1"  # and the window opens where one left
        assert again.services.state.annotation.get_unconfirmed(MIDDLE) is not None


class TestUndoInTheMiddle:
    def test_undo_during_a_drag_puts_the_point_back_and_nothing_else(self, on_pitch, clicks):
        before = clicks.draw(MIDDLE, (300, 300), (400, 300))
        clicks.draw(TOP, (300, 200), (400, 200))
        on_pitch.services.selection.set_mode("edit")
        viewport = on_pitch.canvas.viewport()
        left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
        QTest.mousePress(viewport, left, none, clicks.at(300, 300))
        clicks._move(clicks.at(320, 340), left)
        clicks.key(Qt.Key.Key_Z, CTRL)
        QTest.mouseRelease(viewport, left, none, clicks.at(320, 340))
        assert px(on_pitch, MIDDLE) == pytest.approx(before, abs=1e-9)
        assert on_pitch.services.state.annotation.annotated == (MIDDLE, TOP)

    def test_a_point_inserted_and_taken_back_leaves_no_other_point_chosen(self, on_pitch, clicks):
        before = clicks.draw(MIDDLE, (300, 300), (400, 300), (500, 300))
        on_pitch.services.selection.set_mode("edit")
        viewport = on_pitch.canvas.viewport()
        left, alt = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.AltModifier
        QTest.mousePress(viewport, left, alt, clicks.at(350, 300))
        clicks._move(clicks.at(352, 330), left)
        QTest.mouseRelease(viewport, left, alt, clicks.at(352, 330))
        assert len(px(on_pitch, MIDDLE)) == 4
        clicks.key(Qt.Key.Key_Z, CTRL)
        assert on_pitch.services.state.selection.point is None
        clicks.key(Qt.Key.Key_Z, CTRL)
        clicks.key(Qt.Key.Key_Y, CTRL)
        assert px(on_pitch, MIDDLE) == pytest.approx(before, abs=1e-9)


class TestHints:
    def test_what_was_under_the_cursor_is_forgotten_with_its_frame(self, on_pitch, clicks, qtbot):
        told = on_pitch.status.hint.text
        clicks.draw(MIDDLE, (300, 300), (400, 300))
        clicks.key(Qt.Key.Key_W)
        clicks.move(300, 300)
        qtbot.waitUntil(lambda: "drag moves point 1 of Halfway line" in told())
        clicks.key(Qt.Key.Key_D)
        qtbot.waitUntil(lambda: "Halfway line" not in told())

    def test_the_next_click_is_told_beside_a_message_too(self, on_pitch, clicks, qtbot):
        told = on_pitch.status.hint.text
        on_pitch.services.selection.set_option("draw_first", False)
        clicks.click(300, 300)  # no element is chosen: a message says so
        on_pitch.services.selection.select_class(MIDDLE)
        clicks.click(300, 300)
        qtbot.waitUntil(lambda: "DRAW Halfway line, 1 point" in told())
        assert "choose an element first" in told()

    def test_several_points_and_copies_are_named_for_what_they_are(self, on_pitch, clicks, qtbot):
        TestCopying().copy(on_pitch, clicks, qtbot)
        clicks.key(Qt.Key.Key_W)
        clicks.move(700, 500)
        on_pitch.services.selection.select_class(None)
        clicks.key(Qt.Key.Key_A, CTRL)
        words = on_pitch.canvas.hint
        assert "Delete removes 4 points" in words
        assert "no points to edit" not in words


class TestSeveralPoints:
    def test_a_band_chooses_points_that_move_and_go_together(self, on_pitch, clicks):
        before = clicks.draw(MIDDLE, (300, 300), (340, 320), (600, 420))
        clicks.key(Qt.Key.Key_W)
        clicks.drag((270, 270), (380, 350))
        assert on_pitch.services.state.selection.points == {(MIDDLE, 0), (MIDDLE, 1)}
        clicks.key(Qt.Key.Key_Down)
        assert px(on_pitch, MIDDLE)[:2] == pytest.approx(before[:2] + np.array([0, 1]), abs=1e-6)
        assert px(on_pitch, MIDDLE)[2] == pytest.approx(before[2], abs=1e-6)
        clicks.drag((300, 301), (320, 331))
        assert px(on_pitch, MIDDLE)[1] - before[1] == pytest.approx([20, 31], abs=1.5)
        clicks.key(Qt.Key.Key_Delete)
        assert px(on_pitch, MIDDLE) == pytest.approx(before[2:], abs=1e-6)

    def test_shift_click_adds_and_takes_away(self, on_pitch, clicks):
        clicks.draw(MIDDLE, (300, 300), (400, 300), (500, 300))
        clicks.key(Qt.Key.Key_W)
        clicks.click(300, 300)
        clicks.click(500, 300, SHIFT)
        assert on_pitch.services.state.selection.points == {(MIDDLE, 0), (MIDDLE, 2)}
        clicks.click(500, 300, SHIFT)
        assert on_pitch.services.state.selection.point == (MIDDLE, 0)
        assert not on_pitch.services.state.selection.points

    def test_a_click_on_one_of_several_means_that_one(self, on_pitch, clicks):
        clicks.draw(MIDDLE, (300, 300), (400, 300))
        clicks.key(Qt.Key.Key_W)
        clicks.key(Qt.Key.Key_A, CTRL)
        assert len(on_pitch.services.state.selection.points) == 2
        clicks.click(400, 300)
        assert on_pitch.services.state.selection.point == (MIDDLE, 1)
        assert not on_pitch.services.state.selection.points


class TestWholeElements:
    def test_elements_are_pinned_and_the_first_refusal_explains(self, on_pitch, clicks):
        before = clicks.draw(MIDDLE, (300, 300), (400, 300))
        clicks.key(Qt.Key.Key_W)
        clicks.drag((350, 300), (350, 340))
        assert px(on_pitch, MIDDLE) == pytest.approx(before, abs=1e-9)
        assert "pinned" in QToolTip.text()  # beside the cursor
        assert "pinned" in on_pitch.status.hint.text()
        clicks.key(Qt.Key.Key_P, CTRL)
        clicks.drag((350, 300), (350, 340))
        assert px(on_pitch, MIDDLE) == pytest.approx(before + np.array([0, 40]), abs=1.5)

    def test_the_menu_changes_and_swaps_classes(self, on_pitch, clicks):
        first = clicks.draw(MIDDLE, (300, 300), (400, 300))
        second = clicks.draw(TOP, (300, 350), (400, 350))
        on_pitch.services.selection.select_class(MIDDLE)
        choose(on_pitch, "Change class to (swaps with an annotated one)", TOP)
        assert px(on_pitch, TOP) == pytest.approx(first, abs=1e-9)
        assert px(on_pitch, MIDDLE) == pytest.approx(second, abs=1e-9)
        assert on_pitch.services.state.selected_class == TOP
        on_pitch.services.editing.undo()
        assert px(on_pitch, MIDDLE) == pytest.approx(first, abs=1e-9)

    def test_the_menu_splits_at_a_point_and_merges_again(self, on_pitch, clicks):
        clicks.draw(MIDDLE, (300, 300), (400, 300), (400, 400))
        clicks.key(Qt.Key.Key_W)
        clicks.click(400, 300)
        choose(on_pitch, "Split here: the rest becomes", TOP)
        assert len(px(on_pitch, MIDDLE)) == len(px(on_pitch, TOP)) == 2
        on_pitch.services.selection.select_point(None)
        on_pitch.services.selection.select_class(TOP)
        choose(on_pitch, "Merge into", MIDDLE)
        assert len(px(on_pitch, MIDDLE)) == 3

    def test_a_right_click_selects_what_is_under_it(self, on_pitch, clicks, qtbot):
        clicks.draw(MIDDLE, (300, 300), (400, 300))
        clicks.key(Qt.Key.Key_W)
        on_pitch.services.selection.select_class(None)
        on_pitch.canvas.editor.point_at((350.0, 301.0))
        assert on_pitch.services.state.selected_class == MIDDLE
        on_pitch.canvas.editor.point_at((400.0, 300.0))
        assert on_pitch.services.state.selection.point == (MIDDLE, 1)
        on_pitch.canvas.editor.point_at((350.0, 301.0))
        assert on_pitch.services.state.selection.point is None
        on_pitch.canvas.editor.point_at((700.0, 450.0))
        assert on_pitch.canvas.editor.on_ground
        menu = canvas_menu(
            on_pitch,
            on_pitch.services,
            on_pitch.actions_,
            on_pitch.element_edits,
            on_ground=on_pitch.canvas.editor.on_ground,
        )
        assert on_pitch.actions_["copy_previous"] in menu.actions()

    def test_a_duplicate_waits_under_the_symmetric_class(self, on_pitch, clicks):
        clicks.draw("Big rect. left top", (300, 300), (400, 300))
        on_pitch.services.selection.select_class("Big rect. left top")
        clicks.key(Qt.Key.Key_D, CTRL)
        waiting = on_pitch.services.state.annotation.get_unconfirmed("Big rect. right bottom")
        assert waiting is not None
        clicks.drag((350, 300), (350, 360))  # unconfirmed elements are not pinned
        assert px(on_pitch, "Big rect. right bottom")[:, 1] == pytest.approx(360, abs=1.5)

    def test_of_several_symmetric_classes_the_free_one_is_offered(self, on_pitch, clicks, tmp_path):
        path = tmp_path / "square.toml"
        path.write_text(_square())
        services = on_pitch.services
        services.evaluation.set_field(load_field(path))
        clicks.draw("Side right", (300, 300), (400, 300))
        for expected in ("Side bottom", "Side left"):
            services.selection.select_class("Side right")
            clicks.key(Qt.Key.Key_D, CTRL)
            assert services.state.annotation.get_unconfirmed(expected) is not None
            on_pitch.element_edits.confirm_all()
        services.selection.set_mode("draw")
        clicks.draw("Side top", (300, 200), (400, 200))
        texts = heard(services)
        services.selection.select_class("Side right")
        clicks.key(Qt.Key.Key_D, CTRL)
        assert texts[-1] == "Side bottom, Side left, Side top are annotated already"


def _square() -> str:
    """A field that four turns take to itself."""
    side = "{ title = 'Side', nominal = 20, minimum = 20, maximum = 20 }"
    text = f"""
name = "square"
title = "Square"
symmetries = [90, 180, 270]
[dimensions]
length = {side}
width = {side}
"""
    corners = {"right": (10, -10), "bottom": (10, 10), "left": (-10, 10), "top": (-10, -10)}
    places = list(corners.values())
    for i, name in enumerate(corners):
        (x, y), (u, v) = places[i], places[(i + 1) % 4]
        text += f"""
[[elements]]
name = "Side {name}"
title = "Side {name}"
group = "Lines"
colour = "#ff00{i}0"
shortcut = ""
kind = "line"
start = ["{x}", "{y}", "0"]
end = ["{u}", "{v}", "0"]
"""
    return text


def choose(window: MainWindow, title: str, class_name: str) -> None:
    """Choose a class in a submenu of the menu at the cursor."""
    menu = canvas_menu(window, window.services, window.actions_, window.element_edits)
    submenu = next(a.menu() for a in menu.actions() if a.text() == title)
    for action in (a for m in (submenu, *submenu.findChildren(QMenu)) for a in m.actions()):
        if action.data() == class_name and action.isEnabled():
            action.trigger()
            return
    raise AssertionError(f"{class_name} is not offered in {title}")
