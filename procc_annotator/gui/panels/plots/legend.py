"""The names of the plotted sources next to their lines."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QPainter, QPaintEvent, QPalette, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from procc_annotator.gui.panels.plots.data import PlottedSource
from procc_annotator.gui.theme import readable
from procc_annotator.translation import tr

# Sources are distinguished without colour, too.
_DASHES: tuple[tuple[float, ...], ...] = ((), (6, 3), (2, 2), (8, 2, 2, 2), (12, 4), (4, 2, 1, 2))
_SYMBOLS = ("o", "s", "t", "d", "+", "x")


def symbol_of(source: PlottedSource) -> str:
    """The symbol of a source, as pyqtgraph calls it."""
    count = len(_SYMBOLS)
    return _SYMBOLS[(source.number + 2 * (source.number // count)) % count]


def dash_of(source: PlottedSource) -> tuple[float, ...]:
    """The dashes of a source; they and its colour together are its own among 36 sources."""
    count = len(_DASHES)
    return _DASHES[(source.number + source.number // count) % count]


def source_pen(source: PlottedSource, palette: QPalette, width: float) -> QPen:
    """The line of a source: its colour, made readable on the theme, and its dashes."""
    pen = QPen(readable(source.colour, palette), width)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    if dash := dash_of(source):
        pen.setDashPattern([d / width * 1.5 for d in dash])
    return pen


_SYMBOL = 8.0  # logical px


class Legend(QWidget):
    """The sources' names next to their lines and symbols, wrapped to the width there is."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("plots_legend")
        self._sources: tuple[tuple[PlottedSource, str], ...] = ()
        policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    @property
    def text(self) -> str:
        """Return what it says."""
        return ", ".join(_entry(source, more) for source, more in self._sources)

    def show_sources(self, sources: Sequence[tuple[PlottedSource, str]]) -> None:
        """Name sources, each with more to say of it (may be empty)."""
        self._sources = tuple(sources)
        self.setVisible(bool(sources))
        self.setAccessibleName(tr("Sources: {names}", names=self.text))
        self.setToolTip(self.text)
        self.updateGeometry()
        self.update()

    def hasHeightForWidth(self) -> bool:
        return True

    def heightForWidth(self, width: int) -> int:
        return round(self._lay_out(width)[1])

    def sizeHint(self) -> QSize:
        return QSize(200, self.heightForWidth(max(self.width(), 200)))

    def minimumSizeHint(self) -> QSize:
        return QSize(0, self.fontMetrics().height() + 2)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        self.paint(painter, self.width())

    def paint(self, painter: QPainter, width: float) -> None:
        """Paint it anywhere, from the painter's origin on."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        text = self.palette().color(QPalette.ColorRole.Text)
        boxes, _ = self._lay_out(width)
        sample = self._sample()
        for (source, more), box in zip(self._sources, boxes, strict=True):
            pen = source_pen(source, self.palette(), 2.0)
            painter.setPen(pen)
            middle = box.center().y()
            painter.drawLine(QPointF(box.left(), middle), QPointF(box.left() + sample, middle))
            _paint_symbol(painter, source, QPointF(box.left() + sample / 2, middle))
            font = self._font(source)
            painter.setFont(font)
            painter.setPen(text)
            words = box.adjusted(sample + 5, 0, 0, 0)
            shown = QFontMetricsF(font).elidedText(
                _entry(source, more), Qt.TextElideMode.ElideMiddle, words.width() + 1
            )
            painter.drawText(
                words, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, shown
            )
        painter.restore()

    def _font(self, source: PlottedSource) -> QFont:
        font = QFont(self.font())
        font.setBold(source.active)
        return font

    def _sample(self) -> float:
        return 2.0 * self.fontMetrics().height()

    def _lay_out(self, width: float) -> tuple[list[QRectF], float]:
        height = self.fontMetrics().height() + 2
        x = y = 0.0
        boxes = []
        for source, more in self._sources:
            metrics = QFontMetricsF(self._font(source))
            own = self._sample() + 6 + metrics.horizontalAdvance(_entry(source, more))
            own = min(own, width)
            if x and x + own > width:
                x, y = 0.0, y + height
            boxes.append(QRectF(x, y, own, height))
            x += own + 14
        return boxes, y + height if boxes else 0.0


def _paint_symbol(painter: QPainter, source: PlottedSource, at: QPointF) -> None:
    from pyqtgraph.graphicsItems.ScatterPlotItem import Symbols  # the plot itself has imported it

    painter.save()
    painter.translate(at)
    painter.scale(_SYMBOL, _SYMBOL)
    painter.fillPath(Symbols[symbol_of(source)], painter.pen().color())
    painter.restore()


def _entry(source: PlottedSource, more: str) -> str:
    name = f"{source.name} ({tr(source.fitted.mark)})" if source.fitted else source.name
    return f"{name} {more}".strip()
