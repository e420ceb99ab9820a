"""The boards of an ice rink: walls that follow its outline, glass above them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from drawing.rays import Sight
from drawing.surroundings import Stands, board_colours
from procc_annotator.field.geometry import Arc, Line, Vector

FloatArray = NDArray[np.float32]

_KICK_PLATE_M = 0.22
_RAIL_M = 0.06
_ADVERT_M = (0.32, 0.92)
_JOINT_M, _JOINT_EVERY_M = 0.04, 1.8
_KICK_PLATE, _WHITE, _RAIL = (40, 190, 225), (226, 226, 222), (140, 60, 20)
_OUTSIDE, _GLASS, _JOINT = (74, 62, 52), (220, 214, 206), (70, 66, 62)


@dataclass(frozen=True)
class Rink:
    """Boards along the outline of the ice.

    Attributes:
        outline: lines and arcs, once around, from left to right as one sees them from the ice.
        height_m: of the boards.
        glass_m: of the glass above the boards.
        look: words on the boards.
    """

    outline: tuple[Line | Arc, ...]
    height_m: float
    glass_m: float
    look: Stands

    def hides(self, points: NDArray[np.float64], position: Vector) -> NDArray[np.bool_]:
        """(n,) whether the boards stand between a camera and places, (n, 3) metres."""
        rays = points - np.array(position)
        hidden = np.zeros(len(points), dtype=bool)
        for part in self.outline:
            for t, _, outside in _meetings(np.array(position), rays, part):
                height = -(position[2] + t * rays[:, 2])
                between = (t > 0) & (t < 1 + 1e-9) & (height < self.height_m - 1e-6)
                hidden |= between & outside
        return hidden


def draw_rink(picture: FloatArray, sight: Sight, rink: Rink) -> None:
    """Paint boards where they are nearer than what is painted already, and the far glass.

    Args:
        picture: (H, W, 3) BGR, changed in place, and with it what ``sight`` reaches.
        sight: rays of the picture.
        rink: the boards.
    """
    begin = 0.0
    for part in rink.outline:
        for t, along, outside in _meetings(sight.position, sight.rays, part):
            height = -(sight.position[2] + t * sight.rays[..., 2])
            seen = (t > 0) & (t < sight.reach) & (height >= 0)
            glass = seen & ~outside & (height >= rink.height_m)
            glass &= height < rink.height_m + rink.glass_m
            _tint(picture, glass, begin + along, height - rink.height_m, rink)
            wall = seen & (height < rink.height_m)
            inner = wall & ~outside
            picture[inner] = _boards(begin + along[inner], height[inner], rink)
            picture[wall & outside] = _OUTSIDE
            rail = wall & (height > rink.height_m - _RAIL_M)
            picture[rail] = _RAIL
            sight.reach[wall] = t[wall]
        begin += _length(part)


def _boards(along: FloatArray, height: FloatArray, rink: Rink) -> FloatArray:
    """(n, 3) BGR of the inner face: kick plate, white board, adverts."""
    colour = np.full((len(along), 3), _WHITE, dtype=np.float32)
    low, high = _ADVERT_M
    advert = (height > low) & (height < high)
    place = (height[advert] - low) / (high - low) * rink.look.board_height_m
    colour[advert] = board_colours(along[advert], place, rink.look)
    colour[height < _KICK_PLATE_M] = _KICK_PLATE
    return colour


def _tint(
    picture: FloatArray,
    glass: NDArray[np.bool_],
    along: FloatArray,
    up: FloatArray,
    rink: Rink,
) -> None:
    """Glass lets nearly all light through; its joints and its upper edge are seen."""
    place, height = along[glass], up[glass]
    share = np.full(len(place), 0.07, dtype=np.float32)
    share[height > rink.glass_m - _JOINT_M] = 0.4
    colour = np.full((len(place), 3), _GLASS, dtype=np.float32)
    joint = np.mod(place, _JOINT_EVERY_M) < _JOINT_M
    share[joint], colour[joint] = 0.55, _JOINT
    picture[glass] = picture[glass] * (1 - share[:, None]) + colour * share[:, None]


def _length(part: Line | Arc) -> float:
    if isinstance(part, Line):
        return float(np.linalg.norm(np.subtract(part.end, part.start)))
    return (part.end_rad - part.start_rad) * part.radius


def _meetings(
    position: NDArray[np.floating], rays: NDArray[np.floating], part: Line | Arc
) -> list[tuple[NDArray, NDArray, NDArray[np.bool_]]]:
    """Where rays cross the vertical wall above a part of the outline.

    Returns:
        Of each possible crossing: how often the ray's length it is (infinite where there is none),
        metres along the part, and whether the ray comes from outside the rink.
    """
    dx, dy = rays[..., 0], rays[..., 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        if isinstance(part, Line):
            start, end = np.array(part.start[:2]), np.array(part.end[:2])
            along = (end - start) / np.linalg.norm(end - start)
            normal = np.array([along[1], -along[0]])
            normal *= np.sign(normal @ (start + end)) or 1.0  # outwards: away from the centre
            towards = dx * normal[0] + dy * normal[1]
            t = float((start - position[:2]) @ normal) / towards
            s = (position[0] + t * dx - start[0]) * along[0]
            s = s + (position[1] + t * dy - start[1]) * along[1]
            off = (s < 0) | (s > np.linalg.norm(end - start))
            return [(np.where(off, np.inf, t), s, towards < 0)]
        ox, oy = position[0] - part.centre[0], position[1] - part.centre[1]
        a = dx * dx + dy * dy
        b = dx * ox + dy * oy
        root = np.sqrt(b * b - a * (ox * ox + oy * oy - part.radius**2))
        found = []
        for sign in (-1, 1):
            t = (-b + sign * root) / a
            x, y = ox + t * dx, oy + t * dy
            ahead = x * part.ahead[0] + y * part.ahead[1]
            aside = x * part.aside[0] + y * part.aside[1]
            turn = np.mod(np.arctan2(aside, ahead) - part.start_rad, 2 * np.pi)
            off = ~(turn <= part.end_rad - part.start_rad)
            found.append((np.where(off, np.inf, t), turn * part.radius, np.full(a.shape, sign < 0)))
        return found
