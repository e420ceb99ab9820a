"""Whether clicks cover the line: ends that stop short, no line marking under the element."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.label_check.evidence import (
    ON_LINE_PX,
    AnnotatedElement,
    FrameEvidence,
    LineEvidence,
    LinePresence,
    in_image_px,
)
from procc_annotator.calibration.label_check.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
    error_classes,
    outlier_point_finding,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.prediction.visible_elements import (
    expected_line_end,
    image_edge_point,
)
from procc_annotator.camera.base import Camera
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import BAR, LIGHTER, Element, Field
from procc_annotator.field.sampling import distances_to
from procc_annotator.translation import translatable

# A shorter gap is how people click; beyond a longer one the line is hidden or worn.
_MIN_GAP_PX, _MAX_GAP_PX = 15.0, 40.0
_MAX_OFF_LINE_PX = 15.0
_ON_ELEMENT_M = 0.2
_CORNER_TEXT = translatable("its corner", "where a line ends")
_EDGE_TEXT = translatable("the picture's edge", "where a line ends")


def short_end_findings(evidence: FrameEvidence, known: Sequence[Finding]) -> Iterator[Finding]:
    """Ends that were clicked too early; worth a look, no more. A camera that fits everything knows
    where the elements end; without one the other elements do."""
    clicked, field, frame = evidence.clicked, evidence.field, evidence.frame
    if error_classes(known):
        return  # ends are looked for at elements of wrong names
    by_name = {one.name: one for one in clicked}
    camera = evidence.fit.camera if evidence.is_whole else None
    model = evidence.fit.model if camera is not None else None
    for one in clicked:
        if not one.element.is_straight or len(one.points) < 2:
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
            seen = evidence.paint.get(one.name)
            if seen is not None and seen.ends_at(index, gap * frame.scale / seen.scale):
                continue  # it is hidden there, or ends
            if place is not None and _MIN_GAP_PX < gap * frame.scale < _MAX_GAP_PX:
                gaps.append((gap, place[1]))
        if gaps:
            px, what = max(gaps)
            reason = translatable(
                "{title} stops {px:.0f} px short of {what}", title=one.title, px=px, what=what
            )
            yield Finding(Rule.SHORT, Severity.HINT, (one.name,), reason, (LOOK,), model=model)


def _inside_image(points: FloatArray, frame: ImageFrame) -> FloatArray:
    return np.asarray(points / frame.scales + frame.centre_px)


def _end_by_camera(
    end: FloatArray, inner: FloatArray, points: FloatArray, shown: FloatArray, frame: ImageFrame
) -> tuple[FloatArray, str] | None:
    """Return where the camera lets the element end beyond a clicked end, and what is there."""
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
    """The elements at which a straight one ends, not those that it merely crosses."""
    shape = next(e.geometry for e in elements if e.name == name)
    assert isinstance(shape, Line)  # of straight elements only
    near = distances_to(elements, np.array([shape.start, shape.end])).min(axis=0) < _ON_ELEMENT_M
    return tuple(
        e.name for e, is_near in zip(elements, near, strict=True) if is_near and e.name != name
    )


# Players hide shorter stretches, worn lines smaller shares, px at 960 px width.
_MIN_MISSING_PX, _MIN_MISSING_SHARE = 40.0, 0.5
_MIN_MISSING_BAR_PX = 12.0  # which is short, and stands before whatever else there is
_ERROR_MISSING_SHARE = 0.8
_MIN_CURVE_CLICKS = 5
# A straight element next to its paint: a lens bends it between its clicks.
_BEND_PX = 2.5
_MIN_SEEN_SHARE = 0.6  # what is beside something must be seen
_MIN_DISPLACED_SHARE, _END_SHARE = 0.25, 0.7
# An end next to its paint, px at 960 px width: how far at least, how near to it the point before
# still is, and how far what is seen between them may leave a line.
_DISPLACED_END_PX, _ALIGNED_PX, _LINE_RESIDUAL_PX = 2.5, 1.2, 0.9
_MIN_PLACES, _SEEN_SPACING_PX = 3, 1.2
_DISPLACED_CLICK_PX = 3.0  # at 960 px width
_FOLLOW_LINE_REMEDY = Remedy(RemedyKind.FOLLOW, translatable("move its points onto the line"))


def line_evidence_findings(evidence: FrameEvidence, known: Sequence[Finding]) -> Iterator[Finding]:
    """Return what the picture says of elements; nothing where no one examined it.

    Only of paint that is lighter than what is around it, which is found nearly always; and none
    is missed where as much of what was clicked is not seen as is: at night, in snow, in a picture
    of something else.
    """
    wrong = error_classes(known)
    judged = [
        (one, seen)
        for one in evidence.clicked
        if (seen := evidence.paint.get(one.name)) is not None and _is_checked(one)
    ]
    missed = [_has_no_line(one, seen) for one, seen in judged]
    can_see = 2 * sum(missed) <= len(missed)
    for (one, seen), is_missed in zip(judged, missed, strict=True):
        if one.name not in wrong:
            found = _displaced_finding(one, seen) or _no_line_finding(
                one, seen, is_missed=is_missed and can_see
            )
            if found is not None:
                yield found


def _displaced_finding(one: AnnotatedElement, seen: LineEvidence) -> Finding | None:
    """Paint that is seen, but next to the element or next to one of its ends."""
    if bent := _line_bend_px(one, seen):
        reason = translatable(
            "{title} bends: its line is up to {px:.0f} px off between points. Press R to follow it",
            title=one.title,
            px=bent,
        )
        return Finding(
            Rule.BESIDE_PAINT, Severity.WARNING, (one.name,), reason, (_FOLLOW_LINE_REMEDY,)
        )
    if (found := _displaced_click(seen)) is not None:
        return outlier_point_finding(one.name, one.element.title, *found, severity=Severity.WARNING)
    if (end := _displaced_end(one, seen)) is not None:
        which, off_px = end
        reason = translatable(
            "one end of {title} is {px:.0f} px off the line. Move it onto the paint",
            title=one.title,
            px=off_px,
        )
        point = one.indices[which]
        return Finding(Rule.BESIDE_PAINT, Severity.WARNING, (one.name,), reason, (LOOK,), point)
    return None


def _no_line_finding(
    one: AnnotatedElement, seen: LineEvidence, *, is_missed: bool
) -> Finding | None:
    """No paint under much of the element, or towards one of its ends."""
    if is_missed:
        share, length = seen.missing_share, seen.longest_gap_px
        is_sure = share >= _ERROR_MISSING_SHARE and _missing_px(seen) >= _MIN_MISSING_PX
        severity = Severity.WARNING if is_sure else Severity.HINT
        reason = translatable(
            "{percent:.0f} % of {title} is not on paint (longest gap {px:.0f} px). Line bends?"
            " Press R",
            title=one.title,
            percent=100 * share,
            px=length,
        )
        return Finding(Rule.NO_PAINT, severity, (one.name,), reason, (LOOK,))
    if (end := _end_without_line(one, seen)) is not None:
        reason = translatable(
            "one end of {title} is not on paint",
            title=one.title,
        )
        point = one.indices[end]
        return Finding(Rule.NO_PAINT, Severity.HINT, (one.name,), reason, (LOOK,), point)
    return None


def _is_checked(one: AnnotatedElement) -> bool:
    # Between few clicks no one knows how a curve runs.
    known = not one.element.is_curved or len(one.points) >= _MIN_CURVE_CLICKS
    return known and one.element.appearance.tone == LIGHTER


def _has_no_line(one: AnnotatedElement, seen: LineEvidence) -> bool:
    least_px = _MIN_MISSING_BAR_PX if one.element.appearance.kind == BAR else _MIN_MISSING_PX
    return seen.missing_share >= _MIN_MISSING_SHARE and _missing_px(seen) >= least_px


def _missing_px(seen: LineEvidence) -> float:
    """Length without paint, px at 960 px width."""
    return seen.missing_share * float(seen.lengths_px.sum()) * seen.scale


def _line_bend_px(one: AnnotatedElement, seen: LineEvidence) -> float:
    """Return how far the paint runs next to the middle of a straight element, px of the picture; 0
    where it does not, or no one can say."""
    if not one.element.is_straight:
        return 0.0
    off, paint = seen.steady, seen.paint
    found = paint != LinePresence.NONE
    sides = [(paint == side).mean() for side in (LinePresence.LEFT, LinePresence.RIGHT)]
    if found.mean() < _MIN_SEEN_SHARE or max(sides) < _MIN_DISPLACED_SHARE or min(sides) > 0.1:
        return 0.0
    # Its ends are on the paint: else the element is next to it as a whole, or another one's.
    at_ends = np.abs(off[found][[0, -1]]) * seen.scale
    most = float(np.quantile(np.abs(off[found]), 0.9))
    most_px = most * seen.scale
    return most if most_px >= _BEND_PX and at_ends.max() <= _END_SHARE * most_px else 0.0


def _displaced_click(seen: LineEvidence) -> tuple[int, int, float, float] | None:
    """Which click between others lies next to the paint that both its neighbours are on, of how
    many, and how far it and the others lie off, px of the picture."""
    off = np.abs(seen.click_offsets_px)
    on_line = off * seen.scale <= ON_LINE_PX
    lies_off = off[1:-1] * seen.scale >= _DISPLACED_CLICK_PX
    which = 1 + np.flatnonzero(lies_off & on_line[:-2] & on_line[2:])
    if not len(which):
        return None
    worst = int(which[off[which].argmax()])
    rest = np.nanmax(np.delete(off, worst))
    return worst, len(off), float(off[worst]), float(rest)


def _displaced_end(one: AnnotatedElement, seen: LineEvidence) -> tuple[int, float] | None:
    """Which end of a straight element lies next to its paint, 0 or -1, and how far, px of the
    picture: from the click before it the paint steadily leaves the line."""
    if not one.element.is_straight:
        return None
    for end in (0, -1):
        rows = np.flatnonzero(seen.segments == seen.segments[end])
        rows = rows if end == -1 else rows[::-1]
        way = (np.arange(len(rows)) + 0.5) / len(rows)  # 1 at the end
        off = seen.steady[rows] * seen.scale
        there = ~np.isnan(off)
        if there.sum() < max(_MIN_PLACES, _MIN_SEEN_SHARE / 2 * len(rows)):
            continue
        slope, before = np.polyfit(way[there], off[there], 1)
        apart = np.abs(before + slope * way[there] - off[there])
        at_end = abs(before + slope)
        seen_px = np.abs(off[there][-1])  # farther off nothing is looked for
        starts_on_it = abs(before) <= _ALIGNED_PX and np.median(apart) <= _LINE_RESIDUAL_PX / 2
        if (
            starts_on_it
            and at_end >= _DISPLACED_END_PX
            and seen_px >= _SEEN_SPACING_PX
            and apart.max() < _LINE_RESIDUAL_PX
        ):
            return end, at_end / seen.scale
    return None


def _end_without_line(one: AnnotatedElement, seen: LineEvidence) -> int | None:
    """Which end of a straight element has no paint between it and the click before it, 0 or -1,
    though all else has."""
    if not one.element.is_straight:
        return None
    unseen = seen.paint != LinePresence.UNDER
    for end in (0, -1):
        there = seen.segments == seen.segments[end]
        rest = (~there).sum()
        is_seen = not unseen[there].all() or seen.missing[there].mean() <= _MIN_MISSING_SHARE
        if there.sum() >= _MIN_PLACES <= rest and not is_seen and not unseen[~there].any():
            return end
    return None
