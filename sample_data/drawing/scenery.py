"""The empty arena: a colour for every pixel, by following its ray."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from drawing.gloss import Gloss, add_gloss
from drawing.paint import Area, Colour, Stroke, cover_with_areas, cover_with_strokes
from drawing.rays import Sight
from drawing.rink import Rink, draw_rink
from drawing.surroundings import Side, Stands, draw_side
from procc_annotator.camera.models import PinholeCamera

FloatArray = NDArray[np.float32]
# (H, W, 2) metres on the ground and a seed -> (H, W, 3) BGR
Ground = Callable[[FloatArray, int], FloatArray]


@dataclass(frozen=True)
class Arena:
    """What the scenery of a sport is made of.

    Attributes:
        ground: the bare floor.
        areas: coloured parts of it.
        strokes: painted lines.
        beyond: ground that no paint reaches.
        opacity: of the lines.
        sides: where boards and stands are.
        stands: how they look.
        above: colour of what is above the stands.
        gloss: how the floor shines; None: not at all.
        rink: boards and glass around the ice.
    """

    ground: Ground
    strokes: tuple[Stroke, ...]
    sides: tuple[Side, ...]
    stands: Stands
    areas: tuple[Area, ...] = ()
    beyond: tuple[Area, ...] = ()
    opacity: float = 0.93
    above: Colour = (52, 40, 34)
    gloss: Gloss | None = None
    rink: Rink | None = None


def draw_scenery(
    arena: Arena, camera: PinholeCamera, size: tuple[int, int], seed: int
) -> FloatArray:
    """The empty arena seen by a camera.

    Args:
        arena: what there is to see.
        camera: in pixels of ``size``.
        size: (width, height) px.
        seed: decides the crowd and the grain of the ground.

    Returns:
        (height, width, 3) BGR, 0 to 255.
    """
    sight = Sight.of(camera, size)
    # Rays that meet a plane nowhere, and ground that runs to the horizon.
    with np.errstate(divide="ignore", invalid="ignore"):
        ground = sight.ground()
        picture = arena.ground(ground, seed)
        cover_with_areas(picture, ground, arena.areas)
        cover_with_strokes(picture, ground, arena.strokes, arena.opacity, camera)
        cover_with_areas(picture, ground, arena.beyond)
        if arena.gloss is not None:
            below = sight.mirrored(arena.gloss.every)
            surroundings = np.full((*below.reach.shape, 3), arena.above, dtype=np.float32)
            _draw_around(surroundings, below, arena, seed)
            roof = ~np.isfinite(below.reach)
            add_gloss(picture, ground, sight, arena.gloss, surroundings, roof)
        picture[~np.isfinite(sight.reach)] = arena.above
        _draw_around(picture, sight, arena, seed)
    return picture


def _draw_around(picture: FloatArray, sight: Sight, arena: Arena, seed: int) -> None:
    for side in arena.sides:
        draw_side(picture, sight, side, arena.stands, seed)
    if arena.rink is not None:
        draw_rink(picture, sight, arena.rink)
