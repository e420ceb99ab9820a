"""Levenberg-Marquardt for B starts at once, robust by iteratively reweighted least squares."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.models import LEAST_KAPPA
from procc_annotator.fit.solving.observations import FloatArray, IntArray
from procc_annotator.fit.solving.residual import Residuals

LossKind = Literal["cauchy", "geman_mcclure", "huber", "squared"]

_FIRST_DAMPING = 1e-3
_EASED, _RAISED = 0.15, 6.0
_LEAST_DAMPING, _MOST_DAMPING = 1e-8, 1e8


@dataclass(frozen=True)
class Loss:
    """What a distance costs: half its square at first, less and less beyond ``scale``."""

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


# What a search goes by, what tells mistakes apart, and what the result is the best one for.
SEARCH_LOSS = Loss("cauchy", 10.0)
ROBUST_LOSS = Loss("geman_mcclure", 8.0)
FINAL_LOSS = Loss("huber", 2.0)


@dataclass(frozen=True, eq=False)
class Prior:
    """Where parameters are expected: (B or 1, n) means, and inverse standard deviations."""

    mean: FloatArray
    inverse_sd: FloatArray


@dataclass(frozen=True, eq=False)
class Solution:
    """Where B searches ended, or are.

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
        """What a problem is at (B, m) parameters."""
        found = problem.residuals(vectors)
        cost, weight = problem.loss.cost_and_weight(found.distances)
        cost, weight = cost @ problem.weights, weight * problem.weights
        count, free = found.derivatives.shape[:2]
        derivatives = found.derivatives.reshape(count, free, -1)
        weighted = (found.derivatives * weight[:, None, None]).reshape(count, free, -1)
        off = (vectors[:, :free] - problem.prior.mean) * problem.prior.inverse_sd
        gradient = (weighted @ found.values.reshape(count, -1, 1))[:, :, 0]
        return cls(
            vectors,
            cost + (off * off).sum(axis=1) / 2,
            found.values,
            found.whole,
            weighted @ derivatives.transpose(0, 2, 1),
            gradient + off * problem.prior.inverse_sd,
        )

    @property
    def distances(self) -> FloatArray:
        """(B, N) solver px of the points."""
        return np.asarray(np.hypot(self.values[:, 0], self.values[:, 1]))

    def chosen(self, rows: IntArray) -> Solution:
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
    """What is minimised: the weighted cost of the points' distances plus half the squared prior.

    Attributes:
        residuals: (B, m) parameters -> residuals, with derivatives by the first n parameters.
        weights: (N,) of the points.
        loss: of a point's distance.
        prior: on the first n parameters.
        bounded: index of a parameter that may not fall below 0, if any; in searches that start
            below 0, not below `least`.
        held: (B, n) parameters that stay as they are, so that searches over fewer parameters can
            share the work with searches over more; None for none.
        least: see `bounded`.
    """

    residuals: Callable[[FloatArray], Residuals]
    weights: FloatArray
    loss: Loss
    prior: Prior
    bounded: int | None = None
    held: NDArray[np.bool_] | None = None
    least: float = LEAST_KAPPA

    @property
    def free(self) -> int:
        """Number of free parameters."""
        return int(self.prior.mean.shape[1])

    def floor(self, starts: FloatArray) -> FloatArray:
        """(B,) what the bounded parameter may fall to in searches from starts (B, m)."""
        if self.bounded is None:
            return np.full(len(starts), -np.inf)
        return np.where(starts[:, self.bounded] < 0, self.least, 0.0)


def solve(
    problem: Problem,
    starts: FloatArray | Solution,
    *,
    iterations: int,
    tolerance: float = 1e-4,
    hopeless: float = np.inf,
) -> Solution:
    """Minimise from every start.

    Args:
        problem: what to minimise.
        starts: (B, m) parameters, of which those after the first n stay as they are; or where
            searches are that went by the same residuals, weights, loss and prior.
        iterations: at most so many.
        tolerance: a search ends when a step lowers its cost by less than this share of it.
        hopeless: once a search has ended, others end that cost so many times as much.
    """
    at = starts if isinstance(starts, Solution) else Solution.at(problem, starts)
    count, free = len(at.vectors), problem.free
    floor = problem.floor(at.vectors)
    damping = np.full(count, _FIRST_DAMPING)
    stiffness = problem.prior.inverse_sd**2
    running = np.ones(count, dtype=bool)
    made = 0
    for made in range(1, iterations + 1):  # noqa: B007
        normal, gradient = at.normal.copy(), at.gradient
        diagonal = np.einsum("bii->bi", normal)  # a view
        diagonal += stiffness
        pinned = _pinned(problem, at, floor)
        if pinned is not None:
            gradient = np.where(pinned, 0.0, gradient)
            normal[pinned] = 0.0
            normal.transpose(0, 2, 1)[pinned] = 0.0
        nothing = diagonal == 0
        diagonal *= 1 + damping[:, None]
        diagonal += 1e-12
        diagonal += nothing
        step = np.linalg.solve(normal, gradient[:, :, None])[:, :, 0]
        tried = at.vectors.copy()
        tried[:, :free] -= step
        if problem.bounded is not None:
            lowest = tried[:, problem.bounded]
            np.maximum(lowest, floor, out=lowest)
        new = Solution.at(problem, tried)
        better = running & (new.costs < at.costs)
        gain = np.where(better, at.costs - new.costs, 0.0)
        hoped = (step * gradient).sum(axis=1) / 2
        small = np.where(better, gain, hoped) <= tolerance * at.costs
        damping = np.where(better, damping * _EASED, damping * _RAISED)
        damping = np.minimum(np.maximum(damping, _LEAST_DAMPING), _MOST_DAMPING)
        running &= ~small & (damping < _MOST_DAMPING)
        at = new if better.all() else at.replaced_where(better, new)
        if not running.all():
            running &= at.costs <= hopeless * at.costs[~running].min()
            if not running.any():
                break
    return replace(at, steps=made)


def _pinned(problem: Problem, at: Solution, floor: FloatArray) -> NDArray[np.bool_] | None:
    """(B, n) parameters that are held, or lie on their bound and would be pushed through it."""
    index = problem.bounded
    if index is None or index >= problem.free:
        return problem.held
    pinned = (
        np.zeros(at.gradient.shape, dtype=bool) if problem.held is None else problem.held.copy()
    )
    pinned[:, index] |= (at.vectors[:, index] <= floor) & (at.gradient[:, index] > 0)
    return pinned if pinned.any() else None
