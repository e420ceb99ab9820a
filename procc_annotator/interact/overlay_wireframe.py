"""The field as further camera sources show it: thin lines, to be drawn beside what is judged."""

from __future__ import annotations

from collections.abc import Iterable

from procc_annotator.interact import palette as tones
from procc_annotator.interact.overlay_shapes import Overlay, Size, Strokes
from procc_annotator.interact.verdicts import joined, segments_by_element
from procc_annotator.metric.project import ProjectedField


def build_wireframes(
    shown: Iterable[tuple[ProjectedField, str]], size: Size, picture_size: Size
) -> Overlay:
    """Draw what several sources show of the field.

    Args:
        shown: projected field and colour of each source, the last one on top.
        size: (width, height) of the evaluation; the projections' px belong to it.
        picture_size: (width, height) of the picture painted on.

    Returns:
        Two strokes a source: a dark rim, for no colour is seen on every ground, and the line.
    """
    strokes: list[Strokes] = []
    for projected, colour in shown:
        segments = joined(list(segments_by_element(projected, size, picture_size).values()))
        rim = tones.WIREFRAME_WIDTH + 1.0
        strokes.append(Strokes(segments, tones.RIM, rim, layer="wireframe"))
        strokes.append(Strokes(segments, colour, tones.WIREFRAME_WIDTH, layer="wireframe"))
    return Overlay(tuple(strokes), (), ())
