"""A written homography is read back as the same camera, in every convention."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.io.camera_files.homography_file import (
    CONVENTIONS,
    HOMOGRAPHY_SIZE,
    read_homography,
)
from procc_annotator.io.camera_files.homography_writer import write_homography

# A main camera's view; the ground in front of it lies below the horizon, as in every such picture.
CAMERA = HomographyCamera(
    np.array([[1400.0, -96.0, 35000.0], [0.0, 60.0, 15000.0], [0.0, -0.98, 65.0]])
)
GROUND = np.array([(0.0, 0.0, 0.0), (40.0, 20.0, 0.0), (-30.0, 30.0, 0.0)])


@pytest.mark.parametrize("convention", CONVENTIONS)
@pytest.mark.parametrize("size", [(960, 540), HOMOGRAPHY_SIZE])
def test_round_trip(convention, size) -> None:
    data = write_homography(CAMERA, size, convention)
    loaded = read_homography(data, path="a.npy", convention=convention)
    back = loaded.camera.scaled(loaded.size, size)
    expected, valid = CAMERA.project(GROUND)
    shown, again = back.project(GROUND)
    assert valid.all()
    assert again.all()
    np.testing.assert_allclose(shown, expected, atol=1e-8)


def test_a_singular_one_is_refused() -> None:
    with pytest.raises(ValueError, match="cannot be inverted"):
        write_homography(HomographyCamera(np.ones((3, 3))), (960, 540))
