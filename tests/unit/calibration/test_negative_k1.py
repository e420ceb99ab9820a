"""Wide lenses with barrel distortion are fitted, and nothing else is taken for one."""

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization.camera_parameters import KAPPA, MIN_KAPPA
from procc_annotator.calibration.prediction.uncertainty import map_ground_uncertainty
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from tests.bench.sports.views import SIZE, Views

COURT = Views(load_field("basketball_fiba"))
HALF_DIAGONAL = float(np.hypot(959, 539) / 2)


def wide(k1: float = -0.1, focal: float = 650.0) -> PinholeCamera:
    """On a stand beside the court, with most of it in sight."""
    return PinholeCamera(
        np.deg2rad(-8), np.deg2rad(72), np.deg2rad(0.5), (2.0, 15.0, -6.0), (focal, focal),
        (479.5, 269.5), (k1, 0.0, 0.0, 0.0, 0.0, 0.0),
    )  # fmt: skip


def clicked(camera: PinholeCamera, seed: int = 0) -> FrameAnnotation:
    return COURT.clicks(camera, np.random.default_rng(seed))


def swapped(annotation: FrameAnnotation, rng: np.random.Generator) -> FrameAnnotation:
    """Two labels changed places."""
    own = list(annotation.polylines)
    i, j = rng.permutation(len(own))[:2].tolist()
    names = own[i].class_name, own[j].class_name
    own[i], own[j] = Polyline(names[1], own[i].points), Polyline(names[0], own[j].points)
    return FrameAnnotation(tuple(own))


@pytest.mark.parametrize("model", ["R", "R+", "auto"])
def test_a_wide_lens_is_fitted(model):
    for k1 in (-0.06, -0.15):
        fit = fit_camera(clicked(wide(k1)), COURT.field, model=model)
        assert fit.camera.radial[0] == pytest.approx(k1, abs=0.02)
        assert COURT.median_error(wide(k1), fit.camera) < 0.6
        assert not fit.left_out


def test_a_pinhole_has_no_distortion_all_the_same():
    assert fit_camera(clicked(wide()), COURT.field, model="P").camera.radial[0] == 0


@pytest.mark.parametrize("model", ["R", "R+", "auto"])
def test_other_cameras_are_never_taken_for_one(views, field, model):
    """Neither without distortion nor with the other kind, be a label wrong or not."""
    rng = np.random.default_rng(5)
    for k1 in (0.0, 0.1):
        for _ in range(2):
            annotation = views.random(rng, k1=k1, at_least=6).annotation
            for given in (annotation, swapped(annotation, rng)):
                assert fit_camera(given, field, model=model).vector[KAPPA] >= 0


def test_the_coefficient_is_bounded():
    """kappa = -0.14, which the picture's corners can just bear."""
    camera = wide(-0.14 * (650 / HALF_DIAGONAL) ** 2)
    fit = fit_camera(clicked(camera), COURT.field)
    assert fit.vector[KAPPA] == MIN_KAPPA
    assert COURT.median_error(camera, fit.camera) < 4


@pytest.mark.parametrize("model", ["R", "auto"])
def test_the_next_click_goes_on_from_it(model):
    first = fit_camera(clicked(wide()), COURT.field, model=model)
    again = fit_camera(clicked(wide(), 1), COURT.field, model=model, start=first.camera)
    assert again.warm
    assert COURT.median_error(wide(), again.camera) < 0.6


@pytest.mark.parametrize("model", ["R", "auto"])
def test_it_is_given_up_where_the_points_no_longer_demand_it(model):
    ordinary = clicked(wide(0.0))
    start = replace(wide(), radial=(-0.03, 0.0, 0.0, 0.0, 0.0, 0.0))
    fit = fit_camera(ordinary, COURT.field, model=model, start=start)
    cold = fit_camera(ordinary, COURT.field, model=model)
    assert fit.vector[KAPPA] >= 0
    assert COURT.median_error(cold.camera, fit.camera) < 0.05


def test_nothing_is_folded_back_into_the_picture():
    """A camera so near that half the court lies far beside its picture."""
    true = replace(wide(-0.18, 700.0), position_world=(2.0, 10.0, -3.0), tilt_rad=np.deg2rad(80))
    fit = fit_camera(clicked(true), COURT.field)
    assert fit.camera.radial[0] < -0.1
    shown = {one.name for one in visible_stretches(COURT.field, fit.camera, SIZE)}
    seen = {one.name for one in visible_stretches(COURT.field, true, SIZE)}
    # Where they would be without distortion.
    px, in_front = replace(fit.camera, radial=(0.0,) * 6).project(COURT.ground)
    beyond = in_front & (np.hypot(*(px - (479.5, 269.5)).T) > 1200)
    assert beyond.any()
    assert not fit.camera.project(COURT.ground)[1][beyond].any()
    assert len(shown ^ seen) <= 1


def test_uncertainty_is_known_where_it_is_shown_and_nowhere_else():
    true = replace(wide(-0.18, 700.0), position_world=(2.0, 10.0, -3.0), tilt_rad=np.deg2rad(80))
    rng = np.random.default_rng(4)
    fits = [fit_camera(COURT.clicks(true, rng), COURT.field) for _ in range(25)]
    fit = fits[0]
    shown = fit.camera.project(COURT.ground)[1]
    sd = fit.projected_sd(COURT.ground)
    assert 0 < shown.sum() < len(shown)
    np.testing.assert_array_equal(np.isfinite(sd), shown)
    places = np.array([(0.0, 0.0, 0.0), (3.0, -5.0, 0.0), (5.0, 0.0, 0.0)])
    scatter = np.hypot(*np.array([f.camera.project(places)[0] for f in fits]).std(axis=0).T)
    expected = np.median([f.projected_sd(places) for f in fits], axis=0)
    assert (expected > 0.6 * scatter).all()
    assert (expected < 3 * scatter).all()
    known = map_ground_uncertainty(fit, COURT.field)
    assert known.statistics.median < 0.1
