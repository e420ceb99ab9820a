"""Widgets over the picture: name plates, the divider of the split view, blind mode's frame."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QAccessible,
    QColor,
    QFontMetricsF,
    QKeyEvent,
    QMouseEvent,
    QMoveEvent,
    QPainter,
    QPaintEvent,
    QPen,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from procc_annotator.assist.track_anchors import CameraCorrection
from procc_annotator.calibration.single_image.proposal import NONE, SURE
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import State
from procc_annotator.gui.theme import give_role
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.palette import UNSURE_GHOST
from procc_annotator.translation import tr, tr_count, word


class ViewportOverlay(QWidget):
    """A child of the viewport that stays where it is put: a view that scrolls would take it along.

    It lets the mouse through unless it says otherwise.
    """

    def __init__(self, viewport: QWidget, name: str) -> None:
        super().__init__(viewport)
        self.setObjectName(name)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._place = QPoint()
        self.hide()

    def put(self, area: QRect) -> None:
        """Stand here from now on."""
        self._place = area.topLeft()
        self.setGeometry(area)

    def paint_plate(self, painter: QPainter, tone: QColor) -> None:
        """Paint a rounded ground, and go on smoothly and without an outline."""
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(tone)
        painter.drawRoundedRect(QRectF(self.rect()), 4, 4)

    def moveEvent(self, event: QMoveEvent) -> None:
        super().moveEvent(event)
        if self.pos() != self._place:
            self.move(self._place)


_GRIP = QSize(26, 44)
_ABOVE_BOTTOM = 16  # the grip stands low, where it hides the least
_NEAREST_EDGE = 24  # of the divider to an edge of the view
_STEP, _LARGE_STEP = 8, 64
_PLATE = QColor(20, 20, 20, 205)
_LIGHT, _RIM = QColor("#f4f4f4"), QColor("#101010")
_TOP = 10
_SIGNS = {Qt.Key.Key_Left: -1, Qt.Key.Key_Right: 1}


class NamePlate(ViewportOverlay):
    """The name of a source on a dark plate, behind a patch of its colour."""

    def __init__(self, viewport: QWidget, name: str) -> None:
        super().__init__(viewport, name)
        self.text = ""
        self._colour: QColor | None = None
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)

    def say(self, text: str, colour: str) -> None:
        """Show another text."""
        self.text, self._colour = text, QColor(colour)
        self.setAccessibleName(text)
        self.update()

    def wanted_size(self) -> QSize:
        """Room for the whole text."""
        metrics = QFontMetricsF(self.font())
        return QSize(round(metrics.horizontalAdvance(self.text)) + 34, round(metrics.height()) + 10)

    def wanted_height(self, width: int) -> int:
        """Room for the whole text, in as many lines as a width makes of it."""
        room = QRectF(0, 0, width - 32, 0)
        metrics = QFontMetricsF(self.font())
        wrapped = metrics.boundingRect(room, Qt.TextFlag.TextWordWrap, self.text)
        return round(wrapped.height()) + 10

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        self.paint_plate(painter, _PLATE)
        area = QRectF(self.rect())
        if self._colour is not None:
            painter.setPen(QPen(_LIGHT, 1))
            painter.setBrush(self._colour)
            painter.drawRect(QRectF(8.5, area.center().y() - 5, 10, 10))
        painter.setPen(_LIGHT)
        room = area.adjusted(26, 0, -6, 0)
        text = self.text
        if room.height() < self.wanted_height(self.width()):
            middle = Qt.TextElideMode.ElideMiddle
            text = self.fontMetrics().elidedText(text, middle, int(room.width()))
        where = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        painter.drawText(room, where | Qt.TextFlag.TextWordWrap, text)


class _Line(ViewportOverlay):
    """The divider itself: light between two dark lines."""

    WIDTH = 4

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), _RIM)
        painter.fillRect(self.rect().adjusted(1, 0, -1, 0), _LIGHT)


class DividerGrip(ViewportOverlay):
    """Handle of the divider; the only part that takes the mouse."""

    movedTo = Signal(float)  # x in the viewport

    def __init__(self, viewport: QWidget) -> None:
        super().__init__(viewport, "dividerGrip")
        give_role(self, QAccessible.Role.Grip)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents, False)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setCursor(Qt.CursorShape.SplitHCursor)
        self.setToolTip(tr("Drag to move the divider (arrow keys do it too)"))
        self.setAccessibleName(tr("Divider of the split view"))
        self._held_at: float | None = None

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()
        if event.button() == Qt.MouseButton.LeftButton:
            self._held_at = event.position().x() - self.width() / 2

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        event.accept()
        if self._held_at is not None:
            self.movedTo.emit(self.mapToParent(event.position()).x() - self._held_at)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        event.accept()
        self._held_at = None

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        event.accept()

    def event(self, event: QEvent) -> bool:
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.ShortcutOverride
            and event.key() in _SIGNS
        ):
            event.accept()  # elsewhere on the canvas the arrows move points
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        sign = _SIGNS.get(Qt.Key(event.key()))
        if sign is None:
            super().keyPressEvent(event)
            return
        event.accept()
        large = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
        middle = self.x() + self.width() / 2
        self.movedTo.emit(middle + sign * (_LARGE_STEP if large else _STEP))

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        painter.setPen(QPen(_LIGHT, 2 if self.hasFocus() else 1))
        painter.setBrush(_PLATE)
        painter.drawRoundedRect(area, 6, 6)
        middle = area.center()
        painter.setPen(QPen(_LIGHT, 1.6))
        for sign in (-1, 1):
            tip = middle.x() + sign * 8
            back = middle.x() + sign * 4
            painter.drawLine(tip, middle.y(), back, middle.y() - 4)  # type: ignore[call-overload]
            painter.drawLine(tip, middle.y(), back, middle.y() + 4)  # type: ignore[call-overload]


class SplitView(QObject):
    """Line, grip and the two names; says where the divider is, and draws nothing of the picture."""

    moved = Signal(float, float)  # from, to: x in the viewport

    def __init__(self, viewport: QWidget) -> None:
        super().__init__(viewport)
        self._viewport = viewport
        self._share = 0.5
        self.shown = False
        self.top = 0  # screen px that something else covers
        self._line = _Line(viewport, "dividerLine")
        self.grip = DividerGrip(viewport)
        self.left = NamePlate(viewport, "splitLeft")
        self.right = NamePlate(viewport, "splitRight")
        self.grip.movedTo.connect(self.move_to)

    @property
    def x(self) -> float:
        """Return where the divider is in the viewport; it keeps its share of the width."""
        return round(self._share * self._viewport.width())

    def move_to(self, x: float) -> None:
        """Put the divider somewhere else, not out of reach."""
        before, width = self.x, self._viewport.width()
        edge = min(_NEAREST_EDGE, width / 2)
        self._share = min(max(x, edge), width - edge) / max(1, width)
        self.place()
        if self.shown and self.x != before:
            self.moved.emit(before, self.x)

    def show_names(self, left: tuple[str, str], right: tuple[str, str]) -> None:
        """Divide the picture; each side's text and colour stand at its top."""
        self.left.say(*left)
        self.right.say(*right)
        self.shown = True
        self.place()
        for part in (self._line, self.left, self.right, self.grip):
            part.show()
            part.raise_()

    def hide(self) -> None:
        """One picture again."""
        self.shown = False
        for part in (self._line, self.left, self.right, self.grip):
            part.hide()

    def place(self) -> None:
        """Arrange everything in the viewport as it is now."""
        x, size = round(self.x), self._viewport.size()
        self._line.put(QRect(x - _Line.WIDTH // 2, 0, _Line.WIDTH, size.height()))
        top = max(0, size.height() - _ABOVE_BOTTOM - _GRIP.height())
        self.grip.put(QRect(QPoint(x - _GRIP.width() // 2, top), _GRIP))
        wanted, room = self.left.wanted_size(), x - 16
        width = max(0, min(wanted.width(), room))
        self.left.put(QRect(x - 8 - width, _TOP + self.top, width, wanted.height()))
        wanted, room = self.right.wanted_size(), size.width() - x - 16
        width = max(0, min(wanted.width(), room))
        self.right.put(QRect(x + 8, _TOP + self.top, width, wanted.height()))


_WIDTH = 3  # screen px of the frame
_BESIDE = 8
_WORDS = word("Blind: no camera is shown before Ctrl+Enter")
_COMMITTED = word("Blind mode, this frame is committed")


class BlindFrame(QObject):
    """Four edges and a badge; none of them takes the mouse or moves the picture."""

    def __init__(self, services: Services, view: PictureView) -> None:
        viewport = view.viewport()
        super().__init__(viewport)
        self._viewport, self._store = viewport, services.store
        self.edges = [_Edge(viewport, f"blindEdge{i}") for i in range(4)]  # not shown
        self.badge = NamePlate(viewport, "blindBadge")
        view.resized.connect(self._stand_if_shown)
        services.store.watch(_shown, self._show)
        self._show()

    def _stand_if_shown(self) -> None:
        if not self.badge.isHidden():
            self._stand()

    def _show(self) -> None:
        blind, committed = _shown(self._store.state)
        self.badge.say(tr(_COMMITTED if committed else _WORDS), UNSURE_GHOST)
        for part in (*self.edges, self.badge):
            part.setVisible(blind)
        if blind:
            self._stand()

    def _stand(self) -> None:
        width, height = self._viewport.width(), self._viewport.height()
        boxes = (
            QRect(0, 0, width, _WIDTH),
            QRect(0, height - _WIDTH, width, _WIDTH),
            QRect(0, 0, _WIDTH, height),
            QRect(width - _WIDTH, 0, _WIDTH, height),
        )
        for edge, box in zip(self.edges, boxes, strict=True):
            edge.put(box)
        size = self.badge.wanted_size()
        size.setWidth(min(size.width(), width - 2 * _BESIDE))
        left = width - size.width() - _BESIDE
        self.badge.put(QRect(left, height - size.height() - _BESIDE, size.width(), size.height()))


class _Edge(ViewportOverlay):
    """A plain strip."""

    def paintEvent(self, event: QPaintEvent) -> None:
        QPainter(self).fillRect(self.rect(), QColor(UNSURE_GHOST))


def _shown(state: State) -> tuple[bool, bool]:
    """Return whether the mode is on while a frame is on screen, and whether that frame is
    committed."""
    return state.blind and state.frame is not None, state.projection_visible


_MARGIN = 8
_GREY = tones.UNKNOWN_CLASS


class FoundPlate(NamePlate):
    """Says whether a camera is looked for, sure, unsure or none, and why; in words and colour."""

    clicked = Signal()  # where none was found: maybe it is another sport

    def __init__(self, services: Services, view: PictureView) -> None:
        super().__init__(view.viewport(), "foundPlate")
        self._services, self._viewport = services, view.viewport()
        self._soon = after_paint(self, self._show)
        services.prediction.changed.connect(self._soon.start)
        services.store.watch(lambda s: (select.annotation(s), select.mode(s)), self._soon.start)
        view.resized.connect(self._stand)

    def _show(self) -> None:
        said = self._words()
        self.setVisible(said is not None)
        found = self._services.proposals.here
        transparent = Qt.WidgetAttribute.WA_TransparentForMouseEvents
        self.setAttribute(transparent, found is None or found.state != NONE)
        if said is not None:
            self.say(*said)
            self._stand()

    def _stand(self) -> None:
        width = min(self.wanted_size().width(), self._viewport.width() - 2 * _MARGIN)
        height = self.wanted_height(width)
        top = self._viewport.height() - height - _MARGIN
        self.put(QRect(_MARGIN, top, width, height))

    def _words(self) -> tuple[str, str] | None:
        """Text and colour; None where there is nothing to say."""
        services = self._services
        state, foresight = services.state, services.prediction
        if state.frame is None or not services.proposals.allowed:
            return None
        stands_in = foresight.stands_in or services.corrections.rules
        if state.annotation.annotated and not stands_in:
            return None  # the clicks say more
        if (corrected := services.corrections.here) is not None:
            return _of_corrected(corrected, looking=services.corrections.looking)
        if services.shot_track.fit_here is not None:
            doubt = foresight.doubt
            if doubt:
                return tr("Camera of the track, unsure: {why}", why=doubt), tones.UNSURE_GHOST
            return tr("Camera of the track: Shift+Enter accepts its elements"), tones.PASSES
        if services.proposals.working:
            return tr("Looking for the camera in the picture …"), _GREY
        proposal = services.proposals.here
        if proposal is None:
            return None
        why = proposal.reason
        if proposal.state == NONE:
            return tr(
                "No camera found: {why}. To begin, {advice} (Enter takes the first). Another sport?"
                " Click here",
                why=why,
                advice=services.ghosts.advice,
            ), _GREY
        if proposal.state == SURE:
            return tr("Camera found, sure: {why}", why=why), tones.PASSES
        said = tr("Camera found, unsure: {why}. Shift+Enter accepts, Delete rejects it", why=why)
        return said, tones.UNSURE_GHOST

    def mousePressEvent(self, event: QMouseEvent) -> None:
        event.accept()
        self.clicked.emit()


def _of_corrected(corrected: CameraCorrection, *, looking: bool) -> tuple[str, str]:
    pegs = tr_count(len(corrected.pegs), "{n} peg", "{n} pegs")
    if not corrected.looked:
        if looking:
            return tr("Camera dragged, {pegs}: its lines are looked for …", pegs=pegs), _GREY
        return tr("Camera dragged, {pegs}", pegs=pegs), _GREY
    if corrected.why_not:
        why = corrected.why_not
        text = tr("Camera dragged, {pegs}, not made exact: {why}", pegs=pegs, why=why)
        return text, tones.UNSURE_GHOST
    text = tr(
        "Camera dragged, {pegs}, made exact on paint: {share:.0%} of its lines",
        pegs=pegs,
        share=corrected.coverage,
    )
    return text, tones.PASSES
