"""The one place that holds the state, and the one signal that says that it changed."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import replace
from inspect import ismethod
from typing import Any, Protocol, TypeVar
from weakref import WeakMethod

import shiboken6
from PySide6.QtCore import QObject, Signal

from procc_annotator.gui.soon import soon
from procc_annotator.gui.state.state import State, same

T = TypeVar("T")

_CARRIED = frozenset({"preview"})  # what becomes another thing with every move of a held mouse


class _Reach(Protocol):
    """Gives what is to be called, or None once its owner is gone."""

    def __call__(self) -> Callable[[Any], object] | None: ...


class _Watch:
    """Calls a person whenever what they select of the state is another thing than before."""

    def __init__(
        self, select: Callable[[State], Any], then: Callable[[Any], object], state: State
    ) -> None:
        self._select = select
        self._reach: _Reach = WeakMethod(then) if ismethod(then) else lambda: then
        self._selected = select(state)

    def differs(self, state: State) -> bool:
        """Return whether they are to be called."""
        return not same(self._select(state), self._selected)

    def tell(self, state: State) -> bool:
        """Call them if need be; False once they are gone and would have been called."""
        selected = self._select(state)
        if same(selected, self._selected):
            return True
        then = self._reach()
        if then is None or not _is_alive(then):
            return False
        self._selected = selected
        then(selected)
        return True


class Store(QObject):
    """Holds the state. It is replaced as a whole, by commands, and reported step by step.

    A change that is made while another one is signalled is there at once, but signalled after that
    one: every listener sees every step, and all see them in the same order. A listener is notified
    once of all steps that follow from one another; of what the user drags, after that was painted.
    """

    changed = Signal(object, object)  # the state before, the state after
    rested = Signal()  # all that changed was told

    def __init__(self, state: State, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._state = state
        self._steps: deque[tuple[State, State]] = deque()
        self._telling = False
        self._begun: State | None = None  # what changes together with what is there now
        self._watches: list[_Watch] = []
        self._only_carried = True  # nothing else that those who watch were not told of
        self._after_paint = soon(self, self._tell_of_carried)

    @property
    def state(self) -> State:
        """As it is now."""
        return self._state

    @property
    def busy(self) -> bool:
        """Return whether something is still to be reported."""
        return self._telling or self._begun is not None

    @contextmanager
    def together(self) -> Iterator[None]:
        """Return what is changed within is there at once, and reported as one step at its end, but
        for lines that are said: each is a step of its own to those who listen to `changed`."""
        if self.busy:
            yield
            return
        self._begun = self._state
        try:
            yield
        finally:
            self._end_step()
            self._tell()

    def set(self, **changes: Any) -> None:
        """Replace fields of the state; nothing is reported where nothing differs.

        Args:
            changes: the new values, by the names of the fields of `State`.
        """
        before = self._state
        other = {k: v for k, v in changes.items() if not same(v, getattr(before, k))}
        if not other:
            return
        self._only_carried = self._only_carried and other.keys() <= _CARRIED
        if self._begun is None:
            self._steps.append((before, replace(before, **other)))
            self._state = self._steps[-1][1]
            if not self._telling:
                self._tell()
            return
        if "told" in other and before.told is not self._begun.told:
            self._end_step()
            self._begun = before
        self._state = replace(before, **other)

    def watch(self, select: Callable[[State], T], then: Callable[[T], object]) -> None:
        """Have a person called whenever what is selected differs, until their owner is gone.

        Args:
            select: a pure function of the state, cheap enough for every move of the mouse.
            then: receives what is selected. A method does not keep its object alive; any other
                function lives as long as the store and must hold no widget.
        """
        self._watches.append(_Watch(select, then, self._state))

    def _end_step(self) -> None:
        """What changed together is a step to be reported."""
        if self._begun is not None and self._begun is not self._state:
            self._steps.append((self._begun, self._state))
        self._begun = None

    def _tell(self) -> None:
        """Report every step; if a listener fails, all others are notified first."""
        self._telling = True
        with ExitStack() as at_last:
            at_last.callback(self._rest)
            self._tell_steps()

    def _tell_steps(self) -> None:
        changed = bool(self._steps)
        while self._steps:
            self.changed.emit(*self._steps.popleft())
        if not self._only_carried:
            self._tell_watches()
        elif changed:
            self._after_paint.start()

    def _tell_of_carried(self) -> None:
        self._only_carried = False
        if not self.busy:  # or they are about to be told
            self._tell()

    def _tell_watches(self) -> None:
        self._after_paint.stop()
        self._only_carried = True
        with ExitStack() as each:
            each.callback(self._tell_of_more)
            for watch in reversed([w for w in self._watches if w.differs(self._state)]):
                each.callback(self._tell_watch, watch)

    def _tell_watch(self, watch: _Watch) -> None:
        if not watch.tell(self._state):
            self._watches.remove(watch)

    def _tell_of_more(self) -> None:
        """Those who watch may have changed something themselves."""
        if self._steps:
            self._tell_steps()

    def _rest(self) -> None:
        self._telling = False
        self.rested.emit()


def _is_alive(then: Callable[[Any], object]) -> bool:
    """Return whether the owner of a method, if it is Qt's, is not deleted."""
    owner = getattr(then, "__self__", None)
    return not isinstance(owner, QObject) or shiboken6.isValid(owner)
