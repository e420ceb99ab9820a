"""What is read from and written to the workspace database: statements, and rows as values."""

from __future__ import annotations

import re
import sqlite3
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field

from procc_annotator.session.database.tables import (
    BY_NAME,
    DamagedError,
    Row,
    as_bytes,
    as_fault,
    as_kind,
    as_number,
    as_status,
    as_text,
    as_text_or_none,
    stored,
)
from procc_annotator.session.facts.origins import (
    Comment,
    FrameRecord,
    NotVisible,
    Origin,
    PointKey,
    Status,
    Version,
    digest_of,
)
from procc_annotator.session.facts.verdict import Verdict

# Every statement may be run again with the same values without changing more: what was written
# before a failure whose extent nobody knows is simply written again.
SETTING_KEY = "setting "  # what a setting's key begins with among what else is kept by key

SET_META = "INSERT OR REPLACE INTO meta(key, value) VALUES(?1, ?2)"
SET_STATUS = (
    "INSERT INTO frame(name, status) VALUES(?1, ?2)"
    " ON CONFLICT(name) DO UPDATE SET status = excluded.status"
)
SET_COMMITTED = (
    "INSERT INTO frame(name, committed) VALUES(?1, ?2)"
    " ON CONFLICT(name) DO UPDATE SET committed = excluded.committed"
)
SET_SECONDS = (
    "INSERT INTO work(frame, session, seconds) VALUES(?1, ?2, ?3)"
    " ON CONFLICT(frame, session) DO UPDATE SET seconds = max(seconds, excluded.seconds)"
)
ADD_COMMENT = (
    "INSERT OR IGNORE INTO comment(id, frame, author, time, text, resolved)"
    " VALUES(?1, ?2, ?3, ?4, ?5, ?6)"
)
SET_COMMENT = (
    "INSERT INTO comment(id, frame, author, time, text, resolved)"
    " VALUES(?1, ?2, ?3, ?4, ?5, ?6)"
    " ON CONFLICT(id) DO UPDATE SET resolved = excluded.resolved"
)
PUT_ORIGIN = (
    "INSERT OR REPLACE INTO origin(frame, u, v, kind, author, time) VALUES(?1, ?2, ?3, ?4, ?5, ?6)"
)
ADD_VERSION = (
    "INSERT OR IGNORE INTO version(id, frame, author, time, reason, digest, data)"
    " SELECT ?1, ?2, ?3, ?4, ?5, ?6, ?7 WHERE ?6 IS NOT"
    " (SELECT digest FROM version WHERE frame = ?2 ORDER BY seq DESC LIMIT 1)"
)
SET_DRAFT = "INSERT OR REPLACE INTO draft(frame, data) VALUES(?1, ?2)"
SET_VERDICT = (
    "INSERT OR REPLACE INTO source_verdict(frame, place, source, fault, author, time, comment)"
    " VALUES(?1, ?2, ?3, ?4, ?5, ?6, ?7)"
)
# A row of the table there was before sources were known by their places.
SET_VERDICT_BY_NAME = (
    "INSERT OR REPLACE INTO source_verdict(frame, place, source, fault, author, time, comment)"
    f" VALUES(?1, {BY_NAME.format('?2')}, ?2, ?3, ?4, ?5, ?6)"
)
RENAME_SOURCE = "UPDATE source_verdict SET source = ?2 WHERE place = ?1"
SET_NOT_VISIBLE = (
    "INSERT OR REPLACE INTO not_visible(frame, element, hidden, author, time)"
    " VALUES(?1, ?2, ?3, ?4, ?5)"
)

_VERSIONS = "SELECT id, frame, author, time, reason FROM version WHERE frame = ?1 ORDER BY seq DESC"
_VERSION_DATA = "SELECT digest, data FROM version WHERE id = ?1"
_ORIGINS = "SELECT u, v, kind, author, time FROM origin WHERE frame = ?1"
_WORK = "SELECT frame, sum(seconds) FROM work GROUP BY frame"
_ALL_VERDICTS = "SELECT frame, source, place, fault, author, time, comment FROM source_verdict"
_ALL_NOT_VISIBLE = "SELECT frame, element, hidden, author, time FROM not_visible"
_COMMENTS = "SELECT id, frame, author, time, text, resolved FROM comment ORDER BY seq"

