"""Paint on the ground: lines of their true width on their true side, and areas of colour.

Every pixel gets the share of it that paint covers, from its distance to the paint's middle and
from how much ground the pixel sees: edges lie where they are to a fraction of a pixel.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import (
    Arc,
    Circle,
    Geometry,
    Line,
    Part,
    Spot,
    Vector,
    ends_of,
    outline_of,
    parts_of,
)
from procc_annotator.field.model import Element

FloatArray = NDArray[np.float32]
Colour = tuple[float, float, float]  # BGR, 0 to 255

_JOINED_M = 1e-4
_NEAR_M = 1.0


@dataclass(frozen=True)
class Stroke:
    """A painted line.

    Attributes:
        geometry: what the rules measure.
        width_m: of the paint; of a spot its diameter.
        colour: of the paint.
        inside: a place on that side of the geometry on which the paint lies; None: to both sides.
    """

    geometry: Geometry
    width_m: float
    colour: Colour
    inside: Vector | None = None


@dataclass(frozen=True)
class Rectangle:
    """An area of colour: opposite corners, metres."""

    x: tuple[float, float]
    y: tuple[float, float]

    def depth(self, ground: FloatArray) -> FloatArray:
        """(H, W) metres inside its border; negative outside."""
        x, y = ground[..., 0], ground[..., 1]
        across = np.minimum(x - self.x[0], self.x[1] - x)
        return np.asarray(np.minimum(across, np.minimum(y - self.y[0], self.y[1] - y)))


@dataclass(frozen=True)
class Disc:
    """A round area of colour, or that part of it with x and y in a range, metres."""

    centre: tuple[float, float]
    radius: float
    x: tuple[float, float] = (-math.inf, math.inf)
    y: tuple[float, float] = (-math.inf, math.inf)

    def depth(self, ground: FloatArray) -> FloatArray:
        """(H, W) metres inside its border; negative outside."""
        away = np.hypot(ground[..., 0] - self.centre[0], ground[..., 1] - self.centre[1])
        within = Rectangle(self.x, self.y).depth(ground)
        return np.asarray(np.minimum(self.radius - away, within).astype(np.float32))


@dataclass(frozen=True)
class RoundedRectangle:
    """A rectangle around the centre with rounded corners: half its sides and the radius, metres."""

    half: tuple[float, float]
    radius: float

    def depth(self, ground: FloatArray) -> FloatArray:
        """(H, W) metres inside its border; negative outside."""
        x = np.abs(ground[..., 0]) - (self.half[0] - self.radius)
        y = np.abs(ground[..., 1]) - (self.half[1] - self.radius)
        beyond = np.hypot(np.maximum(x, 0), np.maximum(y, 0)) + np.minimum(np.maximum(x, y), 0)
        return np.asarray(self.radius - beyond)


@dataclass(frozen=True)
class Area:
    """An area, or all around it, and its colour; ``opacity`` below 1 lets the grain through."""

    shape: Rectangle | Disc | RoundedRectangle
    colour: Colour
    opacity: float = 1.0
    outside: bool = False


def strokes_of(elements: Iterable[Element], colours: dict[str, Colour]) -> list[Stroke]:
    """The paint of a field's elements on the ground, each in its own colour or that of "".

    Args:
        elements: those without a width are not painted.
        colours: colour by element name; "" for all others.
    """
    return [
        Stroke(e.geometry, e.line_width, colours.get(e.name, colours[""]), e.inside)
        for e in elements
        if e.on_ground and e.line_width > 0
    ]


def cover_with_areas(picture: FloatArray, ground: FloatArray, areas: Sequence[Area]) -> None:
    """Paint areas over a picture, one after the other.

    Args:
        picture: (H, W, 3) BGR, changed in place.
        ground: (H, W, 2) metres.
        areas: the first one lowest.
    """
    for area in areas:
        depth = area.shape.depth(ground) * (-1 if area.outside else 1)
        slope = np.hypot(np.gradient(depth, axis=0), np.gradient(depth, axis=1))
        share = np.clip(depth / np.maximum(slope, 1e-6) + 0.5, 0, 1)[..., None] * area.opacity
        picture *= 1 - share
        picture += share * np.array(area.colour, dtype=np.float32)


def cover_with_strokes(
    picture: FloatArray,
    ground: FloatArray,
    strokes: Sequence[Stroke],
    opacity: float,
    camera: PinholeCamera,
) -> None:
    """Paint lines over a picture; those of one colour that meet or cross are one coat.

    Args:
        picture: (H, W, 3) BGR, changed in place.
        ground: (H, W, 2) metres.
        strokes: later colours cover earlier ones.
        opacity: 0 to 1.
        camera: of the picture.
    """
    across, down = np.gradient(ground, axis=1), np.gradient(ground, axis=0)
    for colour in dict.fromkeys(s.colour for s in strokes):
        cover = np.zeros(ground.shape[:2], dtype=np.float32)
        for stroke in (s for s in strokes if s.colour == colour):
            for part, longer in _parts(stroke, strokes):
                box = _box(part, camera, cover.shape)
                views = (ground[box], across[box], down[box])
                cover[box] = np.maximum(cover[box], _share(stroke, part, longer, *views))
        paint = cover[..., None]
        picture[:] = picture * (1 - opacity * paint) + (
            np.array(colour, dtype=np.float32) * opacity * paint
        )


def _parts(stroke: Stroke, strokes: Sequence[Stroke]) -> Iterable[tuple[Part, tuple[float, float]]]:
    """A stroke's parts, each with how far its paint goes on beyond its ends to close a corner."""
    for part in parts_of(stroke.geometry):
        if not isinstance(part, Line):
            yield part, (0.0, 0.0)
            continue
        start, end = np.array(part.start), np.array(part.end)
        along = (end - start) / np.linalg.norm(end - start)
        others = [s for s in strokes if s is not stroke and isinstance(s.geometry, Line)]
        yield (
            part,
            (
                max((_beyond(o, start, -along) for o in others), default=0.0),
                max((_beyond(o, end, along) for o in others), default=0.0),
            ),
        )


