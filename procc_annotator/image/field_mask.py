"""Segment the field surface in an image: grass, or the floor of a hall."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import IntArray
from procc_annotator.image.pixels import PixelArray

Mask = NDArray[np.uint8]
Values = NDArray[np.float32]

_MASK_WIDTH_PX = 320
_MIN_BRIGHTNESS, _MAX_EDGE, _MIN_FLAT_SHARE = 30, 14, 0.55
# Colours alike: their shares of red and blue, and the logarithm of their brightness.
_CHROMA_STEP, _BRIGHTNESS_STEP, _CHROMA_BINS, _BRIGHTNESS_BINS = 0.025, 0.25, 40, 9
_MIN_LOG_BRIGHTNESS = 3.4
_CHROMA_TOLERANCE, _BRIGHTNESS_TOLERANCE = 0.08, 0.8
_FIELD_COLOURS = 3  # a court has others than what surrounds it
_MIN_FIELD_SHARE, _MIN_ADDED_SHARE = (
    0.4,
    0.04,
)  # of the picture: no other colour is looked for; another one's
_MIN_CONTACT_SHARE = 0.02
_PLAYER_KERNEL_PX, _HULL_KERNEL_PX = 25, 25


def field_mask(picture: PixelArray) -> Mask:
    """The ground, players on it included.

    The most frequent colour of what is smooth, in its largest piece; where that is little of the
    picture, further smooth colours that touch it and do not lie above.

    Args:
        picture: (H, W, 3) BGR.

    Returns:
        (h, 320) 1 where the ground is; nothing but 0 if nothing is smooth.
    """
    small = mask_scale_image(picture)
    ground = np.zeros(small.shape[:2], dtype=np.uint8)
    top = 0.0
    for piece in colour_regions(small, _FIELD_COLOURS):
        rows = np.nonzero(piece)[0]
        if not ground.any():
            ground, top = piece, float(np.percentile(rows, 5))
        elif is_field_region(piece, ground, top):
            ground |= piece
        if ground.mean() > _MIN_FIELD_SHARE:
            break
    return fill_holes(ground)


def mask_scale_image(picture: PixelArray) -> PixelArray:
    """A picture (H, W, 3) made so small that a ground shows, and little else: (h, 320, 3)."""
    height, width = picture.shape[:2]
    size = (_MASK_WIDTH_PX, max(round(height * _MASK_WIDTH_PX / width), 1))
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)


def colour_regions(small: PixelArray, colours: int, calm: float = 0.0) -> Iterator[Mask]:
    """The largest piece of each of the most frequent colours of what is smooth.

    Args:
        small: (h, 320, 3) BGR.
        colours: so many at most.
        calm: share of what is about a place that must be flat; in a crowd less is.
    """
    red, blue, bright = _chromaticity(small)
    flat = _smooth_mask(small)
    smooth = (cv2.blur(flat, (9, 9)) > _MIN_FLAT_SHARE) & (small.max(axis=2) > _MIN_BRIGHTNESS)
    quiet = cv2.blur(flat, (_HULL_KERNEL_PX, _HULL_KERNEL_PX)) >= calm
    for _ in range(colours):
        if smooth.mean() < 2 * _MIN_ADDED_SHARE:
            return
        centre = _modal_colour(red[smooth], blue[smooth], bright[smooth], np.nonzero(smooth)[0])
        alike = np.hypot(red - centre[0], blue - centre[1]) < _CHROMA_TOLERANCE
        alike &= np.abs(bright - centre[2]) < _BRIGHTNESS_TOLERANCE
        piece = _largest_component(alike & quiet)
        smooth &= ~alike
        if piece.any():
            yield piece


def _chromaticity(small: PixelArray) -> tuple[Values, Values, Values]:
    values = small.astype(np.float32) + 10
    total = values.sum(axis=2) + 20
    return values[..., 2] / total, values[..., 0] / total, np.log(values.max(axis=2))


def _smooth_mask(small: PixelArray) -> Values:
    """(h, 320) 1 where there is no edge."""
    grey = cv2.cvtColor(small, cv2.COLOR_BGR2GRAY)
    edges = cv2.morphologyEx(grey, cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))
    return np.asarray(edges < _MAX_EDGE, dtype=np.float32)


def _modal_colour(
    red: Values, blue: Values, bright: Values, below: NDArray[np.intp]
) -> tuple[float, float, float]:
    """The colour most pixels have, those below counting more: the sky is no ground."""
    places = (
        np.clip((red / _CHROMA_STEP).astype(np.intp), 0, _CHROMA_BINS - 1),
        np.clip((blue / _CHROMA_STEP).astype(np.intp), 0, _CHROMA_BINS - 1),
        np.clip(
            ((bright - _MIN_LOG_BRIGHTNESS) / _BRIGHTNESS_STEP).astype(np.intp),
            0,
            _BRIGHTNESS_BINS - 1,
        ),
    )
    shape = (_CHROMA_BINS, _CHROMA_BINS, _BRIGHTNESS_BINS)
    weight = 0.3 + below / max(int(below.max()), 1)
    counts = np.bincount(
        np.ravel_multi_index(places, shape), weight, _CHROMA_BINS**2 * _BRIGHTNESS_BINS
    )
    padded = np.pad(counts.reshape(shape), 1)
    rows = padded[:-2] + padded[1:-1] + padded[2:]
    both = rows[:, :-2] + rows[:, 1:-1] + rows[:, 2:]
    near = both[:, :, 1:-1] + (both[:, :, :-2] + both[:, :, 2:]) / 2
    first, second, third = np.unravel_index(int(near.argmax()), shape)
    return (
        (float(first) + 0.5) * _CHROMA_STEP,
        (float(second) + 0.5) * _CHROMA_STEP,
        (float(third) + 0.5) * _BRIGHTNESS_STEP + _MIN_LOG_BRIGHTNESS,
    )


def _largest_component(alike: NDArray[np.bool_]) -> Mask:
    opened = cv2.morphologyEx(alike.astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    closed = cv2.morphologyEx(opened, cv2.MORPH_CLOSE, _disc_kernel(7))
    count, labels, figures, _ = cv2.connectedComponentsWithStats(closed)
    if count < 2:
        return np.zeros(alike.shape, dtype=np.uint8)
    largest = 1 + int(figures[1:, cv2.CC_STAT_AREA].argmax())
    return np.asarray(labels == largest, dtype=np.uint8)


def is_field_region(piece: Mask, ground: Mask, top: float) -> bool:
    """Return whether another colour is of the ground: it touches it, and is no wall above its top
    row."""
    if piece.mean() < _MIN_ADDED_SHARE or float(np.percentile(np.nonzero(piece)[0], 30)) < top:
        return False
    beside = (cv2.dilate(piece, np.ones((9, 9), np.uint8)) > 0) & (ground > 0)
    return bool(beside.sum() >= _MIN_CONTACT_SHARE * piece.sum())


def fill_holes(ground: Mask) -> Mask:
    """A ground with what is enclosed, and what players cut out of its edge."""
    closed = cv2.morphologyEx(ground, cv2.MORPH_CLOSE, _disc_kernel(9))
    outlines, _ = cv2.findContours(closed, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    filled = np.zeros_like(ground)
    if outlines:
        largest = max(outlines, key=cv2.contourArea)
        cv2.drawContours(filled, [largest], -1, (1,), -1)
    rim = _PLAYER_KERNEL_PX + 5
    padded = cv2.copyMakeBorder(filled, rim, rim, rim, rim, cv2.BORDER_REPLICATE)
    padded = cv2.morphologyEx(padded, cv2.MORPH_CLOSE, _disc_kernel(_PLAYER_KERNEL_PX))
    return np.ascontiguousarray(padded[rim:-rim, rim:-rim], dtype=np.uint8)


def _disc_kernel(size: int) -> Mask:
    return np.asarray(cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size)), dtype=np.uint8)


_FLOOR_COLOURS, _MIN_PIECE_SHARE = 5, 0.04  # a piece's share of the picture
_SMOOTH_SHARE = 0.25  # a crowd has less that is flat
_MIN_FLOOR_SHARE = 0.4  # of the picture: only what lines part is added
_BORDER_DILATION_PX = 7  # cells across of what pieces are widened by
# Along a border of so many cells at least, lines run along such a share.
_MIN_BORDER, _MIN_MARKED_BORDER = 15, 0.4
_PLACES_A_CELL = 4  # of paint, along a line


def floor_regions(picture: PixelArray) -> list[Mask]:
    """Return what may be of a floor: large pieces of one colour each, (h, 320), of a picture (H, W,
    3)."""
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
    return np.asarray(
        cv2.dilate(piece, np.ones((_BORDER_DILATION_PX,) * 2, np.uint8)), dtype=np.uint8
    )


def _separated_by_line(one: Mask, other: Mask, paint: IntArray) -> bool:
    """Return whether paint runs along much of the border of two widened pieces."""
    border = (one & other) > 0
    length = border.sum() / _BORDER_DILATION_PX
    return bool(
        length > _MIN_BORDER and paint[border].sum() > _MIN_MARKED_BORDER * _PLACES_A_CELL * length
    )
