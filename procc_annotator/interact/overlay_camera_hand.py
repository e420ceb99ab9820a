"""A camera in a hand: its wireframe, the place under the cursor, and the pegs that hold it."""

from __future__ import annotations

import numpy as np

from procc_annotator.interact import palette as tones
from procc_annotator.interact.overlay_shapes import FloatArray, Labels, Overlay, PointMarks, Strokes
from procc_annotator.interact.verdicts import NO_POINTS

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
