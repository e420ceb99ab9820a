"""Whether everything is on disk, and since when."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPaintEvent
from PySide6.QtWidgets import QSizePolicy

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.theme import alarm_colours, fixed_width
from procc_annotator.gui.window.status import PaintedText
from procc_annotator.translation import tr, tr_count

_PAD = 4
_ALARM_PAD = 6


class SaveState(PaintedText):
    """Says so in a word or two; what is not saved stands out.

    With every click the words change twice, and nothing is laid out anew for that.
    """

    def __init__(self, document: Document) -> None:
        super().__init__()
        self.setObjectName("savedState")
        self.setFont(fixed_width(self.font()))
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Preferred)
        self._document, self._alarm = document, False
        self._asked_for = QSize()
        store = document.store
        store.watch(lambda s: (s.workspace, s.frame_index, s.unsaved), self._show)
        document.saver.begun.connect(self._show)
        document.saver.settled.connect(self._show)
        self._show()

    def set_saved(self, text: str, *, alarm: bool, tip: str = "") -> None:
        """Show some words, with all of it in the tip."""
        if tip != self.toolTip():
            self.setToolTip(tip)
        if (text, alarm) == (self.text(), self._alarm):
            return
        self._alarm = alarm
        self.set_text(text)
        before, self._asked_for = self._asked_for, self.sizeHint()
        if before != self._asked_for:
            self.updateGeometry()

    def minimumSizeHint(self) -> QSize:
        """Room for the usual words, so that neighbours stay where they are."""
        metrics = self._metrics()
        words = tr("saved {time}", time="00:00:00")
        usual = self.fontMetrics().horizontalAdvance(words) + 2 * _PAD
        said = metrics.horizontalAdvance(self.text()) + 2 * self._pad
        return QSize(max(usual, said), metrics.height() + 2 * _PAD)

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, area = QPainter(self), self.rect()
        colour = self.palette().windowText().color()
        if self._alarm:
            ground, text = alarm_colours(self.palette())
            painter.fillRect(area, QColor(ground))
            painter.setFont(fixed_width(self.font(), bold=True))
            colour = QColor(text)
        painter.setPen(colour)
        edge = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        painter.drawText(area.adjusted(self._pad, _PAD, -self._pad, -_PAD), edge, self.text())

    @property
    def _pad(self) -> int:
        return _ALARM_PAD if self._alarm else _PAD

    def _metrics(self) -> QFontMetrics:
        if not self._alarm:
            return self.fontMetrics()
        return QFontMetrics(fixed_width(self.font(), bold=True))

    def _show(self) -> None:
        saver = self._document.saver
        problems = saver.problems
        if problems:
            tip = "\n".join(str(p) for p in problems.values())
            said = tr_count(len(problems), "NOT SAVED: {n} frame", "NOT SAVED: {n} frames")
            self.set_saved(said, alarm=True, tip=tip)
        elif saver.under_way:
            self.set_saved(tr("saving..."), alarm=False)
        elif saver.saved_at is not None:
            self.set_saved(tr("saved {time}", time=f"{saver.saved_at:%H:%M:%S}"), alarm=False)
        elif self._document.state.frame is not None:
            self.set_saved(tr("no changes"), alarm=False)
        else:
            self.set_saved("", alarm=False)
