"""Pictures as arrays of pixels, the way the tools that made the annotations saw them.

Everything becomes 8 bit BGRA: grey is spread over the channels, 16 bit is divided down, an alpha
channel is dropped. An EXIF orientation is applied, as `cv2.imread` and every viewer do, so that
annotation coordinates refer to the upright picture.

A path below a video file, ``match.mp4/00000123``, means that frame of the video (0 is the first).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from procc_annotator.errors import ImageError
from procc_annotator.image.header import require_valid_size, is_truncated_png, header_size
from procc_annotator.image.pixels import PixelArray as PixelArray
from procc_annotator.image.pixels import bgra_from_bgr, require_decodable_size
from procc_annotator.image.video import video_frame_of_path, open_shared_video
from procc_annotator.regular_file import open_regular

# Decoding at a fraction is 3-6 times faster for JPEG, where it skips most of the inverse DCT.
_REDUCED_FLAGS = {
    8: cv2.IMREAD_REDUCED_COLOR_8,
    4: cv2.IMREAD_REDUCED_COLOR_4,
    2: cv2.IMREAD_REDUCED_COLOR_2,
    1: cv2.IMREAD_COLOR,
}


_JPEG = frozenset({".jpg", ".jpeg"})
_HALF_SIZE_MIN_PIXELS = 1_000_000  # of what takes a hand's time to decode


def decode_bgra(path: Path) -> PixelArray:
    """The picture as (H, W, 4) uint8, C-contiguous, opaque and read-only.

    Raises:
        ImageError: it is not a readable picture, or has more than 100 megapixels.
    """
    video_frame = video_frame_of_path(path)
    if video_frame is not None:
        video, number = video_frame
        return open_shared_video(video).frame(number)
    return bgra_from_bgr(_decode(path, _read(path), cv2.IMREAD_COLOR))


def decode_for_camera(path: Path) -> PixelArray:
    """As `decode_bgra`, for a picture that a camera is looked for in.

    Raises:
        ImageError: as there, or it has no shape for that.
    """
    picture = decode_bgra(path)
    require_valid_size(path, picture.shape[1], picture.shape[0])
    return picture


@dataclass(frozen=True, eq=False, slots=True)
class HalfSizeImage:
    """A picture at half its size, to be looked at until the whole one is there.

    Attributes:
        pixels: (h, w, 4) uint8 like `decode_bgra`.
        size: (width, height) px of the whole picture.
    """

    pixels: PixelArray
    size: tuple[int, int]


def decode_half_size(path: Path) -> HalfSizeImage | None:
    """A large JPEG at half its size, in a third of the time; None for any other picture, and for
    one that `decode_bgra` would refuse."""
    if path.suffix.lower() not in _JPEG or video_frame_of_path(path) is not None:
        return None
    try:
        data = _read(path)
        width, height = header_size(data.data) or (0, 0)
        if width * height < _HALF_SIZE_MIN_PIXELS:
            return None
        pixels = bgra_from_bgr(_decode(path, data, _REDUCED_FLAGS[2]))
    except ImageError:
        return None
    for size in ((width, height), (height, width)):  # it may be stored lying on its side
        if pixels.shape[:2] == ((size[1] + 1) // 2, (size[0] + 1) // 2):
            return HalfSizeImage(pixels, size)
    return None


def decode_thumbnail(path: Path, max_side: int = 160) -> PixelArray:
    """A small version, (h, w, 4) uint8 like `decode_bgra`, its longer side at most ``max_side`` px.

    Raises:
        ImageError: it is not a readable picture.
    """
    if video_frame_of_path(path) is not None:
        small = np.ascontiguousarray(downscale_to(decode_bgra(path), max_side))
        small.flags.writeable = False
        return small
    data = _read(path)
    short, long = sorted(header_size(data.data) or (0, 0))
    factor = next((f for f in (8, 4, 2) if long >= f * max_side and short >= f), 1)
    return bgra_from_bgr(downscale_to(_decode(path, data, _REDUCED_FLAGS[factor]), max_side))


def downscale_to(pixels: PixelArray, max_side: int) -> PixelArray:
    """(h, w, c) of a (H, W, c) picture, its longer side at most ``max_side`` px; never enlarged."""
    height, width = pixels.shape[:2]
    scale = max_side / max(height, width)
    if scale >= 1:
        return pixels
    target = max(1, round(width * scale)), max(1, round(height * scale))
    return np.asarray(cv2.resize(pixels, target, interpolation=cv2.INTER_AREA), dtype=np.uint8)


def read_size(path: Path) -> tuple[int, int]:
    """(width, height) in px; of a video's frame that of the video, without decoding the frame.

    Raises:
        ImageError: it is not a readable picture.
    """
    video_frame = video_frame_of_path(path)
    if video_frame is not None:
        return open_shared_video(video_frame[0]).size
    height, width = _decode(path, _read(path), cv2.IMREAD_GRAYSCALE).shape[:2]
    return width, height


def _read(path: Path) -> PixelArray:
    try:
        # cv2.imread cannot open every name on Windows; reading the bytes ourselves can.
        with open_regular(path) as file:
            data = np.fromfile(file, dtype=np.uint8)
    except OSError as error:
        raise ImageError(path, f"cannot be read: {error.strerror or error}") from error
    if not data.size:
        raise ImageError(path, "the file is empty, expected a picture")
    return data


def _decode(path: Path, data: PixelArray, flags: int) -> PixelArray:
    size = header_size(data.data)
    if size is None:  # OpenCV reads more kinds, some of which unpack without any limit
        raise _decode_error(path)
    require_decodable_size(path, *size)
    if is_truncated_png(data.data):
        raise ImageError(path, "the picture cannot be decoded: a part of the file is missing")
    try:
        pixels = cv2.imdecode(data, flags)
    except cv2.error as error:
        raise ImageError(path, f"the picture cannot be decoded: {error.err}") from error
    if pixels is None:
        raise _decode_error(path)
    return np.asarray(pixels, dtype=np.uint8)


def _decode_error(path: Path) -> ImageError:
    return ImageError(path, "the picture cannot be decoded: damaged, or not jpg, png, bmp, webp")
