"""Snap clicked points to the centre of the line marking nearby.

Profiles across the line are averaged along it; the centre is where the smoothed profile curves most
(Steger 1998, "An unbiased detector of curvilinear structures", without its width model), in the
colour that separates the band from its flanks. A band convinces when nearly every cut across shows
it, when it is as wide and as coloured as what is sought, and when it goes on along the line. Of two
that convince as much neither does.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.field.model import ANY, BAR, EDGE, LINE, NOTHING, WHITE
from procc_annotator.image.line_candidates import (
    MARGIN_PX,
    MAX_CANDIDATES,
    BandMaxima,
    LineBand,
    LineExtent,
    closest_offset,
    trace_line,
)
from procc_annotator.image.line_candidates import MAX_TRACE_PX as FOLLOWED_PX
from procc_annotator.image.line_profiles import ANY_LINE_TARGET, ImagePatch, LineTarget
from procc_annotator.image.pixels import PixelArray

SNAP_RADIUS_PX = 6.0

_DIRECTIONS = 12  # 15 degrees apart
# Of the angle between two directions.
_DIRECTION_OFFSETS = np.array([-1.6, -0.8, -0.4, 0.0, 0.4, 0.8, 1.6])
_ANGLE_OFFSETS = np.radians([0.0, -5.0, 5.0])  # how a line may be turned against a given direction
_CURVE_ANGLE_OFFSETS = np.radians([0.0, -6.0, 6.0, -12.0, 12.0])
_BAR_ANGLE_OFFSETS = np.radians([0.0, -1.5, 1.5, -3.0, 3.0])
_SAME_BAND_PX = 1.0  # a band that was refused is not examined from a place as near
_MIN_LENGTH_PX, _MIN_LENGTH_ANY_PX = 16.0, 30.0
# Px from the position to the middle of the cuts that show it, and how long it then must be.
_ONE_SIDED_LENGTHS_PX = {LINE: (1.5, 36.0), BAR: (6.0, 46.0)}
# So far off a hand clicks; px of length for each px more
_CLICK_ERROR_PX, _LENGTH_PER_OFFSET = 4.5, 20.0
# Of the band against a given direction, which of a curve is that of a chord.
_MAX_TURN_RAD, _MAX_TURN_CURVE_RAD = math.radians(8.0), math.radians(20.0)
# Of the best one's merit: another band that convinces nearly as much; where paint may be lighter or
# darker than its ground, anything that convinces.
_RIVAL_RATIO, _RIVAL_RATIO_ANY = 0.7, 0.12
_MAX_RIVALS = 4
_DISTINCT_BAND_PX = 2.5
_CROSSING_TOLERANCE_PX, _CROSSING_COSINE = 1.5, 0.5  # of one band seen in another direction
_RECENTRE_PX = 2.0
_SUBPATCH_PX = 4.0  # beyond the reach: where the other part of a wide line may be
_SHRINK_WIDTH_PX = 20.0  # what may be wider is looked at in a smaller picture


def snap_to_line(
    picture: PixelArray,
    point: tuple[float, float],
    sought: LineTarget = ANY_LINE_TARGET,
    *,
    direction: tuple[float, float] | None = None,
    reach_px: float = SNAP_RADIUS_PX,
) -> tuple[float, float] | None:
    """Move a position to the middle of the paint next to it, across the line only.

    Args:
        picture: (H, W, 4) BGRA.
        point: picture px, pixel centres are whole numbers.
        direction: of the line there, in px; None to find it in the picture.

    Returns:
        Picture px, or None without convincing paint within reach.
    """
    height, width = picture.shape[:2]
    x, y = point
    inside = -0.5 <= x <= width - 0.5 and -0.5 <= y <= height - 0.5
    if not inside or not is_searchable(sought):
        return None
    wide = math.ceil(sought.width_px[1] / _SHRINK_WIDTH_PX)
    if wide > 1:
        return _snap_in_smaller(picture, point, sought, direction, reach_px, wide)
    near_px = min(reach_px, SNAP_RADIUS_PX) if sought.is_pale_line else reach_px
    patch = _patch_around(picture, point, near_px)
    if direction is None:
        return _snap_any_direction(picture, patch, point, sought, near_px)
    placed = _snap_with_direction(patch, point, sought, direction, near_px)
    if placed is not None or not sought.is_pale_line:
        return placed
    blurred, reach, shrink = sought.blurred(width), max(reach_px, 2 * SNAP_RADIUS_PX), 1
    placed = _snap_in_smaller(picture, point, blurred, direction, reach, 2)
    while placed is None and shrink * SNAP_RADIUS_PX < reach_px:
        shrink *= 2
        far = replace(sought, length_px=_MIN_LENGTH_ANY_PX)
        placed = _snap_in_smaller(picture, point, far, direction, reach_px, shrink)
        if placed is not None:  # the whole picture shows it as well
            placed = snap_to_line(picture, placed, sought, direction=direction, reach_px=shrink)
    return placed


def is_searchable(sought: LineTarget) -> bool:
    """Return whether enough is known: before anything, a bar of any tone and colour is one band of
    many unless a camera shows it there."""
    looks = sought.looks
    if looks.kind != BAR or looks.tone != ANY or looks.colour not in (ANY, WHITE):
        return looks.kind != NOTHING
    return sought.is_expected


def _snap_in_smaller(
    picture: PixelArray,
    point: tuple[float, float],
    sought: LineTarget,
    direction: tuple[float, float] | None,
    reach_px: float,
    shrink: int,
) -> tuple[float, float] | None:
    """A band too wide, or too far away, to be examined as it is, found in a smaller picture."""
    if direction is None:
        return None
    least, most = (width / shrink for width in sought.width_px)
    smaller = replace(
        sought, width_px=(least, most), is_wide=sought.length_px != _MIN_LENGTH_ANY_PX
    )
    looked_at = reach_px / shrink + _SUBPATCH_PX
    reach = math.hypot(looked_at + MARGIN_PX, FOLLOWED_PX) * shrink
    patch = ImagePatch.around(picture, point, reach, shrink)
    placed = _snap_with_direction(patch, (0.0, 0.0), smaller, direction, looked_at)
    if placed is None or math.hypot(*placed) * shrink > reach_px:
        return None
    return point[0] + placed[0] * shrink, point[1] + placed[1] * shrink


def _snap_with_direction(
    patch: ImagePatch,
    point: tuple[float, float],
    sought: LineTarget,
    direction: tuple[float, float],
    reach_px: float,
) -> tuple[float, float] | None:
    """The place next to a point on the band that runs in a direction."""
    angle = math.atan2(direction[1], direction[0])
    spread = _ANGLE_OFFSETS
    if sought.looks.kind == BAR:
        spread = _BAR_ANGLE_OFFSETS
    elif sought.bends:
        spread = _CURVE_ANGLE_OFFSETS

    most_turn = _MAX_TURN_CURVE_RAD if sought.bends else _MAX_TURN_RAD

    def goes_on(found: LineBand) -> LineBand | None:
        for course in trace_line(patch, found.angle, found.offset, found.width, sought):
            turn = abs(found.angle + course.turn - angle)
            if course.length_px >= _min_length_px(found, course, sought) and turn <= most_turn:
                # It is wanted next to the position, not where it can be seen.
                across = found.along * math.tan(course.turn)
                return replace(found, offset=found.offset - across)
        return None

    maxima = BandMaxima.of(patch, angle + spread, sought, reach_px)
    found = _best_confirmed_band(maxima, goes_on, unsure=sought.looks.tone == ANY or sought.is_wide)
    if found is None:
        return None
    across = found.offset / math.cos(found.angle - angle)
    # Only now: a band that comes out beyond reach makes any other one doubtful all the same.
    if abs(across) > reach_px:
        return None
    return point[0] - across * math.sin(angle), point[1] + across * math.cos(angle)


def _min_length_px(found: LineBand, course: LineExtent, sought: LineTarget) -> float:
    """Return how far a band must go on to be the sought paint, px.

    One that may be lighter or darker than its ground, and is seen on one side only, could be a
    letter's stroke; and so could anything that is farther away than a click errs.
    """
    farther = 0.0
    if not (sought.is_wide or sought.length_px):
        farther = _LENGTH_PER_OFFSET * max(0.0, abs(found.offset) - _CLICK_ERROR_PX)
    if sought.looks.tone != ANY:
        return max(_MIN_LENGTH_PX + farther, sought.length_px)
    if sought.looks.kind == EDGE:
        return _MIN_LENGTH_ANY_PX + farther
    if course.start_px:
        return math.inf
    beside, longer = _ONE_SIDED_LENGTHS_PX[sought.looks.kind]
    return (longer if abs(found.along) > beside else _MIN_LENGTH_ANY_PX) + farther


def snap_points_to_lines(
    picture: PixelArray,
    points: FloatArray,
    directions: FloatArray | None = None,
    sought: LineTarget = ANY_LINE_TARGET,
    *,
    reach_px: float = SNAP_RADIUS_PX,
) -> FloatArray:
    """Move many positions to the middle of their paint; see `snap`.

    Args:
        picture: (H, W, 4) BGRA.
        points: (N, 2) picture px.
        directions: (N, 2) of the lines there, or None.

    Returns:
        (N, 2) picture px; NaN where there is no convincing paint.
    """
    ways = [None] * len(points) if directions is None else map(tuple, directions.tolist())
    found = [
        snap_to_line(picture, (x, y), sought, direction=way, reach_px=reach_px)
        for (x, y), way in zip(points.tolist(), ways, strict=True)
    ]
    return np.array([place or (np.nan, np.nan) for place in found]).reshape(-1, 2)


def _patch_around(picture: PixelArray, point: tuple[float, float], reach_px: float) -> ImagePatch:
    return ImagePatch.around(picture, point, math.hypot(reach_px + MARGIN_PX, FOLLOWED_PX))


def _snap_any_direction(
    picture: PixelArray,
    patch: ImagePatch,
    point: tuple[float, float],
    sought: LineTarget,
    reach_px: float,
) -> tuple[float, float] | None:
    """The click's foot on the band that is seen in whatever direction."""
    turn = math.pi / _DIRECTIONS
    angles = np.arange(_DIRECTIONS, dtype=np.float64) * turn

    def place(found: LineBand) -> LineBand | None:
        # Seen from its own centre, a line gives its direction best.
        across = -math.sin(found.angle), math.cos(found.angle)
        x, y = (c + found.offset * a for c, a in zip(point, across, strict=True))
        centred = _patch_around(picture, (x, y), reach_px)
        finer = BandMaxima.of(
            centred, found.angle + _DIRECTION_OFFSETS * turn, sought, reach_px
        ).best()
        if finer is None or abs(finer.offset) > _RECENTRE_PX:
            return None
        courses = trace_line(centred, finer.angle, finer.offset, finer.width, sought)
        if not any(course.length_px >= _MIN_LENGTH_ANY_PX for course in courses):
            return None
        # The click's foot on it is wanted.
        across = -math.sin(finer.angle), math.cos(finer.angle)
        foot = finer.offset + (x - point[0]) * across[0] + (y - point[1]) * across[1]
        return replace(finer, offset=foot) if abs(foot) <= reach_px else None

    found = _best_confirmed_band(BandMaxima.of(patch, angles, sought, reach_px), place, unsure=True)
    if found is None:
        return None
    return (
        point[0] - found.offset * math.sin(found.angle),
        point[1] + found.offset * math.cos(found.angle),
    )


