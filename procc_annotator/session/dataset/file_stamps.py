"""How files looked when they were read, so that a cheap look tells which were written since."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping
from pathlib import Path
from typing import Generic, TypeVar

Stamp = tuple[int, int, int] | None  # time of change (ns), size, inode; None without a file

K = TypeVar("K", bound=Hashable)


def stamp_of(path: Path) -> Stamp:
    """What differs once a file was written; None where there is none."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino


class FileStamps(Generic[K]):
    """The stamps of files by whatever they are known by; safe to be used from several threads.

    A file keeps the stamp of its first reading until somebody followed the change: who reads it in
    between hides nothing from those who read it before.
    """

    def __init__(self) -> None:
        self._stamps: dict[K, Stamp] = {}

    def note(self, key: K, path: Path) -> None:
        """A file is about to be read."""
        if key not in self._stamps:
            self._stamps.setdefault(key, stamp_of(path))

    def take(self, key: K, stamp: Stamp) -> None:
        """All that was made from a file is made from this state of it now."""
        self._stamps[key] = stamp

    def renew(self, key: K, path: Path) -> bool:
        """Take a file as it is now; whether it is another one than was read."""
        before, now = self._stamps.get(key), stamp_of(path)
        known = key in self._stamps
        self._stamps[key] = now
        return known and now != before

    def keep(self, other: FileStamps[K], without: Mapping[K, Stamp]) -> None:
        """Take over what others know, but of these files."""
        for key, stamp in list(other._stamps.items()):
            if key not in without:
                self._stamps.setdefault(key, stamp)

    def changed(
        self,
        path_of: Callable[[K], Path],
        stopped: Callable[[], bool] = lambda: False,
        *,
        only: Iterable[K] | None = None,
    ) -> dict[K, Stamp]:
        """Files that are not as they were read, and how they are now; one look at each.

        Args:
            path_of: where a file is.
            stopped: whether to give up.
            only: look at these, as far as they were read.
        """
        found: dict[K, Stamp] = {}
        stamps = self._stamps
        asked = list(stamps) if only is None else [key for key in only if key in stamps]
        for key in asked:
            stamp = stamps[key]
            if stopped():
                break
            now = stamp_of(path_of(key))
            if now != stamp:
                found[key] = now
        return found
