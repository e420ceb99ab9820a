"""Search from many starts, reject outlier elements, and fit the final camera."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    KAPPA,
    homography_from_pinhole,
    lower_bounded_parameter,
    rotated_180,
)
from procc_annotator.calibration.optimization.camera_placement import (
    CameraPlacementPrior,
    camera_placement_prior,
    implausible_reason,
)
from procc_annotator.calibration.optimization.initialization import (
    camera_side,
    camera_sides,
    initial_cameras,
    prior_near,
    search_prior,
    side_costs,
    wide_prior,
)
from procc_annotator.calibration.optimization.observations import ImageFrame, Observations
from procc_annotator.calibration.optimization.residuals import (
    Residuals,
    estimate_click_sd,
    homography_residuals,
    linear_map,
    pinhole_residuals,
    residual_components,
    unwhitened,
    whitened,
)
from procc_annotator.calibration.optimization.solver import (
    FINAL_LOSS,
    ROBUST_LOSS,
    SEARCH_LOSS,
    GaussianPrior,
    Problem,
    Solution,
    SolveRequest,
    solve,
    solve_all,
    solve_request,
)
from procc_annotator.field.model import Field

# An element with a point farther off than this is taken for a mistake: no say in the final fit.
OUTLIER_PX = 15.0
MIN_ELEMENTS = 3
# A camera known before is looked for anew when the points no longer fit it.
_STALE_ELEMENT_SHARE, _STALE_PX = 1 / 3, 5.0

# Times that the weight of an uncertain spot is computed anew from the camera that was found with
# it.
_WHITENING_ROUNDS = 3


@dataclass(frozen=True, eq=False)
class CameraSolution:
    """A fitted camera.

    Attributes:
        vector: (11,) parameters of a pinhole, or (8,) corrections of a homography.
        solution: of the final stage, one camera.
        left_out: (E,) elements taken for mistakes.
        basis: (3, 3) homography that is corrected; None for a pinhole.
    """

    vector: FloatArray
    solution: Solution
    prior: GaussianPrior
    seen: Observations
    left_out: NDArray[np.bool_]
    basis: FloatArray | None = None

    @property
    def distances(self) -> FloatArray:
        """(N,) solver px from each point to its element, as they count."""
        return np.asarray(self.solution.distances[0])

    @property
    def image_distances(self) -> FloatArray:
        """The same as the picture shows them: uncertain spots in full."""
        x, y = unwhitened(self.solution.values[0], self.seen)
        return np.asarray(np.hypot(x, y))

    @property
    def components(self) -> FloatArray:
        """(M,) solver px: the numbers that the residuals of the points with a say are made of."""
        counted = ~self.left_out[self.seen.element_of_point]
        return residual_components(self.solution.values[0], self.solution.whole[0], counted)

    @property
    def robust_cost(self) -> float:
        """Cost of all points, those of the elements it leaves out too, and of the prior, px^2."""
        off = (self.vector[: self.prior.mean.shape[1]] - self.prior.mean[0]) * (
            self.prior.inverse_sd[0]
        )
        losses = ROBUST_LOSS.cost_and_weight(self.distances)[0]
        return float(losses @ self.seen.weights + off @ off / 2)

    @property
    def is_consistent(self) -> bool:
        """Return whether the elements it leaves out are those that are too far off."""
        return bool((outlier_elements(self.seen, self.distances) == self.left_out).all())

    @property
    def has_stale_start(self) -> bool:
        """Return whether the points speak so much against it that another camera may explain
        them."""
        off = self.seen.max_per_element(self.distances) > OUTLIER_PX
        means = self.seen.mean_per_element(self.distances)
        return bool(off.mean() >= _STALE_ELEMENT_SHARE or np.median(means) > _STALE_PX)


class FitScene(NamedTuple):
    """Annotated points of a frame, the field's elements, and the picture."""

    seen: Observations
    field: Field
    frame: ImageFrame

    @property
    def around(self) -> CameraPlacementPrior:
        """Where cameras stand around the field."""
        return camera_placement_prior(self.field)

    def residuals(self, free: int) -> Callable[..., Residuals]:
        """(B, n) parameters, observations -> residuals, with derivatives by the first ``free``."""
        return partial(pinhole_residuals, half_diagonal=self.frame.half_diagonal, free=free)


