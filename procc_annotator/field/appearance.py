"""How an element looks in a picture: what a finder of paint has to look for."""

from __future__ import annotations

from dataclasses import dataclass

# A painted band with ground on both its sides; the border of an area or of a wall, where one side
# differs from the other; something that stands before anything; nothing that could be found.
LINE, EDGE, BAR, NOTHING = KINDS = "line", "edge", "bar", "nothing"
# The paint against what lies beside it.
LIGHTER, DARKER, ANY = TONES = "lighter", "darker", "any"
WHITE, BLACK = "white", "black"
RED, ORANGE, YELLOW, BLUE = "red", "orange", "yellow", "blue"
COLOURS = WHITE, BLACK, RED, ORANGE, YELLOW, BLUE, ANY


@dataclass(frozen=True, slots=True)
class Appearance:
    """What an element's paint looks like, as far as its rules say.

    Attributes:
        kind: one of `KINDS`.
        tone: of the paint against the ground beside it, one of `TONES`.
        colour: of the paint, one of `COLOURS`.
        width_m: of the painted band, or the diameter of a bar; 0 where nobody knows.
    """

    kind: str = LINE
    tone: str = ANY
    colour: str = ANY
    width_m: float = 0.0


ANY_LINE = Appearance()
