"""A proposed camera, and known camera positions from other images."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.joint.adjustment import LensAndRollPrior
from procc_annotator.calibration.joint.position_clusters import cluster_positions
from procc_annotator.calibration.joint.shared_position import lens_and_roll_prior
from procc_annotator.calibration.optimization.camera_parameters import (
    POSITION_SLICE,
    vector_from_camera,
)
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field

ProposalState = Literal["sure", "unsure", "none"]
SURE: ProposalState = "sure"
UNSURE: ProposalState = "unsure"
NONE: ProposalState = "none"
PROPOSAL_STATES: tuple[ProposalState, ...] = (SURE, UNSURE, NONE)


@dataclass(frozen=True, eq=False)
class Proposal:
    """A camera proposed for a picture, or why there is none.

    Attributes:
        state: whether the camera may be relied on, has to be checked, or is missing.
        reason: a sentence for the user, also when sure.
        fit: the camera, px of the picture, with vector, covariance and deviations as any fit; its
            camera is None and its failure reported if absent.
        coverage: share of the visible model that was found on paint, 0-1.
        explained: share of the paint on the field that the model explains, 0-1.
        residual_px: median distance of the found paint to the model, px of the picture; None
            without a camera.
        margin: how much better it is than the best camera that shows something else, 0-1.
        runner_up: that other camera, px of the picture; None where none was found.
        probability: that the camera is right, 0-1; see `single_image.probability`.
    """

    state: ProposalState
    reason: str
    fit: FitResult
    coverage: float
    explained: float
    residual_px: float | None
    margin: float
    runner_up: PinholeCamera | None
    probability: float = 0.0


@dataclass(frozen=True, eq=False)
class KnownPosition:
    """A place where cameras are known to stand.

    Attributes:
        position_m: (3,) metres, world frame.
        covariance: (3, 3) m^2.
        usual: what else is known of the camera there; None for nothing.
        camera: there, in px of the picture, that is one more hypothesis; None for none.
    """

    position_m: FloatArray
    covariance: FloatArray
    usual: LensAndRollPrior | None = None
    camera: PinholeCamera | None = None


# What is known of the position of a camera that no other one agrees with, metres.
_SINGLE_POSITION_SD_M = 1.0
_MIN_SURE_FITS = 2


def cluster_fit_positions(
    sure: Sequence[FitResult], field: Field, others: Sequence[FitResult] = ()
) -> tuple[KnownPosition, ...]:
    """The positions that three or more fits agree on, the one with most of them first.

    Frames of one shot can make the same mistake; so two of those that agree must be sure. The
    others may be wrong.
    """
    known = [fit for fit in (*sure, *others) if fit.vector is not None]
    known = [fit for fit in known if fit.covariance is not None]
    if not known:
        return ()
    vectors = np.array([fit.vector for fit in known])
    covariances = np.array([fit.covariance[POSITION_SLICE, POSITION_SLICE] for fit in known])  # type: ignore[index]
    relied_on = {id(fit) for fit in sure}
    is_sure = np.array([id(fit) in relied_on for fit in known])
    return _clustered_positions(vectors, covariances, field, is_sure)


def cluster_camera_positions(
    cameras: Sequence[tuple[PinholeCamera, tuple[int, int]]], field: Field
) -> tuple[KnownPosition, ...]:
    """The positions that several cameras agree on; the own ones of all where none do. Each camera
    is in px of the picture size (width, height) next to it."""
    if not cameras:
        return ()
    frames = [ImageFrame(size, field.pixel_aspect) for _, size in cameras]
    vectors = np.array(
        [vector_from_camera(c, own) for (c, _), own in zip(cameras, frames, strict=True)]
    )
    agreed = _clustered_positions(
        vectors, np.zeros((len(vectors), 3, 3)), field, np.ones(len(vectors), bool)
    )
    if agreed:
        return agreed
    alone = np.eye(3) * _SINGLE_POSITION_SD_M**2
    return tuple(KnownPosition(vector[POSITION_SLICE], alone) for vector in vectors)


def _clustered_positions(
    vectors: FloatArray, covariances: FloatArray, field: Field, is_sure: NDArray[np.bool_]
) -> tuple[KnownPosition, ...]:
    places = cluster_positions(
        vectors[:, POSITION_SLICE], covariances, camera_placement_prior(field).reach
    )
    return tuple(
        KnownPosition(place.position, place.covariance, lens_and_roll_prior(vectors[place.members]))
        for place in places
        if is_sure[place.members].sum() >= _MIN_SURE_FITS
    )
