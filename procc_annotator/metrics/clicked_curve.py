"""Reconstruct the curve of an annotated element from its clicks, without a camera.

The course passes through every click, so an annotation has no distance to itself. Straight elements
run from click to click. Between the clicks of a curve a chord would cut the bend: there the course
follows an ellipse fitted to the clicks, moved across so that it meets each of them. Clicks that lie
around no one ellipse, and curves of fewer than five clicks, get a smooth spline in clicked order.
A chain runs in clicked order, too: from click to click if all its parts are straight, else as a
spline. A spot is where it was clicked.

No one clicks the same extent twice. A course therefore reaches a little beyond its first and last
click (`REACH` of its length, at least `MIN_EXTENSION_PX`); a point past that has no distance.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.field.geometry import Chain, Circle, Line, Spot
from procc_annotator.field.model import Element

# Beyond the clicks a course is a guess whose error grows with the distance from them: at 5 % of
# the length it is a fifth above the error between them, and clicks a few pixels further still meet.
EXTENSION_SHARE = 0.05
MIN_EXTENSION_PX = 3.0

# The direction in which a line goes on is taken over a part of it: over the last clicks alone it
# would be as uncertain as they are close, over the whole of it a bent line would go on next to.
_DIRECTION_SHARE = 0.25
_DIRECTION_PX = 20.0

# A conic has five unknowns.
_ELLIPSE_POINTS = 5
_CHAIN_CLICKS = 4  # a chain of so few clicks is coarse, as other curves are
# How far off the ellipse, as a share of its radius there, clicks may lie that belong to it.
_MAX_ELLIPSE_DEVIATION = 0.25
# An ellipse this many times as long as wide, or as large as its clicks' extent, is as good as a
# line, and its angles are rounding errors.
_MAX_AXIS_RATIO = 1000.0
_MAX_AXIS_PX = 1000.0
# A circle whose clicks leave no larger gap than this is known all round.
_CLOSED_GAP = np.deg2rad(120.0)

# Chords this fine stand for a curve: they pass it by no more than this, or there are this many.
_SAGITTA_PX = 0.02
_MAX_CHORDS = 720
_CHORDS_PER_SPAN = 32


@dataclass(frozen=True, eq=False)
class ClickedCurve:
    """One element's course in the picture.

    Attributes:
        vertices: (M, 2) px, reach included; a closed course ends at its first vertex; a single
            vertex where all clicks lie in one place.
        coarse: whether it is a curve of so few clicks that it may pass the element by many pixels
            between them.
        ellipse, angles: what an open course around an ellipse goes along, and the first and the
            last angle of it: a point in the gap may be nearer to the far side than to an end.
    """

    vertices: FloatArray
    closed: bool = False
    coarse: bool = False
    ellipse: Ellipse | None = None
    angles: tuple[float, float] = (0.0, 2 * np.pi)

    @property
    def is_point(self) -> bool:
        """Return whether there is no course, only a place."""
        return len(self.vertices) == 1

    @property
    def rank(self) -> int:
        """Return how much it says: a place (0), a coarse course (1), a course (2)."""
        if self.is_point:
            return 0
        return 1 if self.coarse else 2

    def distances(self, points_px: FloatArray) -> FloatArray:
        """Distance (n,), px, of each point (n, 2), px, to the course; NaN for a point beyond an
        end: the nearest position on the course is the end itself, or the point lies in the gap of
        an ellipse. Of a course that is a point, the distances to it."""
        if self.is_point:
            off = points_px - self.vertices[0]
            return np.asarray(np.hypot(off[:, 0], off[:, 1]), dtype=np.float64)
        start = self.vertices[:-1]
        along = self.vertices[1:] - start
        length2 = (along * along).sum(axis=1)
        off = points_px[:, None, :] - start
        foot = (off * along).sum(axis=2) / length2
        off -= np.clip(foot, 0.0, 1.0)[:, :, None] * along
        distance2 = (off * off).sum(axis=2)
        nearest = distance2.argmin(axis=1)
        rows = np.arange(len(points_px))
        distances: FloatArray = np.sqrt(distance2[rows, nearest])
        if not self.closed:
            at = foot[rows, nearest]
            beyond = ((nearest == 0) & (at < 0.0)) | ((nearest == len(start) - 1) & (at > 1.0))
            distances[beyond | self._in_gap(points_px)] = np.nan
        return distances

    def _in_gap(self, points_px: FloatArray) -> BoolArray:
        if self.ellipse is None:
            return np.zeros(len(points_px), dtype=bool)
        first, last = self.angles
        after_first = (self.ellipse.polar(points_px)[0] - first) % (2 * np.pi)
        return np.asarray(after_first > last - first)


def clicked_curve(points_px: FloatArray, element: Element) -> ClickedCurve:
    """The course of an element through the points (n, 2), px, at least one, clicked on it in this
    order, which only a spline needs."""
    shape = element.geometry
    if isinstance(shape, Spot):
        return ClickedCurve(points_px.mean(axis=0, keepdims=True))
    if isinstance(shape, Line):
        return _polyline_curve(_order_clicks(points_px))
    if isinstance(shape, Chain):
        bent = not all(isinstance(part, Line) for part in shape.parts)
        course = _catmull_rom(points_px) if bent else _polyline_curve(points_px)
        # Anyone who leaves corners out goes far next to them.
        return replace(course, coarse=len(points_px) <= max(len(shape.parts), _CHAIN_CLICKS))
    if len(points_px) < _ELLIPSE_POINTS:
        return replace(_catmull_rom(points_px), coarse=True)
    around = _ellipse_curve(points_px, is_circle=isinstance(shape, Circle))
    return _catmull_rom(points_px) if around is None else around


# ------------------------------------------------------------------------------------- straight


def _order_clicks(points: FloatArray) -> FloatArray:
    """The clicks in their order along the line, whatever order they were clicked in."""
    if len(points) <= 2:
        return points
    one = points[_farthest_point(points, points[0])]
    other = points[_farthest_point(points, one)]
    return np.asarray(points[((points - one) @ (other - one)).argsort(kind="stable")])


def _polyline_curve(points: FloatArray) -> ClickedCurve:
    """From click to click in this order."""
    points = _distinct_consecutive(points)
    if len(points) < 2:
        return ClickedCurve(points)
    steps = np.hypot(*np.diff(points, axis=0).T)
    at = np.concatenate(((0.0,), steps.cumsum()))
    back = min(at[-1], max(_DIRECTION_SHARE * at[-1], _DIRECTION_PX))
    reach = _extension_length(at[-1])
    first = _extrapolate(points[0], _point_at_length(points, at, back), reach)
    last = _extrapolate(points[-1], _point_at_length(points, at, at[-1] - back), reach)
    return ClickedCurve(np.vstack((first, points, last)))


def _farthest_point(points: FloatArray, place: FloatArray) -> int:
    off = points - place
    return int((off * off).sum(axis=1).argmax())


def _point_at_length(points: FloatArray, at: FloatArray, position: float) -> FloatArray:
    return np.array([np.interp(position, at, points[:, axis]) for axis in (0, 1)])


def _extrapolate(end: FloatArray, inner: FloatArray, reach: float) -> FloatArray:
    """The place ``reach`` px beyond an end, seen from a place within."""
    direction = end - inner
    length = np.hypot(*direction)
    # A polyline that folds back on itself may meet its own end; it goes nowhere from there.
    away = direction * (reach / length) if length else np.array((reach, 0.0))
    return np.asarray(end + away, dtype=np.float64)


def _extension_length(length: float) -> float:
    return max(EXTENSION_SHARE * length, MIN_EXTENSION_PX)


def _distinct_consecutive(points: FloatArray) -> FloatArray:
    kept = np.ones(len(points), dtype=bool)
    kept[1:] = (points[1:] != points[:-1]).any(axis=1)
    return points[kept]


# -------------------------------------------------------------------------------------- ellipses


@dataclass(frozen=True, eq=False)
class Ellipse:
    """The unit circle, moved: ``centre + axes @ (cos, sin)``, centre (2,) px, axes (2, 2) px, two
    conjugate half diameters as columns."""

    centre: FloatArray
    axes: FloatArray

    @classmethod
    def fit(cls, points: FloatArray) -> Self | None:
        """The ellipse nearest to points (n, 2), n >= 5, px, in the algebraic sense (Halir and
        Flusser 1998); None where they determine none: they lie on a line, or as good as that."""
        middle = points.mean(axis=0)
        scale = np.abs(points - middle).max()
        if not scale:
            return None
        x, y = (points - middle).T / scale
        squares = np.column_stack((x * x, x * y, y * y))
        linear = np.column_stack((x, y, np.ones_like(x)))
        try:
            rest = -np.linalg.solve(linear.T @ linear, linear.T @ squares)
            reduced = squares.T @ (squares + linear @ rest)
            vectors = np.linalg.eig(np.stack((reduced[2] / 2, -reduced[1], reduced[0] / 2)))[1].real
            kind = 4 * vectors[0] * vectors[2] - vectors[1] ** 2
            a, b, c = conic = vectors[:, int(kind.argmax())]
            d, e, f = rest @ conic
            shape = np.array(((a, b / 2), (b / 2, c)))
            centre = -np.linalg.solve(shape, np.array((d, e))) / 2
            at_centre = f + (d * centre[0] + e * centre[1]) / 2
            if not at_centre:  # a pair of lines
                return None
            half = np.linalg.cholesky(shape / -at_centre)
            axes = np.linalg.inv(half.T)
        except np.linalg.LinAlgError:
            return None
        if not (np.linalg.cond(axes) < _MAX_AXIS_RATIO and np.linalg.norm(axes) < _MAX_AXIS_PX):
            return None
        return cls(middle + scale * centre, scale * axes)

    def polar(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Angles (-pi to pi) and radii (1 on the ellipse) of (n, 2) points, px."""
        x, y = np.linalg.solve(self.axes, (points - self.centre).T)
        return np.arctan2(y, x), np.hypot(x, y)

    def places(self, angles: FloatArray, radii: FloatArray) -> FloatArray:
        """The inverse of `polar`: (n, 2) px."""
        directions = np.column_stack((np.cos(angles), np.sin(angles)))
        return np.asarray(self.centre + radii[:, None] * (directions @ self.axes.T))

    def speeds(self, angles: FloatArray) -> FloatArray:
        """Length of ellipse a radian of the angle stands for, px, at (n,) angles."""
        along = self.axes @ np.stack((-np.sin(angles), np.cos(angles)))
        return np.asarray(np.hypot(along[0], along[1]))


