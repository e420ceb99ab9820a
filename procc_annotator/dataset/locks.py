"""Frame locks between windows and machines on one dataset folder."""

from __future__ import annotations

import hashlib
import json
import os
import re
import socket
import sys
import time
import uuid
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from procc_annotator.regular_file import open_regular, read_head


def machine_id() -> str:
    """Tells machines and containers of one name apart, and a machine before and after a restart.

    Empty where the system says nothing about it.
    """
    marks = []
    with suppress(OSError):  # Linux only
        with open("/proc/sys/kernel/random/boot_id", encoding="ascii") as file:
            marks.append(file.read().strip())
        marks.append(os.readlink("/proc/self/ns/pid"))  # a process id means nothing outside it
    return " ".join(marks)


if sys.platform == "win32":
    import ctypes

    def process_start(pid: int) -> str | None:
        """See below; ``os.kill(pid, 0)`` would end the process here."""
        query_limited_information, still_active, access_denied = 0x1000, 259, 5
        if not 0 < pid < 2**32:
            return None
        kernel = ctypes.WinDLL("kernel32", use_last_error=True)
        kernel.OpenProcess.restype = ctypes.c_void_p
        found = kernel.OpenProcess(query_limited_information, False, pid)
        if not found:
            return "" if ctypes.get_last_error() == access_denied else None
        handle = ctypes.c_void_p(found)
        try:
            code = ctypes.c_ulong()
            kernel.GetExitCodeProcess(handle, ctypes.byref(code))
            if code.value != still_active:
                return None
            times = [ctypes.c_ulonglong() for _ in range(4)]
            kernel.GetProcessTimes(handle, *(ctypes.byref(moment) for moment in times))
            return str(times[0].value)
        finally:
            kernel.CloseHandle(handle)

else:

    def process_start(pid: int) -> str | None:
        """When a process of this machine began, as the system counts; None when there is no such.

        Two processes that had the same id one after the other differ in it. Empty where the system
        does not say when a process began.
        """
        if pid <= 0:
            return None
        try:
            os.kill(pid, 0)
        except (ProcessLookupError, OverflowError):
            return None
        except PermissionError:  # somebody else's
            pass
        try:
            with open(f"/proc/{pid}/stat", "rb") as file:
                # The name in brackets may itself hold spaces and brackets.
                fields = file.read().rpartition(b")")[2].split()
        except OSError:  # no /proc here, or it ended this moment
            return ""
        state, start = fields[0], fields[19]
        return None if state in (b"Z", b"X") else start.decode("ascii")


_LARGEST = 4096  # bytes of a lock file that are looked at
_EMPTY_S = 3.0  # a lock is written as soon as it is made: one that stays empty is nobody's
_NOT_MADE = (FileNotFoundError, NotADirectoryError)


@lru_cache(maxsize=16)  # asked for with every click
def _file_of(frame: str) -> str:
    """Readable, but told apart by the hash: names may hold anything and be as long as allowed."""
    readable = re.sub(r"[^A-Za-z0-9_-]+", "_", frame)[:60]
    mark = hashlib.sha256(frame.encode("utf-8", "surrogatepass")).hexdigest()[:16]
    return f"{readable}-{mark}.lock"


@dataclass(frozen=True, slots=True)
class LockHolder:
    """Somebody else who is editing a frame.

    Attributes:
        author, host: as they named themselves; empty when the lock cannot be read.
        since: when they began, seconds since 1970 by their clock; 0 when unknown.
        age: seconds since they last said so.
    """

    author: str
    host: str
    since: float
    age: float


@dataclass(frozen=True, slots=True)
class _LockContent:
    """What a lock file says."""

    author: str
    host: str
    machine: str
    pid: int
    started: str
    session: str
    since: float
    beat: int = 0


def locks_folder(dataset: Path) -> Path:
    """Where the locks of a dataset lie; a single picture's are its folder's."""
    return (dataset.parent if dataset.is_file() else dataset) / ".procc" / "locks"


