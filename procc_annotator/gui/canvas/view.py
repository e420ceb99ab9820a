"""Looking at a picture: zoom, pan, and where on the picture a screen position is.

A picture pixel (x, y), as annotations count (u * (W - 1), pixel centres at whole numbers), is the
unit square of the scene from (x, y) to (x + 1, y + 1), so that its centre lies at scene
(x + 0.5, y + 0.5). A mouse position names a screen pixel by its top left corner; what the user
points with is that pixel's middle, half a device pixel further.
"""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QHelpEvent,
    QInputDevice,
    QKeyEvent,
    QMouseEvent,
    QNativeGestureEvent,
    QPainter,
    QResizeEvent,
    QTransform,
    QWheelEvent,
)
from PySide6.QtWidgets import QFrame, QGraphicsScene, QGraphicsView

from procc_annotator.gui.canvas.picture_item import PictureItem
from procc_annotator.image.pixels import PixelArray

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


MAX_SCALE = 64.0
_WHEEL_STEP = 1.2
_KEY_STEP = 1.5
_AREA_SHARE, _AREA_SCALE = 0.7, 4.0  # of the view that an area takes, and its largest scale
_AREA_BEYOND = (1 - _AREA_SHARE) / 2  # of the view that may lie beyond the picture's edge for it
_FIT_MARGIN = 6  # screen px around a fitted picture


@dataclass(frozen=True, slots=True)
class ViewPlace:
    """Screen px per picture px, and the picture position in the middle; ``fitted``: all of it."""

    scale: float
    x: float
    y: float
    fitted: bool = False


