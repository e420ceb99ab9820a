"""The store: one state, one signal, every step told in order."""

from __future__ import annotations

import gc
import weakref
from dataclasses import replace
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.load import load_field
from procc_annotator.gui.state.saying import say
from procc_annotator.gui.state.state import State, same
from procc_annotator.gui.state.store import Store
from procc_annotator.metrics.setup import EvaluationSetup


@pytest.fixture
def store(qtbot: QtBot) -> Store:
    return Store(State(EvaluationSetup(load_field())))


class Listener:
    """Keeps what it was told."""

    def __init__(self) -> None:
        self.heard: list[Any] = []

    def hear(self, told: Any) -> None:
        self.heard.append(told)


def test_a_change_is_told_with_the_state_before_and_after(store: Store) -> None:
    told: list[tuple[State, State]] = []
    store.changed.connect(lambda before, after: told.append((before, after)))
    before = store.state
    store.set(tau=7.0, blind=True)
    assert told == [(before, store.state)]
    assert (before.tau, before.blind) == (5.0, False)
    assert (store.state.tau, store.state.blind) == (7.0, True)


def test_nothing_is_told_where_nothing_differs(store: Store) -> None:
    told: list[object] = []
    store.changed.connect(lambda *states: told.append(states))
    store.set(tau=5.0, selection=replace(store.state.selection), sources=(), committed=frozenset())
    store.set(annotation=store.state.annotation)
    assert not told


def test_large_values_differ_by_identity(store: Store) -> None:
    listener = Listener()
    store.watch(lambda state: state.annotation, listener.hear)
    other = FrameAnnotation()
    store.set(annotation=other)
    assert len(listener.heard) == 1
    assert listener.heard[0] is other


def test_a_change_within_a_change_is_there_at_once_and_told_afterwards(store: Store) -> None:
    steps: list[tuple[str, float]] = []

    def first(_: State, after: State) -> None:
        steps.append(("first", after.tau))
        if after.tau == 6.0:
            store.set(tau=7.0)
            assert store.state.tau == 7.0

    store.changed.connect(first)
    store.changed.connect(lambda _, after: steps.append(("second", after.tau)))
    store.set(tau=6.0)
    assert steps == [("first", 6.0), ("second", 6.0), ("first", 7.0), ("second", 7.0)]


def test_a_watch_hears_only_what_it_selects(store: Store) -> None:
    listener = Listener()
    store.watch(lambda state: (state.tau, state.blind), listener.hear)
    store.set(hovered_class="Middle line")
    assert listener.heard == []
    store.set(tau=8.0)
    store.set(hovered_class=None, blind=True)
    assert listener.heard == [(8.0, False), (8.0, True)]


def test_a_watch_ends_with_its_owner_and_keeps_it_not_alive(store: Store) -> None:
    listener = Listener()
    store.watch(lambda state: state.tau, listener.hear)
    gone = weakref.ref(listener)
    del listener
    gc.collect()
    assert gone() is None
    store.set(tau=9.0)
    assert not store._watches


def test_values_are_the_same_by_identity_or_if_small_and_equal() -> None:
    some, other = FrameAnnotation(), FrameAnnotation()
    assert some == other
    assert not same(some, other)
    assert same((1, "a", some), (1, "a", some))
    assert not same((1, some), (1, other))
    assert not same(1, 1.0)
    assert not same((1,), (1, 2))
    assert same(None, None)


def test_blind_mode_reveals_committed_frames_only(store: Store) -> None:
    assert store.state.reveals("a")
    assert store.state.revealed_frames is None
    store.set(blind=True, committed=frozenset({"a"}))
    assert store.state.reveals("a")
    assert not store.state.reveals("b")
    assert not store.state.projection_visible, "no frame is on screen"


def test_what_changes_together_is_one_step_and_there_at_once(store: Store) -> None:
    steps: list[tuple[State, State]] = []
    store.changed.connect(lambda before, after: steps.append((before, after)))
    before = store.state
    with store.together():
        store.set(tau=6.0)
        assert (store.state.tau, steps) == (6.0, [])
        with store.together():  # of the one around it
            store.set(blind=True)
        assert not steps
    assert steps == [(before, store.state)]
    assert (store.state.tau, store.state.blind) == (6.0, True)


def test_each_line_that_is_said_together_is_told(store: Store) -> None:
    said: list[str] = []
    store.changed.connect(lambda _, after: said.append(after.told.text))
    with store.together():
        say(store, "first")
        store.set(tau=6.0)
        say(store, "second")
    assert said == ["first", "second"]


def test_what_changed_before_an_error_is_told(store: Store) -> None:
    listener = Listener()
    store.watch(lambda state: state.tau, listener.hear)

    def fail() -> None:
        with store.together():
            store.set(tau=6.0)
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        fail()
    assert listener.heard == [6.0]
    assert not store.busy


def test_a_watch_hears_once_of_steps_that_follow_from_one_another(store: Store) -> None:
    listener = Listener()
    rested: list[float] = []
    store.watch(lambda state: state.tau, listener.hear)
    store.changed.connect(lambda _, after: store.set(tau=7.0) if after.tau == 6.0 else None)
    store.rested.connect(lambda: rested.append(store.state.tau))
    store.set(tau=6.0)
    assert listener.heard == rested == [7.0]


def test_of_what_a_hand_carries_a_watch_hears_after_the_paint(store: Store, qtbot: QtBot) -> None:
    carried, listener = Listener(), Listener()
    store.changed.connect(lambda _, after: carried.hear(after.preview))
    store.watch(lambda state: state.shown_annotation, listener.hear)
    moves = FrameAnnotation(), FrameAnnotation()
    for move in moves:
        store.set(preview=move)
    assert [heard is move for heard, move in zip(carried.heard, moves, strict=True)] == [True] * 2
    assert not listener.heard
    qtbot.waitUntil(lambda: bool(listener.heard))
    assert len(listener.heard) == 1
    assert listener.heard[0] is moves[1]


def test_whatever_else_changes_tells_of_what_is_carried_too(store: Store) -> None:
    listener = Listener()
    store.watch(lambda state: state.shown_annotation, listener.hear)
    preview = FrameAnnotation()
    store.set(preview=preview)
    store.set(tau=6.0)
    assert len(listener.heard) == 1
    assert listener.heard[0] is preview


def test_whoever_fails_keeps_nobody_else_from_hearing(store: Store) -> None:
    listener, rested = Listener(), Listener()

    def fail(tau: float) -> None:
        store.set(blind=True)
        raise ZeroDivisionError

    store.watch(lambda state: state.tau, fail)
    store.watch(lambda state: state.tau, listener.hear)
    store.watch(lambda state: state.blind, listener.hear)
    store.rested.connect(lambda: rested.hear(store.state.tau))
    with pytest.raises(ZeroDivisionError):
        store.set(tau=6.0)
    assert listener.heard == [6.0, True]
    assert rested.heard == [6.0]
    assert not store.busy
