"""How far the field map is magnified, and which part of it is in sight."""

from __future__ import annotations

from PySide6.QtCore import QPointF

_LARGEST = 40.0
_STEP = 1.0015  # an eighth of a degree of the wheel
_DRAG = 4.0  # widget points: less is a click


class MapView:
    """Zoom and shift of a map, changed by hands.

    Attributes:
        zoom: 1 where the whole map is in sight.
        shift: widget points.
        dragging: whether the map is being moved, and the button that is held means no click.
    """

    def __init__(self) -> None:
        self.zoom, self.shift, self.dragging = 1.0, QPointF(), False
        self._pressed: QPointF | None = None
        self._before = QPointF()

    def reset(self) -> None:
        """Show the whole map."""
        self.zoom, self.shift = 1.0, QPointF()

    def wheel(self, turned: float, cursor: QPointF, centre: QPointF) -> None:
        """Magnify; what is under the cursor stays there.

        Args:
            turned: eighths of a degree, forward is larger.
            cursor, centre: the mouse, and the middle of the map's room, widget points.
        """
        zoom = min(_LARGEST, max(1.0, self.zoom * _STEP**turned))
        beside = cursor - centre
        self.shift = beside - (beside - self.shift) * (zoom / self.zoom)
        self.zoom = zoom
        if zoom == 1.0:
            self.shift = QPointF()

    def press(self, cursor: QPointF) -> None:
        """A button went down: the map may be moved from now on."""
        self._pressed, self._before, self.dragging = cursor, self.shift, False

    def move(self, cursor: QPointF) -> bool:
        """The mouse moved; whether the map did."""
        if self._pressed is None or self.zoom == 1.0:
            return False
        moved = cursor - self._pressed
        self.dragging = self.dragging or moved.manhattanLength() > _DRAG
        if self.dragging:
            self.shift = self._before + moved
        return self.dragging

    def release(self) -> bool:
        """The button came up; whether it moved the map."""
        moved, self.dragging, self._pressed = self.dragging, False, None
        return moved
