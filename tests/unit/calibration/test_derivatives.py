"""The analytic Jacobian is that of the residual, by finite differences, and of the projection."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.calibration.optimization.camera_parameters import (
    camera_from_vector,
    homography_from_pinhole,
    rotation_matrices,
)
from procc_annotator.calibration.optimization.camera_parameters import (
    vector_from_camera as to_vector,
)
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.calibration.optimization.residuals import (
    HIDDEN_RESIDUAL_PX,
    homography_residuals,
    pinhole_residuals,
)

FRAME = ImageFrame((960, 540))
# Steps of each parameter that move pixels by about a hundredth.
STEPS = np.array([1e-6, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4, 1e-6, 1e-6, 1e-6, 1e-4, 1e-4])


@pytest.mark.parametrize(
    ("seed", "kappa"), [*((n, None) for n in range(6)), (0, -0.05), (1, -0.12)]
)
def test_of_pinhole_residuals(views, field, seed, kappa) -> None:
    rng = np.random.default_rng(seed)
    view = views.random(rng, noise_px=1.0)
    seen = build_observations(view.annotation, field, FRAME)
    vector = to_vector(view.camera, FRAME)
    vector[8:] = 0.01, 5.0, -3.0
    if kappa is not None:
        vector[7] = kappa
    found = pinhole_residuals(vector[None], seen, FRAME.half_diagonal, 11)
    for i, step in enumerate(STEPS):
        ahead, behind = vector.copy(), vector.copy()
        ahead[i] += step
        behind[i] -= step
        both = pinhole_residuals(np.array([ahead, behind]), seen, FRAME.half_diagonal, 11)
        numeric = (both.values[0] - both.values[1]) / (2 * step)
        scale = np.abs(found.derivatives[0, i]).max() + 1e-9
        # A point whose foot is about to leave an end has no derivative: no more than one in 20.
        off = np.abs(numeric - found.derivatives[0, i]) / scale
        assert (off < 0.02).mean() > 0.95, i


@pytest.mark.parametrize("k1", [0.1, -0.4])
def test_of_exact_points_is_exact(views, field, k1) -> None:
    """Ends are left out: there the residual changes its nature."""
    view = views.main(np.random.default_rng(0), noise_px=0.0, k1=k1)
    inner = FrameAnnotation(tuple(Polyline(p.class_name, p.points[1:-1]) for p in view.annotation))
    seen = build_observations(inner, field, FRAME)
    assert seen.points.shape[1] > 15
    vector = to_vector(view.camera, FRAME)
    found = pinhole_residuals(vector[None], seen, FRAME.half_diagonal, 11)
    # The visible pieces of the metric are polylines, a hundredth of a pixel beside the curve.
    assert found.distances.max() < 0.02
    for i, step in enumerate(STEPS):
        ahead, behind = vector.copy(), vector.copy()
        ahead[i] += step
        behind[i] -= step
        both = pinhole_residuals(np.array([ahead, behind]), seen, FRAME.half_diagonal, 11)
        numeric = (both.values[0] - both.values[1]) / (2 * step)
        scale = np.abs(numeric).max()
        np.testing.assert_allclose(numeric, found.derivatives[0, i], atol=2e-3 * scale + 1e-6)


def test_of_homography_residuals(views, field) -> None:
    rng = np.random.default_rng(4)
    view = views.main(rng, k1=0.0)
    seen = build_observations(view.annotation, field, FRAME, ground_only=True)
    basis = homography_from_pinhole(to_vector(view.camera, FRAME))
    vector = rng.normal(0, 1e-3, 8)
    found = homography_residuals(vector[None], seen, basis)
    step = 1e-7
    for i in range(8):
        ahead, behind = vector.copy(), vector.copy()
        ahead[i] += step
        behind[i] -= step
        both = homography_residuals(np.array([ahead, behind]), seen, basis)
        numeric = (both.values[0] - both.values[1]) / (2 * step)
        off = np.abs(numeric - found.derivatives[0, i]) / np.abs(numeric).max()
        assert (off < 0.02).mean() > 0.95


@pytest.mark.parametrize("k1", [0.0, 0.3, -0.1, "both"])
def test_projection_is_that_of_the_camera(views, k1) -> None:
    rng = np.random.default_rng(2)
    k1s = [0.2, -0.05, 0.0, -0.1] if k1 == "both" else [k1] * 4
    vectors = np.array([to_vector(views.random(rng, k1=k).camera, FRAME) for k in k1s])
    vectors[:, 8:] = 0.02, 7.0, -4.0
    lens = Lens.of(vectors, FRAME.half_diagonal)
    world = np.empty((4, 3, 20))
    for b in range(4):  # in front of each camera
        depths = rng.uniform(20, 80, 20)
        aside = rng.uniform(-0.2, 0.2, (2, 20)) * depths
        cam = np.vstack([aside, depths])
        world[b] = lens.rotation[b].T @ cam + vectors[b, 3:6, None]
    pixels, _, _ = project(lens, world, np.zeros_like(world), 11)
    for b in range(4):
        camera = camera_from_vector(vectors[b], FRAME)
        expected, valid = camera.project(world[b].T)
        assert valid.all()
        centred = (expected - FRAME.centre_px) * FRAME.scale
        np.testing.assert_allclose(pixels[b].T, centred, atol=1e-7)
        # The way back through the lens, in closed form.
        back = lens.undistorted(pixels[b])[b]
        ideal = (lens.linear[b, :, :3] @ world[b]) + lens.linear[b, :, 3:]
        np.testing.assert_allclose(back, ideal[:2] / ideal[2], atol=1e-6)


def test_what_barrel_distortion_does_not_show_is_taken_for_its_edge() -> None:
    """Shown are places up to 2 / 3 of the fold's distance from the principal point."""
    vector = np.zeros((1, 11))
    vector[:, 6:8] = np.log(700.0), -0.12
    lens = Lens.of(vector, FRAME.half_diagonal)
    fold = FRAME.half_diagonal / np.sqrt(0.36)
    there = np.array([[0.66, 2 / 3, 0.7, 30.0], [0.0] * 4]) * fold
    back = lens.undistorted(there)[0]
    assert 0.8 * fold < back[0, 0] < 0.95 * fold
    np.testing.assert_allclose(back[0, 1:], fold, rtol=1e-6)
    ahead = np.array([[0.999, 1.001], [0.0, 0.0], [1.0, 1.0]])[None] * [[[fold], [0.0], [700.0]]]
    world = lens.rotation.transpose(0, 2, 1) @ ahead
    assert lens.is_beyond_fold(world).tolist() == [[False, True]]
    straight = Lens.of(np.zeros((1, 11)), FRAME.half_diagonal)
    assert straight.is_beyond_fold(world) is None


