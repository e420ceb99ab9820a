"""What happens while an edit is on its way to the disk: nothing is lost, and nothing is said to be
saved before it is."""

import json
import shutil
import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import Point
from procc_annotator.dataset import editing, saving
from procc_annotator.dataset.locks import locks_folder
from procc_annotator.errors import AnnotationError, SaveError
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import Hand, heard, until_kept

MIDDLE, TOP = "Middle line", "Side line top"
THEIRS = '{"Circle left": [{"x": 0.5, "y": 0.5}]}'


class SlowDisk:
    """Stands before the real atomic write: takes nothing until it is let go, and may fail then.

    Attributes:
        written: what the files were to hold, in the order it came.
        before: called in the thread that writes, before anything is written.
        after: the same, afterwards.
        problem, problem_after: why it fails before or after the file was written.
    """

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.asked, self._go = threading.Event(), threading.Event()
        self.written: list[tuple[str, ...]] = []
        self.problem = self.problem_after = ""
        self.before: Callable[[], object] = lambda: None
        self.after: Callable[[], object] = lambda: None
        self._write = saving.write_atomic
        monkeypatch.setattr(saving, "write_atomic", self.write)

    def write(self, path: Path, data: bytes, **more: Path) -> None:
        self.asked.set()
        assert self._go.wait(20)
        self.before()
        self.written.append(tuple(json.loads(data)))
        if self.problem:
            raise SaveError(f"{path}: cannot be written: {self.problem}")
        self._write(path, data, **more)
        self.after()
        if self.problem_after:
            raise SaveError(f"{path}: cannot be written: {self.problem_after}")

    def let_go(self) -> None:
        self._go.set()

    def hold(self) -> None:
        self.asked.clear()
        self._go.clear()


@pytest.fixture
def disk(monkeypatch) -> Iterator[SlowDisk]:
    made = SlowDisk(monkeypatch)
    yield made
    made.let_go()  # whatever failed: the window is closed after this


def click(window: MainWindow, class_name: str = MIDDLE) -> None:
    """One more point of an element."""
    services = window.services
    points = (
        0 if (known := services.state.annotation.get(class_name)) is None else len(known.points)
    )
    edited = editing.append_points(
        services.state.annotation, class_name, [Point(0.1 + 0.1 * points, 0.5)]
    )
    assert services.editing.commit_edit("click", edited)


def points_on_disk(dataset: Path, frame: int = 0) -> dict[str, int]:
    path = dataset / f"frame_{frame}.json"
    entries = json.loads(path.read_text()) if path.exists() else {}
    return {name: len(points) for name, points in entries.items()}


def reads_saved(window: MainWindow) -> bool:
    return window.top_bar.saved.text().startswith("saved ")


def test_it_is_said_to_be_saved_once_it_is(window, disk, dataset, qtbot):
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    assert window.top_bar.saved.text() == "saving..."
    assert not (dataset / "frame_0.json").exists()
    assert not window.isWindowModified()  # nothing failed
    disk.let_go()
    qtbot.waitUntil(lambda: reads_saved(window))
    assert points_on_disk(dataset) == {MIDDLE: 1}


def test_what_is_clicked_meanwhile_is_saved_on_the_result(window, disk, dataset, qtbot):
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    click(window, TOP)
    click(window, TOP)
    assert window.services.state.annotation.annotated == (MIDDLE, TOP)
    disk.let_go()
    qtbot.waitUntil(lambda: reads_saved(window))
    assert disk.written == [(MIDDLE,), (MIDDLE, TOP)]
    assert points_on_disk(dataset) == {MIDDLE: 1, TOP: 2}
    assert not window.services.saver.problems


def test_an_undo_meanwhile_is_saved_too(window, disk, dataset, qtbot):
    disk.let_go()
    click(window)
    until_kept()
    disk.hold()
    click(window, TOP)
    qtbot.waitUntil(disk.asked.is_set)
    window.services.editing.undo()  # to what the file holds, if only it were left alone
    assert window.top_bar.saved.text() == "saving..."
    disk.let_go()
    qtbot.waitUntil(lambda: reads_saved(window))
    assert points_on_disk(dataset) == {MIDDLE: 1}
    window.services.editing.undo()
    until_kept()
    assert not (dataset / "frame_0.json").exists()


def test_a_first_click_taken_back_while_it_is_written_leaves_no_file(window, disk, dataset, qtbot):
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    window.services.editing.undo()
    disk.let_go()
    qtbot.waitUntil(lambda: reads_saved(window))
    assert not (dataset / "frame_0.json").exists()
    assert not window.services.state.counts


