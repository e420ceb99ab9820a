"""Two windows on one dataset: who edits a frame has it, the other one is told."""

import json
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path

import pytest

from procc_annotator.annotation import Point, Polyline
from procc_annotator.calibration.label_check.finding import Remedy, RemedyKind
from procc_annotator.gui.commands.versions import apply_version
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import Hand, heard, until_kept

HandOn = Callable[[MainWindow], "Hand"]
OnDisk = Callable[..., tuple[str, ...]]
MIDDLE, TOP = "Middle line", "Side line top"


def _clear_away(folder: Path, tmp_path: Path) -> None:
    """At once, as a deletion file by file is not: a window may be writing into it."""
    folder.rename(tmp_path / f"cleared_{folder.name}")


def enter(window: MainWindow) -> None:
    """The key of a window that does not have the keyboard; what it finishes is saved."""
    window.canvas.key("Enter")
    until_kept()


@pytest.fixture
def both(make_window, dataset) -> tuple[MainWindow, MainWindow]:
    first, second = make_window(dataset), make_window(dataset)
    first.services.set_author("Ada")
    first.services.frame_lock.set_dataset(dataset, "Ada")
    first.services.frame_lock.enter("frame_0")
    return first, second


@pytest.fixture
def on_disk(dataset) -> OnDisk:
    """The classes that a frame's file holds, the first one's unless told otherwise."""

    def read(frame: int = 0) -> tuple[str, ...]:
        until_kept()
        return tuple(json.loads((dataset / f"frame_{frame}.json").read_text()))

    return read


def test_the_second_window_sees_who_is_editing_and_cannot_click(both, hand_on):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.services.frame_lock.look()
    assert not second.services.state.editable
    assert "Ada" in second.frame_bar.label.text()
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.services.state.annotation.get(TOP) is None
    assert not second.canvas.editor.drawing


def test_an_edit_that_finds_the_lock_free_again_opens_the_frame(both, hand_on):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.services.frame_lock.look()
    first.services.frame_lock.close()
    annotation = second.services.state.annotation
    moved = annotation.with_polyline(Polyline(TOP, (Point(0.1, 0.1), Point(0.3, 0.1))))
    assert second.services.editing.commit_edit("late", moved)  # of a gesture that had begun before
    assert second.services.state.editable
    assert second.frame_bar.isHidden()


def test_who_looks_only_blocks_nobody(both, hand_on):
    _, second = both
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.services.state.annotation.get(TOP) is not None


def test_a_click_that_comes_second_is_refused_before_anything_is_drawn(both, hand_on):
    first, second = both
    first.services.selection.select_class(MIDDLE)
    hand_on(first).click(100, 100)  # not finished, nothing saved yet
    second.services.selection.select_class(TOP)
    hand_on(second).click(100, 50)
    assert not second.canvas.editor.drawing
    assert "Ada" in second.message_bar.label.text()


def test_it_opens_by_itself_with_the_newer_file_once_the_other_leaves(both, hand_on):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.services.frame_lock.look()
    first.services.navigator.next_frame()
    second.services.frame_lock.look()
    assert second.services.state.editable
    assert second.services.state.annotation.annotated == (MIDDLE,)
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.services.state.annotation.annotated == (MIDDLE, TOP)
    assert not second.services.saver.problems


def test_a_frame_edited_elsewhere_meanwhile_is_read_again_before_the_first_click(both, hand_on):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    first.services.navigator.next_frame()  # the second window has not looked in between
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.services.state.annotation.annotated == (MIDDLE, TOP)


def test_a_lock_that_was_cleared_away_is_taken_again(both, hand_on, dataset, tmp_path):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    enter(first)
    _clear_away(dataset / ".procc", tmp_path)
    first.services.frame_lock.beat()
    second.services.frame_lock.look()
    assert not second.services.state.editable
    _clear_away(dataset / ".procc" / "locks", tmp_path)
    hand_on(first).draw(TOP, (100, 50), (200, 50))  # before the next beat
    enter(first)
    second.services.frame_lock.look()
    assert not second.services.state.editable


