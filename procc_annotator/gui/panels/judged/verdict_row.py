"""Three buttons that say whose fault a bad score is; the same as the keys."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from procc_annotator.dataset.records import FaultParty
from procc_annotator.gui.panels.parts import note_label, show_note
from procc_annotator.gui.state.document import Document
from procc_annotator.translation import tr, word

_WORDS = {
    FaultParty.CAMERA: word("Camera", "a verdict"),
    FaultParty.ANNOTATION: word("Annotation", "a verdict"),
    FaultParty.FINE: word("Fine", "a verdict"),
}
_TIPS = {
    FaultParty.CAMERA: word("The active camera is wrong in this frame"),
    FaultParty.ANNOTATION: word("The clicks are wrong in this frame"),
    FaultParty.FINE: word("Camera and clicks are right in this frame"),
}
_KEYS = {FaultParty.CAMERA: "F7", FaultParty.ANNOTATION: "F8", FaultParty.FINE: "F9"}


class VerdictRow(QWidget):
    """Shows the verdict on the frame under the active source; a click asks the window to mark."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self.buttons: dict[FaultParty, QToolButton] = {}
        row = QHBoxLayout()
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(3)
        caption = QLabel(tr("Fault"))
        caption.setToolTip(tr("Whose fault the score of this frame is; kept with the dataset"))
        row.addWidget(caption)
        for fault in FaultParty:
            button = QToolButton()
            button.setCheckable(True)
            button.setObjectName(f"scores_verdict_{fault}")
            words = tr(_WORDS[fault], "a verdict")
            button.setText(words)
            button.setAccessibleName(tr("Verdict: {verdict}", verdict=words))
            button.setToolTip(
                tr(
                    "{verdict}; once more takes it back ({key})",
                    verdict=tr(_TIPS[fault]),
                    key=_KEYS[fault],
                )
            )
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self.buttons[fault] = button
            row.addWidget(button, 1)
        self.note = note_label("scores_verdict_note")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addLayout(row)
        layout.addWidget(self.note)

    def refresh(self) -> None:
        """Show what is known now."""
        document = self._document
        frame, source = document.state.frame, document.state.active
        verdict = None
        if frame is not None and source is not None and document.state.projection_visible:
            verdict = document.verdicts.verdict(frame.name, source)
        for fault, button in self.buttons.items():
            button.setChecked(verdict is not None and verdict.fault is fault)
        show_note(self.note, f"“{verdict.comment}”" if verdict is not None and verdict.comment
                  else "")  # fmt: skip
