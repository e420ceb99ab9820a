"""Atomic file writes, temporary-file cleanup and inter-process file locks."""

from __future__ import annotations

import errno
import hashlib
import os
import secrets
import stat
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

from procc_annotator.errors import SaveError
from procc_annotator.regular_file import open_regular

if sys.platform == "win32":
    import msvcrt

    def try_lock(descriptor: int) -> bool:
        """Lock an open file for this process if no other one has; the lock ends with either."""
        try:
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True

else:
    import fcntl

    def try_lock(descriptor: int) -> bool:
        """Lock an open file for this process if no other one has; the lock ends with either.
        `OSError` if the file system knows no locks."""
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        return True


_ADVICE = {
    errno.ENOSPC: "make room or choose another folder",
    errno.EDQUOT: "make room or choose another folder",
    errno.EACCES: "change its permissions or choose another folder",
    errno.EPERM: "change its permissions or choose another folder",
    errno.ENAMETOOLONG: "choose a shorter name",
    errno.EROFS: "choose a folder that can be written to",
    errno.EIO: "check the drive or the connection and save again",
    errno.ESTALE: "check the drive or the connection and save again",
}
_OTHER_ADVICE = "try again or choose another folder"

_LONGEST_NAME = 255  # bytes, of a file system's entry
_STALE_S = 600.0
_swept: set[Path] = set()


def write_atomic(
    path: Path,
    data: bytes,
    *,
    inside: Path | None = None,
    look_again: Callable[[], object] = lambda: None,
) -> None:
    """Replace a file's content in one step; a symbolic link is followed, permissions are kept.

    The new content goes to a temporary file in the same folder, reaches the disk (fsync), takes the
    old name (rename), and the folder's entry reaches the disk too. A crash at any moment leaves the
    old or the new file, never a mixture; a leftover ``.procc-<random>.tmp`` is harmless, and
    removed by a later process that writes into the folder.

    Args:
        inside: a folder that links are not followed out of: a dataset from elsewhere may hold one
            that leads to any file of its user.
        look_again: called when the new content is on the disk, which may take its time, right
            before it takes the name. What it raises is passed on, and the old file is intact.

    Raises:
        SaveError: anything failed, the file is write-protected or lies outside ``inside``; the old
            file is intact and the temporary one is removed.
    """
    with open_replacing(path, inside=inside, look_again=look_again) as stream:
        stream.write(data)


@contextmanager
def open_replacing(
    path: Path,
    *,
    inside: Path | None = None,
    look_again: Callable[[], object] = lambda: None,
) -> Iterator[BinaryIO]:
    """A stream that replaces the content of a file if the block ends well, as `write_atomic`.
    `SaveError` as of `write_atomic`."""
    target = Path(os.path.realpath(path))
    if inside is not None and not target.is_relative_to(os.path.realpath(inside)):
        raise SaveError(
            f"{path}: could not be saved: is a link that leads out of the dataset; not followed"
            f" (replace it by a file, or save to another folder than {inside})"
        )
    # Not named after the target: that name may already be as long as the file system allows.
    temporary = target.with_name(f".procc-{secrets.token_hex(8)}.tmp")
    try:
        mode = mode_to_keep(target)
        with _created(temporary) as stream:
            if mode is not None and hasattr(os, "fchmod"):
                os.fchmod(stream.fileno(), mode)
            remove_stale(temporary)
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
        look_again()
        os.replace(temporary, target)
    except OSError as error:
        reason = error.strerror or str(error)
        raise SaveError(
            f"{path}: could not be saved: {reason} (the file on disk is as it was;"
            f" {advice_for(error)})"
        ) from error
    finally:
        # Gone after a successful save; an interruption must not leave one either.
        with suppress(OSError):
            temporary.unlink(missing_ok=True)
    _sync_folder(target.parent)


def make_folder(path: Path) -> None:
    """Make a folder and those above it, unless it is there. `SaveError` if it cannot be made."""
    try:
        path.mkdir(parents=True, exist_ok=True)
    except (FileExistsError, NotADirectoryError) as error:
        file = next(place for place in (path, *path.parents) if place.exists())
        raise SaveError(
            f"{path}: cannot be made: {file} is a file, expected a folder; choose another place"
        ) from error
    except OSError as error:
        raise SaveError(f"{path}: cannot be made: {error.strerror or error}") from error


def advice_for(error: OSError) -> str:
    """Return what to do about a file that cannot be written."""
    return _ADVICE.get(error.errno or 0, _OTHER_ADVICE)


def remove_stale(fresh: Path) -> None:
    """Remove temporary files that killed processes left in the folder of a file that was made just
    now, as its file system's clock has it; once in a process.

    A file that a living process on this machine writes is locked by it; others are left alone for
    ten minutes, in which a process on another machine writes to its file or renames it.
    """
    if fresh.parent in _swept:
        return
    _swept.add(fresh.parent)
    with suppress(OSError), os.scandir(fresh.parent) as entries:
        old = fresh.stat().st_mtime - _STALE_S
        for entry in entries:
            name = entry.name
            if name.startswith(".procc-") and name.endswith(".tmp") and _is_stale(entry, old):
                with suppress(OSError):
                    os.unlink(entry.path)


def _is_stale(entry: os.DirEntry[str], old: float) -> bool:
    if not entry.is_file(follow_symlinks=False) or entry.stat().st_mtime > old:
        return False
    with open_regular(entry.path, "r+b") as file:
        return try_lock(file.fileno())


def sibling_path(path: Path, before: str, after: str) -> Path:
    """A path next to another one, named after it; the name is cut if it gets too long."""
    name = os.fsencode(path.name)
    if len(os.fsencode(before)) + len(name) + len(os.fsencode(after)) > _LONGEST_NAME:
        kept, digest = os.fsdecode(name[:100]), hashlib.sha256(name).hexdigest()[:16]
        return path.with_name(f"{before}{kept}-{digest}{after}")
    return path.with_name(f"{before}{path.name}{after}")


def remove(path: Path) -> None:
    """Remove a file, if there is one, and have the disk keep that it is gone. `SaveError` if it
    could not be removed."""
    try:
        path.unlink(missing_ok=True)
    except OSError as error:
        raise SaveError(f"{path}: could not be removed: {error.strerror or error}") from error
    _sync_folder(path.parent)


def mode_to_keep(target: Path) -> int | None:
    """The permissions of a file that is to be replaced; None if absent.

    Raises:
        OSError: it must not be replaced: it is no file, or write-protected.
    """
    try:
        mode = target.stat().st_mode
    except FileNotFoundError:
        return None
    if not stat.S_ISREG(mode):  # a rename would put a file in the place of a device
        raise OSError(errno.EINVAL, "a folder, a pipe or a device is in its place")
    # A rename needs no right to the file itself: without this look it would replace a file that
    # a person protected on purpose.
    if not os.access(target, os.W_OK):
        raise PermissionError(errno.EACCES, "the file is write-protected")
    return stat.S_IMODE(mode)


def _created(temporary: Path) -> BinaryIO:
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    descriptor = os.open(temporary, flags, 0o666)
    with ExitStack() as undone:
        undone.callback(os.close, descriptor)  # an open file could not be removed on Windows
        with suppress(OSError):
            try_lock(descriptor)
        stream = os.fdopen(descriptor, "wb")
        undone.pop_all()  # from here on the stream closes it
    return stream


def _sync_folder(folder: Path) -> None:
    # The rename has happened; a file system that cannot sync folders (some network drives, Windows)
    # does not make the save a failure.
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
