"""The pinhole camera that a homography implies: square pixels, a lens centred in the picture."""

from __future__ import annotations

import numpy as np

from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.matrices import angles_from_rotation
from procc_annotator.camera.pinhole import PinholeCamera


def pinhole_from_homography(camera: HomographyCamera, size: tuple[int, int]) -> PinholeCamera | None:
    """The camera whose ground plane a homography shows.

    The two axes of the ground are at right angles and equally long in the world; both conditions
    tell the focal length, here weighed together.

    Args:
        camera: in px of ``size``.
        size: (width, height) px, whose middle is the principal point.

    Returns:
        None where the two axes tell no focal length.
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
