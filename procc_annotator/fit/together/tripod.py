"""One position for all frames that a camera took from one place; pan, tilt, roll, zoom and lens
remain each frame's own."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.final_fit import MINIMUM_ELEMENTS, OUTLIER_PX, FoundCamera
from procc_annotator.fit.solving.models import FREE, KAPPA, LOG_FOCAL, ROLL, STRONG, X, Z, is_strong
from procc_annotator.fit.solving.noise import softened
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame, observe
from procc_annotator.fit.solving.plausible import too_few
from procc_annotator.fit.solving.residual import linear_map, pinhole_residuals
from procc_annotator.fit.solving.starts import (
    side_of,
    wide_prior,
)
from procc_annotator.fit.solving.surroundings import surroundings_of
from procc_annotator.fit.together.known import (
    POSITION,
    Sighting,
    Usual,
    fit_at,
    known_result,
    profile_at,
    search_at,
    sighting_of,
)
from procc_annotator.fit.together.outer import Profile, Shared, SharedPrior, find_shared
from procc_annotator.fit.together.positions import find_positions
from procc_annotator.fit.together.sides import on_other_side
from procc_annotator.language import said, said_joined

# With the position known so many elements are enough, where they leave the rest sure enough.
LEAST_ELEMENTS = 2
_SURE_PAN_RAD, _SURE_FOCAL_SHARE = 0.01, 0.05
_ROUNDS = 2
_TURNED = (
    "its camera stands on the other side of the field, opposite the others: its labels are turned"
)
# A tripod is never quite level, nor a lens the same at every zoom.
_LEAST_ROLL_SD, _LEAST_KAPPA_SD = float(np.deg2rad(0.3)), 0.01


@dataclass(frozen=True, eq=False)
class Tripod:
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
    usual: Usual

    @property
    def deviations_m(self) -> FloatArray:
        """(3,) standard deviations of the position, metres."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))


@dataclass(frozen=True, eq=False)
class SharedPosition:
    """Frames fitted together.

    Attributes:
        tripods: the positions found, the one with most frames first.
        fits: frame -> its camera at its tripod's position, or as it was alone.
        tripod_of: frame -> index in `tripods`, of the frames that share one.
        apart: frame -> why it shares no position, in words; frames without a camera are not in it.
        gained: frames that had no camera alone.
    """

    tripods: tuple[Tripod, ...]
    fits: Mapping[str, FitResult]
    tripod_of: Mapping[str, int]
    apart: Mapping[str, str] = field(default_factory=dict)
    gained: tuple[str, ...] = ()


def share_position(
    annotations: Mapping[str, FrameAnnotation],
    alone: Mapping[str, FitResult],
    field: Field,
    *,
    on_step: Callable[[], None] = lambda: None,
) -> SharedPosition:
    """Give frames of one camera position one position.

    The positions of the frames' own fits are grouped where they agree as well as they are known;
    so several cameras are told apart, and a frame that agrees with none keeps its own position.
    Each group is then fitted as one: the position is that which is best for all its points.

    Args:
        annotations: frame -> normalised points.
        alone: frame -> its own fit (P, R or R+) to that, or why there is none.
        field: the elements.
        on_step: called every few milliseconds; may raise to stop.

    Raises:
        UsageError: fits of homographies, which have no position.
    """
    if any(fit.camera is not None and fit.model not in FREE for fit in alone.values()):
        raise UsageError("a homography has no position to share; choose the model P, R or R+")
    sightings = {
        name: sighting_of(annotations[name], fit, field)
        for name, fit in alone.items()
        if fit.camera is not None
    }
    turned = _turned(alone, sightings, field)
    for name in turned:
        del sightings[name]
    fits = dict(alone)
    tripod_of: dict[str, int] = {}
    tripods: list[Tripod] = []
    for tripod, members in _tripods(alone, sightings, field, on_step):
        fits |= members
        tripod_of |= dict.fromkeys(members, len(tripods))
        tripods.append(tripod)
    apart = {
        name: _why_apart(_position(alone[name]), tripods)
        for name in sightings
        if name not in tripod_of
    }
    apart |= dict.fromkeys(turned, _TURNED)
    gained = []
    for name, fit in alone.items():
        if fit.camera is None and tripods:
            on_step()
            fits[name] = _late(annotations[name], fit, tripods, field)
            if fits[name].camera is not None:
                tripod_of[name] = 0
                gained.append(name)
    return SharedPosition(tuple(tripods), fits, tripod_of, apart, tuple(gained))


