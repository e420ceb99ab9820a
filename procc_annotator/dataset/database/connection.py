"""Open the workspace database file; set a damaged one aside."""

from __future__ import annotations

import os
import shutil
import sqlite3
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

from procc_annotator.dataset.database.backup import (
    backup_path,
    backup_time,
    copy_readable_file,
    transaction,
)
from procc_annotator.dataset.database.schema import (
    APPLICATION_ID,
    MIGRATIONS,
    DamagedError,
    Snapshot,
    load,
)
from procc_annotator.messages import pluralize
from procc_annotator.regular_file import open_regular

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


# All that opening, reading and writing can end with. The sqlite3 module fails with a
# UnicodeDecodeError to report damage when the message quotes damaged text.
FAILURES = (sqlite3.Error, OSError, DamagedError, NewerError, UnicodeDecodeError)


@dataclass(frozen=True)
class OpenedDatabase:
    """A database that can be used, with what it says.

    Attributes:
        identity: differs once another file has taken its place.
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


def lies_outside(path: Path) -> bool:
    """Return whether a database in ``.procc``, its journal or its backup is a link out of the
    dataset."""
    dataset = os.path.realpath(path.parent.parent)
    return not all(Path(os.path.realpath(f)).is_relative_to(dataset) for f in _files(path))


def _files(path: Path) -> tuple[Path, ...]:
    return path, path.with_name(f"{path.name}-journal"), backup_path(path)


def require_folder(path: Path) -> None:
    """Make the folder of a database and see whether it can be written.

    A dataset's own folder is never made: when it is gone (a drive was unplugged), a new one in its
    place would only hide that.

    Raises:
        OSError: it cannot be made, nothing can be written there, or a link leads out of the
            dataset (one from elsewhere could lead to any file of its user), or a pipe is there.
    """
    if path.parent.name == FOLDER and lies_outside(path):
        raise PermissionError("a link leads out of the dataset; it is not followed")
    path.parent.mkdir(parents=path.parent.name != FOLDER, exist_ok=True)
    for file in filter(Path.exists, _files(path)):
        open_regular(file).close()  # SQLite would wait for a pipe
    if not os.access(path.parent, os.W_OK) or (path.exists() and not os.access(path, os.W_OK)):
        raise PermissionError("it is write-protected")


def connect(path: Path | None) -> sqlite3.Connection:
    """A connection to a file, or to memory; no write-ahead log, which network folders cannot do.
    `sqlite3.Error` if the file cannot be opened or is no database."""
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


def open_database(
    path: Path | None, condemned: tuple[Identity | None, Exception] | None = None
) -> OpenedDatabase:
    """Open a database or begin one; any other file in its place is set aside first.

    A new one in the place of one that was lost begins with what can be read of the backup, and then
    of those set aside, which are newer.

    Args:
        path: the file; None for one in memory.
        condemned: a file that was found damaged while it was used, and how.

    Raises:
        One of FAILURES: it can neither be used nor set aside; circumstances may change.
    """
    if path is None:
        return _open(path)
    require_folder(path)
    asides: list[Path] = []
    lost = loss_message(path)
    for _ in range(3):  # another process may put a damaged one in the place of a damaged one
        identity = identity_of(path)
        if condemned is None:
            try:
                return _restored(_open(path), path, asides, lost)
            except FAILURES as error:
                if not is_damage(error):
                    raise
                condemned = identity, error
        aside = set_aside(path, condemned[0])
        if aside is not None:
            asides.append(aside)
            lost = f"could not be used ({reason_of(condemned[1])}); it is set aside as {aside.name}"
        condemned = None
    raise OSError("it is damaged again and again")


def loss_message(path: Path) -> str:
    """Return how a database was lost, by what is left in its folder; empty if it is there.

    A file without content is one: SQLite writes none, but for an instant when it begins one.
    """
    try:
        return "" if path.stat().st_size else "is empty (0 bytes)"
    except OSError:
        pass
    others = path.parent.name == FOLDER and path.parent.is_dir() and os.listdir(path.parent)
    return "is missing" if backup_path(path).exists() or others else ""


def _restored(opened: OpenedDatabase, path: Path, asides: list[Path], lost: str) -> OpenedDatabase:
    if not asides and not (lost and opened.fresh):
        return opened
    with ExitStack() as failed:
        failed.callback(opened.connection.close)
        origins, made = [f"what can be read of {aside.name}" for aside in asides], backup_time(path)
        if opened.fresh:
            if made:
                copy_readable_file(backup_path(path), opened.connection)
                origins.insert(0, f"the backup of {made}")
            for aside in asides:
                copy_readable_file(aside, opened.connection)
            opened = reread(opened)
        failed.pop_all()
    known = opened.snapshot
    comments = sum(map(len, known.comments.values()))
    (versions,) = opened.connection.execute("SELECT count(*) FROM version").fetchone()
    notice = f"{path}: {lost}; " + (
        f"restored from {' and '.join(origins)}: {pluralize(len(known.records), 'frame')} with a"
        f" status or comment, {pluralize(comments, 'comment')}, {pluralize(versions, 'version')};"
        " anything else is lost"
        if origins
        else "it has no backup: statuses, comments and versions that were in it are lost"
    )
    return replace(opened, notices=(notice,))


def reread(opened: OpenedDatabase) -> OpenedDatabase:
    """The same after something was written into it. One of FAILURES if it cannot be read."""
    version = data_version(opened.connection)
    return replace(opened, data_version=version, snapshot=load(opened.connection))


def _open(path: Path | None) -> OpenedDatabase:
    connection = connect(path)
    with ExitStack() as failed:
        failed.callback(connection.close)
        fresh = _prepare(connection)
        if not fresh and path is not None and path.stat().st_size <= _CHECKED_WHOLE:
            verdict = connection.execute("PRAGMA integrity_check(1)").fetchone()
            if verdict != ("ok",):
                raise DamagedError("it contradicts itself")
        if path is not None:
            _check_writable(connection)
        version = data_version(connection)
        snapshot = load(connection)
        failed.pop_all()
    return OpenedDatabase(connection, identity_of(path), fresh, version, snapshot)


def _check_writable(connection: sqlite3.Connection) -> None:
    """Write, and take it back: only that reveals folders in which no journal can be made.

    A damaged header can forbid writing into a file that is not write-protected.
    """
    try:
        connection.execute("BEGIN IMMEDIATE")
        connection.execute(f"PRAGMA user_version = {len(MIGRATIONS)}")
        connection.execute("ROLLBACK")
    except sqlite3.OperationalError as error:
        code = error.sqlite_errorcode & 0xFF
        if code == sqlite3.SQLITE_READONLY:
            raise DamagedError("it forbids writing") from error
        if code != sqlite3.SQLITE_BUSY:  # somebody else is writing: then it can be written
            raise


def _prepare(connection: sqlite3.Connection) -> bool:
    """Bring the schema up to date; whether the database was empty."""
    if _schema_version(connection) == len(MIGRATIONS):
        return False
    with transaction(connection):
        version = _schema_version(connection)  # another process may have been quicker
        for statements in MIGRATIONS[version:]:
            for statement in statements:
                connection.execute(statement)
        connection.execute(f"PRAGMA application_id = {APPLICATION_ID}")
        connection.execute(f"PRAGMA user_version = {len(MIGRATIONS)}")
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
    """A number that changes when another connection has written. `sqlite3.Error` if unreadable."""
    (version,) = connection.execute("PRAGMA data_version").fetchone()
    return int(version)


def identity_of(path: Path | None) -> Identity | None:
    """Return what distinguishes a file from another that takes its place; None if absent."""
    if path is None:
        return None
    try:
        found = os.stat(path)
    except OSError:
        return None
    return found.st_dev, found.st_ino


def is_damage(error: Exception) -> bool:
    """Return whether a failure means that the file holds something else than this program wrote."""
    if isinstance(error, (DamagedError, UnicodeDecodeError)):
        return True
    if not isinstance(error, sqlite3.DatabaseError):
        return False
    code = getattr(error, "sqlite_errorcode", None)
    if code is None:  # the module's own: a text that cannot be decoded
        return isinstance(error, sqlite3.OperationalError)
    return code & 0xFF not in _CIRCUMSTANCES or code == sqlite3.SQLITE_IOERR_SHORT_READ


def reason_of(error: Exception) -> str:
    """Return what a failure says, in one line."""
    if isinstance(error, UnicodeDecodeError):
        return "it contradicts itself"
    return " ".join((getattr(error, "strerror", None) or str(error)).split())


def free_sibling_name(path: Path, why: str) -> Path:
    """A name next to a file that is not taken yet."""
    number = 1
    while (free := path.with_name(f"{path.name}.{why}-{number}")).exists():
        number += 1
    return free


def set_aside(path: Path, identity: Identity | None) -> Path | None:
    """Put a damaged database out of the way, with its journal. `OSError` if that is impossible.

    Returns:
        Where it is now; None when another file has taken the place of the one with this identity
        meanwhile.
    """
    if identity_of(path) != identity:
        return None
    aside = free_sibling_name(path, "damaged")
    _move(path, aside)
    journal = path.with_name(f"{path.name}-journal")
    if journal.exists():
        _move(journal, aside.with_name(f"{aside.name}-journal"))
    return aside


def _move(path: Path, aside: Path) -> None:
    try:
        os.rename(path, aside)
    except PermissionError:  # somebody has it open (Windows)
        shutil.copyfile(path, aside)
        os.truncate(path, 0)
