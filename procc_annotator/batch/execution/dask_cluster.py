"""Run chunks on an existing Dask cluster.

Workers read files by the paths they are given: the data must lie under the same path on every
machine. The scheduler repeats the chunks of a worker that is lost.
"""

from __future__ import annotations

import asyncio
import logging
import socket
import time
import uuid
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import CancelledError
from contextlib import ExitStack, contextmanager
from itertools import count, islice
from queue import Empty, SimpleQueue
from typing import Any, Self, TypeVar

from procc_annotator.batch.execution.executor import Work, take_ready
from procc_annotator.batch.execution.process_pool import run_chunk
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.messages import install_hint
from procc_annotator.version import __version__

C = TypeVar("C")
R = TypeVar("R")

ANSWER_S = 5.0  # how long a scheduler may take to answer
WORKERS_S = 10.0  # how long it may take until there is a first worker
LOST_S = 60.0  # how long there may be no worker in the midst of the work
_LOOK_S = 5.0  # how often workers are counted while waiting
_SMALLEST_WINDOW = 4  # chunks under way, also on a cluster that has yet to grow


class LostWorkError(ProccError):
    """Worker after worker was lost over one chunk."""


class DaskCluster:
    """See `Executor`; the cluster stays as it is when the block ends.

    Args:
        address: of the scheduler, ``tcp://host:8786`` (or ``tls://``, set up in Dask's own way).

    Raises:
        UsageError: no such address.
        ProccError: `distributed` is not installed, no scheduler answers, or it has no workers.
    """

    def __init__(self, address: str) -> None:
        self.address = address
        self._threads = 0
        self._counted_at = -_LOOK_S
        _require_distributed()
        with ExitStack() as ending:
            ending.enter_context(_library_quiet())
            _require_scheduler(address)
            from distributed import Client

            open_client: Any = Client  # the library has no types
            self._client = open_client(address, timeout=ANSWER_S, set_as_default=False)
            ending.callback(self._client.close)
            try:
                self._client.wait_for_workers(1, timeout=WORKERS_S)
            except TimeoutError as error:
                raise ProccError(
                    f"the Dask scheduler at {address} has no workers"
                    f" (start some with: dask worker {address})"
                ) from error
            self._ending = ending.pop_all()

    def map(self, work: Work[C, R]) -> Iterator[R]:
        """See `Executor.map`."""
        run = uuid.uuid4().hex
        more, keys = iter(work.chunks), (f"procc-annotator-{run}-{i}" for i in count())
        sent: dict[Any, C] = {}  # by their futures, in the order in which they were sent
        arrived: SimpleQueue[object] = SimpleQueue()
        try:
            while True:
                for chunk in take_ready(more, self._window() - len(sent)):
                    future = self._client.submit(
                        _run_same_version, __version__, run, work.task, chunk, key=next(keys),
                        pure=False,
                    )  # fmt: skip
                    sent[future] = chunk
                    future.add_done_callback(arrived.put)
                if not sent:
                    return
                future = self._first_done(sent, arrived, work.ordered)
                try:
                    result: R = self._result(future, sent[future], work.name)
                except LostWorkError as error:
                    if work.lost is None:
                        raise
                    result = work.lost(sent[future], error)
                del sent[future]
                yield result
        finally:
            if sent and self._client.status == "running":
                self._client.cancel(list(sent), force=True)

    def _first_done(self, sent: Iterable[Any], arrived: SimpleQueue[object], ordered: bool) -> Any:
        """Wait for a result, if ordered for the first one.

        To give up a result that is just being fetched would leave the client with a fetch that was
        called off, which the next one would join.
        """
        nobody_since: float | None = None
        while True:
            for future in islice(sent, 1 if ordered else None):
                if future.done():
                    return future
            try:
                arrived.get(timeout=_LOOK_S)
            except Empty:
                nobody_since = self._require_workers(nobody_since)

    def _result(self, future: Any, chunk: C, name: Callable[[C], str]) -> Any:
        from distributed import KilledWorker

        try:
            return future.result(timeout=LOST_S)
        except KilledWorker as error:
            raise LostWorkError(
                f"{name(chunk)}: worker after worker was lost over this part of the work,"
                " too little memory or a damaged file (look at these frames)"
            ) from error
        except CancelledError as error:
            raise self._disconnected() from error
        except RuntimeError as error:
            if not str(error).startswith("Error during deserialization"):
                raise
            raise ProccError(
                f"the Dask scheduler at {self.address} cannot take the work: {error.__cause__}"
                f" (install procc-annotator[dask] {__version__} on the scheduler and on every"
                " worker)"
            ) from error

    def _disconnected(self) -> ProccError:
        return ProccError(
            f"the connection to the Dask scheduler at {self.address} was lost"
            " (see whether it still runs, and try again)"
        )

    def _require_workers(self, nobody_since: float | None) -> float | None:
        """Since when there is no worker, None while there is one; too long is an error."""
        now = time.monotonic()
        if self._count_threads():
            return None
        if nobody_since is not None and now - nobody_since > LOST_S:
            raise ProccError(
                f"the Dask scheduler at {self.address} has lost all its workers"
                f" (start some with: dask worker {self.address})"
            )
        return now if nobody_since is None else nobody_since

    def _window(self) -> int:
        if time.monotonic() - self._counted_at > _LOOK_S:
            self._threads = self._count_threads()
            self._counted_at = time.monotonic()
        return max(_SMALLEST_WINDOW, 2 * self._threads)

    def _count_threads(self) -> int:
        if self._client.status != "running":
            return 0
        return int(sum(self._client.nthreads().values()))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *failure: object) -> None:
        self._ending.close()


