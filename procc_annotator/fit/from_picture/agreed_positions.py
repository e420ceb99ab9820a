"""Where cameras are known to stand, told from the cameras of several pictures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.from_picture.proposal import KnownPosition
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.models import POSITION_SLICE, vector_from_camera
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame
from procc_annotator.fit.solving.surroundings import camera_placement_prior
from procc_annotator.fit.together.positions import cluster_positions
from procc_annotator.fit.together.tripod import lens_and_roll_prior

# What is known of the position of a camera that no other one agrees with, metres.
_SINGLE_POSITION_SD_M = 1.0
_MIN_SURE_FITS = 2


def cluster_fit_positions(
    sure: Sequence[FitResult], field: Field, others: Sequence[FitResult] = ()
) -> tuple[KnownPosition, ...]:
    """The positions that three or more fits agree on, the one with most of them first.

    Frames of one shot can make the same mistake; so two of those that agree must be sure.

    Args:
        sure: fits to rely on.
        field: the elements.
        others: fits that may be wrong.
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
    """The positions that several cameras agree on; the own ones of all where none do.

    Args:
        cameras: each in px of the picture size (width, height) beside it.
        field: the elements.
    """
    if not cameras:
        return ()
    vectors = np.array([vector_from_camera(c, ImageFrame(size)) for c, size in cameras])
    agreed = _clustered_positions(vectors, np.zeros((len(vectors), 3, 3)), field, np.ones(len(vectors), bool))
    if agreed:
        return agreed
    alone = np.eye(3) * _SINGLE_POSITION_SD_M**2
    return tuple(KnownPosition(vector[POSITION_SLICE], alone) for vector in vectors)


def _clustered_positions(
    vectors: FloatArray, covariances: FloatArray, field: Field, is_sure: NDArray[np.bool_]
) -> tuple[KnownPosition, ...]:
    places = cluster_positions(vectors[:, POSITION_SLICE], covariances, camera_placement_prior(field).reach)
    return tuple(
        KnownPosition(place.position, place.covariance, lens_and_roll_prior(vectors[place.members]))
        for place in places
        if is_sure[place.members].sum() >= _MIN_SURE_FITS
    )
