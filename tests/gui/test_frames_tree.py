"""The list of frames of a dataset whose pictures lie in folders of folders."""

import json
import shutil
from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from procc_annotator.dataset.records import Status
from procc_annotator.gui.panels.frame_delegate import folder_words
from procc_annotator.gui.panels.frame_rows import FolderInfo
from procc_annotator.gui.panels.frames import FramesPanel
from procc_annotator.gui.state.services import Services
from tests.gui.conftest import all_done, draw


@pytest.fixture
def tree(tmp_path, striped) -> Path:
    root = tmp_path / "season"
    for match in ("a/img1", "b/img1"):
        (root / match).mkdir(parents=True)
        for i, picture in enumerate(striped):
            (root / match / f"{i}.png").write_bytes(picture)
    return root


@pytest.fixture
def services(open_services, tree) -> Services:
    return open_services(tree)


@pytest.fixture
def frames(services, show) -> FramesPanel:
    return show(FramesPanel(services))


def _rows(frames: FramesPanel) -> list[str]:
    """What each row says: a folder by its label in brackets."""
    model = frames.model
    found = []
    for row in range(model.rowCount()):
        folder = model.folder_info(row)
        info = model.info(row)
        found.append(f"[{folder.label}]" if folder is not None else info.name if info else "")
    return found


def _current(frames: FramesPanel) -> int:
    return frames.list.currentIndex().row()


def test_frames_lie_in_folders_of_which_the_one_on_screen_is_open(frames):
    assert _rows(frames) == ["[a/img1]", "0", "1", "2", "[b/img1]"]
    assert _current(frames) == 1
    assert frames.count.text() == "6 frames in 2 folders"


def test_going_on_opens_the_next_folder(services, frames):
    services.navigator.go_to(3)
    frames._refresh()
    assert _rows(frames)[4:] == ["[b/img1]", "0", "1", "2"]
    assert _current(frames) == 5


def test_a_click_on_a_folder_folds_it_and_stays_on_the_frame(services, frames, qtbot):
    view = frames.list
    place = view.visualRect(frames.model.index(0)).center()
    qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert _rows(frames) == ["[a/img1]", "[b/img1]"]
    assert services.state.frame_index == 0
    qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert _rows(frames) == ["[a/img1]", "0", "1", "2", "[b/img1]"]


def test_keys_fold_and_unfold(services, frames, qtbot):
    view = frames.list
    view.setFocus()
    qtbot.keyClick(view, Qt.Key.Key_Left)  # from the frame to its folder
    assert _current(frames) == 0
    qtbot.keyClick(view, Qt.Key.Key_Left)
    assert _rows(frames) == ["[a/img1]", "[b/img1]"]
    qtbot.keyClick(view, Qt.Key.Key_Down)
    assert services.state.frame_index == 0
    qtbot.keyClick(view, Qt.Key.Key_Right)
    assert _rows(frames) == ["[a/img1]", "[b/img1]", "0", "1", "2"]
    qtbot.keyClick(view, Qt.Key.Key_Right)
    assert services.state.frame_index == 3
    qtbot.keyClick(view, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert len(_rows(frames)) == 8
    qtbot.keyClick(view, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert _rows(frames) == ["[a/img1]", "[b/img1]"]
    assert _current(frames) == 1  # the folder that holds the frame on screen
    qtbot.keyClick(view, Qt.Key.Key_Return)
    assert _rows(frames)[1:] == ["[b/img1]", "0", "1", "2"]


def test_a_filter_shows_what_matches_in_every_folder(frames):
    frames.filter.setText("img1/2")
    assert _rows(frames) == ["[a/img1]", "2", "[b/img1]", "2"]
    info = frames.model.folder_info(0)
    assert info is not None
    assert folder_words(info)[0] == "1 of 3 frames"
    assert frames.count.text() == "2 of 6 frames in 2 folders"
    frames.filter.clear()
    assert _rows(frames) == ["[a/img1]", "0", "1", "2", "[b/img1]"]


def test_a_folder_tells_how_much_of_it_is_done(services, frames, qtbot):
    services.review.set_status("b/img1/1", Status.DONE)

    def done() -> list[int]:
        infos = map(frames.model.folder_info, range(frames.model.rowCount()))
        return [info.done for info in infos if info is not None]

    qtbot.waitUntil(lambda: done() == [0, 1])
    services.review.set_status("b/img1/1", Status.IN_PROGRESS)
    qtbot.waitUntil(lambda: done() == [0, 0])


def test_words_of_a_folder(frames):
    info = FolderInfo("a", 0, folded=True, frames=1200, shown=1200, done=30, jac=None)
    assert folder_words(info) == ["1,200 frames · 30 done", "1,200 frames", "30/1200"]


def test_an_edit_is_saved_beside_the_picture_of_its_match(services, tree):
    services.navigator.go_to(4)
    draw(services, "Middle line")
    assert [p.relative_to(tree).as_posix() for p in tree.rglob("*.json")] == ["b/img1/1.json"]
    services.navigator.go_to(1)
    draw(services, "Middle line")
    names = {p.relative_to(tree).as_posix() for p in tree.rglob("*.json")}
    assert names == {"a/img1/1.json", "b/img1/1.json"}


def test_while_blind_no_folder_tells_a_score(open_services, show, sample_data, tmp_path, qtbot):
    for match in ("a", "b"):
        folder, cameras = tmp_path / "season" / match, tmp_path / "cameras" / match
        folder.mkdir(parents=True)
        cameras.mkdir(parents=True)
        for suffix in (".jpg", ".json"):
            shutil.copy(sample_data / f"00002{suffix}", folder)
        shutil.copy(sample_data / "cameras/pinhole/camera_00002.json", cameras)
    services = open_services(tmp_path / "season")
    frames = show(FramesPanel(services))
    assert services.camera_sources.load_cameras(tmp_path / "cameras")

    def scores() -> list[float | None]:
        infos = map(frames.model.folder_info, range(frames.model.rowCount()))
        return [info.jac for info in infos if info is not None]

    qtbot.waitUntil(lambda: scores() == [1.0, 1.0])
    services.blind_lock.set_blind(True)
    assert scores() == [None, None]
    all_done(qtbot)
    assert scores() == [None, None]


def test_an_annotation_without_the_folder_of_pictures_is_shown_and_saved_where_it_is(
    open_services, tree, qtbot
):
    path = tree / "annotations/a/0.json"
    path.parent.mkdir(parents=True)
    path.write_text(json.dumps({"Middle line": [{"x": 0.1, "y": 0.1}, {"x": 0.4, "y": 0.4}]}))
    services = open_services(tree)
    assert [p.class_name for p in services.state.annotation.polylines] == ["Middle line"]
    draw(services, "Side line top")
    qtbot.waitUntil(lambda: "Side line top" in json.loads(path.read_text()))
    assert [p.name for p in (tree / "annotations").rglob("*.json")] == ["0.json"]
    services.navigator.go_to(1)
    draw(services, "Side line top")
    qtbot.waitUntil((tree / "annotations/a/img1/1.json").exists)
