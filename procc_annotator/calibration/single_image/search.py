"""Camera hypotheses for an image: chamfer scoring, then staged refinement of the best."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.camera_parameters import (
    LOG_FOCAL,
    PAN,
    PARAMETERS,
    POSITION_SLICE,
    TILT,
    Z,
    rotation_matrices,
)
from procc_annotator.calibration.optimization.camera_placement import CameraPlacementPrior
from procc_annotator.calibration.optimization.initialization import SIDES
from procc_annotator.calibration.optimization.observations import REFERENCE_WIDTH
from procc_annotator.calibration.single_image.array_cache import Arrays, cached_arrays
from procc_annotator.calibration.single_image.field_points import (
    FieldLinePoints,
    view_distance_px,
    visible_line_points,
)
from procc_annotator.calibration.single_image.icp_refinement import (
    CoarseLineGrid,
    ImageLinePixels,
    LineDistanceMaps,
    SearchScene,
    chamfer_agreement,
    direction_indices,
    map_cells,
    map_shape,
    refine_by_icp,
)

DISTANCE_CELL_PX = 4
_POINTS_PER_CAMERA = 48  # of the lines, a camera
_GRID_STEP_PX = 48.0  # between the places neighbouring cameras look at
_MIN_VISIBLE_LENGTH_PX = 350.0
# Widths of the view where the usual camera sees the field's centre, of half the field's length.
_VIEW_WIDTHS = np.geomspace(0.34, 1.9, 9)
# Places along a long side and an end, of half its length; the middle one is the usual one.
_POSITIONS_ALONG, _POSITIONS_ALONG_END = (-0.5, -0.25, 0.0, 0.25, 0.5), (-0.4, 0.0, 0.4)
_HEIGHT_COUNT, _HEIGHT_FACTOR = 6, 1.15
_NEAREST_VIEW, _FARTHEST_VIEW = 0.75, 1.5  # of the usual distance from the side
# A place of a line counts 1 so near to paint, less beyond, and against the camera farther off.
_MATCH_DISTANCE_PX, _MISMATCH_DISTANCE_PX, _MISMATCH_WEIGHT = 12.0, 45.0, 0.5
_BORDER_CELLS = 5
_BATCH_CAMERAS = 8000
_GRID_BATCH = 500  # cameras whose grids stay in the processor's cache: 19 instead of 47 ms
_PRESELECTED = 12000  # so many of the best are looked at from the paint, too
# Of cameras from a file, which are computed anew; the share of their cells that has to be the same:
# rounding may differ with the number of cameras computed at once.
_CHECKED_EVERY, _SAME_CELLS = 997, 0.999


@dataclass(frozen=True, eq=False)
class CameraHypotheses:
    """B cameras of one shape of picture.

    Attributes:
        vectors: (B, 11) parameters.
        cells: (B, K) in the maps of paint, flat.
        length_px: (B,) of their lines in sight, solver px.
    """

    vectors: FloatArray
    cells: NDArray[np.int32]
    length_px: FloatArray

    def best(self, paint: ImageLinePixels, most: int) -> FloatArray:
        """(b, 11) so many at most that suit the paint best.

        Those with most of their lines on paint are also asked how much of the paint they explain.
        """
        near = paint.near.coarser(DISTANCE_CELL_PX // paint.near.cell)
        on_paint = self._on_paint(near, paint)
        some = _top_indices(on_paint, _PRESELECTED)
        grid = CoarseLineGrid.of(paint, DISTANCE_CELL_PX)
        parts = np.split(some, range(_GRID_BATCH, len(some), _GRID_BATCH))
        explained = np.concatenate([grid.explained(self.cells[part]) for part in parts])
        return self.vectors[some[_top_indices(on_paint[some] * explained, most)]]

    def _on_paint(self, near: LineDistanceMaps, paint: ImageLinePixels) -> FloatArray:
        """(B,) share of lines on paint, less that next to it; more where more is in sight."""
        shape = near.away.shape[1:]
        value = np.clip(
            (_MISMATCH_DISTANCE_PX - near.away) / (_MISMATCH_DISTANCE_PX - _MATCH_DISTANCE_PX), 0, 1
        )
        value = value * (1 + _MISMATCH_WEIGHT) - _MISMATCH_WEIGHT
        ground = cv2.resize(paint.ground, shape[::-1], interpolation=cv2.INTER_NEAREST)
        rim = cv2.dilate(ground, np.ones((_BORDER_CELLS, _BORDER_CELLS), np.uint8)) > 0
        table = np.rint(np.where(rim, value, -_MISMATCH_WEIGHT) * 100).astype(np.int8).ravel()
        found = [
            table.take(self.cells[first : first + _BATCH_CAMERAS]).sum(axis=1, dtype=np.int32)
            for first in range(0, len(self.cells), _BATCH_CAMERAS)
        ]
        return np.asarray(np.concatenate(found) * np.sqrt(self.length_px))


def _top_indices(scores: FloatArray, most: int) -> IntArray:
    count = min(most, len(scores))
    return np.argpartition(-scores, count - 1)[:count]


@lru_cache(maxsize=4)  # 35 MB each
def hypotheses_on_side(lines: FieldLinePoints, half_height: float, side: int) -> CameraHypotheses:
    """Cameras wherever the field's file says that they stand on a side of the field: an index in
    `SIDES`, not above. Half the picture's height in solver px."""
    places, field = _positions_on_side(lines.around, side), lines.coarsest
    sizes = lines.around.half_length, lines.around.half_width
    columns = [PAN, TILT, *range(POSITION_SLICE.start, POSITION_SLICE.stop), LOG_FOCAL]

    def compute() -> Arrays:
        found = _hypotheses_from(places, lines, half_height)
        return found.vectors[:, columns], found.cells, found.length_px

    def is_valid(kept: Arrays) -> bool:
        """Check some cameras: what computes them may have changed within a version."""
        some = _hypotheses_at(_full_vectors(kept[0][::_CHECKED_EVERY]), lines, half_height)
        return len(some.cells) == len(kept[1][::_CHECKED_EVERY]) and bool(
            (some.cells == kept[1][::_CHECKED_EVERY]).mean() > _SAME_CELLS
        )

    def _full_vectors(few: FloatArray) -> FloatArray:
        vectors = np.zeros((len(few), len(PARAMETERS)))
        vectors[:, columns] = few
        return vectors

    key = (
        places,
        sizes,
        _VIEW_WIDTHS,
        _GRID_STEP_PX,
        half_height,
        field.world,
        field.along,
        field.step,
    )
    few, cells, length = cached_arrays("cameras", key, compute, is_valid)
    return CameraHypotheses(_full_vectors(few), cells, length)


