"""The one live state that all widgets share: dataset, frame on screen, scores, selection.

Signals, and what they say:

==================  ===============================================================================
datasetChanged      another dataset (or none); `frameChanged` follows
frameChanged        another frame is on screen: picture, annotation, selection, scores, save state
                    are all new; no other signal is sent for them
framesEdited        annotations of frames (a list of indices) that need not be on screen
annotationChanged   the frame's annotation: an edit, undo, redo or reload; `scoreChanged` follows
previewChanged      the annotation as it would be if the mouse button were released now
selectionChanged    selected class or point
hoverChanged        the class under the cursor, in whatever widget
scoreChanged        measurement, threshold, protocol, camera of the frame, or blind mode
fieldChanged        another field, or other dimensions; `scoreChanged` follows
camerasChanged      camera sources were loaded, removed, renamed or are shown otherwise; another one
                    is active or compared
frameScoresChanged  per-frame JaC of one frame, or of all of them ("")
sourceAuditsChanged (source) more is known of how a source does in the frames of the set
saveStateChanged    whether everything is saved
modeChanged         draw or edit, blind or not, snapping, pinning and the like
blindChanged        blind mode is on, or off
aboutToLeave        the frame on screen is about to be left: finish what is under way
flyTo               show this position of the picture (px)
flyToArea           show this part of the picture (px: left, top, right, bottom)
message             one line for the user; level "info", "warning" or "error"
==================  ===============================================================================
"""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Literal

from PySide6.QtCore import Signal

from procc_annotator.errors import ImageError, InputError, ProccError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.state.blind_lock import BlindLock
from procc_annotator.gui.state.edited_frame import EditedFrame
from procc_annotator.gui.state.field_choice import FieldChoice
from procc_annotator.gui.state.fit_source import FitSource
from procc_annotator.gui.state.ghosts import Ghosts
from procc_annotator.gui.state.label_check import LabelCheck
from procc_annotator.gui.state.landmarks import Landmarks
from procc_annotator.gui.state.live_fit import LiveFit
from procc_annotator.gui.state.outside_changes import OutsideChanges
from procc_annotator.gui.state.second import SecondAnnotator
from procc_annotator.gui.state.uncertainty import UncertaintyWatch
from procc_annotator.image.cache import FrameCache
from procc_annotator.session.database.database import WorkspaceDatabase
from procc_annotator.session.dataset.workspace import Workspace
from procc_annotator.session.facts.origins import default_author

Mode = Literal["draw", "edit"]
Option = Literal["snapping", "pinned", "auto_advance", "two_clicks"]

_CACHE_BYTES = 48 * 2**20
_EMPTY_COMMIT = (
    "blind: nothing is annotated here; Ctrl+Enter again shows the cameras, and what is clicked"
    " after that is no blind work"
)


