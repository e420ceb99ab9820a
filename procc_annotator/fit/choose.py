"""The simplest camera model that the annotated points support."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.base import Camera
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.one_model import find_model, result_of
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.covariance import error_of_points
from procc_annotator.fit.solving.models import FREE
from procc_annotator.fit.solving.observations import Frame, observe
from procc_annotator.fit.solving.plausible import missing
from procc_annotator.fit.solving.search import MINIMUM_ELEMENTS, Found, nested

_ADDS = {
    "P": "a pinhole",
    "R": "lens distortion",
    "R+": "lens distortion with aspect ratio and principal point",
}


def fit_simplest(
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    start: Camera | None = None,
) -> FitResult:
    """Fit the simplest of the models P, R and R+ that the points support.

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
    frame = Frame(size)
    seen = observe(annotation, field, frame)
    problem = missing(seen, needed=MINIMUM_ELEMENTS, planar=False)
    if seen is None or problem is not None:
        return FitResult("auto", size, None, problem)
    first, warm = find_model(seen, field, frame, "R", start)
    fits = nested(seen, field, frame, first)
    error_px = error_of_points(fits["R+"])
    evidence = {model: _evidence(found, error_px) for model, found in fits.items()}
    chosen = "P"
    for model in FREE:
        if evidence[model] > evidence[chosen]:
            chosen = model
    result = result_of(fits[chosen], field, frame, chosen, warm)
    if result.camera is None:
        return replace(result, model="auto")
    return replace(result, chosen_because=_reason(chosen, fits))


def _evidence(found: Found, error_px: float) -> float:
    """Logarithm of the evidence, less what all models share."""
    precision = found.prior.inverse_sd[0]
    off = (found.vector[: len(precision)] - found.prior.mean[0]) * precision
    prior_cost = float(off @ off) / 2
    data_cost = (float(found.solution.costs[0]) - prior_cost) / error_px**2
    information = found.solution.normal[0] / error_px**2 + np.diag(precision**2)
    # Pan and tilt have no prior; whatever theirs is, all models share it.
    sharpened = np.linalg.slogdet(information)[1] / 2 - np.log(precision[precision > 0]).sum()
    return -data_cost - prior_cost - float(sharpened)


def _reason(chosen: str, fits: dict[str, Found]) -> str:
    mean = {model: float(found.distances.mean()) for model, found in fits.items()}
    if chosen == "P":
        return (
            f"a pinhole explains the points to {mean['P']:.1f} px,"
            f" lens distortion would change that to {mean['R']:.1f} px"
        )
    before = "P" if chosen == "R" else "R"
    return f"{_ADDS[chosen]} brings the points from {mean[before]:.1f} to {mean[chosen]:.1f} px"