@lru_cache(maxsize=16)
def hypotheses_at_positions(
    lines: FieldLinePoints, half_height: float, places: tuple[tuple[float, float, float], ...]
) -> CameraHypotheses:
    """Cameras at places (metres) where they are known to stand."""
    return _hypotheses_from(np.array(places), lines, half_height)


def _hypotheses_from(
    places: FloatArray, lines: FieldLinePoints, half_height: float
) -> CameraHypotheses:
    # One place after the other: all at once would take ten times the memory.
    found = [
        _hypotheses_at(_cameras_at_position(place, lines.around, half_height), lines, half_height)
        for place in places
    ]
    return CameraHypotheses(
        np.concatenate([one.vectors for one in found]),
        np.concatenate([one.cells for one in found]),
        np.concatenate([one.length_px for one in found]),
    )


def _hypotheses_at(
    vectors: FloatArray, lines: FieldLinePoints, half_height: float
) -> CameraHypotheses:
    """The cameras (B, 11) that have enough lines in sight."""
    shown = visible_line_points(vectors, lines.coarsest, half_height, _POINTS_PER_CAMERA)
    kept = shown.length_px > _MIN_VISIBLE_LENGTH_PX
    column, row = map_cells(shown.points[kept], half_height, DISTANCE_CELL_PX)
    height, width = map_shape(half_height, DISTANCE_CELL_PX)
    cells = (direction_indices(shown.angles[kept]) * height + row) * width + column
    return CameraHypotheses(vectors[kept], cells.astype(np.int32), shown.length_px[kept])


