"""Closest points on primitives to the annotated points, for batches of cameras and frames."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.observations import (
    AnyArray,
    Observations,
    PrimitiveCandidates,
    Primitives,
)
from procc_annotator.calibration.optimization.projection import MIN_DEPTH_M

# What stands in for parts that a frame has fewer of; nothing comes of it.
_PADDING_LINE = np.array([[0.0, 1.0], [0.0, 0.0], [0.0, 0.0]])
_PADDING_CURVE = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]])


def is_batchable(seen: Observations) -> bool:
    """Return whether all points lie on lines and curves that end at their ends, and count as they
    are."""
    plain = seen.candidates.of_point is None and seen.soft is None
    return plain and seen.curve_pairs == seen.points.shape[1]


class BatchSizes(NamedTuple):
    """The largest number of lines, curves, and points on either, of the frames of a batch."""

    lines: int
    curves: int
    on_lines: int
    on_curves: int

    @classmethod
    def of(cls, frames: Sequence[Observations]) -> BatchSizes:
        """Sizes that hold any of the frames."""
        counts = [
            (f.parts.lines, f.parts.curves, f.line_pairs, f.curve_pairs - f.line_pairs)
            for f in frames
        ]
        return cls(*np.max(counts, axis=0).tolist())


@dataclass(frozen=True, eq=False)
class BatchedObservations:
    """The `Observations` of one frame, for B cameras of several frames: some cameras of the first
    one, then some of the next.

    Attributes:
        points: (B, 2, N) solver px: first those on lines, then those on curves, of each frame
            followed by what stands in for those it has not.
        line_pairs, curve_pairs: how many of the N are on lines; N.
        parts: those of each camera's frame: arrays as `Parts` has them, (B, ...).
        line_first, line_span: (B, 3, points on lines) metres, as `Observations` have them.
        curve_half, curve_frames: (B, points on curves) and (B, 3, 3, points on curves), likewise.
        line_place, curve_place: (B, points) where among all the parts of all cameras that of each
            point is.
        first_row: (F,) the first camera of each frame.
        frame_of_row: (B,) which frame each camera is of.
    """

    points: FloatArray
    line_pairs: int
    curve_pairs: int
    parts: Primitives
    line_first: FloatArray
    line_span: FloatArray
    curve_half: FloatArray
    curve_frames: FloatArray
    line_place: IntArray
    curve_place: IntArray
    first_row: IntArray
    frame_of_row: IntArray
    candidates: ClassVar[PrimitiveCandidates] = PrimitiveCandidates(
        None, np.empty(0, dtype=np.intp), None
    )
    soft: ClassVar[None] = None

    @classmethod
    def of(
        cls, frames: Sequence[Observations], counts: IntArray, sizes: BatchSizes
    ) -> BatchedObservations:
        """Stack the points of F frames for so many cameras (F,) of each."""
        *most, on_lines, on_curves = sizes
        points = np.zeros((len(frames), 2, on_lines + on_curves))
        ends = np.tile(_PADDING_LINE[:, :, None], (len(frames), 1, 1, most[0]))
        circles = np.tile(_PADDING_CURVE[:, :, None], (len(frames), 1, 1, most[1]))
        half = np.full((len(frames), most[1]), np.inf)
        line = np.zeros((len(frames), on_lines), dtype=np.intp)
        curve = np.zeros((len(frames), on_curves), dtype=np.intp)
        for row, one in enumerate(frames):
            parts = one.parts
            points[row][:, point_columns(one, on_lines)] = one.points
            ends[row, :, :, : parts.lines] = parts.line_ends.reshape(3, 2, -1)
            circles[row, :, :, : parts.curves] = parts.curve_frames.reshape(3, 3, -1)
            half[row, : parts.curves] = parts.curve_half
            line[row, : one.line_pairs] = one.line_of_pair
            curve[row, : len(one.curve_of_pair)] = one.curve_of_pair
        first, span = ends[:, :, 0], ends[:, :, 1] - ends[:, :, 0]
        frame_of_row = np.repeat(np.arange(len(frames)), counts)
        number = np.arange(len(frame_of_row))[:, None]
        return cls(
            points[frame_of_row],
            on_lines,
            points.shape[2],
            Primitives(
                ends.reshape(len(frames), 3, -1)[frame_of_row],
                circles.reshape(len(frames), 3, -1)[frame_of_row],
                half[frame_of_row],
                np.empty((3, 0)),
                (),
            ),
            np.take_along_axis(first, line[:, None], axis=2)[frame_of_row],
            np.take_along_axis(span, line[:, None], axis=2)[frame_of_row],
            np.take_along_axis(half, curve, axis=1)[frame_of_row],
            np.take_along_axis(circles, curve[:, None, None], axis=3)[frame_of_row],
            line[frame_of_row] + number * most[0],
            curve[frame_of_row] + number * most[1],
            np.cumsum(counts) - counts,
            frame_of_row,
        )

    def of_lines(self, table: AnyArray) -> AnyArray:
        """See `Observations.of_lines`."""
        return _select_rows(table, self.line_place)

    def of_curves(self, table: AnyArray) -> AnyArray:
        """See `Observations.of_curves`."""
        return _select_rows(table, self.curve_place)

    def shared(self, of_rows: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(B,) whether what is said of cameras (B,) holds of any of the same frame."""
        found = np.logical_or.reduceat(of_rows, self.first_row)[self.frame_of_row]
        return np.asarray(found)


