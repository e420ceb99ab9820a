"""Detect line pixels in the whole image: ridges on the field mask, thinned and linked.

A line is a band lighter or darker than both its sides: there the picture curves much across and
little along. What is narrow in a crowd, on boards and in letters is so too: the colour of the
ground says where to look, and a ridge counts only where others of its direction continue it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
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
# Of the picture: no other colour is looked for; another one's
_MIN_FIELD_SHARE, _MIN_ADDED_SHARE = 0.4, 0.04
_MIN_CONTACT_SHARE = 0.02
_PLAYER_KERNEL_PX, _HULL_KERNEL_PX = 25, 25


def field_mask(picture: PixelArray) -> Mask:
    """The ground of a BGR picture, players on it included.

    The most frequent colour of what is smooth, in its largest piece; where that is little of the
    picture, further smooth colours that touch it and do not lie above.

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


def colour_regions(
    small: PixelArray,
    colours: int,
    calm: float = 0.0,
    further: float = 1.0,
    least: float = 2 * _MIN_ADDED_SHARE,
) -> Iterator[Mask]:
    """The largest piece of each of the most frequent colours of what is smooth.

    Args:
        small: (h, 320, 3) BGR.
        colours: so many at most.
        calm: share of what is about a place that must be flat; in a crowd less is.
        further: other pieces of a colour that have such a share of the largest one's area, too.
        least: share of the picture that is smooth and of none of the colours yet.
    """
    red, blue, bright = _chromaticity(small)
    flat = _smooth_mask(small)
    smooth = (cv2.blur(flat, (9, 9)) > _MIN_FLAT_SHARE) & (small.max(axis=2) > _MIN_BRIGHTNESS)
    quiet = cv2.blur(flat, (_HULL_KERNEL_PX, _HULL_KERNEL_PX)) >= calm
    for _ in range(colours):
        if smooth.mean() < least:
            return
        centre = _modal_colour(red[smooth], blue[smooth], bright[smooth], np.nonzero(smooth)[0])
        alike = _is_alike((red, blue, bright), centre)
        piece = _largest_components(alike & quiet, further)
        smooth &= ~alike
        if piece.any():
            yield piece


def _chromaticity(small: NDArray[Any]) -> tuple[Values, Values, Values]:
    values = small.astype(np.float32) + 10
    total = values.sum(axis=-1) + 20
    return values[..., 2] / total, values[..., 0] / total, np.log(values.max(axis=-1))


def _is_alike(of: Sequence[Any], centre: Sequence[Any]) -> BoolArray:
    alike = np.hypot(of[0] - centre[0], of[1] - centre[1]) < _CHROMA_TOLERANCE
    return np.asarray(alike & (np.abs(of[2] - centre[2]) < _BRIGHTNESS_TOLERANCE))


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


def _largest_components(alike: NDArray[np.bool_], further: float) -> Mask:
    opened = cv2.morphologyEx(alike.astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8))
    closed = cv2.morphologyEx(opened, cv2.MORPH_CLOSE, _disc_kernel(7))
    count, labels, figures, _ = cv2.connectedComponentsWithStats(closed)
    if count < 2:
        return np.zeros(alike.shape, dtype=np.uint8)
    area = figures[:, cv2.CC_STAT_AREA].astype(np.float64)
    area[0] = 0
    return np.asarray((area >= further * area.max())[labels], dtype=np.uint8)


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


_FLOOR_COLOURS, _MIN_PIECE_SHARE = 5, 0.02  # a piece's share of the picture: a painted key's
_SMOOTH_SHARE = 0.12  # a crowd has less that is flat
_MIN_FLOOR_SHARE = 0.4  # of the picture: only what lines part is added
_FURTHER_PIECES = 0.05  # of the largest piece's area: a painted key cuts a floor in two
_BORDER_DILATION_PX = 7  # cells across of what pieces are widened by
# Along a border of so many cells at least, lines run along such a share.
_MIN_BORDER, _MIN_MARKED_BORDER = 15, 0.4
_PLACES_A_CELL = 4  # of paint, along a line


def floor_regions(picture: PixelArray) -> list[Mask]:
    """Return what may be of a floor: large pieces of one colour each, (h, 320), of a picture (H, W,
    3)."""
    small = mask_scale_image(picture)
    found = colour_regions(small, _FLOOR_COLOURS, _SMOOTH_SHARE, _FURTHER_PIECES, _MIN_PIECE_SHARE)
    return [piece for piece in found if piece.mean() >= _MIN_PIECE_SHARE]


