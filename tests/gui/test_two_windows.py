"""Two windows on one dataset: who edits a frame has it, the other one is told."""

import json
from collections.abc import Callable

import pytest

from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import Hand, until_kept

OnDisk = Callable[..., tuple[str, ...]]
MIDDLE, TOP = "Middle line", "Side line top"


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
            second.canvas.keys.arrow(key, 1.0)
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
