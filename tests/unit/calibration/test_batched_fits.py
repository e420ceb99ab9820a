"""Frames that are fitted together get the cameras that each of them gets alone."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.calibration.fitting import FitRequest, fit_camera, fit_cameras
from procc_annotator.calibration.optimization import residuals
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.robust_fit import FitScene, search_cameras

SIZE, LARGER = (960, 540), (1920, 1080)


@pytest.fixture(scope="module")
def frames(views, field) -> list[FitRequest]:
    """Frames unlike each other: few and many elements, with and without curves, barrel, wrong
    labels, too little for a camera, another size."""
    rng = np.random.default_rng(5)
    seen = [views.random(rng).annotation for _ in range(5)]
    seen.append(views.main(rng, k1=-0.2).annotation)
    straight = [p for p in seen[5] if field.element(p.class_name).is_straight]
    seen.append(FrameAnnotation(tuple(straight)))
    seen.append(swapped(seen[5]))
    seen.append(FrameAnnotation(seen[5].polylines[:1]))
    seen.append(FrameAnnotation(()))
    given = [(annotation, field, SIZE) for annotation in seen]
    return [*given, (seen[0], field, LARGER)]


def swapped(annotation: FrameAnnotation) -> FrameAnnotation:
    first, second, *rest = annotation.polylines
    return FrameAnnotation(
        (
            Polyline(second.class_name, first.points),
            Polyline(first.class_name, second.points),
            *rest,
        )
    )


@pytest.mark.parametrize("model", ["P", "R", "R+", "auto", "H", "F"])
def test_the_same_as_alone(frames, model) -> None:
    together = fit_cameras(frames, model=model)
    assert len(together) == len(frames)
    assert sum(fit.camera is not None for fit in together) >= 6
    for (annotation, field, size), fit in zip(frames, together, strict=True):
        alone = fit_camera(annotation, field, model=model, size=size)
        assert (fit.model, fit.failure, fit.left_out) == (
            alone.model,
            alone.failure,
            alone.left_out,
        )
        if alone.camera is None:
            assert fit.camera is None
            continue
        np.testing.assert_allclose(fit.vector, alone.vector, rtol=1e-6, atol=1e-9)
        np.testing.assert_allclose(fit.covariance, alone.covariance, rtol=1e-4, atol=1e-12)
        assert fit.mean_px == pytest.approx(alone.mean_px, rel=1e-6)


def test_who_is_beside_a_frame_does_not_matter(frames) -> None:
    one = fit_cameras([frames[0], frames[5]], model="R")
    other = fit_cameras([frames[5], *frames[6:], frames[0]], model="R")
    np.testing.assert_allclose(one[0].vector, other[-1].vector, rtol=1e-6, atol=1e-9)
    np.testing.assert_allclose(one[1].vector, other[0].vector, rtol=1e-6, atol=1e-9)


def test_no_frames_get_no_cameras() -> None:
    assert fit_cameras([]) == []


def test_residuals_of_several_frames_are_computed_at_once(frames, monkeypatch) -> None:
    """As often as the slowest frame needs them, not as often as all of them do."""
    calls: Counter[str] = Counter()
    computed = residuals.find_closest_points

    def counted(*args, **options):
        calls[way] += 1
        return computed(*args, **options)

    monkeypatch.setattr(residuals, "find_closest_points", counted)
    frame = ImageFrame(SIZE)
    seen = [(build_observations(one, field, frame), field) for one, field, _ in frames[:8]]
    scenes = [FitScene(*one, frame) for one in seen]
    way = "alone"
    alone = [search_cameras([one], "R")[0] for one in scenes]
    way = "together"
    for one, other in zip(alone, search_cameras(scenes, "R"), strict=True):
        assert one.solution.steps == other.solution.steps
        np.testing.assert_allclose(one.vector, other.vector, rtol=1e-6, atol=1e-9)
    assert calls["together"] < 0.7 * calls["alone"]
