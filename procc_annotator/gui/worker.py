"""Long work off the interface thread, its outcome delivered on it.

Groups of threads share the work. What the user waits for (the fit of the frame on screen, its
ghosts, the points of a copied element) is ``urgent`` and never queues behind what walks through a
whole dataset (audits, exports, thumbnails), which gets a core only where no one else wants it.
What has to come ``at_once`` (the picture of the frame on screen, saving a click) is short, and
waits for neither.
"""

from __future__ import annotations

import itertools
import os
import sys
import threading
import weakref
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from functools import lru_cache, partial
from typing import Any, TypeVar
from weakref import WeakKeyDictionary, WeakSet

import shiboken6
from PySide6.QtCore import QCoreApplication, QObject, Qt, QTimer, Signal, Slot

from procc_annotator.error_log import one_line
from procc_annotator.errors import ProccError
from procc_annotator.translation import tr

T = TypeVar("T")

_WRITING_THREADS, _PROMPT_THREADS, _URGENT_THREADS, _PATIENT_THREADS = 2, 2, 2, 3
_NICER = 5  # than the interface


class Stopped(Exception):
    """Left the work: no one wants its result any more."""


class JobControl:
    """What the work sees of its job: where to report progress, and whether to stop."""

    def __init__(self, announce: Callable[[], None]) -> None:
        self._announce = announce
        self._stop = threading.Event()
        self._lock = threading.Lock()
        self._latest: tuple[int, int] | None = None
        self._parts: list[Any] = []

    @property
    def cancelled(self) -> bool:
        """True once no one wants the result any more; the work should return soon."""
        return self._stop.is_set()

    def progress(self, done: int, total: int) -> None:
        """Report progress; cheap, a burst of calls reaches the interface as its last one."""
        with self._lock:
            announced = self._latest is not None
            self._latest = (done, total)
        if not announced and not self.cancelled:
            self._announce()

    def hand_over(self, part: Any) -> None:
        """Give a part of what is found away; it arrives with the next progress, or the outcome."""
        with self._lock:
            self._parts.append(part)

    def progress_or_stop(self, done: int, total: int) -> None:
        """As `progress`, for work that knows nothing of jobs.

        Raises:
            Stopped: no one wants the result any more.
        """
        if self.cancelled:
            raise Stopped
        self.progress(done, total)

    def _take_progress(self) -> tuple[int, int] | None:
        with self._lock:
            latest, self._latest = self._latest, None
        return latest

    def _take_parts(self) -> list[Any]:
        with self._lock:
            parts, self._parts = self._parts, []
        return parts

    def _cancel(self) -> None:
        self._stop.set()


class Job:
    """Work under way; belongs to the interface thread, the working thread never sees it."""

    def __init__(
        self,
        control: JobControl,
        submit: Callable[[], Future[Any]],
        drop: Callable[[], object],
        on_result: Callable[[Any], object],
        on_error: Callable[[str], None] | None,
        on_progress: Callable[[int, int], None] | None,
        on_parts: Callable[[list[Any]], None] | None,
        owner: QObject | None,
    ) -> None:
        self._control = control
        self._submit = submit
        self._drop = drop
        self._future: Future[Any] | None = None
        self._patience: QTimer | None = None
        self._on_result = on_result
        self._on_error = on_error
        self._on_progress = on_progress
        self._on_parts = on_parts
        self._owner = None if owner is None else weakref.ref(owner)
        self._delivered = False

    @property
    def running(self) -> bool:
        """Return whether an outcome is still to be delivered."""
        return not self._delivered and not self._control.cancelled

    @property
    def begun(self) -> bool:
        """Return whether the work was given to a thread, which may still be busy with other
        work."""
        return self._future is not None

    def _begin(self) -> Future[Any]:
        """Give the work to a thread, unless that was done."""
        if self._future is None:
            self._patience = None
            self._future = self._submit()
        return self._future

    def _begin_in(self, wait_ms: int) -> None:
        self._patience = QTimer(singleShot=True, interval=wait_ms)
        self._patience.timeout.connect(self._begin)
        self._patience.start()

    def cancel(self) -> None:
        """Forget the work: nothing is delivered any more, and it is asked to stop."""
        self._control._cancel()
        if self._future is not None:
            self._future.cancel()
        else:
            # Qt may have ended before, with the program.
            if self._patience is not None and shiboken6.isValid(self._patience):
                self._patience.stop()
            self._drop()

    def stop(self) -> None:
        """As `cancel`, and wait until the work has come to its end: what it reads may go now."""
        self.cancel()
        if self._future is not None and not self._future.cancelled():
            wait([self._future])

    def finish(self, most_s: float | None = None) -> bool:
        """Wait for the work and deliver its outcome now; nothing happens once it is delivered.

        Args:
            most_s: wait so many seconds at most; then the work goes on as before.

        Returns:
            False if it takes longer.
        """
        if self.running:
            if not wait([self._begin()], most_s).done:
                return False
            self._deliver()
        return True

    def _wanted(self) -> bool:
        if self._owner is not None:
            owner = self._owner()
            if owner is None or not shiboken6.isValid(owner):
                self.cancel()
        return self.running

    def deliver_parts(self) -> None:
        """Deliver now what was passed on so far."""
        if self._on_parts is not None and self._wanted() and (parts := self._control._take_parts()):
            self._on_parts(parts)

    def _deliver_progress(self) -> None:
        self.deliver_parts()
        latest = self._control._take_progress()
        if latest is not None and self._on_progress is not None and self._wanted():
            self._on_progress(*latest)

    def _deliver(self) -> None:
        self._deliver_progress()
        if not self._wanted():
            return
        self._delivered = True
        future = self._begin()
        error = future.exception()
        if error is None:
            self._on_result(future.result())
        elif isinstance(error, ProccError) and self._on_error is not None:
            self._on_error(str(error))
        else:
            sys.excepthook(type(error), error, error.__traceback__)
            # Anyone who waits hears that it is over, or would wait for as long as the window is
            # open.
            if self._on_error is not None:
                self._on_error(_unexpected(error))


