"""Measure where line markings are across many places in one call."""

from __future__ import annotations

import math
from collections.abc import Sequence

import cv2
import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.field.model import ANY, BAR, DARKER, EDGE
from procc_annotator.image.line_candidates import MIN_BAND_CONTRAST
from procc_annotator.image.line_profiles import (
    STEP_PX,
    WIDE_BAND_PX,
    LineTarget,
    Values,
    curvature_kernel,
    cut_strip,
    matches_colour_step,
    median_of_nine,
)
from procc_annotator.image.line_snapping import is_searchable, snap_points_to_lines
from procc_annotator.image.pixels import PixelArray

_STRETCH_PX = np.array([-6, -5, -3, -2, 0, 2, 3, 5, 6])[:, None]  # along: the cuts of one profile
_WIDTHS = 2, 4, 6, 8, 12, 16, 24  # of bands, samples
_EDGE_WIDTH = 4
_NEIGHBOURS = 2  # places to either side that decide with one on width and tone
_DISTANCE_SCALE_PX = 8.0  # a band at this distance counts less than half of one at none
_MIN_CONTRAST = 5.0  # grey levels, of the band against the nearer of its flanks
_RIVAL_RATIO = 0.75  # of a band's contrast: another one that convinces as much
_RIVAL_MIN_STEPS = 5  # from the band's middle: nearer ones are itself


def offsets_along_curve(
    picture: PixelArray,
    course_px: FloatArray,
    across: FloatArray,
    rows: IntArray,
    sought: LineTarget,
    reach_px: float,
    *,
    bars_alone: bool = True,
) -> FloatArray:
    """The offsets of paint from places of a course, which it follows.

    Args:
        picture: (H, W, 4) BGRA.
        course_px: (n, 2) px, a place about every pixel.
        across: (n, 2) its unit normals.
        rows: (N,) places that are measured.
        bars_alone: whether places on bars are examined one by one: it is surer and takes long.

    Returns:
        (N,) px along the normals; NaN without paint, or if there is doubt which.
    """
    if not len(rows) or not is_searchable(sought):
        return np.full(len(rows), np.nan)
    if sought.looks.kind == BAR and bars_alone:
        # What is behind one changes, and may be as bright: each place is examined alone.
        along = np.column_stack([across[rows, 1], -across[rows, 0]])
        found = snap_points_to_lines(picture, course_px[rows], along, sought, reach_px=reach_px)
        return np.asarray(((found - course_px[rows]) * across[rows]).sum(axis=1))
    return _band_offsets(picture, course_px, across, rows, sought, reach_px)


