"""Where the workspace database lies, opening it, and setting aside what is no such database."""

from __future__ import annotations

import hashlib
import os
import shutil
import sqlite3
import sys
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from procc_annotator.session.database_rows import (
    APPLICATION_ID,
    MIGRATIONS,
    DamagedError,
    Snapshot,
    check_statements,
    load,
)

FOLDER = ".procc"
FILE = "workspace.db"

# How long a statement waits for another process that is writing.
_BUSY_S = 5.0

# A larger file is not read from end to end each time: what is kept in memory is read in any case,
# and damage elsewhere shows when it is used.
_CHECKED_WHOLE = 4_000_000

# Failures that say nothing about the file's content (primary result codes of SQLite). All others
# mean that the file is not what this program wrote.
_CIRCUMSTANCES = {
    sqlite3.SQLITE_BUSY,
    sqlite3.SQLITE_LOCKED,
    sqlite3.SQLITE_PERM,
    sqlite3.SQLITE_READONLY,
    sqlite3.SQLITE_IOERR,
    sqlite3.SQLITE_CANTOPEN,
    sqlite3.SQLITE_FULL,
    sqlite3.SQLITE_INTERRUPT,
    sqlite3.SQLITE_PROTOCOL,
    sqlite3.SQLITE_NOLFS,
    sqlite3.SQLITE_AUTH,
    sqlite3.SQLITE_CONSTRAINT,
    sqlite3.SQLITE_MISMATCH,
    sqlite3.SQLITE_TOOBIG,
    sqlite3.SQLITE_MISUSE,
    sqlite3.SQLITE_RANGE,
}

Identity = tuple[int, int]  # device and inode


class NewerError(Exception):
    """The database was written by a newer version of this program; it is left alone."""


@dataclass(frozen=True)
class Opened:
    """A database that can be used, with what it says.

    Attributes:
        identity: tells whether another file has taken its place since.
        fresh: it was empty.
        data_version: changes when another connection writes.
        notices: what had to be set aside.
    """

    connection: sqlite3.Connection
    identity: Identity | None
    fresh: bool
    data_version: int
    snapshot: Snapshot
    notices: tuple[str, ...] = ()


def database_path(dataset: Path) -> Path:
    """Where a dataset's database belongs; a single picture's is its folder's."""
    folder = dataset.parent if dataset.is_file() else dataset
    return folder / FOLDER / FILE


def own_path(dataset: Path) -> Path | None:
    """Where it is kept for a dataset that cannot be written: the user's data folder.

    Returns:
        None when the user has no home.
    """
    folder = os.path.realpath(dataset.parent if dataset.is_file() else dataset)
    base = _data_folder()
    if base is None:
        return None
    mark = hashlib.sha256(os.fsencode(folder)).hexdigest()[:12]
    return base / "procc-annotator" / f"{os.path.basename(folder) or 'root'}-{mark}" / FILE


def _data_folder() -> Path | None:
    if sys.platform == "win32":
        named, usual = os.environ.get("LOCALAPPDATA", ""), "~/AppData/Local"
    elif sys.platform == "darwin":
        named, usual = "", "~/Library/Application Support"
    else:
        named, usual = os.environ.get("XDG_DATA_HOME", ""), "~/.local/share"
    folder = named if os.path.isabs(named) else os.path.expanduser(usual)
    return Path(folder) if os.path.isabs(folder) else None


def make_folder(path: Path) -> None:
    """Make the folder of a database and see whether it can be written.

    A dataset's own folder is never made: when it is gone (a drive was unplugged), a new one in its
    place would only hide that.

    Raises:
        OSError: it cannot be made, or nothing can be written there.
    """
    path.parent.mkdir(parents=path.parent.name != FOLDER, exist_ok=True)
    if not os.access(path.parent, os.W_OK) or (path.exists() and not os.access(path, os.W_OK)):
        raise PermissionError("it is write-protected")


def connect(path: Path | None) -> sqlite3.Connection:
    """A connection to a file, or to memory; no write-ahead log, which network folders cannot do.

    Raises:
        sqlite3.Error: the file cannot be opened or is no database.
    """
    name = ":memory:" if path is None else path
    connection = sqlite3.connect(
        name, timeout=_BUSY_S, isolation_level=None, check_same_thread=False
    )
    try:
        connection.execute("PRAGMA trusted_schema = OFF")
        connection.execute("PRAGMA cell_size_check = ON")
        connection.execute("PRAGMA journal_mode = TRUNCATE")
        connection.execute("PRAGMA synchronous = FULL")
    except sqlite3.Error:
        connection.close()
        raise
    return connection


