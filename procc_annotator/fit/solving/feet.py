"""The place on its element that each annotated point belongs to: the nearest one in the picture.

Works for B cameras at once. A camera enters as a linear map (B, 3, 4) from world points to
(u z, v z, z): u, v its undistorted pixels, z the depth in metres.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import FloatArray, IntArray, Observations

# Nearer than this to the camera's plane nothing is projected: its pixels would be anywhere.
NEAREST_M = 0.5
_TINY = 1e-12
_LARGEST_STEP_RAD = 0.5


@dataclass(frozen=True, eq=False)
class Feet:
    """Feet of N points for B cameras.

    Attributes:
        world: (B, 3, N) metres.
        along: (B, 3, N) direction of the element there, metres.
        at_end: (B, N) whether the foot was moved to a true end of the element, a corner of a chain
            or a spot: the whole difference counts.
        hidden: (B, N) whether the element is behind the camera.
        pair: (B, N) which of the points' candidates each foot is; None where they had no choice.
    """

    world: FloatArray
    along: FloatArray
    at_end: NDArray[np.bool_]
    hidden: NDArray[np.bool_]
    pair: IntArray | None = None


def find_feet(linear: FloatArray, undistorted: FloatArray, seen: Observations) -> Feet:
    """Feet of all points.

    Args:
        linear: (B, 3, 4) world -> undistorted pixels times depth.
        undistorted: (B, 2, N) the annotated points as the linear map shows them.
        seen: the N points and their elements.
    """
    candidates = seen.candidates
    points = undistorted if candidates.point is None else undistorted[:, :, candidates.point]
    lines, curves = seen.line_pairs, seen.curve_pairs
    count, total = len(linear), points.shape[2]
    feet = Feet(
        np.empty((count, 3, total)),
        np.empty((count, 3, total)),
        np.empty((count, total), dtype=bool),
        np.empty((count, total), dtype=bool),
    )
    if lines:
        _on_lines(linear, points[:, :, :lines], seen, feet)
    if lines < curves:
        _on_curves(linear, points[:, :, lines:curves], seen, feet)
    if curves < total:
        _on_spots(linear, seen, feet)
    if candidates.of_point is None:
        return feet
    return _nearest(linear, points, candidates.of_point, feet)


def _nearest(linear: FloatArray, points: FloatArray, of_point: IntArray, feet: Feet) -> Feet:
    """Of the feet of all candidates those that lie nearest to their point in the picture."""
    place = linear[:, :, :3] @ feet.world + linear[:, :, 3:]
    depth = np.where(feet.hidden, 1.0, place[:, 2])[:, None]
    apart = ((points - place[:, :2] / depth) ** 2).sum(axis=1)
    apart[feet.hidden] = np.inf
    best = np.argmin(apart[:, of_point], axis=2)
    pair = of_point[np.arange(len(of_point)), best]
    camera = np.arange(len(linear))[:, None]
    return Feet(
        np.take_along_axis(feet.world, pair[:, None], axis=2),
        np.take_along_axis(feet.along, pair[:, None], axis=2),
        feet.at_end[camera, pair],
        feet.hidden[camera, pair],
        pair,
    )


def _on_spots(linear: FloatArray, seen: Observations, feet: Feet) -> None:
    split, of_pair = seen.curve_pairs, seen.spot_of_pair
    depths = linear[:, 2, :3] @ seen.parts.spots + linear[:, 2, 3:]
    feet.world[:, :, split:] = seen.parts.spots[:, of_pair]
    feet.along[:, :, split:] = 0.0
    feet.at_end[:, split:] = True
    feet.hidden[:, split:] = depths[:, of_pair] < NEAREST_M


def _on_lines(linear: FloatArray, points: FloatArray, seen: Observations, feet: Feet) -> None:
    lines, split = seen.parts.lines, seen.line_pairs
    ends = linear[:, :, :3] @ seen.parts.line_ends + linear[:, :, 3:]
    first, second = ends[:, :, :lines], ends[:, :, lines:]
    depth_a, depth_b = first[:, 2], second[:, 2]
    fall = depth_b - depth_a
    # Where the element crosses the nearest depth that is projected; no matter where it does not.
    crossing = (NEAREST_M - depth_a) / np.where(np.abs(fall) > _TINY, fall, 1.0)
    near_a, near_b = depth_a < NEAREST_M, depth_b < NEAREST_M
    low = np.where(near_a, crossing, 0.0)
    high = np.where(near_b, crossing, 1.0)
    span = second - first
    seen_a = first + low[:, None] * span
    seen_b = first + high[:, None] * span
    hidden = near_a & near_b
    weight_a = np.where(hidden, 1.0, seen_a[:, 2])
    weight_b = np.where(hidden, 1.0, seen_b[:, 2])
    # One array, so that the elements are handed to their points in one step.
    table = np.empty((len(linear), 8, lines))
    table[:, 0:2] = seen_a[:, :2] / weight_a[:, None]
    table[:, 2:4] = seen_b[:, :2] / weight_b[:, None] - table[:, 0:2]
    table[:, 4], table[:, 5], table[:, 6], table[:, 7] = weight_a, weight_b, low, high - low
    table = table[:, :, seen.line_of_pair]
    across = table[:, 2:4]
    share = np.einsum("bkn,bkn->bn", points - table[:, 0:2], across)
    share /= np.einsum("bkn,bkn->bn", across, across) + _TINY
    inside = np.minimum(np.maximum(share, 0.0), 1.0)
    # Equal steps in the picture are not equal steps on the field.
    near = inside * table[:, 4]
    position = table[:, 6] + table[:, 7] * near / (near + (1 - inside) * table[:, 5])
    first_of_pair = seen.parts.line_ends[:, :lines][:, seen.line_of_pair]
    feet.world[:, :, :split] = first_of_pair + position[:, None] * seen.line_span
    feet.along[:, :, :split] = seen.line_span
    feet.hidden[:, :split] = hidden[:, seen.line_of_pair]
    at_first, at_second = position <= 0.0, position >= 1.0
    if not seen.parts.all_end:
        at_first &= seen.parts.ends[0, seen.line_of_pair]
        at_second &= seen.parts.ends[1, seen.line_of_pair]
    feet.at_end[:, :split] = (inside != share) & (at_first | at_second)


def _on_curves(linear: FloatArray, points: FloatArray, seen: Observations, feet: Feet) -> None:
    curves, of_pair = seen.parts.curves, seen.curve_of_pair
    on_curves = slice(seen.line_pairs, seen.curve_pairs)
    frame = linear[:, :, :3] @ seen.parts.curve_frames
    frame[:, :, :curves] += linear[:, :, 3:]
    centre, ahead, aside = frame.reshape(*frame.shape[:2], 3, curves).transpose(2, 0, 1, 3)
    # Cramer's rule: the point of the circle's plane that a pixel shows, in radii from the centre.
    # Above the horizon it goes on to the direction in which the pixel's ray leaves.
    by_ahead, by_aside = _cross(aside, centre), _cross(centre, ahead)
    turned = np.where(np.einsum("bkc,bkc->bc", ahead, by_ahead) < 0, -1.0, 1.0)[:, None]
    table = np.concatenate([centre, ahead, aside, by_ahead * turned, by_aside * turned], axis=1)
    table = table[:, :, of_pair]
    angle = np.arctan2(
        np.einsum("bkn,bkn->bn", table[:, 12:14], points) + table[:, 14],
        np.einsum("bkn,bkn->bn", table[:, 9:11], points) + table[:, 11],
    )
    half = seen.parts.curve_half[of_pair]
    centre, ahead, aside = table[:, 0:3], table[:, 3:6], table[:, 6:9]
    angle = np.minimum(np.maximum(angle, -half), half)
    for _ in range(2):
        cosine, sine = np.cos(angle)[:, None], np.sin(angle)[:, None]
        place = centre + cosine * ahead + sine * aside
        speed = cosine * aside - sine * ahead
        depth = np.maximum(place[:, 2:], NEAREST_M)
        shown = place[:, :2] / depth
        motion = (speed[:, :2] - shown * speed[:, 2:]) / depth
        step = np.einsum("bkn,bkn->bn", points - shown, motion)
        step /= np.einsum("bkn,bkn->bn", motion, motion) + _TINY
        angle = angle + np.minimum(np.maximum(step, -_LARGEST_STEP_RAD), _LARGEST_STEP_RAD)
        angle = np.minimum(np.maximum(angle, -half), half)
    cosine, sine = np.cos(angle), np.sin(angle)
    world = seen.parts.curve_frames.reshape(3, 3, curves)[:, :, of_pair]
    cos_wide, sin_wide = cosine[:, None], sine[:, None]
    feet.world[:, :, on_curves] = world[:, 0] + cos_wide * world[:, 1] + sin_wide * world[:, 2]
    feet.along[:, :, on_curves] = cos_wide * world[:, 2] - sin_wide * world[:, 1]
    depths = centre[:, 2] + cosine * ahead[:, 2] + sine * aside[:, 2]
    feet.hidden[:, on_curves] = depths < NEAREST_M
    if seen.parts.all_end:
        feet.at_end[:, on_curves] = np.abs(angle) >= half
        return
    ends = seen.parts.ends[:, seen.parts.lines :][:, of_pair]
    feet.at_end[:, on_curves] = ((angle <= -half) & ends[0]) | ((angle >= half) & ends[1])


def _cross(a: FloatArray, b: FloatArray) -> FloatArray:
    """Cross products along axis 1; `numpy.cross` takes several times as long on small arrays."""
    found = np.empty(a.shape)
    found[:, 0] = a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1]
    found[:, 1] = a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2]
    found[:, 2] = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return found
