"""Where profiles across a direction curve most, and the bands that are there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.appearance import ANY, BAR, EDGE, LIGHTER, WHITE
from procc_annotator.image.colour_step import fits
from procc_annotator.image.cuts import STEP_PX, Patch, Values
from procc_annotator.image.profile import (
    Band,
    band_at,
    curvature_kernel,
    edge_at,
    gradient_kernel,
    middle_of_nine,
    top_of_three,
)
from procc_annotator.image.sought import Sought

FloatArray = NDArray[np.float64]

BEYOND_PX = 14.0  # a profile goes this far beyond the reach: the widest line and its side
TRIED = 8  # maxima looked at, the most convincing first

_LENGTH_PX = 6.5  # a profile is averaged this far along the line
# Both ways; and one way only, since an element's ends lie where its line ends or meets another.
_STRETCHES = np.array(
    [
        np.linspace(-_LENGTH_PX, _LENGTH_PX, 9),
        np.linspace(-0.5, _LENGTH_PX + 1.5, 9),
        np.linspace(-_LENGTH_PX - 1.5, 0.5, 9),
    ]
)
_SIDES = np.array([1.0, 0.75, 0.75])  # a band that is seen on one side only counts less
_BAR_STRETCHES = 2.0 * _STRETCHES  # bars are straight: what is behind them averages out
_NEARNESS_PX = 8.0  # a band at this distance counts less than half of one at none
_LEAST_CONTRAST = 16.0  # of 255
_SHOWN = 0.4  # of the contrast: what a cut must have to show the band
_SUPPORT = 0.62  # share of the cuts that must show it
_LEVEL = 0.7
_BALANCED = 0.6
_FRINGE_PX = 6.0  # from a band's edge: where a stronger one of the opposite tone may lie
_STRONGER = 1.2
_LOPSIDED, _STRONGER_BESIDE = 0.62, 1.0  # ... on the side to which most of a band's step leads


@dataclass(frozen=True, slots=True)
class Found:
    """A band through a patch: its direction, and where across the position it is, px.

    ``merit``: how sharp and near it is; comparable within one patch.
    """

    angle: float
    offset: float
    merit: float
    width: float

    @property
    def foot(self) -> tuple[float, float]:
        """From the position to the band's middle, px."""
        return foot_of(self.angle, self.offset)


def foot_of(angle: float, offset: float) -> tuple[float, float]:
    return -offset * math.sin(angle), offset * math.cos(angle)


