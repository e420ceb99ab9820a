"""The set of wrong labels that best explains a camera that does not fit all elements.

The robust fit says which elements to suspect. That is nearly always right, but in a frame of few
elements it may sacrifice right ones to a wrong one; then every element is tried as the only
mistake, and pairs of suspects after that.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, replace
from dataclasses import field as default
from functools import cached_property
from itertools import combinations

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.candidate_classes import (
    CandidateClass,
    candidate_classes,
    distances_to_classes,
    farthest_point,
    refit_all_points,
    relabelled,
    uncertain_landmarks,
)
from procc_annotator.calibration.label_check.evidence import CORRECT_PX, FITS_PX, SUSPECT_LIMIT_PX
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.robust_fit import MIN_ELEMENTS
from procc_annotator.calibration.result import FitResult, PosedCamera
from procc_annotator.camera.base import Camera
from procc_annotator.field.landmarks import landmark_covariances
from procc_annotator.field.model import Field

# Fewer right elements than these leave open who is wrong.
MIN_CORRECT = 4
# With so many right ones a single suspect is taken at its word.
_CLEARLY_CORRECT = 6
_ITERATIONS = 3
_MAX_TRIALS = 16
_MAX_PAIRED = 7
# A second look: at so many mistakes, at labels within so many solver px, at so many of them; they
# may make the right elements fit so much worse on average.
_MAX_RETRIES = 4
_MAX_CANDIDATE_ERROR_PX = 80.0
_MAX_LABEL_TRIALS = 3
_MIN_COST_GAIN_PX = 1.0
# What a mistake counts in an explanation: one that is understood, and one that is not.
_EXPLAINED_COST, _UNEXPLAINED_COST = 1.0, 2.0


@dataclass(frozen=True)
class SuspectFrame:
    """The annotation in question, with what is needed to fit it."""

    annotation: FrameAnnotation
    field: Field
    frame: ImageFrame
    model: str
    limit_px: float = SUSPECT_LIMIT_PX  # solver px; an element farther off does not fit
    go_on: Callable[[], None] = lambda: None

    def fit(self, annotation: FrameAnnotation, start: Camera | None = None) -> FitResult:
        """The camera of another version of the annotation, if anyone still wants it."""
        self.go_on()
        return fit_camera(
            annotation, self.field, model=self.model, size=self.frame.size, start=start
        )

    def without(self, names: Collection[str]) -> FrameAnnotation:
        """The annotation without some classes."""
        return FrameAnnotation(
            tuple(p for p in self.annotation.polylines if p.class_name not in names)
        )

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The annotated classes that have a place on the field."""
        return tuple(n for n in self.annotation.annotated if self.field.element(n) is not None)


@dataclass(frozen=True)
class OutlierPoint:
    """One point that is off while the rest of its element fits; distances in solver px."""

    index: int
    off_px: float
    rest_px: float


@dataclass(frozen=True)
class Explanation:
    """Elements taken for mistakes, and the camera of the others.

    Attributes:
        vector: (11,) the camera without the mistakes.
        off_px: mistake -> its largest distance, solver px, as it counts.
        right: number of elements that fit, without landmarks that may be anywhere.
        correct_px: mean of their largest distances, solver px.
        names: mistake -> the class it fits, all of them different.
        places: mistake -> every class its points are near to.
        points: mistake -> the one point that is to blame.
    """

    vector: FloatArray
    off_px: Mapping[str, float]
    right: int
    correct_px: float
    names: Mapping[str, str] = default(default_factory=dict)
    places: Mapping[str, tuple[CandidateClass, ...]] = default(default_factory=dict)
    points: Mapping[str, OutlierPoint] = default(default_factory=dict)

    @property
    def cost(self) -> float:
        """The less, the better an explanation."""
        unexplained = len(self.unexplained)
        understood = len(self.off_px) - unexplained
        return (
            _EXPLAINED_COST * understood
            + _UNEXPLAINED_COST * unexplained
            + self.correct_px / SUSPECT_LIMIT_PX
        )

    @property
    def unexplained(self) -> tuple[str, ...]:
        """Mistakes that fit no other class, and of which no single point is to blame."""
        return tuple(n for n in self.off_px if n not in self.names and n not in self.points)