def point_columns(seen: Observations, on_lines: int) -> IntArray:
    """(n,) where a frame's points are among those of `BatchedObservations`, so many of which are
    on lines."""
    columns = np.arange(seen.points.shape[1])
    columns[seen.line_pairs :] += on_lines - seen.line_pairs
    return columns


def _select_rows(table: AnyArray, place: IntArray) -> AnyArray:
    return table.reshape(*table.shape[:-2], -1).take(place, axis=-1)


_TINY = 1e-12
_MAX_STEP_RAD = 0.5
# Coordinates of aside, centre and ahead, each going on round: their cross products are those of
# slices (`numpy.cross` takes several times as long on small arrays).
_GRAM_ORDER = [6, 7, 8, 6, 7, 0, 1, 2, 0, 1, 3, 4, 5, 3, 4]
# The whole of a curve is examined where the last step is larger, or the point is farther off.
_CONVERGED_PX, _AMBIGUOUS_PX = 1.0, 4.0


@dataclass(frozen=True, eq=False)
class ClosestPoints:
    """Feet of N points for B cameras.

    Attributes:
        world: (B, 3, N) metres.
        along: (B, 3, N) direction of the element there, metres.
        at_end: (B, N) whether the foot is at a true end of the element, a corner or a spot: the
            whole difference counts.
        hidden: (B, N) whether the element is behind the camera.
        pair: (B, N) which of the points' candidates each foot is; None where they had no choice.
    """

    world: FloatArray
    along: FloatArray
    at_end: NDArray[np.bool_]
    hidden: NDArray[np.bool_]
    pair: IntArray | None = None


def find_closest_points(
    linear: FloatArray,
    undistorted: FloatArray,
    seen: Observations | BatchedObservations,
    *,
    thorough: bool = True,
) -> ClosestPoints:
    """Closest points on their elements to all N annotated points.

    Args:
        linear: (B, 3, 4) world -> undistorted pixels times depth.
        undistorted: (B, 2, N) the annotated points as the linear map shows them.
        thorough: whether curves have their nearest place always; else one that steps from where
            the point's ray goes lead to, which takes less time where most cameras are wrong.
    """
    candidates = seen.candidates
    points = undistorted if candidates.point is None else undistorted[:, :, candidates.point]
    lines, curves = seen.line_pairs, seen.curve_pairs
    count, total = len(linear), points.shape[2]
    feet = ClosestPoints(
        np.empty((count, 3, total)),
        np.empty((count, 3, total)),
        np.empty((count, total), dtype=bool),
        np.empty((count, total), dtype=bool),
    )
    if lines:
        _closest_on_lines(linear, points[:, :, :lines], seen, feet)
    if lines < curves:
        _closest_on_curves(linear, points[:, :, lines:curves], seen, feet, thorough)
    if isinstance(seen, Observations) and curves < total:
        _closest_on_spots(linear, seen, feet)
    if candidates.of_point is None:
        return feet
    return _nearest_candidates(linear, points, candidates.of_point, feet)