def outlier_elements(seen: Observations, distances: FloatArray) -> NDArray[np.bool_]:
    """(E,) elements to leave out; none when too few would remain to say who is right."""
    left_out = seen.max_per_element(distances) > OUTLIER_PX
    if len(left_out) - left_out.sum() < MIN_ELEMENTS:
        return np.zeros_like(left_out)
    return np.asarray(left_out)


# Points, (1, n) parameters that are nearly right, (E,) elements to leave out, residuals of (B, n)
# parameters and points, prior on the free parameters.
FinalStart = tuple[
    Observations, FloatArray, NDArray[np.bool_], Callable[..., Residuals], GaussianPrior
]


def final_fits(starts: Sequence[FinalStart]) -> list[CameraSolution]:
    """The best pinhole camera of each frame for the elements that are believed, solved together."""
    requests = [
        final_request(*start, bounded=lower_bounded_parameter(start[1]))
        for start in starts
        if start[0].spreads is None
    ]
    solutions = iter(solve_all(requests))
    return [
        CameraSolution((final := next(solutions)).vectors[0], final, start[4], start[0], start[2])
        if start[0].spreads is None
        else final_fit(*start)
        for start in starts
    ]


def final_fit(
    seen: Observations,
    vectors: FloatArray,
    left_out: NDArray[np.bool_],
    residuals: Callable[..., Residuals],
    prior: GaussianPrior,
    basis: FloatArray | None = None,
) -> CameraSolution:
    """The best camera for the elements that are believed. Spots that are not known exactly are
    whitened by the camera that comes out.

    Args:
        vectors: (1, n) parameters to begin with, nearly right.
        left_out: (E,) elements taken for mistakes.
        residuals: (B, n) parameters, observations -> residuals.
        basis: (3, 3) homography that is corrected; None for a pinhole.
    """
    bounded = None if basis is not None else lower_bounded_parameter(vectors)
    for _ in range(_WHITENING_ROUNDS):
        request = final_request(seen, vectors, left_out, residuals, prior, bounded=bounded)
        final = solve_request(request)
        found = CameraSolution(final.vectors[0], final, prior, seen, left_out, basis)
        if seen.spreads is None:
            break
        error_px = estimate_click_sd(found.components, prior.mean.shape[1])
        seen = whitened(seen, linear_map(found.vector, basis), error_px)
        vectors = final.vectors
    return found


def final_request(
    seen: Observations,
    vectors: FloatArray,
    left_out: NDArray[np.bool_],
    residuals: Callable[..., Residuals],
    prior: GaussianPrior,
    *,
    bounded: int | None = KAPPA,
    held: NDArray[np.bool_] | None = None,
    iterations: int = 20,
    tolerance: float = 1e-5,
) -> SolveRequest:
    """One descent of (B, n) parameters on the points of the elements that are believed."""
    kept = seen.with_excluded(left_out)
    look = partial(residuals, seen=kept)
    problem = Problem(look, kept.weights, FINAL_LOSS, prior, bounded=bounded, held=held)
    return SolveRequest(problem, vectors, iterations=iterations, tolerance=tolerance)


def fit_models(
    scene: FitScene,
    vector: FloatArray,
    left_out: NDArray[np.bool_],
    models: Sequence[str],
) -> dict[str, CameraSolution]:
    """The final fits of several pinhole models to the same elements, sharing the work.

    Args:
        vector: (11,) parameters that are nearly right.
        left_out: (E,) elements taken for mistakes.
        models: P, R, R+ or some of them, the simplest first.
    """
    free = np.array([FREE_PARAMETERS[model] for model in models])
    most = int(free.max())
    fixed = np.arange(len(vector)) >= free[:, None]
    vectors = np.where(fixed, 0.0, vector)
    rows = [prior_near(row, scene.around, most) for row in vectors]
    prior = GaussianPrior(
        np.concatenate([one.mean for one in rows]), np.concatenate([one.inverse_sd for one in rows])
    )
    seen = whitened(scene.seen, linear_map(vector))
    request = final_request(
        seen, vectors, left_out, scene.residuals(most), prior, held=fixed[:, :most], tolerance=1e-4
    )
    found = solve_request(request)
    return {
        model: CameraSolution(
            found.vectors[row],
            found.only(row, FREE_PARAMETERS[model]),
            GaussianPrior(
                prior.mean[[row], : FREE_PARAMETERS[model]],
                prior.inverse_sd[[row], : FREE_PARAMETERS[model]],
            ),
            seen,
            left_out,
        )
        for row, model in enumerate(models)
    }


