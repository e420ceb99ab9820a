"""Whether the frames of the open dataset follow one another, found out next to."""

from __future__ import annotations

from collections.abc import Callable

from procc_annotator.dataset.sequence import FrameSequence, sequence_of
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.store import Store


class SequenceWatch(Derived[FrameSequence]):
    """The video or the consecutive pictures that the dataset's frames are of; None for others."""

    def __init__(self, store: Store, signals: Signals) -> None:
        super().__init__(
            self._made_of,
            _look,
            Where.BESIDE,
            store,
            stoppable=True,
            after=(signals.datasetChanged,),
        )
        self._store = store

    def _made_of(self) -> Inputs | None:
        workspace = self._store.state.workspace
        return None if workspace is None else (workspace,)


def _look(workspace: Workspace, *, go_on: Callable[[], None]) -> FrameSequence | None:
    return sequence_of(workspace.frames, go_on)