class PictureView(QGraphicsView):
    """A picture with zoom at the cursor and panning; subclasses get its mouse in picture px."""

    viewChanged = Signal()
    resized = Signal()  # what stands in a corner of it finds its place
    tipWanted = Signal(object)  # a QHelpEvent: the mouse rests

    def __init__(self) -> None:
        super().__init__()
        self.setScene(QGraphicsScene(self))
        self.picture_item = PictureItem()
        self.scene().addItem(self.picture_item)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setViewportUpdateMode(QGraphicsView.ViewportUpdateMode.MinimalViewportUpdate)
        self.setOptimizationFlag(QGraphicsView.OptimizationFlag.DontSavePainterState)
        self.setTransformationAnchor(QGraphicsView.ViewportAnchor.NoAnchor)
        self.setResizeAnchor(QGraphicsView.ViewportAnchor.NoAnchor)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setRenderHint(QPainter.RenderHint.Antialiasing)
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setBackgroundBrush(Qt.GlobalColor.black)
        # All of it is painted by the view itself: Qt need not fill it before.
        self.viewport().setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self._fitted = True
        self._space_held = self._panned = False
        self.pan_tool = False  # whether the left button moves the picture
        self._pan_from: QPoint | None = None
        self._pan_button = Qt.MouseButton.NoButton  # that the mouse moves the picture with

    # --- where things are -----------------------------------------------------------------

    @property
    def view_scale(self) -> float:
        """Screen px (logical) per picture px."""
        return self.transform().m11()

    def to_picture(self, position: QPointF) -> tuple[float, float]:
        """Picture px of a mouse position in the viewport."""
        half = 0.5 / self.devicePixelRatioF()
        inverse, _ = self.viewportTransform().inverted()
        at = inverse.map(position + QPointF(half, half))
        return at.x() - 0.5, at.y() - 0.5

    def to_view(self, x: float, y: float) -> QPointF:
        """Mouse position in the viewport that points at a picture position; undoes `to_picture`."""
        half = 0.5 / self.devicePixelRatioF()
        return self.viewportTransform().map(QPointF(x + 0.5, y + 0.5)) - QPointF(half, half)

    # --- what is shown --------------------------------------------------------------------

    def set_picture(
        self, pixels: PixelArray | None, size: tuple[int, int] | None, *, keep_view: bool = False
    ) -> None:
        """Show a picture of a size, all of it, or with ``keep_view`` at the place and zoom of the
        last one."""
        same_size = self.picture_item.boundingRect().size().toSize().toTuple() == size
        self.picture_item.set_picture(pixels, size)
        if not same_size:
            # Room around the picture, so that its corners can be brought to the middle too.
            area = self.picture_item.boundingRect()
            w, h = area.width(), area.height()
            self.setSceneRect(area.adjusted(-w, -h, w, h))
        if not (same_size and (keep_view or self._fitted)):
            self.fit()

    @property
    def fit_scale(self) -> float:
        """The scale at which the whole picture is just visible."""
        area, room = self.picture_item.boundingRect(), self.viewport().size()
        if area.isEmpty():
            return 1.0
        fitting = min(
            (room.width() - 2 * _FIT_MARGIN) / area.width(),
            (room.height() - 2 * _FIT_MARGIN) / area.height(),
        )
        return min(max(fitting, 1e-3), MAX_SCALE)

    def fit(self) -> None:
        """Show the whole picture; it stays whole when the window is resized."""
        scale = self.fit_scale
        self.setTransform(QTransform.fromScale(scale, scale))
        self.centerOn(self.picture_item.boundingRect().center())
        self._fitted = True
        self.viewChanged.emit()

    def set_scale(self, scale: float, anchor: QPointF | None = None) -> None:
        """Zoom, keeping the picture position under ``anchor`` (viewport; default its middle)."""
        fit = self.fit_scale
        scale = min(max(scale, min(fit, 1.0)), MAX_SCALE)
        if scale == self.view_scale:
            return
        if scale <= fit and fit <= 1.0:
            self.fit()
            return
        at = anchor if anchor is not None else QRectF(self.viewport().rect()).center()
        before = self.to_picture(at)
        self.setTransform(QTransform.fromScale(scale, scale))
        self._scroll_by(self.to_view(*before) - at)
        self._fitted = False
        self.viewChanged.emit()

    def actual_size(self) -> None:
        """One picture pixel on one screen pixel."""
        self.set_scale(1.0 / self.devicePixelRatioF())

    def zoom_in(self) -> None:
        """Magnify about the middle."""
        self.set_scale(self.view_scale * _KEY_STEP)

    def zoom_out(self) -> None:
        """Reduce about the middle."""
        self.set_scale(self.view_scale / _KEY_STEP)

    def fly_to(self, x: float, y: float) -> None:
        """Bring a picture position to the middle, magnified enough to see its pixels' distances."""
        scale = max(self.view_scale, min(MAX_SCALE, max(4.0, 2 * self.fit_scale)))
        self.setTransform(QTransform.fromScale(scale, scale))
        self.centerOn(QPointF(x + 0.5, y + 0.5))
        self._fitted = False
        self.viewChanged.emit()

    def show_area(self, left: float, top: float, right: float, bottom: float) -> None:
        """Bring a part of the picture to the middle, as large as fits with some room around it.

        Never smaller than the whole picture, and not so large that one sees nothing but pixels;
        beyond the picture's edges a rim is shown, so that what is at an edge does not lie at that
        of the view, and more only where the picture is smaller than the view.
        """
        room, picture = self.viewport().size(), self.picture_item.boundingRect()
        across = _AREA_SHARE * room.width() / max(right - left, 1.0)
        down = _AREA_SHARE * room.height() / max(bottom - top, 1.0)
        scale = max(self.fit_scale, min(across, down, max(_AREA_SCALE, 2 * self.fit_scale)))
        if scale == self.fit_scale:
            self.fit()
            return
        x = _within((left + right) / 2, room.width() / scale, picture.width())
        y = _within((top + bottom) / 2, room.height() / scale, picture.height())
        self.show_place(ViewPlace(scale, x, y))

    @property
    def place(self) -> ViewPlace:
        """Zoom and middle of what is shown now."""
        centre = self.mapToScene(self.viewport().rect().center())
        return ViewPlace(self.view_scale, centre.x() - 0.5, centre.y() - 0.5, fitted=self._fitted)

    def show_place(self, place: ViewPlace) -> None:
        """Show what was shown when the view was at a place."""
        if place.fitted:
            self.fit()
            return
        self.setTransform(QTransform.fromScale(place.scale, place.scale))
        self.centerOn(QPointF(place.x + 0.5, place.y + 0.5))
        self._fitted = False
        self.viewChanged.emit()

    # --- panning --------------------------------------------------------------------------

    @property
    def panning(self) -> bool:
        """Return whether the mouse moves the picture now rather than the tool."""
        return self._pan_from is not None

    def _wants_pan(self, event: QMouseEvent) -> bool:
        moves = self._space_held or self.pan_tool
        left = event.button() == Qt.MouseButton.LeftButton and moves
        return event.button() == Qt.MouseButton.MiddleButton or left

    def _scroll_by(self, delta: QPointF) -> None:
        across, down = self.horizontalScrollBar(), self.verticalScrollBar()
        across.setValue(across.value() + round(delta.x()))
        down.setValue(down.value() + round(delta.y()))

    def _pan_to(self, position: QPoint) -> None:
        if self._pan_from is None:
            return
        self.go_along(QPointF(self._pan_from - position))
        self._pan_from = position

    def go_along(self, delta: QPointF) -> None:
        """Scroll by ``delta`` screen px."""
        self._scroll_by(delta)
        self._fitted = False
        self.viewChanged.emit()

    def _ends_pan(self, event: QMouseEvent) -> bool:
        return self.panning and event.button() == self._pan_button

    def _start_pan(self, event: QMouseEvent) -> None:
        self._pan_from, self._panned = event.position().toPoint(), True
        self._pan_button = event.button()
        self.viewport().setCursor(Qt.CursorShape.ClosedHandCursor)

    def _end_pan(self) -> None:
        self._pan_from = None
        self.update_cursor()

    def update_cursor(self) -> None:
        """Show what the mouse would do."""
        moves = self._space_held or self.pan_tool
        shape = Qt.CursorShape.OpenHandCursor if moves else self.tool_cursor()
        self.viewport().setCursor(shape)

    def tool_cursor(self) -> Qt.CursorShape:
        """The cursor of the current tool."""
        return Qt.CursorShape.ArrowCursor

    # --- events ---------------------------------------------------------------------------

    def wheelEvent(self, event: QWheelEvent) -> None:
        moved = gone_along(event)
        if moved is None:
            turned = event.angleDelta().y()
            self.set_scale(self.view_scale * _WHEEL_STEP ** (turned / 120), event.position())
        else:
            self.go_along(-moved)
        event.accept()

    def viewportEvent(self, event: QEvent) -> bool:
        if isinstance(event, QNativeGestureEvent):
            if event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture:
                self.set_scale(self.view_scale * (1 + event.value()), event.position())
                return True
            return False
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            self.tipWanted.emit(event)
            return True
        return super().viewportEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._fitted:
            self.fit()
        self.resized.emit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space:
            if not event.isAutoRepeat():
                self._space_held, self._panned = True, False
                self.update_cursor()
            event.accept()
            return
        event.ignore()  # the scroll area would scroll with the arrows

    def tapped(self, event: QKeyEvent) -> bool:
        """Return whether a key that comes up is the space bar, which panned nothing meanwhile."""
        space = event.key() == Qt.Key.Key_Space and not event.isAutoRepeat()
        return space and self._space_held and not self._panned

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._space_held = False
            self.update_cursor()
            event.accept()
            return
        event.ignore()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._space_held = False
        self._end_pan()
        super().focusOutEvent(event)


def _within(middle: float, shown: float, whole: float) -> float:
    """The middle of what is shown of a row or column of pixels, moved to show no more than a rim
    beyond them."""
    if shown >= whole:
        return whole / 2 - 0.5
    least = (0.5 - _AREA_BEYOND) * shown
    return min(max(middle, least - 0.5), whole - least - 0.5)
