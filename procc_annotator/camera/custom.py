"""Cameras supplied by callers: wrap them and validate what they return."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.camera.backprojection import ground_by_search
from procc_annotator.camera.base import (
    Camera,
    CameraOrProjections,
    ElementProjections,
    ScaledCamera,
    Size,
    scaled_camera,
)
from procc_annotator.camera.models import (
    FisheyeCamera,
    HomographyCamera,
    MatrixCamera,
    PinholeCamera,
    as_pixels,
)
from procc_annotator.errors import UsageError

_OWN_CAMERA_TYPES = (
    PinholeCamera, FisheyeCamera, HomographyCamera, MatrixCamera, ElementProjections,
)  # fmt: skip


def validated_camera(camera: CameraOrProjections, name: str = "camera") -> CameraOrProjections:
    """The same camera, where it is not one of this program's with its answers checked; errors call
    it ``name``."""
    if isinstance(camera, ScaledCamera):
        inner = validated_camera(camera.camera, name)
        assert not isinstance(inner, ElementProjections)  # those are no camera
        return replace(camera, camera=inner)
    if isinstance(camera, (*_OWN_CAMERA_TYPES, ValidatedCamera)):
        return camera
    return ValidatedCamera(camera, name)


@dataclass(frozen=True, eq=False)
class ValidatedCamera:
    """A camera of others. What it offers besides `project` is its own."""

    camera: Camera
    name: str = "camera"

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """See `Camera.project`; `UsageError` if what the camera returns is no projection of the
        points."""
        return self._asked(self.camera.project, points_world)

    def ground_from_px(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px -> (N, 2) metres on the ground within 300 m of the field's centre, by the
        camera's own way back or by a numerical search; NaN for pixels that do not show it."""
        if callable(own := getattr(self.camera, "ground_from_px", None)):
            return np.asarray(own(as_pixels(points_px)), np.float64)
        return ground_by_search(self, as_pixels(points_px))

    def scaled(self, from_size: Size, to_size: Size) -> CameraOrProjections:
        """The same camera for another picture size."""
        return validated_camera(scaled_camera(self.camera, from_size, to_size), self.name)

    def __getattr__(self, attribute: str) -> Any:
        if attribute == "camera" or attribute.startswith("__"):
            raise AttributeError(attribute)  # while it is made anew in another process
        found = getattr(self.camera, attribute)
        return partial(self._asked, found) if attribute == "project_float32" else found

    def _asked(
        self, project: Callable[[FloatArray], object], points_world: FloatArray
    ) -> tuple[FloatArray, BoolArray]:
        return _validated_projection(project(points_world), points_world, self.name)


@dataclass(frozen=True, eq=False)
class FunctionCamera:
    """A camera that is a function.

    Attributes:
        function: takes (N, 3) metres, world frame; returns (N, 2) px, NaN for points without a
            projection; or those and (N,) bool, whether a point has one.
        ground_only: whether it knows the plane z = 0 only.
    """

    function: Callable[[FloatArray], object]
    ground_only: bool = False
    model: str = "function"

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        """See `Camera.project`."""
        given: Any = self.function(points_world)
        if isinstance(given, tuple) and len(given) == 2:
            return given[0], given[1]
        points = _validated_pixels(given, len(points_world), "the function")
        return points, np.asarray(np.isfinite(points).all(axis=1))


def _validated_projection(
    given: Any, points_world: FloatArray, name: str
) -> tuple[FloatArray, BoolArray]:
    if not isinstance(given, tuple) or len(given) != 2:
        raise UsageError(
            f"{name}: `project` must return the pixels and which of them are valid, found"
            f" {_type_name(given)}"
        )
    count = len(points_world)
    points = _validated_pixels(given[0], count, f"{name}: `project`")
    valid = np.asarray(given[1])
    if valid.dtype != np.bool_ or valid.shape != (count,):
        raise UsageError(
            f"{name}: `project` must return which points are valid as ({count},) bool, found"
            f" {_type_name(valid)}"
        )
    wrong = np.flatnonzero(valid & ~np.isfinite(points).all(axis=1))
    if len(wrong):
        where = ", ".join(f"{v:g}" for v in points_world[wrong[0]])
        raise UsageError(
            f"{name}: {len(wrong)} of {count} points are said to be valid, but their pixels are not"
            f" finite: ({where}) m is shown at {points[wrong[0]].tolist()}"
        )
    return points, valid


def _validated_pixels(given: Any, count: int, who: str) -> FloatArray:
    try:
        points = np.asarray(given)
    except ValueError:  # lists of several lengths
        points = np.empty(0)
    if points.dtype.kind not in "fiu" or points.shape != (count, 2):
        raise UsageError(
            f"{who} must return the pixels of {count} points as ({count}, 2) numbers, found"
            f" {_type_name(given)}"
        )
    return points.astype(np.float64, copy=False)


def _type_name(value: object) -> str:
    if isinstance(value, np.ndarray):
        return f"{value.shape} {value.dtype}"
    return "nothing" if value is None else type(value).__name__
