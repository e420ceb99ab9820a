"""The ground as cameras see it, and the field's rectangle on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.backproject import ground_from_px
from procc_annotator.camera.base import Camera, FloatArray
from procc_annotator.camera.projections import CameraOrProjections, ElementProjections
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.field.sample import sample_evenly
from procc_annotator.metric.polylines import BoolArray

_CURVE_SPACING_M = 0.1


@dataclass(frozen=True, slots=True)
class GroundRectangle:
    """A rectangle on the ground, metres, world frame; its border belongs to it."""

    left: float
    top: float
    right: float
    bottom: float

    @property
    def corners(self) -> FloatArray:
        """(4, 2) metres, around the rectangle."""
        return np.array(
            [
                (self.left, self.top),
                (self.right, self.top),
                (self.right, self.bottom),
                (self.left, self.bottom),
            ]
        )

    def holds(self, points: FloatArray) -> BoolArray:
        """(...,) whether points (..., 2) lie in it; not a number does not."""
        x, y = points[..., 0], points[..., 1]
        inside: BoolArray = (
            (x >= self.left) & (x <= self.right) & (y >= self.top) & (y <= self.bottom)
        )
        return inside


def field_rectangle(field: Field) -> GroundRectangle:
    """The field of play: its length and width about the centre.

    A field without these dimensions has the smallest rectangle along the axes that holds every
    element on the ground; optional ones, which may be anywhere, count where there are no others.

    Raises:
        UsageError: the field has neither the dimensions nor anything on the ground.
    """
    length, width = field.dimension("length"), field.dimension("width")
    if length is not None and width is not None:
        x, y = length.value / 2, width.value / 2
        return GroundRectangle(-x, -y, x, y)
    samples = sample_evenly(field, _CURVE_SPACING_M)
    rows = [i for i, element in enumerate(field.elements) if element.on_ground]
    needed = [i for i in rows if not field.elements[i].optional]
    ground = [samples.of(i)[:, :2] for i in needed or rows]
    if not ground:
        raise UsageError(f"the field {field.title} has no element on the ground to compare over")
    points = np.concatenate(ground)
    (left, top), (right, bottom) = points.min(axis=0), points.max(axis=0)
    return GroundRectangle(float(left), float(top), float(right), float(bottom))


def require_camera_model(camera: CameraOrProjections) -> Camera:
    """The camera itself; a source that has none, only shown elements, is refused.

    Raises:
        UsageError: the source shares only projections.
    """
    if isinstance(camera, ElementProjections):
        raise UsageError(
            "one of the sources shares only projections, there is no ground to compare;"
            " choose a source with a camera model"
        )
    return camera


def ground_points_seen(camera: CameraOrProjections, points_px: FloatArray) -> FloatArray:
    """The ground points (z = 0) that pixels show.

    Args:
        camera: any model.
        points_px: (N, 2) px.

    Returns:
        (N, 2) metres, NaN where a pixel shows no ground.

    Raises:
        UsageError: a source that shares only projections.
    """
    return ground_from_px(require_camera_model(camera), points_px)
