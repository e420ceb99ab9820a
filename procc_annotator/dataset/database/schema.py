"""Tables, migrations and statements of the workspace database; rows as values."""

from __future__ import annotations

import math
import sqlite3
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import astuple, dataclass, field, replace
from enum import StrEnum
from itertools import starmap
from typing import Any

from procc_annotator.dataset.records import (
    Comment,
    FaultParty,
    FrameRecord,
    NotVisible,
    Origin,
    OriginKind,
    PointKey,
    Status,
    Verdict,
    Version,
    digest_of,
)

APPLICATION_ID = 0x50724343  # "PrCC"

# `verdict.by_name` of a source's stored name, which stays a BLOB when it is one.
BY_NAME = "CASE typeof({0}) WHEN 'blob' THEN CAST('name:' || {0} AS BLOB) ELSE 'name:' || {0} END"

# One tuple of statements a schema version; a database of version n gets MIGRATIONS[n:].
MIGRATIONS: tuple[tuple[str, ...], ...] = (
    (
        # A setting that was taken back leaves NULL.
        "CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID",
        # NULL is what no one has set.
        "CREATE TABLE frame(name TEXT PRIMARY KEY, status TEXT, committed INTEGER) WITHOUT ROWID",
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
        # A draft that is over leaves an empty one.
        "CREATE TABLE draft(frame TEXT PRIMARY KEY, data BLOB NOT NULL) WITHOUT ROWID",
    ),
    (
        # A verdict that was taken back leaves an empty fault.
        "CREATE TABLE verdict(frame TEXT, source TEXT, fault TEXT NOT NULL, author TEXT NOT NULL,"
        " time REAL NOT NULL, comment TEXT NOT NULL, PRIMARY KEY(frame, source)) WITHOUT ROWID",
    ),
    (
        # A source is known by its place: names change, and others may be called the same.
        "CREATE TABLE source_verdict(frame TEXT, place TEXT, source TEXT NOT NULL,"
        " fault TEXT NOT NULL, author TEXT NOT NULL, time REAL NOT NULL, comment TEXT NOT NULL,"
        " PRIMARY KEY(frame, place)) WITHOUT ROWID",
        "INSERT INTO source_verdict(frame, place, source, fault, author, time, comment)"
        f" SELECT frame, {BY_NAME.format('source')}, source, fault, author, time, comment"
        " FROM verdict",
        "DROP TABLE verdict",
    ),
    (
        # An element that can be seen after all leaves a hidden of 0.
        "CREATE TABLE not_visible(frame TEXT, element TEXT, hidden INTEGER NOT NULL,"
        " author TEXT NOT NULL, time REAL NOT NULL, PRIMARY KEY(frame, element)) WITHOUT ROWID",
    ),
    (
        # Comments on places, px of the picture; the others have no row. A table of its own, so
        # that those of an older backup are read as they are.
        "CREATE TABLE comment_place(id TEXT PRIMARY KEY, x REAL NOT NULL, y REAL NOT NULL)"
        " WITHOUT ROWID",
    ),
)

Value = str | bytes | float | int | None
Row = tuple[Value, ...]


class DamagedError(Exception):
    """A row holds what this program never wrote."""


def stored(text: str) -> str | bytes:
    """Text as it is bound to a statement; any Python string survives the way there and back."""
    if text.isascii():
        return text
    try:
        text.encode()
    except UnicodeEncodeError:  # lone surrogates: undecodable bytes of a file's name
        return text.encode("utf-8", "surrogatepass")
    return text


def as_text(value: Value) -> str:
    """The way back from `stored`; `DamagedError` if it is no text."""
    if isinstance(value, str):
        return value
    if isinstance(value, bytes):
        try:
            return value.decode("utf-8", "surrogatepass")
        except UnicodeDecodeError as error:
            raise DamagedError("a text that is none") from error
    raise DamagedError("a text that is none")


