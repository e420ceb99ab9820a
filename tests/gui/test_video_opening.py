"""Opening a video in the window: which frames, annotating them, keeping them as pictures."""

import shutil
import threading
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.load import load_field
from procc_annotator.gui.commands.opening import VideoDialog
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.background import run_in_background
from procc_annotator.image.video import Video

SIZE = (320, 180)
FPS = 10.0
FRAMES = 40
CUT = 25  # the first frame of the second scene


def picture_of(number: int) -> np.ndarray:
    """A camera that pans over one of two scenes, its frame's number in the corner."""
    scene = np.random.default_rng(number >= CUT).integers(0, 200, (12, 40, 3), dtype=np.uint8)
    wide = cv2.resize(scene, (SIZE[0] + 2 * FRAMES, SIZE[1]), interpolation=cv2.INTER_CUBIC)
    picture = np.ascontiguousarray(wide[:, 2 * number : 2 * number + SIZE[0]])
    picture[:40, :40] = 5 * number
    return picture


@pytest.fixture
def match(tmp_path) -> Path:
    """Four seconds with one cut."""
    path = tmp_path / "match.avi"
    code = cv2.VideoWriter.fourcc(*"MJPG")
    writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, code, FPS, SIZE)
    for number in range(FRAMES):
        writer.write(picture_of(number))
    writer.release()
    return path


def asked(window: MainWindow, qtbot: QtBot, video: Path) -> VideoDialog:
    """The dialog that opening a video shows."""
    window.opening.open_path(video)
    qtbot.waitUntil(lambda: window.findChild(VideoDialog) is not None)
    return window.findChild(VideoDialog)


def accept(window: MainWindow, dialog: VideoDialog, qtbot: QtBot) -> None:
    """Accept, and wait until the keyboard is the window's again."""
    with qtbot.waitActive(window):
        dialog.accept()
        window.activateWindow()
    window.canvas.setFocus()


def names(window: MainWindow) -> list[str]:
    workspace = window.services.state.workspace
    return [frame.name for frame in workspace.frames]


def test_a_frame_every_second_is_annotated_beside_the_video(make_window, hand_on, qtbot, match):
    window = make_window()
    dialog = asked(window, qtbot, match)
    texts = [label.text() for label in dialog.findChildren(QLabel)]
    assert any(f"{FRAMES} frames, 320x180, 4 s" in text for text in texts)
    accept(window, dialog, qtbot)
    assert names(window) == ["match_000000", "match_000010", "match_000020", "match_000030"]
    window.services.navigator.go_to(2)
    picture = window.services.navigator.picture
    assert abs(int(picture[20, 20, 0]) - 5 * 20) <= 4
    hand_on(window).draw("Middle line", (50, 50), (250, 120))
    saved = match.parent / "match_frames" / "match_000020.json"
    assert "Middle line" in saved.read_text()
    assert list(saved.parent.glob("*.png")) == []  # nothing is extracted


@pytest.mark.new_window
@pytest.mark.parametrize("chosen", ["volleyball", "tennis"])
def test_the_dialog_shows_the_field_and_asks_it(make_window, qtbot, match, chosen):
    window = make_window(match, field=load_field("volleyball"))
    qtbot.waitUntil(lambda: window.findChild(VideoDialog) is not None)
    dialog = window.findChild(VideoDialog)
    assert dialog.field.currentData() == "volleyball"
    dialog.field.setCurrentIndex(dialog.field.findData(chosen))
    accept(window, dialog, qtbot)
    qtbot.waitUntil(lambda: window.services.state.field.name == chosen)
    assert window.opening.open_path(match)  # and the dataset remembers it
    qtbot.waitUntil(lambda: len(window.findChildren(VideoDialog)) > 0)
    assert window.findChildren(VideoDialog)[-1].field.currentData() == chosen


@pytest.mark.new_window
def test_what_was_chosen_is_offered_for_the_next_video(make_window, qtbot, match):
    window = make_window()
    dialog = asked(window, qtbot, match)
    dialog.seconds.setValue(2.0)
    dialog.field.setCurrentIndex(dialog.field.findData("tennis"))
    accept(window, dialog, qtbot)
    assert len(names(window)) == 2
    other = match.with_name("other.avi")
    shutil.copy(match, other)
    again = make_window()
    dialog = asked(again, qtbot, other)
    assert (dialog.seconds.value(), dialog.cuts.isChecked()) == (2.0, False)
    assert dialog.field.currentData() == "tennis"
    accept(again, dialog, qtbot)
    qtbot.waitUntil(lambda: again.services.state.field.name == "tennis")


