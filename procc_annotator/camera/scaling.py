"""A camera for another picture size, whatever its model."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol, cast

import numpy as np

from procc_annotator.camera.base import BoolArray, Camera, FloatArray
from procc_annotator.camera.projections import CameraOrProjections, ElementProjections

Size = tuple[int, int]


class _Scalable(Protocol):
    def scaled(self, from_size: Size, to_size: Size) -> CameraOrProjections: ...


def scaled_camera(camera: CameraOrProjections, from_size: Size, to_size: Size) -> CameraOrProjections:
    """The camera in pixels of another picture size.

    Args:
        camera: its own ``scaled`` is used where it has one.
        from_size: (width, height) its pixels belong to. to_size: those wanted.
    """
    if isinstance(camera, ElementProjections) or callable(getattr(camera, "scaled", None)):
        return cast(_Scalable, camera).scaled(from_size, to_size)
    factors = (to_size[0] - 1) / (from_size[0] - 1), (to_size[1] - 1) / (from_size[1] - 1)
    return ScaledCamera(camera, factors)


@dataclass(frozen=True, eq=False)
class ScaledCamera:
    """Another camera, its pixels multiplied: for models that cannot be scaled themselves."""

    camera: Camera
    factors: tuple[float, float]

    @property
    def ground_only(self) -> bool:
        """As the camera inside."""
        return bool(getattr(self.camera, "ground_only", False))

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """See `Camera.project`."""
        px, valid = self.camera.project(points_world)
        return px * np.array(self.factors), valid

    def scaled(self, from_size: Size, to_size: Size) -> ScaledCamera:
        """For yet another picture size."""
        sx = (to_size[0] - 1) / (from_size[0] - 1) * self.factors[0]
        sy = (to_size[1] - 1) / (from_size[1] - 1) * self.factors[1]
        return ScaledCamera(self.camera, (sx, sy))
