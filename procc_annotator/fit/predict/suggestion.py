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
from procc_annotator.fit.predict.ghosts import SHORTEST_PX
from procc_annotator.fit.predict.mistaken import carrying_another_label
from procc_annotator.fit.predict.sight import (
    Stretch,
    spots_in_sight,
    stretches_in_sight,
)
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.covariance import projected_derivatives
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame
from procc_annotator.metric.course import lengths_along, normals_of

_CLICKS_STRAIGHT, _CLICKS_CURVE = 2, 5
_EITHER_WAY = np.eye(2)
_JUDGED_EVERY_PX = 40.0  # at 960 px width
_LEAST_GAIN_PX, _LEAST_GAIN = 0.1, 0.1  # px of the picture, share


@dataclass(frozen=True, slots=True)
class Suggestion:
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
        return self.gain_px >= max(_LEAST_GAIN_PX, _LEAST_GAIN * self.sd_before_px)


def suggest_next(
    annotation: FrameAnnotation,
    field: Field,
    fit: FitResult,
    *,
    without: Collection[str] = (),
) -> tuple[Suggestion, ...]:
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
    frame = PictureFrame(fit.size)
    shortest = SHORTEST_PX / frame.scale
    passed_over = {e.name for e in field.elements if e.optional}
    passed_over -= {landmark.name for landmark in field.landmarks}
    whole = stretches_in_sight(field, fit.camera, fit.size, passed_over)
    seen = [s for s in whole if s.length_px >= shortest]
    if not seen:
        return ()
    taken = {p.class_name for p in (*annotation.polylines, *annotation.unconfirmed) if p.points}
    taken = taken.union(without)
    taken |= carrying_another_label(annotation, fit, [s for s in seen if s.name not in taken])
    lines = [name for name in dict.fromkeys(s.name for s in seen) if name not in taken]
    spots = spots_in_sight(field, fit.camera, fit.size, passed_over | taken)
    clicks = [
        *(_clicks(field, name, seen) for name in lines),
        *(_Clicks(np.array([place, place]), _EITHER_WAY, 1) for place in spots.values()),
    ]
    places = [*(_middle(_longest(name, seen)) for name in lines), *spots.values()]
    sds = _sds_px(fit, frame, _judged(seen, frame), clicks)
    found = [
        Suggestion(name, float(sds[0]), float(sd), place)
        for name, sd, place in zip((*lines, *spots), sds[1:], places, strict=True)
    ]
    return tuple(sorted(found, key=lambda s: s.sd_after_px))


class _Clicks(NamedTuple):
    """Where an annotator would click an element: (n, 3) metres, and (n, 2) the directions in which
    each click ties the camera down; how many points they are."""

    world: FloatArray
    across: FloatArray
    points: int


def _sds_px(
    fit: FitResult,
    frame: PictureFrame,
    judged: FloatArray,
    clicks: Sequence[_Clicks],
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
    derivatives = _derivatives(fit, frame, np.concatenate([judged, *(c.world for c in clicks)]))
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


def _clicks(field: Field, name: str, seen: list[Stretch]) -> _Clicks:
    """Regularly along what is visible of an element that is no spot."""
    stretch = _longest(name, seen)
    element = field.element(name)
    straight = element is not None and element.is_straight
    count = _CLICKS_STRAIGHT if straight else _CLICKS_CURVE
    rows = _rows_every(stretch, count)
    return _Clicks(stretch.points_world[rows], normals_of(stretch.points_px)[rows], len(rows))


def _longest(name: str, seen: list[Stretch]) -> Stretch:
    return max((s for s in seen if s.name == name), key=lambda s: s.length_px)


def _middle(stretch: Stretch) -> tuple[float, float, float]:
    x, y, z = stretch.points_world[len(stretch.points_world) // 2].tolist()
    return x, y, z


def _judged(seen: list[Stretch], frame: PictureFrame) -> FloatArray:
    """(N, 3) metres: places evenly along everything in the picture."""
    spacing = _JUDGED_EVERY_PX / frame.scale
    return np.concatenate(
        [s.points_world[_rows_every(s, max(2, round(s.length_px / spacing)))] for s in seen]
    )


def _rows_every(stretch: Stretch, count: int) -> np.ndarray:
    """Rows of so many points, evenly along a stretch."""
    lengths = lengths_along(stretch.points_px)
    rows = np.searchsorted(lengths, np.linspace(0.0, lengths[-1], count))
    return np.unique(np.minimum(rows, len(lengths) - 1))


def _derivatives(fit: FitResult, frame: PictureFrame, world: FloatArray) -> FloatArray:
    assert fit.of_clicks is not None
    assert fit.vector is not None
    derivatives, shown = projected_derivatives(
        fit.vector, fit.basis, frame.half_diagonal, len(fit.of_clicks), world
    )
    return np.where(shown[:, None, None], derivatives, 0.0)
