"""A season in the window: its matches are listed with their state, and open with their cameras."""

import threading
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog
from pytestqt.qtbot import QtBot

from procc_annotator.batch.unit_store import DONE, SOURCE, UnitStore
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.packed import PackedCameras
from procc_annotator.gui.commands import season as season_commands
from procc_annotator.gui.commands.opening import VideoDialog
from procc_annotator.gui.main_window import MainWindow

pytestmark = pytest.mark.new_window
MJPG = cv2.VideoWriter.fourcc(*"MJPG")
MATCHES = ("day 2/a", "day 10/a", "day 10/b")
FIGURES = ("done 12 12 50% 0", "waiting – 0 – 0", "begun – 7 91% 1")


@pytest.fixture
def season(tmp_path) -> Path:
    """Three matches, in a folder and in a list."""
    for name in MATCHES:
        path = tmp_path / "season" / f"{name}.avi"
        path.parent.mkdir(parents=True, exist_ok=True)
        writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, MJPG, 10.0, (320, 180))
        for _ in range(12):
            writer.write(np.full((180, 320, 3), 90, np.uint8))
        writer.release()
    rows = [f"season/{name}.avi,{name},Park {i},basketball_fiba" for i, name in enumerate(MATCHES)]
    (tmp_path / "list.csv").write_text("\n".join(["video,match,stadium,field", *rows]))
    return tmp_path / "season"


@pytest.fixture
def tracked(season, tmp_path) -> Path:
    """One match is done, another begun, with a unit that was set aside."""
    out = tmp_path / "tracked"
    with UnitStore(out / "track.sqlite", {SOURCE: str(season)}, resume=False) as store:
        store.announce("day 2/a", DONE, frames=12, cameras=12, evidence=0.5)
        store.add("1", None, match="day 2/a", kind="track", frames=12, evidence=0.5)
        store.add("2", None, match="day 10/b", kind="track", frames=7, evidence=0.91)
        store.add("3", None, match="day 10/b", kind="track", state="failed", error="damaged")
    cameras = PackedCameras.without_cameras(tuple(f"a_{i:06d}" for i in range(12)), "a", "followed")
    cameras.camera[:] = 0.0, 1.3, 0.0, 0.0, 60.0, -15.0, 400.0, 400.0, 160.0, 90.0, *[0.0] * 12
    cameras.size[:] = 320, 180
    (out / "day 2").mkdir()
    (out / "day 2" / "a.npz").write_bytes(cameras.encoded())
    return out


def shown(window: MainWindow, qtbot: QtBot) -> list[str]:
    qtbot.waitUntil(lambda: window.opening.season.dialog is not None)
    model = window.opening.season.dialog.table.model()
    rows = range(model.rowCount())
    return [" ".join(model.index(row, k).data() for k in range(8)) for row in rows]


@pytest.mark.parametrize("opened", ["season", "list.csv", "tracked"])
def test_matches_are_listed_and_open_with_their_cameras(
    make_window, qtbot, tracked, opened, monkeypatch
):
    read, readers = season_commands.list_matches, []
    noted = lambda path: readers.append(threading.current_thread()) or read(path)  # noqa: E731
    monkeypatch.setattr(season_commands, "list_matches", noted)
    window = make_window(tracked.parent / opened, field=load_field("tennis"))
    if opened != "tracked":
        assert all("waiting" in row for row in shown(window, qtbot))
        monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tracked))
        window.opening.season.dialog.tracked.click()
        qtbot.waitUntil(lambda: "done" in shown(window, qtbot)[0])
    parks = [f"Park {i} " if opened == "list.csv" else " " for i in range(3)]
    rows = [f"{m} {park} {f}" for m, park, f in zip(MATCHES, parks, FIGURES, strict=True)]
    assert shown(window, qtbot) == rows
    dialog = window.opening.season.dialog
    dialog.table.sortByColumn(6, Qt.SortOrder.DescendingOrder)
    assert shown(window, qtbot) == [rows[2], rows[0], rows[1]]
    dialog.search.setText("day done")
    assert shown(window, qtbot) == [rows[0]]
    dialog.table.doubleClicked.emit(dialog.table.model().index(0, 3))
    qtbot.waitUntil(lambda: window.findChild(VideoDialog) is not None)
    asked, state = window.findChild(VideoDialog), window.services.store
    assert asked.field.currentData() == ("basketball_fiba" if "csv" in opened else "tennis")
    asked.accept()
    qtbot.waitUntil(lambda: state.state.active is not None)
    assert state.state.active.matched(frame.name for frame in state.state.workspace.frames) == 2
    window.actions_["season"].trigger()
    assert len(shown(window, qtbot)) == 3
    assert threading.main_thread() not in readers


def test_a_folder_of_pictures_with_a_video_is_a_dataset(make_window, qtbot, season, dataset):
    (season / "day 2" / "a.avi").rename(dataset / "clip.avi")
    window = make_window()
    window.opening.drop([dataset])
    qtbot.waitUntil(lambda: window.services.state.workspace is not None)
    window.opening.drop([season])
    assert len(shown(window, qtbot)) == 2


def test_a_table_that_is_no_list_is_refused_by_name(make_window, qtbot, tmp_path):
    (tmp_path / "list.csv").write_text("film,match\na.mp4,a\n")
    window = make_window(tmp_path / "list.csv")
    qtbot.waitUntil(lambda: "no column 'video'" in window.message_bar.label.text())
