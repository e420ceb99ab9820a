"""Where cameras stand around a sports field: the places a search starts from, and weak priors.

Everything is told in the measures of the field, so that it serves fields of other sizes as well;
the figures are those of soccer, 105 x 68 m, where a main camera stands some 20 to 50 m from the
near side line and 10 to 20 m above it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from procc_annotator.field.geometry import Arc, Circle, length_of, middle_of, outline_of
from procc_annotator.field.model import Element, Field
from procc_annotator.fit.solving.crossings import nearest_crossing
from procc_annotator.fit.solving.models import ASPECT, KAPPA, LOG_FOCAL, PRINCIPAL_X, ROLL, X, Y, Z
from procc_annotator.fit.solving.observations import FloatArray, IntArray, Observations
from procc_annotator.fit.solving.solver import Prior

FOCALS = (1200.0, 2200.0, 3800.0)
SIDES = ("near", "far", "left", "right")
# Metres of a soccer field: along the side from its middle, away from the line, above the ground.
_LONG_SIDE_PLACES = ((0.0, 18.0, 11.0), (0.0, 28.0, 17.0), (0.0, 51.0, 20.0))
_END_PLACES = ((0.0, 14.0, 5.0), (0.0, 25.0, 11.0), (0.0, 48.0, 20.0))
# And less usual ones.
_OTHER_FOCALS = (800.0, 2800.0, 7000.0)
_OTHER_LONG_SIDE_PLACES = ((-28.0, 18.0, 9.0), (28.0, 18.0, 9.0), (0.0, 36.0, 26.0))
_OTHER_END_PLACES = ((-18.0, 18.0, 8.0), (18.0, 18.0, 8.0), (0.0, 36.0, 26.0))
# Of two explanations that are as good the main camera's: what another side costs, px^2.
_OTHER_SIDE_COST = 3.0
_SOCCER_HALF_LENGTH = 52.5
_SHORT_M = 15.0

_Places = tuple[tuple[float, float, float], ...]


@dataclass(frozen=True)
class Extent:
    """Half the length and half the width of what lies on a field, metres."""

    half_length: float
    half_width: float

    @property
    def scale(self) -> float:
        """The size of the field, a soccer field being 1."""
        return self.half_length / _SOCCER_HALF_LENGTH


@dataclass(frozen=True, eq=False)
class Starts:
    """Cameras to start from.

    Attributes:
        vectors: (B, 11) parameters.
        sides: (B,) index in `SIDES` of the side each one stands on.
    """

    vectors: FloatArray
    sides: IntArray

    def chosen(self, which: IntArray) -> Starts:
        """Some of them, in the order asked for."""
        return Starts(self.vectors[which], self.sides[which])


def extent_of(field: Field) -> Extent:
    """How far the field reaches from its centre."""
    return _extent(field.elements)


@lru_cache(maxsize=16)
def _extent(elements: tuple[Element, ...]) -> Extent:
    reach = np.ones(2)
    for element in elements:
        reach = np.maximum(reach, np.abs(outline_of(element.geometry)[:, :2]).max(axis=0))
    return Extent(float(reach[0]), float(reach[1]))


def all_starts(seen: Observations, field: Field) -> Starts:
    """Places on all sides, with several focal lengths, looking at what was annotated.

    The usual places look at a crossing of two lines, which is exact unless a label is wrong; the
    others at the middle of everything.
    """
    middle = _middle_of(seen)
    usual = _starts(
        field, (_LONG_SIDE_PLACES, _END_PLACES), FOCALS, nearest_crossing(seen) or middle
    )
    other = _starts(field, (_OTHER_LONG_SIDE_PLACES, _OTHER_END_PLACES), _OTHER_FOCALS, middle)
    return Starts(
        np.concatenate([usual.vectors, other.vectors]), np.concatenate([usual.sides, other.sides])
    )


def _starts(
    field: Field,
    places: tuple[_Places, _Places],
    focals: tuple[float, ...],
    target: tuple[FloatArray, FloatArray],
) -> Starts:
    centres, sides = _places_around(extent_of(field), *places)
    focal = np.tile(focals, len(centres))
    vectors = np.zeros((len(focal), 11))
    vectors[:, X : Z + 1] = np.repeat(centres, len(focals), axis=0)
    vectors[:, LOG_FOCAL] = np.log(focal)
    _aim(vectors, focal, *target)
    return Starts(vectors, np.repeat(sides, len(focals)))


def aimed(position: FloatArray, focals: FloatArray, seen: Observations) -> FloatArray:
    """(B, 11) cameras at one place with B focal lengths, looking at what was annotated.

    Args:
        position: (3,) metres.
        focals: (B,) solver px.
        seen: the annotated points.
    """
    vectors = np.zeros((len(focals), 11))
    vectors[:, X : Z + 1] = position
    vectors[:, LOG_FOCAL] = np.log(focals)
    target, shown = nearest_crossing(seen) or _middle_of(seen)
    _aim(vectors, focals, target, shown)
    return vectors


def side_of(vector: FloatArray, extent: Extent) -> int:
    """Index in `SIDES` of the side a camera stands on: the one it is farthest outside of."""
    x, y = float(vector[X]), float(vector[Y])
    outside = (
        y - extent.half_width,
        -y - extent.half_width,
        -x - extent.half_length,
        x - extent.half_length,
    )
    return int(np.argmax(outside))


def search_prior(sides: IntArray, extent: Extent, free: int) -> Prior:
    """Priors that keep a search among cameras as they usually stand."""
    sd = np.array([12, 20, 7, 1.5, 0.6, 0.1, 0.01, 10.0])
    return _prior(sides, extent, free, sd, away=(33.0, 33.0), height=15.0)


def wide_prior(sides: IntArray, extent: Extent, free: int) -> Prior:
    """Priors that decide only what the points leave open."""
    sd = np.array([20, 28, 9, 2.0, 0.8, 0.08, 0.02, 25.0])
    return _prior(sides, extent, free, sd, away=(31.0, 31.0), height=15.0)


def _prior(
    sides: IntArray,
    extent: Extent,
    free: int,
    sd: FloatArray,
    *,
    away: tuple[float, float],
    height: float,
) -> Prior:
    """``sd``: along the side, away, height (m), roll (degrees), log f, kappa, aspect, centre."""
    scale = extent.scale
    mean, inverse = np.zeros((len(sides), 11)), np.zeros((len(sides), 11))
    mean[:, Z] = -height * scale
    mean[:, LOG_FOCAL] = np.log(2300.0)
    at_end = np.asarray(sides) >= 2
    sign = np.where(np.asarray(sides) % 3 == 0, 1.0, -1.0)  # near and right: positive
    mean[:, Y] = np.where(at_end, 0.0, sign * (extent.half_width + away[0] * scale))
    mean[:, X] = np.where(at_end, sign * (extent.half_length + away[1] * scale), 0.0)
    inverse[:, X] = 1 / (scale * np.where(at_end, sd[1], sd[0]))
    inverse[:, Y] = 1 / (scale * np.where(at_end, sd[0], sd[1]))
    inverse[:, Z] = 1 / (scale * sd[2])
    inverse[:, ROLL] = 1 / np.deg2rad(sd[3])
    inverse[:, LOG_FOCAL], inverse[:, KAPPA] = 1 / sd[4], 1 / sd[5]
    inverse[:, ASPECT], inverse[:, PRINCIPAL_X:] = 1 / sd[6], 1 / sd[7]
    return Prior(mean[:, :free], inverse[:, :free])


def side_costs(sides: IntArray) -> FloatArray:
    """(B,) what a camera costs that is not on the main camera's side."""
    return np.where(np.asarray(sides) == 0, 0.0, _OTHER_SIDE_COST)


