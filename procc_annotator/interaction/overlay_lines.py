"""Lines of an overlay: annotated, projected, evidence strips, camera wireframe."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.label_check.evidence import LineEvidence, LinePresence
from procc_annotator.calibration.prediction.uncertainty import ErrorEllipse
from procc_annotator.field.markings import class_of_border
from procc_annotator.field.model import Field
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay_primitives import (
    NO_LINE,
    NO_POINTS,
    NO_SEGMENTS,
    UNSCORED,
    Draft,
    Drawn,
    DrawnLine,
    Labels,
    Overlay,
    PointMarks,
    ScoredFrame,
    ScoredProjection,
    Size,
    Strokes,
    joined,
    segments_by_element,
)
from procc_annotator.metrics.projection import ProjectedField
from procc_annotator.metrics.score import FrameScore

_PROJECTED = ("not_annotated", "tp", "too_far")
_ANNOTATED = ("tp", "too_far", "missed")
_ELLIPSE_WIDTH, _ELLIPSE_OUTLINE_WIDTH, _ELLIPSE_OUTLINE = 1.4, 3.0, "#101010"
_ELLIPSE_DASH = (4.0, 2.5)
_SMALLEST_ELLIPSE_PX = 1.0  # picture px; below that the place is as good as known


@dataclass(frozen=True, eq=False)
class ShownEllipse:
    """Error ellipse of a landmark in a view, picture px, in the landmark's colour."""

    colour: str
    ellipse: ErrorEllipse


def halos(
    drawn: Drawn, verdict: ScoredFrame, highlight: str | None, selected: str | None
) -> Iterable[Strokes]:
    """Return what is under the lines of the hovered and the selected element.

    White alone would vanish on the painted lines of the field, hence the dark rims. The selected
    element's projection is emphasised only if there is no annotation to emphasise.
    """
    for segments, width in (
        (verdict.projection_of(highlight), tones.PROJECTION_WIDTH),
        (drawn.segments(highlight), tones.ANNOTATION_WIDTH),
    ):
        yield Strokes(segments, tones.OUTLINE, width + 3.5, layer="highlight")
        yield Strokes(segments, tones.HALO, width + 2.0, layer="highlight")
    alone = NO_SEGMENTS if selected in drawn else verdict.projection_of(selected)
    for segments, width in (
        (alone, tones.PROJECTION_WIDTH),
        (drawn.segments(selected), tones.ANNOTATION_WIDTH),
    ):
        yield Strokes(segments, tones.OUTLINE, width + 5.5, layer="selection")
        yield Strokes(segments, tones.HALO, width + 3.5, layer="selection")


def unconfirmed_strokes(waiting: Drawn) -> Iterable[Strokes]:
    """Unconfirmed elements: on a dark rim, for short blue dashes vanish on grass."""
    lines, width = waiting.all_segments, tones.ANNOTATION_WIDTH
    yield Strokes(lines, tones.HALO, width + 1.5, layer="unconfirmed")
    yield Strokes(lines, tones.UNCONFIRMED, width, tones.UNCONFIRMED_DASH, "unconfirmed")


def second_strokes(second: Drawn) -> Iterable[Strokes]:
    """Return what the second annotator clicked."""
    width = tones.PROJECTION_WIDTH
    yield Strokes(second.all_segments, tones.OUTLINE, width + 2.0, layer="second")
    yield Strokes(second.all_segments, tones.SECOND, width, layer="second")


def band_strokes(band: tuple[tuple[float, float], tuple[float, float]]) -> Iterable[Strokes]:
    """The rectangle that chooses points."""
    (x0, y0), (x1, y1) = band
    lines = np.array([[x0, y0, x1, y0], [x1, y0, x1, y1], [x1, y1, x0, y1], [x0, y1, x0, y0]])
    yield Strokes(lines, tones.OUTLINE, tones.ERROR_VECTOR_WIDTH + 2, layer="band")
    yield Strokes(lines, tones.HALO, tones.ERROR_VECTOR_WIDTH, tones.CURSOR_LINE_DASH, "band")


def projection_strokes(projection: ScoredProjection) -> Iterable[Strokes]:
    """The projected field by verdict."""
    for status in _PROJECTED:
        yield Strokes(
            projection.by_status.get(status, NO_SEGMENTS),
            tones.STATUS_COLOURS[status],
            # Nothing annotated lies next to these, and dashes weigh less than lines.
            tones.PROJECTION_WIDTH * (1.5 if status == "not_annotated" else 1.0),
            tones.STATUS_DASHES[status],
            "projection",
        )
    unjudged = projection.by_status.get(UNSCORED, NO_SEGMENTS)
    yield Strokes(unjudged, tones.UNKNOWN_CLASS, tones.PROJECTION_WIDTH, (), "projection")


