"""Beside every segment of the annotation a thin strip: whether the picture shows paint there.

Under it: a solid strip. Beside it: a dashed one, on the side where the paint runs. None: dots. The
strip keeps off the line, so that the paint can be seen; by its dashes it is told without colours.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from procc_annotator.fit.labels.seen_paint import LineEvidence, LinePresence
from procc_annotator.interact import palette as tones
from procc_annotator.interact.overlay_shapes import FloatArray, Strokes
from procc_annotator.interact.verdicts import joined

_OFFSET_PX = 7.0  # at 960 px width


def evidence_strips(seen: Iterable[LineEvidence]) -> tuple[Strokes, ...]:
    """The strips of some elements, the same groups whatever was seen.

    Args:
        seen: along elements of one picture.
    """
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
