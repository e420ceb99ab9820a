"""From annotated points to the parameters of a pinhole camera: many starts, few survivors, one fit."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.model import Field
from procc_annotator.fit.models import FREE, KAPPA, LOG_FOCAL, X, Z
from procc_annotator.fit.observations import FloatArray, Frame, Observations
from procc_annotator.fit.residual import pinhole_residuals
from procc_annotator.fit.solver import Loss, Prior, Problem, Solution, solve
from procc_annotator.fit.starts import (
    Extent,
    Starts,
    all_starts,
    extent_of,
    search_prior,
    side_of,
    wide_prior,
)

# Points of an element that the search looks at.
_SEARCH_POINTS = 3
_SEARCH_LOSS = Loss("cauchy", 10.0)
_ROBUST_LOSS = Loss("geman_mcclure", 8.0)
_FINAL_LOSS = Loss("huber", 2.0)
# An element farther off than this is taken for a mistake and has no say in the final fit.
OUTLIER_PX = 15.0
_SURVIVORS = 3


@dataclass(frozen=True, eq=False)
class Found:
    """A fitted pinhole.

    Attributes:
        vector: (11,) parameters.
        solution: of the final stage, one camera.
        prior: of the final stage.
        left_out: (E,) elements taken for mistakes.
    """

    vector: FloatArray
    solution: Solution
    prior: Prior
    left_out: NDArray[np.bool_]


def search(seen: Observations, field: Field, frame: Frame, model: str) -> Found:
    """Fit a pinhole model without a start."""
    extent = extent_of(field)
    starts = all_starts(seen, field)
    few = seen.thinned(_SEARCH_POINTS)
    starts = _stage(few, frame, extent, starts, iterations=4, keep=12)
    starts = _stage(few, frame, extent, starts, iterations=10, keep=_SURVIVORS)
    return _finish(seen, frame, extent, starts, model)


def refine(seen: Observations, field: Field, frame: Frame, model: str, start: FloatArray) -> Found:
    """Fit a pinhole model from a start that is nearly right."""
    extent = extent_of(field)
    sides = np.array([side_of(start, extent)])
    return _finish(seen, frame, extent, Starts(start[None].copy(), sides), model)


def _stage(
    seen: Observations, frame: Frame, extent: Extent, starts: Starts, *, iterations: int, keep: int
) -> Starts:
    free = FREE["P"]
    problem = Problem(
        partial(pinhole_residuals, seen=seen, half_diagonal=frame.half_diagonal, free=free),
        seen.weights,
        _SEARCH_LOSS,
        search_prior(starts.sides, extent, free),
    )
    found = solve(problem, starts.vectors, iterations=iterations)
    return Starts(found.vectors, starts.sides).chosen(
        _distinct_best(found.vectors, found.costs, keep)
    )


def _finish(
    seen: Observations, frame: Frame, extent: Extent, starts: Starts, model: str
) -> Found:
    robust_free = FREE["P" if model == "P" else "R"]
    vectors = starts.vectors
    vectors[:, robust_free:] = np.where(model == "R+", vectors[:, robust_free:], 0.0)
    problem = Problem(
        partial(
            pinhole_residuals, seen=seen, half_diagonal=frame.half_diagonal, free=robust_free
        ),
        seen.weights,
        _ROBUST_LOSS,
        wide_prior(starts.sides, extent, robust_free),
        not_negative=KAPPA,
    )
    robust = solve(problem, vectors, iterations=20)
    best = int(np.argmin(robust.costs))
    left_out = seen.worst_of_element(robust.residuals.distances[best]) > OUTLIER_PX
    kept = seen.leaving_out(left_out)
    prior = wide_prior(starts.sides[best : best + 1], extent, FREE[model])
    problem = Problem(
        partial(
            pinhole_residuals, seen=kept, half_diagonal=frame.half_diagonal, free=FREE[model]
        ),
        kept.weights,
        _FINAL_LOSS,
        prior,
        not_negative=KAPPA,
    )
    final = solve(problem, robust.vectors[best : best + 1], iterations=20, tolerance=1e-5)
    return Found(final.vectors[0], final, prior, left_out)


def _distinct_best(vectors: FloatArray, costs: FloatArray, most: int) -> NDArray[np.intp]:
    """The cheapest of the searches, of those that came to the same place only one."""
    chosen: list[int] = []
    for index in np.argsort(costs, kind="stable").tolist():
        same = any(_alike(vectors[index], vectors[other]) for other in chosen)
        if not same:
            chosen.append(index)
        if len(chosen) == most:
            break
    return np.array(chosen, dtype=np.intp)


def _alike(a: FloatArray, b: FloatArray) -> bool:
    apart = np.abs(a - b)
    return bool(
        (apart[X : Z + 1] < 1.0).all() and apart[LOG_FOCAL] < 0.03 and (apart[:3] < 0.02).all()
    )
