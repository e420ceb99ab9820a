"""What the actions do that is neither the document's nor the canvas's business."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QFileDialog, QInputDialog, QMessageBox

from procc_annotator import __version__
from procc_annotator.gui.tasks.field.view_grouping import ViewGrouping
from procc_annotator.gui.tasks.files.exporting import Exporter
from procc_annotator.gui.tasks.files.exporting_as import ExportAs
from procc_annotator.gui.tasks.files.importing import AnnotationImporter
from procc_annotator.gui.tasks.files.overlay_saving import OverlaySaving
from procc_annotator.gui.tasks.files.overview_command import OverviewCommand
from procc_annotator.gui.tasks.files.video_opening import VideoOpening, keep_video_frame
from procc_annotator.gui.tasks.review.versions_command import restore_version
from procc_annotator.gui.window.context_menu import canvas_menu
from procc_annotator.gui.window.key_sheet import KeySheet
from procc_annotator.image.suffixes import PICTURE_SUFFIXES, VIDEO_SUFFIXES

if TYPE_CHECKING:
    from procc_annotator.gui.main_window import MainWindow

_CAMERA_SUFFIXES = ("json", "homographyMatrix", "txt", "npy", "zip")
_TAU_STEP = 0.5


def sample_folder() -> Path | None:
    """The sample frames of a checkout; an installed package has none."""
    folder = Path(__file__).resolve().parents[3] / "sample_data"
    return folder if folder.is_dir() else None


class Commands:
    """Slots of the action table, by name."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._document = window.document
        self.exporter = Exporter(window.document, window)
        self.importer = AnnotationImporter(window.document, window)
        self.export_as_ = ExportAs(window.document, window)
        self.overlay = OverlaySaving(window.document, window)
        self.overview = OverviewCommand(window.document, window)
        self.view_grouping = ViewGrouping(window.document, window)
        self.video = VideoOpening(window.document, window, self._remember)
        self._sheet: KeySheet | None = None

    # --- files ----------------------------------------------------------------------------

    def open_path(self, path: Path, annotations: Path | None = None) -> bool:
        """Open a folder or picture and remember it, or ask which frames of a video to open."""
        if _is_video(path):
            self.video.ask(path)
            return True
        opened = self._document.open_path(path, annotations)
        if opened:
            self._remember(path)
        elif not path.exists():
            self._window.settings.forget_recent(path)
        return opened

    def _remember(self, path: Path) -> None:
        self._window.settings.add_recent(path.resolve())
        self._window.settings.set("folder", str(path if path.is_dir() else path.parent))

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

    def open_video(self) -> None:
        """Ask for a video."""
        patterns = " ".join(f"*{s}" for s in sorted(VIDEO_SUFFIXES))
        chosen, _ = QFileDialog.getOpenFileName(
            self._window, "Open a video", self._folder("folder"), f"Videos ({patterns})"
        )
        if chosen:
            self.open_path(Path(chosen))

    def keep_frame(self) -> None:
        """Write the video frame on screen as a picture."""
        keep_video_frame(self._document)

    def open_second(self) -> None:
        """Ask for the folder of a second annotator."""
        chosen = QFileDialog.getExistingDirectory(
            self._window, "Open a second annotator's folder", self._folder("second")
        )
        if chosen and self._window.agreement.open(Path(chosen)):
            self._window.settings.set("second", chosen)
            self._window.show_panel("agreement")

    def open_sample(self) -> None:
        """Open the frames that come with a checkout."""
        folder = sample_folder()
        if folder is None:
            self._document.say("the sample comes with the source, not here", "warning")
        elif self.open_path(folder):
            self._document.say("load its cameras from the menu Camera")

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
        """Open what was dropped: pictures, folders of them and videos; the rest are cameras."""
        for path in paths:
            if _holds_pictures(path) or _is_video(path):
                self.open_path(path)
            else:
                self._document.load_cameras(path)

    def export_annotations(self) -> None:
        """Write SoccerNet JSON of the set."""
        self.exporter.ask_annotations()

    def import_annotations(self) -> None:
        """Take annotations of any format into the dataset."""
        self.importer.ask()

    def export_as(self) -> None:
        """Write the annotations in any format."""
        self.export_as_.ask()

    def export_scores(self) -> None:
        """Write JaC of the set."""
        self.exporter.ask_scores()

    def export_provenance(self) -> None:
        """Write how every point came to be."""
        self.exporter.ask_provenance()

    def save_overlay(self) -> None:
        """Write the picture on screen with what is drawn over it."""
        self.overlay.ask()

    def export_overview(self) -> None:
        """Write status, counts and time of every frame."""
        self.overview.export()

    def ask_author(self) -> None:
        """Ask for the name that points, comments and versions bear."""
        document = self._document
        name, given = QInputDialog.getText(
            self._window,
            "Your name",
            "Points, comments and versions bear it:",
            text=document.author,
        )
        if given and name.strip():
            self._window.settings.set("author", name.strip())
            document.set_author(name.strip())

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

    def set_snapping(self, on: bool) -> None:
        """Whether clicks near a painted line go to its centre."""
        self._document.set_option("snapping", on)

    def set_pinned(self, on: bool) -> None:
        """Whether elements as a whole stay where they are."""
        self._document.set_option("pinned", on)

    def set_auto_advance(self, on: bool) -> None:
        """Whether the next element is chosen after one was finished."""
        self._document.set_option("auto_advance", on)

    def set_two_clicks(self, on: bool) -> None:
        """Whether the second click finishes a straight element."""
        self._document.set_option("two_clicks", on)

    def show_menu(self, at: QPoint) -> None:
        """The menu of what is under the cursor."""
        window = self._window
        menu = canvas_menu(
            window,
            self._document,
            window.actions_,
            window.element_edits,
            window.label_check,
            drawing=window.canvas.editor.drawing,
            on_ground=window.canvas.editor.on_ground,
            ghost_tasks=window.ghost_tasks,
            ghost=window.ghost_tasks.at_cursor(),
        )
        menu.exec(at)
        menu.deleteLater()

    # --- review ---------------------------------------------------------------------------

    def comment(self) -> None:
        """Put the keyboard into the box for a comment."""
        self._window.show_panel("review")
        self._window.review.focus_comment()

    def show_versions(self) -> None:
        """Look at the saved versions of this frame."""
        restore_version(self._document, self._window)

    def show_overview(self) -> None:
        """Counts, progress and time of the set."""
        self.overview.show()

    # --- scores ---------------------------------------------------------------------------

    def step_camera(self, step: int) -> None:
        """Judge with the next source (1) or the one before (-1)."""
        document = self._document
        if not document.sources:
            document.say("no cameras are loaded (Ctrl+L)")
            return
        active = document.active_source
        if active is None:
            document.set_active_camera(0 if step > 0 else len(document.sources) - 1)
            return
        index = document.sources.index(active) + step
        document.set_active_camera(index % len(document.sources))

    def set_split(self, split: bool) -> None:
        """Divide the picture between the active and the compared source."""
        self._window.canvas.set_split(split)
        if split:
            self._say_if_alone("to see side by side")

    def set_disagreement(self, shown: bool) -> None:
        """Show where the active and the compared source disagree."""
        self._document.disagreement.set_wanted(shown)
        if shown:
            self._say_if_alone("to compare")

    def _say_if_alone(self, purpose: str) -> None:
        if self._document.compared is None:
            text = f"load a second set of cameras {purpose} (Ctrl+L)"
            self._document.say(text)

    def step_tau(self, steps: int) -> None:
        """Allow larger (1) or smaller (-1) distances."""
        self._document.set_tau(self._document.tau + steps * _TAU_STEP)

    def set_off_plane(self, choice: str) -> None:
        """How elements count that a homography cannot project."""
        self._document.set_protocol(off_plane=choice)

    def show_plots(self) -> None:
        """Open the plots."""
        self._window.show_panel("plots")

    def stop_scoring(self) -> None:
        """Stop what is computed of the whole set."""
        self._document.set_scores.cancel()
        self._window.worst_first.stop()

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
        self._sheet.show_field(self._document.field)
        self._sheet.show()
        self._sheet.raise_()

    def about(self) -> None:
        """Say which version this is."""
        QMessageBox.about(
            self._window,
            "About ProCC Annotator",
            f"ProCC Annotator {__version__}\nAnnotate and audit sports-camera calibrations.",
        )


def _is_video(path: Path) -> bool:
    return path.suffix.lower() in VIDEO_SUFFIXES and path.is_file()


def _holds_pictures(path: Path) -> bool:
    if path.suffix.lower() in PICTURE_SUFFIXES:
        return True
    try:
        return path.is_dir() and any(p.suffix.lower() in PICTURE_SUFFIXES for p in path.iterdir())
    except OSError:
        return False
