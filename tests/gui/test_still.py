"""An overlay painted from a picture of it looks as if it were painted line by line."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QRectF, QSize
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtWidgets import QApplication

from procc_annotator.gui.canvas.overlay_item import StillOverlay
from procc_annotator.interaction.overlay_primitives import Labels, Overlay, Strokes

ROOM = QSize(400, 120)
RED = Overlay((Strokes(np.array([[10.0, 5.0, 90.0, 50.0]]), "#ff0000", 3.0),), (), ())
BLUE = Overlay((Strokes(np.array([[10.0, 50.0, 90.0, 5.0]]), "#0000ff", 3.0),), (), ())


def painted(still: StillOverlay, overlay: Overlay, ratio: float, scale: float = 2.0) -> np.ndarray:
    image = QImage(ROOM * ratio, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(QColor("#3f7f3f"))
    painter = QPainter(image)
    area = QRectF(0, 0, ROOM.width(), ROOM.height())
    still.paint(painter, (overlay,), scale=scale, offset=(3.0, 2.0), clip=area, room=ROOM)
    painter.end()
    return np.frombuffer(image.constBits(), np.uint8).astype(int)


@pytest.mark.parametrize("ratio", [1.0, 2.0])
def test_the_second_and_third_time_look_like_the_first(qapp: QApplication, ratio: float) -> None:
    still = StillOverlay()
    first = painted(still, RED, ratio)
    bare = painted(StillOverlay(), Overlay((), (), ()), ratio)
    assert np.abs(first - bare).max() > 150
    for _ in range(2):
        assert np.abs(painted(still, RED, ratio) - first).max() <= 3  # rounding of the smoothing


def test_another_overlay_or_place_is_painted_anew(qapp: QApplication) -> None:
    still = StillOverlay()
    for _ in range(3):
        painted(still, RED, 1.0)
    for overlay, scale in ((BLUE, 2.0), (RED, 2.0), (RED, 1.5)):
        fresh = painted(StillOverlay(), overlay, 1.0, scale)
        assert np.abs(painted(still, overlay, 1.0, scale) - fresh).max() <= 3


def test_texts_stay_in_what_is_seen(qapp: QApplication) -> None:
    label = Labels(np.array([[95.0, 30.0]]), ("Right goal post  ±1.2 px",), "#ffffff")
    still = StillOverlay()
    seen = QRectF(0, 0, ROOM.width() / 2, ROOM.height())
    for _ in range(2):
        image = QImage(ROOM, QImage.Format.Format_RGB32)
        image.fill(QColor("#3f7f3f"))
        painter = QPainter(image)
        area = QRectF(0, 0, ROOM.width(), ROOM.height())
        still.paint(
            painter, (Overlay((), (), (label,)),), scale=2.0, offset=(0.0, 0.0),
            clip=area, room=ROOM, seen=seen,
        )  # fmt: skip
        painter.end()
        pixels = np.frombuffer(image.constBits(), np.uint8).reshape(ROOM.height(), -1, 4)
        assert (pixels[:, : ROOM.width() // 2] != pixels[0, 0]).any()
        assert (pixels[:, ROOM.width() // 2 :] == pixels[0, 0]).all()
