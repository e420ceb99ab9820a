"""Visible part of the field under a camera, its wireframe for picking, and the looks of maps in
metres."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.prediction.uncertainty import ACCURACY_LEVELS_M
from procc_annotator.calibration.prediction.visible_elements import (
    VisibleStretch,
    visible_spots,
    visible_stretches,
)
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import Camera
from procc_annotator.camera.matrices import pinhole_from_homography
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sampling import distinctive_points, sample_evenly
from procc_annotator.interaction import palette
from procc_annotator.interaction.gestures import closest_on_segments
from procc_annotator.interaction.overlay_primitives import NO_POINTS
from procc_annotator.metrics.error_maps import (
    DISAGREEMENT_LEVELS_M,
    OFFSIDE_ACCURACY_M,
    Polygon,
    filled_contours,
)
from procc_annotator.metrics.ground_plane import GroundRectangle, field_rectangle
from procc_annotator.translation import word


@dataclass(frozen=True, slots=True)
class LevelLine:
    """The line of one level; ``dash``: lengths on and off, points; () for a solid line."""

    metres: float
    dash: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class MapStyle:
    """One kind of map.

    Attributes:
        name: what people call it, for `tr`.
        levels_m: ascending; a band lies between each two.
        colours: a tone a band.
        opacity: of the bands, 0 to 1.
        lines: the levels that are drawn as lines, distinguished by their dashes.
    """

    name: str
    levels_m: tuple[float, ...]
    colours: tuple[str, ...]
    opacity: float
    lines: tuple[LevelLine, ...]


DISAGREEMENT = MapStyle(
    word("Disagreement"),
    DISAGREEMENT_LEVELS_M,
    palette.DISAGREEMENT_COLOURS,
    palette.DISAGREEMENT_OPACITY,
    (LevelLine(OFFSIDE_ACCURACY_M, palette.LIMIT_DASH),),
)
UNCERTAINTY = MapStyle(
    word("Uncertainty"),
    (0.0, *ACCURACY_LEVELS_M, math.inf),
    palette.UNCERTAINTY_COLOURS,
    palette.UNCERTAINTY_OPACITY,
    tuple(
        LevelLine(metres, dash)
        for metres, dash in zip(ACCURACY_LEVELS_M, palette.UNCERTAINTY_DASHES, strict=True)
    ),
)


_BESIDE_PX = 10.0  # on either side of a place of the picture: which way right is there
_GRID = 60  # samples along each side of the field
_BEYOND = 0.06  # of the field: so far beyond its lines the map has ground, too


@dataclass(frozen=True, eq=False)
class VisibleField:
    """The visible part of a field under one camera.

    Attributes:
        turns: quarter turns, clockwise as seen from above with the main camera at the bottom, that
            bring the side the camera stands on to the bottom: 0 for the main camera's side, 1 to 3.
        names: the elements that are in the picture, whether in part.
        ground: the ground that is in the picture, metres, as far as the field reaches.
    """

    turns: int
    names: frozenset[str]
    ground: tuple[Polygon, ...]


def visible_field(field: Field, camera: Camera, size: tuple[int, int]) -> VisibleField | None:
    """Return what a camera, in px of a picture of this (width, height), sees of a field; None if it
    sees nothing of it. `UsageError` if the field has nothing on the ground."""
    stretches = visible_stretches(field, camera, size)
    names = {s.name for s in stretches} | set(visible_spots(field, camera, size))
    area = field_rectangle(field)
    turns = _turns(camera, size, area, [s.points_px for s in stretches])
    if not names or turns is None:
        return None
    return VisibleField(turns, frozenset(names), _ground_in_sight(area, camera, size))


def _turns(
    camera: Camera, size: tuple[int, int], area: GroundRectangle, seen_px: list[FloatArray]
) -> int | None:
    """By where the camera stands, which stays while it pans; over the field by what is right."""
    found = (
        pinhole_from_homography(camera, size) if isinstance(camera, HomographyCamera) else camera
    )
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


def _ground_in_sight(
    area: GroundRectangle, camera: Camera, size: tuple[int, int]
) -> tuple[Polygon, ...]:
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


Vector = tuple[float, float, float]

_CHORD_M = 0.5


@dataclass(frozen=True, slots=True)
class WireframePoint:
    """A place of a wireframe.

    Attributes:
        world: metres.
        px: where the camera shows it.
        along: the direction of its line, metres; None for a place that can be distinguished from
            all others on its line: an end, a corner, a crossing, a spot.
    """

    name: str
    world: Vector
    px: tuple[float, float]
    along: Vector | None


@dataclass(frozen=True, eq=False)
class Wireframe:
    """The lines and places of a field in a camera's picture.

    Attributes:
        camera: px of the picture.
        stretches: of its lines, in the picture.
        names: the classes of n distinct places in the picture.
        places: (n, 3) metres.
        px: (n, 2) px.
    """

    camera: PinholeCamera
    stretches: tuple[VisibleStretch, ...]
    names: tuple[str, ...]
    places: FloatArray
    px: FloatArray

    def at(self, position: tuple[float, float], reach_px: float) -> WireframePoint | None:
        """The distinct place that is nearest, if one is within reach, else the nearest of a line;
        px of the picture."""
        if len(self.px):
            away = np.hypot(*(self.px - position).T)
            best = int(away.argmin())
            if away[best] <= reach_px:
                x, y = self.px[best].tolist()
                return WireframePoint(self.names[best], _vector(self.places[best]), (x, y), None)
        return self._on_line(position, reach_px)

    def _on_line(self, position: tuple[float, float], reach_px: float) -> WireframePoint | None:
        nearest, found = reach_px, None
        for stretch in self.stretches:
            course = stretch.points_px
            feet = closest_on_segments(course[:-1], course[1:], np.array(position))
            away = np.hypot(*(feet - position).T)
            row = int(away.argmin())
            if away[row] <= nearest:
                nearest, found = float(away[row]), (stretch, row, feet[row])
        if found is None:
            return None
        stretch, row, foot = found
        before, after = stretch.points_world[row], stretch.points_world[row + 1]
        begin, end = stretch.points_px[row], stretch.points_px[row + 1]
        share = float(np.hypot(*(foot - begin)) / max(np.hypot(*(end - begin)), 1e-9))
        world = before + share * (after - before)
        along = (after - before) / max(float(np.linalg.norm(after - before)), 1e-12)
        x, y = self.camera.project(world[None])[0][0].tolist()
        return WireframePoint(stretch.name, _vector(world), (x, y), _vector(along))


def wireframe_of(camera: PinholeCamera, field: Field, size: tuple[int, int]) -> Wireframe:
    """Return what a camera shows of a field in its picture, (width, height) px."""
    names, places = distinctive_points(field.elements)
    px, inside = NO_POINTS, np.zeros(len(places), dtype=bool)
    if len(places):
        px, shown = camera.project(places)
        inside = shown & ((px >= 0) & (px <= np.array(size) - 1.0)).all(axis=1)
    rows = np.flatnonzero(inside)
    return Wireframe(
        camera,
        visible_stretches(field, camera, size),
        tuple(names[row] for row in rows.tolist()),
        places[rows],
        px[rows],
    )


def segments_in_sight(camera: PinholeCamera, field: Field, size: tuple[int, int]) -> FloatArray:
    """(N, 4) px: what of a field's lines is at least partly in the picture; cheap enough for every
    move of a mouse."""
    world, follows = _chords(field.elements)
    px, shown = camera.project(world)
    inside = shown & ((px >= 0) & (px <= np.array(size) - 1.0)).all(axis=1)
    drawn = follows & shown[:-1] & shown[1:] & (inside[:-1] | inside[1:])
    rows = np.flatnonzero(drawn)
    return np.concatenate((px[rows], px[rows + 1]), axis=1)


@lru_cache(maxsize=16)
def _chords(elements: tuple[Element, ...]) -> tuple[FloatArray, NDArray[np.bool_]]:
    """(n, 3) metres along all elements, and (n - 1,) whether a place follows the one before it."""
    samples = sample_evenly(Field("", "", (), elements), _CHORD_M)
    follows = np.ones(max(len(samples.points_world) - 1, 0), dtype=bool)
    follows[samples.offsets[1:-1] - 1] = False
    return samples.points_world, follows


def _vector(place: FloatArray) -> Vector:
    x, y, z = place.tolist()
    return x, y, z
