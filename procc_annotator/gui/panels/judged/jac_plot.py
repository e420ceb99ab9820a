"""JaC as a function of tau; pyqtgraph is imported when the first plot is shown (it takes 0.3 s)."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QVBoxLayout, QWidget

from procc_annotator.gui.panels.states import ElementState, state_colour
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU
from procc_annotator.gui.theme import follow_theme, muted
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.score import jac_curve
from procc_annotator.translation import tr

_TAUS = np.arange(MIN_TAU, MAX_TAU + 0.05, 0.1)


class JacPlot(QWidget):
    """The curve of the frame on screen with a line at tau, which can be dragged."""

    tauChosen = Signal(float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        import pyqtgraph as pg  # see the module's docstring

        self._pg = pg
        self._plot = pg.PlotWidget(background=None)
        follow_theme(self._plot)
        self._plot.setObjectName("scores_plot")
        self._plot.setAccessibleName(tr("JaC over tau"))
        self._plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # the threshold has keys of its own
        item = self._plot.getPlotItem()
        item.setMenuEnabled(False)
        item.hideButtons()
        item.setMouseEnabled(x=False, y=False)
        item.setLabel("bottom", tr("tau (px)"))
        item.setLabel("left", "JaC")
        item.setXRange(0, MAX_TAU, padding=0.01)
        item.setYRange(0, 1, padding=0.04)
        item.showGrid(x=True, y=True, alpha=0.2)
        self._curve = item.plot(stepMode=None)
        self._line = pg.InfiniteLine(angle=90, movable=True, bounds=(MIN_TAU, MAX_TAU))
        self._line.sigDragged.connect(lambda line: self.tauChosen.emit(float(line.value())))
        item.addItem(self._line)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self._plot)
        self._dress()

    def show_curve(self, measurement: Measurement, tau: float) -> None:
        """Draw another frame's curve, or the same at another tau."""
        self._curve.setData(_TAUS, jac_curve(measurement, _TAUS))
        if self._line.value() != tau:
            self._line.setValue(tau)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_line"):
            self._dress()
        super().changeEvent(event)

    def _dress(self) -> None:
        text = self.palette().color(QPalette.ColorRole.Text)
        item = self._plot.getPlotItem()
        for side in ("left", "bottom"):
            axis = item.getAxis(side)
            axis.setPen(muted(self.palette()))
            axis.setTextPen(text)
        self._curve.setPen(
            self._pg.mkPen(state_colour(ElementState.PASSES, self.palette()), width=2)
        )
        self._line.setPen(self._pg.mkPen(text, width=1, style=Qt.PenStyle.DashLine))
        self._line.setHoverPen(self._pg.mkPen(text, width=3))
