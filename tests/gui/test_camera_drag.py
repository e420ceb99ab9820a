"""Dragging the camera: with Ctrl and Alt held, a place of its wireframe goes where it belongs."""

import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from procc_annotator.calibration.line_alignment.control_points import (
    control_point_errors,
    rotated_camera,
)
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import external_camera_fit
from procc_annotator.calibration.single_image.proposal import Proposal
from procc_annotator.calibration.tracking import shot_tracker
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.records import OriginKind
from procc_annotator.dataset.sequence import open_video
from procc_annotator.field.model import Field
from procc_annotator.gui.commands import shot_following
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.prediction import camera_choice
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.camera_view import wireframe_of
from tests.drawn_shots import DrawnShot, Look, soccer_shot, write_video
from tests.gui.conftest import all_done, until_kept
from tests.gui.known_already import TrackMemory

Key, Button = Qt.Key, Qt.MouseButton
SHIFT, CTRL, ALT = (
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
)
HELD = CTRL | ALT
Place = tuple[float, float]
SAMPLE = (1280, 720)  # its pictures, px


class CameraDrag:
    """A person's mouse over the canvas with both keys held: positions are in picture px."""

    def __init__(self, window: MainWindow) -> None:
        self.canvas, self.services = window.canvas, window.services

    def at(self, place: Place) -> QPoint:
        return self.canvas.to_view(*place).toPoint()

    def exactly(self, place: Place) -> Place:
        """Where the whole pixel of the screen lies."""
        return self.canvas.to_picture(QPointF(self.at(place)))

    def move(self, place: Place, held: Button = Button.NoButton, keys: Any = HELD) -> None:
        self._send(QEvent.Type.MouseMove, place, Button.NoButton, held, keys)

    def press(self, place: Place) -> None:
        self._send(QEvent.Type.MouseButtonPress, place, Button.LeftButton, Button.LeftButton, HELD)

    def release(self, place: Place) -> None:
        self._send(QEvent.Type.MouseButtonRelease, place, Button.LeftButton, Button.NoButton, HELD)

    def carry(self, start: Place, *ends: Place) -> None:
        """Press, and go there without letting go."""
        self.move(start)
        self.press(start)
        for end in ends:
            self.move(end, Button.LeftButton)

    def drag(self, start: Place, end: Place) -> None:
        half = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
        self.carry(start, half, end)
        self.release(end)

    def _send(
        self, kind: QEvent.Type, place: Place, button: Button, held: Button, keys: Any
    ) -> None:
        at, viewport = QPointF(self.at(place)), self.canvas.viewport()
        event = QMouseEvent(kind, at, QPointF(viewport.mapToGlobal(at)), button, held, keys)
        QApplication.sendEvent(viewport, event)


@pytest.fixture
def truth(annotated) -> PinholeCamera:
    cameras = CameraSet.open(annotated / "cameras" / "true", camera_size=(960, 540))
    found = cameras.camera("00002", SAMPLE)
    assert isinstance(found.camera, PinholeCamera)
    return found.camera


@pytest.fixture
def wrong(truth) -> PinholeCamera:
    """What the search in the picture finds: turned and zoomed away."""
    return rotated_camera(truth, np.array([0.02, 0.006, 0.03, 0.0]))


@pytest.fixture
def search(wrong, monkeypatch) -> None:
    def propose(picture: PixelArray, field: Field, **_: Any) -> Proposal:
        size = picture.shape[1], picture.shape[0]
        fit = external_camera_fit(wrong.scaled(SAMPLE, size), size)
        return Proposal("unsure", "a neighbour fits as well", fit, 0.5, 0.5, 2.0, 0.0, None)

    monkeypatch.setattr(camera_choice, "propose_camera", propose)


@pytest.fixture
def window(make_window, annotated, search, qtbot) -> MainWindow:
    (annotated / "00002.json").unlink()
    made = make_window(annotated)
    made.services.navigator.go_to(1)
    all_done(qtbot)
    return made


@pytest.fixture
def drag(window) -> CameraDrag:
    return CameraDrag(window)


def camera_of(window: MainWindow) -> PinholeCamera:
    found = window.services.corrections.here
    assert isinstance(found.fit.camera, PinholeCamera)
    return found.fit.camera


