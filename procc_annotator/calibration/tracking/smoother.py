"""Smooth a chain: one position and lens, banded least squares over all frames."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.line_alignment.gaussian_state import (
    MIN_WEIGHT,
    PARAMETERS_FREE,
    FloatingArray,
    GaussianState,
    IntegerArray,
    default_state,
    geman_mcclure_weights,
)
from procc_annotator.calibration.optimization.camera_parameters import KAPPA, MIN_KAPPA, X, Z
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.calibration.tracking.filter_step import FilterStep
from procc_annotator.calibration.tracking.forward_pass import FrameChain
from procc_annotator.calibration.tracking.motion_model import (
    TRIPOD_NOISE,
    MotionConstraints,
    ProcessNoise,
    motion_constraints,
)
from procc_annotator.field.model import Field

_BATCH_FRAMES = 128  # frames


@dataclass(frozen=True, eq=False)
class EdgePointBatch:
    """The marks of b frames, m of each.

    Attributes:
        world: (b, 3, m) metres.
        across: (b, m) solver px.
        normal: (b, 2, m).
        trust: (b, m) inverse variances; 0 where a frame has fewer.
        element: (b, m) which element each is on.
    """

    world: FloatingArray
    across: FloatingArray
    normal: FloatingArray
    trust: FloatingArray
    element: IntegerArray


class ShotEdgePoints:
    """Inputs of smoothing for K frames.

    Attributes:
        vectors: (K, 11) where following left their cameras.
        coverages: (K,).
        elements: (E,) that any mark is on.
    """

    vectors: FloatArray
    coverages: FloatArray
    elements: IntArray

    def __init__(self, steps: Sequence[FilterStep]) -> None:
        self.vectors = np.array([step.belief.vector for step in steps])
        self.coverages = np.array([step.coverage for step in steps])
        of_frames = (step.marks.element.tolist() for step in steps if step.marks is not None)
        self.elements = np.array(sorted(set().union(*of_frames)), dtype=np.intp)
        self._parts = [
            (slice(first, past), _batch_of(steps[first:past]))
            for first in range(0, len(steps), _BATCH_FRAMES)
            for past in [min(first + _BATCH_FRAMES, len(steps))]
        ]

    def parts(self) -> Iterator[tuple[slice, EdgePointBatch]]:
        """All frames, some at a time."""
        yield from self._parts


def _batch_of(steps: Sequence[FilterStep]) -> EdgePointBatch:
    frames = len(steps)
    most = max([1, *(len(step.marks) for step in steps if step.marks is not None)])
    some = EdgePointBatch(
        np.zeros((frames, 3, most), np.float32),
        np.zeros((frames, most), np.float32),
        np.zeros((frames, 2, most), np.float32),
        np.zeros((frames, most), np.float32),
        np.zeros((frames, most), np.int16),
    )
    for row, step in enumerate(steps):
        if (marks := step.marks) is None:
            continue
        own = len(marks)
        some.world[row, :, :own], some.across[row, :own] = marks.world, marks.across
        some.normal[row, :, :own], some.element[row, :own] = marks.normal, marks.element
        # Of the marks that were found some were kept, which stand for all of them.
        some.trust[row, :own] = step.represented_weight / step.worth.independent_error_px**2
    return some


@dataclass(frozen=True, eq=False)
class BandedNormalEquations:
    """Normal equations.

    Attributes:
        own: (K, n, n) of each frame's unknowns.
        beside: (K - 1, n, n) between those of a frame (rows) and of the next one.
        border: (K, n, s) between those of a frame and the shared ones.
        shared: (s, s).
        own_pull: (K, n, r) right-hand sides.
        shared_pull: (s, r).
    """

    own: FloatArray
    beside: FloatArray
    border: FloatArray
    shared: FloatArray
    own_gradient: FloatArray
    shared_gradient: FloatArray


@dataclass(frozen=True, eq=False)
class BandedSolution:
    """Their solution.

    Attributes:
        own: (K, n, r) of each frame's unknowns, for each right-hand side.
        shared: (s, r) of the shared ones.
        own_covariance: (K, n, n) of each frame's, the shared ones' part included.
        shared_covariance: (s, s).
        follow: (K, n, s) how each frame's unknowns follow the shared ones.
    """

    own: FloatArray
    shared: FloatArray
    own_covariance: FloatArray
    shared_covariance: FloatArray
    follow: FloatArray


def solve_banded(normal: BandedNormalEquations) -> BandedSolution:
    """Solve normal equations, and say how surely."""
    count, own, sides = normal.own_gradient.shape
    right = np.concatenate([normal.own_gradient, normal.border], axis=2)
    inverse = np.empty_like(normal.own)
    passed = np.empty((max(count - 1, 0), own, own))  # inverse of a block times its neighbour
    gone = np.empty_like(right)
    block, column = normal.own[0], right[0]
    for k in range(count):
        inverse[k] = np.linalg.inv(block)
        gone[k] = inverse[k] @ column
        if k + 1 < count:
            passed[k] = inverse[k] @ normal.beside[k]
            block = normal.own[k + 1] - normal.beside[k].T @ passed[k]
            column = right[k + 1] - normal.beside[k].T @ gone[k]
    found, spread = gone, inverse
    for k in range(count - 2, -1, -1):
        found[k] -= passed[k] @ found[k + 1]
        spread[k] += passed[k] @ spread[k + 1] @ passed[k].T
    follow = -found[:, :, sides:]
    reduced = normal.shared + np.einsum("kns,knt->st", normal.border, follow)
    pull = normal.shared_gradient - np.einsum("kns,knr->sr", normal.border, found[:, :, :sides])
    covariance = np.linalg.inv(reduced)
    step = covariance @ pull
    return BandedSolution(
        found[:, :, :sides] + follow @ step,
        step,
        spread + follow @ covariance @ follow.transpose(0, 2, 1),
        covariance,
        follow,
    )


# Marks count by these scales, solver px, from round to round: at first each frame's camera is off
# by what the frames' positions differ by.
_SCALES_PX = (16.0, 8.0, 4.0, 2.0, 1.5, 1.5, 1.5, 1.5)
_CONVERGED = 1e-3  # standard deviations of the shared parameters
_BATCH_ELEMENTS = 8
_MIN_OFFSET_SD_PX = 0.05  # that an element lies beside the model by, solver px
_MAX_KAPPA = 0.6
# So far beside a given camera, solver px, that a track may be to pass through it.
GIVEN_REACHED_PX = 6.0


@dataclass(frozen=True, eq=False)
class SmoothedChain:
    """A chain, all of it solved together.

    Attributes:
        chain: with the cameras that are best for all of it.
        beside_px: how far elements lie next to the model in a frame, on average, solver px.
        explained: how many frames' worth of marks its cameras explain.
        coverages: (K,) of each frame, the share of the visible model that was found on paint.
    """

    chain: FrameChain
    beside_px: float
    explained: float
    coverages: FloatArray


def smooth_chain(
    chain: FrameChain, field: Field, frame: ImageFrame, stand: ProcessNoise = TRIPOD_NOISE
) -> SmoothedChain:
    """The same frames, each with the camera that is best for all of them together."""
    marks, ties = ShotEdgePoints(chain.steps), motion_constraints(chain.turns, stand)
    vectors, weights = marks.vectors, np.maximum(marks.coverages, 1e-3)
    vectors[:, stand.shared] = np.average(vectors[:, stand.shared], axis=0, weights=weights)
    known = _StatePriors(chain.given, default_state(vectors[len(vectors) // 2], field))
    for scale in _SCALES_PX:
        normal = _build_normal_equations(marks, ties, known, vectors, frame, stand, scale)
        found = solve_banded(normal)
        step = found.shared[:, 0]
        vectors[:, stand.own] += found.own[:, :, 0]
        vectors[:, stand.shared] += step
        np.clip(vectors[:, KAPPA], MIN_KAPPA, _MAX_KAPPA, out=vectors[:, KAPPA])
        sd = np.sqrt(np.diag(found.shared_covariance))
        if scale == _SCALES_PX[-1] and (np.abs(step) < _CONVERGED * sd).all():
            break
    size, beside = _element_offset_effect(marks, vectors, normal, frame, stand)
    covariances = beside
    covariances *= size**2 + _MIN_OFFSET_SD_PX**2
    _add_noise(covariances, found, stand)
    held, residuals = _consistent_shares(marks, vectors, frame)
    steps = [
        replace(
            step,
            belief=GaussianState(vector, np.asarray(np.linalg.inv(covariance))),
            coverage=step.coverage * share,
            residual_px=residual,
        )
        for step, vector, covariance, share, residual in zip(
            chain.steps, vectors, covariances, held, residuals, strict=True
        )
    ]
    coverages = marks.coverages * np.array(held)
    return SmoothedChain(replace(chain, steps=steps), size, float(sum(held)), coverages)


@dataclass(frozen=True, eq=False)
class _StatePriors:
    """Priors of cameras next to their pictures.

    Attributes:
        given: place in the chain -> what is believed of that frame's camera by itself.
        usual: of any camera: weak, and taken for the first frame only, for the others are like it.
    """

    given: Mapping[int, GaussianState]
    usual: GaussianState

    def add_to(
        self,
        information: FloatArray,
        pull: FloatArray,
        rows: slice,
        vectors: FloatArray,
        scale_px: float,
    ) -> None:
        """Add it to the normal equations (b, 8, 8) and (b, 8) of some frames; a given camera less
        and less if all other frames contradict it."""
        own = [(k, prior) for k, prior in self.given.items() if rows.start <= k < rows.stop]
        if rows.start == 0:
            own.append((0, self.usual))
        for k, prior in own:
            off = (prior.vector - vectors[k])[:PARAMETERS_FREE]
            counted = prior.information
            if prior is not self.usual:
                away = np.sqrt(off @ prior.information @ off / PARAMETERS_FREE)
                counted = counted * geman_mcclure_weights(away, max(scale_px, GIVEN_REACHED_PX))
            information[k - rows.start] += counted
            pull[k - rows.start] += counted @ off


def _build_normal_equations(
    marks: ShotEdgePoints,
    ties: MotionConstraints,
    known: _StatePriors,
    vectors: FloatArray,
    frame: ImageFrame,
    stand: ProcessNoise,
    scale_px: float,
) -> BandedNormalEquations:
    """The normal equations at K cameras (K, 11)."""
    own, shared, count = stand.own, stand.shared, len(vectors)
    found = _empty_normal_equations(count, len(own), len(shared))
    for rows, some in marks.parts():
        information, pull = _edge_point_information(some, vectors[rows], frame, scale_px)
        known.add_to(information, pull, rows, vectors, scale_px)
        stiff = ties.add_to(information, pull, rows, vectors)
        found.own[rows] = information[:, own[:, None], own]
        found.border[rows] = information[:, own[:, None], shared]
        found.own_gradient[rows, :, 0] = pull[:, own]
        found.beside[rows.start : rows.start + len(stiff)] = -stiff[:, own[:, None], own]
        # What all frames share does not change between them.
        found.shared[:] += information[:, shared[:, None], shared].sum(axis=0)
        found.shared[:] -= 2 * stiff[:, shared[:, None], shared].sum(axis=0)
        found.shared_gradient[:, 0] += pull[:, shared].sum(axis=0)
    return found


def _empty_normal_equations(count: int, own: int, shared: int) -> BandedNormalEquations:
    return BandedNormalEquations(
        np.zeros((count, own, own)),
        np.zeros((max(count - 1, 0), own, own)),
        np.zeros((count, own, shared)),
        np.zeros((shared, shared)),
        np.zeros((count, own, 1)),
        np.zeros((shared, 1)),
    )


def _edge_point_rows(
    some: EdgePointBatch, vectors: FloatArray, frame: ImageFrame, scale_px: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Of the marks of b frames: (b, 8, m) derivatives of where they appear, across; (b, m) solver
    px they are off; (b, m) what they count."""
    lens = Lens.of(vectors, frame.half_diagonal)
    world = some.world.astype(np.float64)
    empty = some.trust == 0
    if empty.any():  # anything in front of the camera will do
        ahead = (lens.rotation[:, 2] + vectors[:, X : Z + 1])[:, :, None]
        world = np.where(empty[:, None], ahead, world)
    px, _, by = project(lens, world, np.zeros_like(world), PARAMETERS_FREE)
    off = some.across - (px * some.normal).sum(axis=1)
    across = (by * some.normal[:, None]).sum(axis=2)
    return across, off, some.trust * geman_mcclure_weights(off, scale_px)