def best_explanation(
    doubted: SuspectFrame, fit: FitResult, suspects: Collection[str]
) -> Explanation | None:
    """The best explanation of a robust fit, or its failure, that does not fit; ``suspects`` are the
    elements that are off under it. None where too few elements are left to say; without mistakes
    where a better camera fits all."""
    first = (
        _iterate_outliers(doubted, set(suspects), fit.camera) if fit.camera is not None else None
    )
    if first is not None and _is_convincing(first):
        return first
    tried = [first, *(_as_only_mistakes(doubted, {name}) for name in doubted.names[:_MAX_TRIALS])]
    found = [explanation for explanation in tried if explanation is not None]
    sure = any(explanation.right >= MIN_CORRECT for explanation in found)
    if not sure and len(doubted.names) - 2 >= MIN_CORRECT:
        paired = tuple(suspects) or doubted.names
        pairs = combinations(paired if len(paired) <= _MAX_PAIRED else (), 2)
        both = (_as_only_mistakes(doubted, set(pair)) for pair in pairs)
        found = [explanation for explanation in both if explanation is not None] or found
    return min(found, key=lambda explanation: explanation.cost, default=None)


def _is_convincing(found: Explanation) -> bool:
    if found.correct_px > CORRECT_PX:
        return False
    wrong, unexplained = len(found.off_px), len(found.unexplained)
    if wrong <= 1 and found.right >= _CLEARLY_CORRECT:
        return True
    return not unexplained and (wrong <= 1 or found.right >= MIN_CORRECT)


def _as_only_mistakes(doubted: SuspectFrame, out: set[str]) -> Explanation | None:
    """These elements as the only mistakes, if all others fit without them."""
    fit = doubted.fit(doubted.without(out))
    if not isinstance(fit.camera, PosedCamera) or fit.vector is None:
        return None
    off = _max_distances(doubted, fit.vector)
    wrong = {name for name, distance in off.items() if distance > doubted.limit_px}
    if not wrong <= out:
        return None
    return _retry_relabelled(
        doubted, _build_explanation(doubted, fit.camera, fit.vector, off, wrong)
    )


def _iterate_outliers(
    doubted: SuspectFrame, out: set[str], start: Camera | None
) -> Explanation | None:
    """Leave some elements out, look who is off now, until the same ones are off."""
    camera: Camera | None = start
    for _ in range(_ITERATIONS):
        fit = doubted.fit(doubted.without(out), camera)
        if not isinstance(fit.camera, PosedCamera) or fit.vector is None:
            return None
        off = _max_distances(doubted, fit.vector)
        now = {name for name, distance in off.items() if distance > doubted.limit_px}
        if len(off) - len(now) < MIN_ELEMENTS:
            return None
        camera = fit.camera
        if now == out:
            break
        out = now
    assert isinstance(camera, PosedCamera)  # the last one looked at
    assert fit.vector is not None
    return _retry_relabelled(doubted, _build_explanation(doubted, camera, fit.vector, off, now))


def _retry_relabelled(doubted: SuspectFrame, found: Explanation) -> Explanation:
    """Try other labels on what fits no class so far, with the camera fitted to them as well.

    The camera of the others may be open just where the mistakes are.
    """
    if not found.unexplained or len(found.off_px) > _MAX_RETRIES:
        return found
    for one, other in combinations(found.off_px, 2):
        if one in found.unexplained or other in found.unexplained:
            names = {one: other, other: one}
            if _fits_relabelled(doubted, found, names):
                return replace(found, names={**_compatible_labels(found, names), **names})
    for name in found.unexplained:
        swapped = _try_swap_with(doubted, found, name)
        if swapped is not None:
            return swapped
        taken = {*doubted.names, *found.names.values()} - found.off_px.keys()
        near = candidate_classes(
            _polyline_named(doubted, name),
            doubted.field,
            doubted.frame,
            found.vector,
            _MAX_CANDIDATE_ERROR_PX,
        )
        free = [place.class_name for place in near if place.class_name not in taken | {name}]
        for becomes in free[:_MAX_LABEL_TRIALS]:
            if _fits_relabelled(doubted, found, {name: becomes}):
                names = {name: becomes}
                found = replace(found, names={**_compatible_labels(found, names), **names})
                break
    return found


def _try_swap_with(doubted: SuspectFrame, found: Explanation, name: str) -> Explanation | None:
    """A mistake that lies on a right element may be swapped with it: the camera gave way to that.

    Had a person clicked one line under two names, the other one would fit no better for the swap.
    """
    right = set(doubted.names) - found.off_px.keys()
    twin = next((p.class_name for p in found.places.get(name, ()) if p.class_name in right), None)
    if twin is None:
        return None
    names = {name: twin, twin: name}
    if not _fits_relabelled(doubted, found, names):
        return None
    off = _max_distances(doubted, found.vector)[twin]
    return replace(
        found,
        off_px={**found.off_px, twin: off},
        right=found.right - 1,
        names={**_compatible_labels(found, names), **names},
    )


