"""Where a picture shows the floor of a hall: of several colours, which lines part."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.image.ground import Mask, is_field_region, fill_holes, colour_regions, mask_scale_image
from procc_annotator.image.pixels import PixelArray

IntArray = NDArray[np.intp]

_FLOOR_COLOURS, _MIN_PIECE_SHARE = 5, 0.04  # a piece's share of the picture
_SMOOTH_SHARE = 0.25  # a crowd has less that is flat
_MIN_FLOOR_SHARE = 0.4  # of the picture: only what lines part is added
_BORDER_DILATION_PX = 7  # cells across of what pieces are widened by
# Along a border of so many cells at least, lines run along such a share.
_MIN_BORDER, _MIN_MARKED_BORDER = 15, 0.4
_PLACES_A_CELL = 4  # of paint, along a line


def floor_regions(picture: PixelArray) -> list[Mask]:
    """What may be of a floor: large pieces of one colour each, (h, 320), of a picture (H, W, 3)."""
    found = colour_regions(mask_scale_image(picture), _FLOOR_COLOURS, _SMOOTH_SHARE)
    return [piece for piece in found if piece.mean() >= _MIN_PIECE_SHARE]


def floor_mask(pieces: Sequence[Mask], paint: IntArray) -> Mask:
    """The floor, players on it included.

    It begins with the piece that is large and has much paint, for what is around a court may be
    larger; what adjoins it along paint is added. Where that is little of the picture, so are other
    pieces that touch it and do not lie above.

    Args:
        pieces: one at least.
        paint: (h, 320) how many places that look like paint each cell has.

    Returns:
        (h, 320) 1 where the floor is.
    """
    widened = [_dilated(piece) for piece in pieces]
    worth = [
        piece.mean() * (paint[wide > 0].sum() + 1)
        for piece, wide in zip(pieces, widened, strict=True)
    ]
    first = int(np.argmax(worth))
    floor, around = pieces[first].copy(), widened[first].copy()
    left = [i for i in range(len(pieces)) if i != first]
    while more := [i for i in left if _separated_by_line(around, widened[i], paint)]:
        for i in more:
            left.remove(i)
            floor |= pieces[i]
            around |= widened[i]
    top = float(np.percentile(np.nonzero(floor)[0], 5))
    for i in left:
        if floor.mean() <= _MIN_FLOOR_SHARE and is_field_region(pieces[i], floor, top):
            floor |= pieces[i]
    return fill_holes(floor)


def _dilated(piece: Mask) -> Mask:
    return np.asarray(cv2.dilate(piece, np.ones((_BORDER_DILATION_PX,) * 2, np.uint8)), dtype=np.uint8)


def _separated_by_line(one: Mask, other: Mask, paint: IntArray) -> bool:
    """Whether paint runs along much of the border of two widened pieces."""
    border = (one & other) > 0
    length = border.sum() / _BORDER_DILATION_PX
    return bool(length > _MIN_BORDER and paint[border].sum() > _MIN_MARKED_BORDER * _PLACES_A_CELL * length)
