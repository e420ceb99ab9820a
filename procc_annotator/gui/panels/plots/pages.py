"""The plots: JaC over tau and over the frames, errors as a histogram and over the picture."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPalette, QResizeEvent
from PySide6.QtWidgets import QComboBox, QLabel

from procc_annotator.batch.audit import (
    TAU_GRID,
    Arrows,
    FloatArray,
    Histogram,
    PlotData,
    Points,
    cell_arrows,
    envelope,
    gather,
    histogram,
    mean_curve,
    point_arrows,
    timeline,
)
from procc_annotator.batch.frame_sums import AuditBand, mean_band
from procc_annotator.gui.panels.plots.page import (
    PlotPage,
    PlotRequest,
    PlottedSource,
    Scope,
    symbol_of,
)
from procc_annotator.gui.panels.widgets import hbox, named
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU
from procc_annotator.gui.theme import muted
from procc_annotator.translation import tr, tr_count, word

_ROOM = 7  # logical px a frame must have for a symbol
_MARK_EVERY = 70  # logical px between the symbols of a line with more frames
_SMALL = 120  # logical px: a plot less high or wide than this has no line to drag


@dataclass(frozen=True, eq=False)
class JacCurves:
    """Per source: its curve over `TAU_GRID`, and from how many frames; of a set with bands."""

    curves: tuple[FloatArray, ...]
    frames: tuple[int, ...]
    bands: tuple[AuditBand, ...] = ()
    problem: str = ""  # with the table of frames


class TauPage(PlotPage[JacCurves]):
    """JaC over tau, of the frame or as the mean over the set."""

    name = "plot_tau"
    title = word("JaC over tau")
    axes = word("tau (px)"), "JaC"
    movable = False

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self.item.setXRange(0, MAX_TAU, padding=0.01)
        self.item.setYRange(0, 1, padding=0.04)
        self.line = self.pg.InfiniteLine(angle=90, movable=True, bounds=(MIN_TAU, MAX_TAU))
        self.line.setZValue(10)
        set_tau = services.evaluation.set_tau
        self.line.sigDragged.connect(lambda line: set_tau(float(line.value())))
        self.item.addItem(self.line)
        self.restyle()

    @staticmethod
    def compute(request: PlotRequest) -> JacCurves:
        chosen = [request.audits(source) for source in request.sources]
        bands: tuple[AuditBand, ...] = ()
        problem = ""
        if request.scope == "set":
            order, problem = request.order()
            bands = tuple(mean_band(s.audits, request.frames, order) for s in request.sources)
        curves = tuple(mean_curve(some) for some in chosen)
        return JacCurves(curves, tuple(map(len, chosen)), bands, problem)

    def draw(self, data: JacCurves, request: PlotRequest) -> str:
        self.shown = data, request
        self.items.start()
        for source, own in zip(request.sources, data.bands, strict=False):
            self.shade(source, TAU_GRID, own.band.low, own.band.high)
        for source, curve, count in zip(request.sources, data.curves, data.frames, strict=True):
            if count:
                line = self.items.take("curve", source.number, self.pg.PlotCurveItem)
                line.setData(TAU_GRID, curve, pen=self.pen(source))
        self.items.finish()
        self.mark(request)
        self._pages.explain("" if any(data.frames) else request.why_nothing(_nothing(request)))
        said = []
        if request.scope == "set" and len(set(data.frames)) > 1:
            said.append(tr("Each curve is the mean of the frames that source has a camera for."))
        if any(np.isfinite(own.band.low).any() for own in data.bands):
            said.append(tr("Shaded: 95 % bands, {drawn}.", drawn=data.bands[0].clustered))
            said += [data.problem] if data.problem else []
        return " ".join(said)

    def mark(self, request: PlotRequest) -> None:
        if self.line.value() != request.tau:
            self.line.setValue(request.tau)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.line.setVisible(min(self.width(), self.height()) >= _SMALL)

    def restyle(self) -> None:
        text = self.palette().color(QPalette.ColorRole.Text)
        self.line.setPen(self.pg.mkPen(text, width=1, style=Qt.PenStyle.DashLine))
        self.line.setHoverPen(self.pg.mkPen(text, width=3))

    @staticmethod
    def table(data: JacCurves, request: PlotRequest) -> PlotData:
        names = [source.name for source in request.sources]
        header = ["tau_px", *(f"jac {name}" for name in names)]  # not shown
        columns = [TAU_GRID, *data.curves]
        for name, own in zip(names, data.bands, strict=False):
            header += [f"low {name}", f"high {name}"]  # not shown
            columns += [own.band.low, own.band.high]
        return PlotData(tuple(header), tuple(columns))

    def read(self, x: float) -> str:
        if self.shown is None:
            return ""
        data, request = self.shown
        column = int(np.argmin(np.abs(TAU_GRID - x)))
        values = [
            f"{source.name} {curve[column]:.3f}"
            for source, curve, n in zip(request.sources, data.curves, data.frames, strict=True)
            if n
        ]
        return " · ".join([tr("tau {px:.1f} px", px=TAU_GRID[column]), *values])


class TimelinePage(PlotPage[tuple[FloatArray, ...]]):
    """JaC of every frame, NaN if absent, under every source; a click shows the frame."""

    name = "plot_timeline"
    title = word("JaC over the frames")
    axes = word("frame"), "JaC"
    scopes: tuple[Scope, ...] = ("set",)
    follows_tau = True

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self.item.setMouseEnabled(x=True, y=False)
        self.item.disableAutoRange()
        self.item.setYRange(0, 1, padding=0.06)
        self.item.vb.setLimits(yMin=-0.1, yMax=1.1)
        self.here = self.pg.InfiniteLine(angle=90, movable=False)
        self.here.setZValue(-5)
        self.item.addItem(self.here, ignoreBounds=True)
        self._lines: list[tuple[PlottedSource, FloatArray, Any, Any]] = []
        self._frames: tuple[str, ...] = ()
        self.item.vb.sigXRangeChanged.connect(self._thin_out)
        self.view.scene().sigMouseClicked.connect(self._click)
        self.restyle()

    @staticmethod
    def compute(request: PlotRequest) -> tuple[FloatArray, ...]:
        return tuple(timeline(request.frames, s.audits, request.tau) for s in request.sources)

    def draw(self, data: tuple[FloatArray, ...], request: PlotRequest) -> str:
        self.items.start()
        self._lines = []
        for source, values in zip(request.sources, data, strict=True):
            line = self.items.take("line", source.number, self.pg.PlotDataItem)
            marks = self.dots("marks", source, size=8)
            self._lines.append((source, values, line, marks))
        self.items.finish()
        if request.frames != self._frames:
            self._frames = request.frames
            count = len(request.frames)
            self.item.vb.setLimits(xMin=0, xMax=count + 1, minXRange=min(8, count + 1))
            self.item.setXRange(0.5, max(count, 1) + 0.5, padding=0.02)
        self._thin_out()
        self.mark(request)
        nothing = not any(np.isfinite(values).any() for values in data)
        self._pages.explain(request.why_nothing(_nothing(request)) if nothing else "")
        return ""

    def mark(self, request: PlotRequest) -> None:
        self.item.setLabel("left", tr("JaC at {tau:.1f} px", tau=request.tau))
        self.here.setVisible(request.current >= 0)
        self.here.setValue(request.current + 1)

    def restyle(self) -> None:
        text = self.palette().color(QPalette.ColorRole.Text)
        tone = self.palette().color(QPalette.ColorRole.Highlight)
        tone.setAlphaF(0.85)
        self.here.setPen(self.pg.mkPen(tone, width=3))
        self.item.setLabel("bottom", tr("frame"), color=text.name())

    @staticmethod
    def table(data: tuple[FloatArray, ...], request: PlotRequest) -> PlotData:
        names = (f"jac@{request.tau:g} {source.name}" for source in request.sources)  # not shown
        numbers = np.arange(1, len(request.frames) + 1)
        return PlotData(("number", "frame", *names), (numbers, request.frames, *data))

    def frame_at(self, scene: QPointF) -> int:
        """The frame a position of the scene belongs to, -1 next to the plot."""
        if not self.item.vb.sceneBoundingRect().contains(scene) or not self._frames:
            return -1
        return self._frame_near(float(self.item.vb.mapSceneToView(scene).x()))

    def _frame_near(self, x: float) -> int:
        return min(max(round(x), 1), len(self._frames)) - 1

    def _thin_out(self) -> None:
        """Give each line no more points than the screen can show."""
        low, high = self.item.vb.viewRange()[0]
        for source, values, line, marks in self._lines:
            self._draw_line(line, marks, source, values, (low, high, self.item.vb.width()))

    def _draw_line(
        self,
        line: Any,
        marks: Any,
        source: PlottedSource,
        values: FloatArray,
        span: tuple[float, float, float],
    ) -> None:
        """Show what is in view of values over the frames, with gaps where there are none.

        Args:
            line, marks: a curve and dots of the plot, for the source alone.
            values: (F,) of the frames, which are counted from 1 on the axis.
            span: the first and the last place in view, and how many logical px wide that is.
        """
        low, high, width = span
        positions, shown = envelope(values, int(low) - 2, int(high) + 2, max(400, round(4 * width)))
        if not np.isfinite(shown).any():  # pyqtgraph takes the extremes of nothing, and complains
            positions = shown = np.empty(0)
        symbols = width >= _ROOM * (high - low)
        pen = self.pen(source, 1.4)
        if 2 * (high - low) > width:  # dashes cannot be distinguished there, and take long to paint
            pen = self.pg.mkPen(self.colour(source), width=1)
        line.setData(
            positions + 1.0,
            shown,
            connect="finite",
            pen=pen,
            symbol=symbol_of(source) if symbols else None,
            symbolSize=7,
            symbolBrush=self.colour(source),
            symbolPen=None,
        )
        at = np.empty(0, dtype=int) if symbols else _sparse(values, source.number, span)
        marks.setData(x=at + 1.0, y=values[at])

    def read(self, x: float) -> str:
        if not self._frames:
            return ""
        index = self._frame_near(x)
        values = [
            f"{source.name} {values[index]:.3f}" if np.isfinite(values[index]) else
            f"{source.name} –"
            for source, values, *_ in self._lines
        ]  # fmt: skip
        frame = tr("{name} (frame {n})", name=self._frames[index], n=index + 1)
        return " · ".join([frame, *values])

    def _click(self, event: Any) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            index = self.frame_at(event.scenePos())
            if index >= 0:
                event.accept()
                self.services.navigator.go_to(index)


def _nothing(request: PlotRequest) -> str:
    """Return why there is no curve."""
    if request.scope == "frame":
        return tr("No score of this frame: it is not annotated, or no shown source has its camera.")
    return tr("No scores yet. They are computed in the background, frame by frame.")


def _sparse(values: FloatArray, number: int, span: tuple[float, float, float]) -> Any:
    """(m,) positions of a few values in view, evenly apart; other numbers get others in between.
    The span is that of `TimelinePage._draw_line`."""
    low, high, width = span
    step = max(1.0, _MARK_EVERY * (high - low) / max(width, 1.0))
    wanted = np.arange(0.0, len(values), step) + step * (number % 6) / 6
    known = np.flatnonzero(np.isfinite(values))
    wanted = wanted[(wanted >= low - 1) & (wanted <= high - 1)]
    if not len(known) or not len(wanted):
        return np.empty(0, dtype=int)
    after = np.minimum(np.searchsorted(known, wanted), len(known) - 1)
    found = known[after]
    return np.unique(found[np.abs(found - wanted) <= step / 2])


@dataclass(frozen=True, eq=False)
class ErrorBars:
    """The histogram and, per source, the points it counts."""

    bars: Histogram
    points: tuple[Points, ...]


class HistogramPage(PlotPage[ErrorBars]):
    """Histogram of the errors, overall or of one class."""

    name = "plot_histogram"
    title = word("Errors, as a histogram")
    axes = word("reprojection error (px)"), word("points")
    movable = False
    by_class = True

    @staticmethod
    def compute(request: PlotRequest) -> ErrorBars:
        points = tuple(gather(request.audits(s), request.class_row) for s in request.sources)
        return ErrorBars(histogram([p.errors_px for p in points]), points)

    def draw(self, data: ErrorBars, request: PlotRequest) -> str:
        self.shown = data, request
        self.items.start()
        edges = data.bars.edges
        several = len(request.sources) > 1
        for source, counts in zip(request.sources, data.bars.counts, strict=True):
            if counts.any():
                steps = self.items.take("bars", source.number, self.pg.PlotCurveItem)
                steps.setData(
                    np.asarray(edges, dtype=float),
                    np.asarray(counts, dtype=float),
                    stepMode="center",
                    fillLevel=0,
                    brush=self.pg.mkBrush(self.colour(source, 0.12 if several else 0.35)),
                    pen=self.pen(source),
                )
        self.items.finish()
        highest = max((int(c.max()) for c in data.bars.counts if len(c)), default=0)
        self.item.setXRange(0, float(edges[-1]), padding=0.01)
        self.item.setYRange(0, max(highest, 1) * 1.05, padding=0)
        self.item.getAxis("left").setTicks([_count_ticks(highest)])
        self._pages.explain("" if highest else no_points(request))
        beyond = tr("The last bar holds all larger errors.") if data.bars.open_ended else ""
        return " ".join(filter(None, (beyond, left_out(data.points))))

    @staticmethod
    def table(data: ErrorBars, request: PlotRequest) -> PlotData:
        edges = data.bars.edges
        upper = edges[1:].astype(float)
        if data.bars.open_ended:
            upper[-1] = np.nan
        names = (f"points {source.name}" for source in request.sources)  # not shown
        return PlotData(("from_px", "below_px", *names), (edges[:-1], upper, *data.bars.counts))

    def read(self, x: float) -> str:
        if self.shown is None:
            return ""
        data, request = self.shown
        edges = data.bars.edges
        bar = int(np.searchsorted(edges, x, side="right")) - 1
        if not 0 <= bar < len(edges) - 1:
            return ""
        last = data.bars.open_ended and bar == len(edges) - 2
        interval = f"{edges[bar]:g}-{edges[bar + 1]:g} px"
        if last:
            interval = tr("{px:g} px or more", px=edges[bar])
        counts = [
            tr(
                "{name} {part:,} of {total:,}",
                name=source.name,
                part=counts[bar],
                total=counts.sum(),
            )
            for source, counts in zip(request.sources, data.bars.counts, strict=True)
        ]
        return " · ".join([interval, *counts])


def _count_ticks(highest: int, most: int = 4) -> list[tuple[float, str]]:
    """Return round whole numbers from 0 up to a count, ``most`` or one more of them."""
    steps = (digit * 10**power for power in itertools.count() for digit in (1, 2, 5))
    step = next(step for step in steps if highest / step <= most)
    return [(float(value), f"{value:,}") for value in range(0, highest + 1, step)]


def no_points(request: PlotRequest) -> str:
    """Return why there is no point to plot."""
    here = request.scope == "frame"
    if request.class_row is not None and request.class_row < len(request.titles):
        title = tr(request.titles[request.class_row])
        if here:
            why = tr("No point of {element} in this frame.", element=title)
        else:
            why = tr("No point of {element} so far.", element=title)
    elif here:
        why = tr("No annotated point that a shown source projects in this frame.")
    else:
        why = tr("No annotated point that a shown source projects so far.")
    return request.why_nothing(why)


def left_out(points: tuple[Points, ...]) -> str:
    """Return what to say of points without a distance."""
    count = sum(p.undefined for p in points)
    if not count:
        return ""
    return tr_count(
        count,
        "{n:,} point without a distance left out.",
        "{n:,} points without a distance left out.",
    )


def point_table(request: PlotRequest, points: tuple[Points, ...]) -> PlotData:
    """One row a point: source, frame, class, place, residual, error."""

    def joined(parts: list[Any], kind: Any = float) -> Any:
        return np.concatenate(parts) if parts else np.empty(0, dtype=kind)

    titles = dict(enumerate(request.titles))
    sources = [s.name for s, p in zip(request.sources, points, strict=True) for _ in p.errors_px]
    frames = [p.names[i] for p in points for i in p.frames.tolist()]
    classes = [titles.get(row, "") for p in points for row in p.class_rows.tolist()]
    at, residuals = (
        joined([getattr(p, name).reshape(-1, 2) for p in points]).reshape(-1, 2)
        for name in ("points_px", "residuals_px")
    )
    errors = joined([p.errors_px for p in points])
    return PlotData(
        ("source", "frame", "element", "x_px", "y_px", "dx_px", "dy_px", "error_px"),
        (sources, frames, classes, *at.T, *residuals.T, errors),
    )


_FACTORS = (1, 2, 5, 10, 20, 50, 100, 200)
_AUTOMATIC = 0
_TYPICAL = 0.045  # of the picture's width: how long most arrows are when the factor is automatic
_HEAD = 0.3  # of an arrow's length


@dataclass(frozen=True, eq=False)
class Vectors:
    """Per source: its points, and arrows of them or of cells of the picture."""

    points: tuple[Points, ...]
    arrows: tuple[Arrows, ...]


class VectorsPage(PlotPage[Vectors]):
    """Residuals over the picture, from click to projection."""

    name = "plot_vectors"
    title = word("Residuals over the picture")
    axes = "x (px)", "y (px)"
    by_class = True

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self.item.setAspectLocked(True)
        self.item.invertY(True)
        self.item.showGrid(x=False, y=False)
        self.border = self.pg.PlotCurveItem()
        self.item.addItem(self.border)
        self._framed: tuple[int, int] | None = None
        tip = tr("How many times longer than they are arrows are drawn")
        title = tr("Arrows drawn longer")
        self.factor = named(QComboBox(), "plot_vectors_factor", tip=tip, title=title)
        self.factor.addItem(tr("automatic"), _AUTOMATIC)
        for factor in _FACTORS:
            self.factor.addItem(f"{factor} ×", factor)
        self.factor.currentIndexChanged.connect(self.changed)
        layout = self.layout()
        layout.insertLayout(0, hbox(QLabel(tr("Arrows")), self.factor, None))  # type: ignore[union-attr]
        self.restyle()

    @staticmethod
    def compute(request: PlotRequest) -> Vectors:
        points = tuple(gather(request.audits(s), request.class_row) for s in request.sources)
        if request.scope == "frame":
            return Vectors(points, tuple(map(point_arrows, points)))
        return Vectors(points, tuple(cell_arrows(p, request.size) for p in points))

    def draw(self, data: Vectors, request: PlotRequest) -> str:
        self.items.start()
        width, height = request.size
        x = [-0.5, width - 0.5, width - 0.5, -0.5, -0.5]
        y = [-0.5, -0.5, height - 0.5, height - 0.5, -0.5]
        self.border.setData(x, y)
        factor = self.factor.currentData() or automatic_factor(data.arrows, width)
        for source, arrows in zip(request.sources, data.arrows, strict=True):
            self._draw_arrows(source, arrows, factor)
        self.items.finish()
        if self._framed != request.size:
            self._framed = request.size
            self.item.setRange(xRange=(0, width), yRange=(0, height), padding=0.02)
        count = sum(len(arrows.counts) for arrows in data.arrows)
        if not count and request.scope == "set" and any(len(p.errors_px) for p in data.points):
            self._pages.explain(
                tr("Too few points so far: five in a part of the picture make an arrow.")
            )
        else:
            self._pages.explain("" if count else no_points(request))
        if request.scope == "frame":
            said = tr(
                "Arrows {factor} times as long as they are: from the click towards the projection.",
                factor=factor,
            )
        else:
            said = tr(
                "Arrows {factor} times as long as they are: the median residual of each part of"
                " the picture with 5 points or more.",
                factor=factor,
            )
        return " ".join(filter(None, (said, left_out(data.points))))

    def _draw_arrows(self, source: PlottedSource, arrows: Arrows, factor: float) -> None:
        lines = arrow_lines(arrows.at_px, arrows.vectors_px * factor)
        curve = self.items.take("arrows", source.number, self.pg.PlotCurveItem)
        # Arrows are too short for dashes; their feet have the source's symbol.
        pen = self.pg.mkPen(self.colour(source), width=1.4)
        curve.setData(lines[:, 0], lines[:, 1], connect="pairs", pen=pen, antialias=True)
        feet = self.dots("feet", source, size=4)
        feet.setData(x=arrows.at_px[:, 0], y=arrows.at_px[:, 1])

    def restyle(self) -> None:
        self.border.setPen(self.pg.mkPen(muted(self.palette()), width=1))

    @staticmethod
    def table(data: Vectors, request: PlotRequest) -> PlotData:
        return point_table(request, data.points)


def automatic_factor(arrows: tuple[Arrows, ...], width: int) -> int:
    """The round factor that gives most arrows a length one sees and that keeps them apart."""
    lengths = [np.hypot(*a.vectors_px.T) for a in arrows if len(a.vectors_px)]
    typical = float(np.percentile(np.concatenate(lengths), 80)) if lengths else 0.0
    if typical <= 0:
        return 1
    return max((f for f in _FACTORS if f * typical <= _TYPICAL * width), default=1)


def arrow_lines(at: FloatArray, vectors: FloatArray) -> FloatArray:
    """(6n, 2) ends of the lines that make arrows: shaft and two barbs each."""
    tips = at + vectors
    back = -_HEAD * vectors
    side = np.stack([-back[:, 1], back[:, 0]], axis=1) * 0.6
    ends = np.stack([at, tips, tips, tips + back + side, tips, tips + back - side], axis=1)
    return np.asarray(ends.reshape(-1, 2), dtype=np.float64)
