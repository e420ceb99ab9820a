"""The list of frames: opens at once whatever its length, filters, follows, shows what is done."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QModelIndex, Qt

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset.records import Status
from procc_annotator.gui.panels.frame_delegate import row_words
from procc_annotator.gui.panels.frame_rows import RowInfo, Thumbnails
from procc_annotator.gui.panels.frames import FramesPanel
from procc_annotator.gui.state.services import Services


@pytest.fixture
def frames(tmp_path) -> Path:
    for i in range(1, 13):
        picture = np.full((36, 64, 3), 10 * i, dtype=np.uint8)
        cv2.imwrite(str(tmp_path / f"match {i}.png"), picture)
    (tmp_path / "match 2.json").write_text('{"Middle line": [{"x": 0.5, "y": 0.1}]}')
    (tmp_path / "match 3.json").write_text('{"Middle line": [')
    (tmp_path / "match 4.png").write_bytes(b"not a picture")
    return tmp_path


@pytest.fixture
def services(open_services, frames) -> Services:
    return open_services(frames)


@pytest.fixture
def panel(services, show) -> FramesPanel:
    panel = show(FramesPanel(services))
    panel.resize(260, 700)
    return panel


def _info(panel: FramesPanel, row: int) -> RowInfo:
    info = panel.model.info(row)
    assert info is not None
    return info


def _known(panel: FramesPanel, row: int) -> bool:
    info = _info(panel, row)
    return info.thumbnail is not None and (info.count is not None or bool(info.unreadable))


def test_rows_fill_in_behind(qtbot, panel):
    qtbot.waitUntil(lambda: all(_known(panel, row) for row in range(5)))
    assert [_info(panel, row).name for row in range(3)] == ["match 1", "match 2", "match 3"]
    assert _info(panel, 0).count == 0
    assert _info(panel, 1).count == 1
    assert _info(panel, 2).unreadable
    assert _info(panel, 3).unreadable
    thumbnail = _info(panel, 4).thumbnail
    assert thumbnail.width() == 64
    assert thumbnail.pixelColor(3, 3).red() == 50


def test_pictures_come_from_the_top_down(qtbot, services, frames):
    """As far as they are painted together, which is not for a test to say of a whole list."""
    thumbnails = Thumbnails(services.cache, services)
    rows = [frames / f"match {i}.png" for i in range(1, 9)]
    came: list[list[Path]] = []
    thumbnails.arrived.connect(came.append)
    for path in rows:
        assert thumbnails.image(path) is None
    qtbot.waitUntil(lambda: sum(map(len, came)) == len(rows))
    assert [path for batch in came for path in batch] == rows


def test_a_click_goes_to_the_frame_and_the_list_follows(qtbot, panel, services):
    rect = panel.list.visualRect(panel.model.index(4, 0))
    qtbot.mouseClick(panel.list.viewport(), Qt.MouseButton.LeftButton, pos=rect.center())
    assert services.state.frame_index == 4
    services.navigator.go_to(11)
    qtbot.waitUntil(lambda: panel.list.currentIndex().row() == 11)
    assert (
        panel.list.viewport()
        .rect()
        .contains(panel.list.visualRect(panel.list.currentIndex()).center())
    )


def test_the_filter_narrows_by_name(qtbot, panel, services):
    qtbot.keyClicks(panel.filter, "MATCH 1")
    assert panel.model.rowCount() == 4
    assert panel.count.text() == "4 of 12 frames"
    assert panel.list.currentIndex().row() == 0
    services.navigator.go_to(10)
    qtbot.waitUntil(lambda: panel.list.currentIndex().row() == 2)
    services.navigator.go_to(5)
    qtbot.waitUntil(lambda: not panel.list.currentIndex().isValid())
    assert services.state.frame_index == 5
    qtbot.keyClicks(panel.filter, "x")
    assert panel.empty.isVisible()
    assert "MATCH 1x" in panel.empty.text()
    panel.filter.clear()
    assert panel.model.rowCount() == 12
    assert panel.list.currentIndex().row() == 5


def test_next_and_previous_stay_within_the_filter(window, hand, qtbot):
    services, where = window.services, lambda: window.services.state.frame_index
    services.review.set_status("frame_1", Status.DONE)
    window.frames.filter.setText("-state:done")
    qtbot.waitUntil(lambda: window.frames.model.shown == 2)
    hand.key(Qt.Key.Key_D)
    assert where() == 2
    hand.key(Qt.Key.Key_D)
    assert where() == 2
    assert "no further frame" in window.status.hint.text()
    services.review.set_status("frame_0", Status.DONE)
    qtbot.waitUntil(lambda: window.frames.model.shown == 1)
    services.navigator.go_to(1)
    hand.key(Qt.Key.Key_A)
    assert where() == 1
    window.frames.filter.clear()
    qtbot.waitUntil(lambda: window.frames.model.shown == 3)
    hand.key(Qt.Key.Key_A)
    assert where() == 0


def test_enter_in_the_filter_goes_to_the_first_match(qtbot, panel, services):
    qtbot.keyClicks(panel.filter, "12")
    qtbot.keyClick(panel.filter, Qt.Key.Key_Return)
    assert services.state.frame_index == 11
    qtbot.keyClick(panel.filter, Qt.Key.Key_Escape)
    assert panel.model.rowCount() == 12
    assert panel.list.currentIndex().row() == 11


def test_an_edit_is_counted(qtbot, panel, services):
    qtbot.waitUntil(lambda: _known(panel, 0))
    line = Polyline("Middle line", (Point(0.1, 0.1), Point(0.2, 0.2)))
    services.editing.commit_edit("draw", FrameAnnotation((line,)))
    qtbot.waitUntil(lambda: _info(panel, 0).count == 1)


def test_without_frames_the_panel_says_what_to_do(qtbot, qapp):
    services = Services()
    panel = FramesPanel(services)
    qtbot.addWidget(panel)
    panel.show()
    assert panel.empty.isVisible()
    assert "Open a folder" in panel.empty.text()


def test_of_twenty_thousand_frames_only_those_on_show_are_looked_at(
    qtbot, tmp_path, qapp, monkeypatch
):
    first = tmp_path / "00000.png"
    cv2.imwrite(str(first), np.zeros((4, 4, 3), dtype=np.uint8))
    for i in range(1, 20_000):
        (tmp_path / f"{i:05d}.png").hardlink_to(first)
    services = Services()
    assert services.opening.open_path(tmp_path)
    panel = FramesPanel(services)
    qtbot.addWidget(panel)
    panel.resize(260, 700)
    asked: set[int] = set()
    delegate, model = type(panel.list.itemDelegate()), type(panel.model)
    for kind, name in ((delegate, "sizeHint"), (delegate, "paint"), (model, "data")):
        monkeypatch.setattr(kind, name, _noting(getattr(kind, name), asked))
    panel._take_dataset()
    panel.show()
    panel.grab()
    assert panel.model.rowCount() == 20_000
    assert 0 < len(asked) < 100


def _noting(original: Callable[..., Any], asked: set[int]) -> Callable[..., Any]:
    """A method that also notes which rows it is called for."""

    def call(*terms: Any) -> Any:
        asked.update(term.row() for term in terms if isinstance(term, QModelIndex))
        return original(*terms)

    return call


def test_the_status_is_not_cut_for_the_number_of_elements():
    row = RowInfo("a", None, 12, "", False, None, status=Status.IN_PROGRESS)
    assert row_words(row, False) == ["in progress · 12", "in progress", "12"]


def test_what_is_drawn_right_before_a_frame_is_left_is_counted(qtbot, panel, services):
    qtbot.waitUntil(lambda: _known(panel, 0))
    assert _info(panel, 0).count == 0
    line = Polyline("Middle line", (Point(0.5, 0.1), Point(0.5, 0.9)))
    with services.store.transaction():  # as a polyline under way is finished by leaving
        assert services.editing.commit_edit("draw", FrameAnnotation((line,)))
        services.navigator.go_to(1)
    qtbot.waitUntil(lambda: _info(panel, 0).count == 1)
    assert services.editing.commit_edit("draw", FrameAnnotation((line,)))
    services.navigator.go_to(5)
    services.navigator.go_to(0)
    qtbot.waitUntil(lambda: _info(panel, 1).count == 1)
