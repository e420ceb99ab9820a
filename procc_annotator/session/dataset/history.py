"""Undo and redo of one frame: a list of immutable annotations and a place in it."""

from __future__ import annotations

from collections.abc import Callable

from procc_annotator.annotation import FrameAnnotation


class History:
    """Every annotation a frame has had in this session, each with the edit that led to it.

    Snapshots share the polylines that did not change, so there is no limit to their number.
    """

    def __init__(self, initial: FrameAnnotation) -> None:
        self._steps: list[tuple[str, FrameAnnotation]] = [("", initial)]
        self._position = 0

    @property
    def current(self) -> FrameAnnotation:
        """The annotation as it is now."""
        return self._steps[self._position][1]

    @property
    def can_undo(self) -> bool:
        return self._position > 0

    @property
    def can_redo(self) -> bool:
        return self._position + 1 < len(self._steps)

    @property
    def undo_label(self) -> str | None:
        """What undo would take back."""
        return self._steps[self._position][0] if self.can_undo else None

    @property
    def redo_label(self) -> str | None:
        """What redo would do again."""
        return self._steps[self._position + 1][0] if self.can_redo else None

    def push(self, label: str, annotation: FrameAnnotation) -> bool:
        """Make an edit the newest step; steps that were undone are given up.

        Returns:
            False when the annotation did not change: then there is no step.
        """
        if annotation == self.current:
            return False
        del self._steps[self._position + 1 :]
        self._steps.append((label, annotation))
        self._position += 1
        return True

    def change_all(self, change: Callable[[FrameAnnotation], FrameAnnotation]) -> None:
        """Replace every annotation by what a function makes of it; the steps stay."""
        self._steps = [(label, change(annotation)) for label, annotation in self._steps]

    def undo(self) -> str | None:
        """Go back one step; its label, or None when there is none."""
        label = self.undo_label
        if label is not None:
            self._position -= 1
        return label

    def redo(self) -> str | None:
        """Go forward one step; its label, or None when there is none."""
        label = self.redo_label
        if label is not None:
            self._position += 1
        return label
