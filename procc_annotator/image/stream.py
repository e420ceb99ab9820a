"""A video file as OpenCV's FFmpeg reader gives it, with what must not be taken on trust.

OpenCV computes the place of a seek from the mean frame rate, which is wrong for videos with a
varying rate, an edit list or frames stored out of order. Timestamps of decoded frames are right
nearly always, and the packets' timestamps can be listed without decoding (21 ms per thousand):
sorted, they say which number the frame with a given timestamp has.
"""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.errors import ImageError
from procc_annotator.image.pixels import PixelArray, check_size
from procc_annotator.regular_file import read_head

FloatArray = NDArray[np.float64]

_COMPARED = 12  # frames whose timestamps must agree before a list of timestamps is trusted
_SAME_MS = 0.01
_BROKEN_IN_A_ROW = 16
_CONVERT = "convert it, for example with ffmpeg -i old.mp4 -vf yadif -c:v libx264 new.mp4"


def check_file(path: Path) -> None:
    """Refuse what is no video before FFmpeg sees it: it also opens playlists and text.

    Raises:
        ImageError: missing, not a file, empty, or neither mp4, mov, mkv nor avi inside.
    """
    try:
        head = read_head(path, 12)
    except OSError as error:
        raise ImageError(path, f"cannot be read: {error.strerror or error}") from error
    if not head:
        raise ImageError(path, "the file is empty, expected a video")
    boxes = (b"ftyp", b"moov", b"mdat", b"wide", b"free", b"skip", b"pnot")
    known = head[4:8] in boxes or head[:4] == b"\x1a\x45\xdf\xa3"
    if not known and not (head[:4] == b"RIFF" and head[8:12] == b"AVI "):
        raise ImageError(path, "expected a video, this is neither mp4, mov, mkv nor avi inside")


def open_capture(path: Path, *, packets: bool = False) -> cv2.VideoCapture:
    """A reader before its first frame; with ``packets`` it reads without decoding.

    Raises:
        ImageError: FFmpeg finds no video in it, or frames over `MAX_PIXELS`.
    """
    parameters = [cv2.CAP_PROP_FORMAT, -1] if packets else []
    capture = cv2.VideoCapture(str(path), cv2.CAP_FFMPEG, parameters)
    if not capture.isOpened():
        raise ImageError(path, "cannot be opened as a video: damaged, cut off, or without pictures")
    width = capture.get(cv2.CAP_PROP_FRAME_WIDTH)
    height = capture.get(cv2.CAP_PROP_FRAME_HEIGHT)
    check_size(path, int(width), int(height))
    return capture


def grab(capture: cv2.VideoCapture) -> bool:
    """Go on to the next frame that decodes; False at the end."""
    # OpenCV says the same for a broken packet and for the end; after a packet it goes on.
    return any(capture.grab() for _ in range(_BROKEN_IN_A_ROW))


def retrieve(capture: cv2.VideoCapture) -> PixelArray | None:
    """The frame that was grabbed last, (H, W, 3) BGR, turned as its metadata says."""
    done, pixels = capture.retrieve()
    if not done or pixels is None or pixels.ndim != 3 or not pixels.size:
        return None
    return np.asarray(pixels, dtype=np.uint8)


def time_ms(capture: cv2.VideoCapture) -> float:
    """Timestamp of the frame that was grabbed last."""
    return float(capture.get(cv2.CAP_PROP_POS_MSEC))


def number_at(times: FloatArray, time: float) -> int | None:
    """The number of the frame with this timestamp (ms), None if there is none."""
    number = int(np.searchsorted(times, time - _SAME_MS))
    found = number < len(times) and abs(times[number] - time) <= _SAME_MS
    return number if found else None


