"""Where cameras are known to stand, told from the cameras of several pictures."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.fit.from_picture.proposal import KnownPosition
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.models import CENTRE, vector_from_camera
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame
from procc_annotator.fit.solving.surroundings import surroundings_of
from procc_annotator.fit.together.positions import find_places
from procc_annotator.fit.together.tripod import usual_of

# What is known of the position of a camera that no other one agrees with, metres.
_ALONE_SD_M = 1.0


def positions_of_fits(fits: Sequence[FitResult], field: Field) -> tuple[KnownPosition, ...]:
    """The positions that several fits agree on, the one with most of them first.

    Args:
        fits: with or without a camera.
        field: the elements.
    """
    known = [fit for fit in fits if fit.vector is not None and fit.covariance is not None]
    known = [fit for fit in known if isinstance(fit.camera, PinholeCamera)]
    if not known:
        return ()
    vectors = np.array([fit.vector for fit in known])
    covariances = np.array([fit.covariance[CENTRE, CENTRE] for fit in known])  # type: ignore[index]
    return _agreed(vectors, covariances, field)


def positions_of_cameras(
    cameras: Sequence[tuple[PinholeCamera, tuple[int, int]]], field: Field
) -> tuple[KnownPosition, ...]:
    """The positions that several cameras agree on; the own ones of all where none do.

    Args:
        cameras: each in px of the picture size (width, height) beside it.
        field: the elements.
    """
    if not cameras:
        return ()
    vectors = np.array([vector_from_camera(c, PictureFrame(size)) for c, size in cameras])
    agreed = _agreed(vectors, np.zeros((len(vectors), 3, 3)), field)
    if agreed:
        return agreed
    alone = np.eye(3) * _ALONE_SD_M**2
    return tuple(KnownPosition(vector[CENTRE], alone) for vector in vectors)


def _agreed(
    vectors: FloatArray, covariances: FloatArray, field: Field
) -> tuple[KnownPosition, ...]:
    places = find_places(vectors[:, CENTRE], covariances, surroundings_of(field).reach)
    return tuple(
        KnownPosition(place.position, place.covariance, usual_of(vectors[place.members]))
        for place in places
    )
