"""Output streams and targets: folder or zip archive, complete or absent."""

from __future__ import annotations

import io
import os
import shutil
import tempfile
import zipfile
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import IO, Any, Protocol, cast

from procc_annotator.errors import ProccError, SaveError
from procc_annotator.formats.atomic import make_folder, open_replacing, write_atomic
from procc_annotator.formats.cameras.writers import zip_entry
from procc_annotator.formats.strict_json import is_unicode, printable


class Interrupted(KeyboardInterrupt):
    """A person stopped the work: so many cameras of so many frames are written."""

    def __init__(self, written: int, total: int) -> None:
        super().__init__()
        self.written, self.total = written, total


class Target(Protocol):
    """Takes files by their names relative to it."""

    def write(self, name: str, data: bytes) -> None:
        """Write one file."""

    def stream(self, name: str) -> AbstractContextManager[IO[bytes]]:
        """A file too long to hold in memory."""


class _Folder:
    def __init__(self, path: Path) -> None:
        self._path = path

    def write(self, name: str, data: bytes) -> None:
        path = self._path / name
        make_folder(path.parent)
        write_atomic(path, data)

    def stream(self, name: str) -> AbstractContextManager[IO[bytes]]:
        make_folder(self._path)
        return open_replacing(self._path / name)


class _Archive:
    def __init__(self, archive: zipfile.ZipFile) -> None:
        self._archive = archive

    def write(self, name: str, data: bytes) -> None:
        self._archive.writestr(_zip_entry(name), data)

    @contextmanager
    def stream(self, name: str) -> Iterator[IO[bytes]]:
        # An archive takes one member at a time; two score files grow together.
        with tempfile.TemporaryFile() as waiting:
            yield waiting
            waiting.seek(0)
            with self._archive.open(_zip_entry(name), "w", force_zip64=True) as member:
                shutil.copyfileobj(waiting, member)


def is_archive(out: Path) -> bool:
    """Return whether the name asks for an archive."""
    return out.suffix.lower() == ".zip"


@contextmanager
def open_target(out: Path) -> Iterator[Target]:
    """A folder, made when something is written to it, or an archive if the name ends in ``.zip``.

    Raises:
        SaveError: writing failed; an archive is then not there at all.
    """
    if not is_archive(out):
        yield _Folder(out)
        return
    make_folder(out.parent)
    with open_replacing(out) as stream, zipfile.ZipFile(stream, "w") as archive:
        yield _Archive(archive)


def _zip_entry(name: str) -> zipfile.ZipInfo:
    if not is_unicode(name):
        raise SaveError(
            f"{printable(name)}: cannot be written to an archive: is no valid Unicode; rename the"
            " file it is of, or write to a folder"
        )
    return zip_entry(name)


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
    """A file as of `replacing`; that it cannot be written must not stop the work. `SaveError` if it
    cannot even be begun."""
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
