"""The workspace database: frame metadata, point origins and file versions of a dataset.

It lies in the dataset's ``.procc`` folder, or in the user's data folder when that cannot be
written. Annotations never depend on it, and nothing here makes the annotator wait or raises because
of the disk: what cannot be written yet is kept in memory, tried again, and named in ``problem``.
"""

from __future__ import annotations

import math
import sqlite3
import time
import uuid
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import Future
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from procc_annotator.dataset.database import schema
from procc_annotator.dataset.database.connection import OpenedDatabase, data_version
from procc_annotator.dataset.database.location import (
    database_path,
    fingerprint_of,
    folder_of,
    open_or_fallback,
    save_to_fallback,
)
from procc_annotator.dataset.database.metadata_cache import MetadataCache
from procc_annotator.dataset.database.schema import DamagedError, Row, Snapshot, Write, stored
from procc_annotator.dataset.database.writer import UnavailableError
from procc_annotator.dataset.records import (
    Origin,
    PointKey,
    Version,
    digest_of,
)
from procc_annotator.errors import InputError

T = TypeVar("T")

# How long the annotator may wait for something to be read: at most, and once it is known that the
# database cannot be reached.
_TIMEOUT_S = 2.0
_NO_WAIT_S = 0.1


@dataclass(frozen=True)
class _ExternalChanges:
    """State that other processes gave the database, valid if nothing was changed here meanwhile."""

    changes: int
    frames: frozenset[str]
    settings: frozenset[str]
    snapshot: Snapshot


