"""Overlay primitives (strokes, marks, labels) and a scored frame as arrays."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Literal

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.metrics.measurement import Labelling, Measurement, nearest_points
from procc_annotator.metrics.projection import ProjectedField
from procc_annotator.metrics.score import FrameScore, px_text
from procc_annotator.translation import tr

Size = tuple[int, int]

UNSCORED = "unjudged"
_SPOT_ARM = 0.006  # of the picture's width

NO_SEGMENTS: FloatArray = np.empty((0, 4))
NO_POINTS: FloatArray = np.empty((0, 2))
NO_SEGMENTS.setflags(write=False)
NO_POINTS.setflags(write=False)


@dataclass(frozen=True, eq=False)
class ScoredProjection:
    """The criterion on projected elements; the very same one while no verdict becomes another.

    Attributes:
        by_element: element -> its visible segments, (N, 4) picture px.
        by_status: verdict -> the segments of all its elements; `UNSCORED` -> those of optional
            elements that no one annotated.
    """

    by_element: dict[str, FloatArray]
    by_status: dict[str, FloatArray]


@dataclass(frozen=True, eq=False)
class ScoredFrame:
    """The criterion on annotated points and projected elements.

    n points belong to a class that is annotated and projected. Where mirrored labels count, a class
    is judged against another element than the one of its name: `status` and `shown_as` go by the
    annotator's names, `projection` by the names of the elements themselves.

    Attributes:
        status: annotated class -> verdict.
        shown_as: class as an annotator labels it -> the projected element it is judged against.
        projection: the elements where the camera shows them.
        points: (n, 2) picture px.
        feet: (n, 2) nearest projected position, picture px; NaN if absent.
        distances: (n,) px of the evaluation size.
        passes: (n,) whether each is below the threshold.
        owners: (n,) annotated class of each point.
        tau: the threshold, px of the evaluation size.
    """

    status: Mapping[str, str]
    shown_as: dict[str, str]
    projection: ScoredProjection
    points: FloatArray
    feet: FloatArray
    distances: FloatArray
    passes: BoolArray
    owners: tuple[str, ...]
    tau: float = np.inf

    def projection_of(self, class_name: str | None) -> FloatArray:
        """The segments of the element that a class is judged against; none if it is not seen."""
        if class_name is None:
            return NO_SEGMENTS
        return self.projection.by_element.get(
            self.shown_as.get(class_name, class_name), NO_SEGMENTS
        )

    @property
    def by_criterion(self) -> bool:
        """Return whether anything is judged."""
        return self.tau < np.inf

    @cached_property
    def passing(self) -> FloatArray:
        """Points below the threshold."""
        return self.points[self.passes]

    @cached_property
    def failing(self) -> FloatArray:
        """Points at or above the threshold, or without a distance."""
        return self.points[~self.passes]

    @cached_property
    def passing_error_vectors(self) -> FloatArray:
        """From each passing point to the projection, (N, 4) picture px."""
        return self._whiskers(self.passes)

    @cached_property
    def failing_error_vectors(self) -> FloatArray:
        """From each failing point to the projection, if that has a nearest position."""
        return self._whiskers(~self.passes)

    def _whiskers(self, which: BoolArray) -> FloatArray:
        drawn = which & np.isfinite(self.feet[:, 0])
        return np.concatenate((self.points[drawn], self.feet[drawn]), axis=1)

    def labelled(self, selected: str | None) -> tuple[FloatArray, tuple[str, ...]]:
        """Positions and texts of distances: failing points, and all of the selected class."""
        rows = [
            i
            for i, (owner, passes) in enumerate(zip(self.owners, self.passes.tolist(), strict=True))
            if not passes or owner == selected
        ]
        texts = tuple([_distance_text(d, self.tau) for d in self.distances[rows].tolist()])
        return self.points[rows], texts


NO_SCORED_FRAME = ScoredFrame(
    {},
    {},
    ScoredProjection({}, {}),
    NO_POINTS,
    NO_POINTS,
    np.empty(0),
    np.empty(0, dtype=bool),
    (),
)


@lru_cache(maxsize=4)  # two sides of a split view, and what they showed before
def scored_frame(measurement: Measurement, score: FrameScore, picture_size: Size) -> ScoredFrame:
    """Turn a score of a measurement into what is painted on a picture of this (width, height),
    px."""
    elements = score.elements
    shown_as = {e.annotated_name: e.name for e in elements}
    status = {e.annotated_name: e.status for e in elements if e.status != "not_annotated"}
    verdict_of = tuple([(e.name, e.status) for e in elements])
    labels = score.labelling
    factor = _factor(measurement.setup.size, picture_size)
    hit = np.repeat(np.array(labels.projected, dtype=bool), labels.point_counts)
    owners: list[str] = []
    for name, count, seen in zip(
        labels.annotated_names, labels.point_counts, labels.projected, strict=True
    ):
        owners += [name] * (count if seen else 0)
    return ScoredFrame(
        status,
        shown_as,
        _projection(measurement.projected, measurement.setup.size, picture_size, verdict_of),
        measurement.points_px[hit] * factor,
        _closest_points(measurement, labels) * factor,
        labels.all_distances,
        labels.all_distances < score.threshold,  # NaN never passes, as in the score
        tuple(owners),
        score.threshold,
    )


@lru_cache(maxsize=4)
def unscored_projection(measurement: Measurement, picture_size: Size) -> ScoredFrame:
    """The projected elements of a frame without a score."""
    shown = measurement.projected
    status = tuple([(name, "not_annotated") for name in shown.names])
    projection = _projection(shown, measurement.setup.size, picture_size, status)
    return replace(NO_SCORED_FRAME, projection=projection)


@lru_cache(maxsize=4)
def _projection(
    projected: ProjectedField, size: Size, picture_size: Size, status: tuple[tuple[str, str], ...]
) -> ScoredProjection:
    by_element = segments_by_element(projected, size, picture_size)
    by_status: dict[str, list[FloatArray]] = {}
    for name, verdict in status:
        if name in by_element:
            by_status.setdefault(verdict, []).append(by_element[name])
    judged = {name for name, _ in status}
    for name, segments in by_element.items():
        if name not in judged:
            by_status.setdefault(UNSCORED, []).append(segments)
    return ScoredProjection(by_element, {key: joined(p) for key, p in by_status.items()})


def joined(parts: list[FloatArray]) -> FloatArray:
    """Several (N, 4) arrays of segments as one."""
    return np.concatenate(parts) if parts else NO_SEGMENTS


@lru_cache(maxsize=4)
def _closest_points(measurement: Measurement, labelling: Labelling) -> FloatArray:
    """(n, 2) px of the evaluation size; kept while only the threshold changes."""
    parts = [feet for feet in nearest_points(measurement, labelling) if feet is not None]
    return np.concatenate(parts) if parts else NO_POINTS


@lru_cache(maxsize=16)
def segments_by_element(
    projected: ProjectedField, size: Size, picture_size: Size
) -> dict[str, FloatArray]:
    """Element -> its visible pieces as segments, picture px; kept while only points move.

    A spot is a small cross.
    """
    lines = projected.polylines
    vertices = lines.vertices * _factor(size, picture_size)
    inner = ~lines.is_end[:-1]
    segments = np.concatenate((vertices[:-1], vertices[1:]), axis=1)[inner]
    rows = np.arange(lines.element_count + 1)
    bounds = np.searchsorted(lines.element[:-1][inner], rows).tolist()
    found = {}
    for row in np.flatnonzero(lines.detected).tolist():
        own = segments[bounds[row] : bounds[row + 1]]
        if (own[:, :2] == own[:, 2:]).all():
            own = _cross(vertices[np.searchsorted(lines.element, row)], picture_size)
        found[projected.names[row]] = own
    return found


def _cross(place: FloatArray, picture_size: Size) -> FloatArray:
    """(2, 4) what is drawn of a spot, which has no length."""
    arm = _SPOT_ARM * picture_size[0]
    aside, down = np.array([arm, 0.0]), np.array([0.0, arm])
    ends = [(place - way, place + way) for way in (aside, down)]
    return np.array([np.concatenate(both) for both in ends])


def _factor(size: Size, picture_size: Size) -> FloatArray:
    """Picture px per px of the evaluation size; the centres of the corner pixels coincide."""
    return np.array([(picture_size[0] - 1) / (size[0] - 1), (picture_size[1] - 1) / (size[1] - 1)])


def _distance_text(distance: float, tau: float) -> str:
    return tr("no distance") if np.isnan(distance) else px_text(distance, tau)


Box = tuple[float, float, float, float]  # left, top, right, bottom, picture px

_FEW = 60  # numbers, which are compared sooner one by one


@dataclass(frozen=True, eq=False)
class Strokes:
    """Lines of one look: (N, 4) picture px, x0 y0 x1 y1; a curve's segments follow each other."""

    segments: FloatArray
    colour: str
    width: float
    dash: tuple[float, ...] = ()
    layer: str = ""

    @cached_property
    def box(self) -> Box | None:
        """Return what the lines reach over, without their width; None where there are none."""
        return _box_of(self.segments)