def _nearest_candidates(
    linear: FloatArray, points: FloatArray, of_point: IntArray, feet: ClosestPoints
) -> ClosestPoints:
    """Of the feet of all candidates those that lie nearest to their point in the picture."""
    place = linear[:, :, :3] @ feet.world + linear[:, :, 3:]
    depth = np.where(feet.hidden, 1.0, place[:, 2])[:, None]
    apart = ((points - place[:, :2] / depth) ** 2).sum(axis=1)
    apart[feet.hidden] = np.inf
    best = np.argmin(apart[:, of_point], axis=2)
    pair = of_point[np.arange(len(of_point)), best]
    camera = np.arange(len(linear))[:, None]
    return ClosestPoints(
        np.take_along_axis(feet.world, pair[:, None], axis=2),
        np.take_along_axis(feet.along, pair[:, None], axis=2),
        feet.at_end[camera, pair],
        feet.hidden[camera, pair],
        pair,
    )


def _closest_on_spots(linear: FloatArray, seen: Observations, feet: ClosestPoints) -> None:
    split, of_pair = seen.curve_pairs, seen.spot_of_pair
    depths = linear[:, 2, :3] @ seen.parts.spots + linear[:, 2, 3:]
    feet.world[:, :, split:] = seen.parts.spots[:, of_pair]
    feet.along[:, :, split:] = 0.0
    feet.at_end[:, split:] = True
    feet.hidden[:, split:] = depths[:, of_pair] < MIN_DEPTH_M


def _closest_on_lines(
    linear: FloatArray,
    points: FloatArray,
    seen: Observations | BatchedObservations,
    feet: ClosestPoints,
) -> None:
    split = seen.line_pairs
    table, hidden = _visible_lines(linear, seen)
    # Elements are passed to their points in one step, a plane each number.
    table = seen.of_lines(table)
    across = table[2:4]
    share = _dot_2d(points.transpose(1, 0, 2) - table[0:2], across)
    length = _dot_2d(across, across)
    length += _TINY
    share /= length
    inside = np.maximum(share, 0.0)
    np.minimum(inside, 1.0, out=inside)
    # Equal steps in the picture are not equal steps on the field.
    near = inside * table[4]
    position = table[7] * near
    position /= near + (1 - inside) * table[5]
    position += table[6]
    world = feet.world[:, :, :split]
    np.multiply(position[:, None], seen.line_span, out=world)
    world += seen.line_first
    feet.along[:, :, :split] = seen.line_span
    feet.hidden[:, :split] = False if hidden is None else seen.of_lines(hidden)
    at_first, at_second = position <= 0.0, position >= 1.0
    at_first |= at_second
    np.logical_and(inside != share, at_first, out=feet.at_end[:, :split])


def _visible_lines(
    linear: FloatArray, seen: Observations | BatchedObservations
) -> tuple[FloatArray, NDArray[np.bool_] | None]:
    """Return what the cameras show of L lines: (8, B, L), u and v of the first end in sight, u and
    v from there to the second, the depths of both, the share of the line before the first and that
    in sight; and (B, L) whether nothing is, None where something is of all."""
    lines = seen.parts.lines
    ends = linear[:, :, :3] @ seen.parts.line_ends
    ends += linear[:, :, 3:]
    ends = ends.reshape(len(linear), 3, 2, lines)
    first, span = ends[:, :, 0], ends[:, :, 1] - ends[:, :, 0]
    depths = ends[:, 2]
    behind = depths < MIN_DEPTH_M
    table = np.empty((8, len(linear), lines))
    hidden = None
    if behind.any():
        # Where the element crosses the nearest depth that is projected; no matter where it does
        # not.
        fall = span[:, 2]
        crossing = (MIN_DEPTH_M - depths[:, 0]) / np.where(np.abs(fall) > _TINY, fall, 1.0)
        low = np.where(behind[:, 0], crossing, 0.0)
        high = np.where(behind[:, 1], crossing, 1.0)
        hidden = behind[:, 0] & behind[:, 1]
        seen_a = low[:, None] * span
        seen_a += first
        seen_b = high[:, None] * span
        seen_b += first
        table[4], table[5] = (
            np.where(hidden, 1.0, seen_a[:, 2]),
            np.where(hidden, 1.0, seen_b[:, 2]),
        )
        table[6], table[7] = low, high - low
    else:
        seen_a, seen_b = first, first + span
        table[4], table[5], table[6], table[7] = seen_a[:, 2], seen_b[:, 2], 0.0, 1.0
    np.divide(seen_a[:, :2].transpose(1, 0, 2), table[4], out=table[0:2])
    np.divide(seen_b[:, :2].transpose(1, 0, 2), table[5], out=table[2:4])
    table[2:4] -= table[0:2]
    return table, hidden