def _beyond(other: Stroke, end: NDArray[np.float64], outwards: NDArray[np.float64]) -> float:
    """How far another line's paint that ends here lies beyond this end."""
    ends = ends_of(other.geometry)
    if ends is None or min(math.dist(e, end) for e in ends) > _JOINED_M or other.inside is None:
        return 0.0
    geometry = other.geometry
    assert isinstance(geometry, Line)
    normal, middle = _line_normal(geometry), _middle(other, geometry)
    reach = float(outwards[:2] @ normal) * 2 * middle
    return max(0.0, reach)


def _line_normal(line: Line) -> FloatArray:
    """(2,) to the same side of the way from start to end as that of `_outward_directions`."""
    (ax, ay), (bx, by) = line.start[:2], line.end[:2]
    along = np.hypot(bx - ax, by - ay)
    return np.array([(by - ay) / along, -(bx - ax) / along], dtype=np.float32)


def _outwards(part: Part) -> float:
    """1 where a curve's outer side is the one that lines call positive, else -1; 1 for lines."""
    if isinstance(part, Line | Spot):
        return 1.0
    return math.copysign(1, part.ahead[0] * part.aside[1] - part.ahead[1] * part.aside[0])


def _middle(stroke: Stroke, part: Part) -> float:
    """Where the paint's middle is, metres along a line's normal or outwards from a curve.

    The paint of a chain keeps to one side of it: that of its part nearest to ``inside``.
    """
    if stroke.inside is None or isinstance(part, Spot):
        return 0.0
    there = np.array(stroke.inside[:2])
    nearest = min(
        parts_of(stroke.geometry),
        key=lambda own: float(np.hypot(*(outline_of(own)[:, :2] - there).T).min()),
    )
    if isinstance(nearest, Line):
        side = float((there - nearest.start[:2]) @ _line_normal(nearest))
    else:
        assert isinstance(nearest, Arc | Circle)
        side = math.dist(there, nearest.centre[:2]) - nearest.radius
    return math.copysign(stroke.width_m / 2, side) * _outwards(nearest) * _outwards(part)


