"""Which element and which points are chosen, and what a click does: commands of the store."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.dataset.editing import PointRef
from procc_annotator.gui.state.state import ChosenElement, Mode, Option
from procc_annotator.gui.state.store import Store


class SelectionCommands:
    """Chooses elements and points."""

    def __init__(self, store: Store) -> None:
        self._store = store

    def select_class(self, class_name: str | None, *, continues: bool = False) -> None:
        """Choose the element to draw and to look at; ``continues``: clicks add to its points."""
        chosen = self._store.state.selection
        stays = chosen.point is not None and chosen.point[0] == class_name
        if class_name == chosen.class_name or stays:
            # Anyone who chooses means what was chosen, not what was finished before.
            chosen = replace(chosen, class_name=class_name, last_finished=None, continues=continues)
        else:
            chosen = ChosenElement(class_name, continues=continues)
        self._store.update(selection=chosen)

    def select_point(
        self, class_name: str | None, index: int = 0, together: Collection[PointRef] = ()
    ) -> None:
        """Choose one point of an element, or several ``together``; None lets go of all points."""
        chosen = self._store.state.selection
        if class_name is None:
            self._store.update(selection=replace(chosen, point=None, points=frozenset()))
            return
        points = frozenset(together) if len(together) > 1 else frozenset()
        self._store.update(selection=ChosenElement(class_name, (class_name, index), points))

    def select_all_points(self) -> None:
        """Choose every point of the selected element, or of the frame when none is selected."""
        annotation, name = self._store.state.annotation, self._store.state.selected_class
        every = (*annotation.polylines, *annotation.unconfirmed)
        chosen = [p for p in every if p.class_name == name] or every
        points = [(p.class_name, i) for p in chosen for i in range(len(p.points))]
        if points:
            self.select_point(*points[0], together=points)

    def note_finished(self, class_name: str | None) -> None:
        """An element was finished, and the next one is chosen by now."""
        self._store.update(selection=replace(self._store.state.selection, last_finished=class_name))

    def hover_class(self, class_name: str | None) -> None:
        """Report every widget which element the cursor is on."""
        self._store.update(hovered_class=class_name)

    def set_mode(self, mode: Mode) -> None:
        """Draw or edit; a polyline under way is finished first."""
        if mode != self._store.state.mode:
            self._store.events.aboutToLeave.emit()
            self._store.update(mode=mode)

    def set_option(self, option: Option, on: bool) -> None:
        """Switch snapping, pinning of elements, the offer of the next element, or the finish of
        straight elements at the second click."""
        options = self._store.state.options
        self._store.update(options=replace(options, **{option: on}))


def without_points(selection: ChosenElement) -> ChosenElement:
    """Return a selection without its points."""
    return replace(selection, point=None, points=frozenset())


def that_survives(
    selection: ChosenElement, before: FrameAnnotation, after: FrameAnnotation, *, stepped: bool
) -> ChosenElement:
    """Return the selection after an annotation has changed; clicks do not continue an element
    whose points changed. If ``stepped``, the other one was made elsewhere (undo, another window):
    points of an element that has more or fewer of them are others then than those chosen."""
    name = selection.class_name or ""
    if selection.continues and _polyline(before, name) != _polyline(after, name):
        selection = replace(selection, continues=False)
    if selection.point is not None and selection.point[1] >= _count(after, selection.point[0]):
        return without_points(selection)
    if stepped:
        chosen = selection.points | ({selection.point} if selection.point else set())
        if any(_count(before, name) != _count(after, name) for name in {ref[0] for ref in chosen}):
            return without_points(selection)
    return selection


def _polyline(annotation: FrameAnnotation, class_name: str) -> Polyline | None:
    return annotation.get(class_name) or annotation.get_unconfirmed(class_name)


def _count(annotation: FrameAnnotation, class_name: str) -> int:
    polyline = _polyline(annotation, class_name)
    return len(polyline.points) if polyline is not None else 0
