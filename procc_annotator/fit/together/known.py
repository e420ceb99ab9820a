"""A camera whose position is known: what is left are pan, tilt, roll, zoom and lens."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.one_model import fit_result_from
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.element_offsets import estimate_element_offsets
from procc_annotator.fit.solving.final_fit import CameraSolution
from procc_annotator.fit.solving.models import (
    FISHEYE_FLAG,
    FREE_PARAMETERS,
    KAPPA,
    LOG_FOCAL,
    ROLL,
    X,
    Z,
    lower_bounded_parameter,
    is_wide_angle,
)
from procc_annotator.fit.solving.noise import whitened
from procc_annotator.fit.solving.observations import FloatArray, Observations, ImageFrame, build_observations
from procc_annotator.fit.solving.residual import linear_map, pinhole_residuals
from procc_annotator.fit.solving.solver import (
    FINAL_LOSS,
    ROBUST_LOSS,
    SEARCH_LOSS,
    RobustLoss,
    GaussianPrior,
    Problem,
    solve,
)
from procc_annotator.fit.solving.starts import initial_cameras_at_position, prior_near
from procc_annotator.fit.solving.surroundings import camera_placement_prior
from procc_annotator.fit.together.outer import ReducedFrame, unbounded_parameters, reduce_frame

POSITION_PARAMETERS = np.arange(X, Z + 1)
_FIXED_POSITION_SD_M = 1e-3  # what the position may be off in a fit that is not to move it


@dataclass(frozen=True, eq=False)
class LensAndRollPrior:
    """What the lens and the level of a camera are known to be beside its position: means and
    standard deviations of roll (rad) and kappa."""

    roll: tuple[float, float]
    kappa: tuple[float, float]


@dataclass(frozen=True, eq=False)
class FrameObservations:
    """One frame to be fitted together with others.

    Attributes:
        seen: its points.
        left_out: (E,) elements taken for mistakes, which have no say.
        frame: the picture.
        model: P, R or R+.
        vector: (11,) its camera, or what to start from.
    """

    seen: Observations
    left_out: NDArray[np.bool_]
    frame: ImageFrame
    model: str
    vector: FloatArray

    @cached_property
    def kept(self) -> Observations:
        """The points, with weight 0 for those that have no say."""
        return self.seen.with_excluded(self.left_out)


def frame_observations(annotation: FrameAnnotation, fit: FitResult, field: Field) -> FrameObservations:
    """A frame as its own fit sees it.

    Args:
        annotation: what was fitted.
        fit: has a pinhole camera.
        field: the elements.
    """
    frame = ImageFrame(fit.size)
    seen = build_observations(annotation, field, frame)
    if seen is None or fit.vector is None:
        raise ValueError("a failed fit has no camera")
    out = set(fit.left_out)
    left_out = np.array([element.name in out for element in seen.elements])
    seen = whitened(seen, linear_map(fit.vector))
    return FrameObservations(seen, left_out, frame, fit.model, fit.vector)


def prior_at_position(vector: FloatArray, field: Field, free: int, usual: LensAndRollPrior | None = None) -> GaussianPrior:
    """Weak priors on everything but the position, which is held.

    Args:
        vector: (11,) a camera at that position, nearly right.
        field: where cameras stand around it.
        free: number of the model's parameters.
        usual: what is known of the camera besides.
    """
    around = camera_placement_prior(field)
    prior = prior_near(vector, around, free)
    mean, inverse = prior.mean.copy(), prior.inverse_sd.copy()
    mean[:, POSITION_PARAMETERS], inverse[:, POSITION_PARAMETERS] = vector[POSITION_PARAMETERS], 1 / _FIXED_POSITION_SD_M
    if usual is not None:
        mean[:, ROLL], inverse[:, ROLL] = usual.roll[0], 1 / usual.roll[1]
        if free > KAPPA and not is_wide_angle(vector):
            mean[:, KAPPA], inverse[:, KAPPA] = usual.kappa[0], 1 / usual.kappa[1]
    return GaussianPrior(mean, inverse)


def fit_at_position(
    sighting: FrameObservations,
    position: FloatArray,
    field: Field,
    *,
    usual: LensAndRollPrior | None = None,
    tolerance: float = 1e-5,
) -> CameraSolution:
    """The camera of a frame at a known position, from one that is nearly right.

    Args:
        sighting: the frame.
        position: (3,) metres.
        field: the elements.
        usual: what is known of the camera besides.
        tolerance: see `solve`.
    """
    start = sighting.vector.copy()
    start[POSITION_PARAMETERS] = position
    prior = prior_at_position(start, field, FREE_PARAMETERS[sighting.model], usual)
    return _fit_at_position(sighting, start[None], position, prior, FINAL_LOSS, tolerance)


def search_at_position(
    sighting: FrameObservations, position: FloatArray, field: Field, usual: LensAndRollPrior | None = None
) -> CameraSolution:
    """The camera of a frame at a known position, without a start.

    Args:
        sighting: the frame; its vector does not matter.
        position: (3,) metres.
        field: the elements.
        usual: what is known of the camera besides.
    """
    starts = initial_cameras_at_position(position, sighting.seen, field)
    prior = prior_at_position(starts[0], field, FREE_PARAMETERS["P"], usual)
    first = _fit_at_position(replace(sighting, model="P"), starts, position, prior, SEARCH_LOSS, 1e-4)
    prior = prior_at_position(starts[0], field, FREE_PARAMETERS[sighting.model], usual)
    begin = first.vector[None].copy()
    # Whose other pictures show barrel distortion: only from below 0 is a fit led there.
    begin[:, KAPPA] = 0.0 if usual is None else min(usual.kappa[0], 0.0)
    robust = _fit_at_position(sighting, begin, position, prior, ROBUST_LOSS, 1e-4)
    return _fit_at_position(sighting, robust.vector[None], position, prior, FINAL_LOSS, 1e-5)


def _fit_at_position(
    sighting: FrameObservations,
    starts: FloatArray,
    position: FloatArray,
    prior: GaussianPrior,
    loss: RobustLoss,
    tolerance: float,
) -> CameraSolution:
    free = FREE_PARAMETERS[sighting.model]
    vectors = starts.copy()
    vectors[:, free:FISHEYE_FLAG] = 0.0
    problem = Problem(
        partial(
            pinhole_residuals,
            seen=sighting.kept,
            half_diagonal=sighting.frame.half_diagonal,
            free=free,
        ),
        sighting.kept.weights,
        loss,
        prior,
        bounded=lower_bounded_parameter(vectors),
    )
    found = solve(problem, vectors, iterations=20, tolerance=tolerance)
    best = int(np.argmin(found.costs))
    only = found.chosen(np.array([best]))
    vector = found.vectors[best].copy()
    vector[POSITION_PARAMETERS] = position  # the same to the last digit in all frames
    return CameraSolution(vector, only, prior, sighting.seen, sighting.left_out)


def profile_at_position(sighting: FrameObservations, position: FloatArray, field: Field) -> ReducedFrame:
    """What a frame says of a position, once its camera is the best one for it."""
    found = fit_at_position(sighting, position, field)
    free, vector = FREE_PARAMETERS[sighting.model], found.vector
    residuals = pinhole_residuals(vector[None], sighting.seen, sighting.frame.half_diagonal, free)
    own = frame_parameters(vector, free)
    order = np.concatenate([POSITION_PARAMETERS, own])
    ordered = replace(residuals, derivatives=residuals.derivatives[:, order])
    return reduce_frame(vector, ordered, sighting.kept.weights, found.prior, own)


def frame_parameters(vector: FloatArray, free: int) -> NDArray[np.intp]:
    """Free parameters beside the position; a radial coefficient on its bound is none."""
    return np.setdiff1d(unbounded_parameters(vector, free), POSITION_PARAMETERS)


def fit_result_at_position(
    found: CameraSolution, sighting: FrameObservations, field: Field, covariance: FloatArray
) -> FitResult:
    """The result of a fit at a known position, which is itself uncertain.

    Args:
        found: from `fit_at_position` or `search_at_position`.
        sighting: the frame.
        field: the elements.
        covariance: (3, 3) of the position, metres squared.
    """
    result = fit_result_from(found, field, sighting.frame, sighting.model, False)
    if result.camera is None or result.error_px is None or result.deviations is None:
        return result
    free = FREE_PARAMETERS[sighting.model]
    own = np.setdiff1d(np.arange(free), POSITION_PARAMETERS)
    error_px = result.error_px * sighting.frame.scale
    information = found.solution.normal[0] / error_px**2 + np.diag(found.prior.inverse_sd[0] ** 2)
    alone = np.linalg.inv(information[np.ix_(own, own)])
    # How the camera's own parameters follow the position.
    follow = -alone @ information[np.ix_(own, POSITION_PARAMETERS)]
    full = np.zeros((free, free))
    full[np.ix_(POSITION_PARAMETERS, POSITION_PARAMETERS)] = covariance
    full[np.ix_(own, POSITION_PARAMETERS)] = follow @ covariance
    full[np.ix_(POSITION_PARAMETERS, own)] = full[np.ix_(own, POSITION_PARAMETERS)].T
    full[np.ix_(own, own)] = alone + follow @ covariance @ follow.T
    of_clicks, at_place = full, np.zeros((free, free))
    at_place[np.ix_(own, own)] = alone
    full = of_clicks + estimate_element_offsets(found, sighting.frame, error_px).covariance(at_place)
    sd = np.sqrt(np.diag(full)).tolist()
    focal = float(np.exp(found.vector[LOG_FOCAL])) / sighting.frame.scale
    deviations = replace(
        result.deviations,
        pan_rad=sd[0],
        tilt_rad=sd[1],
        roll_rad=sd[2],
        position_m=(sd[X], sd[X + 1], sd[Z]),
        focal_px=focal * sd[LOG_FOCAL],
    )
    return replace(result, covariance=full, of_clicks=of_clicks, deviations=deviations)