def strokes_by_status(drawn: Drawn, verdict: ScoredFrame) -> Iterable[Strokes]:
    """Annotated polylines in the colours of the criterion."""
    for status in _ANNOTATED:
        parts = [drawn.segments(n) for n in drawn.names() if verdict.status.get(n) == status]
        yield Strokes(
            joined(parts),
            tones.STATUS_COLOURS[status],
            tones.ANNOTATION_WIDTH,
            tones.STATUS_DASHES[status],
            "annotation",
        )
    # A homography's elements off its plane, when they are left out, have no verdict.
    rest = [drawn.segments(n) for n in drawn.names() if n not in verdict.status]
    yield Strokes(joined(rest), tones.UNKNOWN_CLASS, tones.ANNOTATION_WIDTH, (), "annotation")


def strokes_by_class(drawn: Drawn, field: Field) -> Iterable[Strokes]:
    """Annotated polylines in the colours of their classes."""
    width, rest = tones.ANNOTATION_WIDTH, []
    by_class = [_class_strokes(NO_LINE, element.colour) for element in field.elements]
    for name in drawn.names():
        i = field.index.get(name)
        if i is None:
            rest.append(drawn.segments(name))
        else:
            by_class[i] = _class_strokes(drawn.line(name), by_class[i].colour)
    yield from by_class
    yield Strokes(joined(rest), tones.UNKNOWN_CLASS, width, tones.UNKNOWN_CLASS_DASH, "annotation")


@lru_cache(maxsize=256)  # the very same while other elements change
def _class_strokes(line: DrawnLine, colour: str) -> Strokes:
    return Strokes(line.segments, colour, tones.ANNOTATION_WIDTH, (), "annotation")


def draft_strokes(draft: Draft, drawn: Sequence[Drawn], field: Field) -> Iterable[Strokes]:
    """The polyline under way from where it continues one of those ``drawn``, and its line to the
    cursor."""
    colour = draft_colour(draft, field)
    ends = (group.points(draft.class_name)[-1:] for group in drawn)
    points = np.concatenate((*ends, draft_points(draft)))
    lines = np.concatenate((points[:-1], points[1:]), axis=1)
    yield Strokes(lines, tones.OUTLINE, tones.ANNOTATION_WIDTH + 2, layer="draft")
    yield Strokes(lines, colour, tones.ANNOTATION_WIDTH, layer="draft")
    band = NO_SEGMENTS
    if draft.cursor is not None and len(points):
        band = np.array([[*points[-1], *draft.cursor]])
    yield Strokes(band, colour, tones.ERROR_VECTOR_WIDTH, tones.CURSOR_LINE_DASH, "draft")


def draft_points(draft: Draft) -> FloatArray:
    """The points clicked so far, (N, 2)."""
    return np.array(draft.points, dtype=np.float64).reshape(-1, 2)


def draft_colour(draft: Draft, field: Field) -> str:
    """The colour of the class that is being drawn."""
    element = field.element(draft.class_name)
    return element.colour if element is not None else tones.UNKNOWN_CLASS


def paint_strokes(
    paint: ProjectedField | None, score: FrameScore | None, size: Size, picture_size: Size
) -> Iterable[Strokes]:
    """The borders of the paint, in the tone of what the criterion says of their element; always as
    many strokes, some of them empty.

    Args:
        paint: where the camera shows them, px of the evaluation's ``size``; None: not to be drawn.
        score: of the frame against that camera.
        picture_size: (width, height) of the picture painted on.
    """
    status = {e.name: e.status for e in score.elements} if score is not None else {}
    found: dict[str, list[FloatArray]] = {}
    if paint is not None:
        for border, segments in segments_by_element(paint, size, picture_size).items():
            known = status.get(class_of_border(border), "")
            found.setdefault(known if known in _PROJECTED else "", []).append(segments)
    for key in (*_PROJECTED, ""):
        colour = tones.STATUS_COLOURS[key] if key else tones.UNKNOWN_CLASS
        yield Strokes(joined(found.get(key, [])), colour, tones.LINE_MARKING_WIDTH, layer="paint")


