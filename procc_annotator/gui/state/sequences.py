"""Consecutive frames of the open dataset, and which frames are annotated."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial

from PySide6.QtCore import QObject, Signal

from procc_annotator.dataset.sequence import FrameSequence, sequence_of
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import ComputedValue, Inputs, Priority
from procc_annotator.gui.state.store import Store


class AnnotatedIndices(QObject):
    """Their indices, once a person wants them. A frame that cannot be read counts as annotated:
    no one may write over it."""

    changed = Signal()

    def __init__(self, store: Store) -> None:
        super().__init__(store)
        self._store = store
        self._edited: dict[int, bool] = {}  # since they were read
        self._read = ComputedValue(
            partial(_open_dataset, store),
            _read_all,
            self,
            enabled=False,
            stoppable=True,
            priority=Priority.LOW,
        )
        self._read.changed.connect(self.changed)
        store.watch(select.dataset, self._begin_anew)
        store.watch(select.annotation, self._note_here)
        store.events.framesEdited.connect(self._note)

    def set_wanted(self, wanted: bool) -> None:
        """Compute them from now on, or stop."""
        self._read.set_enabled(wanted)

    @property
    def indices(self) -> frozenset[int]:
        """The indices known so far."""
        found = set(self._read.value or ())
        found -= {index for index, annotated in self._edited.items() if not annotated}
        return frozenset(found.union(i for i, annotated in self._edited.items() if annotated))

    # --- inside ---

    def _begin_anew(self) -> None:
        self._edited.clear()
        self._read.invalidate()

    def _note_here(self) -> None:
        state = self._store.state
        if state.frame is not None:
            self._take({state.frame_index: bool(state.annotation.annotated or state.damage)})

    def _note(self, indices: Iterable[int]) -> None:
        workspace = self._store.state.workspace
        if workspace is not None:
            self._take({index: is_annotated(workspace, index) for index in indices})

    def _take(self, edited: dict[int, bool]) -> None:
        if edited.items() <= self._edited.items():  # as after most clicks
            return
        before = self.indices
        self._edited |= edited
        if any((index in before) != annotated for index, annotated in edited.items()):
            self.changed.emit()


def is_annotated(workspace: Workspace, index: int) -> bool:
    """Return whether a frame has an annotation, even one that cannot be read."""
    try:
        return workspace.annotated_count(index) > 0
    except InputError:
        return True


def _read_all(workspace: Workspace, *, go_on: Callable[[], None]) -> frozenset[int]:
    found = set()
    for index in range(len(workspace.frames)):
        go_on()
        if is_annotated(workspace, index):
            found.add(index)
    return frozenset(found)


def open_sequence(store: Store) -> ComputedValue[FrameSequence]:
    """Make the video, or the consecutive pictures, of the dataset's frames; None for others."""
    sequence = ComputedValue(
        partial(_open_dataset, store),
        lambda workspace, go_on: sequence_of(workspace.frames, go_on),
        store,
        stoppable=True,
    )
    store.keep_current(sequence)
    return sequence


def _open_dataset(store: Store) -> Inputs | None:
    workspace = store.state.workspace
    return None if workspace is None else (workspace,)
