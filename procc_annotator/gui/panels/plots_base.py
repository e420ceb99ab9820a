"""What all plots share: looks in both themes, the legend, pages that say why they are empty.

pyqtgraph is imported when the first page is made (it takes 0.3 s).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Generic, Literal, TypeVar

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPalette, QPen
from PySide6.QtWidgets import QSizePolicy, QStackedLayout, QVBoxLayout, QWidget

from procc_annotator.gui.panels.common import blend, empty_state, muted
from procc_annotator.session.audit import FrameAudit
from procc_annotator.session.audit_figures import FloatArray, Table, envelope

D = TypeVar("D")

Scope = Literal["frame", "set"]

# Sources are told apart without colour, too.
_DASHES: tuple[tuple[float, ...], ...] = ((), (6, 3), (2, 2), (8, 2, 2, 2), (12, 4), (4, 2, 1, 2))
SYMBOLS = ("o", "s", "t", "d", "+", "x")
_ROOM = 7  # logical px a frame must have for a symbol
_LEAST_CONTRAST = 3.0  # of lines against what is behind them (WCAG 1.4.11)


@dataclass(frozen=True, eq=False)
class PlottedSource:
    """A camera source as plots know it.

    Attributes:
        name, colour: as everywhere in the window; the colour as "#rrggbb".
        number: its place among all sources, which gives its dashes and its symbol.
        audits: by frame name; only of frames that may be shown.
        active: whether it is the one that is judged.
    """

    name: str
    colour: str
    number: int
    audits: Mapping[str, FrameAudit]
    active: bool = False


@dataclass(frozen=True, eq=False)
class PlotRequest:
    """What to plot.

    Attributes:
        sources: the visible ones.
        frames: names of all frames of the dataset, in its order.
        current: position of the frame on screen, -1 without one.
        scope: the frame on screen, or all of them.
        class_row: only points of this class of the field; None for all.
        tau: px.
        size: of the evaluation, px.
        titles: of the classes, by row of the field.
    """

    sources: tuple[PlottedSource, ...]
    frames: tuple[str, ...]
    current: int
    scope: Scope
    class_row: int | None
    tau: float
    size: tuple[int, int]
    titles: tuple[str, ...] = ()

    def audits(self, source: PlottedSource) -> list[FrameAudit]:
        """What the scope holds of a source, in the order of the frames."""
        if self.scope == "frame":
            name = self.frames[self.current] if self.current >= 0 else ""
            found = source.audits.get(name)
            return [] if found is None else [found]
        return [source.audits[name] for name in self.frames if name in source.audits]


class Items:
    """The curves and dots of one set of axes, made once and used again for other data.

    None is ever removed: what Python would collect later, perhaps in a thread that computes, is
    still known to Qt then.
    """

    def __init__(self, plot: Any) -> None:
        self._plot = plot
        self._made: dict[tuple[str, int], Any] = {}
        self._used: set[tuple[str, int]] = set()

    def start(self) -> None:
        """What is not taken from here on is hidden by `finish`."""
        self._used.clear()

    def take(self, kind: str, number: int, make: Callable[[], Any]) -> Any:
        """The item of a kind and a number; made and added the first time."""
        key = kind, number
        item = self._made.get(key)
        if item is None:
            item = self._made[key] = make()
            self._plot.addItem(item)
        self._used.add(key)
        item.setVisible(True)
        return item

    def finish(self) -> None:
        """Hide what was not taken."""
        for key, item in self._made.items():
            if key not in self._used:
                item.setVisible(False)


class PlotPage(QWidget, Generic[D]):
    """One plot; whoever holds it computes its data, perhaps in another thread, and has it drawn.

    Class attributes:
        title: its name in the list of plots.
        scopes: which choices of frames make sense.
        by_class: whether one class can be chosen.
        follows_tau, follows_frame: whether the data (not only a mark) depends on these.
    """

    title = ""
    scopes: tuple[Scope, ...] = ("frame", "set")
    by_class = False
    follows_tau = False

    tauChosen = Signal(float)
    frameChosen = Signal(int)
    readout = Signal(str)  # what is under the cursor; empty when nothing is
    changed = Signal()  # an option of the page: draw it again

    def __init__(self, name: str) -> None:
        super().__init__()
        import pyqtgraph as pg  # see the module's docstring

        self.pg = pg
        self.setObjectName(name)
        self.view = pg.GraphicsLayoutWidget()
        self.view.setBackground(None)
        self.view.setObjectName(f"{name}_view")
        self.view.setAccessibleName(self.title)
        self.view.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.view.ci.layout.setContentsMargins(0, 9, 12, 0)  # figures at the ends of axes
        self.plots: list[Any] = []
        self.items: list[Items] = []
        self.empty = empty_state("", f"{name}_empty")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self._pages = QStackedLayout()
        layout.addLayout(self._pages, 1)  # first: a page of no window would be one for a moment
        self._pages.addWidget(self.view)
        self._pages.addWidget(self.empty)

    # --- to be given by each page ---------------------------------------------------------

    @staticmethod
    def compute(request: PlotRequest) -> D:
        """The data, from any thread."""
        raise NotImplementedError

    def draw(self, data: D, request: PlotRequest) -> str:
        """Show data; what there is to say about it, or an empty text."""
        raise NotImplementedError

    def mark(self, request: PlotRequest) -> None:
        """Show another frame or tau in what is drawn."""

    @staticmethod
    def table(data: D, request: PlotRequest) -> Table:
        """The numbers that are drawn, for a file."""
        raise NotImplementedError

    def restyle(self) -> None:
        """Take over the theme's colours where `dress` does not reach."""

    # --- shared ---------------------------------------------------------------------------

    @property
    def is_empty(self) -> bool:
        """Whether there is nothing but words."""
        return self._pages.currentWidget() is self.empty

    def say_empty(self, why: str) -> None:
        """Show words in place of the plot, or the plot (no words)."""
        self.empty.setText(why)
        self._pages.setCurrentWidget(self.empty if why else self.view)

    def add_plot(self, row: int, bottom: str, left: str, *, movable: bool = True) -> Any:
        """A set of axes with labels."""
        item = self.view.addPlot(row=row, col=0)
        item.setMenuEnabled(False)
        item.hideButtons()
        item.setMouseEnabled(x=movable, y=movable)
        item.setLabel("left", left)
        item.setLabel("bottom", bottom)
        item.showGrid(x=True, y=True, alpha=0.18)
        for side in ("left", "bottom"):
            item.getAxis(side).enableAutoSIPrefix(False)
            item.getAxis(side).setStyle(
                tickFont=self.font(), tickLength=-4, hideOverlappingLabels=False
            )
        self.plots.append(item)
        self.items.append(Items(item))
        self._dress_axes(item)
        return item

    def dots(
        self,
        kind: str,
        number: int,
        source: PlottedSource,
        *,
        size: float,
        alpha: float = 1.0,
        pen: Any = None,
    ) -> Any:
        """Dots with the symbol of a source; they have no data yet."""
        item = self.items[0].take(kind, number, self.pg.ScatterPlotItem)
        item.setSymbol(SYMBOLS[source.number % len(SYMBOLS)], update=False)
        item.setSize(size, update=False)
        item.setPen(pen, update=False)
        item.setBrush(self.colour(source, alpha), update=False)
        return item

    def draw_over_frames(
        self, line: Any, source: PlottedSource, values: FloatArray, span: tuple[float, float, float]
    ) -> None:
        """Show what is in view of values over the frames, with gaps where there are none.

        Args:
            line: an item of the plot.
            values: (F,) of the frames, which are counted from 1 on the axis.
            span: the first and the last place in view, and how many logical px wide that is.
        """
        low, high, width = span
        positions, shown = envelope(values, int(low) - 2, int(high) + 2, max(400, round(4 * width)))
        if not np.isfinite(shown).any():  # pyqtgraph takes the extremes of nothing, and complains
            positions = shown = np.empty(0)
        symbols = width >= _ROOM * (high - low)
        line.setData(
            positions + 1.0,
            shown,
            connect="finite",
            pen=self.pen(source, 1.4),
            symbol=SYMBOLS[source.number % len(SYMBOLS)] if symbols else None,
            symbolSize=7,
            symbolBrush=self.colour(source),
            symbolPen=None,
        )

    def pen(self, source: PlottedSource, width: float = 1.6) -> Any:
        """The line of a source."""
        return source_pen(source, self.palette(), width)

    def colour(self, source: PlottedSource, alpha: float = 1.0) -> QColor:
        """The tone of a source, readable on this theme."""
        colour = readable(source.colour, self.palette())
        colour.setAlphaF(alpha)
        return colour

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "plots"):
            for item in self.plots:
                self._dress_axes(item)
            self.restyle()
            self.changed.emit()

    def _dress_axes(self, item: Any) -> None:
        palette = self.palette()
        text = palette.color(QPalette.ColorRole.Text)
        for side in ("left", "bottom"):
            axis = item.getAxis(side)
            axis.setPen(muted(palette))
            axis.setTextPen(text)
            axis.setLabel(axis.labelText, axis.labelUnits, color=text.name())


