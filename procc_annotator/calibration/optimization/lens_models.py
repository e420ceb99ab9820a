"""Further lens models where the points demand one: negative k1, off-centre principal point,
wide angle, fisheye.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.camera_parameters import (
    FISHEYE_FLAG,
    FREE_PARAMETERS,
    KAPPA,
    LOG_FOCAL,
    MIN_KAPPA,
    PAN,
    PRINCIPAL_X,
    SECOND_KAPPA,
    TILT,
)
from procc_annotator.calibration.optimization.camera_placement import (
    implausible_reason,
)
from procc_annotator.calibration.optimization.covariance import point_error_sd
from procc_annotator.calibration.optimization.initialization import (
    CENTRE_SD,
    CROPPED_CENTRE_SD,
    camera_side,
    prior_near,
    wide_prior,
)
from procc_annotator.calibration.optimization.observations import Observations
from procc_annotator.calibration.optimization.residuals import (
    linear_map,
    whitened,
)
from procc_annotator.calibration.optimization.robust_fit import (
    CameraSolution,
    FitScene,
    final_fit,
    outlier_elements,
    search_cameras,
)
from procc_annotator.calibration.optimization.solver import (
    FINAL_LOSS,
    ROBUST_LOSS,
    GaussianPrior,
    Problem,
    solve,
)

# Where the coefficient is looked for.
_NEGATIVE_K1_STARTS = (-0.01, -0.05)
# What it must explain, squares of the error of a point: 3 for what the prior leaves open, and 3 for
# being twenty times as likely as no distortion.
_NEGATIVE_K1_EVIDENCE = 6.0


def try_negative_k1(found: CameraSolution, scene: FitScene) -> CameraSolution:
    """The same camera (R or R+), or one with barrel distortion if that explains the points of the
    scene clearly better."""
    if found.vector[KAPPA] != 0 or _predicted_gain(found, scene) < _NEGATIVE_K1_EVIDENCE / 2:
        return found
    free = found.prior.mean.shape[1]
    starts = np.tile(found.vector, (len(_NEGATIVE_K1_STARTS), 1))
    starts[:, KAPPA] = _NEGATIVE_K1_STARTS
    prior = prior_near(found.vector, scene.around, free)
    scene = scene._replace(seen=found.seen)
    other = _best_fit(scene, starts, prior, prior, bounded=KAPPA)
    better = other.vector[KAPPA] < 0 and _explains_more(other, found, scene, _NEGATIVE_K1_EVIDENCE)
    return other if better else found


def is_negative_k1_supported(found: CameraSolution) -> bool:
    """Return whether the points still demand the barrel distortion that a camera was started with,
    by how surely its coefficient is not 0; true of a camera without."""
    if found.vector[KAPPA] >= 0:
        return True
    saved = float(found.vector[KAPPA]) ** 2 / _k1_variance(found) / 2
    return saved > _NEGATIVE_K1_EVIDENCE * point_error_sd(found) ** 2


def _explains_more(
    other: CameraSolution, found: CameraSolution, scene: FitScene, evidence: float
) -> bool:
    """Return whether a camera is plausible, leaves out no more elements than another one, and
    costs less by at least ``evidence``, squares of the error of a point."""
    if implausible_reason(other.vector, scene.around):
        return False
    saved = found.robust_cost - other.robust_cost
    clearly = saved > evidence * point_error_sd(other) ** 2
    return bool(clearly and other.left_out.sum() <= found.left_out.sum())


def _best_fit(
    scene: FitScene,
    starts: FloatArray,
    prior: GaussianPrior,
    final_prior: GaussianPrior | None = None,
    *,
    bounded: int | None = None,
    iterations: int = 20,
    hopeless: float = np.inf,
) -> CameraSolution:
    """Descend robustly from (B, n) starts, and fit the best of them to the elements near it.

    Args:
        prior: of each start, or of all.
        final_prior: of the final fit; None for `prior_near` the best one.
        bounded, iterations, hopeless: see `SolveRequest`.
    """
    seen, around, free = scene.seen, scene.around, prior.mean.shape[1]
    residuals = scene.residuals(free)
    problem = Problem(partial(residuals, seen=seen), seen.weights, ROBUST_LOSS, prior, bounded)
    robust = solve(problem, starts, iterations=iterations, tolerance=1e-3, hopeless=hopeless)
    order = np.argsort(robust.costs, kind="stable").tolist()
    plausible = (i for i in order if not implausible_reason(robust.vectors[i], around))
    row = next(plausible, order[0])
    chosen = robust.vectors[[row]]
    left_out = outlier_elements(seen, robust.distances[row])
    near = prior_near(chosen[0], around, free) if final_prior is None else final_prior
    return final_fit(seen, chosen, left_out, residuals, near)


def _predicted_gain(found: CameraSolution, scene: FitScene) -> float:
    """Return what a step of the coefficient below 0 promises to save, squares of the error of a
    point."""
    free = found.prior.mean.shape[1]
    seen = found.seen.with_excluded(found.left_out)
    at = scene.residuals(free)(found.vector[None], seen)
    weights = FINAL_LOSS.cost_and_weight(at.distances)[1][0] * seen.weights
    weighted = at.derivatives[0] * weights
    slope = float((weighted[KAPPA] * at.values[0]).sum())
    if slope <= 0:
        return 0.0
    return slope**2 * _k1_variance(found) / 2 / point_error_sd(found) ** 2


def _k1_variance(found: CameraSolution) -> float:
    """Of the coefficient, the other parameters following it, where points have an error of 1 px."""
    normal = found.solution.normal[0] + np.diag(found.prior.inverse_sd[0] ** 2)
    return float(np.linalg.inv(normal)[KAPPA, KAPPA])


_CROPPED_FREE = FREE_PARAMETERS["R+"]
# Where the principal point is looked for, px from where a whole picture has it.
_CROPPED_CENTRE_STARTS_PX = ((0.0, 0.0), (-450.0, 0.0), (450.0, 0.0), (0.0, -250.0), (0.0, 250.0))
# A whole picture's camera leaves nothing out, is off by no more, and its principal point lies near.
_GOOD_FIT_PX, _CENTRED_PX = 1.0, 2 * CENTRE_SD
# What a principal point anywhere must save, px^2: ln(300 / 25) for each of two coordinates, whose
# prior is so much wider, at an error of about 1 px.
_CROPPED_EVIDENCE = 6.0
# The same against barrel distortion, whose coefficient the points have determined as well.
_CROPPED_OVER_NEGATIVE_K1_EVIDENCE = 3.0


def try_cropped(found: CameraSolution, scene: FitScene) -> CameraSolution:
    """The same camera (R+), or one with its principal point elsewhere if that explains the points.

    Only a camera is doubted that leaves elements out, lies off the points, strains for the
    principal point, or has barrel distortion; and only one is taken instead that leaves fewer out
    and costs clearly less.
    """
    if is_cropped(found) or not _is_poor_fit(found):
        return found
    side = np.array([camera_side(found.vector, scene.around)])
    prior = wide_prior(side, scene.around, _CROPPED_FREE, centre_sd=CROPPED_CENTRE_SD)
    scene, starts = scene._replace(seen=found.seen), _cropped_starts(found.vector)
    other = _best_fit(scene, starts, prior, prior, bounded=KAPPA, hopeless=3.0)
    worth = _CROPPED_OVER_NEGATIVE_K1_EVIDENCE if found.vector[KAPPA] < 0 else _CROPPED_EVIDENCE
    return other if _explains_more(other, found, scene, worth) else found


def is_cropped(found: CameraSolution) -> bool:
    """Return whether a camera of the model R+ was fitted as one of a picture cut out of a larger
    one."""
    return bool(found.prior.inverse_sd[0, PRINCIPAL_X] < 1 / CENTRE_SD)


def _cropped_starts(vector: FloatArray) -> FloatArray:
    """(B, 11) the camera itself, and with its principal point elsewhere, looking the same way."""
    vectors = np.tile(vector, (len(_CROPPED_CENTRE_STARTS_PX), 1))
    focal = np.exp(vector[LOG_FOCAL])
    moved = np.array(_CROPPED_CENTRE_STARTS_PX)
    vectors[:, PRINCIPAL_X:] += moved
    # Of barrel distortion and another principal point one is enough.
    vectors[:, KAPPA] = max(float(vector[KAPPA]), 0.0)
    # What appears in the middle of the picture stays there.
    vectors[:, PAN] += np.arctan2(moved[:, 0], focal)
    vectors[:, TILT] -= np.arctan2(moved[:, 1], focal)
    return vectors


def _is_poor_fit(found: CameraSolution) -> bool:
    if found.vector[KAPPA] < 0:
        return True
    if np.abs(found.vector[PRINCIPAL_X:]).max() > _CENTRED_PX or found.left_out.any():
        return True
    return float(found.distances.mean()) > _GOOD_FIT_PX


_WIDE_ANGLE_FREE = FREE_PARAMETERS["R2"]
# Focal lengths, solver px, of the fisheyes that are tried; a picture is 960 px wide.
_WIDE_ANGLE_FOCALS_PX = (330.0, 480.0, 700.0)
_MAX_ANGLE_RAD = 1.4
# Where both coefficients of a radial lens are looked for next to a camera without them.
_COEFFICIENT_STARTS = ((0.0, 0.0), (-0.15, 0.02), (-0.35, 0.08))
# A fisheye's curve is made a radial one at so many places, up to so many half diagonals.
_STRAIGHTENING_SAMPLES, _MAX_RADII = 40, 2.5
# What a strong lens must explain, squares of the error of a point: 3 for each of two coefficients
# that its prior left open, and 3 for being twenty times as likely.
_WIDE_ANGLE_EVIDENCE = 9.0
# Straight elements clicked so far next to the line through their ends are bent by a strong lens.
_BENT_LINE_PX, _MIN_BENT_ELEMENTS = 6.0, 2
# Of so many elements that fit no camera together it is rather the camera that is not understood.
MANY_OUTLIERS = 3


def fit_wide_angle(
    scene: FitScene,
    model: str,
    near: CameraSolution,
    fisheye: CameraSolution | None = None,
) -> CameraSolution:
    """Fit R2 or F without a start of its own, near the best camera with one coefficient;
    ``fisheye`` is the best fisheye, if that is known already."""
    fisheyes = [_fisheye_vector_from(near.vector)]
    if fisheye is not None:
        fisheyes.append(fisheye.vector)
    for focal in _WIDE_ANGLE_FOCALS_PX if fisheye is None else ():
        straight = scene._replace(seen=_undistort_as_fisheye(scene.seen, focal))
        found = search_cameras([straight], "P")[0]
        own = _fisheye_vector_from(found.vector)
        own[KAPPA] = own[SECOND_KAPPA] = 0.0
        assumed = own.copy()
        assumed[LOG_FOCAL] = np.log(focal)
        fisheyes += [own, assumed]
    starts = (
        fisheyes
        if model == "F"
        else [_radial_vector_from(v, scene.frame.half_diagonal) for v in fisheyes]
    )
    if model == "R2":
        starts += [
            np.concatenate([near.vector[:SECOND_KAPPA], (0.0, 0.0)]) for _ in _COEFFICIENT_STARTS
        ]
        for start, both in zip(
            starts[-len(_COEFFICIENT_STARTS) :], _COEFFICIENT_STARTS, strict=True
        ):
            start[[KAPPA, SECOND_KAPPA]] = both
    return _best_wide_angle(scene, np.array(starts))


def refine_wide_angle(scene: FitScene, start: FloatArray) -> CameraSolution:
    """Fit a strong lens from parameters (13,) that are nearly right; stale if they are not."""
    residuals = scene.residuals(_WIDE_ANGLE_FREE)
    seen = whitened(scene.seen, linear_map(start))
    left_out = outlier_elements(seen, residuals(start[None], seen).distances[0])
    prior = prior_near(start, scene.around, _WIDE_ANGLE_FREE)
    found = final_fit(seen, start[None], left_out, residuals, prior)
    return (
        found
        if found.has_stale_start or found.is_consistent
        else _best_wide_angle(scene, start[None])
    )


def try_wide_angle(found: CameraSolution, scene: FitScene) -> tuple[CameraSolution, str] | None:
    """A wide angle or fisheye lens, and its model, if that explains the points clearly better than
    a camera R+; else None.

    Only a camera is doubted whose lines are bent, as only lenses of a wide angle do it, or that
    leaves several elements out.
    """
    doubted = _has_bent_lines(scene.seen) or found.left_out.sum() >= MANY_OUTLIERS
    if found.vector[KAPPA] >= 0 and not doubted:
        return None
    fisheye = fit_wide_angle(scene, "F", found)
    fits = (fit_wide_angle(scene, "R2", found, fisheye), "R2"), (fisheye, "F")
    better = [fit for fit in fits if wide_angle_explains_more(fit[0], found, scene)]
    return min(better, key=lambda fit: fit[0].robust_cost, default=None)


def wide_angle_explains_more(
    strong: CameraSolution, plain: CameraSolution, scene: FitScene
) -> bool:
    """Return whether a strong lens explains the points clearly better than one coefficient."""
    return _explains_more(strong, plain, scene, _WIDE_ANGLE_EVIDENCE)


def _best_wide_angle(scene: FitScene, starts: FloatArray) -> CameraSolution:
    """The strong lens that explains the points best, from (B, 13) that may lead to it."""
    rows = [prior_near(start, scene.around, _WIDE_ANGLE_FREE) for start in starts]
    prior = GaussianPrior(
        np.concatenate([row.mean for row in rows]), np.concatenate([row.inverse_sd for row in rows])
    )
    scene = scene._replace(seen=whitened(scene.seen, linear_map(starts[0])))
    return _best_fit(scene, starts, prior, iterations=40)


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
    """(11,) the camera of one coefficient to look for one from, next to a strong lens (13,)."""
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
