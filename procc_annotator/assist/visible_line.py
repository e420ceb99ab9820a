"""Detect where a line marking is visible along its predicted curve."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray, true_runs
from procc_annotator.assist.curves import robust_fit
from procc_annotator.field.model import EDGE
from procc_annotator.image.line_offsets import offsets_along_curve
from procc_annotator.image.line_profiles import (
    LineTarget,
    StraightenedCurve,
    Values,
    straighten_curve,
)
from procc_annotator.image.line_snapping import SNAP_RADIUS_PX
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.polylines import arc_lengths, points_at_arc_lengths, polyline_normals

AGREE_PX = 0.8  # offsets this near to the smooth ones lie on the line


def smooth_inliers(
    places: FloatArray, values: FloatArray, reach: float, *, terms: int
) -> tuple[BoolArray, FloatArray]:
    """Which offsets lie on one smooth course, and its coefficients.

    The course through two of the offsets that most others agree with, then fitted to those.

    Args:
        places: (n,) along the course, -1 to 1, ascending.
        values: (n,) px across it, n >= 2.
        reach: px; how far the line may lie.
        terms: of the series at most; 2 where it is straight.

    Returns:
        (n,) which agree, and the coefficients of a Legendre series of the offsets.
    """
    i, j = np.triu_indices(len(places), 1)
    slopes = (values[j] - values[i]) / np.maximum(places[j] - places[i], 1e-9)
    level = values[i] - slopes * places[i]
    possible = np.abs(level) + np.abs(slopes) <= reach + 1.0
    level = np.concatenate([level[possible], values])
    slopes = np.concatenate([slopes[possible], np.zeros(len(values))])
    away = slopes[:, None] * places
    away += level[:, None]
    away -= values
    away /= 2 * AGREE_PX
    away *= away
    # Many that agree, and well; near the prediction where that leaves a choice.
    merit = len(values) - np.minimum(away, 1.0).sum(axis=1)
    merit -= 0.1 * (np.abs(level) + np.abs(slopes)) / reach
    best = int(merit.argmax())
    kept = away[best] <= 1.0
    coefficients = np.array([level[best], slopes[best]])
    for _ in range(4):
        used = min(terms, max(1, int(kept.sum()) // 3))
        basis = np.polynomial.legendre.legvander(places, used - 1)
        penalty = 0.02 * np.diag(np.arange(used) ** 2.0)
        own = basis[kept]
        coefficients = np.linalg.solve(own.T @ own + penalty, own.T @ values[kept])
        kept = np.abs(basis @ coefficients - values) <= AGREE_PX
        if kept.sum() < 3:
            break
    return kept, coefficients


Runs = tuple[tuple[int, int], ...]

BESIDE_PX = 12.0  # what is looked at to both sides of the line
_LEAST_CONTRAST = 10.0  # of 255
_CONTRAST_SHARES = 0.4, 2.2  # of what the line has at the nearest hits
_COLOUR_COSINE = 0.93  # 22 degrees between two colours
_GROUND_APART = 0.07  # of the shares of blue, green and red in a side's colour
_GROUND_LIGHT = 0.45, 2.0
_MOST_SPREAD = 0.5  # of the way from the ground's colour to the line's
_MOST_SPREAD = 0.5  # of the way from the ground's colour to the line's
_RUN_STEADY_PX = 13  # a line shows in nearly every cut over this length
_STEADY_SHARE = 0.65
_GAP_PX = 6
_RUN_PX = 12  # twice the gap
_END_GAP_PX = 3  # half the gap between runs
_END_PX = 40
_END_SHARE = 1.7  # as the larger of the contrast shares, where only one side shows the line


@dataclass(frozen=True, eq=False)
class _StripColours:
    """Colours of a strip, place by place: (n, 3) BGR of the line and of the ground next to it."""

    centre: FloatArray
    left: FloatArray
    right: FloatArray

    def steps(self, *, edge: bool) -> tuple[FloatArray, FloatArray]:
        """(n, 3) what the colour changes by from either ground to the line; of an edge, from one
        ground to the other."""
        if edge:
            return self.right - self.left, self.right - self.left
        return self.centre - self.left, self.centre - self.right


def runs_seen(
    strip: StraightenedCurve, hits: IntArray, *, on_ground: bool, edge: bool = False
) -> Runs:
    """The stretches along which a line is seen.

    Args:
        strip: the picture along the line's course, a place about every pixel.
        hits: places where it was found.
        on_ground: whether the same ground lies to both sides of it all along; a post or a crossbar
            may have anything behind it.
        edge: whether it is the edge of an area.

    Returns:
        First and one past the last place of each stretch, ascending.
    """
    at_hits = _near(hits, len(strip.colours))
    look = _strip_colours(strip, hits)
    steps = look.steps(edge=edge)
    stroke = (steps[0] + steps[1]) / 2
    usual_stroke = np.median(stroke[at_hits], axis=0)
    colour = usual_stroke / max(float(np.linalg.norm(usual_stroke)), 1e-6)
    contrast = np.column_stack([step @ colour for step in steps])
    usual = np.column_stack([_usual(of_side, hits) for of_side in contrast.T])
    if float(np.median(usual.min(axis=1))) < _LEAST_CONTRAST:
        return ()
    share, largest_share = _CONTRAST_SHARES
    beside = (contrast >= np.maximum(share * usual, _LEAST_CONTRAST)) & (
        contrast <= largest_share * np.maximum(usual, _LEAST_CONTRAST)
    )
    if on_ground:
        line = np.median(look.centre[at_hits], axis=0)
        beside &= np.column_stack([_as_ground(s, line, at_hits) for s in (look.left, look.right)])
    lengths = np.linalg.norm(stroke, axis=1)
    in_colour = stroke @ colour >= _COLOUR_COSINE * np.maximum(lengths, 1e-6)
    runs = _steady_runs(in_colour & beside.all(axis=1))
    modest = contrast <= _END_SHARE * usual
    return _to_ends(runs, np.asarray((beside & modest).any(axis=1)))


def is_bare(picture: PixelArray, course: FloatArray, across: FloatArray, asked: BoolArray) -> bool:
    """Return whether most of some places show neither a line, by what it is like at the others, nor
    anything else that could hide it: across it all is alike. (n, 2) px of each and its normal."""
    if not asked.any() or (~asked).sum() < _RUN_PX:
        return False  # nobody can tell
    strip = straighten_curve(picture, course, across, BESIDE_PX)
    look = _strip_colours(strip, np.flatnonzero(~asked))
    usual = [np.median(part[~asked], axis=0) for part in (look.centre, look.left, look.right)]
    stroke = usual[0] - (usual[1] + usual[2]) / 2
    contrast = max(float(np.linalg.norm(stroke)), 1e-6)
    most = _CONTRAST_SHARES[0] * contrast
    lightness = (look.centre - usual[0] + stroke) @ (stroke / contrast)
    steps = [np.linalg.norm(step, axis=1) for step in look.steps(edge=False)]
    bare = (np.maximum(*steps) < most) & (lightness < most)
    return bool(bare[asked].mean() > 0.5)


def _strip_colours(strip: StraightenedCurve, hits: IntArray) -> _StripColours:
    width = _half_widths(strip, hits)
    inner = np.maximum(0.5, 0.5 * width)
    zones = (-inner, inner), (-width - 5.0, -width - 1.5), (width + 1.5, width + 5.0)
    return _StripColours(*(_smooth(_mean_between(strip, *zone)) for zone in zones))


def _mean_between(strip: StraightenedCurve, low_px: FloatArray, high_px: FloatArray) -> FloatArray:
    """(n, 3) means of the colours of each place from one offset (n,) to another one."""
    offsets = strip.offsets_px
    first = np.searchsorted(offsets, low_px, side="left")
    past = np.maximum(np.searchsorted(offsets, high_px, side="right"), first + 1)
    sums = np.zeros((len(strip.colours), len(offsets) + 1, 3))
    np.cumsum(strip.colours, axis=1, dtype=np.float64, out=sums[:, 1:])
    rows = np.arange(len(sums))
    return np.asarray((sums[rows, past] - sums[rows, first]) / (past - first)[:, None])


def _near(hits: IntArray, n: int) -> BoolArray:
    """(n,) whether a place is within three of a hit."""
    marked = np.zeros(n, dtype=bool)
    for step in range(-3, 4):
        marked[np.clip(hits + step, 0, n - 1)] = True
    return marked


def _half_width(colours: Values, strip: StraightenedCurve) -> float:
    """Half the stroke's width at half its height, px, by (m, 3) colours across it."""
    outer = np.concatenate([colours[:8], colours[-8:]])
    steps = colours - np.median(outer, axis=0)
    near = strip.columns(-2.0, 2.0)
    middle = steps[strip.columns(-0.5, 0.5)].mean(axis=0)
    profile = steps @ (middle / max(float(np.linalg.norm(middle)), 1e-6))
    peak = near.start + int(profile[near].argmax())
    ground = float(np.median(np.concatenate([profile[:8], profile[-8:]])))
    above = profile > (float(profile[peak]) + ground) / 2
    right = len(above) - peak if above[peak:].all() else int(np.argmin(above[peak:]))
    left = peak if above[: peak + 1].all() else int(np.argmin(above[: peak + 1][::-1]))
    step = float(strip.offsets_px[1] - strip.offsets_px[0])
    return float(np.clip((left + right - 1) * step / 2, 0.75, 5.0))


