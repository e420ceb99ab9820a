"""What a camera has of the field in sight, and from which side: how the field map is turned."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.backproject import ground_from_px
from procc_annotator.camera.base import Camera, FloatArray
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.implied import pinhole_from_homography
from procc_annotator.field.model import Field
from procc_annotator.fit.predict.sight import visible_spots, visible_stretches
from procc_annotator.metric.contours import Polygon, filled_contours
from procc_annotator.metric.ground import GroundRectangle, field_rectangle

_BESIDE_PX = 10.0  # on either side of a place of the picture: which way right is there
_GRID = 60  # samples along each side of the field
_BEYOND = 0.06  # of the field: so far beyond its lines the map has ground, too
_ACROSS = 0.06  # of the field's length beyond the middle that still leaves the other half alone


@dataclass(frozen=True, eq=False)
class VisibleField:
    """What one camera sees of a field.

    Attributes:
        turns: quarter turns, clockwise as seen from above with the main camera at the bottom, that
            bring the side the camera stands on to the bottom: 0 for the main camera's side, 1 to 3.
        names: the elements that are in the picture, be it in part.
        ground: the ground that is in the picture, metres, as far as the field reaches.
        half: -1 or 1 where nothing is in sight of the half with larger or smaller x; else 0.
    """

    turns: int
    names: frozenset[str]
    ground: tuple[Polygon, ...]
    half: int


def visible_field(field: Field, camera: Camera, size: tuple[int, int]) -> VisibleField | None:
    """What a camera sees of a field; None if it sees nothing of it.

    Args:
        field: with elements on the ground.
        camera: in px of the picture.
        size: (width, height) of the picture, px.

    Raises:
        UsageError: the field has nothing on the ground.
    """
    stretches = visible_stretches(field, camera, size)
    names = {s.name for s in stretches} | set(visible_spots(field, camera, size))
    area = field_rectangle(field)
    turns = _turns(camera, size, area, [s.points_px for s in stretches])
    if not names or turns is None:
        return None
    ground = _ground_in_sight(area, camera, size)
    return VisibleField(turns, frozenset(names), ground, _half(ground, area))


def _turns(
    camera: Camera, size: tuple[int, int], area: GroundRectangle, seen_px: list[FloatArray]
) -> int | None:
    """By where the camera stands, which stays while it pans; over the field by what is right."""
    found = pinhole_from_homography(camera, size) if isinstance(camera, HomographyCamera) else camera
    position = getattr(found, "position_world", None)
    if position is not None and np.isfinite(position).all():
        x, y = (float(value) for value in position[:2])
        beyond_x = max(area.left - x, x - area.right)
        beyond_y = max(area.top - y, y - area.bottom)
        if max(beyond_x, beyond_y) > 0:
            if beyond_y >= beyond_x:
                return 0 if y > 0 else 2
            return 1 if x > 0 else 3
    return _turns_by_sight(camera, seen_px)


def _turns_by_sight(camera: Camera, seen_px: list[FloatArray]) -> int | None:
    if not seen_px:
        return None
    u, v = np.concatenate(seen_px).mean(axis=0)
    ground = ground_from_px(camera, np.array([(u - _BESIDE_PX, v), (u + _BESIDE_PX, v)]))
    right = ground[1] - ground[0]
    if not np.isfinite(right).all() or not right.any():
        return None
    return -round(math.atan2(right[1], right[0]) / (math.pi / 2)) % 4


def _ground_in_sight(area: GroundRectangle, camera: Camera, size: tuple[int, int]) -> tuple[Polygon, ...]:
    """The part of the field, and of a little around it, that lies inside the picture."""
    beyond = _BEYOND * max(area.right - area.left, area.bottom - area.top)
    x = np.linspace(area.left - beyond, area.right + beyond, _GRID)
    y = np.linspace(area.top - beyond, area.bottom + beyond, _GRID)
    places = np.stack([*np.meshgrid(x, y), np.zeros((_GRID, _GRID))], axis=-1)
    px, shown = camera.project(places.reshape(-1, 3))
    limits = np.array(size, dtype=np.float64) - 1
    inside = np.minimum(px, limits - px).min(axis=1)  # px from the picture's edge
    far = float(limits.max())
    inside = np.where(shown & np.isfinite(inside), inside, -far).clip(-far, far)
    bands = filled_contours(inside.reshape(_GRID, _GRID), x, y, (0.0, math.inf))
    return bands[0].polygons


def _half(ground: tuple[Polygon, ...], area: GroundRectangle) -> int:
    if not ground:
        return 0
    x = np.concatenate([outlines[0][:, 0] for outlines in ground])
    middle, across = (area.left + area.right) / 2, _ACROSS * (area.right - area.left)
    if x.min() > middle - across:
        return 1
    return -1 if x.max() < middle + across else 0
