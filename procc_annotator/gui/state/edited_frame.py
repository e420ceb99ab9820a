"""The part of the document that edits and saves the frame on screen."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from PySide6.QtCore import Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.gui.state.presence import Presence
from procc_annotator.gui.state.saving import Saver
from procc_annotator.gui.state.selected_elements import SelectedElements
from procc_annotator.image.decode import PixelArray
from procc_annotator.session.dataset.workspace import SAVED_ELSEWHERE
from procc_annotator.session.facts.origins import OriginKind, PointKey


class EditedFrame(SelectedElements):
    """A frame whose annotation is edited step by step, each saved at once, by one window at a time.

    Attributes:
        picture: (H, W, 4) BGRA; None where it cannot be read, and ``picture_error`` says why.
        saver: writes what was edited.
        presence: the lock of the frame.
    """

    annotationChanged = Signal()
    previewChanged = Signal()
    saveStateChanged = Signal()
    aboutToLeave = Signal()

    def __init__(self, field: Field) -> None:
        super().__init__(field)
        self.picture: PixelArray | None = None
        self.picture_error = ""
        self.saver = Saver(self)
        self.saver.changed.connect(self.saveStateChanged)
        self.saver.failed.connect(lambda text: self.message.emit(text, "error"))
        self.saver.reloaded.connect(self._after_reload)
        self.presence = Presence(self)
        self.presence.freed.connect(self._take_newer_file)
        self._warned_of: FrameAnnotation | None = None

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

    # --- edits ---------------------------------------------------------------------------

    def begin_edit(self) -> bool:
        """Take the frame for editing before the first gesture; False (and said so) if it is not to
        be had. Until then nothing has been clicked that could be lost."""
        if not self.editable:
            self.message.emit(self.frame_error or "open a folder of pictures first", "warning")
            return False
        if self.presence.still_owned():
            return True
        if not self.presence.acquire():
            self.message.emit(self.frame_error, "warning")
            return False
        self._take_newer_file()  # whoever edits looks at `annotation` again from here on
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
        # The lock may have been lost in the middle of a gesture (the machine slept). What was
        # clicked is kept all the same, and the file is not read again now: what was made from the
        # older one would pass for made from the newer one. The save notices that they differ.
        if not self.presence.acquire():
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

    def set_field(self, field: Field, *, keep: bool = True) -> None:
        chosen = self.selected_class
        # What is under way belongs to the field of before, unless that is only written anew.
        if keep or not (chosen is None or field.knows(chosen)):
            self.aboutToLeave.emit()
        super().set_field(field, keep=keep)
        chosen = self.selected_class
        here = self.annotation.renamed(str.strip)
        if chosen is not None and not (field.knows(chosen) or here.get(chosen.strip())):
            self.select_class(None)
        self.hover_class(None)

    def save_now(self) -> bool:
        """Finish what is under way and write what is not on disk; True when all is saved."""
        self.aboutToLeave.emit()
        return self.saver.save_all()

    def reload_frame(self) -> None:
        """Decide a conflict in favour of the file."""
        before = self.annotation
        self.saver.reload(self.frame_index)
        self._drop_stale_points(before)

    def overwrite_frame(self) -> None:
        """Decide a conflict in favour of the screen."""
        self.saver.overwrite(self.frame_index)

    # --- inside ---

    def _after_edit(self, *, save: bool = True) -> None:
        self._warned_of = None
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
        if self.workspace is None or self.frame is None:
            return
        before = self.annotation
        if not self.begin_edit():
            return
        if self.annotation is not before:
            self._say_saved_elsewhere(f"nothing is {done}")
            return
        if direction == "undo" and self._would_take_away():
            return
        label = getattr(self.workspace, direction)(self.frame_index)
        if label is None:
            self.message.emit(f"nothing to {direction} on this frame", "info")
            return
        self._preview = None
        self._drop_stale_points(before)
        said = self.review.touched(self.frame.name, before, self.annotation)
        self._after_edit()
        self.message.emit("; ".join(filter(None, (f"{done}: {label}", said))), "info")

    def _would_take_away(self) -> bool:
        """Whether undo would take away what somebody else saved, and was not told so before: it
        is their work, and who presses the key means a step of their own."""
        state = self.state
        if state is None or state.history.undo_label != SAVED_ELSEWHERE:
            return False
        if self._warned_of is state.history.current:
            return False
        self._warned_of = state.history.current
        self._say_saved_elsewhere("undo once more takes that away")
        return True

    def _say_saved_elsewhere(self, so: str) -> None:
        if self.frame is not None:
            text = f"{self.frame.name} was changed elsewhere and read again: {so}"
            self.message.emit(text, "info")

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
        before = self.annotation
        try:
            changed = self.workspace.refresh(self.frame_index)
        except InputError as error:
            self.message.emit(str(error), "warning")
            return
        if changed:
            self._drop_stale_points(before)
            self._preview = None
            self._after_edit()  # nothing is to be saved: a conflict that waited is decided
            self.message.emit(f"{self.frame.name} was changed elsewhere: read again", "info")

    def _after_reload(self, index: int) -> None:
        if index == self.frame_index:
            self._preview = None
            self._after_edit(save=False)


def _point_count(annotation: FrameAnnotation, class_name: str) -> int:
    polyline = annotation.get(class_name) or annotation.get_unconfirmed(class_name)
    return len(polyline.points) if polyline is not None else 0
