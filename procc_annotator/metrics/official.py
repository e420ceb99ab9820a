"""Projection of the official SoccerNet evaluation, quirks included, and fold-back of lenses."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Protocol, cast

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.camera.base import (
    CameraOrProjections,
    ElementProjections,
    projects_only_ground,
)
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.messages import pluralize
from procc_annotator.metrics.polylines import Polylines
from procc_annotator.metrics.setup import FieldTables


class _Float32Camera(Protocol):
    def project_float32(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]: ...


def official_polylines(
    cameras: Sequence[CameraOrProjections], tables: FieldTables, size: tuple[int, int]
) -> Polylines:
    """Project the official samples and keep what the official evaluation calls visible.

    Args:
        cameras: at least one; projections have these samples; ``project_float32`` is used of
            cameras that have one (the official code rounds so).
        tables: the field's official samples; there are none of optional elements.
        size: (width, height) px; inside means 0 <= x < width and 0 <= y < height.

    Returns:
        One piece an element, px, also across gaps; what the cameras show one after the other, as
        `Polylines.joined` has it.
    """
    shown = [project_samples(camera, tables) for camera in cameras]
    elements = len(tables.names)
    first_row = np.repeat(np.arange(len(shown)) * elements, len(tables.element_of_sample))
    return visible_polylines(
        np.concatenate([points_px for points_px, _ in shown]),
        np.concatenate([valid for _, valid in shown]),
        np.tile(tables.element_of_sample, len(shown)) + first_row,
        size,
        element_count=elements * len(shown),
    )


def project_samples(
    camera: CameraOrProjections, tables: FieldTables
) -> tuple[FloatArray, BoolArray]:
    """(N, 2) px of the official samples and (N,) which of them have a projection."""
    points = tables.points_world
    if isinstance(camera, ElementProjections):
        counts = np.bincount(tables.element_of_sample, minlength=len(tables.names)).tolist()
        of_names = zip(tables.names, counts, strict=True)
        known = camera.samples or {}
        parts = [known.get(n, np.full((count, 2), np.nan)) for n, count in of_names]
        points_px = np.concatenate(parts)
        found: BoolArray = np.asarray(np.isfinite(points_px).all(axis=1))
        return points_px, found
    if hasattr(camera, "project_float32"):
        points_px, valid = cast(_Float32Camera, camera).project_float32(points)
    else:
        points_px, valid = camera.project(points)
    if projects_only_ground(camera):
        valid = valid & tables.on_ground[tables.element_of_sample]
    return points_px, valid


def visible_polylines(
    points_px: FloatArray,
    valid: BoolArray,
    element: IntArray,
    size: tuple[int, int],
    *,
    element_count: int,
) -> Polylines:
    """The official walk along projected samples, for all elements at once.

    Args:
        points_px: (N, 2) px of the samples, element by element.
        valid: (N,) whether a sample is in front of the camera; others are as if absent.
        element: (N,) row of each sample's element, ascending.
        size: (width, height) px.

    Returns:
        One piece an element, px; NaN distances for segments without length.
    """
    if not valid.all():
        points_px, element = points_px[valid], element[valid]
    x, y = points_px.T.copy()
    inside = _inside_image(x, y, size)
    crossing = np.flatnonzero(inside[1:] != inside[:-1]) + 1
    crossing = crossing[element[crossing] == element[crossing - 1]]
    border, found = _border_points(
        points_px.take(crossing - 1, axis=0), points_px.take(crossing, axis=0), size
    )
    crossing, border = crossing[found], border[found]
    # A border point stands before the samples inside that follow it, whether entering or leaving.
    kept = np.flatnonzero(inside)
    place = np.searchsorted(kept, crossing) + np.arange(len(crossing))
    total = len(kept) + len(crossing)
    source = np.ones(total, dtype=np.intp)
    source[place] = 0
    np.cumsum(source, out=source)
    source -= 1
    source[place] = np.arange(len(kept), total)
    vertices = np.concatenate((points_px.take(kept, axis=0), border)).take(source, axis=0)
    owner = element.take(np.concatenate((kept, crossing)).take(source))
    is_end = np.ones(total, dtype=bool)
    is_end[:-1] = owner[1:] != owner[:-1]
    return Polylines(vertices, owner, is_end, element_count, nan_if_zero_length=True)


def _inside_image(
    x: NDArray[np.float64], y: NDArray[np.float64], size: tuple[int, int]
) -> NDArray[np.bool_]:
    return (x >= 0) & (x < size[0]) & (y >= 0) & (y < size[1])


def _border_points(
    previous: FloatArray, current: FloatArray, size: tuple[int, int]
) -> tuple[FloatArray, BoolArray]:
    """Return where the infinite line through two samples (K, 2), px, meets the border x = 0,
    x = width - 1, y = 0, y = height - 1, nearest to the second: (K, 2) px, the coordinate on the
    border exact, and (K,) whether there is such a point."""
    sides = np.array([[0.0, size[0] - 1.0], [0.0, size[1] - 1.0]])
    along = current - previous
    # From the sample inside on: one almost in the camera's plane is so far off that its last digit
    # is pixels.
    far = np.abs(current).max(axis=1) > np.abs(previous).max(axis=1)
    start = np.where(far[:, None], previous, current)
    x, y = start[:, :1], start[:, 1:]
    candidates = np.empty((len(current), 4, 2))
    candidates[:, :2, 0] = sides[0]
    candidates[:, 2:, 1] = sides[1]
    # A parallel side, or a sample at infinity, gives inf or NaN: not inside, hence no point.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        candidates[:, :2, 1] = y + (sides[0] - x) * (along[:, 1:] / along[:, :1])
        candidates[:, 2:, 0] = x + (sides[1] - y) * (along[:, :1] / along[:, 1:])
        usable = _inside_image(candidates[..., 0], candidates[..., 1], size)
        usable &= np.isfinite(along[:, :1]) & np.isfinite(along[:, 1:])
        offset = candidates - current[:, None, :]
        distance2 = np.where(usable, np.einsum("ksc,ksc->ks", offset, offset), np.inf)
    rows = np.arange(len(current))
    nearest = np.argmin(distance2, axis=1)
    found: BoolArray = usable[rows, nearest]
    return candidates[rows, nearest], found


_MAX_NAMED = 5


@cache
def soccernet_tables() -> FieldTables:
    """The field that the official evaluation knows."""
    return FieldTables.of(load_field())


def folds_into_image(
    camera: CameraOrProjections, tables: FieldTables, size: tuple[int, int]
) -> bool:
    """Return whether the official evaluation would show field points in the picture that a lens
    folds back into it: they lie beyond `PinholeCamera.fold_radius`, and no lens shows them there.
    Only pinholes fold."""
    if not isinstance(camera, PinholeCamera) or camera.fold_radius == np.inf:
        return False
    points_px, in_front = camera.project_float32(tables.points_world)
    _, shown = camera.project(tables.points_world)
    folded = points_px[in_front & ~shown]
    return bool(((folded >= 0) & (folded < np.array(size))).all(axis=1).any())


def fold_back_warnings(frames: Sequence[str]) -> tuple[str, ...]:
    """One line for all frames whose cameras do so; nothing without any."""
    if not frames:
        return ()
    shown = ", ".join(frames[:_MAX_NAMED]) + (", ..." if len(frames) > _MAX_NAMED else "")
    cameras = pluralize(len(frames), "camera folds", "cameras fold")
    return (
        f"{cameras} lines from far outside back into the picture in the official evaluation, which"
        f" does not know of folds; they may count as false positives there: {shown}",
    )
