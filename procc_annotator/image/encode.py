"""Pictures as file content."""

from __future__ import annotations

import cv2

from procc_annotator.errors import ImageError
from procc_annotator.image.decode import PixelArray


def encode_png(pixels: PixelArray) -> bytes:
    """A (H, W, 4) BGRA picture as a PNG file's content, without its alpha channel.

    Raises:
        ImageError: it cannot be encoded.
    """
    done, data = cv2.imencode(".png", pixels[:, :, :3])
    if not done:
        raise ImageError("picture", "cannot be written as PNG")
    return data.tobytes()