@dataclass(frozen=True, eq=False)
class PointMarks:
    """Points of one look: (N, 2) picture px; shape ``dot``, ``cross``, ``ring`` or ``handle``."""

    centres: FloatArray
    shape: str
    colour: str
    size: float

    @cached_property
    def box(self) -> Box | None:
        """Return what the points reach over; None where there are none."""
        return _box_of(self.centres)


Snap = Literal["off", "none", "found", ""]
"""State of snapping for the next click: off, no line found, on a line, or not applicable."""


@dataclass(frozen=True, slots=True)
class CursorSigns:
    """Signs at the cursor: the colour of the class that is drawn, and what snapping does."""

    colour: str
    snap: Snap


@dataclass(frozen=True, slots=True)
class DraftState:
    """Progress of what is drawn: its points, how many are missing until it is whole, and what
    snapping does with the next one."""

    points: int = 0
    missing: int = 0
    snap: Snap = ""


NO_DRAFT_STATE = DraftState()


@dataclass(frozen=True, eq=False)
class Labels:
    """Texts next to points: (N, 2) picture px.

    ``sign`` is a finding's severity: its sign goes before each text (or stands alone before "");
    ``below``: on the other side of their points than texts usually are. ``hand``: what stands
    next to the text at the cursor. ``carried``: at the cursor; others need not give way.
    ``covered``: places of the view, device px, that hold no text.
    """

    positions: FloatArray
    texts: tuple[str, ...]
    colour: str
    sign: str = ""
    below: bool = False
    hand: CursorSigns | None = None
    carried: bool = False
    covered: tuple[Box, ...] = ()


