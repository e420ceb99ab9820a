"""Location of a dataset's workspace database, and the fingerprint that matches both."""

from __future__ import annotations

import hashlib
import heapq
import json
import os
import sqlite3
import zlib
from collections.abc import Callable, Iterable
from contextlib import closing, suppress
from itertools import islice
from pathlib import Path
from typing import Any

from procc_annotator.dataset.database.backup import (
    backup_path,
    backup_time,
    copy_readable_file,
    write_all,
)
from procc_annotator.dataset.database.connection import (
    FAILURES,
    FILE,
    FOLDER,
    OpenedDatabase,
    free_sibling_name,
    is_damage,
    lies_outside,
    loss_message,
    open_database,
    reason_of,
    reread,
)
from procc_annotator.dataset.database.schema import SETTING_KEY, DamagedError, Write, read
from procc_annotator.errors import InputError, SaveError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_source import read_file, suffix_of, walk
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.regular_file import open_regular
from procc_annotator.resources import data_folder

# Path of a picture below the folder, with slashes -> its size and a checksum of some of it.
Fingerprint = dict[str, str]

_SUFFIXES = frozenset(PICTURE_SUFFIXES) | frozenset(VIDEO_SUFFIXES)
_BYTES = 4096  # looked at in the middle of a picture
_PICTURES = 24  # as many tell datasets apart, and take no time to look at
_FOLDERS = 8  # of a tree, whose pictures are chosen from
_FOLDERS_LOOKED_INTO = 200  # until those are found


def fingerprint_of(folder: Path) -> Fingerprint:
    """The mark of a dataset's folder; empty if it holds no pictures or videos, or is out of reach.

    Chosen by their names alone, so that pictures that come or go change little of it.
    """
    names = _pictures(folder)
    chosen = heapq.nsmallest(_PICTURES, names, key=lambda n: (zlib.crc32(os.fsencode(n)), n))
    looks = ((name, _file_signature(folder / name)) for name in chosen)
    return {name: look for name, look in looks if look}


def _pictures(folder: Path) -> list[str]:
    """The pictures and videos of a folder; of one without any those of the first folders below it
    that hold some, with their paths."""
    found: list[str] = []
    holding = 0
    with suppress(InputError):  # what is out of reach has no mark
        for below, names in islice(walk(folder, lambda _: None), _FOLDERS_LOOKED_INTO):
            here = [below + name for name in names if suffix_of(name) in _SUFFIXES]
            found += here
            holding += bool(here)
            if (here and not below) or holding == _FOLDERS:
                break
    return found


def matches_folder(mark: Fingerprint, folder: Path) -> bool:
    """Return whether at least half of a mark's pictures are there as they were; an empty mark fits
    every folder."""
    return 2 * sum(_file_signature(folder / name) == look for name, look in mark.items()) >= len(
        mark
    )


def fingerprints_match(mark: Fingerprint, other: Fingerprint) -> bool:
    """Return whether at least half of a mark's pictures are in another mark too."""
    return 2 * sum(other.get(name) == look for name, look in mark.items()) >= len(mark)


def read_fingerprint(file: Path) -> Fingerprint:
    """A mark as it was written; empty if it cannot be read."""
    try:
        entries = json.loads(read_file(file))
    except (InputError, ValueError, RecursionError):
        return {}
    if not isinstance(entries, dict):
        return {}
    return {name: look for name, look in entries.items() if isinstance(look, str)}


def write_fingerprint(file: Path, mark: Fingerprint) -> None:
    """Keep a mark; without one, everything fits."""
    with suppress(SaveError):
        write_atomic(file, json.dumps(mark).encode())


