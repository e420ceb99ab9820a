"""Copying from one workspace database into another whatever can be read."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from procc_annotator.session.database import rows
from procc_annotator.session.database.rows import Write
from procc_annotator.session.database.tables import (
    DamagedError,
    Row,
    Value,
    as_bytes,
    as_fault,
    as_kind,
    as_status,
    as_text_or_none,
)
from procc_annotator.session.database.tables import as_number as number
from procc_annotator.session.database.tables import as_text as text

_Check = Callable[[Value], object]


@dataclass(frozen=True, slots=True)
class _Table:
    """What to read from a table, in which order, how to see that it is sound, and to write it."""

    columns: str
    table: str
    order: tuple[str, ...]
    sql: str
    checks: tuple[_Check, ...]


_COMMENT = (text, text, text, number, text, number)

_TABLES = (
    _Table("key, value", "meta", ("key",), rows.SET_META, (text, as_text_or_none)),
    _Table("name, status", "frame", ("name",), rows.SET_STATUS, (text, as_status)),
    _Table("name, committed", "frame", ("name",), rows.SET_COMMITTED, (text, number)),
    _Table(
        "frame, session, seconds",
        "work",
        ("frame", "session"),
        rows.SET_SECONDS,
        (text, text, number),
    ),
    _Table(
        "id, frame, author, time, text, resolved",
        "comment",
        ("seq",),
        rows.SET_COMMENT,
        _COMMENT,
    ),
    _Table(
        "frame, u, v, kind, author, time",
        "origin",
        ("frame", "u", "v"),
        rows.PUT_ORIGIN,
        (text, number, number, as_kind, text, number),
    ),
    _Table(
        "id, frame, author, time, reason, digest, data",
        "version",
        ("seq",),
        rows.ADD_VERSION,
        (text, text, text, number, text, as_bytes, as_bytes),
    ),
    _Table("frame, data", "draft", ("frame",), rows.SET_DRAFT, (text, as_bytes)),
    _Table(
        "frame, place, source, fault, author, time, comment",
        "source_verdict",
        ("frame", "place"),
        rows.SET_VERDICT,
        (text, text, text, as_fault, text, number, text),
    ),
    _Table(
        "frame, element, hidden, author, time",
        "not_visible",
        ("frame", "element"),
        rows.SET_NOT_VISIBLE,
        (text, text, number, text, number),
    ),
    _Table(  # of a file that was damaged before it was brought up to date
        "frame, source, fault, author, time, comment",
        "verdict",
        ("frame", "source"),
        rows.SET_VERDICT_BY_NAME,
        (text, text, as_fault, text, number, text),
    ),
)


@contextmanager
def transaction(connection: sqlite3.Connection) -> Iterator[None]:
    """What is written inside is written as a whole or not at all, whatever ends it.

    Raises:
        sqlite3.Error: it cannot begin, or cannot be kept.
    """
    connection.execute("BEGIN IMMEDIATE")
    with ExitStack() as failed:
        failed.callback(_roll_back, connection)
        yield
        connection.execute("COMMIT")
        failed.pop_all()


def _roll_back(connection: sqlite3.Connection) -> None:
    with suppress(sqlite3.Error):
        connection.execute("ROLLBACK")


def write_all(connection: sqlite3.Connection, writes: Iterator[Write]) -> None:
    """Run writes, all or none of them.

    Raises:
        sqlite3.Error: they cannot be written.
    """
    with transaction(connection):
        for write in writes:
            connection.executemany(write.sql, write.rows)


def rescue(source: sqlite3.Connection, target: sqlite3.Connection) -> None:
    """Add to a database what another, perhaps damaged one says.

    Where both say something, the other one wins. Rows that make no sense are left out.

    Raises:
        sqlite3.Error: the target cannot be written; then nothing is.
    """
    write_all(target, (write for table in _TABLES for write in _sound(source, table)))


def rescue_file(path: Path, target: sqlite3.Connection) -> None:
    """The same from a file.

    Raises:
        sqlite3.Error: the target cannot be written; then nothing is.
    """
    with closing(sqlite3.connect(path, timeout=1.0, isolation_level=None)) as source:
        rescue(source, target)


def _sound(source: sqlite3.Connection, table: _Table) -> Iterator[Write]:
    """The rows from the first up to a damaged page, then those from the last back to one."""
    for row in _rows(source, table, ""):
        if row is None:
            break
        yield Write(table.sql, (row,))
    else:
        return
    behind = [row for row in _rows(source, table, " DESC") if row is not None]
    yield Write(table.sql, tuple(reversed(behind)))


def _rows(source: sqlite3.Connection, table: _Table, direction: str) -> Iterator[Row | None]:
    """Rows that make sense; at last None when there are more that cannot be reached."""
    order = ", ".join(column + direction for column in table.order)
    query = f"SELECT {table.columns} FROM {table.table} ORDER BY {order}"
    try:
        for row in source.execute(query):
            with suppress(DamagedError):
                for check, value in zip(table.checks, row, strict=True):
                    check(value)
                yield row
    except (sqlite3.Error, UnicodeDecodeError):  # that is what damage looks like
        yield None
