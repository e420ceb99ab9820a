"""Icons, drawn as vectors in a colour of the theme: sharp at every size and scale."""

from __future__ import annotations

from functools import lru_cache

from PySide6.QtCore import QByteArray, QRectF
from PySide6.QtGui import QColor, QPainter
from PySide6.QtSvg import QSvgRenderer

from procc_annotator.resources import resources_dir

_BLACK = b"#000"  # what the files are drawn in


def paint_icon(painter: QPainter, name: str, box: QRectF, colour: QColor) -> None:
    """Paint an icon of ``resources/icons`` into a box, in one colour."""
    _drawn(name, colour.name()).render(painter, box)


@lru_cache(maxsize=128)  # every icon in the colours of both themes
def _drawn(name: str, colour: str) -> QSvgRenderer:
    """Raises `FileNotFoundError` where there is no such icon."""
    drawn = (resources_dir() / "icons" / f"{name}.svg").read_bytes()
    return QSvgRenderer(QByteArray(drawn.replace(_BLACK, colour.encode())))
