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
from procc_annotator.fit.solving.starts import SIDES, camera_side
from procc_annotator.fit.solving.surroundings import CameraPlacementPrior
from procc_annotator.fit.together.positions import MIN_FRAMES, is_compatible_position

_ROTATION_180 = np.array([-1.0, -1.0, 1.0])
_OPPOSITE_SIDES = (("near", "far"), ("left", "right"))
# Cameras on one side are worth a look where so many frames tell that hardly any stands there.
_MIN_FRAMES_ON_SIDE, _MAX_MINORITY_SHARE = 10, 0.1


@dataclass(frozen=True)
class OppositeSideFrames:
    """Frames whose camera stands on the other side from the rest, by their indices.

    Attributes:
        turned: frame -> how many frames stand where its camera does once its labels are turned.
        rare: frames that stand where no other does, on a side where hardly any does.
    """

    turned: Mapping[int, int] = field(default_factory=dict)
    minority: frozenset[int] = frozenset()


def find_opposite_side_frames(
    positions: FloatArray, covariances: FloatArray, around: CameraPlacementPrior
) -> OppositeSideFrames:
    """Tell the frames on the other side of a field that half a turn takes to itself.

    Args:
        positions: (F, 3) metres, of the frames' own fits.
        covariances: (F, 3, 3) metres squared.
        around: the field's surroundings.
    """
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
        if len(few) + len(most) >= _MIN_FRAMES_ON_SIDE and len(few) <= _MAX_MINORITY_SHARE * (len(few) + len(most)):
            own = [is_compatible_position(positions[i], covariances[i], positions[known], covariances[known],
                              around.reach).sum() for i in known]  # fmt: skip
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
