"""How sources look in plots: a colour that is seen on either theme, dashes, a symbol."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPalette, QPen

from procc_annotator.gui.plots.request import PlottedSource
from procc_annotator.gui.theme import blend

# Sources are told apart without colour, too.
_DASHES: tuple[tuple[float, ...], ...] = ((), (6, 3), (2, 2), (8, 2, 2, 2), (12, 4), (4, 2, 1, 2))
_SYMBOLS = ("o", "s", "t", "d", "+", "x")
_LEAST_CONTRAST = 3.0  # of lines against what is behind them (WCAG 1.4.11)


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


def readable(colour: str, palette: QPalette) -> QColor:
    """A colour as it is, or nearer to the text's where it would hardly be seen."""
    base = palette.color(QPalette.ColorRole.Base)
    text = palette.color(QPalette.ColorRole.Text)
    asked = QColor(colour)
    for share in range(10):
        tone = blend(asked, text, share / 10)
        if contrast(tone, base) >= _LEAST_CONTRAST:
            return tone
    return text


def contrast(a: QColor, b: QColor) -> float:
    """The contrast ratio of two colours by WCAG 2, 1 to 21."""
    lighter, darker = sorted((_luminance(a), _luminance(b)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def _luminance(colour: QColor) -> float:
    parts = (
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
        for c in (colour.redF(), colour.greenF(), colour.blueF())
    )
    return sum(share * part for share, part in zip((0.2126, 0.7152, 0.0722), parts, strict=True))
