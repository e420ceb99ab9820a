"""Following a shot in the window: its frames fill in, are a source, are accepted and taken back."""

import shutil
from collections.abc import Callable
from pathlib import Path
from threading import Event
from typing import Any

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.calibration.result import external_camera_fit
from procc_annotator.calibration.single_image.proposal import Proposal
from procc_annotator.calibration.tracking import shot_tracker
from procc_annotator.calibration.tracking.track import Track
from procc_annotator.dataset.records import OriginKind, Status
from procc_annotator.dataset.sequence import open_video
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.commands import shot_accepting, shot_following
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.prediction import camera_choice
from procc_annotator.image.pixels import PixelArray
from tests.drawn_shots import DrawnShot, Look, soccer_shot, write_video
from tests.gui.conftest import Hand, all_done, heard, until_kept
from tests.gui.known_already import TrackMemory

SIZE = (640, 360)
COUNT, EVERY = 30, 5  # frames, half of them in each shot; those of the dataset
Key = Qt.Key
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier


@pytest.fixture(scope="module")
def drawn() -> DrawnShot:
    """The first shot."""
    return soccer_shot(COUNT // 2, size=SIZE, look=Look(people=False, noise=0.0))


def close_up(number: int) -> np.ndarray:
    """The second one, of no field."""
    colours = np.random.default_rng(1).integers(0, 200, (5, 9, 3), dtype=np.uint8)
    wide = cv2.resize(colours, (SIZE[0] + 2 * COUNT, SIZE[1]), interpolation=cv2.INTER_CUBIC)
    return np.ascontiguousarray(wide[:, 2 * number : 2 * number + SIZE[0]])


@pytest.fixture(scope="module")
def pictures(drawn) -> list[PixelArray]:
    return [drawn.frame(n) for n in range(len(drawn))]


@pytest.fixture(scope="module")
def written(pictures, tmp_path_factory) -> Path:
    second = [close_up(n) for n in range(COUNT - len(pictures))]
    return write_video(tmp_path_factory.mktemp("drawn") / "match.mp4", [*pictures, *second])


@pytest.fixture
def video(written, tmp_path) -> Path:
    return Path(shutil.copyfile(written, tmp_path / "match.mp4"))


@pytest.fixture(autouse=True)
def found(drawn, pictures, monkeypatch) -> None:
    """The first picture's camera is found in it, and no other's."""
    first = pictures[0][::8, ::8, :3].astype(float)

    def propose(picture: PixelArray, field: Field, **_: Any) -> Proposal:
        small = picture[::8, ::8, :3]
        apart = np.abs(small - first).mean() if small.shape == first.shape else np.inf
        fit = external_camera_fit(drawn.cameras[0], SIZE)
        state = "sure" if apart < 8 else "none"
        return Proposal(state, "as drawn", fit, 0.9, 0.9, 0.3, 0.3, None)

    monkeypatch.setattr(camera_choice, "propose_camera", propose)
    monkeypatch.setattr(shot_tracker, "propose_camera", propose)


@pytest.fixture(scope="module")
def tracks() -> TrackMemory:
    return TrackMemory()


@pytest.fixture(autouse=True)
def tracked_once(tracks, monkeypatch) -> None:
    """The shot is followed in the first test that needs it; so is what lies around an anchor."""
    tracks.hand_out(monkeypatch)


@pytest.fixture
def window(make_window, dataset, video, qtbot) -> MainWindow:
    made = make_window(dataset)
    services = made.services
    services.opening.open_workspace(open_video(video, range(0, COUNT, EVERY), services.state.field))
    all_done(qtbot)
    return made


def press(window: MainWindow, key: Qt.Key, modifiers: Any = Qt.KeyboardModifier.NoModifier) -> None:
    QTest.keyClick(window.canvas, key, modifiers)


def follow(window: MainWindow, qtbot: QtBot) -> None:
    press(window, Key.Key_T)
    assert window.shot_following.running
    qtbot.waitUntil(lambda: not window.shot_following.running)
    all_done(qtbot)


def accept(window: MainWindow, qtbot: QtBot) -> None:
    press(window, Key.Key_Return, CTRL | SHIFT)
    qtbot.waitUntil(lambda: not window.stretch_accepting.running)
    all_done(qtbot)


def files(video: Path) -> list[str]:
    until_kept()
    return sorted(path.stem[-2:] for path in (video.parent / "match_frames").glob("*.json"))


class TestFollowing:
    def test_the_shot_is_followed_to_its_cut(self, window, drawn, qtbot):
        services = window.services
        follow(window, qtbot)

        track = services.shot_track
        assert sorted(track.tracked) == list(range(COUNT // 2))
        assert track.cuts == (COUNT // 2,)
        assert all(frame.state == "followed" for frame in track.tracked.values())
        fit = track.tracked[10].fit
        spots = np.array([[0.0, 0.0, 0.0], [20.0, -30.0, 0.0], [20.0, 10.0, 0.0]])
        apart = fit.camera.project(spots)[0] - drawn.cameras[10].project(spots)[0]
        assert np.abs(apart).max() < 2.0
        assert services.state.active is None
        assert [len(source.camera_set.frames) for source in services.state.sources] == [3]

    def test_ghosts_come_from_the_track_and_it_is_judged_like_any_source(self, window, qtbot):
        services = window.services
        follow(window, qtbot)

        services.navigator.go_to(2)
        all_done(qtbot)
        assert services.prediction.stands_in
        assert services.ghosts.painted
        assert window.canvas.found_plate.text.startswith("Camera of the track")
        services.camera_sources.set_active_camera(
            services.state.sources.index(services.shot_track.source)
        )
        assert services.scorer.camera is not None

    def test_frames_fill_in_meanwhile_and_it_can_be_stopped(self, window, qtbot, monkeypatch):
        going, track = Event(), shot_following.track_shot

        def slow(*args: Any, on_frame: Callable[..., None], go_on: Any, **more: Any) -> Any:
            def on_each(frame: Any) -> None:
                on_frame(frame)
                on_frame(frame)  # as where a part is followed once more
                while frame.number == 8 and not going.wait(0.01):
                    go_on()

            return track(*args, on_frame=on_each, go_on=go_on, **more)

        monkeypatch.setattr(shot_following, "track_shot", slow)
        press(window, Key.Key_T)
        qtbot.waitUntil(lambda: 8 in window.services.shot_track.tracked)
        words = window.shot_following.words()
        assert words.startswith("following: ")
        assert int(words.split()[1]) <= 9  # frames, not how often they were followed
        assert not np.isnan(window.strip.content.band.coverage[8])

        press(window, Key.Key_T)
        all_done(qtbot)

        assert not window.shot_following.running
        assert 8 in window.services.shot_track.tracked
        assert 12 not in window.services.shot_track.tracked

    def test_an_unsure_camera_is_no_beginning(
        self, make_window, dataset, video, qtbot, drawn, monkeypatch
    ):
        def unsure(*_: Any, **__: Any) -> Proposal:
            fit = external_camera_fit(drawn.cameras[0], SIZE)
            return Proposal("unsure", "too little in sight", fit, 0.9, 0.9, 0.3, 0.1, None)

        asked: list[Any] = []

        def noted(_: Any, numbers: range, *__: Any, anchors: Any, **___: Any) -> Track:
            asked.append(dict(anchors))
            return Track((), ())

        monkeypatch.setattr(camera_choice, "propose_camera", unsure)
        monkeypatch.setattr(shot_following, "track_shot", noted)
        window = make_window(dataset)
        services = window.services
        services.opening.open_workspace(
            open_video(video, range(0, COUNT, EVERY), services.state.field)
        )
        all_done(qtbot)
        assert services.prediction.stands_in

        follow(window, qtbot)

        assert asked == [{}]

    def test_not_in_blind_mode_nor_without_order(self, window, dataset, qtbot):
        services = window.services
        said = heard(services)

        services.blind_lock.set_blind(True)
        press(window, Key.Key_T)
        assert said[-1].startswith("blind mode: no shot is followed")
        services.blind_lock.set_blind(False)
        services.opening.open_path(dataset)
        all_done(qtbot)
        press(window, Key.Key_T)
        assert said[-1].startswith("only a video, or frames that follow one another")
        assert not window.shot_following.running

    def test_removing_its_row_forgets_it(self, window, qtbot):
        follow(window, qtbot)
        services = window.services

        window.panels.show("cameras")
        all_done(qtbot)
        window.cameras.list.rows[0].remove.click()

        assert not services.shot_track.tracked
        assert services.state.sources == ()
        assert services.live_fit.wanted

    def test_correcting_a_frame_follows_what_lies_between_its_neighbours_again(
        self, window, qtbot, monkeypatch, hand_on
    ):
        follow(window, qtbot)
        services, track = window.services, shot_following.track_shot
        asked: list[tuple[range, list[int]]] = []

        def noted(frames: Any, numbers: range, *args: Any, anchors: Any, **more: Any) -> Any:
            asked.append((numbers, sorted(anchors)))
            return track(frames, numbers, *args, anchors=anchors, **more)

        monkeypatch.setattr(shot_following, "track_shot", noted)
        services.navigator.go_to(1)
        all_done(qtbot)
        hand: Hand = hand_on(window)
        hand.key(Key.Key_Return, SHIFT)
        all_done(qtbot)
        polyline = services.state.annotation.polylines[0]
        services.selection.select_class(polyline.class_name)
        services.selection.set_mode("edit")
        width, height = SIZE
        at = polyline.points[1].u * (width - 1), polyline.points[1].v * (height - 1)
        hand.drag(at, (at[0] + 4, at[1] + 4))
        assert asked == []  # while somebody works here
        services.selection.set_mode("draw")

        services.navigator.go_to(2)
        qtbot.waitUntil(lambda: bool(asked))
        qtbot.waitUntil(lambda: not window.shot_following.running)

        assert asked == [(range(COUNT // 2), [5])]
        assert services.shot_track.tracked[5].state == "anchor"
        assert services.shot_track.tracked[7].anchor_distance == 2

    def test_another_field_has_another_track(self, window, qtbot):
        follow(window, qtbot)
        services = window.services

        services.evaluation.set_field(load_field("basketball_nba"))
        all_done(qtbot)

        assert not services.shot_track.tracked
        assert services.state.sources == ()

    def test_annotated_frames_are_anchors_before_anybody_knows_which_they_are(
        self, window, qtbot, monkeypatch
    ):
        services, track = window.services, shot_following.track_shot
        follow(window, qtbot)
        accept(window, qtbot)
        asked: list[list[int]] = []

        def noted(*args: Any, anchors: Any, **more: Any) -> Any:
            asked.append(sorted(anchors))
            return track(*args, anchors=anchors, **more)

        monkeypatch.setattr(shot_following, "track_shot", noted)
        services.annotated_frames.set_wanted(False)
        services.annotated_frames._edited.clear()
        follow(window, qtbot)

        assert asked == [[0, 5, 10]]
        # These are fits to the clicks they would be judged by, the others are not.
        anchored = {one.number for one in services.shot_track.tracked.values() if one.clicks}
        assert anchored == {0, 5, 10}

    def test_a_folder_is_followed_up_to_where_pictures_are_missing(
        self, make_window, dataset, pictures, tmp_path, qtbot
    ):
        folder = tmp_path / "pictures"
        folder.mkdir()
        for number in range(14):
            if number != 11:
                cv2.imwrite(str(folder / f"f_{number:03d}.png"), pictures[number][..., :3])
        window = make_window(dataset)
        window.services.opening.open_path(folder)
        all_done(qtbot)

        follow(window, qtbot)

        assert sorted(window.services.shot_track.tracked) == list(range(11))


class TestAccepting:
    def test_a_stretch_is_one_action_and_one_step_of_undo(self, window, video, qtbot):
        services = window.services
        follow(window, qtbot)

        accept(window, qtbot)

        assert files(video) == ["00", "05", "10"]
        assert window.strip.content.anchors == (0, 5, 10)
        for index in range(3):
            services.navigator.go_to(index)
            counts = services.review.origin_counts(
                services.state.frame.name, services.state.annotation
            )
            assert set(counts) == {OriginKind.ACCEPTED}
            assert services.review.status(services.state.frame.name) is Status.IN_PROGRESS
        assert not window.shot_following.running  # nothing was corrected

        services.navigator.go_to(1)
        press(window, Key.Key_Z, CTRL)  # of this frame alone: somebody went on to look
        all_done(qtbot)
        assert files(video) == ["00", "10"]

        window.actions_["take_back_stretch"].trigger()
        qtbot.waitUntil(lambda: not window.stretch_accepting.running)
        all_done(qtbot)
        assert files(video) == []

    def test_undo_right_after_takes_all_of_it_back(self, window, video, qtbot):
        follow(window, qtbot)
        accept(window, qtbot)

        press(window, Key.Key_Z, CTRL)
        qtbot.waitUntil(lambda: not window.stretch_accepting.running)
        all_done(qtbot)

        assert files(video) == []
        assert window.services.review.status("match_000005") is Status.UNTOUCHED

    def test_doubtful_and_annotated_frames_are_left_alone(self, window, video, qtbot, hand_on):
        services = window.services
        follow(window, qtbot)
        services.navigator.go_to(1)
        hand: Hand = hand_on(window)
        hand.draw("Middle line", (40, 40), (200, 120))
        all_done(qtbot)
        before = services.state.annotation
        tracked = dict(services.shot_track.tracked)
        doubtful = tracked[10]
        tracked[10] = type(doubtful)(10, "bridged", "", doubtful.fit, 0.0, None, 10)
        services.shot_track.replace(tracked, services.shot_track.cuts)

        accept(window, qtbot)

        assert files(video) == ["00", "05"]
        assert services.state.annotation == before

    def test_only_the_stretch_that_is_marked(self, window, video, qtbot):
        follow(window, qtbot)
        window.strip.stretch = (4, 9)

        accept(window, qtbot)

        assert files(video) == ["05"]

    def test_undo_of_a_click_made_since_is_of_that_click(self, window, video, qtbot, hand_on):
        services = window.services
        follow(window, qtbot)
        services.navigator.go_to(1)
        hand: Hand = hand_on(window)
        hand.draw("Middle line", (40, 40), (200, 120))
        all_done(qtbot)
        accept(window, qtbot)
        assert files(video) == ["00", "05", "10"]

        hand.draw("Side line top", (50, 300), (400, 320))
        all_done(qtbot)
        press(window, Key.Key_Z, CTRL)
        all_done(qtbot)

        assert not window.stretch_accepting.running
        assert files(video) == ["00", "05", "10"]

    def test_what_was_added_while_it_was_written_is_not_taken_back(
        self, window, qtbot, hand_on, monkeypatch
    ):
        services = window.services
        follow(window, qtbot)
        hand: Hand = hand_on(window)
        edits = window.stretch_accepting._edits
        saved = edits._batch_saved

        def late() -> None:
            hand.draw("Goal left crossbar", (50, 300), (400, 320))
            saved()

        with monkeypatch.context() as once:
            once.setattr(edits, "_batch_saved", late)
            accept(window, qtbot)
        window.actions_["take_back_stretch"].trigger()
        qtbot.waitUntil(lambda: not window.stretch_accepting.running)
        all_done(qtbot)

        assert "Goal left crossbar" in services.state.annotation.annotated
        assert "Middle line" in services.state.annotation.annotated  # left as it was: edited since

    def test_nothing_is_accepted_once_blind_mode_is_on(self, window, video, qtbot, monkeypatch):
        going, look = Event(), shot_accepting._annotate_followed

        def slow(*args: Any) -> Any:
            going.wait(60)
            return look(*args)

        monkeypatch.setattr(shot_accepting, "_annotate_followed", slow)
        follow(window, qtbot)
        press(window, Key.Key_Return, CTRL | SHIFT)
        assert window.stretch_accepting.running
        window.services.blind_lock.set_blind(True)
        going.set()
        qtbot.waitUntil(lambda: not window.stretch_accepting.running)
        all_done(qtbot)

        assert files(video) == []

    def test_without_a_track_it_says_what_to_do(self, window):
        said = heard(window.services)

        press(window, Key.Key_Return, CTRL | SHIFT)

        assert said[-1].startswith("no frame to accept: follow the shot first (T)")

    def test_copying_goes_along_the_track(self, window, qtbot, hand_on):
        services = window.services
        follow(window, qtbot)
        hand: Hand = hand_on(window)
        hand.key(Key.Key_Return, SHIFT)
        all_done(qtbot)
        names = set(services.state.annotation.annotated)
        said = heard(services)

        services.navigator.go_to(1)
        all_done(qtbot)
        press(window, Key.Key_V)
        all_done(qtbot)

        copied = {polyline.class_name for polyline in services.state.annotation.unconfirmed}
        assert copied
        assert copied <= names
        assert "along the track" in said[-1]
