"""Distance maps to line pixels, and ICP between field lines and line pixels for many cameras."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.camera_parameters import FREE_PARAMETERS, Z
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.initialization import (
    camera_sides,
    side_costs,
    wide_prior,
)
from procc_annotator.calibration.optimization.observations import (
    HALF_WIDTH_PX,
    REFERENCE_WIDTH,
    ImageFrame,
)
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.calibration.optimization.solver import GaussianPrior
from procc_annotator.calibration.single_image.field_points import (
    FieldLinePoints,
    is_off_ground,
    visible_line_points,
)
from procc_annotator.field.model import ANY, DARKER, LIGHTER, LINE, Field
from procc_annotator.image.line_pixels import detect_line_pixels
from procc_annotator.image.pixels import PixelArray

DIRECTION_COUNT = 12
SAME_DIRECTION_RAD = np.radians(20.0)  # directions that may be those of one line
_NO_LINE_DISTANCE_PX = 1e3
_MAP_CELL_PX = 2
_MAX_FLOOR_M = 31.0  # half a length; an NHL rink is 61 m long. What is larger is grass
_WIDE_LINE_M = 0.25  # of lines such as the blue ones of ice hockey


@dataclass(frozen=True, eq=False)
class ImageLinePixels:
    """N places of paint, solver px.

    Attributes:
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

    def thinned(self, count: int) -> ImageLinePixels:
        """At most so many of the places on the ground, without what is around them."""
        some = self.some(count)
        return replace(
            self,
            points=self.points[:, some],
            along=self.along[some],
            on_ground=np.arange(len(some)),
            ground=np.zeros((1, 1), np.uint8),
        )


def line_pixels_for_field(picture: PixelArray, field: Field) -> ImageLinePixels:
    """The paint of a picture (H, W, 4) BGRA, of the tones a field's lines have."""
    lines = [e.appearance for e in field.elements if e.appearance.kind == LINE]
    tones = {line.tone for line in lines}
    wide = any(line.width_m >= _WIDE_LINE_M for line in lines)
    light, dark = bool(tones & {LIGHTER, ANY}), bool(tones & {DARKER, ANY})
    floor = camera_placement_prior(field).half_length <= _MAX_FLOOR_M
    found = detect_line_pixels(
        picture, light=light, dark=dark, floor=floor, wide=wide, edges=ANY in tones
    )
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
        """(B,) share of cells (B, K), flat, of the maps where lines are, that have a line of a like
        direction in them or next to them."""
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


_MIN_DEPTH_M, _VIEW_MARGIN_PX = 1.0, 2.0
_FIELD_MARGIN_M = 1.0  # about the field: lines have a width, and touchlines are not where files say
_BEAM_RADIUS_PX = 20.0  # along the line, from paint to the place that is nearest to it


@dataclass(frozen=True, eq=False)
class Correspondences:
    """K pulls on each of B cameras.

    Attributes:
        off: (B, K) solver px across the line, from where the camera shows it to the paint.
        by: (B, free, K) how the place moves across with the camera's parameters.
        known: (B, K) whether there is a pull at all.
        in_view: (B, K) whether the place of a line is in the picture, or the paint on the field.
        away: (B, K) solver px to the paint in any direction.
    """

    off: FloatArray
    by: FloatArray
    known: NDArray[np.bool_]
    in_view: NDArray[np.bool_]
    away: NDArray[np.floating]


