"""Few clicks become a regular polyline along the painted line.

A smooth curve through the clicks is sampled finely, every sample is put on its line's centre, the
curve is fitted again to what was found, robustly, and so on. What does not lie on the final curve
(a neighbouring line, a player) and what found no line at all (hidden stretches) is left out.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import Point, Polyline, point_from_px, points_px
from procc_annotator.session.strokes.spacing import regular_parameters

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]

# (N, 2) points px, (N, 2) unit directions px -> (N, 2) px on the lines' centres, NaN: no line.
Snap = Callable[[FloatArray, FloatArray], FloatArray]

_ROUNDS = 2
_SAMPLES = 24  # along an element, to find its curve
_INLIER_PX = 1.0
_UNCHANGED_PX = 0.5  # a point that would move by less stays
_LEAST_SUPPORT = 0.3  # of the samples; with less the curve itself is in doubt
_ELLIPSE_CLICKS = 5
_CLOSED_PX = 15.0  # a circle clicked all round ends this near to its beginning


def regularise(
    polyline: Polyline,
    *,
    curved: bool,
    size: tuple[int, int],
    snap: Snap | None,
) -> Polyline:
    """Resample an element along its painted line, denser where it bends.

    Args:
        polyline: at least its two ends; a curve wants five points.
        curved: whether it is a circle or an arc; the order of a circle's points does not matter.
        size: (width, height) of the picture, px.
        snap: puts points on lines; None only resamples.

    Returns:
        Points in the direction of the clicks. The clicked ends stay, moved across the line only;
        in between are the samples that a painted line supports. With support for fewer than two
        samples, or for less than a third of them, the polyline comes back as it is; so does one
        that is regular already, lest it creeps along with every repetition.
    """
    if len(polyline.points) < 2:
        return polyline
    clicked = points_px(polyline, size)
    curve = _first_curve(clicked, curved)
    if curve is None:
        return polyline
    if snap is None:
        return _output(polyline, curve, _positions(curve, size), None, size)
    for _ in range(_ROUNDS):
        parameters = np.linspace(0.0, 1.0, _SAMPLES)
        places, directions = curve.at(parameters)
        found = snap(places, directions)
        kept = curve.fitted(parameters, found)
        if kept is None:
            return polyline
        curve = kept
    return _output(polyline, curve, _positions(curve, size), snap, size)


def _is_regular(before: FloatArray, after: FloatArray) -> bool:
    if len(before) != len(after):
        return False
    return bool(np.hypot(*(after - before).T).max() <= _UNCHANGED_PX)


def _output(
    polyline: Polyline,
    curve: _Curve,
    parameters: FloatArray,
    snap: Snap | None,
    size: tuple[int, int],
) -> Polyline:
    places, directions = curve.at(parameters)
    placed, supported = places, np.ones(len(places), dtype=bool)
    if snap is not None:
        found = snap(places, directions)
        supported = np.hypot(*(found - places).T) <= _INLIER_PX  # False where NaN
        placed = np.where(supported[:, None], found, places)
    inner = supported[1:-1]
    if snap is not None and inner.sum() < max(2.0, _LEAST_SUPPORT * len(inner)):
        return polyline
    supported[[0, -1]] = True  # the annotator has seen that it ends here
    if _is_regular(points_px(polyline, size), placed[supported]):
        return polyline
    points = [point_from_px(x, y, size) for x, y in placed[supported].tolist()]
    first, last = polyline.points[0], polyline.points[-1]
    if not curve.closed:
        points[0] = Point(points[0].u, points[0].v, first.extra)
        points[-1] = Point(points[-1].u, points[-1].v, last.extra)
    return Polyline(polyline.class_name, tuple(points))


def _positions(curve: _Curve, size: tuple[int, int]) -> FloatArray:
    """Parameters of the resulting points: regular, denser where the curve bends."""
    fine = np.linspace(0.0, 1.0, 201)
    places, directions = curve.at(fine)
    return regular_parameters(fine, places, directions, size[0])


@dataclass(frozen=True, eq=False)
class _Curve:
    """A base course and smooth offsets across it; parameters run from 0 to 1.

    Attributes:
        course: (M, 2) px, dense, evenly spaced.
        coefficients: of a polynomial (or, where closed, Fourier series) of the offsets, px.
        closed: whether the course ends where it begins.
    """

    course: FloatArray
    coefficients: FloatArray
    closed: bool

    def at(self, parameters: FloatArray) -> tuple[FloatArray, FloatArray]:
        """(n, 2) places px and (n, 2) unit directions."""
        places = self._base(parameters) + self._across(parameters) * self._offsets(parameters)
        step = 1e-3
        ahead, back = np.clip(parameters + step, 0, 1), np.clip(parameters - step, 0, 1)
        along = self._moved(ahead) - self._moved(back)
        return places, along / np.hypot(*along.T)[:, None]

    def fitted(self, parameters: FloatArray, found: FloatArray) -> _Curve | None:
        """The curve through what was found, without what does not belong; None: too little."""
        base, across = self._base(parameters), self._across(parameters)
        offsets = ((found - base) * across).sum(axis=1)
        known = ~np.isnan(offsets)
        terms = len(self.coefficients)
        if known.sum() < max(4, terms):
            return None
        basis = self._basis(parameters)
        coefficients, kept = _robust_fit(basis[known], offsets[known])
        if kept.sum() < max(4, terms - 1):
            return None
        return _Curve(self.course, coefficients, self.closed)

    def _moved(self, parameters: FloatArray) -> FloatArray:
        found: FloatArray = self._base(parameters) + self._across(parameters) * self._offsets(
            parameters
        )
        return found

    def _base(self, parameters: FloatArray) -> FloatArray:
        index = parameters * (len(self.course) - 1)
        rows = np.arange(len(self.course))
        return np.column_stack([np.interp(index, rows, self.course[:, k]) for k in (0, 1)])

    def _across(self, parameters: FloatArray) -> FloatArray:
        step = 0.5 / len(self.course)
        ahead = self._base(np.clip(parameters + step, 0, 1))
        back = self._base(np.clip(parameters - step, 0, 1))
        along = ahead - back
        along /= np.hypot(*along.T)[:, None]
        return np.column_stack([-along[:, 1], along[:, 0]])

    def _offsets(self, parameters: FloatArray) -> FloatArray:
        return (self._basis(parameters) @ self.coefficients)[:, None]

    def _basis(self, parameters: FloatArray) -> FloatArray:
        terms = len(self.coefficients)
        if not self.closed:
            return np.asarray(
                np.polynomial.legendre.legvander(2 * parameters - 1, terms - 1), dtype=np.float64
            )
        turn = 2 * math.pi * parameters
        waves = [f(k * turn) for k in range(1, terms // 2 + 1) for f in (np.cos, np.sin)]
        return np.column_stack([np.ones_like(turn), *waves])


def _first_curve(clicked: FloatArray, curved: bool) -> _Curve | None:
    """The curve through the clicks: chords, an ellipse, or a cubic."""
    if not curved:
        return _curve(_chords(clicked), 4, closed=False)
    if len(clicked) >= _ELLIPSE_CLICKS:
        arc = _elliptic_arc(clicked)
        if arc is not None:
            course, closed = arc
            return _curve(course, 7 if closed else 6, closed=closed)
    return _curve(_smooth(clicked), 5, closed=False)


def _curve(course: FloatArray, terms: int, *, closed: bool) -> _Curve | None:
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(course, axis=0).T))])
    if lengths[-1] < 4.0:
        return None
    even = np.linspace(0.0, lengths[-1], 400)
    resampled = np.column_stack([np.interp(even, lengths, course[:, k]) for k in (0, 1)])
    return _Curve(resampled, np.zeros(terms), closed)


def _chords(clicked: FloatArray) -> FloatArray:
    """A straight element's clicks, where they bend a little smoothed by a low polynomial."""
    if len(clicked) < 4:
        return clicked
    begin, along = clicked[0], clicked[-1] - clicked[0]
    length = float(np.hypot(*along))
    if length < 1e-6:
        return clicked
    along = along / length
    across = np.array([-along[1], along[0]])
    s, o = (clicked - begin) @ along, (clicked - begin) @ across
    fit = np.polynomial.Polynomial.fit(s, o, 2)
    steps = np.linspace(0.0, length, 100)
    return np.asarray(begin + steps[:, None] * along + fit(steps)[:, None] * across)


