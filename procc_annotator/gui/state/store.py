"""The one place that holds the state, and the one signal that says that it changed."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import replace
from inspect import ismethod
from typing import Any, Protocol, TypeVar
from weakref import WeakMethod

import shiboken6
from PySide6.QtCore import QObject, Signal

from procc_annotator.gui.state.state import State, same

T = TypeVar("T")


class _Reach(Protocol):
    """Gives what is to be called, or None once its owner is gone."""

    def __call__(self) -> Callable[[Any], object] | None: ...


class _Watch:
    """Calls somebody whenever what they select of the state is another thing than before."""

    def __init__(
        self, select: Callable[[State], Any], then: Callable[[Any], object], state: State
    ) -> None:
        self._select = select
        self._reach: _Reach = WeakMethod(then) if ismethod(then) else lambda: then
        self._selected = select(state)

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
    """Holds the state. It is replaced as a whole, by commands, and told step by step.

    A change that is made while another one is told is there at once, but told after that one: every
    listener sees every step, and all see them in the same order.
    """

    changed = Signal(object, object)  # the state before, the state after

    def __init__(self, state: State, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._state = state
        self._steps: deque[tuple[State, State]] = deque()
        self._telling = False
        self._watches: list[_Watch] = []

    @property
    def state(self) -> State:
        """As it is now."""
        return self._state

    def set(self, **changes: Any) -> None:
        """Replace fields of the state; nothing is told where nothing differs.

        Args:
            changes: the new values, by the names of the fields of `State`.
        """
        before = self._state
        other = {k: v for k, v in changes.items() if not same(v, getattr(before, k))}
        if not other:
            return
        self._state = replace(before, **other)
        self._steps.append((before, self._state))
        if not self._telling:
            self._tell()

    def watch(self, select: Callable[[State], T], then: Callable[[T], object]) -> None:
        """Have somebody called whenever what is selected differs, until their owner is gone.

        Args:
            select: a pure function of the state, cheap enough for every move of the mouse.
            then: receives what is selected. A method does not keep its object alive; any other
                function lives as long as the store and must hold no widget.
        """
        self._watches.append(_Watch(select, then, self._state))

    def _tell(self) -> None:
        self._telling = True
        try:
            while self._steps:
                before, after = self._steps.popleft()
                self.changed.emit(before, after)
                gone = [watch for watch in tuple(self._watches) if not watch.tell(after)]
                if gone:
                    self._watches = [w for w in self._watches if w not in gone]
        finally:
            self._telling = False


def _is_alive(then: Callable[[Any], object]) -> bool:
    """Whether the owner of a method, if it is Qt's, is not deleted."""
    owner = getattr(then, "__self__", None)
    return not isinstance(owner, QObject) or shiboken6.isValid(owner)
