"""Temporal jitter of a shot: second differences of projections and of camera poses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import Camera, CameraOrProjections
from procc_annotator.camera.matrices import pinhole_from_homography
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.metrics.ground_plane import field_rectangle

SECOND_DIFFERENCE_SCALE = math.sqrt(6.0)  # a second difference is so many times one frame's error
_SAMPLE_STEPS = 120  # that the field's diagonal is cut into
_MIN_POINTS = 4


@dataclass(frozen=True, eq=False)
class ShotJitter:
    """Of each of the n frames of a shot; NaN where it or a neighbour has no camera.

    Attributes:
        px: (n,) how far the field's points in sight lie from where steady motion would have them,
            root mean square, px.
        ground_m: (n,) the same on the ground: how far away the pixels of these points then mean.
        step_px: (n,) how far they moved since the frame before, root mean square, px.
    """

    px: FloatArray
    ground_m: FloatArray
    step_px: FloatArray


def consecutive_neighbours(numbers: Sequence[int]) -> BoolArray:
    """(n,) which frames have one just before and one just after them, by the ascending numbers of
    the frames of a shot; they need not be every frame of a video, but where some are left out
    their neighbours do not follow each other. Ends are False."""
    found = np.zeros(len(numbers), dtype=bool)
    if len(numbers) > 2:
        steps = np.diff(numbers)
        follows = steps == typical_frame_step(numbers)
        found[1:-1] = follows[:-1] & follows[1:]
    return found


def typical_frame_step(numbers: Sequence[int]) -> int:
    """By how much the numbers of a shot's frames go up, as a rule."""
    steps, counts = np.unique(np.diff(numbers), return_counts=True)
    return int(steps[counts.argmax()]) if len(steps) else 1


def field_ground_points(field: Field) -> FloatArray:
    """(P, 3) metres: places evenly spaced along everything that a field has on the ground, optional
    elements left out. `UsageError` if it has nothing there."""
    around = field_rectangle(field)
    spacing = math.hypot(around.right - around.left, around.bottom - around.top) / _SAMPLE_STEPS
    samples = sample_evenly(field, spacing)
    rows = [i for i, e in enumerate(field.elements) if e.on_ground and not e.optional]
    every = range(len(field.elements))
    kept = rows or [i for i in every if field.elements[i].on_ground]
    return np.concatenate([samples.of(i) for i in kept])


def projection_jitter(
    cameras: Sequence[Camera | None],
    numbers: Sequence[int],
    points_world: FloatArray,
    size: tuple[int, int],
) -> ShotJitter:
    """Second differences of where the cameras of a shot show the field.

    Args:
        cameras: (n,) in px of ``size``, None for a frame without one.
        numbers: (n,) of the frames, ascending.
        points_world: (P, 3) metres, see `field_ground_points`.
        size: (width, height) px; the points that lie in the picture count.
    """
    count = len(cameras)
    px, ground, steps = (np.full(count, np.nan) for _ in range(3))
    seen = [_projected_in_front(camera, points_world) for camera in cameras]
    between = consecutive_neighbours(numbers)
    follows: BoolArray = np.diff(np.array(numbers), prepend=numbers[0]) == typical_frame_step(
        numbers
    )
    for i in range(1, count):
        if not follows[i]:
            continue
        steps[i] = _rms_or_nan(_nan_outside_image(seen[i], size) - seen[i - 1])
        camera = cameras[i]
        if not between[i] or camera is None:
            continue
        here = _nan_outside_image(seen[i], size)
        off = (seen[i - 1] - 2 * here + seen[i + 1]) / SECOND_DIFFERENCE_SCALE
        px[i] = _rms_or_nan(off)
        known = np.isfinite(off[:, 0])
        if known.sum() >= _MIN_POINTS:
            meant = ground_from_px(camera, here[known] - off[known])
            ground[i] = _rms_or_nan(meant - points_world[known, :2])
    return ShotJitter(px, ground, steps)


def shot_rms(values: FloatArray, left_out: BoolArray | None = None) -> float | None:
    """The root mean square of values (n,) over the frames of a shot that are not left out (n,),
    such as those of a jump; None where no frame has a value."""
    counted = np.isfinite(values) if left_out is None else np.isfinite(values) & ~left_out
    return float(np.sqrt(np.mean(values[counted] ** 2))) if counted.any() else None


