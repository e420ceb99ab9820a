"""Computed values: of the present inputs or none, computed and signalled once, stopped in time."""

import gc
import sys
import threading
import weakref
from collections.abc import Callable
from typing import Any

import pytest
from PySide6.QtCore import QEvent, QObject, Signal
from PySide6.QtWidgets import QApplication, QWidget

from procc_annotator.errors import UsageError
from procc_annotator.gui.state.background import ComputedValue, Stopped
from tests.gui.conftest import let_work_end


class Number(QObject):
    """Something that values follow from."""

    changed = Signal()

    def __init__(self, value: object = 1) -> None:
        super().__init__()
        self.value = value

    def set(self, value: object) -> None:
        self.value = value
        self.changed.emit()

    def inputs(self) -> tuple[object, ...] | None:
        return None if self.value is None else (self.value,)


class Gate:
    """A computation that waits to be let go on."""

    def __init__(self) -> None:
        self.begun, self.go = threading.Event(), threading.Event()
        self.asked: list[object] = []

    def __call__(self, value: int) -> int:
        self.asked.append(value)
        self.begun.set()
        assert self.go.wait(20)
        return 10 * value


def counted(signal: Any) -> list[tuple[object, ...]]:
    """What a signal says from now on."""
    said: list[tuple[object, ...]] = []
    signal.connect(lambda *given: said.append(given))
    return said


def derived(
    number: Number, compute: Callable[..., Any], background: bool = True, **more: Any
) -> ComputedValue[Any]:
    value = ComputedValue(number.inputs, compute, background=background, **more)
    number.changed.connect(value.invalidate)
    value.invalidate()
    return value


def test_at_once_it_is_worked_out_when_asked_for_and_once(qtbot):
    number, asked = Number(), []
    value = derived(number, lambda n: asked.append(n) or 10 * n, background=False)
    said = counted(value.changed)
    assert asked == []
    assert (value.value, value.value, asked) == (10, 10, [1])
    number.changed.emit()
    assert said == []
    number.set(2)
    assert (len(said), asked) == (1, [1])
    assert (value.value, asked) == (20, [1, 2])


def test_objects_are_told_apart_by_what_they_are_not_by_what_is_in_them(qtbot):
    number, asked = Number([1]), []
    value = derived(number, lambda n: asked.append(n) or len(n), background=False)
    assert value.value == 1
    number.set([1])
    assert value.value == 1
    assert len(asked) == 2
    for plain in (("a", (1, 2.0)), ("a", (1, 2.0)), ["other"], frozenset("ab"), frozenset("ab")):
        number.set(plain)
        assert value.value == len(plain)
    assert len(asked) == 5


def test_beside_it_comes_once_it_is_known(qtbot):
    number, threads = Number(), set()
    value = derived(number, lambda n: threads.add(threading.get_ident()) or 10 * n)
    said = counted(value.changed)
    assert (value.value, value.working) == (None, True)
    qtbot.waitUntil(lambda: value.value == 10)
    assert (value.working, len(said)) == (False, 1)
    assert threading.get_ident() not in threads
    number.changed.emit()
    assert (value.value, len(said)) == (10, 1)


def test_a_stale_answer_is_never_shown(qtbot):
    number, gate = Number(), Gate()
    value = derived(number, gate)
    shown: list[object] = []
    value.changed.connect(lambda: shown.append(value.value))
    qtbot.waitUntil(gate.begun.is_set)
    number.set(2)
    number.set(3)
    gate.go.set()
    qtbot.waitUntil(lambda: value.value == 30)
    assert gate.asked == [1, 3]  # one at a time, and only the newest of what waited
    assert set(shown) == {None, 30}
    number.value = 4  # nobody has said so yet
    assert (value.value, value.working) == (None, True)


def test_nothing_to_work_out_is_no_value(qtbot):
    number = Number(None)
    value = derived(number, lambda n: 10 * n)
    assert (value.value, value.working, value.problem) == (None, False, "")
    number.set(1)
    qtbot.waitUntil(lambda: value.value == 10)
    said = counted(value.changed)
    number.set(None)
    assert (value.value, value.working, len(said)) == (None, False, 1)


