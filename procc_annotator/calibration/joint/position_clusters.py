"""Cluster camera positions, and find frames taken from the opposite side of the field."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.calibration.optimization.camera_parameters import X, Z
from procc_annotator.calibration.optimization.camera_placement import CameraPlacementPrior
from procc_annotator.calibration.optimization.initialization import SIDES, camera_side

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
    """(F,) whether a position (3,) may be that of each of some frames, for how surely they are
    known; the other arguments are those of `cluster_positions`."""
    means = np.concatenate([position[None], positions])
    spreads = np.concatenate([covariance[None], covariances]) + _tolerance_covariance(
        POSITION_TOLERANCE_SHARE, reach
    )
    return np.asarray(
        _squared_mahalanobis(means, spreads, 0, _tolerance_covariance(SHARED_ERROR_SHARE, reach))[
            1:
        ]
        <= MAX_SQUARED_DISTANCE
    )


def _tolerance_covariance(shares: tuple[float, float, float], reach: float) -> FloatArray:
    return np.diag((np.array(shares) * reach) ** 2)


def _squared_mahalanobis(
    means: FloatArray, spreads: FloatArray, one: int, common: FloatArray
) -> FloatArray:
    """(K,) squared distances to one of K groups, in standard deviations of the difference."""
    off = means - means[one]
    solved = np.linalg.solve(spreads + spreads[one] + common, off[:, :, None])[:, :, 0]
    return np.asarray((off * solved).sum(axis=1))


def _merge_estimates(means: FloatArray, spreads: FloatArray) -> tuple[FloatArray, FloatArray]:
    inverse = np.linalg.inv(spreads)
    spread = np.linalg.inv(inverse.sum(axis=0))
    return spread @ np.einsum("gij,gj->i", inverse, means), spread


_ROTATION_180 = np.array([-1.0, -1.0, 1.0])
_OPPOSITE_SIDES = (("near", "far"), ("left", "right"))
# Cameras on one side are worth a look where so many frames say that hardly any stands there.
_MIN_FRAMES_ON_SIDE, _MAX_MINORITY_SHARE = 10, 0.1


@dataclass(frozen=True)
class OppositeSideFrames:
    """Frames whose camera stands on the other side from the rest, by their indices.

    Attributes:
        turned: frame -> how many frames stand where its camera does once its labels are turned.
        minority: frames that stand where no other does, on a side where hardly any does.
    """

    turned: Mapping[int, int] = field(default_factory=dict)
    minority: frozenset[int] = frozenset()


def find_opposite_side_frames(
    positions: FloatArray, covariances: FloatArray, around: CameraPlacementPrior
) -> OppositeSideFrames:
    """Report the frames on the other side of a field that half a turn takes to itself, by the
    positions (F, 3), metres, and covariances (F, 3, 3), metres squared, of their own fits."""
    sides = np.array([_side_of_position(position, around) for position in positions], dtype=np.intp)
    turned: dict[int, int] = {}
    minority: set[int] = set()
    for few, most in _minority_pairs(sides):
        covariance = covariances[most]
        for i in few.tolist():
            there = positions[i] * _ROTATION_180
            # Half a turn leaves a covariance along the axes as it is, but for its sign with z.
            spread = covariances[i] * np.outer(_ROTATION_180, _ROTATION_180)
            agree = is_compatible_position(there, spread, positions[most], covariance, around.reach)
            if agree.sum() >= MIN_FRAMES:
                turned[i] = int(agree.sum())
        known = [i for i in few.tolist() if i not in turned]
        if len(few) + len(most) >= _MIN_FRAMES_ON_SIDE and len(few) <= _MAX_MINORITY_SHARE * (
            len(few) + len(most)
        ):
            own = [
                is_compatible_position(
                    positions[i], covariances[i], positions[known], covariances[known], around.reach
                ).sum()
                for i in known
            ]
            minority.update(i for i, count in zip(known, own, strict=True) if count < MIN_FRAMES)
    return OppositeSideFrames(turned, frozenset(minority))


def _minority_pairs(sides: IntArray) -> list[tuple[IntArray, IntArray]]:
    """Of opposite sides the frames on the one where few stand, and those on the other."""
    found = []
    for names in _OPPOSITE_SIDES:
        pair = [np.flatnonzero(sides == SIDES.index(name)) for name in names]
        # Of two sides with as many frames the labels are made for the first.
        most, few = sorted(pair, key=len, reverse=True)
        if "near" in names or 2 * (len(most) + len(few)) > len(sides):
            found.append((few, most))
    return found


def _side_of_position(position: FloatArray, around: CameraPlacementPrior) -> int:
    vector = np.zeros(Z + 1)
    vector[X:] = position
    return camera_side(vector, around)
