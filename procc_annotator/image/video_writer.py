"""H.264 video files from pictures."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO

import numpy as np

from procc_annotator.errors import SaveError
from procc_annotator.image.pixels import PixelArray

if TYPE_CHECKING:
    from av.video.stream import VideoStream

_TIME_BASE = Fraction(1, 90_000)
_QUALITY = {"crf": "18", "preset": "veryfast"}


class VideoWriter:
    """Writes one video; the size is that of the first picture, made even.

    Args:
        stream: takes the file; seekable.
        path: its name, for messages.
        fps: frames per second; each picture may have a time of its own.
    """

    def __init__(self, stream: BinaryIO, path: Path, fps: float) -> None:
        import av  # loads FFmpeg

        self._path = path
        self._container = av.open(stream, "w", format="mp4")
        self._rate = Fraction(fps).limit_denominator(1001)
        self._stream: VideoStream | None = None
        self._size = (0, 0)

    def write(self, pixels: PixelArray, time_s: float) -> None:
        """Append a picture.

        Args:
            pixels: (H, W, 3) or (H, W, 4), BGR or BGRA; of the size of the first.
            time_s: when it is shown; later than the one before.

        Raises:
            SaveError: encoding or writing failed, or the picture has another size.
        """
        import av

        height, width = pixels.shape[:2]
        with self._named_failures():
            if self._stream is None:
                self._size = width, height
                self._stream = self._begin(width, height)
            if (width, height) != self._size:
                raise SaveError(
                    f"{self._path}: a picture of {width}x{height} px in a video of"
                    f" {self._size[0]}x{self._size[1]} px: all pictures must have one size"
                )
            even = ((0, height % 2), (0, width % 2), (0, 0))
            frame = av.VideoFrame.from_ndarray(
                np.ascontiguousarray(np.pad(pixels[:, :, :3], even, mode="edge")), format="bgr24"
            )
            frame.time_base, frame.pts = _TIME_BASE, round(time_s / _TIME_BASE)
            self._container.mux(self._stream.encode(frame))

    def close(self) -> None:
        """Finish the file. `SaveError` if writing fails."""
        with self._named_failures():
            if self._stream is not None:
                self._container.mux(self._stream.encode(None))
            self._container.close()

    def _begin(self, width: int, height: int) -> VideoStream:
        stream = self._container.add_stream("libx264", rate=self._rate, options=_QUALITY)
        stream.width, stream.height = width + width % 2, height + height % 2
        stream.pix_fmt = "yuv420p"
        stream.codec_context.time_base = _TIME_BASE
        return stream

    @contextmanager
    def _named_failures(self) -> Iterator[None]:
        import av

        try:
            yield
        except (av.FFmpegError, OSError) as error:
            raise SaveError(f"{self._path}: cannot be written: {error}") from error
