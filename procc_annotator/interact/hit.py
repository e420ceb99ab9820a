"""What is under the cursor: a point or a segment of an annotated polyline."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.interact.palette import PICK_RADIUS_PX

_SAME_PX = 0.5


@dataclass(frozen=True, slots=True)
class Hit:
    """A target under the cursor.

    Attributes:
        class_name: whose polyline.
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
    radius_screen: float = PICK_RADIUS_PX,
) -> Hit | None:
    """The nearest point within the pick radius, else the nearest segment within it.

    Args:
        annotation: what can be hit.
        picture_size: (width, height) px.
        position: cursor, picture px.
        view_scale: screen px per picture px; the radius does not shrink or grow with zoom.
        prefer: this class wins where two targets are equally near (crossing elements share
            points).
        radius_screen: pick radius in screen px.
    """
    cursor = np.array(position, dtype=np.float64)
    best: dict[str, tuple[float, Hit]] = {}
    for polyline in annotation.polylines:
        if not polyline.points:
            continue
        points = points_px(polyline, picture_size)
        bonus = _SAME_PX if polyline.class_name == prefer else 0.0
        away = np.hypot(*(points - cursor).T) * view_scale
        i = int(np.argmin(away))
        _keep(best, _hit(polyline.class_name, "point", i, float(away[i]), points[i]), bonus)
        if len(points) > 1:
            feet = _feet(points, cursor)
            away = np.hypot(*(feet - cursor).T) * view_scale
            i = int(np.argmin(away))
            _keep(best, _hit(polyline.class_name, "segment", i, float(away[i]), feet[i]), bonus)
    for kind in ("point", "segment"):
        found = best.get(kind)
        if found is not None and found[1].distance_screen <= radius_screen:
            return found[1]
    return None


def _feet(points: np.ndarray, cursor: np.ndarray) -> np.ndarray:
    """(n - 1, 2) the nearest position on each segment."""
    step = points[1:] - points[:-1]
    squared = np.maximum((step**2).sum(axis=1), 1e-12)
    t = np.clip(((cursor - points[:-1]) * step).sum(axis=1) / squared, 0.0, 1.0)
    feet: np.ndarray = points[:-1] + t[:, None] * step
    return feet


def _hit(
    class_name: str, kind: Literal["point", "segment"], index: int, away: float, foot: np.ndarray
) -> Hit:
    return Hit(class_name, kind, index, away, (float(foot[0]), float(foot[1])))


def _keep(best: dict[str, tuple[float, Hit]], hit: Hit, bonus: float) -> None:
    rank = hit.distance_screen - bonus
    if hit.kind not in best or rank < best[hit.kind][0]:
        best[hit.kind] = (rank, hit)
