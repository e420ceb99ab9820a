"""A camera that somebody pegged, made right on the paint of its picture where that agrees."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.on_paint.belief import GaussianState, default_state
from procc_annotator.fit.on_paint.marks import PARAMETERS_FREE
from procc_annotator.fit.on_paint.refining import LineAlignment, align_with_lines
from procc_annotator.fit.pegs import ControlPoint, control_point_errors, fit_control_points, rotated_camera
from procc_annotator.fit.solving.jacobian import Lens, project
from procc_annotator.fit.solving.models import POSITION_SLICE, vector_from_camera
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame
from procc_annotator.image.pixels import PixelArray
from procc_annotator.language import translatable

# Somebody who drags lines to where they belong saw them about right; a camera stands where it was
# found to stand, to a metre or two.
_POINT_PRIOR_M = 2.0
_MAX_DEVIATION_SD, _MIN_TOLERANCE_SHARE = 3.0, 2.0 / 960  # that paint may move a peg: by its own deviation, of width
_MIN_COVERAGE, _CLEAR_COVERAGE = 0.5, 0.8
_TRIAL_ZOOMS = (-0.05, 0.05, -0.1, 0.1, -0.15, 0.15)  # of the logarithm of the focal length


def align_with_control_points(
    picture: PixelArray,
    field: Field,
    camera: PinholeCamera,
    pegs: Sequence[ControlPoint],
    *,
    go_on: Callable[[], None] = lambda: None,
) -> tuple[LineAlignment | None, str]:
    """The same camera on the paint near its lines, the pegs within what a hand is good for.

    One peg tells nothing of the zoom: others near it are tried, and the one counts whose lines are
    on paint.

    Args:
        picture: (H, W, 4) BGRA.
        field: the elements.
        camera: that shows the pegs where they are, px of the picture.
        pegs: at least one.
        go_on: called between the tries; raises whatever it likes when nobody wants the rest.

    Returns:
        What was found, or None and why the paint does not say: too little of it is seen, or it
        would take a peg from its place.
    """
    best, why = _align_at_zoom(picture, field, camera, pegs)
    if len(pegs) > 1 or (best is not None and best.coverage >= _CLEAR_COVERAGE):
        return best, why
    for zoom in _TRIAL_ZOOMS:
        go_on()
        zoomed = fit_control_points(rotated_camera(camera, np.array([0.0, 0.0, zoom, 0.0])), pegs)
        found, _ = _align_at_zoom(picture, field, zoomed, pegs)
        if found is not None and (best is None or found.coverage > best.coverage):
            best = found
    return best, "" if best is not None else why


def _align_at_zoom(
    picture: PixelArray, field: Field, camera: PinholeCamera, pegs: Sequence[ControlPoint]
) -> tuple[LineAlignment | None, str]:
    frame = ImageFrame((picture.shape[1], picture.shape[0]))
    vector = vector_from_camera(camera, frame)
    information = default_state(vector, field).information + _control_point_information(pegs, vector, frame)
    information[POSITION_SLICE, POSITION_SLICE] += np.eye(3) / _POINT_PRIOR_M**2
    found = align_with_lines(picture, field, camera, belief=GaussianState(vector, information))
    refined = found.fit.camera
    if not isinstance(refined, PinholeCamera):
        return None, found.fit.failure or translatable("there is too little paint")
    if found.coverage < _MIN_COVERAGE:
        return None, translatable(
            "only {share:.0%} of the lines in sight are on paint", share=found.coverage
        )
    for off, peg in zip(control_point_errors(refined, pegs).tolist(), pegs, strict=True):
        if not off <= max(_MAX_DEVIATION_SD * peg.sd_px, _MIN_TOLERANCE_SHARE * frame.size[0]):
            return None, translatable("the paint nearby would take a peg from its place")
    return found, ""


def _control_point_information(pegs: Sequence[ControlPoint], vector: FloatArray, frame: ImageFrame) -> FloatArray:
    """(8, 8) information of pegs that a camera (11,) shows where they are."""
    world = np.array([peg.world for peg in pegs]).T[None]
    along = np.array([peg.along or (0.0, 0.0, 0.0) for peg in pegs]).T[None]
    lens = Lens.of(vector[None], frame.half_diagonal)
    _, moved, by = project(lens, world, along, PARAMETERS_FREE)
    told = np.zeros((PARAMETERS_FREE, PARAMETERS_FREE))
    for row, peg in enumerate(pegs):
        own = by[0, :, :, row] / (peg.sd_px * frame.scale)
        if peg.along is not None:
            x, y = moved[0, :, row]
            own = own @ (np.array([[-y], [x]]) / max(float(np.hypot(x, y)), 1e-12))
        told += own @ own.T
    return told