_ALL = (
    *(SET_META, SET_STATUS, SET_COMMITTED, SET_SECONDS, ADD_COMMENT, SET_COMMENT, PUT_ORIGIN),
    *(
        ADD_VERSION,
        SET_DRAFT,
        SET_VERDICT,
        SET_VERDICT_BY_NAME,
        RENAME_SOURCE,
        SET_NOT_VISIBLE,
        _VERSIONS,
        _VERSION_DATA,
        _ORIGINS,
        _ALL_NOT_VISIBLE,
    ),
)


@dataclass(frozen=True, slots=True)
class Write:
    """A statement and the rows to run it with.

    ``raw``: the last value of each row is still to be compressed (by the writer, not by whoever
    waits for the next click).
    """

    sql: str
    rows: tuple[Row, ...]
    raw: bool = False

    def packed(self) -> Write:
        """The same with nothing left to be compressed."""
        if not self.raw:
            return self
        rows = tuple((*row[:-1], zlib.compress(as_bytes(row[-1]))) for row in self.rows)
        return Write(self.sql, rows)


@dataclass
class Snapshot:
    """What is kept in memory; ``meta`` values are text."""

    records: dict[str, FrameRecord] = field(default_factory=dict)
    comments: dict[str, tuple[Comment, ...]] = field(default_factory=dict)  # by frame
    drafts: dict[str, bytes] = field(default_factory=dict)
    meta: dict[str, str] = field(default_factory=dict)
    verdicts: dict[str, dict[str, Verdict]] = field(default_factory=dict)  # by frame and place
    not_visible: dict[str, dict[str, NotVisible]] = field(default_factory=dict)  # and by class


def check_statements(connection: sqlite3.Connection) -> None:
    """Have every statement understood, so that a wrong schema is found at once.

    Raises:
        sqlite3.Error: a table, a column or a constraint is not there.
    """
    for sql in _ALL:
        values = len(set(re.findall(r"\?\d", sql)))
        connection.execute("EXPLAIN " + sql, (None,) * values)


def load(connection: sqlite3.Connection) -> Snapshot:
    """Read everything that is kept in memory.

    Raises:
        sqlite3.Error: it cannot be read.
        DamagedError: a row is impossible.
    """
    comments: dict[str, list[Comment]] = {}
    for comment in _load_comments(connection):
        comments.setdefault(comment.frame, []).append(comment)
    worked = {as_text(frame): as_number(total) for frame, total in connection.execute(_WORK)}
    records: dict[str, FrameRecord] = {}
    for name, status, committed in connection.execute("SELECT name, status, committed FROM frame"):
        frame = as_text(name)
        records[frame] = FrameRecord(
            as_status(status) or Status.UNTOUCHED, bool(committed), worked.pop(frame, 0.0)
        )
    for frame, seconds in worked.items():
        records[frame] = FrameRecord(seconds=seconds)
    snapshot = Snapshot(records, {frame: tuple(all_) for frame, all_ in comments.items()})
    for frame, remarks in snapshot.comments.items():
        records[frame] = with_comments(records.get(frame, FrameRecord()), remarks)
    for name, data in connection.execute("SELECT frame, data FROM draft"):
        if as_bytes(data):
            snapshot.drafts[as_text(name)] = data
    for key, value in connection.execute("SELECT key, value FROM meta"):
        if (text := as_text_or_none(value)) is not None:
            snapshot.meta[as_text(key)] = text
    for verdict in _load_verdicts(connection):
        snapshot.verdicts.setdefault(verdict.frame, {})[verdict.place] = verdict
    for mark in _load_not_visible(connection):
        snapshot.not_visible.setdefault(mark.frame, {})[mark.class_name] = mark
    return snapshot


def _load_not_visible(connection: sqlite3.Connection) -> Iterator[NotVisible]:
    for frame, name, hidden, author, time in connection.execute(_ALL_NOT_VISIBLE):
        if as_number(hidden):
            yield NotVisible(as_text(frame), as_text(name), as_text(author), as_number(time))


def _load_verdicts(connection: sqlite3.Connection) -> Iterator[Verdict]:
    for frame, source, place, fault, author, time, comment in connection.execute(_ALL_VERDICTS):
        found = as_fault(fault)
        if found is not None:
            yield Verdict(
                as_text(frame),
                as_text(source),
                as_text(place),
                found,
                as_text(author),
                as_number(time),
                as_text(comment),
            )


