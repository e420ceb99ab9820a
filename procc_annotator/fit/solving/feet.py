"""The place on its element that each annotated point belongs to: the nearest one in the picture.

Works for B cameras at once. A camera enters as a linear map (B, 3, 4) from world points to
(u z, v z, z): u, v its undistorted pixels, z the depth in metres.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import FloatArray, Observations

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
        at_end: (B, N) whether the foot was moved to a true end of the element.
        hidden: (B, N) whether the element is behind the camera.
    """

    world: FloatArray
    along: FloatArray
    at_end: NDArray[np.bool_]
    hidden: NDArray[np.bool_]


def find_feet(linear: FloatArray, undistorted: FloatArray, seen: Observations) -> Feet:
    """Feet of all points.

    Args:
        linear: (B, 3, 4) world -> undistorted pixels times depth.
        undistorted: (B, 2, N) the annotated points as the linear map shows them.
        seen: the N points and their elements.
    """
    split = seen.line_points
    count, total = len(linear), undistorted.shape[2]
    feet = Feet(
        np.empty((count, 3, total)),
        np.empty((count, 3, total)),
        np.empty((count, total), dtype=bool),
        np.empty((count, total), dtype=bool),
    )
    if split:
        _on_lines(linear, undistorted[:, :, :split], seen, feet)
    if split < total:
        _on_circles(linear, undistorted[:, :, split:], seen, feet)
    return feet


def _on_lines(linear: FloatArray, points: FloatArray, seen: Observations, feet: Feet) -> None:
    lines, split = seen.line_count, seen.line_points
    ends = linear[:, :, :3] @ seen.line_ends + linear[:, :, 3:]
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
    table = table[:, :, seen.line_of_point]
    across = table[:, 2:4]
    share = np.einsum("bkn,bkn->bn", points - table[:, 0:2], across)
    share /= np.einsum("bkn,bkn->bn", across, across) + _TINY
    inside = np.minimum(np.maximum(share, 0.0), 1.0)
    # Equal steps in the picture are not equal steps on the field.
    near = inside * table[:, 4]
    position = table[:, 6] + table[:, 7] * near / (near + (1 - inside) * table[:, 5])
    ends_of_point = seen.line_ends[:, :lines][:, seen.line_of_point]
    feet.world[:, :, :split] = ends_of_point + position[:, None] * seen.line_span
    feet.along[:, :, :split] = seen.line_span
    feet.hidden[:, :split] = hidden[:, seen.line_of_point]
    feet.at_end[:, :split] = (inside != share) & ((position <= 0.0) | (position >= 1.0))


def _on_circles(linear: FloatArray, points: FloatArray, seen: Observations, feet: Feet) -> None:
    curves, split, of_point = len(seen.circle_half), seen.line_points, seen.circle_of_point
    frame = linear[:, :, :3] @ seen.circle_frames
    frame[:, :, :curves] += linear[:, :, 3:]
    centre, ahead, aside = frame.reshape(*frame.shape[:2], 3, curves).transpose(2, 0, 1, 3)
    # Cramer's rule: the point of the circle's plane that a pixel shows, in radii from the centre.
    # Above the horizon it goes on to the direction in which the pixel's ray leaves.
    by_ahead, by_aside = _cross(aside, centre), _cross(centre, ahead)
    turned = np.where(np.einsum("bkc,bkc->bc", ahead, by_ahead) < 0, -1.0, 1.0)[:, None]
    table = np.concatenate([centre, ahead, aside, by_ahead * turned, by_aside * turned], axis=1)
    table = table[:, :, of_point]
    angle = np.arctan2(
        np.einsum("bkn,bkn->bn", table[:, 12:14], points) + table[:, 14],
        np.einsum("bkn,bkn->bn", table[:, 9:11], points) + table[:, 11],
    )
    half = seen.circle_half[of_point]
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
    world = seen.circle_frames.reshape(3, 3, curves)[:, :, of_point]
    cos_wide, sin_wide = cosine[:, None], sine[:, None]
    feet.world[:, :, split:] = world[:, 0] + cos_wide * world[:, 1] + sin_wide * world[:, 2]
    feet.along[:, :, split:] = cos_wide * world[:, 2] - sin_wide * world[:, 1]
    depths = centre[:, 2] + cosine * ahead[:, 2] + sine * aside[:, 2]
    feet.hidden[:, split:] = depths < NEAREST_M
    feet.at_end[:, split:] = np.abs(angle) >= half


def _cross(a: FloatArray, b: FloatArray) -> FloatArray:
    """Cross products along axis 1; `numpy.cross` takes several times as long on small arrays."""
    found = np.empty(a.shape)
    found[:, 0] = a[:, 1] * b[:, 2] - a[:, 2] * b[:, 1]
    found[:, 1] = a[:, 2] * b[:, 0] - a[:, 0] * b[:, 2]
    found[:, 2] = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return found
