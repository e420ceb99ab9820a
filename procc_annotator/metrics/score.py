"""TP, FP, FN, JaC and reprojection errors of one frame at a threshold; JaC curves."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from procc_annotator.arrays import FloatArray
from procc_annotator.metrics.measurement import Labelling, Measurement

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
    labelling: Labelling
    read: Labelling

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
    """Score a measured frame.

    An annotated and projected class is correct if all its distances are below the threshold. With
    mirrored labels the best labelling counts; on a tie a mirrored one for ``soccernet`` (as the
    official code does), the unmirrored one for ``procc``; of several turns the first in the field.

    Args:
        measurement: what `measure` returned.
        threshold: px, compared strictly (distance < threshold).
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

    Args:
        measurement: what `measure` returned.
        threshold: px, compared strictly.
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
    """JaC at many thresholds; the same numbers as `score` gives one by one.

    Args:
        measurement: what `measure` returned.
        thresholds: (T,) px, in any order.

    Returns:
        (T,) JaC in [0, 1].
    """
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
