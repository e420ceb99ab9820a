"""A camera whose position is known: what is left are pan, tilt, roll, zoom and lens."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.fit.one_model import result_of
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.element_offsets import element_offsets
from procc_annotator.fit.solving.final_fit import FoundCamera
from procc_annotator.fit.solving.models import (
    FISHEYE,
    FREE,
    KAPPA,
    LOG_FOCAL,
    ROLL,
    X,
    Z,
    bounded_in,
    is_strong,
)
from procc_annotator.fit.solving.noise import softened
from procc_annotator.fit.solving.observations import FloatArray, Observations, PictureFrame, observe
from procc_annotator.fit.solving.residual import linear_map, pinhole_residuals
from procc_annotator.fit.solving.solver import (
    FINAL_LOSS,
    ROBUST_LOSS,
    SEARCH_LOSS,
    Loss,
    Prior,
    Problem,
    solve,
)
from procc_annotator.fit.solving.starts import aimed, prior_near
from procc_annotator.fit.solving.surroundings import surroundings_of
from procc_annotator.fit.together.outer import Profile, open_parameters, profile_of

POSITION = np.arange(X, Z + 1)
_HELD_M = 1e-3  # what the position may be off in a fit that is not to move it


@dataclass(frozen=True, eq=False)
class Usual:
    """What the lens and the level of a camera are known to be beside its position: means and
    standard deviations of roll (rad) and kappa."""

    roll: tuple[float, float]
    kappa: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Sighting:
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
    frame: PictureFrame
    model: str
    vector: FloatArray

    @cached_property
    def kept(self) -> Observations:
        """The points, with weight 0 for those that have no say."""
        return self.seen.leaving_out(self.left_out)


def sighting_of(annotation: FrameAnnotation, fit: FitResult, field: Field) -> Sighting:
    """A frame as its own fit sees it.

    Args:
        annotation: what was fitted.
        fit: has a pinhole camera.
        field: the elements.
    """
    frame = PictureFrame(fit.size)
    seen = observe(annotation, field, frame)
    if seen is None or fit.vector is None:
        raise ValueError("a failed fit has no camera")
    out = set(fit.left_out)
    left_out = np.array([element.name in out for element in seen.elements])
    seen = softened(seen, linear_map(fit.vector))
    return Sighting(seen, left_out, frame, fit.model, fit.vector)


def prior_at(vector: FloatArray, field: Field, free: int, usual: Usual | None = None) -> Prior:
    """Weak priors on everything but the position, which is held.

    Args:
        vector: (11,) a camera at that position, nearly right.
        field: where cameras stand around it.
        free: number of the model's parameters.
        usual: what is known of the camera besides.
    """
    around = surroundings_of(field)
    prior = prior_near(vector, around, free)
    mean, inverse = prior.mean.copy(), prior.inverse_sd.copy()
    mean[:, POSITION], inverse[:, POSITION] = vector[POSITION], 1 / _HELD_M
    if usual is not None:
        mean[:, ROLL], inverse[:, ROLL] = usual.roll[0], 1 / usual.roll[1]
        if free > KAPPA and not is_strong(vector):
            mean[:, KAPPA], inverse[:, KAPPA] = usual.kappa[0], 1 / usual.kappa[1]
    return Prior(mean, inverse)


def fit_at(
    sighting: Sighting,
    position: FloatArray,
    field: Field,
    *,
    usual: Usual | None = None,
    tolerance: float = 1e-5,
) -> FoundCamera:
    """The camera of a frame at a known position, from one that is nearly right.

    Args:
        sighting: the frame.
        position: (3,) metres.
        field: the elements.
        usual: what is known of the camera besides.
        tolerance: see `solve`.
    """
    start = sighting.vector.copy()
    start[POSITION] = position
    prior = prior_at(start, field, FREE[sighting.model], usual)
    return _fit(sighting, start[None], position, prior, FINAL_LOSS, tolerance)


def search_at(
    sighting: Sighting, position: FloatArray, field: Field, usual: Usual | None = None
) -> FoundCamera:
    """The camera of a frame at a known position, without a start.

    Args:
        sighting: the frame; its vector does not matter.
        position: (3,) metres.
        field: the elements.
        usual: what is known of the camera besides.
    """
    starts = aimed(position, sighting.seen, field)
    prior = prior_at(starts[0], field, FREE["P"], usual)
    first = _fit(replace(sighting, model="P"), starts, position, prior, SEARCH_LOSS, 1e-4)
    prior = prior_at(starts[0], field, FREE[sighting.model], usual)
    begin = first.vector[None].copy()
    # Whose other pictures show barrel distortion: only from below 0 is a fit led there.
    begin[:, KAPPA] = 0.0 if usual is None else min(usual.kappa[0], 0.0)
    robust = _fit(sighting, begin, position, prior, ROBUST_LOSS, 1e-4)
    return _fit(sighting, robust.vector[None], position, prior, FINAL_LOSS, 1e-5)


def _fit(
    sighting: Sighting,
    starts: FloatArray,
    position: FloatArray,
    prior: Prior,
    loss: Loss,
    tolerance: float,
) -> FoundCamera:
    free = FREE[sighting.model]
    vectors = starts.copy()
    vectors[:, free:FISHEYE] = 0.0
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
        bounded=bounded_in(vectors),
    )
    found = solve(problem, vectors, iterations=20, tolerance=tolerance)
    best = int(np.argmin(found.costs))
    only = found.chosen(np.array([best]))
    vector = found.vectors[best].copy()
    vector[POSITION] = position  # the same to the last digit in all frames
    return FoundCamera(vector, only, prior, sighting.seen, sighting.left_out)


def profile_at(sighting: Sighting, position: FloatArray, field: Field) -> Profile:
    """What a frame says of a position, once its camera is the best one for it."""
    found = fit_at(sighting, position, field)
    free, vector = FREE[sighting.model], found.vector
    residuals = pinhole_residuals(vector[None], sighting.seen, sighting.frame.half_diagonal, free)
    own = own_parameters(vector, free)
    order = np.concatenate([POSITION, own])
    ordered = replace(residuals, derivatives=residuals.derivatives[:, order])
    return profile_of(vector, ordered, sighting.kept.weights, found.prior, own)


def own_parameters(vector: FloatArray, free: int) -> NDArray[np.intp]:
    """Free parameters beside the position; a radial coefficient on its bound is none."""
    return np.setdiff1d(open_parameters(vector, free), POSITION)


def known_result(
    found: FoundCamera, sighting: Sighting, field: Field, covariance: FloatArray
) -> FitResult:
    """The result of a fit at a known position, which is itself uncertain.

    Args:
        found: from `fit_at` or `search_at`.
        sighting: the frame.
        field: the elements.
        covariance: (3, 3) of the position, metres squared.
    """
    result = result_of(found, field, sighting.frame, sighting.model, False)
    if result.camera is None or result.error_px is None or result.deviations is None:
        return result
    free = FREE[sighting.model]
    own = np.setdiff1d(np.arange(free), POSITION)
    error_px = result.error_px * sighting.frame.scale
    information = found.solution.normal[0] / error_px**2 + np.diag(found.prior.inverse_sd[0] ** 2)
    alone = np.linalg.inv(information[np.ix_(own, own)])
    # How the camera's own parameters follow the position.
    follow = -alone @ information[np.ix_(own, POSITION)]
    full = np.zeros((free, free))
    full[np.ix_(POSITION, POSITION)] = covariance
    full[np.ix_(own, POSITION)] = follow @ covariance
    full[np.ix_(POSITION, own)] = full[np.ix_(own, POSITION)].T
    full[np.ix_(own, own)] = alone + follow @ covariance @ follow.T
    of_clicks, at_place = full, np.zeros((free, free))
    at_place[np.ix_(own, own)] = alone
    full = of_clicks + element_offsets(found, sighting.frame, error_px).covariance(at_place)
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
