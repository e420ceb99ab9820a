"""Annotations of the sample: what a careful person would have clicked."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from drawing.sport import Hidden, Sport
from drawing.views import PICTURE_SIZE, View
from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.field.geometry import Spot
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

FloatArray = NDArray[np.float64]

NOISE_PX = 0.7
CURVE_POINTS = 9
_SAMPLES_M = 0.02


def annotation_of(sport: Sport, view: View, annotator: int = 1) -> FrameAnnotation:
    """Every visible element that is long enough: two or three points, about nine on curves.

    Single places are clicked where they are in the picture. Annotators differ in their noise.
    """
    random = np.random.default_rng(int(view.name) + 1000 * annotator)
    pieces = _pieces(sport, view)
    polylines = []
    for element in sport.clicked:
        curves = pieces.get(element.name, [])
        if element.is_spot:
            chosen = curves
        else:
            curves = [c for c in curves if _length(c) >= sport.shortest_px]
            chosen = _chosen(element, curves, random)
        if not chosen:
            continue
        clicked = np.concatenate(chosen)
        clicked += random.normal(0, NOISE_PX, clicked.shape)
        points = tuple(point_from_px(round(x, 2), round(y, 2), PICTURE_SIZE) for x, y in clicked)
        polylines.append(Polyline(element.name, points))
    return FrameAnnotation(tuple(polylines))


def _chosen(
    element: Element, curves: list[FloatArray], random: np.random.Generator
) -> list[FloatArray]:
    if not curves:
        return []
    count = CURVE_POINTS
    if element.is_straight:
        count = 3 if _length(curves[0]) > 250 and random.random() < 0.6 else 2
    return [_spread(c, _share(c, curves, count)) for c in curves]


def _pieces(sport: Sport, view: View) -> dict[str, list[FloatArray]]:
    """What a view shows of each element, px; nothing of what stands behind something."""
    camera = view.picture_camera
    if sport.hidden is None:
        setup = EvaluationSetup(sport.field, size=PICTURE_SIZE, protocol="procc")
        pieces = {k: list(v) for k, v in project_field(camera, setup).pieces.items()}
    else:
        pieces = _open_to_view(sport.field, view, sport.hidden)
    largest = np.array(PICTURE_SIZE) - 1
    for element in sport.clicked:
        if isinstance(element.geometry, Spot):
            place = np.array([element.geometry.position])
            px, seen = camera.project(place)
            seen &= ((px >= 0) & (px <= largest)).all(axis=1)
            if sport.hidden is not None:
                seen &= ~sport.hidden(place, camera.position_world)
            pieces[element.name] = [px] if seen.all() else []
    return pieces


def _open_to_view(field: Field, view: View, hidden: Hidden) -> dict[str, list[FloatArray]]:
    camera = view.picture_camera
    samples = sample_evenly(field, _SAMPLES_M)
    px, seen = camera.project(samples.points_world)
    seen &= ((px >= 0) & (px <= np.array(PICTURE_SIZE) - 1)).all(axis=1)
    seen &= ~hidden(samples.points_world, camera.position_world)
    pieces = {}
    for name, begin, end in zip(samples.names, samples.offsets, samples.offsets[1:], strict=False):
        cuts = np.flatnonzero(np.diff(seen[begin:end].astype(int))) + 1
        runs = np.split(np.arange(begin, end), cuts)
        pieces[name] = [px[run] for run in runs if seen[run[0]] and len(run) > 1]
    return pieces


def _length(curve: FloatArray) -> float:
    return float(np.linalg.norm(np.diff(curve, axis=0), axis=1).sum())


def _share(curve: FloatArray, curves: list[FloatArray], count: int) -> int:
    total = sum(_length(c) for c in curves)
    return max(2, round(count * _length(curve) / total))


def _spread(curve: FloatArray, count: int) -> FloatArray:
    """``count`` points regularly spaced along a curve, its ends included."""
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))])
    wanted = np.linspace(0, along[-1], count)
    return np.column_stack([np.interp(wanted, along, curve[:, i]) for i in range(2)])
