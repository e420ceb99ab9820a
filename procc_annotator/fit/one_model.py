"""Fit one camera model to an annotation: from a start or without one, with its residuals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.result import ElementResidual, FitResult, PoseDeviations
from procc_annotator.fit.solving.barrel import is_demanded, perhaps_barrel
from procc_annotator.fit.solving.covariance import (
    covariance_of,
    error_of_points,
    same_from_other_end,
)
from procc_annotator.fit.solving.cut_out import perhaps_cut_out
from procc_annotator.fit.solving.element_offsets import element_offsets
from procc_annotator.fit.solving.final_fit import OUTLIER_PX, FoundCamera
from procc_annotator.fit.solving.models import (
    LOG_FOCAL,
    STRONG,
    X,
    Z,
    camera_from_vector,
    fisheye_from_vector,
    homography_camera,
    homography_from_pinhole,
    homography_in_solver,
    is_fisheye,
    parameters_of,
    strong_vector_from_camera,
    vector_from_camera,
)
from procc_annotator.fit.solving.observations import FloatArray, Observations, PictureFrame
from procc_annotator.fit.solving.plausible import objection
from procc_annotator.fit.solving.residual import homography_of
from procc_annotator.fit.solving.search import (
    refine,
    refine_homography,
    search_homography,
    search_steps,
)
from procc_annotator.fit.solving.solver import Steps
from procc_annotator.fit.solving.strong_lens import fit_strong, refine_strong
from procc_annotator.fit.solving.surroundings import surroundings_of
from procc_annotator.language import said

# Farther off than this on the median element, a camera explains nothing.
_HOPELESS_PX = 2 * OUTLIER_PX


def find_model_steps(
    seen: Observations, field: Field, frame: PictureFrame, model: str, start: Camera | None
) -> Steps[tuple[FoundCamera, bool]]:
    """Fit a model, from a start if there is one that serves; step by step.

    Args:
        seen: the annotated points; for H those on the ground.
        field: the elements, metres.
        frame: the picture.
        model: H, P, R, R+, R2 or F.
        start: a camera that is nearly right, px of the picture.

    Returns:
        The fit, plausible or not, and whether it came from the start.
    """
    if model in STRONG:
        return (yield from _find_strong(seen, field, frame, model, start))
    found, warm = _warm(seen, field, frame, model, start), True
    if isinstance(start, PinholeCamera) and found is not None and not _keeps_barrel(found):
        found = _warm(seen, field, frame, model, replace(start, radial=(0.0,) * 6))
    if found is None or found.is_stale or not _is_plausible(found, field):
        warm = False
        if model == "H":
            found = search_homography(seen, field, frame)
        else:
            found = yield from search_steps(seen, field, frame, model)
    if model in ("R", "R+"):
        found = perhaps_barrel(found, field, frame)
    return perhaps_cut_out(found, field, frame) if model == "R+" else found, warm


def _find_strong(
    seen: Observations, field: Field, frame: PictureFrame, model: str, start: Camera | None
) -> Steps[tuple[FoundCamera, bool]]:
    if isinstance(start, FisheyeCamera if model == "F" else PinholeCamera):
        assert isinstance(start, FisheyeCamera | PinholeCamera)  # one of both
        vector = strong_vector_from_camera(start, frame)
        if np.isfinite(vector).all():
            found = refine_strong(seen, field, frame, vector)
            if not found.is_stale and _is_plausible(found, field):
                return found, True
    near, _ = yield from find_model_steps(seen, field, frame, "R+", None)
    return fit_strong(seen, field, frame, model, near), False


def _warm(
    seen: Observations, field: Field, frame: PictureFrame, model: str, start: Camera | None
) -> FoundCamera | None:
    if isinstance(start, PinholeCamera):
        vector = vector_from_camera(start, frame)
        if not np.isfinite(vector).all():
            return None
        if model != "H":
            return refine(seen, field, frame, model, vector)
        return refine_homography(seen, homography_from_pinhole(vector))
    if isinstance(start, HomographyCamera) and model == "H":
        return refine_homography(seen, homography_in_solver(start, frame))
    return None


def _keeps_barrel(found: FoundCamera) -> bool:
    return found.basis is not None or is_demanded(found)


def _is_plausible(found: FoundCamera, field: Field) -> bool:
    return found.basis is not None or not objection(found.vector, surroundings_of(field))


def result_of(
    found: FoundCamera, field: Field, frame: PictureFrame, model: str, warm: bool
) -> FitResult:
    """What a fit hands back: its camera with residuals and uncertainty, or what speaks against it.

    Args:
        found: the fit.
        field: the elements, metres.
        frame: the picture.
        model: H, P, R or R+.
        warm: whether it came from a start.
    """
    problem = _objection(found, field)
    if problem is not None:
        return FitResult(model, frame.size, None, problem)
    error_px = error_of_points(found)
    of_clicks = covariance_of(found, error_px)
    offsets = element_offsets(found, frame, error_px)
    covariance = of_clicks + offsets.covariance(of_clicks)
    camera: PinholeCamera | HomographyCamera | FisheyeCamera
    if found.basis is not None:
        matrix = homography_of(found.vector[None], found.basis)[0]
        camera, deviations = homography_camera(matrix, frame), None
        names = tuple(f"h{row}{column}" for row in range(3) for column in range(3))[:8]
    else:
        of_vector = fisheye_from_vector if is_fisheye(found.vector) else camera_from_vector
        camera = of_vector(found.vector, frame)
        deviations = _deviations(found.vector, covariance, frame)
        names = parameters_of(model)
    return FitResult(
        model,
        frame.size,
        camera,
        None,
        _residuals(found, frame),
        deviations,
        error_px / frame.scale,
        names,
        covariance,
        warm,
        found.vector,
        found.basis,
        other_end=same_from_other_end(found, field, frame),
        offset_px=offsets.sd_px / frame.scale,
        of_clicks=of_clicks,
    )


def _objection(found: FoundCamera, field: Field) -> str | None:
    """Why the best camera that was found is none."""
    if found.basis is None:
        problem = objection(found.vector, surroundings_of(field))
        if problem is not None:
            return problem
    means = found.seen.mean_of_element(found.distances)
    middle = float(np.median(means))
    if not middle <= _HOPELESS_PX:
        return said(
            "no camera explains these elements together: the best one misses half of them by more"
            " than {px:.0f} px (are the labels right?)",
            px=middle,
        )
    return None


def _residuals(found: FoundCamera, frame: PictureFrame) -> tuple[ElementResidual, ...]:
    seen = found.seen
    shown = np.split(found.shown_distances / frame.scale, seen.starts[1:])
    counted = np.split(found.distances / frame.scale, seen.starts[1:])
    uncertain = np.zeros(len(seen.element_of_point))
    if seen.spreads is not None:
        uncertain = np.abs(seen.spreads).max(axis=(1, 2))
    return tuple(
        ElementResidual(
            element.name,
            tuple(shown[i].tolist()),
            bool(found.left_out[i]),
            tuple(counted[i].tolist()) if uncertain[seen.starts[i]] else None,
        )
        for i, element in enumerate(seen.elements)
    )


def _deviations(vector: FloatArray, covariance: FloatArray, frame: PictureFrame) -> PoseDeviations:
    sd = np.sqrt(np.diag(covariance)).tolist()
    focal = float(np.exp(vector[LOG_FOCAL])) / frame.scale
    return PoseDeviations(sd[0], sd[1], sd[2], (sd[X], sd[X + 1], sd[Z]), focal * sd[LOG_FOCAL])
