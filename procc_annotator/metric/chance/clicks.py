"""What the clicks leave open: how much of a spread comes from where points were put."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.metric.polylines import FloatArray

# The median distance between two annotators, over the standard deviation of one's clicks across a
# line: the difference of two normal errors is root two times as wide, half of it within 0.6745.
_MEDIAN_OF_DIFFERENCE = 0.6744897501960817 * 2**0.5


@dataclass(frozen=True, eq=False)
class AnnotationNoiseSensitivity:
    """K means over frames that were judged R times with every point moved at random.

    Attributes:
        means: (K,) over frames and repeats. Below the figures themselves, whose clicks were off
            once already.
        deviations: (K,) standard deviation of a mean: what other clicks on these very frames would
            make of it.
        shares: (K,) how much of the variance from set to set comes from clicks, in [0, 1]; NaN
            where it does not vary.
    """

    means: FloatArray
    deviations: FloatArray
    shares: FloatArray


def annotation_noise_sensitivity(moved: FloatArray, deviations: FloatArray) -> AnnotationNoiseSensitivity:
    """Compare what clicks alone change with what sets of other frames change.

    Frames are clicked each for itself, so that the variance of their mean is the sum of theirs over
    the square of their number; that takes far fewer repeats than the means' own variance.

    Args:
        moved: (F, R, K) figures of F frames in R repeats.
        deviations: (K,) of the means from set to set, where both frames and clicks are others.
    """
    frames, repeats, _ = moved.shape
    own = np.full(moved.shape[2], np.nan)
    if frames and repeats > 1:
        own = np.sqrt(moved.var(axis=1, ddof=1).sum(axis=0)) / frames
    with np.errstate(divide="ignore", invalid="ignore"):
        shares = np.where(deviations > 0, np.minimum(1.0, (own / deviations) ** 2), np.nan)
    means = moved.mean(axis=(0, 1)) if frames else np.full(moved.shape[2], np.nan)
    return AnnotationNoiseSensitivity(means, own, shares)


def noise_from_median_distance(median_px: float) -> float:
    """The standard deviation of one annotator's clicks from the median distance of two, px."""
    return median_px / _MEDIAN_OF_DIFFERENCE