def test_why_there_is_nothing_to_work_out_is_a_problem(qtbot):
    asked: list[object] = ["no camera"]
    value = ComputedValue(lambda: asked[0], lambda n: 10 * n)
    value.invalidate()
    said, told = counted(value.changed), counted(value.failed)
    assert (value.value, value.working, value.problem) == (None, False, "no camera")
    for other in ("no field", None, "no field"):
        asked[0] = other
        value.invalidate()
        assert value.problem == (other or "")
    assert (len(said), told) == (3, [])
    value.set_enabled(False)
    assert value.problem == ""


def test_none_may_be_the_answer(qtbot):
    number, asked = Number(), []
    value = derived(number, lambda n: asked.append(n))
    qtbot.waitUntil(lambda: not value.working)
    number.changed.emit()
    let_work_end(qtbot)
    assert (value.value, asked) == (None, [1])


def test_what_nobody_wants_is_not_worked_out(qtbot):
    number, asked = Number(), []
    value = ComputedValue(number.inputs, lambda n: asked.append(n) or n)
    value.set_enabled(False)
    value.invalidate()
    let_work_end(qtbot)
    assert (asked, value.working) == ([], False)
    value.set_enabled(True)
    qtbot.waitUntil(lambda: value.value == 1)
    value.set_enabled(False)
    assert value.value is None


def test_as_many_answers_are_kept_as_wished(qtbot):
    number, asked = Number(), []
    value = derived(number, lambda n: asked.append(n) or n, cache_size=2)
    for n in (1, 2, 1, 3, 1, 2):
        number.set(n)
        qtbot.waitUntil(lambda n=n: value.value == n)
    assert asked == [1, 2, 3, 2]  # what was not asked for longest goes first
    number.set(1)
    assert value.value == 1  # at once
    assert (value.latest, value.cached(2), value.cached(3)) == (1, 2, None)
    value.clear()
    assert value.value is None


def refuse(n: int) -> int:
    raise UsageError(f"{n // 10} is no good")


@pytest.mark.parametrize("background", [True, False])
def test_a_failure_is_a_problem_and_told_once(qtbot, background):
    number = Number(11)
    value = derived(number, refuse, background)
    told = counted(value.failed)
    for n, problem in ((11, "1 is no good"), (12, "1 is no good"), (21, "2 is no good")):
        number.set(n)
        qtbot.waitUntil(lambda p=problem: value.problem == p)
        assert value.value is None
        assert not value.working
    let_work_end(qtbot)
    assert told == [("1 is no good",), ("2 is no good",)]


def test_what_failed_is_tried_again_when_asked(qtbot):
    number, asked, broken = Number(), [], [True]

    def compute(n: int) -> int:
        asked.append(n)
        if broken:
            raise UsageError("broken")
        return n

    value = derived(number, compute)
    told = counted(value.failed)
    qtbot.waitUntil(lambda: value.problem == "broken")
    value.invalidate()
    let_work_end(qtbot)
    assert asked == [1]
    value.retry()
    let_work_end(qtbot)
    assert (asked, value.problem, len(told)) == ([1, 1], "broken", 1)
    broken.clear()
    value.retry()
    qtbot.waitUntil(lambda: value.value == 1)
    value.retry()
    let_work_end(qtbot)
    assert (len(asked), value.problem) == (3, "")


def test_a_bug_is_told_and_not_hidden(qtbot, monkeypatch):
    raised: list[BaseException] = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: raised.append(error))
    number, asked = Number(0), []
    value = derived(number, lambda n: asked.append(n) or 1 / n)
    qtbot.waitUntil(lambda: "ZeroDivisionError" in value.problem)
    value.invalidate()
    let_work_end(qtbot)
    assert (len(raised), asked, value.working) == (1, [0], False)
    number.set(2)
    qtbot.waitUntil(lambda: value.value == 0.5)
    assert value.problem == ""


def test_work_that_nobody_wants_any_more_is_left(qtbot):
    number, begun, left = Number(), threading.Event(), []

    def compute(n: int, go_on: Callable[[], None]) -> int:
        begun.set()
        try:
            while n == 1:
                go_on()
        except Stopped:
            left.append(n)
            raise
        return n

    value = derived(number, compute, stoppable=True)
    qtbot.waitUntil(begun.is_set)
    number.set(2)
    qtbot.waitUntil(lambda: value.value == 2)
    qtbot.waitUntil(lambda: left == [1])


