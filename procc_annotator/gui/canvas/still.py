"""Painting overlays that seldom change: from a pixmap of them while the view rests."""

from __future__ import annotations

from collections.abc import Iterable
from typing import cast

from PySide6.QtCore import QRect, QRectF, QSize, Qt
from PySide6.QtGui import QPainter, QPixmap

from procc_annotator.gui.canvas.items import paint_overlay
from procc_annotator.gui.theme import text_times
from procc_annotator.interaction.overlay_primitives import Overlay


class StillOverlay:
    """Overlays that are painted repeatedly at the same place, under something that moves.

    The first time at a place it is painted line by line; the second time into a picture of the
    whole view, which from then on costs next to nothing.
    """

    def __init__(self) -> None:
        self._painted: tuple[object, ...] = ()
        self._picture: QPixmap | None = None

    def paint(
        self,
        painter: QPainter,
        layers: tuple[Overlay, ...],
        *,
        scale: float,
        offset: tuple[float, float],
        clip: QRectF,
        room: QSize,
        seen: QRectF | None = None,
    ) -> None:
        """Paint overlays, the first one lowest.

        Args:
            painter: in coordinates of the view.
            layers, scale, offset, clip: as for `paint_overlay`.
            room: size of the view.
            seen: where in the view the overlay can be seen; texts stay inside. None for all of it.
        """
        ratio = painter.device().devicePixelRatioF()
        times = text_times()
        asked = layers, scale, offset, room, seen, ratio, times
        if asked != self._painted:
            self._painted, self._picture = asked, None
            for overlay in layers:
                paint_overlay(
                    painter, overlay, scale=scale, offset=offset, clip=clip, room=seen,
                    text_times=times,
                )  # fmt: skip
            return
        if self._picture is None:
            self._picture = QPixmap(room * ratio)
            self._picture.setDevicePixelRatio(ratio)
            self._picture.fill(Qt.GlobalColor.transparent)
            own = QPainter(self._picture)
            whole = QRectF(0, 0, room.width(), room.height())
            for overlay in layers:
                paint_overlay(
                    own, overlay, scale=scale, offset=offset, clip=whole, room=seen,
                    text_times=times,
                )  # fmt: skip
            own.end()
        painter.save()
        for place in _exposed(painter, clip):
            painter.setClipRect(place)
            painter.drawPixmap(0, 0, self._picture)
        painter.restore()


def _exposed(painter: QPainter, clip: QRectF) -> list[QRectF]:
    """Return the rectangles that are painted now: Qt blends a pixmap several times as fast within
    one rectangle as within a region of several."""
    region = painter.paintEngine().systemClip()
    if region.isEmpty():
        return [clip]
    to_view, _ = painter.deviceTransform().inverted()
    places = [to_view.mapRect(QRectF(place)) & clip for place in cast(Iterable[QRect], region)]
    return [place for place in places if not place.isEmpty()]