def _compatible_labels(found: Explanation, names: Mapping[str, str]) -> dict[str, str]:
    new = set(names.values())
    return {a: b for a, b in found.names.items() if a not in names and b not in new}


def _fits_relabelled(doubted: SuspectFrame, found: Explanation, names: Mapping[str, str]) -> bool:
    """Return whether everything fits once some mistakes have these classes; others are left out."""
    kept = relabelled(doubted.without(found.off_px.keys() - names.keys()), names)
    worst = refit_all_points(kept, doubted.field, doubted.frame, found.vector, doubted.model)
    if max(worst.values(), default=np.inf) > FITS_PX:
        return False
    right = [distance for name, distance in worst.items() if name not in names.values()]
    return float(np.mean(right)) <= found.correct_px + _MIN_COST_GAIN_PX


def _max_distances(doubted: SuspectFrame, vector: FloatArray) -> dict[str, float]:
    """The largest distance of every element, solver px, as it counts."""
    found = {}
    for polyline in doubted.annotation.polylines:
        if doubted.field.element(polyline.class_name) is None:
            continue
        name = polyline.class_name
        distances = distances_to_classes(
            polyline, [name], doubted.field, doubted.frame, vector, as_counted=True
        )
        if name in distances:
            found[name] = float(distances[name].max())
    return found


def _build_explanation(
    doubted: SuspectFrame,
    camera: PosedCamera,
    vector: FloatArray,
    off: Mapping[str, float],
    wrong: Collection[str],
) -> Explanation:
    right = {name: distance for name, distance in off.items() if name not in wrong}
    polylines = {name: _polyline_named(doubted, name) for name in off if name in wrong}
    points = {
        name: point
        for name, polyline in polylines.items()
        if (point := _outlier_point(doubted, polyline, vector, camera, wrong)) is not None
    }
    places = {
        name: candidate_classes(polyline, doubted.field, doubted.frame, vector)
        for name, polyline in polylines.items()
        if name not in points
    }
    taken = set(off) - set(wrong) | points.keys()
    names = dict(_greedy_assignment(places, taken))
    return Explanation(
        vector,
        {name: off[name] for name in off if name in wrong},
        len(right.keys() - uncertain_landmarks(doubted.field, vector)),
        float(np.mean(list(right.values()))) if right else 0.0,
        names,
        places,
        points,
    )


def _polyline_named(doubted: SuspectFrame, name: str) -> Polyline:
    found = doubted.annotation.get(name)
    assert found is not None  # the caller has it from the annotation
    return found


def _greedy_assignment(
    places: Mapping[str, tuple[CandidateClass, ...]], taken: Collection[str]
) -> Iterator[tuple[str, str]]:
    """The nearest free class for each, no class twice; the closest pairs choose first."""
    pairs = sorted(
        (place.mean_px, name, place.class_name)
        for name, near in places.items()
        for place in near
        if place.class_name not in taken and place.class_name != name
    )
    done: set[str] = set()
    used: set[str] = set()
    for _, name, becomes in pairs:
        if name not in done and becomes not in used:
            done.add(name)
            used.add(becomes)
            yield name, becomes


def _outlier_point(
    doubted: SuspectFrame,
    polyline: Polyline,
    vector: FloatArray,
    camera: PosedCamera,
    wrong: Collection[str],
) -> OutlierPoint | None:
    """The one point without which an element fits."""
    if len(polyline.points) < 2 or polyline.class_name in landmark_covariances(doubted.field):
        return None
    found = farthest_point(polyline, doubted.field, doubted.frame, vector)
    if found is None:
        return None
    index, off, rest = found
    if len(polyline.points) == 2:
        # Either point is to blame, or the label is; one that explains both points is likelier.
        if rest > CORRECT_PX or candidate_classes(polyline, doubted.field, doubted.frame, vector):
            return None
        return OutlierPoint(index, off, rest)
    # Without the whole element the camera may be open; the rest of it has a say as well.
    points = polyline.points
    kept = Polyline(polyline.class_name, (*points[:index], *points[index + 1 :]))
    others = doubted.without({*wrong} - {polyline.class_name})
    fit = doubted.fit(others.with_polyline(kept), camera)
    if fit.vector is None or fit.basis is not None:
        return None
    again = farthest_point(polyline, doubted.field, doubted.frame, fit.vector)
    if (
        again is None
        or again[0] != index
        or again[1] <= doubted.limit_px
        or again[2] > SUSPECT_LIMIT_PX / 1.5
    ):
        return None
    return OutlierPoint(index, again[1], again[2])