class Document(EditedFrame):
    """Shared by canvas and panels, which display it and call its methods; it knows no widget."""

    datasetChanged = Signal()
    frameChanged = Signal()
    framesEdited = Signal(list)
    modeChanged = Signal()
    blindChanged = Signal(bool)
    flyTo = Signal(float, float)
    flyToArea = Signal(float, float, float, float)

    def __init__(self, field: Field | None = None, cache: FrameCache | None = None) -> None:
        super().__init__(field if field is not None else load_field())
        self.cache = cache if cache is not None else FrameCache(_CACHE_BYTES)
        self.mode: Mode = "draw"
        self.snapping, self.pinned = True, True
        self.auto_advance, self.two_clicks = True, False
        self.author = default_author()
        self._opened: tuple[Path, Path | None] | None = None
        self._empty_asked: str | None = None  # frame whose commit with nothing in it was asked for
        self.review.failed.connect(lambda text: self.message.emit(text, "warning"))
        self.frameChanged.connect(self.disagreement.look)
        self.presence.changed.connect(self.modeChanged)
        self.second = SecondAnnotator(self.field, self)
        self.second.message.connect(self.message)
        self.fieldChanged.connect(lambda: self.second.set_field(self.field))
        self.blind_lock = BlindLock(self)
        self.live_fit = LiveFit(self)
        self.uncertainty = UncertaintyWatch(self)
        self.fit_source = FitSource(self)
        self.ghosts = Ghosts(self)
        self.label_check = LabelCheck(self)
        self.field_choice = FieldChoice(self)
        self.landmarks = Landmarks(self)
        self.outside = OutsideChanges(self)

    # --- dataset and frames ------------------------------------------------------------------

    def open_path(self, path: Path, annotations: Path | None = None) -> bool:
        """Open a folder of pictures or one picture; on failure the session stays as it is."""
        self.aboutToLeave.emit()
        if not self.save_now():
            self.message.emit(
                "not everything is saved yet: the other dataset was not opened", "error"
            )
            return False
        try:
            workspace = Workspace.open(path, self.field, annotations)
        except ProccError as error:
            self.message.emit(str(error), "error")
            return False
        self._take_workspace(workspace)
        self._opened = (path, annotations)
        return True

    def open_workspace(self, workspace: Workspace) -> bool:
        """Show a dataset that was put together elsewhere (frames of a video)."""
        self.aboutToLeave.emit()
        if not self.save_now():
            self.message.emit("not everything is saved yet: the video was not opened", "error")
            return False
        self._take_workspace(workspace)
        self._opened = None
        return True

    def _take_workspace(self, workspace: Workspace) -> None:
        self.set_scores.forget(self.sources)
        if self.review.database is not None:
            self.review.database.flush()  # the same dataset may be opened again
        database = WorkspaceDatabase.open(workspace.root, self.author)
        workspace.database = database
        self.review.set_database(database)
        self.presence.set_dataset(workspace.root, self.author)
        self.workspace = workspace
        first = workspace.index.get(database.last_frame or "", 0)
        self.frame_index = first if workspace.frames else -1
        self._choose_points(None)
        self.last_finished = None
        self.saver.set_workspace(workspace)
        self.second.close()
        shown = self.field_choice.field_of(workspace, database)
        field = self.landmarks.take(workspace, shown.field)
        other_field = field != self.field or field.source != self.field.source
        self._use_field(field)
        self._load_frame()
        if other_field:
            self.fieldChanged.emit()
        self.datasetChanged.emit()
        self.frameChanged.emit()
        self._score_set()
        if self.field.own_terms:
            self.message.emit(f"the field of this dataset: {self.field.described}", "info")
        landmarks = [t for t in (self.landmarks.problem, self.landmarks.strange) if t]
        notices = (
            *self._unwritable(workspace),
            *shown.notices,
            *landmarks,
            *database.notices,
            *workspace.notices,
        )
        if notices:
            self.message.emit("; ".join(notices[:3]), "warning")

    @staticmethod
    def _unwritable(workspace: Workspace) -> tuple[str, ...]:
        """That nothing can be saved, said before anybody has worked for nothing."""
        folder = workspace.frames[0].annotation_folder if workspace.frames else workspace.folder
        if not folder.is_dir() or os.access(folder, os.W_OK):
            return ()
        return (f"{folder} cannot be written: nothing that is annotated here can be saved",)

    def reopener(self) -> Callable[[], Workspace]:
        """What opens the dataset as it is on disk, in a thread of its own: this dataset with this
        field, whatever is shown by then. It raises `ProccError` if that cannot be opened any more.

        Raises:
            UsageError: nothing is open.
        """
        workspace, field = self.workspace, self.field
        if workspace is None:
            raise UsageError("nothing is open")
        if self._opened is None:  # frames of a video
            return partial(Workspace, workspace.root, workspace.frames, field, ())
        path, annotations = self._opened
        return partial(Workspace.open, path, field, annotations)

    def close(self) -> None:
        """Stop everything that runs in the background."""
        self.outside.close()
        self.set_scores.close()
        self.source_frames.close()
        self.live_fit.close()
        self.label_check.close()
        self.field_choice.close()
        self.landmarks.close()
        self.ghosts.close()
        self.uncertainty.close()
        self.disagreement.close()
        self.painted_width.close()
        self.saver.retry_timer.stop()
        self.presence.close()
        self.review.set_database(None)
        self.cache.close()

    def go_to(self, index: int) -> None:
        """Show another frame; what is under way on this one is finished first."""
        if self.workspace is None or index == self.frame_index:
            return
        if not 0 <= index < len(self.workspace.frames):
            return
        self.aboutToLeave.emit()
        self.frame_index = index
        self._choose_points(None)
        self.hovered_class = self.last_finished = None
        changed = self._load_frame()
        self.frameChanged.emit()
        if changed:
            if index not in self.workspace.dirty_frames():
                self.saver.save(index)  # nothing to save: a conflict that waited is decided
            self.framesEdited.emit([index])
        name = self.workspace.frames[index].name
        if any(s.files is not None and s.files.written_since(name) for s in self.sources):
            self.outside.look()

    def next_frame(self) -> None:
        """Show the next frame, if there is one."""
        self.go_to(self.frame_index + 1)

    def previous_frame(self) -> None:
        """Show the previous frame, if there is one."""
        self.go_to(self.frame_index - 1)

    def go_to_unannotated(self, step: int) -> None:
        """Show the nearest frame without annotation before (-1) or after (1) this one."""
        if self.workspace is None:
            return
        index = self.frame_index + step
        while 0 <= index < len(self.workspace.frames):
            if self._is_unannotated(index):
                self.go_to(index)
                return
            index += step
        where = "after" if step > 0 else "before"
        self.message.emit(f"every frame {where} this one is annotated", "info")

    def _is_unannotated(self, index: int) -> bool:
        """Whether a frame has no annotation yet; an unreadable one has."""
        try:
            return self.workspace is not None and not self.workspace.annotated_count(index)
        except InputError:
            return False

    def set_author(self, author: str) -> None:
        """Give points, comments and versions another author from now on."""
        self.author = author
        if self.review.database is not None:
            self.review.database.author = author

    def look_at_frame(self) -> None:
        """Follow the file of the frame on screen if others wrote it. A gesture under way goes on,
        and what is not saved yet stays: saving then tells that both differ."""
        if self.workspace is None or self.frame is None or self._preview is not None:
            return
        before, damage = self.annotation, self._damage
        changed = self.workspace.look_again(self.frame_index)
        if not changed or self.frame_index in self.workspace.dirty_frames():
            return
        if self.annotation == before and self._damage == damage:
            self._audit_frame_again()  # an empty file came or went: that is another score
            self.scoreChanged.emit()
            return
        self._drop_stale_points(before)
        self._after_edit()  # nothing is to be saved: a conflict that waited is decided
        self.framesEdited.emit([self.frame_index])
        self.modeChanged.emit()
        self.message.emit(f"{self.frame.name} was changed elsewhere: read again", "info")

    # --- modes ---------------------------------------------------------------------------------

    def set_mode(self, mode: Mode) -> None:
        """Draw or edit; a polyline under way is finished first."""
        if mode != self.mode:
            self.aboutToLeave.emit()
            self.mode = mode
            self.modeChanged.emit()

    def set_option(self, option: Option, on: bool) -> None:
        """Switch snapping, pinning of elements, the offer of the next element, or the finish of
        straight elements at the second click."""
        if getattr(self, option) != on:
            setattr(self, option, on)
            self.modeChanged.emit()

    # --- blind mode ------------------------------------------------------------------------------

    def set_blind(self, blind: bool) -> None:
        """Hide everything of the camera until the frame is committed, or show it again unless the
        dataset is locked to blind mode."""
        self.apply_blind(self.blind_lock.choose(blind))

    def apply_blind(self, blind: bool) -> None:
        """Hide everything of the camera, or show it, whoever decided so."""
        if blind != self.blind:
            self.blind = blind
            self.blindChanged.emit(blind)
            self.scoreChanged.emit()
            self.frameScoresChanged.emit("")
        self.modeChanged.emit()

    def commit_frame(self) -> None:
        """The annotator is done with this frame: the projection may be shown. In blind mode an
        empty one must be committed twice: that shows its cameras before anything is clicked."""
        if (frame := self.frame) is None:
            return
        self.aboutToLeave.emit()
        seen = self.annotation
        if not self.presence.owned:
            self._take_newer_file()
        if self.annotation is not seen:
            return  # nobody is done with what they have not seen: that it was read again is said
        blind = not self.projection_visible
        if blind and not self.annotation.annotated and self._empty_asked != frame.name:
            self._empty_asked = frame.name
            self.message.emit(_EMPTY_COMMIT, "info")
            return
        waiting = len(self.annotation.unconfirmed)
        self.review.commit(frame.name, self.annotation, blind=blind)
        self.scoreChanged.emit()
        self.frameScoresChanged.emit(frame.name)
        left = f"; unconfirmed elements do not count: {waiting}" if waiting else ""
        self.message.emit(f"{frame.name} is done{left}", "info")

    # --- inside ----------------------------------------------------------------------------------

    def _load_frame(self) -> bool:
        """Whether its file was written by others since something was made from it."""
        self._preview = self._empty_asked = None
        self.picture, self.picture_error = None, ""
        frame = self.frame
        name = frame.name if frame is not None else None
        changed = False
        if self.workspace is not None and frame is not None:
            changed = self.workspace.look_again(self.frame_index)
        self.outside.watch_frame()
        self.review.enter(name)
        self.presence.enter(name)
        self.second.show(name)
        if frame is not None:
            try:
                self.picture = self.cache.get(frame.image_path)
            except ImageError as error:
                self.picture_error = str(error)
            self._prefetch_neighbours()
        self._show_camera()
        self.judge.judge(self.annotation)
        self._show_sources()
        if changed:
            self._audit_frame_again()
        return changed

    def _prefetch_neighbours(self) -> None:
        frames = self.workspace.frames if self.workspace is not None else ()
        around = (self.frame_index + step for step in (0, 1, -1, 2))
        here, *soon = [frames[i] for i in around if 0 <= i < len(frames)]
        self.cache.prefetch([frame.image_path for frame in soon])
        self.review.foresee(frame.name for frame in (here, *soon))
