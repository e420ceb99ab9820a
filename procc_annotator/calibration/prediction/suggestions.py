"""Which element to annotate next, and which class an unnamed line likely is."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_placement import (
    CameraPlacementPrior,
    camera_placement_prior,
)
from procc_annotator.calibration.optimization.covariance import projected_jacobian
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.prediction.ghosts import MIN_LENGTH_PX, classes_labelled_otherwise
from procc_annotator.calibration.prediction.visible_elements import (
    VisibleStretch,
    visible_spots,
    visible_stretches,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.metrics.polylines import arc_lengths, polyline_normals

_SAMPLES_PER_ELEMENT = 10  # along an element
_SPACING_M = 0.25
_VIEW_WIDTHS = (0.42, 0.6, 0.85, 1.2, 1.7)  # of the view at the middle, of half the field's length
_TARGET_X, _TARGET_Y = np.linspace(-0.9, 0.9, 13), (-0.5, 0.0, 0.4)  # looked at, of half its size
_POSITIONS_ALONG = (-0.3, 0.0, 0.3)
_END_TOLERANCE = 0.08  # of the picture around it: a line is drawn up to its edge
_LINE_SD = 0.07  # of the picture's width that usual cameras are off by
_ANGLE_FACTOR = 3.0  # how much farther a line counts that runs across
_DRAWN_SAMPLES = 5  # places along what was drawn
_SHOWN_SHARE = 0.3  # of an element that is in the picture, for it to be in sight
_LEAST_SEEN = 0.6  # of the usual views: of 55 wrong proposals in the sample data 7 are left

Float32 = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class _ExpectedViews:
    """Places (P, E, B) along E elements where usual cameras show them, shares of the picture's
    width; NaN outside the picture."""

    names: tuple[str, ...]
    x: Float32
    y: Float32


def likely_classes(
    field: Field,
    drawn: FloatArray,
    size: tuple[int, int],
    known: Mapping[str, FloatArray],
) -> tuple[str, ...]:
    """The elements that a line (n, 2), px, likely is, likeliest first; those of no camera are left
    out, as are those ``known``: the elements of the picture that have names, (n, 2) px each."""
    views, weight = _weighted_views(field, size, known)
    rows = [i for i, name in enumerate(views.names) if name not in known]
    if not rows:
        return ()
    score = _line_likelihood(views, drawn / size[0], rows) @ weight
    order = np.argsort(-score, kind="stable")
    return tuple(views.names[rows[i]] for i in order.tolist() if score[i] > 0)


def unlikely_in_sight(
    field: Field, size: tuple[int, int], known: Mapping[str, FloatArray]
) -> frozenset[str]:
    """The elements that usual cameras seldom show with the ``known`` ones, (n, 2) px each."""
    views, weight = _weighted_views(field, size, known)
    shown = np.isfinite(views.x).mean(axis=0) > _SHOWN_SHARE
    seen = (shown @ weight).tolist()
    few = _LEAST_SEEN * float(weight.sum())
    return frozenset(name for name, share in zip(views.names, seen, strict=True) if share < few)


def often_in_sight(field: Field, size: tuple[int, int]) -> tuple[str, ...]:
    """The lines of a field, those first that most of the usual cameras show."""
    views, _ = _weighted_views(field, size, {})
    seen = (np.isfinite(views.x).mean(axis=0) > _SHOWN_SHARE).sum(axis=1)
    return tuple(views.names[row] for row in np.argsort(-seen, kind="stable"))


def _weighted_views(
    field: Field, size: tuple[int, int], known: Mapping[str, FloatArray]
) -> tuple[_ExpectedViews, Float32]:
    """The usual views, and (B,) how well each fits the elements that are known."""
    views = _expected_views(
        field.elements, camera_placement_prior(field), round(size[1] / size[0], 3)
    )
    weight = np.ones(views.x.shape[2], dtype=np.float32)
    for name, line in known.items():
        if name in views.names:
            weight *= _line_likelihood(views, line / size[0], [views.names.index(name)])[0] + 1e-3
    return views, weight


def _line_likelihood(views: _ExpectedViews, line: FloatArray, rows: list[int]) -> Float32:
    """(R, B) of a line, in shares of the width, being each of some elements."""
    at = np.linspace(0, len(line) - 1, _DRAWN_SAMPLES)
    whole = np.arange(len(line))
    px = np.stack([np.interp(at, whole, line[:, axis]) for axis in (0, 1)], axis=1)
    px = px.astype(np.float32)
    x, y = views.x[:, rows], views.y[:, rows]
    along_x, along_y = np.diff(x, axis=0), np.diff(y, axis=0)
    squares = np.maximum(along_x * along_x + along_y * along_y, 1e-12)
    away = []
    for point_x, point_y in px:
        offset_x, offset_y = point_x - x[:-1], point_y - y[:-1]
        share = np.clip((offset_x * along_x + offset_y * along_y) / squares, 0, 1)
        gap_x, gap_y = offset_x - share * along_x, offset_y - share * along_y
        nearest = np.fmin.reduce(gap_x * gap_x + gap_y * gap_y, axis=0)
        away.append(np.sqrt(np.where(np.isnan(nearest), np.inf, nearest)))
    course_x, course_y = np.nansum(along_x, axis=0), np.nansum(along_y, axis=0)
    runs = px[-1] - px[0]
    lengths = np.maximum(np.hypot(course_x, course_y) * np.hypot(*runs), 1e-12)
    sine = (course_x * runs[1] - course_y * runs[0]) / lengths
    off = np.mean(away, axis=0) * (1 + _ANGLE_FACTOR * sine**2) + _LINE_SD / 2 * np.abs(sine)
    return np.asarray(np.exp(-0.5 * (off / _LINE_SD) ** 2), dtype=np.float32)


@lru_cache(maxsize=4)
def _expected_views(
    elements: tuple[Element, ...], around: CameraPlacementPrior, ratio: float
) -> _ExpectedViews:
    lines = [e for e in elements if not e.is_spot and not e.optional]
    samples = sample_evenly(Field("", "", (), tuple(lines)), _SPACING_M)
    rows = []
    for i in range(len(lines)):
        own = samples.of(i)
        rows.append(own[np.linspace(0, len(own) - 1, _SAMPLES_PER_ELEMENT).round().astype(int)])
    world = np.concatenate(rows) if rows else np.empty((0, 3))
    found = []
    for camera in _usual_cameras(around, ratio):
        px, shown = camera.project(world)
        inside = (px > -_END_TOLERANCE).all(axis=1) & (
            px < np.array([1 + _END_TOLERANCE, ratio + _END_TOLERANCE])
        ).all(axis=1)
        px[~(shown & inside)] = np.nan
        if np.isfinite(px[:, 0]).any():
            found.append(px.reshape(len(lines), _SAMPLES_PER_ELEMENT, 2).astype(np.float32))
    places = np.array(found, np.float32).reshape(len(found), len(lines), _SAMPLES_PER_ELEMENT, 2)
    x, y = np.ascontiguousarray(places.T)
    return _ExpectedViews(tuple(e.name for e in lines), x, y)


def _usual_cameras(around: CameraPlacementPrior, ratio: float) -> list[PinholeCamera]:
    """All usual ones; px in shares of the picture's width."""
    # Of two sides from which a field looks the same one is enough.
    sides = ("near",) if around.has_main_side else ("near", "right")
    found = []
    for side, along, height, x, y, width in itertools.product(
        sides, _POSITIONS_ALONG, around.height[1:], _TARGET_X, _TARGET_Y, _VIEW_WIDTHS
    ):
        half = around.half_length, around.half_width
        reach = half[1 if side == "near" else 0] + around.distance[1]
        place = (along * half[0], reach) if side == "near" else (reach, along * half[1])
        dx, dy = x * half[0] - place[0], y * half[1] - place[1]
        focal = math.hypot(*place, height) / (width * half[0])
        found.append(
            PinholeCamera(
                math.atan2(dx, -dy),
                math.atan2(math.hypot(dx, dy), height),
                0.0,
                (*place, -height),
                (focal, focal),
                (0.5, ratio / 2),
            )
        )
    return found


