"""Metrics of a set of frames, accumulated per frame; annotated extent; choice of distinct views."""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from statistics import median

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Element, Field
from procc_annotator.metrics.measurement import Labelling, Measurement
from procc_annotator.metrics.score import FrameScore
from procc_annotator.metrics.setup import EvaluationSetup

CountArray = NDArray[np.int64]

# The devkit's stand-ins for the points of an element that is projected but not annotated; a place
# is one click, of which the devkit knows none.
_CURVE_POINTS = 9
_LINE_POINTS = 2
_SPOT_POINTS = 1


@dataclass(frozen=True, slots=True)
class ClassSummary:
    """One class over a set; the counts are points, not elements."""

    tp: int
    fp: int
    fn: int

    @property
    def jac(self) -> float | None:
        """TP / (TP + FP + FN); None when all are zero."""
        return _ratio(self.tp, self.tp + self.fp + self.fn)

    @property
    def precision(self) -> float | None:
        """TP / (TP + FP); None when nothing is shown."""
        return _ratio(self.tp, self.tp + self.fp)

    @property
    def recall(self) -> float | None:
        """TP / (TP + FN); None when nothing is annotated."""
        return _ratio(self.tp, self.tp + self.fn)


@dataclass(frozen=True, slots=True)
class SetSummary:
    """Figures of a set at one threshold; None where undefined (no frame to take them from).

    Attributes:
        images: annotation files in the set. evaluated: those that have a camera.
        mean_jac, sd_jac (divided by n, not n - 1), median_jac: over the evaluated images.
        completeness: evaluated / images. final_score: completeness * mean_jac.
        mean_precision, mean_recall: over the evaluated images where they are defined.
        mean_reprojection_error: px, over all points of all images together, under the labelling
            that counts. mean_error: the same under the one that is read, see `FrameScore`.
        per_class: class name -> sums over the evaluated images.
        tied: images in which mirrored labels count and those annotated score as high.
    """

    threshold: float
    images: int
    evaluated: int
    mean_jac: float | None
    sd_jac: float | None
    median_jac: float | None
    completeness: float | None
    final_score: float | None
    mean_precision: float | None
    mean_recall: float | None
    mean_reprojection_error: float | None
    mean_error: float | None
    per_class: Mapping[str, ClassSummary] = field(repr=False)
    tied: int = 0


@dataclass(slots=True)
class _ThresholdSums:
    """Data of one threshold: the JaC of every image, and sums; of errors under the labelling that
    counts, and under the one that is read."""

    jacs: array[float] = field(default_factory=lambda: array("d"))
    precision_sum: float = 0.0
    precision_count: int = 0
    recall_sum: float = 0.0
    recall_count: int = 0
    error_sum: float = 0.0
    error_count: int = 0
    read_error_sum: float = 0.0
    read_error_count: int = 0
    tied: int = 0

    def add(self, score: FrameScore) -> None:
        self.jacs.append(score.jac)
        precision, recall = score.precision, score.recall
        if precision is not None:
            self.precision_sum += precision
            self.precision_count += 1
        if recall is not None:
            self.recall_sum += recall
            self.recall_count += 1
        self.error_sum += score.labelling.error_sum
        self.error_count += len(score.labelling.all_distances)
        self.read_error_sum += score.read.error_sum
        self.read_error_count += len(score.read.all_distances)
        self.tied += score.read is not score.labelling

    def merge(self, other: _ThresholdSums) -> None:
        self.jacs.extend(other.jacs)
        for number in fields(self)[1:]:
            total = getattr(self, number.name) + getattr(other, number.name)
            setattr(self, number.name, total)


