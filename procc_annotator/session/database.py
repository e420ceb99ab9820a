"""The workspace's memory: what is known of a dataset's frames besides their annotations.

It lies in the dataset's ``.procc`` folder, or in the user's data folder when that cannot be
written. Annotations never depend on it, and nothing here makes the annotator wait or raises because
of the disk: what cannot be written yet is kept in memory, tried again, and named in ``problem``.
"""

from __future__ import annotations

import math
import sqlite3
import time
import uuid
import zlib
from collections.abc import Callable, Mapping
from concurrent.futures import Future
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

from procc_annotator.errors import InputError
from procc_annotator.session import database_rows as rows
from procc_annotator.session.database_file import (
    NewerError,
    Opened,
    data_version,
    database_path,
    open_database,
    own_path,
)
from procc_annotator.session.database_rows import Snapshot, Write, stored
from procc_annotator.session.database_writer import DatabaseWriter, UnavailableError
from procc_annotator.session.origins import (
    Comment,
    FrameRecord,
    Origin,
    OriginKind,
    PointKey,
    Status,
    Version,
    default_author,
    digest_of,
)

__all__ = [
    "Comment",
    "FrameRecord",
    "Origin",
    "OriginKind",
    "PointKey",
    "Status",
    "Version",
    "WorkspaceDatabase",
    "default_author",
]

T = TypeVar("T")

# How long the annotator may wait for something to be read: at most, and once it is known that the
# database cannot be reached.
_PATIENCE_S = 2.0
_NO_PATIENCE_S = 0.1

_UNTOUCHED = FrameRecord()


@dataclass(frozen=True)
class _Look:
    """What other processes made of the database, valid if nothing was changed here meanwhile."""

    changes: int
    frames: frozenset[str]
    snapshot: Snapshot


