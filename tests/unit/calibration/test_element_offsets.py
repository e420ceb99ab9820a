"""What elements lie beside the model by is told from the residuals, and the camera is no surer."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization.covariance import PRIOR_OFFSET_PX
from procc_annotator.calibration.prediction.ghosts import find_ghosts

SIZE = (960, 540)
PLACES = np.array([(-40.0, 5.0, 0.0), (-20.0, -30.0, 0.0), (-52.5, 0.0, -2.44)])


def beside(annotation: FrameAnnotation, rng: np.random.Generator, by_px: float) -> FrameAnnotation:
    """Every element as a whole a little beside where it was clicked."""
    moved = []
    for polyline in annotation:
        points = points_px(polyline, SIZE) + rng.normal(0, by_px, 2)
        moved.append(
            Polyline(polyline.class_name, tuple(point_from_px(x, y, SIZE) for x, y in points))
        )
    return FrameAnnotation(tuple(moved))


def test_the_offsets_of_elements_are_told_from_the_noise_of_clicks(views, field):
    rng = np.random.default_rng(1)
    truth = views.main(rng).camera
    said: dict[float, list[float]] = {0.0: [], 2.0: []}
    for by_px, found in said.items():
        for _ in range(25):
            clicked = beside(views.clicks(truth, rng, 0.7), rng, by_px)
            fit = fit_camera(clicked, field, model="R")
            found.append(fit.offset_px)
    assert np.median(said[0.0]) < PRIOR_OFFSET_PX
    assert 1.0 < np.median(said[2.0]) < 2.5


@pytest.mark.parametrize("model", ["H", "P", "R", "R+"])
def test_what_the_residuals_say_of_the_model_is_in_every_deviation(views, field, model):
    rng = np.random.default_rng(2)
    clicked = beside(views.main(rng, noise_px=0.7, k1=0.0).annotation, rng, 2.0)
    fit = fit_camera(clicked, field, model=model)
    more = np.linalg.eigvalsh(fit.covariance - fit.of_clicks)
    assert more.min() > -1e-9 * more.max()
    assert more.max() > 0
    shown = fit.projected_sd(PLACES[:2])
    slopes_alone = np.sqrt(np.diag(fit.of_clicks))
    assert (np.sqrt(np.diag(fit.covariance)) >= slopes_alone).all()
    assert np.isfinite(shown).all()
    if fit.deviations is not None:
        assert fit.deviations.pan_rad == pytest.approx(np.sqrt(fit.covariance[0, 0]))


@pytest.mark.parametrize("noise_px", [0.3, 1.0, 2.5])
def test_standard_deviations_follow_the_clicks(views, field, noise_px):
    """Root mean square of error over standard deviation is 1 where they are right."""
    rng = np.random.default_rng(3)
    ratios, clicks = [], []
    for _ in range(40):
        view = views.main(rng, noise_px=noise_px, k1=0.0)
        fit = fit_camera(view.annotation, field, model="P")
        true, found, sd = view.camera, fit.camera, fit.deviations
        place = np.subtract(found.position_world, true.position_world) / sd.position_m
        pan = (found.pan_rad - true.pan_rad + np.pi) % (2 * np.pi) - np.pi
        tilt = (found.tilt_rad - true.tilt_rad) / sd.tilt_rad
        focal = (found.focal_px[0] - true.focal_px[0]) / sd.focal_px
        ratios.append((pan / sd.pan_rad, tilt, focal, np.sqrt(np.mean(place**2))))
        clicks.append(fit.error_px)
    assert np.median(clicks) == pytest.approx(noise_px, rel=0.15)
    typical = np.sqrt(np.mean(np.square(ratios), axis=0))
    assert (typical > 0.75).all()
    assert (typical < 1.3).all()


def test_a_ghost_may_lie_beside_the_model_as_the_others_do(views, field):
    rng = np.random.default_rng(3)
    clicked = views.main(rng, noise_px=0.7).annotation
    left = clicked.without("Small rect. left main")
    fit = fit_camera(left, field)
    (ghost,) = [g for g in find_ghosts(left, field, fit) if g.name == "Small rect. left main"]
    assert fit.offset_px > 0
    assert min(piece.sd_px.min() for piece in ghost.pieces) > fit.offset_px


def test_three_elements_tell_nothing_of_offsets(views, field):
    annotation = views.main(np.random.default_rng(4)).annotation
    fit = fit_camera(FrameAnnotation(annotation.polylines[:3]), field)
    if fit.camera is not None:
        assert fit.offset_px == pytest.approx(PRIOR_OFFSET_PX, abs=0.3)
