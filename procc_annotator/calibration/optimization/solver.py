"""Batched Levenberg-Marquardt with robust losses (IRLS) and Gaussian priors, for the starts of one
frame or of several frames at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.camera_parameters import MIN_KAPPA
from procc_annotator.calibration.optimization.closest_points import (
    BatchedObservations,
    BatchSizes,
    is_batchable,
    point_columns,
)
from procc_annotator.calibration.optimization.observations import Observations
from procc_annotator.calibration.optimization.residuals import Residuals, pinhole_residuals

LossKind = Literal["cauchy", "geman_mcclure", "huber", "squared"]

_INITIAL_DAMPING = 1e-3
_DAMPING_DECREASE, _DAMPING_INCREASE = 0.15, 6.0
_MIN_DAMPING, _MAX_DAMPING = 1e-8, 1e8


@dataclass(frozen=True)
class RobustLoss:
    """Robust cost of a distance: half its square at first, less and less beyond ``scale``."""

    kind: LossKind
    scale: float  # solver px

    def cost_and_weight(self, distances: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Cost of each distance, and the weight its square gets in the next step."""
        squares = distances * distances
        if self.kind == "squared":
            return squares / 2, np.ones_like(squares)
        if self.kind == "huber":
            weight = self.scale / np.maximum(distances, self.scale)
            # For r > s: s r - s^2 / 2; both cases at once, weight being s / r or 1.
            return weight * squares - weight * weight * squares / 2, weight
        part = self.scale**2
        if self.kind == "cauchy":
            return part / 2 * np.log1p(squares / part), part / (part + squares)
        share = part / (part + squares)
        return squares * share / 2, share * share


# What a search goes by, what distinguishes mistakes, and what the result is the best one for.
SEARCH_LOSS = RobustLoss("cauchy", 10.0)
ROBUST_LOSS = RobustLoss("geman_mcclure", 8.0)
FINAL_LOSS = RobustLoss("huber", 2.0)


@dataclass(frozen=True, eq=False)
class GaussianPrior:
    """Prior of parameters: (B or 1, n) means, and inverse standard deviations."""

    mean: FloatArray
    inverse_sd: FloatArray


@dataclass(frozen=True, eq=False)
class Solution:
    """State or result of B searches.

    Attributes:
        vectors: (B, m) parameters.
        costs: (B,) robust cost there, prior included.
        values: (B, 2, N) residuals of the points, solver px.
        whole: (B, N) whether both of their rows count.
        normal: (B, n, n) weighted J^T J of the data alone, of the n free parameters.
        gradient: (B, n) of the cost, prior included.
        steps: iterations made.
    """

    vectors: FloatArray
    costs: FloatArray
    values: FloatArray
    whole: NDArray[np.bool_]
    normal: FloatArray
    gradient: FloatArray
    steps: int = 0

    @classmethod
    def at(cls, problem: Problem, vectors: FloatArray) -> Solution:
        """Return what a problem is at (B, m) parameters."""
        found = problem.residuals(vectors)
        cost, normal, gradient = problem.summed(found)
        free = gradient.shape[1]
        off = (vectors[:, :free] - problem.prior.mean) * problem.prior.inverse_sd
        return cls(
            vectors,
            cost + (off * off).sum(axis=1) / 2,
            found.values,
            found.whole,
            normal,
            gradient + off * problem.prior.inverse_sd,
        )

    @property
    def distances(self) -> FloatArray:
        """(B, N) solver px of the points."""
        return np.asarray(np.hypot(self.values[:, 0], self.values[:, 1]))

    def chosen(self, rows: IntArray | NDArray[np.bool_]) -> Solution:
        """Some of the searches, in the order asked for."""
        return Solution(
            self.vectors[rows],
            self.costs[rows],
            self.values[rows],
            self.whole[rows],
            self.normal[rows],
            self.gradient[rows],
            self.steps,
        )

    def only(self, row: int, free: int) -> Solution:
        """One of the searches, as one over the first ``free`` parameters."""
        one = self.chosen(np.array([row]))
        return replace(one, normal=one.normal[:, :free, :free], gradient=one.gradient[:, :free])

    def replaced_where(self, chosen: NDArray[np.bool_], other: Solution) -> Solution:
        """The same, some of its searches being where another has them."""
        if not chosen.any():
            return self
        one, two = chosen[:, None], chosen[:, None, None]
        return Solution(
            np.where(one, other.vectors, self.vectors),
            np.where(chosen, other.costs, self.costs),
            np.where(two, other.values, self.values),
            np.where(one, other.whole, self.whole),
            np.where(two, other.normal, self.normal),
            np.where(one, other.gradient, self.gradient),
        )


