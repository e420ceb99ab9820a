"""Where cameras of a sport stand around its field, and from how far away they see it.

All lengths a fit goes by come from here, so that it serves a court as well as a stadium: the field
file tells where cameras stand; where it does not, the size of the field does.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from procc_annotator.field.geometry import outline_of
from procc_annotator.field.model import CameraPlacement, Element, Field

# Shares of half the field's length: where cameras stand if nobody tells.
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
        half_length, half_width: of what lies on the field, from its centre.
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
    """The surroundings of a field, as its file tells them or its size suggests."""
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