_WIDTH_HITS = 3  # a width is the median of this many
_GROUND_PX = 5.5, 8.0


def _half_widths(strip: StraightenedCurve, hits: IntArray) -> FloatArray:
    """(n,) half the stroke's width at half its height, px: what it is as a rule, and more where it
    is wider towards both sides, as an arc is where it leads away from the camera."""
    least = _half_width(np.median(strip.colours[_near(hits, len(strip.colours))], axis=0), strip)
    around = np.clip(hits[:, None] + np.arange(-3, 4), 0, len(strip.colours) - 1)
    colours = np.median(strip.colours[around], axis=1)
    line = colours[:, strip.columns(-0.5, 0.5)].mean(axis=1)
    middle, ground = len(strip.offsets_px) // 2, strip.columns(*_GROUND_PX)
    extents = []
    for outwards in (colours, colours[:, ::-1]):
        base = outwards[:, ground].mean(axis=1)
        height = np.einsum("nmc,nc->nm", outwards[:, middle:] - base[:, None], line - base)
        below = height <= height[:, :1] / 2
        extents.append(np.where(below.any(axis=1), below.argmax(axis=1), below.shape[1]))
    step = float(strip.offsets_px[1] - strip.offsets_px[0])
    own = _median_around((np.minimum(*extents) - 0.5) * step, _WIDTH_HITS)
    return np.interp(np.arange(len(strip.colours)), hits, np.clip(own, least, 5.0))


