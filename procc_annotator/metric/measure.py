"""How far each annotated point is from its element's projection, under every labelling."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.projections import CameraOrProjections
from procc_annotator.metric.polylines import FloatArray, IntArray
from procc_annotator.metric.project import ProjectedField, project_field
from procc_annotator.metric.setup import EvaluationSetup, FieldTables


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
        hallucinated: elements the camera shows that are not annotated, in field order; never
            optional ones.
        hallucinated_annotated_names: what an annotator would have labelled those.
    """

    names: tuple[str, ...]
    annotated_names: tuple[str, ...]
    rows: IntArray
    point_counts: tuple[int, ...]
    projected: tuple[bool, ...]
    all_distances: FloatArray
    hallucinated: tuple[str, ...]
    hallucinated_annotated_names: tuple[str, ...]

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
        return len(self.names) + len(self.hallucinated)

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
        setup: what was asked.
        projected: what the camera shows.
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
    """Measure an annotation against a camera.

    Args:
        annotation: normalised points.
        camera: in px of ``setup.size``.
        setup: field, size, protocol.
    """
    return measure_projected(annotation, project_field(camera, setup), setup)


def measure_projected(
    annotation: FrameAnnotation, projected: ProjectedField, setup: EvaluationSetup
) -> Measurement:
    """Measure an annotation against an already projected field (while only points move)."""
    tables = setup.tables
    names, rows, counts, flat = _labelled_points(annotation, projected, setup)
    points_px = np.array(flat, dtype=np.float64).reshape(-1, 2)
    points_px *= (setup.size[0] - 1, setup.size[1] - 1)
    own = np.array(rows, dtype=np.intp)
    turns: tuple[IntArray | None, ...] = (None, *(tables.turns if setup.considers_mirrored else ()))
    candidates = [own if turn is None else np.where(own >= 0, turn[own], -1) for turn in turns]
    hits = [_is_projected(some, projected) for some in candidates]
    distances = _distances(points_px, np.array(counts, dtype=np.intp), candidates, hits, projected)
    plain, *mirrored = (
        _labelling(names, counts, some, hit, found, projected, tables, turn)
        for some, hit, found, turn in zip(candidates, hits, distances, turns, strict=True)
    )
    return Measurement(setup, projected, plain, tuple(mirrored), points_px)


@lru_cache(maxsize=4)  # what is drawn of a frame is kept of it, too
def nearest_points(measurement: Measurement, labelling: Labelling) -> tuple[FloatArray | None, ...]:
    """The nearest projected position of every annotated point, for whiskers.

    Args:
        measurement: what `measure` returned.
        labelling: its ``plain`` or one of its ``mirrored`` labellings.

    Returns:
        (C,) per class (n, 2) px of the evaluation size in the order of its points, or None where
        the class is not projected; NaN for a point whose element has no measurable segment.
    """
    counts = np.array(labelling.point_counts, dtype=np.intp)
    hit = np.repeat(np.array(labelling.projected, dtype=bool), counts)
    feet = measurement.projected.polylines.segments.feet(
        measurement.points_px[hit], np.repeat(labelling.rows, counts)[hit]
    )
    parts = iter(np.split(feet, labelling.starts[1:]))
    return tuple(next(parts) if seen else None for seen in labelling.projected)


def _labelled_points(
    annotation: FrameAnnotation, projected: ProjectedField, setup: EvaluationSetup
) -> tuple[list[str], list[int], list[int], list[float]]:
    """Class names, field rows, point counts and flat coordinates of the classes that count."""
    index = setup.tables.index
    names: list[str] = []
    rows: list[int] = []
    counts: list[int] = []
    flat: list[float] = []
    for polyline in annotation.polylines:
        points = polyline.points
        name = polyline.class_name
        if name not in index:
            name = setup.field.canonical_name(name)
        if not points or name in projected.left_out:
            continue
        names.append(name)
        rows.append(index.get(name, -1))
        counts.append(len(points))
        for point in points:
            flat += point[:2]
    return names, rows, counts, flat


def _is_projected(rows: IntArray, projected: ProjectedField) -> list[bool]:
    hit: list[bool] = ((rows >= 0) & projected.polylines.detected[rows]).tolist()
    return hit


def _distances(
    points_px: FloatArray,
    counts: IntArray,
    candidates: Sequence[IntArray],
    hits: Sequence[list[bool]],
    projected: ProjectedField,
) -> list[FloatArray]:
    """Distances of the points of projected classes, for all labellings in one go.

    Classes that a turn takes to themselves (the centre circle has most of the segments) are
    measured once.
    """
    rows = [
        np.repeat(np.where(np.array(hit, dtype=bool), row, -1), counts)
        for row, hit in zip(candidates, hits, strict=True)
    ]
    fresh = [rows[0] >= 0, *((other >= 0) & (other != rows[0]) for other in rows[1:])]
    measured = projected.polylines.segments.distances(
        np.concatenate([points_px[new] for new in fresh]),
        np.concatenate([row[new] for row, new in zip(rows, fresh, strict=True)]),
    )
    of_point = np.empty(len(points_px))
    found = []
    for row, new in zip(rows, fresh, strict=True):
        count = np.count_nonzero(new)
        of_point[new], measured = measured[:count], measured[count:]
        found.append(of_point[row >= 0])
    return found


def _labelling(
    names: list[str],
    counts: list[int],
    rows: IntArray,
    hit: list[bool],
    distances: FloatArray,
    projected: ProjectedField,
    tables: FieldTables,
    turn: IntArray | None,
) -> Labelling:
    shown = projected.polylines.detected & tables.is_official
    shown[rows[rows >= 0]] = False
    extra = shown.nonzero()[0]
    hallucinated = tuple([tables.names[row] for row in extra.tolist()])
    own, labelled = tuple(names), hallucinated
    if turn is not None:
        read = zip(names, rows.tolist(), strict=True)
        own = tuple([name if row < 0 else tables.names[row] for name, row in read])
        before = np.empty_like(turn)
        before[turn] = np.arange(len(turn))
        labelled = tuple([tables.names[row] for row in before[extra].tolist()])
    return Labelling(
        own, tuple(names), rows, tuple(counts), tuple(hit), distances, hallucinated, labelled
    )
