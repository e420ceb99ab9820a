"""Going from frame to frame by status, and giving them one; by score: `worst_first`."""

from __future__ import annotations

from collections.abc import Callable

from procc_annotator.dataset.records import Status
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.review_state import UNFINISHED
from procc_annotator.translation import tr


class Tour:
    """Slots of the menu Frame that look at more than one frame."""

    def __init__(self, document: Document) -> None:
        self._document = document

    def go_last(self) -> None:
        """The last frame."""
        if (workspace := self._document.state.workspace) is not None:
            self._document.walk.go_to(len(workspace.frames) - 1)

    def go_unfinished(self, step: int) -> None:
        """The nearest frame after (1) or before (-1) this one that is neither done nor approved."""
        self._go(
            step,
            lambda name: self._document.review.status(name) in UNFINISHED,
            tr("every frame after this one is done or approved")
            if step > 0
            else tr("every frame before this one is done or approved"),
        )

    def go_rejected(self) -> None:
        """The next rejected frame; after the last one it begins again."""
        self._go(
            1,
            lambda name: self._document.review.status(name) is Status.REJECTED,
            tr("no other frame is rejected"),
            around=True,
        )

    def set_status(self, status: str) -> None:
        """Give the frame on screen a status."""
        document = self._document
        if (frame := document.state.frame) is None:
            return
        document.store.events.aboutToLeave.emit()
        document.review.set_status(frame.name, Status(status))
        document.say(tr("{frame} is {status}", frame=frame.name, status=tr(status, "a frame")))

    def _go(
        self, step: int, wanted: Callable[[str], bool], none_left: str, *, around: bool = False
    ) -> None:
        document = self._document
        if document.state.workspace is None:
            return
        frames = document.state.workspace.frames
        here, count = document.state.frame_index, len(frames)
        ahead = range(here + step, count if step > 0 else -1, step)
        order = [*ahead, *(range(here) if around else ())]
        for index in order:
            if wanted(frames[index].name):
                document.walk.go_to(index)
                return
        document.say(none_left)
