"""What tells a dataset from another one at the same path: some of its pictures, by name and size.

Drives are mounted where others were before; what was remembered of one must not be told of another.
"""

from __future__ import annotations

import heapq
import json
import os
import zlib
from contextlib import suppress
from pathlib import Path

from procc_annotator.errors import SaveError
from procc_annotator.image.decode import PICTURE_SUFFIXES
from procc_annotator.io.atomic import write_atomic

Mark = dict[str, int]  # name of a picture -> bytes

_PICTURES = 24  # as many tell datasets apart, and take no time to look at


def mark_of(folder: Path) -> Mark:
    """The mark of a dataset's folder; empty if it holds no pictures or is out of reach.

    Chosen by their names alone, so that pictures that come or go change little of it.
    """
    try:
        names = [n for n in os.listdir(folder) if Path(n).suffix.lower() in PICTURE_SUFFIXES]
    except OSError:
        return {}
    chosen = heapq.nsmallest(_PICTURES, names, key=lambda n: (zlib.crc32(os.fsencode(n)), n))
    sizes = ((name, _size(folder / name)) for name in chosen)
    return {name: size for name, size in sizes if size is not None}


def fits(mark: Mark, folder: Path) -> bool:
    """Whether at least half of a mark's pictures are there, as large as they were; an empty mark
    fits every folder."""
    return 2 * sum(_size(folder / name) == size for name, size in mark.items()) >= len(mark)


def read_mark(file: Path) -> Mark:
    """A mark as it was written; empty if there is none that can be read."""
    try:
        entries = json.loads(file.read_bytes())
    except (OSError, ValueError, RecursionError):
        return {}
    if not isinstance(entries, dict):
        return {}
    return {name: size for name, size in entries.items() if type(size) is int}


def write_mark(file: Path, mark: Mark) -> None:
    """Keep a mark; without one, everything fits."""
    with suppress(SaveError):
        write_atomic(file, json.dumps(mark).encode())


def _size(path: Path) -> int | None:
    try:
        return path.stat().st_size
    except (OSError, ValueError):  # ValueError: a name that no file can have
        return None
