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
from procc_annotator.fit.solving.covariance import error_of_points
from procc_annotator.fit.solving.final_fit import FoundCamera, final_fit, mistakes
from procc_annotator.fit.solving.models import (
    FISHEYE,
    FREE,
    KAPPA,
    LEAST_KAPPA,
    LOG_FOCAL,
    SECOND,
)
from procc_annotator.fit.solving.noise import softened
from procc_annotator.fit.solving.observations import FloatArray, Observations, PictureFrame
from procc_annotator.fit.solving.plausible import objection
from procc_annotator.fit.solving.residual import linear_map, pinhole_residuals
from procc_annotator.fit.solving.search import search
from procc_annotator.fit.solving.solver import ROBUST_LOSS, Prior, Problem, solve
from procc_annotator.fit.solving.starts import prior_near
from procc_annotator.fit.solving.surroundings import surroundings_of

_FREE = FREE["R2"]
# Focal lengths, solver px, of the fisheyes that are tried; a picture is 960 px wide.
_FOCALS = (330.0, 480.0, 700.0)
_MOST_ANGLE_RAD = 1.4
# Where both coefficients of a radial lens are looked for beside a camera without them.
_COEFFICIENTS = ((0.0, 0.0), (-0.15, 0.02), (-0.35, 0.08))
# A fisheye's curve is made a radial one at so many places, up to so many half diagonals.
_PLACES, _MOST_RADII = 40, 2.5
# What a strong lens must explain, squares of the error of a point: 3 for each of two coefficients
# that its prior left open, and 3 for being twenty times as likely.
_WORTH = 9.0
# Straight elements clicked so far beside the line through their ends are bent by a strong lens.
_BENT_PX, _BENT_ELEMENTS = 6.0, 2
# Of so many elements that fit no camera together it is rather the camera that is not understood.
MANY_LEFT_OUT = 3


def fit_strong(
    seen: Observations,
    field: Field,
    frame: PictureFrame,
    model: str,
    near: FoundCamera,
    fisheye: FoundCamera | None = None,
) -> FoundCamera:
    """Fit a strong lens without a start of its own.

    Args:
        seen: the annotated points.
        field: the elements.
        frame: the picture.
        model: R2 or F.
        near: the best camera with one coefficient.
        fisheye: the best fisheye, if that is known already.
    """
    fisheyes = [_as_fisheye(near.vector)]
    if fisheye is not None:
        fisheyes.append(fisheye.vector)
    for focal in _FOCALS if fisheye is None else ():
        found = search(_straightened(seen, focal), field, frame, "P")
        own = _as_fisheye(found.vector)
        own[KAPPA] = own[SECOND] = 0.0
        assumed = own.copy()
        assumed[LOG_FOCAL] = np.log(focal)
        fisheyes += [own, assumed]
    starts = fisheyes if model == "F" else [_as_radial(v, frame.half_diagonal) for v in fisheyes]
    if model == "R2":
        starts += [np.concatenate([near.vector[:SECOND], (0.0, 0.0)]) for _ in _COEFFICIENTS]
        for start, both in zip(starts[-len(_COEFFICIENTS) :], _COEFFICIENTS, strict=True):
            start[[KAPPA, SECOND]] = both
    return _best(seen, field, frame, np.array(starts))


def refine_strong(
    seen: Observations, field: Field, frame: PictureFrame, start: FloatArray
) -> FoundCamera:
    """Fit a strong lens from parameters (13,) that are nearly right; stale if they are not."""
    around = surroundings_of(field)
    residuals = partial(pinhole_residuals, half_diagonal=frame.half_diagonal, free=_FREE)
    seen = softened(seen, linear_map(start))
    left_out = mistakes(seen, residuals(start[None], seen).distances[0])
    prior = prior_near(start, around, _FREE)
    found = final_fit(seen, start[None], left_out, residuals, prior)
    return (
        found if found.is_stale or found.is_consistent else _best(seen, field, frame, start[None])
    )


def perhaps_strong(
    found: FoundCamera, seen: Observations, field: Field, frame: PictureFrame
) -> tuple[FoundCamera, str] | None:
    """A strong lens, and its model, if that explains the points clearly better; else None.

    Only a camera is doubted whose lines are bent, as only lenses of a wide angle do it, or that
    leaves several elements out.

    Args:
        found: of the model R+.
        seen: the annotated points.
        field: the elements.
        frame: the picture.
    """
    doubted = _bends(seen) or found.left_out.sum() >= MANY_LEFT_OUT
    if found.vector[KAPPA] >= 0 and not doubted:
        return None
    fisheye = fit_strong(seen, field, frame, "F", found)
    fits = (fit_strong(seen, field, frame, "R2", found, fisheye), "R2"), (fisheye, "F")
    around = surroundings_of(field)
    better = [
        fit for fit in fits if not objection(fit[0].vector, around) and explains_more(fit[0], found)
    ]
    return min(better, key=lambda fit: _cost(fit[0]), default=None)


