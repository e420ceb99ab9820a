"""What a hand decided of ghosts is kept, or it is said that it is not; and nothing else happens."""

import threading
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from procc_annotator.assist.ghost_points import GhostPoints, find_points
from procc_annotator.dataset.editing import delete_point
from procc_annotator.gui.commands import ghost_accepting
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.prediction import ghosts as ghosts_module
from procc_annotator.interaction.overlay_predictions import ghost_extent
from tests.gui.conftest import KEPT, Hand, let_work_end, wait_for_ghosts

SHIFT = Qt.KeyboardModifier.ShiftModifier
CTRL = Qt.KeyboardModifier.ControlModifier
Key = Qt.Key


@pytest.fixture
def hand(begun, hand_on) -> Hand:
    return hand_on(begun)


@pytest.fixture
def go_on(monkeypatch) -> threading.Event:
    """The searches along ghosts wait for this."""
    event = threading.Event()

    def slow(*terms: Any) -> GhostPoints:
        assert event.wait(20)
        return find_points(*terms)

    for module in (ghosts_module, ghost_accepting):
        monkeypatch.setattr(module, "find_points", slow)
    return event


@pytest.fixture
def patient(monkeypatch) -> None:
    """However busy the machine is, the search ends in time."""
    monkeypatch.setattr(ghost_accepting, "_MOST_WAIT_S", 20.0)


def current(window: MainWindow) -> str | None:
    ghost = window.services.ghosts.current
    return ghost.name if ghost is not None else None


def names(window: MainWindow) -> list[str]:
    return [ghost.name for ghost in window.services.ghosts.known]


def find(window: MainWindow, qtbot: QtBot) -> None:
    """Wait for the points of the current ghost."""
    ghosts = window.services.ghosts
    qtbot.waitUntil(lambda: ghosts.found(current(window)) is not None)


@pytest.mark.usefixtures("patient")
class TestLeaving:
    def test_all_accepted_and_left_at_once(self, begun, hand, told):
        services = begun.services
        hand.key(Key.Key_Return, SHIFT)
        assert services.state.annotation.annotated == KEPT
        hand.key(Key.Key_A)
        assert services.state.frame.name == "00001"
        done = services.state.workspace.read(1)
        assert len(done.annotated) >= len(KEPT) + 4
        assert any(t.startswith("accepted ") and "on 00002" in t for t in told)
        hand.key(Key.Key_D)
        hand.key(Key.Key_Z, CTRL)
        assert services.state.annotation.annotated == KEPT

    def test_one_accepted_and_left_at_once(self, begun, hand, told):
        services = begun.services
        hand.key(Key.Key_Tab)
        name = current(begun)
        hand.key(Key.Key_Return)
        hand.key(Key.Key_A)
        assert services.state.workspace.read(1).get(name) is not None
        assert f"accepted {services.state.field.title_of(name)} on 00002" in told[-1]

    def test_what_takes_too_long_is_said_to_be_dropped(
        self, begun, hand, qtbot, told, go_on, monkeypatch
    ):
        monkeypatch.setattr(ghost_accepting, "_MOST_WAIT_S", 0.01)
        hand.key(Key.Key_Return, SHIFT)
        hand.key(Key.Key_A)
        assert told[-1] == ("no ghost was accepted: looking for the line on 00002 took too long")
        go_on.set()
        let_work_end(qtbot)
        assert begun.services.state.workspace.read(1).annotated == KEPT

    def test_tab_goes_on_once_it_is_accepted(self, begun, hand):
        hand.key(Key.Key_Tab)
        name = current(begun)
        hand.key(Key.Key_Return)
        hand.key(Key.Key_Tab)
        assert begun.services.state.annotation.get(name) is not None


def test_undo_takes_back_what_is_waited_for_and_nothing_else(begun, hand, qtbot, told, go_on):
    services = begun.services
    services.editing.commit_edit("shorten", delete_point(services.state.annotation, KEPT[3], 0))
    shortened = services.state.annotation
    wait_for_ghosts(begun, qtbot)
    hand.key(Key.Key_Return, SHIFT)
    hand.key(Key.Key_Z, CTRL)
    assert told[-1] == "no ghost was accepted: taken back"
    go_on.set()
    let_work_end(qtbot)
    assert services.state.annotation is shortened
    hand.key(Key.Key_Z, CTRL)
    assert services.state.annotation is not shortened


def test_a_ghost_that_is_drawn_by_hand_after_all_is_not_accepted_as_well(
    begun, hand, qtbot, told, go_on
):
    services = begun.services
    hand.key(Key.Key_Tab)
    name = current(begun)
    left, top, right, bottom = ghost_extent(services.ghosts.current)
    hand.key(Key.Key_Return)
    hand.click(left, top)
    assert "is not accepted: it is being drawn by hand" in told[-1]
    hand.click(right, bottom)
    go_on.set()
    hand.key(Key.Key_Return)
    let_work_end(qtbot)
    assert len(services.state.annotation.get(name).points) == 2


def test_what_is_accepted_is_done_and_the_next_click_does_not_continue_it(begun, hand, qtbot, told):
    services = begun.services
    services.selection.select_class("Middle line")
    hand.key(Key.Key_Tab)
    find(begun, qtbot)
    name = current(begun)
    hand.key(Key.Key_Return)
    count = len(services.state.annotation.get(name).points)
    assert services.state.selected_class != name
    assert begun.canvas.hint.startswith("GHOST the next one comes in a moment")
    hand.key(Key.Key_Period)  # there is no ghost yet that it could mean
    assert told[-1] == "the camera is being fitted: ghosts come in a moment"
    assert not services.review.not_visible("00002")
    hand.click(700, 400)
    hand.key(Key.Key_Return)
    assert len(services.state.annotation.get(name).points) == count


