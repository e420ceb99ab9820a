"""What a camera stands on: a tripod, or something that moves while it films."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.solving.models import KAPPA, LOG_FOCAL, PAN, ROLL, TILT, X, Z
from procc_annotator.fit.solving.observations import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class ProcessNoise:
    """What may change from frame to frame, and how much.

    Attributes:
        own: parameters that each frame has of its own.
        shared: those that all frames of a shot have in common.
        position_m: standard deviation of the position's change from one frame to the next.
        apparent: (4,) by how much a turn that is seen may be no turn, standard deviations of pan,
            tilt, roll and the logarithm of the focal length: what is near moves past a camera that
            moves.
    """

    own: IntArray
    shared: IntArray
    position_m: float
    apparent: FloatArray


# Radial coefficients: of a lens at rest, from frame to frame, and of one that zooms e times.
_KAPPA_SD, _KAPPA_SD_PER_ZOOM = 0.0003, 0.02
_POSITION_PARAMETERS = (X, X + 1, Z)
# Tripods give a little, and no field is quite what it should be.
TRIPOD_NOISE = ProcessNoise(
    np.array([PAN, TILT, ROLL, LOG_FOCAL, KAPPA]), np.array(_POSITION_PARAMETERS), 0.015, np.zeros(4)
)
# Rails, cranes and cameras on ropes: some metres a second, 60 m from what they film.
MOVING_NOISE = ProcessNoise(
    np.array([PAN, TILT, ROLL, *_POSITION_PARAMETERS, LOG_FOCAL, KAPPA]),
    np.array([], dtype=np.intp),
    0.15,
    np.array([0.004, 0.004, 0.0005, 0.004]),
)


def kappa_change_sd(log_focal: FloatArray | float) -> FloatArray:
    """Standard deviation of the radial coefficient's change while the logarithm of the focal length
    changes by so much: lenses distort otherwise when they zoom."""
    return np.asarray(np.sqrt(_KAPPA_SD**2 + _KAPPA_SD_PER_ZOOM**2 * np.abs(log_focal)))
