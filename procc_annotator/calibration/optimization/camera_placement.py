"""Prior of where cameras stand around a field, and plausibility of a fitted pose."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import (
    LOG_FOCAL,
    ROLL,
    TILT,
    X,
    Y,
    Z,
)
from procc_annotator.calibration.optimization.observations import Observations
from procc_annotator.field.geometry import outline_of
from procc_annotator.field.model import CameraPlacement, Element, Field
from procc_annotator.translation import translatable, translatable_count

# Shares of half the field's length: where cameras stand if no one decides.
_DISTANCE_SHARES, _HEIGHT_SHARES = (0.2, 0.55, 1.2), (0.08, 0.28, 0.5)
# A camera so many times as far away as the farthest usual one is none.
_MAX_DISTANCE_FACTOR = 3.5
# Focal length, px at 960 px of width, of the usual camera so many metres from the field's centre:
# farther away lenses are longer, though not by as much as things look smaller.
_REFERENCE_FOCAL_PX, _REFERENCE_DISTANCE_M = 2300.0, 62.0

PlacementRange = tuple[float, float, float]


@dataclass(frozen=True)
class CameraPlacementPrior:
    """A field's size, and where cameras stand around it; metres.

    Attributes:
        half_length, half_width: of what is on the field, from its centre.
        distance: from the edge of the field: least, usual, most.
        height: above the ground: least, usual, most.
        ceiling: height of cameras that look down; 0 for none.
        has_main_side: whether labels are made for a camera on the near side. Where a field looks
            the same from several sides, its labels go by where the main camera stands; where it
            does not, a camera may stand anywhere.
    """

    half_length: float
    half_width: float
    distance: PlacementRange
    height: PlacementRange
    ceiling: float = 0.0
    has_main_side: bool = True

    @property
    def reach(self) -> float:
        """From the centre of the field to the usual camera at its long side."""
        return self.half_width + self.distance[1]

    @property
    def farthest(self) -> float:
        """Farther from the field's centre there is no camera."""
        return _MAX_DISTANCE_FACTOR * (max(self.half_length, self.half_width) + self.distance[2])

    @property
    def zoom(self) -> float:
        """Focal lengths here, those of a camera 62 m from the field's centre being 1."""
        return math.sqrt(self.reach / _REFERENCE_DISTANCE_M)

    @property
    def ceiling_zoom(self) -> float:
        """The same for cameras that look down."""
        return math.sqrt(self.ceiling / _REFERENCE_DISTANCE_M)

    @property
    def typical_focal_above(self) -> float:
        """Focal length of the usual camera that looks down, solver px."""
        return _REFERENCE_FOCAL_PX * self.ceiling_zoom

    @property
    def typical_focal(self) -> float:
        """Focal length of the usual camera, solver px."""
        return _REFERENCE_FOCAL_PX * self.zoom

    def away(self, share: float) -> float:
        """A distance from the edge: -1 the least, 0 the usual, 1 the most."""
        return _interpolate_range(self.distance, share)

    def up(self, share: float) -> float:
        """A height above the ground: -1 the least, 0 the usual, 1 the most."""
        return _interpolate_range(self.height, share)


def camera_placement_prior(field: Field) -> CameraPlacementPrior:
    """The surroundings of a field, as its file gives them or its size suggests."""
    # What a set need not have may lie anywhere, as a landmark on a roof does.
    own = tuple(e for e in field.elements if not e.optional) or field.elements
    half_length, half_width = _field_extent(own)
    cameras = field.cameras or _default_placement(half_length)
    return CameraPlacementPrior(
        half_length,
        half_width,
        cameras.distance,
        cameras.height,
        cameras.ceiling,
        bool(field.symmetries),
    )


@lru_cache(maxsize=32)
def _field_extent(elements: Sequence[Element]) -> tuple[float, float]:
    reach = np.ones(2)
    for element in elements:
        reach = np.maximum(reach, np.abs(outline_of(element.geometry)[:, :2]).max(axis=0))
    return float(reach[0]), float(reach[1])


def _default_placement(half_length: float) -> CameraPlacement:
    least, usual, most = (share * half_length for share in _DISTANCE_SHARES)
    low, middle, high = (share * half_length for share in _HEIGHT_SHARES)
    return CameraPlacement((least, usual, most), (low, middle, high))


