"""Least squares over a chain: unknowns of every frame, tied to their neighbours', and shared ones.

The normal matrix has K blocks on its diagonal, one beside each, and a border: blocks are eliminated
one after the other (block tridiagonal Cholesky with a border, as in bundle adjustment), so that the
time it takes grows with the number of frames, not with its cube.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.solving.observations import FloatArray


@dataclass(frozen=True, eq=False)
class BandedNormalEquations:
    """Normal equations.

    Attributes:
        own: (K, n, n) of each frame's unknowns.
        beside: (K - 1, n, n) between those of a frame (rows) and of the next one.
        border: (K, n, s) between those of a frame and the shared ones.
        shared: (s, s).
        own_pull: (K, n, r) right-hand sides.
        shared_pull: (s, r).
    """

    own: FloatArray
    beside: FloatArray
    border: FloatArray
    shared: FloatArray
    own_gradient: FloatArray
    shared_gradient: FloatArray


@dataclass(frozen=True, eq=False)
class BandedSolution:
    """What solves them.

    Attributes:
        own: (K, n, r) of each frame's unknowns, for each right-hand side.
        shared: (s, r) of the shared ones.
        own_covariance: (K, n, n) of each frame's, the shared ones' part included.
        shared_covariance: (s, s).
        follow: (K, n, s) how each frame's unknowns follow the shared ones.
    """

    own: FloatArray
    shared: FloatArray
    own_covariance: FloatArray
    shared_covariance: FloatArray
    follow: FloatArray


def solve_banded(normal: BandedNormalEquations) -> BandedSolution:
    """Solve normal equations, and tell how surely."""
    count, own, sides = normal.own_gradient.shape
    right = np.concatenate([normal.own_gradient, normal.border], axis=2)
    inverse = np.empty_like(normal.own)
    passed = np.empty((max(count - 1, 0), own, own))  # inverse of a block times its neighbour
    gone = np.empty_like(right)
    block, column = normal.own[0], right[0]
    for k in range(count):
        inverse[k] = np.linalg.inv(block)
        gone[k] = inverse[k] @ column
        if k + 1 < count:
            passed[k] = inverse[k] @ normal.beside[k]
            block = normal.own[k + 1] - normal.beside[k].T @ passed[k]
            column = right[k + 1] - normal.beside[k].T @ gone[k]
    found, spread = gone, inverse
    for k in range(count - 2, -1, -1):
        found[k] -= passed[k] @ found[k + 1]
        spread[k] += passed[k] @ spread[k + 1] @ passed[k].T
    follow = -found[:, :, sides:]
    reduced = normal.shared + np.einsum("kns,knt->st", normal.border, follow)
    pull = normal.shared_gradient - np.einsum("kns,knr->sr", normal.border, found[:, :, :sides])
    covariance = np.linalg.inv(reduced)
    step = covariance @ pull
    return BandedSolution(
        found[:, :, :sides] + follow @ step,
        step,
        spread + follow @ covariance @ follow.transpose(0, 2, 1),
        covariance,
        follow,
    )