def _load_comments(connection: sqlite3.Connection) -> Iterator[Comment]:
    for id_, frame, author, time, text, resolved in connection.execute(_COMMENTS):
        yield Comment(
            as_text(id_),
            as_text(frame),
            as_text(author),
            as_number(time),
            as_text(text),
            bool(resolved),
        )


def with_comments(record: FrameRecord, remarks: tuple[Comment, ...]) -> FrameRecord:
    """The record with its comments counted anew."""
    still_open = sum(not remark.resolved for remark in remarks)
    return FrameRecord(record.status, record.committed, record.seconds, still_open, len(remarks))


def load_origins(connection: sqlite3.Connection, frame: str) -> dict[PointKey, Origin]:
    """The origins of a frame's points.

    Raises:
        sqlite3.Error: they cannot be read.
        DamagedError: a row is impossible.
    """
    found: dict[PointKey, Origin] = {}
    for u, v, kind, author, time in connection.execute(_ORIGINS, (stored(frame),)):
        origin = Origin(as_kind(kind), as_text(author), as_number(time))
        found[as_number(u), as_number(v)] = origin
    return found


def load_versions(connection: sqlite3.Connection, frame: str) -> tuple[Version, ...]:
    """The versions of a frame, newest first.

    Raises:
        sqlite3.Error: they cannot be read.
        DamagedError: a row is impossible.
    """
    return tuple(version_of(row) for row in connection.execute(_VERSIONS, (stored(frame),)))


def version_of(row: Row) -> Version:
    """A version from its first five columns (id, frame, author, time, reason).

    Raises:
        DamagedError: the row is impossible.
    """
    id_, name, author, time, reason = row[:5]
    return Version(as_text(id_), as_text(name), as_text(author), as_number(time), as_text(reason))


def load_version_data(connection: sqlite3.Connection, id_: str) -> Row | None:
    """What `version_data_of` takes, or None when there is no such version.

    Raises:
        sqlite3.Error: it cannot be read.
    """
    row: Row | None = connection.execute(_VERSION_DATA, (stored(id_),)).fetchone()
    return row


def version_data_of(row: Row) -> bytes:
    """A version's data from its digest and what was compressed.

    Raises:
        DamagedError: they do not belong together.
    """
    digest, packed = row
    try:
        data = zlib.decompress(as_bytes(packed))
    except zlib.error as error:
        raise DamagedError("data that is none") from error
    if digest_of(data) != digest:
        raise DamagedError("data that is not what it was")
    return data


def draft_write(frame: str, data: bytes | None) -> Write:
    """Keep or forget a frame's draft."""
    return Write(SET_DRAFT, ((stored(frame), bytes(data or b"")),))


def comment_write(comment: Comment, sql: str = ADD_COMMENT) -> Write:
    """Add a comment, or with SET_COMMENT settle it."""
    row = (
        comment.id,
        stored(comment.frame),
        stored(comment.author),
        comment.time,
        stored(comment.text),
        int(comment.resolved),
    )
    return Write(sql, (row,))


def verdict_write(verdict: Verdict, *, withdrawn: bool = False) -> Write:
    """Give a frame a verdict under a source, or take it back."""
    row = (
        stored(verdict.frame),
        stored(verdict.place),
        stored(verdict.source),
        "" if withdrawn else str(verdict.fault),
        stored(verdict.author),
        verdict.time,
        stored(verdict.comment),
    )
    return Write(SET_VERDICT, (row,))


def not_visible_write(mark: NotVisible, *, withdrawn: bool = False) -> Write:
    """Say of an element that it cannot be seen in a frame, or that it can after all."""
    row = (
        stored(mark.frame),
        stored(mark.class_name),
        int(not withdrawn),
        stored(mark.author),
        mark.time,
    )
    return Write(SET_NOT_VISIBLE, (row,))


def meta_write(key: str, value: str | None) -> Write:
    """Keep a text by key, or (None) take it back."""
    return Write(SET_META, ((stored(key), None if value is None else stored(value)),))


def origins_write(frame: str, origins: dict[PointKey, Origin]) -> Write:
    """Add or replace origins of a frame's points."""
    name = stored(frame)
    rows = tuple(
        (name, u, v, origin.kind, stored(origin.author), origin.time)
        for (u, v), origin in origins.items()
    )
    return Write(PUT_ORIGIN, rows)


def seconds_write(frame: str, session: str, seconds: float) -> Write:
    """The time a session has spent on a frame by now."""
    return Write(SET_SECONDS, ((stored(frame), session, seconds),))
