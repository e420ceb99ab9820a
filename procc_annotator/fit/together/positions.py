"""From where frames were taken, told from the positions their own fits found."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.fit.solving.observations import FloatArray, IntArray

# Positions found for one tripod differ by more than the points' errors explain: lens and field are
# never quite the model's. On World Cup frames by such shares of the way to the field's centre,
# along the ground (1 m) and in height.
SLACK = (0.016, 0.016, 0.005)
# What of that frames have in common that look the same way: more of them do not average it out.
COMMON = (0.011, 0.011, 0.003)
# Chi squared of 3 degrees of freedom, one in a thousand.
MOST_APART = 16.3
LEAST_FRAMES = 3


@dataclass(frozen=True, eq=False)
class CameraPlace:
    """A position that several frames agree on.

    Attributes:
        position: (3,) metres.
        covariance: (3, 3) of it, metres squared.
        members: (n,) indices of the frames.
    """

    position: FloatArray
    covariance: FloatArray
    members: IntArray


def find_positions(
    positions: FloatArray, covariances: FloatArray, reach: float
) -> tuple[CameraPlace, ...]:
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
    spreads = covariances + _slack(SLACK, reach)
    common = _slack(COMMON, reach)
    apart = np.array([_between(means, spreads, i, common) for i in range(len(means))])
    np.fill_diagonal(apart, np.inf)
    alive = np.ones(len(means), dtype=bool)
    while True:
        one, other = divmod(int(np.argmin(apart)), len(means))
        if not apart[one, other] <= MOST_APART:
            break
        groups[one] += groups[other]
        means[one], spreads[one] = _joined(means[[one, other]], spreads[[one, other]])
        alive[other] = False
        apart[other], apart[:, other] = np.inf, np.inf
        row = np.where(alive, _between(means, spreads, one, common), np.inf)
        row[one] = np.inf
        apart[one], apart[:, one] = row, row
    found = [
        CameraPlace(means[i], spreads[i] + common, np.array(sorted(groups[i])))
        for i in np.flatnonzero(alive)
        if len(groups[i]) >= LEAST_FRAMES
    ]
    return tuple(sorted(found, key=lambda place: -len(place.members)))


def agree_with(
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
    spreads = np.concatenate([covariance[None], covariances]) + _slack(SLACK, reach)
    return np.asarray(_between(means, spreads, 0, _slack(COMMON, reach))[1:] <= MOST_APART)


def _slack(shares: tuple[float, float, float], reach: float) -> FloatArray:
    return np.diag((np.array(shares) * reach) ** 2)


def _between(means: FloatArray, spreads: FloatArray, one: int, common: FloatArray) -> FloatArray:
    """(K,) squared distances to one of K groups, in standard deviations of the difference."""
    off = means - means[one]
    solved = np.linalg.solve(spreads + spreads[one] + common, off[:, :, None])[:, :, 0]
    return np.asarray((off * solved).sum(axis=1))


def _joined(means: FloatArray, spreads: FloatArray) -> tuple[FloatArray, FloatArray]:
    inverse = np.linalg.inv(spreads)
    spread = np.linalg.inv(inverse.sum(axis=0))
    return spread @ np.einsum("gij,gj->i", inverse, means), spread