def _best_confirmed_band(
    maxima: BandMaxima, confirmed: Callable[[LineBand], LineBand | None], *, unsure: bool
) -> LineBand | None:
    """The best band that is confirmed, unless another one does nearly as well."""
    best: LineBand | None = None
    rival = _RIVAL_RATIO_ANY if unsure else _RIVAL_RATIO
    tried, failed = MAX_CANDIDATES, list[tuple[int, float]]()
    for row, column, offset, merit in maxima.ordered():
        if best is not None:
            if merit < rival * best.merit:
                break
            if _is_oblique_view_of(best, maxima.angle_of(row), offset, maxima.middle_of(row)):
                continue
        stretch = maxima.stretch_of(row)
        if any(s == stretch and abs(o - offset) < _SAME_BAND_PX for s, o in failed):
            continue
        found = maxima.band(row, column)
        if found is None or (found := confirmed(found)) is None:
            failed.append((stretch, offset))
            if len(failed) == tried:
                break
            continue
        if best is not None:
            if math.dist(found.foot, best.foot) < _DISTINCT_BAND_PX:
                continue
            return None
        best, tried = replace(found, merit=merit), len(failed) + _MAX_RIVALS
    return best


def _is_oblique_view_of(band: LineBand, angle: float, offset: float, along_px: float) -> bool:
    """Return whether a maximum is what cuts across another direction show of a band."""
    x, y = closest_offset(angle, offset)
    if math.dist((x, y), band.foot) < _DISTINCT_BAND_PX:
        return True
    away = (x - band.foot[0] + along_px * math.cos(angle)) * math.sin(band.angle) - (
        y - band.foot[1] + along_px * math.sin(angle)
    ) * math.cos(band.angle)
    return (
        abs(away) < _CROSSING_TOLERANCE_PX and abs(math.cos(angle - band.angle)) > _CROSSING_COSINE
    )
