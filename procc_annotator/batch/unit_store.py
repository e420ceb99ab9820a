"""The units of a run in one SQLite file: which are done, with their results, and which failed.

One process writes; others may read meanwhile, as ``status`` does. SQLite was chosen because a unit
is one transaction that a kill cannot tear, a season's 100,000 units need no memory, questions such
as "failed ones by match" are one statement, and it is part of Python.
"""

from __future__ import annotations

import hashlib
import sqlite3
import time
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, closing, contextmanager, suppress
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any, NamedTuple, Self

import numpy as np

from procc_annotator.batch.serialization import SerializationError, deserialize, serialize
from procc_annotator.errors import InputError, SaveError, UsageError
from procc_annotator.field.load import field_fingerprint
from procc_annotator.field.model import Field
from procc_annotator.formats.atomic import make_folder, remove, sibling_path
from procc_annotator.regular_file import read_head
from procc_annotator.version import __version__

DONE, FAILED, WAITING = "done", "failed", "waiting"
SOURCE = "source"  # of the terms: a run may go on with pictures that were moved
MOST_TRIES = 3  # a unit that failed so often is set aside
_BUSY_S = 30.0  # that a reader may hold up the writer
_VERSION = 1
_SCHEMA = f"""
CREATE TABLE terms (name TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE units (
    key TEXT PRIMARY KEY, match TEXT NOT NULL, kind TEXT NOT NULL, state TEXT NOT NULL,
    tries INTEGER NOT NULL, seconds REAL NOT NULL, frames INTEGER NOT NULL, evidence REAL,
    cameras INTEGER NOT NULL, error TEXT NOT NULL, changed REAL NOT NULL, result BLOB
) WITHOUT ROWID;
CREATE INDEX units_by_match ON units (match, state);
PRAGMA user_version = {_VERSION};
"""


@dataclass(frozen=True)
class Unit:
    """A part of a run.

    Attributes:
        key: distinguishes it, and all that its result depends on, from any other.
        match: that it belongs to; empty for a run over one source.
        kind: of work.
        state: `DONE`, `FAILED`, or `WAITING` for another try.
        tries: so far.
        seconds: of work, all tries together.
        frames: that it is about.
        evidence: 0 to 1, how much of the visible model was found on paint; None where nothing is
            measured.
        cameras: frames that have a camera.
        error: why the last try failed.
        changed: when, seconds since 1970.
    """

    key: str
    match: str = ""
    kind: str = ""
    state: str = DONE
    tries: int = 1
    seconds: float = 0.0
    frames: int = 0
    evidence: float | None = None
    cameras: int = 0
    error: str = ""
    changed: float = 0.0


class MatchUnits(NamedTuple):
    """What is known of a match.

    Attributes:
        state: `DONE` when its file is written, `FAILED` if it cannot be opened. frames: of the
            match; 0 before it was opened.
        done, failed: units. tracked: frames of those that are done. cameras: frames with a camera.
        seconds: of work. evidence: mean over the frames tracked. changed: when its last unit
            changed.
    """

    match: str
    state: str
    frames: int
    done: int
    failed: int
    tracked: int
    cameras: int
    seconds: float
    evidence: float | None
    changed: float

    @property
    def progress(self) -> str:
        """``waiting``, ``begun``, ``failed`` or ``done``."""
        if self.state in (DONE, FAILED):
            return self.state
        return "begun" if self.done or self.failed else WAITING

    @property
    def frames_tracked(self) -> int:
        """As `tracked`; frames that neighbouring pieces share count once when all are."""
        return min(self.tracked, self.frames or self.tracked)


MATCH = "match"  # kind of the row that stands for the whole of one
_PIECE = "rtrim(key, '0123456789abcdef')"  # of a shot, whatever anchors it was followed from
_OTHER = "FROM units WHERE match = ? AND kind <> ? AND instr(key, ?) = 0"
_COLUMNS = tuple(field.name for field in fields(Unit))


def unfinished_path(out: Path, command: str) -> Path:
    """Return where the store of a run lies: in the folder that is written, or next to the archive;
    hidden, so that no listing of cameras or annotations minds it."""
    if out.suffix.lower() == ".zip":
        return sibling_path(out, ".", f".{command}.unfinished")
    return out / f".{command}.unfinished"


