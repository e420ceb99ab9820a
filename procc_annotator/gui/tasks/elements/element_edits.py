"""Edits of whole elements, as the menus name them; each is one step of undo."""

from __future__ import annotations

from collections.abc import Callable

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import UsageError
from procc_annotator.gui.state.document import Document
from procc_annotator.interact.hints import counted
from procc_annotator.interact.next_element import next_element
from procc_annotator.session.dataset import edits
from procc_annotator.session.facts.origins import OriginKind
from procc_annotator.session.strokes.gaps import close_gaps


class ElementEdits:
    """What can be done to the selected element, its chosen point, or all unconfirmed elements.

    Whatever changes an unconfirmed element confirms it: a hand has decided where it is.
    """

    def __init__(self, document: Document) -> None:
        self._document = document

    # --- the element's class --------------------------------------------------------------

    def change_class(self, new: str) -> None:
        """Give the selected element another class; a class that is taken swaps with it."""
        old = self._selected()
        if old is None or new == old:
            return
        if self._document.annotation.get(new) is not None:
            self._swap(old, new)
            return
        label = f"{self._title(old)} becomes {self._title(new)}"
        if self._edit((old, new), label, lambda seen: edits.change_class(seen, old, new)):
            self._document.select_class(new)

    def _swap(self, old: str, other: str) -> None:
        label = f"swap {self._title(old)} and {self._title(other)}"
        if self._edit((old, other), label, lambda seen: edits.swap_classes(seen, old, other)):
            self._document.select_class(other)

    def symmetric_classes(self) -> tuple[str, ...]:
        """The other classes that the selected one becomes on the turned field, a turn each."""
        name = self._document.selected_class
        return self._document.field.symmetric_names(name) if name is not None else ()

    def duplicate_symmetric(self) -> None:
        """Put an unconfirmed copy of the selected element under its symmetric class; of several
        under the first that is not annotated yet."""
        old, partners = self._selected(), self.symmetric_classes()
        if old is None:
            return
        document = self._document
        polyline = self._touched(old).get(old)
        if not partners or polyline is None:
            document.say(f"{self._title(old)} is its own symmetric element")
            return
        new = next((name for name in partners if document.annotation.get(name) is None), None)
        if new is None:
            titles = ", ".join(map(self._title, partners))
            are = "is" if len(partners) == 1 else "are"
            document.say(f"{titles} {are} annotated already")
            return
        copy = edits.change_class(FrameAnnotation((polyline,)), old, new).polylines
        label = f"duplicate {self._title(old)} as {self._title(new)}"
        if self._edit((old, new), label, lambda seen: edits.propose(seen, copy)):
            document.set_mode("edit")
            document.select_class(new)
            document.say(
                f"{self._title(new)} lies where {self._title(old)} is: drag it to its place"
            )

    # --- the element's points -------------------------------------------------------------

    def reverse(self) -> None:
        """Turn the order of the selected element's points round."""
        if (name := self._selected()) is not None:
            label = f"reverse {self._title(name)}"
            self._edit((name,), label, lambda seen: edits.reverse(seen, name))

    def split(self, rest: str) -> None:
        """Cut the selected element at its chosen point; the rest becomes another class."""
        point = self._document.selected_point
        if point is None:
            self._document.say("choose the point to split at first (edit mode)")
            return
        name, index = point

        def split(seen: FrameAnnotation) -> FrameAnnotation:
            try:
                return edits.split(seen, name, index, rest)
            except (IndexError, ValueError):
                raise UsageError(
                    "an element is split at a point between its ends, into a class that is free"
                ) from None

        self._edit((name, rest), f"split {self._title(name)}", split)

    def merge_into(self, target: str) -> None:
        """Join the selected element's points to another element's."""
        source = self._selected()
        if source is None:
            return
        label = f"merge {self._title(source)} into {self._title(target)}"
        if self._edit((source, target), label, lambda seen: edits.merge(seen, source, target)):
            self._document.select_class(target)

    def close_gaps(self) -> None:
        """Let the selected element, or all, reach the corners and edges they fall short of."""
        document, size = self._document, self._document.picture_size
        document.aboutToLeave.emit()
        if size is None:
            return
        selected = document.selected_class

        def close(annotation: FrameAnnotation) -> FrameAnnotation:
            changed = annotation if selected is None else edits.confirm(annotation, selected)
            for polyline in changed.polylines:
                if selected in (None, polyline.class_name):
                    closed = close_gaps(polyline, changed, document.field, size)
                    if closed != polyline:
                        changed = changed.with_polyline(closed)
            if changed == annotation:
                raise UsageError("no end is that near to a corner or the picture's edge")
            return changed

        document.edit("close gaps", close, OriginKind.MOVED)

    # --- unconfirmed elements -------------------------------------------------------------

    def confirm(self) -> None:
        """Make the selected unconfirmed element an annotated one."""
        document = self._document
        document.aboutToLeave.emit()
        name = document.selected_class
        if name is not None and document.annotation.get_unconfirmed(name) is not None:
            label = f"confirm {self._title(name)}"
            document.edit(label, lambda seen: edits.confirm(seen, name), OriginKind.COPIED)

    def confirm_all(self) -> None:
        """Make all unconfirmed elements annotated ones; the next one is chosen, as after each that
        is finished: a click must not go on with one that was chosen because it waited."""
        if waiting := self._unconfirmed():
            document, what = self._document, counted(waiting, "element")
            name = document.selected_class or ""
            waited = document.annotation.get_unconfirmed(name) is not None
            if not document.edit(f"confirm {what}", edits.confirm_all, OriginKind.COPIED):
                return
            if waited and document.mode == "draw":
                document.select_class(self._following(name))
            document.say(f"confirmed {what}")

    def _following(self, name: str) -> str | None:
        document = self._document
        if not document.state.options.auto_advance:
            return None
        field, gains = document.field, document.ghosts.gains
        unseen = document.ghosts.out_of_sight
        return next_element(field, document.annotation, name, gains=gains, out_of_sight=unseen)

    def drop_unconfirmed(self) -> None:
        """Throw all unconfirmed elements away."""
        if waiting := self._unconfirmed():
            what = counted(waiting, "unconfirmed element")
            if self._document.edit(f"drop {what}", edits.drop_unconfirmed):
                self._document.say(f"dropped {what}")

    def _unconfirmed(self) -> int:
        """How many elements are unconfirmed; says so where none is."""
        self._document.aboutToLeave.emit()
        waiting = len(self._document.annotation.unconfirmed)
        if not waiting:
            self._document.say("nothing is unconfirmed on this frame")
        return waiting

    # --- inside ---------------------------------------------------------------------------

    def _selected(self) -> str | None:
        """The selected class if it is annotated; else says so. What is under way ends first."""
        self._document.aboutToLeave.emit()
        name = self._document.selected_class
        polyline = self._touched(name).get(name) if name is not None else None
        if polyline is None or not polyline.points:
            self._document.say("choose an annotated element first")
            return None
        return name

    def _touched(self, class_name: str) -> FrameAnnotation:
        """The annotation with this element confirmed, if it was not."""
        return edits.confirm(self._document.annotation, class_name)

    def _title(self, class_name: str) -> str:
        return self._document.field.title_of(class_name)

    def _edit(
        self,
        names: tuple[str, ...],
        label: str,
        change: Callable[[FrameAnnotation], FrameAnnotation],
    ) -> bool:
        """Edit elements that somebody looks at, the first one confirmed if it was not; what another
        window made of them meanwhile is to be looked at first."""
        seen = [self._touched(names[0]).get(name) for name in names]

        def apply(annotation: FrameAnnotation) -> FrameAnnotation:
            touched = edits.confirm(annotation, names[0])
            for name, polyline in zip(names, seen, strict=True):
                if touched.get(name) != polyline:
                    raise UsageError(f"{self._title(name)} was changed elsewhere: look at it again")
            try:
                return change(touched)
            except ValueError as error:
                raise UsageError(str(error)) from error

        return self._document.edit(label, apply)
