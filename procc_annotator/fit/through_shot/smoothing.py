"""All frames of a chain together: one position and one lens, the rest as paint and motion say.

Every frame's camera follows from the paint of that frame and, through the motion from frame to
frame, from that of its neighbours on both sides; what all frames have in common follows from all.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.fit.on_paint.belief import COUNTS, Belief, usual, weights_of
from procc_annotator.fit.on_paint.marks import PARAMETERS_FREE, Floats, Integers
from procc_annotator.fit.solving.jacobian import Lens, project
from procc_annotator.fit.solving.models import KAPPA, LEAST_KAPPA, LOG_FOCAL, X, Z
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame
from procc_annotator.fit.through_shot.banded import BandedSolution, Normal, solve_normal
from procc_annotator.fit.through_shot.chain import FrameChain
from procc_annotator.fit.through_shot.stand import TRIPOD, ShotStand, lens_change
from procc_annotator.fit.through_shot.stepping import Stepped
from procc_annotator.fit.through_shot.turning import OWN, Turn

# Marks count by these scales, solver px, from round to round: at first each frame's camera is off
# by what the frames' positions differ by.
_SCALES_PX = (16.0, 8.0, 4.0, 2.0, 1.5, 1.5, 1.5, 1.5)
_SETTLED = 1e-3  # standard deviations of the shared parameters
_AT_ONCE = 128  # frames whose marks are projected together
# Of a step that nothing foretells, standard deviations: pan, tilt, roll, logarithm of the focal
# length.
_UNKNOWN = Turn(np.zeros(4), np.diag(np.array([0.02, 0.01, 0.002, 0.05]) ** 2))
_LEAST_BESIDE_PX = 0.05  # that an element lies beside the model by, solver px
_MOST_KAPPA = 0.6


@dataclass(frozen=True, eq=False)
class _Data:
    """The marks of K frames as arrays, m of each.

    Attributes:
        world: (K, 3, m) metres.
        across: (K, m) solver px.
        normal: (K, 2, m).
        trust: (K, m) inverse variances; 0 where a frame has fewer.
        element: (K, m) which element each is on.
    """

    world: Floats
    across: Floats
    normal: Floats
    trust: Floats
    element: Integers


@dataclass(frozen=True, eq=False)
class Smoothed:
    """A chain, all of it solved together.

    Attributes:
        chain: with the cameras that are best for all of it.
        beside_px: how far elements lie beside the model in a frame, on average, solver px.
        explained: how many frames' worth of marks its cameras explain.
    """

    chain: FrameChain
    beside_px: float
    explained: float

    def coverages(self) -> FloatArray:
        """(K,) of each frame, the share of the visible model that was found on paint."""
        return np.array([step.coverage for step in self.chain.steps])


def smoothed(
    chain: FrameChain, field: Field, frame: PictureFrame, stand: ShotStand = TRIPOD
) -> Smoothed:
    """The same frames, each with the camera that is best for all of them together."""
    data = _data_of(chain.steps)
    vectors = np.array([step.belief.vector for step in chain.steps])
    weights = np.array([max(step.coverage, 1e-3) for step in chain.steps])
    vectors[:, stand.shared] = np.average(vectors[:, stand.shared], axis=0, weights=weights)
    before = usual(vectors[len(vectors) // 2], field)
    for scale in _SCALES_PX:
        normal = _normal(chain, data, vectors, before, frame, stand, scale)
        found = solve_normal(normal)
        step = found.shared[:, 0]
        vectors[:, stand.own] += found.own[:, :, 0]
        vectors[:, stand.shared] += step
        np.clip(vectors[:, KAPPA], LEAST_KAPPA, _MOST_KAPPA, out=vectors[:, KAPPA])
        sd = np.sqrt(np.diag(found.shared_covariance))
        if scale == _SCALES_PX[-1] and (np.abs(step) < _SETTLED * sd).all():
            break
    size, beside = _beside(data, vectors, normal, frame, stand)
    covariances = _covariances(found, beside * np.hypot(size, _LEAST_BESIDE_PX), stand)
    held, residuals = _held(data, vectors, frame)
    steps = tuple(
        replace(
            step,
            belief=Belief(vector, np.asarray(np.linalg.inv(covariance))),
            coverage=step.coverage * share,
            residual_px=residual,
        )
        for step, vector, covariance, share, residual in zip(
            chain.steps, vectors, covariances, held, residuals, strict=True
        )
    )
    return Smoothed(replace(chain, steps=steps), size, float(sum(held)))


def _data_of(steps: tuple[Stepped, ...]) -> _Data:
    most = max((len(s.marks) for s in steps if s.marks is not None), default=0)
    count = len(steps)
    # As the marks are kept: a shot may have many thousand frames.
    world, normal = (np.zeros((count, axes, most), dtype=np.float32) for axes in (3, 2))
    across, trust = (np.zeros((count, most), dtype=np.float32) for _ in range(2))
    element = np.zeros((count, most), dtype=np.int16)
    for k, step in enumerate(steps):
        if step.marks is None:
            continue
        own = len(step.marks)
        world[k, :, :own], across[k, :own] = step.marks.world, step.marks.across
        normal[k, :, :own], element[k, :own] = step.marks.normal, step.marks.element
        # Of the marks that were found some were kept, which stand for all of them.
        trust[k, :own] = step.standing_for / step.worth.information_px**2
    return _Data(world, across, normal, trust, element)


def _normal(
    chain: FrameChain,
    data: _Data,
    vectors: FloatArray,
    before: Belief,
    frame: PictureFrame,
    stand: ShotStand,
    scale_px: float,
) -> Normal:
    """The normal equations at K cameras (K, 11)."""
    information, pull = _of_marks(data, vectors, frame, scale_px)
    for place, belief in chain.given.items():
        information[place] += belief.information
        pull[place] += belief.information @ (belief.vector - vectors[place])[:PARAMETERS_FREE]
    # What is known of any camera: weak, and of the first frame only, for the others are like it.
    information[0] += before.information
    pull[0] += before.information @ (before.vector - vectors[0])[:PARAMETERS_FREE]
    beside = np.zeros((max(len(vectors) - 1, 0), PARAMETERS_FREE, PARAMETERS_FREE))
    stiff = np.zeros((PARAMETERS_FREE, PARAMETERS_FREE))
    stiff[range(X, Z + 1), range(X, Z + 1)] = stand.position_m**-2
    for k, turn in enumerate(chain.turns):
        told = turn or _UNKNOWN
        stiff[np.ix_(OWN, OWN)] = np.linalg.inv(told.covariance + np.diag(stand.apparent**2))
        off = vectors[k, :PARAMETERS_FREE] - vectors[k + 1, :PARAMETERS_FREE]
        off[OWN] += told.step
        zoomed = vectors[k + 1, LOG_FOCAL] - vectors[k, LOG_FOCAL]
        stiff[KAPPA, KAPPA] = lens_change(float(zoomed)) ** -2
        information[k] += stiff
        information[k + 1] += stiff
        beside[k] = -stiff
        pull[k] -= stiff @ off
        pull[k + 1] += stiff @ off
    own, shared = stand.own, stand.shared
    # What all frames share does not change between them.
    own_block = information[:, own[:, None], own]
    shared_block = information[:, shared[:, None], shared].sum(axis=0)
    both = beside[:, shared[:, None], shared].sum(axis=0)
    return Normal(
        own_block,
        beside[:, own[:, None], own],
        information[:, own[:, None], shared],
        shared_block + both + both.T,
        pull[:, own, None],
        pull[:, shared].sum(axis=0)[:, None],
    )


def _in_parts(count: int) -> Iterator[slice]:
    return (slice(begin, begin + _AT_ONCE) for begin in range(0, count, _AT_ONCE))


def _seen(
    data: _Data, rows: slice, vectors: FloatArray, frame: PictureFrame, scale_px: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Of the marks of b frames: (b, 8, m) derivatives of where they appear, across; (b, m) solver
    px they are off; (b, m) what they count."""
    lens = Lens.of(vectors[rows], frame.half_diagonal)
    world = data.world[rows].astype(np.float64)
    empty = data.trust[rows] == 0
    if empty.any():  # anything in front of the camera will do
        ahead = (lens.rotation[:, 2] + vectors[rows, X : Z + 1])[:, :, None]
        world = np.where(empty[:, None], ahead, world)
    px, _, by = project(lens, world, np.zeros_like(world), PARAMETERS_FREE)
    off = data.across[rows] - (px * data.normal[rows]).sum(axis=1)
    across = (by * data.normal[rows][:, None]).sum(axis=2)
    return across, off, data.trust[rows] * weights_of(off, scale_px)