class WorkspaceDatabase(MetadataCache):
    """Database of a dataset's frames: what is kept in memory, origins and versions.

    Belongs to one thread (any may use `record`, `records`, `read_origins`, `add_version`,
    ``problem`` and `flush`). Frames are known by name, which may hold any characters.

    Attributes:
        path: the file; None when everything is in memory only and will be lost.
        author: signs comments and versions.
    """

    def __init__(
        self,
        dataset: Path,
        path: Path | None,
        author: str,
        opened: OpenedDatabase,
        notices: tuple[str, ...],
    ) -> None:
        super().__init__(path, opened, author, notices)
        self._dataset = dataset
        self._origins: dict[str, dict[PointKey, Origin]] = {}  # all of a frame's
        self._foreseen: dict[str, Future[dict[PointKey, Origin]]] = {}  # asked for early
        self._put: dict[str, dict[PointKey, Origin]] = {}  # those of this session
        self._looking: Future[_ExternalChanges | None] | None = None
        self._others_settings: set[str] = set()  # taken over, and not asked for yet
        self._look_again = False
        self._kept_elsewhere = False
        # Of the writer's thread: which state of the file the memory was compared with last.
        self._seen: tuple[sqlite3.Connection | None, int] = (
            opened.connection,
            opened.data_version,
        )
        # By the writer's thread: it takes a while on a network folder, and is needed at the end.
        self._mark = self._writer.submit(lambda _: fingerprint_of(folder_of(dataset)))

    @classmethod
    def open(cls, dataset: Path, author: str) -> WorkspaceDatabase:
        """Open a dataset's database, or begin one; never fails.

        What had to be done about a damaged, foreign or write-protected one is in `notices`.

        Args:
            dataset: its folder (or a picture in it).
            author: see `default_author`.
        """
        path, opened, notices = open_or_fallback(dataset)
        return cls(dataset, path, author, opened, notices)

    @property
    def shared(self) -> bool:
        """Return whether everybody who opens the dataset reads this: not what is in the user's
        data folder, or in memory."""
        return self.path == database_path(self._dataset)

    def origins(self, frame: str) -> dict[PointKey, Origin]:
        """Origins of a frame's points, as far as known, also of points no longer there.

        Read from the file the first time: up to two seconds when that does not answer, and then
        only what this session put there.
        """
        known = self._origins.get(frame)
        if known is None:
            try:
                foreseen = self._foreseen.pop(frame, None)
                read = self._answer(foreseen or self._ask_origins(frame))
            except UnavailableError:
                return dict(self._put.get(frame, {}))
            known = self._origins[frame] = read | self._put.get(frame, {})
        return dict(known)

    def read_origins(self, frame: str) -> dict[PointKey, Origin]:
        """As `origins`, safe from any thread: read from the file each time, and nothing is kept.
        `InputError` if not all can be read, as once another dataset was opened."""
        try:
            read = self._answer(self._ask_origins(frame))
        except UnavailableError as error:
            why = f"the origins of the points of frame {frame} cannot be read ({error})"
            raise InputError(self._shown, why) from error
        # Examined last: what is put there meanwhile may be missing from what was read.
        return read | self._put.get(frame, {})

    def prefetch_origins(self, frames: Iterable[str]) -> None:
        """Begin to read what `origins` will be asked for soon; never waits.

        An answer waits for all that is queued before it, up to the disk.
        """
        wanted = [frame for frame in frames if frame not in self._origins]
        self._foreseen = {f: self._foreseen.get(f) or self._ask_origins(f) for f in wanted}

    def put_origins(self, frame: str, origins: Mapping[PointKey, Origin]) -> None:
        """Add or replace origins of a frame's points; points that are no numbers are left out."""
        kept = {
            (float(u), float(v)): origin
            for (u, v), origin in origins.items()
            if math.isfinite(u) and math.isfinite(v) and math.isfinite(origin.time)
        }
        if not kept:
            return
        self._put_write(schema.origins_write(frame, kept))
        self._put.setdefault(frame, {}).update(kept)
        if frame in self._origins:
            self._origins[frame].update(kept)

    def add_version(self, frame: str, data: bytes, reason: str) -> None:
        """Keep the bytes of a frame's annotation file, unless the newest version has the same."""
        head = (uuid.uuid4().hex, stored(frame), stored(self.author), time.time(), stored(reason))
        row = (*head, digest_of(data), bytes(data))
        # Nothing that is kept in memory changes by it.
        self._writer.put(Write(schema.ADD_VERSION, (row,), raw=True))

    def versions(self, frame: str) -> tuple[Version, ...]:
        """A frame's versions, newest first (in the order written, whatever the clocks said).

        Up to two seconds when the file does not answer, and then only those not written yet.
        """
        try:
            read = self._ask(lambda connection: schema.load_versions(connection, frame))
        except UnavailableError:
            read = ()
        known = {version.id for version in read}
        waiting = (schema.version_of(row) for row in reversed(self._unwritten_versions()))
        new = (one for one in waiting if one.frame == frame and one.id not in known)
        return (*new, *read)

    def version_data(self, version_id: str) -> bytes:
        """The bytes of a version. `InputError` if the id is unknown, or it cannot be read."""
        found = next((r[5:] for r in self._unwritten_versions() if r[0] == version_id), None)
        try:
            if found is None:
                found = self._ask(
                    lambda connection: schema.load_version_data(connection, version_id)
                )
            if found is None:
                raise InputError(self._shown, "there is no such version")
            return schema.version_data_of(found)
        except UnavailableError as error:
            raise InputError(self._shown, f"version cannot be read ({error})") from error
        except DamagedError as error:
            raise InputError(self._shown, "this version is damaged") from error

    def poll(self) -> frozenset[str]:
        """Take over what other processes wrote; call it every few seconds, it never waits.

        Return the frames with another record, comment, verdict, element not visible or draft, as
        the look begun by the call before found them.
        """
        changed = self.collect()
        if self._looking is None:
            self._looking = self._writer.submit(self._look)
        return changed

    @property
    def looking(self) -> bool:
        """Return whether a look that `poll` began is to be collected."""
        return self._looking is not None

    def collect(self) -> frozenset[str]:
        """Take over what the look begun by `poll` found, as `poll` does, if it is done by now; the
        sooner it is asked for, the less can have been changed here meanwhile."""
        looking = self._looking
        if looking is None or not looking.done():
            return frozenset()
        self._looking = None
        changed, outdated = self._take(looking)
        if outdated:
            self._looking = self._writer.submit(self._look)
        return changed

    def changed_settings(self) -> frozenset[str]:
        """The settings that other processes gave or took back, as far as taken over since this was
        asked last."""
        changed, self._others_settings = frozenset(self._others_settings), set()
        return changed

    def reload(self, timeout: float = _TIMEOUT_S) -> frozenset[str]:
        """Like `poll`, but wait for the look (at most ``timeout`` s)."""
        changed: frozenset[str] = frozenset()
        begun, self._looking = self._looking, None
        for looking in (begun, self._writer.submit(self._look)):
            if looking is None:
                continue
            try:
                looking.exception(timeout)
            except TimeoutError:
                self._looking = looking
                return changed
            changed |= self._take(looking)[0]
        return changed

    def flush(self, timeout: float = _TIMEOUT_S) -> bool:
        """Write what is queued; whether all of it is written now."""
        return self._writer.flush(timeout)

    def close(self, timeout: float = 10.0) -> bool:
        """Write what is queued and let go of the file; whether all of it was written.

        What the file does not take any more is left in the user's data folder (a notice says), and
        taken over from there when the dataset is opened the next time.
        """
        if self._writer.close(timeout):
            return True
        if self.path is None or self._kept_elsewhere:
            return self._kept_elsewhere
        known = self._mark.done() and self._mark.exception() is None
        writes = [w.packed() for w in self._writer.pending()]
        kept = save_to_fallback(self._dataset, writes, self._mark.result() if known else {})
        self._kept_elsewhere = kept not in (None, self.path)
        if self._kept_elsewhere:
            self._notify((f"{self.path}: the latest changes are kept in {kept} until it is back",))
        return self._kept_elsewhere

    @property
    def _shown(self) -> str:
        return str(self.path or "memory")

    def _ask(self, question: Callable[[sqlite3.Connection], T]) -> T:
        return self._answer(self._writer.submit(question))

    def _ask_origins(self, frame: str) -> Future[dict[PointKey, Origin]]:
        return self._writer.submit(lambda connection: schema.load_origins(connection, frame))

    def _answer(self, future: Future[T]) -> T:
        try:
            return future.result(_NO_WAIT_S if self.problem else _TIMEOUT_S)
        except TimeoutError as error:
            future.cancel()
            raise UnavailableError("it does not answer") from error

    def _unwritten_versions(self) -> list[Row]:
        writes = (w.packed() for w in self._writer.pending() if w.sql == schema.ADD_VERSION)
        return [row for write in writes for row in write.rows]

    def _take(self, looking: Future[_ExternalChanges | None]) -> tuple[frozenset[str], bool]:
        """The frames that changed; and whether nothing was taken over, as it was outdated."""
        if looking.exception() is not None:  # it is named in `problem`, and looked again
            return frozenset(), False
        look = looking.result()
        if look is None:
            return frozenset(), False
        self._origins.clear()
        self._foreseen.clear()
        if look.changes != self._changes:
            # Taking it over could undo what was changed here meanwhile: look again.
            self._look_again = True
            return frozenset(), True
        self._take_over(look.snapshot, look.frames)
        self._others_settings |= look.settings
        return look.frames, False

    # What follows is called by the writer's thread.

    def _look(self, connection: sqlite3.Connection) -> _ExternalChanges | None:
        version = data_version(connection)
        if self._seen == (connection, version) and not self._look_again:
            return None
        self._look_again = False
        changes = self._changes
        if self._writer.pending():
            self._look_again = True
            return None
        snapshot = schema.load(connection)
        self._seen = (connection, version)
        differences = self._differences(snapshot)
        return _ExternalChanges(changes, differences, self._settings_changed(snapshot), snapshot)
