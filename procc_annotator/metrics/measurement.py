"""Distances from each annotated point to its element's projection, per labelling."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from typing import Self

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.camera.base import CameraOrProjections
from procc_annotator.metrics.polylines import Polylines
from procc_annotator.metrics.projection import ProjectedField, project_fields
from procc_annotator.metrics.setup import EvaluationSetup, FieldTables


@dataclass(frozen=True, eq=False)
class Labelling:
    """An annotation read with one set of labels (as they are, or those of the field after a turn).

    C annotated classes that have points, in file order, also those without geometry.

    Attributes:
        names: (C,) class names in this labelling.
        annotated_names: (C,) the same classes as the annotator labelled them.
        rows: (C,) field row of each class, -1 for one without geometry.
        point_counts: (C,) annotated points a class.
        projected: (C,) whether the camera shows the class.
        all_distances: px, the points of the projected classes one after the other.
        not_annotated: elements the camera shows that are not annotated, in field order; never
            optional ones.
        not_annotated_labels: what an annotator would have labelled those.
    """

    names: tuple[str, ...]
    annotated_names: tuple[str, ...]
    rows: IntArray
    point_counts: tuple[int, ...]
    projected: tuple[bool, ...]
    all_distances: FloatArray
    not_annotated: tuple[str, ...]
    not_annotated_labels: tuple[str, ...]

    @cached_property
    def starts(self) -> IntArray:
        """(B,) first entry in `all_distances` of each projected class."""
        counts = [n for n, hit in zip(self.point_counts, self.projected, strict=True) if hit]
        return np.cumsum(np.array([0, *counts], dtype=np.intp))[:-1]

    @cached_property
    def worst(self) -> FloatArray:
        """(B,) ascending largest distances of projected classes, px; NaN (never passes) last."""
        if not len(self.all_distances):
            return np.empty(0)
        return np.sort(np.maximum.reduceat(self.all_distances, self.starts))

    @cached_property
    def distances(self) -> tuple[FloatArray | None, ...]:
        """(C,) each class's distances in the order of its points, px; None if not projected."""
        parts = iter(np.split(self.all_distances, self.starts[1:]))
        return tuple(next(parts) if hit else None for hit in self.projected)

    @cached_property
    def element_count(self) -> int:
        """TP + FP + FN at any threshold."""
        return len(self.names) + len(self.not_annotated)

    @cached_property
    def mean_error(self) -> float | None:
        """Plain mean of all distances, px; None if there are none or one is undefined."""
        count = len(self.all_distances)
        return None if not count or np.isnan(self.error_sum) else self.error_sum / count

    @cached_property
    def error_sum(self) -> float:
        """Sum of all distances, px; NaN if one is undefined."""
        return float(self.all_distances.sum())

    @cached_property
    def median_error(self) -> float | None:
        """Median of all distances, px; None as for the mean."""
        return None if self.mean_error is None else float(np.median(self.all_distances))

    @cached_property
    def max_error(self) -> float | None:
        """Largest of all distances, px; None as for the mean."""
        return None if self.mean_error is None else float(self.all_distances.max())


@dataclass(frozen=True, eq=False)
class Measurement:
    """An annotation against a camera, before any threshold.

    Attributes:
        plain: the labels as they are.
        mirrored: the labels of the turned field, one labelling for each of its turns, where the
            setup considers them.
        points_px: (n, 2) all annotated points of the labelled classes, px of the evaluation size.
    """

    setup: EvaluationSetup
    projected: ProjectedField
    plain: Labelling
    mirrored: tuple[Labelling, ...]
    points_px: FloatArray


def measure(
    annotation: FrameAnnotation, camera: CameraOrProjections, setup: EvaluationSetup
) -> Measurement:
    """Measure an annotation against a camera in px of ``setup.size``."""
    return measure_frames([annotation], [camera], setup)[0]


def measure_frames(
    annotations: Sequence[FrameAnnotation],
    cameras: Sequence[CameraOrProjections],
    setup: EvaluationSetup,
) -> list[Measurement]:
    """The same for several frames at once, at least one: the same numbers in half the time."""
    return _build_measurements(annotations, *project_fields(cameras, setup), setup)


