"""What tells a dataset from another one at the same path: some of its pictures.

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
from procc_annotator.image.suffixes import PICTURE_SUFFIXES
from procc_annotator.io.atomic import write_atomic

Mark = dict[str, str]  # name of a picture -> its size and a checksum of some of it

_BYTES = 4096  # looked at in the middle of a picture
_PICTURES = 24  # as many tell datasets apart, and take no time to look at


def mark_of(folder: Path) -> Mark:
    """The mark of a dataset's folder; empty if it holds no pictures or is out of reach.

    Chosen by their names alone, so that pictures that come or go change little of it.
    """
    try:
        names = [
            n for n in os.listdir(folder) if os.path.splitext(n)[1].lower() in PICTURE_SUFFIXES
        ]
    except OSError:
        return {}
    chosen = heapq.nsmallest(_PICTURES, names, key=lambda n: (zlib.crc32(os.fsencode(n)), n))
    looks = ((name, _look(folder / name)) for name in chosen)
    return {name: look for name, look in looks if look}


def belongs_to(mark: Mark, folder: Path) -> bool:
    """Whether at least half of a mark's pictures are there as they were; an empty mark fits every
    folder."""
    return 2 * sum(_look(folder / name) == look for name, look in mark.items()) >= len(mark)


def alike(mark: Mark, other: Mark) -> bool:
    """Whether at least half of a mark's pictures are in another mark too."""
    return 2 * sum(other.get(name) == look for name, look in mark.items()) >= len(mark)


def read_mark(file: Path) -> Mark:
    """A mark as it was written; empty if there is none that can be read."""
    try:
        entries = json.loads(file.read_bytes())
    except (OSError, ValueError, RecursionError):
        return {}
    if not isinstance(entries, dict):
        return {}
    return {name: look for name, look in entries.items() if isinstance(look, str)}


def write_mark(file: Path, mark: Mark) -> None:
    """Keep a mark; without one, everything fits."""
    with suppress(SaveError):
        write_atomic(file, json.dumps(mark).encode())


def _look(path: Path) -> str:
    """Empty for what cannot be read. Uncompressed pictures all have one size, hence the content."""
    try:
        with path.open("rb") as file:
            size = os.fstat(file.fileno()).st_size
            file.seek(size // 2)
            return f"{size} {zlib.crc32(file.read(_BYTES)):08x}"
    except (OSError, ValueError):  # ValueError: a name that no file can have
        return ""
