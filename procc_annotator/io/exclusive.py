"""One process at a time: for files that several read, change and write back.

The lock is the operating system's, on a small file beside the one it is for. It ends with the
process that has it, however that ends.
"""

from __future__ import annotations

import os
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from procc_annotator.errors import SaveError
from procc_annotator.io.atomic import sibling_path
from procc_annotator.io.file_lock import try_lock

_TRY_EVERY_S = 0.05


@contextmanager
def exclusive_lock(path: Path, *, timeout_s: float = 60.0) -> Iterator[None]:
    """Keep every other process that asks for the same path waiting.

    Args:
        path: the file to be changed; it need not exist.
        timeout_s: how long to wait for others.

    Raises:
        SaveError: another process has it all that time, or the folder cannot be written or locked.
    """
    target = Path(os.path.realpath(path))
    lock = sibling_path(target, ".", ".lock")
    try:
        descriptor = _acquire(lock, time.monotonic() + timeout_s)
    except TimeoutError as error:
        raise SaveError(
            f"{path}: could not be saved: another process has been writing it for {timeout_s:g} s"
            " (the file on disk is as it was; wait for that process and try again)"
        ) from error
    except OSError as error:
        raise SaveError(
            f"{path}: could not be saved: {lock.name} beside it cannot be made or locked:"
            f" {error.strerror or error} (choose another folder)"
        ) from error
    try:
        yield
    finally:
        # Removed while it is held: whoever waits for it sees that it is gone and makes another.
        with suppress(OSError):  # Windows keeps a file that is open; then it stays for the next
            lock.unlink()
        os.close(descriptor)


def _acquire(lock: Path, until: float) -> int:
    while True:
        descriptor = os.open(lock, os.O_RDWR | os.O_CREAT, 0o666)
        with ExitStack() as unless_kept:
            unless_kept.callback(os.close, descriptor)
            if try_lock(descriptor) and _is_still(lock, descriptor):
                unless_kept.pop_all()
                return descriptor
        if time.monotonic() > until:
            raise TimeoutError
        time.sleep(_TRY_EVERY_S)


def _is_still(lock: Path, descriptor: int) -> bool:
    """Whether the file that was locked is the one that others find by its name."""
    try:
        return os.path.samestat(os.stat(lock), os.fstat(descriptor))
    except FileNotFoundError:
        return False
