"""The cameras of the sample: where they stand, what they look at, how their lens bends lines."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.camera.models import PinholeCamera

EVALUATION_SIZE = (960, 540)
PICTURE_SIZE = (1280, 720)


@dataclass(frozen=True)
class View:
    """One frame of the sample; the camera's pixels belong to `EVALUATION_SIZE`."""

    name: str
    camera: PinholeCamera
    annotated: bool = True
    bad_camera: bool = True  # whether the bad set has a camera for it

    @property
    def picture_camera(self) -> PinholeCamera:
        """The camera in pixels of `PICTURE_SIZE`."""
        return self.camera.scaled(EVALUATION_SIZE, PICTURE_SIZE)


def looking_at(
    position: tuple[float, float, float],
    target: tuple[float, float, float],
    focal: float,
    *,
    k1: float = 0.0,
    roll_degrees: float = 0.0,
) -> PinholeCamera:
    """A camera at ``position`` whose optical axis goes through ``target`` (metres, z down)."""
    direction = np.array(target) - np.array(position)
    direction /= np.linalg.norm(direction)
    tilt = math.acos(direction[2])
    pan = math.atan2(direction[0], -direction[1])
    width, height = EVALUATION_SIZE
    return PinholeCamera(
        round(pan, 8),  # the last bits differ between machines
        round(tilt, 8),
        math.radians(roll_degrees),
        position,
        (focal, focal),
        ((width - 1) / 2, (height - 1) / 2),
        (k1, 0.0, 0.0, 0.0, 0.0, 0.0),
    )


def perturbed(camera: PinholeCamera, seed: int) -> PinholeCamera:
    """A camera as a mediocre method would estimate it: some elements pass at 5 px, others fail."""
    random = np.random.default_rng(seed)
    scale = 1000.0 / camera.focal_px[0]
    focal = camera.focal_px[0] * (1 + random.uniform(0.004, 0.022))
    return replace(
        camera,
        pan_rad=camera.pan_rad + math.radians(scale * random.uniform(-0.5, 0.5)),
        tilt_rad=camera.tilt_rad + math.radians(scale * random.uniform(-0.4, 0.4)),
        roll_rad=camera.roll_rad + math.radians(random.uniform(-0.3, 0.3)),
        focal_px=(focal, focal),
        radial=(0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
    )


def late(camera: PinholeCamera, seed: int) -> PinholeCamera:
    """A camera as it was a moment ago, while it pans and zooms in: a tracker that lags behind."""
    random = np.random.default_rng(seed + 50)
    pan = math.radians(1000.0 / camera.focal_px[0] * random.uniform(0.15, 0.5))
    focal = camera.focal_px[0] * random.uniform(0.985, 0.998)
    return replace(
        camera, pan_rad=camera.pan_rad + random.choice([-1, 1]) * pan, focal_px=(focal, focal)
    )


def turned(camera: PinholeCamera) -> PinholeCamera:
    """The camera on the other side that sees the same: the field is the same after half a turn."""
    x, y, z = camera.position_world
    return replace(camera, pan_rad=camera.pan_rad + math.pi, position_world=(-x, -y, z))