def open_database(path: Path | None) -> Opened:
    """Open a database or begin one; what is none is set aside first.

    Raises:
        sqlite3.Error, OSError: it can neither be used nor set aside; circumstances may change.
        NewerError: it is for a newer version of this program.
    """
    if path is not None:
        make_folder(path)
    notices: tuple[str, ...] = ()
    for _ in range(3):  # another process may put a damaged one in the place of a damaged one
        before = identity_of(path)
        try:
            opened = _open(path)
        except (DamagedError, sqlite3.Error) as error:
            if path is None or not is_damage(error):
                raise
            notices += set_aside(path, before, error)
        else:
            return Opened(*opened, notices)
    raise OSError(f"{path} is damaged again and again")


def _open(
    path: Path | None,
) -> tuple[sqlite3.Connection, Identity | None, bool, int, Snapshot]:
    connection = connect(path)
    try:
        fresh = _prepare(connection)
        if not fresh and path is not None and path.stat().st_size <= _CHECKED_WHOLE:
            verdict = connection.execute("PRAGMA quick_check(1)").fetchone()
            if verdict != ("ok",):
                raise DamagedError("it contradicts itself")
        check_statements(connection)
        version = data_version(connection)
        snapshot = load(connection)
    except BaseException:
        connection.close()
        raise
    return connection, identity_of(path), fresh, version, snapshot


def _prepare(connection: sqlite3.Connection) -> bool:
    """Bring the schema up to date; whether the database was empty."""
    if _schema_version(connection) == len(MIGRATIONS):
        return False
    connection.execute("BEGIN IMMEDIATE")
    try:
        version = _schema_version(connection)  # another process may have been quicker
        for statements in MIGRATIONS[version:]:
            for statement in statements:
                connection.execute(statement)
        connection.execute(f"PRAGMA application_id = {APPLICATION_ID}")
        connection.execute(f"PRAGMA user_version = {len(MIGRATIONS)}")
        connection.execute("COMMIT")
    except BaseException:
        with suppress(sqlite3.Error):
            connection.execute("ROLLBACK")
        raise
    return version == 0


def _schema_version(connection: sqlite3.Connection) -> int:
    (program,) = connection.execute("PRAGMA application_id").fetchone()
    (version,) = connection.execute("PRAGMA user_version").fetchone()
    (tables,) = connection.execute("SELECT count(*) FROM sqlite_master").fetchone()
    if program == 0 and version == 0 and tables == 0:
        return 0
    if program != APPLICATION_ID:
        raise DamagedError("it belongs to another program")
    if version > len(MIGRATIONS):
        raise NewerError("it was written by a newer version of this program")
    if version <= 0:
        raise DamagedError("it contradicts itself")
    return int(version)


def data_version(connection: sqlite3.Connection) -> int:
    """A number that changes when another connection has written.

    Raises:
        sqlite3.Error: the database cannot be read.
    """
    (version,) = connection.execute("PRAGMA data_version").fetchone()
    return int(version)


def identity_of(path: Path | None) -> Identity | None:
    """What tells a file from another that takes its place; None when there is none."""
    if path is None:
        return None
    try:
        found = os.stat(path)
    except OSError:
        return None
    return found.st_dev, found.st_ino


def is_damage(error: Exception) -> bool:
    """Whether a failure means that the file holds something else than this program wrote."""
    if isinstance(error, DamagedError):
        return True
    if not isinstance(error, sqlite3.DatabaseError):
        return False
    code = getattr(error, "sqlite_errorcode", None)
    if code is None:  # the module's own: a text that cannot be decoded
        return isinstance(error, sqlite3.OperationalError)
    return code & 0xFF not in _CIRCUMSTANCES or code == sqlite3.SQLITE_IOERR_SHORT_READ


def set_aside(path: Path, identity: Identity | None, error: Exception) -> tuple[str, ...]:
    """Put a damaged database out of the way, with its journal; one line for the user.

    Returns:
        Nothing when another file has taken the place of the one with this identity meanwhile.

    Raises:
        OSError: that is not possible.
    """
    if identity is not None and identity_of(path) != identity:
        return ()
    number = 1
    while (aside := path.with_name(f"{path.name}.damaged-{number}")).exists():
        number += 1
    _move(path, aside)
    journal = path.with_name(f"{path.name}-journal")
    if journal.exists():
        _move(journal, aside.with_name(f"{aside.name}-journal"))
    reason = " ".join(str(error).split())
    return (f"{path}: cannot be used ({reason}); set aside as {aside.name}, a new one is begun",)


def _move(path: Path, aside: Path) -> None:
    try:
        os.rename(path, aside)
    except PermissionError:  # somebody has it open (Windows)
        shutil.copyfile(path, aside)
        os.truncate(path, 0)
