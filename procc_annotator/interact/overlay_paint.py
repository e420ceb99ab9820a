"""The painted width of the field's lines, beside the projection of the elements."""

from __future__ import annotations

from collections.abc import Iterable

from procc_annotator.field.paint import painted_class
from procc_annotator.interact import palette as tones
from procc_annotator.interact.overlay_shapes import FloatArray, Size, Strokes
from procc_annotator.interact.verdicts import joined, segments_by_element
from procc_annotator.metric.project import ProjectedField
from procc_annotator.metric.score import FrameScore

_STATUSES = ("not_annotated", "tp", "too_far")


def paint_strokes(
    paint: ProjectedField | None, score: FrameScore | None, size: Size, picture_size: Size
) -> Iterable[Strokes]:
    """The borders of the paint, in the tone of what the criterion says of their element.

    Args:
        paint: where the camera shows them; None: they are not to be drawn.
        score: of the frame against that camera.
        size: (width, height) of the evaluation; the px of ``paint`` belong to it.
        picture_size: (width, height) of the picture painted on.

    Yields:
        Always as many strokes, some of them empty.
    """
    status = {e.name: e.status for e in score.elements} if score is not None else {}
    found: dict[str, list[FloatArray]] = {}
    if paint is not None:
        for border, segments in segments_by_element(paint, size, picture_size).items():
            known = status.get(painted_class(border), "")
            found.setdefault(known if known in _STATUSES else "", []).append(segments)
    for key in (*_STATUSES, ""):
        colour = tones.STATUS_COLOURS[key] if key else tones.UNKNOWN_CLASS
        yield Strokes(joined(found.get(key, [])), colour, tones.PAINT_WIDTH, layer="paint")
