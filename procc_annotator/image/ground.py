"""Where a picture shows the ground of a field: its colours tell, and that it is one large piece."""

from __future__ import annotations

from collections.abc import Iterator

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.image.pixels import PixelArray

Mask = NDArray[np.uint8]
Values = NDArray[np.float32]

_WIDTH_PX = 320
_DARKEST, _MOST_EDGE, _FLAT_SHARE = 30, 14, 0.55
# Colours alike: their shares of red and blue, and the logarithm of their brightness.
_SHARE_STEP, _BRIGHT_STEP, _SHARES, _BRIGHTS = 0.025, 0.25, 40, 9
_DARK_LOG = 3.4
_LIKE_SHARE, _LIKE_BRIGHT = 0.08, 0.8
_COLOURS = 3  # a court has others than what surrounds it
_ENOUGH, _LEAST_MORE = 0.4, 0.04  # of the picture: no other colour is looked for; another one's
_TOUCHING = 0.02
_PLAYER_PX, _ABOUT_PX = 25, 25


def ground_of(picture: PixelArray) -> Mask:
    """The ground, players on it included.

    The most frequent colour of what is smooth, in its largest piece; where that is little of the
    picture, further smooth colours that touch it and do not lie above.

    Args:
        picture: (H, W, 3) BGR.

    Returns:
        (h, 320) 1 where the ground is; nothing but 0 if nothing is smooth.
    """
    small = reduced(picture)
    ground = np.zeros(small.shape[:2], dtype=np.uint8)
    top = 0.0
    for piece in pieces_of(small, _COLOURS):
        rows = np.nonzero(piece)[0]
        if not ground.any():
            ground, top = piece, float(np.percentile(rows, 5))
        elif belongs(piece, ground, top):
            ground |= piece
        if ground.mean() > _ENOUGH:
            break
    return filled(ground)


def reduced(picture: PixelArray) -> PixelArray:
    """A picture (H, W, 3) made so small that a ground shows, and little else: (h, 320, 3)."""
    height, width = picture.shape[:2]
    size = (_WIDTH_PX, max(round(height * _WIDTH_PX / width), 1))
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)


def pieces_of(small: PixelArray, colours: int, calm: float = 0.0) -> Iterator[Mask]:
    """The largest piece of each of the most frequent colours of what is smooth.

    Args:
        small: (h, 320, 3) BGR.
        colours: so many at most.
        calm: share of what is about a place that must be flat; in a crowd less is.
    """
    red, blue, bright = _colour(small)
    flat = _flat(small)
    smooth = (cv2.blur(flat, (9, 9)) > _FLAT_SHARE) & (small.max(axis=2) > _DARKEST)
    quiet = cv2.blur(flat, (_ABOUT_PX, _ABOUT_PX)) >= calm
    for _ in range(colours):
        if smooth.mean() < 2 * _LEAST_MORE:
            return
        centre = _most_frequent(red[smooth], blue[smooth], bright[smooth], np.nonzero(smooth)[0])
        alike = np.hypot(red - centre[0], blue - centre[1]) < _LIKE_SHARE
        alike &= np.abs(bright - centre[2]) < _LIKE_BRIGHT
        piece = _largest_piece(alike & quiet)
        smooth &= ~alike
        if piece.any():
            yield piece


def _colour(small: PixelArray) -> tuple[Values, Values, Values]:
    values = small.astype(np.float32) + 10
    total = values.sum(axis=2) + 20
    return values[..., 2] / total, values[..., 0] / total, np.log(values.max(axis=2))


def _flat(small: PixelArray) -> Values:
    """(h, 320) 1 where there is no edge."""
    grey = cv2.cvtColor(small, cv2.COLOR_BGR2GRAY)
    edges = cv2.morphologyEx(grey, cv2.MORPH_GRADIENT, np.ones((3, 3), np.uint8))
    return np.asarray(edges < _MOST_EDGE, dtype=np.float32)


def _most_frequent(
    red: Values, blue: Values, bright: Values, below: NDArray[np.intp]
) -> tuple[float, float, float]:
    """The colour most pixels have, those below counting more: the sky is no ground."""
    places = (
        np.clip((red / _SHARE_STEP).astype(np.intp), 0, _SHARES - 1),
        np.clip((blue / _SHARE_STEP).astype(np.intp), 0, _SHARES - 1),
        np.clip(((bright - _DARK_LOG) / _BRIGHT_STEP).astype(np.intp), 0, _BRIGHTS - 1),
    )
    shape = (_SHARES, _SHARES, _BRIGHTS)
    weight = 0.3 + below / max(int(below.max()), 1)
    counts = np.bincount(np.ravel_multi_index(places, shape), weight, _SHARES**2 * _BRIGHTS)
    padded = np.pad(counts.reshape(shape), 1)
    rows = padded[:-2] + padded[1:-1] + padded[2:]
    both = rows[:, :-2] + rows[:, 1:-1] + rows[:, 2:]
    near = both[:, :, 1:-1] + (both[:, :, :-2] + both[:, :, 2:]) / 2
    first, second, third = np.unravel_index(int(near.argmax()), shape)
    return (
        (float(first) + 0.5) * _SHARE_STEP,
        (float(second) + 0.5) * _SHARE_STEP,
        (float(third) + 0.5) * _BRIGHT_STEP + _DARK_LOG,
    )


def _largest_piece(alike: NDArray[np.bool_]) -> Mask:
    opened = cv2.morphologyEx(alike.astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    closed = cv2.morphologyEx(opened, cv2.MORPH_CLOSE, _disc(7))
    count, labels, figures, _ = cv2.connectedComponentsWithStats(closed)
    if count < 2:
        return np.zeros(alike.shape, dtype=np.uint8)
    largest = 1 + int(figures[1:, cv2.CC_STAT_AREA].argmax())
    return np.asarray(labels == largest, dtype=np.uint8)


def belongs(piece: Mask, ground: Mask, top: float) -> bool:
    """Whether another colour is of the ground: it touches it, and is no wall above its top row."""
    if piece.mean() < _LEAST_MORE or float(np.percentile(np.nonzero(piece)[0], 30)) < top:
        return False
    beside = (cv2.dilate(piece, np.ones((9, 9), np.uint8)) > 0) & (ground > 0)
    return bool(beside.sum() >= _TOUCHING * piece.sum())


def filled(ground: Mask) -> Mask:
    """A ground with what is enclosed, and what players cut out of its edge."""
    closed = cv2.morphologyEx(ground, cv2.MORPH_CLOSE, _disc(9))
    outlines, _ = cv2.findContours(closed, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    filled = np.zeros_like(ground)
    if outlines:
        largest = max(outlines, key=cv2.contourArea)
        cv2.drawContours(filled, [largest], -1, (1,), -1)
    rim = _PLAYER_PX + 5
    padded = cv2.copyMakeBorder(filled, rim, rim, rim, rim, cv2.BORDER_REPLICATE)
    padded = cv2.morphologyEx(padded, cv2.MORPH_CLOSE, _disc(_PLAYER_PX))
    return np.ascontiguousarray(padded[rim:-rim, rim:-rim], dtype=np.uint8)


def _disc(size: int) -> Mask:
    return np.asarray(cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size)), dtype=np.uint8)
