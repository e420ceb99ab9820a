"""From where frames were taken, told from the positions their own fits found."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import FloatArray, IntArray

# Positions found for one tripod differ by more than the points' errors explain: lens and field are
# never quite the model's. On World Cup frames by such shares of the way to the field's centre,
# along the ground (1 m) and in height.
POSITION_TOLERANCE_SHARE = (0.016, 0.016, 0.005)
# What of that frames have in common that look the same way: more of them do not average it out.
SHARED_ERROR_SHARE = (0.011, 0.011, 0.003)
# Chi squared of 3 degrees of freedom, one in a thousand.
MAX_SQUARED_DISTANCE = 16.3
MIN_FRAMES = 3


@dataclass(frozen=True, eq=False)
class PositionCluster:
    """A position that several frames agree on.

    Attributes:
        position: (3,) metres.
        covariance: (3, 3) of it, metres squared.
        members: (n,) indices of the frames.
    """

    position: FloatArray
    covariance: FloatArray
    members: IntArray


def cluster_positions(
    positions: FloatArray, covariances: FloatArray, reach: float
) -> tuple[PositionCluster, ...]:
    """The positions that frames agree on, the one with most frames first.

    Frames, then groups of them, are joined two by two, those whose mean positions differ least for
    how surely they are known, until no two are left that may be the same. Groups of fewer than
    three frames are no agreement.

    Args:
        positions: (F, 3) metres, of the frames' own fits.
        covariances: (F, 3, 3) metres squared.
        reach: metres from the usual camera to the field's centre.
    """
    if not len(positions):
        return ()
    groups = [[i] for i in range(len(positions))]
    means = positions.copy()
    spreads = covariances + _tolerance_covariance(POSITION_TOLERANCE_SHARE, reach)
    common = _tolerance_covariance(SHARED_ERROR_SHARE, reach)
    apart = np.array([_squared_mahalanobis(means, spreads, i, common) for i in range(len(means))])
    np.fill_diagonal(apart, np.inf)
    alive = np.ones(len(means), dtype=bool)
    while True:
        one, other = divmod(int(np.argmin(apart)), len(means))
        if not apart[one, other] <= MAX_SQUARED_DISTANCE:
            break
        groups[one] += groups[other]
        means[one], spreads[one] = _merge_estimates(means[[one, other]], spreads[[one, other]])
        alive[other] = False
        apart[other], apart[:, other] = np.inf, np.inf
        row = np.where(alive, _squared_mahalanobis(means, spreads, one, common), np.inf)
        row[one] = np.inf
        apart[one], apart[:, one] = row, row
    found = [
        PositionCluster(means[i], spreads[i] + common, np.array(sorted(groups[i])))
        for i in np.flatnonzero(alive)
        if len(groups[i]) >= MIN_FRAMES
    ]
    return tuple(sorted(found, key=lambda place: -len(place.members)))


def is_compatible_position(
    position: FloatArray,
    covariance: FloatArray,
    positions: FloatArray,
    covariances: FloatArray,
    reach: float,
) -> NDArray[np.bool_]:
    """(F,) whether a position may be that of each of some frames, for how surely they are known.

    Args:
        position: (3,) metres.
        covariance: (3, 3) of it, metres squared.
        positions: (F, 3) metres.
        covariances: (F, 3, 3) metres squared.
        reach: metres from the usual camera to the field's centre.
    """
    means = np.concatenate([position[None], positions])
    spreads = np.concatenate([covariance[None], covariances]) + _tolerance_covariance(POSITION_TOLERANCE_SHARE, reach)
    return np.asarray(_squared_mahalanobis(means, spreads, 0, _tolerance_covariance(SHARED_ERROR_SHARE, reach))[1:] <= MAX_SQUARED_DISTANCE)


def _tolerance_covariance(shares: tuple[float, float, float], reach: float) -> FloatArray:
    return np.diag((np.array(shares) * reach) ** 2)


def _squared_mahalanobis(means: FloatArray, spreads: FloatArray, one: int, common: FloatArray) -> FloatArray:
    """(K,) squared distances to one of K groups, in standard deviations of the difference."""
    off = means - means[one]
    solved = np.linalg.solve(spreads + spreads[one] + common, off[:, :, None])[:, :, 0]
    return np.asarray((off * solved).sum(axis=1))


def _merge_estimates(means: FloatArray, spreads: FloatArray) -> tuple[FloatArray, FloatArray]:
    inverse = np.linalg.inv(spreads)
    spread = np.linalg.inv(inverse.sum(axis=0))
    return spread @ np.einsum("gij,gj->i", inverse, means), spread
