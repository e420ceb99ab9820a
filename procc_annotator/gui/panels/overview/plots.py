"""The overview's plots; pyqtgraph is imported when they are made (it takes 0.3 s)."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QLabel, QStackedWidget, QVBoxLayout, QWidget

from procc_annotator.gui.panels.parts import empty_state
from procc_annotator.gui.theme import follow_theme, muted
from procc_annotator.report.window_tables import SetOverview, TimeHistogram
from procc_annotator.translation import tr, word

_UNITS = ((3600, "hours"), (60, "minutes"), (1, "seconds"))
_CAPTIONS = {
    "hours": word("Time per frame in hours"),
    "minutes": word("Time per frame in minutes"),
    "seconds": word("Time per frame in seconds"),
}
_ROUND_TIMES = (1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 18000, 36000)
_MOST_TIMES = 7
_AXIS = 10  # logical px that the left axis takes besides its figures
_BETWEEN = 4  # between the names of bars

Ticks = list[tuple[float, str]]


def count_ticks(highest: int, most: int = 4) -> Ticks:
    """Round whole numbers from 0 up to a count, about as many as asked for."""
    step = 1
    while highest / step > most:
        step = _next_round(step)
    return [(float(value), f"{value:,}") for value in range(0, highest + 1, step)]


def _next_round(step: int) -> int:
    """1, 2, 5, 10, 20, 50, ..."""
    return step * 5 // 2 if str(step)[0] == "2" else step * 2


def time_ticks(histogram: TimeHistogram) -> tuple[Ticks, str]:
    """Ticks at the edges of bars, whose positions are bar numbers, and the unit they are in."""
    step = histogram.step
    longest = len(histogram.counts) * step
    seconds, unit = next((u for u in _UNITS if longest >= 2 * u[0]), _UNITS[-1])
    fitting = (t for t in _ROUND_TIMES if t % step == 0 and longest <= t * _MOST_TIMES)
    apart = next(fitting, _ROUND_TIMES[-1])
    return [(t / step, f"{t / seconds:g}") for t in range(0, longest + 1, apart)], unit


class _Bars(QWidget):
    """A caption, and bars below it or a line that says why there are none."""

    def __init__(self, caption: str, name: str, nothing: str) -> None:
        super().__init__()
        import pyqtgraph as pg  # see the module's docstring

        self._pg = pg
        self.caption = QLabel(caption)
        font = self.caption.font()
        font.setBold(True)
        self.caption.setFont(font)
        self.plot = pg.PlotWidget(background=None)
        follow_theme(self.plot)
        self.plot.setObjectName(name)
        self.plot.setAccessibleName(caption)
        self.plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.plot.setMinimumHeight(90)
        item = self.plot.getPlotItem()
        item.setMenuEnabled(False)
        item.hideButtons()
        item.setMouseEnabled(x=False, y=False)
        item.showGrid(y=True, alpha=0.15)
        for side in ("left", "bottom"):
            item.getAxis(side).setStyle(tickFont=self.font(), tickLength=3)
        self.bars = pg.BarGraphItem(x=[], height=[], width=1)
        item.addItem(self.bars)
        self.pages = QStackedWidget()
        self.pages.addWidget(self.plot)
        self.pages.addWidget(empty_state(nothing, f"{name}_empty"))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addWidget(self.caption)
        layout.addWidget(self.pages, 1)
        self._dress()

    def show_bars(self, counts: Sequence[int], ticks: Ticks, *, start: float, width: float) -> None:
        """Bars at start, start + 1, ...; ``width`` of the room they have."""
        highest = max(counts, default=0)
        self.pages.setCurrentIndex(0 if highest else 1)
        centres = [start + i for i in range(len(counts))]
        self.bars.setOpts(x=centres, height=list(counts), width=width)
        item = self.plot.getPlotItem()
        lines = 1 + max((text.count("\n") for _, text in ticks), default=0)
        item.getAxis("bottom").setHeight(lines * self.fontMetrics().height() + 8)
        item.getAxis("bottom").setTicks([ticks])
        item.getAxis("left").setTicks([count_ticks(highest)])
        item.setXRange(start - 0.8, start + max(len(counts), 1) - 0.3, padding=0)
        item.setYRange(0, max(highest, 1) * 1.05, padding=0)
        item.layout.activate()  # else the names of bars are cut until the next turn

    def names_width(self, names: Sequence[str]) -> int:
        """Return how wide the plot must be for the names of its bars to lie side by side."""
        advance = self.fontMetrics().horizontalAdvance
        widest = max((advance(word) for name in names for word in name.split("\n")), default=0)
        return round((len(names) + 0.5) * (widest + _BETWEEN)) + self.figures_width() + _AXIS

    def figures_width(self) -> int:
        """Return how wide the figures at the left axis are, in logical pixels."""
        ticks = count_ticks(max(self.bars.opts["height"], default=0))
        return max(self.fontMetrics().horizontalAdvance(text) for _, text in ticks)

    def align(self, width: int) -> None:
        """Begin the bars where those of the other plots begin."""
        self.plot.getPlotItem().getAxis("left").setWidth(width + _AXIS)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "pages"):
            self._dress()
        super().changeEvent(event)

    def _dress(self) -> None:
        palette = self.palette()
        item = self.plot.getPlotItem()
        for side in ("left", "bottom"):
            axis = item.getAxis(side)
            axis.setPen(muted(palette))
            axis.setTextPen(palette.color(QPalette.ColorRole.Text))
        highlight = palette.color(QPalette.ColorRole.Highlight)
        self.bars.setOpts(brush=self._pg.mkBrush(highlight), pen=self._pg.mkPen(None))


class OverviewPlots(QWidget):
    """Frames by status, elements per frame, time per frame."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.statuses = _Bars(tr("Frames by status"), "overview_status_plot", tr("No frames"))
        self.elements = _Bars(tr("Elements per frame"), "overview_elements_plot", tr("No frames"))
        self.times = _Bars(
            tr("Time per frame"),
            "overview_times_plot",
            tr("No time yet: it is taken while somebody works on a frame"),
        )
        layout = QVBoxLayout(self)
        layout.setContentsMargins(8, 0, 0, 0)
        layout.setSpacing(6)
        for part in (self.statuses, self.elements, self.times):
            layout.addWidget(part, 1)

    def show_overview(self, overview: SetOverview) -> None:
        """Draw the figures of a set."""
        names: Ticks = [
            (float(i), tr(s.status, "a frame").replace(" ", "\n"))
            for i, s in enumerate(overview.statuses)
        ]
        self.statuses.show_bars([s.frames for s in overview.statuses], names, start=0, width=0.7)
        counts = overview.elements_per_frame
        self.elements.show_bars(counts, count_ticks(len(counts) - 1, 16), start=0, width=0.85)
        histogram = overview.time_histogram
        ticks, unit = time_ticks(histogram)
        caption = tr(_CAPTIONS[unit]) if histogram.counts else tr("Time per frame")
        if histogram.open_ended:
            caption = tr("{caption}; last bar: longer", caption=caption)
        self.times.caption.setText(caption)
        self.times.show_bars(histogram.counts, ticks, start=0.5, width=0.94)
        plots = (self.statuses, self.elements, self.times)
        width = max(plot.figures_width() for plot in plots)
        for plot in plots:
            plot.align(width)
        margins = self.layout().contentsMargins()  # type: ignore[union-attr]
        needed = self.statuses.names_width([name for _, name in names])
        self.setMinimumWidth(needed + margins.left() + margins.right())
