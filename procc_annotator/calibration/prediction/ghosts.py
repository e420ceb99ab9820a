"""Predicted elements that are not annotated yet, with standard deviations and ends."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.prediction.visible_elements import (
    VisibleStretch,
    split_at_corners,
    visible_stretches,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import distances_to
from procc_annotator.metrics.polylines import (
    Polylines,
    arc_lengths,
    points_at_arc_lengths,
    polyline_normals,
)

_JOINT_TOLERANCE_M = 0.2  # paint has a width, and some lines end at another one's edge
_JOINT_WINDOW_PX = 80.0
_BAR_WINDOW_PX = 240.0  # of one: letters and boards behind it are shorter than it
_MIN_JOINT_LENGTH_PX = 15.0


@dataclass(frozen=True, eq=False)
class ElementJoint:
    """Another element at an end of an element, and its course (n, 2), n >= 2, px, around that end,
    where the camera expects it."""

    name: str
    course_px: FloatArray


@dataclass(frozen=True, eq=False)
class ExpectedEnd:
    """An end that the field gives an element.

    Attributes:
        place_px: (2,) px, where the camera expects it.
        sd_px: its standard deviation along the element, px.
        joints: the elements that it lies at.
    """

    place_px: FloatArray
    sd_px: float
    joints: tuple[ElementJoint, ...] = ()


# An element's first and its last end; None where the picture's edge cuts it off.
ExpectedEnds = tuple[ExpectedEnd | None, ExpectedEnd | None]


def expected_ends(
    stretches: Sequence[VisibleStretch], field: Field, fit: FitResult
) -> dict[str, ExpectedEnds]:
    """The ends of straight elements in the picture of the fit's camera, by class."""
    lines = {e.name: e.geometry for e in field.elements if isinstance(e.geometry, Line)}
    straight = [s for s in stretches if s.name in lines]
    if not straight or fit.camera is None:
        return {}
    world = np.concatenate([s.points_world[[0, -1]] for s in straight])
    apart = distances_to(field.elements, world).reshape(len(straight), 2, -1)
    along = np.concatenate([_outward_directions(s.points_px) for s in straight])
    sd = fit.annotated_sd(world, along).reshape(-1, 2)
    shown: dict[str, list[FloatArray]] = {}
    for stretch in visible_stretches(field, fit.camera, fit.size):
        shown.setdefault(stretch.name, []).append(stretch.points_px)
    found: dict[str, ExpectedEnds] = {}
    for row, stretch in enumerate(straight):
        line = lines[stretch.name]
        corners = np.array([line.start, line.end])
        ends: list[ExpectedEnd | None] = []
        for k, end in enumerate((0, -1)):
            off = np.linalg.norm(corners - stretch.points_world[end], axis=1)
            if off.min() > 1e-6:
                ends.append(None)
                continue
            others = [
                field.elements[i] for i in np.flatnonzero(apart[row, k] <= _JOINT_TOLERANCE_M)
            ]
            place = stretch.points_px[end]
            joints = (
                ElementJoint(other.name, around)
                for other in others
                for course in (shown.get(other.name, ()) if other.name != stretch.name else ())
                if (around := _curve_near(course, place, on_ground=other.on_ground)) is not None
            )
            ends.append(ExpectedEnd(place, float(sd[row, k]), tuple(joints)))
        found[stretch.name] = ends[0], ends[1]
    return found


def _outward_directions(course: FloatArray) -> FloatArray:
    """(2, 2) unit vectors along a course at both of its ends."""
    steps = np.array([course[0] - course[1], course[-1] - course[-2]])
    return np.asarray(steps / np.maximum(np.hypot(*steps.T), 1e-12)[:, None])


def _curve_near(course: FloatArray, place: FloatArray, *, on_ground: bool) -> FloatArray | None:
    """Return what of a course lies around a place, every pixel; None: too little."""
    lengths = arc_lengths(course)
    nearest = lengths[np.hypot(*(course - place).T).argmin()]
    reach = _JOINT_WINDOW_PX if on_ground else _BAR_WINDOW_PX
    begin = max(0.0, nearest - reach)
    end = min(float(lengths[-1]), nearest + reach)
    if end - begin < _MIN_JOINT_LENGTH_PX:
        return None
    at = np.linspace(begin, end, round(end - begin) + 1)
    return points_at_arc_lengths(course, at, lengths)


_MAX_DISTANCE_PX = 6.0  # at 960 px width
_MIN_POINT_SHARE = 0.8  # of an element's points lie along the other one
_NEARER_RATIO = 3.0  # than to where the camera shows their own element


def classes_labelled_otherwise(
    annotation: FrameAnnotation, fit: FitResult, stretches: Iterable[VisibleStretch]
) -> frozenset[str]:
    """The classes, of those with these visible stretches, along which another element is annotated
    that does not belong there.

    Elements that really coincide in the picture are none: each lies where the camera shows it.
    """
    along_px = _MAX_DISTANCE_PX * (fit.size[0] - 1) / 959
    far_px = _NEARER_RATIO * along_px
    astray = {e.name: e.mean_px for e in fit.elements if e.left_out or e.mean_px > far_px}
    courses: dict[str, list[np.ndarray]] = {}
    for stretch in stretches:
        courses.setdefault(stretch.name, []).append(stretch.points_px)
    found = set()
    for polyline in annotation:
        if polyline.class_name not in astray or len(polyline.points) < 2:
            continue
        points = points_px(polyline, fit.size)
        for name, pieces in courses.items():
            apart = _distances_to_pieces(points, pieces)
            near = float(np.mean(apart <= along_px)) >= _MIN_POINT_SHARE
            if near and _NEARER_RATIO * float(np.median(apart)) <= astray[polyline.class_name]:
                found.add(name)
    return frozenset(found)


