"""A camera proposed for a picture, and what may be known of it before."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.observations import FloatArray
from procc_annotator.fit.together.known import LensAndRollPrior

ProposalState = Literal["sure", "unsure", "none"]
SURE: ProposalState = "sure"
UNSURE: ProposalState = "unsure"
NONE: ProposalState = "none"
PROPOSAL_STATES: tuple[ProposalState, ...] = (SURE, UNSURE, NONE)


@dataclass(frozen=True, eq=False)
class Proposal:
    """A camera proposed for a picture, or why there is none.

    Attributes:
        state: whether the camera may be relied on, has to be looked at, or is none.
        reason: a sentence for the user, also when sure.
        fit: the camera, px of the picture, with vector, covariance and deviations as any fit; its
            camera is None and its failure told if there is none.
        coverage: share of the visible model that was found on paint, 0-1.
        explained: share of the paint on the ground that the model explains, 0-1.
        residual_px: median distance of the found paint to the model, px of the picture; None
            without a camera.
        margin: how much better it is than the best camera that shows something else, 0-1.
        runner_up: that other camera, px of the picture; None where none was found.
    """

    state: ProposalState
    reason: str
    fit: FitResult
    coverage: float
    explained: float
    residual_px: float | None
    margin: float
    runner_up: PinholeCamera | None


@dataclass(frozen=True, eq=False)
class KnownPosition:
    """A place where cameras are known to stand.

    Attributes:
        position_m: (3,) metres, world frame.
        covariance: (3, 3) m^2.
        usual: what else is known of the camera there; None for nothing.
    """

    position_m: FloatArray
    covariance: FloatArray
    usual: LensAndRollPrior | None = None
