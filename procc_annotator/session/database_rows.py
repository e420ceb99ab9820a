"""The tables of the workspace database: their schema, statements, and rows as values.

Text is stored as TEXT, or as a BLOB where it is no valid Unicode (names of files may be anything).
"""

from __future__ import annotations

import math
import re
import sqlite3
import zlib
from collections.abc import Iterator
from dataclasses import dataclass, field

from procc_annotator.session.origins import (
    Comment,
    FrameRecord,
    Origin,
    OriginKind,
    PointKey,
    Status,
    Version,
)

Value = str | bytes | float | int | None
Row = tuple[Value, ...]

APPLICATION_ID = 0x50724343  # "PrCC"

# One tuple of statements a schema version; a database of version n gets MIGRATIONS[n:].
MIGRATIONS: tuple[tuple[str, ...], ...] = (
    (
        "CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID",
        "CREATE TABLE frame(name TEXT PRIMARY KEY, status TEXT NOT NULL DEFAULT 'untouched',"
        " committed INTEGER NOT NULL DEFAULT 0) WITHOUT ROWID",
        # Seconds are kept by session as totals, so that writing them twice changes nothing.
        "CREATE TABLE work(frame TEXT, session TEXT, seconds REAL NOT NULL,"
        " PRIMARY KEY(frame, session)) WITHOUT ROWID",
        # Ids are chosen by the writing process; seq gives the order, whatever the clocks said.
        "CREATE TABLE comment(seq INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE,"
        " frame TEXT NOT NULL, author TEXT NOT NULL, time REAL NOT NULL, text TEXT NOT NULL,"
        " resolved INTEGER NOT NULL DEFAULT 0)",
        "CREATE TABLE origin(frame TEXT, u REAL, v REAL, kind TEXT NOT NULL,"
        " author TEXT NOT NULL, time REAL NOT NULL, PRIMARY KEY(frame, u, v)) WITHOUT ROWID",
        "CREATE TABLE version(seq INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE,"
        " frame TEXT NOT NULL, author TEXT NOT NULL, time REAL NOT NULL, reason TEXT NOT NULL,"
        " digest BLOB NOT NULL, data BLOB NOT NULL)",
        "CREATE INDEX version_of_frame ON version(frame)",
        "CREATE TABLE draft(frame TEXT PRIMARY KEY, data BLOB NOT NULL) WITHOUT ROWID",
    ),
)

# Every statement may be run again with the same values without changing more: what was written
# before a failure whose extent nobody knows is simply written again.
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
RESOLVE_COMMENT = "UPDATE comment SET resolved = ?2 WHERE id = ?1"
PUT_ORIGIN = (
    "INSERT OR REPLACE INTO origin(frame, u, v, kind, author, time) VALUES(?1, ?2, ?3, ?4, ?5, ?6)"
)
ADD_VERSION = (
    "INSERT OR IGNORE INTO version(id, frame, author, time, reason, digest, data)"
    " SELECT ?1, ?2, ?3, ?4, ?5, ?6, ?7 WHERE ?6 IS NOT"
    " (SELECT digest FROM version WHERE frame = ?2 ORDER BY seq DESC LIMIT 1)"
)
SET_DRAFT = "INSERT OR REPLACE INTO draft(frame, data) VALUES(?1, ?2)"
DROP_DRAFT = "DELETE FROM draft WHERE frame = ?1"

_VERSIONS = "SELECT id, frame, author, time, reason FROM version WHERE frame = ?1 ORDER BY seq DESC"
_VERSION_DATA = "SELECT data, digest FROM version WHERE id = ?1"
_NEWEST_DIGEST = "SELECT digest FROM version WHERE frame = ?1 ORDER BY seq DESC LIMIT 1"
_ORIGINS = "SELECT u, v, kind, author, time FROM origin WHERE frame = ?1"
_WORK = "SELECT frame, sum(seconds) FROM work GROUP BY frame"
_COMMENTS = "SELECT id, frame, author, time, text, resolved FROM comment ORDER BY seq"

_ALL = (
    *(SET_META, SET_STATUS, SET_COMMITTED, SET_SECONDS, ADD_COMMENT, RESOLVE_COMMENT, PUT_ORIGIN),
    *(ADD_VERSION, SET_DRAFT, DROP_DRAFT, _VERSIONS, _VERSION_DATA, _NEWEST_DIGEST, _ORIGINS),
)

_STATUSES = {str(status): status for status in Status}
_KINDS = {str(kind): kind for kind in OriginKind}


class DamagedError(Exception):
    """A row holds what this program never wrote."""


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


