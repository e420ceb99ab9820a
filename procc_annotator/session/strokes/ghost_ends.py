"""Where a straight ghost's line ends: at the paint of the element that it ends at.

The camera knows the ends of what it expects less surely than their courses. So the other element's
paint is looked for around the end, and both lines are crossed.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.line_ends import edge_point
from procc_annotator.fit.predict.joints import Joint
from procc_annotator.fit.predict.sight import normals_of
from procc_annotator.image.decode import PixelArray
from procc_annotator.image.paint import REACH_PX, snap_all
from procc_annotator.session.strokes.agreement import agreement
from procc_annotator.session.strokes.expected_paint import ExpectedPaint
from procc_annotator.session.strokes.visible_line import VisibleLine

FloatArray = NDArray[np.float64]

_ALONG_PX = 30.0  # how far along its line an end may lie from where the camera expects it
_HIDDEN_PX, _JOINED_PX = 40, 14  # ... and from where it is seen to end
_BAR_PX = 24  # a bar is looked for so far beyond its ends, to see where it joins
_EVERY_PX = 6.0
_BESIDE_PX = 4.0
_EDGE_GAP = 8  # px before the picture's edge where a line need not be seen
_LEAST_AGREED = 4
_BEYOND_PX = 25.0  # the other line may be seen so far before the corner only
_TANGENT_PX = 40
_MISSED_PX = 1.5
_LEAST_SINE = 0.1  # lines at less than six degrees cross nowhere that could be told
_AT_EDGE_PX = 6.0


def longer(course_px: FloatArray, sd_px: FloatArray) -> tuple[FloatArray, FloatArray]:
    """A bar's course and its standard deviations, (n, 2) and (n,), with some px at both ends."""
    begun = _continued(course_px[::-1], _BAR_PX)[::-1]
    return _continued(begun, _BAR_PX), np.pad(sd_px, _BAR_PX, mode="edge")


def ends_by_paint(
    line: VisibleLine,
    joints: tuple[Joint, ...],
    picture: PixelArray,
    paint: ExpectedPaint,
    sd_px: float,
    *,
    on_ground: bool,
) -> VisibleLine:
    """A line with its ends where it crosses the paint of the elements it ends at.

    Args:
        line: a straight element's; of a bar, found along its `longer` course.
        joints: at its ends.
        picture: (H, W, 4) BGRA.
        paint: how the elements look.
        sd_px: how surely the camera knows the elements there.
        on_ground: whether it lies on the ground, where the line may be hidden before it ends; a bar
            is seen until it joins the next one.

    Returns:
        Ends that lie at the picture's edge lie exactly there; others stay where no paint of the
        other element is found, or the line is hidden long before it.
    """
    extra = 0 if on_ground else _BAR_PX
    if not line.runs:
        return _cut(_turned(_cut(line, extra)), extra)
    size = picture.shape[1], picture.shape[0]
    for last in (True, False):
        way = line if last else _turned(line)
        corner = None
        for joint in joints:
            if joint.last == last and corner is None:
                moved = joint if on_ground else _at_seen_end(joint, way)
                other = _painted(moved, way, picture, paint, sd_px)
                corner = None if other is None else _crossing(way, other, extra)
        may_miss = _HIDDEN_PX if on_ground else _JOINED_PX
        ending = None if corner is None else _ending_at(way, corner, may_miss)
        way = _to_edge(_cut(way, extra), size) if ending is None else ending
        if not way.runs:
            return VisibleLine(way.course_px, way.directions, ())
        line = way if last else _turned(way)
    return line


def _cut(line: VisibleLine, by: int) -> VisibleLine:
    """A line without the last so many places of its course."""
    past = line.length - by
    runs = tuple((begin, min(end, past)) for begin, end in line.runs if begin < past)
    return VisibleLine(line.course_px[:past], line.directions[:past], runs) if by else line


def _at_seen_end(joint: Joint, line: VisibleLine) -> Joint:
    """The other bar where this one is seen to end: a camera that is off is off for both."""
    off = line.course_px[line.runs[-1][1] - 1] - joint.end_px
    return replace(joint, course_px=joint.course_px + off)


