"""Convert between camera models and K, R, t, OpenCV distortion vectors and homographies."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.models import (
    FisheyeCamera,
    HomographyCamera,
    PinholeCamera,
    rotation_cam_from_world,
)

# |R R^T - 1| up to which a matrix counts as a rotation that was rounded on its way through a file;
# the nearest rotation is taken, as OpenCV does. Above the smaller figure the user is notified.
ROTATION_TOLERANCE = 1e-3
_ROTATION_WARNING_TOLERANCE = 1e-5
DISTORTION_LENGTHS = (0, 4, 5, 8, 12, 14)
# A skew is left out when it moves no pixel of the picture by more than this.
SKEW_TOLERANCE_PX = 0.01
_GIMBAL_LOCK_TOLERANCE = 1e-12
_SINGULAR = 1e15  # condition of a matrix that is not inverted any more
_ROUNDED_SKEW = 1e-9  # of the focal length: what taking a matrix apart leaves of none


@dataclass(frozen=True)
class Intrinsics:
    """The calibration matrix, taken apart; notices are remarks for the user."""

    focal_px: tuple[float, float]
    principal_point_px: tuple[float, float]
    notices: tuple[str, ...] = ()


@dataclass(frozen=True)
class CameraPose:
    """Orientation and position in this project's terms; notices are remarks for the user."""

    pan_rad: float
    tilt_rad: float
    roll_rad: float
    position_world: tuple[float, float, float]
    notices: tuple[str, ...] = ()

    @property
    def values(self) -> tuple[float, float, float, tuple[float, float, float]]:
        """Pan, tilt, roll and position, as the camera models take them."""
        return self.pan_rad, self.tilt_rad, self.roll_rad, self.position_world


def focal_warnings(fx: float, fy: float) -> tuple[str, ...]:
    """Return what a person should see of focal lengths, px: no lens has negative ones, though a
    file may mean a turned picture by them, and they are taken as they are."""
    if fx > 0 and fy > 0:
        return ()
    shown = "upside down" if fx > 0 else "left for right"
    if fx < 0 and fy < 0:
        shown = "turned by 180 degrees"
    return (f"negative focal length: shows everything {shown} (is the sign right?)",)


def intrinsics_from_matrix(k: FloatArray, size: tuple[int, int] | None = None) -> Intrinsics:
    """Focal lengths and principal point of a calibration matrix.

    Args:
        k: (3, 3) [[fx, skew, cx], [0, fy, cy], [0, 0, s]]; divided by s.
        size: (width, height) px of the picture; twice the principal point where it is not known.

    Raises:
        ValueError: not such a matrix, or a skew that moves a pixel by more than 0.01 px: no model
            here has one.
    """
    if k.shape != (3, 3) or not np.isfinite(k).all():
        raise ValueError("K is not 3 x 3 finite numbers")
    scale = float(np.abs(k[:2]).max())
    if k[2, 2] == 0 or max(abs(k[1, 0]), abs(k[2, 0]), abs(k[2, 1])) > 1e-9 * max(scale, 1.0):
        raise ValueError("K is not of the form [[fx, 0, cx], [0, fy, cy], [0, 0, 1]]")
    with np.errstate(over="ignore"):
        k = k / k[2, 2]
    fx, fy, cx, cy = (float(v) for v in (k[0, 0], k[1, 1], k[0, 2], k[1, 2]))
    if fx == 0 or fy == 0 or not np.isfinite(k).all():
        raise ValueError("a focal length in K is zero or without bounds")
    moved = skew_px(k, size)
    if moved > SKEW_TOLERANCE_PX:
        raise ValueError(f"K has a skew, which moves pixels by up to {moved:.2g} px; none is known")
    notices = focal_warnings(fx, fy)
    if moved > 0:
        notices = (
            *notices,
            f"the skew in K is left out (it moves no pixel by {SKEW_TOLERANCE_PX} px)",
        )
    return Intrinsics((fx, fy), (cx, cy), notices)


def skew_px(k: FloatArray, size: tuple[int, int] | None = None) -> float:
    """By how much the skew of a calibration matrix moves a pixel at most; as above, K[2, 2] = 1."""
    fy, cy = abs(float(k[1, 1])), float(k[1, 2])
    height = size[1] if size else 2 * abs(cy) + 1
    return abs(float(k[0, 1])) * max(abs(cy), abs(height - 1 - cy)) / fy


