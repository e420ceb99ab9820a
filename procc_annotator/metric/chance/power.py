"""How many frames a set needs before a difference of a given size would be found."""

from __future__ import annotations

import math

from procc_annotator.metric.chance.distributions import student_t_ppf
from procc_annotator.metric.chance.intervals import critical_value

_MIN_CLUSTERS = 2.0


def required_frames(
    difference: float,
    deviation: float,
    frames: int,
    effective: float,
    *,
    level: float = 0.95,
    power: float = 0.8,
    fewest: int = 1,
) -> int:
    """The frames of a set like this one in which a true difference is found beyond chance.

    The deviation of a mean falls with the root of the frames, however alike frames of one cluster
    are, as long as more frames come in clusters like those at hand.

    Args:
        difference: the true one, above 0, in the unit of the figure.
        deviation: of the difference on the frames at hand, in the same unit.
        frames, effective: those at hand, and how many clusters they effectively come in.
        level: of the interval that is to exclude 0.
        power: in which share of such sets it is to.
        fewest: frames below which nothing is found for another reason.
    """

    def suffice(count: int) -> bool:
        clusters = max(_MIN_CLUSTERS, effective * count / frames)
        reached = deviation * math.sqrt(frames / count) * _detection_multiplier(clusters, level, power)
        return reached <= difference * (1 + 1e-9)

    fewest = max(fewest, math.ceil(_MIN_CLUSTERS * frames / effective))
    if suffice(fewest):
        return fewest
    # More frames never reach farther: the bounds are doubled, then halved.
    most = fewest
    while not suffice(most):
        fewest, most = most, 2 * most
    while most - fewest > 1:
        middle = (fewest + most) // 2
        fewest, most = (fewest, middle) if suffice(middle) else (middle, most)
    return most


def minimum_detectable_difference(
    deviation: float, effective: float, *, level: float = 0.95, power: float = 0.8
) -> float:
    """The true difference that these very frames would find in such a share of sets."""
    return deviation * _detection_multiplier(max(_MIN_CLUSTERS, effective), level, power)


def _detection_multiplier(clusters: float, level: float, power: float) -> float:
    freedom = max(1.0, round(clusters - 1, 6))
    return critical_value(clusters, level) + student_t_ppf(power, freedom)
