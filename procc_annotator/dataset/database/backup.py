"""Transactions and backups of the workspace database; reading a damaged one."""

from __future__ import annotations

import os
import secrets
import sqlite3
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import ExitStack, closing, contextmanager, suppress
from pathlib import Path

from procc_annotator.dataset.database.schema import (
    SET_VERDICT_BY_NAME,
    DamagedError,
    Row,
    Write,
    values_of,
)
from procc_annotator.formats.atomic import remove_stale

_OLD_VERDICTS = "frame", "source", "fault", "author", "time", "comment"
_PAGES = 1000  # 4 MB, copied in some milliseconds: so long a question waits


@contextmanager
def transaction(connection: sqlite3.Connection) -> Iterator[None]:
    """Write everything inside as a whole or not at all, whatever ends it. `sqlite3.Error` if it
    cannot begin, or cannot be committed."""
    connection.execute("BEGIN IMMEDIATE")
    with ExitStack() as failed:
        failed.callback(_roll_back, connection)
        yield
        connection.execute("COMMIT")
        failed.pop_all()


def _roll_back(connection: sqlite3.Connection) -> None:
    with suppress(sqlite3.Error):
        connection.execute("ROLLBACK")


def write_all(connection: sqlite3.Connection, writes: Iterable[Write]) -> None:
    """Run writes, all or none of them. `sqlite3.Error` if they cannot be written."""
    with transaction(connection):
        for write in writes:
            connection.executemany(write.sql, write.rows)


def copy_readable(source: sqlite3.Connection, target: sqlite3.Connection) -> None:
    """Copy into a database every row that can be read of another, perhaps damaged one.

    Rows of the source replace those of the target with the same key; impossible rows are left out.
    `sqlite3.Error` if the target cannot be written; then nothing is.
    """
    tables = "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%'"
    with transaction(target):
        for (table,) in target.execute(tables).fetchall():
            info = {row[1]: row[5] for row in target.execute(f"PRAGMA table_info({table})")}
            columns = tuple(name for name in info if name != "seq")
            keys = ("id",) if "seq" in info else tuple(name for name in columns if info[name])
            # Of a frame NULL means "not set"; of a setting it means "taken back".
            new = "coalesce(excluded.{0}, {0})" if table == "frame" else "excluded.{0}"
            values = ", ".join(f"{c} = {new.format(c)}" for c in columns if c not in keys)
            sql = (
                f"INSERT INTO {table}({', '.join(columns)})"
                f" VALUES({', '.join('?' * len(columns))})"
                f" ON CONFLICT({', '.join(keys)}) DO UPDATE SET {values}"
            )
            order = ("seq",) if "seq" in info else keys
            target.executemany(sql, _readable(source, table, columns, order))
        # Of a file that was damaged before its schema was brought up to date.
        old = _readable(source, "verdict", _OLD_VERDICTS, _OLD_VERDICTS[:2])
        target.executemany(SET_VERDICT_BY_NAME, old)


def copy_readable_file(path: Path, target: sqlite3.Connection) -> None:
    """As `copy_readable`, from a file."""
    with closing(sqlite3.connect(path, timeout=1.0, isolation_level=None)) as source:
        copy_readable(source, target)


def _readable(
    source: sqlite3.Connection, table: str, columns: tuple[str, ...], order: tuple[str, ...]
) -> Iterator[Row]:
    """The valid rows from the first up to a damaged page, then those from the last back to one."""
    for direction in ("", " DESC"):
        query = f"SELECT {', '.join(columns)} FROM {table} ORDER BY " + ", ".join(
            column + direction for column in order
        )
        rows: list[Row] = []
        try:
            for row in source.execute(query):
                with suppress(DamagedError):
                    values_of(columns, row)
                    rows.append(row)
            complete = True
        except (sqlite3.Error, UnicodeDecodeError):  # a damaged page, or no such table
            complete = False
        yield from reversed(rows) if direction else rows
        if complete:
            return


def backup_path(path: Path) -> Path:
    """Return where the backup copy of a database lies."""
    return path.with_name(f"{path.name}.backup")


def backup_time(path: Path) -> str:
    """Return when the backup of a database was made, as local time; empty if absent."""
    try:
        made = backup_path(path).stat().st_mtime
    except OSError:
        return ""
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(made))


def is_backup_due(path: Path) -> bool:
    """Return whether a database was changed after its backup was made, or has none."""
    try:
        return path.stat().st_mtime_ns >= backup_path(path).stat().st_mtime_ns
    except OSError:
        return path.exists()


def write_backup(
    connection: sqlite3.Connection, path: Path, check: Callable[[], None] = lambda: None
) -> None:
    """Copy a database to the backup of its path, which is replaced only by a complete and sound
    copy.

    ``check`` is called every few milliseconds; what it raises ends the copying.

    Raises:
        sqlite3.Error, OSError: the copy cannot be written.
        DamagedError: the database is damaged.
    """
    temporary = path.with_name(f".procc-{secrets.token_hex(8)}.tmp")
    try:
        with closing(sqlite3.connect(temporary, isolation_level=None)) as copy:
            copy.execute("PRAGMA journal_mode = OFF")
            remove_stale(temporary)
            connection.backup(copy, pages=_PAGES, progress=lambda *_: check())
            if copy.execute("PRAGMA integrity_check(1)").fetchone() != ("ok",):
                raise DamagedError("it contradicts itself")
        os.replace(temporary, backup_path(path))
    finally:
        with suppress(OSError):
            temporary.unlink(missing_ok=True)
