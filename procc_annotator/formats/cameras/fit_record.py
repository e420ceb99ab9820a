"""Records of files about fitted cameras: digest of the fitted annotation, leave-one-element-
out distances.
"""

from __future__ import annotations

import csv
import hashlib
import io
import json
import math
import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from statistics import fmean
from typing import Any

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.csv_tables import unescape_formula
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.metrics.camera_origin import is_made_from
from procc_annotator.metrics.measurement import Measurement, nearest_points
from procc_annotator.metrics.statistics.independence import are_dependent, independence_evidence
from procc_annotator.translation import word

# Marks of methods that are not ranked: their cameras explain the points they were fitted to.
FITTED = word("fitted on these clicks")
OTHER_VERSION = word("fitted to another version of these annotations")
SOME_OTHER_VERSION = word("fitted on these clicks, or to another version of these annotations")
TOO_CLOSE = word("closer to these clicks than a prediction can be")
# Behind a method's name in tables and charts, each explained below a table that has it.
MARKS = {"†": FITTED, "‡": OTHER_VERSION, "§": TOO_CLOSE}
FRAME_KEYS = ("fitted_on_these_clicks", "fitted_on_another_version", "independence_p")
FITTED_KEYS = ("fitted_on_these_clicks", "fitted_on_another_version", "too_close_to_clicks")
FIT_KEY = "fit"  # of a camera file: what it was fitted from
UNCERTAINTY = "uncertainty"  # among that: vector and covariance of its parameters
DIGEST = "annotation_sha256"  # among that, and the column of the table
TABLE_FILE = "calibration.csv"  # beside cameras of any format
_NEAR = 0.02  # of the picture's width: elements of the right labels are nearer
_MOST_TESTED = 4096  # frames; more find nothing else
_MARK = re.compile(rb"annotation_sha256\W{1,8}([0-9a-f]{64})")


def annotation_digest(annotation: FrameAnnotation) -> str:
    """SHA-256 of an annotation as it would be written."""
    return hashlib.sha256(write_annotation(annotation)).hexdigest()


@dataclass(frozen=True, slots=True)
class FitCounts:
    """Number of cameras that were fitted to the annotations they are judged by, or to another
    version of these, or whose residuals say so; false without any. No such method is ranked.

    A point that was moved since leaves a camera that still explains the others.

    Attributes:
        these, another: cameras with a mark. tested: cameras without, whose residuals were tested.
        evidence: of the first of these, `independence_evidence` behind what is equal for clicks
            that were copied from frame to frame, which have one error in common.
    """

    these: int = 0
    another: int = 0
    tested: int = 0
    evidence: tuple[tuple[tuple[int, ...], float], ...] = ()

    @classmethod
    def of(
        cls,
        digest: str | None,
        annotation: FrameAnnotation,
        measurement: Measurement | None = None,
    ) -> FitCounts:
        """One camera by the digest of what it was fitted to, or without one by its residuals of the
        annotation that it is judged by; without a measurement no test."""
        shown = None if measurement is None else measurement.projected.camera
        if measurement and shown and is_made_from(annotation, shown, measurement.setup.size):
            return cls(these=1)
        if digest is not None:
            same = digest == annotation_digest(annotation)
            return cls(int(same), int(not same))
        evidence = None if measurement is None else _evidence(measurement)
        return NOT_FITTED if evidence is None else cls(tested=1, evidence=(evidence,))

    def __bool__(self) -> bool:
        return self.count > 0

    def __add__(self, other: FitCounts) -> FitCounts:
        tested, evidence = self.tested + other.tested, self.evidence + other.evidence
        counts = self.these + other.these, self.another + other.another, tested
        return FitCounts(*counts, evidence[:_MOST_TESTED])

    def __sub__(self, other: FitCounts) -> FitCounts:
        evidence = (Counter(self.evidence) - Counter(other.evidence)).elements()
        counts = self.these - other.these, self.another - other.another, self.tested - other.tested
        return FitCounts(*counts, tuple(evidence))

    @property
    def too_close(self) -> int:
        """Cameras without a mark that together are no predictions of these clicks."""
        of_clicks: dict[tuple[int, ...], list[float]] = {}
        for clicks, evidence in self.evidence:
            of_clicks.setdefault(clicks, []).append(evidence)
        together = sum(map(fmean, of_clicks.values()))
        return self.tested if are_dependent(len(of_clicks), together) else 0

    @property
    def marked(self) -> int:
        """Cameras with a mark."""
        return self.these + self.another

    @property
    def count(self) -> int:
        """Of all kinds together."""
        return self.marked + self.too_close

    @property
    def mark(self) -> str:
        """Words for people; empty without any."""
        if not self.another:
            return FITTED if self.these else TOO_CLOSE if self.too_close else ""
        return SOME_OTHER_VERSION if self.these else OTHER_VERSION

    @property
    def values(self) -> tuple[int, int, int]:
        """For the columns of tables, `FITTED_KEYS`."""
        return self.these, self.another, self.too_close

    @property
    def of_frame(self) -> tuple[bool, bool, float | None]:
        """Of one camera, for the columns `FRAME_KEYS`: the marks, and p of the test."""
        p = math.exp(-self.evidence[0][1]) if self.tested else None
        return self.these > 0, self.another > 0, p

    def entry(self, *, frame: bool = False) -> dict[str, Any]:
        """For JSON: what there is, of a set or of one frame."""
        keys, values = (FRAME_KEYS, self.of_frame) if frame else (FITTED_KEYS, self.values)
        return {key: value for key, value in zip(keys, values, strict=True) if value}

    def among(self, with_camera: int) -> str:
        """The mark for a source with so many cameras."""
        partly = self and self.count != with_camera
        return f"{self.mark} in {self.count} of {with_camera} frames" if partly else self.mark


