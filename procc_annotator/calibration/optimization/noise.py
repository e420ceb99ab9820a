"""Noise model of annotated points: independent click errors, and errors that all points of an
element share (random effects), estimated from the residuals of a frame."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.observations import Observations
from procc_annotator.calibration.optimization.residuals import PRIOR_CLICK_SD_PX, Residuals

# Standard deviations of what all points of an element share where `shared` is 1: its place on the
# ground, m, along x and y (lines are about 0.12 m wide, and are clicked anywhere on them), and its
# distance across from the model, solver px (lens errors). The pair, and the prior of `shared`, have
# the largest marginal likelihood on one half of the frames of World Cup 2014 (docs/fitting.md).
SHARED_SD_M, SHARED_SD_PX = 0.04, 0.3
# How often the variance of what the elements of a fit share is that of one that took no part: few
# lie far off, as with a t distribution of three degrees of freedom.
NEW_ELEMENT_VARIANCE = 3.5
# Log-normal priors: median and standard deviation of the logarithm. Clicks by people, by trackers
# of lines and on small pictures have 0.3 to 2.5 px; the prior covers these within one and a half.
_CLICK_PRIOR_PX = (PRIOR_CLICK_SD_PX, 1.0)
_SHARED_PRIOR = (1.0, 0.5)
# Elements may as well lie where the model has them, as drawn ones do.
_NO_SHARED_PROBABILITY = 0.4
_SHARED_GRID = np.array([0.0, 0.5, 1.0, 1.7, 3.0])
_COARSE_CLICKS_PX = np.geomspace(0.2, 6.0, 5)
_FINE_CLICKS = np.linspace(-2.0, 2.0, 5)  # standard deviations of the coarse posterior
_MIN_LOG_SD = 0.2  # of that posterior, which the coarse grid cannot resolve
_MIN_ROBUST_SD_PX, _MIN_SPARE_ROWS = 0.3, 4
# What a model does not know shows outside of the points: with the prior weighed by less, cameras R+
# predict fewer held-out elements of World Cup 2014 within 5 px (95.3 % by the clicks' own error).
MIN_COUNTED_PX = 1.0
# Standard deviations beyond which a point counts less and less (Huber).
HUBER_SD = 2.0
_TINY, _RIDGE = 1e-12, 1e-9


@dataclass(frozen=True, eq=False)
class PointNoise:
    """Noise of annotated points.

    Attributes:
        click_px: standard deviation of a point across its element, solver px.
        shared: standard deviation of what all points of an element share, in units of
            `SHARED_SD_M` and `SHARED_SD_PX`.
        scatter: (n, n) covariance of the gradient by the n free parameters that both cause, solver
            px squared times the squares of the derivatives.
    """

    click_px: float
    shared: float
    scatter: FloatArray

    @property
    def counted_px(self) -> float:
        """Standard deviation of a point that the prior is weighed with, solver px."""
        return max(self.click_px, MIN_COUNTED_PX)


def estimate_noise(
    found: Residuals,
    displacements: FloatArray,
    seen: Observations,
    prior_mean: FloatArray,
    prior_inverse_sd: FloatArray,
) -> PointNoise:
    """Noise of a frame's points: means of the posterior of both variances.

    The marginal likelihood of the residuals, the camera integrated out near the one given
    (Laplace's approximation, as in restricted maximum likelihood), on a grid of both standard
    deviations. Points far off count less (Huber), at a scale from the median of the residuals.

    Args:
        found: of one camera that is nearly right, with derivatives by the n free parameters.
        displacements: (2, 2, N) derivatives of the residuals by moves of the elements along x and
            y, solver px per metre.
        seen: the points, with their weights; those of weight 0 have no say.
        prior_mean: (n,) of the prior, less the parameters of the camera.
        prior_inverse_sd: (n,) its inverse standard deviations.
    """
    distances, counted = found.distances[0], seen.weights > 0
    rows = np.stack([counted, counted & found.whole[0]])
    free, count = found.derivatives.shape[1], int(rows.sum())
    typical = 1.4826 * float(np.median(distances[counted]))
    typical *= np.sqrt(count / max(count - free, _MIN_SPARE_ROWS))
    huber = HUBER_SD * max(typical, _MIN_ROBUST_SD_PX)
    roots = rows * np.sqrt(np.minimum(1.0, huber / np.maximum(distances, _TINY)))
    effects = _shared_effects(found, displacements)
    axes, squares = _orthonormal(effects * roots, seen)
    values = (found.values[0] * roots).reshape(-1)
    slopes = (found.derivatives[0] * roots).reshape(free, -1)
    likelihood = _MarginalLikelihood(
        values @ values, slopes @ values, slopes @ slopes.T, values @ axes, slopes @ axes, squares,
        count, prior_mean, prior_inverse_sd**2,
    )  # fmt: skip
    logs, weight = np.log(_COARSE_CLICKS_PX), likelihood.posterior(_COARSE_CLICKS_PX)
    middle = float(weight.sum(axis=1) @ logs)
    spread = float(np.sqrt(weight.sum(axis=1) @ (logs - middle) ** 2))
    clicks = np.exp(middle + max(spread, _MIN_LOG_SD) * _FINE_CLICKS)
    weight = likelihood.posterior(clicks)
    click_px = float(np.sqrt(weight.sum(axis=1) @ clicks**2))
    shared = float(np.sqrt(weight.sum(axis=0) @ _SHARED_GRID**2))
    weights = seen.weights * np.minimum(
        1.0, HUBER_SD * max(click_px, 1.0) / np.maximum(distances, _TINY)
    )
    pulls = found.derivatives[0] * (rows * weights)
    of_elements = np.add.reduceat(
        np.einsum("prn,irn->pin", pulls, effects), seen.starts, axis=2
    ).reshape(free, -1)
    pulls = pulls.reshape(free, -1)
    scatter = click_px**2 * pulls @ pulls.T + shared**2 * of_elements @ of_elements.T
    return PointNoise(click_px, shared, scatter)


def _shared_effects(found: Residuals, displacements: FloatArray) -> FloatArray:
    """(3, 2, N) what an element's own errors along x, y, m, and across, px, add to its points."""
    along = found.along[0]
    length = np.hypot(along[0], along[1])
    has_side = length > _TINY
    # At a true end both components count, along the picture's axes.
    turned = found.whole[0] & has_side
    unit = np.where(has_side, length, 1.0)
    across = np.stack(
        [np.where(turned, -along[1] / unit, has_side), np.where(turned, along[0] / unit, 0.0)]
    )
    return np.concatenate([SHARED_SD_M * displacements, SHARED_SD_PX * across[None]])


def _orthonormal(effects: FloatArray, seen: Observations) -> tuple[FloatArray, FloatArray]:
    """Effects (3, 2, N) as orthonormal axes of the elements (2 N, 3 E), and squares (3 E,)."""
    products = np.einsum("irn,jrn->ijn", effects, effects)
    gram = np.add.reduceat(products, seen.starts, axis=2).transpose(2, 0, 1)
    squares, turns = np.linalg.eigh(gram)
    squares = np.where(squares > 1e-9 * (squares[:, -1:] + _TINY), squares, 0.0)
    turns = turns / np.sqrt(np.where(squares > 0, squares, np.inf))[:, None]
    points, elements = seen.points.shape[1], len(seen.elements)
    axes = np.zeros((2, points, elements, 3))
    own = np.einsum("irn,nia->rna", effects, turns[seen.element_of_point])
    axes[:, np.arange(points), seen.element_of_point] = own
    return axes.reshape(2 * points, -1), squares.reshape(-1)


@dataclass(frozen=True, eq=False)
class _MarginalLikelihood:
    """Sums over residuals, with n derivatives and K axes, that their likelihood needs."""

    square: float
    gradient: FloatArray  # (n,)
    normal: FloatArray  # (n, n)
    values_along: FloatArray  # (K,)
    slopes_along: FloatArray  # (n, K)
    squares: FloatArray  # (K,)
    count: int
    mean: FloatArray  # (n,) of the prior, from where the residuals are
    precision: FloatArray  # (n,)

    def posterior(self, clicks: FloatArray) -> NDArray[np.float64]:
        """(C, S) probabilities of the standard deviations of clicks (C,) and of shared errors."""
        click, shared = (g.reshape(-1) for g in np.meshgrid(clicks, _SHARED_GRID, indexing="ij"))
        ratio = np.outer((shared / click) ** 2, self.squares)
        taken = ratio / (1 + ratio)
        scale = 1 / click**2
        reduced = self.normal - (self.slopes_along * taken[:, None]) @ self.slopes_along.T
        normal = scale[:, None, None] * reduced
        slope = scale[:, None] * (self.gradient - (taken * self.values_along) @ self.slopes_along.T)
        square = scale * (self.square - taken @ self.values_along**2)
        pull = self.precision * self.mean - slope
        # Of the information, bordered by the pull and the cost, the factor's last entry is the root
        # of the least cost.
        bordered = np.empty((len(click), len(pull[0]) + 1, len(pull[0]) + 1))
        bordered[:, :-1, :-1] = normal + np.diag(self.precision)
        bordered[:, :-1, -1] = bordered[:, -1, :-1] = pull
        bordered[:, -1, -1] = square + self.precision @ self.mean**2
        diagonal = np.einsum("gii->gi", bordered)
        diagonal *= 1 + _RIDGE
        diagonal += _TINY
        factor = np.einsum("gii->gi", np.linalg.cholesky(bordered))
        cost = factor[:, -1] ** 2
        width = 2 * np.log(factor[:, :-1]).sum(axis=1) + 2 * self.count * np.log(click)
        logs = -(cost + width + np.log1p(ratio).sum(axis=1)) / 2 + _log_prior(click, shared)
        found = np.exp(logs - logs.max()).reshape(len(clicks), -1)
        return np.asarray(found / found.sum())


def _log_prior(click: FloatArray, shared: FloatArray) -> FloatArray:
    (click_px, click_sd), (usual, shared_sd) = _CLICK_PRIOR_PX, _SHARED_PRIOR
    positive = _SHARED_GRID[1:]
    mass = np.exp(-((np.log(positive / usual) / shared_sd) ** 2) / 2)
    mass = (1 - _NO_SHARED_PROBABILITY) * mass / mass.sum()
    masses = np.concatenate([[_NO_SHARED_PROBABILITY], mass])
    of_shared = np.log(masses)[np.searchsorted(_SHARED_GRID, shared)]
    return np.asarray(of_shared - (np.log(click / click_px) / click_sd) ** 2 / 2)
