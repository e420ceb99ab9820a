"""Write a homography as .npy, so that reading it gives the same camera again."""

from __future__ import annotations

import io

import numpy as np

from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.io.camera_files.homography_file import CONVENTIONS, HOMOGRAPHY_SIZE

DEFAULT_CONVENTION = "carwc"  # what the suffix .npy stands for where nothing else is said


def write_homography(
    camera: HomographyCamera, size: tuple[int, int], convention: str = DEFAULT_CONVENTION
) -> bytes:
    """A homography as the content of a .npy file, picture to ground.

    Args:
        camera: in px of ``size``; the file holds those of a 1280 x 720 picture, as all such do.
        size: (width, height) px.
        convention: a key of `CONVENTIONS`: units and origin of the ground.

    Raises:
        ValueError: the homography cannot be inverted.
    """
    units_from_world = np.linalg.inv(CONVENTIONS[convention].world_from_units)
    image_from_world = camera.scaled(size, HOMOGRAPHY_SIZE).image_from_world
    try:
        matrix = units_from_world @ np.linalg.inv(image_from_world)
    except np.linalg.LinAlgError as error:
        raise ValueError("the homography cannot be inverted") from error
    matrix = matrix / np.abs(matrix).max()
    if not np.isfinite(matrix).all():
        raise ValueError("the homography cannot be inverted")
    buffer = io.BytesIO()
    np.save(buffer, matrix, allow_pickle=False)
    return buffer.getvalue()
