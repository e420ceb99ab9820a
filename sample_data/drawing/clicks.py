"""Annotations of the sample: what a careful person would have clicked."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from drawing.views import PICTURE_SIZE, View
from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.field.load import load_field
from procc_annotator.metric.project import project_field
from procc_annotator.metric.setup import EvaluationSetup

FloatArray = NDArray[np.float64]

NOISE_PX = 0.7
SHORTEST_PX = 14.0
CURVE_POINTS = 9


def annotation_of(view: View) -> FrameAnnotation:
    """Every visible element of at least 14 px: two or three points, about nine on curves."""
    random = np.random.default_rng(int(view.name) + 1000)
    field = load_field()
    setup = EvaluationSetup(field, size=PICTURE_SIZE, protocol="procc")
    pieces = project_field(view.picture_camera, setup).pieces
    polylines = []
    for element in field.elements:
        curves = [c for c in pieces.get(element.name, ()) if _length(c) >= SHORTEST_PX]
        if not curves:
            continue
        if element.is_straight:
            count = 3 if _length(curves[0]) > 250 and random.random() < 0.6 else 2
        else:
            count = CURVE_POINTS
        clicked = np.concatenate([_spread(c, _share(c, curves, count)) for c in curves])
        clicked += random.normal(0, NOISE_PX, clicked.shape)
        points = tuple(point_from_px(round(x, 2), round(y, 2), PICTURE_SIZE) for x, y in clicked)
        polylines.append(Polyline(element.name, points))
    return FrameAnnotation(tuple(polylines))


def _length(curve: FloatArray) -> float:
    return float(np.linalg.norm(np.diff(curve, axis=0), axis=1).sum())


def _share(curve: FloatArray, curves: list[FloatArray], count: int) -> int:
    total = sum(_length(c) for c in curves)
    return max(2, round(count * _length(curve) / total))


def _spread(curve: FloatArray, count: int) -> FloatArray:
    """``count`` points regularly spaced along a curve, its ends included."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    wanted = np.linspace(0, along[-1], count)
    return np.column_stack([np.interp(wanted, along, curve[:, i]) for i in range(2)])