def _ellipse_curve(points: FloatArray, *, is_circle: bool) -> ClickedCurve | None:
    """Along the ellipse of the clicks and through each of them, in their order around it.

    Between two clicks the radius goes evenly from that of one to that of the other.
    """
    ellipse = Ellipse.fit(points)
    if ellipse is None:
        return None
    angles, radii = ellipse.polar(points)
    if not np.abs(radii - 1.0).max() < _MAX_ELLIPSE_DEVIATION:
        return None
    order = angles.argsort(kind="stable")
    angles, radii = angles[order], radii[order]
    gaps = np.diff(angles, append=angles[0] + 2 * np.pi)
    begin = int(gaps.argmax()) + 1  # after the widest gap
    angles = np.concatenate((angles[begin:], angles[:begin] + 2 * np.pi))
    radii = np.roll(radii, -begin)
    gap = float(gaps.max())
    closed = is_circle and gap <= _CLOSED_GAP
    if closed:
        angles, radii = np.append(angles, angles[0] + 2 * np.pi), np.append(radii, radii[0])
    between = _ellipse_angles(angles[0], angles[-1], ellipse)[1:-1]
    at = np.concatenate((between, angles))
    order = at.argsort(kind="stable")
    at = at[order]
    # Clicks at one angle keep their own radii: interpolating would leave all but one of them out.
    out = np.concatenate((np.interp(between, angles, radii), radii))[order]
    vertices = ellipse.places(at, out)
    if not closed:
        length = float(np.hypot(*np.diff(vertices, axis=0).T).sum())
        before, after = np.minimum(_extension_length(length) / ellipse.speeds(at[[0, -1]]), gap / 2)
        first = _ellipse_angles(at[0] - before, at[0], ellipse)[:-1]
        last = _ellipse_angles(at[-1], at[-1] + after, ellipse)[1:]
        out = np.concatenate((np.full(len(first), radii[0]), out, np.full(len(last), radii[-1])))
        at = np.concatenate((first, at, last))
        vertices = _distinct_consecutive(ellipse.places(at, out))
        return ClickedCurve(vertices, ellipse=ellipse, angles=(float(at[0]), float(at[-1])))
    return ClickedCurve(_distinct_consecutive(vertices), closed=True)