class _Desk(QObject):
    """Where threads leave word for the interface thread: only the number of a job crosses over."""

    progressed = Signal(int)
    done = Signal(int)

    def __init__(self) -> None:
        super().__init__()
        self.jobs: dict[int, Job] = {}
        self.numbers = itertools.count()
        self.urgent = ThreadPoolExecutor(_URGENT_THREADS, thread_name_prefix="urgent")
        self.writing = ThreadPoolExecutor(_WRITING_THREADS, thread_name_prefix="writing")
        self.prompt = ThreadPoolExecutor(_PROMPT_THREADS, thread_name_prefix="at once")  # not shown
        self.patient = ThreadPoolExecutor(
            _PATIENT_THREADS, thread_name_prefix="background", initializer=_give_way
        )
        self.held: list[tuple[Job, int | None]] | None = None  # until the window is there
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
    on_parts: Callable[[list[Any]], None] | None = None,
    owner: QObject | None = None,
    urgent: bool = False,
    at_once: bool = False,
    writes: bool = False,
    wait_ms: int | None = None,
) -> Job:
    """Run ``fn(control)`` in a thread; call from the interface thread.

    Args:
        fn: the work; may look at ``control.cancelled`` and call ``control.progress(done, total)``.
        on_result: receives what ``fn`` returned, on the interface thread.
        on_error: receives the one-line text of a `ProccError`. Any other exception is a bug: it
            goes to `sys.excepthook` as if it had been raised on the interface thread, and
            ``on_error`` receives a line that says so. None: the work raises nothing that a person
            could be foreseen, so that every exception of it is a bug.
        on_progress: receives (done, total).
        on_parts: receives what the work passed on since, before progress and outcome.
        owner: nothing is delivered any more once this object is gone, and what has not begun by
            then never does.
        urgent: the user waits for it, and it takes a second at most.
        at_once: it is short, and may not wait for what is urgent either.
        writes: it writes down what the user did, and waits for nothing but the disk.
        wait_ms: begin so much later, and once what is to be painted was painted: 0 is after the
            next paint. None: at once.
    """
    desk = _desk()
    number = next(desk.numbers)
    control = JobControl(lambda: desk.progressed.emit(number))
    threads = desk.patient
    if writes:
        threads = desk.writing
    elif at_once:
        threads = desk.prompt
    elif urgent:
        threads = desk.urgent

    def submit() -> Future[T]:
        future = threads.submit(fn, control)
        future.add_done_callback(lambda _: desk.done.emit(number))
        return future

    drop = partial(desk.jobs.pop, number, None)
    job = Job(control, submit, drop, on_result, on_error, on_progress, on_parts, owner)
    desk.take(number, job, owner)
    if desk.held is not None and threads in (desk.urgent, desk.patient):
        desk.held.append((job, wait_ms))
    else:
        _begin(job, wait_ms)
    return job


def hold_back() -> None:
    """From now on begin nothing but what is short, until `let_go`: it would take the interpreter
    from a window that is being made and painted for the first time."""
    _desk().held = []


def let_go() -> None:
    """Begin all that was held back, and from now on everything at once."""
    desk = _desk()
    held, desk.held = desk.held or [], None
    for job, wait_ms in held:
        if job.running:
            _begin(job, wait_ms)


def _begin(job: Job, wait_ms: int | None) -> None:
    if wait_ms is None:
        job._begin()
    else:
        job._begin_in(wait_ms)


def cancel_all() -> None:
    """Cancel every job under way; the program waits for its threads at its end."""
    for job in tuple(_desk().jobs.values()):
        job.cancel()


def _give_way() -> None:
    """Let this thread, and the processes that it starts, yield to those that the user waits for."""
    if sys.platform == "linux":  # elsewhere no thread has a niceness of its own
        before = os.getpriority(os.PRIO_PROCESS, 0)
        os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), min(before + _NICER, 19))


def _unexpected(error: BaseException) -> str:
    return tr("unexpected error ({what})", what=one_line(error))


def _cancel_each(jobs: WeakSet[Job]) -> None:
    for job in tuple(jobs):
        job.cancel()


@lru_cache(maxsize=1)
def _desk() -> _Desk:
    application = QCoreApplication.instance()
    if application is not None:
        application.aboutToQuit.connect(cancel_all)
    return _Desk()
