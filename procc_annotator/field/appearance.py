"""Appearance of line markings (kind, tone, colour, width), and CIE L*a*b* colour differences."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

# A painted band with ground on both its sides; the border of an area or of a wall, where one side
# differs from the other; something that stands before anything; nothing that could be found.
LINE, EDGE, BAR, NOTHING = KINDS = "line", "edge", "bar", "nothing"
# The paint against what is next to it.
LIGHTER, DARKER, ANY = TONES = "lighter", "darker", "any"
WHITE, BLACK = "white", "black"
RED, ORANGE, YELLOW, BLUE = "red", "orange", "yellow", "blue"
COLOURS = WHITE, BLACK, RED, ORANGE, YELLOW, BLUE, ANY


@dataclass(frozen=True, slots=True)
class Appearance:
    """Look of an element's line marking, as far as its rules say.

    Attributes:
        kind: one of `KINDS`.
        tone: of the paint against the ground next to it, one of `TONES`.
        colour: of the paint, one of `COLOURS`.
        width_m: of the painted band, or the diameter of a bar; 0 if unknown.
    """

    kind: str = LINE
    tone: str = ANY
    colour: str = ANY
    width_m: float = 0.0


ANY_LINE = Appearance()


# sRGB to XYZ under D65 (IEC 61966-2-1).
_XYZ_FROM_RGB = np.array(
    [[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]]
)
_WHITE = np.array([0.9505, 1.0, 1.089])
_LAB_EPSILON, _LAB_KAPPA = 216 / 24389, 24389 / 27


def colour_difference(one: str, other: str) -> float:
    """The distance of two colours ``#rrggbb`` in CIE L*a*b* (1976): about 2 can just be seen."""
    return float(np.linalg.norm(_lab(one) - _lab(other)))


def linear_rgb(colour: str) -> NDArray[np.float64]:
    """(3,) the light of a colour ``#rrggbb``, 0 to 1 each (sRGB made linear)."""
    rgb = np.array([int(colour[i : i + 2], 16) for i in (1, 3, 5)]) / 255
    return np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)


def hex_colour(linear: NDArray[np.float64]) -> str:
    """The colour ``#rrggbb`` of (3,) linear light; what is out of 0 to 1 is cut."""
    light = np.clip(linear, 0.0, 1.0)
    rgb = np.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055)
    return "#" + "".join(f"{round(255 * float(part)):02x}" for part in rgb)


def _lab(colour: str) -> NDArray[np.float64]:
    xyz = _XYZ_FROM_RGB @ linear_rgb(colour) / _WHITE
    x, y, z = np.where(xyz > _LAB_EPSILON, np.cbrt(xyz), (_LAB_KAPPA * xyz + 16) / 116)
    return np.array([116 * y - 16, 500 * (x - y), 200 * (y - z)])
