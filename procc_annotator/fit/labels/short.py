"""Ends of straight elements that stop short of the corner or of the picture's edge."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Element, Field
from procc_annotator.field.neighbours import meeting
from procc_annotator.field.sample import sample_every
from procc_annotator.fit.labels.clicked import Clicked, ClickedFrame, in_picture
from procc_annotator.fit.labels.finding import LOOK, Finding, Rule, Severity, surely_wrong
from procc_annotator.fit.line_ends import belongs_at, edge_point
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame
from procc_annotator.language import said

# A shorter gap is how people click; beyond a longer one the line is hidden or worn.
_SHORTEST_GAP_PX, _LONGEST_GAP_PX = 15.0, 40.0
_BESIDE_PX = 15.0
_ON_IT_M = 0.2
_SPACING_M = 0.25
_CORNER = said("its corner", "where a line ends")
_EDGE = said("the picture's edge", "where a line ends")


def short_findings(looked_at: ClickedFrame, known: Sequence[Finding]) -> Iterator[Finding]:
    """Ends that were clicked too early; worth a look, no more. A camera that fits everything knows
    where the elements end; without one the other elements do."""
    clicked, field, frame = looked_at.clicked, looked_at.field, looked_at.frame
    by_name, wrong = {one.name: one for one in clicked}, surely_wrong(known)
    camera = looked_at.fit.camera if looked_at.is_whole else None
    model = looked_at.fit.model if camera is not None else None
    for one in clicked:
        if one.name in wrong or not one.element.is_straight or len(one.points) < 2:
            continue
        points = _in_picture(one.points, frame)
        shown = _true_ends(one.element, camera) if camera is not None else None
        gaps = []
        for index, inner in ((0, points[1]), (-1, points[-2])):
            end = points[index]
            if shown is None:
                place = _by_neighbours(one, end, inner, field, frame, by_name)
            else:
                place = _by_camera(end, inner, points, shown, frame)
            gap = 0.0 if place is None else float(np.hypot(*(place[0] - end)))
            seen = looked_at.paint.get(one.name)
            if seen is not None and seen.ends_at(index, gap * frame.scale / seen.scale):
                continue  # it is hidden there, or ends
            if place is not None and _is_gap(gap * frame.scale):
                gaps.append((gap, place[1]))
        if gaps:
            yield Finding(
                Rule.SHORT,
                Severity.HINT,
                (one.name,),
                _words(one.title, gaps),
                (LOOK,),
                model=model,
            )


def _words(title: str, gaps: Sequence[tuple[float, str]]) -> str:
    (px, what), *others = gaps
    for px_2, what_2 in others:
        return said(
            "{title} stops {px:.0f} px short of {what}, and {px_2:.0f} px short of {what_2} at its"
            " other end",
            title=title,
            px=px,
            what=what,
            px_2=px_2,
            what_2=what_2,
        )
    return said("{title} stops {px:.0f} px short of {what}", title=title, px=px, what=what)


def _is_gap(gap_px: float) -> bool:
    return _SHORTEST_GAP_PX < gap_px < _LONGEST_GAP_PX


def _in_picture(points: FloatArray, frame: PictureFrame) -> FloatArray:
    return np.asarray(points / frame.scale + frame.centre_px)


def _by_camera(
    end: FloatArray, inner: FloatArray, points: FloatArray, shown: FloatArray, frame: PictureFrame
) -> tuple[FloatArray, str] | None:
    """Where the camera lets the element end beyond a clicked end, and what is there."""
    along = end - inner
    if np.hypot(*along) < 1e-6:
        return None
    along = along / np.hypot(*along)
    reach = float(np.hypot(*np.ptp(points, axis=0)))
    edge = edge_point(end, along, frame.size)
    if edge is None:
        return None
    to_edge = float((edge - end) @ along)
    for true_end in shown:
        ahead = float((true_end - end) @ along)
        beside = abs(float((true_end - end) @ (-along[1], along[0])))
        if ahead > -reach / 2 and beside < in_picture(_BESIDE_PX, frame) and ahead < to_edge:
            return (end + max(ahead, 0.0) * along, _CORNER)
    return edge, _EDGE


def _true_ends(element: Element, camera: Camera) -> FloatArray:
    """(n, 2) px: the ends of a straight element that a camera shows."""
    shape = element.geometry
    assert isinstance(shape, Line)  # of straight elements only
    pixels, in_front = camera.project(np.array([shape.start, shape.end]))
    return pixels[in_front & np.isfinite(pixels).all(axis=1)]


def _by_neighbours(
    one: Clicked,
    end: FloatArray,
    inner: FloatArray,
    field: Field,
    frame: PictureFrame,
    by_name: Mapping[str, Clicked],
) -> tuple[FloatArray, str] | None:
    corners = [
        _in_picture(other.points, frame)
        for name in _ending_at(field.elements, one.name)
        if (other := by_name.get(name)) is not None
        and other.element.is_straight
        and len(other.points) > 1
    ]
    reach = in_picture(_LONGEST_GAP_PX, frame)
    corner = belongs_at(end, inner, corners, None, reach)
    if corner is not None:
        ahead = float((corner - end) @ (end - inner))
        return (corner, _CORNER) if ahead > 0 else None
    place = belongs_at(end, inner, (), frame.size, reach)
    return None if place is None else (place, _EDGE)


@lru_cache(maxsize=256)
def _ending_at(elements: tuple[Element, ...], name: str) -> tuple[str, ...]:
    """The elements at which a straight one ends, not those that it merely crosses or carries."""
    field = Field("", "", (), elements)
    shape = elements[field.index[name]].geometry
    assert isinstance(shape, Line)  # of straight elements only
    ends = np.array([shape.start, shape.end])
    samples = sample_every(field, _SPACING_M)
    found = []
    for other in meeting(field, name):
        points = samples.of(field.index[other])
        apart = np.sqrt(((ends[:, None] - points[None]) ** 2).sum(axis=2)).min(axis=1)
        if (apart < _ON_IT_M).any():
            found.append(other)
    return tuple(found)
