"""What a line without a name likely is where no camera is known: seen by all usual cameras at once.

Each usual camera of the field says where its elements would appear. A camera counts by how well it
explains the elements of the picture that have names; a line is what the cameras that count have
there, running the same way.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.base import FloatArray
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sample import sample_evenly
from procc_annotator.fit.solving.surroundings import CameraPlacementPrior, camera_placement_prior

_SAMPLES_PER_ELEMENT = 10  # along an element
_SPACING_M = 0.25
_VIEW_WIDTHS = (0.42, 0.6, 0.85, 1.2, 1.7)  # of the view at the middle, of half the field's length
_TARGET_X, _TARGET_Y = np.linspace(-0.9, 0.9, 13), (-0.5, 0.0, 0.4)  # looked at, of half its size
_POSITIONS_ALONG = (-0.3, 0.0, 0.3)
_END_TOLERANCE = 0.08  # of the picture around it: a line is drawn up to its edge
_LINE_SD = 0.07  # of the picture's width that usual cameras are off by
_ANGLE_FACTOR = 3.0  # how much farther a line counts that runs across
_DRAWN_SAMPLES = 5  # places along what was drawn

Float32 = NDArray[np.float32]


@dataclass(frozen=True, eq=False)
class _ExpectedViews:
    """Where usual cameras show elements, shares of the picture's width.

    Attributes:
        names: (E,) elements.
        x, y: (P, E, B) places along them, not a number outside the picture.
    """

    names: tuple[str, ...]
    x: Float32
    y: Float32


def likely_classes(
    field: Field,
    drawn: FloatArray,
    size: tuple[int, int],
    known: Mapping[str, FloatArray],
) -> tuple[str, ...]:
    """The elements that a line likely is, likeliest first; those of no camera are left out.

    Args:
        field: its elements, and where its cameras stand.
        drawn: (n, 2) px, n >= 1.
        size: (width, height) of the picture, px.
        known: the elements of the picture that have names, (n, 2) px each; none of them is offered.
    """
    views = _expected_views(field.elements, camera_placement_prior(field), round(size[1] / size[0], 3))
    weight = np.ones(views.x.shape[2], dtype=np.float32)
    for name, line in known.items():
        if name in views.names:
            weight *= _line_likelihood(views, line / size[0], [views.names.index(name)])[0] + 1e-3
    rows = [i for i, name in enumerate(views.names) if name not in known]
    if not rows:
        return ()
    score = _line_likelihood(views, drawn / size[0], rows) @ weight
    order = np.argsort(-score, kind="stable")
    return tuple(views.names[rows[i]] for i in order.tolist() if score[i] > 0)


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
def _expected_views(elements: tuple[Element, ...], around: CameraPlacementPrior, ratio: float) -> _ExpectedViews:
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
        inside = (px > -_END_TOLERANCE).all(axis=1) & (px < np.array([1 + _END_TOLERANCE, ratio + _END_TOLERANCE])).all(
            axis=1
        )
        px[~(shown & inside)] = np.nan
        if np.isfinite(px[:, 0]).any():
            found.append(px.reshape(len(lines), _SAMPLES_PER_ELEMENT, 2).astype(np.float32))
    places = np.array(found, dtype=np.float32).reshape(-1, len(lines), _SAMPLES_PER_ELEMENT, 2)
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
