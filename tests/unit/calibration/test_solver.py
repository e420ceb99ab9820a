"""The solver comes to the same optimum as scipy's, and keeps to its bound."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from procc_annotator.calibration.optimization.camera_parameters import (
    KAPPA,
    MIN_KAPPA,
    vector_from_camera,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.initialization import wide_prior
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.residuals import pinhole_residuals
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
def test_squared_loss_as_scipy(views, field, seed, free, barrel) -> None:
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


def test_a_parameter_on_its_bound_lets_the_others_go_on() -> None:
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
def test_weights_are_the_slope_of_the_cost(kind) -> None:
    loss = RobustLoss(kind, 3.0)
    distances = np.linspace(0.1, 40, 60)
    step = 1e-6
    slope = (
        loss.cost_and_weight(distances + step)[0] - loss.cost_and_weight(distances - step)[0]
    ) / (2 * step)
    np.testing.assert_allclose(loss.cost_and_weight(distances)[1] * distances, slope, rtol=1e-5)
    assert loss.cost_and_weight(np.zeros(1))[0] == 0


def test_a_search_that_starts_below_zero_keeps_to_the_lower_bound() -> None:
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


def test_the_radial_coefficient_of_a_search_never_falls_below_zero(views, field) -> None:
    rng = np.random.default_rng(3)
    for _ in range(4):
        view = views.random(rng, k1=-0.05, at_least=6)
        found = search_cameras(
            [FitScene(build_observations(view.annotation, field, FRAME), field, FRAME)], "R"
        )[0]
        assert found.vector[KAPPA] >= 0
