"""The threshold of a judgement, as a slider and a number."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QSlider, QWidget

from procc_annotator.gui.panels.widgets import RangeBox
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU
from procc_annotator.translation import tr


class TauControl(QWidget):
    """The threshold as a slider and a number; both change it live."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._document = document
        tip = tr("Threshold tau: an element passes when all its points are nearer (+ and -)")
        label = QLabel("τ")
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setObjectName("tauSlider")
        self.slider.setRange(round(MIN_TAU * 10), round(MAX_TAU * 10))
        self.slider.setSingleStep(5)
        self.slider.setPageStep(20)
        self.slider.setFixedWidth(100)
        self.spin = RangeBox()
        self.spin.refused.connect(self.spin.tell_refused)
        self.spin.setObjectName("tauSpin")
        self.spin.setRange(MIN_TAU, MAX_TAU)
        self.spin.setDecimals(1)
        self.spin.setSingleStep(0.5)
        self.spin.setSuffix(" px")
        self.spin.setKeyboardTracking(False)
        self.spin.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(4, 0, 4, 0)
        for widget in (label, self.slider, self.spin):
            widget.setToolTip(tip)
            widget.setAccessibleName(tr("Threshold tau"))
            layout.addWidget(widget)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        self.slider.valueChanged.connect(lambda tenths: document.terms.set_tau(tenths / 10))
        self.spin.valueChanged.connect(document.terms.set_tau)
        document.store.watch(lambda s: s.tau, self._show)
        self._document = document
        self._show()

    def _show(self) -> None:
        tau = self._document.state.tau
        with QSignalBlocker(self.slider), QSignalBlocker(self.spin):
            self.slider.setValue(round(tau * 10))
            self.spin.setValue(tau)
