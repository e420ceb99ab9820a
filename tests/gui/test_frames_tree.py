"""The list of frames of a dataset whose pictures lie in folders of folders."""

import json
import shutil
from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from procc_annotator.dataset.records import Status
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.frame_delegate import folder_words
from procc_annotator.gui.panels.frame_rows import FolderInfo
from tests.gui.conftest import all_done


@pytest.fixture
def tree(tmp_path, striped) -> Path:
    root = tmp_path / "season"
    for match in ("a/img1", "b/img1"):
        (root / match).mkdir(parents=True)
        for i, picture in enumerate(striped):
            (root / match / f"{i}.png").write_bytes(picture)
    return root


@pytest.fixture
def window(make_window, tree) -> MainWindow:
    return make_window(tree)


def _rows(window: MainWindow) -> list[str]:
    """What each row says: a folder by its label in brackets."""
    model = window.frames.model
    found = []
    for row in range(model.rowCount()):
        folder = model.folder_info(row)
        info = model.info(row)
        found.append(f"[{folder.label}]" if folder is not None else info.name if info else "")
    return found


def _current(window: MainWindow) -> int:
    return window.frames.list.currentIndex().row()


def test_frames_lie_in_folders_of_which_the_one_on_screen_is_open(window):
    assert _rows(window) == ["[a/img1]", "0", "1", "2", "[b/img1]"]
    assert _current(window) == 1
    assert window.frames.count.text() == "6 frames in 2 folders"
    assert window.windowTitle().startswith("a/img1/0")


def test_going_on_opens_the_next_folder(window):
    window.services.navigator.go_to(3)
    window.frames._follow_frames()
    assert _rows(window)[4:] == ["[b/img1]", "0", "1", "2"]
    assert _current(window) == 5


def test_a_click_on_a_folder_folds_it_and_stays_on_the_frame(window, qtbot):
    view = window.frames.list
    place = view.visualRect(window.frames.model.index(0)).center()
    qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert _rows(window) == ["[a/img1]", "[b/img1]"]
    assert window.services.state.frame_index == 0
    qtbot.mouseClick(view.viewport(), Qt.MouseButton.LeftButton, pos=place)
    assert _rows(window) == ["[a/img1]", "0", "1", "2", "[b/img1]"]


def test_keys_fold_and_unfold(window, qtbot):
    view = window.frames.list
    view.setFocus()
    qtbot.keyClick(view, Qt.Key.Key_Left)  # from the frame to its folder
    assert _current(window) == 0
    qtbot.keyClick(view, Qt.Key.Key_Left)
    assert _rows(window) == ["[a/img1]", "[b/img1]"]
    qtbot.keyClick(view, Qt.Key.Key_Down)
    assert window.services.state.frame_index == 0
    qtbot.keyClick(view, Qt.Key.Key_Right)
    assert _rows(window) == ["[a/img1]", "[b/img1]", "0", "1", "2"]
    qtbot.keyClick(view, Qt.Key.Key_Right)
    assert window.services.state.frame_index == 3
    qtbot.keyClick(view, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert len(_rows(window)) == 8
    qtbot.keyClick(view, Qt.Key.Key_Left, Qt.KeyboardModifier.ShiftModifier)
    assert _rows(window) == ["[a/img1]", "[b/img1]"]
    assert _current(window) == 1  # the folder that holds the frame on screen
    qtbot.keyClick(view, Qt.Key.Key_Return)
    assert _rows(window)[1:] == ["[b/img1]", "0", "1", "2"]


def test_a_filter_shows_what_matches_in_every_folder(window):
    window.frames.filter.setText("img1/2")
    assert _rows(window) == ["[a/img1]", "2", "[b/img1]", "2"]
    info = window.frames.model.folder_info(0)
    assert info is not None
    assert folder_words(info)[0] == "1 of 3 frames"
    assert window.frames.count.text() == "2 of 6 frames in 2 folders"
    window.frames.filter.clear()
    assert _rows(window) == ["[a/img1]", "0", "1", "2", "[b/img1]"]


def test_a_folder_tells_how_much_of_it_is_done(window, qtbot):
    window.services.review.set_status("b/img1/1", Status.DONE)

    def done() -> list[int]:
        infos = map(window.frames.model.folder_info, range(window.frames.model.rowCount()))
        return [info.done for info in infos if info is not None]

    qtbot.waitUntil(lambda: done() == [0, 1])
    window.services.review.set_status("b/img1/1", Status.IN_PROGRESS)
    qtbot.waitUntil(lambda: done() == [0, 0])


def test_words_of_a_folder():
    info = FolderInfo("a", 0, folded=True, frames=1200, shown=1200, done=30, jac=None)
    assert folder_words(info) == ["1,200 frames · 30 done", "1,200 frames", "30/1200"]


def test_an_edit_is_saved_beside_the_picture_of_its_match(window, hand, tree):
    window.services.navigator.go_to(4)
    hand.draw("Middle line", (100, 50), (120, 200))
    assert [p.relative_to(tree).as_posix() for p in tree.rglob("*.json")] == ["b/img1/1.json"]
    window.services.navigator.go_to(1)
    hand.draw("Middle line", (100, 50), (120, 200))
    names = {p.relative_to(tree).as_posix() for p in tree.rglob("*.json")}
    assert names == {"a/img1/1.json", "b/img1/1.json"}


def test_while_blind_no_folder_tells_a_score(make_window, sample_data, tmp_path, qtbot):
    for match in ("a", "b"):
        folder, cameras = tmp_path / "season" / match, tmp_path / "cameras" / match
        folder.mkdir(parents=True)
        cameras.mkdir(parents=True)
        for suffix in (".jpg", ".json"):
            shutil.copy(sample_data / f"00002{suffix}", folder)
        shutil.copy(sample_data / "cameras/pinhole/camera_00002.json", cameras)
    window = make_window(tmp_path / "season")
    assert window.services.camera_sources.load_cameras(tmp_path / "cameras")

    def scores() -> list[float | None]:
        infos = map(window.frames.model.folder_info, range(window.frames.model.rowCount()))
        return [info.jac for info in infos if info is not None]

    qtbot.waitUntil(lambda: scores() == [1.0, 1.0], timeout=20_000)
    window.services.blind_lock.set_blind(True)
    assert scores() == [None, None]
    all_done(qtbot)
    assert scores() == [None, None]


def test_an_annotation_without_the_folder_of_pictures_is_shown_and_saved_where_it_is(
    make_window, tree, hand_on, qtbot
):
    path = tree / "annotations/a/0.json"
    path.parent.mkdir(parents=True)
    path.write_text(json.dumps({"Middle line": [{"x": 0.1, "y": 0.1}, {"x": 0.4, "y": 0.4}]}))
    window = make_window(tree)
    assert [p.class_name for p in window.services.state.annotation.polylines] == ["Middle line"]
    hand_on(window).draw("Side line top", (10, 30), (60, 30))
    qtbot.waitUntil(lambda: "Side line top" in json.loads(path.read_text()))
    assert [p.name for p in (tree / "annotations").rglob("*.json")] == ["0.json"]
    window.services.navigator.go_to(1)
    hand_on(window).draw("Side line top", (10, 30), (60, 30))
    qtbot.waitUntil((tree / "annotations/a/img1/1.json").exists)
