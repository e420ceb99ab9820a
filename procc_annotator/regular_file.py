"""Opening files to read without ever waiting for a pipe, a socket or a device."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO


def open_regular(path: Path | str, mode: str = "rb", buffering: int = -1) -> BinaryIO:
    """Open a regular file; a link is followed.

    Anything else in its place is opened without waiting and refused by what was opened, so that
    nothing can take the file's place between the check and the opening.

    Raises:
        OSError: there is no file, it cannot be opened, or it is not a regular one.
    """
    return open(path, mode, buffering=buffering, opener=_open)  # type: ignore[return-value]


def read_head(path: Path | str, count: int) -> bytes:
    """The first bytes of a regular file. `OSError` as of `open_regular`."""
    with open_regular(path, buffering=0) as file:
        return file.read(count)


def _open(path: str, flags: int) -> int:
    try:
        descriptor = os.open(path, flags | getattr(os, "O_NONBLOCK", 0))
    except OSError as error:
        if error.errno == errno.ENXIO:  # a socket
            raise _refused(path) from error
        raise
    mode = os.fstat(descriptor).st_mode
    if stat.S_ISREG(mode):
        return descriptor
    os.close(descriptor)
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(errno.EISDIR, "is a folder, expected a file", path)
    raise _refused(path)


def _refused(path: str) -> OSError:
    return OSError(errno.EINVAL, "is a pipe, a socket or a device, expected a file", path)
