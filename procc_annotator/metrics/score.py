"""Scores of a measurement at a threshold, and their explanation per element."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.field.model import Field
from procc_annotator.metrics.measurement import Labelling, Measurement
from procc_annotator.metrics.polylines import Polylines
from procc_annotator.metrics.projection import project_unclipped
from procc_annotator.translation import tr, word

Status = Literal["tp", "too_far", "not_annotated", "missed"]

_NO_DISTANCES = np.empty(0)
_NO_DISTANCES.setflags(write=False)


@dataclass(frozen=True, eq=False, slots=True)
class ElementScore:
    """One element's verdict: ``too_far`` and ``not_annotated`` count as FP, ``missed`` as FN.

    Attributes:
        name: the class in the labelling that counts; annotated_name: as the annotator labels it.
        status: the verdict.
        distances: (n,) px in the order of the polyline's points, empty where there are none.
        max_distance: the largest one; None where there are none or it is undefined.
        deciding_point: index in the polyline of the point with that distance.
    """

    name: str
    annotated_name: str
    status: Status
    distances: FloatArray
    max_distance: float | None = None
    deciding_point: int | None = None

    @property
    def passes_above(self) -> float | None:
        """The element is correct at every threshold above this one, px."""
        return self.max_distance


@dataclass(frozen=True, eq=False)
class FrameScore:
    """The score of one frame at one threshold, from the labelling that counts.

    Attributes:
        labelling: the one that counts; mirrored: whether it is a mirrored one.
        read: the one whose errors are reported: the labels as annotated unless mirrored ones score
            higher. On a tie the official evaluation counts the mirrored labels, whose distances
            belong to the other half of the field and say nothing.
    """

    threshold: float
    tp: int
    fp: int
    fn: int
    mirrored: bool
    labelling: Labelling = field(repr=False)
    read: Labelling = field(repr=False)

    @property
    def jac(self) -> float:
        """TP / (TP + FP + FN); 0 when all are zero."""
        return _ratio(self.tp, self.tp + self.fp + self.fn) or 0.0

    @property
    def precision(self) -> float | None:
        """TP / (TP + FP); None when the camera shows nothing."""
        return _ratio(self.tp, self.tp + self.fp)

    @property
    def recall(self) -> float | None:
        """TP / (TP + FN); None when nothing is to be found."""
        return _ratio(self.tp, self.tp + self.fn)

    @property
    def mean_error(self) -> float | None:
        """Mean reprojection error, px; None when no class is both annotated and projected."""
        return self.read.mean_error

    @property
    def median_error(self) -> float | None:
        """Median reprojection error, px; None as for the mean."""
        return self.read.median_error

    @property
    def max_error(self) -> float | None:
        """Largest reprojection error, px; None as for the mean."""
        return self.read.max_error

    @property
    def mean_reprojection_error(self) -> float | None:
        """The mean error under the labelling that counts, as the official evaluation gives it."""
        return self.labelling.mean_error

    @cached_property
    def elements(self) -> tuple[ElementScore, ...]:
        """The verdict on every element: annotated ones in file order, then those only projected."""
        labels = self.labelling
        annotated = zip(labels.names, labels.annotated_names, labels.distances, strict=True)
        others = zip(labels.not_annotated, labels.not_annotated_labels, strict=True)
        return (
            *(_element_score(name, own, found, self.threshold) for name, own, found in annotated),
            *(ElementScore(name, own, "not_annotated", _NO_DISTANCES) for name, own in others),
        )


def score(measurement: Measurement, threshold: float) -> FrameScore:
    """Score a measured frame at a threshold, px, compared strictly (distance < threshold).

    An annotated and projected class is correct if all its distances are below the threshold. With
    mirrored labels the best labelling counts; on a tie a mirrored one for ``soccernet`` (as the
    official code does), the unmirrored one for ``procc``; of several turns the first in the field.
    """
    best = read = measurement.plain
    tp = int(best.worst.searchsorted(threshold))
    for mirrored in measurement.mirrored:
        other = int(mirrored.worst.searchsorted(threshold))
        gain = _labelling_gain(other, mirrored, tp, best)
        if gain > 0:
            best, tp, read = mirrored, other, mirrored
        elif gain == 0 and best is measurement.plain and measurement.setup.is_official:
            best, tp = mirrored, other
    return _frame_score(threshold, tp, best, best is not measurement.plain, read)


def display_score(measurement: Measurement, threshold: float) -> FrameScore:
    """The score as a person reads it: the same JaC, with the labels as they are on a tie.

    On a tie the official evaluation takes the mirrored labels. Its JaC is the same, but every
    distance and verdict then belongs to the other half of the field, and says nothing.
    """
    counted = score(measurement, threshold)
    plain = measurement.plain
    if counted.read is counted.labelling:
        return counted
    return _frame_score(threshold, int(plain.worst.searchsorted(threshold)), plain, False, plain)


def _labelling_gain(tp: int, labelling: Labelling, other_tp: int, other: Labelling) -> int:
    """Return whether the JaC of a labelling is above (> 0) that of another one, or the same (0).

    Compared without dividing; all counts zero is JaC 0.
    """
    return tp * max(other.element_count, 1) - other_tp * max(labelling.element_count, 1)


def jac_curve(measurement: Measurement, thresholds: ArrayLike) -> FloatArray:
    """JaC in [0, 1], (T,), at many thresholds (T,), px, in any order; the same numbers as `score`
    gives one by one."""
    taus = np.asarray(thresholds, dtype=np.float64)
    curve = _labelling_curve(measurement.plain, taus)
    for mirrored in measurement.mirrored:
        curve = np.maximum(curve, _labelling_curve(mirrored, taus))
    return curve


def _labelling_curve(labelling: Labelling, taus: FloatArray) -> FloatArray:
    passed = np.searchsorted(labelling.worst, taus)
    return np.asarray(passed / max(labelling.element_count, 1), dtype=np.float64)


def _frame_score(
    threshold: float, tp: int, labelling: Labelling, mirrored: bool, read: Labelling
) -> FrameScore:
    both = len(labelling.worst)
    return FrameScore(
        threshold=float(threshold),
        tp=tp,
        fp=both - tp + len(labelling.not_annotated),
        fn=len(labelling.names) - both,
        mirrored=mirrored,
        labelling=labelling,
        read=read,
    )


def _element_score(
    name: str, own: str, distances: FloatArray | None, threshold: float
) -> ElementScore:
    if distances is None:
        return ElementScore(name, own, "missed", _NO_DISTANCES)
    deciding = int(np.argmax(distances))  # the first NaN, if any: it decides as well
    largest = float(distances[deciding])
    status: Status = "tp" if largest < threshold else "too_far"
    return ElementScore(
        name, own, status, distances, None if np.isnan(largest) else largest, deciding
    )


def _ratio(part: int, whole: int) -> float | None:
    return part / whole if whole else None


_MAX_DIGITS = 6
_AGREES_TEXT = word(
    "{element} agrees: its farthest point, {number}, is {px} px off; it passes at tau > {px}."
)
_TOO_FAR_TEXT = word(
    "{element} is too far: point {number} is {px} px off; it passes at tau > {px}."
)
_STATUS_ORDER: dict[Status, int] = {"too_far": 0, "missed": 1, "not_annotated": 2, "tp": 3}


@dataclass(frozen=True, slots=True)
class ScoreExplanation:
    """Result of one element at a threshold.

    Attributes:
        name: the class in the labelling that counts; annotated_name: as the annotator labels it.
        deciding_point: index (from 0) in the polyline of the farthest point, or of the first one
            without a distance; None where no point was measured.
        deciding_px: its distance; None if absent.
        passes_above: the element is correct at every threshold above this one, px; None if it is
            at none.
        sentence: for people; points are counted from 1.
    """

    name: str
    annotated_name: str
    status: Status
    deciding_point: int | None
    deciding_px: float | None
    passes_above: float | None
    sentence: str


def explain_score(
    score: FrameScore, measurement: Measurement, field: Field
) -> tuple[ScoreExplanation, ...]:
    """Explain every element of a score, of this measurement at any threshold, in its order."""
    beyond = _farthest_outside_image(score, measurement)
    return tuple(
        ScoreExplanation(
            judged.name,
            judged.annotated_name,
            judged.status,
            judged.deciding_point,
            judged.max_distance,
            judged.passes_above,
            _sentence(judged, score.threshold, measurement, field)
            + _clipped_note(beyond.get(judged.name), score.threshold),
        )
        for judged in score.elements
    )


def worst_elements_first(explanations: Iterable[ScoreExplanation]) -> tuple[ScoreExplanation, ...]:
    """Return what lowers the score first: too far (farthest first), missed, not annotated, then the
    rest.

    Elements alike keep their order.
    """

    def rank(said: ScoreExplanation) -> tuple[int, bool, float]:
        # A point without a distance is worse than any distance.
        known = said.deciding_px is not None or said.deciding_point is None
        return _STATUS_ORDER[said.status], known, -(said.deciding_px or 0.0)

    return tuple(sorted(explanations, key=rank))


def _sentence(judged: ElementScore, tau: float, measurement: Measurement, field: Field) -> str:
    who = _element_label(judged, field)
    if judged.status == "not_annotated":
        return tr(
            "{element} is not annotated, but the camera shows it: a false positive.", element=who
        )
    if judged.status == "missed":
        return tr(_missed_reason(judged, measurement, field), element=who)
    number = (judged.deciding_point or 0) + 1
    if judged.max_distance is None:
        return tr(
            "{element} is too far: point {number} has no distance, because the projection has"
            " coinciding samples there; it passes at no tau.",
            element=who,
            number=number,
        )
    said = _AGREES_TEXT if judged.status == "tp" else _TOO_FAR_TEXT
    return tr(said, element=who, number=number, px=px_text(judged.max_distance, tau))


def _farthest_outside_image(score: FrameScore, measurement: Measurement) -> dict[str, float]:
    """Of elements that are too far and leave the picture, where only what is in it is measured to:
    the distance of the farthest point to the element as it goes on, px."""
    shown, setup, labels = measurement.projected, measurement.setup, score.labelling
    if not setup.is_official or shown.camera is None:
        return {}
    index = setup.tables.index
    wanted = np.zeros(len(shown.names), dtype=bool)
    wanted[[index[e.name] for e in score.elements if e.status == "too_far"]] = True
    wanted &= _touches_border(shown.polylines, setup.size)
    if not wanted.any():
        return {}
    lines = project_unclipped(shown.camera, setup, wanted)
    points = np.split(measurement.points_px, np.cumsum(labels.point_counts)[:-1])
    return {
        name: float(lines.segments.distances(px, np.full(len(px), row)).max())
        for name, row, px in zip(labels.names, labels.rows.tolist(), points, strict=True)
        if row >= 0 and lines.detected[row]
    }


def _touches_border(lines: Polylines, size: tuple[int, int]) -> BoolArray:
    """(E,) whether an element has a vertex on the border of the picture."""
    on_border = ((lines.vertices == 0) | (lines.vertices == np.array(size) - 1)).any(axis=1)
    leaving = np.zeros(lines.element_count, dtype=bool)
    leaving[lines.element[on_border]] = True
    return leaving


def _clipped_note(farthest: float | None, tau: float) -> str:
    if farthest is None or not farthest < tau:
        return ""
    return " " + tr(
        "As it goes on beyond the picture it is at most {px} px off, but soccernet measures to what"
        " is in the picture alone.",
        px=px_text(farthest, tau),
    )


def _element_label(judged: ElementScore, field: Field) -> str:
    title = tr(field.title_of(judged.annotated_name))
    if judged.name == judged.annotated_name:
        return title
    other = tr(field.title_of(judged.name))
    return tr("{title} (judged as {other}, labels mirrored)", title=title, other=other)


def _missed_reason(judged: ElementScore, measurement: Measurement, field: Field) -> str:
    element = field.element(judged.name)
    if element is None:
        return word(
            "{element} is missed: it is annotated, but the field has no such element to project."
        )
    if measurement.projected.ground_only and not element.on_ground:
        return word(
            "{element} is missed: it is annotated, but it leaves the ground, and the camera knows"
            " only the ground."
        )
    return word(
        "{element} is missed: it is annotated, but the camera does not show it in the picture."
    )


def px_text(distance: float, tau: float) -> str:
    """A distance, px, with one decimal, or as many as it takes to be on its side of the threshold:
    what fails at 5 px does not read as 5.0, nor does what passes."""
    for digits in range(1, _MAX_DIGITS):
        shown = round(distance, digits)
        if (shown < tau, shown > tau) == (distance < tau, distance > tau):
            return f"{distance:.{digits}f}"
    return f"{distance:.{_MAX_DIGITS}f}"
