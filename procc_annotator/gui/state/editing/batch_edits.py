"""Edits of frames that need not be on screen: each locked, and a step of its history."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from time import perf_counter

from PySide6.QtCore import QObject

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.records import OriginKind
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.state.editing.editor import Editing
from procc_annotator.gui.state.scoring.dataset_scores import DatasetScoring
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr, word

_SLICE_S = 0.008
_TOGETHER = 32

# Edits a frame and locks it; why it left the frame as it was, not locked, or "" where it did not.
EditFrame = Callable[[int], str]
# Given what a frame holds: what it is to hold, or why it is to stay as it is.
Change = Callable[[FrameAnnotation], FrameAnnotation | str]


@dataclass
class EditedFrames:
    """The outcome of editing several frames.

    Attributes:
        total: how many were to be edited.
        edited: those that are, and are saved.
        left: (index, why) of those that were left as they were.
        unsaved: (index, why) of those that could not be saved.
        waiting: how many no one came to: it was stopped.
    """

    total: int = 0
    edited: list[int] = field(default_factory=list)
    left: list[tuple[int, str]] = field(default_factory=list)
    unsaved: list[tuple[int, str]] = field(default_factory=list)
    waiting: int = 0


class BatchEdits(QObject):
    """Goes through frames, one run at a time. Edits are made on the interface thread: a slice of
    them between what else happens there."""

    def __init__(
        self, store: Store, editing: Editing, scoring: DatasetScoring, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._store = store
        self._editing, self._scoring = editing, scoring
        self._outcome: EditedFrames | None = None
        self._edit: EditFrame = lambda _: ""
        self._stopped = False
        self._waiting: list[int] = []
        self._batch: list[int] = []  # edited and not handed over to be written yet
        self._written: list[int] = []  # being written
        self._next = after_paint(self, self._take_some)

    @property
    def running(self) -> bool:
        """Return whether frames are still to be edited or written."""
        return self._outcome is not None

    def start(
        self,
        indices: Sequence[int],
        edit: EditFrame,
        finished: Callable[[EditedFrames], None],
        progressed: Callable[[int, int], None] | None = None,
    ) -> None:
        """Edit these frames in their order; ``progressed`` receives how many of how many are
        done."""
        self._edit, self._stopped = edit, False
        self._finished, self._progressed = finished, progressed
        self._waiting, self._batch, self._written = list(indices)[::-1], [], []
        self._outcome = EditedFrames(len(indices))
        self._next.start()

    def stop(self) -> None:
        """Edit no further frame; what is edited is saved, and reported."""
        if self._outcome is not None:
            self._next.stop()
            self._stopped = True
            if not self._written:
                self._save_batch()
            self._editing.saver.settle()

    def forget(self) -> None:
        """Edit no further frame and say nothing: the dataset or the window closes."""
        self._next.stop()
        self._outcome = None

    def edit_frame(self, index: int, change: Change, label: str, kind: OriginKind) -> str:
        """Change what is annotated in a frame; undo and versions keep what was there.

        The frame is locked until it is saved.

        Args:
            change: given what the frame holds once the lock is taken.
            kind: how new points came to be.

        Returns:
            Why the frame was left as it was, not locked, for `tr`; empty when it was not.
        """
        store, editing = self._store, self._editing
        workspace = store.state.workspace
        assert workspace is not None
        name = workspace.frames[index].name
        editing.saver.settle(index)
        if index == store.state.frame_index:
            if not editing.begin_edit():
                return store.state.why_not_editable or tr("it cannot be edited")
        else:
            holder = editing.frame_lock.borrow(name)
            if holder is not None:
                return tr("{who} is editing it", who=holder.author or tr("somebody"))
        why = self._put(workspace, index, change, label, kind)
        if why:
            editing.frame_lock.give_back(name)
        return why

    def _put(
        self, workspace: Workspace, index: int, change: Change, label: str, kind: OriginKind
    ) -> str:
        editing, here = self._editing, index == self._store.state.frame_index
        if here:
            editing.look_at_frame()
        else:
            workspace.look_again(index)
            try:
                # Another window may have saved it since it was read here.
                if workspace.state(index).error is None and workspace.refresh(index):
                    editing.saver.save(index)  # no conflict is left to be decided
            except InputError as error:
                return str(error)
        held, name = workspace.state(index), workspace.frames[index].name
        if held.error is not None:
            return str(held.error)
        before = held.history.current
        after = change(before)
        if isinstance(after, str):
            return after
        if here:
            editing.commit_edit(label, after, kind)
        elif workspace.edit(index, label, after):
            editing.review.note_edit(name, before, after, kind)
            editing.review.touched(name, before, after)
        return ""

    def _take_some(self) -> None:
        end = perf_counter() + _SLICE_S
        assert self._outcome is not None
        while self._waiting and len(self._batch) < _TOGETHER and perf_counter() < end:
            index = self._waiting.pop()
            if why := self._edit(index):
                self._outcome.left.append((index, why))
            else:
                self._batch.append(index)
        if self._waiting and len(self._batch) < _TOGETHER:
            self._next.start()
        else:
            self._save_batch()

    def _save_batch(self) -> None:
        self._written, self._batch = self._batch, []
        self._editing.saver.save_together(self._written, self._batch_saved)

    def _batch_saved(self) -> None:
        workspace, outcome = self._store.state.workspace, self._outcome
        if workspace is None or outcome is None:
            return
        for index in self._written:
            problem = workspace.state(index).save_error
            self._editing.frame_lock.give_back(workspace.frames[index].name)
            if problem is None:
                outcome.edited.append(index)
            else:
                outcome.unsaved.append((index, str(problem)))
        self._written = []
        if self._progressed is not None:
            self._progressed(outcome.total - len(self._waiting), max(1, outcome.total))
        if self._waiting and not self._stopped:
            self._next.start()
        else:
            self._finish(outcome)

    def _finish(self, outcome: EditedFrames) -> None:
        self._outcome = None
        outcome.waiting = len(self._waiting)
        workspace = self._store.state.workspace
        if outcome.edited and workspace is not None:
            self._store.events.framesEdited.emit(outcome.edited)
            self._scoring.frames_edited([workspace.frames[i].name for i in outcome.edited])
        self._finished(outcome)


class LeftAlone(StrEnum):
    """Why an import has nothing to do in a frame."""

    SAME = word("it holds the same already")
    ANNOTATED = word("it is annotated already")


def why_left_alone(
    before: FrameAnnotation, incoming: FrameAnnotation, *, replacing: bool
) -> LeftAlone | None:
    """Return whether there is anything to import into a frame that holds ``before``."""
    if before.same_content(incoming):
        return LeftAlone.SAME
    return LeftAlone.ANNOTATED if before.annotated and not replacing else None


def imported(incoming: FrameAnnotation, *, replacing: bool) -> Change:
    """Return what an import makes of a frame; also of one that is annotated if ``replacing``.

    Unconfirmed elements of other classes stay, and so do further entries of the file.
    """

    def change(before: FrameAnnotation) -> FrameAnnotation | str:
        why = why_left_alone(before, incoming, replacing=replacing)
        return merged(before, incoming) if why is None else why

    return change


def merged(before: FrameAnnotation, incoming: FrameAnnotation) -> FrameAnnotation:
    """Return what a frame holds after an import: the elements that came, and what has no other
    place."""
    classes = {p.class_name for p in incoming.polylines}
    return replace(
        incoming,
        extra=tuple((dict(before.extra) | dict(incoming.extra)).items()),
        unconfirmed=tuple(p for p in before.unconfirmed if p.class_name not in classes),
    )