class UnitStore:
    """Units of one run; used as a context, which closes the file."""

    def __init__(self, path: Path, terms: Mapping[str, str], *, resume: bool) -> None:
        """Begin, or go on.

        Args:
            path: it and its folder are made with the first unit.
            terms: what the run was asked for, in words; another one's results are none of this
                one's.
            resume: whether to go on with what is there; else that goes.

        Raises:
            UsageError: what is there was begun with other terms.
            InputError: it cannot be read.
        """
        self.path = path
        self.terms = {**terms, "version": __version__, "numpy": np.__version__}
        self._database: sqlite3.Connection | None = None
        if resume and path.exists():
            self._database = _opened(path)
            self._check()
            if source := terms.get(SOURCE):  # the list that is worked on now
                self._write("UPDATE terms SET value = ? WHERE name = ?", source, SOURCE)

    @classmethod
    def read(cls, path: Path) -> Self:
        """What a run left, or is writing, to look at.

        Raises:
            InputError: it cannot be read.
        """
        found = cls.__new__(cls)
        found.path, found._database = path, _opened(path)
        found.terms = dict(found._rows("SELECT name, value FROM terms"))
        return found

    def __contains__(self, key: str) -> bool:
        """Return whether a unit is done."""
        return bool(self._rows("SELECT 1 FROM units WHERE key = ? AND state = ?", (key, DONE)))

    def __len__(self) -> int:
        found = self._rows("SELECT COUNT(*) FROM units WHERE state = ?", (DONE,))
        return int(found[0][0]) if found else 0

    def result(self, key: str) -> Any:
        """The result of a unit that is done; None if it cannot be read."""
        found = self._rows("SELECT result FROM units WHERE key = ? AND state = ?", (key, DONE))
        try:
            return deserialize(found[0][0]) if found and found[0][0] else None
        except SerializationError:
            return None

    def unit(self, key: str) -> Unit | None:
        """What is known of a unit."""
        found = self._rows(f"SELECT {', '.join(_COLUMNS)} FROM units WHERE key = ?", (key,))
        return Unit(*found[0]) if found else None

    def units(self, state: str) -> Iterator[Unit]:
        """Those in a state, by match."""
        order = f"SELECT {', '.join(_COLUMNS)} FROM units WHERE state = ? ORDER BY match, key"
        return (Unit(*row) for row in self._rows(order, (state,)))

    def matches(self) -> list[MatchUnits]:
        """The matches, in the order of their names; of pieces of shots that were followed several
        times the last time counts."""
        last = f"changed = MAX(changed) OVER (PARTITION BY match, {_PIECE}, evidence IS NULL)"
        tracked = "CASE WHEN kind = :match OR evidence IS NULL THEN 0 ELSE last * frames END"
        whole = "kind = :match AND state = :done"
        return [
            MatchUnits(*row)
            for row in self._rows(
                "SELECT match, MAX(CASE WHEN kind = :match THEN state ELSE '' END),"
                " SUM(CASE WHEN kind = :match THEN frames ELSE 0 END),"
                f" COUNT(DISTINCT CASE WHEN kind <> :match AND state = :done THEN {_PIECE} END),"
                " SUM(kind <> :match AND state = :failed),"
                f" SUM({tracked}),"
                f" COALESCE(MAX(CASE WHEN {whole} THEN cameras END), SUM(last * cameras)),"
                f" SUM(seconds), COALESCE(MAX(CASE WHEN {whole} THEN evidence END),"
                f" SUM(evidence * {tracked}) / SUM({tracked})),"
                f" MAX(changed) FROM (SELECT {', '.join(_COLUMNS)}, {last} AS last FROM units)"
                " GROUP BY match ORDER BY match",
                {"match": MATCH, "done": DONE, "failed": FAILED},
            )
        ]

    def tracked_since(self, time_s: float) -> tuple[int, float]:
        """Frames of pieces first followed since a time, and when work on units done since began."""
        found = self._rows(
            "SELECT SUM(frames), (SELECT MIN(changed - seconds) FROM units"
            " WHERE kind <> :match AND changed > :since) FROM (SELECT frames FROM units"
            " WHERE evidence IS NOT NULL AND kind <> :match"
            f" GROUP BY match, {_PIECE} HAVING MIN(changed) > :since)",
            {"match": MATCH, "since": time_s},
        )
        return (found[0][0] or 0, found[0][1] or time_s) if found else (0, time_s)

    def announce(self, match: str, state: str = WAITING, **about: Any) -> None:
        """Note a match: that there is one, and what is known of the whole of it."""
        self._put(
            Unit(f"{match}/{MATCH}", match, MATCH, state, 0, changed=time.time(), **about), None
        )

    def has_other(self, match: str, stamp: str) -> bool:
        """Return whether a match has units of other content, without its stamp in their keys."""
        return bool(self._rows(f"SELECT 1 {_OTHER}", (match, MATCH, f"/{stamp}/")))

    def drop_other(self, match: str, stamp: str) -> None:
        """Drop those units."""
        self._write(f"DELETE {_OTHER}", match, MATCH, f"/{stamp}/")

    def add(self, key: str, result: Any, **about: Any) -> Unit:
        """Keep what came of a unit, before anything is said of it.

        Args:
            about: attributes of the `Unit`.

        Raises:
            SaveError: the disk is full, say.
        """
        data = None if result is None else serialize(result)
        return self._put(Unit(key, changed=time.time(), **about), data)

    def fail(self, unit: Unit, *, last: bool = False) -> Unit:
        """Keep that a try failed, perhaps the last one."""
        state = FAILED if last or unit.tries >= MOST_TRIES else WAITING
        return self._put(replace(unit, state=state, changed=time.time()), None)

    def forget(self, match: str, kind: str) -> None:
        """Drop the results of a match whose file is written; its units stay."""
        self._write("UPDATE units SET result = NULL WHERE match = ? AND kind = ?", match, kind)

    def restart(self, *, failed: bool = False, evidence_below: float | None = None) -> None:
        """Units are to be done again: those that were set aside, or with less evidence."""
        if failed:
            self._write("DELETE FROM units WHERE state IN (?, ?)", FAILED, WAITING)
        if evidence_below is not None:
            self._write("DELETE FROM units WHERE evidence < ?", evidence_below)

    def finish(self) -> None:
        """All is written: nothing is left to go on with.

        Raises:
            SaveError: the file cannot be removed.
        """
        self.__exit__()
        remove(self.path)

    def _rows(self, statement: str, values: Any = ()) -> list[Any]:
        if self._database is None:
            return []
        try:
            return self._database.execute(statement, values).fetchall()
        except sqlite3.Error as error:
            raise _damaged(self.path, error) from error

    def _put(self, unit: Unit, result: str | None) -> Unit:
        marks = ", ".join("?" * (len(_COLUMNS) + 1))
        columns = ", ".join((*_COLUMNS, "result"))
        self._write(
            f"INSERT OR REPLACE INTO units ({columns}) VALUES ({marks})",
            *(getattr(unit, name) for name in _COLUMNS),
            result,
        )
        return unit

    def _write(self, statement: str, *values: object) -> None:
        try:
            if self._database is None:
                self._database = self._begun()
            with self._database:
                self._database.execute(statement, values)
        except (OSError, sqlite3.Error) as error:
            raise SaveError(f"{self.path}: cannot be written: {error}") from error

    def _begun(self) -> sqlite3.Connection:
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self.path.unlink(missing_ok=True)
        found = sqlite3.connect(self.path, timeout=_BUSY_S)
        with found:
            found.executescript(_SCHEMA)
            found.executemany("INSERT INTO terms VALUES (?, ?)", self.terms.items())
        return found

    def _check(self) -> None:
        before = dict(self._rows("SELECT name, value FROM terms"))
        for name in dict.fromkeys((*self.terms, *before)):
            if name != SOURCE and before.get(name) != self.terms.get(name):
                raise UsageError(
                    f"{self.path.parent}: what is there was begun with another {name}"
                    f" ({before.get(name) or 'none'}, now {self.terms.get(name) or 'none'}); ask"
                    " for the same to go on, or begin anew with --overwrite"
                )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *failure: object) -> None:
        if self._database is not None:
            self._database.close()
            self._database = None


