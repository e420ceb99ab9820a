"""Locate the ends of a straight ghost at the lines it meets."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.assist.visible_line import (
    VisibleLine,
    continued,
    is_bare,
    onwards,
    smooth_inliers,
)
from procc_annotator.calibration.prediction.ghosts import ElementJoint, ExpectedEnd, Ghost
from procc_annotator.calibration.prediction.visible_elements import image_edge_point
from procc_annotator.field.model import BAR
from procc_annotator.image.line_offsets import offsets_along_curve
from procc_annotator.image.line_snapping import SNAP_RADIUS_PX
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.polylines import polyline_normals

FARTHEST_PX = 80.0  # an end is looked for so far beyond where the camera expects it
_LEAST_SD = 3.0  # standard deviations: 99.7 %
_LEAST_PX = 14.0
_EVERY_PX, _MOST_PLACES = 6.0, 26
_BESIDE_PX = 4.0
_LEAST_AGREED = 4
_LEAST_SHARE, _SURE_SHARE = 0.3, 0.7  # of the other's course, where its paint is found
_FARTHER = 0.3  # so much less counts one at the farthest place
_MISSED = 0.3  # ... or one to which the line is hardly seen to go
_LEAST_MERIT = 0.3
_TRIED_PX = 25.0
_BEYOND_PX = 40.0  # the other line may be seen so far before the corner only
_MISSED_PX = 1.5
_LEAST_SINE = 0.1  # lines at less than six degrees cross nowhere that could be told
_STEEP_SINE = 0.8  # what a course is off is little along the other one
_NEAR_PX = 10.0, 76.0  # of the corner: from where both are followed to it
_LOCAL_EVERY_PX, _LOCAL_REACH_PX = 5.0, 2.5
_LOCAL_AGREED, _LOCAL_SPAN_PX = 5, 15.0
_LOCAL_OFF_PX = 0.2  # from the straight line: what belongs to it
_REFINED_PX = 1.0  # across


@dataclass(frozen=True, slots=True)
class Corner:
    """End of a line.

    Attributes:
        place_px: (2,) px.
        is_seen: whether its paint was followed up to there.
    """

    place_px: FloatArray
    is_seen: bool


@dataclass(frozen=True, eq=False, slots=True)
class _Scene:
    """The picture (H, W, 4) BGRA, how its elements look, and the ghost that the line belongs to."""

    picture: PixelArray
    paint: ExpectedLines
    ghost: Ghost

    def offsets(
        self,
        course: FloatArray,
        across: FloatArray,
        rows: IntArray,
        name: str,
        reach: float,
        *,
        bars_alone: bool = True,
    ) -> FloatArray:
        """(k,) px from places of a course (n, 2) to the paint of an element, along its normals
        (n, 2); NaN where there is none."""
        sought = self.paint.of(name)
        return offsets_along_curve(
            self.picture, course, across, rows, sought, reach, bars_alone=bars_alone
        )


@dataclass(frozen=True, slots=True)
class _Candidate:
    place: FloatArray
    row: int  # of the line
    merit: float
    other: FloatArray
    sine: float  # of the angle between both
    name: str


def reach_of(end: ExpectedEnd | None) -> float:
    """Px along a line within which its end lies: three standard deviations."""
    if end is None:
        return 0.0
    return float(np.clip(np.nan_to_num(_LEAST_SD * end.sd_px, nan=np.inf), _LEAST_PX, FARTHEST_PX))


def _seen_corner(
    line: VisibleLine, end: ExpectedEnd, scene: _Scene, *, may_miss_px: float, shifted_px: float
) -> Corner | None:
    """Return where a line's last end meets the paint of an element that it ends at; None where no
    other element's paint is found, or the line is not seen to go there, or only beyond.

    Args:
        may_miss_px: so far before the corner the line need not be seen.
        shifted_px: how much farther on than expected the line's first end was found.
    """
    best: _Candidate | None = None
    for candidate in (
        candidate
        for joint in end.joints
        for candidate in _candidates(line, end, joint, scene, shifted_px)
        if candidate.row > line.runs[0][0]
    ):
        missed = abs(candidate.row - line.runs[-1][1]) / may_miss_px
        merit = candidate.merit - _MISSED * min(missed, 1.0)
        if best is None or merit > best.merit:
            best = replace(candidate, merit=merit)
        if merit >= _SURE_SHARE:
            break
    if best is None or best.merit < _LEAST_MERIT:
        return None
    is_near = abs(best.row - line.runs[-1][1]) <= may_miss_px
    if is_near and best.sine >= _STEEP_SINE:
        return Corner(best.place, False)
    place, seen = _refined(line, best, scene)
    return Corner(place, seen) if seen or is_near else None


def _candidates(
    line: VisibleLine, end: ExpectedEnd, joint: ElementJoint, scene: _Scene, shifted_px: float
) -> Iterator[_Candidate]:
    """Return where the other element's paint crosses the line, the nearest to the expected end
    first."""
    at = line.expected[1]
    along, anchor = line.directions[at], line.course_px[at]
    course = joint.course_px + (anchor - end.place_px)
    other = course[-1] - course[0]
    sine = abs(along[0] * other[1] - along[1] * other[0]) / max(float(np.hypot(*other)), 1e-9)
    if sine < _LEAST_SINE:
        return
    reach = float(np.clip(3.0 * scene.ghost.sd_px, 3.0, SNAP_RADIUS_PX))
    farthest, step = reach_of(end), 1.6 * reach / sine
    own = continued(line.course_px, _TRIED_PX)

    def off(shift: float) -> float:
        return min(abs(shift), abs(shift - shifted_px)) / farthest

    count = int((farthest + abs(shifted_px)) / step)
    shifts = [*(np.arange(-count, count + 1) * step).tolist(), shifted_px]
    for shift in sorted({s for s in shifts if off(s) <= 1.0}, key=off):
        found = _detected_line(course + shift * along, line, scene, joint.name, reach)
        place = None if found is None else _crossing(own, found[0])
        if found is None or place is None:
            continue
        painted, share = found
        apart = off(float((place - anchor) @ along))
        row = int(np.hypot(*(own - place).T).argmin())
        yield _Candidate(place, row, share - _FARTHER * apart, painted, sine, joint.name)


def _detected_line(
    course: FloatArray, line: VisibleLine, scene: _Scene, name: str, reach: float
) -> tuple[FloatArray, float] | None:
    """(n, 2) px: the other element's line, as long as it was found, and where of its course it was,
    as a share.

    Right next to the line that ends there, it could not be distinguished from it.
    """
    limits = _limits(scene.picture)
    count = min(round(len(course) / _EVERY_PX), _MOST_PLACES) + 1
    rows = np.unique(np.linspace(0, len(course) - 1, count).round())
    rows = rows.astype(np.intp)
    rows = rows[((course[rows] >= 0) & (course[rows] <= limits)).all(axis=1)]
    rows = rows[_curve_distances(course[rows], line.course_px) > _BESIDE_PX]
    if len(rows) < _LEAST_AGREED:
        return None
    across = polyline_normals(course, 3)
    sought, places = scene.paint.of(name), 2.0 * rows / (len(course) - 1) - 1.0
    for alone in (False, True) if sought.looks.kind == BAR else (False,):
        offsets = scene.offsets(course, across, rows, name, reach, bars_alone=alone)
        known = ~np.isnan(offsets)
        if known.sum() < _LEAST_AGREED:
            return None
        agreed, coefficients = smooth_inliers(
            places[known], offsets[known], reach, terms=3 if sought.bends else 2
        )
        share = float(agreed.sum() / len(rows))
        if agreed.sum() < _LEAST_AGREED or share < _LEAST_SHARE:
            return None
    shifts = np.polynomial.legendre.legval(np.linspace(-1.0, 1.0, len(course)), coefficients)
    painted, hit = course + across * shifts[:, None], rows[known][agreed]
    # Next to the picture's edge there is no ground to one side of it.
    at_edge = np.any((painted < _AT_EDGE_PX) | (painted > limits - _AT_EDGE_PX), axis=1)
    first = rows[0] if at_edge[rows[0] : hit[0]].all() else hit[0]
    last = rows[-1] if at_edge[hit[-1] + 1 : rows[-1] + 1].all() else hit[-1]
    return painted[first : last + 1], share


def _curve_distances(places: FloatArray, course: FloatArray) -> FloatArray:
    """(n,) px from places to the nearest of a course."""
    return np.asarray(_distances(places, course).min(axis=1)) if len(places) else np.zeros(0)


def _distances(places: FloatArray, others: FloatArray) -> FloatArray:
    """(n, m) px between places (n, 2) and others (m, 2)."""
    (x, y), (u, v) = places.T, others.T
    away = x[:, None] - u
    away *= away
    across = y[:, None] - v
    across *= across
    away += across
    return np.asarray(np.sqrt(away, out=away))


def _crossing(own: FloatArray, other: FloatArray) -> FloatArray | None:
    """(2,) px where two courses cross, the other one continued at both ends."""
    whole = continued(continued(other, _BEYOND_PX)[::-1], _BEYOND_PX)
    apart = _distances(own, whole)
    i, j = divmod(int(apart.argmin()), len(whole))
    if apart[i, j] > _MISSED_PX:
        return None
    i, j = min(max(i, 1), len(own) - 2), min(max(j, 1), len(whole) - 2)
    return _meeting(own[i], own[i + 1] - own[i - 1], whole[j], whole[j + 1] - whole[j - 1])


def _meeting(a: FloatArray, u: FloatArray, b: FloatArray, v: FloatArray) -> FloatArray | None:
    """(2,) px where two straight lines meet, each by a place and a direction."""
    determinant = u[1] * v[0] - u[0] * v[1]
    if abs(determinant) < _LEAST_SINE * np.hypot(*u) * np.hypot(*v):
        return None
    offset = b - a
    share = (offset[1] * v[0] - offset[0] * v[1]) / determinant
    return np.asarray(a + share * u)


def _refined(line: VisibleLine, found: _Candidate, scene: _Scene) -> tuple[FloatArray, bool]:
    """The same corner, by what both lines are like close to it, and whether the line is seen there.

    A smooth course over a whole element is off by some tenths of a pixel here: at a shallow angle
    by pixels along the line.
    """
    own = _close_by(line.course_px, found.place, found.other, scene, scene.ghost.name)
    if scene.paint.of(found.name).bends or own is None:
        return found.place, own is not None
    other = _close_by(found.other, found.place, line.course_px, scene, found.name)
    place = None if other is None else _meeting(*own, *other)
    most = _REFINED_PX * (1.0 + 3.0 * math.sqrt(1.0 - found.sine**2) / found.sine)
    if place is None or np.hypot(*(place - found.place)) > most:
        return found.place, True
    return place, True


def _close_by(
    course: FloatArray, corner: FloatArray, beside: FloatArray, scene: _Scene, name: str
) -> tuple[FloatArray, FloatArray] | None:
    """A straight line through a course's paint close to a corner: a place and a direction."""
    away = np.hypot(*(course - corner).T)
    nearest, farthest = _NEAR_PX
    rows = np.flatnonzero((away >= nearest) & (away <= farthest))[:: round(_LOCAL_EVERY_PX)]
    rows = rows[_curve_distances(course[rows], beside) > _BESIDE_PX]
    if len(rows) < _LOCAL_AGREED:
        return None
    across = polyline_normals(course, 3)
    offsets = scene.offsets(course, across, rows, name, _LOCAL_REACH_PX)
    found = (course[rows] + offsets[:, None] * across[rows])[~np.isnan(offsets)]
    if len(found) < _LOCAL_AGREED:
        return None
    direction = found[-1] - found[0]
    span = float(np.hypot(*direction))
    if span < _LOCAL_SPAN_PX:
        return None
    direction = direction / span
    normal = np.array([-direction[1], direction[0]])
    s, o = (found - corner) @ direction, (found - corner) @ normal
    agreed, _ = smooth_inliers(2 * (s - s[0]) / (s[-1] - s[0]) - 1, o, 12.0, terms=2)
    if agreed.sum() < _LOCAL_AGREED:
        return None
    slope, level = np.polyfit(s[agreed], o[agreed], 1)
    # Closest to the corner a place may be drawn to the other line, and turn this one.
    away_px = np.abs(o - level - slope * s)
    own = away_px <= max(_LOCAL_OFF_PX, 2.0 * float(np.median(away_px[agreed])))
    slope, level = np.polyfit(s[own], o[own], 1)
    return corner + level * normal, direction + slope * normal


