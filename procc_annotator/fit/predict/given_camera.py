"""A camera from elsewhere as if it had been fitted: what of it is assumed to be sure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from procc_annotator.camera.homography import HomographyCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.fit.result import FitResult
from procc_annotator.fit.solving.observations import FloatArray

# What a given camera may show an element beside its paint by, px at 960 px width: such cameras
# come from paint or from points, not from a guess.
_ASSUMED_SD_PX = 1.5


@dataclass(frozen=True, eq=False)
class ExternalCameraFit(FitResult):
    """A fit nobody made: every element may lie beside the camera as a whole, by the same."""

    def projected_covariance(self, points_world: FloatArray) -> FloatArray:
        """(N, 2, 2) px squared: none but that of `offset_px`."""
        return np.zeros((len(points_world), 2, 2))


def external_camera_fit(camera: PinholeCamera | HomographyCamera, size: tuple[int, int]) -> ExternalCameraFit:
    """A camera in px of a picture, with what it may be off by in this picture.

    Args:
        camera: in px of the picture.
        size: (width, height) px.
    """
    return ExternalCameraFit("given", size, camera, offset_px=_ASSUMED_SD_PX * (size[0] - 1) / 959)
