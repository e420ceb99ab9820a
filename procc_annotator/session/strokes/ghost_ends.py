"""Where a straight ghost's line ends: at the paint of the element that it ends at, or before."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.line_ends import image_edge_point
from procc_annotator.fit.predict.ghosts import Ghost
from procc_annotator.fit.predict.joints import ExpectedEnd
from procc_annotator.image.decode import PixelArray
from procc_annotator.image.paint import snap_points_to_lines
from procc_annotator.image.sought import LineTarget
from procc_annotator.metric.course import polyline_normals
from procc_annotator.session.strokes.corners import Corner, reach_of, seen_corner
from procc_annotator.session.strokes.expected_paint import ExpectedLines
from procc_annotator.session.strokes.line_runs import is_bare
from procc_annotator.session.strokes.visible_line import VisibleLine, continued, onwards

FloatArray = NDArray[np.float64]
BoolArray = NDArray[np.bool_]

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
        paint: how the elements look.
        on_ground: whether it lies on the ground, where the line may be hidden before it ends; a bar
            is seen until it joins the next one.

    Returns:
        The line, and how many of its ends are cut back. It goes on to the picture's edge only
        where it has no end in the picture, and then lies exactly there.
    """
    may_miss = _HIDDEN_PX if on_ground else _JOINED_PX
    corners = _corners(line, ghost, picture, paint, may_miss)
    sought, unsure = paint.of(ghost.name), 0
    for last in (True, False):
        way, end, corner = (line if last else _reversed_line(line)), ghost.ends[last], corners.get(last)
        if not way.runs:
            break
        ending: VisibleLine | None = None
        if end is None or (corner and not _is_inside(corner.place_px, picture)):
            ending = _to_edge(way, picture, sought)
        elif corner and not (on_ground and is_bare(picture, *_before(way, corner))):
            ending = _ending_at(way, corner)
        if ending is None and end is not None:
            ending, unsure = _cut_back(way, end), unsure + 1
        line = ending or way
        line = line if last else _reversed_line(line)
    return line, unsure


def _corners(
    line: VisibleLine, ghost: Ghost, picture: PixelArray, paint: ExpectedLines, may_miss_px: int
) -> dict[bool, Corner]:
    """The corners at which a line ends, by whether it is its last one.

    What the one is off from where the camera expects it, the other is by nearly as much.
    """
    found: dict[bool, Corner] = {}
    shifted = 0.0
    first = reach_of(ghost.ends[0]) > reach_of(ghost.ends[1])
    for last in (first, not first, first):
        way, end = (line if last else _reversed_line(line)), ghost.ends[last]
        if last in found or end is None or not way.runs:
            continue
        corner = seen_corner(
            way, end, picture, paint, ghost, may_miss_px=may_miss_px, shifted_px=shifted
        )
        if corner is None:
            continue
        found[last] = corner
        at = way.expected[1]
        shifted = -float((corner.place_px - way.course_px[at]) @ way.directions[at])
    return found


def _before(line: VisibleLine, corner: Corner) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Where a line was seen last, and what lies between it and its last end: (n, 2) px of both, and
    (n,) whether they are of the second."""
    course = continued(line.course_px, _HIDDEN_PX)
    past = max(2, int(np.hypot(*(course - corner.place_px).T).argmin()))
    begin, end = line.runs[-1]
    seen = np.arange(max(begin, end - _HIDDEN_PX), end)
    last = np.arange(max(0, past - _LAST_PX[1]), max(1, past - _LAST_PX[0] + 1))
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
    """A line as far as it is surely its own."""
    sure = line.expected[1] - math.ceil(reach_of(end))
    seen = max((past for begin, past in line.runs if begin <= line.expected[1]), default=0)
    past = sure if seen >= line.length - _EDGE_GAP else max(sure, seen - _BACK_PX)
    runs = tuple((a, min(b, past)) for a, b in line.runs if a < past - 1)
    return replace(line, runs=runs)


def _is_inside(place_px: FloatArray, picture: PixelArray) -> bool:
    limits = np.array([picture.shape[1], picture.shape[0]]) - 1.0
    return bool(((place_px >= 0) & (place_px <= limits)).all())


def _to_edge(line: VisibleLine, picture: PixelArray, sought: LineTarget) -> VisibleLine | None:
    """A line that is seen to end a little inside the picture's edge, or outside it, ends there."""
    size = picture.shape[1], picture.shape[0]
    limits = np.array(size, dtype=np.float64) - 1
    end = np.clip(line.course_px[-1], 0.0, limits)
    edge = image_edge_point(end, onwards(line.course_px), size)
    if edge is None or np.hypot(*(edge - end)) > _AT_EDGE_PX:
        return None
    begin, past = line.runs[-1]
    runs = (*line.runs[:-1], (begin, line.length))
    if past < line.length - _EDGE_GAP:
        again = _seen_again(line, picture, sought)
        if again is None:
            return None
        runs = (*line.runs, (again, line.length))
    course = np.vstack([line.course_px[:-1], edge])
    return replace(line, course_px=course, runs=runs, expected=(line.expected[0], line.length - 1))


def _seen_again(line: VisibleLine, picture: PixelArray, sought: LineTarget) -> int | None:
    """The place from which a line that was hidden is seen until its last end, which is too near
    for it to show a steady stroke; None: it is not."""
    rows = np.arange(line.length - 1, max(line.runs[-1][1], line.length - _HIDDEN_PX), -_AGAIN_PX)
    course, along = line.course_px[rows], line.directions[rows]
    found = snap_points_to_lines(picture, course, along, sought, reach_px=_AGAIN_REACH_PX)
    seen = ~np.isnan(found[:, 0])
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