def as_number(value: Value) -> float:
    """A finite number; `DamagedError` if it is something else."""
    if type(value) is float and math.isfinite(value):
        return value
    if type(value) is int:
        return float(value)
    raise DamagedError("a number that is none")


def as_bytes(value: Value) -> bytes:
    """Bytes; `DamagedError` if it is something else."""
    if isinstance(value, bytes):
        return value
    raise DamagedError("contents that are none")


def _one_of(kind: type[StrEnum], *others: Value) -> Callable[[Value], StrEnum | None]:
    """A check for the values of an enumeration; the others stand for none of them."""
    known: dict[Value, StrEnum | None] = dict.fromkeys(others) | {str(one): one for one in kind}

    def check(value: Value) -> StrEnum | None:
        if value not in known:
            raise DamagedError(f"a {kind.__name__.lower()} that is none")
        return known[value]

    return check


# What the columns hold that are not texts.
_COLUMNS: dict[str, Callable[[Value], object]] = {
    "status": _one_of(Status, None),
    "committed": lambda value: value is not None and bool(as_number(value)),
    "value": lambda value: None if value is None else as_text(value),
    "kind": _one_of(OriginKind),
    "fault": _one_of(FaultParty, ""),
    **dict.fromkeys(("resolved", "hidden"), lambda value: bool(as_number(value))),
    **dict.fromkeys(("seconds", "u", "v", "time"), as_number),
    **dict.fromkeys(("x", "y"), lambda value: None if value is None else as_number(value)),
    **dict.fromkeys(("data", "digest"), as_bytes),
}


def values_of(columns: Sequence[str], row: Row) -> tuple[Any, ...]:
    """The values of a row, by the names of its columns; `DamagedError` if one is impossible."""
    read = zip(columns, row, strict=True)
    return tuple(_COLUMNS.get(column, as_text)(value) for column, value in read)


# Every statement may be run again with the same values without changing more: what was written
# before a failure of unknown extent is simply written again.
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
PLACE_COMMENT = "INSERT OR REPLACE INTO comment_place(id, x, y) VALUES(?1, ?2, ?3)"
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

_VERSION = ("id", "frame", "author", "time", "reason")


@dataclass(frozen=True, slots=True)
class Write:
    """A statement and the rows to run it with.

    ``raw``: the last value of each row is still to be compressed (by the writer, not by anyone who
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
    """Content of the database in memory; ``meta`` values are text."""

    records: dict[str, FrameRecord] = field(default_factory=dict)
    comments: dict[str, tuple[Comment, ...]] = field(default_factory=dict)  # by frame
    drafts: dict[str, bytes] = field(default_factory=dict)
    meta: dict[str, str] = field(default_factory=dict)
    verdicts: dict[str, dict[str, Verdict]] = field(default_factory=dict)  # by frame and place
    not_visible: dict[str, dict[str, NotVisible]] = field(default_factory=dict)  # and by class


def load(connection: sqlite3.Connection) -> Snapshot:
    """Read everything that is kept in memory; raises as `read`."""
    known = Snapshot()
    for frame, status, committed in read(connection, "name, status, committed", "frame"):
        known.records[frame] = FrameRecord(status or Status.UNTOUCHED, committed)
    for frame, seconds in read(connection, "frame, sum(seconds) AS seconds", "work GROUP BY frame"):
        known.records[frame] = replace(known.records.get(frame, FrameRecord()), seconds=seconds)
    comments = "id, frame, author, time, text, resolved, x, y"
    placed = "comment LEFT JOIN comment_place USING(id) ORDER BY seq"
    for row in read(connection, comments, placed):
        comment = Comment(*row[:6])
        if None not in row[6:]:
            comment = replace(comment, place=row[6:])
        remarks = known.comments.get(comment.frame, ())
        known.comments[comment.frame] = (*remarks, comment)
    for frame, remarks in known.comments.items():
        known.records[frame] = with_comments(known.records.get(frame, FrameRecord()), remarks)
    known.drafts.update(
        (name, data) for name, data in read(connection, "frame, data", "draft") if data
    )
    meta = read(connection, "key, value", "meta")
    known.meta.update((key, value) for key, value in meta if value is not None)
    verdicts = "frame, source, place, fault, author, time, comment"
    for verdict in starmap(Verdict, read(connection, verdicts, "source_verdict")):
        if verdict.fault is not None:
            known.verdicts.setdefault(verdict.frame, {})[verdict.place] = verdict
    marks = "frame, element, author, time, hidden"
    for frame, name, author, time, hidden in read(connection, marks, "not_visible"):
        if hidden:
            mark = NotVisible(frame, name, author, time)
            known.not_visible.setdefault(mark.frame, {})[mark.class_name] = mark
    return known


def read(
    connection: sqlite3.Connection, columns: str, rest: str, *given: Value
) -> Iterator[tuple[Any, ...]]:
    """Read rows as values, which are checked by the names of their columns.

    Raises:
        sqlite3.Error: they cannot be read.
        DamagedError: a row is impossible.
    """
    names = [column.split()[-1] for column in columns.split(", ")]
    for row in connection.execute(f"SELECT {columns} FROM {rest}", given):
        yield values_of(names, row)


def with_comments(record: FrameRecord, remarks: tuple[Comment, ...]) -> FrameRecord:
    """The record with its comments counted anew."""
    still_open = sum(not remark.resolved for remark in remarks)
    return replace(record, open_comments=still_open, comments=len(remarks))


def load_origins(connection: sqlite3.Connection, frame: str) -> dict[PointKey, Origin]:
    """The origins of a frame's points; raises as `read`."""
    found = read(connection, "u, v, kind, author, time", "origin WHERE frame = ?", stored(frame))
    return {(u, v): Origin(*row) for u, v, *row in found}