@contextmanager
def only_run(folder: Path) -> Iterator[None]:
    """Hold the lock of a folder, made if needed; UsageError if another run has it."""
    make_folder(folder)
    file = folder / ".run.lock"
    with ExitStack() as opened:
        try:  # the lock is given up when a process ends
            lock = opened.enter_context(closing(sqlite3.connect(file, timeout=0)))
            lock.execute("BEGIN EXCLUSIVE")
        except sqlite3.OperationalError as error:
            why = f"another run writes there or it is read-only ({error}); wait, or write elsewhere"
            raise UsageError(f"{folder}: {why}") from error
        try:
            yield
        finally:
            lock.close()
            with suppress(OSError):  # other files are there, as they should
                file.unlink()
                folder.rmdir()


def _opened(path: Path) -> sqlite3.Connection:
    try:
        read_head(path, 1)
        # Also to look at it: a transaction that a kill cut off is rolled back by who opens it next.
        found = sqlite3.connect(f"{path.absolute().as_uri()}?mode=rw", uri=True, timeout=_BUSY_S)
        version = found.execute("PRAGMA user_version").fetchone()[0]
    except OSError as error:
        raise InputError(path, f"cannot be read: {error.strerror or error}") from error
    except sqlite3.Error as error:
        raise _damaged(path, error) from error
    if version != _VERSION:
        raise _damaged(path, f"version {version}, expected {_VERSION}")
    return found


def _damaged(path: Path, error: object) -> InputError:
    return InputError(
        path,
        f"is not what a run of this program leaves ({error})",
        advice="remove it, or begin anew with --overwrite",
    )


def hex_digest(*parts: object) -> str:
    """SHA-256, in hexadecimal, of bytes, and of the text of anything else; names of files may be no
    UTF-8."""
    digest = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else str(part).encode("utf-8", "surrogatepass")
        digest.update(len(data).to_bytes(8, "big"))
        digest.update(data)
    return digest.hexdigest()


def field_settings(field: Field) -> str:
    """A field as a term of a run: its words and a digest of all that fits and proposals look at,
    which is more than distinguishes fields."""
    looked_at = (
        field.cameras,
        [(e.name, e.appearance, e.line_width, e.inside) for e in field.elements],
        [(m.name, m.position, m.covariance, m.instant, m.surveyed) for m in field.landmarks],
        sorted(field.instants.items()),
        field.pixels,
    )
    return f"{field.described}, {hex_digest(field_fingerprint(field), repr(looked_at))[:12]}"


def stamp_of_file(path: Path) -> str:
    """Size and time of a file, as a text; empty for none."""
    try:
        found = path.stat()
    except OSError:  # what is not there is told where it is wanted
        return ""
    return f"{found.st_size} {found.st_mtime_ns}"