def explains_more(strong: FoundCamera, plain: FoundCamera) -> bool:
    """Whether a strong lens leaves no more elements out than a camera with one coefficient, and
    costs clearly less."""
    saved = _cost(plain) - _cost(strong)
    better = saved > _WORTH * error_of_points(strong) ** 2
    return bool(better and strong.left_out.sum() <= plain.left_out.sum())


def _best(seen: Observations, field: Field, frame: PictureFrame, starts: FloatArray) -> FoundCamera:
    """The strong lens that explains the points best, from (B, 13) that may lead to it."""
    around = surroundings_of(field)
    seen = softened(seen, linear_map(starts[0]))
    residuals = partial(pinhole_residuals, half_diagonal=frame.half_diagonal)
    rows = [prior_near(start, around, _FREE) for start in starts]
    prior = Prior(
        np.concatenate([row.mean for row in rows]), np.concatenate([row.inverse_sd for row in rows])
    )
    problem = Problem(partial(residuals, seen=seen, free=_FREE), seen.weights, ROBUST_LOSS, prior)
    robust = solve(problem, starts, iterations=40, tolerance=1e-3)
    order = np.argsort(robust.costs, kind="stable").tolist()
    plausible = (i for i in order if not objection(robust.vectors[i], around))
    row = next(plausible, order[0])
    chosen = robust.vectors[[row]]
    left_out = mistakes(seen, robust.distances[row])
    near = prior_near(chosen[0], around, _FREE)
    return final_fit(seen, chosen, left_out, partial(residuals, free=_FREE), near)


def _straightened(seen: Observations, focal: float) -> Observations:
    """The points as a lens without distortion would show them, had a fisheye shown these."""
    distance = np.hypot(*seen.points)
    angle = np.minimum(distance / focal, _MOST_ANGLE_RAD)
    grown = focal * np.tan(angle) / np.maximum(distance, 1e-9)
    return replace(seen, points=seen.points * grown)


def _as_fisheye(vector: FloatArray) -> FloatArray:
    """(13,) the fisheye that looks as a camera of one coefficient does."""
    fisheye = np.concatenate([vector[:SECOND], (0.0, 1.0)])
    fisheye[KAPPA] = 0.0
    return fisheye


def plain_lens_near(vector: FloatArray) -> FloatArray:
    """(11,) the camera of one coefficient to look for one from, beside a strong lens (13,)."""
    plain = vector[:SECOND].copy()
    plain[KAPPA] = LEAST_KAPPA / 2 if vector[FISHEYE] else max(vector[KAPPA], LEAST_KAPPA / 2)
    return plain


def _as_radial(vector: FloatArray, half_diagonal: float) -> FloatArray:
    """(13,) the radial lens nearest to a fisheye."""
    radial = vector.copy()
    radial[FISHEYE] = 0.0
    focal = np.exp(vector[LOG_FOCAL])
    t = np.linspace(_MOST_RADII / _PLACES, _MOST_RADII, _PLACES)
    angle = np.arctan2(t * half_diagonal, focal)
    bent = angle * (1 + vector[KAPPA] * angle**2 + vector[SECOND] * angle**4)
    shown = focal * bent / half_diagonal
    counted = 1 / (1 + t**4)  # nearer to the axis more of the picture lies
    columns = np.column_stack([t**3, t**5]) * counted[:, None]
    radial[[KAPPA, SECOND]] = np.linalg.lstsq(columns, (shown - t) * counted, rcond=None)[0]
    return radial


def _bends(seen: Observations) -> bool:
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
        bent += bool(beside.max() > _BENT_PX)
    return bent >= _BENT_ELEMENTS


def _cost(found: FoundCamera) -> float:
    """What a camera costs by all the points, those of the elements it leaves out too."""
    free = found.prior.mean.shape[1]
    off = (found.vector[:free] - found.prior.mean[0]) * found.prior.inverse_sd[0]
    losses = ROBUST_LOSS.cost_and_weight(found.distances)[0]
    return float(losses @ found.seen.weights + off @ off / 2)
