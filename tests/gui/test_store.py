"""The store: one state, watches that are called once for all that changed."""

import gc
import weakref
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.load import load_field
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.state import State, same
from procc_annotator.gui.state.store import Store, When
from procc_annotator.metrics.setup import EvaluationSetup


@pytest.fixture
def store(qtbot) -> Store:
    return Store(State(EvaluationSetup(load_field())))


class Listener:
    """Keeps what it saw of the state whenever it was called."""

    def __init__(self, store: Store, select: Callable[[State], Any], when: When = When.NOW) -> None:
        self.heard: list[Any] = []
        self._read = lambda: select(store.state)
        store.watch(select, self.hear, when)

    def hear(self) -> None:
        self.heard.append(self._read())


def test_a_watch_is_called_for_what_it_selects_only(store):
    listener = Listener(store, lambda state: (state.tau, state.blind))
    store.update(hovered_class="Middle line")
    assert listener.heard == []
    store.update(tau=8.0)
    store.update(hovered_class=None, blind=True)
    assert listener.heard == [(8.0, False), (8.0, True)]


def test_a_watch_follows_what_its_selection_comes_to_read(store):
    listener = Listener(store, lambda state: state.tau if state.blind else state.mode)
    store.update(tau=8.0)
    assert listener.heard == []
    store.update(blind=True)
    store.update(tau=9.0)
    store.update(mode="edit")
    assert listener.heard == [8.0, 9.0]
    store.update(blind=False)
    assert listener.heard == [8.0, 9.0, "edit"]


def test_no_watch_is_called_if_nothing_differs(store):
    listener = Listener(store, lambda state: state)
    store.update(
        tau=5.0, selection=replace(store.state.selection), sources=(), committed=frozenset()
    )
    store.update(annotation=store.state.annotation)
    assert not listener.heard


def test_large_values_differ_by_identity(store):
    listener = Listener(store, lambda state: state.annotation)
    other = FrameAnnotation()
    store.update(annotation=other)
    assert len(listener.heard) == 1
    assert listener.heard[0] is other


def test_a_change_in_a_callback_is_visible_at_once_and_notified_to_all(store):
    heard: list[float] = []

    def first() -> None:
        if store.state.tau == 6.0:
            store.update(tau=7.0)
            assert store.state.tau == 7.0

    store.watch(lambda state: state.tau, first)
    store.watch(lambda state: state.tau, lambda: heard.append(store.state.tau))
    store.update(tau=6.0)
    assert heard == [7.0], "called once, with the latest state"


def test_scores_are_computed_before_any_watch_is_called(store):
    order: list[str] = []
    store.watch(lambda state: state.tau, lambda: order.append("view"))
    store.score = lambda before, after: order.append(f"score {before.tau} {after.tau}")
    store.update(tau=6.0)
    assert order == ["score 5.0 6.0", "view"]


def test_a_watch_ends_with_its_owner_and_does_not_keep_it_alive(store):
    listener = Listener(store, lambda state: state.tau)
    gone = weakref.ref(listener)
    del listener
    gc.collect()
    assert gone() is None
    store.update(tau=9.0)
    assert not store._watches


def test_values_are_the_same_by_identity_or_if_small_and_equal():
    some, other = FrameAnnotation(), FrameAnnotation()
    assert some == other
    assert not same(some, other)
    assert same((1, "a", some), (1, "a", some))
    assert not same((1, some), (1, other))
    assert not same(1, 1.0)
    assert not same((1,), (1, 2))
    assert same(None, None)


def test_blind_mode_reveals_committed_frames_only(store):
    assert store.state.reveals("a")
    assert store.state.revealed_frames is None
    store.update(blind=True, committed=frozenset({"a"}))
    assert store.state.reveals("a")
    assert not store.state.reveals("b")
    assert not store.state.projection_visible, "no frame is on screen"


def test_a_transaction_is_notified_once_at_its_end(store):
    listener = Listener(store, lambda state: (state.tau, state.blind))
    with store.transaction():
        store.update(tau=6.0)
        assert (store.state.tau, listener.heard) == (6.0, [])
        with store.transaction():
            store.update(blind=True)
        assert not listener.heard
    assert listener.heard == [(6.0, True)]


def test_messages_of_a_transaction_come_after_its_changes_in_order(store):
    order: list[str] = []
    store.watch(lambda state: state.tau, lambda: order.append("changed"))
    store.events.message.connect(lambda message: order.append(message.text))
    with store.transaction():
        say(store, "first")
        store.update(tau=6.0)
        say(store, "second")
    assert order == ["changed", "first", "second"]


def test_what_changed_before_an_error_is_notified(store):
    listener = Listener(store, lambda state: state.tau)

    def fail() -> None:
        with store.transaction():
            store.update(tau=6.0)
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail()
    assert listener.heard == [6.0]
    assert not store.busy


def test_a_gesture_is_notified_to_others_after_the_paint(store, qtbot):
    canvas = Listener(store, lambda state: state.preview, When.GESTURE)
    panel = Listener(store, lambda state: state.shown_annotation)
    moves = FrameAnnotation(), FrameAnnotation()
    for move in moves:
        store.update(preview=move)
    assert [heard is move for heard, move in zip(canvas.heard, moves, strict=True)] == [True] * 2
    assert not panel.heard
    qtbot.waitUntil(lambda: bool(panel.heard))
    assert len(panel.heard) == 1
    assert panel.heard[0] is moves[1]


def test_another_change_notifies_of_the_gesture_too(store):
    panel = Listener(store, lambda state: state.shown_annotation)
    preview = FrameAnnotation()
    store.update(preview=preview)
    store.update(tau=6.0)
    assert len(panel.heard) == 1
    assert panel.heard[0] is preview


def test_several_changes_are_one_after_the_paint(store, qtbot):
    late = Listener(store, lambda state: state.tau, When.AFTER_PAINT)
    store.update(tau=6.0)
    store.update(tau=7.0)
    assert not late.heard
    qtbot.waitUntil(lambda: bool(late.heard))
    assert late.heard == [7.0]


def test_a_callback_that_fails_keeps_no_other_from_being_called(store):
    def fail() -> None:
        store.update(blind=True)
        raise ZeroDivisionError

    store.watch(lambda state: state.tau, fail)
    others = [Listener(store, lambda s: s.tau), Listener(store, lambda s: s.blind)]
    with pytest.raises(ZeroDivisionError):
        store.update(tau=6.0)
    assert [other.heard for other in others] == [[6.0], [True]]
    assert not store.busy
