"""Files of scores that cannot be written must not take the figures along."""

from __future__ import annotations

import io
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any, cast

from procc_annotator.errors import ProccError, SaveError
from procc_annotator.io.atomic import open_replacing


class _Output(io.RawIOBase):
    """A stream that notes its first failure and takes no more from then on."""

    def __init__(self, stream: IO[bytes]) -> None:
        self._stream = stream
        self.failure: OSError | None = None

    def write(self, data: Any) -> int:
        return self._noting(self._stream.write, data) or len(data)

    def flush(self) -> None:
        self._noting(self._stream.flush)

    def sync(self) -> None:
        """Everything reaches the disk; raises what went wrong until then."""
        self.flush()
        self._noting(os.fsync, self._stream.fileno())
        if self.failure is not None:
            raise self.failure

    def _noting(self, do: Callable[..., Any], *arguments: Any) -> Any:
        if self.failure is not None:
            return None
        try:
            return do(*arguments)
        except OSError as error:
            self.failure = error
            return None


@contextmanager
def failure_tolerant_output(path: Path, unwritten: dict[Path, ProccError]) -> Iterator[IO[bytes]]:
    """A file as of `replacing`; that it cannot be written must not stop the work.

    Raises:
        SaveError: it cannot even be begun.
    """
    output: _Output | None = None
    try:
        with open_replacing(path) as stream:
            output = _Output(stream)
            yield cast(IO[bytes], output)
            output.sync()
    except SaveError as error:
        if output is None or output.failure is None:
            raise
        unwritten[path] = error
