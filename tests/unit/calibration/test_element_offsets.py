"""Errors of clicks, and errors that all points of an element share, are told apart, and standard
deviations hold."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.prediction.ghosts import find_ghosts
from procc_annotator.camera.models import PinholeCamera

SIZE = (960, 540)


def beside(annotation: FrameAnnotation, rng: np.random.Generator, by_px: float) -> FrameAnnotation:
    """Every element as a whole a little beside where it was clicked."""
    moved = []
    for polyline in annotation:
        points = points_px(polyline, SIZE) + rng.normal(0, by_px, 2)
        moved.append(
            Polyline(polyline.class_name, tuple(point_from_px(x, y, SIZE) for x, y in points))
        )
    return FrameAnnotation(tuple(moved))


def test_what_elements_share_is_told_from_the_noise_of_clicks(views, field):
    rng = np.random.default_rng(1)
    truth = views.main(rng).camera
    said: dict[float, list[tuple[float, float]]] = {0.0: [], 2.0: []}
    for by_px, found in said.items():
        for _ in range(25):
            clicked = beside(views.clicks(truth, rng, 0.7), rng, by_px)
            fit = fit_camera(clicked, field, model="R")
            found.append((fit.error_px, fit.shared))
    alone, moved = (np.median(said[by_px], axis=0) for by_px in (0.0, 2.0))
    assert alone[0] == pytest.approx(0.7, rel=0.25)
    assert alone[1] < 1.0
    assert moved[1] > 2 * alone[1]


@pytest.mark.parametrize("noise_px", [0.3, 1.0, 2.5])
def test_the_error_of_clicks_is_estimated(views, field, noise_px):
    rng = np.random.default_rng(2)
    truth = views.main(rng).camera
    fits = [fit_camera(views.clicks(truth, rng, noise_px), field) for _ in range(12)]
    assert np.median([fit.error_px for fit in fits]) == pytest.approx(noise_px, rel=0.25)


@pytest.mark.parametrize("noise_px", [0.3, 1.0, 2.5])
def test_standard_deviations_of_the_pose_hold(views, field, noise_px):
    """Root mean square of error over standard deviation; 1 where they are right."""
    rng = np.random.default_rng(3)
    ratios = []
    for _ in range(40):
        view = views.main(rng, noise_px=noise_px, k1=0.0)
        fit = fit_camera(view.annotation, field, model="P")
        true, found, sd = view.camera, fit.camera, fit.deviations
        assert isinstance(found, PinholeCamera)
        assert sd is not None
        place = np.subtract(found.position_world, true.position_world) / sd.position_m
        pan = np.remainder(found.pan_rad - true.pan_rad + np.pi, 2 * np.pi) - np.pi
        tilt = (found.tilt_rad - true.tilt_rad) / sd.tilt_rad
        focal = (found.focal_px[0] - true.focal_px[0]) / sd.focal_px
        ratios.append((pan / sd.pan_rad, tilt, focal, *place))
    assert (np.sqrt(np.mean(np.square(ratios), axis=0)) > 0.65).all()
    assert (np.sqrt(np.mean(np.square(ratios), axis=0)) < 1.4).all()


def test_a_ghost_may_lie_beside_the_model_as_the_others_do(views, field):
    rng = np.random.default_rng(3)
    clicked = beside(views.main(rng, noise_px=0.7).annotation, rng, 2.0)
    left = clicked.without("Small rect. left main")
    fit = fit_camera(left, field)
    (ghost,) = [g for g in find_ghosts(left, field, fit) if g.name == "Small rect. left main"]
    world = np.array([(-47.0, 0.0, 0.0)])
    assert fit.shared > 0
    assert min(piece.sd_px.min() for piece in ghost.pieces) > fit.error_px
    assert min(piece.sd_px.min() for piece in ghost.pieces) > fit.projected_sd(world)[0] / 2
