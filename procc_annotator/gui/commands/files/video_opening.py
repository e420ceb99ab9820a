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

from procc_annotator.dataset.dataset_field import field_of_dataset, own_field_file
from procc_annotator.dataset.diagnostics import loadable
from procc_annotator.dataset.layout import frames_folder
from procc_annotator.dataset.sequence import keep_frame, open_video
from procc_annotator.errors import FieldError
from procc_annotator.field.load import field_titles, load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.messages import write
from procc_annotator.gui.panels.widgets import DecimalBox, choice
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.services import Services
from procc_annotator.image.video import Video, frames_at_interval, open_shared_video, scene_cuts
from procc_annotator.translation import tr, tr_count

T = TypeVar("T")

DEFAULT_INTERVAL_S = 1.0
# Short work needs no window that says so.
_PATIENCE_MS = 400


class VideoDialog(QDialog):
    """Every so many seconds, or one frame for each scene; and which field the video shows."""

    def __init__(self, parent: QWidget, video: Video, shown: Field, *, decided: bool) -> None:
        """Args:
        shown: the field as far as known.
        decided: whether a file in the dataset's folder says so, and no other can be chosen.
        """
        super().__init__(parent)
        self.setObjectName("videoDialog")
        self.setWindowTitle(tr("Open a video"))
        width, height = video.size
        seconds = video.frame_count / video.fps if video.fps else 0.0
        frames = tr_count(video.frame_count, "{n:,} frame", "{n:,} frames")
        text = f"{video.path.name}: {frames}, {width}x{height}, {seconds:.0f} s"
        text = "\n".join(filter(None, (text, video.cut_off, video.squeezed)))
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
        self.field = choice("videoField")
        for name, title in field_titles().items():
            self.field.addItem(tr(title), name)
        at = self.field.findData(loadable(shown))
        if at < 0 or shown.own_terms:
            self.field.insertItem(at := 0, shown.described)
        self.field.setCurrentIndex(at)
        self.field.setEnabled(not decided)
        self.shown_at = at
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Open | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.addRow(QLabel(text))
        form.addRow(self.interval, self.seconds)
        form.addRow(self.cuts)
        form.addRow(tr("Field"), self.field)
        form.addRow(QLabel(tr("Nothing is extracted; “Keep this video frame” writes a picture.")))
        form.addRow(buttons)


class VideoOpening:
    """Asks which frames, finds them in the background, and opens them as a dataset."""

    def __init__(self, services: Services, parent: QWidget, opened: Callable[[Path], None]) -> None:
        self._services = services
        self._parent = parent
        self._opened = opened
        self._work = LatestOnlyTask(services, self._fail)
        self._progress: QProgressDialog | None = None
        # Anyone who opened something else meanwhile does not want the video any more.
        services.store.watch(select.dataset, self.cancel)

    def ask(self, path: Path, field: Field | None = None) -> None:
        """Read how many frames a video has, then show the dialog; ``field``: what it shows, where
        that was said already."""

        def read(_: JobControl) -> tuple[Video, Field]:
            video = open_shared_video(path)  # its first picture is shown by the same one
            video.read_index()  # reads through the file: here, not when the dialog asks
            if field is not None:
                return video, field
            try:
                return video, field_of_dataset(path).field
            except FieldError:  # opening says what is wrong with the dataset's own
                return video, load_field()

        self._run(
            tr("Reading {file}", file=path.name),
            read,
            lambda found: self._show_dialog(*found, said=field is not None),
        )

    def cancel(self) -> None:
        """Forget the video that is being read or looked through."""
        self._work.cancel()
        self._end_progress()

    def _show_dialog(self, video: Video, shown: Field, *, said: bool) -> None:
        decided = own_field_file(frames_folder(video.path)) is not None
        dialog = VideoDialog(self._parent, video, shown, decided=decided)

        def take() -> None:
            name = dialog.field.currentData()
            same = dialog.field.currentIndex() == dialog.shown_at
            self._choose(dialog, video, (shown if said else None) if same else name)

        dialog.accepted.connect(take)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _choose(self, dialog: VideoDialog, video: Video, field: Field | str | None) -> None:
        if not dialog.cuts.isChecked():
            self._open(video.path, frames_at_interval(video, dialog.seconds.value()), field)
            return

        def look(control: JobControl) -> list[int]:
            return scene_cuts(video, progress=control.progress, cancelled=lambda: control.cancelled)

        self._run(
            tr("Looking for cuts in {file}", file=video.path.name),
            look,
            lambda numbers: self._open(video.path, numbers, field),
        )

    def _open(self, path: Path, numbers: list[int], field: Field | str | None) -> None:
        services = self._services
        if not services.opening.open_workspace(open_video(path, numbers, services.state.field)):
            return
        self._opened(path)
        if isinstance(field, Field):
            services.field_choice.take(field)
        elif field is not None:
            services.field_choice.choose(field)

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
        self._services.say(text, "error")

    def _end_progress(self) -> None:
        progress, self._progress = self._progress, None
        if progress is not None:
            progress.canceled.disconnect()
            progress.close()
            progress.deleteLater()


def keep_video_frame(services: Services) -> None:
    """Write the picture on screen next to its annotation, if it is a frame of a video."""
    frame, picture = services.state.frame, services.navigator.picture
    if frame is None or picture is None or frame.image_folder.is_dir():
        services.say(tr("this frame is a picture already"))
        return
    write(
        services, lambda _: keep_frame(frame, picture), lambda path: tr("kept as {path}", path=path)
    )