def corners(
    window: MainWindow, shown: PinholeCamera, true: PinholeCamera
) -> list[tuple[Place, Place]]:
    """Where distinct places well inside the picture are shown, and where they belong; those that
    lie far apart first."""
    size = window.services.state.picture_size
    assert size is not None
    frame = wireframe_of(shown, window.services.state.field, size)
    belong = true.project(frame.places)[0]
    middle, room = np.array(size) / 2, np.array(size) / 2 - 40
    inside = (np.abs(frame.px - middle) < room) & (np.abs(belong - middle) < room)
    rows = np.flatnonzero(inside.all(axis=1))
    rows = rows[np.argsort(frame.px[rows, 0])]
    assert len(rows) >= 3
    chosen = [rows[0], rows[-1], *rows[1:-1]]
    return [((*frame.px[r].tolist(),), (*belong[r].tolist(),)) for r in chosen]


@pytest.fixture
def places(window, wrong, truth) -> list[tuple[Place, Place]]:
    return corners(window, wrong, truth)


class TestTakingHold:
    def test_the_wireframe_and_the_place_under_the_cursor_are_shown(
        self, window, drag, places, qtbot
    ):
        hand = window.canvas.camera_drag
        assert window.canvas.overlay_item.ghosts.strokes
        drag.move(places[0][0])

        overlay = hand.item.overlay
        assert len(overlay.strokes[1].segments) > 20
        assert overlay.strokes[1].colour == tones.CURSOR
        assert overlay.labels[0].positions[0] == pytest.approx(places[0][0])
        assert not window.canvas.overlay_item.ghosts.strokes
        qtbot.waitUntil(lambda: window.status.hint.text().startswith("CAMERA  •  drag "))
        assert window.status.hint.text().endswith("to where it belongs: the camera follows")

        drag.move(places[0][0], keys=Qt.KeyboardModifier.NoModifier)
        assert not hand.held
        assert not hand.item.overlay.strokes
        assert window.canvas.overlay_item.ghosts.strokes
        qtbot.waitUntil(lambda: window.status.hint.text().startswith("DRAW"))

    def test_the_keys_alone_show_it(self, window, drag):
        QTest.keyPress(window.canvas, Key.Key_Control)
        assert not window.canvas.camera_drag.held
        QTest.keyPress(window.canvas, Key.Key_Alt, CTRL)
        assert window.canvas.camera_drag.held
        QTest.keyRelease(window.canvas, Key.Key_Alt, CTRL)
        assert not window.canvas.camera_drag.held
        QTest.keyRelease(window.canvas, Key.Key_Control)

    def test_a_click_of_it_draws_nothing(self, window, drag, places):
        window.services.selection.select_class("Middle line")
        drag.drag((700.0, 690.0), (730.0, 680.0))  # no line is there
        drag.drag(places[0][0], places[0][0])
        assert not window.canvas.editor.drawing
        assert window.services.corrections.here is None

    def test_not_in_blind_mode(self, window, drag, places):
        drag.drag(*places[0])
        window.services.blind_lock.set_blind(True)
        assert not window.canvas.camera_drag.item.overlay.marks
        drag.drag(*places[1])
        assert window.status.hint.text().startswith("blind: the camera is hidden")
        assert window.services.corrections.here is None
        assert not window.canvas.camera_drag.item.overlay.strokes[1].segments.size
        window.services.blind_lock.set_blind(False)
        assert len(camera_pegs(window)) == 1


def camera_pegs(window: MainWindow) -> tuple[Any, ...]:
    found = window.services.corrections.here
    return found.pegs if found is not None else ()


