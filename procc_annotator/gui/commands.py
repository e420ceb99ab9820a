"""What the actions do that is neither the document's nor the canvas's business."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QFileDialog, QMessageBox

from procc_annotator import __version__
from procc_annotator.gui.exporting import Exporter
from procc_annotator.gui.key_sheet import KeySheet
from procc_annotator.image.decode import PICTURE_SUFFIXES

if TYPE_CHECKING:
    from procc_annotator.gui.main_window import MainWindow

_CAMERA_SUFFIXES = ("json", "homographyMatrix", "txt", "npy", "zip")
_TAU_STEP = 0.5


def sample_folder() -> Path | None:
    """The sample frames of a checkout; an installed package has none."""
    folder = Path(__file__).resolve().parents[2] / "sample_data"
    return folder if folder.is_dir() else None


class Commands:
    """Slots of the action table, by name."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._document = window.document
        self.exporter = Exporter(window.document, window)
        self._sheet: KeySheet | None = None

    # --- files ----------------------------------------------------------------------------

    def open_path(self, path: Path, annotations: Path | None = None) -> bool:
        """Open a folder or picture and remember it."""
        opened = self._document.open_path(path, annotations)
        if opened:
            self._window.settings.add_recent(path.resolve())
            self._window.settings.set("folder", str(path if path.is_dir() else path.parent))
        return opened

    def open_folder(self) -> None:
        """Ask for a folder of pictures."""
        chosen = QFileDialog.getExistingDirectory(
            self._window, "Open a folder of pictures", self._folder("folder")
        )
        if chosen:
            self.open_path(Path(chosen))

    def open_picture(self) -> None:
        """Ask for one picture."""
        patterns = " ".join(f"*{s}" for s in sorted(PICTURE_SUFFIXES))
        chosen, _ = QFileDialog.getOpenFileName(
            self._window, "Open a picture", self._folder("folder"), f"Pictures ({patterns})"
        )
        if chosen:
            self.open_path(Path(chosen))

    def open_sample(self) -> None:
        """Open the frames that come with a checkout."""
        folder = sample_folder()
        if folder is None:
            self._document.message.emit("the sample comes with the source, not here", "warning")
        elif self.open_path(folder):
            self._document.message.emit("load its cameras from the menu Camera", "info")

    def load_cameras(self) -> None:
        """Ask for a folder of cameras."""
        chosen = QFileDialog.getExistingDirectory(
            self._window, "Load a folder of cameras", self._folder("cameras")
        )
        self._load(chosen)

    def load_camera_file(self) -> None:
        """Ask for one camera file or a zip."""
        patterns = " ".join(f"*.{s}" for s in _CAMERA_SUFFIXES)
        chosen, _ = QFileDialog.getOpenFileName(
            self._window, "Load cameras", self._folder("cameras"), f"Cameras ({patterns})"
        )
        self._load(chosen)

    def drop(self, paths: Sequence[Path]) -> None:
        """Open what was dropped: pictures or folders of them as dataset, the rest as cameras."""
        for path in paths:
            if _holds_pictures(path):
                self.open_path(path)
            else:
                self._document.load_cameras(path)

    def export_annotations(self) -> None:
        """Write SoccerNet JSON of the set."""
        self.exporter.ask_annotations()

    def export_scores(self) -> None:
        """Write JaC of the set."""
        self.exporter.ask_scores()

    def _load(self, chosen: str) -> None:
        if chosen and self._document.load_cameras(Path(chosen)):
            self._window.settings.set("cameras", chosen)

    def _folder(self, key: str) -> str:
        return self._window.settings.text(key, str(Path.home()))

    # --- frames and elements --------------------------------------------------------------

    def last_frame(self) -> None:
        """Show the last frame."""
        if self._document.workspace is not None:
            self._document.go_to(len(self._document.workspace.frames) - 1)

    def find_frame(self) -> None:
        """Put the keyboard into the frames' filter box."""
        self._window.show_panel("frames")
        self._window.frames.focus_filter()

    def switch_mode(self) -> None:
        """From drawing to editing and back."""
        self._document.set_mode("edit" if self._document.mode == "draw" else "draw")

    def find_element(self) -> None:
        """Put the keyboard into the list of elements' search box."""
        self._window.show_panel("elements")
        self._window.elements.focus_search()

    def step_element(self, step: int) -> None:
        """Choose the next class of the field (1) or the one before (-1)."""
        field = self._document.field
        names = [*(e.name for e in field.elements), *field.classes_without_geometry]
        current = self._document.selected_class
        if current in names:
            index = (names.index(current) + step) % len(names)
        else:
            index = 0 if step > 0 else -1
        self._document.select_class(names[index])

    # --- scores ---------------------------------------------------------------------------

    def next_camera(self) -> None:
        """Judge with the next set."""
        sets = self._document.camera_sets
        active = self._document.active_camera
        if not sets:
            self._document.message.emit("no cameras are loaded (Ctrl+L)", "info")
            return
        current = sets.index(active) if active is not None else -1
        self._document.set_active_camera((current + 1) % len(sets))

    def step_tau(self, steps: int) -> None:
        """Allow larger (1) or smaller (-1) distances."""
        self._document.set_tau(self._document.tau + steps * _TAU_STEP)

    def set_off_plane(self, choice: str) -> None:
        """How elements count that a homography cannot project."""
        self._document.set_protocol(off_plane=choice)

    # --- looks ----------------------------------------------------------------------------

    def set_panels_hidden(self, hidden: bool) -> None:
        """Give the picture all the room, or put the panels back."""
        self._window.set_panels_hidden(hidden)

    def reset_layout(self) -> None:
        """Forget the arrangement of panels."""
        self._window.reset_layout()

    def show_keys(self) -> None:
        """Open the sheet of keys."""
        if self._sheet is None:
            self._sheet = KeySheet(self._document.field, self._window)
        self._sheet.show()
        self._sheet.raise_()

    def about(self) -> None:
        """Say which version this is."""
        QMessageBox.about(
            self._window,
            "About ProCC Annotator",
            f"ProCC Annotator {__version__}\nAnnotate and audit sports-camera calibrations.",
        )


def _holds_pictures(path: Path) -> bool:
    if path.suffix.lower() in PICTURE_SUFFIXES:
        return True
    try:
        return path.is_dir() and any(p.suffix.lower() in PICTURE_SUFFIXES for p in path.iterdir())
    except OSError:
        return False