def _of_marks(
    data: _Data, vectors: FloatArray, frame: PictureFrame, scale_px: float
) -> tuple[FloatArray, FloatArray]:
    """(K, 8, 8) information of the marks, and (K, 8) how they pull."""
    count = len(vectors)
    information = np.zeros((count, PARAMETERS_FREE, PARAMETERS_FREE))
    pull = np.zeros((count, PARAMETERS_FREE))
    for rows in _in_parts(count):
        across, off, trust = _seen(data, rows, vectors, frame, scale_px)
        weighted = across * trust[:, None]
        information[rows] = weighted @ across.transpose(0, 2, 1)
        pull[rows] = (weighted @ off[:, :, None])[:, :, 0]
    return information, pull


def _beside(
    data: _Data, vectors: FloatArray, normal: Normal, frame: PictureFrame, stand: ShotStand
) -> tuple[float, FloatArray]:
    """What it does to the cameras that elements lie beside the model, each all along the chain by
    as much as elements of single frames do: more frames do not average that out.

    Returns:
        Solver px by which they do, root mean square, and (K, 8, E) what 1 px does.
    """
    elements = np.unique(data.element[data.trust > 0])
    count = len(vectors)
    pulls = np.zeros((count, PARAMETERS_FREE, len(elements)))
    squares = counted = 0.0
    for rows in _in_parts(count):
        across, off, trust = _seen(data, rows, vectors, frame, _SCALES_PX[-1])
        weighted = across * trust[:, None]
        of = (data.element[rows][:, :, None] == elements) & (trust > 0)[:, :, None]
        pulls[rows] = weighted @ of
        total = (trust[:, :, None] * of).sum(axis=1)
        mean = ((trust * off)[:, None, :] @ of)[:, 0] / np.maximum(total, 1e-12)
        squares += float((total * mean**2 - (total > 0)).sum())  # less what noise alone does
        counted += float(total.sum())
    shared = pulls[:, stand.shared].sum(axis=0)
    moved = solve_normal(replace(normal, own_pull=pulls[:, stand.own], shared_pull=shared))
    found = np.empty_like(pulls)
    found[:, stand.own], found[:, stand.shared] = moved.own, moved.shared
    return float(np.sqrt(max(squares / max(counted, 1.0), 0.0))), found


