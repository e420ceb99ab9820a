"""What the finder of paint has to look for: what the field says, at the size the camera shows."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from functools import cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.base import Camera, projects_only_ground
from procc_annotator.field.appearance import ANY_LINE, LINE
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sample import sample_evenly
from procc_annotator.image.sought import LineTarget

FloatArray = NDArray[np.float64]
Place = tuple[float, float]

_EVERY_M = 0.5
_NEAR_PX = 30.0  # a camera that shows an element farther from a click does not know it
_STEP_M = 0.05


class ExpectedLines:
    """What each element looks like in one picture.

    Args:
        field: its elements.
        width_px: of the picture.
        camera: in px of the picture; None where nobody knows it, or it must not be told.
    """

    def __init__(self, field: Field, width_px: int, camera: Camera | None = None) -> None:
        self._field = field
        self._width_px = width_px
        self._camera = camera
        looks = Counter(e.appearance for e in field.elements if e.appearance.kind == LINE)
        self._usual = looks.most_common(1)[0][0] if looks else ANY_LINE
        self._course = cache(self._projected)

    def of(self, class_name: str) -> LineTarget:
        """What to look for of a class, wherever it is; of one without a place what most elements
        look like."""
        element = self._field.element(class_name)
        looks = element.appearance if element is not None else self._usual
        bends = element is None or element.is_curved
        return replace(LineTarget.of(looks, self._width_px), bends=bends)

    def at(self, class_name: str, place: Place) -> tuple[LineTarget, Place | None]:
        """What to look for of a class near a place in the picture, and in which direction.

        The direction is a unit vector, None where no camera tells it.
        """
        element = self._field.element(class_name)
        course = self._course(class_name)
        if element is None or course is None:
            return self.of(class_name), None
        points, along, scales = course
        apart = np.hypot(*(points - place).T)
        nearest = int(apart.argmin())
        if apart[nearest] > _NEAR_PX:
            return self.of(class_name), None
        x, y = along[nearest].tolist()
        sought = LineTarget.of(element.appearance, self._width_px, float(scales[nearest]))
        return replace(sought, bends=element.is_curved), (x, y)

    def _projected(self, class_name: str) -> tuple[FloatArray, FloatArray, FloatArray] | None:
        """Of places along an element: (n, 2) px, (n, 2) unit directions, (n,) px a metre across."""
        element, camera = self._field.element(class_name), self._camera
        if element is None or camera is None or element.is_spot:
            return None
        if projects_only_ground(camera) and not element.on_ground:
            return None
        samples = sample_evenly(self._field, _EVERY_M).of(self._field.index[class_name])
        points, along, scales = _seen(camera, samples, _across_directions(element, samples))
        known = np.isfinite(scales) & np.isfinite(points).all(axis=1)
        return (points[known], along[known], scales[known]) if known.any() else None


def _across_directions(element: Element, samples: FloatArray) -> tuple[FloatArray, ...]:
    """(n, 3) unit vectors across an element: in the ground, or both ways from a bar."""
    along = np.gradient(samples, axis=0)
    along /= np.maximum(np.linalg.norm(along, axis=1), 1e-9)[:, None]
    if element.on_ground:
        return (np.column_stack([-along[:, 1], along[:, 0], np.zeros(len(along))]),)
    return tuple(axis - (along @ axis)[:, None] * along for axis in np.eye(3))


def _seen(
    camera: Camera, samples: FloatArray, asides: tuple[FloatArray, ...]
) -> tuple[FloatArray, FloatArray, FloatArray]:
    points, visible = camera.project(samples)
    points = np.where(visible[:, None], points, np.nan)
    along = np.gradient(points, axis=0)
    along /= np.maximum(np.hypot(*along.T), 1e-9)[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0]])
    scales = np.zeros(len(points))
    for aside in asides:
        beside, seen = camera.project(samples + _STEP_M * aside)
        apart = np.abs(((beside - points) * across).sum(axis=1)) / _STEP_M
        scales = np.fmax(scales, np.where(seen, apart, np.nan))
    return points, along, np.where(visible & (scales > 0), scales, np.nan)
