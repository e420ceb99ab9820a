"""Distance maps to detected line pixels, by direction, and a coarse bit map of them."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.observations import (
    HALF_WIDTH_PX,
    REFERENCE_WIDTH,
    ImageFrame,
)
from procc_annotator.field.model import ANY, DARKER, LIGHTER, LINE, Field
from procc_annotator.image.line_pixels import detect_line_pixels
from procc_annotator.image.pixels import PixelArray

DIRECTION_COUNT = 12
SAME_DIRECTION_RAD = np.radians(20.0)  # directions that may be those of one line
_NO_LINE_DISTANCE_PX = 1e3
_MAP_CELL_PX = 2
_MAX_FLOOR_M = 30.0  # half a length: what is larger is of grass, and that has one colour
_WIDE_LINE_M = 0.25  # of lines such as the blue ones of ice hockey


@dataclass(frozen=True, eq=False)
class ImageLinePixels:
    """N places of paint, solver px.

    Attributes:
        frame: the picture.
        points: (2, N).
        along: (N,) rad, direction.
        on_ground: (n,) which of them lie well inside the ground.
        ground: (h, 320) 1 where the ground is.
    """

    frame: ImageFrame
    points: FloatArray
    along: FloatArray
    on_ground: IntArray
    ground: NDArray[np.uint8]

    @property
    def half_height(self) -> float:
        """Of the picture, solver px."""
        return self.frame.size[1] * self.frame.scale / 2

    def over_ground(self, points: FloatArray) -> NDArray[np.bool_]:
        """(..., 2, N) solver px -> (..., N) which lie on the ground, or outside the picture."""
        height, width = self.ground.shape
        column = (points[..., 0, :] / REFERENCE_WIDTH + 0.5) * width
        row = (points[..., 1, :] / (2 * self.half_height) + 0.5) * height
        inside = column.clip(0, width - 1).astype(np.intp), row.clip(0, height - 1).astype(np.intp)
        return np.asarray(self.ground[inside[1], inside[0]] > 0)

    @cached_property
    def near(self) -> LineDistanceMaps:
        """Its maps."""
        return LineDistanceMaps.of(self, _MAP_CELL_PX)

    def some(self, count: int) -> IntArray:
        """At most so many of the places on the ground, evenly chosen."""
        every = len(self.on_ground) / max(count, 1)
        if every <= 1:
            return self.on_ground
        return self.on_ground[(np.arange(count) * every).astype(np.intp)]


def line_pixels_for_field(picture: PixelArray, field: Field) -> ImageLinePixels:
    """The paint of a picture (H, W, 4) BGRA, of the tones a field's lines have."""
    lines = [e.appearance for e in field.elements if e.appearance.kind == LINE]
    tones = {line.tone for line in lines}
    wide = any(line.width_m >= _WIDE_LINE_M for line in lines)
    light, dark = bool(tones & {LIGHTER, ANY}), bool(tones & {DARKER, ANY})
    floor = camera_placement_prior(field).half_length <= _MAX_FLOOR_M
    found = detect_line_pixels(picture, light=light, dark=dark, floor=floor, wide=wide)
    frame = ImageFrame(found.size)
    points = (found.points - np.array(frame.centre_px)[:, None]) * frame.scale
    return ImageLinePixels(
        frame, points, found.along, np.flatnonzero(found.on_ground), found.ground
    )


@dataclass(frozen=True, eq=False)
class LineDistanceMaps:
    """For each of some directions and each cell of the picture the nearest paint that runs so.

    Attributes:
        cell: solver px.
        away: (DIRECTIONS, h, w) solver px to it.
        place: (DIRECTIONS, h, w) index of that place; -1 where nothing runs so.
    """

    cell: int
    away: NDArray[np.float32]
    place: NDArray[np.int32]

    @classmethod
    def of(cls, paint: ImageLinePixels, cell: int) -> LineDistanceMaps:
        """Maps with cells of so many solver px."""
        height, width = map_shape(paint.half_height, cell)
        column, row = map_cells(paint.points, paint.half_height, cell)
        away = np.full((DIRECTION_COUNT, height, width), _NO_LINE_DISTANCE_PX, dtype=np.float32)
        place = np.full((DIRECTION_COUNT, height, width), -1, dtype=np.int32)
        for direction in range(DIRECTION_COUNT):
            turn = paint.along - direction * np.pi / DIRECTION_COUNT
            turn = np.abs(np.mod(turn + np.pi / 2, np.pi) - np.pi / 2)
            own = np.flatnonzero(turn < SAME_DIRECTION_RAD)
            if not len(own):
                continue
            free = np.ones((height, width), dtype=np.uint8)
            free[row[own], column[own]] = 0
            far, labels = cv2.distanceTransformWithLabels(
                free, cv2.DIST_L2, 3, labelType=cv2.DIST_LABEL_PIXEL
            )
            of_label = np.zeros(int(labels.max()) + 1, dtype=np.int32)
            of_label[labels[row[own], column[own]]] = own
            away[direction], place[direction] = far * cell, of_label[labels]
        return cls(cell, away, place)

    def coarser(self, times: int) -> LineDistanceMaps:
        """Maps with cells so many times as large."""
        every = np.s_[:, ::times, ::times]
        return LineDistanceMaps(self.cell * times, self.away[every], self.place[every])


