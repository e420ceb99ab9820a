"""Work off the GUI thread, its outcome delivered on it; values that are computed from others.

Three groups of threads share the work, by priority. What the user waits for (the fit of the frame
on screen, its ghosts) is urgent and never queues behind what walks through a whole dataset (audits,
exports, thumbnails), which gets a core only if no one else needs it. What is immediate (the picture
of the frame on screen, saving a click) is short and waits for neither.
"""

from __future__ import annotations

import itertools
import os
import sys
import threading
import weakref
from collections import deque
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from dataclasses import dataclass
from enum import Enum, auto
from functools import lru_cache, partial
from typing import Any, Generic, TypeVar
from weakref import WeakKeyDictionary, WeakSet

import shiboken6
from PySide6.QtCore import QCoreApplication, QObject, Qt, QTimer, Signal, SignalInstance, Slot

from procc_annotator.error_log import one_line
from procc_annotator.errors import ProccError
from procc_annotator.gui.state.state import same
from procc_annotator.translation import tr

T = TypeVar("T")
Inputs = tuple[object, ...]


class Priority(Enum):
    """Which work goes first."""

    IMMEDIATE = auto()  # short: saving a click, the picture of the frame on screen
    URGENT = auto()  # the user waits for it; a second at most
    LOW = auto()  # walks through a dataset


_THREADS = {Priority.IMMEDIATE: 4, Priority.URGENT: 2, Priority.LOW: 3}
_NICER = 5  # than the interface


def after_paint(owner: QObject, callback: Callable[[], object] | SignalInstance) -> QTimer:
    """Return a timer that, once started, calls back after the next paint; once, however often it is
    started until then. It is gone with its owner.

    Qt paints while it processes posted events, which it does before it looks at its timers.
    """
    timer = QTimer(owner, singleShot=True, interval=0)
    timer.timeout.connect(callback)
    return timer


class Stopped(Exception):
    """Raised by work that was cancelled."""


class JobControl:
    """What the work sees of its job: where to report progress, and whether to stop."""

    def __init__(self, announce: Callable[[], None]) -> None:
        self._announce = announce
        self._stop = threading.Event()
        self._lock = threading.Lock()
        self._latest: tuple[int, int] | None = None
        self._partial: list[Any] = []

    @property
    def cancelled(self) -> bool:
        """True once the result is not needed any more; the work should return soon."""
        return self._stop.is_set()

    def progress(self, done: int, total: int) -> None:
        """Report progress; cheap, a burst of calls reaches the interface as its last one."""
        with self._lock:
            announced = self._latest is not None
            self._latest = (done, total)
        if not announced and not self.cancelled:
            self._announce()

    def emit_partial(self, part: Any) -> None:
        """Pass on a part of the result; it arrives with the next progress, or the outcome."""
        with self._lock:
            self._partial.append(part)

    def raise_if_cancelled(self) -> None:
        """Raise `Stopped` once the result is not needed any more."""
        if self.cancelled:
            raise Stopped

    def progress_or_stop(self, done: int, total: int) -> None:
        """As `progress`, for work that knows nothing of jobs; raise `Stopped` once cancelled."""
        self.raise_if_cancelled()
        self.progress(done, total)

    def _take_progress(self) -> tuple[int, int] | None:
        with self._lock:
            latest, self._latest = self._latest, None
        return latest

    def _take_partial(self) -> list[Any]:
        with self._lock:
            parts, self._partial = self._partial, []
        return parts

    def _cancel(self) -> None:
        self._stop.set()


