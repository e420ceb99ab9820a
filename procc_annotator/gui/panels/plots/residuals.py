"""Residual vectors over the picture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QLabel

from procc_annotator.batch.audit import (
    Arrows,
    FloatArray,
    PlotData,
    Points,
    cell_arrows,
    gather,
    point_arrows,
)
from procc_annotator.gui.panels.plots.base import PlotPage
from procc_annotator.gui.panels.plots.errors import (
    left_out,
    no_points,
    point_table,
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
        feet = self.dots("feet", source, size=4)
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