def _edge_point_information(
    some: EdgePointBatch, vectors: FloatArray, frame: ImageFrame, scale_px: float
) -> tuple[FloatArray, FloatArray]:
    """(b, 8, 8) information of the marks, and (b, 8) how they pull."""
    across, off, trust = _edge_point_rows(some, vectors, frame, scale_px)
    weighted = across * trust[:, None]
    return weighted @ across.transpose(0, 2, 1), (weighted @ off[:, :, None])[:, :, 0]


def _element_offset_effect(
    marks: ShotEdgePoints,
    vectors: FloatArray,
    normal: BandedNormalEquations,
    frame: ImageFrame,
    stand: ProcessNoise,
) -> tuple[float, FloatArray]:
    """Return by how many solver px, root mean square, elements lie next to the model, each all
    along the chain by as much as elements of single frames do (more frames do not average that
    out), and (K, 8, 8) the covariance of the cameras when it is 1 px."""
    own, shared, count = stand.own, stand.shared, len(vectors)
    spread = np.zeros((count, PARAMETERS_FREE, PARAMETERS_FREE))
    squares = counted = 0.0
    for begin in range(0, len(marks.elements), _BATCH_ELEMENTS):
        elements = marks.elements[begin : begin + _BATCH_ELEMENTS]
        own_gradient = np.zeros((count, len(own), len(elements)))
        shared_gradient = np.zeros((len(shared), len(elements)))
        for rows, some in marks.parts():
            across, off, trust = _edge_point_rows(some, vectors[rows], frame, _SCALES_PX[-1])
            of = (some.element[:, :, None] == elements) & (trust > 0)[:, :, None]
            pulls = (across * trust[:, None]) @ of
            own_gradient[rows] = pulls[:, own]
            shared_gradient += pulls[:, shared].sum(axis=0)
            total = (trust[:, :, None] * of).sum(axis=1)
            mean = ((trust * off)[:, None, :] @ of)[:, 0] / np.maximum(total, 1e-12)
            squares += float((total * mean**2 - (total > 0)).sum())  # less what noise alone does
            counted += float(total.sum())
        moved = solve_banded(
            replace(normal, own_gradient=own_gradient, shared_gradient=shared_gradient)
        )
        by = np.empty((PARAMETERS_FREE, len(elements)))
        by[shared] = moved.shared
        for one, into in zip(moved.own, spread, strict=True):
            by[own] = one
            into += by @ by.T
    return float(np.sqrt(max(squares / max(counted, 1.0), 0.0))), spread


