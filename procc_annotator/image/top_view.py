"""Pictures laid on the ground: the field as seen from above."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.base import Camera
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.ground_plane import field_rectangle

MARGIN_M = 5.0  # of ground around the field
_COARSE = 4  # px of the top view between two projected points; between them it is interpolated
_NOT_SEEN = 256  # above every value of a pixel


@dataclass(frozen=True, slots=True)
class GroundRaster:
    """Pixels of a top view on the ground: x to the right, y down, towards the main camera.

    Attributes:
        left, top: metres, the outer edge of the first pixel.
        size: (width, height) px.
        px_per_m: resolution.
    """

    left: float
    top: float
    size: tuple[int, int]
    px_per_m: float

    @classmethod
    def of(cls, field: Field, px_per_m: float, margin_m: float = MARGIN_M) -> GroundRaster:
        """The field with some ground around it. `UsageError` if the field has nothing on the
        ground."""
        area = field_rectangle(field)
        extents = (area.right - area.left, area.bottom - area.top)
        width, height = (max(1, round((e + 2 * margin_m) * px_per_m)) for e in extents)
        return cls(area.left - margin_m, area.top - margin_m, (width, height), px_per_m)

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """Left, right, bottom, top edge in metres, in matplotlib's order."""
        width, height = self.size
        right, bottom = self.left + width / self.px_per_m, self.top + height / self.px_per_m
        return self.left, right, bottom, self.top

    def points(self, xs: FloatArray, ys: FloatArray) -> FloatArray:
        """(len(ys), len(xs), 3) metres, world frame, of pixel coordinates."""
        ground = np.zeros((len(ys), len(xs), 3))
        ground[..., 0] = self.left + (xs + 0.5) / self.px_per_m
        ground[..., 1] = self.top + (ys[:, None] + 0.5) / self.px_per_m
        return ground


def picture_on_ground(
    pixels: PixelArray, camera: Camera, size: tuple[int, int], raster: GroundRaster
) -> tuple[PixelArray, BoolArray]:
    """Resample a picture as seen from above.

    Args:
        pixels: (H, W, 4) BGRA.
        camera: in px of ``size``.

    Returns:
        (h, w, 3) BGR, black where the picture does not show the ground, and (h, w) where it does.
        Between projected points, a few px of the result apart, the map is linear.
    """
    height, width = pixels.shape[:2]
    columns, rows = (np.arange(-_COARSE / 2, e + _COARSE, _COARSE) + _COARSE / 2 - 0.5
                     for e in raster.size)  # fmt: skip
    shown, valid = camera.project(raster.points(columns, rows).reshape(-1, 3))
    # Centres of first and last pixels agree at every size.
    scale = (np.array((width, height)) - 1) / (np.array(size) - 1)
    at = np.where(valid[:, None], shown * scale, -1e6).reshape(len(rows), len(columns), 2)
    fine = _upsampled(at, raster.size)
    u, v = fine[..., 0], fine[..., 1]
    inside = (u >= 0) & (u <= width - 1) & (v >= 0) & (v <= height - 1)
    result = cv2.remap(pixels[:, :, :3], u, v, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT)
    result[~inside] = 0
    return np.asarray(result, np.uint8), inside


def _upsampled(coarse: FloatArray, size: tuple[int, int]) -> NDArray[np.float32]:
    """(h, w, 2) of samples at px -0.5, 3.5, 7.5 ..., linear in between."""
    fine = cv2.resize(coarse.astype(np.float32), None, fx=_COARSE, fy=_COARSE)
    return np.asarray(fine, np.float32)[_COARSE // 2 :, _COARSE // 2 :][: size[1], : size[0]]


def panorama(views: Sequence[tuple[PixelArray, BoolArray]]) -> PixelArray:
    """The median of several top views of one scene, per pixel and channel: what moves disappears.

    Args:
        views: at least one; of `picture_on_ground`.

    Returns:
        (h, w, 3) BGR; black where no view shows the ground. Of an even number of views the lower
        of the two middle values counts.
    """
    count = np.sum([seen for _, seen in views], axis=0)
    shown = [np.where(seen[..., None], view.astype(np.int16), _NOT_SEEN) for view, seen in views]
    stack = np.sort(np.stack(shown), axis=0)
    middle = np.maximum(count - 1, 0) // 2
    found = np.take_along_axis(stack, middle[None, ..., None], axis=0)[0]
    return np.where(count[..., None] > 0, found, 0).astype(np.uint8)
