"""Painting the rows of the frames panel: frames and folders."""

from __future__ import annotations

import math

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QImage, QPainter, QPen
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.dataset.records import FAULT_WORDS, Status
from procc_annotator.gui.canvas.finding_sign import paint_finding_sign
from procc_annotator.gui.panels.frame_rows import FolderInfo, FramesModel, RowInfo
from procc_annotator.gui.panels.widgets import Index
from procc_annotator.gui.theme import alarm_colours, blend, bold, paint_row
from procc_annotator.translation import tr, tr_count

_STEP, _MOST = 10, 3  # px a folder; deeper ones are not moved farther in
_SIGN = 14


def indent(depth: int) -> int:
    """Return how far a row is moved in, px."""
    return _STEP * min(depth, _MOST)


def paint_folder(
    painter: QPainter, box: QRect, info: FolderInfo, font: QFont, text: QColor, quiet: QColor
) -> None:
    """Paint its arrow, its name, its numbers of frames, their mean JaC."""
    box = box.adjusted(indent(info.depth), 0, 0, 0)
    _paint_sign(painter, QRectF(box.left(), box.top(), _SIGN, box.height() / 2), info.folded, text)
    box = box.adjusted(_SIGN + 4, 0, 0, 0)
    if info.jac is not None:
        box = box.adjusted(0, 0, -paint_jac(painter, box, info.jac, font, text, quiet), 0)
    upper, lower = _halves(box)
    painter.setFont(bold(font))
    _paint_text(painter, upper, info.label, text)
    painter.setFont(font)
    fits = painter.fontMetrics().horizontalAdvance
    words = next((w for w in folder_words(info) if fits(w) <= lower.width()), "")
    _paint_text(painter, lower, words, quiet)


