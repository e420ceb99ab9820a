"""Edits of whole elements, as the menus name them; each is one step of undo."""

from __future__ import annotations

from collections.abc import Callable

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.regularise import close_gaps
from procc_annotator.dataset import editing
from procc_annotator.dataset.records import OriginKind
from procc_annotator.errors import UsageError
from procc_annotator.gui.state.document import Document
from procc_annotator.interaction.class_choice import next_element
from procc_annotator.interaction.gestures import CONFIRM, step_name
from procc_annotator.translation import tr, tr_count, translatable, translatable_count, word


class ElementEdits:
    """What can be done to the selected element, its chosen point, or all unconfirmed elements.

    Whatever changes an unconfirmed element confirms it: the user has decided where it is.
    """

    def __init__(self, document: Document) -> None:
        self._document = document

    # --- the element's class --------------------------------------------------------------

    def change_class(self, new: str) -> None:
        """Give the selected element another class; a class that is taken swaps with it."""
        old = self._selected()
        if old is None or new == old:
            return
        if self._document.state.annotation.get(new) is not None:
            self._swap(old, new)
            return
        label = self._step(word("{element} becomes {other}"), element=old, other=new)
        if self._edit((old, new), label, lambda seen: editing.change_class(seen, old, new)):
            self._document.selecting.select_class(new)

    def _swap(self, old: str, other: str) -> None:
        label = self._step(word("swap {element} and {other}"), element=old, other=other)
        if self._edit((old, other), label, lambda seen: editing.swap_classes(seen, old, other)):
            self._document.selecting.select_class(other)

    def symmetric_classes(self) -> tuple[str, ...]:
        """The other classes that the selected one becomes on the turned field, a turn each."""
        name = self._document.state.selected_class
        return self._document.state.field.symmetric_names(name) if name is not None else ()

    def duplicate_symmetric(self) -> None:
        """Put an unconfirmed copy of the selected element under its symmetric class; of several
        under the first that is not annotated yet."""
        old, partners = self._selected(), self.symmetric_classes()
        if old is None:
            return
        document = self._document
        polyline = self._touched(old).get(old)
        if not partners or polyline is None:
            document.say(tr("{element} is its own symmetric element", element=self._title(old)))
            return
        new = next((name for name in partners if document.state.annotation.get(name) is None), None)
        if new is None:
            document.say(
                tr_count(
                    len(partners),
                    "{elements} is annotated already",
                    "{elements} are annotated already",
                    elements=", ".join(map(self._title, partners)),
                )
            )
            return
        copy = editing.change_class(FrameAnnotation((polyline,)), old, new).polylines
        label = self._step(word("duplicate {element} as {other}"), element=old, other=new)
        if self._edit((old, new), label, lambda seen: editing.add_unconfirmed(seen, copy)):
            document.selecting.set_mode("edit")
            document.selecting.select_class(new)
            document.say(
                tr(
                    "{element} lies where {other} is: drag it to its place",
                    element=self._title(new),
                    other=self._title(old),
                )
            )

    # --- the element's points -------------------------------------------------------------

    def reverse(self) -> None:
        """Turn the order of the selected element's points round."""
        if (name := self._selected()) is not None:
            label = self._step(word("reverse {element}"), element=name)
            self._edit((name,), label, lambda seen: editing.reverse(seen, name))

    def split(self, rest: str) -> None:
        """Cut the selected element at its chosen point; the rest becomes another class."""
        point = self._document.state.selection.point
        if point is None:
            self._document.say(tr("choose the point to split at first (edit mode)"))
            return
        name, index = point

        def split(seen: FrameAnnotation) -> FrameAnnotation:
            try:
                return editing.split(seen, name, index, rest)
            except (IndexError, ValueError):
                raise UsageError(
                    tr("an element is split at a point between its ends, into a class that is free")
                ) from None

        self._edit((name, rest), self._step(word("split {element}"), element=name), split)

    def merge_into(self, target: str) -> None:
        """Join the selected element's points to another element's."""
        source = self._selected()
        if source is None:
            return
        label = self._step(word("merge {element} into {other}"), element=source, other=target)
        if self._edit((source, target), label, lambda seen: editing.merge(seen, source, target)):
            self._document.selecting.select_class(target)

    def close_gaps(self) -> None:
        """Let the selected element, or all, reach the corners and edges they fall short of."""
        document, size = self._document, self._document.state.picture_size
        document.store.events.aboutToLeave.emit()
        if not document.editing.begin_edit() or size is None:
            return
        selected = document.state.selected_class

        def close(annotation: FrameAnnotation) -> FrameAnnotation:
            changed = annotation if selected is None else editing.confirm(annotation, selected)
            for polyline in changed.polylines:
                if selected in (None, polyline.class_name):
                    closed = close_gaps(polyline, changed, document.state.field, size)
                    if closed != polyline:
                        changed = changed.with_polyline(closed)
            if changed == annotation:
                raise UsageError(tr("no end is that near to a corner or the picture's edge"))
            return changed

        document.editing.edit(translatable("close gaps"), close, OriginKind.MOVED)

    # --- unconfirmed elements -------------------------------------------------------------

    def confirm(self) -> None:
        """Make the selected unconfirmed element an annotated one."""
        document = self._document
        document.store.events.aboutToLeave.emit()
        name = document.state.selected_class
        if name is not None and document.state.annotation.get_unconfirmed(name) is not None:
            label = step_name(CONFIRM, document.state.field.title_of(name))
            document.editing.edit(
                label, lambda seen: editing.confirm(seen, name), OriginKind.COPIED
            )

    def confirm_all(self) -> None:
        """Make all unconfirmed elements annotated ones; the next one is chosen, as after each that
        is finished: a click must not go on with one that was chosen because it waited."""
        if waiting := self._unconfirmed():
            document = self._document
            name = document.state.selected_class or ""
            waited = document.state.annotation.get_unconfirmed(name) is not None
            label = translatable_count(waiting, "confirm {n} element", "confirm {n} elements")
            if not document.editing.edit(label, editing.confirm_all, OriginKind.COPIED):
                return
            if waited and document.state.mode == "draw":
                document.selecting.select_class(self._following(name))
            document.say(tr_count(waiting, "confirmed {n} element", "confirmed {n} elements"))

    def _following(self, name: str) -> str | None:
        document = self._document
        if not document.state.options.auto_advance:
            return None
        field, gains = document.state.field, document.ghosts.gains
        unseen = document.ghosts.out_of_sight
        return next_element(
            field, document.state.annotation, name, gains=gains, out_of_sight=unseen
        )

    def drop_unconfirmed(self) -> None:
        """Throw all unconfirmed elements away."""
        if waiting := self._unconfirmed():
            label = translatable_count(
                waiting, "drop {n} unconfirmed element", "drop {n} unconfirmed elements"
            )
            if self._document.editing.edit(label, editing.drop_unconfirmed):
                self._document.say(
                    tr_count(
                        waiting,
                        "dropped {n} unconfirmed element",
                        "dropped {n} unconfirmed elements",
                    )
                )

    def _unconfirmed(self) -> int:
        """Return how many elements are unconfirmed; says so where none is."""
        self._document.store.events.aboutToLeave.emit()
        waiting = len(self._document.state.annotation.unconfirmed)
        if not waiting:
            self._document.say(tr("nothing is unconfirmed on this frame"))
        return waiting

    # --- inside ---------------------------------------------------------------------------

    def _selected(self) -> str | None:
        """The selected class if it is annotated; else says so. What is under way ends first."""
        self._document.store.events.aboutToLeave.emit()
        name = self._document.state.selected_class
        polyline = self._touched(name).get(name) if name is not None else None
        if polyline is None or not polyline.points:
            self._document.say(tr("choose an annotated element first"))
            return None
        return name

    def _touched(self, class_name: str) -> FrameAnnotation:
        """The annotation with this element confirmed, if it was not."""
        return editing.confirm(self._document.state.annotation, class_name)

    def _title(self, class_name: str) -> str:
        return tr(self._document.state.field.title_of(class_name))

    def _step(self, words: str, **elements: str) -> str:
        """The name of a step of undo: what ``word`` marked, with elements by their classes."""
        title_of = self._document.state.field.title_of
        return translatable(
            words, **{place: translatable(title_of(name)) for place, name in elements.items()}
        )

    def _edit(
        self,
        names: tuple[str, ...],
        label: str,
        change: Callable[[FrameAnnotation], FrameAnnotation],
    ) -> bool:
        """Edit elements that a person looks at, the first one confirmed if it was not; what another
        window made of them meanwhile is to be checked first."""
        seen = [self._touched(names[0]).get(name) for name in names]

        def apply(annotation: FrameAnnotation) -> FrameAnnotation:
            touched = editing.confirm(annotation, names[0])
            for name, polyline in zip(names, seen, strict=True):
                if touched.get(name) != polyline:
                    title = self._title(name)
                    raise UsageError(
                        tr("{element} was changed elsewhere: look at it again", element=title)
                    )
            try:
                return change(touched)
            except ValueError as error:
                raise UsageError(str(error)) from error

        return self._document.editing.edit(label, apply)
