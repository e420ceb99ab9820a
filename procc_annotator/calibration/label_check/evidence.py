"""Annotated elements, line evidence along them, and straightness under plausible lenses."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.arrays import FloatArray, IntArray, true_runs
from procc_annotator.calibration.optimization.camera_parameters import (
    FREE_PARAMETERS,
    KAPPA,
    MIN_KAPPA,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.optimization.projection import Lens
from procc_annotator.calibration.result import ElementResidual, FitResult, PosedCamera
from procc_annotator.field.model import Element, Field
from procc_annotator.translation import TranslatableText, translatable

# The middle of paint this near is under the clicked line, px at 960 px width.
ON_LINE_PX = 2.0
_NEIGHBOUR_TOLERANCE_PX = 1.0  # paint runs smoothly: places near each other show it equally far off
_NEIGHBOUR_STEPS = np.arange(-2, 3)  # a place and its neighbours
_MIN_AGREEING, _MIN_ON_LINE = 3, 4  # of these
_NEIGHBOUR_LINE_PX, _MAX_SLOPE_PX = 0.8, 2.0


class LinePresence(IntEnum):
    """Observation at a place: paint under it, paint to its left or right, or none."""

    NONE = 0
    UNDER = 1
    LEFT = 2
    RIGHT = 3


@dataclass(frozen=True, eq=False)
class LineEvidence:
    """Evidence along one element.

    Attributes:
        size: (width, height) px of the picture.
        places_px: (n, 2) px, along the element as it was clicked; each stands for as much of it.
        offsets_px: (n,) px from each to the middle of the paint across, to the right when going
            along; NaN where none was found.
        segments: (n,) between which clicks each lies, 0 before the second one.
        lengths_px: (n,) px of the element that each stands for.
        ahead: beyond the first click and beyond the last: (m,) px from it, (m,) offsets as above.
        emptiness: (n,) 0 to 1, how surely there is none where none was found: less where faint
            paint or something that may hide it is seen.
        click_offsets_px: as ``offsets_px``, of every point of the element.
    """

    size: tuple[int, int]
    places_px: FloatArray
    offsets_px: FloatArray
    segments: IntArray
    lengths_px: FloatArray
    ahead: tuple[tuple[FloatArray, FloatArray], tuple[FloatArray, FloatArray]]
    emptiness: FloatArray | float = 1.0
    click_offsets_px: FloatArray = dataclasses.field(default_factory=lambda: np.zeros(0))

    @property
    def scale(self) -> float:
        """Px at 960 px width, per px."""
        return ImageFrame(self.size).scale

    @cached_property
    def steady(self) -> FloatArray:
        """(n,) the offsets that neighbours agree with; NaN elsewhere."""
        return consistent_offsets(self.offsets_px, self.scale)

    @cached_property
    def paint(self) -> NDArray[np.int8]:
        """(n,) what is seen at each place, as `Paint`."""
        off = self.steady * self.scale
        found = np.where(off > 0, LinePresence.RIGHT, LinePresence.LEFT)
        found = np.where(np.abs(off) <= ON_LINE_PX, LinePresence.UNDER, found)
        return np.where(np.isnan(off), LinePresence.NONE, found).astype(np.int8)

    @property
    def missing_share(self) -> float:
        """Share of the element's length under which there is no paint, 0 to 1."""
        return float(self.missing @ self.lengths_px / self.lengths_px.sum())

    @cached_property
    def missing(self) -> FloatArray:
        """(n,) how surely there is no paint under each place, 0 to 1."""
        off = np.where(self.paint == LinePresence.NONE, self.emptiness, 1.0)
        return np.where(self.paint == LinePresence.UNDER, 0.0, off)

    @property
    def longest_gap_px(self) -> float:
        """Length of the longest stretch without paint under it, px."""
        runs = (self.lengths_px[begin:end].sum() for begin, end in true_runs(self.missing > 0))
        return float(max(runs, default=0.0))

    def ends_at(self, end: int, gap_px: float) -> bool:
        """Return whether paint that can be seen along the element cannot be seen beyond an end
        (0 or -1): half of ``gap_px`` beyond it must show none."""
        distances, offsets = self.ahead[end]
        near = distances <= gap_px
        if self.missing_share > 0.5 or not near.any():
            return False
        return bool(np.isfinite(consistent_offsets(offsets, self.scale)[near]).mean() < 0.5)


def consistent_offsets(offsets: FloatArray, scale: float) -> FloatArray:
    """(n,) offsets, px, but NaN where too few of a place's neighbours have about the same one, or
    lie with it on one line: paint runs smoothly."""
    n, reach = len(offsets), int(_NEIGHBOUR_STEPS[-1])
    here = offsets * scale
    padded = np.pad(here, reach, constant_values=np.nan)
    apart = np.stack([padded[reach + k : reach + k + n] for k in _NEIGHBOUR_STEPS.tolist()]) - here
    near = (
        np.abs(apart) <= _NEIGHBOUR_TOLERANCE_PX * np.maximum(np.abs(_NEIGHBOUR_STEPS), 1)[:, None]
    )
    enough = near.sum(axis=0) >= min(_MIN_AGREEING, n)
    rows = np.arange(n) + _NEIGHBOUR_STEPS[:, None]
    there = ((rows >= 0) & (rows < n)).sum(axis=0)
    for row in np.flatnonzero(_NEIGHBOUR_STEPS).tolist():
        slope = apart[row] / _NEIGHBOUR_STEPS[row]
        on_line = (np.abs(apart - slope * _NEIGHBOUR_STEPS[:, None]) <= _NEIGHBOUR_LINE_PX).sum(
            axis=0
        )
        enough |= (np.abs(slope) <= _MAX_SLOPE_PX) & (on_line >= np.minimum(_MIN_ON_LINE, there))
    return np.where(enough, offsets, np.nan)


