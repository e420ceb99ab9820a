"""What a finder of paint looks for: how an element looks, and how wide it is in this picture."""

from __future__ import annotations

from dataclasses import dataclass

from procc_annotator.field.appearance import ANY_LINE, Appearance

NARROWEST_PX, WIDEST_PX = 0.7, 14.0
_LEAST_SHARE, _LARGEST_SHARE = 0.5, 2.0  # of the width a camera shows: blur, snow, worn paint


@dataclass(frozen=True, slots=True)
class Sought:
    """Paint to be found.

    Attributes:
        looks: its kind, tone and colour.
        width_px: (least, most) of the band, across it.
    """

    looks: Appearance = ANY_LINE
    width_px: tuple[float, float] = (NARROWEST_PX, WIDEST_PX)

    @classmethod
    def of(cls, looks: Appearance, px_per_metre: float | None = None) -> Sought:
        """What an element looks like where a metre across it is so many px; None: unknown."""
        if not looks.width_m or px_per_metre is None:
            return cls(looks)
        width = looks.width_m * px_per_metre
        # Nothing is seen narrower than what a lens and compression make of it.
        return cls(looks, (_LEAST_SHARE * width, max(_LARGEST_SHARE * width, 4.0)))


ANYTHING = Sought()
