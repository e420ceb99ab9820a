"""Search for a line marking across each expected point; sub-pixel offsets."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Self

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.line_alignment.expected_lines import (
    ExpectedLinePoints,
    MarkingPoints,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.image.line_offsets import band_response, best_columns, colour_differences
from procc_annotator.image.pixels import PixelArray

Values = NDArray[np.float32]

STEP_PX = 0.5  # between samples of a cut
PROFILE_HALF_SAMPLES = 6  # samples to either side of where the line was found
_BLUR_SIGMAS_PX = (0.85, 1.3)  # standard deviations: of lenses, scaling and loss
_SHIFTS_PX = np.arange(-1.5, 1.51, 0.25)
_WIDTHS_PX = np.arange(0.25, 2.01, 0.25)


def line_centres(cuts: Values, width_px: FloatArray) -> FloatArray:
    """Return how far, px (n,), the middles of lines of a width (n,), px, at most 2, lie from those
    of their cuts (n, 2 * `PROFILE_HALF_SAMPLES` + 1, c) in c colours, `STEP_PX` apart."""
    kind = np.clip(np.round(width_px / _WIDTHS_PX[0]).astype(np.intp) - 1, 0, len(_WIDTHS_PX) - 1)
    level = (cuts - cuts.mean(axis=1, keepdims=True)).transpose(0, 2, 1)
    found = np.empty(len(cuts))
    for own in np.unique(kind).tolist():
        rows = np.flatnonzero(kind == own)
        found[rows] = _best_template_shifts(level[rows], _template_basis(own))
    return found


def _best_template_shifts(level: Values, ways: Values) -> FloatArray:
    """(n,) px, of (n, c, samples)."""
    blurs, shifts, two, samples = ways.shape
    told = level.reshape(-1, samples) @ ways.reshape(-1, samples).T
    told = told.reshape(len(level), -1, blurs, shifts, two)
    explained = (told * told).sum(axis=(1, 4)).astype(np.float64)
    rows = np.arange(len(level))
    blur = explained.max(axis=2).argmax(axis=1)
    of = explained[rows, blur]
    at = of.argmax(axis=1)
    inner = np.clip(at, 1, shifts - 2)
    left, middle, right = (of[rows, inner + away] for away in (-1, 0, 1))
    bend = np.maximum(2 * middle - left - right, 1e-9)
    part = np.clip((right - left) / (2 * bend), -0.5, 0.5)
    spacing = float(_SHIFTS_PX[1] - _SHIFTS_PX[0])
    return np.asarray(_SHIFTS_PX[at] + np.where(at == inner, part, 0.0) * spacing)


@lru_cache(maxsize=len(_WIDTHS_PX))
def _template_basis(kind: int) -> Values:
    """(blurs, shifts, 2, samples): what spans a step and a line of a width, less the mean."""
    half = float(_WIDTHS_PX[kind]) / 2
    places = np.arange(-PROFILE_HALF_SAMPLES, PROFILE_HALF_SAMPLES + 1) * STEP_PX
    found = []
    for blur in _BLUR_SIGMAS_PX:
        for shift in _SHIFTS_PX:
            at = places - shift
            line = _blurred_step((at + half) / blur) - _blurred_step((at - half) / blur)
            both = np.stack([_blurred_step(at / blur), line])
            both -= both.mean(axis=1, keepdims=True)
            found.append(np.linalg.qr(both.T)[0].T)
    shape = (len(_BLUR_SIGMAS_PX), len(_SHIFTS_PX), 2, len(places))
    return np.array(found, dtype=np.float32).reshape(shape)


def _blurred_step(places: FloatArray) -> FloatArray:
    """A step from 0 to 1 at 0, blurred by 1."""
    return np.array([(1 + math.erf(at / math.sqrt(2))) / 2 for at in places.tolist()])


# A cut is sampled in steps of a quarter of the band's width; of half a pixel where it is narrow.
_WIDTH_STEPS, _MIN_STEP_PX = 4, STEP_PX
_FLANK_GAP_STEPS, _FLANK_LENGTH_STEPS = 1, 3
_AVERAGED_NEIGHBOURS = 2  # to either side, whose cuts are averaged with a place's own
_PROFILE_MARGIN_STEPS = _WIDTH_STEPS // 2 + _FLANK_GAP_STEPS + _FLANK_LENGTH_STEPS
# Of a band's contrast: what the grounds next to a narrow line differ by, for its brightest place
# not to be its middle.
_FLANK_DIFFERENCE_RATIO = 2.0


@dataclass(frozen=True, eq=False)
class LineOffsets:
    """Paint next to n expected places.

    Attributes:
        px: (n,) solver px, how far along the normal the paint's middle lies.
        found: (n,) whether there is any, and no doubt which.
        contrast: (n,) grey levels of the band against the nearer of its flanks.
        around: (3, n, 3) BGR to both sides of the expected places (of `nearest_line_offsets` those
            of the paint), and where paint was found.
    """

    px: FloatArray
    found: NDArray[np.bool_]
    contrast: FloatArray
    around: Values

    def is_hidden(
        self, counted: NDArray[np.bool_], others: LineOffsets | None = None
    ) -> NDArray[np.bool_]:
        """Return (n,) where something else than the ground is in sight: to one side at least it
        has no colour that is usual on and next to the paint of the places that count, which are
        those of ``others`` if given."""
        shape = (int(256 / _COLOUR_STEP) + 2,) * 3
        own, flat = (
            np.ravel_multi_index(
                tuple(np.moveaxis((some.around / _COLOUR_STEP).astype(np.intp) + 1, -1, 0)), shape
            )
            for some in (self, others or self)
        )
        usual = np.bincount(flat[:, counted].ravel(), minlength=int(np.prod(shape)))
        usual = usual.reshape(shape)
        for axis in range(3):  # with the colours next to it
            usual = usual + np.roll(usual, 1, axis) + np.roll(usual, -1, axis)
        least = _MIN_COLOUR_SHARE * len(flat) * int(counted.sum())
        return np.asarray(usual.ravel()[own[:2]].min(axis=0) < max(least, 1.0))


# Colours alike differ by less than so much in each channel; usual is what one place in 50 has.
_COLOUR_STEP, _MIN_COLOUR_SHARE = 16.0, 0.02


def line_offsets(
    picture: PixelArray,
    expected: ExpectedLinePoints,
    painted: MarkingPoints,
    frame: ImageFrame,
    reach_px: float | FloatArray,
) -> LineOffsets:
    """Look for paint across each of n expected places in a picture (H, W, 4) BGRA, as far off as
    ``reach_px``, (n,) or one for all, solver px."""
    if not len(expected.rows):
        return _NO_OFFSETS
    cut = _LineProfiles.of(picture, expected, painted, frame, reach_px)
    return cut.offsets(*cut.best(reach_px))


def nearest_line_offsets(
    picture: PixelArray,
    expected: ExpectedLinePoints,
    painted: MarkingPoints,
    frame: ImageFrame,
    near_px: float,
    far_px: float,
) -> tuple[LineOffsets, NDArray[np.bool_]]:
    """Look for paint near every expected place, and if there is none farther off, as
    `line_offsets`; also says (n,) where it was found near."""
    if not len(expected.rows):
        return _NO_OFFSETS, _NO_OFFSETS.found
    cut = _LineProfiles.of(picture, expected, painted, frame, far_px)
    near, far = cut.best(near_px), cut.best(far_px)
    is_near = near[2]
    at, contrast, found = (np.where(is_near, *both) for both in zip(near, far, strict=True))
    return cut.offsets(at, contrast, found, flanks_at=at), is_near


_NO_OFFSETS = LineOffsets(
    np.zeros(0), np.zeros(0, dtype=bool), np.zeros(0), np.zeros((3, 0, 3), dtype=np.float32)
)


@dataclass(frozen=True, eq=False)
class _LineProfiles:
    """A picture cut across n places.

    Attributes:
        scale: solver px a px.
        step: (n,) px between the samples of a cut.
        half: samples to either side at which a band's middle may lie.
        cuts: (n, 2 (half + beyond) + 1, 3) BGR.
        values: the same in one tone, in which paint is lighter than what is next to it.
        response: (n, 2 half + 1) how much a band there stands out.
        separates_areas: (n,) whether an element is taken for an edge between two areas.
    """

    expected: ExpectedLinePoints
    scale: float
    step: FloatArray
    half: int
    cuts: PixelArray
    values: Values
    response: Values
    separates_areas: NDArray[np.bool_]

    @classmethod
    def of(
        cls,
        picture: PixelArray,
        expected: ExpectedLinePoints,
        painted: MarkingPoints,
        frame: ImageFrame,
        reach_px: float | FloatArray,
    ) -> Self:
        """As far as paint may be off, solver px."""
        step = np.maximum(expected.width_px / frame.scale / _WIDTH_STEPS, _MIN_STEP_PX)
        half = int(np.ceil((reach_px / frame.scale / step).max()))
        cuts = _sample_profiles(picture, expected, frame, step, half + _PROFILE_MARGIN_STEPS)
        tone = painted.tone[expected.rows]
        values, separates_areas = _profile_values(cuts, tone, painted.element[expected.rows])
        response = _neighbour_mean(band_response(values, _WIDTH_STEPS, half), expected.run)
        return cls(expected, frame.scale, step, half, cuts, values, response, separates_areas)

    def best(
        self, reach_px: float | FloatArray
    ) -> tuple[FloatArray, FloatArray, NDArray[np.bool_]]:
        """See `best_columns`, no farther off than so many solver px."""
        reach = np.broadcast_to(np.asarray(reach_px) / self.scale, self.step.shape)
        away = np.abs(np.arange(-self.half, self.half + 1)) * self.step[:, None]
        return best_columns(self.response, away <= reach[:, None])

    def offsets(
        self,
        at: FloatArray,
        contrast: FloatArray,
        found: NDArray[np.bool_],
        flanks_at: FloatArray | None = None,
    ) -> LineOffsets:
        """Return what is at columns (n,), in the middle of the paint; and to both sides of the
        expected places, or of other columns."""
        px = (at - self.half) * self.step
        narrow = np.flatnonzero(found & (self.step == _MIN_STEP_PX))
        column = _PROFILE_MARGIN_STEPS + np.rint(at[narrow]).astype(np.intp)
        unlike = self.separates_areas[narrow] | _is_between_surfaces(
            self.values, narrow, column, contrast[narrow]
        )
        if unlike.any():
            narrow, column = narrow[unlike], column[unlike]
            columns = column[:, None] + np.arange(-PROFILE_HALF_SAMPLES, PROFILE_HALF_SAMPLES + 1)
            cut = _neighbour_mean_colours(self.cuts, narrow, columns, self.expected)
            shift = line_centres(cut, self.expected.width_px[narrow] / self.scale)
            px[narrow] = (column - _PROFILE_MARGIN_STEPS - self.half) * _MIN_STEP_PX + shift
        middle, rows = (
            np.full(len(at), self.half) if flanks_at is None else flanks_at,
            np.arange(len(at)),
        )
        middle = np.rint(middle[:, None]).astype(np.intp) + _PROFILE_MARGIN_STEPS
        away = np.arange(_PROFILE_MARGIN_STEPS - _FLANK_LENGTH_STEPS + 1, _PROFILE_MARGIN_STEPS + 1)
        around = np.empty((3, len(at), 3), dtype=np.float32)
        around[0], around[1] = (
            self.cuts[rows[:, None], middle + side * away].mean(axis=1) for side in (1, -1)
        )
        around[2] = self.cuts[rows, _PROFILE_MARGIN_STEPS + np.rint(at).astype(np.intp)]
        return LineOffsets(px * self.scale, found, contrast, around)


def _sample_profiles(
    picture: PixelArray,
    expected: ExpectedLinePoints,
    frame: ImageFrame,
    step: FloatArray,
    half: int,
) -> PixelArray:
    """(n, 2 half + 1, 3) BGR across every place."""
    centre = np.array(frame.centre_px)[:, None]
    px = expected.px / frame.scale + centre
    along = np.arange(-half, half + 1) * step[:, None]
    x, y = (
        (px[axis][:, None] + expected.normal[axis][:, None] * along).astype(np.float32)
        for axis in (0, 1)
    )
    cut = cv2.remap(picture, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
    return np.asarray(cut[..., :3], dtype=np.uint8)


def _profile_values(
    cuts: PixelArray, tone: IntArray, element: IntArray
) -> tuple[Values, NDArray[np.bool_]]:
    """(n, m) of cuts, in which paint is lighter than what is next to it; (n,) whether that is an
    edge between two areas."""
    # White paint is light in all colours, coloured paint dark in one of them.
    lowest = np.minimum(np.minimum(cuts[..., 0], cuts[..., 1]), cuts[..., 2])
    values = lowest.astype(np.float32)
    values *= np.where(tone < 0, -1, 1).astype(np.float32)[:, None]
    unknown, separates_areas = np.flatnonzero(tone == 0), np.zeros(len(cuts), dtype=bool)
    if len(unknown):
        grey = cuts[unknown].astype(np.float32).mean(axis=2)
        looks = np.stack([grey, -grey, colour_differences(cuts[unknown], _WIDTH_STEPS // 2)])
        # An element is painted in one colour, or parts two areas: all of its places decide.
        half = cuts.shape[1] // 2 - _PROFILE_MARGIN_STEPS
        strength = [
            np.maximum(band_response(own, _WIDTH_STEPS, half), 0).max(axis=1) for own in looks
        ]
        own = element[unknown]
        votes = np.stack([np.bincount(own, s) for s in strength])
        chosen = votes.argmax(axis=0)[own]
        values[unknown] = looks[chosen, np.arange(len(own))]
        separates_areas[unknown] = chosen == len(looks) - 1
    return values, separates_areas


def _neighbour_mean(response: Values, run: IntArray) -> Values:
    """The mean over each place and its neighbours on the same stretch."""
    rows = np.arange(len(run))
    first = np.searchsorted(run, run)
    last = np.searchsorted(run, run, side="right") - 1
    found = response.copy()
    for away in range(1, _AVERAGED_NEIGHBOURS + 1):
        for other in (rows - away, rows + away):
            found += response[np.clip(other, first, last)]
    found /= 2 * _AVERAGED_NEIGHBOURS + 1
    return found


def _is_between_surfaces(
    values: Values, rows: IntArray, columns: IntArray, contrast: FloatArray
) -> NDArray[np.bool_]:
    """(k,) whether a line at a column lies between grounds of different tones."""
    away = np.arange(_PROFILE_MARGIN_STEPS - _FLANK_LENGTH_STEPS + 1, _PROFILE_MARGIN_STEPS + 1)
    one, other = (
        values[rows[:, None], columns[:, None] + side * away].mean(axis=1) for side in (1, -1)
    )
    return np.asarray(np.abs(one - other) > _FLANK_DIFFERENCE_RATIO * contrast)


def _neighbour_mean_colours(
    cuts: PixelArray, rows: IntArray, columns: IntArray, expected: ExpectedLinePoints
) -> Values:
    """(k, m, 3) of some rows and their neighbours on the same stretch, at (k, m) columns."""
    total = np.zeros((*columns.shape, 3), dtype=np.float32)
    for other in _neighbour_rows(expected.run):
        total += cuts[other[rows][:, None], columns]
    total /= 2 * _AVERAGED_NEIGHBOURS + 1
    return total


def _neighbour_rows(run: IntArray) -> Iterator[IntArray]:
    """Each place itself, and those next to it on the same stretch, or its end."""
    rows = np.arange(len(run))
    first = np.searchsorted(run, run)
    last = np.searchsorted(run, run, side="right") - 1
    for away in range(-_AVERAGED_NEIGHBOURS, _AVERAGED_NEIGHBOURS + 1):
        yield np.clip(rows + away, first, last)
