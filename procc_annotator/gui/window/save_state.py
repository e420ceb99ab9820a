"""Whether everything is on disk, and since when."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QLabel

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.theme import alarm_colours, fixed_width
from procc_annotator.language import tr, tr_count

_PAD = 4
_ALARM = "background: {}; color: {}; padding: 1px 6px; font-weight: bold;"  # not shown


class SaveState(QLabel):
    """Says so in a word or two; what is not saved stands out."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self.setObjectName("savedState")
        self.setMargin(_PAD)
        self.setFont(fixed_width(self.font()))
        self._document = document
        store = document.store
        store.watch(lambda s: (s.workspace, s.frame_index, s.unsaved), self._show)
        document.saver.begun.connect(self._show)
        document.saver.settled.connect(self._show)
        self._show()

    def set_saved(self, text: str, *, alarm: bool, tip: str = "") -> None:
        """Show some words, with all of it in the tip."""
        self.setToolTip(tip)
        background, colour = alarm_colours(self.palette())
        style = (
            _ALARM.format(background, colour)
            if alarm
            else ""  # a style sheet, however small, would keep the colours of the other theme
        )
        if style != self.styleSheet():  # setting one costs more than showing a frame's text
            self.setStyleSheet(style)
        self.setText(text)

    def minimumSizeHint(self) -> QSize:
        """Room for the usual words, so that neighbours stay where they are."""
        least = super().minimumSizeHint()
        words = tr("saved {time}", time="00:00:00")
        usual = self.fontMetrics().horizontalAdvance(words) + 2 * _PAD
        return least.expandedTo(QSize(usual, 0))

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint()

    def _show(self, *_: object) -> None:
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
        elif self._document.frame is not None:
            self.set_saved(tr("no changes"), alarm=False)
        else:
            self.set_saved("", alarm=False)
