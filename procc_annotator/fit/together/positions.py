"""From where frames were taken, told from the positions their own fits found."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.solving.observations import FloatArray, IntArray

# Positions found for one tripod differ by more than the points' errors explain: lens and field are
# never quite the model's. On World Cup frames by about so much: along the ground, in height.
SLACK_M = (1.0, 1.0, 0.3)
# What of that frames have in common that look the same way: more of them do not average it out.
COMMON_M = (0.7, 0.7, 0.2)
# Chi squared of 3 degrees of freedom, one in a thousand.
MOST_APART = 16.3
LEAST_FRAMES = 3


@dataclass(frozen=True, eq=False)
class CameraPlace:
    """A position that several frames agree on.

    Attributes:
        position: (3,) metres.
        members: (n,) indices of the frames.
    """

    position: FloatArray
    members: IntArray


def find_places(
    positions: FloatArray, covariances: FloatArray, scale: float = 1.0
) -> tuple[CameraPlace, ...]:
    """The positions that frames agree on, the one with most frames first.

    Frames, then groups of them, are joined two by two, those whose mean positions differ least for
    how surely they are known, until no two are left that may be the same. Groups of fewer than
    three frames are no agreement.

    Args:
        positions: (F, 3) metres, of the frames' own fits.
        covariances: (F, 3, 3) metres squared.
        scale: size of the field, a soccer field being 1.
    """
    if not len(positions):
        return ()
    groups = [[i] for i in range(len(positions))]
    means = positions.copy()
    spreads = covariances + _slack(SLACK_M, scale)
    common = _slack(COMMON_M, scale)
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
        CameraPlace(means[i], np.array(sorted(groups[i])))
        for i in np.flatnonzero(alive)
        if len(groups[i]) >= LEAST_FRAMES
    ]
    return tuple(sorted(found, key=lambda place: -len(place.members)))


def compatible(
    position: FloatArray, covariance: FloatArray, places: FloatArray, scale: float = 1.0
) -> IntArray:
    """Indices of the places that a frame may have been taken from.

    Args:
        position: (3,) metres, of its own fit.
        covariance: (3, 3) metres squared.
        places: (K, 3) metres.
        scale: size of the field, a soccer field being 1.
    """
    off = places - position
    inverse = np.linalg.inv(covariance + _slack(SLACK_M, scale))
    return np.flatnonzero(np.einsum("ki,ij,kj->k", off, inverse, off) <= MOST_APART)


def _slack(metres: tuple[float, float, float], scale: float) -> FloatArray:
    return np.diag((np.array(metres) * scale) ** 2)


def _between(means: FloatArray, spreads: FloatArray, one: int, common: FloatArray) -> FloatArray:
    """(K,) squared distances to one of K groups, in standard deviations of the difference."""
    off = means - means[one]
    solved = np.linalg.solve(spreads + spreads[one] + common, off[:, :, None])[:, :, 0]
    return np.asarray((off * solved).sum(axis=1))


def _joined(means: FloatArray, spreads: FloatArray) -> tuple[FloatArray, FloatArray]:
    inverse = np.linalg.inv(spreads)
    spread = np.linalg.inv(inverse.sum(axis=0))
    return spread @ np.einsum("gij,gj->i", inverse, means), spread