def _smooth(clicked: FloatArray) -> FloatArray:
    """A polynomial in the chord length through a short arc's clicks."""
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(clicked, axis=0).T))])
    if lengths[-1] < 1e-6:
        return clicked
    t = lengths / lengths[-1]
    basis = np.vander(t, min(len(clicked), 4))
    coefficients = np.linalg.lstsq(basis, clicked, rcond=None)[0]
    return np.asarray(np.vander(np.linspace(0, 1, 200), min(len(clicked), 4)) @ coefficients)


def _elliptic_arc(clicked: FloatArray) -> tuple[FloatArray, bool] | None:
    """The stretch of an ellipse that was clicked, and whether it is all of it.

    None where the clicks determine no sensible ellipse: a flat arc far away.
    """
    (cx, cy), axes, turn = cv2.fitEllipseDirect(clicked.astype(np.float32))
    major, minor = axes[0] / 2, axes[1] / 2
    if not all(map(math.isfinite, (cx, cy, major, minor, turn))) or min(major, minor) < 2:
        return None
    cos, sin = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    spin = np.array([[cos, sin], [-sin, cos]])  # rows: the ellipse's own axes

    def at(angles: FloatArray) -> FloatArray:
        own = np.column_stack([major * np.cos(angles), minor * np.sin(angles)])
        found: FloatArray = own @ spin + (cx, cy)
        return found

    own = (clicked - (cx, cy)) @ spin.T / (major, minor)
    angles = np.arctan2(own[:, 1], own[:, 0])
    if np.hypot(*(at(angles) - clicked).T).max() > 6.0:
        return None
    if len(clicked) > _ELLIPSE_CLICKS and np.hypot(*(clicked[0] - clicked[-1])) <= _CLOSED_PX:
        direction = 1.0 if np.unwrap(angles)[-1] > angles[0] else -1.0
        return at(angles[0] + direction * np.linspace(0, 2 * math.pi, 400)), True
    swept = np.unwrap(angles)
    steps = np.diff(swept)
    if (steps > 0).all() or (steps < 0).all():
        first, last = float(swept[0]), float(swept[-1])
    else:  # points of a circle in any order: the arc is all but the largest gap
        ordered = np.sort(angles)
        gaps = np.diff(np.append(ordered, ordered[0] + 2 * math.pi))
        start = (int(gaps.argmax()) + 1) % len(ordered)
        first = float(ordered[start])
        last = first + 2 * math.pi - float(gaps.max())
    if abs(last - first) > 2 * math.pi:
        return None
    return at(np.linspace(first, last, 400)), False


