"""The finder of paint: clicks are put on the middle of the band that is sought, or stay.

Profiles across the line are averaged along it; the centre is where the smoothed profile curves
most (Steger 1998, "An unbiased detector of curvilinear structures", without its width model), in
the colour that tells the band from its flanks. A band convinces when nearly every cut across shows
it, when it is as wide and as coloured as what is sought, and when it goes on along the line. Of two
that convince as much neither does.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import islice

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.appearance import ANY, BAR, EDGE, LIGHTER, NOTHING, WHITE
from procc_annotator.image.colour_step import fits
from procc_annotator.image.cuts import STEP_PX, Patch, Values
from procc_annotator.image.following import REACH_PX as FOLLOWED_PX
from procc_annotator.image.following import follow
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.profile import (
    Band,
    band_at,
    curvature_kernel,
    edge_at,
    gradient_kernel,
    middle_of_nine,
    top_of_three,
)
from procc_annotator.image.sought import ANYTHING, WIDEST_PX, Sought

FloatArray = NDArray[np.float64]

REACH_PX = 6.0

_BEYOND_PX = 14.0  # a profile goes this far beyond the reach: the widest line and its side
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
_DIRECTIONS = 12
_FAN = np.array([-1.6, -0.8, -0.4, 0.0, 0.4, 0.8, 1.6])  # of the angle between two directions
_SPREAD = np.radians([0.0, -5.0, 5.0])  # how a line may be turned against a given direction
_BAR_SPREAD = np.radians([0.0, -1.5, 1.5, -3.0, 3.0])
_NEARNESS_PX = 8.0  # a band at this distance counts less than half of one at none
_LEAST_CONTRAST = 16.0  # of 255
_SHOWN = 0.4  # of the contrast: what a cut must have to show the band
_SUPPORT = 0.62  # share of the cuts that must show it
_TRIED = 4  # maxima looked at, the most convincing first
_LEAST_LENGTH_PX = 16.0
_MOST_TURN = math.radians(8.0)  # of the band against a given direction
# Of the best one's merit: another band that convinces nearly as much; where paint may be lighter or
# darker than its ground, anything that convinces.
_RIVAL, _RIVAL_ANY = 0.7, 0.25
_APART_PX = 2.5
_RECENTRED_PX = 2.0
_FRINGE_PX = 6.0  # from a band's edge: where a stronger one of the opposite tone may lie
_STRONGER = 1.2
_LOPSIDED, _STRONGER_BESIDE = 0.62, 0.6  # ... on the side to which most of a band's step leads


@dataclass(frozen=True, slots=True)
class _Found:
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
        return _foot(self.angle, self.offset)


def _foot(angle: float, offset: float) -> tuple[float, float]:
    return -offset * math.sin(angle), offset * math.cos(angle)


def snap(
    picture: PixelArray,
    point: tuple[float, float],
    sought: Sought = ANYTHING,
    *,
    direction: tuple[float, float] | None = None,
    reach_px: float = REACH_PX,
) -> tuple[float, float] | None:
    """Move a position to the middle of the paint beside it, across the line only.

    Args:
        picture: (H, W, 4) BGRA.
        point: picture px, pixel centres are whole numbers.
        sought: what the paint looks like.
        direction: of the line there, in px; None to find it in the picture.
        reach_px: how far the paint's middle may be.

    Returns:
        Picture px, or None without convincing paint within reach.
    """
    height, width = picture.shape[:2]
    x, y = point
    inside = -0.5 <= x <= width - 0.5 and -0.5 <= y <= height - 0.5
    if sought.looks.kind == NOTHING or not inside:
        return None
    wide = math.ceil(sought.width_px[1] / WIDEST_PX)
    if wide > 1:
        return _snap_wide(picture, point, sought, direction, reach_px, wide)
    patch = _patch(picture, point, reach_px)
    if direction is None:
        return _snap_any_way(picture, patch, point, sought, reach_px)
    return _snap_along(patch, point, sought, direction, reach_px)


def _snap_wide(
    picture: PixelArray,
    point: tuple[float, float],
    sought: Sought,
    direction: tuple[float, float] | None,
    reach_px: float,
    shrink: int,
) -> tuple[float, float] | None:
    """A band too wide to be looked at as it is, found in a smaller picture."""
    if direction is None:
        return None
    least, most = (width / shrink for width in sought.width_px)
    smaller = Sought(sought.looks, (least, most))
    reach = math.hypot(reach_px / shrink + _BEYOND_PX, FOLLOWED_PX) * shrink
    patch = Patch.around(picture, point, reach, shrink)
    placed = _snap_along(patch, (0.0, 0.0), smaller, direction, reach_px / shrink)
    if placed is None:
        return None
    return point[0] + placed[0] * shrink, point[1] + placed[1] * shrink


def _snap_along(
    patch: Patch,
    point: tuple[float, float],
    sought: Sought,
    direction: tuple[float, float],
    reach_px: float,
) -> tuple[float, float] | None:
    """The place beside a point on the band that runs in a direction."""
    angle = math.atan2(direction[1], direction[0])
    spread = _BAR_SPREAD if sought.looks.kind == BAR else _SPREAD

    def goes_on(found: _Found) -> _Found | None:
        course = follow(patch, found.angle, found.offset, found.width, sought)
        if course is None or course.length_px < _LEAST_LENGTH_PX:
            return None
        return found if abs(found.angle + course.turn - angle) <= _MOST_TURN else None

    maxima = _Maxima.of(patch, angle + spread, sought, reach_px)
    found = _convincing(maxima, goes_on, unsure=sought.looks.tone == ANY)
    if found is None:
        return None
    across = found.offset / math.cos(found.angle - angle)
    return point[0] - across * math.sin(angle), point[1] + across * math.cos(angle)


def snap_all(
    picture: PixelArray,
    points: FloatArray,
    directions: FloatArray | None = None,
    sought: Sought = ANYTHING,
    *,
    reach_px: float = REACH_PX,
) -> FloatArray:
    """Move many positions to the middle of their paint; see `snap`.

    Args:
        picture: (H, W, 4) BGRA.
        points: (N, 2) picture px.
        directions: (N, 2) of the lines there, or None.
        sought: what the paint looks like.
        reach_px: how far the paint's middle may be.

    Returns:
        (N, 2) picture px; NaN where there is no convincing paint.
    """
    found = np.full((len(points), 2), np.nan)
    for i, (x, y) in enumerate(points.tolist()):
        along = None if directions is None else (float(directions[i, 0]), float(directions[i, 1]))
        placed = snap(picture, (x, y), sought, direction=along, reach_px=reach_px)
        if placed is not None:
            found[i] = placed
    return found


def _patch(picture: PixelArray, point: tuple[float, float], reach_px: float) -> Patch:
    return Patch.around(picture, point, math.hypot(reach_px + _BEYOND_PX, FOLLOWED_PX))


def _snap_any_way(
    picture: PixelArray,
    patch: Patch,
    point: tuple[float, float],
    sought: Sought,
    reach_px: float,
) -> tuple[float, float] | None:
    """The click's foot on the band that is seen in whatever direction."""
    turn = math.pi / _DIRECTIONS
    angles = np.arange(_DIRECTIONS) * turn

    def place(found: _Found) -> _Found | None:
        # Seen from its own centre, a line tells its direction best.
        across = -math.sin(found.angle), math.cos(found.angle)
        x, y = (c + found.offset * a for c, a in zip(point, across, strict=True))
        centred = _patch(picture, (x, y), reach_px)
        finer = _Maxima.of(centred, found.angle + _FAN * turn, sought, reach_px).best()
        if finer is None or abs(finer.offset) > _RECENTRED_PX:
            return None
        course = follow(centred, finer.angle, finer.offset, finer.width, sought)
        if course is None or course.length_px < _LEAST_LENGTH_PX:
            return None
        # The click's foot on it is wanted.
        across = -math.sin(finer.angle), math.cos(finer.angle)
        foot = finer.offset + (x - point[0]) * across[0] + (y - point[1]) * across[1]
        return replace(finer, offset=foot) if abs(foot) <= reach_px else None

    found = _convincing(_Maxima.of(patch, angles, sought, reach_px), place, unsure=True)
    if found is None:
        return None
    return (
        point[0] - found.offset * math.sin(found.angle),
        point[1] + found.offset * math.cos(found.angle),
    )


