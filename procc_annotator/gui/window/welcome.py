"""The start page: ways to open a dataset, and those opened last."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QLabel, QMenu, QWidget

from procc_annotator.gui.commands.opening import OpeningTask, sample_folder
from procc_annotator.gui.panels.widgets import hbox, make_button, make_label, vbox
from procc_annotator.gui.settings import RECENT, Settings
from procc_annotator.translation import tr

_SHOWN = 5
_LEAST = 400  # px


class Welcome(QWidget):
    """Says what to do first, with a button for each way, and offers to go on with what was open."""

    def __init__(
        self, opening: OpeningTask, tour: Callable[[], None], recent: Sequence[Path]
    ) -> None:
        super().__init__()
        self.setObjectName("welcome")
        title = make_label(tr("Drop a folder of pictures here"), wrap=True)
        font = title.font()
        font.setPointSizeF(font.pointSizeF() * 1.6)
        title.setFont(font)
        text = make_label(
            tr(
                "Annotations are read from and saved as JSON next to the pictures. Drop a"
                " folder of cameras later, to see them judged against your clicks."
            ),
            wrap=True,
        )
        for label in (title, text):
            label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        buttons = [
            make_button(tr("Open folder…"), opening.open_folder, "welcomeFolder"),
            make_button(tr("Open picture…"), opening.open_picture, "welcomePicture"),
            make_button(tr("Open video…"), opening.open_video, "welcomeVideo"),
        ]
        if sample_folder() is not None:
            sample = make_button(tr("Try the sample"), opening.open_sample, "welcomeSample")
            buttons += [sample, make_button(tr("Tour (60 seconds)"), tour, "welcomeTour")]
        layout = vbox(None, title, text, of=self)
        layout.addSpacing(12)
        layout.addLayout(hbox(None, *buttons, None))
        layout.addSpacing(24)
        centre = Qt.AlignmentFlag.AlignHCenter
        column = vbox(spacing=2)
        layout.addLayout(column)
        layout.addStretch(1)
        if recent:
            column.addWidget(QLabel(tr("Go on with")), 0, centre)
        for path in recent[:_SHOWN]:
            words, go = described(path).replace("&", "&&"), partial(opening.open_path, path)
            button = make_button(words, go, "welcomeRecent", tip=str(path))
            button.setFlat(True)
            button.setForegroundRole(QPalette.ColorRole.Link)
            button.setCursor(Qt.CursorShape.PointingHandCursor)
            column.addWidget(button, 0, centre)

    def minimumSizeHint(self) -> QSize:
        """Little: it is behind the picture most of the time, which needs no more."""
        return QSize(_LEAST, _LEAST // 2)


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
            words, go = described(path).replace("&", "&&"), partial(self._chosen, path)
            self.addAction(words, go).setToolTip(str(path))
        if self.isEmpty():
            self.addAction(tr("Nothing was opened yet")).setEnabled(False)


def described(path: Path) -> str:
    """A path as its name and the folder it is in, the latter shortened from its beginning."""
    folder = str(path.parent)
    if len(folder) > _LONGEST_FOLDER:
        folder = "…" + folder[-_LONGEST_FOLDER:]
    return f"{path.name or path} – {folder}"
