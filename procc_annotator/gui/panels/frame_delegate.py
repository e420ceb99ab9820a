"""Painting frames and folders: the rows of the frames panel, the thumbnails of the strip."""

from __future__ import annotations

import math

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt, QTransposeProxyModel
from PySide6.QtGui import QColor, QFontMetrics, QImage, QPainter, QPen
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.dataset.records import FAULT_WORDS, Status
from procc_annotator.gui.canvas.finding_sign import paint_finding_sign
from procc_annotator.gui.panels.frame_rows import FolderInfo, FramesModel, RowInfo
from procc_annotator.gui.panels.widgets import Index
from procc_annotator.gui.theme import alarm_colours, blend, bold, paint_row
from procc_annotator.translation import tr, tr_count

_RIM = 3  # px around a thumbnail of a strip: the colour of what is selected
_SIGNS = dict(zip(Status, ("", "…", "✓", "✓✓", "✗"), strict=True))
_STEP, _MOST = 10, 3  # px a folder; deeper ones are not moved farther in
_SIGN = 14
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
        painter.save()
        row = _RowPainter(painter, option)
        if (folder := model.folder_info(index.row())) is not None:
            row.paint_folder(folder)
        elif (info := model.info(index.row())) is not None:
            row.paint_frame(info)
        painter.restore()


class FilmDelegate(QStyledItemDelegate):
    """Paints rows of a `FramesModel` that lie side by side as thumbnails with their state."""

    @staticmethod
    def width(height: int) -> int:
        """Return the width of a frame in a strip, px."""
        return round((height - 2 * _RIM) * _THUMB.width() / _THUMB.height()) + 2 * _RIM

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        turned = index.model()
        if not isinstance(turned, QTransposeProxyModel):
            return
        model, row = turned.sourceModel(), index.column()
        assert isinstance(model, FramesModel)
        painter.save()
        film = _RowPainter(painter, option)
        if (folder := model.folder_info(row)) is not None:
            film.paint_folder(folder)
        elif (info := model.info(row)) is not None:
            film.paint_film(info)
        painter.restore()