@pytest.mark.parametrize("problem", ["No space left on device", "Permission denied"])
def test_what_the_disk_refuses_is_told_kept_and_tried_again(window, disk, dataset, qtbot, problem):
    disk.problem = problem
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    click(window, TOP)
    disk.let_go()
    qtbot.waitUntil(lambda: "NOT SAVED" in window.top_bar.saved.text())
    qtbot.waitUntil(lambda: not window.services.saver.under_way)
    assert problem in window.message_bar.label.text()
    assert window.isWindowModified()
    assert window.services.state.annotation.annotated == (MIDDLE, TOP)
    disk.problem = ""
    window.services.saver.retry_timer.setInterval(1)
    qtbot.waitUntil(lambda: reads_saved(window))
    assert points_on_disk(dataset) == {MIDDLE: 1, TOP: 1}
    assert not window.isWindowModified()


def test_what_failed_and_was_undone_meanwhile_leaves_nothing_unsaved(window, disk, dataset, qtbot):
    disk.problem = "No space left on device"
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    window.services.editing.undo()
    disk.let_go()
    qtbot.waitUntil(lambda: not window.services.saver.under_way)
    assert not window.services.saver.problems
    assert not window.isWindowModified()
    assert not (dataset / "frame_0.json").exists()


def test_a_write_that_happened_though_it_failed_is_saved(window, disk, dataset, qtbot):
    """A drive behind a network may tell of an error after the file has its new name."""
    disk.problem_after = "Input/output error"
    disk.let_go()
    click(window)
    qtbot.waitUntil(lambda: reads_saved(window))
    assert points_on_disk(dataset) == {MIDDLE: 1}
    assert not window.isWindowModified()


@pytest.mark.parametrize("clicks_before", [0, 1])
def test_what_may_be_on_the_disk_is_not_said_to_be_undone(
    window, disk, dataset, qtbot, monkeypatch, clicks_before
):
    """The write failed behind a drive that cannot be read: nobody knows what the file holds."""
    disk.let_go()
    for _ in range(clicks_before):
        click(window)
        qtbot.waitUntil(lambda: reads_saved(window))
    look = saving.read_optional

    def unreadable(path: Path, error: type[AnnotationError]) -> bytes:
        raise error(str(path), "Input/output error")

    def goes_away() -> None:
        monkeypatch.setattr(saving, "read_optional", unreadable)

    disk.hold()
    disk.problem_after = "Input/output error"
    disk.after = goes_away
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    window.services.editing.undo()
    disk.let_go()
    qtbot.waitUntil(lambda: "NOT SAVED" in window.top_bar.saved.text())
    assert window.isWindowModified()
    assert points_on_disk(dataset) == {MIDDLE: clicks_before + 1}
    disk.problem_after = ""
    disk.after = lambda: None
    monkeypatch.setattr(saving, "read_optional", look)
    window.services.saver.retry_timer.setInterval(1)
    qtbot.waitUntil(lambda: reads_saved(window))
    assert not window.isWindowModified()
    assert points_on_disk(dataset) == ({MIDDLE: 1} if clicks_before else {})
    assert (dataset / "frame_0.json").exists() == bool(clicks_before)


def test_somebody_else_writes_before_it_is_written(window, disk, dataset, qtbot):
    """Their file stays, also when more is clicked meanwhile."""
    disk.let_go()
    click(window)
    until_kept()
    (dataset / "frame_0.json").write_text(THEIRS)
    click(window)
    click(window, TOP)
    qtbot.waitUntil(window.conflict_bar.isVisible)
    until_kept()
    assert (dataset / "frame_0.json").read_text() == THEIRS
    window.conflict_bar.overwrite_button.click()
    assert points_on_disk(dataset) == {MIDDLE: 2, TOP: 1}
    assert reads_saved(window)


def test_somebody_else_writes_while_the_disk_is_waited_for(window, disk, dataset, qtbot):
    """After the file was looked at, and before it is replaced."""
    disk.let_go()
    click(window)
    until_kept()
    disk.before = lambda: (dataset / "frame_0.json").write_text(THEIRS)
    click(window)
    until_kept()
    assert (dataset / "frame_0.json").read_text() == THEIRS
    qtbot.waitUntil(window.conflict_bar.isVisible)
    disk.before = lambda: None
    window.conflict_bar.overwrite_button.click()
    assert points_on_disk(dataset) == {MIDDLE: 2}