def _smooth(values: FloatArray) -> FloatArray:
    """(n, 3) means over five places along."""
    padded = np.pad(values, ((2, 2), (0, 0)), mode="edge")
    return np.asarray(sum(padded[k : k + len(values)] for k in range(5)) / 5)


def _usual(contrast: FloatArray, hits: IntArray) -> FloatArray:
    """(n,) the contrast of the line, which changes along it, by the median of five hits around."""
    own = _median_around(contrast[hits], 5)
    return np.asarray(np.interp(np.arange(len(contrast)), hits, own))


def _median_around(values: FloatArray, count: int) -> FloatArray:
    """(n,) medians of so many values around each."""
    half = count // 2
    own = np.pad(values, half, mode="reflect" if len(values) > half else "edge")
    return np.median([own[k : k + len(values)] for k in range(count)], axis=0)


def _as_ground(side: FloatArray, line: FloatArray, at_hits: BoolArray) -> BoolArray:
    """(n,) whether a side has the colour it has at the hits, in light or shadow.

    Compression spreads the line's colour (3,) into its sides, most where it is wide.
    """
    light = side.sum(axis=1)
    shares = side / np.maximum(light, 1.0)[:, None]
    usual = np.median(shares[at_hits], axis=0)
    usual_light = float(np.median(light[at_hits]))
    to_line = line / max(float(line.sum()), 1.0) - usual
    spread = (shares - usual) @ to_line / max(float(to_line @ to_line), 1e-9)
    apart = shares - usual - np.clip(spread, 0.0, _MOST_SPREAD)[:, None] * to_line
    darkest, brightest = _GROUND_LIGHT
    as_light = (light >= darkest * usual_light) & (light <= brightest * usual_light)
    return np.asarray((np.linalg.norm(apart, axis=1) <= _GROUND_APART) & as_light)