class FrameLocks:
    """The locks this window holds, and those of others. Belongs to one thread.

    Args:
        folder: see `locks_folder`; made with the first lock, but a dataset's own folder never is.
        author: shown to others.
        expiry_s: a lock that has not been refreshed for so long counts for nothing.
        host, pid, session: who we are; found out unless given.
    """

    def __init__(
        self,
        folder: Path,
        author: str,
        *,
        expiry_s: float = 60.0,
        host: str | None = None,
        pid: int | None = None,
        session: str | None = None,
    ) -> None:
        self._folder = folder
        self._expiry_s = expiry_s
        pid = os.getpid() if pid is None else pid
        self._me = _LockContent(
            author,
            socket.gethostname() if host is None else host,
            machine_id(),
            pid,
            process_start(pid) or "",
            uuid.uuid4().hex if session is None else session,
            0.0,
        )
        self._held: dict[str, _LockContent] = {}

    @property
    def held(self) -> frozenset[str]:
        """The frames locked by this window, as far as it knows."""
        return frozenset(self._held)

    def set_author(self, author: str) -> None:
        """Another name is shown to others; in locks that are held with the next beat."""
        self._me = replace(self._me, author=author)
        self._held = {frame: replace(note, author=author) for frame, note in self._held.items()}

    def acquire(self, frame: str) -> LockHolder | None:
        """Lock a frame; a lock left behind by a crash is taken over.

        Returns:
            None when it is ours now, or when the folder cannot be written (saving will tell) or is
            a link out of the dataset; else who has it.
        """
        if frame in self._held or self._leads_out():
            return None
        note = replace(self._me, since=time.time())
        for _ in range(3):  # between looking and taking, others may release and take
            try:
                holder = self._try(frame, note)
            except FileExistsError:
                continue
            except OSError:  # see the docstring: nothing to tell
                return None
            if holder is None:
                self._held[frame] = note
            return holder
        return self.holder(frame)

    def holder(self, frame: str) -> LockHolder | None:
        """Who else is editing a frame; costs one look for a file when nobody is."""
        if frame in self._held:
            return None
        try:
            return self._judge(self._path(frame))
        except OSError:  # no lock, or none that could be seen
            return None

    def beat(self) -> frozenset[str]:
        """Say that the locks of this window are still in use; call it every ten seconds or so.

        Returns:
            The frames whose lock was lost: taken by somebody who saw no beat for long (a laptop
            asleep), or removed. A dataset out of reach loses nothing.
        """
        lost = set()
        for frame, note in list(self._held.items()):
            newer = replace(note, beat=note.beat + 1)
            try:
                with open_regular(self._path(frame), "r+b") as file:
                    # Written into the same file: when somebody replaces it this moment, the beat
                    # goes nowhere instead of over their lock.
                    ours = self._is_ours(_parse(file.read(_LARGEST)))
                    if ours:
                        file.seek(0)
                        file.write(_text(newer))
                        file.truncate()
            except FileNotFoundError:
                ours = not self._folder.parent.parent.is_dir()
            except OSError:  # out of reach: the next beat may get through
                continue
            if ours:
                self._held[frame] = newer
            else:
                del self._held[frame]
                lost.add(frame)
        return frozenset(lost)

    def is_there(self, frame: str) -> bool:
        """Whether the lock file of a frame exists; one look at the folder."""
        return os.path.exists(os.path.join(self._folder, _file_of(frame)))

    def release(self, frame: str) -> None:
        """Give a frame back; a lock that somebody else has taken meanwhile stays."""
        if self._held.pop(frame, None) is None:
            return
        path = self._path(frame)
        with suppress(OSError):  # what cannot be removed expires
            if self._is_ours(_parse(_read(path))):
                path.unlink()

    def release_all(self) -> None:
        """Give all frames back."""
        for frame in list(self._held):
            self.release(frame)

    def _path(self, frame: str) -> Path:
        return self._folder / _file_of(frame)

    def _try(self, frame: str, note: _LockContent) -> LockHolder | None:
        """One attempt; raises FileExistsError when somebody was quicker."""
        path = self._path(frame)
        try:
            _create(path, _text(note))
        except _NOT_MADE:
            self._make_folder()
            _create(path, _text(note))
        except FileExistsError:
            try:
                holder = self._judge(path)
            except FileNotFoundError as error:
                raise FileExistsError(path) from error
            if holder is not None:
                return holder
            return self._take_over(path, note)
        return None

    def _leads_out(self) -> bool:
        """Whether the folder is a link out of the dataset, which is not followed."""
        if self._folder.parent.name != ".procc":
            return False
        dataset = os.path.realpath(self._folder.parent.parent)
        return not Path(os.path.realpath(self._folder)).is_relative_to(dataset)

    def _make_folder(self) -> None:
        with suppress(FileNotFoundError):
            self._folder.mkdir(exist_ok=True)
            return
        self._folder.parent.mkdir(exist_ok=True)
        self._folder.mkdir(exist_ok=True)

    def _take_over(self, path: Path, note: _LockContent) -> LockHolder | None:
        """Replace a dead lock. Who takes it must first get hold of a second file, and then look
        again: of two who saw it dead, the second finds the first one's lock."""
        token = path.with_name(f"{path.name}.taking")
        try:
            _create(token, b"")
        except FileExistsError:
            if self._age(token) > self._expiry_s:  # whoever was taking it crashed meanwhile
                token.unlink(missing_ok=True)
            raise
        try:
            holder = self._judge(path)
            if holder is None:
                fresh = path.with_name(f"{path.name}.{self._me.session[:16]}")
                _create(fresh, _text(note))
                os.replace(fresh, path)
            return holder
        finally:
            with suppress(OSError):
                token.unlink()

    def _judge(self, path: Path) -> LockHolder | None:
        """The living holder of a lock file, or None for a dead one or our own.

        Raises:
            OSError: there is none, or it cannot be looked at.
        """
        os.stat(path)  # by far the most frequent answer, and the cheapest: there is none
        data = _read(path)
        note = _parse(data)
        if self._is_ours(note) or (note is not None and self._has_ended(note)):
            return None
        age = self._age(path)
        if age > (self._expiry_s if data else _EMPTY_S):
            return None
        if note is None:
            return LockHolder("", "", 0.0, age)
        return LockHolder(note.author, note.host, note.since, age)

    def _is_ours(self, note: _LockContent | None) -> bool:
        return note is not None and note.session == self._me.session

    def _has_ended(self, note: _LockContent) -> bool:
        """Whether the process is known to be gone: only its own machine can tell."""
        if (note.host, note.machine) != (self._me.host, self._me.machine):
            return False
        started = process_start(note.pid)
        return started is None or bool(note.started and started and note.started != started)

    def _age(self, path: Path) -> float:
        """Seconds since a file was written, by the clock of the server; 0 when nobody can say.

        A time in the future counts like one in the past: the server's clock was set.
        """
        if self._leads_out():
            return 0.0
        probe = self._folder / f".clock-{uuid.uuid4().hex[:16]}"
        try:
            try:
                _create(probe, b"0")
            except OSError:  # a full disk takes an empty one
                _create(probe, b"")
            now = os.stat(probe).st_mtime
        except OSError:  # a folder we cannot write: then nothing can be taken over either
            return 0.0
        finally:
            with suppress(OSError):
                probe.unlink()
        return abs(now - os.stat(path).st_mtime)


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


def _read(path: Path) -> bytes:
    return read_head(path, _LARGEST)


def _text(note: _LockContent) -> bytes:
    entries = {name: getattr(note, name) for name in _LockContent.__slots__}
    return json.dumps(entries).encode("ascii")


def _parse(data: bytes) -> _LockContent | None:
    """What a lock says; None for one that is half written, damaged or not ours to understand."""
    try:
        entries = json.loads(data)
    except (ValueError, RecursionError):
        return None
    if not isinstance(entries, dict):
        return None
    texts = [entries.get(key) for key in ("author", "host", "machine", "started", "session")]
    numbers = [entries.get(key) for key in ("pid", "since", "beat")]
    author, host, machine, started, session = (_line(text) for text in texts)
    pid, since, beat = numbers
    if not session or type(pid) is not int or type(beat) is not int:
        return None
    began = float(since) if isinstance(since, (int, float)) and abs(since) < 1e12 else 0.0
    return _LockContent(author, host, machine, pid, started, session, began, beat)


def _line(text: object) -> str:
    """Text of a stranger's file, fit to be shown in one line."""
    return " ".join(text.split())[:200] if isinstance(text, str) else ""