def measure_projected(
    annotation: FrameAnnotation, projected: ProjectedField, setup: EvaluationSetup
) -> Measurement:
    """Measure an annotation against an already projected field (while only points move)."""
    return _build_measurements([annotation], [projected], projected.measured, setup)[0]


def _build_measurements(
    annotations: Sequence[FrameAnnotation],
    shown: Sequence[ProjectedField],
    polylines: Polylines,
    setup: EvaluationSetup,
) -> list[Measurement]:
    """Measurements of frames; polylines: what distances are taken to, `Polylines.joined`."""
    labels = _FlatLabels.of(annotations, shown, setup)
    turns = setup.tables.turns if setup.considers_mirrored else ()
    readings = [labels.rows, *(np.where(labels.rows >= 0, t[labels.rows], -1) for t in turns)]
    hits = [(some >= 0) & polylines.detected[labels.first_row + some] for some in readings]
    distances = _point_distances(labels, readings, hits, polylines)
    labellings = [
        _build_labellings(labels, some, hit, found, polylines, setup.tables, turn)
        for some, hit, found, turn in zip(readings, hits, distances, (None, *turns), strict=True)
    ]
    points = np.split(labels.points_px, labels.points_before[1:-1])
    return [
        Measurement(setup, projected, plain, tuple(mirrored), px)
        for projected, px, (plain, *mirrored) in zip(
            shown, points, zip(*labellings, strict=True), strict=True
        )
    ]


@lru_cache(maxsize=4)  # what is drawn of a frame is kept of it, too
def nearest_points(measurement: Measurement, labelling: Labelling) -> tuple[FloatArray | None, ...]:
    """The nearest projected position of every annotated point, for error vectors.

    Args:
        labelling: ``plain`` of the measurement or one of its ``mirrored`` labellings.

    Returns:
        (C,) per class (n, 2) px of the evaluation size in the order of its points, or None where
        the class is not projected; NaN for a point whose element has no measurable segment.
    """
    counts = np.array(labelling.point_counts, dtype=np.intp)
    hit = np.repeat(np.array(labelling.projected, dtype=bool), counts)
    feet = measurement.projected.measured.segments.feet(
        measurement.points_px[hit], np.repeat(labelling.rows, counts)[hit]
    )
    parts = iter(np.split(feet, labelling.starts[1:]))
    return tuple(next(parts) if seen else None for seen in labelling.projected)