class Job:
    """Work in progress; belongs to the GUI thread, the working thread never sees it."""

    def __init__(
        self,
        control: JobControl,
        submit: Callable[[], Future[Any]],
        drop: Callable[[], object],
        on_result: Callable[[Any], object],
        on_error: Callable[[str], None] | None,
        on_progress: Callable[[int, int], None] | None,
        on_partial: Callable[[list[Any]], None] | None,
        owner: QObject | None,
    ) -> None:
        self._control, self._submit, self._drop = control, submit, drop
        self._future: Future[Any] | None = None
        self._delay: QTimer | None = None
        self._on_result, self._on_error = on_result, on_error
        self._on_progress, self._on_partial = on_progress, on_partial
        self._owner = None if owner is None else weakref.ref(owner)
        self._delivered = False

    @property
    def running(self) -> bool:
        """Return whether an outcome is still to be delivered."""
        return not self._delivered and not self._control.cancelled

    @property
    def begun(self) -> bool:
        """Return whether a thread works on it, or has finished it."""
        return self._future is not None and (self._future.running() or self._future.done())

    def _begin(self) -> Future[Any]:
        """Submit the work to its threads, unless that was done."""
        if self._future is None:
            self._delay = None
            self._future = self._submit()
        return self._future

    def _begin_in(self, delay_ms: int | None) -> None:
        if delay_ms is None:
            self._begin()
            return
        self._delay = QTimer(singleShot=True, interval=delay_ms)
        self._delay.timeout.connect(self._begin)
        self._delay.start()

    def cancel(self) -> None:
        """Forget the work: nothing is delivered any more, and it is asked to stop."""
        self._control._cancel()
        if self._future is not None:
            self._future.cancel()
        else:
            # Qt may have ended before, with the program.
            if self._delay is not None and shiboken6.isValid(self._delay):
                self._delay.stop()
            self._drop()

    def stop(self) -> None:
        """As `cancel`, and wait until the work has ended: what it reads may go now."""
        self.cancel()
        if self._future is not None and not self._future.cancelled():
            wait([self._future])

    def finish(self, timeout_s: float | None = None) -> bool:
        """Wait for the work and deliver its outcome now; nothing happens once it is delivered.
        False if it takes longer than the timeout; the work then goes on as before."""
        if self.running:
            if not wait([self._begin()], timeout_s).done:
                return False
            self._deliver()
        return True

    def _needed(self) -> bool:
        if self._owner is not None:
            owner = self._owner()
            if owner is None or not shiboken6.isValid(owner):
                self.cancel()
        return self.running

    def deliver_partial(self) -> None:
        """Deliver now what was passed on so far."""
        deliver = self._on_partial
        if deliver is not None and self._needed() and (parts := self._control._take_partial()):
            deliver(parts)

    def _deliver_progress(self) -> None:
        latest = self._control._take_progress()  # first: what comes after it is announced again
        self.deliver_partial()
        if latest is not None and self._on_progress is not None and self._needed():
            self._on_progress(*latest)

    def _deliver(self) -> None:
        self._deliver_progress()
        future = self._begin()
        error = None if future.cancelled() else future.exception()
        if not self._needed():
            if error is not None and not isinstance(error, (ProccError, Stopped)):
                sys.excepthook(type(error), error, error.__traceback__)  # a bug is a bug
            return
        self._delivered = True
        if error is None:
            self._on_result(future.result())
        elif isinstance(error, ProccError) and self._on_error is not None:
            self._on_error(str(error))
        else:
            sys.excepthook(type(error), error, error.__traceback__)
            # Whoever waits for the outcome would otherwise wait as long as the window is open.
            if self._on_error is not None:
                self._on_error(tr("unexpected error ({what})", what=one_line(error)))


class _Dispatcher(QObject):
    """Delivers on the GUI thread what threads announce; only the number of a job crosses over."""

    progressed = Signal(int)
    done = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.jobs: dict[int, Job] = {}
        self.numbers = itertools.count()
        self.pools = {
            priority: ThreadPoolExecutor(
                threads,
                thread_name_prefix=priority.name.lower(),
                initializer=_give_way if priority is Priority.LOW else None,
            )
            for priority, threads in _THREADS.items()
        }
        self.held: list[tuple[Job, int | None]] | None = None  # until the window is painted
        self._owned: WeakKeyDictionary[QObject, WeakSet[Job]] = WeakKeyDictionary()
        self.progressed.connect(self._on_progressed, Qt.ConnectionType.QueuedConnection)
        self.done.connect(self._on_done, Qt.ConnectionType.QueuedConnection)

    def take(self, number: int, job: Job, owner: QObject | None) -> None:
        """Keep a job until it is delivered; it is cancelled when its owner goes."""
        self.jobs[number] = job
        if owner is None:
            return
        jobs = self._owned.get(owner)
        if jobs is None:
            self._owned[owner] = jobs = WeakSet()
            owner.destroyed.connect(partial(_cancel_each, jobs))
        jobs.add(job)

    @Slot(int)
    def _on_progressed(self, number: int) -> None:
        if number in self.jobs:
            self.jobs[number]._deliver_progress()

    @Slot(int)
    def _on_done(self, number: int) -> None:
        job = self.jobs.pop(number, None)
        if job is not None:
            job._deliver()


