"""The one item over the picture: paints the overlay, and repaints only what changed."""

from __future__ import annotations

from itertools import zip_longest

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QGraphicsItem, QStyleOptionGraphicsItem, QWidget

from procc_annotator.gui.items import paint_overlay
from procc_annotator.interact.overlay import Labels, Overlay

_MARGIN = 14.0  # points: half a handle with its halo, a line's width
_LETTER, _LINE = 8.5, 24.0  # points: generous bounds of a label's letter and line
_ABOVE = 28.0
_EVERYTHING = 1e6

Positions = NDArray[np.floating]


class OverlayItem(QGraphicsItem):
    """Everything drawn over the picture; scene coordinates are the picture's pixel squares."""

    def __init__(self) -> None:
        super().__init__()
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemUsesExtendedStyleOption)
        self.setZValue(1)
        self.overlay = Overlay((), (), ())
        self._area = QRectF()

    def set_area(self, area: QRectF) -> None:
        """Where anything may be painted (points may lie outside the picture)."""
        self.prepareGeometryChange()
        self._area = QRectF(area)

    def set_overlay(self, overlay: Overlay, scale: float) -> None:
        """Show another overlay; ``scale`` is screen px per picture px, for the reach of marks."""
        changed = changed_area(self.overlay, overlay, scale)
        self.overlay = overlay
        if changed is not None:
            self.update(changed & self._area)

    def boundingRect(self) -> QRectF:
        return self._area

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionGraphicsItem,
        widget: QWidget | None = None,
    ) -> None:
        world = painter.worldTransform()
        clip = world.mapRect(option.exposedRect)
        painter.save()
        painter.resetTransform()
        paint_overlay(
            painter, self.overlay, scale=world.m11(), offset=(world.dx(), world.dy()), clip=clip
        )
        painter.restore()


def changed_area(old: Overlay, new: Overlay, scale: float) -> QRectF | None:
    """What has to be painted again, in scene coordinates; None when nothing changed."""
    area = QRectF()
    point = 1.0 / scale
    margin = _MARGIN * point
    if len(old.strokes) != len(new.strokes) or len(old.marks) != len(new.marks):
        return QRectF(-_EVERYTHING, -_EVERYTHING, 2 * _EVERYTHING, 2 * _EVERYTHING)
    for was, now in zip(old.strokes, new.strokes, strict=True):
        same_look = (was.colour, was.width, was.dash) == (now.colour, now.width, now.dash)
        area |= _difference(was.segments, now.segments, same_look, margin)
    for was_marks, now_marks in zip(old.marks, new.marks, strict=True):
        same_look = (was_marks.colour, was_marks.size, was_marks.shape) == (
            now_marks.colour,
            now_marks.size,
            now_marks.shape,
        )
        area |= _difference(was_marks.centres, now_marks.centres, same_look, margin)
    for was_labels, now_labels in zip_longest(old.labels, new.labels):
        if not _same_labels(was_labels, now_labels):
            area |= _label_area(was_labels, point) | _label_area(now_labels, point)
    return None if area.isNull() else area


def _difference(was: Positions, now: Positions, same_look: bool, margin: float) -> QRectF:
    """Bounds of the rows that differ; rows at both ends that stayed are left out."""
    if was is now and same_look:
        return QRectF()
    if same_look:
        common = min(len(was), len(now))
        differs = (was[:common] != now[:common]).any(axis=1)
        head = int(np.argmax(differs)) if differs.any() else common
        if head == common and len(was) == len(now):
            return QRectF()
        rest = common - head
        tail_differs = (was[len(was) - rest :][::-1] != now[len(now) - rest :][::-1]).any(axis=1)
        tail = int(np.argmax(tail_differs)) if tail_differs.any() else rest
        was, now = was[head : len(was) - tail], now[head : len(now) - tail]
    both = np.concatenate([was.reshape(-1, 2), now.reshape(-1, 2)])
    if not len(both):
        return QRectF()
    (left, top), (right, bottom) = both.min(axis=0).tolist(), both.max(axis=0).tolist()
    # Pixel centres are whole numbers in the overlay and halves in the scene.
    area = QRectF(left + 0.5, top + 0.5, right - left, bottom - top)
    return area.adjusted(-margin, -margin, margin, margin)


def _same_labels(was: Labels | None, now: Labels | None) -> bool:
    if was is None or now is None:
        return was is now
    return was.texts == now.texts and np.array_equal(was.positions, now.positions)


def _label_area(labels: Labels | None, point: float) -> QRectF:
    area = QRectF()
    if labels is None:
        return area
    for (x, y), text in zip(labels.positions.tolist(), labels.texts, strict=True):
        reach = (len(text) * _LETTER + 20) * point
        area |= QRectF(x - reach, y - _ABOVE * point, 2 * reach, (_ABOVE + _LINE) * point)
    return area