def match_lines_to_pixels(
    vectors: FloatArray,
    places: IntArray,
    lines: FieldLinePoints,
    paint: ImageLinePixels,
    free: int,
) -> Correspondences:
    """Places of lines (B, K), pulled to the nearest paint of their direction."""
    lens, near = Lens.of(vectors, paint.frame.half_diagonal), paint.near
    world, along = (one[:, places].transpose(1, 0, 2) for one in (lines.world, lines.along))
    depth = (lens.linear[:, 2:, :3] @ world)[:, 0] + lens.linear[:, 2, 3:]
    ahead = depth > _MIN_DEPTH_M
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        points, moved, derivatives = project(lens, world, along, free)
        points = np.where(ahead[:, None], points, 1e6)
        in_view = ahead & (np.abs(points[:, 0]) < HALF_WIDTH_PX - _VIEW_MARGIN_PX)
        in_view &= np.abs(points[:, 1]) < paint.half_height - _VIEW_MARGIN_PX
        normal = _unit_normals(moved)
        direction = direction_indices(np.arctan2(-normal[:, 0], normal[:, 1]))
    column, row = map_cells(points, paint.half_height, near.cell)
    if len(lines.beams):
        # What stands before boards or a crowd is not looked for there.
        in_view &= ~is_off_ground(world) | paint.over_ground(points)
    found = near.place[direction, row, column]
    apart = paint.points[:, found].transpose(1, 0, 2) - points
    off = (normal * apart).sum(axis=1)
    by = np.einsum("bkn,bpkn->bpn", normal, derivatives)
    known = in_view & (found >= 0)
    return Correspondences(off, by, known, in_view, near.away[direction, row, column])


def match_pixels_to_lines(
    vectors: FloatArray, some: IntArray, lines: FieldLinePoints, paint: ImageLinePixels, free: int
) -> Correspondences:
    """Paint on the ground (n,), pulled to the nearest line; unknown where that runs another way."""
    lens = Lens.of(vectors, paint.frame.half_diagonal)
    points, direction = paint.points[:, some], paint.along[some]
    shown = lens.undistorted(points)
    ground = _ground_points(lens, shown)
    place = lines.nearest.at(ground)
    if len(lines.beams):
        place = _prefer_nearer_beam(lens, shown, direction, place, lines)
    world, along = (
        one[:, np.maximum(place, 0)].transpose(1, 0, 2) for one in (lines.world, lines.along)
    )
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        shown, moved, derivatives = project(lens, world, along, free)
        normal = _unit_normals(moved)
        apart = points - shown
        off = (normal * apart).sum(axis=1)
        beside = np.abs(normal[:, 1] * apart[:, 0] - normal[:, 0] * apart[:, 1])
        like = np.abs(normal[:, 1] * np.cos(direction) - normal[:, 0] * np.sin(direction))
        known = (place >= 0) & (like > np.cos(SAME_DIRECTION_RAD)) & (beside < _BEAM_RADIUS_PX)
        by = np.einsum("bkn,bpkn->bpn", normal, derivatives)
        half = np.array([[lines.around.half_length], [lines.around.half_width]])
        on_field = np.asarray((np.abs(ground) <= half + _FIELD_MARGIN_M).all(axis=1))
    return Correspondences(off, by, known, on_field, np.abs(off))


def _ground_points(lens: Lens, points: FloatArray) -> FloatArray:
    """(B, 2, n) metres, where cameras see points (B, 2, n), free of distortion, on the ground; NaN
    above the horizon."""
    on_ground = np.linalg.inv(lens.linear[:, :, [0, 1, 3]])
    rays = on_ground[:, :, :2] @ points + on_ground[:, :, 2:]
    return np.asarray(rays[:, :2] / np.where(rays[:, 2] > 1e-9, rays[:, 2], np.nan)[:, None])


def _prefer_nearer_beam(
    lens: Lens, points: FloatArray, direction: FloatArray, place: IntArray, lines: FieldLinePoints
) -> IntArray:
    """(B, n) the same places, or those on beams that appear nearer to points (B, 2, n) of paint
    with their directions (n,), rad."""
    shown = lens.linear[:, :, :3] @ lines.world[:, np.maximum(place, 0)].transpose(1, 0, 2)
    shown += lens.linear[:, :, 3:]
    with np.errstate(divide="ignore", invalid="ignore"):
        nearest = np.hypot(*(shown[:, :2] / shown[:, 2:] - points).transpose(1, 0, 2))
    nearest[(place < 0) | ~(shown[:, 2] > _MIN_DEPTH_M)] = np.inf
    for first, last in lines.beams:
        ends = lens.linear[:, :, :3] @ lines.world[:, [first, last]] + lens.linear[:, :, 3:]
        depth = ends[:, 2]
        # (B, 2, 1) each end; a beam that begins behind a camera is left out there.
        begin, end = (
            ends[:, :2, k, None] / np.maximum(depth[:, None, k, None], _MIN_DEPTH_M) for k in (0, 1)
        )
        way = end - begin
        length = np.hypot(way[:, 0], way[:, 1]) + 1e-9
        share = (((points - begin) * way).sum(axis=1) / length**2).clip(0, 1)
        apart = np.hypot(*(begin + share[:, None] * way - points).transpose(1, 0, 2))
        along = (way[:, 0] * np.cos(direction) + way[:, 1] * np.sin(direction)) / length
        nearer = (apart < nearest) & (np.abs(along) > np.cos(SAME_DIRECTION_RAD))
        nearer &= (depth > _MIN_DEPTH_M).all(axis=1, keepdims=True)
        share *= depth[:, :1] / (share * depth[:, :1] + (1 - share) * depth[:, 1:] + 1e-9)
        place = np.where(nearer, first + np.rint(share * (last - first)).astype(np.intp), place)
        nearest = np.where(nearer, apart, nearest)
    return place