class SetAccumulator:
    """Gathers frame scores of one setup, each at all of the thresholds (px); parts gathered
    elsewhere can be merged."""

    def __init__(self, setup: EvaluationSetup, thresholds: Iterable[float]) -> None:
        self.setup = setup
        self.thresholds = tuple(float(t) for t in thresholds)
        self._taus = np.array(self.thresholds, dtype=np.float64)
        self._missing = 0
        self._gathered = [_ThresholdSums() for _ in self.thresholds]
        self._class_index: dict[str, int] = {}
        # (T, classes, 3) points: tp, fp, fn; grows with the class names met.
        self._classes: CountArray = np.zeros((len(self.thresholds), 0, 3), dtype=np.int64)
        self._reserve(e.name for e in setup.field.elements)
        self._stand_ins = {e.name: _placeholder_points(e) for e in setup.field.elements}

    def add(
        self, name: str, measurement: Measurement | None, scores: Mapping[float, FrameScore]
    ) -> None:
        """Add an image that has a camera; the measurement, if given, is checked to be of this set's
        protocol and size. `UsageError` if a threshold has no score, or the frame was measured
        differently."""
        if measurement is not None and not _same_setup(self.setup, measurement.setup):
            raise UsageError(f"{name}: measured with {measurement.setup.describe()}")
        missing = [t for t in self.thresholds if t not in scores]
        if missing:
            raise UsageError(f"{name}: no score at {missing[0]:g} px")
        chosen = [scores[t] for t in self.thresholds]
        for gathered, score in zip(self._gathered, chosen, strict=True):
            gathered.add(score)
        self._add_classes([score.labelling for score in chosen])

    def add_missing_camera(self, name: str) -> None:
        """Count an annotated image that has no (usable) camera; it lowers completeness only."""
        del name  # which one it was is the caller's to report
        self._missing += 1

    def merge(self, other: SetAccumulator) -> None:
        """Add everything another accumulator of the same setup gathered; `UsageError` if it
        gathered other thresholds or another protocol or size."""
        if other.thresholds != self.thresholds or not _same_setup(other.setup, self.setup):
            raise UsageError("sets scored differently cannot be merged")
        self._missing += other._missing
        for mine, theirs in zip(self._gathered, other._gathered, strict=True):
            mine.merge(theirs)
        self._reserve(other._class_index)
        rows = [self._class_index[name] for name in other._class_index]
        self._classes[:, rows] += other._classes[:, : len(rows)]

    def summary(self) -> dict[float, SetSummary]:
        """The figures so far, by threshold."""
        return {t: self._summary_at(i) for i, t in enumerate(self.thresholds)}

    def _summary_at(self, i: int) -> SetSummary:
        gathered = self._gathered[i]
        jacs = np.array(gathered.jacs, dtype=np.float64)
        evaluated = len(jacs)
        images = evaluated + self._missing
        completeness = _ratio(evaluated, images)
        mean = float(jacs.mean()) if evaluated else None
        return SetSummary(
            threshold=self.thresholds[i],
            images=images,
            evaluated=evaluated,
            mean_jac=mean,
            sd_jac=float(jacs.std()) if evaluated else None,
            median_jac=median(gathered.jacs) if evaluated else None,
            completeness=completeness,
            final_score=None if mean is None or completeness is None else completeness * mean,
            mean_precision=_ratio(gathered.precision_sum, gathered.precision_count),
            mean_recall=_ratio(gathered.recall_sum, gathered.recall_count),
            mean_reprojection_error=_mean(gathered.error_sum, gathered.error_count),
            mean_error=_mean(gathered.read_error_sum, gathered.read_error_count),
            per_class={
                name: ClassSummary(*self._classes[i, row].tolist())
                for name, row in self._class_index.items()
                if self._classes[i, row].any()
            },
            tied=gathered.tied,
        )

    def _add_classes(self, labellings: Sequence[Labelling]) -> None:
        """Add point counts a class; at each threshold from the labelling that counts there."""
        for labelling in dict.fromkeys(labellings):
            at = np.array([i for i, some in enumerate(labellings) if some is labelling])
            self._reserve(labelling.names)
            self._reserve(labelling.not_annotated)
            index = self._class_index
            both: list[int] = []
            shown = zip(labelling.names, labelling.point_counts, labelling.projected, strict=True)
            for name, count, projected in shown:
                if projected:
                    both.append(index[name])
                else:
                    self._classes[at, index[name], 2] += count
            for name in labelling.not_annotated:
                self._classes[at, index[name], 1] += self._stand_ins[name]
            if both:
                below = labelling.all_distances < self._taus[at, None]
                passed = np.add.reduceat(below, labelling.starts, axis=1, dtype=np.int64)
                total = np.diff(np.append(labelling.starts, len(labelling.all_distances)))
                self._classes[at[:, None], both, 0] += passed
                self._classes[at[:, None], both, 1] += total - passed

    def _reserve(self, names: Iterable[str]) -> None:
        new = [name for name in names if name not in self._class_index]
        if not new:
            return
        for name in new:
            self._class_index.setdefault(name, len(self._class_index))
        grown = len(self._class_index) - self._classes.shape[1]
        self._classes = np.pad(self._classes, ((0, 0), (0, grown), (0, 0)))


