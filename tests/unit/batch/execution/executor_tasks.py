"""Tasks for executors under test; workers import this module by its name."""

import os
import signal
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from procc_annotator.errors import CameraError


def with_pid(chunk: int) -> tuple[int, int]:
    return chunk, os.getpid()


def without_end(chunk: int) -> tuple[int, int]:
    """The first one is done at once."""
    if chunk:
        threading.Event().wait()
    return chunk, os.getpid()


def too_slow(chunk: int) -> int:
    raise TimeoutError(f"{chunk} was too slow")


@dataclass(frozen=True)
class Waiting:
    """The first chunk is done at once, the others when a file appears."""

    gate: Path

    def __call__(self, chunk: int) -> tuple[int, int]:
        until = time.monotonic() + 60
        while chunk and not self.gate.exists():
            if time.monotonic() > until:
                raise TimeoutError("nobody opened the gate")
            time.sleep(0.005)
        return chunk, os.getpid()


@dataclass(frozen=True)
class Killer:
    """Kills its worker with one chunk, the first few times."""

    task: Callable[[Any], Any]
    at: object
    marks: Path
    times: int = 1

    def __call__(self, chunk: Any) -> Any:
        if chunk == self.at:
            done = len(list(self.marks.iterdir()))
            if done < self.times:
                (self.marks / str(done)).touch()
                os.kill(os.getpid(), signal.SIGKILL)
        return self.task(chunk)


@dataclass(frozen=True)
class Failing:
    at: int

    def __call__(self, chunk: int) -> int:
        if chunk == self.at:
            raise CameraError("a.json", "is damaged", place="line 3", advice="mend it")
        return chunk


@dataclass(frozen=True)
class Counting:
    """Says how often the worker's copy was called and closed."""

    closed: Path
    calls: list[int] = field(default_factory=list)

    def __call__(self, chunk: int) -> tuple[int, int]:
        self.calls.append(chunk)
        return os.getpid(), len(self.calls)

    def close(self) -> None:
        (self.closed / f"{os.getpid()}-{id(self)}").touch()