def floor_mask(pieces: Sequence[Mask], paint: FloatArray | IntArray) -> Mask:
    """The floor, players on it included.

    It begins with the piece that is large and has much paint, for what is around a court may be
    larger; what adjoins it along paint is added. Where that is little of the picture, so are other
    pieces that touch it and do not lie above.

    Args:
        pieces: one at least.
        paint: (h, 320) how many places that look like paint each cell has, at 1280 px.

    Returns:
        (h, 320) 1 where the floor is.
    """
    kernel = np.ones((_BORDER_DILATION_PX,) * 2, np.uint8)
    widened = [np.asarray(cv2.dilate(piece, kernel), dtype=np.uint8) for piece in pieces]
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


def _separated_by_line(one: Mask, other: Mask, paint: FloatArray | IntArray) -> bool:
    """Return whether paint runs along much of the border of two widened pieces."""
    border = (one & other) > 0
    length = border.sum() / _BORDER_DILATION_PX
    return bool(
        length > _MIN_BORDER and paint[border].sum() > _MIN_MARKED_BORDER * _PLACES_A_CELL * length
    )


_WORKING_WIDTH_PX = 1280  # paint is seen as well in a picture made smaller, in less time
_RIDGE_SIGMAS_PX = (1.2, 2.0)  # a line of half width w shows best at w / sqrt(3): 4 to 7 px wide
_MIN_RIDGE_RESPONSE = 2.5
# A ridge is lighter than both sides, so many px away; next to a step only one of them is darker.
_FLANK_DISTANCES_PX, _MIN_CONTRAST, _CONTRAST_SHARE = (4, 7), 2.0, 0.3
# A ridge goes on so far to one side at least, in small steps, perhaps bending a little.
_CONTINUATION_PX, _CONTINUATION_STEP_PX, _CONTINUATION_CURVATURES, _MIN_SHARE = (
    36,
    4,
    (-0.006, 0.0, 0.006),
    0.7,
)
_SAME_DIRECTION_COSINE = np.cos(2 * np.radians(14.0))  # of twice the angle: a line has no sense
_MASK_MARGIN_PX, _MASK_INNER_PX, _IMAGE_BORDER_PX = 12, 4, 4
# A ridge is so many times as strong as usual about it
_TEXTURE_WINDOW_PX, _MIN_TEXTURE_RATIO = 96, 12.0
_WIDE_LINE_REDUCTION = 3  # lines three times as wide are found by the same filters
_MIN_EDGE_STEP = 24.0  # of 255 each, all channels together: areas of a floor differ as much
_FILTER_MARGIN_PX = 16  # farther from a place nothing changes what is found there


@dataclass(frozen=True, eq=False)
class LinePixels:
    """Line pixels of a picture, or what looks like them.

    Attributes:
        size: (width, height) px of the picture.
        points: (2, N) picture px, on the middle of the paint; row by row.
        along: (N,) rad, the line's direction in the picture, 0 to pi.
        on_ground: (N,) whether it is well inside the ground; the others lie at its rim, where a
            touchline may be, or boards.
        ground: (h, 320) 1 where the ground is, players on it included.
    """

    size: tuple[int, int]
    points: FloatArray
    along: FloatArray
    on_ground: BoolArray
    ground: NDArray[np.uint8]


