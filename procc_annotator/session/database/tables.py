"""The tables of the workspace database: how those of older versions become them, what a column may
hold, and as what it comes out again.

Text is stored as TEXT, or as a BLOB where it is no valid Unicode (names of files may be anything).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from enum import StrEnum
from typing import Any

from procc_annotator.session.facts.origins import OriginKind, Status
from procc_annotator.session.facts.verdict import FaultParty

APPLICATION_ID = 0x50724343  # "PrCC"

# `verdict.by_name` of a source's stored name, which stays a BLOB when it is one.
BY_NAME = "CASE typeof({0}) WHEN 'blob' THEN CAST('name:' || {0} AS BLOB) ELSE 'name:' || {0} END"

# One tuple of statements a schema version; a database of version n gets MIGRATIONS[n:].
MIGRATIONS: tuple[tuple[str, ...], ...] = (
    (
        # A setting that was taken back leaves NULL.
        "CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID",
        # NULL is what nobody has set.
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
    if type(value) is float and math.isfinite(value):
        return value
    if type(value) is int:
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
    **dict.fromkeys(("data", "digest"), as_bytes),
}


def values_of(columns: Sequence[str], row: Row) -> tuple[Any, ...]:
    """The values of a row, by the names of its columns.

    Raises:
        DamagedError: one is impossible.
    """
    read = zip(columns, row, strict=True)
    return tuple(_COLUMNS.get(column, as_text)(value) for column, value in read)
