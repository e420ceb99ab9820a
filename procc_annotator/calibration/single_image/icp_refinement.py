"""ICP between field lines and line pixels for many cameras at once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.camera_parameters import FREE_PARAMETERS, Z
from procc_annotator.calibration.optimization.initialization import (
    camera_side,
    side_costs,
    wide_prior,
)
from procc_annotator.calibration.optimization.observations import HALF_WIDTH_PX
from procc_annotator.calibration.optimization.projection import Lens, project
from procc_annotator.calibration.optimization.solver import GaussianPrior
from procc_annotator.calibration.single_image.field_points import (
    FieldLinePoints,
    is_off_ground,
    visible_line_points,
)
from procc_annotator.calibration.single_image.line_distance import (
    SAME_DIRECTION_RAD,
    ImageLinePixels,
    direction_indices,
    map_cells,
)

_MIN_DEPTH_M, _VIEW_MARGIN_PX = 1.0, 2.0
_BEAM_RADIUS_PX = 20.0  # along the line, from paint to the place that is nearest to it


@dataclass(frozen=True, eq=False)
class Correspondences:
    """K pulls on each of B cameras.

    Attributes:
        off: (B, K) solver px across the line, from where the camera shows it to the paint.
        by: (B, free, K) how the place moves across with the camera's parameters.
        known: (B, K) whether there is a pull at all.
        in_view: (B, K) whether the place is in the picture.
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
    place = _nearest_line_point(lens, shown, lines)
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
    return Correspondences(off, by, known, np.ones_like(known), np.abs(off))


def _nearest_line_point(lens: Lens, points: FloatArray, lines: FieldLinePoints) -> IntArray:
    """(B, n) the place on a line nearest to where cameras see points (B, 2, n), free of distortion,
    on the ground."""
    on_ground = np.linalg.inv(lens.linear[:, :, [0, 1, 3]])
    rays = on_ground[:, :, :2] @ points + on_ground[:, :, 2:]
    below = rays[:, 2] > 1e-9
    place = lines.nearest.at(rays[:, :2] / np.where(below, rays[:, 2], 1.0)[:, None])
    return np.asarray(np.where(below, place, -1))


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
    """Inputs of a search.

    Attributes:
        lines: of the field.
        paint: of the picture.
        known: where its camera stands, (1, 8) means and inverse standard deviations; None if it
            may stand anywhere.
    """

    lines: FieldLinePoints
    paint: ImageLinePixels
    known: GaussianPrior | None = None

    def prior(self, vectors: FloatArray, free: int) -> GaussianPrior:
        """Return where cameras (B, 11) are expected, by the side of the field each one stands
        on."""
        if self.known is not None:
            return GaussianPrior(self.known.mean[:, :free], self.known.inverse_sd[:, :free])
        return wide_prior(self._sides(vectors), self.lines.around, free)

    def unlikeliness(self, vectors: FloatArray) -> FloatArray:
        """(B,) half the squared deviations from where cameras are expected, lens left out; more on
        another side than the main camera's."""
        prior = self.prior(vectors, FREE_PARAMETERS["P"])
        off = (vectors[:, : FREE_PARAMETERS["P"]] - prior.mean) * prior.inverse_sd
        cost = np.asarray((off**2).sum(axis=1) / 2)
        if self.known is None:
            cost += side_costs(self._sides(vectors), self.lines.around)
        return cost

    def _sides(self, vectors: FloatArray) -> IntArray:
        around = self.lines.around
        return np.array([camera_side(vector, around) for vector in vectors], dtype=np.intp)


def refine_by_icp(
    scene: SearchScene,
    vectors: FloatArray,
    scales_px: Sequence[float],
    *,
    places: int,
    paint: int = 0,
    model: str = "P",
) -> FloatArray:
    """Lead cameras to the paint, one step for each scale.

    Args:
        scene: field and picture.
        vectors: (B, 11) where they are.
        scales_px: solver px; paint farther off counts less and less.
        places: so many on the lines of each camera.
        paint: so many places of the paint are pulled to lines as well.
        model: P or R.

    Returns:
        (B, 11).
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


@dataclass(frozen=True, eq=False)
class ChamferAgreement:
    """Agreement of B cameras with a picture.

    Attributes:
        coverage: (B,) share of the lines in sight that lie on paint.
        explained: (B,) share of the paint on the ground that lies on lines.
    """

    coverage: FloatArray
    explained: FloatArray

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
    some = scene.paint.some(paint)
    pulls = match_pixels_to_lines(vectors, some, scene.lines, scene.paint, 0)
    explained = (pulls.known & (np.abs(pulls.off) < within_px)).mean(axis=1)
    return ChamferAgreement(coverage, explained)
