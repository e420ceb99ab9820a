"""Where the cameras look and stand over the frames; a jump stands out."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPalette

from procc_annotator.batch.audit import (
    POSE_QUANTITIES,
    POSE_UNITS,
    FloatArray,
    PlotData,
    SetPoses,
    poses,
)
from procc_annotator.gui.panels.plots.base import Items, PlotPage
from procc_annotator.gui.panels.plots.request import PlotRequest, PlottedSource, Scope
from procc_annotator.translation import tr, tr_count, word

_MOST_JUMPS = 3000  # rings that are painted


@dataclass(frozen=True, eq=False)
class PosePlot:
    """Per source: its poses."""

    poses: tuple[SetPoses, ...]


class PosesPage(PlotPage[PosePlot]):
    """Some quantities of the camera over the frames, one above the other; a click shows the frame.

    Class attributes:
        columns: the quantities, as columns of `Poses.values`.
    """

    scopes: tuple[Scope, ...] = ("set",)
    columns: tuple[int, ...] = ()

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.here: list[Any] = []
        self._lines: list[tuple[PlottedSource, FloatArray, Any, Any]] = []
        self._data: PosePlot | None = None
        self._request: PlotRequest | None = None
        self._span = -1
        self.view.scene().sigMouseMoved.connect(self._hover)
        self.view.scene().sigMouseClicked.connect(self._click)
        for row, column in enumerate(self.columns):
            self._make_plot(row, column)
        self.plots[0].vb.sigXRangeChanged.connect(self._thin_out)
        self.restyle()

    @staticmethod
    def compute(request: PlotRequest) -> PosePlot:
        return PosePlot(tuple(poses(request.frames, s.audits) for s in request.sources))

    def draw(self, data: PosePlot, request: PlotRequest) -> str:
        self._data, self._request = data, request
        self._lines = []
        for items, column in zip(self.items, self.columns, strict=True):
            items.start()
            for source, found in zip(request.sources, data.poses, strict=True):
                self._draw_line(items, source, found, column)
            items.finish()
        count = len(request.frames)
        if self._span != count:
            self._span = count
            self.plots[0].setXRange(0.5, max(count, 1) + 0.5, padding=0.02)
        self._thin_out()
        self.mark(request)
        with_pose = sum(p.with_pose for p in data.poses)
        self.say_empty("" if with_pose else request.why_nothing(_no_pose(data)))
        return self._said(data, request) if with_pose else ""

    def mark(self, request: PlotRequest) -> None:
        for line in self.here:
            line.setVisible(request.current >= 0)
            line.setValue(request.current + 1)

    def restyle(self) -> None:
        tone = self.palette().color(QPalette.ColorRole.Highlight)
        tone.setAlphaF(0.85)
        for line in self.here:
            line.setPen(self.pg.mkPen(tone, width=3))

    @staticmethod
    def table(data: PosePlot, request: PlotRequest) -> PlotData:
        header = ["number", "frame"]
        columns: list[Any] = [np.arange(1, len(request.frames) + 1), request.frames]
        for source, found in zip(request.sources, data.poses, strict=True):
            for i, (quantity, unit) in enumerate(zip(POSE_QUANTITIES, POSE_UNITS, strict=True)):
                unit = "deg" if unit == "°" else unit
                header += [f"{quantity}_{unit} {source.name}", f"{quantity}_jump {source.name}"]
                columns += [found.values[:, i], found.jumps[:, i].astype(int)]
        return PlotData(tuple(header), tuple(columns))

    # --- inside ---------------------------------------------------------------------------

    def _make_plot(self, row: int, column: int) -> None:
        plot = self.add_plot(row, tr("frame"), f"{_name(column)} ({POSE_UNITS[column]})")
        plot.setMouseEnabled(x=True, y=False)
        plot.enableAutoRange(axis="y")
        if row < len(self.columns) - 1:
            plot.getAxis("bottom").showLabel(False)
            plot.getAxis("bottom").setStyle(showValues=False)
        plot.getAxis("left").setWidth(56)
        plot.getAxis("left").setTickDensity(0.6)
        line = self.pg.InfiniteLine(angle=90, movable=False)
        line.setZValue(-5)
        plot.addItem(line, ignoreBounds=True)
        self.here.append(line)
        if row:
            plot.setXLink(self.plots[0])

    def _draw_line(self, items: Items, source: PlottedSource, found: SetPoses, column: int) -> None:
        if not found.with_pose:
            return
        line = items.take("line", source.number, self.pg.PlotDataItem)
        values = found.values[:, column]
        marks = items.take("marks", source.number, self.pg.ScatterPlotItem)
        self._lines.append((source, values, line, marks))
        jumped = found.jumps[:, column].nonzero()[0]
        if 0 < len(jumped) <= _MOST_JUMPS:
            rings = items.take("rings", source.number, self.pg.ScatterPlotItem)
            rings.setPen(self.pg.mkPen(self.colour(source), width=2), update=False)
            rings.setBrush(None, update=False)
            rings.setSize(13, update=False)
            rings.setData(x=jumped + 1.0, y=values[jumped])

    def _said(self, data: PosePlot, request: PlotRequest) -> str:
        parts = []
        columns = list(self.columns)
        for source, found in zip(request.sources, data.poses, strict=True):
            if not found.with_pose:
                if found.without:
                    parts.append(tr("{name}: its model has no pose.", name=source.name))
                continue
            count = int(np.count_nonzero(found.jumps[:, columns].any(axis=1)))
            if count:
                parts.append(
                    tr_count(
                        count,
                        "{name}: {n:,} jump (rings).",
                        "{name}: {n:,} jumps (rings).",
                        name=source.name,
                    )
                )
        return " ".join(parts)

    def _thin_out(self) -> None:
        low, high = self.plots[0].vb.viewRange()[0]
        for source, values, line, marks in self._lines:
            self.draw_over_frames(
                line, marks, source, values, (low, high, self.plots[0].vb.width())
            )

    def _frame_at(self, scene: QPointF) -> int:
        request = self._request
        if request is None or not request.frames:
            return -1
        for plot in self.plots:
            if plot.vb.sceneBoundingRect().contains(scene):
                number = round(float(plot.vb.mapSceneToView(scene).x()))
                return min(max(number, 1), len(request.frames)) - 1
        return -1

    def _hover(self, at: QPointF) -> None:
        index, request, data = self._frame_at(at), self._request, self._data
        if index < 0 or request is None or data is None:
            self.readout.emit("")
            return
        parts = [tr("{name} (frame {n})", name=request.frames[index], n=index + 1)]
        for source, found in zip(request.sources, data.poses, strict=True):
            if found.with_pose:
                values = found.values[index]
                parts.append(
                    f"{source.name} "
                    + ", ".join(
                        f"{_name(c)} {values[c]:.2f} {POSE_UNITS[c]}"
                        if np.isfinite(values[c]) else f"{_name(c)} –"
                        for c in self.columns
                    )
                )  # fmt: skip
        self.readout.emit(" · ".join(parts))

    def _click(self, event: Any) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            index = self._frame_at(event.scenePos())
            if index >= 0:
                event.accept()
                self.frameChosen.emit(index)


class AnglesPage(PosesPage):
    """Where the cameras look, and how far they zoom."""

    title = word("Pan, tilt, roll, zoom over the frames")
    columns = (0, 1, 2, 3)

    def __init__(self) -> None:
        super().__init__("plot_angles")


class PositionPage(PosesPage):
    """Where the cameras stand."""

    title = word("Position over the frames")
    columns = (4, 5, 6)

    def __init__(self) -> None:
        super().__init__("plot_position")


_NAMES = ("", word("tilt"), word("roll"), word("focal"), "x", "y", word("height"))


def _name(column: int) -> str:
    """A quantity of the pose; to pan the picture is another word in most languages."""
    return tr(_NAMES[column]) if column else tr("pan", "an angle")


def _no_pose(data: PosePlot) -> str:
    if any(found.without for found in data.poses):
        return tr(
            "The shown sources are of models without a pose (homographies, projections alone)."
        )
    return tr("No poses yet. They are gathered in the background, frame by frame.")