def _distances_to_pieces(points: np.ndarray, pieces: list[np.ndarray]) -> np.ndarray:
    """(n,) px from points to the nearest of some courses."""
    vertices = np.concatenate(pieces)
    is_end = np.zeros(len(vertices), dtype=bool)
    is_end[np.cumsum([len(piece) for piece in pieces]) - 1] = True
    lines = Polylines(vertices, np.zeros(len(vertices), dtype=np.intp), is_end, 1)
    return lines.segments.distances(points, np.zeros(len(points), dtype=np.intp))


# A ghost is offered where it is known to this, across the element, px at 960 px width.
MAX_SD_PX = 3.0
# Shorter pieces are not worth a click, px at 960 px width.
MIN_LENGTH_PX = 10.0
_SD_SPACING_PX = 12.0  # the deviation changes slowly along an element


@dataclass(frozen=True, eq=False)
class GhostPiece:
    """One visible stretch of an element.

    Attributes:
        points_px: (n, 2) px of the picture, dense, in the element's direction, n >= 2.
        sd_px: (n,) standard deviation of each across the element, px. The line is expected within
            two of them to either side, which is the band that is drawn.
    """

    points_px: FloatArray
    sd_px: FloatArray


@dataclass(frozen=True, eq=False)
class Ghost:
    """An element no one annotated, as a fitted camera shows it.

    Attributes:
        pieces: its visible stretches, along the element; one ends and another begins where a chain
            has a corner.
        ends: of a straight one, first and last; None where the picture's edge cuts it off.
    """

    name: str
    pieces: tuple[GhostPiece, ...]
    ends: ExpectedEnds = (None, None)

    @property
    def sd_px(self) -> float:
        """The largest standard deviation along it, px."""
        return max(float(piece.sd_px.max()) for piece in self.pieces)


def find_ghosts(
    annotation: FrameAnnotation,
    field: Field,
    fit: FitResult,
    *,
    without: Collection[str] = (),
    most_sd_px: float = MAX_SD_PX,
) -> tuple[Ghost, ...]:
    """The elements in sight that are not annotated, where the fit knows them well enough, in the
    field's order; classes ``without`` are not offered.

    A camera that knows only the ground has no ghosts off the ground. A line that is annotated under
    a class that does not belong there is no ghost: it would have two labels.
    """
    if fit.camera is None:
        return ()
    per_reference = (fit.size[0] - 1) / 959
    optional = {e.name for e in field.elements if e.optional}
    seen = unannotated_stretches(annotation, field, fit, optional.union(without))
    smooth = [part for stretch in seen for part in split_at_corners(stretch)]
    long_enough = [s for s in smooth if s.length_px >= MIN_LENGTH_PX * per_reference]
    pieces = stretch_deviations(long_enough, fit)
    found: dict[str, list[GhostPiece]] = {}
    for stretch, piece in zip(long_enough, pieces, strict=True):
        found.setdefault(stretch.name, []).append(piece)
    ends = expected_ends(long_enough, field, fit)
    ghosts = (
        Ghost(name, tuple(pieces), ends.get(name, (None, None))) for name, pieces in found.items()
    )
    return tuple(g for g in ghosts if g.sd_px <= most_sd_px * per_reference)


def unannotated_stretches(
    annotation: FrameAnnotation, field: Field, fit: FitResult, without: Collection[str] = ()
) -> tuple[VisibleStretch, ...]:
    """Return what the fitted camera has in sight of elements that have no points yet, neither under
    their own class nor under another one."""
    if fit.camera is None:
        return ()
    taken = {p.class_name for p in (*annotation.polylines, *annotation.unconfirmed) if p.points}
    seen = visible_stretches(field, fit.camera, fit.size, taken.union(without))
    mistaken = classes_labelled_otherwise(annotation, fit, seen)
    return tuple(stretch for stretch in seen if stretch.name not in mistaken)


def stretch_deviations(stretches: list[VisibleStretch], fit: FitResult) -> list[GhostPiece]:
    """The pieces of stretches, with deviations; one call for all of them."""
    if not stretches:
        return []
    knots = [_sd_sample_rows(s) for s in stretches]
    world = np.concatenate([s.points_world[k] for s, k in zip(stretches, knots, strict=True)])
    across = np.concatenate(
        [polyline_normals(s.points_px)[k] for s, k in zip(stretches, knots, strict=True)]
    )
    sd = fit.annotated_sd(world, across)
    ends = np.cumsum([len(k) for k in knots])[:-1]
    return [
        GhostPiece(s.points_px, np.interp(np.arange(len(s.points_px)), k, own))
        for s, k, own in zip(stretches, knots, np.split(sd, ends), strict=True)
    ]


def _sd_sample_rows(stretch: VisibleStretch) -> np.ndarray:
    count = min(len(stretch.points_px), max(3, round(stretch.length_px / _SD_SPACING_PX)))
    return np.unique(np.linspace(0, len(stretch.points_px) - 1, count).round().astype(np.intp))