def _positions_on_side(around: CameraPlacementPrior, side: int) -> FloatArray:
    """(P, 3) metres, on one side."""
    name = SIDES[side]
    sign = 1.0 if name in ("near", "right") else -1.0
    at_end = name in ("left", "right")
    outer, beside = around.half_width, around.half_length
    if at_end:
        outer, beside = beside, outer
    found = []
    low, _, high = around.height
    steepest = math.atan2(high, outer + 0.6 * around.distance[1])
    for along in _POSITIONS_ALONG_END if at_end else _POSITIONS_ALONG:
        for share in (1.0,) if along else (_NEAREST_VIEW, _FARTHEST_VIEW):
            reach = outer + share * around.distance[1]
            for angle in np.geomspace(math.atan2(low, reach), steepest, _HEIGHT_COUNT):
                height = reach * math.tan(angle)
                if height <= _HEIGHT_FACTOR * high:
                    place = (along * beside, sign * reach)
                    found.append((*(place[::-1] if at_end else place), -height))
    return np.array(found)


def _cameras_at_position(
    place: FloatArray, around: CameraPlacementPrior, half_height: float
) -> FloatArray:
    """(B, 11) cameras at a place (3,) that look at all of the field, with all focal lengths."""
    corners = np.array([(x, y) for x in (-1, 1) for y in (-1, 1)], dtype=float)
    toward = corners * (around.half_length, around.half_width) - place[:2]
    middle = math.atan2(-place[0], place[1])
    turns = np.arctan2(toward[:, 0], -toward[:, 1]) - middle
    pans = middle + np.mod(turns + math.pi, 2 * math.pi) - math.pi
    downs = np.arctan2(-place[2], np.hypot(*toward.T))
    found = []
    for width in _VIEW_WIDTHS * around.half_length:
        focal = REFERENCE_WIDTH * float(np.linalg.norm(place)) / width
        step = _GRID_STEP_PX / focal
        pan, down = (
            one.ravel()
            for one in np.meshgrid(
                np.arange(pans.min(), pans.max() + step, step),
                np.arange(downs.min() - 0.3 * half_height / focal, downs.max() + step, step),
            )
        )
        away = -place[2] / np.tan(np.maximum(down, 1e-3))
        x, y = place[0] + away * np.sin(pan), place[1] - away * np.cos(pan)
        # What looks past the field shows little of it.
        kept = (np.abs(x) < 1.02 * around.half_length) & (np.abs(y) < 1.15 * around.half_width)
        vectors = np.zeros((int(kept.sum()), len(PARAMETERS)))
        vectors[:, PAN], vectors[:, TILT] = pan[kept], math.pi / 2 - down[kept]
        vectors[:, POSITION_SLICE], vectors[:, LOG_FOCAL] = place, math.log(focal)
        found.append(vectors)
    return np.concatenate(found)


@dataclass(frozen=True)
class SearchStage:
    """One round: those that are left climb, and the best of them go on.

    Attributes:
        within_px: what counts as on paint, to judge them.
        judged: how many places on lines, and of the paint, judge them.
        unlikely: what unlikeliness costs.
        kept: how many go on.
        apart_px: so far apart at least; 0 for any.
        model: P or R.
        rounds: how often the places in sight are chosen anew.
        away: shares of their distance from what they look at where they are tried as well, zoomed
            as much: that shows nearly the same, and steps hardly lead there.
    """

    scales_px: Sequence[float]
    places: int
    paint: int
    within_px: float
    judged: tuple[int, int]
    unlikely: float
    kept: int
    apart_px: float = 0.0
    model: str = "P"
    rounds: int = 1
    away: tuple[float, ...] = ()


_MIN_DOWNWARD_TILT = 0.03  # of a direction: what looks at the horizon looks so far
_CANCEL_CHECK_INTERVAL = 4  # of so many at most one goes on
SEARCH_STAGES = (
    SearchStage((30, 24, 16, 14), 48, 0, 8.0, (80, 150), 0.02, 70),
    SearchStage((20, 16, 12, 10), 64, 100, 5.0, (120, 300), 0.01, 16, 6.0, "P", 2, (0.7, 1.35)),
    SearchStage((12, 8, 6, 4), 120, 150, 3.0, (240, 800), 0.005, 12, 12.0, "R", 4, (0.85, 1.2)),
)
# From four times as many starts, where none of the usual ones led to a camera that is likely right.
SEARCH_STAGES_WIDE = (replace(SEARCH_STAGES[0], kept=140), *SEARCH_STAGES[1:])
# Where the position is known, few cameras are left that differ.
SEARCH_STAGES_KNOWN = (
    SearchStage((30, 24, 16), 48, 0, 8.0, (80, 150), 0.02, 40),
    SearchStage((16, 12, 10, 8), 64, 100, 5.0, (120, 300), 0.01, 10, 6.0),
    SearchStage((7, 6, 5, 4), 120, 150, 3.0, (240, 800), 0.005, 3, 12.0, "R", 2),
)