NOT_FITTED = FitCounts()


def _evidence(measurement: Measurement) -> tuple[tuple[int, ...], float] | None:
    # A fit that was turned by half explains the labels of the turned field.
    near_px = _NEAR * measurement.setup.size[0]
    labels = max(
        (measurement.plain, *measurement.mirrored), key=lambda one: one.worst.searchsorted(near_px)
    )
    counts = np.array(labels.point_counts, dtype=np.intp)
    shown = np.repeat(np.array(labels.projected, dtype=bool), counts)
    feet = [own for own in nearest_points(measurement, labels) if own is not None]
    if not feet:
        return None
    points = measurement.points_px[shown]
    evidence = independence_evidence(points, np.concatenate(feet) - points)
    middle = measurement.points_px.mean(axis=0).round().astype(int)  # px, of all clicks
    return None if evidence is None else ((len(measurement.points_px), *middle.tolist()), evidence)


def name_with_mark(name: str, fitted: FitCounts) -> str:
    """The name of a method as it stands next to others, with the signs of `MARKS`."""
    return name + "".join(sign for sign, count in zip(MARKS, fitted.values, strict=True) if count)


def with_mark(data: bytes, digest: str | None) -> bytes:
    """A camera's file that says in itself what it was fitted to: a JSON object as a key, any other
    as a last line, which readers of text, YAML and .npy pass over."""
    if digest is None or _MARK.search(data):
        return data
    if data.startswith(b"{"):
        key = json.dumps({FIT_KEY: {DIGEST: digest}})[1:-1].encode()
        return data.rstrip()[:-1].rstrip() + b",\n  " + key + b"\n}\n"
    return data + f"# {DIGEST}: {digest}\n".encode()


def folders_of(file: str) -> Iterator[str]:
    """The folders that a file of a source lies in, from its own up to the top, which is empty; the
    others end in a slash."""
    while file:
        folder = file.rpartition("/")[0]
        yield f"{folder}/" if folder else ""
        file = folder


class FitDigests:
    """Annotations that the cameras of a source were fitted to; files next to them are read once.

    Args:
        read: the content of a file of the source; None if absent.
    """

    def __init__(self, read: Callable[[str], bytes | None]) -> None:
        self._read = read
        self._table = cache(lambda folder: _table(read(folder + TABLE_FILE)))

    def of(self, frame: str, file: str, extra: Mapping[str, Any], data: bytes = b"") -> str | None:
        """The digest of the annotation that a camera was fitted to; None if nothing says so.

        Args:
            file: of the camera, in the source.
            extra: keys of the file that are not part of the camera.
            data: the file, if it is of this camera alone.
        """
        own = _digest_in(extra.get(FIT_KEY))
        if own is None and (mark := _MARK.search(data)):
            own = mark[1].decode()
        if own is not None:
            return own
        beside = file[: file.rfind("/") + 1] + frame.rpartition("/")[2]
        for folder in folders_of(file):  # of a tree it lies at the top
            table = self._table(folder)
            if table and (found := table.get(frame) or table.get(beside[len(folder) :])):
                return found
        return None


def _digest_in(found: object) -> str | None:
    digest = found.get(DIGEST) if isinstance(found, dict) else None
    return digest if isinstance(digest, str) and digest else None


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
        (unescape_formula(row["name"]), row[DIGEST])
        for row in rows
        if row.get("name") and row.get(DIGEST)
    )


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
    """Settings that distances were measured with.

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
    """Content of such tables for the cameras next to them; each is read once.

    Args:
        read: the content of a file of the source; None if absent.
    """

    def __init__(self, read: Callable[[str], bytes | None]) -> None:
        self._table = cache(lambda folder: _read_table(read(folder + LEFT_OUT_FILE)))

    def of(self, file: str, data: bytes) -> tuple[LeftOutResult | None, str]:
        """Return what is known of a camera, and a remark on a table that cannot be read.

        Args:
            file: of the camera, in the source. data: its content.
        """
        remarks = []
        for folder in folders_of(file):  # of a tree it lies at the top
            table, remark = self._table(folder)
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
            " --leave-one-out writes it anew"
        )
    return {
        digest: LeftOutResult(terms[digest], tuple(found.values()))
        for digest, found in rows.items()
    }, ""


def _element(row: Mapping[str, str]) -> LeftOutElement:
    distances = (_distance(row[key]) for key in ("held_out_px", "in_sample_px"))
    return LeftOutElement(unescape_formula(row["class"]), *distances)


def _distance(cell: str) -> float | None:
    """px; None of an empty cell."""
    if not cell:
        return None
    value = float(cell)
    if not math.isfinite(value) or value < 0:
        raise ValueError(f"{cell[:40]!r} is no distance in px")
    return value
