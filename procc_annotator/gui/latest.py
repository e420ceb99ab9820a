"""Work next to the window of which only the latest counts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from PySide6.QtCore import QObject

from procc_annotator.gui.worker import Job, JobControl, run_in_background

T = TypeVar("T")


class Latest:
    """One piece of work at a time: another one has the one before forgotten."""

    def __init__(
        self,
        owner: QObject,
        failed: Callable[[str], None] | None,
        *,
        urgent: bool = False,
        at_once: bool = False,
        wait_ms: int | None = None,
    ) -> None:
        """Nothing is begun yet.

        Args:
            owner, urgent, at_once, wait_ms: as for `run_in_background`.
            failed: receives the reason of a failure, unless the work has a handler of its own; None
                if the work cannot fail.
        """
        self._owner = owner
        self._failed = failed
        self._urgent, self._at_once, self._wait_ms = urgent, at_once, wait_ms
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
        parts: Callable[[list[Any]], None] | None = None,
    ) -> None:
        """Begin; what is under way is cancelled. ``then`` receives the outcome, ``parts`` what the
        work passed on until then."""
        self.cancel()
        self._job = run_in_background(
            work,
            on_result=then,
            on_error=failed or self._failed,
            on_progress=progress,
            on_parts=parts,
            owner=self._owner,
            urgent=self._urgent,
            at_once=self._at_once,
            wait_ms=self._wait_ms,
        )

    def cancel(self) -> bool:
        """Forget what is under way; False if nothing is."""
        under_way = self.running
        if self._job is not None:
            self._job.cancel()
            self._job = None
        return under_way

    def cut_short(self) -> bool:
        """Take what was passed on so far and forget the rest; False if nothing is under way."""
        if self._job is not None:
            self._job.deliver_parts()
        return self.cancel()

    def finish(self, most_s: float | None = None) -> bool:
        """Wait for the outcome, as `Job.finish`."""
        return self._job is None or self._job.finish(most_s)
