"""Maps in metres over the picture: scene item, legend, and the choice between two maps."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPaintEvent, QPen, QTransform
from PySide6.QtWidgets import QGraphicsItem, QGraphicsScene, QStyleOptionGraphicsItem, QWidget

from procc_annotator.gui.canvas.map_painting import paint_lines, paint_shapes
from procc_annotator.gui.canvas.viewport_overlays import ViewportOverlay
from procc_annotator.gui.state.maps import GroundAccuracy, MapShapes
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.camera_view import DISAGREEMENT, UNCERTAINTY, LevelLine, MapStyle
from procc_annotator.metrics.error_maps import OFFSIDE_ACCURACY_M
from procc_annotator.translation import tr


class MetreMapItem(QGraphicsItem):
    """Lies on the picture, under everything that is annotated or projected."""

    def __init__(self) -> None:
        super().__init__()
        self.setFlag(QGraphicsItem.GraphicsItemFlag.ItemUsesExtendedStyleOption)
        self.setZValue(0.25)
        self._area = QRectF()
        self._shapes: MapShapes | None = None
        self._to_scene = QTransform()

    def show_shapes(
        self,
        shown: MapShapes | None,
        size: tuple[int, int],
        picture_size: tuple[int, int] | None,
    ) -> None:
        """Show another map, or none.

        Args:
            shown: px of ``size``.
            size: (width, height) of the picture whose pixels they are in.
            picture_size: of the picture on screen.
        """
        self.prepareGeometryChange()
        if shown is None or picture_size is None:
            self._shapes, self._area = None, QRectF()
            return
        self._shapes = shown
        self._area = QRectF(0, 0, *picture_size)
        across, down = ((p - 1) / (s - 1) for p, s in zip(picture_size, size, strict=True))
        # Pixel centres are whole numbers in the shapes and halves in the scene.
        self._to_scene = QTransform(across, 0, 0, down, 0.5, 0.5)
        self.update()

    def boundingRect(self) -> QRectF:
        return self._area

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionGraphicsItem,
        widget: QWidget | None = None,
    ) -> None:
        if self._shapes is None:
            return
        world = painter.worldTransform()
        painter.save()
        painter.setClipRect(option.exposedRect, Qt.ClipOperation.IntersectClip)
        painter.resetTransform()
        paint_shapes(painter, self._shapes, self._to_scene * world)
        painter.restore()


_BAR = QSize(252, 12)
_SAMPLE = 36
_EDGE = 8
_WRAPPED = Qt.TextFlag.TextWordWrap.value | Qt.AlignmentFlag.AlignLeft.value
_ONE_LINE = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_PLATE = QColor(20, 20, 20, 215)
_TEXT = QColor("#f4f4f4")


@dataclass(frozen=True, slots=True)
class MapWords:
    """Texts of a map: title, unit, and one per level line."""

    title: str
    unit: str  # a line of its own: titles may be as long as they like
    lines: tuple[str, ...]


class MetreMapLegend(ViewportOverlay):
    """A bar of the bands with their limits in metres, and the lines with what they say; or why
    there is nothing to be seen."""

    def __init__(self, viewport: QWidget) -> None:
        super().__init__(viewport, "metreMapLegend")
        self._viewport = viewport
        self._look = DISAGREEMENT
        self._words: MapWords | None = None
        self.problem = ""

    @property
    def title(self) -> str:
        """Return what the map is of; empty while there is none."""
        return self._words.title if self._words is not None else ""

    @property
    def lines(self) -> tuple[str, ...]:
        """Return what the lines say."""
        return self._words.lines if self._words is not None else ()

    def show_for(self, look: MapStyle, words: MapWords | None, problem: str = "") -> None:
        """Explain a map.

        Args:
            words: None if there are no colours.
            problem: a remark below, or why there is nothing to be seen.
        """
        shown = look, words, problem
        if shown == (self._look, self._words, self.problem) and not self.isHidden():
            return
        self._look, self._words, self.problem = shown
        said = f"{words.title}, {words.unit}. {'; '.join(words.lines)}" if words else ""
        self.setAccessibleName(f"{tr(look.name)}. {said} {problem}")
        self.place()
        self.show()
        self.raise_()
        self.update()

    def place(self) -> None:
        """Stand at the lower left corner of the viewport as it is now."""
        room = self._viewport.size()
        line = math.ceil(QFontMetricsF(self.font()).height())
        width = _BAR.width() + 2 * _EDGE + 12
        height = 2 * _EDGE
        if self._words is not None:
            height += (3 + len(self._words.lines)) * line + _BAR.height() + 8
        if self.problem:
            height += math.ceil(self._problem_room(width).height())
        top = max(0, room.height() - height - _EDGE)
        self.put(QRect(QPoint(_EDGE, top), QSize(width, height)))

    def _problem_room(self, width: int) -> QRectF:
        room = QRectF(0, 0, width - 2 * _EDGE, 1000)
        return QFontMetricsF(self.font()).boundingRect(room, _WRAPPED, self.problem)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        self.paint_plate(painter, _PLATE)
        painter.setPen(_TEXT)
        if self._words is not None:
            self._paint_scale(painter, self._words)
        if self.problem:
            room = self._problem_room(self.width())
            room.moveBottomLeft(QPointF(_EDGE, self.height() - _EDGE))
            painter.drawText(room, _WRAPPED, self.problem)

    def _paint_scale(self, painter: QPainter, words: MapWords) -> None:
        metrics = QFontMetricsF(self.font())
        line = metrics.height()
        room = QRectF(_EDGE, _EDGE, self.width() - 2 * _EDGE, line)
        title = metrics.elidedText(words.title, Qt.TextElideMode.ElideMiddle, room.width())
        painter.drawText(room, _ONE_LINE, title)
        room.translate(0, line)
        painter.drawText(room, _ONE_LINE, words.unit)
        top = _EDGE + 2 * line + 4
        self._paint_bar(painter, top, line)
        top += _BAR.height() + line + 2
        for style, text in zip(self._look.lines, words.lines, strict=True):
            self._paint_line(painter, style, text, QRectF(_EDGE, top, self.width(), line))
            top += line

    def _paint_bar(self, painter: QPainter, top: float, line: float) -> None:
        look = self._look
        cell = _BAR.width() / len(look.colours)
        drawn = {style.metres for style in look.lines}
        for level, colour, i in zip(look.levels_m, look.colours, range(99), strict=False):
            left = _EDGE + 6 + i * cell
            painter.fillRect(QRectF(left, top, cell, _BAR.height()), QColor(colour))
            label = QRectF(left - cell / 2, top + _BAR.height(), cell, line)
            painter.setPen(_TEXT)
            painter.drawText(label, Qt.AlignmentFlag.AlignCenter, f"{level:g}")
            if level in drawn:
                painter.setPen(QPen(QColor(tones.OUTLINE), 1))
                painter.drawLine(QPointF(left, top), QPointF(left, top + _BAR.height()))

    def _paint_line(self, painter: QPainter, style: LevelLine, text: str, room: QRectF) -> None:
        left, middle = _EDGE + 6, room.center().y()
        sample = np.array([[left, middle, left + _SAMPLE, middle]], dtype=np.float64)
        paint_lines(
            painter, sample, QTransform(), tones.HALO,
            width=tones.LIMIT_WIDTH, casing=0.0, dash=style.dash,
        )  # fmt: skip
        painter.setPen(_TEXT)
        painter.drawText(room.adjusted(_SAMPLE + 14, 0, 0, 0), _ONE_LINE, text)


class MetreMaps(QObject):
    """Belongs to the canvas: shows the disagreement of two cameras, or the uncertainty of the
    fitted one; never both."""

    def __init__(self, services: Services, viewport: QWidget, scene: QGraphicsScene) -> None:
        super().__init__(viewport)
        self._services = services
        self._hidden = False
        self.item = MetreMapItem()
        scene.addItem(self.item)
        self.legend = MetreMapLegend(viewport)
        services.disagreement.changed.connect(self._show)
        services.uncertainty.changed.connect(self._show)

    def set_hidden(self, hidden: bool) -> None:
        """Hide the map with the other overlays."""
        if hidden != self._hidden:
            self._hidden = hidden
            self._show()

    def _show(self) -> None:
        if self._hidden or self._services.state.frame is None:
            self._show_nothing()
        elif self._services.uncertainty.enabled:
            self._show_uncertainty()
        else:
            self._show_disagreement()

    def _show_nothing(self) -> None:
        self.item.show_shapes(None, (0, 0), None)
        self.legend.hide()

    def _show_disagreement(self) -> None:
        services, watch = self._services, self._services.disagreement
        found = watch.value
        shown = found.picture if found is not None else None
        self.item.show_shapes(shown, services.state.setup.size, services.state.picture_size)
        if found is not None:
            title = f"{found.names[0]} ↔ {found.names[1]}"
            limit = tr("{metres:g} m, asked of offside technology", metres=OFFSIDE_ACCURACY_M)
            words = MapWords(title, tr("metres on the ground"), (limit,))
            self.legend.show_for(DISAGREEMENT, words, watch.problem)
        elif watch.problem:
            self.legend.show_for(DISAGREEMENT, None, watch.problem)
        else:
            self.legend.hide()

    def _show_uncertainty(self) -> None:
        watch = self._services.uncertainty
        found = watch.value
        if found is None:
            self.item.show_shapes(None, (0, 0), None)
        else:
            size = found.values.fit.size
            self.item.show_shapes(found.picture, size, self._services.state.picture_size)
        if watch.problem:
            self.legend.show_for(UNCERTAINTY, None, watch.problem)
        else:
            self.legend.show_for(UNCERTAINTY, _words(found))


def _words(found: GroundAccuracy | None) -> MapWords:
    """Return what the legend says of the ground; the same room is taken while it is worked out."""
    title, unit = tr("How good the fitted camera is"), tr("metres on the ground, 1 sd")
    lines = []
    for line in UNCERTAINTY.lines:
        share = found.values.share_within_m(line.metres) if found is not None else None
        if share is None:
            lines.append(f"{line.metres:g} m: …")
        else:
            lines.append(
                tr(
                    "{metres:g} m: {percent:.0f} % of the field in sight",
                    metres=line.metres,
                    percent=100 * share,
                )
            )
    if found is not None:
        title = tr("How good the fitted camera ({model}) is", model=found.values.fit.model)
        if (median := found.values.statistics.median) is not None:
            unit = tr("metres on the ground, 1 sd, median {median:.2f}", median=median)
    return MapWords(title, unit, tuple(lines))
