"""Lines that carry a label already, though not their own.

An element that the fit took for a mistake may lie along another one: its line is annotated, under
the wrong class. To offer the right class as well would give one painted line two labels.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.fit.predict.sight import VisibleStretch
from procc_annotator.fit.result import FitResult
from procc_annotator.metric.polylines import Polylines

_MAX_DISTANCE_PX = 6.0  # at 960 px width
_MIN_POINT_SHARE = 0.8  # of an element's points lie along the other one
_NEARER_RATIO = 3.0  # than to where the camera shows their own element


def classes_labelled_otherwise(
    annotation: FrameAnnotation, fit: FitResult, stretches: Iterable[VisibleStretch]
) -> frozenset[str]:
    """The classes along which another element is annotated that does not belong there.

    Elements that really coincide in the picture are none: each lies where the camera shows it.

    Args:
        annotation: that was fitted.
        fit: to it.
        stretches: what is in sight of the classes in question.
    """
    along_px = _MAX_DISTANCE_PX * (fit.size[0] - 1) / 959
    far_px = _NEARER_RATIO * along_px
    astray = {e.name: e.mean_px for e in fit.elements if e.left_out or e.mean_px > far_px}
    courses: dict[str, list[np.ndarray]] = {}
    for stretch in stretches:
        courses.setdefault(stretch.name, []).append(stretch.points_px)
    found = set()
    for polyline in annotation:
        if polyline.class_name not in astray or len(polyline.points) < 2:
            continue
        points = points_px(polyline, fit.size)
        for name, pieces in courses.items():
            apart = _distances_to_pieces(points, pieces)
            near = float(np.mean(apart <= along_px)) >= _MIN_POINT_SHARE
            if near and _NEARER_RATIO * float(np.median(apart)) <= astray[polyline.class_name]:
                found.add(name)
    return frozenset(found)


def _distances_to_pieces(points: np.ndarray, pieces: list[np.ndarray]) -> np.ndarray:
    """(n,) px from points to the nearest of some courses."""
    vertices = np.concatenate(pieces)
    is_end = np.zeros(len(vertices), dtype=bool)
    is_end[np.cumsum([len(piece) for piece in pieces]) - 1] = True
    lines = Polylines(vertices, np.zeros(len(vertices), dtype=np.intp), is_end, 1)
    return lines.segments.distances(points, np.zeros(len(points), dtype=np.intp))
