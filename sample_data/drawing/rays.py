"""What every pixel looks along, and where that meets the ground."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.models import PinholeCamera

FloatArray = NDArray[np.float32]

NOISE_SIDE = 1024


@dataclass(frozen=True, eq=False)
class Sight:
    """The rays of a picture.

    Attributes:
        position: (3,) of the camera, metres.
        rays: (H, W, 3) world directions, of any length.
        reach: (H, W) how often a ray's length it is to what was painted there; infinite: nothing.
    """

    position: FloatArray
    rays: FloatArray
    reach: FloatArray

    @classmethod
    def of(cls, camera: PinholeCamera, size: tuple[int, int]) -> Sight:
        """The rays of a camera down to the ground.

        Args:
            camera: in pixels of ``size``.
            size: (width, height) px.
        """
        rays = _rays_world(camera, size)
        position = np.array(camera.position_world, dtype=np.float32)
        with np.errstate(divide="ignore", invalid="ignore"):
            reach = np.where(rays[..., 2] > 1e-6, -position[2] / rays[..., 2], np.inf)
        return cls(position, rays, reach.astype(np.float32))

    def ground(self) -> FloatArray:
        """(H, W, 2) metres: where the rays are on the ground; the camera's foot above the horizon.

        To be asked for before anything else is painted.
        """
        down = np.where(np.isfinite(self.reach), self.reach, 0)[..., None] * self.rays[..., :2]
        return np.asarray(self.position[:2] + down)

    def mirrored(self, every: int) -> Sight:
        """What a floor that shines shows: the rays of the camera below it, every n-th pixel's."""
        upwards = np.array([1, 1, -1], dtype=np.float32)
        rays = self.rays[::every, ::every] * upwards
        nothing = np.full(rays.shape[:2], np.inf, dtype=np.float32)
        return Sight(self.position * upwards, rays, nothing)


def _rays_world(camera: PinholeCamera, size: tuple[int, int]) -> FloatArray:
    """(H, W, 3) directions; only k1 is undone, by fixed-point iteration."""
    u, v = np.meshgrid(np.arange(size[0], dtype=np.float32), np.arange(size[1], dtype=np.float32))
    xd = (u - camera.principal_point_px[0]) / camera.focal_px[0]
    yd = (v - camera.principal_point_px[1]) / camera.focal_px[1]
    x, y = xd, yd
    for _ in range(12 if camera.is_distorted else 0):
        factor = 1 + camera.radial[0] * (x * x + y * y)
        x, y = xd / factor, yd / factor
    rays_cam = np.stack([x, y, np.ones_like(x)], axis=-1).astype(np.float32)
    return rays_cam @ camera.rotation_cam_from_world.astype(np.float32)


def noise_tile(random: np.random.Generator, blur: float, blur_down: float = 0.0) -> FloatArray:
    """Smooth noise of unit spread that continues across its borders: a seam would look painted.

    Args:
        random: where it comes from.
        blur: its grain along the rows, cells.
        blur_down: ... along the columns; 0 for the same.
    """
    noise = random.normal(0, 1, (NOISE_SIDE, NOISE_SIDE)).astype(np.float32)
    margin = int(5 * max(blur, blur_down))
    padded = np.pad(noise, margin, mode="wrap")
    smooth = cv2.GaussianBlur(padded, (0, 0), blur, sigmaY=blur_down)
    tile = smooth[margin:-margin, margin:-margin]
    return (tile / tile.std()).astype(np.float32)


@lru_cache(maxsize=1)
def noise_tiles(seed: int, *blurs: float) -> tuple[FloatArray, ...]:
    """A noise tile of each grain; the frames of a shot lie on the same ones."""
    random = np.random.default_rng(seed)
    return tuple(noise_tile(random, blur) for blur in blurs)


def cells(metres: FloatArray, per_metre: float) -> NDArray[np.int32]:
    """Which cell of a noise tile a place belongs to, along one axis."""
    # Far beyond the stands the ground runs to infinity; nothing of it is seen.
    return np.floor(np.clip(metres, -1e4, 1e4) * per_metre).astype(np.int32) % NOISE_SIDE