def test_the_interface_opens_no_video_itself(make_window, qtbot, match, monkeypatch):
    opened_by: list[threading.Thread] = []
    open_video = Video.open

    def noted(path: Path) -> Video:
        opened_by.append(threading.current_thread())
        return open_video(path)

    monkeypatch.setattr(Video, "open", noted)
    window = make_window()
    accept(window, asked(window, qtbot, match), qtbot)
    assert window.services.navigator.picture is not None
    assert opened_by
    assert threading.main_thread() not in opened_by


def test_a_kept_frame_joins_its_annotation_as_a_dataset_of_its_own(
    make_window, hand_on, qtbot, match
):
    window = make_window()
    accept(window, asked(window, qtbot, match), qtbot)
    window.services.navigator.go_to(1)
    hand_on(window).draw("Middle line", (50, 50), (250, 120))
    shown = window.services.navigator.picture
    assert shown is not None
    kept = match.parent / "match_frames" / "match_000010.png"
    for _ in range(2):  # keeping it again writes the same file
        with qtbot.waitSignal(
            window.services.store.events.message, check_params_cb=lambda m: "kept as" in m.text
        ):
            window.opening.keep_frame()
    assert np.array_equal(cv2.imread(str(kept)), shown[:, :, :3])
    dataset = Workspace.open(kept.parent, window.services.state.field)
    assert [frame.name for frame in dataset.frames] == ["match_000010"]
    assert dataset.annotated_count(0) == 1


def test_frames_worked_on_are_there_whatever_is_chosen_the_next_time(
    make_window, hand_on, qtbot, match
):
    window = make_window()
    accept(window, asked(window, qtbot, match), qtbot)
    window.services.navigator.go_to(1)
    hand_on(window).draw("Middle line", (50, 50), (250, 120))
    dialog = asked(window, qtbot, match)
    dialog.seconds.setValue(2.5)
    accept(window, dialog, qtbot)
    assert names(window) == ["match_000000", "match_000010", "match_000025"]


def test_the_first_frame_of_every_scene(make_window, qtbot, match):
    window = make_window()
    dialog = asked(window, qtbot, match)
    dialog.cuts.setChecked(True)
    before = window.services.state.workspace
    dialog.accept()
    qtbot.waitUntil(lambda: window.services.state.workspace is not before)
    assert names(window) == ["match_000000", f"match_{CUT:06d}"]


def test_cancelling_leaves_what_was_open(window, qtbot, match):
    asked(window, qtbot, match).reject()
    assert names(window)[0] == "frame_0"


def test_a_dataset_opened_meanwhile_wins(window, qtbot, dataset, match, monkeypatch):
    begun, gate, finished = threading.Event(), threading.Event(), threading.Event()

    def slow(_: Video) -> None:
        begun.set()
        gate.wait(10)
        finished.set()

    monkeypatch.setattr(Video, "read_index", slow)
    window.opening.open_path(match)
    qtbot.waitUntil(begun.is_set)
    window.services.opening.open_path(dataset)
    gate.set()
    qtbot.waitUntil(finished.is_set)
    # The dialog would be there once later jobs are through.
    done: list[int] = []
    for i in range(6):
        run_in_background(lambda _, i=i: i, on_result=done.append, on_error=pytest.fail)
    qtbot.waitUntil(lambda: len(done) == 6)
    assert window.findChild(VideoDialog) is None
    assert names(window)[0] == "frame_0"


def test_a_file_that_is_no_video_is_one_clear_message(window, qtbot, tmp_path):
    broken = tmp_path / "broken.mp4"
    broken.write_bytes(b"not a video" * 100)
    with qtbot.waitSignal(
        window.services.store.events.message, check_params_cb=lambda m: "broken.mp4" in m.text
    ):
        window.opening.open_path(broken)
    assert names(window)[0] == "frame_0"
    assert window.findChild(VideoDialog) is None


def test_keeping_a_picture_says_that_it_is_one(window, qtbot):
    with qtbot.waitSignal(window.services.store.events.message) as said:
        window.opening.keep_frame()
    assert "picture already" in said.args[0].text