def test_a_slow_disk_does_not_hold_the_window_while_it_is_tried_again(window, disk, dataset, qtbot):
    disk.let_go()
    disk.problem = "Input/output error"
    click(window)
    until_kept()
    disk.hold()
    disk.problem = ""
    window.services.saver.retry()
    assert window.services.saver.under_way
    qtbot.waitUntil(disk.asked.is_set)
    disk.let_go()
    qtbot.waitUntil(lambda: reads_saved(window))
    assert points_on_disk(dataset) == {MIDDLE: 1}


def test_what_is_being_written_is_nobody_elses_change(window, disk, dataset, qtbot):
    told = heard(window.services)
    disk.let_go()
    click(window)
    until_kept()
    disk.hold()
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    window.services.editing.undo()
    window.services.editing.look_at_frame()
    window.services.outside_changes.look()
    disk.let_go()
    qtbot.waitUntil(lambda: reads_saved(window))
    window.services.editing.look_at_frame()
    assert not any("elsewhere" in text for text in told)
    assert window.services.state.annotation.get(MIDDLE) is not None
    assert points_on_disk(dataset) == {MIDDLE: 1}


def test_what_others_write_right_after_it_is_seen(window, disk, dataset, qtbot):
    """A look that was asked for while it was written is taken once it is."""
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    window.services.editing.look_at_frame()
    window.services.saver.saved.connect(lambda: (dataset / "frame_0.json").write_text(THEIRS))
    disk.let_go()
    qtbot.waitUntil(lambda: window.services.state.annotation.annotated == ("Circle left",))


def leave_meanwhile(
    window: MainWindow, disk: SlowDisk, qtbot: QtBot, leave: Callable[[], object]
) -> None:
    """Leave while the disk is busy; it is done only once the frame is being left."""
    qtbot.waitUntil(disk.asked.is_set)
    window.services.store.events.aboutToLeave.connect(disk.let_go)
    leave()


def test_a_frame_that_is_left_is_written_before_anybody_else_may_have_it(
    window, disk, dataset, qtbot
):
    locked: list[bool] = []
    disk.before = lambda: locked.append(bool(list(locks_folder(dataset).glob("frame_0-*.lock"))))
    click(window)
    leave_meanwhile(window, disk, qtbot, window.services.navigator.next_frame)
    assert locked == [True]
    assert points_on_disk(dataset) == {MIDDLE: 1}
    assert not list(locks_folder(dataset).glob("frame_0-*.lock"))


def test_the_other_window_reads_what_was_being_written(window, disk, dataset, make_window, qtbot):
    other = make_window(dataset)
    click(window)
    other.services.frame_lock.look()
    assert not other.services.state.editable
    leave_meanwhile(window, disk, qtbot, window.services.navigator.next_frame)
    click_in_other = Hand(other)
    other.services.frame_lock.look()  # it opens by itself
    assert other.services.state.annotation.annotated == (MIDDLE,)
    click_in_other.draw(TOP, (100, 50), (200, 50))
    assert points_on_disk(dataset) == {MIDDLE: 1, TOP: 2}


def test_closing_waits_for_what_is_written_and_for_what_was_clicked_meanwhile(
    window, disk, dataset, qtbot
):
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    click(window, TOP)
    leave_meanwhile(window, disk, qtbot, window.close)
    assert points_on_disk(dataset) == {MIDDLE: 1, TOP: 1}


def test_another_dataset_waits_for_this_one(window, disk, dataset, tmp_path, qtbot):
    other = tmp_path / "other"
    shutil.copytree(dataset, other)
    click(window)
    leave_meanwhile(window, disk, qtbot, lambda: window.services.opening.open_path(other))
    assert points_on_disk(dataset) == {MIDDLE: 1}
    assert window.services.state.annotation.annotated == ()


def test_a_document_that_ends_ends_no_write(window, disk, dataset, qtbot):
    click(window)
    qtbot.waitUntil(disk.asked.is_set)
    disk.let_go()
    window.services.close()
    assert points_on_disk(dataset) == {MIDDLE: 1}


def test_what_is_replaced_is_a_version_before(window, disk, dataset, qtbot):
    (dataset / "frame_1.json").write_text(THEIRS)
    window.services.navigator.go_to(1)
    database = window.services.review.database
    kept: list[list[bytes]] = []
    disk.before = lambda: kept.append(
        [database.version_data(v.id) for v in database.versions("frame_1")]
    )
    disk.let_go()
    click(window)
    until_kept()
    click(window)
    until_kept()
    assert kept[0] == [THEIRS.encode()]
    assert len(kept[1]) == 2
    assert [v.reason for v in database.versions("frame_1")] == ["click", "click", "as it was found"]
