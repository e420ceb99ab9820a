"""Where paint lies under an annotation and where it does not, by the picture alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, points_px
from procc_annotator.field.appearance import NOTHING
from procc_annotator.field.geometry import Chain
from procc_annotator.field.model import Field
from procc_annotator.fit.labels.seen_paint import LineEvidence
from procc_annotator.fit.line_ends import steps_to_image_edge
from procc_annotator.fit.solving.observations import FloatArray, IntArray, ImageFrame
from procc_annotator.image.decode import PixelArray
from procc_annotator.image.paint import SNAP_RADIUS_PX, snap_points_to_lines
from procc_annotator.image.sought import LineTarget
from procc_annotator.metric.course import arc_lengths, points_at_arc_lengths
from procc_annotator.session.strokes.expected_paint import ExpectedLines
from procc_annotator.session.strokes.visible_line import find_line

# Px at 960 px width.
_EVERY_PX, _AHEAD_PX = 16.0, 40.0
_PLACES = (3, 12)  # of a stretch between two clicks
_CURVE_STEPS = 12
_FAINT = 0.5  # of the places of an element that show no paint by themselves


def line_evidence(
    annotation: FrameAnnotation,
    picture: PixelArray,
    field: Field,
    known: Mapping[Polyline, LineEvidence] | None = None,
    go_on: Callable[[], None] = lambda: None,
) -> dict[Polyline, LineEvidence]:
    """What the picture shows along each element; safe from any thread.

    Args:
        annotation: of the frame; unconfirmed elements are looked at too.
        picture: (H, W, 4) BGRA.
        field: says what elements look like; spots and classes it does not place are left out.
        known: of the same picture and field, from before: what did not change is not looked at
            again.
        go_on: called between elements; raises whatever it likes when nobody wants the rest.
    """
    paint, found = ExpectedLines(field, picture.shape[1]), {}
    for polyline in (*annotation.polylines, *annotation.unconfirmed):
        element = field.element(polyline.class_name)
        if element is None or element.is_spot or len(polyline.points) < 2:
            continue
        sought = paint.of(polyline.class_name)
        if sought.looks.kind == NOTHING:
            continue
        seen = known.get(polyline) if known is not None else None
        if seen is None:
            go_on()
            smooth = element.is_curved and not isinstance(element.geometry, Chain)
            seen = _along(polyline, picture, sought, smooth=smooth)
        if seen is not None:
            found[polyline] = seen
    return found


def line_evidence_by_class(
    annotation: FrameAnnotation, picture: PixelArray, field: Field
) -> dict[str, LineEvidence]:
    """The same of the confirmed elements, by class."""
    confirmed = replace(annotation, unconfirmed=())
    return confirmed_evidence(annotation, line_evidence(confirmed, picture, field))


def confirmed_evidence(
    annotation: FrameAnnotation, evidence: Mapping[Polyline, LineEvidence]
) -> dict[str, LineEvidence]:
    """Class -> what is seen along the confirmed element."""
    return {p.class_name: evidence[p] for p in annotation.polylines if p in evidence}


def _along(
    polyline: Polyline, picture: PixelArray, sought: LineTarget, *, smooth: bool
) -> LineEvidence | None:
    size = (picture.shape[1], picture.shape[0])
    per_px = 1 / ImageFrame(size).scale
    limits = np.array(size) - 1.0
    clicks = points_px(polyline, size)
    clicks = clicks[np.isfinite(clicks).all(axis=1)]
    clicks = clicks[np.concatenate([[True], (np.diff(clicks, axis=0) != 0).any(axis=1)])]
    if len(clicks) < 2:
        return None
    places, along, segments, lengths = _places(clicks, per_px, smooth=smooth)
    inside = ((places >= 0) & (places <= limits)).all(axis=1)
    if inside.sum() < 2:
        return None
    places, along, lengths = places[inside], along[inside], lengths[inside]
    reach = SNAP_RADIUS_PX * min(max(per_px, 1.0), 2.0)

    def offsets(at: FloatArray, directions: FloatArray) -> FloatArray:
        found = snap_points_to_lines(picture, at, directions, sought, reach_px=reach)
        across = np.column_stack([-directions[:, 1], directions[:, 0]])
        return np.asarray(((found - at) * across).sum(axis=1))

    ahead = []
    for end, inner in ((clicks[0], clicks[1]), (clicks[-1], clicks[-2])):
        step = (end - inner) / np.hypot(*(end - inner))
        most = 0.0
        if not smooth and ((end >= 0) & (end <= limits)).all():
            most = min(_AHEAD_PX * per_px, steps_to_image_edge(end, step, limits))
        distances = np.arange(_EVERY_PX * per_px / 2, most, _EVERY_PX * per_px / 2)
        beyond = end + distances[:, None] * step
        ahead.append((distances, offsets(beyond, np.tile(step, (len(distances), 1)))))
    found = offsets(places, along)
    if not smooth and np.isnan(found).mean() > _FAINT:
        found = _along_faint_line(picture, clicks, places, along, found, sought, reach)
    return LineEvidence(size, places, found, segments[inside], lengths, (ahead[0], ahead[1]))


def _along_faint_line(
    picture: PixelArray,
    clicks: FloatArray,
    places: FloatArray,
    along: FloatArray,
    offsets: FloatArray,
    sought: LineTarget,
    reach: float,
) -> FloatArray:
    """(n,) offsets (n,), those missing from a line that is seen as a whole only: single cuts across
    it do not stand out of the noise, as `find_line` does that points are put on paint by."""
    line = find_line(
        picture, clicks, np.full(len(clicks), reach / 3), sought, curved=False, on_ground=False
    )
    away = places[:, None] - line.course_px[None]
    nearest = np.hypot(away[..., 0], away[..., 1]).argmin(axis=1)
    shown = np.zeros(line.length, dtype=bool)
    for begin, end in line.runs:
        shown[begin:end] = True
    across = np.column_stack([-along[:, 1], along[:, 0]])
    off = ((line.course_px[nearest] - places) * across).sum(axis=1)
    return np.where(np.isnan(offsets) & shown[nearest] & (np.abs(off) <= reach), off, offsets)


def _places(
    clicks: FloatArray, per_px: float, *, smooth: bool
) -> tuple[FloatArray, FloatArray, IntArray, FloatArray]:
    """(n, 2) px evenly between clicks, (n, 2) directions, (n,) segments, (n,) px of length."""
    found = []
    for segment in range(len(clicks) - 1):
        course = _course(clicks, segment) if smooth else clicks[segment : segment + 2]
        at = arc_lengths(course)
        steps = np.diff(at)
        count = int(np.clip(round(at[-1] / (_EVERY_PX * per_px)), *_PLACES))
        middles = (np.arange(count) + 0.5) * at[-1] / count
        places = points_at_arc_lengths(course, middles, at)
        row = np.clip(np.searchsorted(at, middles) - 1, 0, len(steps) - 1)
        along = np.diff(course, axis=0)[row] / np.maximum(steps[row], 1e-9)[:, None]
        found.append((places, along, np.full(count, segment), np.full(count, at[-1] / count)))
    places, along, segments, lengths = (np.concatenate(part) for part in zip(*found, strict=True))
    return places, along, segments, lengths


def _course(clicks: FloatArray, segment: int) -> FloatArray:
    """(n, 2) px of a smooth curve between two clicks, by those around them (Catmull-Rom)."""
    begin, end = clicks[segment], clicks[segment + 1]
    first, last = max(segment - 1, 0), min(segment + 2, len(clicks) - 1)
    before, after = (end - clicks[first]) / 2, (clicks[last] - begin) / 2
    t = np.linspace(0.0, 1.0, _CURVE_STEPS)[:, None]
    bent = (2 * t**3 - 3 * t**2 + 1) * begin + (3 * t**2 - 2 * t**3) * end
    return np.asarray(bent + (t**3 - 2 * t**2 + t) * before + (t**3 - t**2) * after)
