"""Choose how work on a set is shared: in process, local processes or Dask.

A command cuts its frames into chunks and maps a task over them; the results come in the order of
the chunks anyone who computed them, so that sums made in that order are the same to the last digit.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from procc_annotator.errors import ProccError, UsageError

C = TypeVar("C")
R = TypeVar("R")

Progress = Callable[[Iterable[R], int, str], Iterator[R]]  # items, number, a word

# Starting a process costs about half a second: below this many scored frames one is as fast as
# many.
WORTH_WORKERS = 2000


@dataclass(frozen=True, eq=False)
class Work(Generic[C, R]):
    """A task, and the chunks that it is mapped over.

    Attributes:
        task: survives the trip to a worker, which keeps its copy between chunks: it may open files
            with its first chunk and keep them open. The ``close()`` of such a copy, if it has one,
            is called when the worker needs it no more.
        chunks: as much work each as is worth a trip: a tenth of a second or more. None stands for
            none before there are more results.
        name: how to name a chunk to a person, e.g. by its first and last frame.
        ordered: whether results come in the order of the chunks; else as they are made, so that a
            long chunk holds nothing up.
        lost: result of a chunk over which workers were lost again and again.
    """

    task: Callable[[C], R]
    chunks: Iterable[C | None]
    name: Callable[[C], str] = repr
    ordered: bool = True
    lost: Callable[[C, ProccError], R] | None = None


class Executor(Protocol):
    """Maps a task over chunks."""

    def map(self, work: Work[C, R]) -> Iterator[R]:
        """The results of the chunks; chunks are taken as results are.

        Closing the iterator, or an exception where it is used, gives up what is not done yet. A
        chunk whose worker is lost is done again.

        Raises:
            ProccError: as given to ``lost``, without one; or what the task raises.
        """


class InProcess:
    """Does everything here, chunk by chunk, when the result is asked for, with the task itself."""

    def map(self, work: Work[C, R]) -> Iterator[R]:
        """See `Executor.map`; nobody is lost here."""
        return (work.task(chunk) for chunk in work.chunks if chunk is not None)


def take_ready(chunks: Iterator[C | None], count: int) -> Iterator[C]:
    """Return up to so many chunks; fewer where there are none at present."""
    for _ in range(count):
        if (chunk := next(chunks, None)) is None:
            return
        yield chunk


@contextmanager
def make_executor(
    workers: int | None = None,
    dask: str | None = None,
    *,
    frames: int = 0,
    worth_from: int = WORTH_WORKERS,
) -> Iterator[Executor]:
    """The executor a command line asks for; whatever it started has ended when the block ends.

    Args:
        workers: processes on this machine; None for as many as suit the work and the machine.
        dask: address of a Dask scheduler, ``tcp://host:8786``; None for this machine.
        frames: how many there are to do.
        worth_from: number of frames from which several processes are faster than one.

    Raises:
        UsageError: both workers and a scheduler, or no address of a scheduler.
        ProccError: the cluster cannot be used: `distributed` is not installed, nothing answers at
            the address, it has no workers.
    """
    if dask is not None:
        if workers is not None:
            raise UsageError(
                "--workers is for this machine and --dask for a cluster: give one of them"
            )
        from procc_annotator.batch.execution.dask_cluster import DaskCluster

        with DaskCluster(dask) as cluster:
            yield cluster
        return
    count = workers or (usable_cpus() if frames >= worth_from else 1)
    if count == 1:
        yield InProcess()
        return
    from procc_annotator.batch.execution.process_pool import ProcessPool

    with ProcessPool(count) as pool:
        yield pool


def usable_cpus() -> int:
    """Number of CPUs this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
