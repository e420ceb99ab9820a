"""Bare grounds: grass, a wooden floor, a sheet of plastic, ice."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from drawing.rays import cells, noise_tile

FloatArray = NDArray[np.float32]


def grass(ground: FloatArray, seed: int) -> FloatArray:
    """Mown in stripes. (H, W, 2) metres and a seed -> (H, W, 3) BGR, as all grounds."""
    x, y = ground[..., 0], ground[..., 1]
    random = np.random.default_rng(seed)
    grain = noise_tile(random, 1.2)
    patches = noise_tile(random, 22)
    i, j = cells(x, 9), cells(y, 9)
    stripe = np.tanh(6 * np.sin(np.pi * (x + 52.5) / 5.5))
    light = 1 + 0.075 * stripe + 0.035 * grain[j, i] + 0.03 * patches[j, i]
    off_pitch = (np.abs(x) > 56) | (np.abs(y) > 37.5)
    light = np.where(off_pitch, 0.8 + 0.02 * grain[j, i], light)
    colour = np.array([52, 128, 78], dtype=np.float32)
    return (light[..., None] * colour).astype(np.float32)