def _closest_on_curves(
    linear: FloatArray,
    points: FloatArray,
    seen: Observations | BatchedObservations,
    feet: ClosestPoints,
    thorough: bool,
) -> None:
    curves = seen.parts.curves
    on_curves = slice(seen.line_pairs, seen.curve_pairs)
    frame = linear[:, :, :3] @ seen.parts.curve_frames
    centres = frame[:, :, :curves]
    centres += linear[:, :, 3:]
    # Centre, ahead and aside, a plane (B, C) each coordinate.
    planes = frame.reshape(-1, 3, 3, curves).transpose(2, 1, 0, 3).reshape(9, -1, curves)
    # Cramer's rule: the point of the circle's plane that a pixel shows, in radii from the centre.
    # Above the horizon it goes on to the direction in which the pixel's ray leaves.
    turns = planes[_GRAM_ORDER].reshape(3, 5, -1, curves)
    one, other = turns[:2], turns[1:]
    crossed = one[:, 1:4] * other[:, 2:] - one[:, 2:] * other[:, 1:4]
    crossed *= np.where((planes[3:6] * crossed[0]).sum(axis=0) < 0, -1.0, 1.0)
    table = seen.of_curves(np.concatenate([planes, crossed.reshape(6, -1, curves)]))
    points = np.ascontiguousarray(points.transpose(1, 0, 2))
    sine, cosine = _dot_2d(table[12:14], points), _dot_2d(table[9:11], points)
    sine += table[14]
    cosine += table[11]
    angle = np.arctan2(sine, cosine)
    half = seen.curve_half
    angle, corner = _newton_on_curves(table[:9], points, half, angle, thorough)
    cosine, sine = np.cos(angle), np.sin(angle)
    world = seen.curve_frames
    cos_wide, sin_wide = cosine[:, None], sine[:, None]
    place, along = feet.world[:, :, on_curves], feet.along[:, :, on_curves]
    np.multiply(cos_wide, world[..., 1, :], out=place)
    place += world[..., 0, :]
    place += sin_wide * world[..., 2, :]
    np.multiply(cos_wide, world[..., 2, :], out=along)
    along -= sin_wide * world[..., 1, :]
    depths = cosine * table[5]
    depths += table[2]
    depths += sine * table[8]
    np.less(depths, MIN_DEPTH_M, out=feet.hidden[:, on_curves])
    at_end = np.abs(angle) >= half
    if corner is not None:
        corner &= ~at_end
    feet.at_end[:, on_curves] = at_end if corner is None else at_end | corner


def _newton_on_curves(
    table: FloatArray, points: FloatArray, half: FloatArray, angle: FloatArray, thorough: bool
) -> tuple[FloatArray, NDArray[np.bool_] | None]:
    """Angles on curves (9, B, N: centre, ahead and aside as the camera maps them) nearest to points
    (2, B, N) from those to start from: two steps, and where these do not settle another look;
    whether those found then are corners."""
    centre, ahead, aside = table[0:3], table[3:6], table[6:9]
    least = -half
    angle = np.minimum(np.maximum(angle, least), half)
    for _ in range(2):
        cosine, sine = np.cos(angle), np.sin(angle)
        place = cosine * ahead
        place += centre
        place += sine * aside
        speed = cosine * aside
        speed -= sine * ahead
        depth = np.maximum(place[2], MIN_DEPTH_M)
        apart = points - place[:2] / depth
        motion = points - apart
        motion *= speed[2]
        np.subtract(speed[:2], motion, out=motion)
        motion /= depth
        squares = _dot_2d(motion, motion)
        squares += _TINY
        step = _dot_2d(apart, motion)
        step /= squares
        previous = angle
        angle = angle + np.minimum(np.maximum(step, -_MAX_STEP_RAD), _MAX_STEP_RAD)
        np.maximum(angle, least, out=angle)
        np.minimum(angle, half, out=angle)
    if not thorough:
        return angle, None
    off = _dot_2d(apart, apart) - step * step * squares
    # A point beyond an arc's end has settled there, however far its step would lead on.
    moved = np.where(np.abs(step) > _MAX_STEP_RAD, step, angle - previous)
    doubtful = (
        (moved * moved * squares > _CONVERGED_PX**2)
        | (off > _AMBIGUOUS_PX**2)
        | (place[2] < MIN_DEPTH_M)
    )
    camera, point = np.nonzero(doubtful)
    if not len(camera):
        return angle, None
    curves = table[:, camera, point].T.reshape(-1, 3, 3)
    half = np.broadcast_to(half, angle.shape)[camera, point]
    found = nearest_angles(curves, half, points[:, camera, point].T, MIN_DEPTH_M)
    angle[camera, point] = np.where(found.seen, found.angles, angle[camera, point])
    corner = np.zeros(angle.shape, dtype=bool)
    corner[camera, point] = found.seen & found.corner
    return angle, corner