class TestDragging:
    def test_the_place_lies_under_the_cursor_all_the_way(self, window, drag, places):
        start, end = places[0]
        hand = window.canvas.camera_drag
        for share in (0.4, 0.8, 1.0):
            aim = start[0] + share * (end[0] - start[0]), start[1] + share * (end[1] - start[1])
            if share == 0.4:
                drag.carry(start, aim)
            else:
                drag.move(aim, Button.LeftButton)
            shown = hand.item.overlay.marks[-1].centres[0]
            assert shown == pytest.approx(drag.exactly(aim), abs=0.1)
        assert window.services.corrections.here is None  # nothing before the button goes up

    def test_the_camera_is_made_exact_on_paint_and_ghosts_follow(
        self, window, drag, places, truth, qtbot
    ):
        before = {ghost.name: ghost for ghost in window.services.ghosts.painted}
        drag.drag(*places[0])
        drag.move(places[0][1], keys=Qt.KeyboardModifier.NoModifier)
        all_done(qtbot)

        found = window.services.corrections.here
        assert found.why_not == ""
        spots = wireframe_of(truth, window.services.state.field, SAMPLE).places
        apart = camera_of(window).project(spots)[0] - truth.project(spots)[0]
        assert np.hypot(*apart.T).max() < 2.0
        assert control_point_errors(camera_of(window), found.pegs).max() < 3 * found.pegs[0].sd_px
        after = window.services.ghosts.painted
        assert after
        assert all(ghost is not before.get(ghost.name) for ghost in after)
        assert window.canvas.found_plate.text.startswith(
            "Camera dragged, 1 peg, made exact on paint: "
        )
        assert len(window.canvas.camera_drag.item.overlay.marks[0].centres) == 1

    def test_a_second_place_leaves_the_first_where_it_was_put(self, window, drag, places, qtbot):
        drag.drag(*places[0])
        all_done(qtbot)
        first = camera_pegs(window)[0]
        world = wireframe_of(camera_of(window), window.services.state.field, SAMPLE)
        start = world.at(places[1][1], 30.0)
        end = start.px[0] + 12.0, start.px[1] - 7.0
        drag.carry(start.px, (start.px[0] + 9.0, start.px[1]), end)
        hand = window.canvas.camera_drag
        held = hand._dragged
        assert held is not None
        assert control_point_errors(held, [first])[0] < 0.1
        assert hand.item.overlay.marks[-1].centres[0] == pytest.approx(drag.exactly(end), abs=0.1)
        drag.release(end)
        assert camera_pegs(window)[0] is first
        assert len(camera_pegs(window)) == 2
        all_done(qtbot)

    def test_a_click_takes_a_peg_away_and_a_drag_moves_it(self, window, drag, places, qtbot):
        drag.drag(*places[0])
        all_done(qtbot)
        peg = camera_pegs(window)[0]
        drag.move(peg.px)
        assert "click takes it away" in window.status.hint.text()
        drag.drag(peg.px, (peg.px[0] + 9.0, peg.px[1] + 2.0))
        (moved,) = camera_pegs(window)
        assert moved.world == peg.world
        assert moved.px == pytest.approx(drag.exactly((peg.px[0] + 9.0, peg.px[1] + 2.0)))

        drag.move(moved.px)
        drag.press(moved.px)
        drag.release(moved.px)
        all_done(qtbot)
        assert window.services.corrections.here is None
        window.canvas.undo()
        assert camera_pegs(window) == (moved,)

    def test_let_go_beyond_what_a_camera_can_show_the_peg_lies_where_the_camera_shows_it(
        self, window, drag, places, qtbot
    ):
        drag.drag(*places[0])
        all_done(qtbot)
        start = wireframe_of(camera_of(window), window.services.state.field, SAMPLE).at(
            places[1][1], 30.0
        )
        drag.drag(start.px, (start.px[0] + 12.0, start.px[1]))
        all_done(qtbot)
        start = wireframe_of(camera_of(window), window.services.state.field, SAMPLE).at(
            places[2][1], 30.0
        )
        near, beyond = (start.px[0] + 12.0, start.px[1]), (start.px[0] + 900.0, start.px[1])
        drag.carry(start.px, near, beyond)
        shown = window.canvas.camera_drag.item.overlay.marks[-1].centres[0].tolist()
        drag.release(beyond)
        all_done(qtbot)
        assert camera_pegs(window)[-1].px == pytest.approx(shown, abs=0.1)

    def test_the_mouse_button_that_moves_the_picture_meanwhile_does_not_end_it(
        self, window, drag, places, qtbot
    ):
        canvas, middle = window.canvas, Button.MiddleButton
        drag.carry(*places[0])
        at = drag.at(places[0][1])
        QTest.mousePress(canvas.viewport(), middle, HELD, at)
        drag.release(places[0][1])
        assert not canvas.camera_drag.dragging
        assert canvas.panning
        QTest.mouseRelease(canvas.viewport(), middle, HELD, at)
        assert not canvas.panning
        assert len(camera_pegs(window)) == 1

    def test_a_release_that_went_elsewhere_leaves_it_where_it_was_seen(self, window, drag, places):
        drag.carry(*places[0])
        drag.move(places[0][0])
        assert not window.canvas.camera_drag.dragging
        (peg,) = camera_pegs(window)
        assert peg.px == pytest.approx(drag.exactly(places[0][1]))


