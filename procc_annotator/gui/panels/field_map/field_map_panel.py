"""The field from above: click an element to choose its class; see at a glance what is done."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QAccessible,
    QColor,
    QHelpEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QToolTip

from procc_annotator.calibration.prediction.suggestions import AnnotationSuggestion
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.gui.canvas.finding_sign import paint_finding_sign
from procc_annotator.gui.keymap import key_text
from procc_annotator.gui.panels.element_states import (
    EXPLANATIONS,
    ElementState,
    class_title,
    element_states,
    state_pen,
)
from procc_annotator.gui.panels.field_map.field_shape import FieldShape
from procc_annotator.gui.panels.field_map.painting import (
    MapView,
    Placement,
    nearest,
    paint_badge,
    paint_ground,
    paint_metres,
    paint_spot,
    paint_top_view,
)
from procc_annotator.gui.panels.finding_rows import findings_by_element, reasons_of
from procc_annotator.gui.panels.widgets import Panel
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import give_role, muted
from procc_annotator.interaction import palette as tones
from procc_annotator.translation import tr

_PICK_POINTS = 9.0
_MARGIN = 10.0
_FAINT = 0.25  # opacity of what is out of sight
_RING = 9.0  # radius, around what to annotate next
_WIDTHS = {
    ElementState.UNTOUCHED: 1.0,
    ElementState.ANNOTATED: 2.5,
    ElementState.UNCONFIRMED: 2.5,
    ElementState.PASSES: 2.5,
    ElementState.TOO_FAR: 2.5,
    ElementState.NOT_ANNOTATED: 1.8,
    ElementState.MISSED: 2.5,
    ElementState.NOT_VISIBLE: 1.0,
}
_TO = Qt.AlignmentFlag
_EDGES = (_TO.AlignTop | _TO.AlignHCenter, _TO.AlignRight | _TO.AlignVCenter,
          _TO.AlignBottom | _TO.AlignHCenter, _TO.AlignLeft | _TO.AlignVCenter)  # fmt: skip
_WAYS = {
    Qt.Key.Key_Left: QPointF(-1, 0),
    Qt.Key.Key_Right: QPointF(1, 0),
    Qt.Key.Key_Up: QPointF(0, -1),
    Qt.Key.Key_Down: QPointF(0, 1),
}


class FieldMapPanel(Panel):
    """Displays the state's field, annotation, score, selection and hover; clicks select."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "field_map_panel", (300, 220))
        give_role(self, QAccessible.Role.Canvas)
        self.setAccessibleName(tr("Field map"))
        self.setAccessibleDescription(tr("The arrows choose elements"))
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the canvas
        self.setMouseTracking(True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self._shape = FieldShape.of(services.state.field)
        self._states: dict[str, ElementState] = {}
        self._next: AnnotationSuggestion | None = None
        self._findings: Mapping[str, tuple[StoredFinding, ...]] = {}
        self._view = MapView()
        self._drawn: tuple[tuple[object, ...], Placement] | None = None
        self._follow(
            judged,
            services.review.notVisibleChanged,
            services.label_check.changed,
            services.ghosts.changed,
        )
        # After the canvas was painted, too: no one looks at the map first.
        services.store.watch_visible(
            self,
            self.update,
            lambda s: (s.selection, s.hovered_class, s.projection_visible),
            services.disagreement.changed,
            services.uncertainty.changed,
            services.visible_region.changed,
            services.top_view.changed,
        )
        services.store.watch(lambda s: s.field, self._take_field)
        services.field_choice.preparing.append(FieldShape.of)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, 120)

    def class_at(self, position: QPointF) -> str | None:
        """The class with a line at a position of the widget."""
        placed = self._placement()
        x, y = placed.to_field(position)
        return self._shape.pick(x, y, _PICK_POINTS / placed.scale)

    def to_widget(self, x: float, y: float) -> QPointF:
        """The position in the widget of metres of the map."""
        return self._placement().to_widget(x, y)

    def position_of(self, class_name: str) -> QPointF | None:
        """A point of an element's line in the widget that no other line crosses."""
        if class_name not in self._shape.names:
            return None
        return self._placement().anchors[self._shape.names.index(class_name)]

    def _take_field(self) -> None:
        field = self._services.state.field
        if [e.name for e in field.elements] != list(self._shape.names):
            self._view.reset()
        self._shape = FieldShape.of(field)
        self.update()

    # --- keys ----------------------------------------------------------------------------------

    def keyPressEvent(self, event: QKeyEvent) -> None:
        way = _WAYS.get(Qt.Key(event.key()))
        if way is None or event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
            event.ignore()
            return
        event.accept()
        anchors = dict(zip(self._shape.names, self._placement().anchors, strict=True))
        chosen = self._services.state.selected_class
        if chosen not in anchors:
            self._services.selection.select_class(next(iter(anchors), None), continues=True)
        elif (found := nearest(anchors[chosen], anchors, way)) is not None:
            self._services.selection.select_class(found, continues=True)

    # --- mouse ---------------------------------------------------------------------------------

    def wheelEvent(self, event: QWheelEvent) -> None:
        turned = event.angleDelta().y()
        self._view.wheel(turned, event.position(), self._room().center())
        self.update()
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._view.move(event.position()):
            self.setCursor(Qt.CursorShape.ClosedHandCursor)
            self.update()
            return
        hovered = self.class_at(event.position())
        self._services.selection.hover_class(hovered)
        if hovered is None:
            self.unsetCursor()
        else:
            self.setCursor(Qt.CursorShape.PointingHandCursor)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton):
            self._view.press(event.position())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        moved = self._view.release()
        if moved:
            self.unsetCursor()
        elif event.button() == Qt.MouseButton.LeftButton:
            self._services.selection.select_class(self.class_at(event.position()), continues=True)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if self.class_at(event.position()) is None:
            self._view.reset()
            self.update()

    def leaveEvent(self, event: QEvent) -> None:
        self._services.selection.hover_class(None)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent):
            name = self.class_at(QPointF(event.pos()))
            if name is None:
                QToolTip.hideText()
            else:
                QToolTip.showText(event.globalPos(), self._tip(name), self)
            return True
        return super().event(event)

    def _tip(self, name: str) -> str:
        state = self._states.get(name, ElementState.UNTOUCHED)
        best = _words(self._next) if self._next and name == self._next.name else ""
        reasons = reasons_of(self._findings.get(name, ()))
        lines = (self._heading(name), tr(EXPLANATIONS[state]), best, reasons)
        return "\n".join(filter(None, lines))

    def _heading(self, name: str) -> str:
        title = class_title(self._services.state.field, name)
        keys = key_text(self._services.state.field, name, self._services.state.keymap)
        return f"{title}  ({keys})" if keys else title

    # --- what next -----------------------------------------------------------------------------

    def place_of_next(self) -> QPointF | None:
        """Return where in the widget the element to annotate next is in sight."""
        if self._next is None or self._next.name not in self._shape.names:
            return None
        place = np.array([self._next.place_world])
        ((x, y),) = self._shape.on_map(self._next.name, place).tolist()
        return self._placement().to_widget(x, y)

    def _paint_next(self, painter: QPainter) -> None:
        """A ring around what is in sight of the element to annotate next."""
        if (centre := self.place_of_next()) is None:
            return
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for colour, width in ((tones.OUTLINE, 4.5), (tones.GHOST, 2.5)):
            painter.setPen(QPen(QColor(colour), width))
            painter.drawEllipse(centre, _RING, _RING)

    # --- drawing -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        services = self._services
        shown = element_states(services), findings_by_element(services), services.ghosts.suggestion
        if shown != (self._states, self._findings, self._next):
            self._states, self._findings, self._next = shown
            self.update()

    def _room(self) -> QRectF:
        """The part of the widget that the map has: there is text above and below."""
        # The line of what is next has its room also before there is anything to say.
        lines = 2 if self._services.ghosts.suggesting else 1
        line = self.fontMetrics().height()
        above = line if self._services.state.field.own_terms else 0
        return QRectF(self.rect()).adjusted(
            _MARGIN, _MARGIN + above, -_MARGIN, -_MARGIN - lines * line - 4
        )

    def _placement(self) -> Placement:
        """Return where the field is in the widget; worked out again only when that changes."""
        room, view, turns = self._room(), self._view, self._services.visible_region.turns
        key = self._shape, room.getRect(), view.zoom, view.shift.toTuple(), turns
        if self._drawn is None or self._drawn[0] != key:
            self._drawn = key, Placement.of(self._shape, room, view, turns)
        return self._drawn[1]

    def paintEvent(self, event: QPaintEvent) -> None:
        with QPainter(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Base))
            painter.setClipRect(self._room().adjusted(-_MARGIN, -_MARGIN, _MARGIN, _MARGIN - 2))
            placed = self._placement()
            paint_ground(painter, placed, self._services.visible_region.shown, self.palette())
            if (above := self._services.top_view.value) is not None:
                paint_top_view(painter, placed, above)
            self._paint_metres(painter, placed)
            for index in sorted(range(len(self._shape.names)), key=self._paint_rank):
                painter.setOpacity(_FAINT if self._out_of_sight(self._shape.names[index]) else 1.0)
                self._paint_element(painter, placed, index)
            painter.setOpacity(1.0)
            self._paint_findings(painter)
            self._paint_next(painter)
            painter.setClipping(False)
            self._paint_sides(painter, placed)
            self._paint_captions(painter)

    def _paint_rank(self, index: int) -> tuple[bool, bool, bool]:
        name = self._shape.names[index]
        return (
            name == self._services.state.selected_class,
            name == self._services.state.hovered_class,
            name in self._states,
        )

    def _paint_metres(self, painter: QPainter, placed: Placement) -> None:
        found = self._services.uncertainty.value or self._services.disagreement.value
        if found is not None:
            paint_metres(painter, placed, found.field)

    def _out_of_sight(self, name: str) -> bool:
        """Return whether an element is faint: the camera does not see it, and no one asks for
        it."""
        services = self._services
        if (sight := services.visible_region.shown) is None or name in sight.names:
            return False
        return self._states.get(name) is None and name not in (
            services.state.selected_class,
            services.state.hovered_class,
        )

    def _paint_element(self, painter: QPainter, placed: Placement, index: int) -> None:
        name = self._shape.names[index]
        state = self._states.get(name, ElementState.UNTOUCHED)
        hovered = name == self._services.state.hovered_class
        polygon = placed.polygons[index]
        if polygon.count() == 1:
            chosen = name == self._services.state.selected_class
            paint_spot(
                painter, polygon.at(0), state, self.palette(), chosen=chosen, hovered=hovered
            )
            return
        width = _WIDTHS[state] + (1.0 if hovered else 0.0)
        if name == self._services.state.selected_class:
            painter.setPen(_round_pen(QColor(tones.OUTLINE), width + 6))
            painter.drawPolyline(polygon)
            painter.setPen(_round_pen(QColor(tones.HALO), width + 4))
            painter.drawPolyline(polygon)
        elif hovered:
            painter.setPen(QPen(muted(self.palette(), 0.75), width + 6))
            painter.drawPolyline(polygon)
        painter.setPen(state_pen(state, self.palette(), width))
        painter.drawPolyline(polygon)
        if state in (ElementState.TOO_FAR, ElementState.PASSES):
            paint_badge(painter, placed.anchors[index], state, self.palette())

    def _paint_findings(self, painter: QPainter) -> None:
        """Next to the sign of the verdict, on elements with a finding."""
        for name, found in self._findings.items():
            if (anchor := self.position_of(name)) is not None:
                at = anchor + QPointF(0, -11)
                box = QRectF(at.x() - 7.5, at.y() - 7.5, 15, 15)
                paint_finding_sign(painter, box, found[0].finding.severity)

    def _paint_sides(self, painter: QPainter, placed: Placement) -> None:
        """Name the sides of a map that is turned, as the names of elements have them."""
        names = [tr("far"), tr("right"), tr("near"), tr("left")]  # clockwise, from the top
        turns = self._services.visible_region.turns
        wide = max(map(self.fontMetrics().horizontalAdvance, names)) + 4.0
        area = placed.ground.adjusted(-wide, 0, wide, 0)
        painter.setPen(muted(self.palette()))
        for at, edge in enumerate(_EDGES if turns else ()):
            painter.drawText(area, edge, names[(at - turns) % 4])

    def _paint_captions(self, painter: QPainter) -> None:
        """Paint the field's own dimensions at the top; at the bottom the name under the cursor, or
        of the chosen element, or what a click does, and above it what to annotate next."""
        state = self._services.state
        text, height = self.palette().color(QPalette.ColorRole.Text), self.fontMetrics().height()
        bottom = self.height() - height - 4
        painter.setPen(text)
        self._paint_line(painter, state.field.own_terms, 2)
        if self._next is not None:
            following = tr(
                "Next: {title}, {before:.1f} → {after:.1f} px",
                title=class_title(state.field, self._next.name),
                before=self._next.sd_before_px,
                after=self._next.sd_after_px,
            )
            self._paint_line(painter, following, bottom - height)
        name = state.hovered_class or state.selected_class
        if name is None:
            painter.setPen(muted(self.palette()))
        words = self._heading(name) if name else tr("Click an element")
        self._paint_line(painter, words, bottom)

    def _paint_line(self, painter: QPainter, text: str, top: int) -> None:
        line = QRectF(4, top, self.width() - 8, self.fontMetrics().height())
        text = self.fontMetrics().elidedText(text, Qt.TextElideMode.ElideRight, int(line.width()))
        painter.drawText(line, Qt.AlignmentFlag.AlignCenter, text)


def _words(suggestion: AnnotationSuggestion) -> str:
    return tr(
        "Annotating it next helps most: the projection is then known to {after:.1f} px instead"
        " of {before:.1f} px",
        after=suggestion.sd_after_px,
        before=suggestion.sd_before_px,
    )


def _round_pen(colour: QColor, width: float) -> QPen:
    pen = QPen(colour, width)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    return pen