@dataclass(frozen=True, eq=False)
class RankedCameras:
    """The cameras that were found, the best first.

    Attributes:
        vectors: (B, 11).
        scores: (B,) agreement less what their unlikeliness costs.
        ends: (E, 11) where all starts of the last stage ended, these cameras among them.
    """

    vectors: FloatArray
    scores: FloatArray
    ends: FloatArray

    def chosen(self, rows: IntArray) -> RankedCameras:
        """Some of them."""
        return RankedCameras(self.vectors[rows], self.scores[rows], self.ends)


def search_cameras(
    scene: SearchScene,
    hypotheses: Sequence[tuple[CameraHypotheses, int]],
    go_on: Callable[[], None],
    stages: Sequence[SearchStage] = SEARCH_STAGES,
) -> RankedCameras:
    """The best cameras of all hypotheses, led to the paint; so many of each kind climb."""
    vectors = np.concatenate([some.best(scene.paint, most) for some, most in hypotheses])
    for stage in stages:
        go_on()
        found = _search_round(scene, vectors, stage)
        vectors = found.vectors
    return found


def _search_round(scene: SearchScene, vectors: FloatArray, stage: SearchStage) -> RankedCameras:
    vectors = np.concatenate([vectors, *(_dolly_zoom(vectors, share) for share in stage.away)])
    for _ in range(stage.rounds):
        vectors = _refined(scene, vectors, stage)
    found = rank_cameras(scene, vectors, stage)
    order = np.argsort(-found.scores, kind="stable")
    most = min(stage.kept, max(len(order) // _CANCEL_CHECK_INTERVAL, 1))
    if not stage.apart_px:
        return found.chosen(order[:most])
    return found.chosen(_distinct_cameras(scene, vectors, order, stage.apart_px, most))


def _refined(scene: SearchScene, vectors: FloatArray, stage: SearchStage) -> FloatArray:
    return refine_by_icp(
        scene,
        vectors,
        stage.scales_px,
        places=stage.places,
        paint=stage.paint,
        model=stage.model,
    )


def _dolly_zoom(vectors: FloatArray, share: float) -> FloatArray:
    """Cameras (B, 11) at so many times their distance from what they look at, zoomed as much."""
    ahead = rotation_matrices(vectors)[:, 2]
    distance = -vectors[:, Z] / np.maximum(ahead[:, 2], _MIN_DOWNWARD_TILT)
    moved = vectors.copy()
    moved[:, POSITION_SLICE] += (1 - share) * distance[:, None] * ahead
    moved[:, LOG_FOCAL] += np.log(share)
    return moved


def rank_cameras(
    scene: SearchScene, vectors: FloatArray, stage: SearchStage = SEARCH_STAGES[-1]
) -> RankedCameras:
    """Cameras (B, 11) with what they are worth, in their order."""
    found = chamfer_agreement(
        scene, vectors, stage.within_px, places=stage.judged[0], paint=stage.judged[1]
    )
    scores = found.both - stage.unlikely * scene.unlikeliness(vectors)
    return RankedCameras(vectors, scores, vectors)


def with_hypothesis(scene: SearchScene, found: RankedCameras, vector: FloatArray) -> RankedCameras:
    """The cameras that were found and one (11,) more, led to the paint like them."""
    vectors = vector[None]
    for stage in SEARCH_STAGES_KNOWN:
        vectors = _refined(scene, vectors, stage)
    more = rank_cameras(scene, vectors)
    scores = np.concatenate([found.scores, more.scores])
    every = RankedCameras(np.concatenate([found.vectors, vectors]), scores, found.ends)
    return every.chosen(np.argsort(-scores, kind="stable"))


def _distinct_cameras(
    scene: SearchScene, vectors: FloatArray, order: IntArray, apart: float, most: int
) -> IntArray:
    """The first ones that show lines so many solver px from where those before them do."""
    kept: list[int] = []
    while len(order) and len(kept) < most:
        kept.append(int(order[0]))
        away = view_distance_px(
            vectors[order[0]], vectors[order], scene.lines, scene.paint.half_height
        )
        order = order[1:][away[1:] > apart]
    return np.array(kept, dtype=np.intp)
