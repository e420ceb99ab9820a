"""Overlay pictures without a window: the painter of the canvas, on a picture in memory."""

from __future__ import annotations

import cv2
from PySide6.QtCore import QCoreApplication, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter
from PySide6.QtWidgets import QApplication

from procc_annotator.errors import SaveError
from procc_annotator.gui.picture.items import paint_overlay
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
    unit = max(1.0, width / _WIDTH_OF_POINTS)
    paint_overlay(painter, overlay, scale=1.0, unit=unit)
    _paint_caption(painter, caption(scene), QRectF(0, 0, width, height), unit)
    painter.end()
    done, encoded = cv2.imencode(suffix, pixels[:, :, :3])
    if not done:
        raise SaveError(f"{scene.image_path}: the overlay cannot be encoded as {suffix}")
    return encoded.tobytes()


def caption(scene: Scene) -> str:
    """What the picture shows, with protocol and size beside the number; empty without a score."""
    if scene.score is None or scene.measurement is None:
        return ""
    ground_only = scene.measurement.projected.ground_only
    words = f"JaC@{scene.score.threshold:g} {100 * scene.score.jac:.1f} %"
    labels = ", labels mirrored" if scene.score.mirrored else ""
    return f"{words}  ({scene.setup.describe(ground_only)}{labels})"


def _paint_caption(painter: QPainter, text: str, area: QRectF, unit: float) -> None:
    if not text:
        return
    font = QFont()
    font.setPixelSize(round(14 * unit))
    metrics = QFontMetricsF(font)
    band = QRectF(0, 0, metrics.horizontalAdvance(text) + 16 * unit, metrics.height() + 8 * unit)
    band.moveBottomLeft(area.bottomLeft())
    painter.fillRect(band, QColor(32, 32, 32, 200))
    painter.setFont(font)
    painter.setPen(QColor("white"))
    painter.drawText(band, Qt.AlignmentFlag.AlignCenter, text)
