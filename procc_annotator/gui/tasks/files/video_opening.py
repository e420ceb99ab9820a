"""Opening a video: which of its frames to annotate, and keeping them as pictures.

Reading the frame times, looking for cuts and writing pictures all happen off the interface thread.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLabel,
    QProgressDialog,
    QRadioButton,
    QWidget,
)

from procc_annotator.gui.decimal_box import DecimalBox
from procc_annotator.gui.latest import Latest
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import JobControl
from procc_annotator.gui.writing import write
from procc_annotator.image.video import Video, frames_at_interval, open_shared, scene_cuts
from procc_annotator.language import tr, tr_count
from procc_annotator.session.dataset.video_frames import keep_frame, open_video

T = TypeVar("T")

DEFAULT_INTERVAL_S = 1.0
# Short work needs no window that says so.
_PATIENCE_MS = 400


class VideoDialog(QDialog):
    """Every so many seconds, or one frame for each scene."""

    def __init__(self, parent: QWidget, video: Video) -> None:
        super().__init__(parent)
        self.setObjectName("videoDialog")
        self.setWindowTitle(tr("Open a video"))
        width, height = video.size
        seconds = video.frame_count / video.fps if video.fps else 0.0
        frames = tr_count(video.frame_count, "{n:,} frame", "{n:,} frames")
        text = f"{video.path.name}: {frames}, {width}x{height}, {seconds:.0f} s"
        text += f"\n{video.cut_off}" if video.cut_off else ""
        self.interval = QRadioButton(tr("One frame every"))
        self.interval.setChecked(True)
        self.seconds = DecimalBox()
        self.seconds.setRange(0.02, 3600.0)
        self.seconds.setDecimals(2)
        self.seconds.setValue(DEFAULT_INTERVAL_S)
        self.seconds.setSuffix(" s")
        self.cuts = QRadioButton(tr("The first frame of every scene"))
        self.cuts.setToolTip(tr("Looks through the whole video for cuts; this takes a while"))
        self.cuts.toggled.connect(lambda on: self.seconds.setEnabled(not on))
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Open | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.addRow(QLabel(text))
        form.addRow(self.interval, self.seconds)
        form.addRow(self.cuts)
        form.addRow(QLabel(tr("Nothing is extracted; “Keep this video frame” writes a picture.")))
        form.addRow(buttons)


class VideoOpening:
    """Asks which frames, finds them in the background, and opens them as a dataset."""

    def __init__(self, document: Document, parent: QWidget, opened: Callable[[Path], None]) -> None:
        self._document = document
        self._parent = parent
        self._opened = opened
        self._work = Latest(document, self._fail)
        self._progress: QProgressDialog | None = None
        # Whoever opened something else meanwhile does not want the video any more.
        document.datasetChanged.connect(self.cancel)

    def ask(self, path: Path) -> None:
        """Read how many frames a video has, then show the dialog."""

        def read(_: JobControl) -> Video:
            video = open_shared(path)  # its first picture is shown by the same one
            video.read_index()  # reads through the file: here, not when the dialog asks
            return video

        self._run(tr("Reading {file}", file=path.name), read, self._show_dialog)

    def cancel(self) -> None:
        """Forget the video that is being read or looked through."""
        self._work.cancel()
        self._end_progress()

    def _show_dialog(self, video: Video) -> None:
        dialog = VideoDialog(self._parent, video)
        dialog.accepted.connect(lambda: self._choose(dialog, video))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _choose(self, dialog: VideoDialog, video: Video) -> None:
        if not dialog.cuts.isChecked():
            self._open(video.path, frames_at_interval(video, dialog.seconds.value()))
            return

        def look(control: JobControl) -> list[int]:
            return scene_cuts(video, progress=control.progress, cancelled=lambda: control.cancelled)

        self._run(
            tr("Looking for cuts in {file}", file=video.path.name),
            look,
            lambda numbers: self._open(video.path, numbers),
        )

    def _open(self, path: Path, numbers: list[int]) -> None:
        if self._document.opening.open_workspace(open_video(path, numbers, self._document.field)):
            self._opened(path)

    def _run(self, what: str, work: Callable[[JobControl], T], then: Callable[[T], object]) -> None:
        """Work in the background, with a window that shows how far it is and can cancel it."""
        self.cancel()
        self._progress = progress = QProgressDialog(what, tr("Cancel"), 0, 0, self._parent)
        progress.setObjectName("videoProgress")
        progress.setWindowTitle(tr("Open a video"))
        progress.setMinimumDuration(_PATIENCE_MS)
        progress.canceled.connect(self.cancel)

        def advance(done: int, total: int) -> None:
            progress.setMaximum(total)
            progress.setValue(done)

        def finish(result: T) -> None:
            self._end_progress()
            then(result)

        self._work.start(work, finish, progress=advance)

    def _fail(self, text: str) -> None:
        self._end_progress()
        self._document.say(text, "error")

    def _end_progress(self) -> None:
        progress, self._progress = self._progress, None
        if progress is not None:
            progress.canceled.disconnect()
            progress.close()
            progress.deleteLater()


def keep_video_frame(document: Document) -> None:
    """Write the picture on screen beside its annotation, if it is a frame of a video."""
    frame, picture = document.frame, document.picture
    if frame is None or picture is None or frame.image_folder.is_dir():
        document.say(tr("this frame is a picture already"))
        return
    write(
        document, lambda _: keep_frame(frame, picture), lambda path: tr("kept as {path}", path=path)
    )
