"""Initial cameras and the priors of the search."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.camera_parameters import (
    ASPECT,
    KAPPA,
    LOG_FOCAL,
    PAN,
    PARAMETERS,
    POSITION_SLICE,
    PRINCIPAL_X,
    PRINCIPAL_Y,
    ROLL,
    SECOND_KAPPA,
    TILT,
    X,
    Y,
    Z,
    rotation_matrices,
)
from procc_annotator.calibration.optimization.camera_placement import (
    CameraPlacementPrior,
    camera_placement_prior,
)
from procc_annotator.calibration.optimization.observations import Observations
from procc_annotator.calibration.optimization.solver import GaussianPrior
from procc_annotator.field.geometry import Arc, Circle, length_of, middle_of
from procc_annotator.field.model import Field

# Two lines of the field meet if they come this close, metres, about as paint is wide, at most this
# share beyond their ends.
_SAME_POINT_M, _EXTENSION_SHARE = 0.15, 0.02
# Where two lines of the picture cross at less than this sine of an angle, or farther out than this
# from its centre (solver px), clicks do not determine well.
_MIN_CROSSING_SINE, _MAX_CROSSING_PX = 0.05, 1000.0
_TINY = 1e-9


def nearest_control_point(seen: Observations) -> tuple[FloatArray, FloatArray] | None:
    """Of the places where two annotated straight elements meet, and of the annotated spots, the one
    nearest to the picture's centre: (3,) metres, and where the picture shows it (2,), solver px.

    Both lines are prolonged in the picture, so the place need not be visible.
    """
    places, shown = _line_crossings(seen)
    spots = [row for row, element in enumerate(seen.elements) if element.is_spot]
    if spots:
        known = seen.parts.spots[:, : len(spots)]
        places = np.concatenate([places, known], axis=1)
        shown = np.concatenate([shown, seen.points[:, seen.starts[spots]]], axis=1)
    far = np.hypot(shown[0], shown[1])
    if not far.size or far.min() > _MAX_CROSSING_PX:
        return None
    best = int(np.argmin(far))
    return places[:, best], shown[:, best]


def _line_crossings(seen: Observations) -> tuple[FloatArray, FloatArray]:
    """(3, K) metres and (2, K) solver px: where annotated straight elements meet clearly."""
    lines = _straight_count(seen)
    enough = np.flatnonzero(seen.counts[:lines] >= 2)
    first, second = np.triu_indices(len(enough), 1)
    one, other = enough[first], enough[second]
    places, meet = _crossings_on_field(seen, one, other)
    shown, clear = _crossings_in_image(seen, one, other)
    known = meet & clear
    return places[:, known], shown[:, known]


def _straight_count(seen: Observations) -> int:
    return sum(element.is_straight for element in seen.elements)


def _crossings_on_field(
    seen: Observations, one: IntArray, other: IntArray
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """(3, K) places on lines ``one`` nearest to lines ``other`` (K,), and whether they meet."""
    begin, end = np.split(seen.parts.line_ends, 2, axis=1)
    span_a, span_b = (end - begin)[:, one], (end - begin)[:, other]
    between = begin[:, other] - begin[:, one]
    normal = np.cross(span_a, span_b, axis=0)
    square = (normal * normal).sum(axis=0)
    crossed = square > _TINY
    square = np.where(crossed, square, 1.0)
    along_a = (np.cross(between, span_b, axis=0) * normal).sum(axis=0) / square
    along_b = (np.cross(between, span_a, axis=0) * normal).sum(axis=0) / square
    apart = np.abs((between * normal).sum(axis=0)) / np.sqrt(square)
    within = (np.abs(np.stack([along_a, along_b]) - 0.5) <= 0.5 + _EXTENSION_SHARE).all(axis=0)
    return begin[:, one] + along_a * span_a, crossed & within & (apart < _SAME_POINT_M)


def _crossings_in_image(
    seen: Observations, one: IntArray, other: IntArray
) -> tuple[FloatArray, NDArray[np.bool_]]:
    """(2, K) solver px where the lines of the picture cross, and whether they do so clearly."""
    lines = _straight_count(seen)
    counts = seen.counts[:lines]
    points = seen.points[:, : counts.sum()]
    of_point = seen.element_of_point[: points.shape[1]]
    middle = np.stack([np.bincount(of_point, row, lines) for row in points]) / counts
    x, y = points - middle[:, of_point]
    spread = [np.bincount(of_point, product, lines) for product in (x * x, y * y, x * y)]
    angle = np.arctan2(2 * spread[2], spread[0] - spread[1]) / 2
    cosine, sine = np.cos(angle), np.sin(angle)
    turn = cosine[one] * sine[other] - sine[one] * cosine[other]
    clear = np.abs(turn) > _MIN_CROSSING_SINE
    between = middle[:, other] - middle[:, one]
    along = between[0] * sine[other] - between[1] * cosine[other]
    along = along / np.where(clear, turn, 1.0)
    return middle[:, one] + along * np.stack([cosine[one], sine[one]]), clear


# Focal lengths (solver px) where the usual one is 2300.
START_FOCALS_PX = (1200.0, 2200.0, 3800.0)
SIDES = ("near", "far", "left", "right", "above")
ABOVE_SIDE = SIDES.index("above")
# Shares: along the side from its middle, of half the field's length; away from the edge, above
# the ground, both from -1 (the least where cameras stand) over 0 (the usual) to 1 (the most).
_LONG_SIDE_POSITIONS = ((0.0, -0.7, -0.4), (0.0, 0.0, 0.2), (0.0, 0.7, 0.45))
_END_POSITIONS = ((0.0, -1.0, -1.0), (0.0, -0.2, -0.4), (0.0, 0.6, 0.45))
# And less usual ones.
_FURTHER_FOCALS_PX = (800.0, 2800.0, 7000.0)
_FURTHER_LONG_SIDE_POSITIONS = ((-0.53, -0.7, -0.6), (0.53, -0.7, -0.6), (0.0, 0.25, 1.0))
_FURTHER_END_POSITIONS = ((-0.34, -0.7, -0.7), (0.34, -0.7, -0.7), (0.0, 0.25, 1.0))
# Cameras that look down may be turned any way.
_PANS_ABOVE, _TILT_ABOVE_RAD = 8, 0.15
# Of two explanations that are as good the main camera's: what another side costs, px^2.
_OTHER_SIDE_COST = 3.0
# Standard deviations of where cameras stand, as shares of the range in which they do; along a side
# and for cameras that look down, of half the field's length or width.
_WIDE_PRIOR_SD, _WIDE_PRIOR_SD_ALONG, _SEARCH_PRIOR_FACTOR = 0.5, 0.38, 0.75
# Of the way to the usual camera, at least: who says exactly where cameras stand says so of most.
_MIN_POSITION_SD = 0.05
# The principal point (solver px): of a whole picture it is near the centre, of a picture that is
# cut out of a larger one it may be anywhere.
# What both coefficients of a strong lens are expected to be.
_WIDE_ANGLE_SD = (0.25, 0.15)
CENTRE_SD, MAX_CENTRE_OFFSET, CROPPED_CENTRE_SD = 25.0, 100.0, 300.0
_SHORT_LENS_SHARE = 2 / 7  # of half the field's length

_RelativePositions = tuple[tuple[float, float, float], ...]


@dataclass(frozen=True, eq=False)
class InitialCameras:
    """Cameras to start from: (B, 11) parameters, and (B,) index in `SIDES` of the side each one
    stands on."""

    vectors: FloatArray
    sides: IntArray


def initial_cameras(seen: Observations, field: Field) -> InitialCameras:
    """Places on all sides, with several focal lengths, looking at what was annotated; above too,
    where cameras hang from a ceiling.

    The usual places look at a place known exactly, unless a label is wrong: a crossing of two lines
    or a spot. The others look at the middle of everything.
    """
    around = camera_placement_prior(field)
    middle = _annotated_centroid(seen, around)
    exact = nearest_control_point(seen) or middle
    found = [
        _initial_cameras_at(around, (_LONG_SIDE_POSITIONS, _END_POSITIONS), START_FOCALS_PX, exact),
        _initial_cameras_at(
            around,
            (_FURTHER_LONG_SIDE_POSITIONS, _FURTHER_END_POSITIONS),
            _FURTHER_FOCALS_PX,
            middle,
        ),
    ]
    if around.ceiling:
        found.append(_initial_cameras_above(around, exact))
    return InitialCameras(
        np.concatenate([one.vectors for one in found]), np.concatenate([one.sides for one in found])
    )


def _initial_cameras_at(
    around: CameraPlacementPrior,
    places: tuple[_RelativePositions, _RelativePositions],
    focals: tuple[float, ...],
    target: tuple[FloatArray, FloatArray],
) -> InitialCameras:
    centres, sides = _positions_around(around, *places)
    focal = np.tile(focals, len(centres)) * around.zoom
    vectors = np.zeros((len(focal), len(PARAMETERS)))
    vectors[:, POSITION_SLICE] = np.repeat(centres, len(focals), axis=0)
    vectors[:, LOG_FOCAL] = np.log(focal)
    _aim_cameras(vectors, focal, *target)
    return InitialCameras(vectors, np.repeat(sides, len(focals)))


def _initial_cameras_above(
    around: CameraPlacementPrior, target: tuple[FloatArray, FloatArray]
) -> InitialCameras:
    """Cameras under the ceiling, each where it shows the target (3,) at (2,) solver px."""
    turns = np.arange(_PANS_ABOVE) * 2 * np.pi / _PANS_ABOVE
    focal = np.tile(START_FOCALS_PX, len(turns)) * around.ceiling_zoom
    vectors = np.zeros((len(focal), len(PARAMETERS)))
    vectors[:, PAN] = np.repeat(turns, len(START_FOCALS_PX))
    vectors[:, TILT] = _TILT_ABOVE_RAD
    vectors[:, LOG_FOCAL] = np.log(focal)
    place, shown = target
    ray = np.column_stack([shown[0] / focal, shown[1] / focal, np.ones(len(focal))])
    toward = np.einsum("bij,bi->bj", rotation_matrices(vectors), ray)
    drop = max(around.ceiling + float(place[2]), around.ceiling / 4)
    # A ray to the edge of a wide picture may not go down at all.
    toward *= drop / np.maximum(toward[:, 2:], 0.2)
    vectors[:, POSITION_SLICE] = place - toward
    vectors[:, Z] = np.minimum(vectors[:, Z], -around.ceiling / 4)
    return InitialCameras(vectors, np.full(len(focal), ABOVE_SIDE))


def initial_cameras_at_position(
    position: FloatArray, seen: Observations, field: Field
) -> FloatArray:
    """(B, 11) cameras at a position (3,), metres, with several focal lengths, looking at what was
    annotated."""
    around = camera_placement_prior(field)
    focals = np.array(START_FOCALS_PX) * around.zoom
    vectors = np.zeros((len(focals), len(PARAMETERS)))
    vectors[:, POSITION_SLICE] = position
    vectors[:, LOG_FOCAL] = np.log(focals)
    target, shown = nearest_control_point(seen) or _annotated_centroid(seen, around)
    _aim_cameras(vectors, focals, target, shown)
    return vectors


def camera_side(vector: FloatArray, around: CameraPlacementPrior) -> int:
    """Index in `SIDES` of the side a camera stands on: the one it is farthest outside of."""
    return int(camera_sides(vector[None], around)[0])


def camera_sides(vectors: FloatArray, around: CameraPlacementPrior) -> IntArray:
    """(B,) of cameras (B, 11); see `camera_side`."""
    x, y = vectors[:, X], vectors[:, Y]
    half_width, half_length = around.half_width, around.half_length
    outside = np.array([y - half_width, -y - half_width, -x - half_length, x - half_length])
    sides = outside.argmax(axis=0)
    if around.ceiling:
        above = (outside.max(axis=0) < 0) & (-vectors[:, Z] > around.ceiling / 2)
        sides[above] = ABOVE_SIDE
    return np.asarray(sides)


def search_prior(sides: IntArray, around: CameraPlacementPrior, free: int) -> GaussianPrior:
    """Priors that keep a search among cameras as they usually stand."""
    return _build_prior(
        sides, around, free, _SEARCH_PRIOR_FACTOR, np.array([1.5, 0.6, 0.1, 0.01, 10.0])
    )


def wide_prior(
    sides: IntArray, around: CameraPlacementPrior, free: int, *, centre_sd: float = CENTRE_SD
) -> GaussianPrior:
    """Priors that decide only what the points leave open; ``centre_sd``: of the principal point."""
    return _build_prior(sides, around, free, 1.0, np.array([2.0, 0.8, 0.08, 0.02, centre_sd]))


def prior_near(vector: FloatArray, around: CameraPlacementPrior, free: int) -> GaussianPrior:
    """The wide prior of a camera that is near another one (11,): on its side of the field, and of a
    picture that is cut out of a larger one where that one's is."""
    cut_out = np.abs(vector[PRINCIPAL_X : PRINCIPAL_Y + 1]).max() > MAX_CENTRE_OFFSET
    centre_sd = CROPPED_CENTRE_SD if cut_out else CENTRE_SD
    return wide_prior(np.array([camera_side(vector, around)]), around, free, centre_sd=centre_sd)