@dataclass(frozen=True, eq=False)
class Problem:
    """Objective: the weighted cost of the points' distances plus half the squared prior.

    Attributes:
        residuals: (B, m) parameters -> residuals, with derivatives by the first n parameters.
        weights: (N,) of the points.
        prior: on the first n parameters.
        bounded: index of a parameter that may not fall below 0, if any; in searches that start
            below 0, not below `least`.
        held: (B, n) parameters that stay as they are, so that searches over fewer parameters can
            share the work with searches over more; None for none.
        least: see `bounded`.
    """

    residuals: Callable[[FloatArray], Residuals]
    weights: FloatArray
    loss: RobustLoss
    prior: GaussianPrior
    bounded: int | None = None
    held: NDArray[np.bool_] | None = None
    least: float = MIN_KAPPA

    @property
    def free(self) -> int:
        """Number of free parameters."""
        return int(self.prior.mean.shape[1])

    def summed(self, found: Residuals) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return what N residuals of B cameras sum up to, of the points alone: (B,) cost, (B, n, n)
        weighted J^T J, (B, n) gradient."""
        cost, weight = self.loss.cost_and_weight(found.distances)
        weight = weight * self.weights
        count, free = found.derivatives.shape[:2]
        weighted = (found.derivatives * weight[:, None, None]).reshape(count, free, -1)
        gradient = (weighted @ found.values.reshape(count, -1, 1))[:, :, 0]
        rows = found.derivatives.reshape(count, free, -1)
        return cost @ self.weights, weighted @ rows.transpose(0, 2, 1), gradient

    def hopeful(
        self, costs: FloatArray, running: NDArray[np.bool_], hopeless: float
    ) -> NDArray[np.bool_]:
        """(B,) whether searches cost less than so many times what one does that has ended."""
        return np.asarray(costs <= hopeless * costs[~running].min())

    def floor(self, starts: FloatArray) -> FloatArray:
        """(B,) what the bounded parameter may fall to in searches from starts (B, m)."""
        if self.bounded is None:
            return np.full(len(starts), -np.inf)
        return np.where(starts[:, self.bounded] < 0, self.least, 0.0)


@dataclass(frozen=True, eq=False)
class SolveRequest:
    """A minimisation request: objective, start and limit.

    Attributes:
        starts: (B, m) parameters, of which those after the first n stay as they are.
        tolerance: a search ends when a step lowers its cost by less than this share of it.
        hopeless: once a search has ended, others end that cost so many times as much.
    """

    problem: Problem
    starts: FloatArray
    iterations: int
    tolerance: float = 1e-4
    hopeless: float = np.inf


def solve(
    problem: Problem,
    starts: FloatArray,
    *,
    iterations: int,
    tolerance: float = 1e-4,
    hopeless: float = np.inf,
) -> Solution:
    """Minimise from every start; see `SolveRequest`."""
    return solve_request(SolveRequest(problem, starts, iterations, tolerance, hopeless))


def solve_request(request: SolveRequest) -> Solution:
    """Minimise from every start."""
    state = SolverState.begun(request.problem, request.starts)
    made = 0
    for made in range(1, request.iterations + 1):  # noqa: B007
        state.step(request.problem, request.tolerance, request.hopeless)
        if not state.running.any():
            break
    return replace(state.at, steps=made)


@dataclass(eq=False)
class SolverState:
    """State of B searches.

    Attributes:
        floor: (B,) what their bounded parameter may fall to.
        damping: (B,) of their next steps.
        running: (B,) whether they go on.
    """

    at: Solution
    floor: FloatArray
    damping: FloatArray
    running: NDArray[np.bool_]

    @classmethod
    def begun(cls, problem: Problem, starts: FloatArray) -> SolverState:
        """At the beginning."""
        count = len(starts)
        damping, running = np.full(count, _INITIAL_DAMPING), np.ones(count, dtype=bool)
        return cls(Solution.at(problem, starts), problem.floor(starts), damping, running)

    def chosen(self, rows: NDArray[np.bool_]) -> SolverState:
        """Some of them (B,)."""
        return SolverState(
            self.at.chosen(rows), self.floor[rows], self.damping[rows], self.running[rows]
        )

    def step(self, problem: Problem, tolerance: float, hopeless: float) -> None:
        """One step of all searches; of those that ended none is taken."""
        at, damping = self.at, self.damping
        step, hoped = _damped_step(problem, at, self.floor, damping)
        tried = at.vectors.copy()
        tried[:, : problem.free] -= step
        if problem.bounded is not None:
            lowest = tried[:, problem.bounded]
            np.maximum(lowest, self.floor, out=lowest)
        new = Solution.at(problem, tried)
        better = self.running & (new.costs < at.costs)
        gain = np.where(better, at.costs - new.costs, 0.0)
        small = np.where(better, gain, hoped) <= tolerance * at.costs
        damping = np.where(better, damping * _DAMPING_DECREASE, damping * _DAMPING_INCREASE)
        self.damping = np.minimum(np.maximum(damping, _MIN_DAMPING), _MAX_DAMPING)
        self.running = self.running & ~small & (self.damping < _MAX_DAMPING)
        self.at = new if better.all() else at.replaced_where(better, new)
        if not self.running.all():
            self.running &= problem.hopeful(self.at.costs, self.running, hopeless)


def _damped_step(
    problem: Problem, at: Solution, floor: FloatArray, damping: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """(B, n) what parameters are to be lowered by, and (B,) what cost that is hoped to save."""
    normal, gradient = at.normal.copy(), at.gradient
    diagonal = np.einsum("bii->bi", normal)  # a view
    diagonal += problem.prior.inverse_sd**2
    pinned = _held_or_bounded(problem, at, floor)
    if pinned is not None:
        gradient = np.where(pinned, 0.0, gradient)
        normal[pinned] = 0.0
        normal.transpose(0, 2, 1)[pinned] = 0.0
    nothing = diagonal == 0
    diagonal *= 1 + damping[:, None]
    diagonal += 1e-12
    diagonal += nothing
    step = np.asarray(np.linalg.solve(normal, gradient[:, :, None])[:, :, 0], dtype=np.float64)
    return step, (step * gradient).sum(axis=1) / 2


def _held_or_bounded(problem: Problem, at: Solution, floor: FloatArray) -> NDArray[np.bool_] | None:
    """(B, n) parameters that are held, or lie on their bound and would be pushed through it."""
    index = problem.bounded
    if index is None or index >= problem.free:
        return problem.held
    pinned = (
        np.zeros(at.gradient.shape, dtype=bool) if problem.held is None else problem.held.copy()
    )
    pinned[:, index] |= (at.vectors[:, index] <= floor) & (at.gradient[:, index] > 0)
    return pinned if pinned.any() else None


# Arrays of more cameras than this are large enough for one frame alone.
_MAX_BATCH_STARTS = 32
# A stack is made anew where so many of its frames have ended.
_COMPACTION_SHARE = 0.25


def solve_all(requests: Sequence[SolveRequest]) -> list[Solution]:
    """Minimise each request; requests of one kind step together, which halves the time of many.

    Small arrays cost mostly the calls: with R on World Cup 2014 a fit takes 24 ms of CPU in batches
    of 16 frames, 45 ms frame by frame.
    """
    if len(requests) == 1:
        return [solve_request(requests[0])]
    kinds: dict[object, list[int]] = {}
    for row, request in enumerate(requests):
        kinds.setdefault(_batch_key(request) or row, []).append(row)
    found: dict[int, Solution] = {}
    for rows in kinds.values():
        if len(rows) == 1:
            found[rows[0]] = solve_request(requests[rows[0]])
        else:
            found.update(zip(rows, _solve_batch([requests[row] for row in rows]), strict=True))
    return [found[row] for row in range(len(requests))]


def _batch_key(request: SolveRequest) -> tuple[object, ...] | None:
    """Equal for descents that can be made at once; None for what is to be made alone."""
    problem = request.problem
    look = problem.residuals
    alone = problem.held is not None or len(request.starts) > _MAX_BATCH_STARTS
    if alone or not isinstance(look, partial) or look.func is not pinhole_residuals:
        return None
    options = {name: value for name, value in look.keywords.items() if name != "seen"}
    if look.args or not is_batchable(look.keywords["seen"]):
        return None
    return (
        tuple(sorted(options.items())),
        (problem.loss, problem.bounded, problem.least, problem.free),
        (request.iterations, request.tolerance, request.hopeless),
    )


def _solve_batch(requests: Sequence[SolveRequest]) -> list[Solution]:
    problems = [one.problem for one in requests]
    counts = np.array([len(one.starts) for one in requests])
    sizes = BatchSizes.of([_observations_of(problem) for problem in problems])
    batch = list(range(len(requests)))  # the frames in it
    problem = _BatchProblem.of(problems, counts, sizes)
    state = SolverState.begun(problem, np.concatenate([one.starts for one in requests]))
    found: dict[int, Solution] = {}
    limit, tolerance, hopeless = (
        requests[0].iterations,
        requests[0].tolerance,
        requests[0].hopeless,
    )
    for made in range(1, limit + 1):
        state.step(problem, tolerance, hopeless)
        going = np.array([state.running[rows].any() for rows in problem.rows])
        for row, one in enumerate(batch):
            if one not in found and (made == limit or not going[row]):
                found[one] = replace(problem.solution_of(state.at, row), steps=made)
        if not going.any():
            break
        if going.mean() <= 1 - _COMPACTION_SHARE:
            state = state.chosen(going[problem.frame_of_row])
            batch = [one for one, still in zip(batch, going, strict=True) if still]
            problem = _BatchProblem.of([problems[one] for one in batch], counts[batch], sizes)
    return [found[one] for one in range(len(requests))]


def _observations_of(problem: Problem) -> Observations:
    residuals: Any = problem.residuals  # a partial, see `_batch_key`
    seen: Observations = residuals.keywords["seen"]
    return seen


@dataclass(frozen=True, eq=False)
class _BatchProblem(Problem):
    """The problems of several frames, as one.

    Attributes:
        frames: (F,) those of the frames.
        rows: (F,) the cameras of each.
        columns: (F,) its points among those of the stack.
        frame_of_row: (B,) of which frame each camera is.
    """

    frames: tuple[Problem, ...] = ()
    rows: tuple[slice, ...] = ()
    columns: tuple[IntArray, ...] = ()
    frame_of_row: IntArray = field(default_factory=lambda: np.empty(0, dtype=np.intp))

    @classmethod
    def of(cls, problems: Sequence[Problem], counts: IntArray, sizes: BatchSizes) -> _BatchProblem:
        """As one, with so many cameras (F,) of each."""
        residuals: Any = problems[0].residuals
        seen = [_observations_of(problem) for problem in problems]
        stack = BatchedObservations.of(seen, counts, sizes)
        until = np.cumsum(counts).tolist()
        pairs = list(zip(problems, counts.tolist(), strict=True))
        size = problems[0].free
        return cls(
            partial(residuals, seen=stack),
            np.empty(0),
            problems[0].loss,
            GaussianPrior(
                np.concatenate([np.broadcast_to(p.prior.mean, (n, size)) for p, n in pairs]),
                np.concatenate([np.broadcast_to(p.prior.inverse_sd, (n, size)) for p, n in pairs]),
            ),
            problems[0].bounded,
            None,
            problems[0].least,
            tuple(problems),
            tuple(slice(end - n, end) for end, n in zip(until, counts.tolist(), strict=True)),
            tuple(point_columns(one, stack.line_pairs) for one in seen),
            stack.frame_of_row,
        )

    def summed(self, found: Residuals) -> tuple[FloatArray, FloatArray, FloatArray]:
        parts = [
            problem.summed(
                Residuals(
                    found.values[rows].take(columns, axis=2),
                    found.derivatives[rows].take(columns, axis=3),
                    found.distances[rows].take(columns, axis=1),
                    found.whole,
                    found.along,
                )
            )
            for problem, rows, columns in zip(self.frames, self.rows, self.columns, strict=True)
        ]
        costs, normals, gradients = zip(*parts, strict=True)
        return np.concatenate(costs), np.concatenate(normals), np.concatenate(gradients)

    def hopeful(
        self, costs: FloatArray, running: NDArray[np.bool_], hopeless: float
    ) -> NDArray[np.bool_]:
        ended = np.where(running, np.inf, costs)
        least = np.array([ended[rows].min() for rows in self.rows])[self.frame_of_row]
        return np.asarray((costs <= hopeless * least) | np.isinf(least))

    def solution_of(self, at: Solution, frame: int) -> Solution:
        """The searches of one frame among those of all."""
        rows, columns = self.rows[frame], self.columns[frame]
        return Solution(
            at.vectors[rows],
            at.costs[rows],
            at.values[rows].take(columns, axis=2),
            at.whole[rows].take(columns, axis=1),
            at.normal[rows],
            at.gradient[rows],
        )