class TestTakingBack:
    def test_escape_while_dragging_and_right_after(self, window, drag, places, qtbot):
        drag.carry(*places[0])
        window.canvas.key("Escape")
        drag.release(places[0][1])
        assert window.services.corrections.here is None

        drag.drag(*places[0])
        all_done(qtbot)
        assert window.services.corrections.here is not None
        window.canvas.key("Escape")
        assert window.services.corrections.here is None

    def test_undo_goes_back_drag_by_drag_and_then_to_the_edits(self, window, drag, places, qtbot):
        drag.drag(*places[0])
        all_done(qtbot)
        first = camera_of(window)
        drag.drag(places[1][1], (places[1][1][0] + 20.0, places[1][1][1]))
        all_done(qtbot)
        window.canvas.undo()
        assert camera_of(window) == first
        window.canvas.undo()
        assert window.services.corrections.here is None
        said: list[str] = []
        window.services.store.events.message.connect(lambda m: said.append(m.text))
        window.canvas.undo()
        assert said == ["nothing to undo on this frame"]

    def test_an_edit_after_it_is_undone_first(self, window, drag, places, qtbot):
        drag.drag(*places[0])
        all_done(qtbot)
        QTest.keyClick(window.canvas, Key.Key_Return, SHIFT)
        all_done(qtbot)
        assert window.services.state.annotation.annotated
        window.canvas.undo()
        assert not window.services.state.annotation.annotated
        assert window.services.corrections.here is not None


class TestWhatComesOfIt:
    def test_nothing_is_saved_before_ghosts_are_accepted(
        self, window, annotated, drag, places, qtbot
    ):
        services = window.services
        drag.drag(*places[0])
        all_done(qtbot)
        until_kept()
        assert not (annotated / "00002.json").exists()

        QTest.keyClick(window.canvas, Key.Key_Return, SHIFT)
        all_done(qtbot)
        until_kept()
        assert (annotated / "00002.json").exists()
        counts = services.review.origin_counts(services.state.frame.name, services.state.annotation)
        assert set(counts) == {OriginKind.ACCEPTED}
        assert not services.corrections.rules  # the clicks say more
        assert services.prediction.insight.from_clicks

    def test_it_stays_with_its_frame_and_goes_with_the_dataset(
        self, window, dataset, drag, places, qtbot
    ):
        drag.drag(*places[0])
        all_done(qtbot)
        window.services.navigator.go_to(2)
        all_done(qtbot)
        assert window.services.corrections.here is None
        assert not window.canvas.camera_drag.item.overlay.marks
        window.services.navigator.go_to(1)
        all_done(qtbot)
        assert len(camera_pegs(window)) == 1
        window.services.opening.open_path(dataset)
        all_done(qtbot)
        assert not window.services.state.corrected

    def test_the_fit_to_clicks_and_a_loaded_camera_can_be_dragged(
        self, make_window, annotated, qtbot, truth
    ):
        window = make_window(annotated)
        services = window.services
        services.navigator.go_to(1)
        services.live_fit.set_model("R")
        all_done(qtbot)
        drag = CameraDrag(window)
        frame = wireframe_of(truth, services.state.field, SAMPLE)
        start = frame.at((480.0, 270.0), 500.0)
        drag.drag(start.px, (start.px[0] + 25.0, start.px[1] + 10.0))
        assert services.corrections.rules
        window.canvas.undo()
        assert services.corrections.here is None

        services.live_fit.set_wanted(False)
        services.camera_sources.load_cameras(annotated / "cameras" / "true")
        all_done(qtbot)
        drag.drag(start.px, (start.px[0] + 25.0, start.px[1] + 10.0))
        assert services.corrections.rules

    def test_without_a_camera_it_is_said(self, make_window, annotated, qtbot):
        window = make_window(annotated)
        window.services.live_fit.set_wanted(False)
        all_done(qtbot)
        CameraDrag(window).move((480.0, 270.0))
        qtbot.waitUntil(lambda: "no camera is known here" in window.status.hint.text())


COUNT, SHOT = 13, (640, 360)  # frames; px


