"""A camera that is nearly right, made right on the paint of its picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.on_paint.belief import MIN_WEIGHT, GaussianState, StateUpdate, update_state, default_state
from procc_annotator.fit.on_paint.looking import LineMeasurement, measure_lines, found_shares
from procc_annotator.fit.on_paint.painted import MarkingPoints, marking_points
from procc_annotator.fit.on_paint.result import fit_from_edge_points, estimate_edge_noise
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.models import vector_from_camera
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame
from procc_annotator.image.pixels import PixelArray

SEARCH_RADII_PX = (20.0, 10.0, 5.0, 5.0)
_LOSS_SCALE_SHARE = 0.5  # of the reach: farther off, marks count less and less
_MIN_EDGE_POINTS = 12  # marks, for a camera to go by


@dataclass(frozen=True, eq=False)
class LineAlignment:
    """A camera on the paint of a picture.

    Attributes:
        fit: the camera with its standard deviations, or why there is none.
        coverage: share of the visible model that was found on paint, 0 to 1.
        residual_px: median distance of that paint, px of the picture; None if there was too little.
        shares: class in sight -> share of it that was found.
        marks: how many places of paint it goes by.
    """

    fit: FitResult
    coverage: float
    residual_px: float | None
    shares: Mapping[str, float]
    marks: int


def align_with_lines(
    picture: PixelArray,
    field: Field,
    camera: PinholeCamera | FloatArray,
    *,
    belief: GaussianState | None = None,
    reaches_px: Sequence[float] = SEARCH_RADII_PX,
) -> LineAlignment:
    """Make a camera right on the paint that its picture shows near where it expects some.

    Args:
        picture: (H, W, 4) BGRA.
        field: the elements, taken for the middle of their paint, see `marking_points`.
        camera: nearly right: in px of the picture, or (11,) parameters of `fit.solving.models`.
        belief: what is known of the camera besides; None for what is known of any.
        reaches_px: how far off to look for paint, solver px (960 across the picture), one after
            the other.
    """
    frame = ImageFrame((picture.shape[1], picture.shape[0]))
    vector = (
        vector_from_camera(camera, frame) if isinstance(camera, PinholeCamera) else camera.copy()
    )
    painted = marking_points(field)
    belief = default_state(vector, field) if belief is None else belief
    for reach in reaches_px:
        seen = measure_lines(picture, vector, painted, frame, reach)
        if len(seen.marks) < _MIN_EDGE_POINTS:
            return _no_alignment(frame, painted, seen)
        solved = update_from_measurement(seen, belief, vector, frame, reach)
        vector = solved.vector
    return alignment_result(solved, seen, belief, painted, frame)


def update_from_measurement(
    seen: LineMeasurement, belief: GaussianState, start: FloatArray, frame: ImageFrame, reach_px: float
) -> StateUpdate:
    """The camera for what was found within a reach, from (11,) parameters."""
    scale = _LOSS_SCALE_SHARE * reach_px
    return update_state(
        seen.marks, belief, start, frame.half_diagonal, error_px=1.0, scale_px=scale
    )


def alignment_result(
    solved: StateUpdate, seen: LineMeasurement, belief: GaussianState, painted: MarkingPoints, frame: ImageFrame
) -> LineAlignment:
    """What a refinement hands back."""
    worth = estimate_edge_noise(solved, seen.marks)
    coverage, shares = found_shares(seen, solved.weights, painted)
    fit = fit_from_edge_points(solved, seen.marks, belief, worth, painted, frame)
    counted = solved.weights > MIN_WEIGHT
    residual = (
        float(np.median(np.abs(solved.off[counted]))) / frame.scale if counted.any() else None
    )
    return LineAlignment(fit, coverage, residual, shares, int(counted.sum()))


def _no_alignment(frame: ImageFrame, painted: MarkingPoints, seen: LineMeasurement) -> LineAlignment:
    fit = FitResult(
        "R", frame.size, None, "there is too little paint where the camera expects some"
    )
    coverage, shares = found_shares(seen, np.zeros(len(seen.marks)), painted)
    return LineAlignment(fit, coverage, None, shares, 0)
