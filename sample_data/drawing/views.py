"""The cameras of the sample: where they stand, what they look at, how their lens bends lines."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.camera.pinhole import PinholeCamera

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


MAIN = (0.0, 62.0, -17.0)


def views() -> tuple[View, ...]:
    """All frames of the sample, in order."""
    cameras = [
        looking_at(MAIN, (0, 2, 0), 1150, k1=0.16),
        looking_at(MAIN, (-36, -2, 0), 1500, k1=0.22, roll_degrees=0.3),
        looking_at(MAIN, (36, 0, 0), 1450),
        looking_at(MAIN, (-19, 0, 0), 1300, k1=0.18),
        looking_at(MAIN, (22, -4, 0), 1700, k1=0.3),
        looking_at(MAIN, (41, 4, 0), 2300, k1=0.5, roll_degrees=-0.4),
        looking_at((-36.0, 58.0, -12.0), (-41, 4, 0), 1250, k1=0.2),
        looking_at((36.0, 58.0, -12.0), (43, -2, 0), 1500),
        looking_at((-78.0, 2.0, -19.0), (-38, 0, 0), 1000, k1=0.12),
        looking_at((82.0, -4.0, -21.0), (40, 2, 0), 1150),
        looking_at(MAIN, (-47, 2, -1), 3600),
        looking_at((60.0, 24.0, -5.0), (49, -2, 0), 1500, k1=0.15),
        looking_at(MAIN, (3, 4, 0), 2500, k1=0.4),
        looking_at(MAIN, (-43, 12, 0), 1900, k1=0.35),
    ]
    unannotated = {5, 10, 14}
    without_bad_camera = {4, 9, 12}
    return tuple(
        View(f"{i:05d}", camera, i not in unannotated, i not in without_bad_camera)
        for i, camera in enumerate(cameras, 1)
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