@dataclass(frozen=True, eq=False)
class Maxima:
    """Where profiles in several directions curve most, and what is needed to look closer.

    Attributes:
        angles: (A,) radians; each has three rows, one a stretch.
        offsets: (T,) px across.
        cuts: (3 A, 9, T, K) colours.
        profiles, curved: (3 A, T, K) along the cuts, and how they curve.
        strength: (3 A, T) how much they curve the way the sought paint does.
    """

    angles: FloatArray
    offsets: FloatArray
    cuts: Values
    profiles: Values
    curved: Values
    strength: Values
    sought: Sought
    reach_px: float

    @classmethod
    def of(cls, patch: Patch, angles: FloatArray, sought: Sought, reach_px: float) -> Maxima:
        """Look for paint in several directions through a patch's position."""
        looks = sought.looks
        pale = looks.tone == LIGHTER and looks.colour in (WHITE, ANY) and looks.kind != EDGE
        half = math.ceil((reach_px + BEYOND_PX) / STEP_PX)
        offsets = np.arange(-half, half + 1, dtype=np.float64) * STEP_PX
        stretches = _BAR_STRETCHES if looks.kind == BAR else _STRETCHES
        cuts = (patch.palest() if pale else patch).cuts(angles, stretches, offsets)
        cuts = cuts.reshape(-1, *cuts.shape[2:])
        profiles = middle_of_nine(cuts)
        edge = looks.kind == EDGE
        curved = _filtered(profiles, gradient_kernel() if edge else curvature_kernel())
        strength = curved[..., 0] if pale else _strength(curved, sought)
        return cls(angles, offsets, cuts, profiles, curved, strength, sought, reach_px)

    def ordered(self) -> Iterator[tuple[int, int, float, float]]:
        """Row, column, offset and merit of each maximum, the strongest and nearest first."""
        inner = self.strength[:, 1:-1]
        peaks = (inner > 0) & (inner >= self.strength[:, :-2]) & (inner > self.strength[:, 2:])
        weights = _weights(len(self.angles), len(self.offsets), self.reach_px)[:, 1:-1]
        rows, columns = np.nonzero(peaks & (weights > 0))
        values = inner[rows, columns] * weights[rows, columns]
        order = np.argsort(-values)
        rows, columns, values = rows[order], columns[order] + 1, values[order]
        return zip(
            rows.tolist(),
            columns.tolist(),
            self.offsets[columns].tolist(),
            values.tolist(),
            strict=True,
        )

    def angle_of(self, row: int) -> float:
        """The direction of a row, radians."""
        return float(self.angles[row // len(_SIDES)])

    def stretch_of(self, row: int) -> int:
        """The stretch of a row: both ways, ahead, back."""
        return row % len(_SIDES)

    def best(self) -> Found | None:
        """The strongest and nearest band."""
        found = (self.band(row, column) for row, column, *_ in islice(self.ordered(), TRIED))
        return next((band for band in found if band is not None), None)

    def band(self, row: int, column: int) -> Found | None:
        """The band at a maximum, if there is one that looks like what is sought."""
        colour = self.curved[row, column]
        colour = colour / math.sqrt(float(colour @ colour))
        looks, profile = self.sought.looks, self.profiles[row] @ colour
        band = (edge_at if looks.kind == EDGE else band_at)(profile, column)
        if band is None or not _is_shown(band, self.cuts[row] @ colour, self.sought):
            return None
        if looks.tone == ANY and looks.kind != EDGE and _is_fringe(band, profile):
            return None
        place = band.centre
        if place == column:
            place += top_of_three(*self.strength[row, column - 1 : column + 2].tolist())
        offset = float(self.offsets[0] + place * STEP_PX)
        if abs(offset) > self.reach_px:
            return None
        return Found(self.angle_of(row), offset, 0.0, band.width_px)


@lru_cache(maxsize=8)
def _weights(directions: int, samples: int, reach_px: float) -> Values:
    """(3 A, T) how much a band counts by its distance and the stretch it is seen on."""
    offsets = (np.arange(samples) - samples // 2) * STEP_PX
    near = np.exp(-((offsets / _NEARNESS_PX) ** 2))
    near[np.abs(offsets) > reach_px + STEP_PX] = 0.0
    return np.asarray(np.tile(_SIDES, directions)[:, None] * near[None], dtype=np.float32)


def _is_fringe(band: Band, profile: Values) -> bool:
    """Whether a band is what sharpening makes of the ground beside a stronger one."""
    half = round(band.width_px / 2 / STEP_PX)
    reach = round(_FRINGE_PX / STEP_PX)
    first, last = (round(band.centre) + side * half for side in (-1, 1))
    left, right = profile[max(0, first - reach) : max(0, first)], profile[last + 1 : last + reach]
    middle = float(profile[round(band.centre)])
    steps = [middle - float(profile[ground]) for ground in (band.left, band.right)]
    for begin, side, step in ((max(0, first - reach), left, steps[0]), (last + 1, right, steps[1])):
        if not len(side):
            continue
        other = band_at(-profile, begin + int(side.argmin()))
        stronger = _STRONGER if step < _LOPSIDED * sum(steps) else _STRONGER_BESIDE
        if other is not None and other.contrast > stronger * band.contrast:
            return True
    return False


def _is_shown(band: Band, cuts: Values, sought: Sought) -> bool:
    """Whether a band is as wide as what is sought, and nearly every cut across shows it."""
    least, most = sought.width_px
    if band.contrast < _LEAST_CONTRAST:
        return False
    if sought.looks.kind == EDGE:
        steps = cuts[:, band.right] - cuts[:, band.left]
    else:
        if not least <= band.width_px <= most:
            return False
        if sought.looks.kind == BAR and band.level < _LEVEL:
            return False
        if sought.is_wide and band.balance < _BALANCED:
            return False  # a part of it
        middle = round(band.centre)
        inner = cuts[:, max(0, middle - 1) : middle + 2].mean(axis=1)
        steps = inner - (cuts[:, band.left] + cuts[:, band.right]) / 2
    return bool((steps > _SHOWN * band.contrast).mean() >= _SUPPORT)


def _filtered(profiles: Values, kernel: Values) -> Values:
    """(R, T, K) each colour's profile, filtered."""
    rows, samples, channels = profiles.shape
    flat = np.moveaxis(profiles, 2, 1).reshape(-1, samples)
    curved = cv2.filter2D(flat, -1, kernel, borderType=cv2.BORDER_REPLICATE)
    apart = np.asarray(curved, dtype=np.float32).reshape(rows, channels, samples)
    return np.moveaxis(apart, 1, 2)


def _strength(curved: Values, sought: Sought) -> Values:
    lengths = np.asarray(np.sqrt((curved * curved).sum(axis=-1)), dtype=np.float32)
    if sought.looks.kind == EDGE:
        return lengths
    return np.where(fits(curved, sought), lengths, 0.0).astype(np.float32)