@contextmanager
def _library_quiet() -> Iterator[None]:
    """What goes wrong is said here in one line; the library would log its tracebacks as well."""
    import distributed  # noqa: F401  (it sets up its loggers)

    loggers = [logging.getLogger(name) for name in ("distributed", "distributed.client")]
    before = [logger.level for logger in loggers]
    for logger in loggers:
        logger.setLevel(logging.CRITICAL)
    try:
        yield
    finally:
        for logger, level in zip(loggers, before, strict=True):
            logger.setLevel(level)


def _run_same_version(version: str, key: str, task: Callable[[C], R], chunk: C) -> R:
    if version != __version__:
        raise ProccError(
            f"a Dask worker has procc-annotator {__version__}, this is {version}: the figures might"
            " differ (install the same version everywhere)"
        )
    try:
        return run_chunk(key, task, chunk)
    except (UsageError, FileNotFoundError) as error:
        raise ProccError(
            f"{error} (on {socket.gethostname()}: the data must lie under the same path on every"
            " machine of the cluster)"
        ) from error


def _require_distributed() -> None:
    try:
        import distributed  # noqa: F401
    except ModuleNotFoundError as error:
        raise ProccError(
            "a Dask cluster needs the library distributed, which is not installed"
            f" ({install_hint('dask')})"
        ) from error


def _require_scheduler(address: str) -> None:
    """Ask who is there: a client of Dask would try for long, and say little."""
    try:
        kind = asyncio.run(_kind(address))
    except ValueError as error:
        raise UsageError(
            f"--dask: {address!r} is no address of a Dask scheduler, expected tcp://HOST:PORT"
            f" ({error})"
        ) from error
    except (OSError, TimeoutError) as error:
        raise ProccError(
            f"no Dask scheduler answers at {address} within {ANSWER_S:g} s"
            " (start one with: dask scheduler; or try without --dask)"
        ) from error
    if kind != "Scheduler":
        raise UsageError(f"--dask: at {address} is a {kind or 'stranger'}, not a Dask scheduler")


async def _kind(address: str) -> str:
    from distributed import rpc

    connect: Any = rpc
    remote = connect(address, timeout=ANSWER_S)
    try:
        answer = await asyncio.wait_for(remote.identity(), ANSWER_S)
        return str(answer.get("type", "")) if isinstance(answer, dict) else ""
    finally:
        await remote.close_rpc()
