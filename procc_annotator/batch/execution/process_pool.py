"""Local worker processes that survive dead workers, and the task cache in a worker."""

from __future__ import annotations

import multiprocessing
import os
import signal
import threading
import uuid
from collections import OrderedDict, deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import islice
from multiprocessing import connection
from multiprocessing.context import SpawnContext, SpawnProcess
from queue import Empty, SimpleQueue
from types import TracebackType
from typing import Any, Generic, Self, TypeVar

from procc_annotator.batch.execution.executor import Work, take_ready
from procc_annotator.errors import ProccError

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
    close = getattr(task, "close", None)
    if close is not None:
        close()


# A chunk that was under way when the pool broke so often is tried alone from then on ...
_SUSPECT_AFTER = 2
# ... and given up when it breaks the pool alone so often.
_ALONE_TRIES = 2
_INTERRUPT_POLL_S = 0.5


@dataclass(eq=False)
class _Sent(Generic[C, R]):
    """A chunk under way; ``future`` is None when it has to be sent (again)."""

    chunk: C
    future: Future[R] | None = None
    broke: int = 0
    broke_alone: int = 0


class ProcessPool:
    """See `Executor`; processes start when they are needed and end with the block.

    Args:
        workers: how many processes.
    """

    def __init__(self, workers: int) -> None:
        self.workers = workers
        self._pool: ProcessPoolExecutor | None = None
        self._context = _RememberingContext()

    def map(self, work: Work[C, R]) -> Iterator[R]:
        """See `Executor.map`. A bounded window of chunks is under way, so that memory stays flat
        when results are used up more slowly than they are made.

        When no one wants more results, the chunks under way are left to the pool: it breaks off
        with a traceback at one that was called off when its processes are killed.
        """
        key = uuid.uuid4().hex
        more = iter(work.chunks)
        sent: deque[_Sent[C, R]] = deque()
        arrived: SimpleQueue[object] = SimpleQueue()
        while True:
            sent.extend(map(_Sent[C, R], take_ready(more, 2 * self.workers - len(sent))))
            if not sent:
                return
            alone = any(one.broke >= _SUSPECT_AFTER for one in sent)
            try:
                for one in islice(sent, 1 if alone else None):
                    if one.future is None:
                        one.future = self._submit(key, work.task, one.chunk)
                        with _interrupts_deferred():
                            one.future.add_done_callback(arrived.put)
                one = _first_done(sent, arrived, work.ordered or alone)
                assert one.future is not None
                with _interrupts_deferred():
                    result = one.future.result()
            except BrokenProcessPool as error:
                self._context.kill_all()
                self._end()
                _count_broken(sent, alone)
                one = sent[0]
                if one.broke_alone < _ALONE_TRIES:
                    continue
                said = _lost(work.name(one.chunk), one)
                if work.lost is None:
                    raise said from error
                result = work.lost(one.chunk, said)
            sent.remove(one)
            yield result

    def _submit(self, key: str, task: Callable[[C], R], chunk: C) -> Future[R]:
        with _interrupts_deferred():
            if self._pool is None:
                # Made apart: what it starts for its locks has this thread hear interrupts again.
                self._pool = ProcessPoolExecutor(self.workers, self._context, _begin_worker)
            with _interrupts_blocked():  # submitting starts a process, if one is missing
                try:
                    return self._pool.submit(run_chunk, key, task, chunk)
                except OSError:
                    # A pool that breaks at this moment closes what the process that starts
                    # inherits; asked again it says that it is broken. Else the chunk is at most
                    # done twice.
                    try:
                        return self._pool.submit(run_chunk, key, task, chunk)
                    except BrokenProcessPool as error:
                        under_way: Future[R] = Future()  # it may be the one that broke the pool
                        under_way.set_exception(error)
                        return under_way

    def _end(self) -> None:
        if self._pool is not None:
            self._pool.shutdown(cancel_futures=True)
            self._pool = None
            self._context.started.clear()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if kind is not None and issubclass(kind, KeyboardInterrupt):
            # No one wants what they are doing, and one that still starts would be waited for.
            self._context.kill_all()
        self._end()


class _RememberingContext(SpawnContext):
    """Knows the processes started through it: a pool that breaks while it starts one forgets it
    when it ends the others, and then waits for it forever."""

    def __init__(self) -> None:
        super().__init__()
        self.started: list[SpawnProcess] = []

    def Process(self, *args: Any, **keywords: Any) -> SpawnProcess:  # type: ignore[override]
        """As the class of this name, which is what the pool asks for."""
        process = SpawnProcess(*args, **keywords)
        self.started.append(process)
        return process

    def kill_all(self) -> None:
        """End the processes of a broken pool, also those it does not know."""
        for process in self.started:
            if process.pid is not None:
                process.kill()


def _count_broken(sent: Iterable[_Sent[Any, Any]], alone: bool) -> None:
    """Blame everything that was under way when the pool broke, and send it again."""
    for one in sent:
        if one.future is None or _is_finished(one.future):
            continue
        one.future = None
        one.broke += 1
        one.broke_alone += alone


def _is_finished(future: Future[Any]) -> bool:
    """Return whether it has a result (or an error of its own) in spite of the broken pool."""
    if not future.done() or future.cancelled():
        return False
    return not isinstance(future.exception(), BrokenProcessPool)


def _lost(name: str, one: _Sent[Any, Any]) -> ProccError:
    return ProccError(
        f"{name}: the worker process was ended from outside {one.broke} times over this part of"
        " the work, too little memory or a damaged file (look at these frames, or try --workers 1)"
    )


def _first_done(
    sent: Sequence[_Sent[C, R]], arrived: SimpleQueue[object], ordered: bool
) -> _Sent[C, R]:
    """Wait for a result, if ordered for the first one; of all that is done with a future, this
    alone hears Ctrl+C."""
    while True:
        for one in islice(sent, 1 if ordered else None):
            if one.future is not None and one.future.done():
                return one
        try:
            # Python sees a Ctrl+C that came just before a wait when that ends, not before.
            arrived.get(timeout=_INTERRUPT_POLL_S)
        except Empty:
            continue


@contextmanager
def _interrupts_deferred() -> Iterator[None]:
    """A Ctrl+C meanwhile is heard at the end.

    At once, it could come between the taking of a lock, of a future or of the pool, and what
    releases it: then the pool would wait for that lock forever.
    """
    handler = signal.getsignal(signal.SIGINT)
    if not callable(handler) or threading.current_thread() is not threading.main_thread():
        yield
        return
    heard: list[int] = []
    signal.signal(signal.SIGINT, lambda number, _: heard.append(number))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, handler)
        if heard:
            handler(signal.SIGINT, None)


@contextmanager
def _interrupts_blocked() -> Iterator[None]:
    """Processes started here never hear Ctrl+C, not even while they start; we do, and end them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin_worker() -> None:
    # Processes share the processors: OpenCV's threads would wait for each other. It reads this when
    # it first divides work.
    os.environ.setdefault("OPENCV_FOR_THREADS_NUM", "1")
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    """End this worker when the main process ended without a chance to say so."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        connection.wait([parent.sentinel])
        os._exit(1)
