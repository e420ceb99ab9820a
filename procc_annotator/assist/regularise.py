"""Resample an element regularly along its line marking; close small gaps at its ends."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.assist.curves import (
    EVERYWHERE,
    Curve,
    curve_through,
    refitted,
    regular_parameters,
)
from procc_annotator.calibration.prediction.visible_elements import ImageSize, expected_line_end
from procc_annotator.field.geometry import is_closed
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import touching_elements

REACH_PX = 25.0


def close_gaps(
    polyline: Polyline, annotation: FrameAnnotation, field: Field, size: ImageSize
) -> Polyline:
    """Extend the ends of an element to what they fall short of; unchanged when nothing is near.

    An end of a straight element is moved along its line, by at most `REACH_PX`: to where it meets
    the line of an annotated straight element that it meets on the field, else to the picture's
    edge. A circle with ends that near is closed with its first point. Points between the ends stay.

    Args:
        polyline: of a class of the field; others come back unchanged.
        size: (width, height) of the picture, px.
    """
    element = field.element(polyline.class_name)
    if element is None or len(polyline.points) < 2:
        return polyline
    points = points_px(polyline, size)
    if is_closed(element.geometry):
        if len(points) > 4 and 0 < np.hypot(*(points[-1] - points[0])) <= REACH_PX:
            return Polyline(polyline.class_name, (*polyline.points, polyline.points[0]))
        return polyline
    if not element.is_straight:
        return polyline
    lines = [
        points_px(other, size)
        for name in touching_elements(field, polyline.class_name)
        if (other := annotation.get(name)) is not None
        and len(other.points) >= 2
        and (neighbour := field.element(name)) is not None
        and neighbour.is_straight
    ]
    first = expected_line_end(points[0], points[1], lines, size, REACH_PX)
    last = expected_line_end(points[-1], points[-2], lines, size, REACH_PX)
    return Polyline(
        polyline.class_name,
        (
            _replaced(polyline.points[0], first, size),
            *polyline.points[1:-1],
            _replaced(polyline.points[-1], last, size),
        ),
    )


def _replaced(point: Point, place: FloatArray | None, size: ImageSize) -> Point:
    if place is None:
        return point
    moved = point_from_px(float(place[0]), float(place[1]), size)
    return Point(moved.u, moved.v, point.extra)


# (N, 2) points px, (N, 2) unit directions px -> (N, 2) px on the lines' centres, NaN: no line.
Snap = Callable[[FloatArray, FloatArray], FloatArray]

MOST_MOVED_PX = 2.5  # a click farther from the paint is not the program's to move
_SAMPLES = 24  # along an element, to find its curve
_INLIER_PX = 1.0
_UNCHANGED_PX = 0.5  # a point that would move by less stays, a chord that passes nearer is its own
_LEAST_SUPPORT = 0.3  # of the samples; with less the curve itself is in doubt
_LEAST_AGREED = 0.5  # of the clicks: where fewer lie on it, the curve is another line's
_VOUCHES = 1.5  # so many samples away
_REGULAR, _DENSER = 0.8, 1.3  # clicks are regular: one so near each sample, and hardly more of them
_FOOT_SAMPLES = 801
_MOST_TIMES = 3  # until it stays


@dataclass(frozen=True, slots=True)
class Regularised:
    """An element after regularising.

    Attributes:
        polyline: its points; the very same where nothing was found or nothing would change.
        unconfirmed: the clicks among them at which no paint was found; they are where they were.
    """

    polyline: Polyline
    unconfirmed: tuple[Point, ...] = ()


def regularise(
    polyline: Polyline,
    *,
    curved: bool,
    size: tuple[int, int],
    snap: Snap | None,
    bar: bool = False,
) -> Regularised:
    """Resample an element along its painted line, denser where it bends.

    No click is lost: the outcome passes every one within `MOST_MOVED_PX`.

    Args:
        polyline: at least its two ends; a curve wants five points.
        curved: whether it is a circle or an arc; the order of a circle's points does not matter.
        size: (width, height) of the picture, px.
        snap: puts points on lines; None only resamples.
        bar: whether it is a bar: straight, and before anything. Its points lie on its own line,
            since what is behind it draws single ones aside.

    Returns:
        Points in the direction of the clicks: the samples that a painted line supports, and the
        clicks that it does not confirm. With support for fewer than two samples, or for less than a
        third of them, the polyline comes back as it is; so does one that is regular already, and
        one with clicks that go back the way they came. Curves and bars are done until that is
        reached, lest their points creep along with every repetition; the last step is left out
        where it would take a click by more than it may be moved.
    """
    if len(polyline.points) < 2:
        return Regularised(polyline)
    if snap is None:
        return _once(polyline, curved, size, None, bar)
    clicked = points_px(polyline, size)
    reached = Regularised(polyline)
    for _ in range(_MOST_TIMES if curved or bar else 1):
        again = _once(reached.polyline, curved, size, snap, bar)
        own = tuple(p for p in again.unconfirmed if p in polyline.points)
        if _is_same(reached.polyline, again.polyline, size):
            return Regularised(reached.polyline, own)
        if (_chord_distances(clicked, points_px(again.polyline, size)) > MOST_MOVED_PX).any():
            break
        reached = Regularised(again.polyline, own)
    return reached


def _once(
    polyline: Polyline, curved: bool, size: tuple[int, int], snap: Snap | None, bar: bool
) -> Regularised:
    clicked = points_px(polyline, size)
    curve = curve_through(clicked, curved, bar)
    if curve is None or curve.turns_back:
        return Regularised(polyline)
    if snap is None:
        places = curve.at(_positions(curve, size))[0]
        return Regularised(_polyline(polyline, places.tolist(), curve, size))
    parameters = _samples(curve, size, curved)
    found = snap(*curve.at(parameters))
    if curved:
        curve = refitted(curve, clicked, found)
        parameters = _samples(curve, size, curved)
        found = snap(*curve.at(parameters))
    fitted = curve.fitted(parameters, found)
    if fitted is None:
        return Regularised(polyline, polyline.points)
    return _along_paint(polyline, clicked, fitted, snap, size, on_curve=bar)


def _is_same(before: Polyline, after: Polyline, size: tuple[int, int]) -> bool:
    """Return whether points are as regular as others, on the same line."""
    if before == after:
        return True
    old, new = points_px(before, size), points_px(after, size)
    if len(old) > _DENSER * len(new) or len(new) < 2:
        return False
    steps = np.hypot(*np.diff(new, axis=0).T)
    own = np.maximum(np.append(steps, 0.0), np.append(0.0, steps))  # to the farther neighbour
    nearest = np.hypot(*(new[:, None] - old[None]).transpose(2, 0, 1)).min(axis=1)
    return bool(
        (nearest <= _REGULAR * own).all()
        and (_chord_distances(new, old) <= _UNCHANGED_PX).all()
        and (_chord_distances(old, new) <= _UNCHANGED_PX).all()
    )


def _along_paint(
    polyline: Polyline,
    clicked: FloatArray,
    curve: Curve,
    snap: Snap,
    size: tuple[int, int],
    *,
    on_curve: bool,
) -> Regularised:
    parameters = _positions(curve, size)
    placed, supported = _snap_to_lines(curve, parameters, snap, on_curve=on_curve)
    inner = supported[1:-1]
    at, near = _closest_parameters(clicked, curve)
    enough = inner.sum() >= max(2.0, _LEAST_SUPPORT * len(inner))
    if not enough or near.mean() < _LEAST_AGREED:
        return Regularised(polyline, polyline.points)
    feet, found = _snap_to_lines(curve, at, snap, on_curve=on_curve)
    # In samples, from each click to each one with support.
    row = np.interp(at, parameters, np.arange(len(parameters)))
    between = np.flatnonzero(supported)[None] - row[:, None]
    ends = np.zeros(len(clicked), dtype=bool)
    if not curve.closed:
        ends[[at.argmin(), at.argmax()]] = True  # somebody has seen it end here
    before = ((between <= 0) & (between >= -_VOUCHES)).any(axis=1)
    after = ((between >= 0) & (between <= _VOUCHES)).any(axis=1)
    # Where lines meet, the finder may see no paint: neighbours on both sides vouch for it, of an
    # end the one there is.
    confirmed = near & (found | (before & after) | (ends & (before | after)))
    moves = np.hypot(*(feet - clicked).T)
    confirmed &= moves <= MOST_MOVED_PX
    kept = tuple(polyline.points[i] for i in np.flatnonzero(~confirmed))
    supported[[0, -1]] = curve.closed  # else the clicks are the ends
    lonely = confirmed & (ends | (np.abs(between).min(axis=1) > _VOUCHES))
    rows = [*zip(parameters[supported], placed[supported].tolist(), strict=True)]
    rows += zip(at[lonely], feet[lonely].tolist(), strict=True)
    rows += zip(at[~confirmed], clicked[~confirmed].tolist(), strict=True)
    chords = [place for _, place in sorted(rows)]
    passed = (_chord_distances(clicked, chords) <= MOST_MOVED_PX) & (
        _chord_distances(feet, chords) <= _UNCHANGED_PX
    )
    missed = confirmed & ~lonely & ~passed  # where what lies between is hidden
    rows += zip(at[missed], feet[missed].tolist(), strict=True)
    places = [place for _, place in sorted(rows)]
    return Regularised(_polyline(polyline, places, curve, size, kept), kept)


def _closest_parameters(clicked: FloatArray, curve: Curve) -> tuple[FloatArray, BoolArray]:
    """(n,) where along a curve clicks belong, 0 to 1, and (n,) whether they lie near it."""
    if not curve.closed and len(clicked) == 2:
        at = np.array([0.0, 1.0])
        return at, np.hypot(*(clicked - curve.at(at)[0]).T) <= MOST_MOVED_PX
    fine = np.linspace(0.0, 1.0, _FOOT_SAMPLES)
    apart = np.hypot(*(clicked[:, None] - curve.at(fine)[0][None]).transpose(2, 0, 1))
    return fine[apart.argmin(axis=1)], apart.min(axis=1) <= MOST_MOVED_PX


def _snap_to_lines(
    curve: Curve, parameters: FloatArray, snap: Snap, *, on_curve: bool
) -> tuple[FloatArray, BoolArray]:
    """(n, 2) px and whether paint was found there; on the curve where none was, or always."""
    places, directions = curve.at(parameters)
    found = snap(places, directions)
    supported = np.hypot(*(found - places).T) <= _INLIER_PX  # False where NaN
    return np.where(supported[:, None] & (not on_curve), found, places), supported


def _chord_distances(clicked: FloatArray, places: FloatArray | list[list[float]]) -> FloatArray:
    """(n,) px from clicks to the chords between places."""
    chain = np.asarray(places)
    begin, step = chain[:-1], np.diff(chain, axis=0)
    offset = clicked[:, None] - begin[None]
    share = (offset * step).sum(axis=2) / np.maximum((step**2).sum(axis=1), 1e-12)
    beside = offset - np.clip(share, 0.0, 1.0)[..., None] * step
    return np.asarray(np.hypot(beside[..., 0], beside[..., 1]).min(axis=1))


def _polyline(
    polyline: Polyline,
    places: list[list[float]],
    curve: Curve,
    size: tuple[int, int],
    kept: tuple[Point, ...] = (),
) -> Polyline:
    as_given = {(p.u, p.v): p for p in kept}
    made = [point_from_px(x, y, size) for x, y in places]
    points = [_nearly(p, as_given) for p in made]
    if not curve.closed:
        for i in (0, -1):
            points[i] = Point(points[i].u, points[i].v, polyline.points[i].extra)
    return Polyline(polyline.class_name, tuple(points))


def _nearly(point: Point, given: dict[tuple[float, float], Point]) -> Point:
    """The given point at this place, to its last digit; else the point itself."""
    for (u, v), kept in given.items():
        if abs(u - point.u) + abs(v - point.v) < 1e-9:
            return kept
    return point


def _samples(curve: Curve, size: tuple[int, int], curved: bool) -> FloatArray:
    """Parameters at which the paint is looked for: more of them where the curve bends."""
    if not curved:
        return np.linspace(0.0, 1.0, _SAMPLES)
    regular = _positions(curve, size)
    rows = np.linspace(0, len(regular) - 1, max(_SAMPLES, min(2 * len(regular), 2 * _SAMPLES)))
    return np.interp(rows, np.arange(len(regular)), regular)


def _positions(curve: Curve, size: tuple[int, int]) -> FloatArray:
    """Parameters of the resulting points: regular, denser where the curve bends."""
    fine = np.linspace(0.0, 1.0, EVERYWHERE)
    places, directions = curve.at(fine)
    return regular_parameters(fine, places, directions, size[0])
