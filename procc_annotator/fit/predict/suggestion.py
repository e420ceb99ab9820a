"""What next: the element whose annotation would tell most about where the field is in the picture.

Pure algebra of covariances: what an element's clicks would add to the information of the fit, and
how much surer the projection would then be. Nothing is fitted anew.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.predict.ghosts import MIN_LENGTH_PX
from procc_annotator.fit.predict.mistaken import classes_labelled_otherwise
from procc_annotator.fit.predict.sight import (
    VisibleStretch,
    visible_spots,
    visible_stretches,
)
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.covariance import projected_jacobian
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame
from procc_annotator.metric.course import arc_lengths, polyline_normals

_CLICKS_PER_LINE, _CLICKS_PER_CURVE = 2, 5
_BOTH_AXES = np.eye(2)
_EVALUATION_SPACING_PX = 40.0  # at 960 px width
_MIN_GAIN_PX, _MIN_GAIN = 0.1, 0.1  # px of the picture, share


@dataclass(frozen=True, slots=True)
class AnnotationSuggestion:
    """What annotating an element would bring.

    Attributes:
        name: the class.
        sd_before_px: how surely the fit knows where the field's lines appear: root of the mean
            predicted variance over those in the picture, px.
        sd_after_px: the same with this element annotated.
        place_world: the middle of the longest stretch of it that is in sight, metres.
    """

    name: str
    sd_before_px: float
    sd_after_px: float
    place_world: tuple[float, float, float]

    @property
    def gain_px(self) -> float:
        """How much surer the projection becomes, px."""
        return self.sd_before_px - self.sd_after_px

    @property
    def is_worthwhile(self) -> bool:
        """Whether annotating it makes a difference worth a word."""
        return self.gain_px >= max(_MIN_GAIN_PX, _MIN_GAIN * self.sd_before_px)


def suggest_annotations(
    annotation: FrameAnnotation,
    field: Field,
    fit: FitResult,
    *,
    without: Collection[str] = (),
) -> tuple[AnnotationSuggestion, ...]:
    """The elements that wait to be annotated, the most helpful first.

    Candidates are all elements that the fitted camera has in the picture, also those that it does
    not know well enough to offer as ghosts; of optional ones only the dataset's own landmarks.
    Their clicks are taken to lie regularly on what is visible of them, two on a straight element
    and five on a curve, and to be off as the annotated points are, across the element; the one on a
    spot both ways. They weigh as in the fit.

    Args:
        annotation: what is there already; confirmed or not.
        field: the elements, metres.
        fit: to this annotation.
        without: classes that are not to be suggested.

    Returns:
        Nothing without a camera: then there is no covariance to reason with.
    """
    if fit.camera is None or fit.of_clicks is None or fit.error_px is None:
        return ()
    frame = ImageFrame(fit.size)
    shortest = MIN_LENGTH_PX / frame.scale
    passed_over = {e.name for e in field.elements if e.optional}
    passed_over -= {landmark.name for landmark in field.landmarks}
    whole = visible_stretches(field, fit.camera, fit.size, passed_over)
    seen = [s for s in whole if s.length_px >= shortest]
    if not seen:
        return ()
    taken = {p.class_name for p in (*annotation.polylines, *annotation.unconfirmed) if p.points}
    taken = taken.union(without)
    taken |= classes_labelled_otherwise(annotation, fit, [s for s in seen if s.name not in taken])
    lines = [name for name in dict.fromkeys(s.name for s in seen) if name not in taken]
    spots = visible_spots(field, fit.camera, fit.size, passed_over | taken)
    clicks = [
        *(_simulate_clicks(field, name, seen) for name in lines),
        *(_SimulatedClicks(np.array([place, place]), _BOTH_AXES, 1) for place in spots.values()),
    ]
    places = [*(_stretch_midpoint(_longest_stretch(name, seen)) for name in lines), *spots.values()]
    sds = _projection_sds_px(fit, frame, _evaluation_points(seen, frame), clicks)
    found = [
        AnnotationSuggestion(name, float(sds[0]), float(sd), place)
        for name, sd, place in zip((*lines, *spots), sds[1:], places, strict=True)
    ]
    return tuple(sorted(found, key=lambda s: s.sd_after_px))


class _SimulatedClicks(NamedTuple):
    """Where an annotator would click an element: (n, 3) metres, and (n, 2) the directions in which
    each click ties the camera down; how many points they are."""

    world: FloatArray
    across: FloatArray
    points: int


def _projection_sds_px(
    fit: FitResult,
    frame: ImageFrame,
    judged: FloatArray,
    clicks: Sequence[_SimulatedClicks],
) -> FloatArray:
    """(1 + C,) px: how surely the fit knows where places appear, and would with more clicks.

    Args:
        fit: has a camera.
        frame: its picture.
        judged: (N, 3) metres, the places.
        clicks: of C elements, each for itself.
    """
    assert fit.of_clicks is not None
    assert fit.error_px is not None
    derivatives = _projection_derivatives(fit, frame, np.concatenate([judged, *(c.world for c in clicks)]))
    rows = derivatives[: len(judged)].reshape(-1, derivatives.shape[2])
    # The mean over rows r of r C r' is the trace of C times the mean of r' r.
    spread = rows.T @ rows / len(rows)
    information = np.linalg.inv(fit.of_clicks)
    known = [information]
    begin = len(judged)
    for world, across, points in clicks:
        own = np.einsum("nk,nkp->np", across, derivatives[begin : begin + len(world)])
        begin += len(world)
        weight = 1 / (np.sqrt(points) * (fit.error_px * frame.scale) ** 2)
        known.append(information + weight * own.T @ own)
    variances = np.einsum("cpq,qp->c", np.linalg.inv(np.array(known)), spread)
    return np.asarray(np.sqrt(variances) / frame.scale)


def _simulate_clicks(field: Field, name: str, seen: list[VisibleStretch]) -> _SimulatedClicks:
    """Regularly along what is visible of an element that is no spot."""
    stretch = _longest_stretch(name, seen)
    element = field.element(name)
    straight = element is not None and element.is_straight
    count = _CLICKS_PER_LINE if straight else _CLICKS_PER_CURVE
    rows = _rows_every(stretch, count)
    return _SimulatedClicks(stretch.points_world[rows], polyline_normals(stretch.points_px)[rows], len(rows))


def _longest_stretch(name: str, seen: list[VisibleStretch]) -> VisibleStretch:
    return max((s for s in seen if s.name == name), key=lambda s: s.length_px)


def _stretch_midpoint(stretch: VisibleStretch) -> tuple[float, float, float]:
    x, y, z = stretch.points_world[len(stretch.points_world) // 2].tolist()
    return x, y, z


def _evaluation_points(seen: list[VisibleStretch], frame: ImageFrame) -> FloatArray:
    """(N, 3) metres: places evenly along everything in the picture."""
    spacing = _EVALUATION_SPACING_PX / frame.scale
    return np.concatenate(
        [s.points_world[_rows_every(s, max(2, round(s.length_px / spacing)))] for s in seen]
    )


def _rows_every(stretch: VisibleStretch, count: int) -> np.ndarray:
    """Rows of so many points, evenly along a stretch."""
    lengths = arc_lengths(stretch.points_px)
    rows = np.searchsorted(lengths, np.linspace(0.0, lengths[-1], count))
    return np.unique(np.minimum(rows, len(lengths) - 1))


def _projection_derivatives(fit: FitResult, frame: ImageFrame, world: FloatArray) -> FloatArray:
    assert fit.of_clicks is not None
    assert fit.vector is not None
    derivatives, shown = projected_jacobian(
        fit.vector, fit.basis, frame.half_diagonal, len(fit.of_clicks), world
    )
    return np.where(shown[:, None, None], derivatives, 0.0)
