"""Fit one camera model to an annotation: from a start or without one, with its residuals."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from procc_annotator.camera.base import Camera
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.result import ElementResidual, FitResult, PoseStandardDeviations
from procc_annotator.fit.solving.barrel import is_negative_k1_supported, try_negative_k1
from procc_annotator.fit.solving.covariance import (
    parameter_covariance,
    point_error_sd,
    is_opposite_end_possible,
)
from procc_annotator.fit.solving.cut_out import try_cropped
from procc_annotator.fit.solving.element_offsets import estimate_element_offsets
from procc_annotator.fit.solving.final_fit import OUTLIER_PX, CameraSolution
from procc_annotator.fit.solving.models import (
    LOG_FOCAL,
    WIDE_ANGLE_MODELS,
    X,
    Z,
    camera_from_vector,
    fisheye_from_vector,
    homography_camera,
    homography_from_pinhole,
    homography_from_camera,
    is_fisheye,
    parameter_names,
    wide_angle_vector_from_camera,
    vector_from_camera,
)
from procc_annotator.fit.solving.observations import FloatArray, Observations, ImageFrame
from procc_annotator.fit.solving.plausible import implausible_reason
from procc_annotator.fit.solving.residual import homographies_from_corrections
from procc_annotator.fit.solving.search import (
    refine_camera,
    refine_homography,
    search_homography,
    search_camera_steps,
)
from procc_annotator.fit.solving.solver import SolveSteps
from procc_annotator.fit.solving.strong_lens import fit_wide_angle, refine_wide_angle
from procc_annotator.fit.solving.surroundings import camera_placement_prior
from procc_annotator.language import translatable

# Farther off than this on the median element, a camera explains nothing.
_HOPELESS_ERROR_PX = 2 * OUTLIER_PX


def fit_model_steps(
    seen: Observations, field: Field, frame: ImageFrame, model: str, start: Camera | None
) -> SolveSteps[tuple[CameraSolution, bool]]:
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
    if model in WIDE_ANGLE_MODELS:
        return (yield from _fit_wide_angle(seen, field, frame, model, start))
    found, warm = _fit_from_start(seen, field, frame, model, start), True
    if isinstance(start, PinholeCamera) and found is not None and not _still_has_negative_k1(found):
        found = _fit_from_start(seen, field, frame, model, replace(start, radial=(0.0,) * 6))
    if found is None or found.has_stale_start or not _is_plausible(found, field):
        warm = False
        if model == "H":
            found = search_homography(seen, field, frame)
        else:
            found = yield from search_camera_steps(seen, field, frame, model)
    if model in ("R", "R+"):
        found = try_negative_k1(found, field, frame)
    return try_cropped(found, field, frame) if model == "R+" else found, warm


def _fit_wide_angle(
    seen: Observations, field: Field, frame: ImageFrame, model: str, start: Camera | None
) -> SolveSteps[tuple[CameraSolution, bool]]:
    if isinstance(start, FisheyeCamera if model == "F" else PinholeCamera):
        assert isinstance(start, FisheyeCamera | PinholeCamera)  # one of both
        vector = wide_angle_vector_from_camera(start, frame)
        if np.isfinite(vector).all():
            found = refine_wide_angle(seen, field, frame, vector)
            if not found.has_stale_start and _is_plausible(found, field):
                return found, True
    near, _ = yield from fit_model_steps(seen, field, frame, "R+", None)
    return fit_wide_angle(seen, field, frame, model, near), False


def _fit_from_start(
    seen: Observations, field: Field, frame: ImageFrame, model: str, start: Camera | None
) -> CameraSolution | None:
    if isinstance(start, PinholeCamera):
        vector = vector_from_camera(start, frame)
        if not np.isfinite(vector).all():
            return None
        if model != "H":
            return refine_camera(seen, field, frame, model, vector)
        return refine_homography(seen, homography_from_pinhole(vector))
    if isinstance(start, HomographyCamera) and model == "H":
        return refine_homography(seen, homography_from_camera(start, frame))
    return None


def _still_has_negative_k1(found: CameraSolution) -> bool:
    return found.basis is not None or is_negative_k1_supported(found)


def _is_plausible(found: CameraSolution, field: Field) -> bool:
    return found.basis is not None or not implausible_reason(found.vector, camera_placement_prior(field))


def fit_result_from(
    found: CameraSolution, field: Field, frame: ImageFrame, model: str, warm: bool
) -> FitResult:
    """What a fit hands back: its camera with residuals and uncertainty, or what speaks against it.

    Args:
        found: the fit.
        field: the elements, metres.
        frame: the picture.
        model: H, P, R or R+.
        warm: whether it came from a start.
    """
    problem = _failure_reason(found, field)
    if problem is not None:
        return FitResult(model, frame.size, None, problem)
    error_px = point_error_sd(found)
    of_clicks = parameter_covariance(found, error_px)
    offsets = estimate_element_offsets(found, frame, error_px)
    covariance = of_clicks + offsets.covariance(of_clicks)
    camera: PinholeCamera | HomographyCamera | FisheyeCamera
    if found.basis is not None:
        matrix = homographies_from_corrections(found.vector[None], found.basis)[0]
        camera, deviations = homography_camera(matrix, frame), None
        names = tuple(f"h{row}{column}" for row in range(3) for column in range(3))[:8]
    else:
        of_vector = fisheye_from_vector if is_fisheye(found.vector) else camera_from_vector
        camera = of_vector(found.vector, frame)
        deviations = _pose_deviations(found.vector, covariance, frame)
        names = parameter_names(model)
    return FitResult(
        model,
        frame.size,
        camera,
        None,
        _element_residuals(found, frame),
        deviations,
        error_px / frame.scale,
        names,
        covariance,
        warm,
        found.vector,
        found.basis,
        other_end=is_opposite_end_possible(found, field, frame),
        offset_px=offsets.sd_px / frame.scale,
        of_clicks=of_clicks,
    )


def _failure_reason(found: CameraSolution, field: Field) -> str | None:
    """Why the best camera that was found is none."""
    if found.basis is None:
        problem = implausible_reason(found.vector, camera_placement_prior(field))
        if problem is not None:
            return problem
    means = found.seen.mean_per_element(found.distances)
    middle = float(np.median(means))
    if not middle <= _HOPELESS_ERROR_PX:
        return translatable(
            "no camera explains these elements together: the best one misses half of them by more"
            " than {px:.0f} px (are the labels right?)",
            px=middle,
        )
    return None


def _element_residuals(found: CameraSolution, frame: ImageFrame) -> tuple[ElementResidual, ...]:
    seen = found.seen
    shown = np.split(found.image_distances / frame.scale, seen.starts[1:])
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


def _pose_deviations(vector: FloatArray, covariance: FloatArray, frame: ImageFrame) -> PoseStandardDeviations:
    sd = np.sqrt(np.diag(covariance)).tolist()
    focal = float(np.exp(vector[LOG_FOCAL])) / frame.scale
    return PoseStandardDeviations(sd[0], sd[1], sd[2], (sd[X], sd[X + 1], sd[Z]), focal * sd[LOG_FOCAL])
