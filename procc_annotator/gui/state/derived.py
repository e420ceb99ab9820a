"""Values that follow from other values: never shown for others than those there are now."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto
from functools import partial
from typing import Generic, TypeVar

from PySide6.QtCore import QObject, Signal, SignalInstance

from procc_annotator.errors import ProccError
from procc_annotator.gui.soon import soon
from procc_annotator.gui.state.state import same
from procc_annotator.gui.state.store import Store, When
from procc_annotator.gui.worker import Job, JobControl, Stopped, run_in_background

T = TypeVar("T")
Inputs = tuple[object, ...]


class Where(Enum):
    """Where a value is computed."""

    AT_ONCE = auto()  # when it is asked for
    BESIDE = auto()  # in the background, begun after the next paint


@dataclass(frozen=True, eq=False, slots=True)
class _Answer(Generic[T]):
    """What became of some inputs."""

    inputs: Inputs
    value: T | None
    problem: str = ""


@dataclass(eq=False, slots=True)
class _Asked:
    """What the interface thread asks for, as the thread sees it that works it out."""

    newest: Inputs | str | None = None
    under_way: Inputs | None = None  # what is worked on, or was last


class Derived(QObject, Generic[T]):
    """A value and what it is worked out of.

    The inputs are asked for at every look, so that nothing is ever shown that was worked out of
    others. Two inputs are the same if they are one object, or small and equal (`state.same`):
    comparing what is in an annotation takes too long.

    In the background one computation is under way at most: while it is, whatever else is asked
    for waits, and only the newest of it is done.
    """

    changed = Signal()  # the value, or that it is worked out, or why there is none
    failed = Signal(str)  # why there is none; the same text once until it went well again

    def __init__(
        self,
        inputs: Callable[[], Inputs | str | None],
        compute: Callable[..., T | None],
        where: Where,
        parent: QObject | None = None,
        *,
        wanted: bool = True,
        kept: int = 1,
        kept_within: Callable[[], object] | None = None,
        stoppable: bool = False,
        urgent: bool = True,
        patience: Callable[[Inputs], int] | None = None,
    ) -> None:
        """Nothing is worked out before the first look.

        Args:
            inputs: what to give to ``compute``; None: there is nothing to work out; a text: neither
                is there, and this is why.
            compute: from any thread if it runs in the background; may raise `ProccError`.
            where: where, and when that is signalled.
            wanted: whether a person wants it from the beginning.
            kept: how many answers are kept, for inputs that come back.
            kept_within: they are forgotten once this is another one at a look: what is large may
                live no longer than what it is of.
            stoppable: ``compute`` takes ``go_on`` too, a function that raises `Stopped` once
                no one wants the answer.
            urgent: it takes a second at most (see `run_in_background`).
            patience: ms to wait before the background begins, by the inputs.
        """
        super().__init__(parent)
        self._inputs, self._compute, self._where = inputs, compute, where
        self._stoppable, self._urgent, self._patience = stoppable, urgent, patience
        self._answers: deque[_Answer[T]] = deque(maxlen=kept)
        self._kept_within = kept_within if kept_within is not None else _nothing
        self._within = self._kept_within()
        # What was looked up last: many ask for the same.
        self._looked: tuple[Inputs, _Answer[T] | None] | None = None
        self._asked = _Asked()
        self._job: Job | None = None
        self._told = ""
        self._wanted = wanted
        self._later = soon(self, self.look)

    # --- what is known ----------------------------------------------------------------------

    @property
    def value(self) -> T | None:
        """Of the present inputs; None while it is worked out, and if absent."""
        answer = self._answer(self._now())
        return None if answer is None else answer.value

    @property
    def problem(self) -> str:
        """Why there is no value; empty where there is one, while it is worked out, and where
        no one wants it."""
        now = self._now()
        if isinstance(now, str):
            return now
        answer = self._answer(now)
        return "" if answer is None else answer.problem

    @property
    def working(self) -> bool:
        """Return whether the value is still to come."""
        now = self._now()
        return isinstance(now, tuple) and self._answer(now) is None

    def known(self, *inputs: object) -> T | None:
        """Return what was found of some inputs, if that is kept."""
        answer = self._known(inputs)
        return None if answer is None else answer.value

    def answered(self, *inputs: object) -> bool:
        """Return whether some inputs were worked out, whether to nothing, and that is kept."""
        return self._known(inputs) is not None

    @property
    def latest(self) -> T | None:
        """Return what was found, or asked for and known, last; of whatever inputs."""
        return self._answers[0].value if self._answers else None

    @property
    def wanted(self) -> bool:
        """Return whether a person wants it; nothing is worked out otherwise."""
        return self._wanted

    def set_wanted(self, wanted: bool) -> None:
        """Whether a person wants it from now on."""
        if wanted != self._wanted:
            self._wanted, self._told = wanted, ""
            before = self._asked.newest
            self.look()
            if same(before, self._asked.newest):
                self.changed.emit()  # whoever shows that it is wanted

    # --- keeping up -------------------------------------------------------------------------

    def look(self) -> None:
        """The inputs may be others."""
        if (within := self._kept_within()) != self._within:
            self._within = within
            self.forget()
        before, now = self._asked.newest, self._now()
        if same(before, now):
            return
        self._asked.newest = now
        if self._where is Where.BESIDE:
            patience = self._patience
            self._begin(patience(now) if patience is not None and isinstance(now, tuple) else 0)
        self.changed.emit()

    def follow(self, store: Store, *signals: SignalInstance, when: When = When.AFTER_PAINT) -> None:
        """Look whenever the inputs differ: ``when`` the state has changed, and after signals of
        what is no part of the state."""
        store.watch(lambda _: self._now(), self.look, when)
        for signal in signals:
            signal.connect(self.look)

    def look_later(self) -> None:
        """As `look`, after the next paint: the value that is asked for is never an older one."""
        self._later.start()

    def try_again(self) -> None:
        """As `look`; what failed is tried anew, and only reported if it fails otherwise."""
        self.forget(failures_only=True)
        self.look()
        if self._where is Where.BESIDE:
            self._begin(0)

    def forget(self, *, failures_only: bool = False) -> None:
        """Keep no answer, or none that is a failure; look afterwards."""
        kept = [answer for answer in self._answers if failures_only and not answer.problem]
        self._answers, self._looked = deque(kept, self._answers.maxlen), None
        if not failures_only:
            self._asked.newest = None
            self._drop_job()  # or its answer would pass for a new one

    def close(self) -> None:
        """Work nothing out any more, and hold on to nothing."""
        self._inputs = _nothing
        self._later.stop()
        self.forget()

    # --- inside -----------------------------------------------------------------------------

    def _now(self) -> Inputs | str | None:
        return self._inputs() if self._wanted else None

    def _answer(self, now: Inputs | str | None) -> _Answer[T] | None:
        if not isinstance(now, tuple):
            return None
        answer = self._known(now)
        if answer is None and self._where is not Where.BESIDE:
            answer = _answer(self._compute, now)
            self._keep(answer)
            self._tell(answer)
        return answer

    def _known(self, inputs: Inputs) -> _Answer[T] | None:
        if self._looked is not None and same(self._looked[0], inputs):
            return self._looked[1]
        answer = next((a for a in self._answers if same(a.inputs, inputs)), None)
        if answer is not None and answer is not self._answers[0]:
            self._answers.remove(answer)
            self._answers.appendleft(answer)  # those that nobody asks for go first
        self._looked = inputs, answer
        return answer

    def _keep(self, answer: _Answer[T]) -> None:
        self._answers.appendleft(answer)
        self._looked = None

    def _tell(self, answer: _Answer[T]) -> None:
        before, self._told = self._told, answer.problem
        if answer.problem not in ("", before):
            self.failed.emit(answer.problem)

    def _begin(self, wait_ms: int) -> None:
        """Have the newest worked out, unless the end of what is under way sees to it."""
        if self._job is not None:
            if self._job.begun:
                return
            self._drop_job()
        asked = self._asked
        if isinstance(asked.newest, tuple) and self._known(asked.newest) is None:
            self._job = run_in_background(
                partial(_work, asked, self._compute, self._stoppable),
                on_result=self._take,
                on_error=self._take_bug,
                owner=self,
                urgent=self._urgent,
                wait_ms=wait_ms,
            )

    def _drop_job(self) -> None:
        if self._job is not None:
            self._job.cancel()
            self._job = None

    def _take(self, answer: _Answer[T] | None) -> None:
        self._job = None
        if answer is not None:
            self._keep(answer)
        self._begin(0)
        if answer is not None and same(answer.inputs, self._asked.newest):
            self._tell(answer)
            self.changed.emit()

    def _take_bug(self, text: str) -> None:
        """It is not tried again as long as the inputs are the same."""
        asked = self._asked.under_way
        self._take(None if asked is None else _Answer(asked, None, text))


def _work(
    asked: _Asked, compute: Callable[..., T | None], stoppable: bool, control: JobControl
) -> _Answer[T] | None:
    """In a thread: what is the newest once the thread is free; None if it is not any more."""
    inputs = asked.newest
    if not isinstance(inputs, tuple):
        return None
    asked.under_way = inputs

    def go_on() -> None:
        if control.cancelled or not same(inputs, asked.newest):
            raise Stopped

    try:
        return _answer(partial(compute, go_on=go_on) if stoppable else compute, inputs)
    except Stopped:
        return None


def _answer(compute: Callable[..., T | None], inputs: Inputs) -> _Answer[T]:
    try:
        return _Answer(inputs, compute(*inputs))
    except ProccError as error:
        return _Answer(inputs, None, str(error))


def _nothing() -> None:
    return None
