"""Fit a camera to an annotation: the entry point."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Sequence
from itertools import repeat

from procc_annotator.annotation import FrameAnnotation, Point, pixel_like
from procc_annotator.calibration.model_selection import fit_model, searched_model, select_model
from procc_annotator.calibration.optimization.camera_parameters import MODELS
from procc_annotator.calibration.optimization.camera_placement import insufficient_reason
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.robust_fit import (
    MIN_ELEMENTS,
    CameraSolution,
    FitScene,
    search_cameras,
)
from procc_annotator.calibration.result import FitResult, fit_result_from
from procc_annotator.camera.base import Camera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.translation import translatable

DEFAULT_SIZE = (960, 540)
AUTO = "auto"
FitRequest = tuple[FrameAnnotation, Field, tuple[int, int]]  # the elements; width and height, px
MODEL_CHOICES = (*MODELS, AUTO)


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
    field; the standard deviations say how much was left open.

    Args:
        annotation: normalised points; unconfirmed elements take no part, nor do classes that the
            field does not place.
        field: the elements, metres.
        model: H (homography of the ground), P (pinhole, one focal length), R (P and one radial
            coefficient, negative only where the points demand it), R+ (R, aspect ratio and
            principal point), R2 (R+ and a second radial coefficient), F (OpenCV's fisheye), or auto
            (the simplest of P, R, R+ that the points support, R2 or F where none of these does, see
            `choose`).
        size: (width, height) px of the picture that the camera is for.
        start: a camera that is nearly right, px of ``size``, e.g. the fit before the last edit; it
            is given up where the points speak against it. A camera that knows only the ground helps
            only the model H.

    Returns:
        The camera with its residuals and uncertainty, or the reason why there is none: too few
        elements, points that say too little, coordinates in pixels, or no plausible pose.

    Raises:
        UsageError: no such model, or a size without pixels.
    """
    scene = _scene((annotation, field, size), model)
    return scene if isinstance(scene, FitResult) else _fit(scene, model, start)


def fit_cameras(given: Sequence[FitRequest], *, model: str = "R") -> list[FitResult]:
    """Fit a camera to each of several frames, without starts: the same as `fit_camera`, in less
    time, since the searches of all frames are solved together.

    Args:
        given: of each frame the annotation, the elements and the size of the picture.
        model: see `fit_camera`.

    Raises:
        UsageError: no such model, or a size without pixels.
    """
    scenes = [_scene(request, model) for request in given]
    fitted = [scene for scene in scenes if not isinstance(scene, FitResult)]
    searched: Iterator[CameraSolution | None] = repeat(None)
    if (first := searched_model(model)) is not None:
        searched = iter(search_cameras(fitted, first))
    return [
        scene if isinstance(scene, FitResult) else _fit(scene, model, None, next(searched))
        for scene in scenes
    ]


def _scene(request: FitRequest, model: str) -> FitScene | FitResult:
    """What is fitted to a frame, or a result that says why no camera can be fitted to them."""
    annotation, field, size = request
    require_known_model(model)
    if min(size) < 2:
        raise UsageError(f"the picture's size {size[0]}x{size[1]} is too small")
    strange = pixel_like(annotation)
    if strange is not None:
        return FitResult(model, size, None, pixel_coordinates_error(strange))
    planar = model == "H"
    frame = ImageFrame(size)
    seen = build_observations(annotation, field, frame, ground_only=planar)
    problem = insufficient_reason(seen, needed=MIN_ELEMENTS, planar=planar)
    if seen is None or problem is not None:
        return FitResult(model, size, None, problem)
    return FitScene(seen, field, frame)


def _fit(
    scene: FitScene, model: str, start: Camera | None, searched: CameraSolution | None = None
) -> FitResult:
    if model == AUTO:
        return select_model(scene, start, searched)
    found, warm = fit_model(scene, model, start, searched)
    return fit_result_from(found, scene.field, scene.frame, model, warm)


def pixel_coordinates_error(point: Point) -> str:
    """Return what is wrong with an annotation in pixels, of which this is a point."""
    return translatable(
        "coordinates look like pixels, expected 0 to 1 (x = {x:g}, y = {y:g})", x=point.u, y=point.v
    )


def require_known_model(model: object) -> None:
    """Raises UsageError unless `fit_camera` knows this model."""
    if not isinstance(model, str):
        raise UsageError(
            f"unknown camera model {model!r}; choose one of {', '.join(MODEL_CHOICES)}"
        )
    if model in MODEL_CHOICES:
        return
    names = {name.lower(): name for name in MODEL_CHOICES}
    close = difflib.get_close_matches(model.lower(), names, n=1)
    hint = (
        f"did you mean {names[close[0]]}?" if close else f"choose one of {', '.join(MODEL_CHOICES)}"
    )
    raise UsageError(f"unknown camera model {model!r}; {hint}")
