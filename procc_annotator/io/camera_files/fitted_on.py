"""Which annotations a camera was fitted to, as its file or the files beside it say.

A camera that was fitted to the very points it is judged by explains them; it does not predict them.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
from collections.abc import Mapping
from pathlib import PurePosixPath
from typing import Any

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.io.annotation_files.soccernet_annotation import write_annotation
from procc_annotator.io.csv_text import formula_text
from procc_annotator.io.source import FileSource
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


class FittedOn:
    """What the cameras of a source were fitted to; files beside them are read once."""

    def __init__(self, source: FileSource) -> None:
        self._source = source
        self._files: frozenset[str] | None = None
        self._tables: dict[PurePosixPath, Mapping[str, str]] = {}

    def of(self, frame: str, file: str, extra: Mapping[str, Any]) -> str | None:
        """The digest of the annotation that a camera was fitted to; None if nothing says so.

        Args:
            file: of the camera, in the source.
            extra: keys of the file that are not part of the camera.
        """
        own = _digest_in(extra.get(FIT_KEY))
        if own is not None:
            return own
        folder = PurePosixPath(file).parent
        name = PurePosixPath(frame).name
        for place in (folder, *folder.parents):  # of a tree it lies at the top
            if place not in self._tables:
                self._tables[place] = _table(self.beside(place / TABLE_FILE))
            table = self._tables[place]
            beside = table.get(frame) or table.get(str(folder.relative_to(place) / name))
            if beside is not None:
                return beside
        note = self.beside(folder / f"{frame}{BESIDE}")
        return None if note is None else _digest_in(_object(note))

    def beside(self, file: PurePosixPath) -> bytes | None:
        """The content of a file of the source; None where there is none that can be read."""
        if self._files is None:
            self._files = frozenset(self._source.files())
        if str(file) not in self._files:
            return None
        try:
            return self._source.read(str(file))
        except InputError:  # gone, or damaged: it says nothing
            return None


def _digest_in(found: object) -> str | None:
    digest = found.get(DIGEST) if isinstance(found, dict) else None
    return digest if isinstance(digest, str) and digest else None


def _object(data: bytes) -> object:
    try:
        return json.loads(data)
    except ValueError:
        return None


def _table(data: bytes | None) -> dict[str, str]:
    """Frame -> digest, of a table that has both columns; empty of any other file."""
    if data is None:
        return {}
    text = data.decode("utf-8-sig", errors="replace")
    try:
        rows = list(csv.DictReader(io.StringIO(text, newline="")))
    except csv.Error:
        return {}
    return {
        formula_text(row["name"]): row[DIGEST]
        for row in rows
        if row.get("name") and row.get(DIGEST)
    }
