"""Residual vectors over the picture."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
from PySide6.QtWidgets import QComboBox, QLabel

from procc_annotator.batch.audit import (
    Arrows,
    FloatArray,
    Histogram,
    PlotData,
    Points,
    cell_arrows,
    gather,
    histogram,
    point_arrows,
)
from procc_annotator.gui.panels.plots.data import PlotRequest, PlottedSource
from procc_annotator.gui.panels.plots.page import PlotPage
from procc_annotator.gui.panels.widgets import hbox, named
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import muted
from procc_annotator.translation import tr, tr_count, word


@dataclass(frozen=True, eq=False)
class ErrorBars:
    """The histogram and, per source, the points it counts."""

    bars: Histogram
    points: tuple[Points, ...]


class HistogramPage(PlotPage[ErrorBars]):
    """Histogram of the errors, overall or of one class."""

    name = "plot_histogram"
    title = word("Errors, as a histogram")
    by_class = True

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self.item = self.add_plot(0, tr("reprojection error (px)"), tr("points"), movable=False)

    @staticmethod
    def compute(request: PlotRequest) -> ErrorBars:
        points = tuple(gather(request.audits(s), request.class_row) for s in request.sources)
        return ErrorBars(histogram([p.errors_px for p in points]), points)

    def draw(self, data: ErrorBars, request: PlotRequest) -> str:
        self.shown = data, request
        items = self.items[0]
        items.start()
        edges = data.bars.edges
        several = len(request.sources) > 1
        for source, counts in zip(request.sources, data.bars.counts, strict=True):
            if counts.any():
                steps = items.take("bars", source.number, self.pg.PlotCurveItem)
                steps.setData(
                    np.asarray(edges, dtype=float),
                    np.asarray(counts, dtype=float),
                    stepMode="center",
                    fillLevel=0,
                    brush=self.pg.mkBrush(self.colour(source, 0.12 if several else 0.35)),
                    pen=self.pen(source),
                )
        items.finish()
        highest = max((int(c.max()) for c in data.bars.counts if len(c)), default=0)
        self.item.setXRange(0, float(edges[-1]), padding=0.01)
        self.item.setYRange(0, max(highest, 1) * 1.05, padding=0)
        self.item.getAxis("left").setTicks([_count_ticks(highest)])
        self.say_empty("" if highest else no_points(request))
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
    steps = (digit * 10**power for power in count() for digit in (1, 2, 5))
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
    by_class = True

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self.item = self.add_plot(0, "x (px)", "y (px)")
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
        self.items[0].start()
        width, height = request.size
        x = [-0.5, width - 0.5, width - 0.5, -0.5, -0.5]
        y = [-0.5, -0.5, height - 0.5, height - 0.5, -0.5]
        self.border.setData(x, y)
        factor = self.factor.currentData() or automatic_factor(data.arrows, width)
        for source, arrows in zip(request.sources, data.arrows, strict=True):
            self._draw_arrows(source, arrows, factor)
        self.items[0].finish()
        if self._framed != request.size:
            self._framed = request.size
            self.item.setRange(xRange=(0, width), yRange=(0, height), padding=0.02)
        count = sum(len(arrows.counts) for arrows in data.arrows)
        if not count and request.scope == "set" and any(len(p.errors_px) for p in data.points):
            self.say_empty(
                tr("Too few points so far: five in a part of the picture make an arrow.")
            )
        else:
            self.say_empty("" if count else no_points(request))
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
        curve = self.items[0].take("arrows", source.number, self.pg.PlotCurveItem)
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
