"""Two windows on one dataset: the one that edits a frame has it, the other one is notified."""

import json
import subprocess
import sys
import textwrap
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.label_check.finding import Remedy, RemedyKind
from procc_annotator.gui.commands.element_edits import ElementEdits
from procc_annotator.gui.commands.label_check import LabelCheckCommands
from procc_annotator.gui.commands.versions import apply_version
from procc_annotator.gui.state.services import Services
from tests.gui.conftest import draw, heard

OnDisk = Callable[..., tuple[str, ...]]
MIDDLE, TOP, BOTTOM = "Middle line", "Side line top", "Side line bottom"
ZIGZAG = (0.15, 0.3), (0.3, 0.31), (0.45, 0.3), (0.6, 0.6), (0.75, 0.3)


@pytest.fixture
def both(open_services, dataset) -> tuple[Services, Services]:
    first, second = open_services(dataset), open_services(dataset)
    first.set_author("Ada")
    first.frame_lock.set_dataset(dataset, "Ada")
    first.frame_lock.enter("frame_0")
    return first, second


@pytest.fixture
def locks(dataset) -> Path:
    return dataset / ".procc" / "locks"


def annotated(services: Services) -> tuple[str, ...]:
    return services.state.annotation.annotated


def on_disk(dataset: Path, frame: int = 0) -> tuple[str, ...]:
    return tuple(json.loads((dataset / f"frame_{frame}.json").read_text()))


def clear_away(folder: Path, tmp_path: Path) -> None:
    """At once, as a deletion file by file is not: a window may be writing into it."""
    folder.rename(tmp_path / f"cleared_{folder.name}")


def leave_it_to(second: Services, first: Services) -> None:
    """The first window leaves the frame; the second one, which looked meanwhile, shows it."""
    second.frame_lock.look()
    first.navigator.next_frame()
    second.frame_lock.look()


def test_the_second_window_sees_who_is_editing_and_cannot_draw(both):
    first, second = both
    draw(first, MIDDLE)
    second.frame_lock.look()
    assert not second.state.editable
    assert "Ada" in second.state.why_not_editable
    assert not draw(second, TOP)
    assert TOP not in annotated(second)


def test_an_edit_that_finds_the_lock_free_again_opens_the_frame(both):
    first, second = both
    draw(first, MIDDLE)
    second.frame_lock.look()
    first.frame_lock.close()
    assert second.editing.commit_edit("late", first.state.annotation)  # of a gesture begun before
    assert second.state.editable


def test_who_looks_only_blocks_nobody(both):
    assert draw(both[1], TOP)
    assert annotated(both[1]) == (TOP,)


def test_a_click_that_comes_second_is_refused(both):
    first, second = both
    said = heard(second)
    assert first.editing.begin_edit()  # not finished, nothing saved yet
    assert not second.editing.begin_edit()
    assert "Ada" in said[-1]


@pytest.mark.parametrize("looked", [True, False])
def test_it_opens_with_the_newer_file_once_the_other_leaves(both, looked):
    first, second = both
    draw(first, MIDDLE)
    if looked:
        leave_it_to(second, first)
        assert second.state.editable
        assert annotated(second) == (MIDDLE,)
    else:
        first.navigator.next_frame()
    draw(second, TOP)  # the file is read again before
    assert annotated(second) == (MIDDLE, TOP)
    assert not second.saver.problems


def test_a_lock_that_was_cleared_away_is_taken_again(both, dataset, locks, tmp_path):
    first, second = both
    draw(first, MIDDLE)
    clear_away(dataset / ".procc", tmp_path)
    first.frame_lock.beat()
    second.frame_lock.look()
    assert not second.state.editable
    clear_away(locks, tmp_path)
    draw(first, TOP)  # before the next beat
    second.frame_lock.look()
    assert not second.state.editable


def test_a_frame_somebody_else_had_meanwhile_is_read_again(both, locks, tmp_path):
    first, second = both
    draw(first, MIDDLE)
    clear_away(locks, tmp_path)  # as if it had expired while the first one slept
    second.frame_lock.look()
    draw(second, TOP)
    second.navigator.next_frame()
    first.frame_lock.beat()
    assert annotated(first) == (MIDDLE, TOP)
    assert not first.saver.problems


