"""The camera protocol, projections without a camera, and rescaling to another image size."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Protocol, cast, runtime_checkable

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.models import size_factors


@runtime_checkable
class Camera(Protocol):
    """Anything that projects world points; plug in a model by writing this one method.

    What a model may offer besides, and what is done where it does not:

    - ``scaled(from_size, to_size)``: the same camera for another picture size; else its pixels are
      scaled (`camera.base`).
    - ``ground_from_px(points_px)``: the way back to the ground; else it is found numerically
      (`camera.backprojection`).
    - ``ground_only = True``: it knows the plane z = 0 only.
    - ``model``: what people call it.
    """

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """Project world points to the picture.

        Args:
            points_world: (N, 3) metres, world frame (z down).

        Returns:
            (N, 2) float64 px, origin at the centre of the top left pixel, and (N,) bool: whether
            the point has a projection (in front of the camera, inside the model's domain). Pixels
            of points without a projection are meaningless.
        """
        ...


def projects_only_ground(camera: object) -> bool:
    """Return whether a model knows the plane z = 0 only, as a homography (``ground_only = True``);
    False for None."""
    return bool(getattr(camera, "ground_only", False))


_BORDER_TOLERANCE_PX = 1e-4  # files round shares


@dataclass(frozen=True, eq=False)
class ElementProjections:
    """Projected polylines of the elements a source shows.

    The protocols ask a camera for nothing but these, so a method that cannot share its model can
    be judged by them. There is no ``project``: what needs points in space is not possible.

    Attributes:
        pieces: class name -> its pieces, each (n, 2) px, vertices in order along the element.
        samples: class name -> (n, 2) px of the points that the official evaluation projects, NaN
            without a projection; None where only the pieces are known.
        ground_only: whether the camera knows the plane z = 0 only.
        field_sha256: fingerprint of the field that was projected; empty where it is not known.
    """

    pieces: Mapping[str, tuple[FloatArray, ...]] = field(repr=False)
    samples: Mapping[str, FloatArray] | None = field(default=None, repr=False)
    ground_only: bool = False
    field_sha256: str = ""

    def is_clipped(self, size: tuple[int, int]) -> bool:
        """Return whether pieces end at the border of a picture of (width, height) px and none goes
        on beyond it: a person cut them to the picture.

        What a camera shows ends there by chance only. Programs cut at the centres of the last
        pixels, or, as the official evaluation does, at width and height.
        """
        if self.samples is not None:
            return False
        pieces = [px for parts in self.pieces.values() for px in parts if len(px)]
        if not pieces:
            return False
        every, ends = np.concatenate(pieces), np.concatenate([px[[0, -1]] for px in pieces])
        border = np.array([[0.0, 0.0], np.subtract(size, 1), size])[:, None]
        within = (
            (every >= -_BORDER_TOLERANCE_PX) & (every <= np.add(size, _BORDER_TOLERANCE_PX))
        ).all()
        return bool(within and (np.abs(ends - border) <= _BORDER_TOLERANCE_PX).any())

    def scaled(self, from_size: tuple[int, int], to_size: tuple[int, int]) -> ElementProjections:
        """The same for another picture size; see `size_factors`."""
        factors = np.array(size_factors(from_size, to_size))
        pieces = {name: tuple(p * factors for p in parts) for name, parts in self.pieces.items()}
        samples = self.samples and {name: px * factors for name, px in self.samples.items()}
        return replace(self, pieces=pieces, samples=samples)


CameraOrProjections = Camera | ElementProjections


Size = tuple[int, int]


class _Scalable(Protocol):
    def scaled(self, from_size: Size, to_size: Size) -> CameraOrProjections: ...


def scaled_camera(
    camera: CameraOrProjections, from_size: Size, to_size: Size
) -> CameraOrProjections:
    """The camera in pixels of another picture (width, height); its own ``scaled`` is used where it
    has one."""
    if isinstance(camera, ElementProjections) or callable(getattr(camera, "scaled", None)):
        return cast(_Scalable, camera).scaled(from_size, to_size)
    return ScaledCamera(camera, size_factors(from_size, to_size))


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
        sx, sy = size_factors(from_size, to_size)
        return ScaledCamera(self.camera, (sx * self.factors[0], sy * self.factors[1]))