def frame_times(path: Path) -> FloatArray | None:
    """Timestamps (ms) of all frames in the order they are shown, rising.

    None if they cannot be trusted to number frames (AVI with frames stored out of order, damaged
    files): then only counting from the first frame on is exact. Reads through the whole file.

    Raises:
        ImageError: it cannot be opened.
    """
    packets = open_capture(path, packets=True)
    listed = []
    while grab(packets):
        listed.append(time_ms(packets))
    times = np.sort(np.array(listed, dtype=np.float64))
    if not len(times) or (np.diff(times) <= 2 * _SAME_MS).any():
        return None
    last = _last_time(path, float(times[-1]))
    if last is None:
        return None
    # An edit list hides packets before the first frame and moves the origin of the timestamps.
    times = times - (times[-1] - last)
    times = times[times >= -_SAME_MS]
    first = _first_times(path)
    count = min(len(first), len(times))
    agree = len(first) == min(_COMPARED, len(times)) and bool(
        (np.abs(first[:count] - times[:count]) <= _SAME_MS).all()
    )
    return times if agree else None


def _first_times(path: Path) -> FloatArray:
    capture = open_capture(path)
    times: list[float] = []
    while len(times) < _COMPARED and grab(capture):
        times.append(time_ms(capture))
    return np.array(times)


def _last_time(path: Path, guess_ms: float) -> float | None:
    """Timestamp of the last frame that decodes, None if timestamps fall on the way there."""
    capture = open_capture(path)
    for part in (1.0, 0.9, 0.7, 0.4, 0.0):  # an edit list puts the end before the guess
        capture.set(cv2.CAP_PROP_POS_MSEC, max(0.0, part * guess_ms - 1000))
        last = None
        while grab(capture):
            time = time_ms(capture)
            if last is not None and time <= last:
                return None
            last = time
        if last is not None:
            return last
    return None


def check_decodes(path: Path) -> tuple[int, int]:
    """(width, height) px of the frames as they are shown.

    Raises:
        ImageError: no frame decodes, or decoding silently gives the same picture again and again,
            as some releases of OpenCV do for interlaced video.
    """
    capture = open_capture(path)
    pixels = retrieve(capture) if grab(capture) else None
    if pixels is None:
        raise ImageError(path, "none of its frames can be decoded", advice=_CONVERT)
    height, width = pixels.shape[:2]
    for part in (0.0, 0.5):  # black frames at the start say nothing
        if part:
            capture, pixels = _at_part(path, part, packets=False), None
        if not _stands_still(capture, pixels):
            return width, height
        if _packets_carry_change(path, part, width * height):
            raise ImageError(
                path, "its frames cannot be converted to pictures (interlaced?)", advice=_CONVERT
            )
    return width, height


def _stands_still(capture: cv2.VideoCapture, before: PixelArray | None) -> bool:
    """Whether the next frames show the same as the one before them."""
    for _ in range(_COMPARED):
        if not grab(capture):
            break
        pixels = retrieve(capture)
        if pixels is None:
            break
        if before is not None and not np.array_equal(pixels, before):
            return False
        before = pixels
    return True


def _packets_carry_change(path: Path, part: float, pixel_count: int) -> bool:
    """Whether packets are larger than an encoder needs to say "as before"."""
    capture = _at_part(path, part, packets=True)
    sizes, keys = [], []
    for _ in range(_COMPARED):
        if not grab(capture):
            break
        sizes.append(int(capture.retrieve()[1].size))
        keys.append(bool(capture.get(cv2.CAP_PROP_LRF_HAS_KEY_FRAME)))
    others = [size for size, key in zip(sizes, keys, strict=True) if not key]
    if others:
        return float(np.mean(others)) > pixel_count / 400
    return len(sizes) > 1 and max(sizes) > 1.01 * min(sizes)


def _at_part(path: Path, part: float, *, packets: bool) -> cv2.VideoCapture:
    capture = open_capture(path, packets=packets)
    if part:
        skipped = int(capture.get(cv2.CAP_PROP_FRAME_COUNT) * part)
        capture.set(cv2.CAP_PROP_POS_FRAMES, skipped)
    return capture
