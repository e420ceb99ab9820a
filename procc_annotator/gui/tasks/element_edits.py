"""Edits of whole elements, as the menus name them; each is one step of undo."""

from __future__ import annotations

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.gui.state.document import Document
from procc_annotator.interact.hints import counted
from procc_annotator.session import edits
from procc_annotator.session.gaps import close_gaps
from procc_annotator.session.origins import OriginKind


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
            self.swap(new)
            return
        changed = edits.change_class(self._touched(old), old, new)
        if self._commit(f"{self._title(old)} becomes {self._title(new)}", changed):
            self._document.select_class(new)

    def swap(self, other: str) -> None:
        """Swap the classes of the selected element and another one."""
        old = self._selected()
        if old is not None:
            swapped = edits.swap_classes(self._touched(old), old, other)
            if self._commit(f"swap {self._title(old)} and {self._title(other)}", swapped):
                self._document.select_class(other)

    def symmetric_class(self) -> str | None:
        """The class that the selected one becomes on the turned field; None: itself."""
        name = self._document.selected_class
        mirrored = self._document.field.mirrored_name(name) if name is not None else None
        return mirrored if mirrored != name else None

    def duplicate_symmetric(self) -> None:
        """Put an unconfirmed copy of the selected element under its symmetric class."""
        old, new = self._selected(), self.symmetric_class()
        if old is None:
            return
        document, touched = self._document, self._touched(old)
        polyline = touched.get(old)
        if new is None or polyline is None:
            document.message.emit(f"{self._title(old)} is its own symmetric element", "info")
            return
        if document.annotation.get(new) is not None:
            document.message.emit(f"{self._title(new)} is annotated already", "info")
            return
        copy = edits.change_class(FrameAnnotation((polyline,)), old, new).polylines
        proposed = edits.propose(touched, copy)
        if self._commit(f"duplicate {self._title(old)} as {self._title(new)}", proposed):
            document.set_mode("edit")
            document.select_class(new)
            document.message.emit(
                f"{self._title(new)} lies where {self._title(old)} is: drag it to its place", "info"
            )

    # --- the element's points -------------------------------------------------------------

    def reverse(self) -> None:
        """Turn the order of the selected element's points round."""
        if (name := self._selected()) is not None:
            self._commit(f"reverse {self._title(name)}", edits.reverse(self._touched(name), name))

    def split(self, rest: str) -> None:
        """Cut the selected element at its chosen point; the rest becomes another class."""
        point = self._document.selected_point
        if point is None:
            self._document.message.emit("choose the point to split at first (edit mode)", "info")
            return
        try:
            parted = edits.split(self._touched(point[0]), *point, rest)
        except (IndexError, ValueError):
            self._document.message.emit(
                "an element is split at a point between its ends, into a class that is free", "info"
            )
            return
        self._commit(f"split {self._title(point[0])}", parted)

    def merge_into(self, target: str) -> None:
        """Join the selected element's points to another element's."""
        source = self._selected()
        if source is None:
            return
        try:
            merged = edits.merge(self._touched(source), source, target)
        except ValueError as error:
            self._document.message.emit(str(error), "info")
            return
        if self._commit(f"merge {self._title(source)} into {self._title(target)}", merged):
            self._document.select_class(target)

    def close_gaps(self) -> None:
        """Let the selected element, or all, reach the corners and edges they fall short of."""
        document, size = self._document, self._document.picture_size
        document.aboutToLeave.emit()
        if size is None:
            return
        before = document.annotation
        selected = document.selected_class
        annotation = changed = before if selected is None else self._touched(selected)
        for polyline in annotation.polylines:
            if selected in (None, polyline.class_name):
                closed = close_gaps(polyline, annotation, document.field, size)
                if closed != polyline:
                    changed = changed.with_polyline(closed)
        if changed == annotation:
            document.message.emit("no end is that near to a corner or the picture's edge", "info")
        else:
            self._commit("close gaps", changed, OriginKind.MOVED)

    # --- unconfirmed elements -------------------------------------------------------------

    def confirm(self) -> None:
        """Make the selected unconfirmed element an annotated one."""
        document = self._document
        document.aboutToLeave.emit()
        name = document.selected_class
        if name is not None and document.annotation.get_unconfirmed(name) is not None:
            confirmed = edits.confirm(document.annotation, name)
            self._commit(f"confirm {self._title(name)}", confirmed, OriginKind.COPIED)

    def confirm_all(self) -> None:
        """Make all unconfirmed elements annotated ones."""
        self._document.aboutToLeave.emit()
        waiting = len(self._document.annotation.unconfirmed)
        if not waiting:
            self._document.message.emit("nothing is unconfirmed on this frame", "info")
            return
        confirmed = edits.confirm_all(self._document.annotation)
        what = counted(waiting, "element")
        if self._commit(f"confirm {what}", confirmed, OriginKind.COPIED):
            self._document.message.emit(f"confirmed {what}", "info")

    def drop_unconfirmed(self) -> None:
        """Throw all unconfirmed elements away."""
        self._document.aboutToLeave.emit()
        waiting = len(self._document.annotation.unconfirmed)
        if not waiting:
            self._document.message.emit("nothing is unconfirmed on this frame", "info")
            return
        left = edits.drop_unconfirmed(self._document.annotation)
        what = counted(waiting, "unconfirmed element")
        if self._commit(f"drop {what}", left):
            self._document.message.emit(f"dropped {what}", "info")

    # --- inside ---------------------------------------------------------------------------

    def _selected(self) -> str | None:
        """The selected class if it is annotated; else says so. What is under way ends first."""
        self._document.aboutToLeave.emit()
        name = self._document.selected_class
        polyline = self._touched(name).get(name) if name is not None else None
        if polyline is None or not polyline.points:
            self._document.message.emit("choose an annotated element first", "info")
            return None
        return name

    def _touched(self, class_name: str) -> FrameAnnotation:
        """The annotation with this element confirmed, if it was not."""
        return edits.confirm(self._document.annotation, class_name)

    def _title(self, class_name: str) -> str:
        return self._document.field.title_of(class_name)

    def _commit(
        self,
        label: str,
        annotation: FrameAnnotation,
        kind: OriginKind = OriginKind.CLICKED,
    ) -> bool:
        return self._document.begin_edit() and self._document.commit_edit(label, annotation, kind)
