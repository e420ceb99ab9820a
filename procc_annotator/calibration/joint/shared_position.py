"""Joint adjustment of frames that share one camera position."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.joint.adjustment import (
    POSITION_PARAMETERS,
    FrameObservations,
    LensAndRollPrior,
    ReducedFrame,
    SharedParameterPrior,
    SharedSolution,
    fit_at_position,
    fit_result_at_position,
    frame_observations,
    profile_at_position,
    search_at_position,
    solve_shared,
)
from procc_annotator.calibration.joint.position_clusters import (
    cluster_positions,
    find_opposite_side_frames,
)
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    KAPPA,
    LOG_FOCAL,
    ROLL,
    WIDE_ANGLE_MODELS,
    X,
    Z,
    is_wide_angle,
)
from procc_annotator.calibration.optimization.camera_placement import (
    camera_placement_prior,
    too_few_elements_text,
)
from procc_annotator.calibration.optimization.initialization import camera_side, wide_prior
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.residuals import (
    linear_map,
    pinhole_residuals,
    whitened,
)
from procc_annotator.calibration.optimization.robust_fit import (
    MIN_ELEMENTS,
    OUTLIER_PX,
    CameraSolution,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.translation import translatable, translatable_joined

# With the position known so many elements are enough, where they leave the rest sure enough.
MIN_ELEMENTS_AT_POSITION = 2
_MAX_PAN_SD_RAD, _MAX_FOCAL_SD_SHARE = 0.01, 0.05
_POSITION_ROUNDS = 2
_ROTATED_REASON = (
    "its camera stands on the other side of the field, opposite the others: its labels are turned"
)
# A tripod is never quite level, nor a lens the same at every zoom.
_MIN_ROLL_SD, _MIN_KAPPA_SD = float(np.deg2rad(0.3)), 0.01


@dataclass(frozen=True, eq=False)
class PositionGroup:
    """A position that frames share.

    Attributes:
        frames: names of those it was found from.
        position_m: (3,) metres.
        covariance: (3, 3) of it, metres squared.
        scatter_m: (3,) standard deviation of the frames' own positions before.
        predicted_m: (3,) root mean square of the standard deviations of these.
        usual: roll and lens of these frames.
    """

    frames: tuple[str, ...]
    position_m: FloatArray
    covariance: FloatArray
    scatter_m: FloatArray
    predicted_m: FloatArray
    usual: LensAndRollPrior

    @property
    def deviations_m(self) -> FloatArray:
        """(3,) standard deviations of the position, metres."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))


@dataclass(frozen=True, eq=False)
class SharedPositionResult:
    """Frames fitted together.

    Attributes:
        groups: the positions found, the one with most frames first.
        fits: frame -> its camera at its group's position, or as it was alone.
        group_of: frame -> index in `groups`, of the frames that share one.
        apart: frame -> why it shares no position, in words; frames without a camera are not in it.
        gained: frames that had no camera alone.
    """

    groups: tuple[PositionGroup, ...]
    fits: Mapping[str, FitResult]
    group_of: Mapping[str, int]
    apart: Mapping[str, str] = field(default_factory=dict)
    gained: tuple[str, ...] = ()


def fit_shared_position(
    annotations: Mapping[str, FrameAnnotation],
    alone: Mapping[str, FitResult],
    field: Field,
    *,
    on_step: Callable[[], None] = lambda: None,
) -> SharedPositionResult:
    """Give frames of one camera position one position.

    The positions of the frames' own fits are grouped where they agree as well as they are known;
    so several cameras are distinguished, and a frame that agrees with none keeps its own position.
    Each group is then fitted as one: the position is that which is best for all its points.

    Args:
        annotations: frame -> normalised points.
        alone: frame -> its own fit (P, R or R+) to that, or why there is none.
        on_step: called every few milliseconds; may raise to stop.

    Raises:
        UsageError: fits of homographies, which have no position.
    """
    if any(fit.camera is not None and fit.model not in FREE_PARAMETERS for fit in alone.values()):
        raise UsageError("a homography has no position to share; choose the model P, R or R+")
    sightings = {
        name: frame_observations(annotations[name], fit, field)
        for name, fit in alone.items()
        if fit.camera is not None
    }
    turned = _rotated_frames(alone, sightings, field)
    for name in turned:
        del sightings[name]
    fits = dict(alone)
    group_of: dict[str, int] = {}
    groups: list[PositionGroup] = []
    for tripod, members in _position_groups(alone, sightings, field, on_step):
        fits |= members
        group_of |= dict.fromkeys(members, len(groups))
        groups.append(tripod)
    apart = {
        name: _excluded_reason(_fit_position(alone[name]), groups)
        for name in sightings
        if name not in group_of
    }
    apart |= dict.fromkeys(turned, _ROTATED_REASON)
    gained = []
    for name, fit in alone.items():
        if fit.camera is None and groups:
            on_step()
            fits[name] = _fit_late_frame(annotations[name], fit, groups, field)
            if fits[name].camera is not None:
                group_of[name] = 0
                gained.append(name)
    return SharedPositionResult(tuple(groups), fits, group_of, apart, tuple(gained))