def map_shape(half_height: float, cell: int) -> tuple[int, int]:
    """(rows, columns) of maps whose cells have so many solver px."""
    return int(np.ceil(2 * half_height / cell)), REFERENCE_WIDTH // cell


def map_cells(points: FloatArray, half_height: float, cell: int) -> tuple[IntArray, IntArray]:
    """Column and row of points (..., 2, N), solver px; the nearest inside the picture."""
    rows, columns = map_shape(half_height, cell)
    column = ((points[..., 0, :] + HALF_WIDTH_PX) / cell).clip(0, columns - 1)
    row = ((points[..., 1, :] + half_height) / cell).clip(0, rows - 1)
    return column.astype(np.intp), row.astype(np.intp)


def direction_indices(angles: FloatArray) -> IntArray:
    """Which of the directions of the maps angles (rad) are."""
    return np.mod(np.rint(angles * (DIRECTION_COUNT / np.pi)).astype(np.intp), DIRECTION_COUNT)


_CELLS_ACROSS = (
    10  # cells of the maps of paint, to a side of a large one: 24 columns fit in 32 bits
)
_DIRECTION_BINS = 6  # directions that are told apart
_MIN_PIXELS_PER_CELL = 6  # places of paint, for a large cell to have some

BitArray = NDArray[np.uint32]


@dataclass(frozen=True, eq=False)
class CoarseLineGrid:
    """Which large cells have paint.

    Attributes:
        rows: (directions, rows) a bit a column.
        cell: solver px of the maps' cells that large ones consist of.
        half_height: of the picture, solver px.
    """

    rows: BitArray
    cell: int
    half_height: float

    @classmethod
    def of(cls, paint: ImageLinePixels, cell: int) -> CoarseLineGrid:
        """Of the paint on the ground."""
        height, width = (-(-n // _CELLS_ACROSS) for n in map_shape(paint.half_height, cell))
        column, row = map_cells(paint.points[:, paint.on_ground], paint.half_height, cell)
        turn = direction_indices(paint.along[paint.on_ground]) * _DIRECTION_BINS // DIRECTION_COUNT
        count = np.zeros((_DIRECTION_BINS, height, width), dtype=np.intp)
        np.add.at(count, (turn, row // _CELLS_ACROSS, column // _CELLS_ACROSS), 1)
        bits = np.left_shift(1, np.arange(width, dtype=np.uint32), dtype=np.uint32)
        rows = ((count >= _MIN_PIXELS_PER_CELL) * bits).sum(axis=2, dtype=np.uint32)
        return cls(rows, cell, paint.half_height)

    def explained(self, cells: NDArray[np.int32]) -> NDArray[np.float64]:
        """(B,) share of its cells that have a line of a like direction in them or next to them.

        Args:
            cells: (B, K) of the maps where lines are, flat.
        """
        height, width = map_shape(self.half_height, self.cell)
        place = cells % (height * width)
        row, column = place // width // _CELLS_ACROSS, place % width // _CELLS_ACROSS
        turn = cells // (height * width) * _DIRECTION_BINS // DIRECTION_COUNT
        lines = np.zeros((len(cells), *self.rows.shape), dtype=np.uint32)
        which = (np.arange(len(cells))[:, None] * _DIRECTION_BINS + turn) * self.rows.shape[1] + row
        bits = np.left_shift(1, column.astype(np.uint32), dtype=np.uint32)
        np.bitwise_or.at(lines.reshape(-1), which.ravel(), bits.ravel())
        found = np.bitwise_count(_dilate_cells(lines) & self.rows).sum(axis=(1, 2), dtype=np.intp)
        total = int(np.bitwise_count(self.rows).sum())
        return np.asarray(found / max(total, 1))


def _dilate_cells(lines: BitArray) -> BitArray:
    """With the cells next to, above and below, and of the next directions."""
    lines = lines | lines << np.uint32(1) | lines >> np.uint32(1)
    tall = lines.copy()
    tall[:, :, 1:] |= lines[:, :, :-1]
    tall[:, :, :-1] |= lines[:, :, 1:]
    return np.asarray(tall | np.roll(tall, 1, axis=1) | np.roll(tall, -1, axis=1))
