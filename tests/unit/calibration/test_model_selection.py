"""The tool chooses the simplest model the points support, and says why."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.camera.models import HomographyCamera
from procc_annotator.errors import UsageError

SIZE = (960, 540)


def chosen_for(views, field, cameras, rng, noise_px: float = 1.0) -> Counter[str]:
    fits = [
        fit_camera(views.clicks(camera, rng, noise_px), field, model="auto", size=SIZE)
        for camera in cameras
    ]
    return Counter(fit.model for fit in fits)


def test_without_distortion_a_pinhole_will_do(views, field) -> None:
    rng = np.random.default_rng(30)
    cameras = [views.random(rng, k1=0.0).camera for _ in range(12)]
    assert chosen_for(views, field, cameras, rng)["P"] >= 11


def test_distortion_that_shows_is_fitted(views, field) -> None:
    rng = np.random.default_rng(31)
    main = views.main(rng).camera
    bent = [replace(main, radial=(k1, 0, 0, 0, 0, 0)) for k1 in np.linspace(0.2, 0.6, 8)]
    chosen = chosen_for(views, field, bent, rng)
    assert chosen["P"] == 0
    assert chosen["R"] >= 6


def test_pixels_that_are_not_square_are_fitted(views, field) -> None:
    rng = np.random.default_rng(32)
    main = views.main(rng, k1=0.3).camera
    wide = [replace(main, focal_px=(1500 * share, 1500.0)) for share in (0.93, 0.95, 1.05, 1.07)]
    assert chosen_for(views, field, wide, rng, noise_px=0.5) == {"R+": 4}


@pytest.mark.parametrize(
    ("k1", "model", "why"),
    [(0.0, "P", "without lens distortion"), (0.5, "R", "lens distortion"), (0.5, "R+", "aspect")],
)
def test_the_reason_is_told(views, field, k1, model, why) -> None:
    rng = np.random.default_rng(33)
    camera = views.main(rng, k1=k1).camera
    if model == "R+":
        camera = replace(camera, principal_point_px=(520.0, 269.5))
    fit = fit_camera(views.clicks(camera, rng, 0.5), field, model="auto", size=SIZE)
    assert fit.model == model
    assert why in fit.chosen_because
    assert " px" in fit.chosen_because
    assert len(fit.parameters) == {"P": 7, "R": 8, "R+": 11}[model]


def test_it_is_the_fit_of_the_model_that_was_chosen(views, field) -> None:
    world = np.array([(-45.0, 0.0, 0.0), (-36.0, 20.0, 0.0), (-20.0, -20.0, 0.0)])
    for k1 in (0.0, 0.1, 0.5):
        annotation = views.main(np.random.default_rng(34), k1=k1).annotation
        chosen = fit_camera(annotation, field, model="auto")
        asked = fit_camera(annotation, field, model=chosen.model)
        assert asked.chosen_because is None
        np.testing.assert_allclose(
            chosen.camera.project(world)[0], asked.camera.project(world)[0], atol=0.05
        )
        assert chosen.deviations.pan_rad == pytest.approx(asked.deviations.pan_rad, rel=0.02)
        assert chosen.left_out == asked.left_out


def test_a_warm_choice_is_that_of_a_cold_one(views, field) -> None:
    world = np.array([(-45.0, 0.0, 0.0), (-36.0, 20.0, 0.0), (-36.0, -20.0, 0.0)])
    for k1 in (0.0, 0.1, 0.5):
        annotation = views.main(np.random.default_rng(35), k1=k1).annotation
        cold = fit_camera(annotation, field, model="auto")
        polyline = annotation.polylines[0]
        moved = Point(polyline.points[0].u + 0.003, polyline.points[0].v - 0.003)
        edited = annotation.with_polyline(
            Polyline(polyline.class_name, (moved, *polyline.points[1:]))
        )
        warm = fit_camera(edited, field, model="auto", start=cold.camera)
        again = fit_camera(edited, field, model="auto")
        assert (cold.warm, warm.warm, again.warm) == (False, True, False)
        assert warm.model == again.model
        np.testing.assert_allclose(
            warm.camera.project(world)[0], again.camera.project(world)[0], atol=0.2
        )


def test_starts_that_are_of_no_use_do_no_harm(views, field, median_error) -> None:
    view = views.main(np.random.default_rng(36))
    elsewhere = views.random(np.random.default_rng(3), side=2).camera
    broken = replace(elsewhere, position_world=(np.nan, 0.0, 0.0))
    for start in (elsewhere, broken, HomographyCamera(np.eye(3))):
        fit = fit_camera(view.annotation, field, model="auto", start=start)
        assert median_error(view.camera, fit.camera) < 3


def test_a_mistake_is_left_out_whatever_the_model(views, field, median_error) -> None:
    view = views.main(np.random.default_rng(37))
    points = view.annotation.get("Small rect. left main").points
    wrong = view.annotation.without("Small rect. left main").with_polyline(
        Polyline("Middle line", points)
    )
    fit = fit_camera(wrong, field, model="auto")
    assert fit.left_out == ("Middle line",)
    assert median_error(view.camera, fit.camera) < 3


def test_what_cannot_be_fitted_is_declined_in_the_same_words(views, field) -> None:
    annotation = views.main(np.random.default_rng(38)).annotation
    two = fit_camera(FrameAnnotation(annotation.polylines[:2]), field, model="auto")
    assert (two.model, two.camera, two.failure) == ("auto", None, "2 elements, 3 needed")
    names = [p.class_name for p in annotation]
    shuffled = FrameAnnotation(
        tuple(
            Polyline(name, p.points)
            for name, p in zip(names[3:] + names[:3], annotation, strict=True)
        )
    )
    lost = fit_camera(shuffled, field, model="auto")
    assert (lost.model, lost.camera, lost.chosen_because) == ("auto", None, None)
    assert lost.failure
    with pytest.raises(UsageError, match="too small"):
        fit_camera(annotation, field, model="auto", size=(1, 540))
