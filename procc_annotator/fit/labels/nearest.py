"""The nearest place of a curve to a click, looked for all along it.

The solver begins at the place of the curve's plane that the click shows. Of a curve seen edge-on
that may be at its far side, or anywhere: the distance is then too large, which the fit survives,
but a label must not be called wrong for it.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.camera.base import Camera
from procc_annotator.field.geometry import length_of
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sample import sample_every
from procc_annotator.fit.labels.limits import RIGHT_PX
from procc_annotator.fit.result import ElementResidual, FitResult
from procc_annotator.fit.solving.observations import FloatArray, Frame, used_points
from procc_annotator.metric.polylines import Polylines

_SAMPLES = 200


def with_nearest(
    fit: FitResult, annotation: FrameAnnotation, field: Field, frame: Frame
) -> FitResult:
    """A fit whose curves that seem to be off have their true distances.

    Args:
        fit: of the annotation.
        annotation: normalised points.
        field: the elements.
        frame: the picture.
    """
    camera, far_px = fit.camera, RIGHT_PX / frame.scale
    if camera is None or not any(_is_in_doubt(e, field, far_px) for e in fit.elements):
        return fit
    elements = []
    for residual in fit.elements:
        polyline, element = annotation.get(residual.name), field.element(residual.name)
        if polyline is not None and element is not None and _is_in_doubt(residual, field, far_px):
            points = points_px(polyline, frame.size)[used_points(polyline, frame)]
            if len(points) == len(residual.distances_px):
                own = nearest(np.array(residual.distances_px), points, element, camera)
                residual = replace(residual, distances_px=tuple(own.tolist()))
        elements.append(residual)
    return replace(fit, elements=tuple(elements))


def nearest(
    distances_px: FloatArray, points: FloatArray, element: Element, camera: Camera
) -> FloatArray:
    """The smaller of known distances and those to the whole of a curve.

    Args:
        distances_px: (n,) px.
        points: (n, 2) px of the picture.
        element: a curved one.
        camera: in px of the picture.

    Returns:
        (n,) px.
    """
    px, shown = camera.project(_samples(element))
    is_end = np.ones(len(px), dtype=bool)
    is_end[:-1] = ~shown[1:]
    shown = shown & np.isfinite(px).all(axis=1)
    if not shown.any():
        return distances_px
    lines = Polylines(px[shown], np.zeros(int(shown.sum()), dtype=np.intp), is_end[shown], 1)
    to_curve = lines.segments.distances(points, np.zeros(len(points), dtype=np.intp))
    return np.minimum(distances_px, to_curve)


def _is_in_doubt(residual: ElementResidual, field: Field, far_px: float) -> bool:
    element = field.element(residual.name)
    return element is not None and element.is_curved and residual.max_px > far_px


@lru_cache(maxsize=64)
def _samples(element: Element) -> FloatArray:
    spacing_m = max(length_of(element.geometry) / _SAMPLES, 0.01)
    return sample_every(Field("", "", (), (element,)), spacing_m).points_world
