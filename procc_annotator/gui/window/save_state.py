"""Whether everything is on disk, and since when."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QLabel

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.theme import alarm_colours, fixed_width
from procc_annotator.interact.hints import counted

_PAD = 4
_WIDEST = "saved 00:00:00"


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
            f"background: {background}; color: {colour}; padding: 1px 6px; font-weight: bold;"
            if alarm
            else ""  # a style sheet, however small, would keep the colours of the other theme
        )
        if style != self.styleSheet():  # setting one costs more than showing a frame's text
            self.setStyleSheet(style)
        self.setText(text)

    def minimumSizeHint(self) -> QSize:
        """Room for the usual words, so that neighbours stay where they are."""
        least = super().minimumSizeHint()
        usual = self.fontMetrics().horizontalAdvance(_WIDEST) + 2 * _PAD
        return least.expandedTo(QSize(usual, 0))

    def sizeHint(self) -> QSize:
        return self.minimumSizeHint()

    def _show(self, *_: object) -> None:
        saver = self._document.saver
        problems = saver.problems
        if problems:
            tip = "\n".join(str(p) for p in problems.values())
            self.set_saved(f"NOT SAVED: {counted(len(problems), 'frame')}", alarm=True, tip=tip)
        elif saver.under_way:
            self.set_saved("saving...", alarm=False)
        elif saver.saved_at is not None:
            self.set_saved(f"saved {saver.saved_at:%H:%M:%S}", alarm=False)
        elif self._document.frame is not None:
            self.set_saved("no changes", alarm=False)
        else:
            self.set_saved("", alarm=False)
