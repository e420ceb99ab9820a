"""Three buttons that say whose fault a bad score is; the same as the keys."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from procc_annotator.gui.panels.parts import note_label, show_note
from procc_annotator.gui.state.document import Document
from procc_annotator.session.facts.verdict import Fault

_WORDS = {Fault.CAMERA: "Camera", Fault.ANNOTATION: "Annotation", Fault.FINE: "Fine"}
_TIPS = {
    Fault.CAMERA: "The active camera is wrong in this frame",
    Fault.ANNOTATION: "The clicks are wrong in this frame",
    Fault.FINE: "Camera and clicks are right in this frame",
}
_KEYS = {Fault.CAMERA: "F7", Fault.ANNOTATION: "F8", Fault.FINE: "F9"}


class VerdictRow(QWidget):
    """Shows the verdict on the frame under the active source; a click asks the window to mark."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self.buttons: dict[Fault, QToolButton] = {}
        row = QHBoxLayout()
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(3)
        caption = QLabel("Fault")
        caption.setToolTip("Whose fault the score of this frame is; kept with the dataset")
        row.addWidget(caption)
        for fault in Fault:
            button = QToolButton()
            button.setCheckable(True)
            button.setObjectName(f"scores_verdict_{fault}")
            button.setText(_WORDS[fault])
            button.setAccessibleName(f"Verdict: {_WORDS[fault]}")
            button.setToolTip(f"{_TIPS[fault]}; once more takes it back ({_KEYS[fault]})")
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
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
        frame, source = document.frame, document.active_source
        verdict = None
        if frame is not None and source is not None and document.projection_visible:
            verdict = document.verdicts.verdict(frame.name, source)
        for fault, button in self.buttons.items():
            button.setChecked(verdict is not None and verdict.fault is fault)
        show_note(self.note, f"“{verdict.comment}”" if verdict is not None and verdict.comment
                  else "")  # fmt: skip