def _box(part: Part, camera: PinholeCamera, shape: tuple[int, int]) -> tuple[slice, slice]:
    """Rows and columns that may show a part: all where some of it is behind the camera."""
    outline = outline_of(part)
    if isinstance(part, Line):
        t = np.linspace(0, 1, 40)[:, None]
        outline = outline[0] * (1 - t) + outline[1] * t
    around = [np.array([dx, dy, 0.0]) for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
    about = np.concatenate([outline + step for step in around])
    px, in_front = camera.project(about)
    if not in_front.all() or (camera.is_distorted and np.abs(px).max() > 2 * max(shape)):
        return slice(None), slice(None)
    low = np.clip(np.floor(px.min(axis=0)) - 2, 0, None).astype(int)
    high = np.clip(np.ceil(px.max(axis=0)) + 3, 0, None).astype(int)
    return slice(low[1], high[1]), slice(low[0], high[0])


def _share(
    stroke: Stroke,
    part: Part,
    longer: tuple[float, float],
    ground: FloatArray,
    across: FloatArray,
    down: FloatArray,
) -> FloatArray:
    """(H, W) share of each pixel covered by a part's paint."""
    if isinstance(part, Spot):
        away = np.hypot(ground[..., 0] - part.position[0], ground[..., 1] - part.position[1])
        return np.asarray(np.clip((stroke.width_m / 2 - away) * 12, 0, 1), dtype=np.float32)
    share = np.zeros(ground.shape[:2], dtype=np.float32)
    near, distance, normal = _near(ground, part, _middle(stroke, part), longer)
    per_pixel = np.hypot((across[near] * normal).sum(axis=-1), (down[near] * normal).sum(axis=-1))
    covered = (stroke.width_m / 2 - distance) / np.maximum(per_pixel, 1e-5) + 0.5
    share[near] = np.where(distance < _NEAR_M, np.clip(covered, 0, 1), 0)
    return share


def _near(
    ground: FloatArray, part: Line | Arc | Circle, middle: float, longer: tuple[float, float]
) -> tuple[NDArray[np.bool_], FloatArray, FloatArray]:
    """(H, W) which pixels may show ground near the middle of a part's paint: few; of these the
    metres to it, (N,), and the direction across, (2,) or (N, 2)."""
    x, y = ground[..., 0], ground[..., 1]
    if isinstance(part, Line):
        ax, ay = part.start[:2]
        bx, by = part.end[:2]
        along = np.hypot(bx - ax, by - ay)
        ux, uy = (bx - ax) / along, (by - ay) / along
        aside = (x - ax) * uy - (y - ay) * ux - middle
        near = np.abs(aside) < _NEAR_M
        t = (x[near] - ax) * ux + (y[near] - ay) * uy
        beyond = np.maximum(np.maximum(-t - longer[0], t - along - longer[1]), 0)
        return near, np.hypot(aside[near], beyond), _line_normal(part)
    offset = ground - np.array(part.centre[:2], dtype=np.float32)
    away = np.maximum(np.hypot(offset[..., 0], offset[..., 1]), 1e-3)
    distance = np.abs(away - (part.radius + middle))
    near = distance < _NEAR_M
    offset, away, distance = offset[near], away[near], distance[near]
    if not isinstance(part, Circle):
        middle_rad = (part.start_rad + part.end_rad) / 2
        half = (part.end_rad - part.start_rad) / 2
        axis = np.cos(middle_rad) * np.array(part.ahead) + np.sin(middle_rad) * np.array(part.aside)
        distance[(offset @ axis[:2].astype(np.float32)) / away < np.cos(half)] = 10.0
    return near, distance, offset / away[..., None]
