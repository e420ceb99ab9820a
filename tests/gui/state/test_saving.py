"""While an edit is on its way to the disk nothing is lost, nor counts as saved before it is."""

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
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.services import Services
from tests.gui.conftest import draw, heard

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


def click(services: Services, class_name: str = MIDDLE) -> None:
    """One more point of an element."""
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


def saved(services: Services) -> bool:
    return not services.saver.under_way and not services.state.unsaved


def test_it_is_said_to_be_saved_once_it_is(services, disk, dataset, qtbot):
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    assert services.saver.under_way
    assert not (dataset / "frame_0.json").exists()
    assert not services.state.unsaved  # nothing failed
    disk.let_go()
    qtbot.waitUntil(lambda: saved(services))
    assert points_on_disk(dataset) == {MIDDLE: 1}


def test_what_is_clicked_meanwhile_is_saved_on_the_result(services, disk, dataset, qtbot):
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    click(services, TOP)
    click(services, TOP)
    assert services.state.annotation.annotated == (MIDDLE, TOP)
    disk.let_go()
    qtbot.waitUntil(lambda: saved(services))
    assert disk.written == [(MIDDLE,), (MIDDLE, TOP)]
    assert points_on_disk(dataset) == {MIDDLE: 1, TOP: 2}
    assert not services.saver.problems


def test_an_undo_meanwhile_is_saved_too(services, disk, dataset, qtbot):
    disk.let_go()
    click(services)
    services.saver.settle()
    disk.hold()
    click(services, TOP)
    qtbot.waitUntil(disk.asked.is_set)
    services.editing.undo()  # to what the file holds, if only it were left alone
    assert services.saver.under_way
    disk.let_go()
    qtbot.waitUntil(lambda: saved(services))
    assert points_on_disk(dataset) == {MIDDLE: 1}
    services.editing.undo()
    services.saver.settle()
    assert not (dataset / "frame_0.json").exists()


def test_a_first_click_taken_back_while_it_is_written_leaves_no_file(
    services, disk, dataset, qtbot
):
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    services.editing.undo()
    disk.let_go()
    qtbot.waitUntil(lambda: saved(services))
    assert not (dataset / "frame_0.json").exists()
    assert not services.state.counts


@pytest.mark.parametrize("problem", ["No space left on device", "Permission denied"])
def test_what_the_disk_refuses_is_told_kept_and_tried_again(
    services, disk, dataset, qtbot, problem
):
    disk.problem = problem
    told = heard(services)
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    click(services, TOP)
    disk.let_go()
    qtbot.waitUntil(lambda: bool(services.state.unsaved))
    qtbot.waitUntil(lambda: not services.saver.under_way)
    assert sum(problem in text for text in told) == 1
    assert services.state.annotation.annotated == (MIDDLE, TOP)
    disk.problem = ""
    services.saver.retry_timer.setInterval(1)
    qtbot.waitUntil(lambda: saved(services))
    assert points_on_disk(dataset) == {MIDDLE: 1, TOP: 1}


def test_what_failed_and_was_undone_meanwhile_leaves_nothing_unsaved(
    services, disk, dataset, qtbot
):
    disk.problem = "No space left on device"
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    services.editing.undo()
    disk.let_go()
    qtbot.waitUntil(lambda: not services.saver.under_way)
    assert not services.saver.problems
    assert not services.state.unsaved
    assert not (dataset / "frame_0.json").exists()


def test_a_write_that_happened_though_it_failed_is_saved(services, disk, dataset, qtbot):
    """A drive behind a network may tell of an error after the file has its new name."""
    disk.problem_after = "Input/output error"
    disk.let_go()
    click(services)
    qtbot.waitUntil(lambda: saved(services))
    assert points_on_disk(dataset) == {MIDDLE: 1}


