"""From a pixel back to the ground, for any camera model."""

from __future__ import annotations

from typing import cast

import numpy as np

from procc_annotator.camera.base import FloatArray
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.ground_search import ground_by_newton
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import NEAREST_DEPTH_M, PinholeCamera
from procc_annotator.camera.projections import CameraOrProjections, ElementProjections
from procc_annotator.camera.scaling import ScaledCamera
from procc_annotator.camera.undistort import rays_cam


def ground_from_px(camera: CameraOrProjections, points_px: FloatArray) -> FloatArray:
    """The world points on the ground (z = 0) that pixels show.

    Exact to 1e-6 m inside the picture: rays for pinhole and fisheye cameras, the matrix for
    homographies, a model's own ``ground_from_px`` where it has one, and a search for all others.

    Args:
        camera: any source; projections alone have no ground.
        points_px: (N, 2) px.

    Returns:
        (N, 2) metres (x, y), NaN for pixels that do not show the ground.
    """
    points_px = np.asarray(points_px, dtype=np.float64)
    if isinstance(camera, ElementProjections):
        return np.full((len(points_px), 2), np.nan)
    if isinstance(camera, PinholeCamera | FisheyeCamera):
        return _intersect_rays_with_ground(camera, points_px)
    if isinstance(camera, ScaledCamera):
        return ground_from_px(camera.camera, points_px / np.array(camera.factors))
    if callable(getattr(camera, "ground_from_px", None)):
        return np.asarray(cast(HomographyCamera, camera).ground_from_px(points_px))
    return ground_by_newton(camera, points_px)


def _intersect_rays_with_ground(camera: PinholeCamera | FisheyeCamera, points_px: FloatArray) -> FloatArray:
    rays = rays_cam(camera, points_px)
    rotation, position = camera.rotation_cam_from_world, camera.position_world
    with np.errstate(all="ignore"):
        along_x, along_y, down = rotation.T @ rays
        distance = -position[2] / down
        # What is nearer than this counts as behind the camera.
        distance[~((distance > 0) & (distance * rays[2] > NEAREST_DEPTH_M))] = np.nan
        ground = np.empty((len(points_px), 2))
        ground[:, 0] = position[0] + distance * along_x
        ground[:, 1] = position[1] + distance * along_y
        ground[~np.isfinite(ground).all(axis=1)] = np.nan
    return ground
