"""The simplest camera model that the annotated points support."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.one_model import find_model_steps, result_of
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.barrel import is_demanded, perhaps_barrel
from procc_annotator.fit.solving.covariance import covariance_of, error_of_points
from procc_annotator.fit.solving.cut_out import is_cut_out, perhaps_cut_out
from procc_annotator.fit.solving.final_fit import MINIMUM_ELEMENTS, FoundCamera, fit_models
from procc_annotator.fit.solving.models import (
    KAPPA,
    strong_vector_from_camera,
    vector_from_camera,
)
from procc_annotator.fit.solving.observations import Observations, PictureFrame, observe
from procc_annotator.fit.solving.plausible import missing, objection
from procc_annotator.fit.solving.search import believed
from procc_annotator.fit.solving.solver import Steps
from procc_annotator.fit.solving.starts import (
    side_of,
    wide_prior,
)
from procc_annotator.fit.solving.strong_lens import (
    explains_more,
    perhaps_strong,
    plain_lens_near,
    refine_strong,
)
from procc_annotator.fit.solving.surroundings import surroundings_of
from procc_annotator.language import said, said_joined

# So many deviations from 0 the radial coefficient is out of question: no need to fit without it.
_CLEARLY = 4.0
_CUT_OUT = said(
    "the principal point is far from the centre of the picture, which seems cut out of a larger one"
)


def fit_simplest_steps(
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    start: Camera | None = None,
) -> Steps[FitResult]:
    """Fit the simplest of the models P, R and R+ that the points support; R2 or F where lines are
    bent as none of these explains; step by step.

    The models are fitted to the same elements and compared by their evidence, the probability of
    the points given a model (Laplace's approximation: MacKay, Bayesian Interpolation, 1992). What
    a parameter costs follows from its prior and from how sharply the points determine it.

    Args:
        annotation: normalised points, as for `fit_camera`.
        field: the elements, metres.
        size: (width, height) px of the picture that the camera is for.
        start: a camera that is nearly right, px of ``size``.

    Returns:
        The fit, as `fit_camera` gives it for the model that was chosen, with `chosen_because`.

    Raises:
        UsageError: a size without pixels.
    """
    if min(size) < 2:
        raise UsageError(f"the picture's size {size[0]}x{size[1]} is too small")
    frame = PictureFrame(size)
    seen = observe(annotation, field, frame)
    problem = missing(seen, needed=MINIMUM_ELEMENTS, planar=False)
    if seen is None or problem is not None:
        return FitResult("auto", size, None, problem)
    strong = _still_strong(seen, field, frame, start)
    if strong is not None:
        return _strong_result(*strong, field, frame, warm=True)
    fits, warm = yield from _fits(seen, field, frame, start)
    found = perhaps_strong(fits["R+"], seen, field, frame)
    if found is not None:
        return _strong_result(*found, fits["R+"], field, frame, warm=False)
    error_px = error_of_points(fits["R+"])
    evidence = {model: _evidence(found, error_px) for model, found in fits.items()}
    around = surroundings_of(field)
    likely = [m for m, found in fits.items() if not objection(found.vector, around)] or list(fits)
    chosen = max(likely, key=lambda model: evidence[model])
    result = result_of(fits[chosen], field, frame, chosen, warm)
    if result.camera is None:
        return replace(result, model="auto")
    return replace(result, chosen_because=_reason(chosen, fits, frame))


def _still_strong(
    seen: Observations, field: Field, frame: PictureFrame, start: Camera | None
) -> tuple[FoundCamera, str, FoundCamera] | None:
    """The strong lens that was there before, its model, and the R+ nearest to it that explains
    clearly less; None where there is none, or it is not supported any more."""
    if isinstance(start, FisheyeCamera):
        model = "F"
    elif isinstance(start, PinholeCamera) and start.radial[1]:
        model = "R2"
    else:
        return None
    vector = strong_vector_from_camera(start, frame)
    if not np.isfinite(vector).all():
        return None
    found = refine_strong(seen, field, frame, vector)
    if found.is_stale or not found.is_consistent or objection(found.vector, surroundings_of(field)):
        return None
    near = plain_lens_near(found.vector)
    plain = fit_models(found.seen, field, frame, near, found.left_out, ("R+",))["R+"]
    return (found, model, plain) if explains_more(found, plain) else None


def _strong_result(
    found: FoundCamera,
    model: str,
    plain: FoundCamera,
    field: Field,
    frame: PictureFrame,
    *,
    warm: bool,
) -> FitResult:
    result = result_of(found, field, frame, model, warm)
    if result.camera is None:
        return replace(result, model="auto")
    without, with_lens = (f"{_mean_px(one) / frame.scale:.2f}" for one in (plain, found))
    lens = "a second radial coefficient" if model == "R2" else "the lens of a fisheye"
    because = f"{lens} brings the points from {without} to {with_lens} px"
    return replace(result, chosen_because=because)


def _fits(
    seen: Observations, field: Field, frame: PictureFrame, start: Camera | None
) -> Steps[tuple[dict[str, FoundCamera], bool]]:
    """Fits of the models that come into question, the simplest first; whether from the start."""
    fits = _fits_from(seen, field, frame, start)
    if fits is not None and is_cut_out(fits["R+"]) and _serves(fits["R+"], field):
        return {"R+": fits["R+"]}, True
    warm = fits is not None and all(_serves(found, field) for found in fits.values())
    if fits is None or not warm:
        # What changes who is mistaken may still be nearly right; what is stale is not.
        known = None if fits is not None and fits["R"].is_stale else start
        first, warm = yield from find_model_steps(seen, field, frame, "R", known)
    else:
        first = perhaps_barrel(fits["R"], field, frame)
    if fits is None or first is not fits["R"]:
        fits = fit_models(seen, field, frame, first.vector, first.left_out, ("R", "R+"))
    cut_out = perhaps_cut_out(fits["R+"], field, frame)
    if is_cut_out(cut_out):
        # Its principal point lies where the other models have none: they explain other elements.
        return {"R+": cut_out}, warm
    with_lens = fits["R"]
    if _bends_clearly(with_lens):
        return fits, warm
    plain = fit_models(seen, field, frame, with_lens.vector, with_lens.left_out, ("P",))
    return {**plain, **fits}, warm


def _fits_from(
    seen: Observations, field: Field, frame: PictureFrame, start: Camera | None
) -> dict[str, FoundCamera] | None:
    """Fits of R and R+ from a start, good or not; None if it is no pinhole."""
    if not isinstance(start, PinholeCamera):
        return None
    vector = vector_from_camera(start, frame)
    if not np.isfinite(vector).all():
        return None
    vector, left_out = believed(seen, field, frame, vector, "R+")
    fits = fit_models(seen, field, frame, vector, left_out, ("R", "R+"))
    if is_demanded(fits["R"]):
        return fits
    vector[KAPPA] = 0.0
    return fit_models(seen, field, frame, vector, left_out, ("R", "R+"))


def _serves(found: FoundCamera, field: Field) -> bool:
    """Whether a fit from a start need not be looked for anew."""
    around = surroundings_of(field)
    # Its prior is that of the side the start stands on.
    moved = wide_prior(np.array([side_of(found.vector, around)]), around, found.prior.mean.shape[1])
    same_side = np.array_equal(moved.mean, found.prior.mean)
    plausible = not objection(found.vector, around)
    return same_side and plausible and found.is_consistent and not found.is_stale


def _bends_clearly(found: FoundCamera) -> bool:
    """Whether the radial coefficient is so many deviations from 0 that it need not be compared."""
    error_px = error_of_points(found)
    deviation = math.sqrt(covariance_of(found, error_px)[KAPPA, KAPPA])
    return bool(abs(found.vector[KAPPA]) > _CLEARLY * deviation)


def _evidence(found: FoundCamera, error_px: float) -> float:
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


def _reason(chosen: str, fits: dict[str, FoundCamera], frame: PictureFrame) -> str:
    if fits.keys() == {"R+"}:
        return _CUT_OUT
    mean = {model: f"{_mean_px(found) / frame.scale:.2f}" for model, found in fits.items()}
    if chosen == "P":
        return said(
            "without lens distortion the points are {without} px off, with it {with_it} px: not"
            " clearly better",
            without=mean["P"],
            with_it=mean["R"],
        )
    if chosen == "R+":
        return said(
            "aspect ratio and principal point bring the points from {before} to {after} px, more"
            " than three parameters would by chance",
            before=mean["R"],
            after=mean["R+"],
        )
    bent = (
        said(
            "lens distortion brings the points from {before} to {after} px",
            before=mean["P"],
            after=mean["R"],
        )
        if "P" in mean
        else said("the points show lens distortion clearly and are {px} px off", px=mean["R"])
    )
    further = said(
        "with aspect ratio and principal point {px} px: not clearly better", px=mean["R+"]
    )
    return said_joined("; ", (bent, further))


def _mean_px(found: FoundCamera) -> float:
    counted = ~found.left_out[found.seen.element_of_point]
    return float(found.shown_distances[counted].mean())