@pytest.mark.parametrize("clicks_before", [0, 1])
def test_what_may_be_on_the_disk_is_not_said_to_be_undone(
    services, disk, dataset, qtbot, monkeypatch, clicks_before
):
    """The write failed behind a drive that cannot be read: nobody knows what the file holds."""
    disk.let_go()
    for _ in range(clicks_before):
        click(services)
        qtbot.waitUntil(lambda: saved(services))
    look = saving.read_optional

    def unreadable(path: Path, error: type[AnnotationError]) -> bytes:
        raise error(str(path), "Input/output error")

    def goes_away() -> None:
        monkeypatch.setattr(saving, "read_optional", unreadable)

    disk.hold()
    disk.problem_after = "Input/output error"
    disk.after = goes_away
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    services.editing.undo()
    disk.let_go()
    qtbot.waitUntil(lambda: bool(services.state.unsaved))
    assert points_on_disk(dataset) == {MIDDLE: clicks_before + 1}
    disk.problem_after = ""
    disk.after = lambda: None
    monkeypatch.setattr(saving, "read_optional", look)
    services.saver.retry_timer.setInterval(1)
    qtbot.waitUntil(lambda: saved(services))
    assert points_on_disk(dataset) == ({MIDDLE: 1} if clicks_before else {})
    assert (dataset / "frame_0.json").exists() == bool(clicks_before)


def test_somebody_else_writes_before_it_is_written(services, disk, dataset, qtbot):
    """Their file stays, also when more is clicked meanwhile."""
    disk.let_go()
    click(services)
    services.saver.settle()
    (dataset / "frame_0.json").write_text(THEIRS)
    click(services)
    click(services, TOP)
    qtbot.waitUntil(lambda: services.saver.conflict(0) is not None)
    services.saver.settle()
    assert (dataset / "frame_0.json").read_text() == THEIRS
    services.editing.overwrite_frame()
    assert points_on_disk(dataset) == {MIDDLE: 2, TOP: 1}
    assert saved(services)


def test_somebody_else_writes_while_the_disk_is_waited_for(services, disk, dataset, qtbot):
    """After the file was looked at, and before it is replaced."""
    disk.let_go()
    click(services)
    services.saver.settle()
    disk.before = lambda: (dataset / "frame_0.json").write_text(THEIRS)
    click(services)
    services.saver.settle()
    assert (dataset / "frame_0.json").read_text() == THEIRS
    qtbot.waitUntil(lambda: services.saver.conflict(0) is not None)
    disk.before = lambda: None
    services.editing.overwrite_frame()
    assert points_on_disk(dataset) == {MIDDLE: 2}


def test_a_slow_disk_does_not_hold_the_window_while_it_is_tried_again(
    services, disk, dataset, qtbot
):
    disk.let_go()
    disk.problem = "Input/output error"
    click(services)
    services.saver.settle()
    disk.hold()
    disk.problem = ""
    services.saver.retry()
    assert services.saver.under_way
    qtbot.waitUntil(disk.asked.is_set)
    disk.let_go()
    qtbot.waitUntil(lambda: saved(services))
    assert points_on_disk(dataset) == {MIDDLE: 1}


def test_what_is_being_written_is_nobody_elses_change(services, disk, dataset, qtbot):
    told = heard(services)
    disk.let_go()
    click(services)
    services.saver.settle()
    disk.hold()
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    services.editing.undo()
    services.editing.look_at_frame()
    services.outside_changes.look()
    disk.let_go()
    qtbot.waitUntil(lambda: saved(services))
    services.editing.look_at_frame()
    assert not any("elsewhere" in text for text in told)
    assert services.state.annotation.get(MIDDLE) is not None
    assert points_on_disk(dataset) == {MIDDLE: 1}


def test_what_others_write_right_after_it_is_seen(services, disk, dataset, qtbot):
    """A look that was asked for while it was written is taken once it is."""
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    services.editing.look_at_frame()
    services.saver.saved.connect(lambda: (dataset / "frame_0.json").write_text(THEIRS))
    disk.let_go()
    qtbot.waitUntil(lambda: services.state.annotation.annotated == ("Circle left",))


def leave_meanwhile(
    services: Services, disk: SlowDisk, qtbot: QtBot, leave: Callable[[], object]
) -> None:
    """Leave while the disk is busy; it is done only once the frame is being left."""
    qtbot.waitUntil(disk.asked.is_set)
    services.store.events.aboutToLeave.connect(disk.let_go)
    leave()


def test_a_frame_that_is_left_is_written_before_anybody_else_may_have_it(
    services, disk, dataset, qtbot
):
    locked: list[bool] = []
    disk.before = lambda: locked.append(bool(list(locks_folder(dataset).glob("frame_0-*.lock"))))
    click(services)
    leave_meanwhile(services, disk, qtbot, services.navigator.next_frame)
    assert locked == [True]
    assert points_on_disk(dataset) == {MIDDLE: 1}
    assert not list(locks_folder(dataset).glob("frame_0-*.lock"))


