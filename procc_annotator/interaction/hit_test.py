"""Find the annotated point or segment under the cursor."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.interaction.palette import PICK_RADIUS_PX

_SAME_PX = 0.5


@dataclass(frozen=True, slots=True)
class Hit:
    """A target under the cursor.

    Attributes:
        class_name: of the polyline.
        kind: ``point``, or ``segment`` between ``index`` and ``index + 1``.
        index: which one.
        distance_screen: screen px from the cursor.
        foot: nearest position on the target, picture px.
    """

    class_name: str
    kind: Literal["point", "segment"]
    index: int
    distance_screen: float
    foot: tuple[float, float]


def hit_test(
    annotation: FrameAnnotation,
    picture_size: tuple[int, int],
    position: tuple[float, float],
    view_scale: float,
    *,
    prefer: str | None = None,
) -> Hit | None:
    """The nearest point within the pick radius, else the nearest segment within it.

    Args:
        annotation: what can be hit.
        picture_size: (width, height) px.
        position: cursor, picture px.
        view_scale: screen px per picture px; the radius does not shrink or grow with zoom.
        prefer: this class wins where two targets are equally near (crossing elements share points).
    """
    points, owners, starts = _all_points(annotation, picture_size)
    if not len(points):
        return None
    names = [p.class_name for p in annotation.polylines]
    cursor = np.array(position, dtype=np.float64)
    preferred = names.index(prefer) if prefer in names else -1

    def nearest(feet: FloatArray, rows: IntArray, kind: Literal["point", "segment"]) -> Hit | None:
        away = np.hypot(feet[:, 0] - cursor[0], feet[:, 1] - cursor[1]) * view_scale
        near = np.flatnonzero(away <= PICK_RADIUS_PX)
        if not len(near):
            return None
        best = near[np.argmin(away[near] - _SAME_PX * (owners[rows[near]] == preferred))]
        row = rows[best]
        owner = owners[row]
        x, y = feet[best].tolist()
        return Hit(names[owner], kind, int(row - starts[owner]), float(away[best]), (x, y))

    found = nearest(points, np.arange(len(points)), "point")
    if found is not None:
        return found
    first = np.flatnonzero(owners[1:] == owners[:-1])
    return nearest(closest_on_segments(points[first], points[first + 1], cursor), first, "segment")


def _all_points(
    annotation: FrameAnnotation, picture_size: tuple[int, int]
) -> tuple[FloatArray, IntArray, IntArray]:
    """Points of all polylines, picture px; each one's polyline; each polyline's first point."""
    counts = np.array([len(p.points) for p in annotation.polylines], dtype=np.intp)
    flat = [c for polyline in annotation.polylines for point in polyline.points for c in point[:2]]
    points = np.array(flat, dtype=np.float64).reshape(-1, 2)
    points *= (picture_size[0] - 1, picture_size[1] - 1)
    return points, np.repeat(np.arange(len(counts)), counts), np.cumsum(counts) - counts


def closest_on_segments(begin: FloatArray, end: FloatArray, cursor: FloatArray) -> FloatArray:
    """(n, 2) the position on each segment nearest to the cursor."""
    step = end - begin
    squared = np.maximum((step * step).sum(axis=1), 1e-12)
    along = ((cursor - begin) * step).sum(axis=1) / squared
    feet: FloatArray = begin + np.clip(along, 0.0, 1.0)[:, None] * step
    return feet
