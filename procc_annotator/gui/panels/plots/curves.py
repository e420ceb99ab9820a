"""JaC over tau, and JaC over the frames with a click to go there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPalette, QResizeEvent

from procc_annotator.batch.audit import TAU_GRID, FloatArray, PlotData, mean_curve, timeline
from procc_annotator.batch.frame_sums import AuditBand, difference_band, mean_band
from procc_annotator.gui.panels.plots.base import PlotPage
from procc_annotator.gui.panels.plots.request import PlotRequest, PlottedSource, Scope
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU
from procc_annotator.translation import tr, word

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

    title = word("JaC over tau")

    def __init__(self) -> None:
        super().__init__("plot_tau")
        self.item = self.add_plot(0, tr("tau (px)"), "JaC", movable=False)
        self.item.setXRange(0, MAX_TAU, padding=0.01)
        self.item.setYRange(0, 1, padding=0.04)
        self.line = self.pg.InfiniteLine(angle=90, movable=True, bounds=(MIN_TAU, MAX_TAU))
        self.line.setZValue(10)
        self.line.sigDragged.connect(lambda line: self.tauChosen.emit(float(line.value())))
        self.item.addItem(self.line)
        self.view.scene().sigMouseMoved.connect(self._hover)
        self._shown: tuple[JacCurves, PlotRequest] | None = None
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
        self._shown = data, request
        items = self.items[0]
        items.start()
        for source, own in zip(request.sources, data.bands, strict=False):
            self.shade(source, TAU_GRID, own.band.low, own.band.high)
        for source, curve, count in zip(request.sources, data.curves, data.frames, strict=True):
            if count:
                line = items.take("curve", source.number, self.pg.PlotCurveItem)
                line.setData(TAU_GRID, curve, pen=self.pen(source))
        items.finish()
        self.mark(request)
        self.say_empty("" if any(data.frames) else request.why_nothing(_nothing(request)))
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

    def _hover(self, at: QPointF) -> None:
        if self._shown is None or not self.item.sceneBoundingRect().contains(at):
            self.readout.emit("")
            return
        data, request = self._shown
        tau = float(self.item.vb.mapSceneToView(at).x())
        column = int(np.argmin(np.abs(TAU_GRID - tau)))
        values = [
            f"{source.name} {curve[column]:.3f}"
            for source, curve, n in zip(request.sources, data.curves, data.frames, strict=True)
            if n
        ]
        self.readout.emit(" · ".join([tr("tau {px:.1f} px", px=TAU_GRID[column]), *values]))


@dataclass(frozen=True, eq=False)
class Differences:
    """The judged source less each other one, over `TAU_GRID`.

    Attributes:
        first: the source that the others are taken from.
        others, bands: one each.
        problem: with the table of frames.
    """

    first: PlottedSource | None
    others: tuple[PlottedSource, ...]
    bands: tuple[AuditBand, ...]
    problem: str = ""


class DifferencePage(PlotPage[Differences]):
    """JaC of the judged source less that of others over tau, on the frames both have."""

    title = word("JaC over tau, differences")
    scopes: tuple[Scope, ...] = ("set",)

    def __init__(self) -> None:
        super().__init__("plot_difference")
        self.item = self.add_plot(0, tr("tau (px)"), tr("JaC, difference"), movable=False)
        self.item.setXRange(0, MAX_TAU, padding=0.01)
        self.zero = self.pg.InfiniteLine(angle=0, movable=False)
        self.item.addItem(self.zero, ignoreBounds=True)
        self.restyle()

    @staticmethod
    def compute(request: PlotRequest) -> Differences:
        first = next((s for s in request.sources if s.active), next(iter(request.sources), None))
        others = tuple(s for s in request.sources if s is not first)
        if first is None:
            return Differences(None, (), ())
        order, problem = request.order()
        found = tuple(
            difference_band(first.audits, s.audits, request.frames, order) for s in others
        )
        return Differences(first, others, found, problem)

    def draw(self, data: Differences, request: PlotRequest) -> str:
        items = self.items[0]
        items.start()
        shown = [own for own in data.bands if own.frames]
        for source, own in zip(data.others, data.bands, strict=True):
            if own.frames:
                self.shade(source, TAU_GRID, own.band.low, own.band.high)
                line = items.take("curve", source.number, self.pg.PlotCurveItem)
                line.setData(TAU_GRID, own.band.values, pen=self.pen(source))
        items.finish()
        self.item.vb.autoRange(padding=0.05)
        self.say_empty("" if shown else request.why_nothing(_nothing_to_compare(data)))
        if not shown or data.first is None:
            return ""
        said = tr(
            "{name} less each other source, on the frames both have. Beyond chance where the 95 %"
            " band lies beside 0; {drawn}.",
            name=data.first.name,
            drawn=shown[0].clustered,
        )
        return f"{said} {data.problem}".rstrip()

    def restyle(self) -> None:
        self.zero.setPen(self.pg.mkPen(self.palette().color(QPalette.ColorRole.Text), width=1))

    @staticmethod
    def table(data: Differences, request: PlotRequest) -> PlotData:
        header, columns = ["tau_px"], [TAU_GRID]
        for source, own in zip(data.others, data.bands, strict=True):
            first = "" if data.first is None else data.first.name
            names = f"{first} less {source.name}"  # not shown
            header += [f"{kind} {names}" for kind in ("jac", "low", "high")]
            columns += [own.band.values, own.band.low, own.band.high]
        return PlotData(tuple(header), tuple(columns))


def _nothing_to_compare(data: Differences) -> str:
    if len(data.others) < 1:
        return tr("One source alone has nothing to be compared with.\nLoad or show another one.")
    return tr("No frame that two of the shown sources have is scored yet.")


@dataclass(frozen=True, eq=False)
class Timelines:
    """Per source (F,) JaC, NaN if absent."""

    values: tuple[FloatArray, ...]


class TimelinePage(PlotPage[Timelines]):
    """JaC of every frame under every source; a click shows the frame."""

    title = word("JaC over the frames")
    scopes: tuple[Scope, ...] = ("set",)
    follows_tau = True
    digits = 3

    def __init__(self, name: str = "plot_timeline") -> None:
        super().__init__(name)
        self.item = self.add_plot(0, tr("frame"), "JaC")
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
        self.view.scene().sigMouseMoved.connect(self._hover)
        self.view.scene().sigMouseClicked.connect(self._click)
        self.restyle()

    @staticmethod
    def compute(request: PlotRequest) -> Timelines:
        return Timelines(
            tuple(timeline(request.frames, s.audits, request.tau) for s in request.sources)
        )

    def draw(self, data: Timelines, request: PlotRequest) -> str:
        items = self.items[0]
        items.start()
        self._lines = []
        for source, values in zip(request.sources, data.values, strict=True):
            line = items.take("line", source.number, self.pg.PlotDataItem)
            marks = items.take("marks", source.number, self.pg.ScatterPlotItem)
            self._lines.append((source, values, line, marks))
        items.finish()
        if request.frames != self._frames:
            self._frames = request.frames
            count = len(request.frames)
            self.item.vb.setLimits(xMin=0, xMax=count + 1, minXRange=min(8, count + 1))
            self.item.setXRange(0.5, max(count, 1) + 0.5, padding=0.02)
        self._thin_out()
        self.mark(request)
        nothing = not any(np.isfinite(values).any() for values in data.values)
        self.say_empty(request.why_nothing(_nothing(request)) if nothing else "")
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
    def table(data: Timelines, request: PlotRequest) -> PlotData:
        names = (f"jac@{request.tau:g} {source.name}" for source in request.sources)  # not shown
        numbers = np.arange(1, len(request.frames) + 1)
        return PlotData(("number", "frame", *names), (numbers, request.frames, *data.values))

    def frame_at(self, scene: QPointF) -> int:
        """The frame a position of the scene belongs to, -1 next to the plot."""
        if not self.item.vb.sceneBoundingRect().contains(scene) or not self._frames:
            return -1
        number = round(float(self.item.vb.mapSceneToView(scene).x()))
        return min(max(number, 1), len(self._frames)) - 1

    def _thin_out(self) -> None:
        """Give each line no more points than the screen can show."""
        low, high = self.item.vb.viewRange()[0]
        for source, values, line, marks in self._lines:
            self.draw_over_frames(line, marks, source, values, (low, high, self.item.vb.width()))

    def _hover(self, at: QPointF) -> None:
        index = self.frame_at(at)
        if index < 0:
            self.readout.emit("")
            return
        values = [
            f"{source.name} {values[index]:.{self.digits}f}" if np.isfinite(values[index]) else
            f"{source.name} –"
            for source, values, *_ in self._lines
        ]  # fmt: skip
        frame = tr("{name} (frame {n})", name=self._frames[index], n=index + 1)
        self.readout.emit(" · ".join([frame, *values]))

    def _click(self, event: Any) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            index = self.frame_at(event.scenePos())
            if index >= 0:
                event.accept()
                self.frameChosen.emit(index)


def _nothing(request: PlotRequest) -> str:
    """Why there is no curve."""
    if request.scope == "frame":
        return tr("No score of this frame: it is not annotated, or no shown source has its camera.")
    return tr("No scores yet. They are computed in the background, frame by frame.")
