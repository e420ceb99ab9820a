"""How sources look in plots: a colour that is seen on either theme, dashes, a symbol."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPalette, QPen

from procc_annotator.gui.panels.plots.request import PlottedSource
from procc_annotator.gui.theme import readable

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
