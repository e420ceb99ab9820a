"""Findings as rows of a list, and as signs and tips of elements."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from PySide6.QtCore import QAbstractListModel, QModelIndex, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QFontMetrics, QPainter, QResizeEvent
from PySide6.QtWidgets import (
    QHeaderView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
)

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.gui.canvas.finding_sign import paint_finding_sign
from procc_annotator.gui.panels.widgets import Index, list_rows
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import blend, bold, paint_row
from procc_annotator.translation import tr, word

Entry = tuple[str, StoredFinding]  # a frame's name and what was found in it

WORDS = {
    Severity.ERROR: word("Error"),
    Severity.WARNING: word("Warning"),
    Severity.HINT: word("Hint"),
}

_SIGN = 15
_PAD = 5
_GAP = 6
_WRAPPED = Qt.TextFlag.TextWordWrap | Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop


class FindingsModel(QAbstractListModel):
    """Rows of findings, of one frame or of many."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self.entries: list[Entry] = []
        self.with_frames = False

    def show_entries(self, entries: Sequence[Entry], *, with_frames: bool) -> bool:
        """Show other findings; False if they are the same."""
        new = list(entries)
        if with_frames == self.with_frames and new == self.entries:
            return False
        self.beginResetModel()
        self.entries, self.with_frames = new, with_frames
        self.endResetModel()
        return True

    def row_of(self, frame: str, found: StoredFinding | None) -> int:
        """The row of a finding, -1 if it is not listed."""
        if found is None:
            return -1
        at = (
            row
            for row, (name, other) in enumerate(self.entries)
            if name == frame and other.key == found.key
        )
        return next(at, -1)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 (Qt's signature)
        return 0 if parent.isValid() else len(self.entries)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        if role in (Qt.ItemDataRole.DisplayRole, Qt.ItemDataRole.AccessibleTextRole):
            frame, head, reason = self.texts(index.row())
            return ": ".join(filter(None, (frame, head, reason)))
        return None

    def severity(self, row: int) -> Severity:
        """Return how sure a row's finding is."""
        return self.entries[row][1].finding.severity

    def texts(self, row: int) -> tuple[str, str, str]:
        """The frame (empty in a list of one frame), word and elements, reason."""
        frame, found = self.entries[row]
        finding, title = found.finding, self._services.state.field.title_of
        elements = " · ".join(dict.fromkeys(tr(title(name)) for name in finding.elements))
        head = f"{tr(WORDS[finding.severity])}: {elements}"
        return frame if self.with_frames else "", head, tr(finding.reason)


class FindingDelegate(QStyledItemDelegate):
    """Paints rows of a `FindingsModel`; nothing is shortened, rows are as high as it takes."""

    def __init__(self, view: QTableView) -> None:
        super().__init__(view)
        self._view = view
        self._heights: dict[tuple[int, bool, tuple[str, str, str]], int] = {}

    def forget(self) -> None:
        """Fonts changed: heights are measured anew."""
        self._heights.clear()

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        model = index.model()
        if not isinstance(model, FindingsModel):
            return QSize()
        width = self._view.viewport().width()
        key = (width, model.with_frames, model.texts(index.row()))
        height = self._heights.get(key)
        if height is None:
            if len(self._heights) > 20_000:
                self._heights.clear()
            boxes = _boxes(QRect(0, 0, width, 0), key[2], self._view.font())
            height = self._heights[key] = boxes[-1].bottom() + 1 + _PAD
        return QSize(width, height)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        model = index.model()
        if not isinstance(model, FindingsModel):
            return
        rect: QRect = option.rect
        painter.save()
        base, text = paint_row(painter, option)
        texts = model.texts(index.row())
        font = self._view.font()
        frame_box, head_box, reason_box = _boxes(rect, texts, font)
        painter.setPen(blend(text, base, 0.25))
        painter.drawText(frame_box, _WRAPPED, texts[0])
        painter.drawText(reason_box, _WRAPPED, texts[2])
        painter.setPen(text)
        painter.setFont(bold(font))
        painter.drawText(head_box, _WRAPPED, texts[1])
        line = QFontMetrics(font).height()
        top = head_box.top() + (line - _SIGN) / 2
        sign = QRectF(rect.left() + _PAD, top, _SIGN, _SIGN)
        paint_finding_sign(painter, sign, model.severity(index.row()))
        painter.setPen(blend(base, text, 0.15))
        painter.drawLine(rect.bottomLeft(), rect.bottomRight())
        painter.restore()


class FindingsList(QTableView):
    """A list with rows as high as their texts.

    Only rows that come into sight are measured: to wrap the texts of thousands would take seconds.
    """

    def __init__(self) -> None:
        super().__init__()
        self._fitting = False
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        # A scroll bar that comes and goes would have every text wrapped anew, again and again.
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        self.setVerticalScrollMode(QTableView.ScrollMode.ScrollPerPixel)
        list_rows(self)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # or a click would first choose the first row
        self.setMouseTracking(True)
        self.setItemDelegate(FindingDelegate(self))
        self.horizontalHeader().hide()
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.verticalHeader().setDefaultSectionSize(4 * self.fontMetrics().height() + 2 * _PAD)
        self.verticalScrollBar().valueChanged.connect(lambda _: self.fit_rows())

    def show_row(self, row: int) -> None:
        """Make a row the current one and bring all of it into sight."""
        index = self.model().index(row, 0)
        self.setCurrentIndex(index)
        self.scrollTo(index)
        self.fit_rows()
        self.scrollTo(index)

    def fit_rows(self) -> None:
        """Give the rows in sight the height of their texts."""
        if self._fitting or self.model() is None:
            return
        self._fitting = True
        row, count = max(0, self.rowAt(0)), self.model().rowCount()
        room = self.viewport().height() - min(0, self.rowViewportPosition(row))
        while row < count and room > 0:
            height = self.sizeHintForRow(row)
            if height != self.rowHeight(row):
                self.setRowHeight(row, height)
            room -= height
            row += 1
        self._fitting = False

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.fit_rows()

    def reset(self) -> None:
        super().reset()
        self.fit_rows()


def _boxes(row: QRect, texts: tuple[str, str, str], font: QFont) -> tuple[QRect, QRect, QRect]:
    """Return where frame, head and reason go in a row of this width."""
    left = row.left() + _PAD + _SIGN + _GAP
    width = max(40, row.right() - _PAD - left)
    boxes = []
    top = row.top() + _PAD
    for text, shown in zip(texts, (font, bold(font), font), strict=True):
        metrics = QFontMetrics(shown)
        room = QRect(left, top, width, 10_000)
        height = metrics.boundingRect(room, _WRAPPED, text).height() if text else 0
        boxes.append(QRect(left, top, width, height))
        top += height + (1 if text else 0)
    return boxes[0], boxes[1], boxes[2]


def findings_by_element(services: Services) -> dict[str, tuple[StoredFinding, ...]]:
    """Findings of the frame on screen by the class they are marked at, the surest first."""
    by_class: dict[str, list[StoredFinding]] = {}
    for found in services.label_check.shown:
        for name, _ in found.places:
            by_class.setdefault(name, []).append(found)
    return {
        name: tuple(sorted(found, key=lambda f: f.finding.severity.rank))
        for name, found in by_class.items()
    }


def reasons_of(found: Iterable[StoredFinding]) -> str:
    """Return what is wrong, a line each."""
    return "\n".join(f"{tr(WORDS[f.finding.severity])}: {tr(f.finding.reason)}" for f in found)