def _halves(box: QRect) -> tuple[QRect, QRect]:
    """Return the upper and the lower line of a row."""
    upper = QRect(box.left(), box.top(), box.width(), box.height() // 2)
    return upper, box.adjusted(0, upper.height(), 0, 0)


def _paint_text(painter: QPainter, box: QRect, text: str, colour: QColor) -> None:
    painter.setPen(colour)
    shown = painter.fontMetrics().elidedText(text, Qt.TextElideMode.ElideMiddle, box.width())
    painter.drawText(box, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, shown)


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


_THUMB = QSize(72, 41)
_PAD = 5


class FrameDelegate(QStyledItemDelegate):
    """Paints rows of a `FramesModel`; measures nothing but text."""

    @staticmethod
    def row_height(metrics: QFontMetrics) -> int:
        """The height of every row: two lines of text next to the thumbnail."""
        return max(_THUMB.height(), 2 * metrics.height() + 2) + 2 * _PAD

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        model = index.model()
        if not isinstance(model, FramesModel):
            return
        folder = model.folder_info(index.row())
        info = model.info(index.row()) if folder is None else None
        if info is None and folder is None:
            return
        rect: QRect = option.rect
        selected = bool(option.state & QStyle.StateFlag.State_Selected)
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        base, text = paint_row(painter, option)
        quiet = blend(text, base, 0.3)
        if folder is not None:
            box = rect.adjusted(_PAD, _PAD, -_PAD - 2, -_PAD)
            paint_folder(painter, box, folder, option.font, text, quiet)
        if info is not None:
            rect = rect.adjusted(indent(info.depth), 0, 0, 0)
            thumb = QRect(rect.left() + _PAD, 0, _THUMB.width(), _THUMB.height())
            thumb.moveTop(rect.center().y() - _THUMB.height() // 2)
            paint_thumbnail(painter, thumb, info.thumbnail, blend(base, text, 0.12))
            words = rect.adjusted(_THUMB.width() + 2 * _PAD + 2, _PAD, -_PAD - 2, -_PAD)
            front = text if selected else quiet
            _paint_words(painter, words, info, option, (text, quiet, front))
        painter.restore()


def paint_thumbnail(painter: QPainter, box: QRect, image: QImage | None, empty: QColor) -> None:
    """Paint a small picture into a box, as large as it fits; crossed if absent."""
    if image is None:
        painter.fillRect(box, empty)
        return
    if image.isNull():
        painter.setPen(empty)
        painter.drawRect(box.adjusted(0, 0, -1, -1))
        painter.drawLine(box.topLeft(), box.bottomRight())
        painter.drawLine(box.topRight(), box.bottomLeft())
        return
    size = image.size().scaled(box.size(), Qt.AspectRatioMode.KeepAspectRatio)
    target = QRect(box.topLeft(), size)
    target.moveCenter(box.center())
    painter.drawImage(target, image)


def _paint_words(
    painter: QPainter,
    box: QRect,
    info: RowInfo,
    option: QStyleOptionViewItem,
    colours: tuple[QColor, QColor, QColor],
) -> None:
    """Paint a frame's name and JaC, and below what is wrong, the verdict, how much is annotated.

    Args:
        painter: on the view.
        box: next to the thumbnail.
        info: the frame's.
        option: with font and palette.
        colours: of names, of what steps back, and of counts.
    """
    text, quiet, front = colours
    if info.jac is not None:
        room = paint_jac(painter, box, info.jac, option.font, text, quiet)
        box = box.adjusted(0, 0, -room, 0)
    painter.setFont(option.font)
    fits = painter.fontMetrics().horizontalAdvance
    upper, lower = _halves(box)
    _paint_text(painter, upper, info.name, text)
    marker = tr("⚠ unreadable") if info.unreadable else tr("● not saved") if info.dirty else ""
    if info.camera_problem and not marker:
        marker = tr("⚠ camera")
    if marker:
        alarm = tuple(QColor(c) for c in alarm_colours(option.palette))
        chip = QRectF(lower.adjusted(0, 1, 0, -1))
        chip.setWidth(min(fits(marker) + 8, lower.width()))
        lower.setLeft(lower.left() + _paint_chip(painter, chip, marker, alarm[1], alarm[0]))
    if info.has_errors:
        side = min(15, lower.height() - 1)
        sign = QRectF(lower.left(), lower.center().y() - side / 2 + 0.5, side, side)
        paint_finding_sign(painter, sign, Severity.ERROR)
        lower.setLeft(lower.left() + side + 5)
    if info.verdict is not None:
        words = tr(FAULT_WORDS[info.verdict], "a verdict")
        if fits(words) + 10 > lower.width():
            words = tr(info.verdict.value, "a verdict")
        width = min(fits(words) + 10, lower.width())
        chip = QRectF(lower.left() + 0.5, lower.top() + 1.5, width - 1, lower.height() - 3)
        lower.setLeft(lower.left() + _paint_chip(painter, chip, words, text))
    if info.count is not None and not info.unreadable:
        choices = row_words(info, bool(marker) or info.verdict is not None)
        shortest = "" if info.verdict is not None else choices[-1]
        words = next((w for w in choices if fits(w) <= lower.width()), shortest)
        _paint_text(painter, lower, words, front)


def _paint_chip(
    painter: QPainter, chip: QRectF, words: str, text: QColor, ground: QColor | None = None
) -> int:
    """Paint words in a frame, or on a ground of their own; return the room they take."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(text if ground is None else Qt.PenStyle.NoPen)
    painter.setBrush(Qt.BrushStyle.NoBrush if ground is None else ground)
    painter.drawRoundedRect(chip, 3, 3)
    painter.setPen(text)
    painter.drawText(chip, Qt.AlignmentFlag.AlignCenter, words)
    return math.ceil(chip.width()) + 6


def row_words(info: RowInfo, short: bool) -> list[str]:
    """Status, number of elements and open comments: in full, then in less and less room."""
    said = info.status is not Status.UNTOUCHED and not short
    status = tr(info.status.value, "a frame") if said else ""
    count = _count_words(info.count or 0, short or bool(status) or info.comments > 0)
    if not info.comments:
        whole = " · ".join(filter(None, (status, count)))
        return [whole, status or count, str(info.count or 0)]
    comments = tr_count(info.comments, "{n} open", "{n} open")
    return [
        " · ".join(filter(None, (status, count, comments))),
        " · ".join(filter(None, (status, comments))),
        " ".join(filter(None, (status, f"✎{info.comments}"))),
    ]


def _count_words(count: int, short: bool) -> str:
    if short:
        return str(count)
    if not count:
        return tr("not annotated", "a frame")
    return tr_count(count, "{n:,} element", "{n:,} elements")
