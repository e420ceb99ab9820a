"""How maps in metres look: their levels, a tone a band, and the lines that need no colour."""

from __future__ import annotations

import math
from dataclasses import dataclass

from procc_annotator.fit.predict.ground_uncertainty import ACCURACY_LEVELS_M
from procc_annotator.interact import palette
from procc_annotator.language import word
from procc_annotator.metric.contours import DISAGREEMENT_LEVELS_M, OFFSIDE_ACCURACY_M


@dataclass(frozen=True, slots=True)
class LevelLine:
    """The line of one level.

    Attributes:
        metres: the level.
        dash: lengths on and off, points; () for a solid line.
    """

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
        lines: the levels that are drawn as lines, told apart by their dashes.
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
