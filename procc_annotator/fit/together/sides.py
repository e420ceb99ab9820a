"""Which cameras of a set stand on the other side of the field from the rest.

Of a field that half a turn takes to itself no single frame can tell that its labels are turned:
they give the turned camera. But a set's labels go by where its main camera stands. So where turning
a frame's labels puts its camera from the side where few stand to where several stand on the side of
most, its labels are turned. Of cameras behind the two ends, which do stand like that, nothing can
be told unless they are the main ones.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from procc_annotator.fit.solving.models import X, Z
from procc_annotator.fit.solving.observations import FloatArray, IntArray
from procc_annotator.fit.solving.starts import SIDES, side_of
from procc_annotator.fit.solving.surroundings import Surroundings
from procc_annotator.fit.together.positions import LEAST_FRAMES, agree_with

_HALF_TURN = np.array([-1.0, -1.0, 1.0])
_OPPOSITE = (("near", "far"), ("left", "right"))
# Cameras on one side are worth a look where so many frames tell that hardly any stands there.
_ENOUGH, _FEW = 10, 0.1


@dataclass(frozen=True)
class OtherSide:
    """Frames whose camera stands on the other side from the rest, by their indices.

    Attributes:
        turned: frame -> how many frames stand where its camera does once its labels are turned.
        rare: frames that stand where no other does, on a side where hardly any does.
    """

    turned: Mapping[int, int] = field(default_factory=dict)
    rare: frozenset[int] = frozenset()


def on_other_side(
    positions: FloatArray, covariances: FloatArray, around: Surroundings
) -> OtherSide:
    """Tell the frames on the other side of a field that half a turn takes to itself.

    Args:
        positions: (F, 3) metres, of the frames' own fits.
        covariances: (F, 3, 3) metres squared.
        around: the field's surroundings.
    """
    sides = np.array([_side(position, around) for position in positions], dtype=np.intp)
    turned: dict[int, int] = {}
    rare: set[int] = set()
    for few, most in _pairs(sides):
        covariance = covariances[most]
        for i in few.tolist():
            there = positions[i] * _HALF_TURN
            # Half a turn leaves a covariance along the axes as it is, but for its sign with z.
            spread = covariances[i] * np.outer(_HALF_TURN, _HALF_TURN)
            agree = agree_with(there, spread, positions[most], covariance, around.reach)
            if agree.sum() >= LEAST_FRAMES:
                turned[i] = int(agree.sum())
        known = [i for i in few.tolist() if i not in turned]
        if len(few) + len(most) >= _ENOUGH and len(few) <= _FEW * (len(few) + len(most)):
            own = [agree_with(positions[i], covariances[i], positions[known], covariances[known],
                              around.reach).sum() for i in known]  # fmt: skip
            rare.update(i for i, count in zip(known, own, strict=True) if count < LEAST_FRAMES)
    return OtherSide(turned, frozenset(rare))


def _pairs(sides: IntArray) -> list[tuple[IntArray, IntArray]]:
    """Of opposite sides the frames on the one where few stand, and those on the other."""
    found = []
    for names in _OPPOSITE:
        pair = [np.flatnonzero(sides == SIDES.index(name)) for name in names]
        # Of two sides with as many frames the labels are made for the first.
        most, few = sorted(pair, key=len, reverse=True)
        if "near" in names or 2 * (len(most) + len(few)) > len(sides):
            found.append((few, most))
    return found


def _side(position: FloatArray, around: Surroundings) -> int:
    vector = np.zeros(Z + 1)
    vector[X:] = position
    return side_of(vector, around)