def run_in_background(
    fn: Callable[[JobControl], T],
    *,
    on_result: Callable[[T], object],
    on_error: Callable[[str], None] | None,
    on_progress: Callable[[int, int], None] | None = None,
    on_partial: Callable[[list[Any]], None] | None = None,
    owner: QObject | None = None,
    priority: Priority = Priority.LOW,
    delay_ms: int | None = None,
) -> Job:
    """Run ``fn(control)`` in a thread; call from the GUI thread.

    Args:
        fn: the work; may look at ``control.cancelled`` and call ``control.progress(done, total)``.
        on_result: receives what ``fn`` returned, on the GUI thread.
        on_error: receives the one-line text of a `ProccError`. Any other exception is a bug: it
            goes to `sys.excepthook` as if it had been raised on the GUI thread, and ``on_error``
            receives a line that says so. None: no failure is expected, every exception is a bug.
        on_progress: receives (done, total).
        on_partial: receives the parts passed on since, before progress and outcome.
        owner: nothing is delivered any more once this object is gone, and what has not begun by
            then never does.
        delay_ms: begin so much later; 0 is after the next paint. None: at once.
    """
    dispatcher = _dispatcher()
    number = next(dispatcher.numbers)
    control = JobControl(lambda: dispatcher.progressed.emit(number))

    def submit() -> Future[T]:
        future = dispatcher.pools[priority].submit(fn, control)
        future.add_done_callback(lambda _: dispatcher.done.emit(number))
        return future

    drop = partial(dispatcher.jobs.pop, number, None)
    job = Job(control, submit, drop, on_result, on_error, on_progress, on_partial, owner)
    dispatcher.take(number, job, owner)
    if dispatcher.held is not None and priority is not Priority.IMMEDIATE:
        dispatcher.held.append((job, delay_ms))
    else:
        job._begin_in(delay_ms)
    return job


def hold() -> None:
    """Begin only immediate work until `release`: other work would take the interpreter from a
    window that is being made and painted for the first time."""
    _dispatcher().held = []


def release() -> None:
    """Begin all work that was held, and from now on everything at once."""
    dispatcher = _dispatcher()
    held, dispatcher.held = dispatcher.held or [], None
    for job, delay_ms in held:
        if job.running:
            job._begin_in(delay_ms)


def cancel_all() -> None:
    """Cancel every job in progress; the program waits for its threads at its end."""
    for job in tuple(_dispatcher().jobs.values()):
        job.cancel()


class LatestOnlyTask:
    """One job at a time: starting another one cancels the one before."""

    def __init__(
        self,
        owner: QObject,
        failed: Callable[[str], None] | None,
        *,
        priority: Priority = Priority.LOW,
        delay_ms: int | None = None,
    ) -> None:
        """
        Args:
            owner, priority, delay_ms: as for `run_in_background`.
            failed: receives the reason of a failure, unless the job has a handler of its own; None
                if the work cannot fail.
        """
        self._owner, self._failed = owner, failed
        self._priority, self._delay_ms = priority, delay_ms
        self._job: Job | None = None

    @property
    def running(self) -> bool:
        """Return whether an outcome is still to be delivered."""
        return self._job is not None and self._job.running

    def start(
        self,
        work: Callable[[JobControl], T],
        then: Callable[[T], object],
        *,
        failed: Callable[[str], None] | None = None,
        progress: Callable[[int, int], None] | None = None,
        partial: Callable[[list[Any]], None] | None = None,
    ) -> None:
        """Begin; the job in progress is cancelled. ``then`` receives the outcome, ``partial`` the
        parts that the work passes on until then."""
        self.cancel()
        self._job = run_in_background(
            work,
            on_result=then,
            on_error=failed or self._failed,
            on_progress=progress,
            on_partial=partial,
            owner=self._owner,
            priority=self._priority,
            delay_ms=self._delay_ms,
        )

    def cancel(self) -> bool:
        """Cancel the job in progress; False if there is none."""
        running = self.running
        if self._job is not None:
            self._job.cancel()
            self._job = None
        return running

    def stop_keep_partial(self) -> bool:
        """Deliver the parts passed on so far and cancel the rest; False if there is no job."""
        if self._job is not None:
            self._job.deliver_partial()
        return self.cancel()

    def finish(self, timeout_s: float | None = None) -> bool:
        """Wait for the outcome, as `Job.finish`."""
        return self._job is None or self._job.finish(timeout_s)


