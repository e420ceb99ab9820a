"""What tells a dataset from another one at the same path: some of its pictures and videos.

Drives are mounted where others were before; what was remembered of one must not be told of another.
"""

from __future__ import annotations

import heapq
import json
import os
import zlib
from contextlib import suppress
from itertools import islice
from pathlib import Path

from procc_annotator.errors import InputError, SaveError
from procc_annotator.image.suffixes import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.io.atomic import write_atomic
from procc_annotator.io.folders import walk
from procc_annotator.io.source import read_file
from procc_annotator.regular_file import open_regular

Fingerprint = dict[
    str, str
]  # path of a picture below the folder, with slashes -> its size and a checksum of some of it

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
            here = [below + name for name in names if _suffix(name) in _SUFFIXES]
            found += here
            holding += bool(here)
            if (here and not below) or holding == _FOLDERS:
                break
    return found


def _suffix(name: str) -> str:
    return os.path.splitext(name)[1].lower()


def matches_folder(mark: Fingerprint, folder: Path) -> bool:
    """Whether at least half of a mark's pictures are there as they were; an empty mark fits every
    folder."""
    return 2 * sum(_file_signature(folder / name) == look for name, look in mark.items()) >= len(mark)


def fingerprints_match(mark: Fingerprint, other: Fingerprint) -> bool:
    """Whether at least half of a mark's pictures are in another mark too."""
    return 2 * sum(other.get(name) == look for name, look in mark.items()) >= len(mark)


def read_fingerprint(file: Path) -> Fingerprint:
    """A mark as it was written; empty if there is none that can be read."""
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
