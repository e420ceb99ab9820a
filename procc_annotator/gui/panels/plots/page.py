"""What plots are of, and the base of their pages: sources, legend, axes in both themes.

pyqtgraph is imported when the first page is made (it takes 0.3 s).
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Generic, Literal, TypeVar

import numpy as np
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPaintEvent, QPalette, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from procc_annotator.batch.audit import FloatArray, FrameAudit, PlotData, audit_frame
from procc_annotator.batch.grouping import FrameOrder
from procc_annotator.dataset.layout import FRAMES_FILE
from procc_annotator.dataset.records import FrameRecord
from procc_annotator.errors import InputError
from procc_annotator.field.landmarks import element_titles
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.gui.panels.widgets import Pages, vbox
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import follow_theme, muted, readable
from procc_annotator.translation import tr

Scope = Literal["frame", "set"]


@dataclass(frozen=True, eq=False)
class PlottedSource:
    """A camera source as plots know it.

    Attributes:
        name, colour: as everywhere in the window; the colour as "#rrggbb".
        number: its place among all sources, which gives its dashes and its symbol.
        audits: by frame name; only of frames that may be shown.
        active: whether it is the one that is judged.
        fitted: whether they were fitted to the clicks they are judged by.
    """

    name: str
    colour: str
    number: int
    audits: Mapping[str, FrameAudit]
    active: bool = False
    fitted: FitCounts = NOT_FITTED


@dataclass(frozen=True, eq=False)
class PlotRequest:
    """The sources, frames and settings of a plot.

    Attributes:
        sources: the visible ones.
        frames: names of all frames of the dataset, in its order.
        current: position of the frame on screen, -1 without one.
        scope: the frame on screen, or all of them.
        class_row: only points of this class of the field; None for all.
        tau: px.
        size: of the evaluation, px.
        titles: of the classes, by row of the field.
        blind: whether blind mode hides frames of the scope.
        order_file: the dataset's table of frames, if it has one.
        shown: in blind mode what is known of each frame; of those that are not committed nothing
            is plotted (`revealed`). None: all may be plotted.
    """

    sources: tuple[PlottedSource, ...]
    frames: tuple[str, ...]
    current: int
    scope: Scope
    class_row: int | None
    tau: float
    size: tuple[int, int]
    titles: tuple[str, ...] = ()
    blind: bool = False
    order_file: Path | None = None
    shown: Mapping[str, FrameRecord] | None = None

    def revealed(self) -> PlotRequest:
        """Return the request without the frames that blind mode hides, in any thread."""
        if self.shown is None:
            return self
        committed = {name for name, record in self.shown.items() if record.committed}
        sources = tuple(
            replace(s, audits={n: a for n, a in s.audits.items() if n in committed})
            for s in self.sources
        )
        return replace(self, sources=sources, shown=None)

    def order(self) -> tuple[FrameOrder | None, str]:
        """The dataset's table of frames, read anew (not on the interface's thread), and what is
        wrong with it, if it cannot be used."""
        if self.order_file is None or not self.order_file.is_file():
            return None, ""
        try:
            return FrameOrder.read(self.order_file), ""
        except InputError as error:
            return None, tr("Shots are recognized by names, since {error}.", error=error)

    def why_nothing(self, otherwise: str) -> str:
        """Return why there is nothing to plot: blind mode, or the page's own reason."""
        if not self.blind:
            return otherwise
        if self.scope == "frame":
            return tr("Hidden: blind mode shows this plot once this frame is committed.")
        return tr(
            "Hidden: blind mode shows committed frames only, and none of them is in this plot."
        )

    def audits(self, source: PlottedSource) -> list[FrameAudit]:
        """Return what the scope holds of a source, in the order of the frames."""
        if self.scope == "frame":
            name = self.frames[self.current] if self.current >= 0 else ""
            found = source.audits.get(name)
            return [] if found is None else [found]
        return [source.audits[name] for name in self.frames if name in source.audits]


class PlotSources:
    """Takes snapshots of the state that another thread may look at.

    ``set_version`` and ``frame_version`` change with what the plots of the set and of the frame on
    screen show; moving on to another frame or tau is no change of the set.
    """

    def __init__(self, services: Services) -> None:
        self._services = services
        self._names: tuple[str, ...] = ()
        self._order_file: Path | None = None
        self.set_version = self.frame_version = 0
        store = services.store
        store.watch(lambda s: s.workspace, self._take_dataset)
        store.watch(
            lambda s: (s.workspace, s.looks, s.field, s.blind, s.committed), self._change_set
        )
        store.watch(judged, self._change_frame)
        services.store.events.sourceAuditsChanged.connect(self._change_set)
        services.review.statusChanged.connect(self._change_set)
        self._take_dataset()

    def version(self, scope: Scope) -> int:
        """A number that is another one when the scope's data is."""
        return self.frame_version + self.set_version if scope == "frame" else self.set_version

    def request(self, scope: Scope, class_row: int | None) -> PlotRequest:
        """Return what to plot; of a set before the frames are left out that blind mode hides."""
        services = self._services
        sources = tuple(
            PlottedSource(
                source.name,
                source.colour,
                number,
                self._of_frame(source) if scope == "frame" else dict(source.audits),
                source.camera_set is services.state.active_cameras,
                source.fitted,
            )
            for number, source in enumerate(services.state.sources)
            if source.visible or source.camera_set is services.state.active_cameras
        )
        shown = None
        if scope == "set" and services.state.blind:
            database = services.review.database
            shown = dict(database.records()) if database is not None else {}
        return PlotRequest(
            sources,
            self._names,
            services.state.frame_index,
            scope,
            class_row,
            services.state.tau,
            services.state.setup.size,
            tuple(element_titles(services.state.field).values()),
            services.state.blind if scope == "set" else not services.state.projection_visible,
            self._order_file,
            shown,
        )

    def _of_frame(self, source: CameraSource) -> dict[str, FrameAudit]:
        """The audit of the frame on screen; of the active source as the clicks are right now."""
        services = self._services
        frame = services.state.frame
        if frame is None or not services.state.projection_visible:
            return {}
        measurement, camera = services.scorer.measurement, services.scorer.camera
        if source.camera_set is not services.state.active_cameras:
            found = source.audits.get(frame.name)
        elif measurement is None or camera is None or not services.state.shown_annotation.annotated:
            found = None
        else:
            found = audit_frame(frame.name, camera, "", measurement, services.state.tau)
        return {} if found is None else {frame.name: found}

    def _take_dataset(self) -> None:
        workspace = self._services.state.workspace
        self._names = () if workspace is None else tuple(f.name for f in workspace.frames)
        self._order_file = None if workspace is None else workspace.folder / FRAMES_FILE

    def _change_set(self) -> None:
        self.set_version += 1

    def _change_frame(self) -> None:
        self.frame_version += 1


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

    def __init__(self) -> None:
        super().__init__()
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


