"""A picture made easier to see: brightness, contrast, gamma, and worn lines brought out.

Only copies are changed; neither a file nor an array that is handed in.
"""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.image.decode import PixelArray

MIN_GAMMA, MAX_GAMMA = 0.2, 5.0

_OPAQUE = np.array([0, 0, 0, 255], dtype=np.uint8).view(np.uint32)[0]  # in memory order
_MAX_SLOPE = 4.0  # of the contrast curve at its ends, 1 in the middle
_MAX_GAIN = 4.5  # of lightness differences where there are hardly any, as on even grass
_TARGET_CONTRAST = 36.0  # mean difference of lightness, 0 to 255, where nothing is gained
_NEIGHBOURHOOD = 1 / 40  # of the picture's width: wider than lines, narrower than mown stripes
_LOCAL_REDUCTION = 4  # what is true of a neighbourhood is smooth: few pixels tell it


@dataclass(frozen=True, slots=True)
class DisplayAdjustment:
    """How a picture is shown.

    Args:
        brightness: -1 to 1, shifts every value by up to half the range.
        contrast: -1 to 1, stretches values about middle grey, up to fourfold either way.
        gamma: 0.2 to 5; above 1 the dark parts become lighter, black and white stay.
        enhance: whether faint lines are brought out.

    Raises:
        ValueError: a value is outside its range.
    """

    brightness: float = 0.0
    contrast: float = 0.0
    gamma: float = 1.0
    enhance: bool = False

    def __post_init__(self) -> None:
        for name, low, high in (
            ("brightness", -1.0, 1.0),
            ("contrast", -1.0, 1.0),
            ("gamma", MIN_GAMMA, MAX_GAMMA),
        ):
            value = getattr(self, name)
            if not low <= value <= high:
                raise ValueError(f"{name} is {value}, expected {low:g} to {high:g}")

    @property
    def is_identity(self) -> bool:
        """Whether pixels stay as they are."""
        return not self.enhance and not self._changes_values

    @property
    def _changes_values(self) -> bool:
        return (self.brightness, self.contrast, self.gamma) != (0.0, 0.0, 1.0)


def adjust_image(pixels: PixelArray, look: DisplayAdjustment) -> PixelArray:
    """A picture as a look shows it.

    Args:
        pixels: (H, W, 4) BGRA, opaque; it is not changed.
        look: what to do; first lines are brought out, then values are changed.

    Returns:
        The same array when the look is plain, else a new one of the same shape, opaque and
        read-only.
    """
    if look.is_identity:
        return pixels
    shown = _enhance_local_contrast(pixels) if look.enhance else pixels
    if look._changes_values:
        # One table for all channels takes half the time of one with four columns; it changes alpha
        # too, which is put right afterwards.
        shown = np.asarray(cv2.LUT(shown, tone_curve(look)), dtype=np.uint8)
        words = shown.view(np.uint32)
        np.bitwise_or(words, _OPAQUE, out=words)
    shown.flags.writeable = False
    return shown


def tone_curve(look: DisplayAdjustment) -> NDArray[np.uint8]:
    """(256,) what brightness, contrast and gamma make of each value; never falling."""
    values = np.linspace(0.0, 1.0, 256) ** (1.0 / look.gamma)
    values = 0.5 + (values - 0.5) * _MAX_SLOPE**look.contrast + 0.5 * look.brightness
    table: NDArray[np.uint8] = np.rint(255.0 * np.clip(values, 0.0, 1.0)).astype(np.uint8)
    return table


def _enhance_local_contrast(pixels: PixelArray) -> PixelArray:
    """Differences of lightness to the neighbourhood, magnified where there is little of them.

    A worn line differs by a few grey values from grass that is nearly even, and gains most; stands,
    boards and players differ much from their neighbourhoods already, and gain little. The colours
    stay because all channels get the same amount, and lines do not become wider, since what is
    added is proportional to what is there.
    """
    light = np.asarray(cv2.cvtColor(pixels, cv2.COLOR_BGRA2GRAY), dtype=np.uint8)
    size = light.shape[1], light.shape[0]
    mean, gain = _local_mean_and_gain(light)
    # Slightly smoothed: a line is wider than a pixel, the noise of the picture is not.
    excess = cv2.GaussianBlur(light, (0, 0), 0.8).astype(np.float32)
    excess -= cv2.resize(mean, size, interpolation=cv2.INTER_LINEAR)
    excess *= cv2.resize(gain, size, interpolation=cv2.INTER_LINEAR)
    none = np.zeros_like(light)  # for alpha
    lighter = cv2.convertScaleAbs(np.maximum(excess, 0))
    darker = cv2.convertScaleAbs(np.minimum(excess, 0))
    shown = cv2.add(pixels, cv2.merge([lighter, lighter, lighter, none]))
    shown = cv2.subtract(shown, cv2.merge([darker, darker, darker, none]))
    return np.asarray(shown, dtype=np.uint8)


def _local_mean_and_gain(light: NDArray[np.uint8]) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Around each place of a (H, W) picture: the mean, and the factor by which differences to it
    grow; at a fraction of the picture's size."""
    height, width = light.shape
    size = max(1, width // _LOCAL_REDUCTION), max(1, height // _LOCAL_REDUCTION)
    small = cv2.resize(light, size, interpolation=cv2.INTER_AREA).astype(np.float32)
    side = max(3, round(size[0] * _NEIGHBOURHOOD)) | 1
    mean = cv2.blur(small, (side, side))
    # Limited, or a board beside a faint line would pass for a neighbourhood full of differences.
    differences = cv2.blur(np.minimum(np.abs(small - mean), _TARGET_CONTRAST), (side, side))
    gain = np.clip(_TARGET_CONTRAST / (differences + 1.0), 1.0, _MAX_GAIN) - 1.0
    return (
        np.asarray(mean, dtype=np.float32),
        np.asarray(cv2.blur(gain, (side, side)), dtype=np.float32),
    )