_HIDDEN_PX, _JOINED_PX = 40, 24  # so far before its end a line, or a bar, need not be seen
_EDGE_GAP = 8  # px before the picture's edge where a line need not be seen
_LAST_PX = 3, 6  # before an end: there the line is seen, or it ended before; nearer, the other is
_BACK_PX = 5  # so far before where its paint seems to end it is sure to be its own
_AT_EDGE_PX = 6.0
_AGAIN_PX, _AGAIN_REACH_PX = 4, 1.5
_AGAIN_FOUND = 3  # places, and one of the first ones from the edge


def locate_line_ends(
    line: VisibleLine, ghost: Ghost, picture: PixelArray, paint: ExpectedLines, *, on_ground: bool
) -> tuple[VisibleLine, int]:
    """A line with its ends where it crosses the paint of the elements that it ends at.

    An end that no other element's paint confirms is cut back to what is surely the line: one that
    stops short says less, one that goes too far says what is wrong.

    Args:
        line: the ghost's, found as far beyond both ends as they may lie.
        ghost: of a straight element, in one piece.
        picture: (H, W, 4) BGRA.
        on_ground: whether it lies on the ground, where the line may be hidden before it ends; a bar
            is seen until it joins the next one.

    Returns:
        The line, and how many of its ends are cut back. It goes on to the picture's edge only
        where it has no end in the picture, and then lies exactly there.
    """
    may_miss = _HIDDEN_PX if on_ground else _JOINED_PX
    scene, unsure = _Scene(picture, paint, ghost), 0
    corners = _corners(line, scene, may_miss)
    for last in (True, False):
        way, end, corner = (
            (line if last else _reversed_line(line)),
            ghost.ends[last],
            corners.get(last),
        )
        if not way.runs:
            break
        ending: VisibleLine | None = None
        if end is None or (corner and not _is_inside(corner.place_px, picture)):
            ending = _to_edge(way, scene)
        elif corner and not (on_ground and is_bare(picture, *_before(way, corner))):
            ending = _ending_at(way, corner)
        if ending is None and end is not None:
            ending, unsure = _cut_back(way, end), unsure + 1
        line = ending or way
        line = line if last else _reversed_line(line)
    return line, unsure


