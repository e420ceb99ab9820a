"""Curves through clicked points with smooth line offsets; regular point spacing."""

from __future__ import annotations

import math
from dataclasses import dataclass

import cv2
import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.metrics.polylines import arc_lengths, points_at_arc_lengths

_SAGITTA_PX = 0.5  # how far chords may cut a bend
_LARGEST_SPACING = 1 / 16  # of the picture's width
_SMALLEST_SPACING = 1 / 80  # 24 px of 1920
_STEADY = 9  # so many steps tell how much a curve bends


def regular_parameters(
    parameters: FloatArray,
    places_px: FloatArray,
    directions: FloatArray,
    width_px: int,
    *,
    least: int = 3,
) -> FloatArray:
    """Return where along a curve the points of a regular polyline belong.

    Args:
        parameters: (n,) ascending, of the places.
        places_px: (n, 2) dense places along the curve, n >= 2.
        directions: (n, 2) of the curve there.
        width_px: of the picture.
        least: chords at least.

    Returns:
        (m,) parameters, m > ``least``, the first and the last of the given ones among them.
    """
    steps = np.hypot(*np.diff(places_px, axis=0).T)
    turns = np.abs(np.diff(np.unwrap(np.arctan2(directions[:, 1], directions[:, 0]))))
    # A chord of length c cuts a bend of radius r by c * c / (8 r).
    around = min(_STEADY, len(turns))
    bend = np.convolve(turns / np.maximum(steps, 1e-9), np.ones(around) / around, mode="same")
    spacing = np.sqrt(8 * _SAGITTA_PX / np.maximum(bend, 1e-9))
    spacing = np.clip(spacing, _SMALLEST_SPACING * width_px, _LARGEST_SPACING * width_px)
    count = np.concatenate([[0.0], np.cumsum(steps / spacing)])
    wanted = max(least, math.ceil(count[-1]))
    return np.asarray(np.interp(np.linspace(0.0, count[-1], wanted + 1), count, parameters))


EVERYWHERE = 201  # so many parameters stand for the whole curve
_INLIER_PX = 1.0
_ELLIPSE_CLICKS = 5  # a conic has five degrees of freedom
_ELLIPSE_PX = 6.0  # how far it may pass from a click
_CLICKS_PX = 3.0  # ... and an ellipse through paint, from the middle one of them
_FEWEST_PAINT, _DRAWS = 8, 80
_CLOSED_PX = 15.0  # a circle clicked all round ends this near to its beginning


@dataclass(frozen=True, eq=False)
class Curve:
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

    @property
    def turns_back(self) -> bool:
        """Return whether it comes back on itself somewhere, so that it has no direction there."""
        with np.errstate(invalid="ignore"):
            return not np.isfinite(self.at(np.linspace(0.0, 1.0, EVERYWHERE))[1]).all()

    def fitted(self, parameters: FloatArray, found: FloatArray) -> Curve | None:
        """The curve through what was found, without what does not belong; None: too little."""
        base, across = self._base(parameters), self._across(parameters)
        offsets = ((found - base) * across).sum(axis=1)
        known = ~np.isnan(offsets)
        terms = len(self.coefficients)
        if known.sum() < max(4, terms):
            return None
        basis = self._basis(parameters)
        coefficients, kept = robust_fit(basis[known], offsets[known])
        if kept.sum() < max(4, terms - 1):
            return None
        return Curve(self.course, coefficients, self.closed)

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


def curve_through(clicked: FloatArray, curved: bool, bar: bool = False) -> Curve | None:
    """The curve through clicks (n, 2), px, n >= 2: chords, an ellipse, or what passes smoothly
    through them all; None for clicks in one place.

    Args:
        curved: whether the element is a circle or an arc; of a circle's points the order does not
            matter.
        bar: whether it is a bar, which bends no more than the lens bends it.
    """
    if not curved:
        return _curve(_chords(clicked), 3 if bar else 4, closed=False)
    if len(clicked) >= _ELLIPSE_CLICKS:
        arc = _elliptic_arc(clicked)
        if arc is not None:
            course, closed = arc
            return _curve(course, 7 if closed else 6, closed=closed)
    return _curve(_through(clicked), 5, closed=False)


def _curve(course: FloatArray, terms: int, *, closed: bool) -> Curve | None:
    lengths = arc_lengths(course)
    if lengths[-1] < 4.0:
        return None
    even = np.linspace(0.0, lengths[-1], 400)
    resampled = points_at_arc_lengths(course, even, lengths)
    return Curve(resampled, np.zeros(terms), closed)


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


def _through(clicked: FloatArray) -> FloatArray:
    """A smooth curve through every click of an arc that is no ellipse (Catmull and Rom's)."""
    lengths = arc_lengths(clicked)
    kept = np.r_[True, np.diff(lengths) > 1e-6]
    clicked, lengths = clicked[kept], lengths[kept]
    if len(clicked) < 3:
        return clicked
    steps = np.gradient(clicked, lengths, axis=0)
    pieces = [
        hermite_curve(clicked[i], clicked[i + 1], length * steps[i], length * steps[i + 1], 60)
        for i, length in enumerate(np.diff(lengths))
    ]
    return np.concatenate(pieces)


