"""Which annotations a camera was fitted to, as its file or the files beside it say.

A camera that was fitted to the very points it is judged by explains them; it does not predict them.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.io.annotation_files.soccernet_annotation import write_annotation
from procc_annotator.io.csv_text import formula_text
from procc_annotator.io.frame_names import FrameTable
from procc_annotator.language import word

# The mark of cameras that explain the points they were made from, and predict none of them.
FITTED = word("fitted on these clicks")
FIT_KEY = "fit"  # of a camera file: what it was fitted from
DIGEST = "annotation_sha256"  # among that, and the column of the table
TABLE_FILE = "calibration.csv"  # beside cameras of any format
BESIDE = ".fit"  # says it of one homography, whose own file holds numbers only


def annotation_digest(annotation: FrameAnnotation) -> str:
    """SHA-256 of an annotation as it would be written."""
    return hashlib.sha256(write_annotation(annotation)).hexdigest()


def is_fitted_on(digest: str | None, annotation: FrameAnnotation) -> bool:
    """Whether a camera that was fitted to the annotation of a digest was fitted to this one."""
    return digest is not None and digest == annotation_digest(annotation)


def marked(name: str, fitted: object) -> str:
    """The name of a source as it stands beside others, with the mark if it was fitted so."""
    return f"{name} ({FITTED})" if fitted else name


def fitted_words(fitted: int, with_camera: int) -> str:
    """The mark of a source of which so many of so many cameras were fitted to the annotations they
    are judged by; nothing of one that was fitted to none."""
    if not fitted:
        return ""
    return FITTED if fitted == with_camera else f"{FITTED} in {fitted} of {with_camera} frames"


def folders_of(file: str) -> Iterator[str]:
    """The folders that a file of a source lies in, from its own up to the top, which is empty; the
    others end in a slash."""
    while file:
        folder = file.rpartition("/")[0]
        yield f"{folder}/" if folder else ""
        file = folder


class FittedOn:
    """What the cameras of a source were fitted to; files beside them are read once."""

    def __init__(self, read: Callable[[str], bytes | None]) -> None:
        """As above.

        Args:
            read: the content of a file of the source; None where there is none.
        """
        self._read = read
        self._tables: dict[str, Mapping[str, str]] = {}

    def of(self, frame: str, file: str, extra: Mapping[str, Any]) -> str | None:
        """The digest of the annotation that a camera was fitted to; None if nothing says so.

        Args:
            file: of the camera, in the source.
            extra: keys of the file that are not part of the camera.
        """
        own = _digest_in(extra.get(FIT_KEY))
        if own is not None:
            return own
        name = frame.rpartition("/")[2]
        beside = file[: file.rfind("/") + 1] + name
        for folder in folders_of(file):  # of a tree it lies at the top
            if folder not in self._tables:
                self._tables[folder] = _table(self._read(folder + TABLE_FILE))
            table = self._tables[folder]
            if table and (found := table.get(frame) or table.get(beside[len(folder) :])):
                return found
        note = self._read(beside + BESIDE)
        return None if note is None else _digest_in(_object(note))


def _digest_in(found: object) -> str | None:
    digest = found.get(DIGEST) if isinstance(found, dict) else None
    return digest if isinstance(digest, str) and digest else None


def _object(data: bytes) -> object:
    try:
        return json.loads(data)
    except ValueError:
        return None


def _table(data: bytes | None) -> FrameTable[str]:
    """Frame -> digest, of a table that has both columns; empty of any other file."""
    if data is None:
        return FrameTable()
    text = data.decode("utf-8-sig", errors="replace")
    try:
        rows = list(csv.DictReader(io.StringIO(text, newline="")))
    except csv.Error:
        return FrameTable()
    return FrameTable(
        (formula_text(row["name"]), row[DIGEST])
        for row in rows
        if row.get("name") and row.get(DIGEST)
    )
