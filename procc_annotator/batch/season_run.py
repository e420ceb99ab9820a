"""Do the plans of matches: hand out their units, keep what came of them, try again what failed."""

from __future__ import annotations

import time
import traceback
from collections import deque
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Generic, Protocol, TypeVar

import cv2

from procc_annotator.batch.execution.executor import Executor, Work
from procc_annotator.batch.unit_store import FAILED, MATCH, WAITING, Unit, UnitStore
from procc_annotator.errors import ProccError

R = TypeVar("R")


class WorkUnit(Protocol):
    """A unit as plans make it, which survives the trip to a worker.

    Attributes:
        key: names it and all that its result depends on. match: that it is of.
        kind: of work. frames: how many it is about.
    """

    @property
    def key(self) -> str: ...
    @property
    def match(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def frames(self) -> int: ...


# Rounds of units that do not wait for each other -> their results by key, of one that was set aside
# the error -> what the match comes to.
Plan = Generator[Sequence[WorkUnit], Mapping[str, Any], R]


@dataclass(frozen=True, eq=False)
class Attempt:
    """What came of a unit in a worker.

    Attributes:
        result: None if it failed. seconds: that it took.
        error: why it failed; where that is a fault of this program, with its place.
    """

    unit: WorkUnit
    result: Any = None
    seconds: float = 0.0
    error: str = ""


# What files, machines and numbers of one unit may lead to; anything else is a fault of this
# program, which ends the run.
_FAILURES = (ProccError, OSError, MemoryError, ArithmeticError, ValueError, cv2.error)


@dataclass(frozen=True)
class AttemptUnit:
    """Does units; a season goes on without those that fail."""

    task: Callable[[Any], Any]

    def __call__(self, unit: WorkUnit) -> Attempt:
        began = time.perf_counter()
        try:
            result, error = self.task(unit), ""
        except _FAILURES as failure:
            place = traceback.extract_tb(failure.__traceback__)[-1]
            where = f" ({Path(place.filename).name}:{place.lineno})"
            own = isinstance(failure, ProccError)
            result, error = None, f"{failure}" if own else f"{failure!r}{where}"
        return Attempt(unit, result, time.perf_counter() - began, error)


@dataclass(eq=False)
class _Round(Generic[R]):
    """A match under way: the results of its present round, and the units that are missing."""

    plan: Plan[R]
    results: dict[str, Any] = field(default_factory=dict)
    missing: set[str] = field(default_factory=set)


class SeasonRun(Generic[R]):
    """Does the plans of matches; those of one stadium one after the other, as the next one begins
    with what the one before knows.

    Attributes:
        store: of units. executor: who does them.
        on_attempt: called with what came of each unit, and what is kept of it.
    """

    def __init__(
        self,
        task: Callable[[Any], Any],
        store: UnitStore,
        executor: Executor,
        evidence: Callable[[Any], tuple[float | None, int]] = lambda _: (None, 0),
        on_attempt: Callable[[Attempt, Unit], None] = lambda *_: None,
    ) -> None:
        """Nothing is done yet.

        Args:
            task: unit -> result, see `AttemptUnit`.
            evidence: of a result, and how many frames have a camera, see `Unit`.
        """
        self.store = store
        self.executor = executor
        self.on_attempt = on_attempt
        self._task, self._evidence = task, evidence
        self._ready: deque[WorkUnit] = deque()
        self._under_way: dict[str, _Round[R]] = {}
        self._finished: deque[tuple[str, R]] = deque()

    def run(
        self,
        matches: Mapping[str, str],
        begin: Callable[[str], Plan[R]],
        recover: Callable[[WorkUnit], Any] = lambda _: None,
    ) -> Iterator[tuple[str, R]]:
        """What each match comes to, as soon as it is known.

        Args:
            matches: name -> stadium, empty if that is not known; in their order.
            begin: makes the plan of a match, when it is its turn.
            recover: result of a unit that was done before, if it is not in the store any more.
        """
        waiting = dict(matches)
        for name in matches if len(matches) > 1 else ():
            if self.store.unit(f"{name}/{MATCH}") is None:
                self.store.announce(name)

        def units() -> Iterator[WorkUnit | None]:
            while True:
                if self._ready:
                    yield self._ready.popleft()
                elif (name := self._startable(waiting, matches)) is not None:
                    del waiting[name]
                    try:
                        self._under_way[name] = _Round(begin(name))
                    except ProccError as error:
                        if len(matches) == 1:
                            raise
                        whole = Unit(f"{name}/{MATCH}", name, MATCH, error=str(error))
                        kept = self.store.fail(whole, last=True)
                        self.on_attempt(Attempt(kept, error=kept.error), kept)
                    else:
                        self._advance(name, None, recover)
                elif self._under_way:
                    yield None
                else:
                    return

        work = Work[WorkUnit, Attempt](
            AttemptUnit(self._task),
            units(),
            name=lambda unit: unit.key,
            ordered=False,
            lost=lambda unit, error: Attempt(unit, error=str(error)),
        )
        for attempt in self.executor.map(work):
            self._take(attempt, recover)
            yield from self._done()
        yield from self._done()

    def _done(self) -> Iterator[tuple[str, R]]:
        while self._finished:
            yield self._finished.popleft()

    def _startable(self, waiting: Iterable[str], stadiums: Mapping[str, str]) -> str | None:
        """The first match whose stadium no other one under way is in."""
        taken = {stadiums[name] for name in (*self._under_way, *(n for n, _ in self._finished))}
        for name in waiting:
            if not stadiums[name] or stadiums[name] not in taken:
                return name
        return None

    def _take(self, attempt: Attempt, recover: Callable[[WorkUnit], Any]) -> None:
        unit, before = attempt.unit, self.store.unit(attempt.unit.key)
        about: dict[str, Any] = {
            "match": unit.match,
            "kind": unit.kind,
            "frames": unit.frames,
            "tries": 1 + (before.tries if before else 0),
            "seconds": attempt.seconds + (before.seconds if before else 0.0),
        }
        if attempt.error:
            kept = self.store.fail(Unit(unit.key, error=attempt.error, **about))
        else:
            evidence, cameras = self._evidence(attempt.result)
            measured = {"evidence": evidence, "cameras": cameras}
            kept = self.store.add(unit.key, attempt.result, **measured, **about)
        self.on_attempt(attempt, kept)
        if kept.state == WAITING:
            self._ready.append(unit)
            return
        now = self._under_way[unit.match]
        now.results[unit.key] = attempt.error or attempt.result
        now.missing.discard(unit.key)
        if not now.missing:
            self._advance(unit.match, now.results, recover)

    def _advance(
        self, name: str, results: Mapping[str, Any] | None, recover: Callable[[WorkUnit], Any]
    ) -> None:
        """Ask the plan of a match for its next rounds, up to one with units that are not done."""
        now = self._under_way[name]
        while not now.missing:
            try:
                units = next(now.plan) if results is None else now.plan.send(results)
            except StopIteration as end:
                del self._under_way[name]
                self._finished.append((name, end.value))
                return
            now.results = results = {}
            for unit in units:
                kept = self.store.unit(unit.key)
                if kept is not None and kept.state == FAILED:
                    now.results[unit.key] = kept.error
                elif unit.key in self.store and (
                    (found := self.store.result(unit.key)) is not None
                    or (found := recover(unit)) is not None
                ):
                    now.results[unit.key] = found
                else:
                    now.missing.add(unit.key)
                    self._ready.append(unit)
