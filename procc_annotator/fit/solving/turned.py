"""The same camera from the other end of the field, where nothing else tells the ends apart.

On a field that is the same after half a turn, labels go by where the main camera stands. On one
that is not, such as a running track with its finish line, much of what a picture shows may be the
same all the same: lanes are, their marks are not. A search that looks at both ends lets one mark
decide; and where there is none, no standard deviation tells that the camera may be elsewhere.
"""

from __future__ import annotations

import numpy as np

from procc_annotator.field.model import Field
from procc_annotator.fit.solving.covariance import error_of_points
from procc_annotator.fit.solving.models import half_turned
from procc_annotator.fit.solving.observations import Frame
from procc_annotator.fit.solving.residual import pinhole_residuals
from procc_annotator.fit.solving.search import Found
from procc_annotator.fit.solving.solver import ROBUST_LOSS

# What the end must explain to be known, squares of the error of a point: twenty times as likely.
_WORTH = 3.0


def same_from_other_end(found: Found, field: Field, frame: Frame) -> bool:
    """Whether the points leave open from which end of the field a camera sees it.

    Args:
        found: a fit.
        field: the elements; of one with symmetries the labels tell, and the answer is no.
        frame: the picture.
    """
    if found.basis is not None or field.symmetries:
        return False
    here = found.solution.distances[0]
    vectors = half_turned(found.vector[None])
    free = found.prior.mean.shape[1]
    there = pinhole_residuals(vectors, found.seen, half_diagonal=frame.half_diagonal, free=free)
    costs = [
        float(ROBUST_LOSS.cost_and_weight(distances)[0] @ found.seen.weights)
        for distances in (here, np.asarray(there.distances[0]))
    ]
    return costs[1] - costs[0] < _WORTH * error_of_points(found) ** 2