def _steady_runs(shown: BoolArray) -> Runs:
    """Runs of nearly uninterrupted True, short gaps closed, short runs left out."""
    n = len(shown)
    half = min(_RUN_STEADY_PX, n) // 2
    counts = np.convolve(np.pad(shown.astype(float), half, mode="edge"), np.ones(2 * half + 1))
    steady = shown & (counts[2 * half : 2 * half + n] >= _STEADY_SHARE * (2 * half + 1))
    runs: list[tuple[int, int]] = []
    for begin, end in true_runs(steady):
        if runs and begin - runs[-1][1] <= _GAP_PX:
            runs[-1] = runs[-1][0], end
        else:
            runs.append((begin, end))
    least = min(_RUN_PX, 0.6 * n)
    return tuple((begin, end) for begin, end in runs if end - begin >= least)


def _to_ends(runs: Runs, beside_ground: BoolArray) -> Runs:
    """The first and the last run continued to the course's ends, as far as one side shows the line.

    Where an element ends it meets another, which lies in the ground of one side.
    """
    if not runs:
        return runs
    n = len(beside_ground)
    first, last = runs[0][0], runs[-1][1]
    begin = first - _reached(beside_ground[:first][::-1][:_END_PX])
    end = last + _reached(beside_ground[last:][:_END_PX])
    begin, end = begin if begin > 1 else 0, end if end < n - 1 else n
    if len(runs) == 1:
        return ((begin, end),)
    return (begin, runs[0][1]), *runs[1:-1], (runs[-1][0], end)


def _reached(shown: BoolArray) -> int:
    """Return how many places from the first on are shown, but for small gaps."""
    rows = np.flatnonzero(shown)
    if not len(rows) or rows[0] > _END_GAP_PX:
        return 0
    breaks = np.flatnonzero(np.diff(rows) > _END_GAP_PX + 1)
    return int(rows[breaks[0]] if len(breaks) else rows[-1]) + 1


_LEAST_REACH_PX = 2.0
_REACH_SD = 3.0  # standard deviations: 99.7 %
_STEADY_PX = 3  # over so many pixels to either side a line's direction is taken
_SNAP_EVERY_PX = 14.0
_SNAPS, _CURVE_SNAPS = (5, 40), (5, 72)
_TANGENT_PX = 40
_CURVE_TERMS = 9  # a circle's affine errors are two waves, and it may be bumpy


@dataclass(frozen=True, eq=False)
class VisibleLine:
    """A line's own course next to a predicted one.

    Attributes:
        course_px: (n, 2) px, a place about every pixel.
        directions: (n, 2) unit vectors.
        runs: first and one past the last place of each stretch that can be seen.
        expected: first and last place of the predicted course; what is beyond is straight on.
    """

    course_px: FloatArray
    directions: FloatArray
    runs: tuple[tuple[int, int], ...]
    expected: tuple[int, int]

    @property
    def length(self) -> int:
        """Places along it, seen or not."""
        return len(self.course_px)

    @property
    def seen(self) -> int:
        """Places that can be seen."""
        return sum(end - begin for begin, end in self.runs)


def find_line(
    picture: PixelArray,
    predicted_px: FloatArray,
    sd_px: FloatArray,
    sought: LineTarget,
    *,
    curved: bool,
    on_ground: bool,
    beyond_px: tuple[float, float] = (0.0, 0.0),
) -> VisibleLine:
    """The painted line near a predicted course.

    Args:
        picture: (H, W, 4) BGRA.
        predicted_px: (n, 2) px, dense, n >= 2.
        sd_px: (n,) how surely it is known across; the line is looked for within three of these, at
            least 2 px and at most the reach of snapping.
        curved: whether the line is a circle or an arc.
        on_ground: whether the same ground lies to both sides of it all along.
        beyond_px: how far beyond its first and its last place the line may go on, straight.

    Returns:
        Without runs where there is no such line.
    """
    course, sd = _every_pixel(predicted_px, sd_px)
    across = polyline_normals(course, _STEADY_PX)
    reach = float(np.clip(_REACH_SD * sd.max(), _LEAST_REACH_PX, SNAP_RADIUS_PX))
    offsets, hits = _offsets(picture, course, across, reach, sought, curved=curved)
    if offsets is None:
        return VisibleLine(course, _along(across), (), (0, len(course) - 1))
    course = course + across * offsets[:, None]
    size = picture.shape[1], picture.shape[0]
    whole = continued(course[::-1], beyond_px[0], size)[::-1]
    before = len(whole) - len(course)
    whole = continued(whole, beyond_px[1], size)
    across = polyline_normals(whole, _STEADY_PX)
    strip = straighten_curve(picture, whole, across, BESIDE_PX)
    edge = sought.looks.kind == EDGE
    runs = runs_seen(strip, hits + before, on_ground=on_ground, edge=edge)
    return VisibleLine(whole, _along(across), runs, (before, before + len(course) - 1))