@dataclass(frozen=True, eq=False, slots=True)
class _Result(Generic[T]):
    """The value for some inputs, or why there is none."""

    inputs: Inputs
    value: T | None
    problem: str = ""


class ComputedValue(QObject, Generic[T]):
    """A value computed from inputs that are read anew at every access: never of other inputs.

    Two inputs are the same if they are one object, or small and equal (`same`): comparing the
    contents of an annotation takes too long. In the background one computation runs at most, of the
    newest inputs. `Store.keep_current` calls `invalidate` whenever the inputs differ.
    """

    changed = Signal()  # the value, or that it is being computed, or why there is none
    failed = Signal(str)  # why there is none; the same text once until it went well again

    def __init__(
        self,
        inputs: Callable[[], Inputs | str | None],
        compute: Callable[..., T | None],
        parent: QObject | None = None,
        *,
        background: bool = True,
        enabled: bool = True,
        cache_size: int = 1,
        cache_scope: Callable[[], object] | None = None,
        stoppable: bool = False,
        priority: Priority = Priority.URGENT,
        delay_ms: Callable[[Inputs], int] | None = None,
    ) -> None:
        """Nothing is computed before the first `invalidate` or access.

        Args:
            inputs: the arguments of ``compute``; None: there is nothing to compute; a text: there
                is not, and this is why.
            compute: called in a thread if in the background; may raise `ProccError`.
            background: whether to compute in a thread, after the next paint; else at access.
            enabled: whether the value is needed from the beginning.
            cache_size: number of results that are kept, for inputs that come back.
            cache_scope: results are dropped once this returns another value: what is large may
                live no longer than what it belongs to.
            stoppable: ``compute`` takes ``go_on`` too, a function that raises `Stopped` once the
                result is not needed any more.
            delay_ms: how long to wait before the work begins, by the inputs.
        """
        super().__init__(parent)
        self._inputs, self._compute, self._background = inputs, compute, background
        self._stoppable, self._priority, self._delay_ms = stoppable, priority, delay_ms
        self._results: deque[_Result[T]] = deque(maxlen=cache_size)
        self._cache_scope = cache_scope if cache_scope is not None else _nothing
        self._scope = self._cache_scope()
        self._found: tuple[Inputs, _Result[T] | None] | None = None  # the last lookup
        self._newest: Inputs | str | None = None  # at the last `invalidate`
        self._job: Job | None = None
        self._problem = ""  # the last one that was signalled
        self.enabled = enabled  # whether the value is needed; nothing is computed otherwise
        self._later = after_paint(self, self.invalidate)

    # --- access -----------------------------------------------------------------------------

    @property
    def value(self) -> T | None:
        """The value of the present inputs; None while it is computed, and if there is none."""
        result = self._result(self.inputs())
        return None if result is None else result.value

    @property
    def problem(self) -> str:
        """Why there is no value; empty if there is one, while it is computed, and if disabled."""
        now = self.inputs()
        if isinstance(now, str):
            return now
        result = self._result(now)
        return "" if result is None else result.problem

    @property
    def working(self) -> bool:
        """Return whether the value is still to come."""
        now = self.inputs()
        return isinstance(now, tuple) and self._result(now) is None

    def cached(self, *inputs: object) -> T | None:
        """Return the value for some inputs, if it is in the cache."""
        result = self._lookup(inputs)
        return None if result is None else result.value

    def is_cached(self, *inputs: object) -> bool:
        """Return whether the result for some inputs, even if none, is in the cache."""
        return self._lookup(inputs) is not None

    @property
    def latest(self) -> T | None:
        """Return the value computed or accessed last, of whatever inputs."""
        return self._results[0].value if self._results else None

    def inputs(self) -> Inputs | str | None:
        """Return the present inputs; None if the value is not needed."""
        return self._inputs() if self.enabled else None

    def set_enabled(self, enabled: bool) -> None:
        """Set whether the value is needed from now on."""
        if enabled != self.enabled:
            self.enabled, self._problem = enabled, ""
            before = self._newest
            self.invalidate()
            if same(before, self._newest):
                self.changed.emit()  # for those who show that it is enabled

    # --- keeping it current -----------------------------------------------------------------

    def invalidate(self) -> None:
        """The inputs may be others."""
        if (scope := self._cache_scope()) != self._scope:
            self._scope = scope
            self.clear()
        now = self.inputs()
        if same(self._newest, now):
            return
        self._newest = now
        if self._background:
            delay_ms = self._delay_ms
            self._start(0 if delay_ms is None or not isinstance(now, tuple) else delay_ms(now))
        self.changed.emit()

    def invalidate_later(self) -> None:
        """As `invalidate`, after the next paint."""
        self._later.start()

    def retry(self) -> None:
        """As `invalidate`; what failed is tried again, and signalled if it fails otherwise."""
        self.clear(failures_only=True)
        self.invalidate()
        if self._background:
            self._start(0)

    def clear(self, *, failures_only: bool = False) -> None:
        """Drop all results, or the failures; invalidate afterwards."""
        kept = [result for result in self._results if failures_only and not result.problem]
        self._results, self._found = deque(kept, self._results.maxlen), None
        if not failures_only:
            self._newest = None
            self._cancel()  # or its result would pass for a new one

    def close(self) -> None:
        """Compute nothing any more, and hold on to nothing."""
        self._inputs = _nothing
        self._later.stop()
        self.clear()

    # --- inside -----------------------------------------------------------------------------

    def _result(self, now: Inputs | str | None) -> _Result[T] | None:
        if not isinstance(now, tuple):
            return None
        result = self._lookup(now)
        if result is None and not self._background:
            result = _evaluate(self._compute, now)
            self._keep(result)
            self._signal_problem(result)
        return result

    def _lookup(self, inputs: Inputs) -> _Result[T] | None:
        if self._found is not None and same(self._found[0], inputs):
            return self._found[1]
        result = next((r for r in self._results if same(r.inputs, inputs)), None)
        if result is not None and result is not self._results[0]:
            self._results.remove(result)
            self._results.appendleft(result)  # those not accessed for longest go first
        self._found = inputs, result
        return result

    def _keep(self, result: _Result[T]) -> None:
        self._results.appendleft(result)
        self._found = None

    def _signal_problem(self, result: _Result[T]) -> None:
        before, self._problem = self._problem, result.problem
        if result.problem not in ("", before):
            self.failed.emit(result.problem)

    def _start(self, delay_ms: int) -> None:
        """Compute the value of the newest inputs, unless the end of another computation does."""
        if self._job is not None:
            if self._job.begun and not self._stoppable:
                return
            self._cancel()
        inputs = self._newest
        if isinstance(inputs, tuple) and self._lookup(inputs) is None:
            self._job = run_in_background(
                partial(_work, self._compute, inputs, self._stoppable),
                on_result=self._take,
                on_error=lambda text: self._take(_Result(inputs, None, text)),
                owner=self,
                priority=self._priority,
                delay_ms=delay_ms,
            )

    def _cancel(self) -> None:
        if self._job is not None:
            self._job.cancel()
            self._job = None

    def _take(self, result: _Result[T]) -> None:
        self._job = None
        self._keep(result)
        self._start(0)
        if same(result.inputs, self._newest):
            self._signal_problem(result)
            self.changed.emit()


def _work(
    compute: Callable[..., T | None], inputs: Inputs, stoppable: bool, control: JobControl
) -> _Result[T]:
    if stoppable:
        compute = partial(compute, go_on=control.raise_if_cancelled)
    return _evaluate(compute, inputs)


def _evaluate(compute: Callable[..., T | None], inputs: Inputs) -> _Result[T]:
    try:
        return _Result(inputs, compute(*inputs))
    except ProccError as error:
        return _Result(inputs, None, str(error))


def _nothing() -> None:
    return None


def _give_way() -> None:
    """Let this thread, and the processes that it starts, yield to those that the user waits for."""
    if sys.platform == "linux":  # elsewhere no thread has a niceness of its own
        before = os.getpriority(os.PRIO_PROCESS, 0)
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), min(before + _NICER, 19))


def _cancel_each(jobs: WeakSet[Job]) -> None:
    for job in tuple(jobs):
        job.cancel()


@lru_cache(maxsize=1)
def _dispatcher() -> _Dispatcher:
    application = QCoreApplication.instance()
    if application is not None:
        application.aboutToQuit.connect(cancel_all)
    return _Dispatcher()
