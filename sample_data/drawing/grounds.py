"""Bare grounds: grass, a wooden floor, a sheet of plastic, ice."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from drawing.rays import NOISE_SIDE, cells, noise_tile, noise_tiles

FloatArray = NDArray[np.float32]
Colour = tuple[float, float, float]  # BGR

_PLANK_WIDTH_M, _PLANK_LENGTH_M = 0.083, 1.4


def grass(ground: FloatArray, seed: int) -> FloatArray:
    """Mown in stripes. (H, W, 2) metres and a seed -> (H, W, 3) BGR, as all grounds."""
    x, y = ground[..., 0], ground[..., 1]
    grain, patches = noise_tiles(seed, 1.2, 22)
    i, j = cells(x, 9), cells(y, 9)
    stripe = np.tanh(6 * np.sin(np.pi * (x + 52.5) / 5.5))
    light = 1 + 0.075 * stripe + 0.035 * grain[j, i] + 0.03 * patches[j, i]
    off_pitch = (np.abs(x) > 56) | (np.abs(y) > 37.5)
    light = np.where(off_pitch, 0.8 + 0.02 * grain[j, i], light)
    colour = np.array([52, 128, 78], dtype=np.float32)
    return (light[..., None] * colour).astype(np.float32)


def planks(colour: Colour) -> Callable[[FloatArray, int], FloatArray]:
    """A floor of wooden planks along x, each of its own tone, with its grain."""

    def draw(ground: FloatArray, seed: int) -> FloatArray:
        x, y = ground[..., 0], ground[..., 1]
        random = np.random.default_rng(seed)
        grain, tones = noise_tile(random, 7, 0.7), random.normal(0, 1, (NOISE_SIDE, 64))
        patches = noise_tile(random, 22)
        row = cells(y, 1 / _PLANK_WIDTH_M)
        shifted = x / _PLANK_LENGTH_M + np.mod(row * 0.377, 1)
        column = np.floor(np.clip(shifted, -1e4, 1e4)).astype(np.int32) % 64
        # Where a pixel sees several planks they are one tone: no pattern of their own appears.
        fine = np.clip(1.3 - _per_pixel(y) / _PLANK_WIDTH_M, 0, 1)
        light = 1 + 0.045 * fine * tones[row, column].astype(np.float32)
        light += (
            0.022 * np.clip(1.3 - _per_pixel(y) / 0.025, 0, 1) * grain[cells(y, 80), cells(x, 22)]
        )
        light += 0.012 * patches[cells(y, 6), cells(x, 6)]
        seam = np.abs(np.mod(y / _PLANK_WIDTH_M, 1) - 0.5) > 0.485
        light = np.where(seam, light - 0.07 * fine, light)
        return np.asarray(light[..., None] * np.array(colour), dtype=np.float32)

    return draw


def sheet(colour: Colour) -> Callable[[FloatArray, int], FloatArray]:
    """A floor of plastic: one colour, hardly any grain."""

    def draw(ground: FloatArray, seed: int) -> FloatArray:
        grain, patches = noise_tiles(seed, 1.0, 30)
        i, j = cells(ground[..., 0], 12), cells(ground[..., 1], 12)
        light = 1 + 0.008 * grain[j, i] + 0.012 * patches[j, i]
        return np.asarray(light[..., None] * np.array(colour), dtype=np.float32)

    return draw


def ice(ground: FloatArray, seed: int) -> FloatArray:
    """White with a touch of blue, scratched by skates."""
    # Scratches: where two slow waves of noise are equal, thin curved lines run.
    clouds, one, other = noise_tiles(seed, 40, 9, 7)
    x, y = ground[..., 0], ground[..., 1]
    i, j = cells(x, 14), cells(y, 14)
    fine = np.clip(1.2 - np.maximum(_per_pixel(x), _per_pixel(y)) / 0.12, 0, 1)
    scratched = np.exp(-((one[j, i] / 0.035) ** 2)) + np.exp(-((other[j, i] / 0.03) ** 2))
    light = 1 + 0.01 * clouds[j, i] - 0.035 * fine * scratched
    return np.asarray(light[..., None] * np.array([227, 222, 217]), dtype=np.float32)


def _per_pixel(metres: FloatArray) -> FloatArray:
    """(H, W) metres between neighbouring pixels."""
    return np.asarray(np.hypot(np.gradient(metres, axis=0), np.gradient(metres, axis=1)))
