"""A stretch is followed past damaged pictures, not in blind mode, nor for what is taken back."""

from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.result import external_camera_fit
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.gui.commands import shot_accepting, shot_following
from procc_annotator.gui.main_window import MainWindow
from tests.drawn_shots import soccer_shot
from tests.gui.conftest import SIZE, Hand, all_done, heard, until_kept

COUNT = 12
DAMAGED = 6
Key = Qt.Key
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier


LINE = FrameAnnotation((Polyline("Side line top", (Point(0.1, 0.2), Point(0.8, 0.3))),))


def followed(number: int, coverage: float = 0.9) -> TrackedFrame:
    camera = soccer_shot(1, size=SIZE).cameras[0]
    fit = external_camera_fit(camera, SIZE)
    return TrackedFrame(number, "followed", "", fit, coverage, 0.3, 1)


@pytest.fixture
def shot(tmp_path, striped) -> Path:
    """Pictures that follow one another."""
    folder = tmp_path / "shot"
    folder.mkdir()
    for number in range(COUNT):
        (folder / f"at_{number:02d}.png").write_bytes(striped[0])
    return folder


@pytest.fixture
def window(make_window, shot, qtbot) -> MainWindow:
    """The first three frames were followed."""
    made = make_window(shot)
    all_done(qtbot)
    made.services.shot_track.replace({n: followed(n) for n in range(3)}, ())
    all_done(qtbot)
    return made


def press(window: MainWindow, key: Qt.Key, modifiers: Any = Qt.KeyboardModifier.NoModifier) -> None:
    QTest.keyClick(window.canvas, key, modifiers)


def look_finds(monkeypatch: pytest.MonkeyPatch, *indices: int) -> None:
    """Paint is seen in these frames."""

    def look(_: Any, __: Any, fits: Any, ___: Any) -> dict[int, FrameAnnotation]:
        return {index: LINE for index in indices if index in fits}

    monkeypatch.setattr(shot_accepting, "_annotate_followed", look)


def accept(window: MainWindow, qtbot: QtBot) -> None:
    press(window, Key.Key_Return, CTRL | SHIFT)
    qtbot.waitUntil(lambda: not window.stretch_accepting.running)
    all_done(qtbot)


def files(shot: Path) -> list[str]:
    until_kept()
    return sorted(path.stem[-2:] for path in shot.glob("at_*.json"))


def commit_here(window: MainWindow, hand: Hand, qtbot: QtBot) -> None:
    """In blind mode, with something clicked; the frame stays on screen, its cameras are shown."""
    index = window.services.state.frame_index
    window.services.blind_lock.set_blind(True)
    hand.draw("Middle line", (40, 40), (200, 120))
    press(window, Key.Key_Return, CTRL)
    all_done(qtbot)
    window.services.navigator.go_to(index)
    all_done(qtbot)
    assert window.services.state.projection_visible


def test_what_is_taken_back_is_not_followed_again(window, shot, qtbot, monkeypatch):
    look_finds(monkeypatch, 0, 1)
    accept(window, qtbot)
    press(window, Key.Key_Z, CTRL)
    qtbot.waitUntil(lambda: not window.stretch_accepting.running)
    all_done(qtbot)
    assert files(shot) == []

    press(window, Key.Key_Y, CTRL)
    qtbot.waitUntil(lambda: not window.stretch_accepting.running)
    all_done(qtbot)
    assert files(shot) == ["00", "01"]  # all of them again
    press(window, Key.Key_Z, CTRL)
    qtbot.waitUntil(lambda: not window.stretch_accepting.running)
    all_done(qtbot)
    assert files(shot) == []

    window.services.navigator.go_to(2)

    assert not window.shot_following.running
    press(window, Key.Key_Z, CTRL | SHIFT)
    assert files(shot) == []  # another frame is meant


def test_unsure_frames_are_gone_through_from_the_least_sure_to_the_last(window, qtbot):
    window.stretch_accepting.unsure = {2: 0.7, 5: 0.2, 8: 0.9}
    window.services.navigator.go_to(2)
    said, places, alt = heard(window.services), [], Qt.KeyboardModifier.AltModifier
    for _ in range(4):
        press(window, Key.Key_PageDown, alt)
        places.append(window.services.state.frame_index)
        all_done(qtbot)
    assert places == [5, 2, 8, 5]
    assert [text.split(",")[0] for text in said] == ["1 of 3", "2 of 3", "3 of 3", "1 of 3"]
    assert ["last one" in text for text in said] == [False, False, True, False]