def _ellipse_angles(first: float, last: float, ellipse: Ellipse) -> FloatArray:
    largest = np.linalg.norm(ellipse.axes)  # no less than the longest half axis
    chords = np.ceil((last - first) / np.sqrt(8 * _SAGITTA_PX / largest))
    return np.linspace(first, last, int(np.clip(chords, 1, _MAX_CHORDS)) + 1)


# --------------------------------------------------------------------------------------- splines


def _catmull_rom(points: FloatArray) -> ClickedCurve:
    """A centripetal Catmull-Rom spline; at its ends it goes on as the parabola of three clicks."""
    points = _distinct_consecutive(points)
    if len(points) < 3:
        return _polyline_curve(points)
    steps = np.diff(points, axis=0)
    spans = np.sqrt(np.hypot(*steps.T))[:, None]
    slopes = steps / spans
    inner = (spans[1:] * slopes[:-1] + spans[:-1] * slopes[1:]) / (spans[1:] + spans[:-1])
    tangents = np.vstack((2 * slopes[0] - inner[0], inner, 2 * slopes[-1] - inner[-1]))
    count = len(steps)
    at = np.arange(count * _CHORDS_PER_SPAN + 1) / _CHORDS_PER_SPAN
    vertices = _hermite(points, tangents, spans, at)
    reach = _extension_length(float(np.hypot(*np.diff(vertices, axis=0).T).sum()))
    first, last = (
        min(reach / max(float(np.hypot(*tangents[end]) * spans[end, 0]), reach), 0.5)
        for end in (0, -1)
    )
    thirds = np.array((1.0, 2.0, 3.0)) / 3
    at = np.concatenate((-first * thirds[::-1], at, count + last * thirds))
    return ClickedCurve(_distinct_consecutive(_hermite(points, tangents, spans, at)))


def _hermite(
    points: FloatArray, tangents: FloatArray, spans: FloatArray, at: FloatArray
) -> FloatArray:
    """The cubic pieces at positions counted in clicks; the outer ones go on beyond the ends."""
    piece = np.clip(at.astype(np.intp), 0, len(spans) - 1)
    t = (at - piece)[:, None]
    span = spans[piece]
    return np.asarray(
        (1 + 2 * t) * (1 - t) ** 2 * points[piece]
        + t * (1 - t) ** 2 * span * tangents[piece]
        + t**2 * (3 - 2 * t) * points[piece + 1]
        + t**2 * (t - 1) * span * tangents[piece + 1],
        dtype=np.float64,
    )
