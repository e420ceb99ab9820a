"""What the cameras of a shot say of where the camera stands, how it turns and how far it zooms."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.implied import pinhole_from_homography
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.metric.over_time.steadiness import shot_rms, second_differences
from procc_annotator.metric.polylines import BoolArray, FloatArray

_MIN_FRAMES = 5  # frames that say anything of a relation
_MIN_TRAVEL_M, _MIN_ZOOM = 0.01, 1e-3  # below them nothing is traded


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


@dataclass(frozen=True)
class PositionDrift:
    """How far the position moves about over a shot, metres from its median.

    Attributes:
        rms_m: root mean square.
        largest_m: of the frame that is farthest away.
    """

    rms_m: float
    largest_m: float


@dataclass(frozen=True)
class FocalDistanceAmbiguity:
    """Position against focal length: an error in one is made up for by the other.

    Attributes:
        correlation: of the way back along the axis and the logarithm of the focal length, -1 to 1;
            near 1 the camera backs off as it zooms in, and the picture hardly changes.
        metres_a_percent: how far it backs off for each percent of focal length.
    """

    correlation: float
    metres_per_percent: float


def shot_poses(cameras: Sequence[CameraOrProjections | None], size: tuple[int, int]) -> ShotPoses:
    """The poses of a shot's cameras.

    Args:
        cameras: (n,) in px of ``size``; of models without a pose only homographies imply one.
        size: (width, height) px.
    """
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
    """How unsteadily pan, tilt, roll, zoom and position go over a shot.

    Args:
        poses: of its frames.
        numbers: (n,) of the frames, ascending.
        left_out: (n,) frames that do not count, such as those of a jump.
    """

    def of(values: FloatArray) -> float | None:
        return shot_rms(second_differences(values, numbers), left_out)

    return PoseJitter(
        of(poses.pan_deg),
        of(poses.tilt_deg),
        of(poses.roll_deg),
        of(poses.log_focal),
        of(poses.position_world),
    )


def position_drift(poses: ShotPoses) -> PositionDrift | None:
    """How far the position moves about; None where no frame has one."""
    known = poses.position_world[np.isfinite(poses.position_world).all(axis=1)]
    if not len(known):
        return None
    off = np.linalg.norm(known - np.median(known, axis=0), axis=1)
    return PositionDrift(float(np.sqrt(np.mean(off**2))), float(off.max()))


def offsets_along_axis(poses: ShotPoses) -> FloatArray:
    """(n,) metres that each camera stands behind the shot's median position, along its axis."""
    pan, tilt = np.deg2rad(poses.pan_deg), np.deg2rad(poses.tilt_deg)
    axis = np.stack((np.sin(pan) * np.sin(tilt), -np.cos(pan) * np.sin(tilt), np.cos(tilt)), axis=1)
    known = np.isfinite(poses.position_world).all(axis=1)
    if not known.any():
        return np.full(len(pan), np.nan)
    off = poses.position_world - np.median(poses.position_world[known], axis=0)
    return np.asarray(-(off * axis).sum(axis=1), dtype=np.float64)


def focal_distance_ambiguity(poses: ShotPoses) -> FocalDistanceAmbiguity | None:
    """How position and focal length make up for each other; None where one of them stays."""
    back, zoom = offsets_along_axis(poses), poses.log_focal
    known = np.isfinite(back) & np.isfinite(zoom)
    if known.sum() < _MIN_FRAMES:
        return None
    back, zoom = back[known] - back[known].mean(), zoom[known] - zoom[known].mean()
    way, zoomed = float(back.std()), float(zoom.std())
    if way < _MIN_TRAVEL_M or zoomed < _MIN_ZOOM:
        return None
    together = float((back * zoom).mean())
    return FocalDistanceAmbiguity(together / (way * zoomed), together / zoomed**2 / 100)


def without_bare_projections(cameras: Sequence[CameraOrProjections | None]) -> list[Camera | None]:
    """The same without those that are known by their projections alone."""
    return [camera if isinstance(camera, Camera) else None for camera in cameras]
