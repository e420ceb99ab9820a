"""What every picture becomes, whatever its file: type, form, the largest that is read; and PNG."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.errors import ImageError

PixelArray = NDArray[np.uint8]

MAX_PIXELS = 100_000_000  # 400 MB once decoded: more than any camera, less than any memory
_PAGE_ALIGNMENT_BYTES = 4096


def require_decodable_size(path: Path, width: int, height: int) -> None:
    """Refuse what would not fit into memory, before it is decoded.

    Raises:
        ImageError: more than `MAX_PIXELS`.
    """
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
    """A (H, W, 4) BGRA picture as a PNG file's content, without its alpha channel.

    Raises:
        ImageError: it cannot be encoded.
    """
    done, data = cv2.imencode(".png", pixels[:, :, :3])
    if not done:
        raise ImageError("picture", "cannot be written as PNG")
    return data.tobytes()
