"""How surely a fit knows the ground: by hand, by drawing cameras, and against the truth."""

import math

import numpy as np
import pytest

from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    LOG_FOCAL,
    PAN,
    PARAMETERS,
    X,
    Z,
    camera_from_vector,
    homography_camera,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.residuals import homographies_from_corrections
from procc_annotator.calibration.prediction.uncertainty import (
    ACCURACY_LEVELS_M,
    GroundUncertainty,
    ground_sd,
    map_ground_uncertainty,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.errors import UsageError
from procc_annotator.metrics.ground_plane import field_rectangle

SIZE = (961, 541)
HEIGHT_M = 50.0
FOCAL_PX = 900.0


def straight_down(**sds: float) -> FitResult:
    """A camera above the field's centre, its parameters known to these standard deviations."""
    frame = ImageFrame(SIZE)
    vector = np.zeros(11)
    vector[Z], vector[LOG_FOCAL] = -HEIGHT_M, math.log(FOCAL_PX * frame.scale)
    names = PARAMETERS[: FREE_PARAMETERS["P"]]
    variances = [sds.get(name, 0.0) ** 2 for name in names]
    return FitResult(
        "P",
        SIZE,
        camera_from_vector(vector, frame),
        error_px=1.5,
        parameters=names,
        covariance=np.diag(variances),
        vector=vector,
    )


GROUND = np.array([(0.0, 0.0), (3.0, 4.0), (-12.0, 5.0), (0.5, -11.0)])
RADIUS = np.hypot(*GROUND.T)


def test_from_above_every_parameter_has_a_closed_form():
    """A metre of the camera is one of the ground; everything else grows from the nadir outwards."""
    for sds, expected in (
        ({"x": 0.3}, np.full(4, 0.3)),
        ({"x": 0.3, "y": 0.4}, np.full(4, 0.4)),  # in the worst direction, not of both together
        ({"z": 0.5}, RADIUS * 0.5 / HEIGHT_M),
        ({"log_focal": 0.01}, RADIUS * 0.01),
        ({"pan": 0.002}, RADIUS * 0.002),
    ):
        np.testing.assert_allclose(ground_sd(straight_down(**sds), GROUND), expected, atol=1e-6)
    turned = straight_down(pan=0.002).ground_covariance(GROUND[1:2])[0]
    across = np.array([-0.8, 0.6])  # about the nadir, so across the ray to the point
    np.testing.assert_allclose(turned, (RADIUS[1] * 0.002) ** 2 * np.outer(across, across), 1e-5)


def test_a_click_comes_on_top():
    metres_a_pixel = HEIGHT_M / FOCAL_PX
    found = ground_sd(straight_down(x=0.3), GROUND, click_px=2.0)
    np.testing.assert_allclose(found, math.hypot(0.3, 2.0 * metres_a_pixel), rtol=1e-5)


# With R+ tilt and principal point may change together by so much that to draw them from a normal
# distribution is not what the fit says: a tenth of it is.
@pytest.mark.parametrize(("model", "part"), [("H", 1.0), ("P", 1.0), ("R", 1.0), ("R+", 0.1)])
def test_as_cameras_drawn_from_the_covariance_scatter(views, field, model, part):
    fit = fit_camera(views.main(np.random.default_rng(5)).annotation, field, model=model)
    pixels = np.array([(120.0, 300.0), (500.0, 180.0), (700.0, 450.0), (300.0, 440.0)])
    meant = ground_from_px(fit.camera, pixels)
    assert field_rectangle(field).holds(meant).all()
    rng, frame, n = np.random.default_rng(6), ImageFrame(fit.size), len(fit.parameters)
    drawn = np.tile(fit.vector, (3000, 1))
    drawn[:, :n] += part * rng.multivariate_normal(np.zeros(n), fit.covariance, len(drawn))

    def seen(vector: np.ndarray) -> np.ndarray:
        if fit.basis is not None:
            matrix = homographies_from_corrections(vector[None], fit.basis)[0]
            return ground_from_px(homography_camera(matrix, frame), pixels)
        return ground_from_px(camera_from_vector(vector, frame), pixels)

    scatter = np.array([seen(vector) for vector in drawn])
    worst = [np.linalg.eigvalsh(np.cov(scatter[:, i].T))[-1] for i in range(len(pixels))]
    np.testing.assert_allclose(part * ground_sd(fit, meant), np.sqrt(worst), rtol=0.1)


def test_the_truth_lies_within_what_is_said(views, field):
    """Over cameras on all sides, with clicks 1 px off: neither boasting nor useless."""
    rng = np.random.default_rng(7)
    within, ratios = [], []
    for _ in range(25):
        view = views.random(rng)
        fit = fit_camera(view.annotation, field)
        if fit.camera is None:
            continue
        found = map_ground_uncertainty(fit, field)
        some = np.argwhere(found.in_sight)[::37]
        pixels = found.points_px[tuple(some.T)]
        said = found.sd_m[tuple(some.T)]
        fitted = np.column_stack((found.xs_m[some[:, 1]], found.ys_m[some[:, 0]]))
        error = np.hypot(*(ground_from_px(view.camera, pixels) - fitted).T)
        within.append(np.mean(error <= 2 * said))
        ratios.append(np.median(error / said))
    assert len(within) >= 23
    assert np.mean(within) > 0.9
    assert 0.2 < np.median(ratios) < 1.2


@pytest.fixture(scope="module")
def found(views, field) -> GroundUncertainty:
    fit = fit_camera(views.main(np.random.default_rng(8)).annotation, field, size=(1280, 720))
    return map_ground_uncertainty(fit, field)


class TestMap:
    def test_samples_are_where_they_say(self, found):
        row, column = np.argwhere(found.in_sight)[100]
        ground = (found.xs_m[column], found.ys_m[row])
        px, _ = found.fit.camera.project(np.array([[*ground, 0.0]]))
        np.testing.assert_allclose(found.points_px[row, column], px[0])
        alone = ground_sd(found.fit, np.array([ground]))[0]
        assert found.sd_m[row, column] == pytest.approx(alone)

    def test_only_the_field_in_sight_counts(self, found, field):
        rectangle = field_rectangle(field)
        assert rectangle.left <= found.xs_m[0] < found.xs_m[-1] <= rectangle.right
        assert rectangle.top <= found.ys_m[0] < found.ys_m[-1] <= rectangle.bottom
        assert max(np.diff(found.xs_m).max(), np.diff(found.ys_m).max()) <= 1
        shown = found.points_px[found.in_sight]
        assert (shown >= -0.5).all()
        assert (shown <= (1279.5, 719.5)).all()
        assert np.isfinite(found.sd_m[found.in_sight]).all()
        assert ((found.distance_to_border_px >= 0) == found.in_sight).all()

    def test_figures(self, found):
        values = found.sd_m[found.in_sight]
        spread = found.statistics
        assert (spread.minimum, spread.maximum) == (values.min(), values.max())
        assert spread.median == pytest.approx(np.median(values), rel=0.02)
        shares = [found.share_within_m(metres) for metres in (0.0, *ACCURACY_LEVELS_M, np.inf)]
        assert shares == sorted(shares)
        assert (shares[0], shares[-1]) == (0.0, 1.0)
        assert shares[2] == pytest.approx(np.mean(values <= 0.5), abs=0.02)


def test_closer_samples_where_little_is_in_sight(field):
    narrow = straight_down(x=0.1)
    vector = narrow.vector.copy()
    vector[LOG_FOCAL] += math.log(20)  # the picture is 2.7 m wide
    fit = FitResult(
        "P", SIZE, camera_from_vector(vector, ImageFrame(SIZE)),
        parameters=narrow.parameters, covariance=narrow.covariance, vector=vector,
    )  # fmt: skip
    found = map_ground_uncertainty(fit, field)
    assert found.in_sight.sum() > 500
    assert found.share_within_m(0.11) == 1.0


def test_nothing_in_sight_has_no_figures(field):
    fit = straight_down(x=0.1)
    vector = fit.vector.copy()
    vector[X] = 300.0
    away = FitResult(
        "P", SIZE, camera_from_vector(vector, ImageFrame(SIZE)),
        parameters=fit.parameters, covariance=fit.covariance, vector=vector,
    )  # fmt: skip
    found = map_ground_uncertainty(away, field)
    assert not found.in_sight.any()
    assert found.statistics.median is None
    assert found.share_within_m(1.0) is None


def test_points_out_of_sight_have_none(field):
    vector = np.zeros(11)
    vector[PAN], vector[1], vector[Z], vector[LOG_FOCAL] = 0.0, math.radians(80), -15.0, 7.0
    camera = camera_from_vector(vector, ImageFrame(SIZE))
    fit = FitResult(
        "P", SIZE, camera, parameters=PARAMETERS[:7], covariance=np.eye(7) * 1e-6, vector=vector
    )
    behind_and_ahead = np.array([(0.0, 60.0), (0.0, -60.0)])
    assert np.isnan(ground_sd(fit, behind_and_ahead)).tolist() == [True, False]
    failed = FitResult("R", SIZE, None, "2 elements, 3 needed")
    assert np.isnan(ground_sd(failed, GROUND)).all()
    with pytest.raises(UsageError, match="2 elements, 3 needed"):
        map_ground_uncertainty(failed, field)