def _unit_normals(moved: FloatArray) -> FloatArray:
    """(B, 2, n) unit vectors across those directions."""
    length = np.hypot(moved[:, 0], moved[:, 1]) + 1e-9
    return np.stack([-moved[:, 1] / length, moved[:, 0] / length], axis=1)


# How far a step may lead: rad, metres, shares.
_MAX_STEP = np.array([0.15, 0.1, 0.03, 8.0, 8.0, 5.0, 0.15, 0.05])
_MIN_HEIGHT_M = 1.0
_REACH_SCALES = 4.0  # times the scale: farther paint is another line's
_LINE_WEIGHT = 40.0  # independent places that all of a picture's paint is worth
_POINT_SCALE = 2.0  # times the scale: what a place's error is taken for
_DAMPING_FACTOR = 1.02


@dataclass(frozen=True, eq=False)
class SearchScene:
    """Inputs of a search; ``known``: where its camera stands, (1, 8) means and inverse standard
    deviations; None if it may stand anywhere."""

    lines: FieldLinePoints
    paint: ImageLinePixels
    known: GaussianPrior | None = None

    def prior(self, vectors: FloatArray, free: int) -> GaussianPrior:
        """Return where cameras (B, 11) are expected, by the side of the field each one stands
        on."""
        if self.known is not None:
            return GaussianPrior(self.known.mean[:, :free], self.known.inverse_sd[:, :free])
        return wide_prior(camera_sides(vectors, self.lines.around), self.lines.around, free)

    def unlikeliness(self, vectors: FloatArray) -> FloatArray:
        """(B,) half the squared deviations from where cameras are expected, lens left out; more on
        another side than the main camera's."""
        prior = self.prior(vectors, FREE_PARAMETERS["P"])
        off = (vectors[:, : FREE_PARAMETERS["P"]] - prior.mean) * prior.inverse_sd
        cost = np.asarray((off**2).sum(axis=1) / 2)
        if self.known is None:
            cost += side_costs(camera_sides(vectors, self.lines.around), self.lines.around)
        return cost


def refine_by_icp(
    scene: SearchScene,
    vectors: FloatArray,
    scales_px: Sequence[float],
    *,
    places: int,
    paint: int = 0,
    model: str = "P",
) -> FloatArray:
    """Lead cameras (B, 11) to the paint, one step for each scale.

    Args:
        scales_px: solver px; paint farther off counts less and less.
        places: so many on the lines of each camera.
        paint: so many places of the paint are pulled to lines as well.
        model: P or R.
    """
    free = FREE_PARAMETERS[model]
    vectors = vectors.copy()
    half_height = scene.paint.half_height
    chosen = visible_line_points(vectors, scene.lines.coarse, half_height, places).places
    some = scene.paint.some(paint)
    prior = scene.prior(vectors, free)
    mean, inverse = prior.mean, prior.inverse_sd
    diagonal = np.arange(free)
    for scale in scales_px:
        pulls = match_lines_to_pixels(vectors, chosen, scene.lines.coarse, scene.paint, free)
        normal, gradient = _normal_equations(pulls, scale)
        if len(some):
            pulls = match_pixels_to_lines(vectors, some, scene.lines, scene.paint, free)
            more = _normal_equations(pulls, scale)
            normal, gradient = normal + more[0], gradient + more[1]
        gradient -= (vectors[:, :free] - mean) * inverse**2
        normal[:, diagonal, diagonal] += inverse**2 + 1e-9
        normal[:, diagonal, diagonal] *= _DAMPING_FACTOR
        step = np.linalg.solve(normal, gradient[:, :, None])[:, :, 0]
        step /= np.maximum(np.abs(step / _MAX_STEP[:free]).max(axis=1), 1.0)[:, None]
        vectors[:, :free] += step
        vectors[:, Z] = np.minimum(vectors[:, Z], -_MIN_HEIGHT_M)
    return vectors


