"""Errors as histograms, and over the distance from the picture's centre."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
from PySide6.QtCore import QPointF
from PySide6.QtGui import QPalette

from procc_annotator.batch.audit import (
    Histogram,
    PlotData,
    Points,
    RadialErrors,
    gather,
    histogram,
    radial_errors,
)
from procc_annotator.gui.panels.plots.base import PlotPage
from procc_annotator.gui.panels.plots.request import PlotRequest
from procc_annotator.translation import tr, tr_count, word

MOST_DOTS = 6000  # painted in all; medians and files are of every point
_LARGEST = 50  # of every source that are painted in any case


@dataclass(frozen=True, eq=False)
class ErrorBars:
    """The histogram and, per source, the points it counts."""

    bars: Histogram
    points: tuple[Points, ...]


class HistogramPage(PlotPage[ErrorBars]):
    """How many points have which error, overall or of one class."""

    title = word("Errors, as a histogram")
    by_class = True

    def __init__(self) -> None:
        super().__init__("plot_histogram")
        self.item = self.add_plot(0, tr("reprojection error (px)"), tr("points"), movable=False)
        self._shown: tuple[ErrorBars, PlotRequest] | None = None
        self.view.scene().sigMouseMoved.connect(self._hover)

    @staticmethod
    def compute(request: PlotRequest) -> ErrorBars:
        points = tuple(gather(request.audits(s), request.class_row) for s in request.sources)
        return ErrorBars(histogram([p.errors_px for p in points]), points)

    def draw(self, data: ErrorBars, request: PlotRequest) -> str:
        self._shown = data, request
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

    def _hover(self, at: QPointF) -> None:
        if self._shown is None or not self.item.vb.sceneBoundingRect().contains(at):
            self.readout.emit("")
            return
        data, request = self._shown
        edges = data.bars.edges
        place = float(self.item.vb.mapSceneToView(at).x())
        bar = int(np.searchsorted(edges, place, side="right")) - 1
        if not 0 <= bar < len(edges) - 1:
            self.readout.emit("")
            return
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
        self.readout.emit(" · ".join([interval, *counts]))


@dataclass(frozen=True, eq=False)
class RadialPlot:
    """Per source: its points, their errors by radius, and which of them are painted.

    ``top``: px, all but one in a hundred errors are below, and all medians.
    """

    points: tuple[Points, ...]
    radial: tuple[RadialErrors, ...]
    painted: tuple[Any, ...]
    top: float


class RadiusPage(PlotPage[RadialPlot]):
    """Error against image radius: a rise towards the corners is unmodelled distortion."""

    title = word("Errors, by image radius")
    by_class = True

    def __init__(self) -> None:
        super().__init__("plot_radius")
        self.item = self.add_plot(
            0, tr("distance from the centre (corner = 1)"), tr("reprojection error (px)")
        )
        self.item.vb.setLimits(xMin=-0.05, yMin=-0.05)

    @staticmethod
    def compute(request: PlotRequest) -> RadialPlot:
        points = tuple(gather(request.audits(s), request.class_row) for s in request.sources)
        radial = tuple(radial_errors(p, request.size) for p in points)
        share = MOST_DOTS // max(1, sum(len(p.errors_px) > 0 for p in points))
        painted = tuple(thinned_errors(p.errors_px, share) for p in points)
        highest = [float(np.percentile(p.errors_px, 99)) for p in points if len(p.errors_px)]
        highest += [float(r.medians.max()) for r in radial if len(r.medians)]
        return RadialPlot(points, radial, painted, 1.1 * max(highest, default=1.0) + 0.1)

    def draw(self, data: RadialPlot, request: PlotRequest) -> str:
        items = self.items[0]
        items.start()
        total = painted = 0
        for source, radial, chosen in zip(request.sources, data.radial, data.painted, strict=True):
            self.cloud(source, radial.radius[chosen], radial.errors_px[chosen])
            total, painted = total + len(radial.radius), painted + len(chosen)
        for source, radial in zip(request.sources, data.radial, strict=True):
            if len(radial.centres) > 1:
                rim = self.pg.mkPen(self.palette().color(QPalette.ColorRole.Base), width=6)
                for kind, z, pen in (("rim", 4, rim), ("median", 5, self.pen(source, 2.6))):
                    line = items.take(kind, source.number, self.pg.PlotCurveItem)
                    line.setData(radial.centres, radial.medians, pen=pen)
                    line.setZValue(z)
        items.finish()
        self.item.setXRange(0, 1, padding=0.02)
        self.item.setYRange(0, data.top, padding=0)
        self.say_empty("" if total else no_points(request))
        some = tr_count(
            total,
            "Dots: {painted:,} of {n:,} point, the largest errors among them.",
            "Dots: {painted:,} of {n:,} points, the largest errors among them.",
            painted=painted,
        )
        medians = any(len(radial.centres) > 1 for radial in data.radial)
        return " ".join(
            filter(None, (some if painted < total else "",
                          tr("Lines: running median of all points.") if medians else "",
                          left_out(data.points)))
        )  # fmt: skip

    @staticmethod
    def table(data: RadialPlot, request: PlotRequest) -> PlotData:
        return point_table(
            request,
            data.points,
            radius=np.concatenate([r.radius for r in data.radial]) if data.radial else np.empty(0),
        )


def thinned_errors(errors: Any, most: int) -> Any:
    """(m,) at most so many positions: the largest errors and an even choice of the others."""
    count = len(errors)
    if count <= most:
        return np.arange(count)
    largest = np.argpartition(errors, -_LARGEST)[-_LARGEST:]
    others = np.linspace(0, count - 1, most - _LARGEST).astype(np.intp)
    return np.union1d(largest, others)


def _count_ticks(highest: int, most: int = 4) -> list[tuple[float, str]]:
    """Return round whole numbers from 0 up to a count, ``most`` or one more of them."""
    steps = (digit * 10**power for power in count() for digit in (1, 2, 5))
    step = next(step for step in steps if highest / step <= most)
    return [(float(value), f"{value:,}") for value in range(0, highest + 1, step)]


def no_points(request: PlotRequest) -> str:
    """Why there is no point to plot."""
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


def point_table(request: PlotRequest, points: tuple[Points, ...], **more: Any) -> PlotData:
    """One row a point: source, frame, class, place, residual, error, and further columns."""

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
        ("source", "frame", "element", "x_px", "y_px", "dx_px", "dy_px", "error_px", *more),
        (sources, frames, classes, *at.T, *residuals.T, errors, *more.values()),
    )