def test_a_frame_somebody_else_had_meanwhile_is_read_again(both, hand_on, dataset, tmp_path):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    enter(first)
    _clear_away(
        dataset / ".procc" / "locks", tmp_path
    )  # as if it had expired while the first one slept
    second.services.frame_lock.look()
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    second.services.navigator.next_frame()
    first.services.frame_lock.beat()
    assert first.services.state.annotation.annotated == (MIDDLE, TOP)
    assert not first.services.saver.problems


def test_another_frame_is_free(both, hand_on):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.services.navigator.next_frame()
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.services.state.annotation.annotated == (TOP,)


def test_a_closed_window_leaves_no_lock(both, hand_on, dataset):
    first, _ = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    assert list((dataset / ".procc" / "locks").iterdir())
    first.close()
    assert not list((dataset / ".procc" / "locks").iterdir())


def test_the_lock_of_a_killed_program_is_gone_at_once(make_window, dataset, hand_on):
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
    window = make_window(dataset)
    hand_on(window).draw(MIDDLE, (100, 100), (200, 200))
    assert window.services.state.annotation.annotated == (MIDDLE,)


def test_statuses_and_comments_of_the_other_window_arrive(both, qtbot):
    first, second = both
    first.services.review.add_comment("frame_0", "look here")
    first.services.review.database.flush(5.0)

    def arrived() -> bool:
        second.services.review.poll()
        return [c.text for c in second.services.review.comments("frame_0")] == ["look here"]

    qtbot.waitUntil(arrived)


def test_a_lock_lost_in_the_middle_of_a_gesture_costs_no_click(both, hand_on, dataset):
    first, second = both
    first.services.selection.select_class(MIDDLE)
    hand = hand_on(first)
    hand.click(100, 100)
    hand.click(200, 200)
    for lock in (dataset / ".procc" / "locks").iterdir():  # as if this machine had slept
        lock.unlink()
    assert second.services.frame_lock.acquire()
    first.services.frame_lock.beat()
    enter(first)  # the other window has the keyboard
    assert first.services.state.annotation.annotated == (MIDDLE,)
    assert (dataset / "frame_0.json").exists()


def test_a_menu_edit_keeps_what_the_other_window_clicked(both, hand_on):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.services.frame_lock.look()
    first.services.navigator.next_frame()
    second.services.frame_lock.look()
    assert second.services.state.annotation.annotated == (MIDDLE,)
    first.services.navigator.previous_frame()
    hand_on(first).draw(TOP, (100, 50), (200, 50))
    first.services.navigator.next_frame()  # the second window has not looked in between
    second.services.selection.select_class(MIDDLE)
    second.element_edits.change_class("Side line bottom")
    assert second.services.state.annotation.annotated == ("Side line bottom", TOP)


def test_a_menu_edit_of_what_the_other_window_changed_is_not_done(both, hand_on):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.services.frame_lock.look()
    first.services.navigator.next_frame()
    second.services.frame_lock.look()
    first.services.navigator.previous_frame()
    first.services.selection.select_class(MIDDLE)
    first.element_edits.change_class(TOP)
    first.services.navigator.next_frame()
    second.services.selection.select_class(MIDDLE)
    second.element_edits.reverse()
    assert second.services.state.annotation.annotated == (TOP,)
    assert "changed elsewhere" in second.status.hint.text()


def test_a_remedy_keeps_what_the_other_window_clicked(both, hand_on, qtbot):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 102), (300, 100), (400, 200), (500, 100))
    second.services.frame_lock.look()
    first.services.navigator.next_frame()
    second.services.frame_lock.look()
    check = second.services.label_check
    qtbot.waitUntil(lambda: bool(check.shown), timeout=20_000)
    found = check.shown[0]
    remedy = Remedy(RemedyKind.RELABEL, "relabel", ((MIDDLE, "Side line bottom"),))
    first.services.navigator.previous_frame()
    hand_on(first).draw(TOP, (100, 50), (200, 50))
    first.services.navigator.next_frame()
    second.label_check.apply(found, remedy)
    assert second.services.state.annotation.annotated == ("Side line bottom", TOP)
    second.services.editing.undo()
    second.services.navigator.next_frame()
    first.services.navigator.previous_frame()
    first.services.frame_lock.look()
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    first.services.navigator.next_frame()
    second.services.navigator.previous_frame()
    second.label_check.apply(found, remedy)
    assert second.services.state.annotation.get("Side line bottom") is None