def _normal_equations(pulls: Correspondences, scale: float) -> tuple[FloatArray, FloatArray]:
    counted = pulls.known & (pulls.away < _REACH_SCALES * scale)
    off = np.where(counted, pulls.off, 0.0)
    weight = counted / (1 + (off / scale) ** 2) ** 2
    weight *= _LINE_WEIGHT / off.shape[1] * (_POINT_SCALE / scale) ** 2
    weighted = pulls.by * weight[:, None]
    normal = weighted @ pulls.by.transpose(0, 2, 1)
    return normal, (weighted @ off[:, :, None])[:, :, 0]


AGREEMENT_PX, AGREEMENT_POINTS = 3.0, 800  # by which a refined camera is judged


@dataclass(frozen=True, eq=False)
class ChamferAgreement:
    """Agreement of B cameras with a picture.

    Attributes:
        coverage: (B,) share of the lines in sight that lie on paint.
        explained: (B,) share of the paint on the ground that lies on lines.
        on_field: (B,) share of it that lies on lines or elsewhere on the field.
    """

    coverage: FloatArray
    explained: FloatArray
    on_field: FloatArray

    @property
    def both(self) -> FloatArray:
        """(B,) their harmonic mean: 1 only if nothing is missing on either side."""
        return np.asarray(harmonic_mean(self.coverage, self.explained))


def harmonic_mean(one: Any, other: Any) -> Any:
    """The harmonic mean of shares; 0 where both are."""
    return 2 * one * other / np.maximum(one + other, 1e-9)


def chamfer_agreement(
    scene: SearchScene, vectors: FloatArray, within_px: float, *, places: int, paint: int
) -> ChamferAgreement:
    """Judge cameras (B, 11) by so many places on lines, and of the paint."""
    chosen = visible_line_points(
        vectors, scene.lines.coarse, scene.paint.half_height, places
    ).places
    pulls = match_lines_to_pixels(vectors, chosen, scene.lines.coarse, scene.paint, 0)
    on_paint = pulls.known & (np.abs(pulls.off) < within_px) & (pulls.away < 3 * within_px)
    coverage = on_paint.sum(axis=1) / np.maximum(pulls.in_view.sum(axis=1), 1)
    return ChamferAgreement(
        coverage, *explained_shares(vectors, scene.lines, scene.paint, within_px, paint)
    )


def explained_shares(
    vectors: FloatArray,
    lines: FieldLinePoints,
    paint: ImageLinePixels,
    within_px: float,
    count: int,
) -> tuple[FloatArray, FloatArray]:
    """(B,) shares of so many places of the paint that are on lines of cameras (B, 11), and that are
    on lines or elsewhere on the field."""
    pulls = match_pixels_to_lines(vectors, paint.some(count), lines, paint, 0)
    on_line = pulls.known & (np.abs(pulls.off) < within_px)
    total = max(on_line.shape[1], 1)
    return on_line.sum(axis=1) / total, (on_line | pulls.in_view).sum(axis=1) / total


def explained_on_field(paint: ImageLinePixels, vector: FloatArray, lines: FieldLinePoints) -> float:
    """Share of the line pixels on the field that are on lines of a camera (11,)."""
    on_line, on_field = explained_shares(vector[None], lines, paint, AGREEMENT_PX, AGREEMENT_POINTS)
    return float(on_line[0] / max(on_field[0], 1e-9))