def test_vectors_and_cameras_are_inverse(views) -> None:
    for size, kappa in (((960, 540), 0.03), ((1920, 1080), -0.1), ((1280, 720), 0.03)):
        frame = ImageFrame(size)
        vector = np.array([0.3, 1.4, 0.01, 3.0, -60.0, -12.0, 7.5, kappa, 0.01, 4.0, -6.0])
        camera = camera_from_vector(vector, frame)
        np.testing.assert_allclose(to_vector(camera, frame), vector, atol=1e-9)
        np.testing.assert_allclose(
            rotation_matrices(vector[None])[0], camera.rotation_cam_from_world, atol=1e-12
        )


def test_elements_behind_the_camera_cost_a_constant(views, field) -> None:
    view = views.main(np.random.default_rng(0))
    seen = build_observations(view.annotation, field, FRAME)
    vector = to_vector(view.camera, FRAME)
    vector[0] += np.pi
    vector[1] = np.deg2rad(100)  # not even what lies under the camera
    found = pinhole_residuals(vector[None], seen, FRAME.half_diagonal, 8)
    assert np.isfinite(found.derivatives).all()
    hidden = found.distances[0] == HIDDEN_RESIDUAL_PX
    assert hidden.all()
    assert not found.derivatives[0][:, :, hidden].any()
