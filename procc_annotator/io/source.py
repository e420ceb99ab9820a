"""A folder, a single file or a zip archive, read alike.

Data sets are published as files in the top folder or all inside one split folder (``test/``); both
look the same here. Deeper files, hidden ones and macOS's resource forks do not count.
"""

from __future__ import annotations

import os
import zipfile
import zlib
from pathlib import Path, PurePosixPath
from types import TracebackType
from typing import Protocol, Self

from natsort import natsorted

from procc_annotator.errors import InputError, UsageError

# A folder with such a name stands where a file was expected; any other may be a split (``v1.2``).
_FILE_SUFFIXES = frozenset({".json", ".npy", ".txt", ".homographymatrix"})


class FileSource(Protocol):
    """Files by relative name (``00037.json``, ``test/00037.json``); never extracted, only read."""

    path: Path

    def files(self) -> list[str]:
        """Names of the files, in natural order."""

    def folders(self) -> list[str]:
        """Names of the folders at the top, in natural order."""

    def read(self, name: str) -> bytes:
        """A file's bytes; InputError when it cannot be read."""

    def display(self, name: str) -> str:
        """How to name a file to a person."""

    def __enter__(self) -> Self: ...

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None: ...


def open_source(path: Path) -> FileSource:
    """Open a folder, a zip archive, or a single file as a source of one.

    Raises:
        UsageError: there is nothing at the path.
        InputError: an archive that cannot be opened.
    """
    if path.is_dir():
        return FolderSource(path)
    if not path.exists():
        raise UsageError(f"{path}: no such file or folder")
    if path.suffix.lower() == ".zip":
        return ZipSource(path)
    return SingleFileSource(path)


class _NothingHeld:
    """Sources that open each file anew have nothing to close."""

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        return None


class FolderSource(_NothingHeld):
    """Files of a folder."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._folder = str(path)

    def files(self) -> list[str]:
        names, folders = _entries(self.path)
        if not names and len(folders) == 1:
            inner, _ = _entries(self.path / folders[0])
            names = [f"{folders[0]}/{name}" for name in inner]
        return natsorted(names)

    def folders(self) -> list[str]:
        return natsorted(_entries(self.path)[1])

    # Joined as text: pathlib would cost more here than reading the file.
    def read(self, name: str) -> bytes:
        return _read_file(self.display(name))

    def display(self, name: str) -> str:
        return os.path.join(self._folder, name)


class SingleFileSource(_NothingHeld):
    """One file, as a source that holds nothing else."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def files(self) -> list[str]:
        return [self.path.name]

    def folders(self) -> list[str]:
        return []

    def read(self, name: str) -> bytes:
        return _read_file(self.path.with_name(name))

    def display(self, name: str) -> str:
        return str(self.path)


class ZipSource:
    """Files of a zip archive; the archive stays open until the source is closed."""

    def __init__(self, path: Path) -> None:
        self.path = path
        try:
            self._archive = zipfile.ZipFile(path)
        except (zipfile.BadZipFile, OSError) as error:
            raise InputError(
                path, f"is not a readable zip archive: {error}", advice="download it again"
            ) from error

    def files(self) -> list[str]:
        # A member that was replaced by appending is listed twice; the later one counts.
        members = dict.fromkeys(self._archive.namelist())
        names = [n for n in members if not n.endswith("/") and _counts(n)]
        top = [n for n in names if "/" not in n]
        if not top:
            folders = {n.split("/", 1)[0] for n in names}
            top = [n for n in names if n.count("/") == 1] if len(folders) == 1 else []
        return natsorted(top)

    def folders(self) -> list[str]:
        inside = (n for n in self._archive.namelist() if "/" in n and _counts(n))
        return natsorted({n.split("/", 1)[0] for n in inside})

    def read(self, name: str) -> bytes:
        try:
            return self._archive.read(name)
        except (
            KeyError,
            zipfile.BadZipFile,
            zlib.error,
            OSError,
            RuntimeError,  # an encrypted member
            EOFError,
            NotImplementedError,  # a compression method this Python does not have
        ) as error:
            raise InputError(
                self.display(name),
                f"cannot be read: {error}",
                advice="unpack the archive to look at it, or download it again",
            ) from error

    def display(self, name: str) -> str:
        return f"{self.path}/{name}"

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._archive.close()


def _entries(folder: Path) -> tuple[list[str], list[str]]:
    """Names of everything that is not a folder, and of the folders; hidden ones left out.

    A folder named like a file (``00001.json/``) counts as a file, so that reading it is an error.
    """
    names: list[str] = []
    folders: list[str] = []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if not _counts(entry.name):
                    continue
                is_folder = entry.is_dir() and not _named_like_file(entry.name)
                (folders if is_folder else names).append(entry.name)
    except OSError as error:
        raise InputError(folder, f"cannot be listed: {error.strerror or error}") from error
    return names, folders


def _named_like_file(name: str) -> bool:
    return PurePosixPath(name).suffix.lower() in _FILE_SUFFIXES


def _counts(name: str) -> bool:
    parts = PurePosixPath(name).parts
    return bool(parts) and "__MACOSX" not in parts and not any(p.startswith(".") for p in parts)


def _read_file(path: Path | str) -> bytes:
    try:
        with open(path, "rb", buffering=0) as file:
            return file.read()
    except OSError as error:
        if os.path.isdir(path):
            raise InputError(
                path, "is a folder, expected a file", advice="move it elsewhere"
            ) from error
        raise InputError(
            path, f"cannot be read: {error.strerror or error}", advice="check its permissions"
        ) from error
