"""Fit a camera to an annotation, with the model asked for or the simplest the points support."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import repeat

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, pixel_like
from procc_annotator.calibration.optimization.camera_parameters import (
    KAPPA,
    MODELS,
    WIDE_ANGLE_MODELS,
    homography_from_camera,
    homography_from_pinhole,
    vector_from_camera,
    wide_angle_vector_from_camera,
)
from procc_annotator.calibration.optimization.camera_placement import (
    implausible_reason,
    insufficient_reason,
)
from procc_annotator.calibration.optimization.covariance import (
    parameter_covariance,
    picture_distances,
    point_error_sd,
)
from procc_annotator.calibration.optimization.initialization import camera_side, wide_prior
from procc_annotator.calibration.optimization.lens_models import (
    fit_wide_angle,
    is_cropped,
    is_negative_k1_supported,
    refine_wide_angle,
    single_coefficient_vector,
    try_cropped,
    try_negative_k1,
    try_wide_angle,
    wide_angle_explains_more,
)
from procc_annotator.calibration.optimization.observations import (
    ImageFrame,
    build_observations,
)
from procc_annotator.calibration.optimization.robust_fit import (
    MIN_ELEMENTS,
    CameraSolution,
    FitScene,
    fit_models,
    inlier_elements_near,
    refine_camera,
    refine_homography,
    search_cameras,
    search_homography,
)
from procc_annotator.calibration.result import FitResult, fit_result_from
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.translation import translatable, translatable_joined

# The model to search for before these are fitted; others are searched for themselves.
_SEARCHED_FOR = {"auto": "R", "R2": "R+", "F": "R+"}


def searched_model(model: str) -> str | None:
    """The pinhole model to search for first when there is no start; None for H."""
    return None if model == "H" else _SEARCHED_FOR.get(model, model)


def fit_model(
    scene: FitScene, model: str, start: Camera | None, searched: CameraSolution | None = None
) -> tuple[CameraSolution, bool]:
    """Fit a model, from a start if there is one that serves.

    Args:
        scene: for H the points on the ground.
        model: H, P, R, R+, R2 or F.
        start: a camera that is nearly right, px of the picture.
        searched: the result of `search_cameras`, if already known; see `searched_model`.

    Returns:
        The fit, plausible or not, and whether it came from the start.
    """
    if model in WIDE_ANGLE_MODELS:
        return _fit_wide_angle(scene, model, start, searched)
    found, warm = _fit_from_start(scene, model, start), True
    if isinstance(start, PinholeCamera) and found is not None and not _still_has_negative_k1(found):
        found = _fit_from_start(scene, model, replace(start, radial=(0.0,) * 6))
    if found is None or found.has_stale_start or not _is_plausible(found, scene):
        warm = False
        if model == "H":
            found = search_homography(scene)
        else:
            found = searched or search_cameras([scene], model)[0]
    if model in ("R", "R+"):
        found = try_negative_k1(found, scene)
    return try_cropped(found, scene) if model == "R+" else found, warm


def _fit_wide_angle(
    scene: FitScene, model: str, start: Camera | None, searched: CameraSolution | None
) -> tuple[CameraSolution, bool]:
    if isinstance(start, FisheyeCamera if model == "F" else PinholeCamera):
        assert isinstance(start, FisheyeCamera | PinholeCamera)  # one of both
        vector = wide_angle_vector_from_camera(start, scene.frame)
        if np.isfinite(vector).all():
            found = refine_wide_angle(scene, vector)
            if not found.has_stale_start and _is_plausible(found, scene):
                return found, True
    near, _ = fit_model(scene, "R+", None, searched)
    return fit_wide_angle(scene, model, near), False


def _fit_from_start(scene: FitScene, model: str, start: Camera | None) -> CameraSolution | None:
    if isinstance(start, PinholeCamera):
        vector = vector_from_camera(start, scene.frame)
        if not np.isfinite(vector).all():
            return None
        if model != "H":
            return refine_camera(scene, model, vector)
        return refine_homography(scene.seen, homography_from_pinhole(vector))
    if isinstance(start, HomographyCamera) and model == "H":
        return refine_homography(scene.seen, homography_from_camera(start, scene.frame))
    return None


def _still_has_negative_k1(found: CameraSolution) -> bool:
    return found.basis is not None or is_negative_k1_supported(found)


def _is_plausible(found: CameraSolution, scene: FitScene) -> bool:
    return found.basis is not None or not implausible_reason(found.vector, scene.around)


# So many deviations from 0 the radial coefficient is out of question: no need to fit without it.
_CLEAR_SIGNIFICANCE_SD = 4.0
_CROPPED_REASON = translatable(
    "the principal point is far from the centre of the picture, which seems cut out of a larger one"
)


def select_model(
    scene: FitScene, start: Camera | None, searched: CameraSolution | None = None
) -> FitResult:
    """Fit the simplest of the models P, R and R+ that the points support; R2 or F where lines are
    bent as none of these explains. The result has `chosen_because`.

    The models are fitted to the same elements and compared by their evidence, the probability of
    the points given a model (Laplace's approximation: MacKay, Bayesian Interpolation, 1992). What
    a parameter costs follows from its prior and from how sharply the points determine it. Start
    and search are those of `fit_model`.
    """
    field, frame = scene.field, scene.frame
    strong = _refit_wide_angle(scene, start)
    if strong is not None:
        return _wide_angle_result(*strong, field, frame, warm=True)
    fits, warm = _candidate_fits(scene, start, searched)
    found = try_wide_angle(fits["R+"], scene)
    if found is not None:
        return _wide_angle_result(*found, fits["R+"], field, frame, warm=False)
    error_px = point_error_sd(fits["R+"])
    evidence = {model: _log_evidence(found, error_px) for model, found in fits.items()}
    likely = [m for m, found in fits.items() if _is_plausible(found, scene)] or list(fits)
    chosen = max(likely, key=lambda model: evidence[model])
    result = fit_result_from(fits[chosen], field, frame, chosen, warm)
    if result.camera is None:
        return replace(result, model="auto")
    return replace(result, chosen_because=_choice_reason(chosen, fits, frame))


def _refit_wide_angle(
    scene: FitScene, start: Camera | None
) -> tuple[CameraSolution, str, CameraSolution] | None:
    """The strong lens that was there before, its model, and the R+ nearest to it that explains
    clearly less; None if absent, or it is not supported any more."""
    if isinstance(start, FisheyeCamera):
        model = "F"
    elif isinstance(start, PinholeCamera) and start.radial[1]:
        model = "R2"
    else:
        return None
    vector = wide_angle_vector_from_camera(start, scene.frame)
    if not np.isfinite(vector).all():
        return None
    found = refine_wide_angle(scene, vector)
    if found.has_stale_start or not found.is_consistent:
        return None
    near = single_coefficient_vector(found.vector)
    plain = fit_models(scene._replace(seen=found.seen), near, found.left_out, ("R+",))["R+"]
    return (found, model, plain) if wide_angle_explains_more(found, plain, scene) else None


def _wide_angle_result(
    found: CameraSolution,
    model: str,
    plain: CameraSolution,
    field: Field,
    frame: ImageFrame,
    *,
    warm: bool,
) -> FitResult:
    result = fit_result_from(found, field, frame, model, warm)
    if result.camera is None:
        return replace(result, model="auto")
    without, with_lens = (f"{_mean_px(one, frame):.2f}" for one in (plain, found))
    lens = "a second radial coefficient" if model == "R2" else "the lens of a fisheye"
    because = f"{lens} brings the points from {without} to {with_lens} px"
    return replace(result, chosen_because=because)


def _candidate_fits(
    scene: FitScene, start: Camera | None, searched: CameraSolution | None
) -> tuple[dict[str, CameraSolution], bool]:
    """Fits of the models that come into question, the simplest first; whether from the start."""
    fits = _candidate_fits_from_start(scene, start)
    if fits is not None and is_cropped(fits["R+"]) and _is_acceptable_start_fit(fits["R+"], scene):
        return {"R+": fits["R+"]}, True
    warm = fits is not None and all(
        _is_acceptable_start_fit(found, scene) for found in fits.values()
    )
    if fits is None or not warm:
        # What changes who is mistaken may still be nearly right; what is stale is not.
        known = None if fits is not None and fits["R"].has_stale_start else start
        first, warm = fit_model(scene, "R", known, searched)
    else:
        first = try_negative_k1(fits["R"], scene)
    if fits is None or first is not fits["R"]:
        fits = fit_models(scene, first.vector, first.left_out, ("R", "R+"))
    cut_out = try_cropped(fits["R+"], scene)
    if is_cropped(cut_out):
        # Its principal point lies where the other models have none: they explain other elements.
        return {"R+": cut_out}, warm
    with_lens = fits["R"]
    if _has_significant_k1(with_lens):
        return fits, warm
    plain = fit_models(scene, with_lens.vector, with_lens.left_out, ("P",))
    return {**plain, **fits}, warm


def _candidate_fits_from_start(
    scene: FitScene, start: Camera | None
) -> dict[str, CameraSolution] | None:
    """Fits of R and R+ from a start, good or not; None if it is no pinhole."""
    if not isinstance(start, PinholeCamera):
        return None
    vector = vector_from_camera(start, scene.frame)
    if not np.isfinite(vector).all():
        return None
    vector, left_out = inlier_elements_near(scene, vector, "R+")
    fits = fit_models(scene, vector, left_out, ("R", "R+"))
    if is_negative_k1_supported(fits["R"]):
        return fits
    vector[KAPPA] = 0.0
    return fit_models(scene, vector, left_out, ("R", "R+"))


def _is_acceptable_start_fit(found: CameraSolution, scene: FitScene) -> bool:
    """Return whether a fit from a start need not be looked for anew."""
    # Its prior is that of the side the start stands on.
    side = np.array([camera_side(found.vector, scene.around)])
    moved = wide_prior(side, scene.around, found.prior.mean.shape[1])
    same_side = np.array_equal(moved.mean, found.prior.mean)
    plausible = _is_plausible(found, scene)
    return same_side and plausible and found.is_consistent and not found.has_stale_start


def _has_significant_k1(found: CameraSolution) -> bool:
    """Return whether the radial coefficient is so many deviations from 0 that it need not be
    compared."""
    error_px = point_error_sd(found)
    deviation = math.sqrt(parameter_covariance(found, error_px)[KAPPA, KAPPA])
    return bool(abs(found.vector[KAPPA]) > _CLEAR_SIGNIFICANCE_SD * deviation)


def _log_evidence(found: CameraSolution, error_px: float) -> float:
    """Logarithm of the evidence, less what all models share."""
    precision = found.prior.inverse_sd[0]
    off = (found.vector[: len(precision)] - found.prior.mean[0]) * precision
    prior_cost = float(off @ off) / 2
    data_cost = (float(found.solution.costs[0]) - prior_cost) / error_px**2
    information = found.solution.normal[0] / error_px**2 + np.diag(precision**2)
    # Pan and tilt have no prior; whatever theirs is, all models share it.
    sharpened = np.linalg.slogdet(information)[1] / 2 - np.log(precision[precision > 0]).sum()
    # The prior of the radial coefficient has its mass on one side.
    one_sided = math.log(2.0) if len(precision) > KAPPA else 0.0
    return one_sided - data_cost - prior_cost - float(sharpened)


def _choice_reason(chosen: str, fits: dict[str, CameraSolution], frame: ImageFrame) -> str:
    if fits.keys() == {"R+"}:
        return _CROPPED_REASON
    mean = {model: f"{_mean_px(found, frame):.2f}" for model, found in fits.items()}
    if chosen == "P":
        return translatable(
            "without lens distortion the points are {without} px off, with it {with_it} px: not"
            " clearly better",
            without=mean["P"],
            with_it=mean["R"],
        )
    if chosen == "R+":
        return translatable(
            "aspect ratio and principal point bring the points from {before} to {after} px, more"
            " than three parameters would by chance",
            before=mean["R"],
            after=mean["R+"],
        )
    bent = (
        translatable(
            "lens distortion brings the points from {before} to {after} px",
            before=mean["P"],
            after=mean["R"],
        )
        if "P" in mean
        else translatable(
            "the points show lens distortion clearly and are {px} px off", px=mean["R"]
        )
    )
    further = translatable(
        "with aspect ratio and principal point {px} px: not clearly better", px=mean["R+"]
    )
    return translatable_joined("; ", (bent, further))


def _mean_px(found: CameraSolution, frame: ImageFrame) -> float:
    counted = ~found.left_out[found.seen.element_of_point]
    return float(picture_distances(found, frame)[counted].mean())


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
        field: the elements, metres, and the pixels of the dataset's pictures.
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
    time, since the searches of all frames are solved together."""
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
    frame = ImageFrame(size, field.pixel_aspect)
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
