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
fieldChanged        the field has other dimensions; `scoreChanged` follows
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

from collections.abc import Callable, Collection
from pathlib import Path
from typing import Literal

from PySide6.QtCore import Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import ImageError, InputError, ProccError, UsageError
from procc_annotator.field.load import load_field, resized
from procc_annotator.field.model import Field
from procc_annotator.gui.state.blind_lock import BlindLock
from procc_annotator.gui.state.fit_source import FitSource
from procc_annotator.gui.state.ghosts import Ghosts
from procc_annotator.gui.state.judged_frame import JudgedFrame
from procc_annotator.gui.state.label_check import LabelCheck
from procc_annotator.gui.state.live_fit import LiveFit
from procc_annotator.gui.state.presence import Presence
from procc_annotator.gui.state.saving import Saver
from procc_annotator.gui.state.second import SecondAnnotator
from procc_annotator.gui.state.uncertainty import UncertaintyWatch
from procc_annotator.image.cache import FrameCache
from procc_annotator.image.decode import PixelArray
from procc_annotator.session.edits import PointRef
from procc_annotator.session.field_dimensions import KeptDimensions, kept_dimensions
from procc_annotator.session.origins import OriginKind, PointKey, default_author
from procc_annotator.session.workspace import Workspace
from procc_annotator.session.workspace_database.database import WorkspaceDatabase

Mode = Literal["draw", "edit"]
Option = Literal["snapping", "pinned", "auto_advance", "two_clicks"]

_CACHE_BYTES = 48 * 2**20
_EMPTY_COMMIT = (
    "blind: nothing is annotated here; Ctrl+Enter again shows the cameras, and what is clicked"
    " after that is no blind work"
)