def _tripods(
    alone: Mapping[str, FitResult],
    sightings: Mapping[str, Sighting],
    field: Field,
    on_step: Callable[[], None],
) -> Iterator[tuple[Tripod, dict[str, FitResult]]]:
    """Each position that frames agree on, with their fits there."""
    names = list(sightings)
    positions, covariances = _stands([alone[name] for name in names])
    for place in find_positions(positions, covariances, surroundings_of(field).reach):
        members = [names[i] for i in place.members]
        shared, taken = _common(
            [sightings[name] for name in members], place.position, field, on_step
        )
        tripod = _tripod(members, shared, positions[place.members], covariances[place.members])
        fits = {}
        for name, sighting in zip(members, taken, strict=True):
            found = fit_at(sighting, shared.values, field, usual=tripod.usual)
            fits[name] = known_result(found, sighting, field, shared.covariance)
        yield tripod, fits


def fit_from(
    annotation: FrameAnnotation,
    field: Field,
    tripod: Tripod,
    *,
    model: str = "R",
    size: tuple[int, int],
) -> FitResult:
    """Fit a camera whose position is known; two elements are enough if they say enough.

    Args:
        annotation: normalised points.
        field: the elements.
        tripod: the position, and what roll and lens usually are there.
        model: P, R or R+.
        size: (width, height) px of the picture.

    Returns:
        The camera, or why there is none: too few elements, elements that contradict each other,
        or a pan or zoom that stays unsure.
    """

    def without(problem: str) -> FitResult:
        why = said("even with the position known: {why}", why=problem)
        return FitResult(model, size, None, why)

    frame = PictureFrame(size)
    seen = observe(annotation, field, frame)
    count = 0 if seen is None else len(seen.elements)
    if seen is None or count < LEAST_ELEMENTS:
        return without(too_few(count, LEAST_ELEMENTS))
    sighting = Sighting(seen, np.zeros(count, dtype=bool), frame, model, np.zeros(11))
    sighting, found = _search_from(sighting, tripod, field)
    worst = float(np.max(found.distances[sighting.kept.weights > 0]))
    if worst > OUTLIER_PX:
        return without(f"the elements contradict each other by {worst / frame.scale:.0f} px")
    result = known_result(found, sighting, field, tripod.covariance)
    sure = result.deviations
    if sure is None or result.camera is None:
        return result
    focal = np.exp(found.vector[LOG_FOCAL]) / frame.scale
    if sure.pan_rad > _SURE_PAN_RAD or sure.focal_px > _SURE_FOCAL_SHARE * focal:
        return without(
            f"pan is known to {np.degrees(sure.pan_rad):.1f} degrees and the focal length to"
            f" {100 * sure.focal_px / focal:.0f} % only"
        )
    return result


def _search_from(sighting: Sighting, tripod: Tripod, field: Field) -> tuple[Sighting, FoundCamera]:
    """A frame's camera at a tripod's position, and the frame with what it takes for mistakes."""
    found = search_at(sighting, tripod.position_m, field, tripod.usual)
    judged = _judged(sighting, found.vector)
    if not judged.left_out.any() and judged.seen.soft is None:
        return sighting, found
    judged = replace(judged, vector=found.vector)
    return judged, fit_at(judged, tripod.position_m, field, usual=tripod.usual)


def _stands(fits: Sequence[FitResult]) -> tuple[FloatArray, FloatArray]:
    """(F, 3) positions and (F, 3, 3) what is known of them."""
    positions = np.array([_position(fit) for fit in fits]).reshape(-1, 3)
    return positions, np.array([_covariance(fit) for fit in fits]).reshape(-1, 3, 3)


def _turned(
    alone: Mapping[str, FitResult], sightings: Mapping[str, Sighting], field: Field
) -> list[str]:
    """The frames whose labels are turned: they would make a tripod of their own."""
    if field.half_turn is None:
        return []
    names = list(sightings)
    other = on_other_side(*_stands([alone[name] for name in names]), surroundings_of(field))
    return [names[i] for i in other.turned]


def _position(fit: FitResult) -> FloatArray:
    assert fit.vector is not None  # it has a camera
    return fit.vector[POSITION]


def _covariance(fit: FitResult) -> FloatArray:
    assert fit.of_clicks is not None  # it has a camera
    return fit.of_clicks[X : Z + 1, X : Z + 1]


