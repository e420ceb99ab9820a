"""How well elements left out of a fit are shown by the camera of the others, kept beside cameras.

A row belongs to the camera whose file has its hash: a camera that was fitted anew has none here.
"""

from __future__ import annotations

import csv
import hashlib
import io
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from procc_annotator.io.camera_files.fitted_on import folders_of
from procc_annotator.io.csv_text import unescape_formula

LEFT_OUT_FILE = "held_out.csv"
CAMERA_HASH = "camera_sha256"
# Columns besides the frame's name, which is for people.
COLUMNS = (
    "class", "held_out_px", "in_sample_px", "protocol", "width", "height", "field_sha256",
    CAMERA_HASH,
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class LeftOutElement:
    """One element under the camera of the others, and under that of all.

    Attributes:
        name: the class.
        predicted_px, explained_px: how far its farthest point is from where the camera of the
            others, and that of all, shows it; None where it does not show it.
    """

    name: str
    predicted_px: float | None
    explained_px: float | None


@dataclass(frozen=True, slots=True)
class LeftOutSettings:
    """What distances were taken with.

    Attributes:
        protocol: ``soccernet`` or ``procc``.
        size: (width, height) px.
        field_sha256: `field_fingerprint` of the field.
    """

    protocol: str
    size: tuple[int, int]
    field_sha256: str


@dataclass(frozen=True, slots=True)
class LeftOutResult:
    """The elements of a frame that were left out in turn, and what they were judged with."""

    terms: LeftOutSettings
    elements: tuple[LeftOutElement, ...]


def camera_hash(data: bytes) -> str:
    """SHA-256 of a camera's file."""
    return hashlib.sha256(data).hexdigest()


class LeftOutTables:
    """What such tables say of the cameras beside them; each is read once."""

    def __init__(self, read: Callable[[str], bytes | None]) -> None:
        """As above.

        Args:
            read: the content of a file of the source; None where there is none.
        """
        self._read = read
        self._tables: dict[str, tuple[Mapping[str, LeftOutResult], str]] = {}

    def of(self, file: str, data: bytes) -> tuple[LeftOutResult | None, str]:
        """What is known of a camera, and a remark on a table that cannot be read.

        Args:
            file: of the camera, in the source. data: its content.
        """
        remarks = []
        for folder in folders_of(file):  # of a tree it lies at the top
            if folder not in self._tables:
                self._tables[folder] = _read_table(self._read(folder + LEFT_OUT_FILE))
            table, remark = self._tables[folder]
            remarks.append(remark)
            if table and (found := table.get(camera_hash(data))) is not None:
                return found, remark
        return None, next(filter(None, remarks), "")


def _read_table(data: bytes | None) -> tuple[Mapping[str, LeftOutResult], str]:
    """By the hash of the camera; nothing of a file that has not the columns of such a table."""
    if data is None:
        return {}, ""
    reader = csv.DictReader(io.StringIO(data.decode("utf-8-sig", "replace"), newline=""))
    # Frames that are annotated alike have the same camera, and the same rows: each counts once.
    rows: dict[str, dict[str, LeftOutElement]] = {}
    terms: dict[str, LeftOutSettings] = {}
    try:
        if not set(COLUMNS) <= set(reader.fieldnames or ()):
            return {}, ""
        for row in reader:
            digest = row[CAMERA_HASH]
            terms[digest] = LeftOutSettings(
                row["protocol"], (int(row["width"]), int(row["height"])), row["field_sha256"]
            )
            of_camera = rows.setdefault(digest, {})
            if row["class"]:
                element = _element(row)
                of_camera[element.name] = element
    except (csv.Error, ValueError, TypeError) as error:
        return {}, (
            f"{LEFT_OUT_FILE}, line {reader.line_num}: {error}; its figures are left out, calibrate"
            " --held-out writes it anew"
        )
    return {
        digest: LeftOutResult(terms[digest], tuple(found.values())) for digest, found in rows.items()
    }, ""


def _element(row: Mapping[str, str]) -> LeftOutElement:
    distances = (_distance(row[key]) for key in ("held_out_px", "in_sample_px"))
    return LeftOutElement(unescape_formula(row["class"]), *distances)


def _distance(cell: str) -> float | None:
    """px; None of an empty cell.

    Raises:
        ValueError: it is no distance.
    """
    if not cell:
        return None
    value = float(cell)
    if not math.isfinite(value) or value < 0:
        raise ValueError(f"{cell[:40]!r} is no distance in px")
    return value
