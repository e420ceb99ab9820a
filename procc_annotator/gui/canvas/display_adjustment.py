"""Sliders for brightness, contrast, gamma and line enhancement."""

from __future__ import annotations

import math
from dataclasses import replace

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import (
    QCheckBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QSlider,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.gui.theme import fixed_width
from procc_annotator.image.pixels import MAX_GAMMA, DisplayAdjustment
from procc_annotator.translation import tr, word

_STEPS = 100  # of a slider, to each side of its middle
_TITLES = {
    "brightness": word("Brightness"),
    "contrast": word("Contrast"),
    "gamma": word("Gamma"),
}


class AdjustmentControls(QWidget):
    """Brightness, contrast, gamma and line enhancement; `lookChanged` gives what the user chose."""

    lookChanged = Signal(object)  # Look

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("lookControls")
        self._look = DisplayAdjustment()
        self._numbers: dict[str, QLabel] = {}
        self.sliders = {
            "brightness": self._slider("brightness", tr("Shift all values")),
            "contrast": self._slider("contrast", tr("Stretch values about middle grey")),
            "gamma": self._slider("gamma", tr("To the right, dark parts become lighter")),
        }
        self.enhance = QCheckBox(tr("Line enhance"))
        self.enhance.setObjectName("lookEnhance")
        self.enhance.setToolTip(tr("Bring out worn and shaded lines"))
        self.enhance.toggled.connect(lambda on: self._choose(replace(self._look, enhance=on)))
        self.reset_button = QPushButton(tr("Reset"))
        self.reset_button.setObjectName("lookReset")
        self.reset_button.setAutoDefault(False)
        self.reset_button.setToolTip(tr("Show the picture as it is"))
        self.reset_button.clicked.connect(lambda: self._choose(DisplayAdjustment()))
        self._arrange()
        self._show()

    @property
    def look(self) -> DisplayAdjustment:
        """Return what the controls show."""
        return self._look

    def set_look(self, look: DisplayAdjustment) -> None:
        """Show a look that was chosen elsewhere; nothing is announced."""
        self._look = look
        self._show()

    # --- building -------------------------------------------------------------------------

    def _slider(self, name: str, tip: str) -> QSlider:
        slider = QSlider(Qt.Orientation.Horizontal)
        slider.setObjectName(f"look_{name}")
        slider.setAccessibleName(tr(_TITLES[name]))
        slider.setToolTip(tip)
        slider.setRange(-_STEPS, _STEPS)
        slider.setPageStep(10)
        slider.setMinimumWidth(80)
        slider.valueChanged.connect(lambda step: self._slide(name, step))
        number = QLabel()
        number.setObjectName(f"look_{name}_number")
        number.setFont(fixed_width(number.font()))
        number.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        number.setMinimumWidth(number.fontMetrics().horizontalAdvance("+100"))
        self._numbers[name] = number
        return slider

    def _arrange(self) -> None:
        rows = QGridLayout()
        rows.setHorizontalSpacing(8)
        rows.setVerticalSpacing(6)
        rows.setColumnStretch(1, 1)
        for row, (name, slider) in enumerate(self.sliders.items()):
            title = QLabel(tr(_TITLES[name]))
            title.setBuddy(slider)
            rows.addWidget(title, row, 0)
            rows.addWidget(slider, row, 1)
            rows.addWidget(self._numbers[name], row, 2)
        last = QHBoxLayout()
        last.addWidget(self.enhance, 1)
        last.addWidget(self.reset_button)
        hint = QLabel(tr("Only what you see changes, never the file"))
        hint.setObjectName("lookHint")
        hint.setWordWrap(True)
        hint.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        hint.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(10, 8, 10, 8)
        layout.setSpacing(8)
        layout.addLayout(rows)
        layout.addLayout(last)
        layout.addWidget(hint)
        layout.addStretch(1)

    # --- changing -------------------------------------------------------------------------

    def _slide(self, name: str, step: int) -> None:
        share = step / _STEPS
        if name == "brightness":
            self._choose(replace(self._look, brightness=share))
        elif name == "contrast":
            self._choose(replace(self._look, contrast=share))
        else:
            self._choose(replace(self._look, gamma=MAX_GAMMA**share))

    def _choose(self, look: DisplayAdjustment) -> None:
        if look != self._look:
            self._look = look
            self._show()
            self.lookChanged.emit(look)

    def _show(self) -> None:
        look = self._look
        steps = {
            "brightness": look.brightness * _STEPS,
            "contrast": look.contrast * _STEPS,
            "gamma": math.log(look.gamma, MAX_GAMMA) * _STEPS,
        }
        for name, step in steps.items():
            with QSignalBlocker(self.sliders[name]):
                self.sliders[name].setValue(round(step))
        with QSignalBlocker(self.enhance):
            self.enhance.setChecked(look.enhance)
        self._numbers["brightness"].setText(_signed(look.brightness))
        self._numbers["contrast"].setText(_signed(look.contrast))
        self._numbers["gamma"].setText(f"{look.gamma:.2f}")
        self.reset_button.setEnabled(look != DisplayAdjustment())


def _signed(share: float) -> str:
    """A share of the range in hundredths: +25, 0, -40 with a true minus sign."""
    hundredths = round(100 * share)
    return f"{hundredths:+d}".replace("-", "−") if hundredths else "0"