_CLICKS_PER_LINE, _CLICKS_PER_CURVE = 2, 5
_BOTH_AXES = np.eye(2)
_EVALUATION_SPACING_PX = 40.0  # at 960 px width
_MIN_GAIN_PX, _MIN_GAIN = 0.1, 0.1  # px of the picture, share


@dataclass(frozen=True, slots=True)
class AnnotationSuggestion:
    """Gain of annotating an element.

    Attributes:
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
        """Return how much surer the projection becomes, px."""
        return self.sd_before_px - self.sd_after_px

    @property
    def is_worthwhile(self) -> bool:
        """Return whether annotating it makes a difference worth a word."""
        return self.gain_px >= max(_MIN_GAIN_PX, _MIN_GAIN * self.sd_before_px)


def suggest_annotations(
    annotation: FrameAnnotation,
    field: Field,
    fit: FitResult,
    *,
    without: Collection[str] = (),
) -> tuple[AnnotationSuggestion, ...]:
    """The elements that wait to be annotated, the most helpful first; none without a camera.

    Candidates are all elements that the fitted camera has in the picture, also those that it does
    not know well enough to offer as ghosts; of optional ones only the dataset's own landmarks.
    Their clicks are taken to lie regularly on what is visible of them, two on a straight element
    and five on a curve, and to be off as the annotated points are, across the element; the one on a
    spot both ways. They weigh as in the fit. Classes ``without`` are not suggested.
    """
    if fit.camera is None or fit.information is None or fit.error_px is None:
        return ()
    frame = fit.frame
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
    """Places where an annotator would click an element: (n, 3) metres, and (n, 2) the directions in
    which each click ties the camera down; how many points they are."""

    world: FloatArray
    across: FloatArray
    points: int


def _projection_sds_px(
    fit: FitResult,
    frame: ImageFrame,
    judged: FloatArray,
    clicks: Sequence[_SimulatedClicks],
) -> FloatArray:
    """(1 + C,) px: how surely the fit knows where places (N, 3), metres, appear, and would with
    more clicks, of C elements, each for itself."""
    assert fit.information is not None
    assert fit.error_px is not None
    derivatives = _projection_derivatives(
        fit, frame, np.concatenate([judged, *(c.world for c in clicks)])
    )
    rows = derivatives[: len(judged)].reshape(-1, derivatives.shape[2])
    # The mean over rows r of r C r' is the trace of C times the mean of r' r.
    spread = rows.T @ rows / len(rows)
    known = [fit.information]
    begin = len(judged)
    for world, across, points in clicks:
        own = np.einsum("nk,nkp->np", across, derivatives[begin : begin + len(world)])
        begin += len(world)
        weight = 1 / (np.sqrt(points) * (fit.error_px * frame.scale) ** 2)
        known.append(fit.information + weight * own.T @ own)
    variances = np.einsum("cpq,qp->c", np.linalg.inv(np.array(known)), spread)
    return np.asarray(np.sqrt(variances) / frame.scale)


def _simulate_clicks(field: Field, name: str, seen: list[VisibleStretch]) -> _SimulatedClicks:
    """Regularly along what is visible of an element that is no spot."""
    stretch = _longest_stretch(name, seen)
    element = field.element(name)
    straight = element is not None and element.is_straight
    count = _CLICKS_PER_LINE if straight else _CLICKS_PER_CURVE
    rows = _rows_every(stretch, count)
    return _SimulatedClicks(
        stretch.points_world[rows], polyline_normals(stretch.points_px)[rows], len(rows)
    )


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
    lengths = arc_lengths(stretch.points_px)
    rows = np.searchsorted(lengths, np.linspace(0.0, lengths[-1], count))
    return np.unique(np.minimum(rows, len(lengths) - 1))


def _projection_derivatives(fit: FitResult, frame: ImageFrame, world: FloatArray) -> FloatArray:
    assert fit.information is not None
    assert fit.vector is not None
    derivatives, shown = projected_jacobian(
        fit.vector, fit.basis, frame.half_diagonal, len(fit.information), world
    )
    return np.where(shown[:, None, None], derivatives, 0.0)