def _common(
    sightings: Sequence[Sighting], start: FloatArray, field: Field, on_step: Callable[[], None]
) -> tuple[Shared, list[Sighting]]:
    """The best position for some frames, and these as they took part in it."""
    prior = _weak_prior(start, field)
    taken = list(sightings)
    shared = _search_position(taken, start, prior, field, on_step)
    for _ in range(_ROUNDS):
        judged = [
            replace(_judged(sighting, profile.vector), vector=profile.vector)
            for sighting, profile in zip(taken, shared.profiles, strict=True)
        ]
        same = all((a.left_out == b.left_out).all() for a, b in zip(judged, taken, strict=True))
        taken = judged
        if same:
            break
        shared = _search_position(taken, shared.values, prior, field, on_step)
    return shared, taken


def _search_position(
    sightings: Sequence[Sighting],
    start: FloatArray,
    prior: SharedPrior,
    field: Field,
    on_step: Callable[[], None],
) -> Shared:
    def profiler(position: FloatArray, vectors: Sequence[FloatArray]) -> list[Profile]:
        found = []
        for sighting, vector in zip(sightings, vectors, strict=True):
            on_step()
            found.append(profile_at(replace(sighting, vector=vector), position, field))
        return found

    return find_shared(profiler, start, [s.vector for s in sightings], prior)


def _weak_prior(near: FloatArray, field: Field) -> SharedPrior:
    """What is expected of a camera's position, once and not for every frame."""
    around = surroundings_of(field)
    vector = np.zeros(11)
    vector[POSITION] = near
    weak = wide_prior(np.array([side_of(vector, around)]), around, Z + 1)
    everywhere = np.full(3, np.inf)
    return SharedPrior(
        weak.mean[0, POSITION], weak.inverse_sd[0, POSITION], -everywhere, everywhere
    )


def _judged(sighting: Sighting, vector: FloatArray) -> Sighting:
    """The same, with what another camera takes for mistakes; with few elements nobody can tell."""
    seen = softened(sighting.seen, linear_map(vector))
    residuals = pinhole_residuals(vector[None], seen, sighting.frame.half_diagonal, FREE["P"])
    left_out = seen.worst_of_element(residuals.distances[0]) > OUTLIER_PX
    if len(left_out) - left_out.sum() < MINIMUM_ELEMENTS:
        left_out = np.zeros_like(left_out)
    return replace(sighting, seen=seen, left_out=left_out)


def _tripod(
    frames: Sequence[str], shared: Shared, positions: FloatArray, covariances: FloatArray
) -> Tripod:
    vectors = [profile.vector for profile in shared.profiles]
    predicted = np.sqrt(np.diagonal(covariances, axis1=1, axis2=2).mean(axis=0))
    scatter = positions.std(axis=0, ddof=1)
    return Tripod(
        tuple(frames), shared.values, shared.covariance, scatter, predicted, usual_of(vectors)
    )


def usual_of(vectors: Iterable[FloatArray]) -> Usual:
    """What lens and level of a camera usually are, told from its frames' parameters; strong lenses
    say nothing of one radial coefficient."""
    vectors = list(vectors)
    kappas = [vector[KAPPA] for vector in vectors if not is_strong(vector)]
    roll = _usual(np.array([vector[ROLL] for vector in vectors]), _LEAST_ROLL_SD)
    return Usual(roll, _usual(np.array(kappas or [0.0]), _LEAST_KAPPA_SD))


def _usual(values: FloatArray, least: float) -> tuple[float, float]:
    """Median and robust standard deviation."""
    middle = float(np.median(values))
    return middle, max(1.4826 * float(np.median(np.abs(values - middle))), least)


def _why_apart(position: FloatArray, tripods: Sequence[Tripod]) -> str:
    if not tripods:
        return "no three frames agree on a position"
    away = min(float(np.linalg.norm(position - t.position_m)) for t in tripods)
    several = "the shared position" if len(tripods) == 1 else "the nearest shared position"
    return f"its own position is {away:.1f} m from {several}: another camera?"


def _late(
    annotation: FrameAnnotation, alone: FitResult, tripods: Sequence[Tripod], field: Field
) -> FitResult:
    """A frame that had no camera alone, now that the position is known."""
    if len(tripods) > 1:
        open_ = said("{count} positions, and nothing tells which is its", count=len(tripods))
        return replace(alone, failure=said_joined("; ", (alone.failure or "", open_)))
    # A model that was to be chosen is known only where there is a camera.
    model = alone.model if alone.model in FREE else "R"
    model = "R+" if model in STRONG else model
    found = fit_from(annotation, field, tripods[0], model=model, size=alone.size)
    if found.camera is None:
        return replace(alone, failure=said_joined("; ", (alone.failure or "", found.failure or "")))
    return found