def second_differences(values: FloatArray, numbers: Sequence[int]) -> FloatArray:
    """Second differences (n,) of a course (n,) or (n, d), NaN where a frame has no value, as the
    error of one frame: root of the summed squares over d; NaN where a neighbour is missing."""
    found: NDArray[np.float64] = np.full(len(values), np.nan)
    table = values.reshape(len(values), -1)
    at: IntArray = np.flatnonzero(consecutive_neighbours(numbers))
    off = (table[at - 1] - 2 * table[at] + table[at + 1]) / SECOND_DIFFERENCE_SCALE
    found[at] = np.sqrt((off**2).sum(axis=1))
    return found


def _projected_in_front(camera: Camera | None, points_world: FloatArray) -> FloatArray:
    if camera is None:
        return np.full((len(points_world), 2), np.nan)
    px, valid = camera.project(points_world)
    return np.where(valid[:, None], px, np.nan)


def _nan_outside_image(px: FloatArray, size: tuple[int, int]) -> FloatArray:
    """(P, 2) the same, NaN outside the picture."""
    with np.errstate(invalid="ignore"):
        outside = ((px < 0) | (px > np.array(size) - 1)).any(axis=1, keepdims=True)
    return np.where(outside, np.nan, px)


def _rms_or_nan(off: FloatArray) -> float:
    """Of lengths of (P, 2) differences; NaN where fewer than four are known."""
    squares = (off**2).sum(axis=1)
    known = squares[np.isfinite(squares)]
    return float(np.sqrt(known.mean())) if len(known) >= _MIN_POINTS else math.nan


@dataclass(frozen=True, eq=False)
class ShotPoses:
    """Of the n frames of a shot; NaN where there is no pose.

    Attributes:
        pan_deg, tilt_deg, roll_deg: (n,) without leaps of a whole turn.
        log_focal: (n,) natural logarithm of px.
        position_world: (n, 3) metres.
        implied: whether they follow from homographies, of square pixels and a centred lens.
    """

    pan_deg: FloatArray
    tilt_deg: FloatArray
    roll_deg: FloatArray
    log_focal: FloatArray
    position_world: FloatArray
    implied: bool


@dataclass(frozen=True)
class PoseJitter:
    """Second differences over a shot as the error of one frame; None where none is known.

    ``zoom`` is a share of the focal length.
    """

    pan_deg: float | None
    tilt_deg: float | None
    roll_deg: float | None
    zoom: float | None
    position_m: float | None


def shot_poses(cameras: Sequence[CameraOrProjections | None], size: tuple[int, int]) -> ShotPoses:
    """The poses of a shot's n cameras, in px of ``size``; of models without a pose only
    homographies imply one."""
    found = np.full((len(cameras), 7), np.nan)
    implied = False
    for row, camera in zip(found, cameras, strict=True):
        if isinstance(camera, HomographyCamera):
            implied = True
            camera = pinhole_from_homography(camera, size)
        if isinstance(camera, PinholeCamera | FisheyeCamera):
            angles = camera.pan_rad, camera.tilt_rad, camera.roll_rad
            row[:] = (*angles, np.log(camera.focal_px[0]), *camera.position_world)
    for column in range(3):
        known = np.isfinite(found[:, column])
        found[known, column] = np.rad2deg(np.unwrap(found[known, column]))
    return ShotPoses(found[:, 0], found[:, 1], found[:, 2], found[:, 3], found[:, 4:], implied)


def pose_jitter(poses: ShotPoses, numbers: Sequence[int], left_out: BoolArray) -> PoseJitter:
    """Return how unsteadily pan, tilt, roll, zoom and position go over a shot, by the ascending
    numbers of its frames; those left out (n,), such as those of a jump, do not count."""

    def of(values: FloatArray) -> float | None:
        return shot_rms(second_differences(values, numbers), left_out)

    return PoseJitter(
        of(poses.pan_deg),
        of(poses.tilt_deg),
        of(poses.roll_deg),
        of(poses.log_focal),
        of(poses.position_world),
    )


def without_bare_projections(cameras: Sequence[CameraOrProjections | None]) -> list[Camera | None]:
    """The same without those that are known by their projections alone."""
    return [camera if isinstance(camera, Camera) else None for camera in cameras]
