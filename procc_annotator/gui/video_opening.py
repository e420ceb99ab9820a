"""Opening a video: which of its frames to annotate, and keeping them as pictures."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QDoubleSpinBox,
    QFormLayout,
    QLabel,
    QRadioButton,
    QWidget,
)

from procc_annotator.errors import ProccError
from procc_annotator.gui.document import Document
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.image.video import Video, frames_at_interval, scene_cuts
from procc_annotator.session.video_frames import keep_frame, open_video

DEFAULT_INTERVAL_S = 1.0


class VideoDialog(QDialog):
    """Every so many seconds, or one frame for each scene."""

    def __init__(self, parent: QWidget, video: Video) -> None:
        super().__init__(parent)
        self.setObjectName("videoDialog")
        self.setWindowTitle("Open a video")
        width, height = video.size
        seconds = video.frame_count / video.fps if video.fps else 0.0
        text = f"{video.path.name}: {video.frame_count} frames, {width}x{height}, {seconds:.0f} s"
        self.interval = QRadioButton("One frame every")
        self.interval.setChecked(True)
        self.seconds = QDoubleSpinBox()
        self.seconds.setRange(0.02, 3600.0)
        self.seconds.setDecimals(2)
        self.seconds.setValue(DEFAULT_INTERVAL_S)
        self.seconds.setSuffix(" s")
        self.cuts = QRadioButton("The first frame of every scene")
        self.cuts.setToolTip("Looks through the whole video for cuts; this takes a while")
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
        form.addRow(QLabel("Nothing is extracted; “Keep this video frame” writes a picture."))
        form.addRow(buttons)


class VideoOpening:
    """Asks which frames, finds them in the background, and opens them as a dataset."""

    def __init__(self, document: Document, parent: QWidget) -> None:
        self._document = document
        self._parent = parent
        self._job: Job | None = None

    def ask(self, path: Path) -> bool:
        """Show the dialog; False when the video cannot be read or the dialog was left."""
        try:
            video = Video.open(path)
        except ProccError as error:
            self._document.message.emit(str(error), "error")
            return False
        dialog = VideoDialog(self._parent, video)
        accepted, seconds = bool(dialog.exec()), dialog.seconds.value()
        cuts = dialog.cuts.isChecked()
        dialog.deleteLater()
        if not accepted:
            video.close()
            return False
        if not cuts:
            numbers = frames_at_interval(video, seconds)
            video.close()
            return self.open_frames(path, numbers)
        self._find_cuts(path, video)
        return True

    def open_frames(self, path: Path, numbers: list[int]) -> bool:
        """Open these frames of a video as a dataset."""
        return self._document.open_workspace(open_video(path, numbers, self._document.field))

    def _find_cuts(self, path: Path, video: Video) -> None:
        document = self._document

        def work(control: JobControl) -> list[int]:
            try:
                return scene_cuts(
                    video, progress=control.progress, cancelled=lambda: control.cancelled
                )
            finally:
                video.close()

        def found(numbers: list[int]) -> None:
            self.open_frames(path, numbers)

        self._job = run_in_background(
            work,
            on_result=found,
            on_error=lambda text: document.message.emit(text, "error"),
            on_progress=lambda done, total: document.message.emit(
                f"looking for cuts: frame {done} of {total}", "info"
            ),
            owner=document,
        )


def keep_video_frame(document: Document) -> None:
    """Write the picture on screen beside its annotation, if it is a frame of a video."""
    frame, picture = document.frame, document.picture
    if frame is None or picture is None or frame.image_folder.is_dir():
        document.message.emit("this frame is a picture already", "info")
        return
    try:
        path = keep_frame(frame, picture)
    except ProccError as error:
        document.message.emit(str(error), "error")
        return
    document.message.emit(f"kept as {path}", "info")
