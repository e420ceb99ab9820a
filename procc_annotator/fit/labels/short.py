"""Ends of straight elements that stop short of the corner or of the picture's edge."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Element, Field
from procc_annotator.field.neighbours import touching_elements
from procc_annotator.field.sample import sample_evenly
from procc_annotator.fit.labels.clicked import AnnotatedElement, FrameEvidence, in_image_px
from procc_annotator.fit.labels.finding import LOOK, Finding, Rule, Severity, error_classes
from procc_annotator.fit.line_ends import expected_line_end, image_edge_point
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame
from procc_annotator.language import translatable

# A shorter gap is how people click; beyond a longer one the line is hidden or worn.
_MIN_GAP_PX, _MAX_GAP_PX = 15.0, 40.0
_MAX_OFF_LINE_PX = 15.0
_ON_ELEMENT_M = 0.2
_END_SPACING_M = 0.25
_CORNER_TEXT = translatable("its corner", "where a line ends")
_EDGE_TEXT = translatable("the picture's edge", "where a line ends")


def short_end_findings(looked_at: FrameEvidence, known: Sequence[Finding]) -> Iterator[Finding]:
    """Ends that were clicked too early; worth a look, no more. A camera that fits everything knows
    where the elements end; without one the other elements do."""
    clicked, field, frame = looked_at.clicked, looked_at.field, looked_at.frame
    by_name, wrong = {one.name: one for one in clicked}, error_classes(known)
    camera = looked_at.fit.camera if looked_at.is_whole else None
    model = looked_at.fit.model if camera is not None else None
    for one in clicked:
        if one.name in wrong or not one.element.is_straight or len(one.points) < 2:
            continue
        points = _inside_image(one.points, frame)
        shown = _projected_ends(one.element, camera) if camera is not None else None
        gaps = []
        for index, inner in ((0, points[1]), (-1, points[-2])):
            end = points[index]
            if shown is None:
                place = _end_by_neighbours(one, end, inner, field, frame, by_name)
            else:
                place = _end_by_camera(end, inner, points, shown, frame)
            gap = 0.0 if place is None else float(np.hypot(*(place[0] - end)))
            seen = looked_at.paint.get(one.name)
            if seen is not None and seen.ends_at(index, gap * frame.scale / seen.scale):
                continue  # it is hidden there, or ends
            if place is not None and _is_relevant_gap(gap * frame.scale):
                gaps.append((gap, place[1]))
        if gaps:
            yield Finding(
                Rule.SHORT,
                Severity.HINT,
                (one.name,),
                _gap_sentence(one.title, gaps),
                (LOOK,),
                model=model,
            )


def _gap_sentence(title: str, gaps: Sequence[tuple[float, str]]) -> str:
    (px, what), *others = gaps
    for px_2, what_2 in others:
        return translatable(
            "{title} stops {px:.0f} px short of {what}, and {px_2:.0f} px short of {what_2} at its"
            " other end",
            title=title,
            px=px,
            what=what,
            px_2=px_2,
            what_2=what_2,
        )
    return translatable("{title} stops {px:.0f} px short of {what}", title=title, px=px, what=what)


def _is_relevant_gap(gap_px: float) -> bool:
    return _MIN_GAP_PX < gap_px < _MAX_GAP_PX


def _inside_image(points: FloatArray, frame: ImageFrame) -> FloatArray:
    return np.asarray(points / frame.scale + frame.centre_px)


def _end_by_camera(
    end: FloatArray, inner: FloatArray, points: FloatArray, shown: FloatArray, frame: ImageFrame
) -> tuple[FloatArray, str] | None:
    """Where the camera lets the element end beyond a clicked end, and what is there."""
    along = end - inner
    if np.hypot(*along) < 1e-6:
        return None
    along = along / np.hypot(*along)
    reach = float(np.hypot(*np.ptp(points, axis=0)))
    edge = image_edge_point(end, along, frame.size)
    if edge is None:
        return None
    to_edge = float((edge - end) @ along)
    for true_end in shown:
        ahead = float((true_end - end) @ along)
        beside = abs(float((true_end - end) @ (-along[1], along[0])))
        if ahead > -reach / 2 and beside < in_image_px(_MAX_OFF_LINE_PX, frame) and ahead < to_edge:
            return (end + max(ahead, 0.0) * along, _CORNER_TEXT)
    return edge, _EDGE_TEXT


def _projected_ends(element: Element, camera: Camera) -> FloatArray:
    """(n, 2) px: the ends of a straight element that a camera shows."""
    shape = element.geometry
    assert isinstance(shape, Line)  # of straight elements only
    pixels, in_front = camera.project(np.array([shape.start, shape.end]))
    return pixels[in_front & np.isfinite(pixels).all(axis=1)]


def _end_by_neighbours(
    one: AnnotatedElement,
    end: FloatArray,
    inner: FloatArray,
    field: Field,
    frame: ImageFrame,
    by_name: Mapping[str, AnnotatedElement],
) -> tuple[FloatArray, str] | None:
    corners = [
        _inside_image(other.points, frame)
        for name in _elements_at_end(field.elements, one.name)
        if (other := by_name.get(name)) is not None
        and other.element.is_straight
        and len(other.points) > 1
    ]
    reach = in_image_px(_MAX_GAP_PX, frame)
    corner = expected_line_end(end, inner, corners, None, reach)
    if corner is not None:
        ahead = float((corner - end) @ (end - inner))
        return (corner, _CORNER_TEXT) if ahead > 0 else None
    place = expected_line_end(end, inner, (), frame.size, reach)
    return None if place is None else (place, _EDGE_TEXT)


@lru_cache(maxsize=256)
def _elements_at_end(elements: tuple[Element, ...], name: str) -> tuple[str, ...]:
    """The elements at which a straight one ends, not those that it merely crosses or carries."""
    field = Field("", "", (), elements)
    shape = elements[field.index[name]].geometry
    assert isinstance(shape, Line)  # of straight elements only
    ends = np.array([shape.start, shape.end])
    samples = sample_evenly(field, _END_SPACING_M)
    found = []
    for other in touching_elements(field, name):
        points = samples.of(field.index[other])
        apart = np.sqrt(((ends[:, None] - points[None]) ** 2).sum(axis=2)).min(axis=1)
        if (apart < _ON_ELEMENT_M).any():
            found.append(other)
    return tuple(found)
