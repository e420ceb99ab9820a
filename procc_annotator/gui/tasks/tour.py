"""Going from frame to frame by status and score, and giving them a status."""

from __future__ import annotations

from collections.abc import Callable

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.review_state import UNFINISHED
from procc_annotator.session.origins import Status


class Tour:
    """Slots of the menu Frame that look at more than one frame."""

    def __init__(self, document: Document) -> None:
        self._document = document

    def go_unfinished(self, step: int) -> None:
        """The nearest frame after (1) or before (-1) this one that is neither done nor approved."""
        self._go(
            step,
            lambda name: self._document.review.status(name) in UNFINISHED,
            f"every frame {'after' if step > 0 else 'before'} this one is done or approved",
        )

    def go_rejected(self) -> None:
        """The next rejected frame; after the last one it begins again."""
        self._go(
            1,
            lambda name: self._document.review.status(name) is Status.REJECTED,
            "no other frame is rejected",
            around=True,
        )

    def go_worst(self) -> None:
        """From this frame's JaC on to the next better one; elsewhere to the worst of all."""
        document = self._document
        workspace, frame = document.workspace, document.frame
        scores = document.frame_scores
        if workspace is None or frame is None or not len(scores):
            document.message.emit("no JaC yet: load cameras first", "info")
            return
        ranked = sorted((jac, workspace.index[name]) for name, jac in scores.items())
        here = (scores[frame.name], document.frame_index) if frame.name in scores else None
        after = [index for jac, index in ranked if here is None or (jac, index) > here]
        if not after:
            document.message.emit("this is the best frame; the worst comes next", "info")
            after = [index for _, index in ranked]
        document.go_to(after[0])

    def set_status(self, status: str) -> None:
        """Give the frame on screen a status."""
        document = self._document
        if (frame := document.frame) is None:
            return
        document.aboutToLeave.emit()
        document.review.set_status(frame.name, Status(status))
        document.message.emit(f"{frame.name} is {status}", "info")

    def _go(
        self, step: int, wanted: Callable[[str], bool], none_left: str, *, around: bool = False
    ) -> None:
        document = self._document
        if document.workspace is None:
            return
        frames = document.workspace.frames
        here, count = document.frame_index, len(frames)
        ahead = range(here + step, count if step > 0 else -1, step)
        order = [*ahead, *(range(here) if around else ())]
        for index in order:
            if wanted(frames[index].name):
                document.go_to(index)
                return
        document.message.emit(none_left, "info")