def test_nothing_is_accepted_while_the_shot_is_followed(window, monkeypatch):
    monkeypatch.setattr(type(window.shot_following), "running", True)
    said = heard(window.services)
    press(window, Key.Key_Return, CTRL | SHIFT)
    assert "still being followed" in said[-1]
    assert not window.stretch_accepting.running


def test_doubtful_frames_are_accepted_by_pressing_once_more(window, shot, qtbot, monkeypatch):
    window.services.shot_track.replace(
        {n: followed(n, 0.9 if n == 1 else 0.4) for n in range(3)}, ()
    )
    look_finds(monkeypatch, 0, 1, 2)
    said = heard(window.services)

    accept(window, qtbot)
    assert files(shot) == ["01"]
    assert "2 doubtful frames left: Ctrl+Shift+Enter once more" in said[-1]

    accept(window, qtbot)
    assert files(shot) == ["00", "01", "02"]
    assert said[-1].startswith("annotated 2 frames")

    accept(window, qtbot)
    assert said[-1] == "no frame to accept: all that were followed are annotated"
    window.services.navigator.go_to(2)
    press(window, Key.Key_Z, CTRL)
    assert said[-1].startswith("undone: accept elements")
    assert files(shot) == ["00", "01"]


def test_all_frames_doubtful_the_reason_is_said_before_any_is_accepted(
    window, shot, qtbot, monkeypatch
):
    window.services.shot_track.replace({n: followed(n, 0.4) for n in range(3)}, ())
    look_finds(monkeypatch, 0, 1, 2)
    said = heard(window.services)

    accept(window, qtbot)
    assert files(shot) == []
    assert said[-1].startswith("all 3 frames are doubtful (only 40% of the lines in sight are")

    window.services.shot_track.replace(
        {0: followed(0, 0.4)}, ()
    )  # others than those that were named
    accept(window, qtbot)
    assert files(shot) == []
    accept(window, qtbot)
    assert files(shot) == ["00"]


def test_a_committed_frame_opens_no_other_in_blind_mode(window, shot, qtbot, hand_on, monkeypatch):
    look_finds(monkeypatch, 1, 2)
    commit_here(window, hand_on(window), qtbot)

    accept(window, qtbot)
    press(window, Key.Key_T)

    assert not window.shot_following.running
    assert files(shot) == ["00"]


def test_a_picture_that_is_damaged_is_lost_and_the_rest_is_followed(
    make_window, shot, qtbot, monkeypatch
):
    (shot / f"at_{DAMAGED:02d}.png").write_bytes(b"no picture")

    def track(frame: Any, numbers: range, *_: Any, **__: Any) -> Track:
        for number in numbers:
            assert frame(number).shape == (SIZE[1], SIZE[0], 4)
        frames = tuple(followed(number) for number in numbers)
        return Track(frames, ((numbers[0], numbers[-1]),))

    monkeypatch.setattr(shot_following, "track_shot", track)
    window = make_window(shot)
    all_done(qtbot)

    press(window, Key.Key_T)
    qtbot.waitUntil(lambda: not window.shot_following.running)
    all_done(qtbot)

    tracked = window.services.shot_track.tracked
    assert sorted(tracked) == list(range(COUNT))
    assert [n for n, frame in tracked.items() if frame.fit is None] == [DAMAGED]
    assert "cannot be" in tracked[DAMAGED].reason


def test_stopped_before_anything_was_followed_it_says_so(window, qtbot, monkeypatch):
    def shot_around(*args: Any) -> range:
        while True:
            args[-1]()  # ends once nobody wants it

    monkeypatch.setattr(shot_following, "shot_range_around", shot_around)
    said = heard(window.services)

    press(window, Key.Key_T)
    press(window, Key.Key_T)
    all_done(qtbot)

    assert said[-1] == "stopped; nothing was followed"