def _corners(line: VisibleLine, scene: _Scene, may_miss_px: int) -> dict[bool, Corner]:
    """The corners at which a line ends, by whether it is its last one.

    What the one is off from where the camera expects it, the other is by nearly as much.
    """
    found: dict[bool, Corner] = {}
    shifted = 0.0
    ends = scene.ghost.ends
    first = reach_of(ends[0]) > reach_of(ends[1])
    for last in (first, not first, first):
        way, end = (line if last else _reversed_line(line)), ends[last]
        if last in found or end is None or not way.runs:
            continue
        corner = _seen_corner(way, end, scene, may_miss_px=may_miss_px, shifted_px=shifted)
        if corner is None:
            continue
        found[last] = corner
        at = way.expected[1]
        shifted = -float((corner.place_px - way.course_px[at]) @ way.directions[at])
    return found


def _before(line: VisibleLine, corner: Corner) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Return where a line was seen last, and what is between it and its last end: (n, 2) px of
    both, and (n,) whether they are of the second."""
    course = continued(line.course_px, _HIDDEN_PX)
    past = max(2, int(np.hypot(*(course - corner.place_px).T).argmin()))
    begin, end = line.runs[-1]
    seen = np.arange(max(begin, end - _HIDDEN_PX), end)
    last = np.arange(
        max(0, min(end + _LAST_PX[1], past - _LAST_PX[1])), max(1, past - _LAST_PX[0] + 1)
    )
    rows = np.concatenate([seen[seen < last[0]], last])
    return course[rows], polyline_normals(course, 3)[rows], rows >= last[0]


def _ending_at(line: VisibleLine, corner: Corner) -> VisibleLine | None:
    """A line that is continued to a place beyond its last end, or cut off there; None where it is
    seen only beyond."""
    course = continued(line.course_px, _HIDDEN_PX)
    past = max(2, int(np.hypot(*(course - corner.place_px).T).argmin()))
    runs = [(begin, min(end, past)) for begin, end in line.runs if begin < past]
    if not runs:
        return None
    if not corner.is_seen or past - runs[-1][1] <= _HIDDEN_PX:
        runs[-1] = runs[-1][0], past + 1
    else:
        runs.append((past - _HIDDEN_PX, past + 1))
    course = np.vstack([course[:past], corner.place_px])
    across = polyline_normals(course, 3)
    directions = np.column_stack([across[:, 1], -across[:, 0]])
    return VisibleLine(course, directions, tuple(runs), (line.expected[0], past))


def _cut_back(line: VisibleLine, end: ExpectedEnd) -> VisibleLine:
    sure = line.expected[1] - math.ceil(reach_of(end))
    seen = max((past for begin, past in line.runs if begin <= line.expected[1]), default=0)
    past = sure if seen >= line.length - _EDGE_GAP else max(sure, seen - _BACK_PX)
    runs = tuple((a, min(b, past)) for a, b in line.runs if a < past - 1)
    return replace(line, runs=runs)


def _is_inside(place_px: FloatArray, picture: PixelArray) -> bool:
    return bool(((place_px >= 0) & (place_px <= _limits(picture))).all())


def _limits(picture: PixelArray) -> FloatArray:
    return np.array([picture.shape[1], picture.shape[0]]) - 1.0


def _to_edge(line: VisibleLine, scene: _Scene) -> VisibleLine | None:
    """A line that is seen to end a little inside the picture's edge, or outside it, ends there."""
    size = scene.picture.shape[1], scene.picture.shape[0]
    end = np.clip(line.course_px[-1], 0.0, _limits(scene.picture))
    edge = image_edge_point(end, onwards(line.course_px), size)
    if edge is None or np.hypot(*(edge - end)) > _AT_EDGE_PX:
        return None
    begin, past = line.runs[-1]
    runs = (*line.runs[:-1], (begin, line.length))
    if past < line.length - _EDGE_GAP:
        again = _seen_again(line, scene)
        if again is None:
            return None
        runs = (*line.runs, (again, line.length))
    course = np.vstack([line.course_px[:-1], edge])
    return replace(line, course_px=course, runs=runs, expected=(line.expected[0], line.length - 1))


def _seen_again(line: VisibleLine, scene: _Scene) -> int | None:
    """The place from which a line that was hidden is seen until its last end, which is too near
    for it to show a steady stroke; None: it is not."""
    rows = np.arange(line.length - 1, max(line.runs[-1][1], line.length - _HIDDEN_PX), -_AGAIN_PX)
    across = np.column_stack([-line.directions[:, 1], line.directions[:, 0]])
    offsets = scene.offsets(line.course_px, across, rows, scene.ghost.name, _AGAIN_REACH_PX)
    seen = ~np.isnan(offsets)
    if seen.sum() < _AGAIN_FOUND or not seen[:_AGAIN_FOUND].any():
        return None
    return int(rows[np.flatnonzero(seen)[-1]])


def _reversed_line(line: VisibleLine) -> VisibleLine:
    n = line.length
    runs = tuple((n - end, n - begin) for begin, end in reversed(line.runs))
    first, last = line.expected
    return VisibleLine(
        line.course_px[::-1], -line.directions[::-1], runs, (n - 1 - last, n - 1 - first)
    )
