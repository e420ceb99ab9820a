"""The start page: ways to open a dataset, and those opened last."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QPushButton, QVBoxLayout, QWidget

from procc_annotator.gui.settings import RECENT, Settings
from procc_annotator.translation import tr

_SHOWN = 5
_LEAST = 400  # px


class Welcome(QWidget):
    """Says what to do first, with a button for each way, and offers to go on with what was open."""

    open_folder = Signal()
    open_picture = Signal()
    open_video = Signal()
    open_sample = Signal()
    open_recent = Signal(Path)

    def __init__(self, *, with_sample: bool) -> None:
        super().__init__()
        self.setObjectName("welcome")
        title = QLabel(tr("Drop a folder of pictures here"))
        font = title.font()
        font.setPointSizeF(font.pointSizeF() * 1.6)
        title.setFont(font)
        text = QLabel(
            tr(
                "Annotations are read from and saved to SoccerNet JSON beside the pictures. "
                "Drop a folder of cameras later, to see them judged against your clicks."
            )
        )
        for label in (title, text):
            label.setAlignment(Qt.AlignmentFlag.AlignCenter)
            label.setWordWrap(True)
        row = QHBoxLayout()
        row.addStretch()
        buttons = [
            (tr("Open folder…"), "welcomeFolder", self.open_folder),
            (tr("Open picture…"), "welcomePicture", self.open_picture),
            (tr("Open video…"), "welcomeVideo", self.open_video),
        ]
        if with_sample:
            buttons.append((tr("Try the sample"), "welcomeSample", self.open_sample))
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
        layout.addSpacing(24)
        self._recent = QVBoxLayout()
        self._recent.setSpacing(2)
        layout.addLayout(self._recent)
        layout.addStretch()

    def minimumSizeHint(self) -> QSize:
        """Little: it is behind the picture most of the time, which needs no more."""
        return QSize(_LEAST, _LEAST // 2)

    def show_recent(self, paths: Sequence[Path]) -> None:
        """Offer what was opened last, newest first."""
        centre = Qt.AlignmentFlag.AlignHCenter
        if paths:
            self._recent.addWidget(QLabel(tr("Go on with")), 0, centre)
        for path in paths[:_SHOWN]:
            button = QPushButton(described(path).replace("&", "&&"))
            button.setObjectName("welcomeRecent")
            button.setFlat(True)
            button.setForegroundRole(QPalette.ColorRole.Link)
            button.setToolTip(str(path))
            button.setCursor(Qt.CursorShape.PointingHandCursor)
            button.clicked.connect(lambda _=False, path=path: self.open_recent.emit(path))
            self._recent.addWidget(button, 0, centre)


_LONGEST_FOLDER = 48


class RecentMenu(QMenu):
    """Lists what was opened last, newest first."""

    def __init__(
        self, settings: Settings, chosen: Callable[[Path], object], parent: QWidget
    ) -> None:
        super().__init__(tr("Open recent"), parent)
        self.setObjectName("recentMenu")
        self._settings = settings
        self._chosen = chosen
        self.aboutToShow.connect(self.fill)

    def fill(self) -> None:
        """Make the entries anew."""
        self.clear()
        for path in self._settings.get(RECENT):
            action = self.addAction(described(path).replace("&", "&&"))
            action.setToolTip(str(path))
            action.triggered.connect(lambda _=False, path=path: self._chosen(path))
        if self.isEmpty():
            self.addAction(tr("Nothing was opened yet")).setEnabled(False)


def described(path: Path) -> str:
    """A path as its name and the folder it is in, the latter shortened from its beginning."""
    folder = str(path.parent)
    if len(folder) > _LONGEST_FOLDER:
        folder = "…" + folder[-_LONGEST_FOLDER:]
    return f"{path.name or path} – {folder}"