def _dot_2d(a: FloatArray, b: FloatArray) -> FloatArray:
    """(2, B, N), (2, B, N) -> (B, N) scalar products."""
    products = a * b
    products[0] += products[1]
    found: FloatArray = products[0]
    return found


# Places examined all along the curve, then about the nearest one of the chords between: half a
# circle's 1/512, 6 cm for 9.15 m, and two passes over small arrays instead of four.
_SEARCH_SAMPLES, _REFINE_SAMPLES = 129, 17
_CORNER_PX = 1.0


@dataclass(frozen=True, eq=False)
class NearestAngles:
    """Closest points of K curves to K points.

    Attributes:
        angles: (K,) rad from the middle of the arc; says nothing where the curve is not seen.
        seen: (K,) whether any of it is.
        corner: (K,) whether the way there is not across the curve: it ends there, or bends as
            sharply as a circle does that is seen edge-on.
    """

    angles: FloatArray
    seen: NDArray[np.bool_]
    corner: NDArray[np.bool_]


def nearest_angles(
    curves: FloatArray, half_rad: FloatArray, points: FloatArray, nearest_m: float
) -> NearestAngles:
    """The angles at which K curves are nearest to K points of the picture.

    Args:
        curves: (K, 3, 3) of each curve its centre, its radius to the middle of the arc and the one
            a quarter turn further, each as (u z, v z, z).
        half_rad: (K,) half of each arc's angle; infinite for a circle.
        points: (K, 2) px.
        nearest_m: what is nearer to the camera's plane is not seen.
    """
    half = half_rad[:, None]
    reach = np.minimum(half, np.pi)
    angles = reach * np.linspace(-1.0, 1.0, _SEARCH_SAMPLES)
    found = _nearest_on_chords(curves, angles, points, nearest_m)
    spacing = reach * 2 / (_SEARCH_SAMPLES - 1)
    about = spacing * np.linspace(-1.0, 1.0, _REFINE_SAMPLES)
    angles = np.minimum(np.maximum(found.angles[:, None] + about, -half), half)
    closer = _nearest_on_chords(curves, angles, points, nearest_m)
    # Next to where a curve is lost from sight nothing closer may be seen.
    both = np.where(closer.seen, closer.angles, found.angles)
    return NearestAngles(both, found.seen, closer.corner)


def _nearest_on_chords(
    curves: FloatArray, angles: FloatArray, points: FloatArray, nearest_m: float
) -> NearestAngles:
    """Return where the chords between (K, S) angles of the curves are nearest to the points."""
    turn = np.stack([np.ones_like(angles), np.cos(angles), np.sin(angles)], axis=1)
    place = curves.transpose(0, 2, 1) @ turn
    seen = place[:, 2] >= nearest_m
    shown = place[:, :2] / np.where(seen, place[:, 2], 1.0)[:, None]
    first, chord = shown[:, :, :-1], shown[:, :, 1:] - shown[:, :, :-1]
    off = points[:, :, None] - first
    length = (chord * chord).sum(axis=1) + _TINY
    free = (off * chord).sum(axis=1) / length
    share = np.minimum(np.maximum(free, 0.0), 1.0)
    away = off - share[:, None] * chord
    squares = np.where(seen[:, :-1] & seen[:, 1:], (away * away).sum(axis=1), np.inf)
    rows = np.arange(len(squares))
    best = rows, np.argmin(squares, axis=1)
    step = angles[rows, best[1] + 1] - angles[best]
    past = (free[best] - share[best]) ** 2 * length[best]
    return NearestAngles(
        angles[best] + share[best] * step, np.isfinite(squares[best]), past > _CORNER_PX**2
    )
