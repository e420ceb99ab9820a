"""Image arrays (BGRA, uint8): memory layout, size limit, PNG encoding, downscaling and
adjustment for display.
"""

from __future__ import annotations

import threading
import weakref
from collections import deque
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.errors import ImageError

PixelArray = NDArray[np.uint8]

MAX_PIXELS = 100_000_000  # 400 MB once decoded: more than any camera, less than any memory
_PAGE_ALIGNMENT_BYTES = 4096  # a memory page: touching one byte reserves all of it


def require_decodable_size(path: Path, width: int, height: int) -> None:
    """Refuse what would not fit into memory, before it is decoded. `ImageError` for more than
    `MAX_PIXELS`."""
    if width * height > MAX_PIXELS:
        raise ImageError(
            path,
            f"{width} x {height} px, expected at most {MAX_PIXELS // 1_000_000} megapixels",
            advice="make it smaller",
        )


def bgra_from_bgr(pixels: PixelArray) -> PixelArray:
    """(H, W, 4) opaque, C-contiguous and read-only, of (H, W, 3) BGR."""
    result = empty_bgra(pixels.shape[1], pixels.shape[0])
    cv2.cvtColor(pixels, cv2.COLOR_BGR2BGRA, dst=result)
    result.flags.writeable = False  # the cache hands the same array to everybody
    return result


def empty_bgra(width: int, height: int) -> PixelArray:
    """(height, width, 4) to be filled by OpenCV.

    Every page of it is here already: where several of OpenCV's threads come to new memory at once,
    they wait for one another many times as long as the work takes.
    """
    pixels = np.empty((height, width, 4), dtype=np.uint8)
    pixels.reshape(-1)[::_PAGE_ALIGNMENT_BYTES] = 0
    return pixels


def encode_png(pixels: PixelArray) -> bytes:
    """A (H, W, 4) BGRA picture as a PNG file's content, without its alpha channel. `ImageError` if
    it cannot be encoded."""
    done, data = cv2.imencode(".png", pixels[:, :, :3])
    if not done:
        raise ImageError("picture", "cannot be written as PNG")
    return data.tobytes()


Size = tuple[int, int]

_CACHED_IMAGES = 3  # the picture on screen and those that may come next


def downscaled(pixels: PixelArray, size: Size, made: PixelArray | None = None) -> PixelArray:
    """A picture made smaller, to (width, height), without losing thin lines; in memory of its own,
    or in ``made``, which is of that size.

    Below one half, sampling between four neighbours would skip pixels; averaging comes first. It
    is done by whole factors, where it takes a thirtieth of the time.
    """
    factor = 1
    while pixels.shape[1] >= 2 * factor * size[0] and pixels.shape[0] >= 2 * factor * size[1]:
        factor *= 2
    small = pixels
    if factor > 1:
        inner = pixels.shape[1] // factor, pixels.shape[0] // factor
        small = np.asarray(cv2.resize(pixels, inner, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    made = empty_bgra(*size) if made is None else made
    cv2.resize(small, size, dst=made, interpolation=cv2.INTER_LINEAR)
    return made


class DownscaledImages:
    """The last few pictures made smaller; safe to use from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._kept: deque[tuple[weakref.ref[PixelArray], Size, PixelArray]] = deque(
            maxlen=_CACHED_IMAGES
        )
        self._scale: float | None = None
        self._lent: PixelArray | None = None  # what somebody looks at

    def of(self, pixels: PixelArray, scale: float, whole: Size | None = None) -> PixelArray:
        """A picture at a scale below 1, which those that are foreseen are made to from now on. It
        stays as it is until another one is asked for.

        Args:
            whole: (width, height) px that the scale is of, where ``pixels`` are but half as many a
                side; None: there are as many.
        """
        with self._lock:
            self._scale = scale
        self._lent = self._made(pixels, scale, whole)
        return self._lent

    def foresee(self, pixels: PixelArray) -> None:
        """Make a picture as small as the last one that was asked for."""
        with self._lock:
            scale = self._scale
        if scale is not None:
            self._made(pixels, scale, None)

    def _made(self, pixels: PixelArray, scale: float, whole: Size | None) -> PixelArray:
        width, height = whole or (pixels.shape[1], pixels.shape[0])
        size = max(1, round(width * scale)), max(1, round(height * scale))
        with self._lock:
            for kept, kept_size, small in self._kept:
                if kept() is pixels and kept_size == size:
                    return small
        small = downscaled(pixels, size, self._spare(size))
        with self._lock:
            self._kept.append((weakref.ref(pixels), size, small))
        return small

    def _spare(self, size: Size) -> PixelArray | None:
        """The memory of the picture that goes, if no one looks at it: the system takes its time
        over new memory."""
        with self._lock:
            if len(self._kept) < _CACHED_IMAGES:
                return None
            oldest = self._kept.popleft()[2]
        return oldest if oldest is not self._lent and oldest.shape[1::-1] == size else None


MIN_GAMMA, MAX_GAMMA = 0.2, 5.0

_OPAQUE = np.array([0, 0, 0, 255], dtype=np.uint8).view(np.uint32)[0]  # in memory order
_MAX_SLOPE = 4.0  # of the contrast curve at its ends, 1 in the middle
_MAX_GAIN = 4.5  # of lightness differences where there are hardly any, as on even grass
_TARGET_CONTRAST = 36.0  # mean difference of lightness, 0 to 255, where nothing is gained
_NEIGHBOURHOOD = 1 / 40  # of the picture's width: wider than lines, narrower than mown stripes
_LOCAL_REDUCTION = 4  # what is true of a neighbourhood is smooth: few pixels tell it


@dataclass(frozen=True, slots=True)
class DisplayAdjustment:
    """Display of a picture.

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
        """Return whether pixels stay as they are."""
        return not self.enhance and not self._changes_values

    @property
    def _changes_values(self) -> bool:
        return (self.brightness, self.contrast, self.gamma) != (0.0, 0.0, 1.0)


def adjust_image(pixels: PixelArray, look: DisplayAdjustment) -> PixelArray:
    """A picture as a look shows it.

    Args:
        pixels: (H, W, 4) BGRA, opaque; it is not changed.

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


def _local_mean_and_gain(
    light: NDArray[np.uint8],
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:
    """Around each place of a (H, W) picture: the mean, and the factor by which differences to it
    grow; at a fraction of the picture's size."""
    height, width = light.shape
    size = max(1, width // _LOCAL_REDUCTION), max(1, height // _LOCAL_REDUCTION)
    small = cv2.resize(light, size, interpolation=cv2.INTER_AREA).astype(np.float32)
    side = max(3, round(size[0] * _NEIGHBOURHOOD)) | 1
    mean = cv2.blur(small, (side, side))
    # Limited, or a board next to a faint line would pass for a neighbourhood full of differences.
    differences = cv2.blur(np.minimum(np.abs(small - mean), _TARGET_CONTRAST), (side, side))
    gain = np.clip(_TARGET_CONTRAST / (differences + 1.0), 1.0, _MAX_GAIN) - 1.0
    return (
        np.asarray(mean, dtype=np.float32),
        np.asarray(cv2.blur(gain, (side, side)), dtype=np.float32),
    )