def _placeholder_points(element: Element) -> int:
    if element.is_spot:
        return _SPOT_POINTS
    return _CURVE_POINTS if element.is_curved else _LINE_POINTS


def _same_setup(a: EvaluationSetup, b: EvaluationSetup) -> bool:
    def conditions(s: EvaluationSetup) -> tuple[object, ...]:
        return s.protocol, s.size, s.allow_mirrored, s.off_plane, s.planar_only

    if conditions(a) != conditions(b):
        return False
    # A frame's field has the dimensions of its stadium.
    fields = {a.field.described, *(own.described for own in a.field.of_stadiums.values())}
    return b.field.described in fields


def _mean(total: float, count: int) -> float | None:
    """None where there is nothing, or something undefined (NaN) in it."""
    return total / count if count and total == total else None


def _ratio(part: float, whole: float) -> float | None:
    return part / whole if whole else None


@dataclass(frozen=True, slots=True)
class AnnotatedExtent:
    """Annotated elements of a field in one frame: how many have points, and the share of the
    picture that these points enclose (``spread``; None without points)."""

    annotated_elements: int
    spread: float | None


def annotated_extent(annotation: FrameAnnotation, field: Field) -> AnnotatedExtent:
    """Number of elements and spread of their points.

    The spread is the area of the convex hull of all points, over that of the picture; points
    outside count where the border is nearest to them. It is 0 for points on one line.
    """
    count = 0
    flat: list[float] = []
    for polyline in annotation.polylines:
        if polyline.points and field.canonical_name(polyline.class_name) in field.index:
            count += 1
            for point in polyline.points:
                flat += point[:2]
    if not flat:
        return AnnotatedExtent(0, None)
    points = np.clip(np.array(flat, dtype=np.float32).reshape(-1, 2), 0.0, 1.0)
    return AnnotatedExtent(count, float(cv2.contourArea(cv2.convexHull(points))))


# Twice as large a picture differs as much as one that is half a picture's width aside.
_ZOOM_SCALE = 0.5 / np.log(2)


def most_distinct_views(
    cameras: Sequence[PinholeCamera], widths_px: Sequence[int], count: int
) -> list[int]:
    """The places, in the order they were chosen, of ``count`` views (all where there are fewer)
    that differ most, by where cameras in px of their pictures look and how far they zoom.

    The first is the one nearest to the middle of all; each further one is the one farthest from
    those before, the earliest of equals.
    """
    if not cameras or count < 1:
        return []
    places = _view_coordinates(cameras, widths_px)
    chosen = [int(np.hypot(*(places - np.median(places, axis=0)).T).argmin())]
    nearest = np.full(len(places), np.inf)
    while len(chosen) < min(count, len(places)):
        nearest = np.minimum(nearest, np.hypot(*(places - places[chosen[-1]]).T))
        nearest[chosen] = -1.0
        chosen.append(int(nearest.argmax()))
    return chosen


def _view_coordinates(
    cameras: Sequence[PinholeCamera], widths_px: Sequence[int]
) -> NDArray[np.float64]:
    """(n, 2) pan in widths of the usual view, and zoom on the scale of it."""
    pans = np.unwrap([camera.pan_rad for camera in cameras])
    focal = np.array([c.focal_px[0] / w for c, w in zip(cameras, widths_px, strict=True)])
    usual = float(np.exp(np.median(np.log(focal))))
    width_rad = 2 * np.arctan(0.5 / usual)
    return np.column_stack([pans / width_rad, _ZOOM_SCALE * np.log(focal / usual)])
