"""Adaptive projection of field curves to the accuracy the ProCC protocol needs.

Elements are curves of a parameter t in [0, 1]. They are sampled coarsely, cut where the camera
stops seeing them, then split until every chord that matters follows its curve, and clipped.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, reduce

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.camera.base import Camera, projects_only_ground
from procc_annotator.field.geometry import Line, Part, Spot, angles_of, parts_of
from procc_annotator.field.model import Field
from procc_annotator.metrics.polylines import Chords, ClippedPolylines, clip_chords

_COARSE_STEP_M = 1.0
_COARSE_CURVE_STEP_M = 0.5
_MIN_INTERVALS = 16

# Chords inside the picture may leave their curve by this much; halving moves distances by less.
_TOLERANCE_PX = 0.0025
# A chord at the border decides where the element ends, at any grazing angle, so it is nearly exact.
_BORDER_TOLERANCE_PX = 1e-5
# Beyond the picture it may leave it by this much of its distance from the picture, if that is more.
_TOLERANCE_OUTSIDE = 1e-4
# Below these lengths a chord is not split for being crooked: that is noise of the camera's numbers.
_MIN_CHORD_PX = 0.008
_BORDER_MIN_CHORD_PX = 0.005

_BISECTIONS = 40
_SUBDIVISION_ROUNDS = 14
_PROBE_SHARES = np.array([0.25, 0.5, 0.75])


@dataclass(frozen=True, eq=False)
class ElementCurves:
    """The K simple parts of all elements as curves of t in [0, 1].

    ``base + t * along + radius * (cos a * ahead + sin a * aside)`` with ``a = start + t * sweep``,
    in metres and radians, world frame; ``intervals`` is the number of coarse steps, ``element`` the
    row of the element a part belongs to, ascending.
    """

    base: FloatArray
    along: FloatArray
    ahead: FloatArray
    aside: FloatArray
    radius: FloatArray
    start: FloatArray
    sweep: FloatArray
    intervals: IntArray
    element: IntArray

    @classmethod
    def of(cls, field: Field) -> ElementCurves:
        parts = [parts_of(e.geometry) for e in field.elements]
        rows = [_curve_coefficients(part) for own in parts for part in own]
        table = np.array([r[:15] for r in rows], dtype=np.float64).reshape(-1, 15)
        intervals = np.array([r[15] for r in rows], dtype=np.intp)
        element = np.repeat(np.arange(len(parts)), [len(own) for own in parts])
        vectors = table[:, :12].reshape(-1, 4, 3).transpose(1, 0, 2)
        return cls(
            vectors[0], vectors[1], vectors[2], vectors[3],
            table[:, 12], table[:, 13], table[:, 14], intervals, element,
        )  # fmt: skip

    def at(self, rows: IntArray, t: FloatArray) -> FloatArray:
        """(N, 3) world points of parts ``rows`` (N,) at parameters ``t`` (N,)."""
        points = self.base.take(rows, axis=0)
        points += t[:, None] * self.along.take(rows, axis=0)
        round_ = np.flatnonzero(self.radius.take(rows))
        if len(round_):  # most parts are straight, and angles take longest
            own = rows[round_]
            radius = self.radius.take(own)
            angle = self.start.take(own) + t[round_] * self.sweep.take(own)
            bent = points[round_]
            bent += (radius * np.cos(angle))[:, None] * self.ahead.take(own, axis=0)
            bent += (radius * np.sin(angle))[:, None] * self.aside.take(own, axis=0)
            points[round_] = bent
        return points

    @cached_property
    def coarse(self) -> tuple[IntArray, FloatArray, FloatArray]:
        """The coarse samples of all parts, whatever the camera: part (N,), t (N,), world (N, 3)."""
        samples = self.intervals + 1
        row = np.repeat(np.arange(len(samples)), samples)
        step = np.arange(len(row)) - np.repeat(np.cumsum(samples) - samples, samples)
        t = step / self.intervals[row]
        return row, t, self.at(row, t)


def _curve_coefficients(part: Part) -> tuple[float, ...]:
    nowhere = (0.0, 0.0, 0.0)
    if isinstance(part, Spot):
        return (*part.position, *nowhere, *nowhere, *nowhere, 0.0, 0.0, 0.0, 1)
    if isinstance(part, Line):
        length = math.dist(part.start, part.end)
        along = tuple(b - a for a, b in zip(part.start, part.end, strict=True))
        steps = max(_MIN_INTERVALS, math.ceil(length / _COARSE_STEP_M))
        return (*part.start, *along, *nowhere, *nowhere, 0.0, 0.0, 0.0, steps)
    first, last = angles_of(part)
    sweep = last - first
    steps = max(_MIN_INTERVALS, math.ceil(sweep * part.radius / _COARSE_CURVE_STEP_M))
    round_ = (*part.ahead, *part.aside, part.radius, first, sweep)
    return (*part.centre, *nowhere, *round_, steps)


class _Projector:
    """Projects curve parameters; a pixel that is not finite counts as not seen."""

    def __init__(self, camera: Camera, curves: ElementCurves) -> None:
        self._camera = camera
        self._curves = curves

    def __call__(self, rows: IntArray, t: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Pixels (N, 2) and visibility (N,) of parts ``rows`` (N,) at parameters ``t`` (N,)."""
        return self.places(self._curves.at(rows, t))

    def places(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Pixels (N, 2) and visibility (N,) of places (N, 3)."""
        px, seen = self._camera.project(points_world)
        finite = np.isfinite(px)
        seen = seen & finite[:, 0] & finite[:, 1]
        return (px if seen.all() else np.where(seen[:, None], px, 0.0)), seen


def project_curves(
    camera: Camera,
    field: Field,
    curves: ElementCurves,
    size: tuple[int, int],
    *,
    only: BoolArray | None = None,
    halvings: int = 0,
) -> ClippedPolylines:
    """Project every element so finely that a finer sampling changes nothing.

    Args:
        camera: any model.
        field: the sports field.
        curves: ``Curves.of(field)``.
        size: (width, height) px; elements are clipped to [0, width - 1] x [0, height - 1].
        only: (E,) the elements wanted, if not all.
        halvings: how often to halve the spacing in the end (to check that it changes nothing).

    Returns:
        The visible pieces of every element, and how those elements go on beyond the picture as far
        as the camera has a projection, px; distances to them are never NaN.
    """
    project = _Projector(camera, curves)
    wanted = np.ones(len(field.elements), dtype=bool) if only is None else only
    if projects_only_ground(camera):
        wanted = wanted & field.on_ground
    active = _coarse_chords(curves, wanted[curves.element], project)
    in_reach = np.zeros(len(field.elements), dtype=bool)
    in_reach[curves.element[active.rows[_near_image(active, size)]]] = True
    active = active.select(in_reach[curves.element[active.rows]])
    done: list[Chords] = []
    for _ in range(_SUBDIVISION_ROUNDS):
        active = active.select(_outside_distance(active, size) < sum(size))
        if not len(active.rows):
            break
        good, active = _split_curved_chords(active, project, size)
        done.append(good)
    # What is still crooked is no curve but a jump (a pole of a distortion model): no chord there.
    chords = Chords.concatenate(done)
    for _ in range(halvings):
        chords = _chords_between(
            chords.rows, *_probe_chords(chords, np.array([0.5]), project), project
        )
    return clip_chords(chords, curves.element, len(field.elements), size)


def _coarse_chords(curves: ElementCurves, wanted: BoolArray, project: _Projector) -> Chords:
    """Chords between the coarse samples of parts; wanted: (K,)."""
    row, t, points = curves.coarse
    if not wanted.all():
        some = wanted[row]
        row, t, points = row[some], t[some], points[some]
    px, seen = project.places(points)
    left = np.flatnonzero(row[1:] == row[:-1])
    ends = np.column_stack((left, left + 1))
    return _chords_between(row[left], t[ends], px[ends], seen[ends], project)


def _chords_between(
    rows: IntArray, t: FloatArray, px: FloatArray, seen: BoolArray, project: _Projector
) -> Chords:
    """Chords between neighbouring samples; from a seen to an unseen one, up to the last seen point.

    Args:
        rows: (K,) part. t: (K, n) ascending parameters. px: (K, n, 2). seen: (K, n).
    """
    rows = np.repeat(rows, t.shape[1] - 1)
    t = np.stack((t[:, :-1], t[:, 1:]), axis=-1).reshape(-1, 2)
    px = np.stack((px[:, :-1], px[:, 1:]), axis=2).reshape(-1, 2, 2)
    seen = np.stack((seen[:, :-1], seen[:, 1:]), axis=-1).reshape(-1, 2)
    some = seen.any(axis=1)
    chords = Chords(rows[some], t[some], px[some])
    mixed = np.flatnonzero(~seen[some].all(axis=1))
    if len(mixed):
        _bisect_to_visible(chords, mixed, seen[some][mixed], project)
    return chords


def _bisect_to_visible(
    chords: Chords, which: IntArray, seen: BoolArray, project: _Projector
) -> None:
    """Move the unseen end of chords ``which`` to the last seen point, by bisecting the 3D curve."""
    rows = chords.rows[which]
    lost = np.where(seen[:, 0], 1, 0)
    good, bad = chords.t[which, 1 - lost], chords.t[which, lost]
    px = chords.px[which, 1 - lost]
    for _ in range(_BISECTIONS):
        middle = 0.5 * (good + bad)
        middle_px, hit = project(rows, middle)
        good, bad = np.where(hit, middle, good), np.where(hit, bad, middle)
        px = np.where(hit[:, None], middle_px, px)
    chords.t[which, lost] = good
    chords.px[which, lost] = px


def _near_image(chords: Chords, size: tuple[int, int]) -> BoolArray:
    """Return whether a chord comes near enough for its curve to bulge into the picture."""
    low, high = _bounds(chords.px)
    return _box_meets_image(low, high, np.hypot(*(high - low).T), size)


def _outside_distance(chords: Chords, size: tuple[int, int]) -> FloatArray:
    return _box_outside_distance(*_bounds(chords.px), size)


def _box_outside_distance(low: FloatArray, high: FloatArray, size: tuple[int, int]) -> FloatArray:
    """(K,) how far outside the picture boxes low..high (K, 2) begin, px; 0 within."""
    gaps = np.maximum(np.maximum(-high, low - (np.array(size) - 1.0)), 0.0)
    return np.maximum(gaps[:, 0], gaps[:, 1])


def _bounds(px: FloatArray) -> tuple[FloatArray, FloatArray]:
    """(K, 2) least and largest coordinates of (K, n, 2); reducing a short axis is slow in numpy."""
    columns = [px[:, i] for i in range(px.shape[1])]
    return reduce(np.minimum, columns), reduce(np.maximum, columns)


def _box_meets_image(
    low: FloatArray, high: FloatArray, margin: FloatArray, size: tuple[int, int]
) -> BoolArray:
    """(K,) whether boxes low..high (K, 2), grown by margin (K,), meet the picture."""
    touching: BoolArray = (
        (high[:, 0] >= -margin)
        & (high[:, 1] >= -margin)
        & (low[:, 0] <= size[0] - 1 + margin)
        & (low[:, 1] <= size[1] - 1 + margin)
    )
    return touching


def _split_curved_chords(
    chords: Chords, project: _Projector, size: tuple[int, int]
) -> tuple[Chords, Chords]:
    """Chords that follow their curve well enough, and the quarters of those that do not."""
    t, px, seen = _probe_chords(chords, _PROBE_SHARES, project)
    deviation = np.where(seen.all(axis=1), _chord_deviation(px), np.inf)
    low, high = _bounds(px)
    touching = _box_meets_image(low, high, deviation, size)
    within = ~_box_meets_border(low, high, deviation, size)
    at_border = touching & ~within
    allowed = np.maximum(_TOLERANCE_PX, _TOLERANCE_OUTSIDE * _box_outside_distance(low, high, size))
    allowed[at_border] = _BORDER_TOLERANCE_PX
    length = np.hypot(*(px[:, -1] - px[:, 0]).T)
    # Not for an infinite deviation: a chord with an unseen point is no matter of noise.
    tiny = np.maximum(length, deviation) < np.where(at_border, _BORDER_MIN_CHORD_PX, _MIN_CHORD_PX)
    good = (deviation <= allowed) | tiny
    split = ~good
    quarters = _chords_between(chords.rows[split], t[split], px[split], seen[split], project)
    return chords.select(good), quarters


def _probe_chords(
    chords: Chords, fractions: FloatArray, project: _Projector
) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Both ends and n points between: t (K, n + 2), pixels (K, n + 2, 2), visibility."""
    count = len(fractions)
    first, last = chords.t[:, :1], chords.t[:, 1:]
    inner_t = first + (last - first) * fractions
    inner_px, inner_seen = project(np.repeat(chords.rows, count), inner_t.ravel())
    t = np.concatenate((first, inner_t, last), axis=1)
    px = np.concatenate(
        (chords.px[:, :1], inner_px.reshape(-1, count, 2), chords.px[:, 1:]), axis=1
    )
    seen = np.ones(t.shape, dtype=bool)
    seen[:, 1:-1] = inner_seen.reshape(-1, count)
    return t, px, seen


def _box_meets_border(
    low: FloatArray, high: FloatArray, margin: FloatArray, size: tuple[int, int]
) -> BoolArray:
    """(K,) whether grown boxes that meet the picture reach its border or beyond."""
    beyond: BoolArray = (
        (low[:, 0] <= margin)
        | (low[:, 1] <= margin)
        | (high[:, 0] >= size[0] - 1 - margin)
        | (high[:, 1] >= size[1] - 1 - margin)
    )
    return beyond


def _chord_deviation(px: FloatArray) -> FloatArray:
    """(K,) largest distance of the points between from the segment of the ends; px (K, n, 2)."""
    start_x, start_y = px[:, :1, 0], px[:, :1, 1]
    along_x, along_y = px[:, -1:, 0] - start_x, px[:, -1:, 1] - start_y
    off_x, off_y = px[:, 1:-1, 0] - start_x, px[:, 1:-1, 1] - start_y
    # Squares of what a damaged camera shows may overflow: it is merely far away.
    with np.errstate(over="ignore", invalid="ignore"):
        length2 = np.maximum(along_x * along_x + along_y * along_y, np.finfo(float).tiny)
        k = np.clip((off_x * along_x + off_y * along_y) / length2, 0.0, 1.0)
        off_x -= k * along_x
        off_y -= k * along_y
        squares = off_x * off_x + off_y * off_y
        return np.asarray(np.sqrt(reduce(np.maximum, squares.T)))