class Document(JudgedFrame):
    """Shared by canvas and panels, which display it and call its methods; it knows no widget."""

    datasetChanged = Signal()
    frameChanged = Signal()
    annotationChanged = Signal()
    framesEdited = Signal(list)
    previewChanged = Signal()
    selectionChanged = Signal()
    hoverChanged = Signal()
    saveStateChanged = Signal()
    modeChanged = Signal()
    blindChanged = Signal(bool)
    aboutToLeave = Signal()
    flyTo = Signal(float, float)
    flyToArea = Signal(float, float, float, float)

    def __init__(self, field: Field | None = None, cache: FrameCache | None = None) -> None:
        super().__init__(field if field is not None else load_field("soccer"))
        self.cache = cache if cache is not None else FrameCache(_CACHE_BYTES)
        self.picture: PixelArray | None = None
        self.picture_error = ""
        self.selected_class: str | None = None
        self.selected_point: PointRef | None = None
        self.selected_points: frozenset[PointRef] = frozenset()
        self.hovered_class: str | None = None
        self.last_finished: str | None = None  # on this frame, before the next one was offered
        self.mode: Mode = "draw"
        self.snapping, self.pinned = True, True
        self.auto_advance, self.two_clicks = True, False
        self.author = default_author()
        self._opened: tuple[Path, Path | None] | None = None
        self._empty_asked: str | None = None  # frame whose commit with nothing in it was asked for
        self.saver = Saver(self)
        self.saver.changed.connect(self.saveStateChanged)
        self.saver.failed.connect(lambda text: self.message.emit(text, "error"))
        self.saver.reloaded.connect(self._after_reload)
        self.review.failed.connect(lambda text: self.message.emit(text, "warning"))
        self.frameChanged.connect(self.disagreement.look)
        self.presence = Presence(self)
        self.presence.changed.connect(self.modeChanged)
        self.presence.freed.connect(self._take_newer_file)
        self.second = SecondAnnotator(self.field, self)
        self.second.message.connect(self.message)
        self.blind_lock = BlindLock(self)
        self.live_fit = LiveFit(self)
        self.uncertainty = UncertaintyWatch(self)
        self.fit_source = FitSource(self)
        self.ghosts = Ghosts(self)
        self.label_check = LabelCheck(self)

    # --- what is on screen -----------------------------------------------------------------

    @property
    def picture_size(self) -> tuple[int, int] | None:
        """(width, height) of the picture on screen in px; None when there is none."""
        if self.picture is None:
            return None
        return self.picture.shape[1], self.picture.shape[0]

    @property
    def frame_error(self) -> str:
        """Why this frame cannot be edited; empty when it can."""
        holder = self.presence.holder
        if self._damage or holder is None:
            return self._damage
        who = " on ".join(part for part in (holder.author, holder.host) if part) or "somebody"
        return f"{who} is editing it; it opens by itself once they leave it"

    @property
    def _damage(self) -> str:
        """Why nobody can edit this frame."""
        state = self.state
        if state is not None and state.error is not None:
            return str(state.error)
        return self.picture_error

    @property
    def editable(self) -> bool:
        """Whether there is a frame that can be edited."""
        return self.frame is not None and not self.frame_error

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
        other_field = self._take_field(kept := kept_dimensions(database, self.field))
        self._load_frame()
        if other_field:
            self.fieldChanged.emit()
        self.datasetChanged.emit()
        self.frameChanged.emit()
        self._score_set()
        if not self.field.is_nominal:
            self.message.emit(f"the field of this dataset: {self.field.described}", "info")
        notices = (*filter(None, (kept.problem,)), *database.notices, *workspace.notices)
        if notices:
            self.message.emit("; ".join(notices[:3]), "warning")

    def _take_field(self, kept: KeptDimensions) -> bool:
        """Use the dimensions that the dataset keeps; whether they are other than before."""
        if self.field.is_nominal and not kept.values:
            return False
        field = resized(self.field, kept.values)
        if field == self.field:
            return False
        self._use_field(field)
        return True

    def reopen(self) -> Workspace:
        """The dataset as it is on disk, for a thread of its own.

        Raises:
            ProccError: it cannot be opened any more, or nothing is open.
        """
        workspace = self.workspace
        if workspace is None:
            raise UsageError("nothing is open")
        if self._opened is None:  # frames of a video
            return Workspace(workspace.root, workspace.frames, self.field, ())
        path, annotations = self._opened
        return Workspace.open(path, self.field, annotations)

    def close(self) -> None:
        """Stop everything that runs in the background."""
        self.set_scores.close()
        self.source_frames.close()
        self.live_fit.close()
        self.label_check.close()
        self.ghosts.close()
        self.uncertainty.close()
        self.disagreement.close()
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
        self._load_frame()
        self.frameChanged.emit()

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

    # --- selection -----------------------------------------------------------------------------

    def select_class(self, class_name: str | None) -> None:
        """Choose the element to draw and to look at."""
        self.last_finished = None  # whoever chooses means what was chosen
        if class_name != self.selected_class:
            self.selected_class = class_name
            if self.selected_point is not None and self.selected_point[0] != class_name:
                self._choose_points(None)
            self.selectionChanged.emit()

    def select_point(
        self,
        class_name: str | None,
        index: int = 0,
        together: Collection[PointRef] = (),
    ) -> None:
        """Choose one point of an element, or several ``together``; None lets go of all points."""
        if class_name is not None:
            self.last_finished = None
        point = None if class_name is None else (class_name, index)
        chosen = frozenset(together) if point is not None and len(together) > 1 else frozenset()
        same = (point, chosen) == (self.selected_point, self.selected_points)
        if same and class_name in (None, self.selected_class):
            return
        self._choose_points(point, chosen)
        if class_name is not None:
            self.selected_class = class_name
        self.selectionChanged.emit()

    def select_all_points(self) -> None:
        """Choose every point of the selected element, or of the frame when none is selected."""
        every = (*self.annotation.polylines, *self.annotation.unconfirmed)
        chosen = [p for p in every if p.class_name == self.selected_class] or every
        points = [(p.class_name, i) for p in chosen for i in range(len(p.points))]
        if points:
            self.select_point(*points[0], together=points)

    def _choose_points(
        self, point: PointRef | None, together: frozenset[PointRef] = frozenset()
    ) -> None:
        self.selected_point, self.selected_points = point, together

    def hover_class(self, class_name: str | None) -> None:
        """Tell every widget which element the cursor is on."""
        if class_name != self.hovered_class:
            self.hovered_class = class_name
            self.hoverChanged.emit()

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

    # --- edits -----------------------------------------------------------------------------------

    def begin_edit(self) -> bool:
        """Take the frame for editing before the first gesture; False (and said so) if it is not to
        be had. Until then nothing has been clicked that could be lost."""
        if not self.editable:
            self.message.emit(self.frame_error or "open a folder of pictures first", "warning")
            return False
        if self.presence.owned:
            return True
        if not self.presence.acquire():
            self.message.emit(self.frame_error, "warning")
            return False
        self._take_newer_file()
        return self.editable

    def set_preview(self, annotation: FrameAnnotation | None) -> None:
        """Show (and score) an annotation during a gesture, without touching history or disk."""
        if annotation is self._preview:
            return
        self._preview = annotation
        self.judge.judge(self.shown_annotation)
        self.previewChanged.emit()

    def commit_edit(
        self,
        label: str,
        annotation: FrameAnnotation,
        kind: OriginKind = OriginKind.CLICKED,
        snapped: frozenset[PointKey] = frozenset(),
    ) -> bool:
        """Make an edit a step of the history and save it at once; ``kind`` and ``snapped`` say how
        its new points came to be."""
        if self.workspace is None or self.frame is None or self._damage:
            self.message.emit(self._damage or "open a folder of pictures first", "warning")
            return False
        self._preview = None
        before = self.annotation
        if annotation == before:
            self._after_edit(save=False)
            return False
        if not self.presence.acquire():
            # The lock was lost in the middle of a gesture (the machine slept). What was clicked
            # is kept all the same; the save notices when the other one wrote the file.
            self.message.emit(self.frame_error, "warning")
        self.workspace.edit(self.frame_index, label, annotation)
        frame = self.frame.name
        self.review.note_edit(frame, before, annotation, kind, snapped)
        said = self.review.touched(frame, before, annotation)
        self._after_edit()
        if said:
            self.message.emit(said, "info")
        return True

    def edit(
        self,
        label: str,
        change: Callable[[FrameAnnotation], FrameAnnotation],
        kind: OriginKind = OriginKind.CLICKED,
    ) -> bool:
        """Take the frame, then change what it holds by then: another window may have saved it since
        it was read here.

        Args:
            label: of the step in the history.
            change: given the newest annotation; raises `UsageError` (which is told) where the edit
                makes no sense any more.
            kind: how new points came to be.
        """
        if not self.begin_edit():
            return False
        try:
            changed = change(self.annotation)
        except UsageError as error:
            self.message.emit(str(error), "info")
            return False
        return self.commit_edit(label, changed, kind)

    def undo(self) -> None:
        """Go back one step of this frame."""
        self._travel("undo", "undone")

    def redo(self) -> None:
        """Go forward one step of this frame."""
        self._travel("redo", "redone")

    def save_now(self) -> bool:
        """Finish what is under way and write what is not on disk; True when all is saved."""
        self.aboutToLeave.emit()
        return self.saver.save_all()

    def reload_frame(self) -> None:
        """Decide a conflict in favour of the file."""
        self.saver.reload(self.frame_index)

    def overwrite_frame(self) -> None:
        """Decide a conflict in favour of the screen."""
        self.saver.overwrite(self.frame_index)

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

    def _load_frame(self) -> None:
        self._preview = self._empty_asked = None
        self.picture, self.picture_error = None, ""
        frame = self.frame
        name = frame.name if frame is not None else None
        if self.workspace is not None and frame is not None:
            self.workspace.look_again(self.frame_index)
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

    def _prefetch_neighbours(self) -> None:
        frames = self.workspace.frames if self.workspace is not None else ()
        around = (self.frame_index + step for step in (0, 1, -1, 2))
        here, *soon = [frames[i] for i in around if 0 <= i < len(frames)]
        self.cache.prefetch([frame.image_path for frame in soon])
        self.review.foresee(frame.name for frame in (here, *soon))

    def _after_edit(self, *, save: bool = True) -> None:
        if self.selected_point is not None:
            name, index = self.selected_point
            polyline = self.annotation.get(name) or self.annotation.get_unconfirmed(name)
            if polyline is None or index >= len(polyline.points):
                self._choose_points(None)
        self.judge.judge(self.annotation)
        if save:
            self.saver.save(self.frame_index)
        self.annotationChanged.emit()
        self.scoreChanged.emit()
        self._audit_frame_again()

    def _travel(self, direction: Literal["undo", "redo"], done: str) -> None:
        if self.workspace is None or self.frame is None or not self.begin_edit():
            return
        before = self.annotation
        label = getattr(self.workspace, direction)(self.frame_index)
        if label is None:
            self.message.emit(f"nothing to {direction} on this frame", "info")
            return
        self._preview = None
        self._drop_stale_points(before)
        said = self.review.touched(self.frame.name, before, self.annotation)
        self._after_edit()
        self.message.emit("; ".join(filter(None, (f"{done}: {label}", said))), "info")

    def _drop_stale_points(self, before: FrameAnnotation) -> None:
        """Chosen points of an element that has more or fewer points now are others than those that
        were chosen."""
        chosen = self.selected_points | ({self.selected_point} if self.selected_point else set())
        for name in {ref[0] for ref in chosen}:
            if _point_count(before, name) != _point_count(self.annotation, name):
                self._choose_points(None)
                self.selectionChanged.emit()
                return

    def _take_newer_file(self) -> None:
        """Another window may have saved this frame since it was read here."""
        if self.workspace is None or self.frame is None:
            return
        try:
            changed = self.workspace.refresh(self.frame_index)
        except InputError as error:
            self.message.emit(str(error), "warning")
            return
        if changed:
            self._after_reload(self.frame_index)
            self.message.emit(f"{self.frame.name} was changed elsewhere: read again", "info")

    def _after_reload(self, index: int) -> None:
        if index == self.frame_index:
            self._preview = None
            self._after_edit(save=False)


def _point_count(annotation: FrameAnnotation, class_name: str) -> int:
    polyline = annotation.get(class_name) or annotation.get_unconfirmed(class_name)
    return len(polyline.points) if polyline is not None else 0