# An element with a point farther off than this is not where the camera of the others shows it.
SUSPECT_LIMIT_PX = 9.0
# Where the other elements fit well less will do: so many times as far off as the next worst one.
_MIN_SUSPECT_LIMIT_PX = 6.5
_NEXT_ELEMENT_RATIO = 3.0
# Points this near to another class could be that class.
FITS_PX = 8.0
# Elements that are right lie this near when the mistakes are left out.
CORRECT_PX = 5.0
# A straight element may lie this far next to a line, whatever the lens.
STRAIGHT_TOLERANCE_PX = 4.0


def suspect_limit(fit: FitResult, frame: ImageFrame) -> float:
    """From what distance on an element of this fit is a suspect, solver px."""
    worst = sorted(element_error(element, frame) for element in fit.elements)
    if len(worst) < 2:
        return SUSPECT_LIMIT_PX
    return min(max(_NEXT_ELEMENT_RATIO * worst[-2], _MIN_SUSPECT_LIMIT_PX), SUSPECT_LIMIT_PX)


def element_error(element: ElementResidual, frame: ImageFrame) -> float:
    """Return how far off an element is, solver px: its largest distance, which of a landmark that
    is not known exactly counts less."""
    return element.most_counted_px * frame.scale


def in_image_px(solver_px: float, frame: ImageFrame) -> float:
    """The same distance in px of the picture."""
    return solver_px / frame.scale


@dataclass(frozen=True, eq=False)
class AnnotatedElement:
    """One annotated element of the field.

    Attributes:
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
        """Return what people call it."""
        return translatable(self.element.title)


def annotated_elements(
    annotation: FrameAnnotation, field: Field, frame: ImageFrame
) -> tuple[AnnotatedElement, ...]:
    """Return what was clicked of the elements that have a place on the field, in the file's
    order."""
    found = []
    centre = np.array(frame.centre_px)
    for polyline in annotation.polylines:
        element = field.element(polyline.class_name)
        if element is None or not polyline.points:
            continue
        points = (points_px(polyline, frame.size) - centre) * frame.scales
        # Squares of numbers far beyond any picture do only harm.
        known = np.flatnonzero((np.abs(points) < 1e5).all(axis=1))
        if len(known):
            found.append(AnnotatedElement(element, points[known], tuple(known.tolist())))
    return tuple(found)


@dataclass(frozen=True, eq=False)
class FrameEvidence:
    """A frame whose labels are examined: what every rule is given.

    Attributes:
        annotation: normalised points; unconfirmed elements take no part.
        fit: the camera fitted to the annotation, or why there is none.
        go_on: called before each further fit; raises whatever it likes when no one wants the rest.
        paint: class -> what the picture shows of paint along it; empty where no one looked.
    """

    annotation: FrameAnnotation
    field: Field
    frame: ImageFrame
    fit: FitResult
    go_on: Callable[[], None] = lambda: None
    paint: Mapping[str, LineEvidence] = dataclasses.field(default_factory=dict)

    @cached_property
    def clicked(self) -> tuple[AnnotatedElement, ...]:
        """Return what was clicked of the elements that have a place on the field, in the file's
        order."""
        return annotated_elements(self.annotation, self.field, self.frame)

    @cached_property
    def explained(self) -> frozenset[str]:
        """The classes that the fitted camera explains."""
        limit = suspect_limit(self.fit, self.frame)
        return frozenset(e.name for e in self.fit.elements if element_error(e, self.frame) <= limit)

    @property
    def is_whole(self) -> bool:
        """Return whether a pinhole explains everything: it is above the ground and sees nothing the
        wrong way round."""
        elements = self.fit.elements
        return isinstance(self.fit.camera, PosedCamera) and len(self.explained) == len(elements)


def extreme_points(points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The two of (n, 2) points that are farthest along their main direction."""
    centred = points - points.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=False)
    along = centred @ axes[0]
    return points[int(along.argmin())], points[int(along.argmax())]


# Radial coefficients kappa (see `calibration.optimization.camera_parameters`) from the strongest
# barrel that a fit allows, below 0, to a pincushion beyond any that cameras have: it shows the
# picture's corners a third farther out than they would lie without it.
PLAUSIBLE_KAPPAS = np.linspace(MIN_KAPPA, 0.3, 8)


def undistort_points(points: FloatArray, kappa: float, frame: ImageFrame) -> FloatArray:
    """Points (n, 2), solver px from the picture's centre, as a lens of radial coefficient 0 would
    show them: the solution r of r (1 + kappa r^2 / h^2) = distance.

    What a lens of negative kappa does not show, farther out than it reaches, is taken for lying at
    the edge of what it does.
    """
    vector = np.zeros((1, FREE_PARAMETERS["R+"]))
    vector[0, KAPPA] = kappa
    return np.asarray(Lens.of(vector, frame.half_diagonal).undistorted(points.T)[0].T)


def line_residuals(points: FloatArray) -> FloatArray:
    """Signed distances of (n, 2) points from the straight line through all of them."""
    centred = points - points.mean(axis=0)
    _, _, axes = np.linalg.svd(centred, full_matrices=False)
    return np.asarray(centred @ axes[-1])


def min_line_residuals(points: FloatArray, frame: ImageFrame) -> float:
    """Return how far, solver px, the farthest of three or more points (n, 2), solver px from the
    picture's centre, lies next to a straight line, seen through the lens that helps them most."""
    return min(
        float(np.abs(line_residuals(undistort_points(points, kappa, frame))).max())
        for kappa in PLAUSIBLE_KAPPAS.tolist()
    )