@dataclass(frozen=True, eq=False)
class _FlatLabels:
    """The classes of F frames that count, one after the other: C in all.

    Attributes:
        names: (F,) of each frame the class names, in file order.
        counts: (C,) points a class.
        rows: (C,) field row of each class, -1 for one without geometry.
        first_row: (C,) first row of the class's frame where the frames are joined.
        points_px: (n, 2) the points of all, px of the evaluation size.
        classes_before, points_before: (F + 1,) in the frames before.
    """

    names: tuple[tuple[str, ...], ...]
    counts: IntArray
    rows: IntArray
    first_row: IntArray
    points_px: FloatArray
    classes_before: IntArray
    points_before: IntArray

    @classmethod
    def of(
        cls,
        annotations: Sequence[FrameAnnotation],
        shown: Sequence[ProjectedField],
        setup: EvaluationSetup,
    ) -> Self:
        names: list[tuple[str, ...]] = []
        counts: list[int] = []
        flat: list[float] = []
        points_before = [0]
        for annotation, projected in zip(annotations, shown, strict=True):
            names.append(_append_labels(annotation, projected, setup, counts, flat))
            points_before.append(len(flat) // 2)
        index = setup.tables.index
        points_px = np.array(flat, dtype=np.float64).reshape(-1, 2)
        points_px *= (setup.size[0] - 1, setup.size[1] - 1)
        classes = np.array([len(some) for some in names], dtype=np.intp)
        return cls(
            tuple(names),
            np.array(counts, dtype=np.intp),
            np.array([index.get(name, -1) for some in names for name in some], dtype=np.intp),
            np.repeat(np.arange(len(names)) * len(setup.tables.names), classes),
            points_px,
            np.concatenate(((0,), classes.cumsum())),
            np.array(points_before, dtype=np.intp),
        )


def _append_labels(
    annotation: FrameAnnotation,
    projected: ProjectedField,
    setup: EvaluationSetup,
    counts: list[int],
    flat: list[float],
) -> tuple[str, ...]:
    """Names of a frame's classes that count; adds their point counts and flat coordinates."""
    index = setup.tables.index
    names: list[str] = []
    for polyline in annotation.polylines:
        points = polyline.points
        name = polyline.class_name
        if name not in index:
            name = setup.field.canonical_name(name)
        if not points or name in projected.left_out:
            continue
        names.append(name)
        counts.append(len(points))
        for point in points:
            flat += point[:2]
    return tuple(names)


def _point_distances(
    labels: _FlatLabels,
    readings: Sequence[IntArray],
    hits: Sequence[BoolArray],
    polylines: Polylines,
) -> list[FloatArray]:
    """Distances of the points of projected classes, for all labellings in one go.

    Classes that a turn takes to themselves (the centre circle has most of the segments) are
    measured once.
    """
    rows = [
        np.repeat(np.where(hit, labels.first_row + row, -1), labels.counts)
        for row, hit in zip(readings, hits, strict=True)
    ]
    fresh = [rows[0] >= 0, *((other >= 0) & (other != rows[0]) for other in rows[1:])]
    measured = polylines.segments.distances(
        np.concatenate([labels.points_px[new] for new in fresh]),
        np.concatenate([row[new] for row, new in zip(rows, fresh, strict=True)]),
    )
    of_point = np.empty(len(labels.points_px))
    found = []
    for row, new in zip(rows, fresh, strict=True):
        count = np.count_nonzero(new)
        of_point[new], measured = measured[:count], measured[count:]
        found.append(of_point[row >= 0])
    return found


def _build_labellings(
    labels: _FlatLabels,
    rows: IntArray,
    hit: BoolArray,
    distances: FloatArray,
    polylines: Polylines,
    tables: FieldTables,
    turn: IntArray | None,
) -> list[Labelling]:
    """The labellings of all frames under one turn of the field, or none."""
    elements = len(tables.names)
    extra = polylines.detected & np.tile(tables.is_official, len(labels.names))
    extra[(labels.first_row + rows)[rows >= 0]] = False
    extra_frame, extra_row = np.divmod(extra.nonzero()[0], elements)
    before = None
    if turn is not None:
        before = np.empty_like(turn)
        before[turn] = np.arange(len(turn))
    hit_counts = np.concatenate(((0,), np.where(hit, labels.counts, 0).cumsum()))
    found = np.split(distances, hit_counts[labels.classes_before[1:-1]])
    cuts = labels.classes_before.tolist()
    extra_cuts = np.searchsorted(extra_frame, np.arange(len(labels.names) + 1)).tolist()
    counts, hits = labels.counts.tolist(), hit.tolist()
    return [
        _build_labelling(
            names, rows[begin:end], tuple(counts[begin:end]), tuple(hits[begin:end]), near,
            extra_row[first:last], tables, before,
        )
        for names, near, (begin, end), (first, last) in zip(
            labels.names, found, pairwise(cuts), pairwise(extra_cuts), strict=True
        )
    ]  # fmt: skip


def _build_labelling(
    names: tuple[str, ...],
    rows: IntArray,
    counts: tuple[int, ...],
    hits: tuple[bool, ...],
    distances: FloatArray,
    extra: IntArray,
    tables: FieldTables,
    before: IntArray | None,
) -> Labelling:
    """One frame's; extra: (H,) rows only projected; before: (E,) what a turn makes of each row."""
    shown = tuple([tables.names[row] for row in extra.tolist()])
    if before is None:
        return Labelling(names, names, rows, counts, hits, distances, shown, shown)
    read = zip(names, rows.tolist(), strict=True)
    own = tuple([name if row < 0 else tables.names[row] for name, row in read])
    labelled = tuple([tables.names[row] for row in before[extra].tolist()])
    return Labelling(own, names, rows, counts, hits, distances, shown, labelled)
