"""The clicks of a frame as the rules that need no camera look at them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.field.model import Element, Field
from procc_annotator.fit.solving.observations import FloatArray, Frame


@dataclass(frozen=True, eq=False)
class Clicked:
    """One annotated element of the field.

    Attributes:
        element: of the field.
        points: (n, 2) solver px, origin at the picture's centre; without points that are nowhere.
        indices: (n,) place of each in the polyline.
    """

    element: Element
    points: FloatArray
    indices: tuple[int, ...]

    @property
    def name(self) -> str:
        """The class."""
        return self.element.name

    @property
    def title(self) -> str:
        """What people call it."""
        return self.element.title


def clicked_elements(
    annotation: FrameAnnotation, field: Field, frame: Frame
) -> tuple[Clicked, ...]:
    """What was clicked of the elements that have a place on the field, in the file's order."""
    found = []
    centre = np.array(frame.centre_px)
    for polyline in annotation.polylines:
        element = field.element(polyline.class_name)
        if element is None or not polyline.points:
            continue
        points = (points_px(polyline, frame.size) - centre) * frame.scale
        # Squares of numbers far beyond any picture do only harm.
        known = np.flatnonzero((np.abs(points) < 1e5).all(axis=1))
        if len(known):
            found.append(Clicked(element, points[known], tuple(known.tolist())))
    return tuple(found)


def far_apart(points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The two of (n, 2) points that are farthest along their main direction."""
    centred = points - points.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=False)
    along = centred @ axes[0]
    return points[int(along.argmin())], points[int(along.argmax())]