def test_a_lock_to_blind_mode_reaches_a_window_that_is_worked_in(both, qtbot):
    first, second = both
    told = heard(second.services)
    first.services.blind_lock.set_locked(True)
    first.services.review.database.flush(5.0)
    review = second.services.review

    def looked() -> bool:
        review.add_comment("frame_0", "busy")  # before every look, as by a busy hand
        review.poll()
        return second.services.state.blind

    qtbot.waitUntil(looked, timeout=20_000)
    assert [text for text in told if "locked this dataset to blind mode on" in text]
    assert first.services.state.blind


def _seen_by_both(first: MainWindow, second: MainWindow, hand: Hand, frame: int = 0) -> None:
    """The first window draws an element; the second one reads it and looks no more."""
    elsewhere = 1 if frame == 0 else 0
    first.services.navigator.go_to(frame)
    hand.draw(MIDDLE, (100, 100), (150, 150), (200, 200))
    first.services.navigator.go_to(elsewhere)
    second.services.navigator.go_to(frame)
    second.services.editing.begin_edit()
    second.services.navigator.go_to(elsewhere)
    second.services.navigator.go_to(frame)
    assert second.services.state.annotation.annotated == (MIDDLE,)
    first.services.navigator.go_to(frame)


def test_a_key_on_what_is_chosen_keeps_what_the_other_window_clicked(both, hand_on, on_disk):
    first, second = both
    second.services.selection.set_mode("edit")
    for frame, key in enumerate(("Delete", "Left", "element")):
        _seen_by_both(first, second, hand_on(first), frame)
        if key == "element":
            second.services.selection.select_point(None)
            second.services.selection.select_class(MIDDLE)
        else:
            second.services.selection.select_point(MIDDLE, 1)
        before = second.services.state.annotation.get(MIDDLE)
        hand_on(first).draw(TOP, (100, 50), (200, 50))
        first.services.navigator.go_to(1 if frame == 0 else 0)
        if key == "Left":
            second.canvas.arrow(key, 1.0)
        else:
            second.canvas.key("Delete")
        assert on_disk(frame) == second.services.state.annotation.annotated
        assert TOP in on_disk(frame)
        assert second.services.state.annotation.get(MIDDLE) != before  # and it did what it is for
    assert not second.services.saver.problems


def test_a_key_on_what_the_other_window_changed_is_not_done(both, hand_on):
    first, second = both
    _seen_by_both(first, second, hand_on(first))
    second.services.selection.set_mode("edit")
    second.services.selection.select_point(MIDDLE, 2)
    first.services.selection.set_mode("edit")
    first.services.selection.select_point(MIDDLE, 0)
    first.canvas.key("Delete")
    newer = first.services.state.annotation
    first.services.navigator.next_frame()
    for _ in range(2):  # nor does the second one take the whole element for the point
        second.canvas.key("Delete")
        assert second.services.state.annotation == newer
    assert not second.services.saver.problems


def let_go(window: MainWindow) -> None:
    """The window shows the frame, does not edit it, and did not notice yet what others write."""
    window.services.navigator.next_frame()
    window.services.navigator.previous_frame()
    window.services.outside_changes.close()


def test_undo_and_redo_take_back_nothing_that_the_other_window_saved(both, hand_on, on_disk):
    first, second = both
    for frame, direction in enumerate(("undo", "redo")):
        hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
        if direction == "redo":
            hand_on(first).draw("Side line bottom", (100, 300), (200, 300))
            enter(first)  # the other window has the keyboard
            first.services.editing.undo()
        let_go(first)
        hand_on(second).draw(TOP, (100, 50), (200, 50))
        second.services.navigator.next_frame()
        getattr(first.services.editing, direction)()
        assert on_disk(frame) == first.services.state.annotation.annotated == (MIDDLE, TOP)
        assert "changed elsewhere" in first.status.hint.text()
        first.services.navigator.next_frame()


