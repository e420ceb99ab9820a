"""The division lens model and a text format for it: an example of a plug-in for procc-annotator.

A file holds lines ``key = numbers``; see README.md.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import isfinite, radians

import numpy as np

from procc_annotator.camera.models import rotation_cam_from_world
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.loaded_camera import CameraFormat, LoadedCamera

KEYS = {"size": 2, "pan_tilt_roll": 3, "position": 3, "focal": 1, "centre": 2, "lambda": 1}


@dataclass(frozen=True, eq=False)
class DivisionCamera:
    """Undistorted = distorted / (1 + lambda |distorted|^2), in focal lengths from the centre."""

    rotation: np.ndarray
    position: np.ndarray
    focal: float
    centre: np.ndarray
    lam: float

    def project(self, points_world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(N, 3) metres -> (N, 2) px, and (N,) whether a point has a projection."""
        cam = (points_world - self.position) @ self.rotation.T
        valid = cam[:, 2] > 1e-3
        undistorted = cam[:, :2] / np.where(valid, cam[:, 2], 1.0)[:, None]
        r = np.hypot(undistorted[:, 0], undistorted[:, 1])
        # r = d / (1 + lambda d^2) solved for d, the branch that starts at d = 0.
        inside = 1 - 4 * self.lam * r * r
        valid &= inside > 0  # beyond, the model has no picture of the point
        ratio = 2 / (1 + np.sqrt(np.maximum(inside, 0.0)))
        return undistorted * ratio[:, None] * self.focal + self.centre, valid


def read(data: bytes, *, path: str) -> LoadedCamera:
    """Read a file; what is wrong with it is named with its place."""
    values: dict[str, np.ndarray] = {}
    for number, line in enumerate(data.decode("utf-8", "replace").splitlines(), 1):
        key, _, rest = (part.strip() for part in line.partition("="))
        if not line.strip() or line.startswith("#"):
            continue
        count = KEYS.get(key)
        try:
            numbers = [float(word) for word in rest.split()]
        except ValueError:
            numbers = []
        if count is None or len(numbers) != count or not all(map(isfinite, numbers)):
            raise CameraError(
                path,
                f"expected {count or 'a known key and its'} numbers, found {line.strip()[:60]!r}",
                place=f"line {number}",
                advice=f"the keys are {', '.join(KEYS)}",
            )
        values[key] = np.array(numbers)
    missing = [key for key in KEYS if key not in values]
    if missing:
        raise CameraError(path, f"lacks {', '.join(missing)}", advice="is this a division camera?")
    camera = DivisionCamera(
        rotation_cam_from_world(*(radians(angle) for angle in values["pan_tilt_roll"])),
        values["position"],
        float(values["focal"][0]),
        values["centre"],
        float(values["lambda"][0]),
    )
    width, height = (int(n) for n in values["size"])
    return LoadedCamera(camera, "division", (width, height))


FORMAT = CameraFormat("division", "division lens model", (".division",), (".division",), read)