def _file_signature(path: Path) -> str:
    """Empty for what cannot be read. Uncompressed pictures all have one size, hence the content."""
    try:
        with open_regular(path) as file:
            size = os.fstat(file.fileno()).st_size
            file.seek(size // 2)
            return f"{size} {zlib.crc32(file.read(_BYTES)):08x}"
    except (OSError, ValueError):  # ValueError: a name that no file can have
        return ""


_MOST_DATASETS = 100  # at one path
_LONGEST_NAME = 242  # bytes of a dataset's name, so that the mark behind it fits too
_BUSY_S = 5.0


def folder_of(dataset: Path) -> Path:
    """A dataset's folder; a single picture's is the one it lies in."""
    return dataset.parent if dataset.is_file() else dataset


def database_path(dataset: Path) -> Path:
    """Return where a dataset's database belongs."""
    return folder_of(dataset) / FOLDER / FILE


def user_fallback_path(dataset: Path) -> Path | None:
    """Return where it is kept for a dataset that cannot be written: the user's data folder; None
    when the user has no home."""
    base = data_folder()
    if base is None:
        return None
    folder = os.path.realpath(folder_of(dataset))
    mark = hashlib.sha256(os.fsencode(folder)).hexdigest()[:12]
    name = os.fsdecode(os.fsencode(os.path.basename(folder))[:_LONGEST_NAME]) or "root"
    return base / "procc-annotator" / f"{name}-{mark}" / FILE


def fallback_path_of(dataset: Path) -> Path | None:
    """The file in the user's data folder that holds what is known of this dataset, if one does."""
    folder = folder_of(dataset)
    own = _fallback_file(dataset, lambda mark: matches_folder(mark, folder))
    return own if own is not None and own.exists() else None


def open_or_fallback(dataset: Path) -> tuple[Path | None, OpenedDatabase, tuple[str, ...]]:
    """Open a dataset's database where it belongs, else the user's own, else one in memory (without
    a file); also return what the user should know.

    What was kept in the user's data folder while the dataset was out of reach is taken over.
    """
    notices: list[str] = []
    path, folder = database_path(dataset), folder_of(dataset)
    own = _fallback_file(dataset, lambda mark: matches_folder(mark, folder))
    try:
        opened = open_database(path)
    except FAILURES as error:
        notices.append(f"{path}: cannot be used ({reason_of(error)})")
    else:
        if own is None or not own.exists():
            return path, opened, ()
        return path, *_take_over(own, opened)
    if own is not None:
        try:
            opened = open_database(own)
        except FAILURES as error:
            notices.append(f"{own}: cannot be used ({reason_of(error)})")
        else:
            notices[-1] += f"; statuses and comments are kept in {own}"
            write_fingerprint(_mark_path(own), fingerprint_of(folder))
            # It can be read, at least.
            if opened.fresh and path.exists() and not lies_outside(path):
                with suppress(*FAILURES):
                    copy_readable_file(path, opened.connection)
                    opened = reread(opened)
            return own, opened, tuple(notices)
    notices.append("statuses and comments are kept in memory only: they end with the window")
    return None, open_database(None), tuple(notices)


def read_settings(dataset: Path) -> tuple[dict[str, str], str]:
    """The settings of a dataset (its folder, or a picture in it), by key, and a notice if the
    database is lost; empty if all is well. Nothing is made, written or fixed. `InputError` if there
    is a workspace, but it cannot be read."""
    start = SETTING_KEY
    meta, notice = _read_meta(dataset)
    found = {k.removeprefix(start): v for k, v in meta.items() if k.startswith(start) and v}
    return found, notice


def _read_meta(dataset: Path) -> tuple[dict[str, Any], str]:
    """Rows of a text and a value, none if there is no workspace; and a notice if they come from the
    backup, or if that is missing too."""
    path = database_path(dataset)
    lost = "" if lies_outside(path) else loss_message(path)
    if not lost and (not path.exists() or lies_outside(path)):
        found = fallback_path_of(dataset)
        if found is None:
            return {}, ""
        path = found
    made = backup_time(path)
    if lost and not made:
        return {}, f"{path}: {lost}, and it has no backup: what was set for the dataset is lost"
    try:
        if lost:
            raise DamagedError(lost)
        return _meta_rows(path), ""
    except FAILURES as error:
        why = reason_of(error)
        if made and is_damage(error):
            with suppress(*FAILURES):
                found_there = _meta_rows(backup_path(path))
                return found_there, f"{path}: {why}; its backup of {made} is read"
        raise InputError(path, f"the dataset's workspace cannot be read: {why}") from error


def _meta_rows(path: Path) -> dict[str, Any]:
    open_regular(path).close()  # SQLite would wait for a pipe
    connection = sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", _BUSY_S, uri=True)
    with closing(connection):
        return dict(read(connection, "key, value", "meta"))


def _mark_path(own: Path) -> Path:
    return own.with_name(f"{own.name}.json")


def _fallback_file(dataset: Path, known: Callable[[Fingerprint], bool]) -> Path | None:
    """The file in the user's data folder that was kept for this dataset, or a new one.

    Another dataset at the same path (drives are mounted where others were) has a file of its own,
    which no one renames: a window may have it open. ``known`` says whether a file's mark is this
    dataset's.
    """
    first = user_fallback_path(dataset)
    if first is None:
        return None
    files = [first, *(first.with_name(f"workspace-{n}.db") for n in range(2, _MOST_DATASETS))]
    kept = next((f for f in files if f.exists() and known(read_fingerprint(_mark_path(f)))), None)
    return kept or next((f for f in files if not f.exists()), None)


def _take_over(own: Path, opened: OpenedDatabase) -> tuple[OpenedDatabase, tuple[str, ...]]:
    try:
        copy_readable_file(own, opened.connection)
        done = free_sibling_name(own, "taken-over")
        os.replace(own, done)
        backup_path(own).unlink(missing_ok=True)  # or it would be restored, and taken over again
        return reread(opened), (f"what was kept in {own} meanwhile is taken over from there",)
    except FAILURES as error:
        return opened, (f"{own}: cannot be taken over ({reason_of(error)})",)


def save_to_fallback(dataset: Path, writes: Iterable[Write], mark: Fingerprint) -> Path | None:
    """Leave what could not be written for the next time the dataset is opened, which is probably
    out of reach now; its mark was taken while it was there.

    Returns:
        The file it is in; None when that failed, too.
    """
    own = _fallback_file(dataset, lambda known: fingerprints_match(known, mark))
    if own is None:
        return None
    with suppress(*FAILURES), closing(open_database(own).connection) as connection:
        write_all(connection, writes)
        write_fingerprint(_mark_path(own), mark)
        return own
    return None
