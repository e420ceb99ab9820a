"""Standard deviations say how far fits to other clicks of the same frame scatter."""

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.result import FitResult
from procc_annotator.field.geometry import Spot
from procc_annotator.field.model import Element

SIZE = (960, 540)


def test_standard_deviations_are_about_the_scatter(views, field):
    """Points of an element count as the square root of their number, so a little too large."""
    rng = np.random.default_rng(1)
    truth = views.main(rng).camera
    world = np.array([(-52.5, 34.0, 0.0), (-36.0, 0.0, 0.0), (-20.0, -34.0, 0.0), (0, 0, 0)])
    fits = [fit_camera(views.clicks(truth, rng, 1.5), field) for _ in range(40)]
    focal = np.std([f.camera.focal_px[0] for f in fits])
    height = np.std([f.camera.position_world[2] for f in fits])
    pan = np.std([f.camera.pan_rad for f in fits])
    said = [f.deviations for f in fits]
    assert 0.7 < np.median([s.focal_px for s in said]) / focal < 2.5
    assert 0.7 < np.median([s.position_m[2] for s in said]) / height < 2.5
    assert 0.7 < np.median([s.pan_rad for s in said]) / pan < 2.5
    shown = np.array([f.camera.project(world)[0] for f in fits])
    scatter = np.hypot(*shown.std(axis=0).T)
    expected = np.median([f.projected_sd(world) for f in fits], axis=0)
    assert (expected > 0.6 * scatter).all()
    assert (expected < 3 * scatter).all()


@pytest.mark.parametrize(
    ("model", "k1"), [("H", 0.05), ("P", 0.05), ("R", 0.05), ("R+", 0.05), ("R", -0.5)]
)
def test_projected_covariance_by_moving_the_parameters(views, field, model, k1):
    view = views.main(np.random.default_rng(2), k1=k1)
    fit = fit_camera(view.annotation, field, model=model)
    assert model == "H" or np.sign(fit.camera.radial[0]) == (0 if model == "P" else np.sign(k1))
    world = np.array([(-40.0, 5.0, 0.0), (-20.0, -30.0, 0.0)])
    from procc_annotator.calibration.optimization.camera_parameters import (
        camera_from_vector,
        homography_camera,
    )
    from procc_annotator.calibration.optimization.observations import ImageFrame
    from procc_annotator.calibration.optimization.residuals import homographies_from_corrections

    frame = ImageFrame(fit.size)

    def shown(vector: np.ndarray) -> np.ndarray:
        if fit.basis is not None:
            matrix = homographies_from_corrections(vector[None], fit.basis)[0]
            return homography_camera(matrix, frame).project(world)[0]
        return camera_from_vector(vector, frame).project(world)[0]

    free = len(fit.parameters)
    derivatives = np.zeros((2, 2, free))
    for i in range(free):
        step = np.zeros(len(fit.vector))
        step[i] = 1e-6
        derivatives[:, :, i] = (shown(fit.vector + step) - shown(fit.vector - step)) / 2e-6
    expected = derivatives @ fit.covariance @ derivatives.transpose(0, 2, 1)
    np.testing.assert_allclose(fit.projected_covariance(world), expected, rtol=1e-3, atol=1e-4)
    largest = np.sqrt(np.linalg.eigvalsh(expected)[:, -1])
    np.testing.assert_allclose(fit.projected_sd(world), largest, rtol=1e-3)
    along_x = fit.projected_sd(world, np.array([(1.0, 0.0)] * 2))
    np.testing.assert_allclose(along_x, np.sqrt(expected[:, 0, 0]), rtol=1e-3)


def test_more_elements_make_it_surer(views, field):
    annotation = views.main(np.random.default_rng(3)).annotation
    assert len(annotation.polylines) >= 8
    far = np.array([(0.0, 0.0, 0.0)])
    sds = [
        fit_camera(FrameAnnotation(annotation.polylines[-k:]), field).projected_sd(far)[0]
        for k in (3, 5, 8)
    ]
    assert sds[0] > sds[1] > sds[2]


def test_points_out_of_sight_have_none(views, field):
    annotation = views.main(np.random.default_rng(4)).annotation
    behind, above = (0.0, 120.0, 0.0), (-40.0, 0.0, -2.44)
    pinhole, flat = fit_camera(annotation, field), fit_camera(annotation, field, model="H")
    assert np.isnan(pinhole.projected_sd(np.array([behind]))).all()
    assert np.isfinite(pinhole.projected_sd(np.array([above]))).all()
    assert np.isnan(flat.projected_sd(np.array([behind, above]))).all()
    failed = FitResult("R", (960, 540), None, "2 elements, 3 needed")
    assert np.isnan(failed.projected_sd(np.array([above]))).all()
    assert failed.mean_px is None


def test_the_noise_of_spots_is_what_clicks_are_off_along_each_axis(views):
    """Both coordinates of a click on a spot count, each with an error of its own."""
    rng = np.random.default_rng(6)
    camera = views.main(rng, k1=0.0).camera
    places = np.column_stack([rng.uniform((-50, -34), (-10, 30), (12, 2)), rng.uniform(-6, 0, 12)])
    shown, _ = camera.project(places)
    spots = tuple(
        Element(f"S{i}", f"S{i}", "", "", "", Spot(tuple(place))) for i, place in enumerate(places)
    )
    field = replace(views.field, elements=(*views.field.elements, *spots))
    said = []
    for _ in range(40):
        clicks = shown + rng.normal(0, 1.5, shown.shape)
        lines = [Polyline(f"S{i}", (point_from_px(*p, SIZE),)) for i, p in enumerate(clicks)]
        said.append(fit_camera(FrameAnnotation(tuple(lines)), field, model="P").error_px)
    assert np.sqrt(np.mean(np.square(said))) == pytest.approx(1.5, rel=0.07)