_SEARCH_POINTS = 3  # points of an element that the search looks at
_SEARCH_ROUNDS = ((4, 14), (5, 4))  # iterations, and how many searches go on after them
# Cameras nearer to each other than this share of the way to the usual one stand in one place.
_SAME_CAMERA_DISTANCE = 0.016
_RETAINED_BYTES = 2**21
_HOPELESS_RATIO = 3.0  # times the cost of a search that has ended
# How far a homography may leave the pinhole camera it is found from, where no point says so.
_CORRECTION_SD = 0.1


def search_cameras(scenes: Sequence[FitScene], model: str) -> list[CameraSolution]:
    """Fit a pinhole model to each of several frames without starts, all solved together."""
    return _fit_best_starts(scenes, _best_starts(scenes), model)


def refine_camera(scene: FitScene, model: str, start: FloatArray) -> CameraSolution:
    """Fit a pinhole model from parameters (11,) that are nearly right; stale if they are not."""
    free = FREE_PARAMETERS[model]
    start = start.copy()
    start[free:] = 0.0
    vector, left_out = inlier_elements_near(scene, start, model)
    prior = prior_near(vector, scene.around, free)
    found = final_fit(scene.seen, vector[None], left_out, scene.residuals(free), prior)
    same_side = camera_side(found.vector, scene.around) == camera_side(vector, scene.around)
    if found.has_stale_start or (same_side and found.is_consistent):
        return found
    return _fit_best_starts([scene], [vector[None]], model)[0]