def _position_groups(
    alone: Mapping[str, FitResult],
    sightings: Mapping[str, FrameObservations],
    field: Field,
    on_step: Callable[[], None],
) -> Iterator[tuple[PositionGroup, dict[str, FitResult]]]:
    """Each position that frames agree on, with their fits there."""
    names = list(sightings)
    positions, covariances = _positions_and_covariances([alone[name] for name in names])
    for place in cluster_positions(positions, covariances, camera_placement_prior(field).reach):
        members = [names[i] for i in place.members]
        shared, taken = _solve_group(
            [sightings[name] for name in members], place.position, field, on_step
        )
        tripod = _build_group(members, shared, positions[place.members], covariances[place.members])
        fits = {}
        for name, sighting in zip(members, taken, strict=True):
            found = fit_at_position(sighting, shared.values, field, usual=tripod.usual)
            fits[name] = fit_result_at_position(found, sighting, field, shared.covariance)
        yield tripod, fits


def fit_at_known_position(
    annotation: FrameAnnotation,
    field: Field,
    tripod: PositionGroup,
    *,
    model: str = "R",
    size: tuple[int, int],
) -> FitResult:
    """Fit a camera whose position is known; two elements are enough if they say enough.

    Args:
        tripod: the position, and what roll and lens usually are there.
        model: P, R or R+.
        size: (width, height) px of the picture.

    Returns:
        The camera, or why there is none: too few elements, elements that contradict each other,
        or a pan or zoom that stays unsure.
    """

    def without(problem: str) -> FitResult:
        why = translatable("even with the position known: {why}", why=problem)
        return FitResult(model, size, None, why)

    frame = ImageFrame(size, field.pixel_aspect)
    seen = build_observations(annotation, field, frame)
    count = 0 if seen is None else len(seen.elements)
    if seen is None or count < MIN_ELEMENTS_AT_POSITION:
        return without(too_few_elements_text(count, MIN_ELEMENTS_AT_POSITION))
    sighting = FrameObservations(seen, np.zeros(count, dtype=bool), frame, model, np.zeros(11))
    sighting, found = _search_at_group(sighting, tripod, field)
    worst = float(np.max(found.distances[sighting.kept.weights > 0]))
    if worst > OUTLIER_PX:
        return without(f"the elements contradict each other by {worst / frame.scale:.0f} px")
    result = fit_result_at_position(found, sighting, field, tripod.covariance)
    sure = result.deviations
    if sure is None or result.camera is None:
        return result
    focal = np.exp(found.vector[LOG_FOCAL]) / frame.scale
    if sure.pan_rad > _MAX_PAN_SD_RAD or sure.focal_px > _MAX_FOCAL_SD_SHARE * focal:
        return without(
            f"pan is known to {np.degrees(sure.pan_rad):.1f} degrees and the focal length to"
            f" {100 * sure.focal_px / focal:.0f} % only"
        )
    return result


def _search_at_group(
    sighting: FrameObservations, tripod: PositionGroup, field: Field
) -> tuple[FrameObservations, CameraSolution]:
    """A frame's camera at a tripod's position, and the frame with what it takes for mistakes."""
    found = search_at_position(sighting, tripod.position_m, field, tripod.usual)
    judged = _with_outliers_from(sighting, found.vector)
    if not judged.left_out.any() and judged.seen.soft is None:
        return sighting, found
    judged = replace(judged, vector=found.vector)
    return judged, fit_at_position(judged, tripod.position_m, field, usual=tripod.usual)


def _positions_and_covariances(fits: Sequence[FitResult]) -> tuple[FloatArray, FloatArray]:
    """(F, 3) positions and (F, 3, 3) what is known of them."""
    positions = np.array([_fit_position(fit) for fit in fits]).reshape(-1, 3)
    return positions, np.array([_position_covariance(fit) for fit in fits]).reshape(-1, 3, 3)


def _rotated_frames(
    alone: Mapping[str, FitResult], sightings: Mapping[str, FrameObservations], field: Field
) -> list[str]:
    """The frames whose labels are turned: they would make a tripod of their own."""
    if field.half_turn is None:
        return []
    names = list(sightings)
    other = find_opposite_side_frames(
        *_positions_and_covariances([alone[name] for name in names]), camera_placement_prior(field)
    )
    return [names[i] for i in other.turned]


def _fit_position(fit: FitResult) -> FloatArray:
    assert fit.vector is not None  # it has a camera
    return fit.vector[POSITION_PARAMETERS]


def _position_covariance(fit: FitResult) -> FloatArray:
    assert fit.covariance is not None  # it has a camera
    return fit.covariance[X : Z + 1, X : Z + 1]


