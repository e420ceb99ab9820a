"""Where a way from inside a picture reaches its edge."""

from __future__ import annotations

import numpy as np

from procc_annotator.annotation import FloatArray


def steps_to_edge(place: FloatArray, step: FloatArray, limits: FloatArray) -> float:
    """How many steps lead from a place to the picture's edge.

    Args:
        place: (2,) px, inside.
        step: (2,) px.
        limits: (2,) px, the last column and row; the first ones are 0.

    Returns:
        Infinity for a step of no length.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        steps = np.where(
            step > 0, (limits - place) / step, np.where(step < 0, -place / step, np.inf)
        )
    return float(steps.min())
