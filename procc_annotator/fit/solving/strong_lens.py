"""Lenses that one radial coefficient does not describe: a second one (R2), or a fisheye (F).

What a strong lens bends no search for a pinhole explains. So the points are also made straight
again, as fisheyes of several focal lengths would have bent them, before a pinhole is looked for;
from whatever is found so, and from the camera with one coefficient, the strong lens is fitted.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.fit.solving.covariance import point_error_sd
from procc_annotator.fit.solving.final_fit import CameraSolution, final_fit, outlier_elements
from procc_annotator.fit.solving.models import (
    FISHEYE_FLAG,
    FREE_PARAMETERS,
    KAPPA,
    MIN_KAPPA,
    LOG_FOCAL,
    SECOND_KAPPA,
)
from procc_annotator.fit.solving.noise import whitened
from procc_annotator.fit.solving.observations import FloatArray, Observations, ImageFrame
from procc_annotator.fit.solving.plausible import implausible_reason
from procc_annotator.fit.solving.residual import linear_map, pinhole_residuals
from procc_annotator.fit.solving.search import search_camera
from procc_annotator.fit.solving.solver import ROBUST_LOSS, GaussianPrior, Problem, solve
from procc_annotator.fit.solving.starts import prior_near
from procc_annotator.fit.solving.surroundings import camera_placement_prior

_WIDE_ANGLE_FREE = FREE_PARAMETERS["R2"]
# Focal lengths, solver px, of the fisheyes that are tried; a picture is 960 px wide.
_WIDE_ANGLE_FOCALS_PX = (330.0, 480.0, 700.0)
_MAX_ANGLE_RAD = 1.4
# Where both coefficients of a radial lens are looked for beside a camera without them.
_COEFFICIENT_STARTS = ((0.0, 0.0), (-0.15, 0.02), (-0.35, 0.08))
# A fisheye's curve is made a radial one at so many places, up to so many half diagonals.
_STRAIGHTENING_SAMPLES, _MAX_RADII = 40, 2.5
# What a strong lens must explain, squares of the error of a point: 3 for each of two coefficients
# that its prior left open, and 3 for being twenty times as likely.
_WIDE_ANGLE_EVIDENCE = 9.0
# Straight elements clicked so far beside the line through their ends are bent by a strong lens.
_BENT_LINE_PX, _MIN_BENT_ELEMENTS = 6.0, 2
# Of so many elements that fit no camera together it is rather the camera that is not understood.
MANY_OUTLIERS = 3


def fit_wide_angle(
    seen: Observations,
    field: Field,
    frame: ImageFrame,
    model: str,
    near: CameraSolution,
    fisheye: CameraSolution | None = None,
) -> CameraSolution:
    """Fit a strong lens without a start of its own.

    Args:
        seen: the annotated points.
        field: the elements.
        frame: the picture.
        model: R2 or F.
        near: the best camera with one coefficient.
        fisheye: the best fisheye, if that is known already.
    """
    fisheyes = [_fisheye_vector_from(near.vector)]
    if fisheye is not None:
        fisheyes.append(fisheye.vector)
    for focal in _WIDE_ANGLE_FOCALS_PX if fisheye is None else ():
        found = search_camera(_undistort_as_fisheye(seen, focal), field, frame, "P")
        own = _fisheye_vector_from(found.vector)
        own[KAPPA] = own[SECOND_KAPPA] = 0.0
        assumed = own.copy()
        assumed[LOG_FOCAL] = np.log(focal)
        fisheyes += [own, assumed]
    starts = fisheyes if model == "F" else [_radial_vector_from(v, frame.half_diagonal) for v in fisheyes]
    if model == "R2":
        starts += [np.concatenate([near.vector[:SECOND_KAPPA], (0.0, 0.0)]) for _ in _COEFFICIENT_STARTS]
        for start, both in zip(starts[-len(_COEFFICIENT_STARTS) :], _COEFFICIENT_STARTS, strict=True):
            start[[KAPPA, SECOND_KAPPA]] = both
    return _best_wide_angle(seen, field, frame, np.array(starts))


def refine_wide_angle(
    seen: Observations, field: Field, frame: ImageFrame, start: FloatArray
) -> CameraSolution:
    """Fit a strong lens from parameters (13,) that are nearly right; stale if they are not."""
    around = camera_placement_prior(field)
    residuals = partial(pinhole_residuals, half_diagonal=frame.half_diagonal, free=_WIDE_ANGLE_FREE)
    seen = whitened(seen, linear_map(start))
    left_out = outlier_elements(seen, residuals(start[None], seen).distances[0])
    prior = prior_near(start, around, _WIDE_ANGLE_FREE)
    found = final_fit(seen, start[None], left_out, residuals, prior)
    return (
        found if found.has_stale_start or found.is_consistent else _best_wide_angle(seen, field, frame, start[None])
    )


def try_wide_angle(
    found: CameraSolution, seen: Observations, field: Field, frame: ImageFrame
) -> tuple[CameraSolution, str] | None:
    """A strong lens, and its model, if that explains the points clearly better; else None.

    Only a camera is doubted whose lines are bent, as only lenses of a wide angle do it, or that
    leaves several elements out.

    Args:
        found: of the model R+.
        seen: the annotated points.
        field: the elements.
        frame: the picture.
    """
    doubted = _has_bent_lines(seen) or found.left_out.sum() >= MANY_OUTLIERS
    if found.vector[KAPPA] >= 0 and not doubted:
        return None
    fisheye = fit_wide_angle(seen, field, frame, "F", found)
    fits = (fit_wide_angle(seen, field, frame, "R2", found, fisheye), "R2"), (fisheye, "F")
    around = camera_placement_prior(field)
    better = [
        fit for fit in fits if not implausible_reason(fit[0].vector, around) and wide_angle_explains_more(fit[0], found)
    ]
    return min(better, key=lambda fit: _wide_angle_cost(fit[0]), default=None)


def wide_angle_explains_more(strong: CameraSolution, plain: CameraSolution) -> bool:
    """Whether a strong lens leaves no more elements out than a camera with one coefficient, and
    costs clearly less."""
    saved = _wide_angle_cost(plain) - _wide_angle_cost(strong)
    better = saved > _WIDE_ANGLE_EVIDENCE * point_error_sd(strong) ** 2
    return bool(better and strong.left_out.sum() <= plain.left_out.sum())


def _best_wide_angle(seen: Observations, field: Field, frame: ImageFrame, starts: FloatArray) -> CameraSolution:
    """The strong lens that explains the points best, from (B, 13) that may lead to it."""
    around = camera_placement_prior(field)
    seen = whitened(seen, linear_map(starts[0]))
    residuals = partial(pinhole_residuals, half_diagonal=frame.half_diagonal)
    rows = [prior_near(start, around, _WIDE_ANGLE_FREE) for start in starts]
    prior = GaussianPrior(
        np.concatenate([row.mean for row in rows]), np.concatenate([row.inverse_sd for row in rows])
    )
    problem = Problem(partial(residuals, seen=seen, free=_WIDE_ANGLE_FREE), seen.weights, ROBUST_LOSS, prior)
    robust = solve(problem, starts, iterations=40, tolerance=1e-3)
    order = np.argsort(robust.costs, kind="stable").tolist()
    plausible = (i for i in order if not implausible_reason(robust.vectors[i], around))
    row = next(plausible, order[0])
    chosen = robust.vectors[[row]]
    left_out = outlier_elements(seen, robust.distances[row])
    near = prior_near(chosen[0], around, _WIDE_ANGLE_FREE)
    return final_fit(seen, chosen, left_out, partial(residuals, free=_WIDE_ANGLE_FREE), near)


def _undistort_as_fisheye(seen: Observations, focal: float) -> Observations:
    """The points as a lens without distortion would show them, had a fisheye shown these."""
    distance = np.hypot(*seen.points)
    angle = np.minimum(distance / focal, _MAX_ANGLE_RAD)
    grown = focal * np.tan(angle) / np.maximum(distance, 1e-9)
    return replace(seen, points=seen.points * grown)


def _fisheye_vector_from(vector: FloatArray) -> FloatArray:
    """(13,) the fisheye that looks as a camera of one coefficient does."""
    fisheye = np.concatenate([vector[:SECOND_KAPPA], (0.0, 1.0)])
    fisheye[KAPPA] = 0.0
    return fisheye


def single_coefficient_vector(vector: FloatArray) -> FloatArray:
    """(11,) the camera of one coefficient to look for one from, beside a strong lens (13,)."""
    plain = vector[:SECOND_KAPPA].copy()
    plain[KAPPA] = MIN_KAPPA / 2 if vector[FISHEYE_FLAG] else max(vector[KAPPA], MIN_KAPPA / 2)
    return plain


def _radial_vector_from(vector: FloatArray, half_diagonal: float) -> FloatArray:
    """(13,) the radial lens nearest to a fisheye."""
    radial = vector.copy()
    radial[FISHEYE_FLAG] = 0.0
    focal = np.exp(vector[LOG_FOCAL])
    t = np.linspace(_MAX_RADII / _STRAIGHTENING_SAMPLES, _MAX_RADII, _STRAIGHTENING_SAMPLES)
    angle = np.arctan2(t * half_diagonal, focal)
    bent = angle * (1 + vector[KAPPA] * angle**2 + vector[SECOND_KAPPA] * angle**4)
    shown = focal * bent / half_diagonal
    counted = 1 / (1 + t**4)  # nearer to the axis more of the picture lies
    columns = np.column_stack([t**3, t**5]) * counted[:, None]
    radial[[KAPPA, SECOND_KAPPA]] = np.linalg.lstsq(columns, (shown - t) * counted, rcond=None)[0]
    return radial


def _has_bent_lines(seen: Observations) -> bool:
    """Whether several straight elements are bent."""
    bent = 0
    for row, element in enumerate(seen.elements):
        points = seen.points[:, seen.element_of_point == row]
        if not element.is_straight or points.shape[1] < 3:
            continue
        ends = points[:, [0, -1]]
        along = ends[:, 1] - ends[:, 0]
        length = float(np.hypot(*along))
        off = points - ends[:, :1]
        beside = np.abs(along[0] * off[1] - along[1] * off[0]) / max(length, 1.0)
        bent += bool(beside.max() > _BENT_LINE_PX)
    return bent >= _MIN_BENT_ELEMENTS


def _wide_angle_cost(found: CameraSolution) -> float:
    """What a camera costs by all the points, those of the elements it leaves out too."""
    free = found.prior.mean.shape[1]
    off = (found.vector[:free] - found.prior.mean[0]) * found.prior.inverse_sd[0]
    losses = ROBUST_LOSS.cost_and_weight(found.distances)[0]
    return float(losses @ found.seen.weights + off @ off / 2)
