"""The part of the document that is there without any camera: frame, annotation, blind mode."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.gui.state.notices import Level
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.session.dataset.workspace import Frame, FrameState, Workspace

_EMPTY = FrameAnnotation()


class FrameOnScreen(QObject):
    """A frame of a dataset and what is annotated in it."""

    message = Signal(str, str)

    def __init__(self, field: Field) -> None:
        super().__init__()
        self.field = field
        self.workspace: Workspace | None = None
        self.frame_index = -1
        self.blind = False
        self._preview: FrameAnnotation | None = None
        self.review = ReviewState(self)

    def say(self, text: str, level: Level = "info") -> None:
        """Tell the user one line."""
        self.message.emit(text, level)

    @property
    def frame(self) -> Frame | None:
        """The frame on screen."""
        if self.workspace is None or self.frame_index < 0:
            return None
        return self.workspace.frames[self.frame_index]

    @property
    def state(self) -> FrameState | None:
        """History, errors and save state of the frame on screen."""
        if self.workspace is None or self.frame_index < 0:
            return None
        return self.workspace.state(self.frame_index)

    @property
    def annotation(self) -> FrameAnnotation:
        """The finished annotation of the frame on screen."""
        state = self.state
        return state.history.current if state is not None else _EMPTY

    @property
    def shown_annotation(self) -> FrameAnnotation:
        """The annotation including a gesture under way."""
        return self._preview if self._preview is not None else self.annotation

    @property
    def why_not_judged(self) -> str:
        """Why the frame on screen belongs to no figure of the set, whatever its cameras are; empty
        when it does, and while its first element is drawn."""
        state = self.state
        if state is None:
            return ""
        if state.error is not None:
            return "annotation cannot be read"
        return "" if state.counts or self.shown_annotation.annotated else "nothing annotated yet"

    @property
    def projection_visible(self) -> bool:
        """False while blind and the frame is not committed: nothing of the camera may be shown."""
        frame = self.frame
        return not self.blind or (frame is not None and self._committed(frame.name))

    @property
    def revealed_frames(self) -> frozenset[str] | None:
        """The frames of which something of a camera may be shown; None: all. In blind mode those
        that are committed."""
        return self.review.committed_frames() if self.blind else None

    def _committed(self, name: str) -> bool:
        return self.review.record(name).committed
