"""How surely a view shows the landmarks: an ellipse around each, in the landmark's colour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.fit.projected_ellipse import Ellipse
from procc_annotator.interact.overlay_shapes import Overlay, Strokes

_WIDTH = 1.4
_RIM_WIDTH = 3.0
_RIM = "#101010"
_DASH = (4.0, 2.5)
_SMALLEST_PX = 1.0  # picture px; below that the place is as good as known


@dataclass(frozen=True, eq=False)
class ShownEllipse:
    """A landmark's ellipse, picture px."""

    name: str
    colour: str
    ellipse: Ellipse


def with_ellipses(overlay: Overlay, ellipses: Sequence[ShownEllipse]) -> Overlay:
    """The overlay with ellipses below what is in hand; itself where there are none to be seen."""
    strokes: list[Strokes] = []
    for one in ellipses:
        if one.ellipse.semi_axes_px[0] >= _SMALLEST_PX:
            outline = one.ellipse.outline()
            segments = np.hstack((outline[:-1], outline[1:]))
            strokes.append(Strokes(segments, _RIM, _RIM_WIDTH))
            strokes.append(Strokes(segments, one.colour, _WIDTH, _DASH))
    return replace(overlay, strokes=(*strokes, *overlay.strokes)) if strokes else overlay