def detect_line_pixels(
    picture: PixelArray,
    *,
    light: bool = True,
    dark: bool = False,
    floor: bool = False,
    wide: bool = False,
    edges: bool = False,
) -> LinePixels:
    """Find what looks like the paint of lines in a picture.

    Args:
        picture: (H, W, 3 or 4) BGR or BGRA.
        light, dark: whether paint is lighter, or darker, than what is next to it.
        floor: whether the ground is the floor of a hall, of several colours and with a grain;
            otherwise it is of one.
        wide: whether some lines may be many px wide.
        edges: whether the edge between a floor's areas of two colours may be a line.
    """
    height, width = picture.shape[:2]
    shrink = max(width / _WORKING_WIDTH_PX, 1.0)
    small = np.ascontiguousarray(picture)
    if shrink > 1:
        size = (_WORKING_WIDTH_PX, max(round(height / shrink), 1))
        small = np.asarray(cv2.resize(small, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    small = np.ascontiguousarray(small[:, :, :3])
    pieces = floor_regions(small) if floor else [field_mask(small)]
    if not pieces:
        none, ground = np.zeros(0), np.zeros((1, 1), dtype=np.uint8)
        return LinePixels((width, height), np.zeros((2, 0)), none, none > 0, ground)
    beside = _search_mask(np.bitwise_or.reduce(pieces), small.shape)
    signs = [sign for sign, wanted in ((1, light), (-1, dark)) if wanted]
    # White paint is light in all colours, coloured paint dark in one of them.
    blue, green, red = cv2.split(small)
    grey = cv2.min(cv2.min(blue, green), red).astype(np.float32)
    found = [_linked_ridges(grey, beside, signs)]
    if wide:
        found.append(_wide_ridges(grey, beside, signs))
    if floor and edges:
        found.append(_linked_edges(small, pieces, beside))
    places, along = (np.concatenate(one, axis=-1) for one in zip(*found, strict=True))
    ground = pieces[0]
    if floor:
        paint = _count_per_cell(places, ground.shape, small.shape)
        ground = floor_mask(pieces, paint * (_WORKING_WIDTH_PX / small.shape[1]))
        column, row = np.rint(places).astype(np.intp)
        kept = _search_mask(ground, small.shape)[row, column]
        places, along = places[:, kept], along[kept]
    whole = cv2.resize(ground, small.shape[1::-1], interpolation=cv2.INTER_NEAREST)
    inner = cv2.erode(whole, np.ones((2 * _MASK_INNER_PX + 1,) * 2, np.uint8)) > 0
    column, row = np.rint(places).astype(np.intp)
    return LinePixels(
        (width, height), (places + 0.5) * shrink - 0.5, along, inner[row, column], ground
    )


def _linked_ridges(
    grey: Values, where: BoolArray, signs: Sequence[int]
) -> tuple[FloatArray, FloatArray]:
    """(2, n) px on the middle of ridges that go on, and (n,) rad their directions."""
    part, corner = _search_window(where)
    grained = len(signs) > 1
    found = [_ridges(grey[part] * np.float32(sign), where[part], grained) for sign in signs]
    places, along = (np.concatenate(one, axis=-1) for one in zip(*found, strict=True))
    places = places + corner
    kept = _is_continued(places, along, grey.shape)
    return places[:, kept], along[kept]


def _wide_ridges(
    grey: Values, where: BoolArray, signs: Sequence[int]
) -> tuple[FloatArray, FloatArray]:
    """The same of ridges so wide that they show in a smaller picture only."""
    size = (grey.shape[1] // _WIDE_LINE_REDUCTION, grey.shape[0] // _WIDE_LINE_REDUCTION)
    small = np.asarray(cv2.resize(grey, size, interpolation=cv2.INTER_AREA), dtype=np.float32)
    there = cv2.resize(where.astype(np.uint8), size, interpolation=cv2.INTER_NEAREST) > 0
    places, along = _linked_ridges(small, _without_border(there), signs)
    scale = np.array([[grey.shape[1] / size[0]], [grey.shape[0] / size[1]]])
    return (places + 0.5) * scale - 0.5, along


def _linked_edges(
    picture: PixelArray, pieces: Sequence[Mask], where: BoolArray
) -> tuple[FloatArray, FloatArray]:
    """The same of edges between two pieces of a floor: as far from them as lines are from their
    flanks, each side has one piece's colour."""
    small = mask_scale_image(picture)
    colour = cv2.GaussianBlur(picture.astype(np.float32), (0, 0), _RIDGE_SIGMAS_PX[0])
    x, y = (cv2.Sobel(colour, cv2.CV_32F, *way, ksize=3, scale=1 / 8) for way in ((1, 0), (0, 1)))
    ones = np.ones((1, 3), dtype=np.float32)
    xx, yy, xy = (cv2.transform(cv2.multiply(*two), ones) for two in ((x, x), (y, y), (x, y)))
    strength = cv2.sqrt(cv2.add(xx, yy))
    # A blurred step is as steep in its middle.
    steepest = _MIN_EDGE_STEP / (np.sqrt(2 * np.pi) * _RIDGE_SIGMAS_PX[0])
    rows, columns = np.nonzero((strength > steepest) & where)
    across = 0.5 * np.arctan2(2 * xy[rows, columns], (xx - yy)[rows, columns])
    way = np.stack([np.cos(across), np.sin(across)])
    step = np.rint(way).astype(np.intp)
    here, after, before = (
        strength[rows + side * step[1], columns + side * step[0]] for side in (0, 1, -1)
    )
    middle = (here >= after) & (here > before)
    places, way = np.stack([columns, rows])[:, middle].astype(np.float64), way[:, middle]
    usual = [_chromaticity(np.median(small[piece > 0], axis=0)) for piece in pieces]
    sides = []
    for sign in (1, -1):
        near, far = (_at(colour, places + sign * away * way) for away in _FLANK_DISTANCES_PX)
        sides.append((near, far, np.array([_is_alike(_chromaticity(near), one) for one in usual])))
    (near, far, own), (other_near, other_far, other) = sides
    apart = np.linalg.norm(near - other_near, axis=1)
    uneven = [
        np.linalg.norm(one - two, axis=1) for one, two in ((near, far), (other_near, other_far))
    ]
    kept = ((own & ~other).any(axis=0) & (other & ~own).any(axis=0)) & (apart > _MIN_EDGE_STEP)
    kept &= np.maximum(*uneven) < _CONTRAST_SHARE * apart
    places = places[:, kept]
    along = np.mod(np.arctan2(way[1], way[0])[kept] + np.pi / 2, np.pi)
    linked = _is_continued(places, along, picture.shape[:2])
    return places[:, linked], along[linked]


def _at(values: NDArray[Any], places: FloatArray) -> NDArray[Any]:
    """Values of a picture at places (2, n), the nearest inside it."""
    column, row = np.rint(places).astype(np.intp)
    return np.asarray(values[row.clip(0, len(values) - 1), column.clip(0, values.shape[1] - 1)])


def _search_mask(ground: NDArray[np.uint8], shape: tuple[int, ...]) -> BoolArray:
    """Return where paint is looked for: on the ground and at its rim, not at the picture's
    border."""
    wide = cv2.resize(ground, shape[1::-1], interpolation=cv2.INTER_NEAREST)
    beside = cv2.dilate(wide, np.ones((2 * _MASK_MARGIN_PX + 1,) * 2, np.uint8)) > 0
    return _without_border(beside)


def _without_border(where: Any) -> BoolArray:
    inside = np.zeros_like(where)
    inner = slice(_IMAGE_BORDER_PX, -_IMAGE_BORDER_PX)
    inside[inner, inner] = where[inner, inner]
    return np.asarray(inside)


def _count_per_cell(places: FloatArray, cells: tuple[int, ...], shape: tuple[int, ...]) -> IntArray:
    """(h, 320) how many places (2, n) lie in each cell."""
    column, row = (
        (places[axis] * cells[1 - axis] / shape[1 - axis]).astype(np.intp) for axis in (0, 1)
    )
    counts = np.bincount(row * cells[1] + column, minlength=cells[0] * cells[1])
    return counts.reshape(cells)


def _search_window(where: BoolArray) -> tuple[tuple[slice, slice], FloatArray]:
    """The part of a picture that is examined, with what the filters need next to it; and (2, 1) px
    from the picture's corner to that of the part."""
    rows, columns = (np.flatnonzero(where.any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return (slice(0, 1), slice(0, 1)), np.zeros((2, 1))
    begins = [max(int(one[0]) - _FILTER_MARGIN_PX, 0) for one in (rows, columns)]
    ends = [int(one[-1]) + _FILTER_MARGIN_PX + 1 for one in (rows, columns)]
    part = slice(begins[0], ends[0]), slice(begins[1], ends[1])
    return part, np.array([[begins[1]], [begins[0]]], dtype=np.float64)


def _ridges(grey: Values, where: BoolArray, grained: bool) -> tuple[FloatArray, FloatArray]:
    """(2, n) px on the middle of light ridges, and (n,) rad their directions; those that stand out
    of what is around them, where there may be a grain."""
    strength, directed = _ridge_curvature(grey)
    least: Any = _MIN_RIDGE_RESPONSE
    if grained:
        usual = (
            cv2.blur(np.sqrt(np.maximum(strength, 0)), (_TEXTURE_WINDOW_PX, _TEXTURE_WINDOW_PX))
            ** 2
        )
        least = np.maximum(_MIN_TEXTURE_RATIO * usual, _MIN_RIDGE_RESPONSE)
    rows, columns = np.nonzero((strength > least) & where)
    apart, mixed = directed(rows, columns)
    along = 0.5 * np.arctan2(mixed, apart)
    across = np.stack([-np.sin(along), np.cos(along)])
    step = np.rint(across).astype(np.intp)
    here = strength[rows, columns]
    after = strength[rows + step[1], columns + step[0]]
    before = strength[rows - step[1], columns - step[0]]
    # Thinned: a middle is stronger than what is to either side; to parts of a px by a parabola.
    middle = (here >= after) & (here > before)
    off = np.clip(0.5 * (after - before) / (2 * here - after - before + 1e-6), -0.6, 0.6)
    places = np.stack([columns, rows]) + off * step
    places, along, across = places[:, middle], along[middle], across[:, middle]
    smooth = np.asarray(cv2.GaussianBlur(grey, (0, 0), 1.0), dtype=np.float32)
    contrast = _ridge_contrast(smooth, places, across)
    kept = contrast > np.maximum(_MIN_CONTRAST, _CONTRAST_SHARE * here[middle])
    return places[:, kept], np.mod(along[kept], np.pi)


def _ridge_curvature(
    grey: Values,
) -> tuple[Values, Callable[[IntArray, IntArray], tuple[Values, Values]]]:
    """Return how much a picture curves across less how much along, at the scale where that is most;
    and what says, at rows and columns, the two numbers for the direction, xx - yy and twice xy."""
    scales = []
    for sigma in _RIDGE_SIGMAS_PX:
        smooth = cv2.GaussianBlur(grey, (0, 0), sigma)
        xx, yy, xy = (
            cv2.Sobel(smooth, cv2.CV_32F, *order, ksize=3, scale=times * sigma**2 / 4)
            for order, times in (((2, 0), 1), ((0, 2), 1), ((1, 1), 2))
        )
        apart = cv2.subtract(xx, yy)
        # Less one curvature than the other, or than nothing where the other is no hollow's.
        strength = cv2.min(-cv2.add(xx, yy), cv2.magnitude(apart, xy))
        scales.append((np.asarray(strength, dtype=np.float32), apart, xy))
    (fine, *_), (wide, *_) = scales

    def directed(rows: IntArray, columns: IntArray) -> tuple[Values, Values]:
        wider = wide[rows, columns] > fine[rows, columns]
        apart, xy = (
            np.where(wider, scales[1][i][rows, columns], scales[0][i][rows, columns])
            for i in (1, 2)
        )
        return apart, xy

    return np.maximum(fine, wide), directed


def _ridge_contrast(grey: Values, places: FloatArray, across: FloatArray) -> FloatArray:
    """(n,) grey levels that places are lighter than the lighter of their sides."""
    sides = [
        np.maximum(_at(grey, places + off * across), _at(grey, places - off * across))
        for off in _FLANK_DISTANCES_PX
    ]
    return np.asarray(_at(grey, places) - np.minimum(*sides))


def _is_continued(places: FloatArray, along: FloatArray, shape: tuple[int, ...]) -> BoolArray:
    """(n,) whether others of like direction continue a ridge, to one side at least."""
    height, width = shape
    columns, rows = np.rint(places).astype(np.intp)
    direction = np.stack([np.cos(2 * along), np.sin(2 * along)]).astype(np.float32)
    field = np.zeros((2, height, width), dtype=np.float32)
    for dy, dx in ((-1, -1), (-1, 1), (1, -1), (1, 1), (-1, 0), (1, 0), (0, -1), (0, 1), (0, 0)):
        row, column = (rows + dy).clip(0, height - 1), (columns + dx).clip(0, width - 1)
        field[:, row, column] = direction
    steps = np.arange(_CONTINUATION_STEP_PX, _CONTINUATION_PX + 1, _CONTINUATION_STEP_PX)
    cosine, sine = np.cos(along)[:, None], np.sin(along)[:, None]
    most = np.zeros(len(along), dtype=np.intp)
    for way in (1, -1):
        for bend in _CONTINUATION_CURVATURES:
            ahead, aside = way * steps, way * bend * steps**2
            x = np.rint(places[0][:, None] + ahead * cosine - aside * sine).astype(np.intp)
            y = np.rint(places[1][:, None] + ahead * sine + aside * cosine).astype(np.intp)
            inside = (x >= 0) & (x < width) & (y >= 0) & (y < height)
            x, y = x.clip(0, width - 1), y.clip(0, height - 1)
            like = field[0, y, x] * direction[0][:, None] + field[1, y, x] * direction[1][:, None]
            most = np.maximum(most, ((like > _SAME_DIRECTION_COSINE) & inside).sum(axis=1))
    return np.asarray(most >= _MIN_SHARE * len(steps))
