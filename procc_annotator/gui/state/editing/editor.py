"""Edits of the frame on screen, step by step, each saved at once, by one window at a time."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.dataset.records import OriginKind, PointKey
from procc_annotator.dataset.workspace import SAVED_ELSEWHERE, Workspace
from procc_annotator.errors import InputError, UsageError
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import no_frame
from procc_annotator.gui.state.editing.saving import FrameLock, Saver
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.scoring.dataset_scores import DatasetScoring
from procc_annotator.gui.state.selection import that_survives
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr, word


class Editing(QObject):
    """Takes the frame, changes what it holds, and saves it.

    What an edit changes is shown first: the state is set, then the file is written behind the
    interface's thread, and what follows from the clicks is worked out after the paint.
    """

    def __init__(
        self,
        store: Store,
        saver: Saver,
        frame_lock: FrameLock,
        review: ReviewState,
        scoring: DatasetScoring,
    ) -> None:
        super().__init__(store)
        self._store = store
        self.saver, self.frame_lock, self.review = saver, frame_lock, review
        self._scoring = scoring
        self._warned_of: FrameAnnotation | None = None  # that undo would take others' work away
        self._look_later = False  # at the file of the frame, once nothing is written any more
        self._empty_asked = False  # whether to be done with this frame while nothing is in it
        store.watch(select.frame, self._begin_frame)
        saver.saved.connect(self._follow_save)
        saver.settled.connect(self._look_if_asked)
        saver.reloaded.connect(self._after_reload)
        frame_lock.freed.connect(self.take_newer_file)

    # --- edits --------------------------------------------------------------------------------

    def begin_edit(self) -> bool:
        """Take the frame for editing before the first gesture; False (and said so) if it is not to
        be had. Until then nothing has been clicked that could be lost."""
        state = self._store.state
        if not state.editable:
            say(self._store, state.why_not_editable or no_frame(state), "warning")
            return False
        if self.frame_lock.still_owned():
            return True
        if not self.frame_lock.acquire():
            self._say_held()
            return False
        self.take_newer_file()  # whoever edits looks at `annotation` again from here on
        return self._store.state.editable

    def set_preview(self, annotation: FrameAnnotation | None) -> None:
        """Show (and score) an annotation during a gesture, without touching history or disk."""
        self._store.update(preview=annotation)

    def commit_edit(
        self,
        label: str,
        annotation: FrameAnnotation,
        kind: OriginKind = OriginKind.CLICKED,
        snapped: frozenset[PointKey] = frozenset(),
        unseen: frozenset[PointKey] = frozenset(),
    ) -> bool:
        """Make an edit a step of the history and save it at once; ``kind`` and ``snapped`` say how
        its new points came to be, ``unseen`` which points show no paint."""
        state = self._store.state
        workspace, frame, before = state.workspace, state.frame, state.annotation
        if workspace is None or frame is None or state.why_broken:
            say(self._store, state.why_broken or no_frame(state), "warning")
            return False
        if annotation == before:
            self._warned_of = None
            self._store.update(preview=None)
            return False
        # The lock may have been lost in the middle of a gesture (the machine slept). What was
        # clicked is kept all the same, and the file is not read again now: what was made from the
        # older one would pass for made from the newer one. The save notices that they differ.
        if not self.frame_lock.acquire():
            self._say_held()
        workspace.edit(state.frame_index, label, annotation)
        self.review.note_edit(frame.name, before, annotation, kind, snapped, unseen)
        said = self.review.touched(frame.name, before, annotation)
        with self._store.transaction():
            self._show_edited(workspace)
            if said:
                say(self._store, said)
        return True

    def keep_clicks(self, drawn: Polyline | None, snapped: frozenset[PointKey]) -> None:
        """Keep what is being drawn next to the file, where it outlives the program; None: nothing
        is."""
        state = self._store.state
        if state.workspace is None or state.frame is None or state.why_broken:
            return
        if state.workspace.keep_clicks(state.frame_index, drawn) and drawn is not None:
            seen, name = state.annotation, state.frame.name
            clicked = seen.with_polyline(drawn)
            self.review.note_edit(name, seen, clicked, OriginKind.CLICKED, snapped)

    def note_unseen(self, unseen: frozenset[PointKey]) -> None:
        """Remember at which of this frame's points paint was looked for and not found."""
        state = self._store.state
        if state.frame is not None and unseen:
            seen = state.annotation
            self.review.note_edit(
                state.frame.name, seen, seen, OriginKind.UNCONFIRMED, unseen=unseen
            )

    def edit(
        self,
        label: str,
        change: Callable[[FrameAnnotation], FrameAnnotation],
        kind: OriginKind = OriginKind.CLICKED,
    ) -> bool:
        """Take the frame, then change what it holds by then: another window may have saved it since
        it was read here. A `UsageError` of ``change`` is reported: the edit makes no sense any
        more."""
        if not self.begin_edit():
            return False
        try:
            changed = change(self._store.state.annotation)
        except UsageError as error:
            say(self._store, str(error))
            return False
        return self.commit_edit(label, changed, kind)

    def undo(self) -> None:
        """Go back one step of this frame."""
        self._travel(back=True)

    def redo(self) -> None:
        """Go forward one step of this frame."""
        self._travel(back=False)

    @property
    def steps(self) -> tuple[str | None, str | None]:
        """Return what undo would take back of this frame and what redo would do again; None:
        nothing."""
        state = self._store.state
        if state.workspace is None or state.frame is None:
            return None, None
        history = state.workspace.state(state.frame_index).history
        return history.undo_label, history.redo_label

    # --- saving -------------------------------------------------------------------------------

    def save_now(self) -> bool:
        """Finish what is under way and write what is not on disk; True when all is saved."""
        self._store.events.aboutToLeave.emit()
        return self.saver.save_all()

    def reload_frame(self) -> None:
        """Decide a conflict in favour of the file."""
        self.saver.reload(self._store.state.frame_index)

    def overwrite_frame(self) -> None:
        """Decide a conflict in favour of the screen."""
        self.saver.overwrite(self._store.state.frame_index)

    # --- what others write --------------------------------------------------------------------

    def take_newer_file(self) -> None:
        """Another window may have saved this frame since it was read here."""
        self.saver.settle(self._store.state.frame_index)
        state = self._store.state
        if state.workspace is None or state.frame is None:
            return
        try:
            changed = state.workspace.refresh(state.frame_index)
        except InputError as error:
            say(self._store, str(error), "warning")
            return
        if changed:
            # Nothing is to be saved then: a conflict that waited is decided.
            self._show_edited(state.workspace, stepped=True)
            self._say_read_again()

    def look_at_frame(self) -> None:
        """Follow the file of the frame on screen if others wrote it. A gesture under way goes on,
        and what is not saved yet stays: saving then says that both differ."""
        state = self._store.state
        workspace, index = state.workspace, state.frame_index
        if workspace is None or state.frame is None or state.preview is not None:
            return
        if self.saver.under_way:
            self._look_later = True
            return
        changed = workspace.look_again(index)
        if not changed or index in workspace.dirty_frames():
            return
        now = held(workspace, index)
        if (now["annotation"], now["damage"]) == (state.annotation, state.damage):
            self._show(workspace)  # an empty file came or went: that is another score
            self._scoring.frame_edited()
            return
        # Nothing is to be saved then: a conflict that waited is decided.
        self._show_edited(workspace, stepped=True)
        self._store.events.framesEdited.emit([index])
        self._say_read_again()

    # --- done with a frame --------------------------------------------------------------------

    def commit_frame(self) -> None:
        """The annotator is done with this frame: the projection may be shown. In blind mode an
        empty one must be committed twice: that shows its cameras before anything is clicked."""
        if (frame := self._store.state.frame) is None:
            return
        if self._store.state.damage:  # nobody saw what is in it
            say(self._store, self._store.state.why_broken, "warning")
            return
        self._store.events.aboutToLeave.emit()
        seen = self._store.state.annotation
        if not self.frame_lock.owned:
            self.take_newer_file()
        state = self._store.state
        if state.annotation is not seen:
            return  # nobody is done with what they have not seen: that it was read again is said
        blind = not state.projection_visible
        if blind and not seen.annotated and not self._empty_asked:
            self._empty_asked = True
            say(self._store, tr(_EMPTY_COMMIT))
            return
        waiting = len(seen.unconfirmed)
        self.review.commit(frame.name, seen, blind=blind)
        self._store.update(committed=state.committed | {frame.name})
        said = [tr("{frame} is done", frame=frame.name)]
        if waiting:
            said.append(tr("unconfirmed elements do not count: {count}", count=waiting))
        say(self._store, "; ".join(said))

    # --- inside -------------------------------------------------------------------------------

    def _begin_frame(self) -> None:
        self._warned_of, self._empty_asked = None, False

    def _show(self, workspace: Workspace, *, stepped: bool = False) -> None:
        state = self._store.state
        now = workspace.state(state.frame_index).history.current
        chosen = that_survives(state.selection, state.annotation, now, stepped=stepped)
        self._store.update(**held(workspace, state.frame_index), preview=None, selection=chosen)
        if now is not state.annotation:
            self._store.events.annotationEdited.emit()

    def _show_edited(self, workspace: Workspace, *, stepped: bool = False) -> None:
        """Show what the frame holds after an edit, and save it if need be."""
        self._warned_of = None
        index = self._store.state.frame_index
        self._show(workspace, stepped=stepped)
        self.saver.save_soon(index)
        self._scoring.frame_edited()

    def _travel(self, *, back: bool) -> None:
        state = self._store.state
        workspace, frame, before = state.workspace, state.frame, state.annotation
        if workspace is None or frame is None or not self.begin_edit():
            return
        if self._store.state.annotation is not before:
            self._say_saved_elsewhere(tr("nothing is undone") if back else tr("nothing is redone"))
            return
        if back and self._would_take_away(workspace):
            return
        step = workspace.undo if back else workspace.redo
        label = step(state.frame_index)
        if label is None:
            nothing = tr("nothing to undo on this frame")
            say(self._store, nothing if back else tr("nothing to redo on this frame"))
            return
        now = workspace.state(state.frame_index).history.current
        said = self.review.touched(frame.name, before, now)
        with self._store.transaction():
            self._show_edited(workspace, stepped=True)
            what = tr(label)
            done = tr("undone: {step}", step=what) if back else tr("redone: {step}", step=what)
            say(self._store, "; ".join(filter(None, (done, said))))

    def _would_take_away(self, workspace: Workspace) -> bool:
        """Return whether undo would take away what another person saved, and was not reported so
        before: it is their work, and who presses the key means a step of their own."""
        history = workspace.state(self._store.state.frame_index).history
        if history.undo_label != SAVED_ELSEWHERE or self._warned_of is history.current:
            return False
        self._warned_of = history.current
        self._say_saved_elsewhere(tr("undo once more takes that away"))
        return True

    def _follow_save(self) -> None:
        """A frame with a file belongs to the figures of the set, also when nothing is in it."""
        state = self._store.state
        if state.workspace is None or state.frame is None:
            return
        counts = state.workspace.state(state.frame_index).counts
        if counts != state.counts:
            self._store.update(counts=counts)
            self._scoring.frame_edited()

    def _look_if_asked(self) -> None:
        asked, self._look_later = self._look_later, False
        if asked:
            self.look_at_frame()

    def _after_reload(self, index: int) -> None:
        state = self._store.state
        if index == state.frame_index and state.workspace is not None:
            self._warned_of = None
            self._show(state.workspace, stepped=True)
            self._scoring.frame_edited()

    def _say_held(self) -> None:
        say(self._store, self._store.state.why_not_editable, "warning")

    def _say_read_again(self) -> None:
        state = self._store.state
        if state.frame_name is not None and not state.damage:  # the frame itself says what it is
            say(
                self._store, tr("{frame} was changed elsewhere: read again", frame=state.frame_name)
            )

    def _say_saved_elsewhere(self, so: str) -> None:
        if (name := self._store.state.frame_name) is not None:
            text = tr("{frame} was changed elsewhere and read again: {so}", frame=name, so=so)
            say(self._store, text)


def held(workspace: Workspace, index: int) -> dict[str, object]:
    """Return what the state is to hold of a frame's file and history."""
    found = workspace.state(index)
    return {
        "annotation": found.history.current,
        "damage": "" if found.error is None else str(found.error),
        "counts": found.counts,
    }


_EMPTY_COMMIT = word(
    "blind: nothing is annotated here; Ctrl+Enter again shows the cameras, and what is clicked"
    " after that is no blind work"
)
