"""Overlay pictures without a window: the painter of the canvas, on a picture in memory."""

from __future__ import annotations

import cv2
from PySide6.QtCore import QCoreApplication
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QApplication

from procc_annotator.errors import SaveError
from procc_annotator.gui.items import paint_overlay
from procc_annotator.image.decode import decode_bgra
from procc_annotator.interact.overlay import build_overlay
from procc_annotator.report.pictures import Scene

# At this width a point is a pixel; lines on larger pictures grow with them, as on a larger sheet.
_WIDTH_OF_POINTS = 1280.0


class OverlayPictures:
    """Called with a scene, gives the picture encoded as ``.png`` or ``.jpg``."""

    def __init__(self, suffix: str) -> None:
        self._suffix = suffix
        # Text needs an application object, though no display; it must outlive the painting.
        self._application = QCoreApplication.instance() or QApplication(
            ["procc-annotator", "-platform", "offscreen"]
        )

    def __call__(self, scene: Scene) -> bytes:
        """The encoded picture.

        Raises:
            ImageError: the picture cannot be decoded.
        """
        return _painted(scene, self._suffix)


def _painted(scene: Scene, suffix: str) -> bytes:
    pixels = decode_bgra(scene.image_path).copy()
    height, width = pixels.shape[:2]
    overlay = build_overlay(
        scene.annotation,
        scene.setup.size,
        scene.setup.field,
        measurement=scene.measurement,
        score=scene.score,
        picture_size=(width, height),
    )
    # Painting goes straight into the array, whose memory the image shares.
    image = QImage(pixels.data, width, height, pixels.strides[0], QImage.Format.Format_RGB32)
    painter = QPainter(image)
    paint_overlay(painter, overlay, scale=1.0, unit=max(1.0, width / _WIDTH_OF_POINTS))
    painter.end()
    done, encoded = cv2.imencode(suffix, pixels[:, :, :3])
    if not done:
        raise SaveError(f"{scene.image_path}: the overlay cannot be encoded as {suffix}")
    return encoded.tobytes()
