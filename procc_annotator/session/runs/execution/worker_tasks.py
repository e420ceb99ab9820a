"""What a worker does with the chunks it is sent: it keeps their tasks open between them."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable
from typing import Any, TypeVar

C = TypeVar("C")
R = TypeVar("R")

# Tasks a worker keeps open between their chunks. More than one, for two sets may be mapped in turn.
MAX_CACHED_TASKS = 2


class _TaskCache(threading.local):
    """The tasks of one thread: sources are not shared between threads."""

    def __init__(self) -> None:
        self.tasks: OrderedDict[str, Callable[[Any], Any]] = OrderedDict()


_kept = _TaskCache()


def run_chunk(key: str, task: Callable[[C], R], chunk: C) -> R:
    """Called in a worker: do a chunk with the task of that key that came first.

    Args:
        key: of one call of `Executor.map`, so that files that changed since the last call are
            opened anew.
    """
    tasks = _kept.tasks
    if key not in tasks:
        while len(tasks) >= MAX_CACHED_TASKS:
            _close_task(tasks.popitem(last=False)[1])
        tasks[key] = task
    tasks.move_to_end(key)
    result: R = tasks[key](chunk)
    return result


def _close_task(task: Callable[[Any], Any]) -> None:
    """Let a task close what it opened."""
    close = getattr(task, "close", None)
    if close is not None:
        close()
