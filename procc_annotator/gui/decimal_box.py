"""Boxes for numbers with decimals: a comma is a point in all of them, whatever the language."""

from __future__ import annotations

from PySide6.QtCore import QLocale, Signal
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QDoubleSpinBox, QToolTip, QWidget

from procc_annotator.translation import tr


class DecimalBox(QDoubleSpinBox):
    """Shows a point, as all figures of the window do, and takes a comma for one."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setLocale(QLocale(QLocale.Language.C))

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        return super().validate(text.replace(",", "."), position)


class RangeBox(DecimalBox):
    """Lets numbers out of its range be written, and says that they are not taken."""

    refused = Signal(float)  # this was entered; the value is what it was

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        text = text.replace(",", ".")
        if self._outside(text) is not None:
            return QValidator.State.Intermediate, text, position
        return super().validate(text, position)

    def fixup(self, text: str) -> str:
        number = self._outside(text)
        if number is not None:
            self.refused.emit(number)
        return str(super().fixup(text))

    def tell_refused(self, number: float) -> None:
        """Say next to the box that a number is not taken."""
        told = tr(
            "not {number:g}: {least:g} to {most:g}{unit}",
            number=number,
            least=self.minimum(),
            most=self.maximum(),
            unit=self.suffix(),
        )
        QToolTip.showText(self.mapToGlobal(self.rect().bottomLeft()), told, self)

    def _outside(self, text: str) -> float | None:
        """The number of a text, if the range does not have it."""
        bare = text.replace(",", ".").removesuffix(self.suffix()).strip()
        number, is_number = self.locale().toDouble(bare)
        if not is_number or self.minimum() <= number <= self.maximum():
            return None
        return number
