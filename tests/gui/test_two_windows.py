"""Two windows on one dataset: who edits a frame has it, the other one is told."""

from __future__ import annotations

import json
import subprocess
import sys
import textwrap
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import Point, Polyline
from procc_annotator.calibration.label_check.finding import Remedy, RemedyKind
from procc_annotator.gui.commands.review.versions import apply_version
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import until_kept

if TYPE_CHECKING:
    from tests.gui.conftest import Hand, MakeWindow

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)

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
def both(make_window: MakeWindow, dataset: Path) -> tuple[MainWindow, MainWindow]:
    first, second = make_window(dataset), make_window(dataset)
    first.document.set_author("Ada")
    first.document.presence.set_dataset(dataset, "Ada")
    first.document.presence.enter("frame_0")
    return first, second


@pytest.fixture
def on_disk(dataset: Path) -> OnDisk:
    """The classes that a frame's file holds, the first one's unless told otherwise."""

    def read(frame: int = 0) -> tuple[str, ...]:
        until_kept()
        return tuple(json.loads((dataset / f"frame_{frame}.json").read_text()))

    return read


def test_the_second_window_sees_who_is_editing_and_cannot_click(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.document.presence.look()
    assert not second.document.state.editable
    assert "Ada" in second.frame_bar.label.text()
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.document.state.annotation.get(TOP) is None
    assert not second.canvas.editor.drawing


def test_an_edit_that_finds_the_lock_free_again_opens_the_frame(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.document.presence.look()
    first.document.presence.close()
    annotation = second.document.state.annotation
    moved = annotation.with_polyline(Polyline(TOP, (Point(0.1, 0.1), Point(0.3, 0.1))))
    assert second.document.editing.commit_edit("late", moved)  # of a gesture that had begun before
    assert second.document.state.editable
    assert second.frame_bar.isHidden()


def test_who_looks_only_blocks_nobody(both: tuple[MainWindow, MainWindow], hand_on: HandOn) -> None:
    _, second = both
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.document.state.annotation.get(TOP) is not None


def test_a_click_that_comes_second_is_refused_before_anything_is_drawn(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    first.document.selecting.select_class(MIDDLE)
    hand_on(first).click(100, 100)  # not finished, nothing saved yet
    second.document.selecting.select_class(TOP)
    hand_on(second).click(100, 50)
    assert not second.canvas.editor.drawing
    assert "Ada" in second.message_bar.label.text()


def test_it_opens_by_itself_with_the_newer_file_once_the_other_leaves(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.document.presence.look()
    first.document.walk.next_frame()
    second.document.presence.look()
    assert second.document.state.editable
    assert second.document.state.annotation.annotated == (MIDDLE,)
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.document.state.annotation.annotated == (MIDDLE, TOP)
    assert not second.document.saver.problems


def test_a_frame_edited_elsewhere_meanwhile_is_read_again_before_the_first_click(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    first.document.walk.next_frame()  # the second window has not looked in between
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.document.state.annotation.annotated == (MIDDLE, TOP)


def test_a_lock_that_was_cleared_away_is_taken_again(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, dataset: Path, tmp_path: Path
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    enter(first)
    _clear_away(dataset / ".procc", tmp_path)
    first.document.presence.beat()
    second.document.presence.look()
    assert not second.document.state.editable
    _clear_away(dataset / ".procc" / "locks", tmp_path)
    hand_on(first).draw(TOP, (100, 50), (200, 50))  # before the next beat
    enter(first)
    second.document.presence.look()
    assert not second.document.state.editable


def test_a_frame_somebody_else_had_meanwhile_is_read_again(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, dataset: Path, tmp_path: Path
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    enter(first)
    _clear_away(
        dataset / ".procc" / "locks", tmp_path
    )  # as if it had expired while the first one slept
    second.document.presence.look()
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    second.document.walk.next_frame()
    first.document.presence.beat()
    assert first.document.state.annotation.annotated == (MIDDLE, TOP)
    assert not first.document.saver.problems


def test_another_frame_is_free(both: tuple[MainWindow, MainWindow], hand_on: HandOn) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.document.walk.next_frame()
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    assert second.document.state.annotation.annotated == (TOP,)


def test_a_closed_window_leaves_no_lock(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, dataset: Path
) -> None:
    first, _ = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    assert list((dataset / ".procc" / "locks").iterdir())
    first.close()
    assert not list((dataset / ".procc" / "locks").iterdir())


def test_the_lock_of_a_killed_program_is_gone_at_once(
    make_window: MakeWindow, dataset: Path, hand_on: HandOn
) -> None:
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
    assert window.document.state.annotation.annotated == (MIDDLE,)


def test_statuses_and_comments_of_the_other_window_arrive(
    both: tuple[MainWindow, MainWindow], qtbot: QtBot
) -> None:
    first, second = both
    first.document.review.add_comment("frame_0", "look here")
    assert first.document.review.database is not None
    first.document.review.database.flush(5.0)

    def arrived() -> bool:
        second.document.review.poll()
        return [c.text for c in second.document.review.comments("frame_0")] == ["look here"]

    qtbot.waitUntil(arrived)


def test_a_lock_lost_in_the_middle_of_a_gesture_costs_no_click(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, dataset: Path
) -> None:
    first, second = both
    first.document.selecting.select_class(MIDDLE)
    hand = hand_on(first)
    hand.click(100, 100)
    hand.click(200, 200)
    for lock in (dataset / ".procc" / "locks").iterdir():  # as if this machine had slept
        lock.unlink()
    assert second.document.presence.acquire()
    first.document.presence.beat()
    enter(first)  # the other window has the keyboard
    assert first.document.state.annotation.annotated == (MIDDLE,)
    assert (dataset / "frame_0.json").exists()


def test_a_menu_edit_keeps_what_the_other_window_clicked(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.document.presence.look()
    first.document.walk.next_frame()
    second.document.presence.look()
    assert second.document.state.annotation.annotated == (MIDDLE,)
    first.document.walk.previous_frame()
    hand_on(first).draw(TOP, (100, 50), (200, 50))
    first.document.walk.next_frame()  # the second window has not looked in between
    second.document.selecting.select_class(MIDDLE)
    second.element_edits.change_class("Side line bottom")
    assert second.document.state.annotation.annotated == ("Side line bottom", TOP)


def test_a_menu_edit_of_what_the_other_window_changed_is_not_done(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    second.document.presence.look()
    first.document.walk.next_frame()
    second.document.presence.look()
    first.document.walk.previous_frame()
    first.document.selecting.select_class(MIDDLE)
    first.element_edits.change_class(TOP)
    first.document.walk.next_frame()
    second.document.selecting.select_class(MIDDLE)
    second.element_edits.reverse()
    assert second.document.state.annotation.annotated == (TOP,)
    assert "changed elsewhere" in second.status.hint.text()


def test_a_remedy_keeps_what_the_other_window_clicked(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, qtbot: QtBot
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 102), (300, 100), (400, 200), (500, 100))
    second.document.presence.look()
    first.document.walk.next_frame()
    second.document.presence.look()
    check = second.document.label_check
    qtbot.waitUntil(lambda: bool(check.shown), timeout=20_000)
    found = check.shown[0]
    remedy = Remedy(RemedyKind.RELABEL, "relabel", ((MIDDLE, "Side line bottom"),))
    first.document.walk.previous_frame()
    hand_on(first).draw(TOP, (100, 50), (200, 50))
    first.document.walk.next_frame()
    second.label_check.apply(found, remedy)
    assert second.document.state.annotation.annotated == ("Side line bottom", TOP)
    second.document.editing.undo()
    second.document.walk.next_frame()
    first.document.walk.previous_frame()
    first.document.presence.look()
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    first.document.walk.next_frame()
    second.document.walk.previous_frame()
    second.label_check.apply(found, remedy)
    assert second.document.state.annotation.get("Side line bottom") is None


def test_a_lock_to_blind_mode_reaches_a_window_that_is_worked_in(
    both: tuple[MainWindow, MainWindow], qtbot: QtBot
) -> None:
    first, second = both
    told: list[str] = []
    second.document.store.events.message.connect(lambda m: told.append(m.text))
    first.document.blind_lock.set_locked(True)
    assert first.document.review.database is not None
    first.document.review.database.flush(5.0)
    review = second.document.review

    def looked() -> bool:
        review.add_comment("frame_0", "busy")  # before every look, as by a busy hand
        review.poll()
        return second.document.state.blind

    qtbot.waitUntil(looked, timeout=20_000)
    assert [text for text in told if "locked this dataset to blind mode on" in text]
    assert first.document.state.blind


def _seen_by_both(first: MainWindow, second: MainWindow, hand: Hand, frame: int = 0) -> None:
    """The first window draws an element; the second one reads it and looks no more."""
    elsewhere = 1 if frame == 0 else 0
    first.document.walk.go_to(frame)
    hand.draw(MIDDLE, (100, 100), (150, 150), (200, 200))
    first.document.walk.go_to(elsewhere)
    second.document.walk.go_to(frame)
    second.document.editing.begin_edit()
    second.document.walk.go_to(elsewhere)
    second.document.walk.go_to(frame)
    assert second.document.state.annotation.annotated == (MIDDLE,)
    first.document.walk.go_to(frame)


def test_a_key_on_what_is_chosen_keeps_what_the_other_window_clicked(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, on_disk: OnDisk
) -> None:
    first, second = both
    second.document.selecting.set_mode("edit")
    for frame, key in enumerate(("Delete", "Left", "element")):
        _seen_by_both(first, second, hand_on(first), frame)
        if key == "element":
            second.document.selecting.select_point(None)
            second.document.selecting.select_class(MIDDLE)
        else:
            second.document.selecting.select_point(MIDDLE, 1)
        before = second.document.state.annotation.get(MIDDLE)
        hand_on(first).draw(TOP, (100, 50), (200, 50))
        first.document.walk.go_to(1 if frame == 0 else 0)
        if key == "Left":
            second.canvas.arrow(key, 1.0)
        else:
            second.canvas.key("Delete")
        assert on_disk(frame) == second.document.state.annotation.annotated
        assert TOP in on_disk(frame)
        assert second.document.state.annotation.get(MIDDLE) != before  # and it did what it is for
    assert not second.document.saver.problems


def test_a_key_on_what_the_other_window_changed_is_not_done(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    _seen_by_both(first, second, hand_on(first))
    second.document.selecting.set_mode("edit")
    second.document.selecting.select_point(MIDDLE, 2)
    first.document.selecting.set_mode("edit")
    first.document.selecting.select_point(MIDDLE, 0)
    first.canvas.key("Delete")
    newer = first.document.state.annotation
    first.document.walk.next_frame()
    for _ in range(2):  # nor does the second one take the whole element for the point
        second.canvas.key("Delete")
        assert second.document.state.annotation == newer
    assert not second.document.saver.problems


def let_go(window: MainWindow) -> None:
    """The window shows the frame, does not edit it, and did not notice yet what others write."""
    window.document.walk.next_frame()
    window.document.walk.previous_frame()
    window.document.outside.close()


def test_undo_and_redo_take_back_nothing_that_the_other_window_saved(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, on_disk: OnDisk
) -> None:
    first, second = both
    for frame, direction in enumerate(("undo", "redo")):
        hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
        if direction == "redo":
            hand_on(first).draw("Side line bottom", (100, 300), (200, 300))
            enter(first)  # the other window has the keyboard
            first.document.editing.undo()
        let_go(first)
        hand_on(second).draw(TOP, (100, 50), (200, 50))
        second.document.walk.next_frame()
        getattr(first.document.editing, direction)()
        assert on_disk(frame) == first.document.state.annotation.annotated == (MIDDLE, TOP)
        assert "changed elsewhere" in first.status.hint.text()
        first.document.walk.next_frame()


def test_undo_takes_away_what_the_other_window_saved_only_when_asked_twice(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, on_disk: OnDisk
) -> None:
    first, second = both
    hand_on(second).draw(MIDDLE, (100, 100), (200, 200))
    second.document.walk.next_frame()
    hand_on(first).draw(TOP, (100, 50), (200, 50))
    second.document.walk.previous_frame()
    first.document.walk.next_frame()
    second.document.presence.look()  # it opens by itself
    assert second.document.state.annotation.annotated == (MIDDLE, TOP)
    hand_on(second).draw("Side line bottom", (100, 300), (200, 300))
    second.document.editing.undo()
    for _ in range(2):
        second.document.editing.undo()
        assert on_disk() == (MIDDLE, TOP)
        assert "undo once more takes that away" in second.status.hint.text()
        second.document.selecting.select_class("Side line bottom")
        hand_on(second).draw("Side line bottom", (100, 300), (200, 300))
        second.document.editing.undo()
    second.document.editing.undo()
    second.document.editing.undo()
    assert on_disk() == (MIDDLE,)
    second.document.editing.redo()
    assert on_disk() == (MIDDLE, TOP)


def test_nobody_commits_what_they_have_not_seen(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    first.document.walk.next_frame()
    second.document.editing.commit_frame()
    assert second.document.state.annotation.annotated == (MIDDLE,)
    assert not second.document.review.record("frame_0").committed
    second.document.editing.commit_frame()
    assert second.document.review.record("frame_0").committed


@pytest.mark.parametrize("in_the_middle", [True, False])
def test_a_lost_lock_costs_nobody_an_element(
    both: tuple[MainWindow, MainWindow],
    hand_on: HandOn,
    on_disk: OnDisk,
    dataset: Path,
    tmp_path: Path,
    in_the_middle: bool,
) -> None:
    first, second = both
    hand = hand_on(first)
    hand.draw(MIDDLE, (100, 100), (200, 200))
    first.document.selecting.select_class("Side line bottom")
    if in_the_middle:
        hand.click(100, 300)
        hand.click(200, 300)
    until_kept()
    _clear_away(dataset / ".procc" / "locks", tmp_path)  # as if it had expired in its sleep
    second.document.presence.look()
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    second.document.walk.next_frame()
    if not in_the_middle:
        hand.click(100, 300)
        hand.click(200, 300)
    enter(first)  # before the next beat
    assert TOP in on_disk()
    assert "Side line bottom" in first.document.state.annotation.annotated
    if in_the_middle:
        assert first.conflict_bar.isVisible()
    else:
        assert on_disk() == (MIDDLE, TOP, "Side line bottom")
        assert not first.document.saver.problems


def test_an_import_that_replaces_nothing_keeps_what_the_other_window_clicked(
    both: tuple[MainWindow, MainWindow],
    hand_on: HandOn,
    on_disk: OnDisk,
    tmp_path: Path,
    qtbot: QtBot,
) -> None:
    first, second = both
    first.document.walk.next_frame()  # both frames were read while they were empty
    foreign = tmp_path / "foreign"
    foreign.mkdir()
    points = [{"x": 0.1, "y": 0.1}, {"x": 0.2, "y": 0.2}]
    for frame in (0, 1):
        hand_on(second).draw(TOP, (100, 50), (200, 50))
        second.document.walk.next_frame()
        (foreign / f"frame_{frame}.json").write_text(json.dumps({MIDDLE: points}))
    importer = first.importer
    importer.ask()
    dialog = importer.dialog
    assert dialog is not None
    dialog.replace.setChecked(False)
    importer.start(foreign)
    qtbot.waitUntil(lambda: bool(dialog.report.toPlainText()))
    assert "2 frames are annotated already and left unchanged" in dialog.report.toPlainText()
    assert on_disk(0) == on_disk(1) == (TOP,)


def test_an_earlier_version_does_not_replace_what_the_other_window_just_saved(
    both: tuple[MainWindow, MainWindow], hand_on: HandOn, on_disk: OnDisk
) -> None:
    first, second = both
    hand_on(first).draw(MIDDLE, (100, 100), (200, 200))
    hand_on(first).draw("Side line bottom", (100, 300), (200, 300))
    database = first.document.review.database
    assert database is not None
    oldest = database.versions("frame_0")[-1]
    let_go(first)
    hand_on(second).draw(TOP, (100, 50), (200, 50))
    second.document.walk.next_frame()
    apply_version(first.document, oldest.id)
    assert TOP in on_disk()
    apply_version(first.document, oldest.id)  # now it was seen
    assert on_disk() == (MIDDLE,)