def inlier_elements_near(
    scene: FitScene, start: FloatArray, model: str
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """Return (11,) parameters to go on from, and (E,) the elements to leave out, near a camera
    (11,) of a model P, R or R+ that was known before.

    Usually the last edit changed little: what was a mistake still is, and nothing else. But what is
    far off may only be new: where the camera was little known it has much to say.
    """
    around, free = scene.around, FREE_PARAMETERS[model]
    residuals = scene.residuals(free)
    seen = whitened(scene.seen, linear_map(start))
    left_out = outlier_elements(seen, residuals(start[None], seen).distances[0])
    if not left_out.any():
        return start, left_out
    nobody = np.zeros_like(left_out)
    prior = prior_near(start, around, free)
    heard = solve_request(final_request(seen, start[None], nobody, residuals, prior, iterations=8))
    all_agree = (heard.distances[0] <= OUTLIER_PX).all()
    if all_agree and camera_side(heard.vectors[0], around) == camera_side(start, around):
        return heard.vectors[0], nobody
    return start, left_out


def refine_homography(seen: Observations, basis: FloatArray) -> CameraSolution:
    """Fit a homography to points on elements on the ground, from one (3, 3), ground -> solver px,
    that is nearly right."""
    residuals = partial(homography_residuals, basis=basis)
    seen = whitened(seen, linear_map(np.zeros(8), basis))
    prior = GaussianPrior(np.zeros((1, 8)), np.full((1, 8), 1 / _CORRECTION_SD))
    problem = Problem(partial(residuals, seen=seen), seen.weights, ROBUST_LOSS, prior)
    robust = solve(problem, np.zeros((1, 8)), iterations=20, tolerance=1e-3)
    left_out = outlier_elements(seen, robust.distances[0])
    return final_fit(seen, robust.vectors, left_out, residuals, prior, basis=basis)


def search_homography(scene: FitScene) -> CameraSolution:
    """Fit a homography without a start: from the pinhole camera that explains the ground best."""
    found = search_cameras([scene], "P")[0]
    return refine_homography(scene.seen, homography_from_pinhole(found.vector))


def _best_starts(scenes: Sequence[FitScene]) -> list[FloatArray]:
    """(B, 11) for each frame: the best of its initial cameras after a few steps with few points."""
    _retain_freed_memory()
    starts = [initial_cameras(scene.seen, scene.field) for scene in scenes]
    few = [scene.seen.thinned(_SEARCH_POINTS) for scene in scenes]
    free = FREE_PARAMETERS["P"]
    sides = [one.sides for one in starts]
    going = [one.vectors for one in starts]
    for iterations, keep in _SEARCH_ROUNDS:
        requests = [
            SolveRequest(
                Problem(
                    partial(scene.residuals(free), seen=few[row], thorough=False),
                    few[row].weights,
                    SEARCH_LOSS,
                    search_prior(sides[row], scene.around, free),
                ),
                going[row],
                iterations,
            )
            for row, scene in enumerate(scenes)
        ]
        for row, (scene, found) in enumerate(zip(scenes, solve_all(requests), strict=True)):
            costs = found.costs + side_costs(sides[row], scene.around)
            best = _best_distinct(found.vectors, costs, keep, scene.around)
            going[row], sides[row] = found.vectors[best], sides[row][best]
    # Much may be the same from the other end; with all points what is not decides.
    return [
        vectors if scene.around.has_main_side else np.concatenate([vectors, rotated_180(vectors)])
        for scene, vectors in zip(scenes, going, strict=True)
    ]


@lru_cache(maxsize=1)
def _retain_freed_memory() -> None:
    """Have the memory of a step at hand in the next one.

    A search works on arrays of some 200 kB. The C library of Linux hands such ones back to the
    system and fetches them anew, page by page, a third of a step's time; unless a larger one was
    freed before, twice the size of which it keeps from then on (mallopt, M_MMAP_THRESHOLD).
    """
    np.empty(_RETAINED_BYTES, dtype=np.uint8)


def _fit_best_starts(
    scenes: Sequence[FitScene], starts: Sequence[FloatArray], model: str
) -> list[CameraSolution]:
    """The fit of each frame, from (B, 11) parameters that may lead to its camera."""
    # Aspect ratio and principal point only once it is known which elements to believe.
    free = min(FREE_PARAMETERS[model], FREE_PARAMETERS["R"])
    requests = []
    for scene, vectors in zip(scenes, starts, strict=True):
        # The first is the best of the search.
        seen = whitened(scene.seen, linear_map(vectors[0]))
        residuals = partial(scene.residuals(free), seen=seen, thorough=False)
        # A search may have led round a corner: what is expected of a camera goes by where it is.
        prior = wide_prior(camera_sides(vectors, scene.around), scene.around, free)
        problem = Problem(residuals, seen.weights, ROBUST_LOSS, prior, bounded=KAPPA)
        requests.append(SolveRequest(problem, vectors, 20, 1e-3, _HOPELESS_RATIO))
    finals = [
        _final_start(scene, vectors, robust, model)
        for scene, vectors, robust in zip(scenes, starts, solve_all(requests), strict=True)
    ]
    return final_fits(finals)


def _final_start(scene: FitScene, vectors: FloatArray, robust: Solution, model: str) -> FinalStart:
    """The best of the robust searches from (B, 11) starts, and the elements it leaves out."""
    seen, around = whitened(scene.seen, linear_map(vectors[0])), scene.around
    free = min(FREE_PARAMETERS[model], FREE_PARAMETERS["R"])
    best = _best_plausible_row(robust, camera_sides(vectors, around), around)
    chosen = robust.vectors[[best]]
    prior = prior_near(chosen[0], around, FREE_PARAMETERS[model])
    distances = robust.distances[best]
    if seen.curve_pairs > seen.line_pairs or seen.spreads is not None:
        # Those of curves were not thorough, and spots were softened by another camera.
        seen = whitened(seen, linear_map(chosen[0]))
        distances = scene.residuals(free)(chosen, seen).distances[0]
    left_out = outlier_elements(seen, distances)
    return seen, chosen, left_out, scene.residuals(FREE_PARAMETERS[model]), prior


def _best_plausible_row(solution: Solution, sides: IntArray, around: CameraPlacementPrior) -> int:
    costs = solution.costs + side_costs(sides, around)
    order = np.argsort(costs, kind="stable").tolist()
    plausible = (i for i in order if not implausible_reason(solution.vectors[i], around))
    return int(next(plausible, order[0]))


def _best_distinct(
    vectors: FloatArray, costs: FloatArray, most: int, around: CameraPlacementPrior
) -> IntArray:
    """The cheapest of the searches, of those that came to the same place only one."""
    order = np.argsort(costs, kind="stable")
    left = vectors[order, :KAPPA]
    # Angles, place, and focal length less apart than this are the same camera.
    least = np.array([*(0.02,) * 3, *(_SAME_CAMERA_DISTANCE * around.reach,) * 3, 0.03])
    chosen: list[int] = []
    while len(order) and len(chosen) < most:
        chosen.append(int(order[0]))
        others = ~(np.abs(left - left[0]) < least).all(axis=1)
        others[0] = False
        order, left = order[others], left[others]
    return np.array(chosen, dtype=np.intp)