def _consistent_shares(
    marks: ShotEdgePoints, vectors: FloatArray, frame: ImageFrame
) -> tuple[list[float], list[float | None]]:
    """Of each frame, the share of its marks that lie where its camera says, and their median
    distance, solver px; 0 and None of those without any."""
    shares: list[float] = []
    residuals: list[float | None] = []
    for rows, some in marks.parts():
        _, off, _ = _edge_point_rows(some, vectors[rows], frame, _SCALES_PX[-1])
        for own, away, seen in zip(off, np.abs(off), some.trust > 0, strict=True):
            held = seen & (geman_mcclure_weights(own) > MIN_WEIGHT)
            shares.append(float(held.sum() / max(seen.sum(), 1)))
            residuals.append(float(np.median(away[held])) if held.any() else None)
    return shares, residuals


def _add_noise(full: FloatArray, found: BandedSolution, stand: ProcessNoise) -> None:
    """Add to the covariances (K, 8, 8) of each frame's parameters what the marks' noise does."""
    own, shared = stand.own, stand.shared
    followed = found.follow @ found.shared_covariance
    full[:, own[:, None], own] += found.own_covariance
    full[:, own[:, None], shared] += followed
    full[:, shared[:, None], own] += followed.transpose(0, 2, 1)
    full[:, shared[:, None], shared] += found.shared_covariance