class Legend(QWidget):
    """The sources' names beside their lines and symbols, wrapped to the width there is."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("plots_legend")
        self._sources: tuple[tuple[PlottedSource, str], ...] = ()
        policy = QSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        policy.setHeightForWidth(True)
        self.setSizePolicy(policy)

    @property
    def text(self) -> str:
        """What it says."""
        return ", ".join(_entry(source, more) for source, more in self._sources)

    def show_sources(self, sources: Sequence[tuple[PlottedSource, str]]) -> None:
        """Name sources, each with more to say of it (may be empty)."""
        self._sources = tuple(sources)
        self.setVisible(bool(sources))
        self.setAccessibleName(f"Sources: {self.text}")
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


def _entry(source: PlottedSource, more: str) -> str:
    return f"{source.name} {more}".strip()


def source_pen(source: PlottedSource, palette: QPalette, width: float) -> QPen:
    """The line of a source: its colour, made readable on the theme, and its dashes."""
    pen = QPen(readable(source.colour, palette), width)
    pen.setCosmetic(True)
    pen.setCapStyle(Qt.PenCapStyle.FlatCap)
    dash = _DASHES[source.number % len(_DASHES)]
    if dash:
        pen.setDashPattern([d / width * 1.5 for d in dash])
    return pen


def readable(colour: str, palette: QPalette) -> QColor:
    """A colour as it is, or nearer to the text's where it would hardly be seen."""
    base = palette.color(QPalette.ColorRole.Base)
    text = palette.color(QPalette.ColorRole.Text)
    asked = QColor(colour)
    for share in range(10):
        tone = blend(asked, text, share / 10)
        if contrast(tone, base) >= _LEAST_CONTRAST:
            return tone
    return text


def contrast(a: QColor, b: QColor) -> float:
    """The contrast ratio of two colours by WCAG 2, 1 to 21."""
    lighter, darker = sorted((_luminance(a), _luminance(b)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def _luminance(colour: QColor) -> float:
    parts = (
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
        for c in (colour.redF(), colour.greenF(), colour.blueF())
    )
    return sum(share * part for share, part in zip((0.2126, 0.7152, 0.0722), parts, strict=True))