def _band_offsets(
    picture: PixelArray,
    course_px: FloatArray,
    across: FloatArray,
    rows: IntArray,
    sought: LineTarget,
    reach_px: float,
) -> FloatArray:
    """`offsets_along_curve` by the bands of all places at once."""
    (least, most), looks = sought.width_px, sought.looks
    is_edge, every = looks.kind == EDGE, np.arange(len(rows))
    widths = np.array(
        [w for w in _WIDTHS if (w - 1) * STEP_PX <= most] if not is_edge else [_EDGE_WIDTH]
    )
    reach = math.ceil(reach_px / STEP_PX) + 1
    half = reach + int(sum(_flanks(widths[-1]))) + widths[-1] // 2
    strip = cut_strip(picture, course_px, across, half)
    cuts = median_of_nine(strip[np.clip(rows + _STRETCH_PX, 0, len(strip) - 1)])[..., :3]
    tones = _tones(cuts, sought)
    aside_px = np.arange(-reach, reach + 1) * STEP_PX
    responses = np.stack([band_response(tone, w, reach) for tone in tones for w in widths.tolist()])
    responses *= np.exp(-((aside_px / _DISTANCE_SCALE_PX) ** 2)).astype(np.float32)
    votes = np.pad(responses.max(axis=2), ((0, 0), (_NEIGHBOURS, _NEIGHBOURS)), mode="edge")
    around = [votes[:, k : k + len(rows)] for k in range(2 * _NEIGHBOURS + 1)]
    chosen = np.sum(around, axis=0).argmax(axis=0)
    values, width = np.stack(tones)[chosen // len(widths), every], widths[chosen % len(widths)]
    at, contrast, good = best_columns(
        responses[chosen, every], np.abs(aside_px) <= reach_px, np.maximum(width, _RIVAL_MIN_STEPS)
    )
    column = np.rint(at).astype(np.intp) + half - reach
    middle, width_px = _middles(values, column, width)
    if is_edge:
        middle = at + half - reach
    else:
        beside = width // 2 + 2
        grounds = [cuts[every, column + side * beside].astype(np.float32) for side in (-1, 1)]
        good &= matches_colour_step(cuts[every, column] - (grounds[0] + grounds[1]) / 2, sought)
        good &= (width_px >= least) & (width_px <= most)
    if looks.tone == ANY:
        good &= contrast >= MIN_BAND_CONTRAST  # textures of halls have lines of their own
    found = (middle - half) * STEP_PX
    return np.where(good & (np.abs(found) <= reach_px), found, np.nan)


def _flanks(width: int) -> tuple[int, int]:
    """Samples between a band and the ground next to it, and of that ground."""
    return max(1, width // 4), max(3, width // 2)


def _tones(cuts: PixelArray, sought: LineTarget) -> Sequence[Values]:
    """(N, m) of cuts, in which the paint is lighter than what is next to it; each way it may be."""
    if sought.looks.kind == EDGE:
        return [colour_differences(cuts, _EDGE_WIDTH // 2)]
    if sought.looks.tone == ANY:
        grey = cuts.astype(np.float32).mean(axis=2)
        return [grey, -grey]
    # White paint is light in all colours, coloured paint dark in one of them.
    lowest = np.minimum(np.minimum(cuts[..., 0], cuts[..., 1]), cuts[..., 2]).astype(np.float32)
    return [-lowest if sought.looks.tone == DARKER else lowest]


def _middles(values: Values, column: IntArray, width: IntArray) -> tuple[FloatArray, FloatArray]:
    """(n,) middles of bands next to columns, and (n,) px of their widths at half their height.

    A narrow one is where the profile curves most: its grounds may differ. A wide one is flat.
    """
    every, last = np.arange(len(column))[:, None], values.shape[1] - 1
    curved = cv2.filter2D(values, -1, curvature_kernel(), borderType=cv2.BORDER_REPLICATE)
    peak = column + curved[every, column[:, None] + np.arange(-2, 3)].argmax(axis=1) - 2
    left, top, right = (curved[every[:, 0], peak + away] for away in (-1, 0, 1))
    narrow = peak + parabola_shifts(left, top, right)
    top = values[every, column[:, None] + np.arange(-1, 2)].max(axis=1)
    away = np.arange(values.shape[1] // 2)
    is_ground = np.abs(away - width[:, None] - 3) <= np.maximum(width[:, None] // 2, 3)
    falls = []
    for side in (-1, 1):
        flank = values[every, np.clip(column[:, None] + side * away, 0, last)]
        level = (top + np.where(is_ground, flank, np.inf).min(axis=1)) / 2
        past = np.maximum((flank < level[:, None]).argmax(axis=1), 1)
        before, after = flank[every[:, 0], past - 1], flank[every[:, 0], past]
        share = (before - level) / np.maximum(before - after, 1e-6)
        falls.append(past - 1 + np.clip(share, 0.0, 1.0))
    width_px = (falls[0] + falls[1]) * STEP_PX
    wide = column + (falls[1] - falls[0]) / 2
    return np.where(width_px <= WIDE_BAND_PX, narrow, wide), np.asarray(width_px)


def colour_differences(cuts: PixelArray, away: int) -> Values:
    """(n, m) how much the colours to both sides of each sample differ, so many samples away: an
    edge between two areas is a band in it, and a line is two, next to each other."""
    wide = np.pad(cuts.astype(np.float32), ((0, 0), (away, away), (0, 0)), mode="edge")
    return np.asarray(np.sqrt(((wide[:, 2 * away :] - wide[:, : -2 * away]) ** 2).mean(axis=2)))


def band_response(values: Values, width: int, reach: int) -> Values:
    """(n, 2 reach + 1) how much a band of a width stands out of the more similar of its flanks, at
    columns around the middle of (n, m) values; all in samples."""
    total = np.zeros((len(values), values.shape[1] + 1), dtype=np.float32)
    np.cumsum(values, axis=1, out=total[:, 1:])
    (gap, flank), count = _flanks(width), 2 * reach + 1
    # Half weights at both ends of the band keep its middle on a sample.
    begin = values.shape[1] // 2 - reach - width // 2

    def sum_from(first: int, many: int) -> Values:
        return total[:, first + many : first + many + count] - total[:, first : first + count]

    band = sum_from(begin, width) + sum_from(begin + 1, width)
    left = sum_from(begin - gap - flank, flank) / flank
    right = sum_from(begin + width + gap + 1, flank) / flank
    return np.asarray(band / (2 * width) - np.maximum(left, right))


def best_columns(
    response: Values, within: BoolArray, apart: IntArray | int = _RIVAL_MIN_STEPS
) -> tuple[FloatArray, FloatArray, BoolArray]:
    """(n,) column of each place's band, between columns; its contrast; whether it convinces, and no
    other one as much at least so many columns apart."""
    columns = np.arange(response.shape[1])
    allowed = np.where(within, response, -np.inf)
    best = allowed.argmax(axis=1)
    rows = np.arange(len(best))
    contrast = allowed[rows, best].astype(np.float64)
    # The slope of a band beyond the reach is no band.
    left = response[rows, np.maximum(best - 1, 0)]
    right = response[rows, np.minimum(best + 1, response.shape[1] - 1)]
    is_top = (left <= contrast) & (right <= contrast)
    convinces = is_top & (contrast >= _MIN_CONTRAST)
    far = np.abs(columns - best[:, None]) >= np.reshape(apart, (-1, 1))
    rival = np.where(far, allowed, -np.inf).max(axis=1)
    at = best + parabola_shifts(left, contrast, right)
    return at, contrast, convinces & (rival < _RIVAL_RATIO * contrast)


def parabola_shifts(left: FloatArray, top: FloatArray, right: FloatArray) -> FloatArray:
    """(n,) between -0.5 and 0.5, where the tops of parabolas through three values are."""
    bend = np.maximum(2 * top - left - right, 1e-6)
    return np.asarray(np.clip((right - left) / (2 * bend), -0.5, 0.5))
