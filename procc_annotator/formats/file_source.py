"""Read a folder, a single file or a zip archive through one interface."""

from __future__ import annotations

import errno
import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache, partial
from pathlib import Path, PurePosixPath
from typing import Protocol, Self

from natsort import natsorted

from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.frame_names import escapes_folder
from procc_annotator.formats.strict_json import printable
from procc_annotator.regular_file import open_regular

# A folder with such a name stands where a file was expected; any other may be a split (``v1.2``).
_FILE_SUFFIXES = frozenset(
    {".json", ".npy", ".npz", ".mat", ".txt", ".homographymatrix", ".yml", ".yaml", ".xml"}
)
# Deeper folders, or more files than any set has, are a whole disk or a trap.
DEEPEST = 24
_MOST_ENTRIES = 1_000_000
_RESOURCE_FORKS = "__MACOSX"


def walk(
    root: Path, on_unread: Callable[[InputError], None] | None = None
) -> Iterator[tuple[str, list[str]]]:
    """Every folder below a place with the names in it that are not folders: the place itself
    first, then each folder before those in it, in natural order.

    A folder that is a link is not gone into: it may lead out, or in a circle.

    Args:
        on_unread: called for each folder below it that cannot be listed, which is then left out;
            None: that is raised.

    Yields:
        The folder below the place with a slash at its end (``game/img1/``; empty for the place
        itself), and its files' names in no order.

    Raises:
        InputError: a folder cannot be listed, or there are more, or deeper ones, than any set has.
    """
    waiting, met = [""], 0
    while waiting:
        folder = waiting.pop()
        if folder.count("/") > DEEPEST:
            raise too_deep_message(root)
        try:
            names, folders = entries(root / folder)
        except InputError as error:
            if on_unread is None or not folder:
                raise
            on_unread(error)
            continue
        met += len(names) + len(folders)
        if met > _MOST_ENTRIES:
            raise InputError(
                root,
                f"holds more than {_MOST_ENTRIES} files and folders",
                advice="name a folder further down",
            )
        yield folder, names
        inner = [f"{folder}{name}/" for name in natsorted(folders, reverse=True)]
        waiting += (name for name in inner if not os.path.islink(root / name.rstrip("/")))


def too_deep_message(path: Path) -> InputError:
    """Return the remark on a tree with folders deeper than `DEEPEST`."""
    return InputError(
        path, f"holds folders more than {DEEPEST} deep", advice="name a folder further down"
    )


def entries(folder: Path) -> tuple[list[str], list[str]]:
    """Names of everything that is not a folder, and of the folders; hidden ones left out.

    A folder named like a file (``00001.json/``) counts as a file, so that reading it is an error.
    """
    names: list[str] = []
    folders: list[str] = []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.name[0] == "." or entry.name == _RESOURCE_FORKS:
                    continue
                is_folder = _is_folder(entry) and not _named_like_file(entry.name)
                (folders if is_folder else names).append(entry.name)
    except OSError as error:
        raise InputError(folder, f"cannot be listed: {error.strerror or error}") from error
    return names, folders


def _is_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:  # a link in a circle is one file that cannot be read, not the end of the rest
        return False


def _named_like_file(name: str) -> bool:
    return PurePosixPath(name).suffix.lower() in _FILE_SUFFIXES


def suffix_of(name: str) -> str:
    """Lower-case suffix of a file's name, which may have its path."""
    return os.path.splitext(name)[1].lower()


def is_listed(name: str) -> bool:
    """Return whether a file or folder of this name, in an archive, is one to be listed."""
    parts = PurePosixPath(name).parts
    return (
        bool(parts) and _RESOURCE_FORKS not in parts and not any(p.startswith(".") for p in parts)
    )


def in_folders(names: Iterable[str]) -> list[str]:
    """Files in natural order as `walk` gives them: a folder's own before those of folders in it."""
    parts = map(os.path.split, names)
    order = natsorted(parts, key=lambda own: [own[0].split("/"), *os.path.splitext(own[1])])
    return [f"{folder}/{name}".lstrip("/") for folder, name in order]


# What a release keeps next to the folder of its annotations.
RELEASE_FILE = "release.json"
_RELEASED = "annotations/"
_LONGEST_NAME = 255  # of what a file system takes; an archive may hold any
# Annotations and cameras have a few kilobytes. A larger file is another one, or a zip bomb.
LARGEST_FILE = 50 * 1024 * 1024
_METHODS = frozenset({zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED})
# What zipfile raises for damage in one place or another; RuntimeError is an encrypted member.
_ZIP_ERRORS = (
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
    OSError,
    RuntimeError,
    EOFError,
    NotImplementedError,
    LookupError,
    ValueError,
    OverflowError,
    MemoryError,
)


