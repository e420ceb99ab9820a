"""What ties each frame's camera to the next one's: the picture's motion, tripod and lens."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.fit.on_paint.marks import PARAMETERS_FREE
from procc_annotator.fit.solving.models import KAPPA, LOG_FOCAL, X, Z
from procc_annotator.fit.solving.observations import FloatArray
from procc_annotator.fit.through_shot.stand import ProcessNoise, kappa_change_sd
from procc_annotator.fit.through_shot.turning import MOTION_PARAMETERS, InterFrameMotion

# Of a step that nothing foretells, standard deviations: pan, tilt, roll, logarithm of the focal
# length.
_UNKNOWN_MOTION = InterFrameMotion(np.zeros(4), np.diag(np.array([0.02, 0.01, 0.002, 0.05]) ** 2))


@dataclass(frozen=True, eq=False)
class MotionConstraints:
    """Between each of K frames and the next one.

    Attributes:
        step: (K - 1, 4) change of the parameters `OWN`.
        stiffness: (K - 1, 4, 4) how surely: inverse covariances.
        stand: what the camera stands on.
    """

    step: FloatArray
    stiffness: FloatArray
    stand: ProcessNoise

    def add_to(
        self, information: FloatArray, pull: FloatArray, rows: slice, vectors: FloatArray
    ) -> FloatArray:
        """Add them to the normal equations of some frames.

        Args:
            information, pull: (b, 8, 8) and (b, 8).
            rows: which frames, in the order of all.
            vectors: (K, 11) of all.

        Returns:
            (b, 8, 8) stiffness between each of these frames and its next; one fewer at the end.
        """
        first = max(rows.start - 1, 0)
        last = min(rows.stop, len(self.step))
        stiff = self._between(slice(first, last), vectors)
        off = (
            vectors[first:last, :PARAMETERS_FREE] - vectors[first + 1 : last + 1, :PARAMETERS_FREE]
        )
        off[:, MOTION_PARAMETERS] += self.step[first:last]
        pulled = (stiff @ off[:, :, None])[:, :, 0]
        ahead = stiff[rows.start - first :]
        information[: len(ahead)] += ahead
        pull[: len(ahead)] -= pulled[rows.start - first :]
        begin, count = first + 1 - rows.start, rows.stop - 1 - first
        information[begin:] += stiff[:count]
        pull[begin:] += pulled[:count]
        return ahead

    def _between(self, pairs: slice, vectors: FloatArray) -> FloatArray:
        """(n, 8, 8) how stiff some of them are."""
        count = pairs.stop - pairs.start
        stiff = np.zeros((count, PARAMETERS_FREE, PARAMETERS_FREE))
        stiff[:, range(X, Z + 1), range(X, Z + 1)] = self.stand.position_m**-2
        stiff[:, MOTION_PARAMETERS[:, None], MOTION_PARAMETERS] = self.stiffness[pairs]
        zoomed = np.diff(vectors[pairs.start : pairs.stop + 1, LOG_FOCAL])
        stiff[:, KAPPA, KAPPA] = kappa_change_sd(zoomed) ** -2.0
        return stiff


def motion_constraints(turns: Sequence[InterFrameMotion | None], stand: ProcessNoise) -> MotionConstraints:
    """The ties of frames between which the picture turned so; None where nothing tells."""
    told = [turn or _UNKNOWN_MOTION for turn in turns]
    apparent = np.diag(stand.apparent**2)
    return MotionConstraints(
        np.array([turn.step for turn in told]).reshape(-1, len(MOTION_PARAMETERS)),
        np.array([np.linalg.inv(turn.covariance + apparent) for turn in told]).reshape(
            -1, len(MOTION_PARAMETERS), len(MOTION_PARAMETERS)
        ),
        stand,
    )
