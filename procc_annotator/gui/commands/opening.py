"""Opening folders, pictures, videos, cameras; the camera sources of a dataset are remembered."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path

import msgspec
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QWidget

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.layout import copy_sample, has_pictures
from procc_annotator.errors import InputError, ProccError
from procc_annotator.field.model import Field
from procc_annotator.gui.commands.video_opening import VideoOpening, keep_video_frame
from procc_annotator.gui.settings import CAMERAS, FOLDER, RECENT, SECOND, SOURCES, Setting, Settings
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask, run_in_background
from procc_annotator.gui.state.services import Services
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.translation import tr


@dataclass(frozen=True)
class RememberedSource:
    """A source as it is written down."""

    path: str
    format: str
    name: str
    colour: str
    visible: bool = True
    active: bool = False


@dataclass(frozen=True, eq=False)
class _Reopened:
    """The reopened sources of a dataset, and those that failed."""

    found: list[tuple[RememberedSource, CameraSet]]
    lost: list[str]


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
        if before is not None:
            self._changing = True
            self._services.camera_sources.clear_sources()
            self._changing = False
        if dataset is not None:
            self._bring_back(dataset)

    def _bring_back(self, dataset: Path) -> None:
        remembered = _read(self._settings.entries(SOURCES, str(dataset)))
        if not remembered:
            return
        self._changing = True  # what is about to come back must not be forgotten meanwhile

        def work(control: JobControl) -> _Reopened:
            return _reopen(remembered)

        def done(reopened: _Reopened) -> None:
            if self._dataset == dataset:
                self._add(reopened)

        def fail(text: str) -> None:
            if self._dataset == dataset:
                self._changing = False
                self._services.say(
                    tr("cameras opened here before are not opened again: {why}", why=text),
                    "warning",
                )

        run_in_background(work, on_result=done, on_error=fail, owner=self)

    def _add(self, reopened: _Reopened) -> None:
        services = self._services
        # Sources that were opened meanwhile, or named on the command line, stay as they are.
        taken = {_place(s.files): s for s in services.state.sources if s.files is not None}
        for source, cameras in reopened.found:
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
        if reopened.lost:
            services.say(
                tr(
                    "cameras opened here before are not there any more: {paths}",
                    paths="; ".join(reopened.lost),
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
    """Return what can be understood of what is written down."""
    remembered = []
    for entry in entries:
        with suppress(msgspec.ValidationError):
            remembered.append(msgspec.convert(entry, RememberedSource))
    return remembered


def _reopen(remembered: list[RememberedSource]) -> _Reopened:
    reopened = _Reopened([], [])
    for source in remembered:
        try:
            cameras = CameraSet.open(Path(source.path), source.format, source.name)
        except (ProccError, OSError):
            reopened.lost.append(source.path)
            continue
        if cameras.frames:
            reopened.found.append((source, cameras))
        else:
            reopened.lost.append(source.path)
    return reopened


_CAMERA_SUFFIXES = (".json", ".homographyMatrix", ".txt", ".npy", ".zip")


def sample_folder() -> Path | None:
    """The sample frames that come with the program; a package of others may have left them out."""
    package = Path(__file__).resolve().parents[2]
    folders = (package / "_sample_data", package.parent / "sample_data")  # installed, or a checkout
    return next((folder for folder in folders if folder.is_dir()), None)


class OpeningTask(QObject):
    """Asks what to open, opens it, and remembers it."""

    secondChosen = Signal(Path)  # the folder of a second annotator

    def __init__(self, services: Services, settings: Settings, window: QWidget) -> None:
        super().__init__(window)
        self._services = services
        self._settings = settings
        self._window = window
        self._copying = LatestOnlyTask(self, lambda why: services.say(why, "warning"))
        self.video = VideoOpening(services, window, self._remember)

    def open_path(
        self, path: Path, annotations: Path | None = None, field: Field | None = None
    ) -> bool:
        """Open a folder or picture and remember it, or ask which frames of a video to open; a
        ``field`` is the dataset's from then on."""
        if _is_video(path):
            self.video.ask(path, field)
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
        """Open what was dropped: pictures, folders of them and videos; the rest are cameras."""
        for path in paths:
            if _holds_pictures(path) or _is_video(path):
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
        """Ask for a video."""
        kind = tr("Videos"), sorted(VIDEO_SUFFIXES)
        if (chosen := self._ask_file(tr("Open a video"), FOLDER, *kind)) is not None:
            self.open_path(chosen)

    def keep_frame(self) -> None:
        """Write the video frame on screen as a picture."""
        keep_video_frame(self._services)

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


def _holds_pictures(path: Path) -> bool:
    if path.suffix.lower() in PICTURE_SUFFIXES:
        return True
    try:
        return path.is_dir() and has_pictures(path)
    except InputError:
        return False