def _build_prior(
    sides: IntArray, around: CameraPlacementPrior, free: int, spread: float, sd: FloatArray
) -> GaussianPrior:
    """``spread`` of where cameras stand; ``sd``: roll (degrees), log f, kappa, aspect, centre."""
    sides = np.asarray(sides)
    mean, inverse = (
        np.zeros((len(sides), SECOND_KAPPA + 1)),
        np.zeros((len(sides), SECOND_KAPPA + 1)),
    )
    half_length, half_width = around.half_length, around.half_width
    at_end = (sides == 2) | (sides == 3)
    sign = np.where(sides % 3 == 0, 1.0, -1.0)  # near and right: positive
    away_sd, up_sd = (
        max(_WIDE_PRIOR_SD * (most - least), _MIN_POSITION_SD * around.reach)
        for least, _, most in (around.distance, around.height)
    )
    along_sd = _WIDE_PRIOR_SD_ALONG * half_length
    mean[:, Y] = np.where(at_end, 0.0, sign * (half_width + around.distance[1]))
    mean[:, X] = np.where(at_end, sign * (half_length + around.distance[1]), 0.0)
    mean[:, Z] = -around.height[1]
    mean[:, LOG_FOCAL] = np.log(around.typical_focal)
    inverse[:, X] = 1 / np.where(at_end, away_sd, along_sd)
    inverse[:, Y] = 1 / np.where(at_end, along_sd, away_sd)
    inverse[:, Z] = 1 / up_sd
    inverse[:, ROLL] = 1 / np.deg2rad(sd[0])
    above = sides == ABOVE_SIDE
    if above.any():
        mean[above, POSITION_SLICE] = 0.0, 0.0, -around.ceiling
        mean[above, LOG_FOCAL] = np.log(around.typical_focal_above)
        inverse[above, POSITION_SLICE] = 1 / np.array(
            [half_length, half_width, _WIDE_PRIOR_SD_ALONG * around.ceiling]
        )
        inverse[above, ROLL] = 0.0  # it looks down: which way is up is anybody's guess
    inverse[:, POSITION_SLICE] /= spread
    inverse[:, LOG_FOCAL], inverse[:, KAPPA] = 1 / sd[1], 1 / sd[2]
    inverse[:, ASPECT], inverse[:, PRINCIPAL_X : PRINCIPAL_Y + 1] = 1 / sd[3], 1 / sd[4]
    if free > SECOND_KAPPA:
        inverse[:, KAPPA], inverse[:, SECOND_KAPPA] = 1 / _WIDE_ANGLE_SD[0], 1 / _WIDE_ANGLE_SD[1]
    return GaussianPrior(mean[:, :free], inverse[:, :free])


