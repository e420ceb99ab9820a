"""Thumbnails of the rows on screen, decoded in the background.

Rows painted last come first, since what was scrolled past is not examined; of rows painted
together the upper ones.
"""

from __future__ import annotations

import itertools
from collections import OrderedDict
from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from procc_annotator.errors import ImageError
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.image.decoding import FrameCache, decode_thumbnail, downscale_to
from procc_annotator.image.pixels import PixelArray

_KEPT = 150  # 192 x 108 x 4 bytes each: 12 MB
_BATCH = 4
_MOST_WANTED = 60  # more were only scrolled past
_SOON_MS, _HAND_MS = 20, 100  # after a frame is painted; after another look at a busy hand
_SIDE = 192

Decoded = list[tuple[Path, PixelArray | None]]


class Thumbnails(QObject):
    """Small pictures by path. Ask with `image`; `arrived` says of which paths an answer came."""

    arrived = Signal(list)

    def __init__(self, cache: FrameCache, parent: QObject) -> None:
        super().__init__(parent)
        self._cache = cache
        self._images: OrderedDict[Path, QImage | None] = OrderedDict()
        self._wanted: dict[Path, tuple[int, int]] = {}  # what is wanted sooner has less
        self._asked = itertools.count()
        self._looks = 0
        self._look_over = QTimer(self, singleShot=True, interval=0)
        self._work = LatestOnlyTask(self, None)  # unreadable pictures are part of the outcome
        self._start_soon = QTimer(self, singleShot=True, interval=_SOON_MS)
        self._start_soon.timeout.connect(self._start)

    def image(self, path: Path) -> QImage | None:
        """The thumbnail if it is here, else None, and it is fetched; a null image: unreadable."""
        if path in self._images:
            self._images.move_to_end(path)
            return self._images[path] or QImage()
        if not self._look_over.isActive():  # rows are painted together, in one turn
            self._looks += 1
            self._look_over.start()
        self._wanted[path] = (-self._looks, next(self._asked))
        if len(self._wanted) > _MOST_WANTED:
            del self._wanted[max(self._wanted, key=self._wanted.__getitem__)]
        # Anyone who asks again and again, as rows do that are painted often, puts nothing off.
        if not self._start_soon.isActive() and not self._work.running:
            self._start_soon.start(_SOON_MS)
        return None

    def clear(self) -> None:
        """Forget everything; another dataset was opened."""
        self._work.cancel()
        self._images.clear()
        self._wanted.clear()

    def _start(self) -> None:
        if not self._wanted or self._work.running:
            return
        if QApplication.mouseButtons() != Qt.MouseButton.NoButton:
            self._start_soon.start(_HAND_MS)  # whatever the mouse holds comes first
            return
        batch = sorted(self._wanted, key=self._wanted.__getitem__)[:_BATCH]
        for path in batch:
            del self._wanted[path]
        cache = self._cache
        self._work.start(lambda control: _decode(batch, cache, control), self._arrive)

    def _arrive(self, decoded: Decoded) -> None:
        for path, pixels in decoded:
            self._images[path] = None if pixels is None else _to_image(pixels)
            self._wanted.pop(path, None)  # its row was painted again meanwhile
        while len(self._images) > _KEPT:
            self._images.popitem(last=False)
        self.arrived.emit([path for path, _ in decoded])
        self._start()


def _decode(paths: list[Path], cache: FrameCache, control: JobControl) -> Decoded:
    decoded: Decoded = []
    for path in paths:
        if control.cancelled:
            break
        try:
            picture = cache.peek(path)
            small = (
                decode_thumbnail(path, _SIDE) if picture is None else downscale_to(picture, _SIDE)
            )
            decoded.append((path, small))
        except ImageError:
            decoded.append((path, None))
    return decoded


def _to_image(pixels: PixelArray) -> QImage:
    height, width = pixels.shape[:2]
    pixels = np.ascontiguousarray(pixels)
    image = QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32)
    return image.copy()  # owns its memory, whatever becomes of the array
