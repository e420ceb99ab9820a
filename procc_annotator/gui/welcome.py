"""What the window shows while nothing is open."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget


class Welcome(QWidget):
    """Says what to do first, with a button for each way."""

    open_folder = Signal()
    open_picture = Signal()
    open_sample = Signal()

    def __init__(self, *, with_sample: bool) -> None:
        super().__init__()
        self.setObjectName("welcome")
        title = QLabel("Drop a folder of pictures here")
        font = title.font()
        font.setPointSizeF(font.pointSizeF() * 1.6)
        title.setFont(font)
        text = QLabel(
            "Annotations are read from and saved to SoccerNet JSON beside the pictures.\n"
            "Drop a folder of cameras later, to see them judged against your clicks."
        )
        for label in (title, text):
            label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        row = QHBoxLayout()
        row.addStretch()
        buttons = [
            ("Open folder…", "welcomeFolder", self.open_folder),
            ("Open picture…", "welcomePicture", self.open_picture),
        ]
        if with_sample:
            buttons.append(("Try the sample", "welcomeSample", self.open_sample))
        for caption, name, signal in buttons:
            button = QPushButton(caption)
            button.setObjectName(name)
            button.clicked.connect(signal)
            row.addWidget(button)
        row.addStretch()
        layout = QVBoxLayout(self)
        layout.addStretch()
        for part in (title, text):
            layout.addWidget(part)
        layout.addSpacing(12)
        layout.addLayout(row)
        layout.addStretch()