def test_undo_takes_away_what_the_other_window_saved_only_when_asked_twice(both, hand_on, on_disk):
    first, second = both
    hand_on(second).draw(MIDDLE, (100, 100), (200, 200))
    second.services.navigator.next_frame()
    hand_on(first).draw(TOP, (100, 50), (200, 50))
    second.services.navigator.previous_frame()
    first.services.navigator.next_frame()
    second.services.frame_lock.look()  # it opens by itself
    assert second.services.state.annotation.annotated == (MIDDLE, TOP)
    hand_on(second).draw("Side line bottom", (100, 300), (200, 300))
    second.services.editing.undo()
    for _ in range(2):
        second.services.editing.undo()
        assert on_disk() == (MIDDLE, TOP)
        assert "undo once more takes that away" in second.status.hint.text()
        second.services.selection.select_class("Side line bottom")
        hand_on(second).draw("Side line bottom", (100, 300), (200, 300))
        second.services.editing.undo()
    second.services.editing.undo()
    second.services.editing.undo()
    assert on_disk() == (MIDDLE,)
    second.services.editing.redo()
    assert on_disk() == (MIDDLE, TOP)


def test_nobody_commits_what_they_have_not_seen(both, hand_on):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    first.services.navigator.next_frame()
    second.services.editing.commit_frame()
    assert second.services.state.annotation.annotated == (MIDDLE,)
    assert not second.services.review.record("frame_0").committed
    second.services.editing.commit_frame()
    assert second.services.review.record("frame_0").committed


@pytest.mark.parametrize("in_the_middle", [True, False])
def test_a_lost_lock_costs_nobody_an_element(
    both, hand_on, on_disk, dataset, tmp_path, in_the_middle
):
    first, second = both
    hand = hand_on(first)
    hand.draw(MIDDLE, (100, 100), (200, 200))
    first.services.selection.select_class("Side line bottom")
    if in_the_middle:
        hand.click(100, 300)
        hand.click(200, 300)
    until_kept()
    _clear_away(dataset / ".procc" / "locks", tmp_path)  # as if it had expired in its sleep
    second.services.frame_lock.look()
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    second.services.navigator.next_frame()
    if not in_the_middle:
        hand.click(100, 300)
        hand.click(200, 300)
    enter(first)  # before the next beat
    assert TOP in on_disk()
    assert "Side line bottom" in first.services.state.annotation.annotated
    if in_the_middle:
        assert first.conflict_bar.isVisible()
    else:
        assert on_disk() == (MIDDLE, TOP, "Side line bottom")
        assert not first.services.saver.problems


def test_an_import_that_replaces_nothing_keeps_what_the_other_window_clicked(
    both, hand_on, on_disk, tmp_path, qtbot
):
    first, second = both
    first.services.navigator.next_frame()  # both frames were read while they were empty
    foreign = tmp_path / "foreign"
    foreign.mkdir()
    points = [{"x": 0.1, "y": 0.1}, {"x": 0.2, "y": 0.2}]
    for frame in (0, 1):
        hand_on(second).draw(TOP, (100, 50), (200, 50))
        second.services.navigator.next_frame()
        (foreign / f"frame_{frame}.json").write_text(json.dumps({MIDDLE: points}))
    importer = first.importer
    importer.ask()
    dialog = importer.dialog
    dialog.replace.setChecked(False)
    importer.start(foreign)
    qtbot.waitUntil(lambda: bool(dialog.report.toPlainText()))
    assert "2 frames are annotated already and left unchanged" in dialog.report.toPlainText()
    assert on_disk(0) == on_disk(1) == (TOP,)


def test_an_earlier_version_does_not_replace_what_the_other_window_just_saved(
    both, hand_on, on_disk
):
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    hand_on(first).draw("Side line bottom", (100, 300), (200, 300))
    database = first.services.review.database
    oldest = database.versions("frame_0")[-1]
    let_go(first)
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    second.services.navigator.next_frame()
    apply_version(first.services, oldest.id)
    assert TOP in on_disk()
    apply_version(first.services, oldest.id)  # now it was seen
    assert on_disk() == (MIDDLE,)
