"""Where cameras are looked for, and how far what a field's file says of it is believed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.field.model import CameraPlacement
from tests.bench.sports.views import Views


@pytest.mark.parametrize("model", ["P", "R+", "auto"])
@pytest.mark.parametrize("height", [13.0, 17.0])
def test_a_place_without_a_range_is_believed_but_not_to_the_metre(
    views, field, median_error, model, height
) -> None:
    """The camera is at 32 m and 14 m: the file may be right or somewhat off."""
    view = views.main(np.random.default_rng(5), noise_px=0.5, k1=0.0)
    exact = replace(field, cameras=CameraPlacement((30.0, 30.0, 30.0), (height, height, height)))
    fit = fit_camera(view.annotation, exact, model=model)
    assert fit.camera is not None, fit.failure
    assert median_error(view.camera, fit.camera) < 2
    assert abs(fit.camera.position_world[2] - view.camera.position_world[2]) < 1.5


def test_cameras_that_all_stand_at_one_distance_and_height_are_found(field) -> None:
    """As a field file may say; the study of every sport draws its cameras from there."""
    exact = Views(replace(field, cameras=CameraPlacement((30.0, 30.0, 30.0), (12.0, 12.0, 12.0))))
    view = exact.random(np.random.default_rng(2))
    assert view.camera.position_world[2] == -12
    fit = fit_camera(view.annotation, exact.field)
    assert exact.median_error(view.camera, fit.camera) < 5