def test_chosen_in_the_list_and_accepted_with_all_others(begun, hand, qtbot):
    services = begun.services
    name = names(begun)[0]
    services.selection.select_class(name)
    hand.key(Key.Key_Return, SHIFT)
    qtbot.waitUntil(lambda: services.state.annotation.get(name) is not None)
    assert services.state.selected_class is None


class TestTab:
    """It never throws the keyboard out of the picture, and says why there is nothing to go to."""

    def says(self, window: MainWindow, hand: Hand, told: list[str]) -> str:
        frame = window.services.state.frame_index
        for _ in range(3):
            hand.key(Key.Key_Tab)
            assert QApplication.focusWidget() is window.canvas
        assert window.services.state.frame_index == frame
        return told[-1]

    def test_in_blind_mode(self, begun, hand, told):
        hand.key(Key.Key_B)
        assert "no ghosts: blind" in self.says(begun, hand, told)
        begun.services.selection.select_class(None)
        hand.key(Key.Key_Period)
        assert told[-1].startswith("no ghosts: blind")
        assert "choose an element first" in told[-1]

    def test_in_a_dataset_that_is_locked_to_it(self, begun, hand, told):
        """Neither committing the frame nor the live fit's key brings any."""
        begun.services.blind_lock.set_locked(True)
        said = self.says(begun, hand, told)
        assert said.startswith("no ghosts: ")
        assert "locked this dataset to blind mode" in said

    def test_switched_off(self, begun, hand, told):
        begun.actions_["ghosts"].trigger()
        assert "they are switched off" in self.says(begun, hand, told)

    def test_without_the_live_fit(self, begun, hand, told):
        hand.key(Key.Key_T, CTRL)
        assert "the live fit is off (Ctrl+T)" in self.says(begun, hand, told)

    def test_another_key_takes_the_keyboard_to_the_panels(self, begun, hand):
        hand.key(Key.Key_Tab, CTRL)
        assert QApplication.focusWidget() is not begun.canvas

    def test_in_the_list_of_frames_it_leaves_the_list(self, begun):
        frames = begun.frames.list
        frames.setFocus()
        QTest.keyClick(frames, Key.Key_Tab)
        assert QApplication.focusWidget() is not frames
        assert begun.services.state.frame_index == 1


def test_nothing_is_accepted_that_is_hidden(begun, hand, qtbot, told):
    hand.key(Key.Key_Tab)
    find(begun, qtbot)
    hand.key(Key.Key_H, CTRL)
    for shift in (Qt.KeyboardModifier.NoModifier, SHIFT):
        hand.key(Key.Key_Return, shift)
        assert told[-1].startswith("overlays are hidden")
    hand.key(Key.Key_H, CTRL)
    QTest.keyPress(begun.canvas, Key.Key_X)
    hand.key(Key.Key_Return)
    QTest.keyRelease(begun.canvas, Key.Key_X)
    let_work_end(qtbot)
    assert begun.services.state.annotation.annotated == KEPT


def test_a_walk_left_goes_on_where_the_status_bar_says(begun, hand):
    hand.key(Key.Key_Tab)
    hand.key(Key.Key_Escape)
    assert f"Tab: next of {len(names(begun))} ghosts" in begun.canvas.hint
    for _ in names(begun)[1:]:
        hand.key(Key.Key_Tab)
    hand.key(Key.Key_Escape)
    assert f"Tab: first of {len(names(begun))} ghosts" in begun.canvas.hint
    hand.key(Key.Key_Tab)
    assert current(begun) == names(begun)[0]


class TestReadOnly:
    @pytest.fixture
    def second(self, begun, make_window, annotated, qtbot, told) -> MainWindow:
        """Another window on the frame, which the first one has."""
        first = begun.services
        first.frame_lock.set_dataset(annotated, "Ada")
        first.frame_lock.enter("00002")
        assert first.editing.begin_edit()
        second = make_window(annotated)
        second.services.frame_lock.set_dataset(annotated, "Ben")
        second.services.navigator.go_to(0)
        second.services.navigator.go_to(1)
        second.services.frame_lock.look()
        assert "Ada" in second.services.state.why_not_editable
        wait_for_ghosts(second, qtbot)
        told.clear()
        second.services.store.events.message.connect(lambda m: told.append(m.text))
        return second

    def test_ghosts_can_be_looked_at_but_nothing_is_written(
        self, second, hand_on, qtbot, told, annotated
    ):
        hand, services = hand_on(second), second.services
        hand.key(Key.Key_Tab)
        find(second, qtbot)
        assert "Enter" not in second.canvas.hint
        for key, modifier in (
            (Key.Key_Period, Qt.KeyboardModifier.NoModifier),
            (Key.Key_Return, Qt.KeyboardModifier.NoModifier),
            (Key.Key_Return, SHIFT),
            (Key.Key_T, CTRL | SHIFT),
        ):
            told.clear()
            hand.key(key, modifier)
            assert "Ada" in told[-1], key
        let_work_end(qtbot)
        assert not services.review.not_visible("00002")
        assert services.state.annotation.annotated == KEPT
        assert not (annotated / "cameras" / "fitted").exists()


def test_accepting_all_says_why_there_is_nothing_to_accept(window, hand_on, qtbot):
    """A frame without clicks has no camera, hence no ghosts; nor is one found in its picture."""
    services = window.services
    qtbot.waitUntil(lambda: not services.live_fit.working and not services.proposals.working)
    assert not window.services.ghosts.painted
    hand_on(window).key(Key.Key_Return, SHIFT)
    told = window.status.hint.text()
    assert "no camera is known; draw 3 elements, two of which meet, such as Far touchline" in told