class FileSource(Protocol):
    """Files by relative name (``00037.json``, ``test/00037.json``); never extracted, only read."""

    path: Path
    notices: tuple[str, ...]  # what a person should know of it
    decoded: tuple[str, ...]  # the files that these are made from, where they are no real ones

    def files(self) -> list[str]:
        """Names of the files at the top, or in the only folder there, in natural order."""

    def tree(self) -> list[str]:
        """Names of all files, however deep, folder after folder in natural order. `InputError` if a
        folder cannot be listed, or there are more, or deeper ones, than any set has."""

    def folders(self) -> list[str]:
        """Names of the folders at the top, in natural order."""

    def read(self, name: str) -> bytes:
        """A file's bytes; InputError when it cannot be read."""

    def display(self, name: str) -> str:
        """Return how to name a file to a person."""

    def opener(self, base: Path) -> Callable[[], FileSource]:
        """Opens the same once more, in another process; base as of `open_source`."""

    def __enter__(self) -> Self: ...

    def __exit__(self, *failure: object) -> None: ...


def open_source(path: Path, base: Path | None = None, of_tree: bool = False) -> FileSource:
    """Open a folder, a zip archive, or a single file as a source of one.

    Args:
        path: what to open; files are named to a person by it, as it is.
        base: the folder a relative path starts from, where that is not the current one (in a worker
            on another machine).
        of_tree: as of `FolderSource`.

    Raises:
        UsageError: there is nothing at the path.
        InputError: nothing at the path can be examined, or an archive that cannot be opened or
            holds a name that leads out of it.
    """
    try:
        if stat.S_ISDIR(os.stat(from_base(base, path)).st_mode):
            return FolderSource(path, base, of_tree)
        open_regular(from_base(base, path)).close()
    except (FileNotFoundError, NotADirectoryError, ValueError) as error:
        raise UsageError(f"{path}: no such file or folder") from error
    except OSError as error:
        raise _read_error(path, error) from error
    if path.suffix.lower() == ".zip":
        return ZipSource(path, base)
    return SingleFileSource(path, base)


def from_base(base: Path | None, path: Path) -> Path:
    """A path that starts from a folder, where one is given."""
    return path if base is None else base / path


class OpenedSource:
    """A source of files as they are; those that open each file anew have nothing to close."""

    path: Path
    notices: tuple[str, ...] = ()
    decoded: tuple[str, ...] = ()

    def folders(self) -> list[str]:
        return []

    def opener(self, base: Path) -> Callable[[], FileSource]:
        return partial(open_source, self.path, base)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *failure: object) -> None:
        return None


@lru_cache(maxsize=4)
def _in_order(names: tuple[str, ...]) -> tuple[str, ...]:
    return tuple(natsorted(names))


class FolderSource(OpenedSource):
    """Files of a folder.

    Attributes:
        of_tree: whether its only folder is one of a tree, which others have more of: its files do
            not count as those at the top.
    """

    def __init__(self, path: Path, base: Path | None = None, of_tree: bool = False) -> None:
        self.path = path
        self.of_tree = of_tree
        self._folder = str(path)
        self._place = str(from_base(base, path))

    def files(self) -> list[str]:
        names, folders = entries(Path(self._place))
        if not names and len(folders) == 1 and not self.of_tree:
            inner, _ = entries(Path(self._place, folders[0]))
            names = [f"{folders[0]}/{name}" for name in inner]
        return list(_in_order(tuple(names)))

    def tree(self) -> list[str]:
        found: list[str] = []
        for folder, names in walk(Path(self._place)):
            found += (f"{folder}{name}" for name in natsorted(names))
        return found

    def folders(self) -> list[str]:
        return natsorted(entries(Path(self._place))[1])

    # Joined as text: pathlib would cost more here than reading the file.
    def read(self, name: str) -> bytes:
        return read_file(os.path.join(self._place, name), shown_as=self.display(name))

    def display(self, name: str) -> str:
        return os.path.join(self._folder, name)

    def opener(self, base: Path) -> Callable[[], FileSource]:
        return partial(open_source, self.path, base, self.of_tree)


class SingleFileSource(OpenedSource):
    """One file, as a source that holds nothing else."""

    def __init__(self, path: Path, base: Path | None = None) -> None:
        self.path = path
        self._place = from_base(base, path)

    def files(self) -> list[str]:
        return [self.path.name]

    def tree(self) -> list[str]:
        return self.files()

    def read(self, name: str) -> bytes:
        return read_file(self._place.with_name(name), shown_as=self.path.with_name(name))

    def display(self, name: str) -> str:
        return str(self.path)


