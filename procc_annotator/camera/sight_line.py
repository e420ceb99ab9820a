"""The line in space that a pixel shows, and how a projection changes with the place: any model."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from procc_annotator.camera.base import BoolArray, Camera, FloatArray
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.camera.scaling import ScaledCamera
from procc_annotator.camera.undistort import rays_cam

_DIFFERENCE_STEP_M = 1e-3
_LINE_ITERATIONS = 40
_LINE_REACHED_PX = 1e-6
_LINE_ACCEPTED_PX = 1e-3
_MIN_STEP_SHARE = 1 / 64
# Where to look for a place that a pixel shows: about a field, from its ground to its roof.
_START_AXIS_M = np.array([-120.0, -70.0, -40.0, -20.0, -8.0, 0.0, 8.0, 20.0, 40.0, 70.0, 120.0])
_START_HEIGHTS_M = np.array([0.0, -3.0, -12.0, -40.0])
_START_COUNT = 6


class ViewingRay(NamedTuple):
    """A line in space: (3,) metres of a place on it, and (3,) its direction, a unit vector."""

    place: FloatArray
    direction: FloatArray


def viewing_ray(camera: Camera, point_px: FloatArray) -> ViewingRay | None:
    """The line whose points appear at a pixel.

    Exact for pinhole and fisheye cameras. For all others a place that appears there is searched
    by Newton's method; along the line the projection does not change, so its direction is what the
    derivatives there take to zero.

    Args:
        camera: any model that projects points off the ground.
        point_px: (2,) px.

    Returns:
        None where the model shows nothing at the pixel.
    """
    point_px = np.asarray(point_px, dtype=np.float64)
    if isinstance(camera, ScaledCamera):
        return viewing_ray(camera.camera, point_px / np.array(camera.factors))
    if isinstance(camera, PinholeCamera | FisheyeCamera):
        ray = camera.rotation_cam_from_world.T @ rays_cam(camera, point_px[None])[:, 0]
        length = float(np.linalg.norm(ray))
        if not (np.isfinite(length) and length > 0):
            return None
        return ViewingRay(np.array(camera.position_world), ray / length)
    return _ray_by_search(camera, point_px)


def projection_jacobian(camera: Camera, points_world: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Where places appear, and the derivatives by the place, from central differences.

    Args:
        camera: any model.
        points_world: (N, 3) metres.

    Returns:
        (N, 2) px and (N, 2, 3) px a metre; NaN where the camera shows nothing.
    """
    points = np.asarray(points_world, dtype=np.float64)
    steps = _DIFFERENCE_STEP_M * np.concatenate((np.zeros((1, 3)), np.eye(3), -np.eye(3)))
    px, shown = _project_or_nan(camera, (points[:, None] + steps).reshape(-1, 3))
    px = np.where(shown[:, None], px, np.nan).reshape(len(points), 7, 2)
    slopes = (px[:, 1:4] - px[:, 4:]) / (2 * _DIFFERENCE_STEP_M)
    return px[:, 0], slopes.transpose(0, 2, 1)


def _project_or_nan(camera: Camera, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
    px, shown = camera.project(points_world)
    return px, shown & np.isfinite(px).all(axis=1)


def _ray_by_search(camera: Camera, point_px: FloatArray) -> ViewingRay | None:
    x, y, z = np.meshgrid(_START_AXIS_M, _START_AXIS_M, _START_HEIGHTS_M)
    nodes = np.column_stack((x.ravel(), y.ravel(), z.ravel()))
    px, shown = _project_or_nan(camera, nodes)
    away = np.where(shown, ((px - point_px) ** 2).sum(axis=1), np.inf)
    for start in np.argsort(away, kind="stable")[:_START_COUNT]:
        if not np.isfinite(away[start]):
            break
        found = _newton_on_ray(camera, point_px, nodes[start])
        if found is not None:
            return found
    return None


def _newton_on_ray(camera: Camera, point_px: FloatArray, place: FloatArray) -> ViewingRay | None:
    """The nearest place of the line, by steps across it; shorter ones where one leads astray."""
    px, slopes = projection_jacobian(camera, place[None])
    for _ in range(_LINE_ITERATIONS):
        off = px[0] - point_px
        if not np.isfinite(slopes).all():
            return None
        if float(np.hypot(*off)) < _LINE_REACHED_PX:
            break
        step = -np.linalg.pinv(slopes[0]) @ off
        share = 1.0
        while share >= _MIN_STEP_SHARE:
            tried, tried_slopes = projection_jacobian(camera, (place + share * step)[None])
            if np.hypot(*(tried[0] - point_px)) < np.hypot(*off):  # False for NaN
                break
            share /= 2
        else:
            break
        place, px, slopes = place + share * step, tried, tried_slopes
    if not (float(np.hypot(*(px[0] - point_px))) < _LINE_ACCEPTED_PX and np.isfinite(slopes).all()):
        return None
    return ViewingRay(place, np.linalg.svd(slopes[0])[2][2])
