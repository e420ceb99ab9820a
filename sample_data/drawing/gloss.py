"""A floor that shines: the lamps below the roof and what stands around, mirrored in it."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from drawing.rays import Sight

FloatArray = NDArray[np.float32]

_TERMS = 4  # of the lamps' grid as a sum of waves
_BLACK_HOLE = 1e-3


@dataclass(frozen=True)
class Gloss:
    """How a floor shines, and what hangs above it.

    Attributes:
        lamp_height_m: of the lamps above the floor.
        spacing_m: of the lamps' grid, along x and y.
        lamp_size_m: spread of one lamp.
        brightness: of the lamps' mirror image, averaged over the roof, 0 to 255 and beyond.
        roughness_rad: spread of the floor's slope: long soft streaks instead of lamps.
        mirror: share of the light that comes back at a right angle; more at flat ones.
        blur_px: of the mirrored surroundings, for a picture 1280 px wide.
        every: mirrored for every n-th pixel only, since it is blurred anyway.
    """

    lamp_height_m: float
    spacing_m: tuple[float, float]
    lamp_size_m: float
    brightness: float
    roughness_rad: float
    mirror: float
    blur_px: float
    every: int = 4


def add_gloss(
    picture: FloatArray,
    ground: FloatArray,
    sight: Sight,
    gloss: Gloss,
    surroundings: FloatArray,
    roof: NDArray[np.bool_],
) -> None:
    """Add what a floor mirrors to its picture.

    Args:
        picture: (H, W, 3) BGR, changed in place.
        ground: (H, W, 2) metres.
        sight: of the picture.
        gloss: how it shines.
        surroundings: (h, w, 3) BGR, every n-th pixel: what stands around, mirrored.
        roof: (h, w) where the roof is mirrored, not what stands below it.
    """
    n = gloss.every
    rays = sight.rays[::n, ::n]
    sine = np.abs(rays[..., 2]) / np.linalg.norm(rays, axis=-1)
    share = gloss.mirror + (1 - gloss.mirror) * (1 - sine) ** 5
    lamps = _lamps(ground[::n, ::n], rays, sine, gloss) * gloss.brightness
    blur = max(gloss.blur_px * picture.shape[1] / 1280 / n, 0.7)

    def blurred(layer: FloatArray) -> FloatArray:
        return np.asarray(cv2.GaussianBlur(layer, (0, 0), 0.4 * blur, sigmaY=blur))

    lamps *= blurred(roof.astype(np.float32))
    light = (blurred(surroundings) + lamps[..., None]) * share[..., None]
    size = picture.shape[1], picture.shape[0]
    wide = cv2.resize(np.asarray(light, dtype=np.float32), size, interpolation=cv2.INTER_LINEAR)
    keep = cv2.resize(np.asarray(1 - share, dtype=np.float32), size)
    picture *= keep[..., None]
    picture += wide


def _lamps(ground: FloatArray, rays: FloatArray, sine: FloatArray, gloss: Gloss) -> FloatArray:
    """(h, w) light of the lamps where the mirrored rays meet the roof; 1 on average.

    The grid of lamps is a sum of waves, each as much weaker as the rough floor blurs it: the
    blur is longer along the ray by the inverse square of its sine.
    """
    down = np.maximum(rays[..., 2], _BLACK_HOLE)
    flat = rays[..., :2]
    there = ground + gloss.lamp_height_m / down[..., None] * flat
    forward = flat / np.maximum(np.linalg.norm(flat, axis=-1, keepdims=True), 1e-6)
    spread = 2 * gloss.roughness_rad * gloss.lamp_height_m
    along2 = (spread / np.maximum(sine, 0.02) ** 2) ** 2
    light = np.ones(sine.shape, dtype=np.float32)
    for i in range(-_TERMS, _TERMS + 1):
        for j in range(_TERMS + 1):
            if j == 0 and i <= 0:
                continue  # the other half of each pair, and the average
            kx, ky = 2 * np.pi * i / gloss.spacing_m[0], 2 * np.pi * j / gloss.spacing_m[1]
            k_along = kx * forward[..., 0] + ky * forward[..., 1]
            k_across2 = kx * kx + ky * ky - k_along**2
            blurred = gloss.lamp_size_m**2 * (kx * kx + ky * ky)
            blurred = blurred + along2 * k_along**2 + spread**2 * k_across2
            wave = np.cos(kx * there[..., 0] + ky * there[..., 1])
            light += (2 * np.exp(-blurred / 2) * wave).astype(np.float32)
    return np.maximum(light, 0)
