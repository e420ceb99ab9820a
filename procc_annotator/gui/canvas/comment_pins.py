"""Comments at places of the picture: numbered pins that can be clicked."""

from __future__ import annotations

from PySide6.QtCore import QObject, QPointF, Signal
from PySide6.QtGui import QColor, QPainterPath, QPen
from PySide6.QtWidgets import QGraphicsPathItem, QGraphicsRectItem, QGraphicsSimpleTextItem

from procc_annotator.dataset.records import Comment
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction.gestures import Position
from procc_annotator.interaction.palette import HALO, OUTLINE, UNSURE_GHOST

_RADIUS, _HEIGHT = 9.0, 22.0  # screen px: of the head, and of its centre above the place
_ABOVE_LINES = 900.0


class CommentPins(QObject):
    """Pins of the open comments of the frame on screen, of the chosen one, and of a new one."""

    clicked = Signal()

    def __init__(self, services: Services, view: PictureView) -> None:
        super().__init__(view)
        self._services, self._view = services, view
        self._root = QGraphicsRectItem()
        self._root.setZValue(_ABOVE_LINES)
        view.scene().addItem(self._root)
        soon = after_paint(self, self._show)
        for changed in (services.review.statusChanged, services.review.pinsChanged):
            changed.connect(soon.start)
        services.store.watch(select.frame, self._show)

    def set_hidden(self, hidden: bool) -> None:
        """Hide the pins with everything else over the picture, or show them."""
        self._root.setVisible(not hidden)

    def at(self, cursor: QPointF) -> Comment | None:
        """Return the comment whose pin is at a position of the viewport."""
        for _, comment, place in self._pinned() if self._root.isVisible() else ():
            away = cursor - self._view.to_view(*place) + QPointF(0, _HEIGHT)
            if QPointF.dotProduct(away, away) <= (_RADIUS + 1) ** 2:
                return comment
        return None

    def press(self, cursor: QPointF) -> bool:
        """Choose the comment whose pin is clicked; False where there is none."""
        if (comment := self.at(cursor)) is not None:
            self._services.review.point_out(comment.id)
            self.clicked.emit()
        return comment is not None

    def _pinned(self) -> list[tuple[int, Comment, Position]]:
        frame, review = self._services.state.frame, self._services.review
        return [
            (number, comment, comment.place)
            for number, comment in enumerate(review.comments(frame.name) if frame else (), start=1)
            if comment.place and (not comment.resolved or comment.id == review.chosen_comment)
        ]

    def _show(self) -> None:
        for item in self._root.childItems():
            self._view.scene().removeItem(item)
        review = self._services.review
        for number, comment, place in self._pinned():
            self._add(str(number), place, chosen=comment.id == review.chosen_comment)
        if review.new_place is not None:
            self._add("+", review.new_place, chosen=True)

    def _add(self, text: str, place: Position, *, chosen: bool) -> None:
        head, tip = QPainterPath(), QPainterPath()
        head.addEllipse(QPointF(0, -_HEIGHT), _RADIUS, _RADIUS)
        tip.lineTo(-0.6 * _RADIUS, 0.6 * _RADIUS - _HEIGHT)
        tip.lineTo(0.6 * _RADIUS, 0.6 * _RADIUS - _HEIGHT)
        pin = QGraphicsPathItem(head.united(tip), self._root)
        pin.setPen(QPen(QColor(OUTLINE), 1.5))
        pin.setBrush(QColor(HALO if chosen else UNSURE_GHOST))
        pin.setFlag(QGraphicsPathItem.GraphicsItemFlag.ItemIgnoresTransformations)
        pin.setPos(place[0] + 0.5, place[1] + 0.5)  # pixel (0, 0) is the square from (0, 0)
        label = QGraphicsSimpleTextItem(text, pin)
        label.setPos(-QPointF(0, _HEIGHT) - label.boundingRect().center())
