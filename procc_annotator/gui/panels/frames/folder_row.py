"""The row of a folder in the list of frames, and what it shares with those of frames."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRect, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen

from procc_annotator.gui.panels.frames.model import FolderInfo
from procc_annotator.translation import tr, tr_count

_STEP, _MOST = 10, 3  # px a folder; deeper ones are not moved farther in
_SIGN = 14


def indent(depth: int) -> int:
    """Return how far a row is moved in, px."""
    return _STEP * min(depth, _MOST)


def paint_folder(
    painter: QPainter, box: QRect, info: FolderInfo, font: QFont, text: QColor, quiet: QColor
) -> None:
    """Whether it is folded, its name, how many frames are in it and done, their mean JaC."""
    box = box.adjusted(indent(info.depth), 0, 0, 0)
    _paint_sign(painter, QRectF(box.left(), box.top(), _SIGN, box.height() / 2), info.folded, text)
    box = box.adjusted(_SIGN + 4, 0, 0, 0)
    if info.jac is not None:
        box = box.adjusted(0, 0, -paint_jac(painter, box, info.jac, font, text, quiet), 0)
    bold = QFont(font)
    bold.setBold(True)
    painter.setFont(bold)
    painter.setPen(text)
    upper = QRect(box.left(), box.top(), box.width(), box.height() // 2)
    align = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
    elide = Qt.TextElideMode.ElideMiddle
    painter.drawText(
        upper, align, painter.fontMetrics().elidedText(info.label, elide, upper.width())
    )
    painter.setFont(font)
    painter.setPen(quiet)
    lower = QRect(box.left(), upper.bottom() + 1, box.width(), box.height() - upper.height())
    metrics = painter.fontMetrics()
    fitting = (w for w in folder_words(info) if metrics.horizontalAdvance(w) <= lower.width())
    painter.drawText(lower, align, next(fitting, ""))


def folder_words(info: FolderInfo) -> list[str]:
    """Its figures: in full, then in less and less room."""
    frames = tr_count(info.frames, "{n:,} frame", "{n:,} frames")
    if info.shown != info.frames:
        frames = tr("{shown:,} of {frames}", shown=info.shown, frames=frames)
    done = ""
    if info.done == info.frames:
        done = tr("all done")
    elif info.done:
        done = tr_count(info.done, "{n:,} done", "{n:,} done")
    short = f"{info.done}/{info.frames}" if done else f"{info.frames}"
    return [" · ".join(filter(None, (frames, done))), frames, short]


def _paint_sign(painter: QPainter, box: QRectF, folded: bool, colour: QColor) -> None:
    """An angle that points to the right where it is folded, and down where it is not."""
    centre, reach = box.center(), 4.0
    corners = [(-0.5, -1.0), (0.5, 0.0), (-0.5, 1.0)]
    if not folded:
        corners = [(y, x) for x, y in corners]
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(colour, 1.6))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawPolyline([centre + QPointF(reach * x, reach * y) for x, y in corners])


def paint_jac(
    painter: QPainter, box: QRect, jac: float, font: QFont, text: QColor, quiet: QColor
) -> int:
    """The figure with a bar of its length below; returns the room it takes."""
    painter.setFont(font)
    words = f"{jac:.2f}"
    width = painter.fontMetrics().horizontalAdvance("0.00") + 4
    upper = QRect(box.right() - width + 1, box.top(), width, box.height() // 2)
    painter.setPen(text)
    painter.drawText(upper, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, words)
    bar = QRectF(upper.left() + 2, box.center().y() + box.height() / 4 - 1, width - 2, 4)
    track = QColor(quiet)
    track.setAlphaF(0.35)
    painter.fillRect(bar, track)
    bar.setWidth(bar.width() * jac)
    painter.fillRect(bar, text)
    return width + 6
