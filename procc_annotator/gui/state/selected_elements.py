"""The part of the document that says which element and which points are chosen."""

from __future__ import annotations

from collections.abc import Collection

from PySide6.QtCore import Signal

from procc_annotator.field.model import Field
from procc_annotator.gui.state.frame_with_sources import FrameWithSources
from procc_annotator.session.dataset.edits import PointRef


class SelectedElements(FrameWithSources):
    """A frame with an element to draw and to look at, some of its points, and what is hovered."""

    selectionChanged = Signal()
    hoverChanged = Signal()

    def __init__(self, field: Field) -> None:
        super().__init__(field)
        self.selected_class: str | None = None
        self.selected_point: PointRef | None = None
        self.selected_points: frozenset[PointRef] = frozenset()
        self.hovered_class: str | None = None
        self.last_finished: str | None = None  # on this frame, before the next one was offered

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