def stored(text: str) -> str | bytes:
    """Text as it is bound to a statement; any Python string survives the way there and back."""
    try:
        text.encode()
    except UnicodeEncodeError:  # lone surrogates: undecodable bytes of a file's name
        return text.encode("utf-8", "surrogatepass")
    return text


def as_text(value: Value) -> str:
    """The way back from `stored`.

    Raises:
        DamagedError: it is no text.
    """
    if isinstance(value, str):
        return value
    if isinstance(value, bytes):
        try:
            return value.decode("utf-8", "surrogatepass")
        except UnicodeDecodeError as error:
            raise DamagedError("a text that is none") from error
    raise DamagedError("a text that is none")


def as_number(value: Value) -> float:
    """A finite number.

    Raises:
        DamagedError: it is none.
    """
    if isinstance(value, (int, float)) and math.isfinite(value):
        return float(value)
    raise DamagedError("a number that is none")


def as_bytes(value: Value) -> bytes:
    """Bytes.

    Raises:
        DamagedError: it is something else.
    """
    if isinstance(value, bytes):
        return value
    raise DamagedError("contents that are none")


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
        if status not in _STATUSES:
            raise DamagedError("a status that is none")
        frame = name if type(name) is str else as_text(name)
        seconds = worked.pop(frame, 0.0) if worked else 0.0
        records[frame] = FrameRecord(_STATUSES[status], bool(committed), seconds)
    for frame, seconds in worked.items():
        records[frame] = FrameRecord(seconds=seconds)
    snapshot = Snapshot(records, {frame: tuple(all_) for frame, all_ in comments.items()})
    for frame, remarks in snapshot.comments.items():
        records[frame] = with_comments(records.get(frame, FrameRecord()), remarks)
    for name, data in connection.execute("SELECT frame, data FROM draft"):
        snapshot.drafts[as_text(name)] = as_bytes(data)
    for key, value in connection.execute("SELECT key, value FROM meta"):
        snapshot.meta[as_text(key)] = as_text(value)
    return snapshot


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
        if kind not in _KINDS:
            raise DamagedError("an origin that is none")
        origin = Origin(_KINDS[kind], as_text(author), as_number(time))
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


def load_version_data(connection: sqlite3.Connection, id_: str) -> tuple[bytes, bytes] | None:
    """A version's compressed data and the digest of what was compressed, or None.

    Raises:
        sqlite3.Error: it cannot be read.
        DamagedError: the row is impossible.
    """
    row = connection.execute(_VERSION_DATA, (stored(id_),)).fetchone()
    return None if row is None else (as_bytes(row[0]), as_bytes(row[1]))


def load_newest_digest(connection: sqlite3.Connection, frame: str) -> bytes | None:
    """The digest of a frame's newest version, or None.

    Raises:
        sqlite3.Error: it cannot be read.
        DamagedError: the row is impossible.
    """
    row = connection.execute(_NEWEST_DIGEST, (stored(frame),)).fetchone()
    return None if row is None else as_bytes(row[0])


def draft_write(frame: str, data: bytes | None) -> Write:
    """Keep or forget a frame's draft."""
    if data is None:
        return Write(DROP_DRAFT, ((stored(frame),),))
    return Write(SET_DRAFT, ((stored(frame), data),))


def comment_write(comment: Comment) -> Write:
    """Add a comment."""
    row = (
        comment.id,
        stored(comment.frame),
        stored(comment.author),
        comment.time,
        stored(comment.text),
        int(comment.resolved),
    )
    return Write(ADD_COMMENT, (row,))


def origins_write(frame: str, origins: dict[PointKey, Origin]) -> Write:
    """Add or replace origins of a frame's points."""
    name = stored(frame)
    rows = tuple(
        (name, u, v, str(origin.kind), stored(origin.author), origin.time)
        for (u, v), origin in origins.items()
    )
    return Write(PUT_ORIGIN, rows)


def snapshot_writes(snapshot: Snapshot, session: str) -> Iterator[Write]:
    """Everything in memory, to be written into a database that has none of it.

    Args:
        session: stands for all the sessions whose seconds were added up.
    """
    statuses = []
    for name, record in snapshot.records.items():
        key = stored(name)
        statuses.append((key, str(record.status)))
        if record.committed:
            yield Write(SET_COMMITTED, ((key, 1),))
        if record.seconds > 0:
            yield Write(SET_SECONDS, ((key, session, record.seconds),))
    yield Write(SET_STATUS, tuple(statuses))
    for remarks in snapshot.comments.values():
        for remark in remarks:
            yield comment_write(remark)
    for name, data in snapshot.drafts.items():
        yield draft_write(name, data)
    yield Write(SET_META, tuple((stored(k), stored(v)) for k, v in snapshot.meta.items()))
