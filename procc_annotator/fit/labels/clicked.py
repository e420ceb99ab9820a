"""The clicks of a frame as rules look at them, and from what on something is said.

Distances are solver px: px of a picture that is 960 px wide.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.field.model import Element, Field
from procc_annotator.fit.labels.seen_paint import LineEvidence
from procc_annotator.fit.result import ElementResidual, FitResult, PosedCamera
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame
from procc_annotator.language import TranslatableText, translatable

# An element with a point farther off than this is not where the camera of the others shows it.
SUSPECT_LIMIT_PX = 9.0
# Where the other elements fit well less will do: so many times as far off as the next worst one.
_MIN_SUSPECT_LIMIT_PX = 6.5
_NEXT_ELEMENT_RATIO = 3.0
# Points this near to another class could be that class.
FITS_PX = 8.0
# Elements that are right lie this near when the mistakes are left out.
CORRECT_PX = 5.0
# A straight element may lie this far beside a line, whatever the lens.
STRAIGHT_TOLERANCE_PX = 4.0


def suspect_limit(fit: FitResult, frame: ImageFrame) -> float:
    """From what distance on an element of this fit is a suspect, solver px."""
    worst = sorted(element_error(element, frame) for element in fit.elements)
    if len(worst) < 2:
        return SUSPECT_LIMIT_PX
    return min(max(_NEXT_ELEMENT_RATIO * worst[-2], _MIN_SUSPECT_LIMIT_PX), SUSPECT_LIMIT_PX)


def element_error(element: ElementResidual, frame: ImageFrame) -> float:
    """How far off an element is, solver px: its largest distance, which of a landmark that is not
    known exactly counts less."""
    return element.most_counted_px * frame.scale


def in_image_px(solver_px: float, frame: ImageFrame) -> float:
    """The same distance in px of the picture."""
    return solver_px / frame.scale


@dataclass(frozen=True, eq=False)
class AnnotatedElement:
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
    def title(self) -> TranslatableText:
        """What people call it."""
        return translatable(self.element.title)


def annotated_elements(
    annotation: FrameAnnotation, field: Field, frame: ImageFrame
) -> tuple[AnnotatedElement, ...]:
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
            found.append(AnnotatedElement(element, points[known], tuple(known.tolist())))
    return tuple(found)


@dataclass(frozen=True, eq=False)
class FrameEvidence:
    """A frame whose labels are looked at: what every rule is given.

    Attributes:
        annotation: normalised points; unconfirmed elements take no part.
        field: the elements.
        frame: the picture.
        fit: the camera fitted to the annotation, or why there is none.
        go_on: called before each further fit; raises whatever it likes when nobody wants the rest.
        paint: class -> what the picture shows of paint along it; empty where nobody looked.
    """

    annotation: FrameAnnotation
    field: Field
    frame: ImageFrame
    fit: FitResult
    go_on: Callable[[], None] = lambda: None
    paint: Mapping[str, LineEvidence] = dataclasses.field(default_factory=dict)

    @cached_property
    def clicked(self) -> tuple[AnnotatedElement, ...]:
        """What was clicked of the elements that have a place on the field, in the file's order."""
        return annotated_elements(self.annotation, self.field, self.frame)

    @cached_property
    def explained(self) -> frozenset[str]:
        """The classes that the fitted camera explains."""
        limit = suspect_limit(self.fit, self.frame)
        return frozenset(e.name for e in self.fit.elements if element_error(e, self.frame) <= limit)

    @property
    def is_whole(self) -> bool:
        """Whether a pinhole explains everything: it is above the ground and sees nothing the wrong
        way round."""
        elements = self.fit.elements
        return isinstance(self.fit.camera, PosedCamera) and len(self.explained) == len(elements)


def extreme_points(points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The two of (n, 2) points that are farthest along their main direction."""
    centred = points - points.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=False)
    along = centred @ axes[0]
    return points[int(along.argmin())], points[int(along.argmax())]