def decompose_projection(projection: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """K, R and t of a projection matrix, which is K [R | t] times any number but 0.

    The sign of the matrix says nothing: R is a rotation and the focal lengths are positive.

    Args:
        projection: (3, 4), homogeneous world -> homogeneous px.

    Returns:
        (3, 3) K with K[2, 2] = 1; (3, 3) R; (3,) t, in the world's units.

    Raises:
        ValueError: not finite, or its left 3 x 3 part cannot be inverted: no camera with a place.
    """
    if projection.shape != (3, 4) or not np.isfinite(projection).all():
        raise ValueError("the projection matrix is not 3 x 4 finite numbers")
    p = projection / (np.abs(projection[:, :3]).max() or 1.0)
    if not np.isfinite(p).all() or np.linalg.cond(p[:, :3]) > _SINGULAR:
        raise ValueError(
            "the projection matrix is of no camera with a place (its left 3 x 3 part"
            " cannot be inverted)"
        )
    # An upper triangle times a rotation: the QR decomposition of the matrix read backwards.
    q, r = np.linalg.qr(p[::-1, :3].T)
    k, rotation = r.T[::-1, ::-1], q.T[::-1]
    signs = np.where(np.diag(k) < 0, -1.0, 1.0)
    k, rotation = np.triu(k * signs), signs[:, None] * rotation
    t = np.linalg.solve(k, p[:, 3])
    if np.linalg.det(rotation) < 0:
        rotation, t = -rotation, -t
    k = k / k[2, 2]
    if abs(k[0, 1]) <= _ROUNDED_SKEW * abs(k[0, 0]):
        k[0, 1] = 0.0
    return k, rotation, t


def pose_from_rt(rotation: FloatArray, t: FloatArray) -> CameraPose:
    """Orientation and position of x_cam = R x_world + t.

    Args:
        rotation: (3, 3), world -> camera.
        t: (3,) metres.

    Raises:
        ValueError: R is no rotation within `ROTATION_TOLERANCE`, or mirrors.
    """
    if rotation.shape != (3, 3) or not np.isfinite(rotation).all():
        raise ValueError("R is not 3 x 3 finite numbers")
    if t.shape != (3,) or not np.isfinite(t).all():
        raise ValueError("t is not 3 finite numbers")
    with np.errstate(over="ignore", invalid="ignore"):
        off = float(np.abs(rotation @ rotation.T - np.eye(3)).max())
    if not off <= ROTATION_TOLERANCE:
        raise ValueError(
            f"R is no rotation: R times its transpose differs from 1 by {off:.2g}"
            f" (up to {ROTATION_TOLERANCE:g} is taken for rounding)"
        )
    if np.linalg.det(rotation) < 0:
        raise ValueError("R is no rotation: it mirrors (determinant -1)")
    u, _, vt = np.linalg.svd(rotation)
    nearest = np.asarray(u @ vt, dtype=np.float64)
    notices: tuple[str, ...] = ()
    if off > _ROTATION_WARNING_TOLERANCE:
        notices = ("R is not exactly a rotation; the nearest one is taken",)
    with np.errstate(over="ignore", invalid="ignore"):
        position = -nearest.T @ t
    if not np.isfinite(position).all():
        raise ValueError("t is without bounds")
    x, y, z = position.tolist()
    return CameraPose(*angles_from_rotation(nearest), (x, y, z), notices)


def angles_from_rotation(rotation: FloatArray) -> tuple[float, float, float]:
    """The angles (rad) whose `rotation_cam_from_world` is this rotation (3, 3), world -> camera.

    Tilt is in [0, pi]. Looking straight down or up only the sum or difference of pan and roll
    counts; roll is 0 then.
    """
    r = rotation
    sine = math.hypot(r[2, 0], r[2, 1])
    tilt = math.atan2(sine, r[2, 2])
    level = sine < _GIMBAL_LOCK_TOLERANCE
    pan = math.atan2(r[0, 1], r[0, 0]) if level else math.atan2(r[2, 0], -r[2, 1])
    # What is left of the rotation, rather than its own two entries: so that near the vertical the
    # errors of pan and roll, each large there, cancel.
    rolled = r @ rotation_cam_from_world(pan, tilt, 0.0).T
    return pan, tilt, math.atan2(rolled[0, 1], rolled[0, 0])


def pinhole_from_parts(
    inside: Intrinsics, pose: CameraPose, distortion: Sequence[float]
) -> PinholeCamera:
    """A pinhole camera with one of OpenCV's distortion vectors.

    Args:
        distortion: k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4 [tau_x tau_y]]]], or nothing.

    Raises:
        ValueError: another length, no finite numbers, or a tilted sensor (tau).
    """
    count = len(distortion)
    if count not in DISTORTION_LENGTHS:
        raise ValueError(f"the distortion has {count} entries, expected 4, 5, 8, 12 or 14")
    if not np.isfinite(distortion).all():
        raise ValueError("the distortion is not finite numbers")
    d = [*map(float, distortion), *[0.0] * (14 - count)]
    if d[12] or d[13]:
        raise ValueError("the distortion tilts the sensor (tau_x, tau_y); no model here does")
    k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4 = d[:12]
    return PinholeCamera(
        *pose.values, inside.focal_px, inside.principal_point_px,
        (k1, k2, k3, k4, k5, k6), (p1, p2), (s1, s2, s3, s4),
    )  # fmt: skip


def fisheye_from_parts(
    inside: Intrinsics, pose: CameraPose, distortion: Sequence[float]
) -> FisheyeCamera:
    """A fisheye camera with OpenCV's k1..k4, or none; `ValueError` for another number of
    coefficients, or no finite ones."""
    if len(distortion) not in (0, 4):
        raise ValueError(f"a fisheye distortion has 4 entries, found {len(distortion)}")
    if not np.isfinite(distortion).all():
        raise ValueError("the distortion is not finite numbers")
    k1, k2, k3, k4 = (*map(float, distortion), *[0.0] * (4 - len(distortion)))
    return FisheyeCamera(*pose.values, inside.focal_px, inside.principal_point_px, (k1, k2, k3, k4))


def distortion_vector(camera: PinholeCamera) -> tuple[float, ...]:
    """OpenCV's distortion vector of a pinhole camera: 5, 8 or 12 entries, as many as it needs."""
    k1, k2, k3, *rational = camera.radial
    shortest = (k1, k2, *camera.tangential, k3)
    if any(camera.thin_prism):
        return (*shortest, *rational, *camera.thin_prism)
    return (*shortest, *rational) if any(rational) else shortest


def calibration_matrix(camera: PinholeCamera | FisheyeCamera) -> FloatArray:
    """(3, 3) K."""
    (fx, fy), (cx, cy) = camera.focal_px, camera.principal_point_px
    return np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])