@dataclass(frozen=True, eq=False)
class FilledArea:
    """A filled outline, (N, 2) picture px; ``opacity`` from 0 to 1."""

    outline: FloatArray
    colour: str
    opacity: float


@dataclass(frozen=True, eq=False)
class Overlay:
    """Overlay of a picture, painted first to last: patches, strokes, marks, labels."""

    strokes: tuple[Strokes, ...]
    marks: tuple[PointMarks, ...]
    labels: tuple[Labels, ...]
    patches: tuple[FilledArea, ...] = ()

    @cached_property
    def seen_strokes(self) -> tuple[Strokes, ...]:
        """Those that are not empty."""
        return tuple([s for s in self.strokes if s.box is not None])

    @cached_property
    def seen_marks(self) -> tuple[PointMarks, ...]:
        """Those that are not empty."""
        return tuple([m for m in self.marks if m.box is not None])


EMPTY_OVERLAY = Overlay((), (), ())


@dataclass(frozen=True)
class Draft:
    """A polyline being drawn, picture px; ``landing`` is where a click would be put by snapping."""

    class_name: str
    points: tuple[tuple[float, float], ...]
    cursor: tuple[float, float] | None = None
    landing: tuple[float, float] | None = None
    hand: DraftState = NO_DRAFT_STATE


@dataclass(frozen=True, eq=False)
class DrawnLine:
    """One polyline, picture px: points (N, 2) and segments (N - 1, 4)."""

    polyline: Polyline | None
    points: FloatArray

    @cached_property
    def segments(self) -> FloatArray:
        return np.concatenate((self.points[:-1], self.points[1:]), axis=1)


NO_LINE = DrawnLine(None, NO_POINTS)


class Drawn:
    """Polylines, picture px, by their classes; ``before`` lends those that are the very same."""

    def __init__(
        self, annotation: FrameAnnotation, picture_size: Size, before: Drawn | None = None
    ) -> None:
        self._size = picture_size
        known = before._lines if before is not None and before._size == picture_size else {}
        self._lines: dict[str, DrawnLine] = {}
        for polyline in annotation.polylines:
            if polyline.points:
                line = known.get(polyline.class_name, NO_LINE)
                if line.polyline is not polyline:
                    line = _drawn_line(polyline, picture_size)
                self._lines[polyline.class_name] = line

    @property
    def all_points(self) -> FloatArray:
        return joined_points([line.points for line in self._lines.values()])

    @property
    def all_segments(self) -> FloatArray:
        return joined([line.segments for line in self._lines.values()])

    def __contains__(self, class_name: object) -> bool:
        return class_name in self._lines

    def names(self) -> Iterable[str]:
        return self._lines

    def line(self, class_name: str | None) -> DrawnLine:
        return self._lines.get(class_name or "", NO_LINE)

    def points(self, class_name: str | None) -> FloatArray:
        return self.line(class_name).points

    def segments(self, class_name: str | None) -> FloatArray:
        return self.line(class_name).segments

    def point(self, which: tuple[str, int] | None) -> FloatArray:
        if which is None:
            return NO_POINTS
        return self.points(which[0])[which[1] : which[1] + 1]


def _drawn_line(polyline: Polyline, size: Size) -> DrawnLine:
    points = np.array([point[:2] for point in polyline.points], dtype=np.float64)
    return DrawnLine(polyline, points * (size[0] - 1, size[1] - 1))


def _box_of(places: FloatArray) -> Box | None:
    """Return what (N, 2) points or the ends of (N, 4) lines reach over; None where there are
    none."""
    if not places.size:
        return None
    if places.size <= _FEW and math.isfinite(sum(flat := places.ravel().tolist())):
        across, down = flat[::2], flat[1::2]
        return min(across), min(down), max(across), max(down)
    points = places.reshape(-1, 2)
    left, top = points.min(axis=0).tolist()
    right, bottom = points.max(axis=0).tolist()
    return left, top, right, bottom


def joined_points(parts: list[FloatArray]) -> FloatArray:
    """Arrays of points as one, (N, 2)."""
    return np.concatenate(parts) if parts else NO_POINTS
