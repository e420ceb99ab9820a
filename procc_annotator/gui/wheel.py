"""Meaning of the wheel and of two fingers over a picture: zoom or scroll."""

from __future__ import annotations

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QInputDevice, QWheelEvent

_STEP_PX = 60.0  # that a notch of a wheel goes along
_NOTCH = 120  # Qt's units of a notch: eighths of a degree


def gone_along(event: QWheelEvent) -> QPointF | None:
    """Return how far what is shown moves, screen px; None for a wheel that zooms.

    Two fingers on a touchpad go along, and zoom with Ctrl held, which is what a pinch comes as
    where there are no gestures; a wheel zooms, and goes along sideways when it is tilted or Shift
    is held.
    """
    if event.modifiers() & Qt.KeyboardModifier.ControlModifier:
        return None
    turned = QPointF(event.angleDelta())
    if _by_fingers(event):
        moved = QPointF(event.pixelDelta())
        return moved if not moved.isNull() else turned * (_STEP_PX / _NOTCH)
    sideways = turned.x()
    if not sideways and event.modifiers() & Qt.KeyboardModifier.ShiftModifier:
        sideways = turned.y()
    return QPointF(sideways * _STEP_PX / _NOTCH, 0.0) if sideways else None


def _by_fingers(event: QWheelEvent) -> bool:
    """A wheel has no phases; on X11 fingers have none either, but their device is a touchpad."""
    touchpad = event.device().type() == QInputDevice.DeviceType.TouchPad
    return touchpad or event.phase() != Qt.ScrollPhase.NoScrollPhase