def _painted(
    joint: Joint, line: VisibleLine, picture: PixelArray, paint: ExpectedPaint, sd_px: float
) -> FloatArray | None:
    """(n, 2) px: the other element's line, as long as it was found; None: it was not.

    Right beside the line that ends there, it could not be told from it.
    """
    course = joint.course_px
    across = normals_of(course, 3)
    rows = np.unique(np.linspace(0, len(course) - 1, round(len(course) / _EVERY_PX) + 1).round())
    rows = rows.astype(np.intp)
    own = _continued(line.course_px[-3 * _HIDDEN_PX :], _ALONG_PX)
    rows = rows[
        np.hypot(*(course[rows][:, None] - own[None]).transpose(2, 0, 1)).min(1) > _BESIDE_PX
    ]
    if len(rows) < _LEAST_AGREED:
        return None
    along = np.column_stack([across[rows, 1], -across[rows, 0]])
    reach = float(np.clip(3.0 * sd_px, 3.0, REACH_PX))
    found = snap_all(picture, course[rows], along, paint.of(joint.name), reach_px=reach)
    offsets = ((found - course[rows]) * across[rows]).sum(axis=1)
    known = ~np.isnan(offsets)
    if known.sum() < _LEAST_AGREED:
        return None
    places = 2.0 * rows / (len(course) - 1) - 1.0
    agreed, coefficients = agreement(places[known], offsets[known], reach, curved=False)
    if agreed.sum() < _LEAST_AGREED:
        return None
    shifts = np.polynomial.legendre.legval(np.linspace(-1.0, 1.0, len(course)), coefficients)
    hit = rows[known][agreed]
    kept = slice(int(hit[0]), int(hit[-1]) + 1)
    return (course + across * shifts[:, None])[kept]


def _crossing(line: VisibleLine, other: FloatArray, extra: int) -> FloatArray | None:
    """(2,) px where a line's last end meets another line, near where it is expected."""
    own = _continued(line.course_px[-2 * _HIDDEN_PX :], _ALONG_PX)
    whole = _continued(_continued(other, _BEYOND_PX)[::-1], _BEYOND_PX)
    apart = np.hypot(*(own[:, None] - whole[None]).transpose(2, 0, 1))
    i, j = np.unravel_index(int(apart.argmin()), apart.shape)
    if apart[i, j] > _MISSED_PX:
        return None
    i, j = np.clip(i, 1, len(own) - 2), np.clip(j, 1, len(whole) - 2)
    u, v = own[i + 1] - own[i - 1], whole[j + 1] - whole[j - 1]
    determinant = u[1] * v[0] - u[0] * v[1]
    if abs(determinant) < _LEAST_SINE * np.hypot(*u) * np.hypot(*v):
        return None
    offset = whole[j] - own[i]
    share = (offset[1] * v[0] - offset[0] * v[1]) / determinant
    corner: FloatArray = own[i] + share * u
    off = np.hypot(*(corner - line.course_px[-1 - extra]))
    return corner if off <= _ALONG_PX else None


def _continued(course: FloatArray, by_px: float) -> FloatArray:
    """A course and, straight on from its last end, some more px."""
    inner = course[max(0, len(course) - 1 - _TANGENT_PX)]
    along = course[-1] - inner
    along = along / max(float(np.hypot(*along)), 1e-9)
    steps = np.arange(1.0, by_px + 1.0)[:, None]
    return np.vstack([course, course[-1] + steps * along])


def _ending_at(line: VisibleLine, corner: FloatArray, may_miss_px: int) -> VisibleLine | None:
    """A line that is continued to a place beyond its last end, or cut off there.

    None where it is seen to end elsewhere.
    """
    course = _continued(line.course_px, _ALONG_PX)
    past = int(np.hypot(*(course - corner).T).argmin())
    if past < 2 or abs(line.runs[-1][1] - past) > may_miss_px:
        return None
    course = np.vstack([course[:past], corner])
    runs = [(begin, min(end, past)) for begin, end in line.runs if begin < past]
    runs[-1] = runs[-1][0], past + 1
    return _of(course, tuple(runs))


def _to_edge(line: VisibleLine, size: tuple[int, int]) -> VisibleLine:
    """A line that ends a little inside the picture's edge, or outside it, ends there."""
    limits = np.array(size, dtype=np.float64) - 1
    end = np.clip(line.course_px[-1], 0.0, limits)
    inner = line.course_px[max(0, line.length - 1 - _TANGENT_PX)]
    along = end - inner
    length = float(np.hypot(*along))
    edge = edge_point(end, along / length, size) if length > 1e-6 else None
    seen = line.runs[-1][1] >= line.length - _EDGE_GAP
    if edge is None or np.hypot(*(edge - end)) > _AT_EDGE_PX or not seen:
        return line
    course = np.vstack([line.course_px[:-1], edge])
    runs = (*line.runs[:-1], (line.runs[-1][0], line.length))
    return replace(line, course_px=course, runs=runs)


def _turned(line: VisibleLine) -> VisibleLine:
    n = line.length
    runs = tuple((n - end, n - begin) for begin, end in reversed(line.runs))
    return VisibleLine(line.course_px[::-1], -line.directions[::-1], runs)


def _of(course: FloatArray, runs: tuple[tuple[int, int], ...]) -> VisibleLine:
    along = normals_of(course, 3)
    return VisibleLine(course, np.column_stack([along[:, 1], -along[:, 0]]), runs)