class ZipSource(OpenedSource):
    """Files of a zip archive; the archive stays open until the source is closed.

    Nothing is ever unpacked to disk, and yet an archive is refused as a whole when it holds a name
    that leads out of the folder it is unpacked to: no one made it by accident.
    """

    def __init__(self, path: Path, base: Path | None = None) -> None:
        self.path = path
        try:
            self._archive = zipfile.ZipFile(from_base(base, path))
        except _ZIP_ERRORS as error:
            raise InputError(
                path,
                f"is not a readable zip archive: {printable(str(error), 160)}",
                advice="download it again",
            ) from error
        # A member that was replaced by appending is listed twice; the later one counts.
        self._stored = {name.removeprefix("./"): name for name in self._archive.namelist()}
        members = self._members()
        # A packed tree of folders: its own name on top is that of the archive, not of frames.
        own = f"{path.stem}/"
        if members and all(n.startswith(own) and n.count("/") > 1 for n in members):
            self._have_only(own)
        elif RELEASE_FILE in members and any(n.startswith(_RELEASED) for n in members):
            self._have_only(_RELEASED)
        for member in self._archive.infolist():
            name = member.orig_filename  # as stored; zipfile may cut or translate the other one
            if escapes_folder(name):
                self._archive.close()
                raise InputError(
                    path,
                    f"holds the name {printable(name, 120)!r}, which leads out of the archive",
                    advice="the archive is not used: look at it, or make it anew",
                )

    def _have_only(self, folder: str) -> None:
        inside = (name for name in self._members() if name.startswith(folder))
        self._stored = {name.removeprefix(folder): self._stored[name] for name in inside}

    def files(self) -> list[str]:
        names = self._members()
        top = [n for n in names if "/" not in n]
        if not top:
            folders = {n.split("/", 1)[0] for n in names}
            top = [n for n in names if n.count("/") == 1] if len(folders) == 1 else []
        return natsorted(top)

    def tree(self) -> list[str]:
        names = self._members()
        if any(name.count("/") > DEEPEST for name in names):
            raise too_deep_message(self.path)
        return in_folders(names)

    def _members(self) -> list[str]:
        return [n for n in self._stored if not n.endswith("/") and is_listed(n)]

    def has(self, name: str) -> bool:
        """Return whether there is such a file."""
        return name in self._stored

    def names(self) -> list[str]:
        """Every name in the archive as stored, however deep, hidden or repeated."""
        return self._archive.namelist()

    def folders(self) -> list[str]:
        inside = (n for n in self._stored if "/" in n and is_listed(n))
        return natsorted({n.split("/", 1)[0] for n in inside})

    def read(self, name: str) -> bytes:
        try:
            member = self._archive.getinfo(self._stored.get(name, name))
            self._check(member)
            with self._archive.open(member) as file:
                # Never more than announced: the size in the archive's table may be a lie.
                return file.read(member.file_size + 1)
        except _ZIP_ERRORS as error:
            raise InputError(
                self.display(name),
                f"cannot be read: {printable(str(error), 160)}",
                advice="unpack the archive to look at it, or download it again",
            ) from error

    def _check(self, member: zipfile.ZipInfo) -> None:
        if member.file_size > LARGEST_FILE:
            raise _too_large(self.display(member.filename), member.file_size)
        if member.compress_type not in _METHODS:
            # The others cannot be read bit by bit, so that nothing would limit what comes out.
            raise InputError(
                self.display(member.filename),
                "is packed by an unusual method",
                advice="unpack the archive and pack it again as an ordinary zip",
            )

    def display(self, name: str) -> str:
        return f"{self.path}/{printable(name, _LONGEST_NAME)}"

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *failure: object) -> None:
        self._archive.close()


def read_file(
    path: Path | str,
    error: type[InputError] = InputError,
    *,
    shown_as: Path | str | None = None,
) -> bytes:
    """A regular file's bytes.

    Raises:
        error: it does not exist, cannot be read, is a folder, a pipe or a device (which would be
            waited for), or is larger than `LARGEST_FILE`. ``__cause__`` is the system's own error
            where there is one, FileNotFoundError for a missing file.
    """
    shown = path if shown_as is None else shown_as
    try:
        with open_regular(path, buffering=0) as file:
            size = os.fstat(file.fileno()).st_size
            if size > LARGEST_FILE:
                raise _too_large(shown, size, error)
            return file.read()
    except OSError as problem:
        raise _read_error(shown, problem, error) from problem


def _read_error(
    path: Path | str, problem: OSError, error: type[InputError] = InputError
) -> InputError:
    advice = "check its name" if isinstance(problem, FileNotFoundError) else "check its permissions"
    if problem.errno in (errno.EISDIR, errno.EINVAL):
        advice = "move it elsewhere"
    return error(path, f"cannot be read: {problem.strerror or problem}", advice=advice)


def read_optional(path: Path | str, error: type[InputError] = InputError) -> bytes | None:
    """As `read_file`; None where there is no such file.

    Raises:
        error: there is something else, or it cannot be read.
    """
    try:
        return read_file(path, error)
    except error as problem:
        if isinstance(problem.__cause__, FileNotFoundError | NotADirectoryError):
            return None
        raise


def _too_large(path: Path | str, size: int, error: type[InputError] = InputError) -> InputError:
    return error(
        path,
        f"holds {size / 1e6:.0f} MB, expected an annotation or a camera of at most"
        f" {LARGEST_FILE / 1e6:.0f} MB",
        advice="is it this file?",
    )