def load_versions(connection: sqlite3.Connection, frame: str) -> tuple[Version, ...]:
    """The versions of a frame, newest first; raises as `read`."""
    of_frame = "version WHERE frame = ? ORDER BY seq DESC"
    return tuple(starmap(Version, read(connection, ", ".join(_VERSION), of_frame, stored(frame))))


def version_of(row: Row) -> Version:
    """A version from its first five columns (id, frame, author, time, reason); `DamagedError` if
    the row is impossible."""
    return Version(*values_of(_VERSION, row[: len(_VERSION)]))


def load_version_data(connection: sqlite3.Connection, id_: str) -> Row | None:
    """Return what `version_data_of` takes, or None when there is no such version."""
    row: Row | None = connection.execute(
        "SELECT digest, data FROM version WHERE id = ?", (stored(id_),)
    ).fetchone()
    return row


def version_data_of(row: Row) -> bytes:
    """A version's data from its digest and what was compressed; `DamagedError` if they do not
    belong together."""
    digest, packed = row
    try:
        data = zlib.decompress(as_bytes(packed))
    except zlib.error as error:
        raise DamagedError("data that is none") from error
    if digest_of(data) != digest:
        raise DamagedError("data that is not what it was")
    return data


def write(sql: str, *values: Value) -> Write:
    """Write one row."""
    return Write(sql, (tuple(stored(v) if isinstance(v, str) else v for v in values),))


def comment_write(comment: Comment, sql: str = ADD_COMMENT) -> Write:
    """Add a comment, or with SET_COMMENT settle it."""
    return write(sql, *astuple(comment)[:6])


def verdict_write(verdict: Verdict, *, withdrawn: bool = False) -> Write:
    """Give a frame a verdict under a source, or take it back."""
    v, fault = verdict, "" if withdrawn else str(verdict.fault)
    return write(SET_VERDICT, v.frame, v.place, v.source, fault, v.author, v.time, v.comment)


def origins_write(frame: str, origins: dict[PointKey, Origin]) -> Write:
    """Add or replace origins of a frame's points."""
    name = stored(frame)
    rows = tuple(
        (name, u, v, origin.kind, stored(origin.author), origin.time)
        for (u, v), origin in origins.items()
    )
    return Write(PUT_ORIGIN, rows)
