"""Candidate line bands through an image point, and how far each continues along its direction."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

import cv2
import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.field.model import ANY, BAR, EDGE, LIGHTER, WHITE
from procc_annotator.image.line_profiles import (
    STEP_PX,
    ImagePatch,
    LineTarget,
    ProfileBand,
    Values,
    band_at,
    curvature_kernel,
    edge_at,
    gradient_kernel,
    matches_colour_step,
    median_of_nine,
    parabola_peak,
)
from procc_annotator.image.pixels import PixelArray

MARGIN_PX = 14.0  # a profile goes this far beyond the reach: the widest line and its side
MAX_CANDIDATES = 8  # maxima looked at, the most convincing first

_HALF_LENGTH_PX = 8.0  # a profile is averaged at most this far along the line
_PROFILE_SPACING_PX = 1.0  # between the cuts that it is averaged of
# Both ways; and one way only, since an element's ends lie where its line ends or meets another.
# Of 17 cuts.
_STRETCHES = np.column_stack(([2, 3, 5, 6, 8, 10, 11, 13, 14], [*range(8, 17)], [*range(9)]))
_STRETCH_WEIGHTS = np.array([1.0, 0.75, 0.75])  # a band that is seen on one side only counts less
_BAR_LENGTH_FACTOR = 2.0  # bars are straight: what is behind them averages out
_PROFILE_POSITIONS_PX = tuple(
    tuple(float(i) * _PROFILE_SPACING_PX - _HALF_LENGTH_PX for i in of) for of in _STRETCHES.T
)
_BAR_PROFILE_POSITIONS_PX = tuple(
    tuple(_BAR_LENGTH_FACTOR * px for px in of) for of in _PROFILE_POSITIONS_PX
)
_DISTANCE_SCALE_PX = 8.0  # a band at this distance counts less than half of one at none
MIN_BAND_CONTRAST = 16.0  # of 255
# Of the grounds next to a band and of three samples in its middle: its step in one cut.
_BAND_STEP = np.array([-1 / 2, 1 / 3, 1 / 3, 1 / 3, -1 / 2], dtype=np.float32)
_EDGE_STEP = np.array([-1, 0, 0, 0, 1], dtype=np.float32)
_MIN_SEEN_CONTRAST = 0.4  # of the contrast: what a cut must have to show the band
_MIN_SUPPORT = 0.62  # share of the cuts that must show it
_MIN_LEVEL = 0.7
_MIN_BALANCE = 0.6
_HALO_WIDTH_PX = 6.0  # from a band's edge: where a stronger one of the opposite tone may lie
_HALO_STRENGTH_RATIO = 1.2
# ... on the side to which most of a band's step leads
_MIN_BALANCE_EDGE, _MIN_RIVAL_RATIO = 0.62, 1.0


@dataclass(frozen=True, slots=True)
class LineBand:
    """A band through a patch: its direction, and where across the position it is, px.

    ``merit``: how sharp and near it is; comparable within one patch. ``along``: where along the
    direction the middle of the cuts lies that show it, px; at an end that is next to the position.
    """

    angle: float
    offset: float
    merit: float
    width: float
    along: float

    @property
    def foot(self) -> tuple[float, float]:
        """From the position to the band's middle, px."""
        return closest_offset(self.angle, self.offset)


def closest_offset(angle: float, offset: float) -> tuple[float, float]:
    return -offset * math.sin(angle), offset * math.cos(angle)