def _robust_fit(basis: FloatArray, values: FloatArray) -> tuple[FloatArray, BoolArray]:
    """Coefficients that most values agree on, and which values do (within `_INLIER_PX`).

    Iteratively reweighted least squares with Cauchy weights that get narrower; the low terms are
    fitted first, so that a stretch on a neighbouring line cannot bend the curve to itself.
    """
    terms = basis.shape[1]
    coefficients = np.zeros(terms)
    for used in sorted({min(2, terms), min(3, terms), terms}):
        part = basis[:, :used]
        start = coefficients[:used]
        residuals = values - part @ start
        scale = max(float(np.median(np.abs(residuals - np.median(residuals)))), 0.5) * 2
        for _ in range(8):
            weights = 1.0 / np.sqrt(1.0 + (residuals / scale) ** 2)
            weighted = part * weights[:, None]
            penalty = 1e-3 * np.eye(used)
            right = weighted.T @ (values * weights)
            start = np.asarray(np.linalg.solve(weighted.T @ weighted + penalty, right), np.float64)
            residuals = values - part @ start
            scale = max(scale * 0.7, 0.3)
        coefficients = np.zeros(terms)
        coefficients[:used] = start
    kept = np.abs(values - basis @ coefficients) <= _INLIER_PX
    if kept.sum() >= terms:
        fitted = np.linalg.lstsq(basis[kept], values[kept], rcond=None)[0]
        coefficients = np.asarray(fitted, dtype=np.float64)
        kept = np.abs(values - basis @ coefficients) <= _INLIER_PX
    return coefficients, kept