def _convincing(
    maxima: _Maxima, confirmed: Callable[[_Found], _Found | None], *, unsure: bool
) -> _Found | None:
    """The best band that is confirmed, unless another one does nearly as well."""
    best: _Found | None = None
    rival = _RIVAL_ANY if unsure else _RIVAL
    tried = 0
    for row, column, offset, merit in maxima.ordered():
        if best is not None:
            if merit < rival * best.merit:
                break
            angle = float(maxima.angles[row // len(_SIDES)])
            if math.dist(_foot(angle, offset), best.foot) < _APART_PX:
                continue
        found = maxima.band(row, column)
        if found is None or (found := confirmed(found)) is None:
            tried += 1
            if tried == _TRIED:
                break
            continue
        if best is not None:
            if math.dist(found.foot, best.foot) < _APART_PX:
                continue
            return None
        best = replace(found, merit=merit)
    return best


@dataclass(frozen=True, eq=False)
class _Maxima:
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
    def of(cls, patch: Patch, angles: FloatArray, sought: Sought, reach_px: float) -> _Maxima:
        """Look for paint in several directions through a patch's position."""
        looks = sought.looks
        pale = looks.tone == LIGHTER and looks.colour in (WHITE, ANY) and looks.kind != EDGE
        half = math.ceil((reach_px + _BEYOND_PX) / STEP_PX)
        offsets = np.arange(-half, half + 1) * STEP_PX
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

    def best(self) -> _Found | None:
        """The strongest and nearest band."""
        found = (self.band(row, column) for row, column, *_ in islice(self.ordered(), _TRIED))
        return next((band for band in found if band is not None), None)

    def band(self, row: int, column: int) -> _Found | None:
        """The band at a maximum, if there is one that looks like what is sought."""
        colour = self.curved[row, column]
        colour = colour / math.sqrt(float(colour @ colour))
        looks, profile = self.sought.looks, self.profiles[row] @ colour
        if looks.kind == EDGE:
            band = edge_at(profile, column)
        else:
            band = band_at(profile, column)
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
        return _Found(float(self.angles[row // len(_SIDES)]), offset, 0.0, band.width_px)


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
        middle = round(band.centre)
        inner = cuts[:, max(0, middle - 1) : middle + 2].mean(axis=1)
        steps = inner - (cuts[:, band.left] + cuts[:, band.right]) / 2
    return bool((steps > _SHOWN * band.contrast).mean() >= _SUPPORT)


def _filtered(profiles: Values, kernel: Values) -> Values:
    """(R, T, K) each colour's profile, filtered."""
    rows, samples, channels = profiles.shape
    flat = np.moveaxis(profiles, 2, 1).reshape(-1, samples)
    curved = cv2.filter2D(flat, -1, kernel, borderType=cv2.BORDER_REPLICATE)
    return np.moveaxis(curved.reshape(rows, channels, samples), 1, 2)


def _strength(curved: Values, sought: Sought) -> Values:
    lengths = np.sqrt((curved * curved).sum(axis=-1))
    if sought.looks.kind == EDGE:
        return lengths
    return np.where(fits(curved, sought), lengths, 0.0).astype(np.float32)
