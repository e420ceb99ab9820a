"""A camera that is nearly right, made right on the paint of its picture."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.on_paint.belief import COUNTS, Belief, Solved, solve_believed, usual
from procc_annotator.fit.on_paint.looking import PaintLook, look, shares_on_paint
from procc_annotator.fit.on_paint.painted import Painted, painted_of
from procc_annotator.fit.on_paint.result import fit_of, worth_of
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.models import vector_from_camera
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame
from procc_annotator.image.pixels import PixelArray

REACHES_PX = (20.0, 10.0, 5.0, 5.0)
_SCALE_SHARE = 0.5  # of the reach: farther off, marks count less and less
_FEWEST = 12  # marks, for a camera to go by


@dataclass(frozen=True, eq=False)
class OnPaint:
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


def refine_on_paint(
    picture: PixelArray,
    field: Field,
    camera: PinholeCamera | FloatArray,
    *,
    belief: Belief | None = None,
    reaches_px: Sequence[float] = REACHES_PX,
) -> OnPaint:
    """Make a camera right on the paint that its picture shows near where it expects some.

    Args:
        picture: (H, W, 4) BGRA.
        field: the elements, taken for the middle of their paint, see `painted_of`.
        camera: nearly right: in px of the picture, or (11,) parameters of `fit.solving.models`.
        belief: what is known of the camera besides; None for what is known of any.
        reaches_px: how far off to look for paint, solver px (960 across the picture), one after
            the other.
    """
    frame = PictureFrame((picture.shape[1], picture.shape[0]))
    vector = (
        vector_from_camera(camera, frame) if isinstance(camera, PinholeCamera) else camera.copy()
    )
    painted = painted_of(field)
    belief = usual(vector, field) if belief is None else belief
    for reach in reaches_px:
        seen = look(picture, vector, painted, frame, reach)
        if len(seen.marks) < _FEWEST:
            return _nothing(frame, painted, seen)
        solved = on_marks(seen, belief, vector, frame, reach)
        vector = solved.vector
    return refined_result(solved, seen, belief, painted, frame)


def on_marks(
    seen: PaintLook, belief: Belief, start: FloatArray, frame: PictureFrame, reach_px: float
) -> Solved:
    """The camera for what was found within a reach, from (11,) parameters."""
    scale = _SCALE_SHARE * reach_px
    return solve_believed(
        seen.marks, belief, start, frame.half_diagonal, error_px=1.0, scale_px=scale
    )


def refined_result(
    solved: Solved, seen: PaintLook, belief: Belief, painted: Painted, frame: PictureFrame
) -> OnPaint:
    """What a refinement hands back."""
    worth = worth_of(solved, seen.marks)
    coverage, shares = shares_on_paint(seen, solved.weights, painted)
    fit = fit_of(solved, seen.marks, belief, worth, painted, frame)
    counted = solved.weights > COUNTS
    residual = (
        float(np.median(np.abs(solved.off[counted]))) / frame.scale if counted.any() else None
    )
    return OnPaint(fit, coverage, residual, shares, int(counted.sum()))


def _nothing(frame: PictureFrame, painted: Painted, seen: PaintLook) -> OnPaint:
    fit = FitResult(
        "R", frame.size, None, "there is too little paint where the camera expects some"
    )
    coverage, shares = shares_on_paint(seen, np.zeros(len(seen.marks)), painted)
    return OnPaint(fit, coverage, None, shares, 0)