D = TypeVar("D")


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
        """Begin a drawing; `finish` hides the items that it does not take."""
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
    """One plot; anyone who holds it computes its data, perhaps in another thread, and has it drawn.

    Class attributes:
        title: its name in the list of plots, marked by ``word``.
        scopes: which choices of frames make sense.
        by_class: whether one class can be chosen.
        follows_tau: whether the data (not only a mark) depends on tau.
    """

    name = title = ""
    scopes: tuple[Scope, ...] = ("frame", "set")
    by_class = False
    follows_tau = False

    shown: tuple[D, PlotRequest] | None = None  # what is drawn, and what it is of

    readout = Signal(str)  # what is under the cursor; empty when nothing is
    changed = Signal()  # an option of the page: draw it again

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.services = services
        import pyqtgraph as pg  # see the module's docstring

        self.pg = pg
        self.setObjectName(self.name)
        self.view = pg.GraphicsLayoutWidget()
        self.view.setBackground(None)
        follow_theme(self.view)
        self.view.setObjectName(f"{self.name}_view")
        self.view.setAccessibleName(tr(self.title))
        self.view.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.view.ci.layout.setContentsMargins(0, 9, 12, 0)  # figures at the ends of axes
        self.sharpness: float | None = None  # px of the device a logical one; None: the screen's
        self.plots: list[Any] = []
        self.items: list[Items] = []
        self._pages = Pages(self.view, f"{self.name}_empty")
        self.empty = self._pages.empty
        vbox((self._pages, 1), of=self, margins=0)

    # --- to be given by each page ---------------------------------------------------------

    @staticmethod
    @abstractmethod
    def compute(request: PlotRequest) -> D:
        """The data, from any thread."""

    @abstractmethod
    def draw(self, data: D, request: PlotRequest) -> str:
        """Show data; what there is to say about it, or an empty text."""

    def read(self, x: float) -> str:
        """Return what there is at a place of the horizontal axis; empty for nothing."""
        return ""

    def mark(self, request: PlotRequest) -> None:
        """Show another frame or tau in what is drawn."""

    @staticmethod
    @abstractmethod
    def table(data: D, request: PlotRequest) -> PlotData:
        """The numbers that are drawn, for a file."""

    def restyle(self) -> None:
        """Take over the theme's colours where `dress` does not reach."""

    # --- shared ---------------------------------------------------------------------------

    @property
    def is_empty(self) -> bool:
        """Return whether there is nothing but words."""
        return self._pages.currentWidget() is self.empty

    def add_plot(self, row: int, bottom: str, left: str, *, movable: bool = True) -> Any:
        """A set of axes with labels."""
        item = self.view.addPlot(row=row, col=0, enableMenu=False)  # a third of its time to make
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
        if not self.plots:
            self.view.scene().sigMouseMoved.connect(self._hover)
        self.plots.append(item)
        self.items.append(Items(item))
        self._dress_axes(item)
        return item

    def _hover(self, at: QPointF) -> None:
        box = self.plots[0].vb
        inside = box.sceneBoundingRect().contains(at)
        self.readout.emit(self.read(float(box.mapSceneToView(at).x())) if inside else "")

    def dots(
        self,
        kind: str,
        source: PlottedSource,
        *,
        size: float,
    ) -> Any:
        """Dots with the symbol of a source; they have no data yet."""
        item = self.items[0].take(kind, source.number, self.pg.ScatterPlotItem)
        item.setSymbol(symbol_of(source), update=False)
        item.setSize(size, update=False)
        item.setPen(None, update=False)
        item.setBrush(self.colour(source), update=False)
        return item

    def shade(
        self, source: PlottedSource, x: FloatArray, low: FloatArray, high: FloatArray
    ) -> None:
        """A band of a source's colour between two curves, where both are known."""
        known = np.isfinite(low) & np.isfinite(high)
        if not known.any():
            return
        band = self.items[0].take("band", source.number, self.pg.PlotCurveItem)
        around = np.concatenate((x[known], x[known][::-1]))
        edges = np.concatenate((low[known], high[known][::-1]))
        fill = self.pg.mkBrush(self.colour(source, 0.15))
        band.setData(around, edges, pen=None, fillLevel="enclosed", brush=fill)

    def pen(self, source: PlottedSource, width: float = 1.6) -> Any:
        """The line of a source; its width in px of the window, whatever their sharpness."""
        pen = source_pen(source, self.palette(), width)
        pen.setCosmetic(True)  # px of the device, then: on the picture's scales, not the axes'
        pen.setWidthF(width * (self.sharpness or self.devicePixelRatioF()))
        return pen

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
