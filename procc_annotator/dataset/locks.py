"""Frame locks between windows and machines on one dataset folder.

A lock file holds the author; its modification time, renewed by each beat, shows that the lock is in
use; a minute without a beat frees the frame, and so does the end of its process on this machine. A
lock informs and never prevents saving, so no disk failure is raised here. Ages are measured by the
clock of the file server: against the time of a file made at the same moment next to it.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import socket
import time
import uuid
from contextlib import suppress
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from pathlib import Path

from procc_annotator.regular_file import read_head

EXPIRY_S = 60.0  # six beats of a window: a busy or sleeping machine may miss some
_LARGEST = 4096  # bytes of a lock file that are read


@lru_cache(maxsize=16)  # needed with every click
def _file_of(frame: str) -> str:
    """File name of a frame's lock; the hash keeps apart names that read alike once cleaned."""
    readable = re.sub(r"[^A-Za-z0-9_-]+", "_", frame)[:60]
    mark = hashlib.sha256(frame.encode("utf-8", "surrogatepass")).hexdigest()[:16]
    return f"{readable}-{mark}.lock"


@dataclass(frozen=True, slots=True)
class LockHolder:
    """Another person who is editing a frame.

    Attributes:
        author, host: as they named themselves; empty when the lock cannot be read.
        since: when they began, seconds since 1970 by their clock; 0 when unknown.
        age: seconds since their last beat.
    """

    author: str
    host: str
    since: float
    age: float


@dataclass(frozen=True, slots=True)
class _LockContent:
    author: str
    host: str
    machine: str  # see `_machine`
    pid: int
    session: str  # of one window
    since: float


def locks_folder(dataset: Path) -> Path:
    """Return the folder of a dataset's locks; a single picture's are its folder's."""
    return (dataset.parent if dataset.is_file() else dataset) / ".procc" / "locks"


