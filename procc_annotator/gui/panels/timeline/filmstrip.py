"""The frames below the picture as small pictures with their states, where they follow no shot."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QModelIndex, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QKeyEvent, QPainter, QWheelEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QSizePolicy,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
)

from procc_annotator.dataset.records import Status
from procc_annotator.gui.panels.frames.delegate import paint_thumbnail
from procc_annotator.gui.panels.frames.model import FramesModel, RowInfo
from procc_annotator.gui.panels.rows import Index
from procc_annotator.gui.panels.timeline.turned_rows import TurnedRows
from procc_annotator.gui.soon import soon
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.theme import blend, paint_row
from procc_annotator.interaction import palette as tones
from procc_annotator.translation import tr

_THUMB = QSize(80, 45)
_PAD = 4
# A sign, and its colour: never the colour alone.
_SIGNS = {
    Status.IN_PROGRESS: ("…", tones.NOT_ANNOTATED),
    Status.DONE: ("✓", tones.PASSES),
    Status.APPROVED: ("✓✓", tones.PASSES),
    Status.REJECTED: ("✗", tones.TOO_FAR),
}
_SHOWING = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space)


class Filmstrip(QTableView):
    """One row of the frames that the list of frames shows, its folders among them; a click goes to
    one."""

    def __init__(self, document: Document, frames: FramesModel) -> None:
        super().__init__()
        self.setObjectName("filmstrip")
        self.setAccessibleName(tr("Frames as small pictures"))
        self.setAccessibleDescription(tr("The arrows go along, Enter shows the frame"))
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the picture
        self.setTabKeyNavigation(False)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.setMouseTracking(True)
        self.setShowGrid(False)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setItemDelegate(_Cells(self))
        self._document, self._frames = document, frames
        self._rows = TurnedRows(frames, self)
        self.setModel(self._rows)
        for header in (self.horizontalHeader(), self.verticalHeader()):
            header.hide()
            header.setMinimumSectionSize(1)
            header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self._size_cells()
        self.clicked.connect(self._go)
        # After the picture was painted: no one looks here first.
        self._soon = soon(self, self._follow)
        document.store.watch(select.frame, self._soon.start)
        self._rows.modelReset.connect(self._soon.start)
        document.store.watch(select.dataset_scores, self.viewport().update)
        document.store.events.frameScoresChanged.connect(self.viewport().update)
        document.review.statusChanged.connect(lambda _: self.viewport().update())

    def sizeHint(self) -> QSize:
        bar = self.horizontalScrollBar().sizeHint().height()
        return QSize(400, _cell_size(self.fontMetrics()).height() + bar + 2)

    def minimumSizeHint(self) -> QSize:
        return QSize(120, self.sizeHint().height())

    def wheelEvent(self, event: QWheelEvent) -> None:
        """The wheel goes along, whichever way it is turned."""
        turned = event.angleDelta()
        bar = self.horizontalScrollBar()
        bar.setValue(bar.value() - (turned.x() or turned.y()))
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in _SHOWING and self.currentIndex().isValid():
            self._go(self.currentIndex())
        else:
            super().keyPressEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.FontChange:
            self._size_cells()
            self.updateGeometry()

    # --- inside ---

    def _size_cells(self) -> None:
        size = _cell_size(self.fontMetrics())
        self.horizontalHeader().setDefaultSectionSize(size.width())
        self.verticalHeader().setDefaultSectionSize(size.height())

    def _go(self, index: QModelIndex) -> None:
        """As in the list: a frame is gone to, a folder folded or unfolded."""
        frames, row = self._frames, index.column()
        if (folder := frames.folder_at(row)) is not None:
            frames.fold(folder, not frames.is_folded(folder))
        else:
            self._document.walk.come_to(frames.frame_index(row))

    def _follow(self) -> None:
        """The frame on screen is marked and in sight."""
        row = self._frames.row_showing(self._document.state.frame_index)
        index = self._rows.index(0, row) if row >= 0 else QModelIndex()
        if index != self.currentIndex():
            self.setCurrentIndex(index)
            if index.isValid():
                self.scrollTo(index, QAbstractItemView.ScrollHint.EnsureVisible)


def _cell_size(metrics: QFontMetrics) -> QSize:
    return QSize(_THUMB.width() + 2 * _PAD, _THUMB.height() + metrics.height() + 3 * _PAD)


class _Cells(QStyledItemDelegate):
    """A small picture, its state as a sign in a corner, and its name."""

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        model = index.model()
        if not isinstance(model, TurnedRows):
            return
        rect: QRect = option.rect
        ground, text = paint_row(painter, option)
        thumb = QRect(rect.left() + _PAD, rect.top() + _PAD, _THUMB.width(), _THUMB.height())
        words = rect.adjusted(_PAD, 2 * _PAD + _THUMB.height(), -_PAD, -_PAD // 2)
        info = model.frames.info(index.column())
        name = index.data() if info is None else info.name
        if info is not None:
            paint_thumbnail(painter, thumb, info.thumbnail, blend(ground, text, 0.12))
            _paint_state(painter, thumb, info)
        painter.setPen(text)
        shown = option.fontMetrics.elidedText(name, Qt.TextElideMode.ElideLeft, words.width())
        painter.drawText(words, Qt.AlignmentFlag.AlignCenter, shown)


def _paint_state(painter: QPainter, thumb: QRect, info: RowInfo) -> None:
    """A plate in the corner: not saved or unreadable before the status, the status before whether
    anything is annotated."""
    if info.unreadable or info.dirty:
        sign, tone = ("⚠" if info.unreadable else "●"), tones.TOO_FAR
    elif info.status in _SIGNS:
        sign, tone = _SIGNS[info.status]
    elif info.count:
        sign, tone = str(info.count), tones.LABEL
    else:
        return
    metrics = painter.fontMetrics()
    width = metrics.horizontalAdvance(sign) + 6
    plate = QRectF(thumb.right() - width, thumb.top() + 1, width, metrics.height())
    painter.fillRect(plate, QColor(0, 0, 0, 190))
    painter.setPen(QColor(tone).lighter(130))
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, sign)