def side_costs(sides: IntArray, around: CameraPlacementPrior) -> FloatArray:
    """(B,) what a camera costs that is not on the main camera's side."""
    cost = _OTHER_SIDE_COST if around.has_main_side else 0.0
    return np.where(np.asarray(sides) == 0, 0.0, cost)


def _positions_around(
    around: CameraPlacementPrior, at_long_side: _RelativePositions, at_end: _RelativePositions
) -> tuple[FloatArray, IntArray]:
    """(K, 3) metres, and (K,) the sides they are on."""
    found, sides = [], []
    for side, name in enumerate(SIDES[:ABOVE_SIDE]):
        sign = 1.0 if name in ("near", "right") else -1.0
        long = name in ("near", "far")
        for along, away, up in at_long_side if long else at_end:
            beside, height = along * around.half_length, -around.up(up)
            if long:
                place = (beside, sign * (around.half_width + around.away(away)), height)
            else:
                place = (sign * (around.half_length + around.away(away)), beside, height)
            found.append(place)
            sides.append(side)
    return np.array(found), np.array(sides)


def _annotated_centroid(
    seen: Observations, around: CameraPlacementPrior
) -> tuple[FloatArray, FloatArray]:
    """Mean of the annotated elements (3,), metres, and of their points (2,), solver px.

    A long element counts less on the field: less of it is seen.
    """
    middles, lengths = [], []
    for element in seen.elements:
        shape = element.geometry
        middles.append(middle_of(shape))
        lengths.append(2 * shape.radius if isinstance(shape, Arc | Circle) else length_of(shape))
    # A single goal post with the wrong label must not turn the camera to the other end.
    weights = 1 / np.maximum(lengths, _SHORT_LENS_SHARE * around.half_length)
    inside = np.clip(seen.points, -600.0, 600.0)
    shown = seen.mean_per_element(inside).mean(axis=1)
    return np.asarray(weights @ np.array(middles) / weights.sum()), shown


def _aim_cameras(
    vectors: FloatArray, focal: FloatArray, target: FloatArray, shown: FloatArray
) -> None:
    """Turn cameras so that the target (3,) appears at (2,) solver px."""
    toward = target - vectors[:, POSITION_SLICE]
    toward /= np.linalg.norm(toward, axis=1)[:, None]
    vectors[:, PAN] = np.arctan2(toward[:, 0], -toward[:, 1]) - np.arctan2(shown[0], focal)
    vectors[:, TILT] = np.arccos(np.clip(toward[:, 2], -1.0, 1.0)) + np.arctan2(shown[1], focal)