def _interpolate_range(values: PlacementRange, share: float) -> float:
    least, usual, most = values
    return usual + share * ((most - usual) if share > 0 else (usual - least))


# How often an element ties a camera down: a line twice, a curve up to five times, once a point;
# the only point of a spot twice.
_LINE_CONSTRAINTS, _CURVE_CONSTRAINTS, _SPOT_CONSTRAINTS = 2, 5, 2
_MIN_EXTENT_PX = 3.0  # solver px, root mean square across the points' main direction
_MIN_HEIGHT_M = 0.3
_GROUND_TOLERANCE_M = 0.05  # told as 0.0 m, above or below
_MAX_ROLL = math.radians(30)
# A camera under a ceiling that looks down more steeply may be turned any way.
_LOOKING_DOWN_RAD = math.radians(35)
_FOCAL_RANGE_PX = (150.0, 60000.0)  # solver px


def insufficient_reason(seen: Observations | None, *, needed: int, planar: bool) -> str | None:
    """Why there is too little to fit a camera to that needs so many elements, in words; None when
    there is enough. If ``planar``, only elements on the ground count."""
    count = 0 if seen is None else len(seen.elements)
    if seen is None or count < needed:
        return too_few_elements_text(count, needed, planar=planar)
    if _constraint_count(seen) < 2 * needed:
        return translatable_count(
            count,
            "{points} points on {n} element, two different ones on each of {needed} needed",
            "{points} points on {n} elements, two different ones on each of {needed} needed",
            points=seen.points.shape[1],
            needed=needed,
        )
    return _is_degenerate(seen.points)


def too_few_elements_text(count: int, needed: int, *, planar: bool = False) -> str:
    """That so many elements are not enough."""
    if planar:
        return translatable_count(
            count,
            "{n} element on the ground, {needed} needed",
            "{n} elements on the ground, {needed} needed",
            needed=needed,
        )
    return translatable_count(
        count, "{n} element, {needed} needed", "{n} elements, {needed} needed", needed=needed
    )


def _constraint_count(seen: Observations) -> int:
    ties = 0
    for element, count in zip(seen.elements, seen.counts.tolist(), strict=True):
        if element.is_spot:
            ties += _SPOT_CONSTRAINTS
        else:
            ties += min(count, _LINE_CONSTRAINTS if element.is_straight else _CURVE_CONSTRAINTS)
    return ties


def _is_degenerate(points: FloatArray) -> str | None:
    centred = points - points.mean(axis=1, keepdims=True)
    rms = np.linalg.svd(centred, compute_uv=False) / math.sqrt(points.shape[1])
    if rms[0] < _MIN_EXTENT_PX:
        return translatable("all points lie in one place of the picture")
    if rms[1] < _MIN_EXTENT_PX:
        return translatable("all points lie on one line of the picture")
    return None


def implausible_reason(vector: FloatArray, around: CameraPlacementPrior) -> str | None:
    """Return what makes the pose of a pinhole (11,) implausible; None when nothing does."""
    if not np.isfinite(vector).all():
        return translatable("not a plausible pose: the fit did not settle")
    height = -float(vector[Z])
    if abs(height) < _GROUND_TOLERANCE_M:
        return translatable("not a plausible pose: on the ground")
    if height < 0:
        return translatable("not a plausible pose: {metres:.1f} m below the ground", metres=-height)
    if height < _MIN_HEIGHT_M:
        return translatable(
            "not a plausible pose: only {metres:.1f} m above the ground", metres=height
        )
    away = math.hypot(vector[X], vector[Y], vector[Z])
    if away > around.farthest:
        return translatable(
            "not a plausible pose: {metres:.0f} m from the field's centre", metres=away
        )
    upright = not around.ceiling or abs(vector[TILT]) > _LOOKING_DOWN_RAD
    if upright and abs(math.remainder(vector[ROLL], 2 * math.pi)) > _MAX_ROLL:
        degrees = math.degrees(vector[ROLL])
        return translatable(
            "not a plausible pose: rolled by {degrees:.0f} degrees", degrees=degrees
        )
    focal = math.exp(vector[LOG_FOCAL])
    if not _FOCAL_RANGE_PX[0] <= focal <= _FOCAL_RANGE_PX[1]:
        return translatable(
            "not a plausible pose: focal length {px:.0f} px at 960 px width", px=focal
        )
    return None