def _solve_group(
    sightings: Sequence[FrameObservations],
    start: FloatArray,
    field: Field,
    on_step: Callable[[], None],
) -> tuple[SharedSolution, list[FrameObservations]]:
    """The best position for some frames, and these as they took part in it."""
    prior = _weak_position_prior(start, field)
    taken = list(sightings)
    shared = _solve_position(taken, start, prior, field, on_step)
    for _ in range(_POSITION_ROUNDS):
        judged = [
            replace(_with_outliers_from(sighting, profile.vector), vector=profile.vector)
            for sighting, profile in zip(taken, shared.profiles, strict=True)
        ]
        same = all((a.left_out == b.left_out).all() for a, b in zip(judged, taken, strict=True))
        taken = judged
        if same:
            break
        shared = _solve_position(taken, shared.values, prior, field, on_step)
    return shared, taken


def _solve_position(
    sightings: Sequence[FrameObservations],
    start: FloatArray,
    prior: SharedParameterPrior,
    field: Field,
    on_step: Callable[[], None],
) -> SharedSolution:
    def profiler(position: FloatArray, vectors: Sequence[FloatArray]) -> list[ReducedFrame]:
        found = []
        for sighting, vector in zip(sightings, vectors, strict=True):
            on_step()
            found.append(profile_at_position(replace(sighting, vector=vector), position, field))
        return found

    return solve_shared(profiler, start, [s.vector for s in sightings], prior)


def _weak_position_prior(near: FloatArray, field: Field) -> SharedParameterPrior:
    """Return what is expected of a camera's position, once and not for every frame."""
    around = camera_placement_prior(field)
    vector = np.zeros(11)
    vector[POSITION_PARAMETERS] = near
    weak = wide_prior(np.array([camera_side(vector, around)]), around, Z + 1)
    everywhere = np.full(3, np.inf)
    return SharedParameterPrior(
        weak.mean[0, POSITION_PARAMETERS],
        weak.inverse_sd[0, POSITION_PARAMETERS],
        -everywhere,
        everywhere,
    )


def _with_outliers_from(sighting: FrameObservations, vector: FloatArray) -> FrameObservations:
    """The same, with what another camera takes for mistakes; with few elements no one can say."""
    seen = whitened(sighting.seen, linear_map(vector))
    residuals = pinhole_residuals(
        vector[None], seen, sighting.frame.half_diagonal, FREE_PARAMETERS["P"]
    )
    left_out = seen.max_per_element(residuals.distances[0]) > OUTLIER_PX
    if len(left_out) - left_out.sum() < MIN_ELEMENTS:
        left_out = np.zeros_like(left_out)
    return replace(sighting, seen=seen, left_out=left_out)


def _build_group(
    frames: Sequence[str], shared: SharedSolution, positions: FloatArray, covariances: FloatArray
) -> PositionGroup:
    vectors = [profile.vector for profile in shared.profiles]
    predicted = np.sqrt(np.diagonal(covariances, axis1=1, axis2=2).mean(axis=0))
    scatter = positions.std(axis=0, ddof=1)
    return PositionGroup(
        tuple(frames),
        shared.values,
        shared.covariance,
        scatter,
        predicted,
        lens_and_roll_prior(vectors),
    )


def lens_and_roll_prior(vectors: Iterable[FloatArray]) -> LensAndRollPrior:
    """Return what lens and level of a camera usually are, distinguished from its frames'
    parameters; strong lenses say nothing of one radial coefficient."""
    vectors = list(vectors)
    kappas = [vector[KAPPA] for vector in vectors if not is_wide_angle(vector)]
    roll = _robust_mean_sd(np.array([vector[ROLL] for vector in vectors]), _MIN_ROLL_SD)
    return LensAndRollPrior(roll, _robust_mean_sd(np.array(kappas or [0.0]), _MIN_KAPPA_SD))


def _robust_mean_sd(values: FloatArray, least: float) -> tuple[float, float]:
    middle = float(np.median(values))
    return middle, max(1.4826 * float(np.median(np.abs(values - middle))), least)


def _excluded_reason(position: FloatArray, groups: Sequence[PositionGroup]) -> str:
    if not groups:
        return "no three frames agree on a position"
    away = min(float(np.linalg.norm(position - t.position_m)) for t in groups)
    several = "the shared position" if len(groups) == 1 else "the nearest shared position"
    return f"its own position is {away:.1f} m from {several}: another camera?"


def _fit_late_frame(
    annotation: FrameAnnotation, alone: FitResult, groups: Sequence[PositionGroup], field: Field
) -> FitResult:
    """A frame that had no camera alone, now that the position is known."""
    if len(groups) > 1:
        open_ = translatable("{count} positions, and nothing tells which is its", count=len(groups))
        return replace(alone, failure=translatable_joined("; ", (alone.failure or "", open_)))
    # A model that was to be chosen is known only where there is a camera.
    model = alone.model if alone.model in FREE_PARAMETERS else "R"
    model = "R+" if model in WIDE_ANGLE_MODELS else model
    found = fit_at_known_position(annotation, field, groups[0], model=model, size=alone.size)
    if found.camera is None:
        return replace(
            alone, failure=translatable_joined("; ", (alone.failure or "", found.failure or ""))
        )
    return found
