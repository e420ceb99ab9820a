"""From a pixel back to the ground."""

from __future__ import annotations

import cv2
import numpy as np

from procc_annotator.camera.base import Camera, FloatArray
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import PinholeCamera

_AGREES_PX = 0.05


def ground_from_px(camera: Camera, points_px: FloatArray) -> FloatArray | None:
    """The world points on the ground (z = 0) that pixels show.

    Distortion is removed iteratively (`cv2.undistortPoints`); where the iteration did not converge
    (its result does not project back to the pixel) the answer is NaN rather than a guess.

    Args:
        camera: a homography or a pinhole camera.
        points_px: (N, 2) px.

    Returns:
        (N, 2) metres (x, y), NaN for pixels that do not show the ground; None for other models.
    """
    if isinstance(camera, HomographyCamera):
        return camera.ground_from_px(points_px)
    if not isinstance(camera, PinholeCamera):
        return None
    rays_world = _rays_cam(camera, points_px) @ camera.rotation_cam_from_world
    position = np.array(camera.position_world)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        distance = -position[2] / rays_world[:, 2]
        ground = position[:2] + distance[:, None] * rays_world[:, :2]
    ground[~(distance > 0)] = np.nan
    known = np.isfinite(ground).all(axis=1)
    points_world = np.column_stack([np.where(known[:, None], ground, 0.0), np.zeros(len(ground))])
    back, valid = camera.project(points_world)
    ground[~valid | (np.abs(back - points_px).max(axis=1) > _AGREES_PX)] = np.nan
    return np.asarray(ground, dtype=np.float64)


def _rays_cam(camera: PinholeCamera, points_px: FloatArray) -> FloatArray:
    normalised = (points_px - np.array(camera.principal_point_px)) / np.array(camera.focal_px)
    if camera.is_distorted and len(points_px):
        k = camera.radial
        distortion = np.array([*k[:2], *camera.tangential, *k[2:], *camera.thin_prism])
        criteria = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 40, 1e-10)
        undistorted = cv2.undistortPoints(
            normalised[:, None, :], np.eye(3), distortion, criteria=criteria
        )
        normalised = np.asarray(undistorted, dtype=np.float64)[:, 0, :]
    return np.column_stack([normalised, np.ones(len(normalised))])
