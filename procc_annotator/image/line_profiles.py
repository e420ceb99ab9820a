"""Intensity profiles across line markings: what is searched for, patches, bands, colour steps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.field.model import (
    ANY,
    ANY_LINE,
    BAR,
    BLACK,
    BLUE,
    DARKER,
    LIGHTER,
    LINE,
    ORANGE,
    RED,
    WHITE,
    YELLOW,
    Appearance,
)
from procc_annotator.image.pixels import PixelArray

MIN_WIDTH_PX, MAX_WIDTH_PX = 0.7, 14.0
_REFERENCE_PX, _BLURRED_LENGTH_PX = 960.0, 46.0  # a picture's width; a line's length, at half size
# Of the width a camera shows: blur, snow, worn paint. A bar is neither worn nor snowed on.
_MIN_WIDTH_RATIO, _MIN_WIDTH_RATIO_BAR, _MAX_WIDTH_RATIO, _BLUR_PX = 0.35, 0.65, 1.3, 1.0

_ASSUMED_VIEW_M = 100.0, 8.0  # how much of a field is in a picture, from side to side
_WIDE_LINE_PX = 3.0
_BLURRED_PX = 6.0


@dataclass(frozen=True, slots=True)
class LineTarget:
    """Paint to be found.

    Attributes:
        looks: its kind, tone and colour.
        width_px: (least, most) of the band, across it.
        bends: whether its direction changes along it.
        is_expected: whether a camera shows it there.
        is_wide: whether something narrower next to it could be a part of it.
        length_px: how far it goes on at least.
    """

    looks: Appearance = ANY_LINE
    width_px: tuple[float, float] = (MIN_WIDTH_PX, MAX_WIDTH_PX)
    bends: bool = False
    is_expected: bool = False
    is_wide: bool = False
    length_px: float = 0.0

    @property
    def is_pale_line(self) -> bool:
        """Return whether it is a line of known tone, which may be blurred, or far from a click."""
        return self.looks.kind == LINE and self.looks.tone != ANY

    def blurred(self, picture_px: int, shrink: int = 1) -> LineTarget:
        """The same as wide as motion makes it, and longer than players, in a picture of a width
        that is made so many times smaller."""
        widths = MAX_WIDTH_PX / shrink, MAX_WIDTH_PX * max(1.0, picture_px / _REFERENCE_PX) / shrink
        return replace(self, width_px=widths, length_px=_BLURRED_LENGTH_PX)

    @classmethod
    def of(
        cls, looks: Appearance, picture_px: int, px_per_metre: float | None = None
    ) -> LineTarget:
        """Return what an element looks like in a picture.

        Args:
            picture_px: the picture's width.
            px_per_metre: across the element; None if unknown.
        """
        if not looks.width_m:
            return cls(looks)
        if px_per_metre is None:
            least, most = (looks.width_m * picture_px / seen for seen in _ASSUMED_VIEW_M)
            if least < _WIDE_LINE_PX:
                return cls(looks, (MIN_WIDTH_PX, min(max(most, _BLURRED_PX), MAX_WIDTH_PX)))
            return cls(looks, (least, most))
        width = looks.width_m * px_per_metre
        # Nothing is seen narrower than what a lens and compression make of it.
        most = max(_MAX_WIDTH_RATIO * width + _BLUR_PX, _BLURRED_PX)
        least = (_MIN_WIDTH_RATIO_BAR if looks.kind == BAR else _MIN_WIDTH_RATIO) * width
        return cls(looks, (least, most), is_expected=True)


ANY_LINE_TARGET = LineTarget()


Values = NDArray[np.float32]

STEP_PX = 0.5  # between the samples of a cut
_REMAP_FLAGS = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP


@dataclass(frozen=True, eq=False)
class ImagePatch:
    """A position and its surroundings.

    Attributes:
        pixels: (h, w, 4) BGRA, a part of the picture.
        centre: of the position, px of the part.
    """

    pixels: PixelArray
    centre: tuple[float, float]

    @classmethod
    def around(
        cls, picture: PixelArray, point: tuple[float, float], reach_px: float, shrink: int = 1
    ) -> ImagePatch:
        """Return what is within a distance, at the picture's border less; so many times smaller."""
        x, y = point
        reach = math.ceil(reach_px) + 2
        left, top = max(0, round(x) - reach), max(0, round(y) - reach)
        part = picture[top : round(y) + reach + 1, left : round(x) + reach + 1]
        x, y = x - left, y - top
        if shrink == 1:
            return cls(part, (x, y))
        height, width = (max(1, side // shrink) for side in part.shape[:2])
        whole = part[: height * shrink, : width * shrink]
        small = cv2.resize(whole, (width, height), interpolation=cv2.INTER_AREA)
        inwards = (shrink - 1) / 2
        centre = (x - inwards) / shrink, (y - inwards) / shrink
        return cls(np.asarray(small, dtype=np.uint8), centre)

    def across(self, angle: float, offset_px: float) -> ImagePatch:
        """The same pixels around a place across a direction from the position."""
        x, y = self.centre
        return ImagePatch(
            self.pixels, (x - offset_px * math.sin(angle), y + offset_px * math.cos(angle))
        )

    def cuts(
        self, angles: Sequence[float], along_px: float, every_px: float, samples: int
    ) -> PixelArray:
        """Sample lines across directions through the position.

        Args:
            angles: (A,) of the directions, radians.
            along_px: how far along each the last cut is; the first one is as far back.
            every_px: between cuts.
            samples: of each cut to either side, `STEP_PX` apart.

        Returns:
            (cuts, A, 2 samples + 1, 4) BGRA; what is beyond the part mirrors it.
        """
        count, width = round(2 * along_px / every_px) + 1, 2 * samples + 1
        found = np.empty((count, len(angles), width, 4), dtype=np.uint8)
        (x, y), aside = self.centre, samples * STEP_PX
        for i, angle in enumerate(angles):
            cos, sin = math.cos(angle), math.sin(angle)
            from_x, from_y = x - along_px * cos + aside * sin, y - along_px * sin - aside * cos
            turned = np.array(
                [
                    [-STEP_PX * sin, every_px * cos, from_x],
                    [STEP_PX * cos, every_px * sin, from_y],
                ]
            )
            cv2.warpAffine(
                self.pixels,
                turned,
                (width, count),
                dst=found[:, i],
                flags=_REMAP_FLAGS,
                borderMode=cv2.BORDER_REFLECT,
            )
        return found


PROFILE_SIGMA_PX = 1.5
WIDE_BAND_PX = (
    5.0  # wider bands are flat on top: their centre is the middle between the half heights
)
_FLANK_PX = 8.0  # how far from a maximum the ground beside the band is looked for
_FAR_FLANK_PX = 14.0  # ... where the maximum is the rim of a wide band
_NEAR_EDGE_PX, _FAR_EDGE_PX = 1.5, 4.0  # where the grounds beside an edge are looked at
_MAX_IMBALANCE = 0.5  # share of the larger step from the ground that the smaller one has


@dataclass(frozen=True, slots=True)
class ProfileBand:
    """A band in a profile; indices are fractions of the profile's steps.

    Attributes:
        width_px: at half its height.
        left, right: where the ground next to it was taken.
        contrast: how much it stands out from the more similar of both grounds.
        balance: the share of that in how much it stands out from the other one.
        level: the share of its contrast that it has at its middle: less where one of two bands side
            by side is the paint.
    """

    centre: float
    width_px: float
    left: int
    right: int
    contrast: float
    balance: float = 1.0
    level: float = 1.0


def band_at(profile: Sequence[float], peak: int) -> ProfileBand | None:
    """The band around a maximum of a profile, which is higher than both its sides.

    Args:
        profile: (T,) values across, the band's are the larger.
        peak: index where the band is suspected.
    """
    top = max(profile[max(0, peak - 2) : peak + 3])
    left, right = _flanks(profile, peak, _FLANK_PX)
    low_left, low_right = min(left), min(right)
    steps = top - low_left, top - low_right
    if min(steps) < _MAX_IMBALANCE * max(steps):
        left, right = _flanks(profile, peak, _FAR_FLANK_PX)
        low_left, low_right = min(left), min(right)
        steps = top - low_left, top - low_right
    begin = _level_crossing(left, (top + low_left) / 2)
    end = _level_crossing(right, (top + low_right) / 2)
    if begin is None or end is None:
        return None
    width = (begin + end) * STEP_PX
    narrow = width <= WIDE_BAND_PX and min(steps) >= _MAX_IMBALANCE * max(steps)
    centre = float(peak) if narrow else peak + (end - begin) / 2
    middle = profile[min(max(round(centre), 0), len(profile) - 1)]
    level = 1.0 - (top - middle) / max(min(steps), 1.0)
    grounds = peak - left.index(low_left), peak + right.index(low_right)
    return ProfileBand(centre, width, *grounds, min(steps), min(steps) / max(steps), level)


def edge_at(profile: Sequence[float], peak: int) -> ProfileBand | None:
    """The edge at a place where a profile rises from its left to its right."""
    near, far = round(_NEAR_EDGE_PX / STEP_PX), round(_FAR_EDGE_PX / STEP_PX)
    low, high = profile[max(0, peak - far) : peak - near + 1], profile[peak + near : peak + far + 1]
    if not low or not high:
        return None
    step = sum(high) / len(high) - sum(low) / len(low)
    middle = (near + far) // 2
    return ProfileBand(float(peak), 0.0, peak - middle, peak + middle, step)


def _flanks(
    profile: Sequence[float], peak: int, reach_px: float
) -> tuple[Sequence[float], Sequence[float]]:
    """The values from a peak outwards, to its left and to its right."""
    reach = round(reach_px / STEP_PX)
    return profile[max(0, peak - reach) : peak + 1][::-1], profile[peak : peak + reach + 1]


def _level_crossing(falling: Sequence[float], level: float) -> float | None:
    """Return where values that begin above a level first fall below it, in steps; None: never."""
    before = falling[0]
    if before < level:
        return None
    for i, after in enumerate(falling):
        if after < level:
            return i - 1 + (before - level) / (before - after)
        before = after
    return None


@cache
def curvature_kernel() -> Values:
    """(1, n) minus the second derivative of a Gaussian; flat ground gives 0."""
    sigma = PROFILE_SIGMA_PX / STEP_PX
    t = np.arange(-math.ceil(4 * sigma), math.ceil(4 * sigma) + 1) / sigma
    kernel = (1 - t**2) * np.exp(-(t**2) / 2)
    return np.asarray(kernel - kernel.mean(), dtype=np.float32)[None]


@cache
def gradient_kernel() -> Values:
    """(1, n) the derivative of a Gaussian, as cv2.filter2D applies it."""
    sigma = PROFILE_SIGMA_PX / STEP_PX
    t = np.arange(-math.ceil(4 * sigma), math.ceil(4 * sigma) + 1) / sigma
    return np.asarray(t * np.exp(-(t**2) / 2), dtype=np.float32)[None]


def parabola_peak(before: float, peak: float, after: float) -> float:
    """Return where between -0.5 and 0.5 the top of a parabola through three values lies."""
    bend = before - 2 * peak + after
    return 0.0 if bend >= 0 else 0.5 * (before - after) / bend


def median_of_nine(cuts: PixelArray) -> PixelArray:
    """(...) of (9, ...): the median of three medians of three.

    Nearly as robust as the median of nine, at a tenth of the time.
    """
    thirds = _median_of_three(cuts[0:3], cuts[3:6], cuts[6:9])
    return _median_of_three(thirds[0], thirds[1], thirds[2])


def _median_of_three(a: PixelArray, b: PixelArray, c: PixelArray) -> PixelArray:
    return np.maximum(np.minimum(a, b), np.minimum(np.maximum(a, b), c))


# Weights of blue, green and red in what must grow from the ground to the paint.
_COLOUR_DIRECTIONS = {
    RED: (-0.5, -0.5, 1.0),
    ORANGE: (-1.0, 0.0, 1.0),
    YELLOW: (-1.0, 0.5, 0.5),
    BLUE: (1.0, -0.3, -0.7),
}
_CHANNELS = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)  # blue, green and red alone
_LIGHTNESS_SIGN = {LIGHTER: 1.0, DARKER: -1.0, WHITE: 1.0, BLACK: -1.0}
# Of the step's length. Video halves the resolution of colour: a thin line differs from its flanks
# in brightness alone, and only what has another colour than the paint can be separated.
_MIN_GROWTH = -0.2
_MAX_LOSS = 0.15  # of white paint in any channel


def matches_colour_step(steps: Values, sought: LineTarget) -> NDArray[np.bool_]:
    """Which steps of colour the sought paint could make.

    Args:
        steps: (n, 4) BGRA, paint minus ground, of any length; alpha is left out.

    Returns:
        (n,).
    """
    weights, least = _colour_conditions(sought.looks)
    bgr = steps[:, :3]
    lengths = np.sqrt(np.einsum("nk,nk->n", bgr, bgr)) + 1e-6
    good: NDArray[np.bool_] = (weights @ bgr.T > least * lengths).all(axis=0)
    return good


@lru_cache(maxsize=64)
def _colour_conditions(looks: Appearance) -> tuple[Values, Values]:
    """(m, 3) weights of blue, green and red in what must be more than (m, 1) shares of a step's
    length."""
    tone, colour = looks.tone, looks.colour
    if looks.kind == BAR and tone == ANY and colour in _LIGHTNESS_SIGN:
        colour = ANY  # before anything: white in the shade is darker than what is lit behind it
    rows = [((_LIGHTNESS_SIGN[word],) * 3, 0.0) for word in {tone, colour} & _LIGHTNESS_SIGN.keys()]
    rows += [
        (_COLOUR_DIRECTIONS[word], _MIN_GROWTH)
        for word in {tone, colour} & _COLOUR_DIRECTIONS.keys()
    ]
    if colour == WHITE:
        rows += [(channel, -_MAX_LOSS) for channel in _CHANNELS]
    weights, least = [row[0] for row in rows], [row[1] for row in rows]
    return (
        np.array(weights, dtype=np.float32).reshape(-1, 3),
        np.array(least, dtype=np.float32).reshape(-1, 1),
    )


@dataclass(frozen=True, eq=False)
class StraightenedCurve:
    """A curve's surroundings.

    Attributes:
        colours: (n, m, 3) BGR, one row a place along the curve, one column an offset across it.
        offsets_px: (m,) evenly spaced, symmetric about 0.
    """

    colours: Values
    offsets_px: FloatArray

    def columns(self, first_px: float, last_px: float) -> slice:
        """The columns between two offsets, both included; at least one."""
        step = self.offsets_px[1] - self.offsets_px[0]
        begin = round((first_px - self.offsets_px[0]) / step)
        end = round((last_px - self.offsets_px[0]) / step)
        begin = min(max(begin, 0), len(self.offsets_px) - 1)
        return slice(begin, min(max(end, begin), len(self.offsets_px) - 1) + 1)


def straighten_curve(
    picture: PixelArray,
    course_px: FloatArray,
    across: FloatArray,
    reach_px: float,
) -> StraightenedCurve:
    """Cut a curve's surroundings out of a picture.

    Args:
        picture: (H, W, 4) BGRA.
        course_px: (n, 2) places along the curve, picture px.
        across: (n, 2) unit vectors across it.

    Returns:
        Bilinearly interpolated and rounded; beyond the picture its last row or column is repeated.
    """
    half = round(reach_px / STEP_PX)
    offsets = np.arange(-half, half + 1, dtype=np.float64) * STEP_PX
    values = cut_strip(picture, course_px, across, half)[..., :3]
    return StraightenedCurve(values.astype(np.float32), offsets)


def cut_strip(
    picture: PixelArray, course_px: FloatArray, across: FloatArray, half: int
) -> PixelArray:
    """(n, 2 half + 1, 4) BGRA across each place of a curve, `STEP_PX` apart, of (n, 2) px and unit
    normals; beyond the picture its last row or column is repeated."""
    offsets = (np.arange(-half, half + 1) * STEP_PX).astype(np.float32)
    places, normals = course_px.astype(np.float32), across.astype(np.float32)
    x, y = (places[:, k, None] + normals[:, k, None] * offsets for k in (0, 1))
    strip = cv2.remap(picture, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(strip, dtype=np.uint8)
