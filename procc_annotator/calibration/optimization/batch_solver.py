"""Solve the minimisation requests of many frames as one batch.

What finds a camera asks for one descent after another. Here the frames of a set take their steps
together, those that ask for descents of one kind: residuals are those of a stack, sums are made
frame by frame, and a frame is left out once all its searches have ended.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from procc_annotator.calibration.optimization.closest_points import (
    BatchedObservations,
    is_batchable,
    point_columns,
)
from procc_annotator.calibration.optimization.observations import FloatArray, IntArray, Observations
from procc_annotator.calibration.optimization.residuals import Residuals, pinhole_residuals
from procc_annotator.calibration.optimization.solver import (
    GaussianPrior,
    Problem,
    Solution,
    SolveRequest,
    SolverState,
    SolveSteps,
    normal_equations,
    solve_request,
)

# Arrays of more cameras than this are large enough for one frame alone.
_MAX_BATCH_STARTS = 32
# A stack is made anew where so many of its frames have ended.
_COMPACTION_SHARE = 0.25

T = TypeVar("T")


def run_batched(walks: Sequence[SolveSteps[T]]) -> list[T]:
    """Return what steps come to that are taken side by side; see `solver.walked`."""
    found: dict[int, T] = {}
    answers: dict[int, Solution | None] = dict.fromkeys(range(len(walks)))
    while answers:
        asked: dict[int, SolveRequest] = {}
        for row, answer in answers.items():
            try:
                asked[row] = next(walks[row]) if answer is None else walks[row].send(answer)
            except StopIteration as end:
                found[row] = end.value
        answers = dict(zip(asked, _solve_requests(list(asked.values())), strict=True))
    return [found[row] for row in range(len(walks))]


def _solve_requests(asked: Sequence[SolveRequest]) -> list[Solution]:
    kinds: dict[object, list[int]] = {}
    for row, descent in enumerate(asked):
        kinds.setdefault(_batch_key(descent) or row, []).append(row)
    found: dict[int, Solution] = {}
    for rows in kinds.values():
        if len(rows) == 1:
            found[rows[0]] = solve_request(asked[rows[0]])
        else:
            found.update(zip(rows, _solve_batch([asked[row] for row in rows]), strict=True))
    return [found[row] for row in range(len(asked))]


def _batch_key(asked: SolveRequest) -> tuple[object, ...] | None:
    """Equal for descents that can be made at once; None for what is to be made alone."""
    problem = asked.problem
    look = problem.residuals
    alone = problem.held is not None or len(_start_vectors(asked.starts)) > _MAX_BATCH_STARTS
    if alone or not isinstance(look, partial) or look.func is not pinhole_residuals:
        return None
    options = {name: value for name, value in look.keywords.items() if name != "seen"}
    if look.args or not is_batchable(look.keywords["seen"]):
        return None
    return (
        tuple(sorted(options.items())),
        (problem.loss, problem.bounded, problem.least, problem.free),
        (asked.iterations, asked.tolerance, asked.hopeless, isinstance(asked.starts, Solution)),
    )


def _start_vectors(starts: FloatArray | Solution) -> FloatArray:
    return starts.vectors if isinstance(starts, Solution) else starts


def _solve_batch(asked: Sequence[SolveRequest]) -> list[Solution]:
    """Minimise descents of one kind from all of their starts."""
    counts = np.array([len(_start_vectors(one.starts)) for one in asked])
    problem = _BatchProblem.of([one.problem for one in asked], counts)
    under_way = SolverState.begun(problem, _initial_solution(problem, asked))
    found: dict[int, Solution] = {}
    steps, going = np.zeros(len(asked), dtype=np.intp), np.ones(len(asked), dtype=bool)
    stack = np.arange(len(asked))  # the frames in it
    for made in range(1, asked[0].iterations + 1):
        under_way.step(problem, asked[0].tolerance, asked[0].hopeless)
        steps[going] = made
        still = problem.any_of_frame(under_way.running)
        going[stack] = still
        if not still.any():
            break
        if still.mean() <= 1 - _COMPACTION_SHARE:
            known = dict(zip(stack.tolist(), problem.apart(under_way.at), strict=True))
            found.update(known)
            rows, stack = still[problem.frame_of_row], stack[still]
            problem = _BatchProblem.of(
                [asked[one].problem for one in stack.tolist()], counts[stack]
            )
            at = problem.side_by_side([known[one] for one in stack.tolist()])
            under_way = under_way.chosen(rows, at)
    found.update(zip(stack.tolist(), problem.apart(under_way.at), strict=True))
    return [replace(found[one], steps=int(steps[one])) for one in range(len(asked))]


def _initial_solution(problem: _BatchProblem, asked: Sequence[SolveRequest]) -> Solution:
    known = [one.starts for one in asked if isinstance(one.starts, Solution)]
    if known:
        return problem.side_by_side(known)
    return Solution.at(problem, np.concatenate([_start_vectors(one.starts) for one in asked]))


@dataclass(frozen=True, eq=False)
class _BatchProblem(Problem):
    """The problems of several frames, as one.

    Attributes:
        frames: (F,) those of the frames.
        rows: (F,) the cameras of each.
        columns: (F,) its points among those of the stack.
        frame_of_row: (B,) of which frame each camera is.
        points: how many the stack has.
    """

    frames: tuple[Problem, ...] = ()
    rows: tuple[slice, ...] = ()
    columns: tuple[IntArray, ...] = ()
    frame_of_row: IntArray = field(default_factory=lambda: np.empty(0, dtype=np.intp))
    points: int = 0

    @classmethod
    def of(cls, problems: Sequence[Problem], counts: IntArray) -> _BatchProblem:
        """As one, with so many cameras (F,) of each."""
        looks: list[Any] = [problem.residuals for problem in problems]  # partials, see `_kind`
        seen: list[Observations] = [look.keywords["seen"] for look in looks]
        stack = BatchedObservations.of(seen, counts)
        until = np.cumsum(counts).tolist()
        pairs = list(zip(problems, counts.tolist(), strict=True))
        size = problems[0].free
        return cls(
            partial(looks[0], seen=stack),
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
            stack.curve_pairs,
        )

    def summed(self, found: Residuals) -> tuple[FloatArray, FloatArray, FloatArray]:
        cost, weight = self.loss.cost_and_weight(found.distances)
        parts = [
            normal_equations(
                found.values[rows].take(columns, axis=2),
                found.derivatives[rows].take(columns, axis=3),
                cost[rows].take(columns, axis=1),
                weight[rows].take(columns, axis=1),
                problem.weights,
            )
            for problem, rows, columns in self._of_frames
        ]
        costs, normals, gradients = zip(*parts, strict=True)
        return np.concatenate(costs), np.concatenate(normals), np.concatenate(gradients)

    def hopeful(
        self, costs: FloatArray, running: NDArray[np.bool_], hopeless: float
    ) -> NDArray[np.bool_]:
        ended = np.where(running, np.inf, costs)
        least = np.array([ended[rows].min() for rows in self.rows])[self.frame_of_row]
        return np.asarray((costs <= hopeless * least) | np.isinf(least))

    def any_of_frame(self, of_rows: NDArray[np.bool_]) -> NDArray[np.bool_]:
        """(F,) whether what is said of cameras (B,) holds of any of a frame's."""
        return np.array([of_rows[rows].any() for rows in self.rows])

    def apart(self, at: Solution) -> list[Solution]:
        """Return what is known of each frame's searches, of all of them being known."""
        return [
            Solution(
                at.vectors[rows],
                at.costs[rows],
                at.values[rows].take(columns, axis=2),
                at.whole[rows].take(columns, axis=1),
                at.normal[rows],
                at.gradient[rows],
                at.steps,
            )
            for _, rows, columns in self._of_frames
        ]

    def side_by_side(self, found: Sequence[Solution]) -> Solution:
        """The other way round."""
        total = sum(len(one.vectors) for one in found)
        values = np.zeros((total, 2, self.points))
        whole = np.zeros((total, self.points), dtype=bool)
        for one, (_, rows, columns) in zip(found, self._of_frames, strict=True):
            values[rows, :, columns] = one.values
            whole[rows, columns] = one.whole
        return Solution(
            np.concatenate([one.vectors for one in found]),
            np.concatenate([one.costs for one in found]),
            values,
            whole,
            np.concatenate([one.normal for one in found]),
            np.concatenate([one.gradient for one in found]),
        )

    @property
    def _of_frames(self) -> list[tuple[Problem, slice, IntArray]]:
        return list(zip(self.frames, self.rows, self.columns, strict=True))