def test_patience_is_asked_for_what_came_and_went(qtbot):
    number, asked, waits = Number(), [], []

    def patience(now: object) -> int:
        waits.append(now)
        return 0

    value = derived(number, lambda n: asked.append(n) or n, delay_ms=patience)
    for n in (2, 3):
        number.set(n)
    number.set(None)
    number.set(4)
    qtbot.waitUntil(lambda: value.value == 4)
    assert waits == [(1,), (2,), (3,), (4,)]
    assert asked == [4]  # what was only passed is never begun


def test_what_is_forgotten_while_it_is_worked_out_is_worked_out_anew(qtbot):
    number, gate = Number(), Gate()
    value = derived(number, gate)
    qtbot.waitUntil(gate.begun.is_set)
    value.clear()
    value.invalidate()
    gate.go.set()
    qtbot.waitUntil(lambda: value.value == 10)
    assert gate.asked == [1, 1]


def test_what_is_painted_comes_first(qtbot):
    order: list[str] = []

    class Painted(QWidget):
        def paintEvent(self, event: QEvent) -> None:
            order.append("painted")

    widget = Painted()
    qtbot.addWidget(widget)
    with qtbot.waitExposed(widget):
        widget.show()
    QApplication.processEvents()
    number = Number()
    value = derived(number, lambda n: order.append("begun") or n)
    order.clear()
    number.set(2)
    widget.update()
    qtbot.waitUntil(lambda: value.value == 2)
    assert order[0] == "painted"
    assert set(order) == {"painted", "begun"}


def test_after_close_nothing_comes_and_nothing_is_held(qtbot):
    class Thing:
        pass

    thing, number, gate = Thing(), Number(), Gate()
    held = weakref.ref(thing)
    value = ComputedValue(
        lambda cache_size=thing: (number.value,),
        gate,
    )
    number.changed.connect(value.invalidate)
    value.invalidate()
    qtbot.waitUntil(gate.begun.is_set)
    said = counted(value.changed)
    value.close()
    del thing
    gate.go.set()
    let_work_end(qtbot)
    assert held() is None
    number.set(2)
    let_work_end(qtbot)
    assert (said, gate.asked, value.value, value.working) == ([], [1], None, False)


def test_what_is_dropped_takes_its_work_along(qtbot):
    parent, number, gate = QObject(), Number(), Gate()
    value = derived(number, gate, parent=parent)
    qtbot.waitUntil(gate.begun.is_set)
    gone = weakref.ref(value)
    del value, parent
    gate.go.set()
    let_work_end(qtbot)
    gc.collect()
    assert gone() is None
    number.set(2)  # nobody listens
    assert gate.asked == [1]


def test_a_value_of_a_value_follows(qtbot):
    number = Number()
    tenfold = derived(number, lambda n: 10 * n)

    def from_tenfold() -> tuple[int] | None:
        return None if tenfold.value is None else (tenfold.value,)

    more = ComputedValue(from_tenfold, lambda n: n + 1, background=False)
    tenfold.changed.connect(more.invalidate)
    said = counted(more.changed)
    qtbot.waitUntil(lambda: more.value == 11)
    number.set(2)
    assert more.value is None
    qtbot.waitUntil(lambda: more.value == 21)
    assert len(said) == 3


def test_answers_are_kept_within_what_they_are_of_only(qtbot):
    number, asked, frame = Number(), [], ["first"]
    value = derived(
        number,
        lambda n: asked.append(n) or n,
        background=False,
        cache_size=8,
        cache_scope=lambda: frame[0],
    )
    assert value.value == 1
    number.set(2)
    assert value.value == 2
    number.set(1)
    assert (value.value, asked) == (1, [1, 2])
    frame[0] = "second"
    number.set(2)
    assert (value.value, asked) == (2, [1, 2, 2])
    assert value.cached(1) is None


def test_a_later_look_is_one_for_all_and_no_value_is_older(qtbot):
    number, asked = Number(), []
    value = ComputedValue(number.inputs, lambda n: asked.append(n) or 10 * n)
    said = counted(value.changed)
    for n in (2, 3, 4):
        number.set(n)
        value.invalidate_later()
        assert value.value is None
        assert value.working
    assert not said
    qtbot.waitUntil(lambda: value.value == 40)
    assert asked == [4]