class WorkspaceDatabase:
    """Statuses, comments, origins, versions and drafts of a dataset's frames.

    Belongs to one thread (`record`, `records` and ``problem`` may be read from any). Frames are
    known by name, which may hold any characters.

    Attributes:
        path: the file; None when everything is in memory only and will be lost.
        author: signs comments and versions.
    """

    def __init__(
        self, path: Path | None, author: str, opened: Opened, notices: tuple[str, ...]
    ) -> None:
        self.path = path
        self.author = author
        self._notices = notices + opened.notices
        self._records = opened.snapshot.records
        self._comments = opened.snapshot.comments
        self._drafts = opened.snapshot.drafts
        self._meta = opened.snapshot.meta
        self._session = uuid.uuid4().hex[:16]
        self._seconds: dict[str, float] = {}  # spent in this session
        self._origins: dict[str, dict[PointKey, Origin]] = {}  # all of a frame's
        self._put: dict[str, dict[PointKey, Origin]] = {}  # those of this session
        self._newest: dict[str, bytes | None] = {}  # digests of versions
        self._changes = 0
        self._looking: Future[_Look | None] | None = None
        self._look_again = False
        # Of the writer's thread: which state of the file the memory was compared with last.
        self._seen: tuple[sqlite3.Connection | None, int] = (
            opened.connection,
            opened.data_version,
        )
        self._writer = DatabaseWriter(path, opened, self._everything, self._notify)

    @classmethod
    def open(cls, dataset: Path, author: str) -> WorkspaceDatabase:
        """Open a dataset's database, or begin one; never fails.

        What had to be done about a damaged, foreign or write-protected one is in `notices`.

        Args:
            dataset: its folder (or a picture in it).
            author: see `default_author`.
        """
        notices: list[str] = []
        own = own_path(dataset)
        for path in (database_path(dataset), *([own] if own is not None else [])):
            try:
                opened = open_database(path)
            except (sqlite3.Error, OSError, NewerError) as error:
                reason = getattr(error, "strerror", None) or " ".join(str(error).split())
                notices.append(f"{path}: cannot be used ({reason})")
                continue
            if notices:
                notices[-1] += f"; statuses and comments are kept in {path}"
            return cls(path, author, opened, tuple(notices))
        notices.append("statuses and comments are kept in memory only: they end with the window")
        return cls(None, author, open_database(None), tuple(notices))

    @property
    def notices(self) -> tuple[str, ...]:
        """What the user should know of the file, one line each; may grow."""
        return self._notices

    @property
    def problem(self) -> str:
        """Why the latest changes are not written, in one line; empty when they are."""
        return self._writer.problem

    def record(self, frame: str) -> FrameRecord:
        """What is remembered about a frame."""
        return self._records.get(frame, _UNTOUCHED)

    def records(self) -> Mapping[str, FrameRecord]:
        """All frames about which anything is remembered: a live view."""
        return MappingProxyType(self._records)

    def set_status(self, frame: str, status: Status) -> None:
        """Say how far a frame has come."""
        status = Status(status)
        if self.record(frame).status is not status:
            self._put_write(Write(rows.SET_STATUS, ((stored(frame), str(status)),)))
            self._records[frame] = replace(self.record(frame), status=status)

    def set_committed(self, frame: str, committed: bool) -> None:
        """Say whether a frame's clicks were declared final."""
        if self.record(frame).committed != committed:
            self._put_write(Write(rows.SET_COMMITTED, ((stored(frame), int(committed)),)))
            self._records[frame] = replace(self.record(frame), committed=bool(committed))

    def add_seconds(self, frame: str, seconds: float) -> None:
        """Add to the time spent on a frame; what no clock that runs forward says is left out."""
        if not (math.isfinite(seconds) and seconds > 0):
            return
        total = self._seconds.get(frame, 0.0) + seconds
        self._seconds[frame] = total
        self._put_write(Write(rows.SET_SECONDS, ((stored(frame), self._session, total),)))
        record = self.record(frame)
        self._records[frame] = replace(record, seconds=record.seconds + seconds)

    def add_comment(self, frame: str, text: str) -> Comment:
        """Remark something on a frame."""
        comment = Comment(uuid.uuid4().hex, frame, self.author, time.time(), text)
        self._put_write(rows.comment_write(comment))
        self._set_comments(frame, (*self.comments(frame), comment))
        return comment

    def comments(self, frame: str) -> tuple[Comment, ...]:
        """A frame's comments, oldest first (in the order written, whatever the clocks said)."""
        return self._comments.get(frame, ())

    def resolve_comment(self, comment_id: str, resolved: bool) -> None:
        """Settle a comment, or open it again; nothing happens when there is none of this id."""
        everywhere = (remark for remarks in self._comments.values() for remark in remarks)
        frame = next((remark.frame for remark in everywhere if remark.id == comment_id), None)
        if frame is None:
            return
        self._put_write(Write(rows.RESOLVE_COMMENT, ((stored(comment_id), int(resolved)),)))
        changed = tuple(
            replace(remark, resolved=bool(resolved)) if remark.id == comment_id else remark
            for remark in self.comments(frame)
        )
        self._set_comments(frame, changed)

    def comment_text(self, frame: str) -> str:
        """All that was remarked on a frame, to be searched."""
        return "\n".join(remark.text for remark in self.comments(frame))

    def origins(self, frame: str) -> dict[PointKey, Origin]:
        """Origins of a frame's points, as far as known, also of points no longer there.

        Read from the file the first time: up to two seconds when that does not answer, and then
        only what this session put there.
        """
        known = self._origins.get(frame)
        if known is None:
            put = self._put.get(frame, {})
            try:
                read = self._ask(lambda connection: rows.load_origins(connection, frame))
            except UnavailableError:
                return dict(put)
            known = self._origins[frame] = read | put
        return dict(known)

    def put_origins(self, frame: str, origins: Mapping[PointKey, Origin]) -> None:
        """Add or replace origins of a frame's points; points that are no numbers are left out."""
        kept = {
            (float(u), float(v)): origin
            for (u, v), origin in origins.items()
            if math.isfinite(u) and math.isfinite(v) and math.isfinite(origin.time)
        }
        if not kept:
            return
        self._put_write(rows.origins_write(frame, kept))
        self._put.setdefault(frame, {}).update(kept)
        if frame in self._origins:
            self._origins[frame].update(kept)

    def add_version(self, frame: str, data: bytes, reason: str) -> None:
        """Keep the bytes of a frame's annotation file, unless the newest version has the same."""
        digest = digest_of(data)
        row = (
            uuid.uuid4().hex,
            stored(frame),
            stored(self.author),
            time.time(),
            stored(reason),
            digest,
            bytes(data),
        )
        self._put_write(Write(rows.ADD_VERSION, (row,), raw=True))
        self._newest[frame] = digest

    def versions(self, frame: str) -> tuple[Version, ...]:
        """A frame's versions, newest first (in the order written, whatever the clocks said).

        Up to two seconds when the file does not answer, and then only those not written yet.
        """
        try:
            read = self._ask(lambda connection: rows.load_versions(connection, frame))
        except UnavailableError:
            read = ()
        known = {version.id for version in read}
        waiting = (rows.version_of(row) for row in reversed(self._unwritten_versions()))
        new = (one for one in waiting if one.frame == frame and one.id not in known)
        return (*new, *read)

    def version_data(self, version_id: str) -> bytes:
        """The bytes of a version.

        Raises:
            InputError: there is none of this id, or it cannot be read.
        """
        for row in self._unwritten_versions():
            if row[0] == version_id:
                return self._unpacked(rows.as_bytes(row[6]), rows.as_bytes(row[5]))
        try:
            found = self._ask(lambda connection: rows.load_version_data(connection, version_id))
        except UnavailableError as error:
            raise InputError(self._shown, f"version cannot be read ({error})") from error
        if found is None:
            raise InputError(self._shown, "there is no such version")
        return self._unpacked(*found)

    def newest_digest(self, frame: str) -> bytes | None:
        """The digest (`origins.digest_of`) of a frame's newest version, None when unknown."""
        if frame not in self._newest:
            try:
                self._newest[frame] = self._ask(
                    lambda connection: rows.load_newest_digest(connection, frame)
                )
            except UnavailableError:
                return None
        return self._newest[frame]

    def set_draft(self, frame: str, data: bytes | None) -> None:
        """Keep what is unfinished in a frame, or forget it (None)."""
        if self._drafts.get(frame) == data:
            return
        self._put_write(rows.draft_write(frame, data))
        if data is None:
            self._drafts.pop(frame, None)
        else:
            self._drafts[frame] = bytes(data)

    def draft(self, frame: str) -> bytes | None:
        """What was unfinished in a frame."""
        return self._drafts.get(frame)

    def drafts(self) -> tuple[str, ...]:
        """The frames in which something was unfinished."""
        return tuple(self._drafts)

    @property
    def last_frame(self) -> str | None:
        """The frame this author looked at last."""
        return self._meta.get(f"last frame of {self.author}")

    @last_frame.setter
    def last_frame(self, frame: str) -> None:
        key = f"last frame of {self.author}"
        if self._meta.get(key) != frame:
            self._put_write(Write(rows.SET_META, ((stored(key), stored(frame)),)))
            self._meta[key] = frame

    def poll(self) -> frozenset[str]:
        """Take over what other processes wrote; call it every few seconds, it never waits.

        Returns:
            The frames whose record, comments or draft changed, as the look begun by the call
            before found them.
        """
        looking = self._looking
        if looking is not None and not looking.done():
            return frozenset()
        changed = self._take(looking) if looking is not None else frozenset()
        self._looking = self._writer.submit(self._look)
        return changed

    def reload(self, timeout: float = _PATIENCE_S) -> frozenset[str]:
        """Like `poll`, but wait for the look (at most ``timeout`` s)."""
        looking = self._writer.submit(self._look)
        try:
            looking.exception(timeout)
        except TimeoutError:
            return frozenset()
        return self._take(looking)

    def flush(self, timeout: float = _PATIENCE_S) -> bool:
        """Write what is queued; whether all of it is written now."""
        return self._writer.flush(timeout)

    def close(self, timeout: float = 10.0) -> bool:
        """Write what is queued and let go of the file; whether all of it was written."""
        return self._writer.close(timeout)

    @property
    def _shown(self) -> str:
        return str(self.path or "memory")

    def _put_write(self, write: Write) -> None:
        self._writer.put(write)
        self._changes += 1  # after it is queued, so that no look misses it

    def _set_comments(self, frame: str, remarks: tuple[Comment, ...]) -> None:
        self._comments[frame] = remarks
        self._records[frame] = rows.with_comments(self.record(frame), remarks)

    def _ask(self, question: Callable[[sqlite3.Connection], T]) -> T:
        future = self._writer.submit(question)
        try:
            return future.result(_NO_PATIENCE_S if self.problem else _PATIENCE_S)
        except TimeoutError as error:
            future.cancel()
            raise UnavailableError("it does not answer") from error

    def _unwritten_versions(self) -> list[rows.Row]:
        writes = (w.packed() for w in self._writer.pending() if w.sql == rows.ADD_VERSION)
        return [row for write in writes for row in write.rows]

    def _unpacked(self, packed: bytes, digest: bytes) -> bytes:
        try:
            data = zlib.decompress(packed)
        except zlib.error as error:
            raise InputError(self._shown, "this version is damaged") from error
        if digest_of(data) != digest:
            raise InputError(self._shown, "this version is damaged")
        return data

    def _take(self, looking: Future[_Look | None]) -> frozenset[str]:
        if looking.exception() is not None:  # it is named in `problem`, and looked again
            return frozenset()
        look = looking.result()
        if look is None:
            return frozenset()
        self._origins.clear()
        self._newest.clear()
        if look.changes != self._changes:
            # Taking it over could undo what was changed here meanwhile: look again.
            self._look_again = True
            return frozenset()
        for frame in look.frames:
            if frame in look.snapshot.records:
                self._records[frame] = look.snapshot.records[frame]
            if frame in look.snapshot.comments:
                self._comments[frame] = look.snapshot.comments[frame]
            self._drafts.pop(frame, None)
            if frame in look.snapshot.drafts:
                self._drafts[frame] = look.snapshot.drafts[frame]
        self._meta = look.snapshot.meta
        return look.frames

    # What follows is called by the writer's thread.

    def _look(self, connection: sqlite3.Connection) -> _Look | None:
        version = data_version(connection)
        if self._seen == (connection, version) and not self._look_again:
            return None
        self._look_again = False
        changes = self._changes
        if self._writer.pending():
            self._look_again = True
            return None
        snapshot = rows.load(connection)
        self._seen = (connection, version)
        frames = _differences(self._records.copy(), snapshot.records)
        frames |= _differences(self._comments.copy(), snapshot.comments)
        frames |= _differences(self._drafts.copy(), snapshot.drafts)
        return _Look(changes, frames, snapshot)

    def _everything(self) -> list[Write]:
        records = self._records.copy()
        for frame, seconds in self._seconds.copy().items():
            # This session's are written as such.
            earlier = max(0.0, records[frame].seconds - seconds)
            records[frame] = replace(records[frame], seconds=earlier)
        snapshot = Snapshot(records, self._comments.copy(), self._drafts.copy(), self._meta.copy())
        return list(rows.snapshot_writes(snapshot, "before"))

    def _notify(self, notices: tuple[str, ...]) -> None:
        self._notices += notices


def _differences(known: dict[str, T], found: dict[str, T]) -> frozenset[str]:
    return frozenset(
        name for name in known.keys() | found.keys() if known.get(name) != found.get(name)
    )