@pytest.fixture(scope="module")
def drawn() -> DrawnShot:
    return soccer_shot(COUNT, size=SHOT, look=Look(people=False, noise=0.0))


@pytest.fixture(scope="module")
def written(drawn, tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("drawn") / "match.mp4"
    return write_video(path, [drawn.frame(n) for n in range(COUNT)])


@pytest.fixture(scope="module")
def tracks() -> TrackMemory:
    return TrackMemory()


@pytest.fixture(autouse=True)
def tracked_once(tracks, monkeypatch) -> None:
    """The shot is followed in the first test that needs it; so is what lies around an anchor."""
    tracks.hand_out(monkeypatch)


class TestInAShot:
    @pytest.fixture
    def shot(
        self, make_window, dataset, written, tmp_path, drawn, qtbot, monkeypatch
    ) -> MainWindow:
        def propose(*_: Any, **__: Any) -> Proposal:
            fit = external_camera_fit(drawn.cameras[0], SHOT)
            return Proposal("sure", "as drawn", fit, 0.9, 0.9, 0.3, 0.3, None)

        monkeypatch.setattr(camera_choice, "propose_camera", propose)
        frame = ImageFrame(SHOT)
        known = vector_from_camera(drawn.cameras[0], frame)

        def found(*_: Any, **__: Any) -> Proposal:
            return replace(propose(), fit=replace(propose().fit, vector=known))

        monkeypatch.setattr(shot_tracker, "propose_camera", found)  # in a track's first frame
        video = Path(shutil.copyfile(written, tmp_path / "match.mp4"))
        window = make_window(dataset)
        services = window.services
        services.opening.open_workspace(open_video(video, range(0, COUNT, 4), services.state.field))
        all_done(qtbot)
        QTest.keyClick(window.canvas, Key.Key_T)
        qtbot.waitUntil(lambda: not window.shot_following.running)
        all_done(qtbot)
        return window

    def test_the_frame_is_an_anchor_and_what_lies_around_it_is_followed_again(
        self, shot, drawn, qtbot, monkeypatch
    ):
        services, track = shot.services, shot_following.track_shot
        asked: list[dict[int, Any]] = []

        def noted(*args: Any, anchors: Any, **more: Any) -> Any:
            asked.append(dict(anchors))
            return track(*args, anchors=anchors, **more)

        monkeypatch.setattr(shot_following, "track_shot", noted)
        services.navigator.go_to(2)
        all_done(qtbot)
        drag = CameraDrag(shot)
        (start, end), *_ = corners(shot, drawn.cameras[8], drawn.cameras[8])
        drag.drag(start, (end[0] + 14.0, end[1] + 9.0))
        drag.drag((end[0] + 14.0, end[1] + 9.0), end)
        all_done(qtbot)
        assert services.shot_track.tracked[8].state == "anchor"
        assert shot.strip.content.dragged == (8,)
        assert "its camera was dragged" in words(shot)
        assert asked == []  # while somebody is here

        services.navigator.go_to(3)
        qtbot.waitUntil(lambda: bool(asked))
        qtbot.waitUntil(lambda: not shot.shot_following.running)
        all_done(qtbot)
        assert [sorted(a) for a in asked] == [[8]]
        assert services.shot_track.tracked[8].state == "anchor"
        assert services.shot_track.tracked[7].anchor_distance == 1
        assert len(services.shot_track.tracked) == COUNT

    def test_taken_back_it_is_no_anchor_any_more(self, shot, drawn, qtbot):
        services = shot.services
        services.navigator.go_to(2)
        all_done(qtbot)
        drag = CameraDrag(shot)
        (start, end), *_ = corners(shot, drawn.cameras[8], drawn.cameras[8])
        drag.drag(start, (end[0] + 14.0, end[1] + 9.0))
        drag.move(end, keys=Qt.KeyboardModifier.NoModifier)
        all_done(qtbot)
        shot.canvas.undo()
        assert shot.strip.content.dragged == ()
        services.navigator.go_to(3)
        qtbot.waitUntil(lambda: services.shot_track.tracked[8].state == "followed")
        all_done(qtbot)


def words(window: MainWindow) -> str:
    from procc_annotator.gui.panels.timeline.shot_strip import strip_words

    return strip_words(window.services, window.strip.content, window.strip.number)
