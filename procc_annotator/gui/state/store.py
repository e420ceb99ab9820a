"""The store: holds the application state, replaces it as a whole and notifies its watches."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import fields, replace
from enum import IntEnum
from inspect import ismethod
from typing import Any, cast
from weakref import WeakMethod

import shiboken6
from PySide6.QtCore import QObject, SignalInstance
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.state.background import ComputedValue, after_paint
from procc_annotator.gui.state.events import Events
from procc_annotator.gui.state.state import State, same
from procc_annotator.gui.state.visible_update import VisibleUpdate

_FIELDS = frozenset(field.name for field in fields(State))
_GESTURE_FIELDS = frozenset({"preview"})  # replaced with every mouse move of a drag


class When(IntEnum):
    """When a watch calls back after its selection has changed; each includes those before it."""

    GESTURE = 0  # as NOW, and with every move of a drag, which others see after the paint
    NOW = 1  # before the command that changed the state returns
    AFTER_PAINT = 2  # once for all changes, after the next paint


class _TracedState:
    """A state as selections read it: notes the names of the fields that are read."""

    def __init__(self, state: State, number: int) -> None:
        self._state, self.number = state, number
        self._read: dict[str, tuple[object, set[str]]] = {}
        self._fields: set[str] = set()

    def evaluate(self, select: Callable[[State], object]) -> tuple[object, set[str]]:
        """Return a selection and the fields that it depends on."""
        before, self._fields = self._fields, set()
        value, fields = select(cast(State, self)), self._fields
        self._fields = before
        return value, fields

    def __getattr__(self, name: str) -> object:
        found = self._read.get(name)
        if found is None:
            attribute = getattr(State, name)
            if name in _FIELDS:
                found = getattr(self._state, name), {name}
            elif isinstance(attribute, property):
                found = self.evaluate(attribute.__get__)
            else:
                return attribute.__get__(self)  # a method; what it reads is noted as it reads it
            self._read[name] = found
        self._fields |= found[1]
        return found[0]


class _Selection:
    """A selection of the state that several watches share: evaluated once per state.

    It is a pure function: as long as the fields that it read are the same, so is its value.
    """

    def __init__(self, select: Callable[[State], object], state: _TracedState) -> None:
        self._select, self._seen = select, state.number
        self._version = 0
        self._value, self.fields = state.evaluate(select)

    def version(self, state: _TracedState) -> int:
        """Return a number that differs if the selection does."""
        if state.number != self._seen:
            self._seen = state.number
            value, self.fields = state.evaluate(self._select)
            if not same(value, self._value):
                self._value = value
                self._version += 1
        return self._version


class _Watch:
    """Calls back if its selection of the state differs from the one of the last call."""

    def __init__(
        self, selection: _Selection, callback: Callable[[], object], when: When, state: _TracedState
    ) -> None:
        self._selection, self.when = selection, when
        self._callback = WeakMethod(callback) if ismethod(callback) else lambda: callback
        self._version = selection.version(state)

    def depends_on(self, fields: set[str]) -> bool:
        """Return whether the selection may differ after a change of these fields."""
        return not self._selection.fields.isdisjoint(fields)

    def check(self, state: _TracedState) -> bool:
        """Call back if the selection has changed; return False once the owner is gone."""
        version = self._selection.version(state)
        if version == self._version:
            return True
        callback = self._callback()
        if callback is None or not _is_alive(callback):
            return False
        self._version = version
        callback()
        return True


class _Current:
    """Invalidates a computed value, whose inputs may depend on more than the state."""

    def __init__(self, value: ComputedValue[Any], when: When) -> None:
        self._value, self.when = value, when

    def depends_on(self, fields: set[str]) -> bool:
        """Return whether the value may differ after a change of these fields."""
        return True

    def check(self, state: _TracedState) -> bool:
        """Invalidate; return False once the value is deleted."""
        if not shiboken6.isValid(self._value):
            return False
        self._value.invalidate()
        return True


class Store(QObject):
    """Holds the state. Commands replace it with `update`; `watch` notifies of what differs.

    A change made by a callback is visible at once and notified after the present round: each
    watch is called once for all changes that follow from one another, and sees the latest state.

    Attributes:
        events: what happens and is no part of the state.
        score: called with the state before and after each change, before any watch: scores are
            up to date when views read them.
    """

    def __init__(self, state: State, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.events = Events(self)
        self.score: Callable[[State, State], object] = lambda before, after: None
        self._state = self._scored = self._notified = state
        self._traced = _TracedState(state, 0)
        self._selections: dict[Callable[[State], object], _Selection] = {}
        self._watches: list[_Watch | _Current] = []
        self._transactions = 0
        self._notifying = False
        self._only_gesture = True  # since all watches were checked
        self._changed = [set[str]() for _ in When]  # fields, since the watches were checked
        self._later: list[Callable[[], object]] = []
        self._after_paint = after_paint(self, self._notify_after_paint)

    @property
    def state(self) -> State:
        """The present state."""
        return self._state

    @property
    def busy(self) -> bool:
        """Return whether watches are still to be notified of a change."""
        return self._notifying or self._transactions > 0

    def update(self, **changes: Any) -> None:
        """Replace fields of the state, by name; no notification if nothing differs."""
        before = self._state
        other = {k: v for k, v in changes.items() if not same(v, getattr(before, k))}
        if other:
            self._only_gesture = self._only_gesture and other.keys() <= _GESTURE_FIELDS
            for changed in self._changed:
                changed.update(other)
            self._state = replace(before, **other)
            self._traced = _TracedState(self._state, self._traced.number + 1)
            self._notify()

    @contextmanager
    def transaction(self) -> Iterator[None]:
        """Notify once, at the end, of all that is changed within."""
        self._transactions += 1
        try:
            yield
        finally:
            self._transactions -= 1
            self._notify()

    def watch(
        self,
        select: Callable[[State], object],
        callback: Callable[[], object],
        when: When = When.NOW,
    ) -> None:
        """Call back whenever a selection of the state has changed, until the owner is gone.

        Args:
            select: a pure function of the state, cheap enough for every change; small values are
                compared by value, large ones by identity (`same`).
            callback: a method does not keep its object alive; any other function lives as long as
                the store and must hold no widget.
        """
        if select not in self._selections:
            self._selections[select] = _Selection(select, self._traced)
        self._watches.append(_Watch(self._selections[select], callback, when, self._traced))

    def watch_visible(
        self,
        widget: QWidget,
        update: Callable[[], None],
        select: Callable[[State], object],
        *signals: SignalInstance,
    ) -> VisibleUpdate:
        """Update a widget whenever a selection of the state has changed, and after signals of what
        is no part of the state: after the paint, and only while it can be seen."""
        visible = VisibleUpdate(widget, update, lambda: bool(self._changed[When.AFTER_PAINT]))
        self.watch(select, visible.request, When.AFTER_PAINT)
        for signal in signals:
            signal.connect(visible.request)
        return visible

    def keep_current(
        self,
        value: ComputedValue[Any],
        *signals: SignalInstance,
        when: When = When.AFTER_PAINT,
    ) -> None:
        """Invalidate a computed value whenever its inputs differ: after a change of the state, and
        after signals of what is no part of the state."""
        self._watches.append(_Current(value, when))
        for signal in signals:
            signal.connect(value.invalidate)

    def when_notified(self, callback: Callable[[], object]) -> None:
        """Call at once, or after all watches were notified if that is in progress."""
        self._later.append(callback)
        if not self.busy:
            self._call_later()

    # --- inside -------------------------------------------------------------------------------

    def _notify(self) -> None:
        """Check the watches until nothing differs; if one fails, the others are checked first."""
        if self.busy:
            return
        if self._state is self._notified:
            self._call_later()
            return
        self._notifying = True
        with ExitStack() as at_last:
            at_last.callback(self._end_round)
            while self._state is not self._notified:
                self._round(When.GESTURE if self._only_gesture else When.NOW)

    def _round(self, when: When) -> None:
        """Compute the scores, then check the watches that are due."""
        before, self._scored = self._scored, self._state
        if before is not self._state:
            self.score(before, self._state)
        self._notified = self._state
        if when is not When.GESTURE:
            self._only_gesture = True
        changed = self._changed[: when + 1]
        self._changed[: when + 1] = [set() for _ in changed]
        due = (watch for watch in self._watches if watch.when <= when)
        watches = [watch for watch in due if watch.depends_on(changed[watch.when])]
        self._check(iter(watches))

    def _check(self, watches: Iterator[_Watch | _Current]) -> None:
        """Check each watch; if one fails, the rest is checked before its error is raised."""
        finished = False
        try:
            for watch in watches:
                if not watch.check(self._traced):
                    self._watches.remove(watch)
            finished = True
        finally:
            if not finished:
                self._check(watches)

    def _end_round(self) -> None:
        self._notifying = False
        self._after_paint.start()
        self._notify()  # if one failed, another may have changed the state

    def _call_later(self) -> None:
        while self._later:
            self._later.pop(0)()

    def _notify_after_paint(self) -> None:
        if self.busy:
            self._after_paint.start()
            return
        self._notifying, self._only_gesture = True, False
        with ExitStack() as at_last:
            at_last.callback(self._end_late_round)
            self._round(When.AFTER_PAINT)

    def _end_late_round(self) -> None:
        self._notifying = False
        self._notify()


def _is_alive(callback: Callable[[], object]) -> bool:
    """Return whether the owner of a method, if it is a QObject, is not deleted."""
    owner = getattr(callback, "__self__", None)
    return not isinstance(owner, QObject) or shiboken6.isValid(owner)
