"""Cameras of basketball courts are found again from what they show of the court."""

import numpy as np
import pytest

from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.camera.base import Camera
from procc_annotator.field.load import load_field
from tests.bench.sports.court_cameras import fitted_back, read_cameras
from tests.bench.sports.views import Views

VIEWS = Views(load_field("basketball_fiba"))


@pytest.fixture(scope="module")
def cameras(shared_data) -> list[Camera]:
    return read_cameras(shared_data / "deepsportradar")


@pytest.mark.parametrize("every", [24, pytest.param(6, marks=pytest.mark.soak)])
def test_cameras_are_found_again(cameras, every):
    """Some; of all of them 97 % within 5 px, see `tests/bench/sports`."""
    errors, jacs = fitted_back(VIEWS, cameras[::every], "R+")
    assert np.mean(errors <= 5) >= 0.95
    assert np.mean(jacs) >= 0.95


def test_a_fit_goes_on_from_that_of_a_picture_cut_out(cameras):
    """The next click finds the principal point where it was."""
    camera = max(cameras[::8], key=lambda c: abs(c.principal_point_px[0] - 479.5) * c.focal_px[0])
    annotation = VIEWS.clicks(camera, np.random.default_rng(3))
    for model in ("R+", "auto"):
        first = fit_camera(annotation, VIEWS.field, model=model)
        assert abs(first.camera.principal_point_px[0] - 479.5) > 200
        again = fit_camera(annotation, VIEWS.field, model=model, start=first.camera)
        assert again.warm
        assert VIEWS.median_error(first.camera, again.camera) < 0.5
