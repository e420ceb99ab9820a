"""A function that is called anew only when it is asked for something else than the last time."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, ParamSpec, TypeVar

P = ParamSpec("P")
T = TypeVar("T")


class LastCallCache(Generic[P, T]):
    """Gives the very same result for the same arguments as the last time.

    Arguments are compared as members of a tuple are: the same object, or an equal one. Arrays must
    therefore come in something that is compared by identity.
    """

    def __init__(self, make: Callable[P, T]) -> None:
        self._make = make
        self._last: tuple[object, T] | None = None

    def __call__(self, *args: P.args, **kwargs: P.kwargs) -> T:
        asked = args, kwargs
        if self._last is None or self._last[0] != asked:
            self._last = asked, self._make(*args, **kwargs)
        return self._last[1]