def test_the_other_window_reads_what_was_being_written(
    services, disk, dataset, open_services, qtbot
):
    other = open_services(dataset)
    click(services)
    other.frame_lock.look()
    assert not other.state.editable
    leave_meanwhile(services, disk, qtbot, services.navigator.next_frame)
    other.frame_lock.look()  # it opens by itself
    assert other.state.annotation.annotated == (MIDDLE,)
    draw(other, TOP)
    assert points_on_disk(dataset) == {MIDDLE: 1, TOP: 2}


def test_closing_waits_for_what_is_written_and_for_what_was_clicked_meanwhile(
    services, disk, dataset, qtbot
):
    click(services)
    qtbot.waitUntil(disk.asked.is_set)
    click(services, TOP)
    disk.let_go()
    services.close()
    assert points_on_disk(dataset) == {MIDDLE: 1, TOP: 1}


def test_another_dataset_waits_for_this_one(services, disk, dataset, tmp_path, qtbot):
    other = tmp_path / "other"
    shutil.copytree(dataset, other)
    click(services)
    leave_meanwhile(services, disk, qtbot, lambda: services.opening.open_path(other))
    assert points_on_disk(dataset) == {MIDDLE: 1}
    assert services.state.annotation.annotated == ()


def test_what_is_replaced_is_a_version_before(services, disk, dataset, qtbot):
    (dataset / "frame_1.json").write_text(THEIRS)
    services.navigator.go_to(1)
    database = services.review.database
    kept: list[list[bytes]] = []
    disk.before = lambda: kept.append(
        [database.version_data(v.id) for v in database.versions("frame_1")]
    )
    disk.let_go()
    click(services)
    services.saver.settle()
    click(services)
    services.saver.settle()
    assert kept[0] == [THEIRS.encode()]
    assert len(kept[1]) == 2
    assert [v.reason for v in database.versions("frame_1")] == ["click", "click", "as it was found"]


def test_another_failure_takes_nothing_unsaved_out_of_sight(services, disk):
    disk.let_go()
    disk.problem = "No space left on device"
    draw(services, MIDDLE)
    say(services.store, "workspace.db: cannot be written", "warning")  # the same full disk
    services.navigator.next_frame()
    assert services.state.unsaved
    disk.problem = ""
    assert services.editing.save_now()  # from another frame
    assert not services.state.unsaved
    assert points_on_disk(services.state.workspace.folder) == {MIDDLE: 2}


@pytest.fixture
def conflicting(services, dataset) -> Services:
    """Somebody else wrote the file of a frame whose second element is not saved yet."""
    draw(services, MIDDLE)
    (dataset / "frame_0.json").write_text(THEIRS)
    draw(services, TOP)
    assert services.state.unsaved
    assert (dataset / "frame_0.json").read_text() == THEIRS
    return services


def test_what_a_decision_overwrites_stays_a_version(conflicting, dataset):
    conflicting.editing.overwrite_frame()
    assert points_on_disk(dataset) == {MIDDLE: 2, TOP: 2}
    database = conflicting.review.database
    newest, before, *_ = database.versions("frame_0")
    assert database.version_data(before.id) == THEIRS.encode()
    assert database.version_data(newest.id) == (dataset / "frame_0.json").read_bytes()


def test_undo_to_what_was_saved_last_decides_no_conflict(conflicting, dataset):
    database = conflicting.review.database
    mine = database.version_data(database.versions("frame_0")[-1].id)
    conflicting.editing.undo()
    assert conflicting.state.annotation.annotated == (MIDDLE,)
    assert conflicting.saver.conflict(0) is not None  # the file is another one
    conflicting.editing.redo()
    conflicting.saver.settle()
    (dataset / "frame_0.json").write_bytes(mine)  # whoever changed it took that back
    conflicting.editing.undo()
    conflicting.saver.settle()
    assert saved(conflicting)


def test_a_newer_file_that_is_read_leaves_no_conflict_behind(conflicting):
    conflicting.editing.undo()
    conflicting.navigator.next_frame()
    conflicting.navigator.previous_frame()
    assert conflicting.editing.begin_edit()  # the frame was let go of: its file is read again
    assert conflicting.state.annotation.annotated == ("Circle left",)
    assert saved(conflicting)