class _RowPainter:
    """Paints one row, its ground first."""

    def __init__(self, painter: QPainter, option: QStyleOptionViewItem) -> None:
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.setFont(option.font)
        self._painter, self._option = painter, option
        self._base, self._text = paint_row(painter, option)
        self._quiet = blend(self._text, self._base, 0.3)
        self._fits = painter.fontMetrics().horizontalAdvance
        self._rect: QRect = option.rect

    def paint_folder(self, info: FolderInfo) -> None:
        """Paint its arrow, its name, its numbers of frames, their mean JaC."""
        box = self._rect.adjusted(_PAD + _indent(info.depth), _PAD, -_PAD - 2, -_PAD)
        self._paint_arrow(QRectF(box.left(), box.top(), _SIGN, box.height() / 2), info.folded)
        upper, lower = self._lines(box.adjusted(_SIGN + 4, 0, 0, 0), info.jac)
        self._painter.setFont(bold(self._option.font))
        self._paint_text(upper, info.label, self._text)
        self._painter.setFont(self._option.font)
        words = next((w for w in folder_words(info) if self._fits(w) < lower.width()), "")
        self._paint_text(lower, words, self._quiet)

    def paint_frame(self, info: RowInfo) -> None:
        """Paint its thumbnail, name, JaC, what is wrong, verdict and how much is annotated."""
        rect = self._rect.adjusted(_indent(info.depth), 0, 0, 0)
        thumb = QRect(rect.left() + _PAD, 0, _THUMB.width(), _THUMB.height())
        thumb.moveTop(rect.center().y() - _THUMB.height() // 2)
        self._paint_thumbnail(thumb, info.thumbnail)
        box = rect.adjusted(_THUMB.width() + 2 * _PAD + 2, _PAD, -_PAD - 2, -_PAD)
        upper, lower = self._lines(box, info.jac)
        if self._fits(info.name) <= upper.width():
            self._paint_text(upper, info.name, self._text)
        else:
            lower = self._paint_long_name(upper | lower, info.name)
        marker = tr("⚠ unreadable") if info.unreadable else tr("● not saved") if info.dirty else ""
        if info.camera_problem and not marker:
            marker = tr("⚠ camera")
        if marker:
            ground, text = (QColor(c) for c in alarm_colours(self._option.palette))
            chip = QRectF(lower.adjusted(0, 1, 0, -1))
            chip.setWidth(min(self._fits(marker) + 8, lower.width()))
            lower.setLeft(lower.left() + self._paint_chip(chip, marker, text, ground))
        if info.has_errors:
            side = min(15, lower.height() - 1)
            sign = QRectF(lower.left(), lower.center().y() - side / 2 + 0.5, side, side)
            paint_finding_sign(self._painter, sign, Severity.ERROR)
            lower.setLeft(lower.left() + side + 5)
        if info.verdict is not None:
            words = tr(FAULT_WORDS[info.verdict], "a verdict")
            if self._fits(words) + 10 > lower.width():
                words = tr(info.verdict.value, "a verdict")
            width = min(self._fits(words) + 10, lower.width())
            chip = QRectF(lower.left() + 0.5, lower.top() + 1.5, width - 1, lower.height() - 3)
            lower.setLeft(lower.left() + self._paint_chip(chip, words, self._text))
        if info.count is not None and not info.unreadable:
            choices = row_words(info, bool(marker) or info.verdict is not None)
            shortest = "" if info.verdict is not None else choices[-1]
            words = next((w for w in choices if self._fits(w) < lower.width()), shortest)
            selected = self._option.state & QStyle.StateFlag.State_Selected
            self._paint_text(lower, words, self._text if selected else self._quiet)

    def paint_film(self, info: RowInfo) -> None:
        """Paint a thumbnail, and at its corner signs of what is wrong and of the status."""
        box = self._rect.adjusted(_RIM, _RIM, -_RIM, -_RIM)
        self._paint_thumbnail(box, info.thumbnail)
        alarm = "⚠" if info.unreadable or info.camera_problem else "●" if info.dirty else ""
        comments = f"✎{info.comments}" if info.comments else ""
        signs = " ".join(filter(None, (alarm, comments, _SIGNS.get(info.status, ""))))
        bottom = box.bottom() - self._painter.fontMetrics().height() + 1
        if info.has_errors:
            sign = QRectF(box.left() + 1, bottom, _SIGN, _SIGN)
            paint_finding_sign(self._painter, sign, Severity.ERROR)
        if signs:
            wide = self._fits(signs) + 6
            chip = QRectF(box.right() - wide + 1, bottom, wide, box.bottom() - bottom + 1)
            self._paint_chip(chip, signs, self._base, self._text)

    # --- parts --------------------------------------------------------------------------------

    def _lines(self, box: QRect, jac: float | None) -> tuple[QRect, QRect]:
        """Return the upper and the lower line of text, left of the JaC, which is painted."""
        if jac is not None:
            box = box.adjusted(0, 0, -self._paint_jac(box, jac), 0)
        upper = QRect(box.left(), box.top(), box.width(), box.height() // 2)
        return upper, box.adjusted(0, upper.height(), 0, 0)

    def _paint_text(self, box: QRect, text: str, colour: QColor) -> None:
        painter, middle = self._painter, Qt.TextElideMode.ElideMiddle
        painter.setPen(colour)
        shown = painter.fontMetrics().elidedText(text, middle, box.width())
        painter.drawText(box, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, shown)

    def _paint_long_name(self, box: QRect, name: str) -> QRect:
        """Paint a name on two lines, and return what is left below them."""
        metrics, width = self._painter.fontMetrics(), box.width()
        line = metrics.height()
        box.adjust(0, 1 - _PAD, 0, _PAD - 1)
        self._painter.setPen(self._text)
        shown = metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, 2 * width - line)
        where = QRect(box.left(), box.top(), width, 2 * line)
        self._painter.drawText(where, Qt.TextFlag.TextWrapAnywhere, shown)
        return box.adjusted(0, 2 * line, 0, 0)

    def _paint_arrow(self, box: QRectF, folded: bool) -> None:
        """An angle that points to the right where it is folded, and down where it is not."""
        corners = [(-2.0, -4.0), (2.0, 0.0), (-2.0, 4.0)]
        if not folded:
            corners = [(y, x) for x, y in corners]
        self._painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self._painter.setPen(QPen(self._text, 1.6))
        self._painter.setBrush(Qt.BrushStyle.NoBrush)
        self._painter.drawPolyline([box.center() + QPointF(x, y) for x, y in corners])

    def _paint_jac(self, box: QRect, jac: float) -> int:
        """The figure with a bar of its length below; returns the room it takes."""
        painter, width = self._painter, self._fits("0.00") + 4
        upper = QRect(box.right() - width + 1, box.top(), width, box.height() // 2)
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        painter.setPen(self._text)
        painter.drawText(upper, right, f"{jac:.2f}")
        bar = QRectF(upper.left() + 2, box.center().y() + box.height() / 4 - 1, width - 2, 4)
        track = QColor(self._quiet)
        track.setAlphaF(0.35)
        painter.fillRect(bar, track)
        bar.setWidth(bar.width() * jac)
        painter.fillRect(bar, self._text)
        return width + 6

    def _paint_thumbnail(self, box: QRect, image: QImage | None) -> None:
        """Paint a small picture into a box, as large as it fits; crossed if absent."""
        painter, empty = self._painter, blend(self._base, self._text, 0.12)
        if image is None:
            painter.fillRect(box, empty)
        elif image.isNull():
            painter.setPen(empty)
            painter.drawRect(box.adjusted(0, 0, -1, -1))
            painter.drawLine(box.topLeft(), box.bottomRight())
            painter.drawLine(box.topRight(), box.bottomLeft())
        else:
            size = image.size().scaled(box.size(), Qt.AspectRatioMode.KeepAspectRatio)
            target = QRect(box.topLeft(), size)
            target.moveCenter(box.center())
            painter.drawImage(target, image)

    def _paint_chip(
        self, chip: QRectF, words: str, text: QColor, ground: QColor | None = None
    ) -> int:
        """Paint words in a frame, or on a ground of their own; return the room they take."""
        painter = self._painter
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(text if ground is None else Qt.PenStyle.NoPen)
        painter.setBrush(Qt.BrushStyle.NoBrush if ground is None else ground)
        painter.drawRoundedRect(chip, 3, 3)
        painter.setPen(text)
        painter.drawText(chip, Qt.AlignmentFlag.AlignCenter, words)
        return math.ceil(chip.width()) + 6


def _indent(depth: int) -> int:
    return _STEP * min(depth, _MOST)


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
