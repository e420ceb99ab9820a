"""Sliders for brightness, contrast, gamma and line enhancement."""

from __future__ import annotations

import math
from dataclasses import replace

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QGridLayout, QLabel, QSizePolicy, QSlider, QWidget

from procc_annotator.gui.panels.widgets import hbox, make_button, make_label, named, vbox
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

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("lookControls")
        self.look = DisplayAdjustment()
        self._numbers: dict[str, QLabel] = {}
        self.sliders = {
            "brightness": self._slider("brightness", tr("Shift all values")),
            "contrast": self._slider("contrast", tr("Stretch values about middle grey")),
            "gamma": self._slider("gamma", tr("To the right, dark parts become lighter")),
        }
        tip = tr("Bring out worn and shaded lines")
        self.enhance = named(QCheckBox(tr("Line enhance")), "lookEnhance", tip=tip)
        self.enhance.toggled.connect(lambda on: self._choose(replace(self.look, enhance=on)))
        self.reset_button = make_button(
            tr("Reset"),
            lambda: self._choose(DisplayAdjustment()),
            "lookReset",
            tip=tr("Show the picture as it is"),
        )
        self._arrange()
        self._show()

    def set_look(self, look: DisplayAdjustment) -> None:
        """Show a look that was chosen elsewhere; nothing is announced."""
        self.look = look
        self._show()

    # --- building -------------------------------------------------------------------------

    def _slider(self, name: str, tip: str) -> QSlider:
        slider = QSlider(Qt.Orientation.Horizontal)
        named(slider, f"look_{name}", tip=tip, title=tr(_TITLES[name]))
        slider.setRange(-_STEPS, _STEPS)
        slider.setPageStep(10)
        slider.setMinimumWidth(80)
        slider.valueChanged.connect(lambda step: self._slide(name, step))
        number = make_label(name=f"look_{name}_number", font=fixed_width(self.font()))
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
            for column, widget in enumerate((title, slider, self._numbers[name])):
                rows.addWidget(widget, row, column)
        words = tr("Only what you see changes, never the file")
        hint = make_label(words, "lookHint", wrap=True, faint=True)
        hint.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        last = hbox((self.enhance, 1), self.reset_button)
        vbox(rows, last, hint, None, of=self, spacing=8, margins=(10, 8, 10, 8))

    # --- changing -------------------------------------------------------------------------

    def _slide(self, name: str, step: int) -> None:
        share = step / _STEPS
        if name == "brightness":
            self._choose(replace(self.look, brightness=share))
        elif name == "contrast":
            self._choose(replace(self.look, contrast=share))
        else:
            self._choose(replace(self.look, gamma=MAX_GAMMA**share))

    def _choose(self, look: DisplayAdjustment) -> None:
        if look != self.look:
            self.look = look
            self._show()
            self.lookChanged.emit(look)

    def _show(self) -> None:
        look = self.look
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