def _places_around(
    extent: Extent, at_long_side: _Places, at_end: _Places
) -> tuple[FloatArray, IntArray]:
    """(K, 3) metres, and (K,) the sides they are on."""
    scale = extent.scale
    found, sides = [], []
    for side, name in enumerate(SIDES):
        sign = 1.0 if name in ("near", "right") else -1.0
        long = name in ("near", "far")
        for along, away, up in at_long_side if long else at_end:
            if long:
                place = (along * scale, sign * (extent.half_width + away * scale), -up * scale)
            else:
                place = (sign * (extent.half_length + away * scale), along * scale, -up * scale)
            found.append(place)
            sides.append(side)
    return np.array(found), np.array(sides)


def _middle_of(seen: Observations) -> tuple[FloatArray, FloatArray]:
    """Mean of the annotated elements (3,), metres, and of their points (2,), solver px.

    A long element counts less on the field: less of it is seen.
    """
    middles, lengths = [], []
    for element in seen.elements:
        shape = element.geometry
        middles.append(middle_of(shape))
        lengths.append(2 * shape.radius if isinstance(shape, Arc | Circle) else length_of(shape))
    # A single goal post with the wrong label must not turn the camera to the other end.
    weights = 1 / np.maximum(lengths, _SHORT_M)
    inside = np.clip(seen.points, -600.0, 600.0)
    shown = seen.mean_of_element(inside).mean(axis=1)
    return np.asarray(weights @ np.array(middles) / weights.sum()), shown


def _aim(vectors: FloatArray, focal: FloatArray, target: FloatArray, shown: FloatArray) -> None:
    """Turn cameras so that the target (3,) appears at (2,) solver px."""
    toward = target - vectors[:, X : Z + 1]
    toward /= np.linalg.norm(toward, axis=1)[:, None]
    vectors[:, 0] = np.arctan2(toward[:, 0], -toward[:, 1]) - np.arctan2(shown[0], focal)
    vectors[:, 1] = np.arccos(np.clip(toward[:, 2], -1.0, 1.0)) + np.arctan2(shown[1], focal)
