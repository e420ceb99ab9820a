"""A camera's wireframe as something to take hold of: its places, and which is under the cursor."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.distinct_places import distinctive_points
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sample import sample_evenly
from procc_annotator.fit.predict.sight import VisibleStretch, visible_stretches
from procc_annotator.interact.hit import FloatArray, closest_on_segments
from procc_annotator.interact.verdicts import NO_POINTS

Vector = tuple[float, float, float]

_CHORD_M = 0.5


@dataclass(frozen=True, slots=True)
class WireframePoint:
    """A place of a wireframe.

    Attributes:
        name: the class it is on.
        world: metres.
        px: where the camera shows it.
        along: the direction of its line, metres; None for a place that can be told from all others
            on its line: an end, a corner, a crossing, a spot.
    """

    name: str
    world: Vector
    px: tuple[float, float]
    along: Vector | None


@dataclass(frozen=True, eq=False)
class Wireframe:
    """What a camera shows of a field.

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
        """The distinct place that is nearest, if one is within reach, else the nearest of a line.

        Args:
            position: px of the picture.
            reach_px: px of the picture.
        """
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
    """What a camera shows of a field in its picture.

    Args:
        camera: px of the picture.
        field: the elements.
        size: (width, height) px.
    """
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
    move of a mouse.

    Args: as for `wireframe_of`.
    """
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
