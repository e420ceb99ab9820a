"""Posterior of two standard deviations: of independent click errors, and of errors that all points
of an element share (random effects)."""

from __future__ import annotations

import numpy as np

from procc_annotator.arrays import FloatArray

# Log-normal priors: median and standard deviation of the logarithm. Clicks by people, by trackers
# of lines and on small pictures have 0.3 to 2.5 px: well within one deviation.
_CLICK_PRIOR_PX = (0.7, 1.0)
_SHARED_PRIOR = (1.0, 0.5)
# Elements may as well lie where the model has them, as drawn ones do.
_NO_SHARED_PROBABILITY = 0.6
_CLICKS_PX = np.geomspace(0.1, 8.0, 24)
# Of the standard deviation of shared errors to that of clicks.
_RATIOS = np.concatenate([[0.0], np.geomspace(0.05, 12.0, 10)])
_TINY, _RIDGE = 1e-12, 1e-9


def posterior_deviations(
    values: FloatArray,
    slopes: FloatArray,
    axes: FloatArray,
    squares: FloatArray,
    mean: FloatArray,
    precision: FloatArray,
) -> tuple[float, float, float]:
    """Return the roots of the posterior means of both variances.

    The likelihood of the residuals has the parameters integrated out (Laplace's approximation, as
    in restricted maximum likelihood); it is summed over a grid.

    Args:
        values: (N,) residuals; those that do not count are 0, as are their derivatives.
        slopes: (n, N) their derivatives by the parameters.
        axes: (N, K) orthonormal directions of the shared errors.
        squares: (K,) variances along these where the shared standard deviation is 1.
        mean: (n,) of the parameters' prior, from where the residuals are.
        precision: (n,) of that prior.

    Returns:
        Standard deviations of clicks, px, of shared errors, and of these if there are any.
    """
    ratios = _RATIOS[:, None] ** 2 * squares
    taken = ratios / (1 + ratios)
    along, slopes_along = values @ axes, slopes @ axes
    normal = slopes @ slopes.T - (slopes_along * taken[:, None]) @ slopes_along.T
    gradient = slopes @ values - (taken * along) @ slopes_along.T
    square = values @ values - taken @ along**2
    # Data and prior diagonal at once: data 1 - m, prior m, for every standard deviation of clicks.
    information = normal + np.diag(precision)
    factor = np.linalg.cholesky(information + _RIDGE * information * np.eye(len(mean)))
    inverse = np.linalg.inv(factor)
    share, turn = np.linalg.eigh((inverse * precision) @ inverse.transpose(0, 2, 1))
    turn = turn.transpose(0, 2, 1) @ inverse
    by_prior, by_data = turn @ (precision * mean), (turn @ gradient[:, :, None])[:, :, 0]
    scale = 1 / _CLICKS_PX[:, None, None] ** 2
    width = np.maximum((1 - share) * scale + share, _TINY)
    explained = ((by_prior - scale * by_data) ** 2 / width).sum(axis=2)
    cost = scale[:, :, 0] * square + mean @ (precision * mean) - explained
    cost += np.log(width).sum(axis=2) + 2 * np.log(np.einsum("jii->ji", factor)).sum(axis=1)
    count = int((slopes != 0).any(axis=0).sum())
    cost += 2 * count * np.log(_CLICKS_PX)[:, None] + np.log1p(ratios).sum(axis=1)
    return (
        _posterior_root(cost, _CLICKS_PX[:, None] ** 2),
        _posterior_root(cost, _SHARED**2),
        _posterior_root(cost[:, 1:], _SHARED[:, 1:] ** 2),
    )


def _posterior_root(cost: FloatArray, squares: FloatArray) -> float:
    weight = _PRIOR[:, -cost.shape[1] :] * np.exp((cost.min() - cost) / 2)
    return float(np.sqrt((weight * squares).sum() / weight.sum()))


def _prior() -> FloatArray:
    (click_px, click_sd), (usual, shared_sd) = _CLICK_PRIOR_PX, _SHARED_PRIOR
    apart = np.log(_SHARED[:, 1:] / usual) / shared_sd
    step = np.log(_RATIOS[-1] / _RATIOS[-2]) / (shared_sd * np.sqrt(2 * np.pi))
    masses = (1 - _NO_SHARED_PROBABILITY) * step * np.exp(-(apart**2) / 2)
    masses = np.concatenate([np.full((len(masses), 1), _NO_SHARED_PROBABILITY), masses], axis=1)
    clicks = np.exp(-((np.log(_CLICKS_PX / click_px) / click_sd) ** 2) / 2)
    return np.asarray(clicks[:, None] * masses)


_SHARED = np.outer(_CLICKS_PX, _RATIOS)
_PRIOR = _prior()