def test_another_frame_is_free(both):
    first, second = both
    draw(first, MIDDLE)
    second.navigator.next_frame()
    assert draw(second, TOP)


def test_a_closed_window_leaves_no_lock(both, locks):
    draw(both[0], MIDDLE)
    assert list(locks.iterdir())
    both[0].close()
    assert not list(locks.iterdir())


def test_the_lock_of_a_killed_program_is_gone_at_once(open_services, dataset):
    killed = """
        import os, signal, sys
        from pathlib import Path
        from procc_annotator.dataset.locks import FrameLocks
        locks = FrameLocks(Path(sys.argv[1]) / ".procc" / "locks", "Crashed")
        assert locks.acquire("frame_0") is None
        os.kill(os.getpid(), signal.SIGKILL)
    """
    done = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(killed), str(dataset)], check=False
    )
    assert done.returncode < 0
    assert draw(open_services(dataset), MIDDLE)


def test_comments_of_the_other_window_arrive(both, qtbot):
    first, second = both
    first.review.add_comment("frame_0", "look here")
    first.review.database.flush(5.0)

    def arrived() -> bool:
        second.review.poll()
        return [c.text for c in second.review.comments("frame_0")] == ["look here"]

    qtbot.waitUntil(arrived)


def test_a_lock_lost_in_the_middle_of_a_gesture_costs_no_click(both, dataset, locks):
    first, second = both
    assert first.editing.begin_edit()
    for lock in locks.iterdir():  # as if this machine had slept
        lock.unlink()
    assert second.frame_lock.acquire()
    first.frame_lock.beat()
    draw(second, TOP)
    seen = first.state.annotation
    assert first.editing.commit_edit("draw", seen.with_polyline(second.state.annotation.get(TOP)))
    first.saver.settle()
    assert annotated(first) == (TOP,)
    assert (dataset / "frame_0.json").exists()


def test_a_menu_edit_keeps_what_the_other_window_drew(both):
    first, second = both
    draw(first, MIDDLE)
    leave_it_to(second, first)
    first.navigator.previous_frame()
    draw(first, TOP)
    first.navigator.next_frame()  # the second window has not looked in between
    second.selection.select_class(MIDDLE)
    ElementEdits(second).change_class(BOTTOM)
    assert annotated(second) == (BOTTOM, TOP)


def test_a_menu_edit_of_what_the_other_window_changed_is_not_done(both):
    first, second = both
    draw(first, MIDDLE)
    leave_it_to(second, first)
    first.navigator.previous_frame()
    first.selection.select_class(MIDDLE)
    ElementEdits(first).change_class(TOP)
    first.navigator.next_frame()
    second.selection.select_class(MIDDLE)
    said = heard(second)
    ElementEdits(second).reverse()
    assert annotated(second) == (TOP,)
    assert "changed elsewhere" in said[-1]


def test_a_remedy_keeps_what_the_other_window_drew(both, qtbot, widget):
    first, second = both
    draw(first, MIDDLE, *ZIGZAG)
    leave_it_to(second, first)
    qtbot.waitUntil(lambda: bool(second.label_check.shown))
    found = second.label_check.shown[0]
    remedy = Remedy(RemedyKind.RELABEL, "relabel", ((MIDDLE, BOTTOM),))
    commands = LabelCheckCommands(second, widget)
    first.navigator.previous_frame()
    draw(first, TOP)
    first.navigator.next_frame()
    commands.apply(found, remedy)
    assert annotated(second) == (BOTTOM, TOP)
    second.editing.undo()
    second.navigator.next_frame()
    first.navigator.previous_frame()
    first.frame_lock.look()
    draw(first, MIDDLE)
    first.navigator.next_frame()
    second.navigator.previous_frame()
    commands.apply(found, remedy)
    assert BOTTOM not in annotated(second)


