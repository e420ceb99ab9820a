"""What a finder of paint looks for: how an element looks, and how wide it is in this picture."""

from __future__ import annotations

from dataclasses import dataclass

from procc_annotator.field.appearance import ANY_LINE, BAR, Appearance

MIN_WIDTH_PX, MAX_WIDTH_PX = 0.7, 14.0
# Of the width a camera shows: blur, snow, worn paint. A bar is neither worn nor snowed on.
_MIN_WIDTH_RATIO, _MIN_WIDTH_RATIO_BAR, _MAX_WIDTH_RATIO, _BLUR_PX = 0.35, 0.65, 1.3, 1.0

_ASSUMED_VIEW_M = 100.0, 8.0  # how much of a field is in a picture, from side to side
_WIDE_LINE_PX = 3.0
_BLURRED_PX = 6.0


@dataclass(frozen=True, slots=True)
class LineTarget:
    """Paint to be found.

    Attributes:
        looks: its kind, tone and colour.
        width_px: (least, most) of the band, across it.
        bends: whether its direction changes along it.
        is_expected: whether a camera shows it there.
        is_wide: whether something narrower beside it could be a part of it.
    """

    looks: Appearance = ANY_LINE
    width_px: tuple[float, float] = (MIN_WIDTH_PX, MAX_WIDTH_PX)
    bends: bool = False
    is_expected: bool = False
    is_wide: bool = False

    @classmethod
    def of(cls, looks: Appearance, picture_px: int, px_per_metre: float | None = None) -> LineTarget:
        """What an element looks like in a picture.

        Args:
            looks: the element's.
            picture_px: the picture's width.
            px_per_metre: across the element; None where nobody knows it.
        """
        if not looks.width_m:
            return cls(looks)
        if px_per_metre is None:
            least, most = (looks.width_m * picture_px / seen for seen in _ASSUMED_VIEW_M)
            if least < _WIDE_LINE_PX:
                return cls(looks, (MIN_WIDTH_PX, min(max(most, _BLURRED_PX), MAX_WIDTH_PX)))
            return cls(looks, (least, most))
        width = looks.width_m * px_per_metre
        # Nothing is seen narrower than what a lens and compression make of it.
        most = max(_MAX_WIDTH_RATIO * width + _BLUR_PX, _BLURRED_PX)
        least = (_MIN_WIDTH_RATIO_BAR if looks.kind == BAR else _MIN_WIDTH_RATIO) * width
        return cls(looks, (least, most), is_expected=True)


ANY_LINE_TARGET = LineTarget()
