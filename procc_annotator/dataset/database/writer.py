"""The writer thread that owns the database connection.

Anyone who queues a write waits for nothing. When the disk is full or the folder is gone, everything
stays in memory and is tried again every few seconds.
"""

from __future__ import annotations

import sqlite3
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from contextlib import suppress
from pathlib import Path
from typing import TypeVar

from procc_annotator.dataset.database.backup import (
    copy_readable,
    is_backup_due,
    write_all,
    write_backup,
)
from procc_annotator.dataset.database.connection import (
    FAILURES,
    Identity,
    OpenedDatabase,
    identity_of,
    is_damage,
    open_database,
    reason_of,
)
from procc_annotator.dataset.database.schema import Write

T = TypeVar("T")

RETRY_DELAY_S = 3.0
_WATCH_S = 1.0  # how often it looks whether the program has ended without closing

_KEEPS_CONNECTION = {sqlite3.SQLITE_BUSY, sqlite3.SQLITE_LOCKED, sqlite3.SQLITE_FULL}


# At most so much work is in neither the file nor its backup if the file is lost: little enough to
# be remembered. A slow disk spends no more than a twentieth of the time on backups.
BACKUP_S = 300.0


class UnavailableError(Exception):
    """The database cannot be read now."""


class _BusyError(Exception):
    """A person waits for the thread that copies the database."""


class DatabaseWriter:
    """Queue of writes and questions before one database.

    Args:
        opened: the database; belongs to the writer from now on.
        notify: gets what the user should know (called by the writer's thread).
    """

    def __init__(
        self,
        path: Path | None,
        opened: OpenedDatabase,
        notify: Callable[[tuple[str, ...]], None],
    ) -> None:
        self.problem = ""
        self._path = path
        self._connection: sqlite3.Connection | None = opened.connection
        self._identity = opened.identity
        self._notify = notify
        self._changed = threading.Condition()
        self._waiting: list[Write] = []
        self._questions: list[Callable[[], None]] = []
        self._asked = 0  # flushes asked for, and those of them that had their round
        self._served = 0
        self._closing = False
        # A disk that damages everything must not fill up with what was set aside.
        self._may_set_aside = 3
        self._condemned: tuple[Identity | None, Exception] | None = None
        self._next_backup = 0.0  # on the monotonic clock
        self._thread = threading.Thread(target=self._run, name="workspace database")
        self._thread.start()

    def put(self, write: Write) -> None:
        """Queue a write."""
        with self._changed:
            self._waiting.append(write)
            if not self.problem:
                self._changed.notify_all()

    def pending(self) -> list[Write]:
        """Return what is not written yet, oldest first."""
        with self._changed:
            return list(self._waiting)

    def submit(self, question: Callable[[sqlite3.Connection], T]) -> Future[T]:
        """Have something read after everything that is queued; the future may fail with
        `UnavailableError`."""
        future: Future[T] = Future()
        with self._changed:
            if self._closing:
                future.set_exception(UnavailableError("the database is closed"))
                return future
            self._questions.append(lambda: self._answer(question, future))
            self._changed.notify_all()
        return future

    def flush(self, timeout: float) -> bool:
        """Write what is queued; whether all of it is written (False also after ``timeout`` s)."""
        with self._changed:
            if not self._waiting:
                return True
            if not self._thread.is_alive():
                return False
            self._asked += 1
            ticket = self._asked
            self._changed.notify_all()
            served = self._changed.wait_for(lambda: self._served >= ticket, timeout)
            return served and not self.problem

    def close(self, timeout: float) -> bool:
        """Write what is queued and end; whether all of it is written."""
        with self._changed:
            self._closing = True
            self._changed.notify_all()
        self._thread.join(timeout)
        with self._changed:
            return not self._waiting

    def _run(self) -> None:
        try:
            while self._round():
                pass
        finally:
            self._disconnect()
            with self._changed:
                self._closing = True
                if self._waiting and not self.problem:
                    self.problem = "the workspace database is closed"
                self._changed.notify_all()

    def _round(self) -> bool:
        with self._changed:
            trouble = bool(self.problem)
            woken = self._changed.wait_for(self._has_work, RETRY_DELAY_S if trouble else _WATCH_S)
            last = self._closing or not threading.main_thread().is_alive()
            self._closing = last
            asked = self._asked
            questions, self._questions = self._questions, []
        if woken or trouble or last:
            self._write_waiting()
        for answer in questions:
            answer()
        with self._changed:
            self._served = asked
            self._changed.notify_all()
        self._back_up(last)
        return not last

    def _back_up(self, last: bool) -> None:
        """Keep a backup next to the file: at the end, and every few minutes while no one waits."""
        connection, path = self._connection, self._path
        if self.problem or connection is None or path is None:
            return
        if not last and (time.monotonic() < self._next_backup or self._has_work()):
            return

        def make_way() -> None:
            if not last and self._has_work():
                raise _BusyError

        begun = time.monotonic()
        try:
            if identity_of(path) == self._identity and is_backup_due(path):
                write_backup(connection, path, make_way)
        except _BusyError:
            return  # again as soon as nobody waits
        except FAILURES as error:
            if is_damage(error):
                self._failed(error)
            else:
                self._notify((f"{path}: no backup could be kept ({reason_of(error)})",))
        self._next_backup = time.monotonic() + BACKUP_S + 20 * (time.monotonic() - begun)

    def _has_work(self) -> bool:
        urgent = self._closing or self._asked > self._served or bool(self._questions)
        return urgent or bool(self._waiting and not self.problem)

    def _write_waiting(self) -> None:
        for _ in range(2):  # once more at once when something was set aside
            try:
                self._ensure_connection()
                batch = [write.packed() for write in self.pending()]
                with self._changed:  # only this thread takes from the front
                    self._waiting[: len(batch)] = batch
                if batch and self._connection is not None:
                    write_all(self._connection, batch)
            except FAILURES as error:
                if not self._failed(error):
                    return
            else:
                with self._changed:
                    del self._waiting[: len(batch)]
                    self.problem = ""
                return

    def _ensure_connection(self) -> None:
        if self._path is None:
            return
        before = self._connection
        if before is not None and identity_of(self._path) == self._identity:
            return
        opened = open_database(self._path, self._condemned)
        self._condemned = None
        if opened.notices:
            self._notify(opened.notices)
        if before is not None:  # the file that lost its place can still be read
            copy_readable(before, opened.connection)
            before.close()
        self._connection = opened.connection
        self._identity = opened.identity

    def _failed(self, error: Exception) -> bool:
        """Remember why; whether trying again at once makes sense."""
        code = getattr(error, "sqlite_errorcode", None)
        if code is None or code & 0xFF not in _KEEPS_CONNECTION:
            self._disconnect()
        self.problem = (
            f"{self._path}: cannot be written, kept in memory meanwhile ({reason_of(error)})"
        )
        if self._path is None or not is_damage(error) or self._may_set_aside == 0:
            return False
        self._may_set_aside -= 1
        self._condemned = self._identity, error
        return True

    def _answer(self, question: Callable[[sqlite3.Connection], T], future: Future[T]) -> None:
        if not future.set_running_or_notify_cancel():
            return
        try:
            self._ensure_connection()
            assert self._connection is not None
            value = question(self._connection)
        except FAILURES as error:
            future.set_exception(UnavailableError(str(error)))
            self._failed(error)
        else:
            future.set_result(value)

    def _disconnect(self) -> None:
        if self._path is None and not self._closing:
            return  # memory has nowhere to come back from
        connection, self._connection = self._connection, None
        if connection is not None:
            with suppress(sqlite3.Error):
                connection.close()