@dataclass(frozen=True, eq=False)
class BandMaxima:
    """Maxima of curvature of profiles in several directions, with data for refinement.

    Attributes:
        angles: (A,) radians; each has a row in each of three blocks, one a stretch.
        offsets: (T,) px across.
        cuts: (9, 3 A, T, K) BGRA, or the smallest of the colours.
        profiles: (3 A, T, K) along the cuts.
        near: the first of the N columns that may be within reach.
        curved: (3 A, N, K) how the profiles curve there.
        strength: (3 A, N) how much they curve the way the sought paint does.
    """

    angles: FloatArray
    offsets: FloatArray
    cuts: PixelArray
    profiles: Values
    near: int
    curved: Values
    strength: Values
    sought: LineTarget
    reach_px: float

    @classmethod
    def of(
        cls, patch: ImagePatch, angles: FloatArray, sought: LineTarget, reach_px: float
    ) -> BandMaxima:
        """Look for paint in several directions through a patch's position."""
        looks = sought.looks
        pale = looks.tone == LIGHTER and looks.colour in (WHITE, ANY) and looks.kind != EDGE
        half = math.ceil((reach_px + MARGIN_PX) / STEP_PX)
        offsets = np.arange(-half, half + 1, dtype=np.float64) * STEP_PX
        longer = _BAR_LENGTH_FACTOR if looks.kind == BAR else 1.0
        along, every = longer * _HALF_LENGTH_PX, longer * _PROFILE_SPACING_PX
        all_cuts = patch.cuts(angles.tolist(), along, every, half)
        if pale:  # the smallest colour shows white paint on saturated ground best
            blue, green, red = (all_cuts[..., k : k + 1] for k in range(3))
            all_cuts = np.minimum(np.minimum(blue, green), red)
        cuts = all_cuts.take(_STRETCHES, axis=0).reshape(len(_STRETCHES), -1, *all_cuts.shape[2:])
        profiles = median_of_nine(cuts).astype(np.float32)
        near = half - math.ceil(reach_px / STEP_PX) - 2
        kernel = gradient_kernel() if looks.kind == EDGE else curvature_kernel()
        curved = _filter_profiles(profiles, kernel, near)
        strength = curved[..., 0] if pale else _response_strength(curved, sought)
        return cls(angles, offsets, cuts, profiles, near, curved, strength, sought, reach_px)

    def ordered(self) -> Iterator[tuple[int, int, float, float]]:
        """Row, column, offset and merit of each maximum, the strongest and nearest first."""
        inner = self.strength[:, 1:-1]
        merits = inner * _distance_weights(len(self.angles), inner.shape[1], self.reach_px)
        peaks = (inner >= self.strength[:, :-2]) & (inner > self.strength[:, 2:]) & (merits > 0)
        rows, columns = peaks.nonzero()
        values = merits[rows, columns]
        order = (-values).argsort()
        rows, columns = rows[order], columns[order] + self.near + 1
        offsets = self.offsets[columns]
        return zip(
            rows.tolist(), columns.tolist(), offsets.tolist(), values[order].tolist(), strict=True
        )

    def angle_of(self, row: int) -> float:
        """The direction of a row, radians."""
        return float(self.angles[row % len(self.angles)])

    @property
    def along(self) -> tuple[tuple[float, ...], ...]:
        """Return where the cuts of each stretch lie along the direction, px."""
        return _BAR_PROFILE_POSITIONS_PX if self.sought.looks.kind == BAR else _PROFILE_POSITIONS_PX

    def stretch_of(self, row: int) -> int:
        """The stretch of a row: both ways, ahead, back."""
        return row // len(self.angles)

    def middle_of(self, row: int) -> float:
        """Return where along the direction the middle of a row's cuts lies, px."""
        along = self.along[self.stretch_of(row)]
        return along[len(along) // 2]

    def best(self) -> LineBand | None:
        """The strongest and nearest band."""
        found = (
            self.band(row, column) for row, column, *_ in islice(self.ordered(), MAX_CANDIDATES)
        )
        return next((band for band in found if band is not None), None)

    def band(self, row: int, column: int) -> LineBand | None:
        """The band at a maximum, if there is one that looks like what is sought."""
        at = column - self.near
        colour = self.curved[row, at]
        colour = colour / math.sqrt(float(colour @ colour))
        looks, profile = self.sought.looks, (self.profiles[row] @ colour).tolist()
        band = (edge_at if looks.kind == EDGE else band_at)(profile, column)
        if band is None or not _matches_target(band, self.sought):
            return None
        shown = _profiles_with_band(band, self.cuts[:, row], colour, edge=looks.kind == EDGE)
        if len(shown) < _MIN_SUPPORT * len(self.cuts):
            return None
        if looks.tone == ANY and looks.kind != EDGE and _is_sharpening_halo(band, profile):
            return None
        place = band.centre
        if place == column:
            place += parabola_peak(*self.strength[row, at - 1 : at + 2].tolist())
        offset = float(self.offsets[0]) + place * STEP_PX
        if abs(offset) > self.reach_px:
            return None
        along = self.along[self.stretch_of(row)]
        middle = sum(along[cut] for cut in shown) / len(shown)
        return LineBand(self.angle_of(row), offset, 0.0, band.width_px, middle)


@lru_cache(maxsize=8)
def _distance_weights(directions: int, samples: int, reach_px: float) -> Values:
    """(3 A, T) how much a band counts by its distance and the stretch it is seen on."""
    offsets = (np.arange(samples) - samples // 2) * STEP_PX
    near = np.exp(-((offsets / _DISTANCE_SCALE_PX) ** 2))
    near[np.abs(offsets) > reach_px + STEP_PX] = 0.0
    return np.asarray(
        np.repeat(_STRETCH_WEIGHTS, directions)[:, None] * near[None], dtype=np.float32
    )


def _matches_target(band: ProfileBand, sought: LineTarget) -> bool:
    """Return whether a band stands out, and is as wide as what is sought."""
    least, most = sought.width_px
    kind = sought.looks.kind
    if band.contrast < MIN_BAND_CONTRAST or kind == EDGE:
        return band.contrast >= MIN_BAND_CONTRAST
    if not least <= band.width_px <= most or (kind == BAR and band.level < _MIN_LEVEL):
        return False
    return band.balance >= _MIN_BALANCE or not sought.is_wide  # else a part of it


def _profiles_with_band(
    band: ProfileBand, cuts: PixelArray, colour: Values, *, edge: bool
) -> list[int]:
    middle = round(band.centre)
    columns = np.array([band.left, middle - 1, middle, middle + 1, band.right])
    weights = (_EDGE_STEP if edge else _BAND_STEP)[:, None] * colour
    steps = cuts[:, columns].reshape(len(cuts), -1) @ weights.reshape(-1)
    least = _MIN_SEEN_CONTRAST * band.contrast
    return [cut for cut, step in enumerate(steps.tolist()) if step > least]


def _is_sharpening_halo(band: ProfileBand, profile: Sequence[float]) -> bool:
    """Return whether a band is what sharpening makes of the ground next to a stronger one."""
    half = round(band.width_px / 2 / STEP_PX)
    reach = round(_HALO_WIDTH_PX / STEP_PX)
    first, last = (round(band.centre) + side * half for side in (-1, 1))
    begin = max(0, first - reach)
    left, right = profile[begin : max(0, first)], profile[last + 1 : last + reach]
    middle = profile[round(band.centre)]
    steps = middle - profile[band.left], middle - profile[band.right]
    turned = [-value for value in profile]
    for start, side, step in ((begin, left, steps[0]), (last + 1, right, steps[1])):
        if not side:
            continue
        other = band_at(turned, start + side.index(min(side)))
        stronger = (
            _HALO_STRENGTH_RATIO if step < _MIN_BALANCE_EDGE * sum(steps) else _MIN_RIVAL_RATIO
        )
        if other is not None and other.contrast > stronger * band.contrast:
            return True
    return False


def _filter_profiles(profiles: Values, kernel: Values, near: int) -> Values:
    """(R, N, K) each colour's profile, filtered; without so many columns at both ends."""
    rows, _, channels = profiles.shape
    curved = cv2.filter2D(profiles, -1, kernel, borderType=cv2.BORDER_REPLICATE)
    return np.asarray(curved, dtype=np.float32).reshape(rows, -1, channels)[:, near:-near]


def _response_strength(curved: Values, sought: LineTarget) -> Values:
    colours = curved.reshape(-1, curved.shape[-1])
    lengths = np.sqrt(np.einsum("nk,nk->n", colours, colours))
    if sought.looks.kind != EDGE:
        lengths[~matches_colour_step(colours, sought)] = 0.0
    return np.asarray(lengths.reshape(curved.shape[:-1]), dtype=np.float32)


MAX_TRACE_PX = 24.0  # along, to either side
_STEP_ALONG_PX = 2.0
_SEARCH_ASIDE_PX = 4.0  # how far it may bend away
_MAX_TURN_STEPS = 2  # steps across that it may move from one place to the next
_FLANK_RANGE = 0.75, 2.75  # px from the band's edge: where the ground is looked at
_MIN_COLOUR_STEP = 10.0  # of 255
_SAME_STEP_RATIO = 0.4  # of the step at the middle
_STRONGER_STEP_RATIO = 1.8  # ... where paint may be lighter or darker: another band's
_SAME_COLOUR = 0.8  # cosine
_SMOOTHNESS_PENALTY = 0.1  # of the usual step: for less it does not move across
_START_OFFSETS = 0, 4, -4  # places along
_REFERENCE_SAMPLES = 5  # over so many places to either side its turn is measured


@dataclass(frozen=True, slots=True)
class LineExtent:
    """Extent of a band without a gap.

    Attributes:
        length_px: both ways together.
        turn: of it against the direction in which it was followed, radians.
        begin_px: where along that direction it was begun.
    """

    length_px: float
    turn: float
    start_px: float


def trace_line(
    patch: ImagePatch, angle: float, offset_px: float, width_px: float, sought: LineTarget
) -> Iterator[LineExtent]:
    """Follow a band or an edge both ways.

    Args:
        patch: reaching `REACH_PX` farther than the band's place.
        angle: of the band, radians.
        offset_px: of its middle from the patch's position, across.
        width_px: of the band; 0 of an edge.

    Returns:
        How far it goes on from its middle, then from ahead and from back of it: at an end another
        line lies in its ground. Nothing where it does not stand out, or has another colour.
    """
    left, right = _colour_steps_along(patch.across(angle, offset_px), angle, width_px)
    if sought.looks.kind == EDGE:
        left = right = left - right  # from one side to the other
    middle = len(left) // 2
    for begin in _START_OFFSETS:
        course = _extent_from(left, right, middle + begin, sought)
        if course is not None:
            yield course


def _extent_from(left: Values, right: Values, begin: int, sought: LineTarget) -> LineExtent | None:
    """From a place along, with the steps of colour there for the usual ones."""
    here, around = left.shape[1] // 2, slice(begin - 1, begin + 2)
    usual = (left[around, here] + right[around, here]).sum(axis=0) / 6
    size = math.sqrt(float(usual @ usual))
    if size < _MIN_COLOUR_STEP or not (
        sought.looks.kind == EDGE or matches_colour_step(usual[None], sought)[0]
    ):
        return None
    bar = sought.looks.kind == BAR
    found = _step_ratios(left, right, usual / size, around, here, bar=bar)
    if found is None:
        return None
    if sought.looks.tone == ANY:
        found[found > _STRONGER_STEP_RATIO] = 0.0
    shares = found.tolist()
    ahead, back = _track_band(shares[begin:], here), _track_band(shares[begin::-1], here)
    first, last = back[: _REFERENCE_SAMPLES + 1], ahead[: _REFERENCE_SAMPLES + 1]
    across, along = (last[-1] - first[-1]) * STEP_PX, (len(first) + len(last) - 2) * _STEP_ALONG_PX
    turn = math.atan2(across, along) if along else 0.0
    length = _STEP_ALONG_PX * (len(ahead) + len(back) - 1)
    return LineExtent(length, turn, _STEP_ALONG_PX * (begin - len(left) // 2))


def _colour_steps_along(patch: ImagePatch, angle: float, width_px: float) -> tuple[Values, Values]:
    """(n, m, 4) steps of colour from the left and the right ground to the band, at places along
    and offsets across."""
    near, far = (round((width_px / 2 + beside) / STEP_PX) for beside in _FLANK_RANGE)
    inner = round(max(0.5, 0.3 * width_px) / STEP_PX)
    aside = round(_SEARCH_ASIDE_PX / STEP_PX)
    half = far + aside + 1
    cuts = patch.cuts([angle], MAX_TRACE_PX, _STEP_ALONG_PX, half)[:, 0]

    def means(samples: int) -> Values:
        """Of so many samples across and three cuts along."""
        whole = cv2.boxFilter(cuts, cv2.CV_32F, (samples, 3))
        return np.asarray(whole[1:-1], dtype=np.float32)

    band, ground = means(2 * inner + 1), means(far - near + 1)
    anchor = (far - near + 1) // 2
    first, past = half - aside, half + aside + 1
    on_left, on_right = anchor - far, anchor + near
    here = band[:, first:past]
    return (
        here - ground[:, first + on_left : past + on_left],
        here - ground[:, first + on_right : past + on_right],
    )


def _step_ratios(
    left: Values, right: Values, direction: Values, around: slice, here: int, *, bar: bool
) -> Values | None:
    """(n, m) how much of the usual step there is; 0 where the colour is another one."""
    shape, flat = left.shape[:2], (-1, left.shape[2])
    on_left, on_right = ((side.reshape(flat) @ direction).reshape(shape) for side in (left, right))
    usual = [sorted(side[around, here].tolist())[1] for side in (on_left, on_right)]
    if bar:
        # Either side may be as bright as the bar for a while, never both.
        shares = np.maximum(on_left, on_right) / max(usual)
    else:
        if min(usual) < _MIN_COLOUR_STEP / 2:
            return None
        shares = np.minimum(on_left / usual[0], on_right / usual[1])
    both = (left + right).reshape(flat)
    lengths = np.sqrt(np.einsum("ij,ij->i", both, both)).reshape(shape) + 1e-6
    shares[on_left + on_right < _SAME_COLOUR * lengths] = 0.0
    return np.asarray(shares, dtype=np.float32)


def _track_band(shares: list[list[float]], here: int) -> list[int]:
    """Return where a band is at each place from the first one on, while it goes on, bending a
    little."""
    walked = [here]
    for row in shares[1:]:
        low = max(0, here - _MAX_TURN_STEPS)
        near = row[low : here + _MAX_TURN_STEPS + 1]
        most = max(near)
        if most < _SAME_STEP_RATIO:
            break
        if row[here] < most - _SMOOTHNESS_PENALTY:
            here = low + near.index(most)
        walked.append(here)
    return walked