def translation(camera: PinholeCamera | FisheyeCamera) -> FloatArray:
    """(3,) t of x_cam = R x_world + t."""
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(-camera.rotation_cam_from_world @ np.array(camera.position_world))


def pinhole_from_homography(
    camera: HomographyCamera, size: tuple[int, int]
) -> PinholeCamera | None:
    """The camera of a homography of the ground, in px of a picture of this (width, height) with the
    principal point in its middle; None where the homography's axes determine no focal length.

    The two axes of the ground are at right angles and equally long in the world; both conditions
    give the focal length, here weighed together.
    """
    cx, cy = (size[0] - 1) / 2, (size[1] - 1) / 2
    centred = np.array([[1.0, 0.0, -cx], [0.0, 1.0, -cy], [0.0, 0.0, 1.0]])
    h = centred @ camera.image_from_world
    (a, b), (c, d), (e, f) = h[:, :2].tolist()
    # (a b + c d) / focal^2 + e f = 0, and (a^2 + c^2 - b^2 - d^2) / focal^2 + e^2 - f^2 = 0; twice
    # the first weighs as much as the second however the ground's axes are turned.
    over = np.array([2 * (a * b + c * d), a * a + c * c - b * b - d * d])
    alone = np.array([2 * e * f, e * e - f * f])
    inverse_square = -float(over @ alone) / max(float(over @ over), 1e-300)
    if not 0 < inverse_square < np.inf:
        return None
    focal = 1 / np.sqrt(inverse_square)
    axes = h / np.array([focal, focal, 1.0])[:, None]
    scale = np.linalg.norm(axes[:, :2], axis=0).mean()
    x, y, t = (axes / scale).T
    near = np.stack((x, y, np.cross(x, y)), axis=1)
    left, _, right = np.linalg.svd(near)
    rotation = left @ right
    if np.linalg.det(rotation) < 0:
        return None
    position = -rotation.T @ t
    pan, tilt, roll = angles_from_rotation(rotation)
    px, py, pz = (float(value) for value in position)
    return PinholeCamera(pan, tilt, roll, (px, py, pz), (float(focal), float(focal)), (cx, cy))