def hermite_curve(
    begin: FloatArray, end: FloatArray, leaving: FloatArray, arriving: FloatArray, count: int
) -> FloatArray:
    """(count, 2) a cubic between two places with these derivatives at its ends."""
    t = np.linspace(0.0, 1.0, count)[:, None]
    bent = (2 * t**3 - 3 * t**2 + 1) * begin + (3 * t**2 - 2 * t**3) * end
    return np.asarray(bent + (t**3 - 2 * t**2 + t) * leaving + (t**3 - t**2) * arriving)


def refitted(curve: Curve, clicked: FloatArray, found: FloatArray) -> Curve:
    """A curved element's curve drawn anew through its paint: a circle is seen as an ellipse. The
    same curve where no ellipse passes most of what was found, and the clicks.

    Args:
        clicked: (n, 2) px; they say how far the arc goes.
        found: (m, 2) px on what may be its paint; NaN where there was none.
    """
    paint = found[~np.isnan(found[:, 0])]
    if len(paint) < _FEWEST_PAINT:
        return curve
    rng = np.random.default_rng(0)  # the same clicks give the same curve
    best, most = None, 0.5 * len(paint)
    for _ in range(_DRAWS):
        ellipse = _ellipse(paint[rng.permutation(len(paint))[:6]])
        if ellipse is None or np.median(ellipse.away(clicked)) > _CLICKS_PX:
            continue
        count = float((1.0 - (ellipse.away(paint) / _INLIER_PX).clip(0.0, 1.0)).sum())
        if count > most:
            best, most = ellipse, count
    for reach in (2 * _INLIER_PX, _INLIER_PX):
        best = None if best is None else _ellipse(paint[best.away(paint) <= reach])
    arc = None if best is None else best.arc(clicked)
    drawn = None if arc is None else _curve(arc[0], len(curve.coefficients), closed=arc[1])
    return curve if drawn is None else drawn


@dataclass(frozen=True, slots=True)
class _Ellipse:
    """A circle as a picture shows it: its centre, half axes, px, and turn, radians."""

    centre: tuple[float, float]
    axes: tuple[float, float]
    turn: float

    def own(self, points: FloatArray) -> FloatArray:
        """(n, 2): the unit circle's coordinates of places."""
        cos, sin = math.cos(self.turn), math.sin(self.turn)
        return np.asarray((points - self.centre) @ np.array([[cos, -sin], [sin, cos]]) / self.axes)

    def at(self, angles: FloatArray) -> FloatArray:
        """(n, 2) px."""
        cos, sin = math.cos(self.turn), math.sin(self.turn)
        own = np.column_stack([np.cos(angles), np.sin(angles)]) * self.axes
        return np.asarray(own @ np.array([[cos, sin], [-sin, cos]]) + self.centre)

    def away(self, points: FloatArray) -> FloatArray:
        """(n,) px, to first order."""
        own = self.own(points)
        slope = 2 * np.hypot(*(own / self.axes).T)
        return np.asarray(np.abs((own**2).sum(axis=1) - 1) / np.maximum(slope, 1e-9))

    def arc(self, clicked: FloatArray) -> tuple[FloatArray, bool] | None:
        """The stretch that was clicked, and whether it is all of it; None: more than all."""
        own = self.own(clicked)
        angles = np.arctan2(own[:, 1], own[:, 0])
        if len(clicked) > _ELLIPSE_CLICKS and np.hypot(*(clicked[0] - clicked[-1])) <= _CLOSED_PX:
            direction = 1.0 if np.unwrap(angles)[-1] > angles[0] else -1.0
            return self.at(angles[0] + direction * np.linspace(0, 2 * math.pi, 400)), True
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
        return self.at(np.linspace(first, last, 400)), False


def _ellipse(points: FloatArray) -> _Ellipse | None:
    """The ellipse through points; None where they determine no sensible one."""
    if len(points) < _ELLIPSE_CLICKS:
        return None
    (cx, cy), axes, turn = cv2.fitEllipseDirect(points.astype(np.float32))
    major, minor = axes[0] / 2, axes[1] / 2
    if not all(map(math.isfinite, (cx, cy, major, minor, turn))) or min(major, minor) < 2:
        return None
    return _Ellipse((cx, cy), (major, minor), math.radians(turn))


def _elliptic_arc(clicked: FloatArray) -> tuple[FloatArray, bool] | None:
    """The stretch of an ellipse that was clicked, and whether it is all of it.

    None where the clicks determine no sensible ellipse: a flat arc far away.
    """
    ellipse = _ellipse(clicked)
    if ellipse is None:
        return None
    own = ellipse.own(clicked)
    if np.hypot(*(ellipse.at(np.arctan2(own[:, 1], own[:, 0])) - clicked).T).max() > _ELLIPSE_PX:
        return None
    return ellipse.arc(clicked)


def robust_fit(basis: FloatArray, values: FloatArray) -> tuple[FloatArray, BoolArray]:
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
