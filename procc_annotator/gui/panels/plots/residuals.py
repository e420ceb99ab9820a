"""Residual vectors over the picture, and the directions they point to."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel

from procc_annotator.batch.audit import (
    Arrows,
    FloatArray,
    PlotData,
    Points,
    bias,
    cell_arrows,
    gather,
    point_arrows,
)
from procc_annotator.gui.panels.plots.base import PlotPage
from procc_annotator.gui.panels.plots.errors import (
    MOST_DOTS,
    left_out,
    no_points,
    point_table,
    thinned_errors,
)
from procc_annotator.gui.panels.plots.request import PlotRequest, PlottedSource
from procc_annotator.gui.theme import muted
from procc_annotator.translation import tr, word

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
    """Where in the picture the projection lies next to the clicks, and which way."""

    title = word("Residuals over the picture")
    by_class = True

    def __init__(self) -> None:
        super().__init__("plot_vectors")
        self.item = self.add_plot(0, "x (px)", "y (px)")
        self.item.setAspectLocked(True)
        self.item.invertY(True)
        self.item.showGrid(x=False, y=False)
        self.border = self.pg.PlotCurveItem()
        self.item.addItem(self.border)
        self._framed: tuple[int, int] | None = None
        self.factor = QComboBox()
        self.factor.setObjectName("plot_vectors_factor")
        self.factor.setAccessibleName(tr("Arrows drawn longer"))
        self.factor.setToolTip(tr("How many times longer than they are arrows are drawn"))
        self.factor.addItem(tr("automatic"), _AUTOMATIC)
        for factor in _FACTORS:
            self.factor.addItem(f"{factor} ×", factor)
        self.factor.currentIndexChanged.connect(lambda _: self.changed.emit())
        row = QHBoxLayout()
        row.addWidget(QLabel(tr("Arrows")))
        row.addWidget(self.factor)
        row.addStretch(1)
        layout = self.layout()
        layout.insertLayout(0, row)  # type: ignore[union-attr]
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
        curve.setData(
            lines[:, 0], lines[:, 1], connect="pairs", pen=self._solid(source), antialias=True
        )
        feet = self.dots("feet", source.number, source, size=4)
        feet.setData(x=arrows.at_px[:, 0], y=arrows.at_px[:, 1])

    def _solid(self, source: PlottedSource) -> Any:
        """Arrows are too short for dashes; their feet have the source's symbol."""
        return self.pg.mkPen(self.colour(source), width=1.4)

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


@dataclass(frozen=True, eq=False)
class Directions:
    """Per source: its points, which of them are painted, and the median residual.

    ``reach``: px, nearly all residuals are shorter; None without any.
    """

    points: tuple[Points, ...]
    painted: tuple[Any, ...]
    biases: tuple[tuple[float, float] | None, ...]
    reach: float | None


class DirectionsPage(PlotPage[Directions]):
    """All residuals from one centre: a cloud next to the cross is a bias."""

    title = word("Residuals, by direction")
    by_class = True

    def __init__(self) -> None:
        super().__init__("plot_directions")
        self.item = self.add_plot(0, tr("to the right (px)"), tr("down (px)"))
        self.item.setAspectLocked(True)
        self.item.invertY(True)
        self.cross = [self.pg.InfiniteLine(angle=angle, movable=False) for angle in (0, 90)]
        self.circle = self.pg.PlotCurveItem()
        for part in (*self.cross, self.circle):
            self.item.addItem(part, ignoreBounds=True)
        self.restyle()

    @staticmethod
    def compute(request: PlotRequest) -> Directions:
        points = tuple(gather(request.audits(s), request.class_row) for s in request.sources)
        share = MOST_DOTS // max(1, sum(len(p.errors_px) > 0 for p in points))
        reach = [float(np.percentile(p.errors_px, 97)) for p in points if len(p.errors_px)]
        return Directions(
            points,
            tuple(thinned_errors(p.errors_px, share) for p in points),
            tuple(bias(p) for p in points),
            1.15 * max(*reach, 0.5) if reach else None,
        )

    def draw(self, data: Directions, request: PlotRequest) -> str:
        self.items[0].start()
        for source, points, chosen in zip(request.sources, data.points, data.painted, strict=True):
            self.cloud(source, points.residuals_px[chosen, 0], points.residuals_px[chosen, 1])
        for source, middle in zip(request.sources, data.biases, strict=True):
            if middle is not None:
                self._draw_bias(source, middle)
        self.items[0].finish()
        if (reach := data.reach) is not None:
            self.item.setRange(xRange=(-reach, reach), yRange=(-reach, reach), padding=0)
        self.mark(request)
        self.say_empty("" if data.reach is not None else no_points(request))
        said = [
            f"{source.name}: {_way(*middle)}"
            for source, middle in zip(request.sources, data.biases, strict=True)
            if middle is not None
        ]
        text = tr("Median of clicks to projection: {ways}.", ways="; ".join(said)) if said else ""
        return " ".join(filter(None, (text, left_out(data.points))))

    def _draw_bias(self, source: PlottedSource, middle: tuple[float, float]) -> None:
        edge = self.pg.mkPen(self.palette().color(QPalette.ColorRole.Text), width=1.5)
        arrow = self.items[0].take("bias", source.number, self.pg.PlotCurveItem)
        arrow.setData([0.0, middle[0]], [0.0, middle[1]], pen=self.pen(source, 3.0))
        head = self.dots("head", source.number, source, size=12, pen=edge)
        head.setData(x=[middle[0]], y=[middle[1]])
        for drawn in (arrow, head):
            drawn.setZValue(10)

    def mark(self, request: PlotRequest) -> None:
        turn = np.linspace(0, 2 * np.pi, 121)
        self.circle.setData(request.tau * np.cos(turn), request.tau * np.sin(turn))

    def restyle(self) -> None:
        for line in self.cross:
            line.setPen(self.pg.mkPen(muted(self.palette()), width=1))
        text = self.palette().color(QPalette.ColorRole.Text)
        self.circle.setPen(self.pg.mkPen(text, width=1, dash=[4, 4]))

    @staticmethod
    def table(data: Directions, request: PlotRequest) -> PlotData:
        return point_table(request, data.points)


def _way(dx: float, dy: float) -> str:
    """A residual in words: 1.2 px right, 0.3 px up."""
    across = tr("{px:.2f} px right", px=abs(dx)) if dx >= 0 else tr("{px:.2f} px left", px=abs(dx))
    down = tr("{px:.2f} px down", px=abs(dy)) if dy >= 0 else tr("{px:.2f} px up", px=abs(dy))
    return f"{across}, {down}"