def test_a_lock_to_blind_mode_reaches_a_window_that_is_worked_in(both, qtbot):
    first, second = both
    said = heard(second)
    first.blind_lock.set_locked(True)
    first.review.database.flush(5.0)

    def looked() -> bool:
        second.review.add_comment("frame_0", "busy")  # before every look, as by a busy hand
        second.review.poll()
        return second.state.blind

    qtbot.waitUntil(looked)
    assert [text for text in said if "locked this dataset to blind mode on" in text]
    assert first.state.blind


def let_go(services: Services) -> None:
    """It shows the frame, does not edit it, and did not notice yet what others write."""
    services.navigator.next_frame()
    services.navigator.previous_frame()
    services.outside_changes.close()


@pytest.mark.parametrize("direction", ["undo", "redo"])
def test_undo_and_redo_take_back_nothing_that_the_other_window_saved(both, dataset, direction):
    first, second = both
    draw(first, MIDDLE)
    if direction == "redo":
        draw(first, BOTTOM)
        first.editing.undo()
    let_go(first)
    draw(second, TOP)
    second.navigator.next_frame()
    said = heard(first)
    getattr(first.editing, direction)()
    assert on_disk(dataset) == annotated(first) == (MIDDLE, TOP)
    assert "changed elsewhere" in said[-1]


def test_undo_takes_away_what_the_other_window_saved_only_when_asked_twice(both, dataset):
    first, second = both

    def undo() -> None:
        second.editing.undo()
        second.saver.settle()

    draw(second, MIDDLE)
    second.navigator.next_frame()
    draw(first, TOP)
    second.navigator.previous_frame()
    first.navigator.next_frame()
    second.frame_lock.look()  # it opens by itself
    assert annotated(second) == (MIDDLE, TOP)
    said = heard(second)
    draw(second, BOTTOM)
    undo()
    for _ in range(2):
        undo()
        assert on_disk(dataset) == (MIDDLE, TOP)
        assert "undo once more takes that away" in said[-1]
        draw(second, BOTTOM)
        undo()
    undo()
    undo()
    assert on_disk(dataset) == (MIDDLE,)
    second.editing.redo()
    second.saver.settle()
    assert on_disk(dataset) == (MIDDLE, TOP)


def test_nobody_commits_what_they_have_not_seen(both):
    first, second = both
    draw(first, MIDDLE)
    first.navigator.next_frame()
    second.editing.commit_frame()
    assert annotated(second) == (MIDDLE,)
    assert not second.review.record("frame_0").committed
    second.editing.commit_frame()
    assert second.review.record("frame_0").committed


@pytest.mark.parametrize("in_the_middle", [True, False])
def test_a_lost_lock_costs_nobody_an_element(both, dataset, locks, tmp_path, in_the_middle):
    first, second = both
    draw(first, MIDDLE)
    seen = first.state.annotation
    clear_away(locks, tmp_path)  # as if it had expired in its sleep
    second.frame_lock.look()
    draw(second, TOP)
    second.navigator.next_frame()
    if in_the_middle:  # its gesture had begun before
        drawn = FrameAnnotation((*seen.polylines, replace(seen.polylines[0], class_name=BOTTOM)))
        first.editing.commit_edit("draw", drawn)
        first.saver.settle()
        assert first.saver.conflict(0) is not None
        assert on_disk(dataset) == (MIDDLE, TOP)
    else:
        draw(first, BOTTOM)  # before the next beat
        assert on_disk(dataset) == (MIDDLE, TOP, BOTTOM)
        assert not first.saver.problems
    assert BOTTOM in annotated(first)


def test_an_earlier_version_does_not_replace_what_the_other_window_just_saved(both, dataset):
    first, second = both
    draw(first, MIDDLE)
    draw(first, BOTTOM)
    oldest = first.review.database.versions("frame_0")[-1]
    let_go(first)
    draw(second, TOP)
    second.navigator.next_frame()
    for held in ((MIDDLE, BOTTOM, TOP), (MIDDLE,)):  # the second time it was seen
        apply_version(first, oldest.id)
        first.saver.settle()
        assert on_disk(dataset) == held