def continued(course: FloatArray, by_px: float, size: tuple[int, int] | None = None) -> FloatArray:
    """A course and, straight on from its last end, some more px; as far as a picture's edge."""
    more = course[-1] + np.arange(1.0, by_px + 1.0)[:, None] * onwards(course)
    if size is not None:
        more = more[((more >= 0) & (more <= np.array(size) - 1)).all(axis=1)]
    return np.vstack([course, more])


def onwards(course: FloatArray) -> FloatArray:
    """(2,) unit vector straight on from a course's last end."""
    along = course[-1] - course[max(0, len(course) - 1 - _TANGENT_PX)]
    return np.asarray(along / max(float(np.hypot(*along)), 1e-9))


def _every_pixel(predicted: FloatArray, sd: FloatArray) -> tuple[FloatArray, FloatArray]:
    lengths = arc_lengths(predicted)
    at = np.linspace(0.0, lengths[-1], max(3, round(lengths[-1]) + 1))
    course = points_at_arc_lengths(predicted, at, lengths)
    return course, np.interp(at, lengths, sd)


def _along(across: FloatArray) -> FloatArray:
    return np.column_stack([across[:, 1], -across[:, 0]])


def _offsets(
    picture: PixelArray,
    course: FloatArray,
    across: FloatArray,
    reach: float,
    sought: LineTarget,
    *,
    curved: bool,
) -> tuple[FloatArray | None, IntArray]:
    """(n,) px from the predicted to the line's own course, and the rows that showed it."""
    n = len(course)
    count = int(np.clip(round(n / _SNAP_EVERY_PX), *(_CURVE_SNAPS if curved else _SNAPS)))
    along = _course_parameters(across) if curved else np.linspace(-1.0, 1.0, n)
    wanted = np.interp(np.linspace(-1.0, 1.0, count), along, np.arange(n))
    rows = np.unique(wanted.round().astype(np.intp))
    values = offsets_along_curve(picture, course, across, rows, sought, reach)
    known = ~np.isnan(values)
    if known.sum() < 3:
        return None, rows[:0]
    places, values = along[rows[known]], values[known]
    agreed, coefficients = smooth_inliers(places, values, reach, terms=5 if curved else 3)
    if curved and len(values) > 2 * _CURVE_TERMS:
        basis = np.polynomial.legendre.legvander(places, _CURVE_TERMS - 1).astype(np.float64)
        bent, bent_agreed = robust_fit(basis, values)
        if bent_agreed.sum() > agreed.sum():
            agreed, coefficients = bent_agreed, bent
    if agreed.sum() < 3:
        return None, rows[:0]
    whole = np.polynomial.legendre.legval(along, coefficients)
    return np.clip(whole, -reach - 1.0, reach + 1.0), rows[known][agreed]


def _course_parameters(across: FloatArray) -> FloatArray:
    """(n,) ascending from -1 to 1 along a curve with unit normals (n, 2): half by its length, half
    by how it turns. What a camera is off by changes with the direction of a circle, at once where
    it is seen to turn at once."""
    turned = np.abs(np.diff(np.unwrap(np.arctan2(across[:, 1], across[:, 0]))))
    shares = np.cumsum(turned / max(float(turned.sum()), 1e-9) + 1 / len(turned))
    return np.concatenate([[-1.0], shares - 1.0])
