"""Projection of field curves as fine polylines, for the ProCC protocol.

Elements are curves of a parameter t in [0, 1]. They are sampled every metre (arcs: half a metre),
cut where the camera stops seeing them, and subdivided by the sagitta of their chords in the image.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.camera.base import Camera, projects_only_ground
from procc_annotator.field.geometry import Line, Part, Spot, angles_of, parts_of
from procc_annotator.field.model import Field
from procc_annotator.metrics.polylines import Chords, ClippedPolylines, clip_chords

_COARSE_STEP_M = 1.0
_COARSE_CURVE_STEP_M = 0.5
_MIN_INTERVALS = 16

# A chord may leave its curve by this much. At 0.02 px, 4 of 1,110 frames of World Cup 2014 change
# their JaC at 2 px, at 0.005 px one, at 0.0025 px none.
_SAGITTA_PX = 0.0025
# Beyond the image by this share of the distance from it, if that is more.
_SAGITTA_OUTSIDE = 1e-4
# The sagitta falls with the square of the number of pieces, so one round nearly suffices; two more
# follow where perspective or a lens changes quickly within a chord.
_SUBDIVISION_ROUNDS = 3
_MAX_PIECES = 32

_BISECTIONS = 40


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
) -> ClippedPolylines:
    """Project every element as polylines that follow it to 0.0025 px.

    Args:
        curves: ``ElementCurves.of(field)``.
        size: (width, height) px; elements are clipped to [0, width - 1] x [0, height - 1].
        only: (E,) the elements wanted, if not all.

    Returns:
        The visible pieces of every element, and how those elements go on beyond the image as far
        as the camera has a projection, px; distances to them are never NaN.
    """
    project = _Projector(camera, curves)
    wanted = np.ones(len(field.elements), dtype=bool) if only is None else only
    if projects_only_ground(camera):
        wanted = wanted & field.on_ground
    row, t, points = curves.coarse
    if not wanted.all():
        some = wanted[curves.element[row]]
        row, t, points = row[some], t[some], points[some]
    last = np.flatnonzero(np.append(row[1:] != row[:-1], True))
    chords = _chords_between(row, t, *project.places(points), last, project)
    outside = _outside_distance(chords.px, size)
    # No curve bulges by more than its chord is long.
    in_reach = np.zeros(len(field.elements), dtype=bool)
    in_reach[curves.element[chords.rows[outside <= _lengths(chords)]]] = True
    chords = chords.select(in_reach[curves.element[chords.rows]] & (outside < sum(size)))
    done: list[Chords] = []
    for _ in range(_SUBDIVISION_ROUNDS):
        middle, seen = project(chords.rows, chords.t.mean(axis=1))
        allowed = np.maximum(_SAGITTA_PX, _SAGITTA_OUTSIDE * _outside_distance(chords.px, size))
        squares = np.where(seen, _sagittas(chords.px, middle) / allowed, np.inf)
        pieces = np.sqrt(np.clip(squares, 1.0, _MAX_PIECES**2))
        straight = pieces == 1
        done.append(chords.select(straight))
        chords = _subdivide(chords.select(~straight), np.ceil(pieces[~straight]), project)
    # What is still crooked is no curve but a jump (a pole of a distortion model): no chord there.
    return clip_chords(Chords.concatenate(done), curves.element, len(field.elements), size)


def _chords_between(
    rows: IntArray,
    t: FloatArray,
    px: FloatArray,
    seen: BoolArray,
    last: IntArray,
    project: _Projector,
) -> Chords:
    """Chords between consecutive samples, N parts with ascending parameters and px (N, 2); from a
    seen to an unseen sample, up to the last seen point. ``last``: samples from which no chord
    leads to the next one."""
    joined = seen[1:] | seen[:-1]
    joined[last[:-1]] = False
    left = np.flatnonzero(joined)
    ends = np.column_stack((left, left + 1))
    chords = Chords(rows[left], t[ends], px[ends])
    mixed = np.flatnonzero(~seen[ends].all(axis=1))
    if len(mixed):
        _bisect_to_visible(chords, mixed, seen[ends[mixed]], project)
    return chords


def _subdivide(chords: Chords, pieces: FloatArray, project: _Projector) -> Chords:
    """Divide each chord into so many pieces (K,), evenly in t."""
    counts = pieces.astype(np.intp) + 1
    which = np.repeat(np.arange(len(counts)), counts)
    last = np.cumsum(counts) - 1
    step = np.arange(len(which)) - (last - counts + 1)[which]
    start, end = chords.t[which].T
    t = start + (end - start) * (step / pieces[which])
    t[last] = chords.t[:, 1]  # neighbours of a curve share an end exactly
    rows = chords.rows[which]
    return _chords_between(rows, t, *project(rows, t), last, project)


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


def _outside_distance(px: FloatArray, size: tuple[int, int]) -> FloatArray:
    """(K,) distance from the image at which boxes around chords (K, 2, 2) begin, px; 0 within."""
    low, high = np.minimum(px[:, 0], px[:, 1]), np.maximum(px[:, 0], px[:, 1])
    gaps = np.maximum(np.maximum(-high, low - (np.array(size) - 1.0)), 0.0)
    return np.maximum(gaps[:, 0], gaps[:, 1])


def _lengths(chords: Chords) -> FloatArray:
    """(K,) px."""
    return np.asarray(np.hypot(*(chords.px[:, 1] - chords.px[:, 0]).T))


def _sagittas(px: FloatArray, middle: FloatArray) -> FloatArray:
    """(K,) distances of points (K, 2) from the segments px (K, 2, 2)."""
    along, off = px[:, 1] - px[:, 0], middle - px[:, 0]
    # Squares of what a damaged camera shows may overflow: it is merely far away.
    with np.errstate(over="ignore", invalid="ignore"):
        length2 = np.maximum((along * along).sum(axis=1), np.finfo(float).tiny)
        share = np.clip((off * along).sum(axis=1) / length2, 0.0, 1.0)
        off -= share[:, None] * along
        return np.asarray(np.hypot(off[:, 0], off[:, 1]))
