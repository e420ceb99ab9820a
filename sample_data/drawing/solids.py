"""What stands on the ground or hangs above it, from bars, threads and sheets; farthest first."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.models import PinholeCamera

FloatArray = NDArray[np.float64]
PixelArray = NDArray[np.uint8]
Colour = tuple[int, int, int]  # BGR
Place = Sequence[float]

WHITE = (243, 244, 243)
_SHIFT = 4
_BAR_PIECES = 25


@dataclass(frozen=True)
class Thing:
    """Something to draw, and where it stands: (x, y) metres."""

    at: tuple[float, float]
    draw: Callable[[PixelArray, PinholeCamera], None]


def draw_things(picture: PixelArray, camera: PinholeCamera, things: Iterable[Thing]) -> None:
    """Paint things into a picture, the farthest first.

    Args:
        picture: (H, W, 3) BGR, changed in place.
        camera: in pixels of ``picture``.
        things: in any order.
    """
    x, y, _ = camera.position_world
    for thing in sorted(things, key=lambda t: -float(np.hypot(t.at[0] - x, t.at[1] - y))):
        thing.draw(picture, camera)


def draw_thread(
    picture: PixelArray, camera: PinholeCamera, points: Sequence[Place], colour: Colour
) -> None:
    """A line one pixel wide through places: a thread of a net."""
    px, in_front = camera.project(np.array(points, dtype=np.float64))
    if in_front.all() and near_picture(px, picture):
        cv2.polylines(picture, [_fixed(px)], False, colour, 1, cv2.LINE_AA, _SHIFT)


def draw_bar(
    picture: PixelArray,
    camera: PinholeCamera,
    points: Sequence[Place],
    width_m: float,
    colour: Colour = WHITE,
) -> None:
    """A round bar of true width, its middle exactly on the line through some places.

    Args:
        picture: (H, W, 3) BGR, changed in place.
        camera: in pixels of ``picture``.
        points: metres; two of a straight bar, many of a bent one.
        width_m: its diameter.
        colour: of all of it.
    """
    places = np.array(points, dtype=np.float64)
    if len(places) == 2:
        t = np.linspace(0, 1, _BAR_PIECES)[:, None]
        places = places[0] * (1 - t) + places[1] * t
    px, in_front = camera.project(places)
    if not in_front.all() or not near_picture(px, picture):
        return
    distance = np.linalg.norm(places - camera.position_world, axis=1)
    half = np.maximum(width_m * camera.focal_px[0] / distance / 2, 0.8)[:, None]
    closed = np.allclose(places[0], places[-1])
    along = _gradient(px, closed=closed)
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    across = along[:, ::-1] * (1, -1) * half
    if closed:  # a ring: what lies within stays free
        cv2.fillPoly(
            picture, [_fixed(px + across), _fixed(px - across)], colour, cv2.LINE_AA, _SHIFT
        )
        return
    outline = np.concatenate([px + across, (px - across)[::-1]])
    cv2.fillPoly(picture, [_fixed(outline)], colour, cv2.LINE_AA, _SHIFT)


def _gradient(px: FloatArray, *, closed: bool) -> FloatArray:
    if not closed:
        return np.asarray(np.gradient(px, axis=0))
    around = np.concatenate([px[-2:-1], px, px[1:2]])
    return np.asarray(np.gradient(around, axis=0)[1:-1])


def draw_sheet(
    picture: PixelArray,
    camera: PinholeCamera,
    corners: Sequence[Place],
    colour: Colour,
    opacity: float = 1.0,
) -> None:
    """A flat sheet between corners, metres; with its sides bent as the lens bends them."""
    places = np.array(corners, dtype=np.float64)
    t = np.linspace(0, 1, 8)[:-1, None]
    pairs = zip(places, np.roll(places, -1, axis=0), strict=True)
    px, in_front = camera.project(np.concatenate([a * (1 - t) + b * t for a, b in pairs]))
    if not in_front.all() or not near_picture(px, picture):
        return
    if opacity == 1:
        fill(picture, px, colour)
    else:
        blend(picture, lambda layer: fill(layer, px, colour), opacity)


def draw_frame(
    picture: PixelArray,
    camera: PinholeCamera,
    corners: Sequence[Place],
    width_m: float,
    colour: Colour = WHITE,
) -> None:
    """A painted rectangle on a sheet, its outer edge exactly between the corners, metres."""
    outer = np.array(corners, dtype=np.float64)
    middle = outer.mean(axis=0)
    # Moved inwards by the width along both sides, not towards the middle.
    sides = (outer[1] - outer[0], outer[2] - outer[1])
    shrink = [1 - 2 * width_m / np.linalg.norm(side) for side in sides]
    inner = middle + sum(
        ((outer - middle) @ s / (s @ s))[:, None] * s * k
        for s, k in zip(sides, shrink, strict=True)
    )
    t = np.linspace(0, 1, 8)[:-1, None]
    rings = []
    for ring in (outer, inner):
        pairs = zip(ring, np.roll(ring, -1, axis=0), strict=True)
        px, in_front = camera.project(np.concatenate([a * (1 - t) + b * t for a, b in pairs]))
        if not in_front.all() or not near_picture(px, picture):
            return
        rings.append(_fixed(px))
    cv2.fillPoly(picture, rings, colour, cv2.LINE_AA, _SHIFT)


def draw_box(
    picture: PixelArray, camera: PinholeCamera, low: Place, high: Place, colour: Colour
) -> None:
    """An upright box between two corners, metres; its sides differ in light."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    faces = [([(x, y0, z0), (x, y1, z0), (x, y1, z1), (x, y0, z1)], 0.8) for x in (x0, x1)]
    faces += [([(x0, y, z0), (x1, y, z0), (x1, y, z1), (x0, y, z1)], 0.95) for y in (y0, y1)]
    faces += [([(x0, y0, z), (x1, y0, z), (x1, y1, z), (x0, y1, z)], 1.1) for z in (z0, z1)]
    position = np.array(camera.position_world)

    def away(face: tuple[list[Place], float]) -> float:
        return float(np.linalg.norm(np.mean(face[0], axis=0) - position))

    for corners, light in sorted(faces, key=away, reverse=True):
        shaded = tuple(min(255, round(c * light)) for c in colour)
        draw_sheet(picture, camera, corners, shaded)


def blend(picture: PixelArray, draw: Callable[[PixelArray], None], opacity: float) -> None:
    """Draw something that lets the picture behind it through."""
    layer = picture.copy()
    draw(layer)
    cv2.addWeighted(layer, opacity, picture, 1 - opacity, 0, dst=picture)


def fill(picture: PixelArray, outline: FloatArray, colour: Colour) -> None:
    """Fill an outline of px, to a fraction of a pixel."""
    cv2.fillPoly(picture, [_fixed(outline)], colour, cv2.LINE_AA, _SHIFT)


def _fixed(px: FloatArray) -> NDArray[np.int32]:
    return np.round(px * (1 << _SHIFT)).astype(np.int32).reshape(-1, 1, 2)


def near_picture(px: FloatArray, picture: PixelArray) -> bool:
    """Whether all of px lies in the picture or not far from it."""
    size = np.array([picture.shape[1], picture.shape[0]])
    return bool(((px > -2000) & (px < size + 2000)).all())
