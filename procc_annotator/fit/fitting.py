"""The one function most callers need: a camera from an annotation."""

from __future__ import annotations

import difflib

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.result import ElementResidual, FitResult, PoseDeviations
from procc_annotator.fit.solving.covariance import covariance_of, error_of_points
from procc_annotator.fit.solving.models import (
    FREE,
    LOG_FOCAL,
    MODELS,
    PARAMETERS,
    X,
    Z,
    camera_from_vector,
    homography_camera,
    homography_from_pinhole,
    homography_in_solver,
    vector_from_camera,
)
from procc_annotator.fit.solving.observations import FloatArray, Frame, Observations, observe
from procc_annotator.fit.solving.plausible import missing, objection
from procc_annotator.fit.solving.residual import homography_of
from procc_annotator.fit.solving.search import (
    MINIMUM_ELEMENTS,
    OUTLIER_PX,
    Found,
    refine,
    refine_homography,
    search,
    search_homography,
)
from procc_annotator.fit.solving.starts import extent_of

# Farther off than this on the median element, a camera explains nothing.
_HOPELESS_PX = 2 * OUTLIER_PX
DEFAULT_SIZE = (960, 540)


def fit_camera(
    annotation: FrameAnnotation,
    field: Field,
    *,
    model: str = "R",
    size: tuple[int, int] = DEFAULT_SIZE,
    start: Camera | None = None,
) -> FitResult:
    """Fit a camera to annotated elements; no picture and no start is needed.

    Robust: an element that no camera explains together with the others is left out and named.
    Where the points leave something open, weak priors decide that hold for cameras around a sports
    field; the standard deviations tell how much was left open.

    Args:
        annotation: normalised points; unconfirmed elements take no part, nor do classes that the
            field does not place.
        field: the elements, metres.
        model: H (homography of the ground), P (pinhole, one focal length), R (P and one radial
            coefficient, not negative) or R+ (R, aspect ratio and principal point).
        size: (width, height) px of the picture that the camera is for.
        start: a camera that is nearly right, px of ``size``, e.g. the fit before the last edit; it
            is given up where the points speak against it. A camera that knows only the ground helps
            only the model H.

    Returns:
        The camera with its residuals and uncertainty, or the reason why there is none: too few
        elements, points that say too little, or no plausible pose.

    Raises:
        UsageError: no such model, or a size without pixels.
    """
    check_model(model)
    if min(size) < 2:
        raise UsageError(f"the picture's size {size[0]}x{size[1]} is too small")
    frame = Frame(size)
    planar = model == "H"
    seen = observe(annotation, field, frame, ground_only=planar)
    problem = missing(seen, needed=MINIMUM_ELEMENTS, planar=planar)
    if seen is None or problem is not None:
        return FitResult(model, size, None, problem)
    found, warm = _fit(seen, field, frame, model, start)
    return _result(found, field, frame, model, warm)


def check_model(model: str) -> None:
    """Raises UsageError unless there is a model of this name."""
    if model in MODELS:
        return
    close = difflib.get_close_matches(model.upper(), MODELS, n=1)
    hint = f"did you mean {close[0]}?" if close else f"choose one of {', '.join(MODELS)}"
    raise UsageError(f"unknown camera model {model!r}; {hint}")


def _fit(
    seen: Observations, field: Field, frame: Frame, model: str, start: Camera | None
) -> tuple[Found, bool]:
    known = _warm(seen, field, frame, model, start)
    if known is not None and not known.is_stale and _is_plausible(known, field):
        return known, True
    if model == "H":
        anew = search_homography(seen, field, frame)
    else:
        anew = search(seen, field, frame, model)
    return anew, False


def _warm(
    seen: Observations, field: Field, frame: Frame, model: str, start: Camera | None
) -> Found | None:
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


def _is_plausible(found: Found, field: Field) -> bool:
    return found.basis is not None or not objection(found.vector, extent_of(field).scale)


def _result(found: Found, field: Field, frame: Frame, model: str, warm: bool) -> FitResult:
    problem = _objection(found, field)
    if problem is not None:
        return FitResult(model, frame.size, None, problem)
    error_px = error_of_points(found)
    covariance = covariance_of(found, error_px)
    camera: PinholeCamera | HomographyCamera
    if found.basis is not None:
        matrix = homography_of(found.vector[None], found.basis)[0]
        camera, deviations = homography_camera(matrix, frame), None
        names = tuple(f"h{row}{column}" for row in range(3) for column in range(3))[:8]
    else:
        camera = camera_from_vector(found.vector, frame)
        deviations = _deviations(found.vector, covariance, frame)
        names = PARAMETERS[: FREE[model]]
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
    )


def _objection(found: Found, field: Field) -> str | None:
    """Why the best camera that was found is none."""
    if found.basis is None:
        problem = objection(found.vector, extent_of(field).scale)
        if problem is not None:
            return problem
    means = found.seen.mean_of_element(found.distances)
    middle = float(np.median(means))
    if not middle <= _HOPELESS_PX:
        return (
            f"no camera explains these elements together: the best one misses half of them by more"
            f" than {middle:.0f} px (are the labels right?)"
        )
    return None


def _residuals(found: Found, frame: Frame) -> tuple[ElementResidual, ...]:
    distances = np.split(found.distances / frame.scale, found.seen.starts[1:])
    return tuple(
        ElementResidual(element.name, tuple(own.tolist()), bool(out))
        for element, own, out in zip(found.seen.elements, distances, found.left_out, strict=True)
    )


def _deviations(vector: FloatArray, covariance: FloatArray, frame: Frame) -> PoseDeviations:
    sd = np.sqrt(np.diag(covariance)).tolist()
    focal = float(np.exp(vector[LOG_FOCAL])) / frame.scale
    return PoseDeviations(sd[0], sd[1], sd[2], (sd[X], sd[X + 1], sd[Z]), focal * sd[LOG_FOCAL])
