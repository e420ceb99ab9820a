"""Opening folders, pictures, videos, cameras; the camera sources of a dataset are remembered."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import TypeVar

import msgspec
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import (
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QLabel,
    QProgressDialog,
    QRadioButton,
    QWidget,
)

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.dataset_field import field_of_dataset, own_field_file
from procc_annotator.dataset.diagnostics import loadable
from procc_annotator.dataset.layout import copy_sample, frames_folder
from procc_annotator.dataset.season import is_list, kinds_met_first
from procc_annotator.dataset.sequence import keep_frame, open_video
from procc_annotator.errors import FieldError, ProccError
from procc_annotator.field.load import field_names, field_titles, load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.commands.dialogs import NamedDialog, dialog_buttons
from procc_annotator.gui.commands.season import SeasonTask
from procc_annotator.gui.messages import write
from procc_annotator.gui.panels.widgets import DecimalBox, choice
from procc_annotator.gui.settings import (
    CAMERAS,
    FOLDER,
    RECENT,
    SECOND,
    SOURCES,
    VIDEO_EVERY,
    VIDEO_FIELD,
    VIDEO_SCENES,
    Setting,
    Settings,
)
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.services import Services
from procc_annotator.image.archive import ARCHIVE_SUFFIXES
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.image.video import Video, frames_at_interval, open_shared_video, scene_cuts
from procc_annotator.translation import tr, tr_count

T = TypeVar("T")

# Short work needs no window that says so.
_PATIENCE_MS = 400


class VideoDialog(NamedDialog):
    """Every so many seconds, or one frame for each scene; and which field the video shows."""

    def __init__(self, parent: QWidget, video: Video, shown: Field, *, decided: bool) -> None:
        """Show the field as far as known; if ``decided`` a file in the dataset's folder says so,
        and no other can be chosen."""
        super().__init__(parent, "videoDialog", tr("Open a video"))
        width, height = video.size
        seconds = video.frame_count / video.fps if video.fps else 0.0
        frames = tr_count(video.frame_count, "{n:,} frame", "{n:,} frames")
        text = f"{video.path.name}: {frames}, {width}x{height}, {seconds:.0f} s"
        text = "\n".join(filter(None, (text, video.cut_off, video.squeezed)))
        self.interval = QRadioButton(tr("One frame every"))
        self.interval.setChecked(True)
        self.seconds = DecimalBox(0.02, 3600.0, 1.0, " s")
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
        buttons, _ = dialog_buttons(self, QDialogButtonBox.StandardButton.Open)
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
        self._services, self._settings = services, Settings()
        self._parent = parent
        self._opened = opened
        self._work = LatestOnlyTask(services, self._fail)
        self._progress: QProgressDialog | None = None
        # Anyone who opened something else meanwhile does not want the video any more.
        services.store.watch(select.dataset, self.cancel)

    def ask(self, path: Path, field: Field | None = None) -> None:
        """Read how many frames a video has, then show the dialog; ``field``: what it shows, where
        that was said already."""

        last = self._settings.get(VIDEO_FIELD)

        def read(_: JobControl) -> tuple[Video, Field, bool]:
            video = open_shared_video(path)  # its first picture is shown by the same one
            video.read_index()  # reads through the file: here, not when the dialog asks
            if field is not None:
                return video, field, True
            try:
                found = field_of_dataset(path)
            except FieldError:  # opening says what is wrong with the dataset's own
                return video, load_field(), False
            asks = not found.chosen and last in field_names()
            return video, load_field(last) if asks else found.field, asks

        self._run(
            tr("Reading {file}", file=path.name),
            read,
            lambda found: self._show_dialog(*found),
        )

    def cancel(self) -> None:
        """Forget the video that is being read or looked through."""
        self._work.cancel()
        self._end_progress()

    def _show_dialog(self, video: Video, shown: Field, said: bool) -> None:
        decided = own_field_file(frames_folder(video.path)) is not None
        dialog = VideoDialog(self._parent, video, shown, decided=decided)
        dialog.seconds.setValue(self._settings.get(VIDEO_EVERY))
        dialog.cuts.setChecked(self._settings.get(VIDEO_SCENES))

        def take() -> None:
            name = dialog.field.currentData()
            self._settings.set(VIDEO_EVERY, dialog.seconds.value())
            self._settings.set(VIDEO_SCENES, dialog.cuts.isChecked())
            self._settings.set(VIDEO_FIELD, name or "")
            same = dialog.field.currentIndex() == dialog.shown_at
            self._choose(dialog, video, (shown if said else None) if same else name)

        dialog.accepted.connect(take)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _choose(self, dialog: VideoDialog, video: Video, field: Field | str | None) -> None:
        if not dialog.cuts.isChecked():
            self._open(video.path, frames_at_interval(video, dialog.seconds.value()), field)
            return

        self._run(
            tr("Looking for cuts in {file}", file=video.path.name),
            lambda job: scene_cuts(video, progress=job.progress, cancelled=lambda: job.cancelled),
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


@dataclass(frozen=True)
class RememberedSource:
    """A source as it is written down."""

    path: str
    format: str
    name: str
    colour: str
    visible: bool = True
    active: bool = False


_Reopened = tuple[RememberedSource, CameraSet]


class SourceMemory(QObject):
    """Writes down the sources whenever they change; brings them back with their dataset.

    Sources belong to the dataset they were opened with: another dataset brings its own. Those that
    were opened before any dataset go over to the first one.
    """

    def __init__(self, services: Services, settings: Settings, parent: QObject) -> None:
        super().__init__(parent)
        self._services = services
        self._settings = settings
        self._dataset: Path | None = None
        self._changing = False
        self._reopening = LatestOnlyTask(self, self._fail)
        self._written: list[dict[str, object]] | None = None
        services.store.watch(select.dataset, self._take_dataset)
        services.store.watch(select.cameras, self._write_down)

    def _take_dataset(self) -> None:
        workspace = self._services.state.workspace
        dataset = workspace.root.resolve() if workspace is not None else None
        if dataset == self._dataset:
            return
        before, self._dataset = self._dataset, dataset
        self._written = None
        self._reopening.cancel()
        if before is not None:
            self._changing = True
            self._services.camera_sources.clear_sources()
            self._changing = False
        remembered = [] if dataset is None else _read(self._settings.entries(SOURCES, str(dataset)))
        if remembered:
            self._changing = True  # what is about to come back must not be forgotten meanwhile
            self._reopening.start(lambda _: _reopen(remembered), self._add)

    def add(self, path: Path) -> None:
        """Open cameras in the background with those that the dataset had, unless it had them."""
        remembered = _read(self._settings.entries(SOURCES, str(self._dataset)))
        if all(source.path != str(path) for source in remembered):
            self._changing = True
            remembered.append(RememberedSource(str(path), "auto", path.stem, "", active=True))
            self._reopening.start(lambda _: _reopen(remembered), self._add)

    def _fail(self, text: str) -> None:
        self._changing = False
        said = tr("cameras opened here before are not opened again: {why}", why=text)
        self._services.say(said, "warning")

    def _add(self, reopened: tuple[list[_Reopened], list[str]]) -> None:
        services, (found, lost) = self._services, reopened
        # Sources that were opened meanwhile, or named on the command line, stay as they are.
        taken = {_place(s.files): s for s in services.state.sources if s.files is not None}
        for source, cameras in found:
            known = taken.get(_place(cameras))
            if known is None:
                services.camera_sources.add_source(
                    cameras,
                    colour=source.colour,
                    visible=source.visible,
                    active=source.active and not taken,
                )
            elif known.name in (cameras.path.name, cameras.path.stem):  # nobody named it otherwise
                services.camera_sources.rename_source(known, source.name)
                services.camera_sources.set_source_colour(known, source.colour)
        self._changing = False
        self._write_down()
        if lost:
            services.say(
                tr(
                    "cameras opened here before are not there any more: {paths}",
                    paths="; ".join(lost),
                ),
                "warning",
            )

    def _write_down(self) -> None:
        if self._changing or self._dataset is None:
            return
        services = self._services
        entries = [
            asdict(
                RememberedSource(
                    os.path.abspath(cameras.path),
                    cameras.format,
                    source.name,
                    source.colour,
                    source.visible,
                    source is services.state.active,
                )
            )
            for source in services.state.sources
            if (cameras := source.files) is not None
        ]
        if entries != self._written:
            self._written = entries
            self._settings.set_entries(SOURCES, str(self._dataset), entries)


def _place(cameras: CameraSet) -> tuple[Path, str]:
    return Path(os.path.abspath(cameras.path)), cameras.format


def _read(entries: list[object]) -> list[RememberedSource]:
    remembered = []
    for entry in entries:
        with suppress(msgspec.ValidationError):
            remembered.append(msgspec.convert(entry, RememberedSource))
    return remembered


def _reopen(remembered: list[RememberedSource]) -> tuple[list[_Reopened], list[str]]:
    """Return the sources that were reopened, and the paths of those without cameras."""
    found, lost = [], []
    for source in remembered:
        try:
            cameras = CameraSet.open(Path(source.path), source.format, source.name)
        except (ProccError, OSError):
            lost.append(source.path)
            continue
        if cameras.frames:
            found.append((source, cameras))
        else:
            lost.append(source.path)
    return found, lost


_CAMERA_SUFFIXES = (".json", ".homographyMatrix", ".txt", ".npy", ".zip")


def sample_folder() -> Path | None:
    """The sample frames that come with the program; a package of others may have left them out."""
    package = Path(__file__).resolve().parents[2]
    folders = (package / "_sample_data", package.parent / "sample_data")  # installed, or a checkout
    return next((folder for folder in folders if folder.is_dir()), None)


class OpeningTask(QObject):
    """Asks what to open, opens it, and remembers it."""

    secondChosen = Signal(Path)  # the folder of a second annotator
    camerasTracked = Signal(Path)  # of the match of a season that was opened

    def __init__(self, services: Services, settings: Settings, window: QWidget) -> None:
        super().__init__(window)
        self._services = services
        self._settings = settings
        self._window = window
        self._copying = LatestOnlyTask(self, lambda why: services.say(why, "warning"))
        self.video = VideoOpening(services, window, self._remember)
        self.season = SeasonTask(
            services, settings, window, lambda path, field: self.open_path(path, field=field)
        )

    def open_path(
        self, path: Path, annotations: Path | None = None, field: Field | None = None,
        *, season: bool = True,
    ) -> bool:  # fmt: skip
        """Open a folder or picture and remember it, or ask which frames of a video or which match
        of a ``season`` to open; a ``field`` is the dataset's from then on."""
        if _is_video(path):
            self.video.ask(path, field)
            return True
        kinds = kinds_met_first(path) if path.is_dir() else PICTURE_SUFFIXES
        if season and (is_list(path) or (kinds and not kinds & PICTURE_SUFFIXES)):
            self.season.field = field
            pictures = partial(self.open_path, path, annotations, field, season=False)
            self.season.read(path.absolute(), none=pictures)
            return True
        opened = self._services.opening.open_path(path, annotations)
        if field is not None:
            self._services.field_choice.take(field)
        if opened:
            self._remember(path)
        elif not path.exists():
            self._settings.take_out(RECENT, path)
        return opened

    def drop(self, paths: Sequence[Path]) -> None:
        """Open what was dropped: pictures, videos, folders of them and, if nothing is open, lists
        of matches; the rest are cameras."""
        nothing = self._services.state.workspace is None
        for path in paths:
            if kinds_met_first(path).difference(ARCHIVE_SUFFIXES) or (nothing and is_list(path)):
                self.open_path(path)
            else:
                self._services.camera_sources.load_cameras(path)

    def open_folder(self) -> None:
        """Ask for a folder of pictures."""
        if (chosen := self._ask_folder(tr("Open a folder of pictures"), FOLDER)) is not None:
            self.open_path(chosen)

    def open_picture(self) -> None:
        """Ask for one picture."""
        kind = tr("Pictures"), sorted(PICTURE_SUFFIXES)
        if (chosen := self._ask_file(tr("Open a picture"), FOLDER, *kind)) is not None:
            self.open_path(chosen)

    def open_video(self) -> None:
        """Ask for a video, or a list of them."""
        kind = tr("Videos"), sorted(VIDEO_SUFFIXES | {".csv"})
        if (chosen := self._ask_file(tr("Open a video"), FOLDER, *kind)) is not None:
            self.open_path(chosen)

    def keep_frame(self) -> None:
        """Write the picture on screen next to its annotation, if it is a frame of a video."""
        services = self._services
        frame, picture = services.state.frame, services.navigator.picture
        if frame is None or picture is None or frame.image_folder.is_dir():
            services.say(tr("this frame is a picture already"))
            return
        write(
            services,
            lambda _: keep_frame(frame, picture),
            lambda path: tr("kept as {path}", path=path),
        )

    def open_second(self) -> None:
        """Ask for the folder of a second annotator."""
        if (chosen := self._ask_folder(tr("Open a second annotator's folder"), SECOND)) is not None:
            self.secondChosen.emit(chosen)

    def open_sample(self) -> None:
        """Open the user's own copy of the frames that come with the program."""
        folder = sample_folder()
        if folder is None:
            self._services.say(tr("the sample comes with the source, not here"), "warning")
        else:
            self._copying.start(lambda _: copy_sample(folder), self._open_copy)

    def _open_copy(self, folder: Path) -> None:
        if self.open_path(folder):
            self._services.say(
                tr(
                    "your own copy, in {folder}; load its cameras from the menu Camera",
                    folder=folder,
                )
            )

    def load_cameras(self) -> None:
        """Ask for a folder of cameras."""
        self._load(self._ask_folder(tr("Load a folder of cameras"), CAMERAS))

    def load_camera_file(self) -> None:
        """Ask for one camera file or a zip."""
        self._load(self._ask_file(tr("Load cameras"), CAMERAS, tr("Cameras"), _CAMERA_SUFFIXES))

    # --- inside ---

    def _load(self, chosen: Path | None) -> None:
        if chosen is not None and self._services.camera_sources.load_cameras(chosen):
            self._settings.set(CAMERAS, str(chosen))

    def _remember(self, path: Path) -> None:
        self._settings.put_first(RECENT, path.resolve())
        self._settings.set(FOLDER, str(path if path.is_dir() else path.parent))
        cameras = self.season.season.cameras.get(path) if self.season.season else None
        if cameras is not None and cameras.is_file():
            self.camerasTracked.emit(cameras)

    def _ask_folder(self, title: str, beside: Setting[str]) -> Path | None:
        start = self._settings.get(beside)
        chosen = QFileDialog.getExistingDirectory(self._window, title, start)
        return Path(chosen) if chosen else None

    def _ask_file(
        self, title: str, beside: Setting[str], what: str, suffixes: Sequence[str]
    ) -> Path | None:
        patterns = " ".join(f"*{suffix}" for suffix in suffixes)
        start = self._settings.get(beside)
        chosen, _ = QFileDialog.getOpenFileName(self._window, title, start, f"{what} ({patterns})")
        return Path(chosen) if chosen else None


def _is_video(path: Path) -> bool:
    return path.suffix.lower() in VIDEO_SUFFIXES and path.is_file()
