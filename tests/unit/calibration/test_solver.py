"""The solver comes to the same optimum as scipy's, and keeps to its bound."""

from functools import partial

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.optimization.camera_parameters import (
    KAPPA,
    MIN_KAPPA,
    camera_from_vector,
    homography_from_pinhole,
    rotation_matrices,
    vector_from_camera,
)
from procc_annotator.calibration.optimization.camera_parameters import (
    vector_from_camera as to_vector,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.initialization import (
    nearest_control_point,
    wide_prior,
)
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.calibration.optimization.residuals import (
    HIDDEN_RESIDUAL_PX,
    homography_residuals,
    pinhole_residuals,
)
from procc_annotator.calibration.optimization.robust_fit import FitScene, search_cameras
from procc_annotator.calibration.optimization.solver import (
    GaussianPrior,
    Problem,
    RobustLoss,
    solve,
)

scipy = pytest.importorskip("scipy")
FRAME = ImageFrame((960, 540))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(("free", "barrel"), [(7, False), (8, False), (11, False), (8, True)])
def test_squared_loss_as_scipy(views, field, seed, free, barrel):
    k1 = -0.4 if barrel else None
    view = views.random(np.random.default_rng(seed), at_least=6, side=0, k1=k1)
    seen = build_observations(view.annotation, field, FRAME)
    start = vector_from_camera(view.camera, FRAME)
    if free == 7:
        start[KAPPA] = 0.0
    prior = wide_prior(np.array([0]), camera_placement_prior(field), free)
    residuals = partial(pinhole_residuals, seen=seen, half_diagonal=FRAME.half_diagonal, free=free)
    problem = Problem(residuals, seen.weights, RobustLoss("squared", 1.0), prior, bounded=KAPPA)
    ours = solve(problem, start[None].copy(), iterations=60, tolerance=1e-12)
    root = np.sqrt(seen.weights)

    def rows(values: np.ndarray) -> np.ndarray:
        vector = start.copy()
        vector[:free] = values
        found = residuals(vector[None]).values[0] * root
        return np.r_[found.ravel(), ((values - prior.mean) * prior.inverse_sd)[0]]

    low = np.full(free, -np.inf)
    if free > KAPPA:
        low[KAPPA] = MIN_KAPPA if barrel else 0.0
    scale = np.r_[1e-3, 1e-3, 1e-3, 0.1, 0.1, 0.1, 1e-3, 1e-2, 1e-3, 1, 1][:free]
    inside = np.maximum(start[:free], low + 1e-6)
    theirs = scipy.optimize.least_squares(
        rows, inside, bounds=(low, np.inf), x_scale=scale, xtol=1e-12, ftol=1e-12, gtol=1e-12
    )
    assert ours.costs[0] == pytest.approx(theirs.cost, rel=1e-3)
    vector = start.copy()
    vector[:free] = theirs.x
    there = residuals(vector[None]).values[0]
    here = residuals(ours.vectors).values[0]
    assert np.median(np.abs(there - here)) < 0.05


def test_a_parameter_on_its_bound_lets_the_others_go_on():
    """Minimum of (x - 3)^2 + (y + 2)^2 + x y / 2 with y >= 0 lies at (3, 0)."""

    class FoundCamera:
        def __init__(self, vectors: np.ndarray) -> None:
            x, y = vectors[:, 0], vectors[:, 1]
            self.values = np.stack([x - 3, y + 2 + 0.25 * x], axis=1)[:, :, None]
            self.derivatives = np.zeros((len(vectors), 2, 2, 1))
            self.derivatives[:, 0, 0], self.derivatives[:, 1, 1] = 1.0, 1.0
            self.derivatives[:, 0, 1] = 0.25
            self.distances = np.hypot(self.values[:, 0], self.values[:, 1])
            self.whole = np.ones_like(self.distances, dtype=bool)

    flat = GaussianPrior(np.zeros((1, 2)), np.zeros((1, 2)))
    problem = Problem(FoundCamera, np.ones(1), RobustLoss("squared", 1.0), flat, bounded=1)
    found = solve(problem, np.array([[0.0, 5.0], [10.0, 0.5]]), iterations=50, tolerance=1e-14)
    # On y = 0: minimise (x - 3)^2 + (2 + x / 4)^2.
    expected = (3 - 0.5) / (1 + 1 / 16)
    np.testing.assert_allclose(found.vectors, [[expected, 0.0]] * 2, atol=1e-5)


@pytest.mark.parametrize("kind", ["cauchy", "geman_mcclure", "huber", "squared"])
def test_weights_are_the_slope_of_the_cost(kind):
    loss = RobustLoss(kind, 3.0)
    distances = np.linspace(0.1, 40, 60)
    step = 1e-6
    slope = (
        loss.cost_and_weight(distances + step)[0] - loss.cost_and_weight(distances - step)[0]
    ) / (2 * step)
    np.testing.assert_allclose(loss.cost_and_weight(distances)[1] * distances, slope, rtol=1e-5)
    assert loss.cost_and_weight(np.zeros(1))[0] == 0


def test_a_search_that_starts_below_zero_keeps_to_the_lower_bound():
    """Minimum of (x + 1)^2, from either side of 0."""

    class FoundCamera:
        def __init__(self, vectors: np.ndarray) -> None:
            self.values = np.zeros((len(vectors), 2, 1))
            self.values[:, 0, 0] = vectors[:, 0] + 1
            self.derivatives = np.zeros((len(vectors), 1, 2, 1))
            self.derivatives[:, 0, 0] = 1.0
            self.distances = np.abs(self.values[:, 0])
            self.whole = np.ones_like(self.distances, dtype=bool)

    flat = GaussianPrior(np.zeros((1, 1)), np.zeros((1, 1)))
    problem = Problem(FoundCamera, np.ones(1), RobustLoss("squared", 1.0), flat, bounded=0)
    found = solve(problem, np.array([[0.3], [0.0], [-0.01]]), iterations=20)
    np.testing.assert_allclose(found.vectors, [[0.0], [0.0], [MIN_KAPPA]], atol=1e-12)


def test_the_radial_coefficient_of_a_search_never_falls_below_zero(views, field):
    rng = np.random.default_rng(3)
    for _ in range(4):
        view = views.random(rng, k1=-0.05, at_least=6)
        found = search_cameras(
            [FitScene(build_observations(view.annotation, field, FRAME), field, FRAME)], "R"
        )[0]
        assert found.vector[KAPPA] >= 0


# The analytic Jacobian is that of the residual, by finite differences, and of the projection.

# Steps of each parameter that move pixels by about a hundredth.
STEPS = np.array([1e-6, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4, 1e-6, 1e-6, 1e-6, 1e-4, 1e-4])


def beside(vector, i, step):
    """(2, n): a vector with one parameter a step larger, and a step smaller."""
    return vector + np.outer((step, -step), np.arange(len(vector)) == i)


@pytest.mark.parametrize(
    ("seed", "kappa"), [*((n, None) for n in range(6)), (0, -0.05), (1, -0.12)]
)
def test_of_pinhole_residuals(views, field, seed, kappa):
    rng = np.random.default_rng(seed)
    view = views.random(rng, noise_px=1.0)
    seen = build_observations(view.annotation, field, FRAME)
    vector = to_vector(view.camera, FRAME)
    vector[8:] = 0.01, 5.0, -3.0
    if kappa is not None:
        vector[7] = kappa
    found = pinhole_residuals(vector[None], seen, FRAME.half_diagonal, 11)
    for i, step in enumerate(STEPS):
        both = pinhole_residuals(beside(vector, i, step), seen, FRAME.half_diagonal, 11)
        numeric = (both.values[0] - both.values[1]) / (2 * step)
        scale = np.abs(found.derivatives[0, i]).max() + 1e-9
        # A point whose foot is about to leave an end has no derivative: no more than one in 20.
        off = np.abs(numeric - found.derivatives[0, i]) / scale
        assert (off < 0.02).mean() > 0.95, i


@pytest.mark.parametrize("k1", [0.1, -0.4])
def test_of_exact_points_is_exact(views, field, k1):
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
        both = pinhole_residuals(beside(vector, i, step), seen, FRAME.half_diagonal, 11)
        numeric = (both.values[0] - both.values[1]) / (2 * step)
        scale = np.abs(numeric).max()
        np.testing.assert_allclose(numeric, found.derivatives[0, i], atol=2e-3 * scale + 1e-6)


def test_of_homography_residuals(views, field):
    rng = np.random.default_rng(4)
    view = views.main(rng, k1=0.0)
    seen = build_observations(view.annotation, field, FRAME, ground_only=True)
    basis = homography_from_pinhole(to_vector(view.camera, FRAME))
    vector = rng.normal(0, 1e-3, 8)
    found = homography_residuals(vector[None], seen, basis)
    step = 1e-7
    for i in range(8):
        both = homography_residuals(beside(vector, i, step), seen, basis)
        numeric = (both.values[0] - both.values[1]) / (2 * step)
        off = np.abs(numeric - found.derivatives[0, i]) / np.abs(numeric).max()
        assert (off < 0.02).mean() > 0.95


@pytest.mark.parametrize("k1", [0.0, 0.3, -0.1, "both"])
def test_projection_is_that_of_the_camera(views, k1):
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


def test_what_barrel_distortion_does_not_show_is_taken_for_its_edge():
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


def test_vectors_and_cameras_are_inverse(views):
    for size, kappa in (((960, 540), 0.03), ((1920, 1080), -0.1), ((1280, 720), 0.03)):
        frame = ImageFrame(size)
        vector = np.array([0.3, 1.4, 0.01, 3.0, -60.0, -12.0, 7.5, kappa, 0.01, 4.0, -6.0])
        camera = camera_from_vector(vector, frame)
        np.testing.assert_allclose(to_vector(camera, frame), vector, atol=1e-9)
        np.testing.assert_allclose(
            rotation_matrices(vector[None])[0], camera.rotation_cam_from_world, atol=1e-12
        )


def test_elements_behind_the_camera_cost_a_constant(views, field):
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


# Where two clicked lines cross is a place both on the field and in the picture.

NEAR_CORNER = ("Side line bottom", "Side line left")


def only(annotation: FrameAnnotation, *names: str) -> FrameAnnotation:
    return FrameAnnotation(tuple(p for p in annotation if p.class_name in names))


def test_the_picture_shows_the_place_where_it_is(views, field):
    view = views.main(np.random.default_rng(50), noise_px=0.0, k1=0.0)
    place, shown = nearest_control_point(build_observations(view.annotation, field, FRAME))
    expected, seen = view.camera.project(place[None])
    assert seen.all()
    np.testing.assert_allclose(shown + np.array(FRAME.centre_px), expected[0], atol=1e-3)
    # Of several crossings the one nearest to the middle of the picture.
    for pair in (("Big rect. left main", "Big rect. left top"), NEAR_CORNER):
        found = nearest_control_point(
            build_observations(only(view.annotation, *pair), field, FRAME)
        )
        if found is not None:
            assert np.hypot(*shown) <= np.hypot(*found[1]) + 1e-9


def test_lines_are_prolonged(views, field):
    """A corner outside the picture is as good as one inside."""
    lines = (
        Polyline("Side line top", (Point(0.2, 0.5), Point(0.5, 0.5))),
        Polyline("Side line left", (Point(0.1, 0.6), Point(0.0, 0.8))),
    )
    place, shown = nearest_control_point(build_observations(FrameAnnotation(lines), field, FRAME))
    np.testing.assert_allclose(place, (-52.5, -34.0, 0.0), atol=1e-6)
    np.testing.assert_allclose(shown, ((0.15 - 0.5) * 959, 0.0), atol=1e-6)


def test_some_lines_never_meet(field):
    up, down = (Point(0.2, 0.2), Point(0.3, 0.9)), (Point(0.8, 0.2), Point(0.7, 0.9))
    level = (Point(0.2, 0.5), Point(0.7, 0.5))
    for names, courses in (
        (("Side line left", "Side line right"), (up, down)),  # parallel on the field
        (("Big rect. left main", "Middle line"), (up, down)),
        (("Small rect. left top", "Big rect. left main"), (up, level)),  # end before they meet
        (("Goal left crossbar", "Side line left"), (up, level)),  # one above the other
        (("Side line top", "Side line left"), (level, (Point(0.2, 0.51), Point(0.7, 0.51)))),
        (("Side line top", "Side line left"), (level, up[:1])),  # one point is no line
        (("Side line top", "Circle central"), (level, up)),
    ):  # fmt: skip
        lines = tuple(Polyline(n, c) for n, c in zip(names, courses, strict=True))
        assert (
            nearest_control_point(build_observations(FrameAnnotation(lines), field, FRAME)) is None
        ), names
