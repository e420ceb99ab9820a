"""Write a file so that it is either the old one or the new one, whatever happens meanwhile."""

from __future__ import annotations

import errno
import os
import secrets
import stat
from collections.abc import Callable
from contextlib import ExitStack, suppress
from pathlib import Path

from procc_annotator.errors import SaveError

_ADVICE = {
    errno.ENOSPC: "make room or choose another folder",
    errno.EDQUOT: "make room or choose another folder",
    errno.EACCES: "change its permissions or choose another folder",
    errno.EPERM: "change its permissions or choose another folder",
    errno.EROFS: "choose a folder that can be written to",
    errno.EIO: "check the drive or the connection and save again",
    errno.ESTALE: "check the drive or the connection and save again",
}
_OTHER_ADVICE = "try again or choose another folder"


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
    old or the new file, never a mixture; a leftover ``.procc-<random>.tmp`` is harmless.

    Args:
        path: the file; its folder must exist.
        data: the whole new content.
        inside: a folder that links are not followed out of: a dataset from elsewhere may hold one
            that leads to any file of its user.
        look_again: called when the new content is on the disk, which may take its time, right
            before it takes the name. What it raises is passed on, and the old file is intact.

    Raises:
        SaveError: anything failed, the file is write-protected or lies outside ``inside``; the old
            file is intact and the temporary one is removed.
    """
    target = Path(os.path.realpath(path))
    if inside is not None and not target.is_relative_to(os.path.realpath(inside)):
        raise SaveError(
            f"{path}: could not be saved: is a link that leads out of the dataset; not followed"
            f" (replace it by a file, or save to another folder than {inside})"
        )
    # Not named after the target, whose name may already be as long as the file system allows.
    temporary = target.with_name(f".procc-{secrets.token_hex(8)}.tmp")
    try:
        _write_synced(temporary, data, mode_to_keep(target))
        look_again()
        os.replace(temporary, target)
    except OSError as error:
        reason = error.strerror or str(error)
        advice = _ADVICE.get(error.errno or 0, _OTHER_ADVICE)
        raise SaveError(
            f"{path}: could not be saved: {reason} (the file on disk is as it was; {advice})"
        ) from error
    finally:
        # After a successful save there is none; also an interruption must not leave one.
        with suppress(OSError):
            temporary.unlink(missing_ok=True)
    _sync_folder(target.parent)


def remove(path: Path) -> None:
    """Remove a file, if there is one, and have the disk keep that it is gone.

    Raises:
        OSError: it could not be removed.
    """
    path.unlink(missing_ok=True)
    _sync_folder(path.parent)


def mode_to_keep(target: Path) -> int | None:
    """The permissions of a file that is to be replaced; None where there is none.

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
    # somebody protected on purpose.
    if not os.access(target, os.W_OK):
        raise PermissionError(errno.EACCES, "the file is write-protected")
    return stat.S_IMODE(mode)


def _write_synced(temporary: Path, data: bytes, mode: int | None) -> None:
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    descriptor = os.open(temporary, flags, 0o666)
    with ExitStack() as undone:
        undone.callback(os.close, descriptor)  # an open file could not be removed on Windows
        stream = os.fdopen(descriptor, "wb")
        undone.pop_all()  # from here on the stream closes it
    with stream as file:
        if mode is not None and hasattr(os, "fchmod"):
            os.fchmod(descriptor, mode)
        file.write(data)
        file.flush()
        os.fsync(descriptor)


def _sync_folder(folder: Path) -> None:
    # The rename has happened; a file system that cannot sync folders (some network drives, Windows)
    # does not make the save a failure.
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