def _held(
    data: _Data, vectors: FloatArray, frame: PictureFrame
) -> tuple[list[float], list[float | None]]:
    """Of each frame, the share of its marks that lie where its camera says, and their median
    distance, solver px; 0 and None of those without any."""
    shares: list[float] = []
    residuals: list[float | None] = []
    for rows in _in_parts(len(vectors)):
        _, off, _ = _seen(data, rows, vectors, frame, _SCALES_PX[-1])
        for own, away, seen in zip(off, np.abs(off), data.trust[rows] > 0, strict=True):
            held = seen & (weights_of(own) > COUNTS)
            shares.append(float(held.sum() / max(seen.sum(), 1)))
            residuals.append(float(np.median(away[held])) if held.any() else None)
    return shares, residuals


def _covariances(found: BandedSolution, beside: FloatArray, stand: ShotStand) -> FloatArray:
    """(K, 8, 8) of each frame's parameters: of the marks' noise, and of what elements do."""
    own, shared = stand.own, stand.shared
    full = beside @ beside.transpose(0, 2, 1)
    followed = found.follow @ found.shared_covariance
    full[:, own[:, None], own] += found.own_covariance
    full[:, own[:, None], shared] += followed
    full[:, shared[:, None], own] += followed.transpose(0, 2, 1)
    full[:, shared[:, None], shared] += found.shared_covariance
    return full