def build_wireframes(
    shown: Iterable[tuple[ProjectedField, str]], size: Size, picture_size: Size
) -> Overlay:
    """Draw what several sources show of the field.

    Args:
        shown: projected field, px of the evaluation's ``size``, and colour of each source, the last
            one on top.
        picture_size: (width, height) of the picture painted on.

    Returns:
        Two strokes a source: a dark rim, for no colour is seen on every ground, and the line.
    """
    strokes: list[Strokes] = []
    for projected, colour in shown:
        segments = joined(list(segments_by_element(projected, size, picture_size).values()))
        rim = tones.WIREFRAME_WIDTH + 1.0
        strokes.append(Strokes(segments, tones.OUTLINE, rim, layer="wireframe"))
        strokes.append(Strokes(segments, colour, tones.WIREFRAME_WIDTH, layer="wireframe"))
    return Overlay(tuple(strokes), (), ())


def ellipse_strokes(ellipses: Sequence[ShownEllipse]) -> Iterable[Strokes]:
    """Return how surely a view shows the landmarks: an ellipse around each that can be seen."""
    for one in ellipses:
        if one.ellipse.semi_axes_px[0] >= _SMALLEST_ELLIPSE_PX:
            outline = one.ellipse.outline()
            segments = np.hstack((outline[:-1], outline[1:]))
            yield Strokes(segments, _ELLIPSE_OUTLINE, _ELLIPSE_OUTLINE_WIDTH)
            yield Strokes(segments, one.colour, _ELLIPSE_WIDTH, _ELLIPSE_DASH)


_OFFSET_PX = 7.0  # at 960 px width


def evidence_strips(seen: Iterable[LineEvidence]) -> tuple[Strokes, ...]:
    """The strips of some elements of one picture, the same groups whatever was seen."""
    strips = [_strip(one) for one in seen]
    found: list[Strokes] = []
    for states, colour, dash in (
        ((LinePresence.UNDER,), tones.PASSES, ()),
        ((LinePresence.LEFT, LinePresence.RIGHT), tones.NOT_ANNOTATED, tones.EVIDENCE_OFFSET_DASH),
        ((LinePresence.NONE,), tones.TOO_FAR, tones.EVIDENCE_NONE_DASH),
    ):
        lines = joined([lines[np.isin(paint, states)] for lines, paint in strips])
        found.append(Strokes(lines, tones.EVIDENCE_OUTLINE, tones.EVIDENCE_WIDTH + 1.5, dash))
        found.append(Strokes(lines, colour, tones.EVIDENCE_WIDTH, dash))
    return tuple(found)


def _strip(seen: LineEvidence) -> tuple[FloatArray, np.ndarray]:
    """(n, 4) picture px of the stretches, aside; (n,) what is seen along each."""
    places, half = seen.places_px, seen.lengths_px[:, None] / 2
    along = np.gradient(places, axis=0)
    same = seen.segments[1:] == seen.segments[:-1]
    steps = np.diff(places, axis=0)
    # Within a segment of a straight element the direction is exact.
    along[:-1][same] = steps[same]
    along[1:][same] = steps[same]
    along /= np.maximum(np.hypot(*along.T), 1e-9)[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0]])
    side = np.where(seen.paint == LinePresence.LEFT, -1.0, 1.0)[:, None] * _OFFSET_PX / seen.scale
    middle = places + side * across
    return np.concatenate([middle - half * along, middle + half * along], axis=1), seen.paint


Place = tuple[float, float]


def build_camera_handles(
    segments: FloatArray, pegs: FloatArray, under: tuple[Place, str] | None, *, pressed: bool
) -> Overlay:
    """Draw a camera that can be taken hold of.

    Args:
        segments: (N, 4) px of its wireframe; none where only the pegs are to be seen.
        pegs: (n, 2) px.
        under: where the place under the cursor is, px, and what it is called.
        pressed: whether it is held.
    """
    strokes = (
        Strokes(segments, tones.OUTLINE, tones.CURSOR_WIDTH + 1.2, layer="wireframe"),
        Strokes(segments, tones.CURSOR, tones.CURSOR_WIDTH, layer="wireframe"),
    )
    centre = NO_POINTS if under is None else np.array([under[0]])
    size = tones.CONTROL_POINT_SIZE + (2.0 if pressed else 6.0)
    marks = (
        PointMarks(pegs, "ring", tones.OUTLINE, tones.CONTROL_POINT_SIZE + 2.5),
        PointMarks(pegs, "ring", tones.CONTROL_POINT, tones.CONTROL_POINT_SIZE),
        PointMarks(pegs, "dot", tones.CURSOR, tones.CONTROL_POINT_SIZE / 2),
        PointMarks(centre, "ring", tones.OUTLINE, size + 3.0),
        PointMarks(centre, "ring", tones.CONTROL_POINT, size),
    )
    labels = () if under is None or pressed else (Labels(centre, (under[1],), tones.LABEL),)
    return Overlay(strokes, marks, labels)