class FrameLocks:
    """The locks of this window, and those of others. Belongs to one thread.

    Args:
        folder: see `locks_folder`; made with the first lock, but a dataset's own folder never is.
        author: shown to others.
    """

    def __init__(self, folder: Path, author: str) -> None:
        self._folder = folder
        self._me = _LockContent(
            author, socket.gethostname(), _machine(), os.getpid(), uuid.uuid4().hex, 0.0
        )
        self._held: dict[str, _LockContent] = {}

    @property
    def held(self) -> frozenset[str]:
        """The frames locked by this window, as of the last beat."""
        return frozenset(self._held)

    def set_author(self, author: str) -> None:
        """Show another name to others; in existing locks from the next beat on."""
        self._me = replace(self._me, author=author)
        self._held = {frame: replace(note, author=author) for frame, note in self._held.items()}

    def acquire(self, frame: str) -> LockHolder | None:
        """Lock a frame; an expired lock is taken over.

        Of two who take over one lock in the same moment both may believe it theirs until the next
        beat.

        Returns:
            None when it is ours now, or when the folder cannot be written (saving will report it)
            or is a link out of the dataset; else who has it.
        """
        if frame in self._held or self._leads_out():
            return None
        path, note = self._path(frame), replace(self._me, since=time.time())
        try:
            with suppress(FileNotFoundError, NotADirectoryError):
                if (holder := self._living_holder(path)) is not None:
                    return holder
            self._folder.parent.mkdir(exist_ok=True)
            self._folder.mkdir(exist_ok=True)
            self._write(path, note, new=not os.path.exists(path))
        except FileExistsError:  # another window was quicker
            return self.holder(frame)
        except OSError:
            return None
        self._held[frame] = note
        return None

    def holder(self, frame: str) -> LockHolder | None:
        """Return who else is editing a frame; a single `stat` when no one is."""
        if frame in self._held:
            return None
        try:
            return self._living_holder(self._path(frame))
        except OSError:  # no lock, or none that could be read
            return None

    def beat(self) -> frozenset[str]:
        """Renew the locks of this window; call it every ten seconds or so.

        Return the frames with a lost lock: taken by a person who saw no beat for long (a laptop
        asleep), or removed. A dataset out of reach loses nothing.
        """
        lost = set()
        for frame, note in self._held.items():
            path = self._path(frame)
            try:
                found = _read(path)
                ours = self._is_ours(found)
                if ours and found != note:  # the author changed
                    self._write(path, note)
                elif ours:
                    os.utime(path)
            except FileNotFoundError:
                ours = not self._folder.parent.parent.is_dir()
            except OSError:  # out of reach: the next beat may get through
                continue
            if not ours:
                lost.add(frame)
        for frame in lost:
            del self._held[frame]
        return frozenset(lost)

    def is_there(self, frame: str) -> bool:
        """Return whether the lock file of a frame exists."""
        return os.path.exists(os.path.join(self._folder, _file_of(frame)))

    def release(self, frame: str) -> None:
        """Give a frame back; a lock that another person has taken meanwhile stays."""
        if self._held.pop(frame, None) is None:
            return
        path = self._path(frame)
        with suppress(OSError):  # what cannot be removed expires
            if self._is_ours(_read(path)):
                path.unlink()

    def release_all(self) -> None:
        """Give all frames back."""
        for frame in list(self._held):
            self.release(frame)

    def _path(self, frame: str) -> Path:
        return self._folder / _file_of(frame)

    def _write(self, path: Path, note: _LockContent, *, new: bool = False) -> None:
        """Write a lock in one step; a new one fails if the file exists by now."""
        data = json.dumps(asdict(note)).encode("ascii")
        if new:
            _create(path, data)
            return
        fresh = path.with_name(f"{path.name}.{note.session[:16]}")
        _create(fresh, data)
        os.replace(fresh, path)

    def _leads_out(self) -> bool:
        """Return whether the folder is a link out of the dataset, which is not followed."""
        if self._folder.parent.name != ".procc":
            return False
        dataset = os.path.realpath(self._folder.parent.parent)
        return not Path(os.path.realpath(self._folder)).is_relative_to(dataset)

    def _living_holder(self, path: Path) -> LockHolder | None:
        """The holder of a lock file, or None for an expired one or our own."""
        os.stat(path)  # by far the most frequent answer, and the cheapest: there is none
        note = _read(path)
        if self._is_ours(note) or (note is not None and self._has_ended(note)):
            return None
        if (age := self._age(path)) > EXPIRY_S:
            return None
        if note is None:
            return LockHolder("", "", 0.0, age)
        return LockHolder(note.author, note.host, note.since, age)

    def _is_ours(self, note: _LockContent | None) -> bool:
        return note is not None and note.session == self._me.session

    def _has_ended(self, note: _LockContent) -> bool:
        """Return whether its process is known to be gone; False on other machines and Windows."""
        here = (note.host, note.machine) == (self._me.host, self._me.machine)
        if os.name != "posix" or not here:
            return False
        try:
            os.kill(note.pid, 0)
        except (ProcessLookupError, OverflowError):
            return True
        except OSError:  # another user's
            return False
        return False

    def _age(self, path: Path) -> float:
        """Seconds since a file was written, by the clock of the server; 0 if unknown.

        A time in the future counts like one in the past: the server's clock was set.
        """
        if self._leads_out():
            return 0.0
        probe = self._folder / f".clock-{uuid.uuid4().hex[:16]}"
        try:
            _create(probe, b"")
            now = os.stat(probe).st_mtime
        except OSError:  # a folder we cannot write: then nothing can be taken over either
            return 0.0
        finally:
            with suppress(OSError):
                probe.unlink()
        return abs(now - os.stat(path).st_mtime)


def _machine() -> str:
    """Start of the kernel and process namespace: containers may share a host name (Linux)."""
    with suppress(OSError):
        boot = Path("/proc/sys/kernel/random/boot_id").read_text(encoding="ascii").strip()
        return f"{boot} {os.readlink('/proc/self/ns/pid')}"
    return ""


def _create(path: Path, data: bytes) -> None:
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    descriptor = os.open(path, flags, 0o666)
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(data)
    except OSError:  # a full disk has room for the name only, which would pass for a lock
        with suppress(OSError):
            path.unlink()
        raise


def _read(path: Path) -> _LockContent | None:
    """Content of a lock; None for one that is half written, damaged or of an unknown kind."""
    try:
        entries = json.loads(read_head(path, _LARGEST))
        author, host, machine, session = (
            _line(entries[key]) for key in ("author", "host", "machine", "session")
        )
        pid, since = entries["pid"], float(entries["since"])
    except (ValueError, RecursionError, KeyError, TypeError):
        return None
    if not session or type(pid) is not int or pid <= 0 or not abs(since) < 1e12:
        return None
    return _LockContent(author, host, machine, pid, session, since)


def _line(text: object) -> str:
    return " ".join(text.split())[:200] if isinstance(text, str) else ""
