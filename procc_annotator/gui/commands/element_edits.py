"""Editing elements: splitting, joining, turning, duplicating, deleting; naming new lines."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np
from PySide6.QtCore import QObject, QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QMenu, QWidget

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.arrays import FloatArray
from procc_annotator.assist.copying import annotated_before
from procc_annotator.assist.regularise import close_gaps
from procc_annotator.calibration.prediction.suggestions import likely_classes
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.calibration.result import FitResult
from procc_annotator.dataset import editing
from procc_annotator.dataset.records import OriginKind
from procc_annotator.errors import UsageError
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.keymap import NATIVE, element_keys, keys_by_place
from procc_annotator.gui.panels.element_states import class_swatch
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import LatestOnlyTask, Priority
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction.class_choice import rank_classes
from procc_annotator.interaction.gestures import CONFIRM, step_name
from procc_annotator.translation import tr, tr_count, translatable, translatable_count, word


class ElementEdits:
    """Edits of the selected element, its chosen point, or all unconfirmed elements.

    Whatever changes an unconfirmed element confirms it: the user has decided where it is.
    """

    def __init__(self, services: Services) -> None:
        self._services = services

    # --- the element's class --------------------------------------------------------------

    def change_class(self, new: str) -> None:
        """Give the selected element another class; a class that is taken swaps with it."""
        old = self._selected()
        if old is None or new == old:
            return
        change: Callable[[FrameAnnotation, str, str], FrameAnnotation] = editing.change_class
        words = word("{element} becomes {other}")
        if self._services.state.annotation.get(new) is not None:
            change, words = editing.swap_classes, word("swap {element} and {other}")
        label = self._step(words, element=old, other=new)
        if self._edit((old, new), label, lambda seen: change(seen, old, new)):
            self._services.selection.select_class(new)

    def symmetric_classes(self) -> tuple[str, ...]:
        """The other classes that the selected one becomes on the turned field, a turn each."""
        name = self._services.state.selected_class
        return self._services.state.field.symmetric_names(name) if name is not None else ()

    def duplicate_symmetric(self) -> None:
        """Put an unconfirmed copy of the selected element under its symmetric class; of several
        under the first that is not annotated yet."""
        old, partners = self._selected(), self.symmetric_classes()
        if old is None:
            return
        services, title_of = self._services, self._services.state.title_of
        polyline = self._touched(old).get(old)
        if not partners or polyline is None:
            services.say(tr("{element} is its own symmetric element", element=title_of(old)))
            return
        new = next((name for name in partners if services.state.annotation.get(name) is None), None)
        if new is None:
            services.say(
                tr_count(
                    len(partners),
                    "{elements} is annotated already",
                    "{elements} are annotated already",
                    elements=", ".join(map(title_of, partners)),
                )
            )
            return
        copy = editing.change_class(FrameAnnotation((polyline,)), old, new).polylines
        label = self._step(word("duplicate {element} as {other}"), element=old, other=new)
        if self._edit((old, new), label, lambda seen: editing.add_unconfirmed(seen, copy)):
            services.selection.set_mode("edit")
            services.selection.select_class(new)
            services.say(
                tr(
                    "{element} lies where {other} is: drag it to its place",
                    element=title_of(new),
                    other=title_of(old),
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
        point = self._services.state.selection.point
        if point is None:
            self._services.say(tr("choose the point to split at first (edit mode)"))
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
            self._services.selection.select_class(target)

    def close_gaps(self) -> None:
        """Let the selected element, or all, reach the corners and edges they fall short of."""
        services, size = self._services, self._services.state.picture_size
        services.store.events.aboutToLeave.emit()
        if not services.editing.begin_edit() or size is None:
            return
        selected = services.state.selected_class

        def close(annotation: FrameAnnotation) -> FrameAnnotation:
            changed = annotation if selected is None else editing.confirm(annotation, selected)
            for polyline in changed.polylines:
                if selected in (None, polyline.class_name):
                    closed = close_gaps(polyline, changed, services.state.field, size)
                    if closed != polyline:
                        changed = changed.with_polyline(closed)
            if changed == annotation:
                raise UsageError(tr("no end is that near to a corner or the picture's edge"))
            return changed

        services.editing.edit(translatable("close gaps"), close, OriginKind.MOVED)

    # --- unconfirmed elements -------------------------------------------------------------

    def confirm(self) -> None:
        """Make the selected unconfirmed element an annotated one."""
        services = self._services
        services.store.events.aboutToLeave.emit()
        name = services.state.selected_class
        if name is not None and services.state.annotation.get_unconfirmed(name) is not None:
            label = step_name(CONFIRM, services.state.field.title_of(name))
            services.editing.edit(
                label, lambda seen: editing.confirm(seen, name), OriginKind.COPIED
            )

    def confirm_all(self) -> None:
        """Make all unconfirmed elements annotated ones; a click must not go on with one that was
        chosen because it waited."""
        if waiting := self._unconfirmed():
            services = self._services
            name = services.state.selected_class or ""
            waited = services.state.annotation.get_unconfirmed(name) is not None
            label = translatable_count(waiting, "confirm {n} element", "confirm {n} elements")
            if not services.editing.edit(label, editing.confirm_all, OriginKind.COPIED):
                return
            if waited and services.state.mode == "draw":
                services.selection.select_class(None)
            services.say(tr_count(waiting, "confirmed {n} element", "confirmed {n} elements"))

    def drop_unconfirmed(self) -> None:
        """Throw all unconfirmed elements away."""
        if waiting := self._unconfirmed():
            label = translatable_count(
                waiting, "drop {n} unconfirmed element", "drop {n} unconfirmed elements"
            )
            if self._services.editing.edit(label, editing.drop_unconfirmed):
                self._services.say(
                    tr_count(
                        waiting,
                        "dropped {n} unconfirmed element",
                        "dropped {n} unconfirmed elements",
                    )
                )

    def _unconfirmed(self) -> int:
        """Return how many elements are unconfirmed; says so where none is."""
        self._services.store.events.aboutToLeave.emit()
        waiting = len(self._services.state.annotation.unconfirmed)
        if not waiting:
            self._services.say(tr("nothing is unconfirmed on this frame"))
        return waiting

    # --- inside ---------------------------------------------------------------------------

    def _selected(self) -> str | None:
        self._services.store.events.aboutToLeave.emit()
        name = self._services.state.selected_class
        polyline = self._touched(name).get(name) if name is not None else None
        if polyline is None or not polyline.points:
            self._services.say(tr("choose an annotated element first"))
            return None
        return name

    def _touched(self, class_name: str) -> FrameAnnotation:
        """The annotation with this element confirmed, if it was not."""
        return editing.confirm(self._services.state.annotation, class_name)

    def _step(self, words: str, **elements: str) -> str:
        """The name of a step of undo: what ``word`` marked, with elements by their classes."""
        title_of = self._services.state.field.title_of
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
                    title = self._services.state.title_of(name)
                    raise UsageError(
                        tr("{element} was changed elsewhere: look at it again", element=title)
                    )
            try:
                return change(touched)
            except ValueError as error:
                raise UsageError(str(error)) from error

        return self._services.editing.edit(label, apply)


_BESIDE = QPoint(18, 12)  # of the pen, so that its next move chooses nothing
_CURVE = 3  # points; two are on any curve
_FARTHEST = 0.1  # of the picture's width: ghosts beyond are another line


class _Offer(QMenu):
    """A menu in which the keys of all elements mean what they mean outside."""

    def __init__(
        self, keys: Mapping[str, QKeySequence], named: Callable[[str], None], parent: QWidget
    ) -> None:
        super().__init__(tr("Name of the line"), parent)
        self._keys, self._named = keys, named
        self._typed = ""  # the beginning of longer keys

    def keyPressEvent(self, event: QKeyEvent) -> None:
        chord = keys_by_place(event) or QKeySequence(event.keyCombination()).toString()
        typed = QKeySequence(self._typed + chord)
        matches = {typed.matches(keys): name for name, keys in self._keys.items()}
        self._typed = ""
        if (name := matches.get(QKeySequence.SequenceMatch.ExactMatch)) is not None:
            self.close()
            self._named(name)
        elif QKeySequence.SequenceMatch.PartialMatch in matches:
            self._typed = f"{typed.toString()}, "
        else:
            super().keyPressEvent(event)


class Naming(QObject):
    """Shows a short menu after every line without a name. Esc leaves it without one."""

    searchWanted = Signal(object)  # what gives the line the class that is found

    def __init__(self, services: Services, canvas: Canvas, edits: ElementEdits) -> None:
        super().__init__(canvas)
        self._services, self._canvas, self._edits = services, canvas, edits
        self.menu: QMenu | None = None
        self._fit: FitResult | None = None  # the last camera of this frame
        self._looking = LatestOnlyTask(
            self, lambda text: services.say(text, "error"), priority=Priority.URGENT
        )
        canvas.editor.lineFinished.connect(self._ask_soon)
        services.store.watch(select.frame, self._forget)
        services.prediction.changed.connect(self._learn)
        services.store.watch(select.blind, self._forget)

    def _forget(self) -> None:
        self._fit = None
        self._learn()

    def _learn(self) -> None:
        """A camera stays known while the line that was just drawn makes another one."""
        insight = self._services.prediction.insight
        if insight is not None:
            self._fit = insight.fit

    def _ask_soon(self, class_name: str) -> None:
        services = self._services
        polyline, size = services.state.annotation.get(class_name), services.state.picture_size
        if polyline is None or size is None:
            return
        drawn = points_px(polyline, size)
        if self._camera_known:
            likely = self._likely(drawn)  # by what was foreseen before this line
            # Once the click that finished the line is through: a menu would take its release.
            QTimer.singleShot(0, self, lambda: self._ask(class_name, drawn, likely))
            return
        field, known = services.state.field, self._named(size)
        self._looking.start(
            lambda _: likely_classes(field, drawn, size, known),
            lambda names: self._ask(class_name, drawn, self._likely(drawn, names)),
        )

    @property
    def _camera_known(self) -> bool:
        allowed = self._services.state.projection_visible
        return allowed and self._fit is not None and self._fit.camera is not None

    def _named(self, size: tuple[int, int]) -> dict[str, FloatArray]:
        """The elements of the frame that have names, px."""
        services = self._services
        return {
            p.class_name: np.asarray(points_px(p, size))
            for p in services.state.annotation
            if p.points and services.state.field.element(p.class_name) is not None
        }

    def _ask(self, class_name: str, drawn: FloatArray, likely: tuple[str, ...]) -> None:
        state = self._services.state
        if state.selected_class != class_name or state.annotation.get(class_name) is None:
            return  # the frame was left, or the line taken back
        field = state.field
        keys, named = element_keys(field, state.keymap), partial(self._name, class_name)
        menu = self.menu = _Offer(keys, named, self._canvas)
        menu.setObjectName("namingMenu")
        menu.setAccessibleName(tr("What is this line?"))
        for name in likely:
            title = tr(field.title_of(name)).replace("&", "&&")
            key = keys[name].toString(NATIVE) if name in keys else ""
            action = menu.addAction(class_swatch(field, name), f"{title}\t{key}")
            action.setData(name)
            action.setIconVisibleInMenu(True)
            action.triggered.connect(partial(self._name, class_name, name))
        menu.addSeparator()
        menu.addAction(f"{tr('Another element…')} &/", lambda: self.searchWanted.emit(named))
        escape = QKeySequence(Qt.Key.Key_Escape).toString(QKeySequence.SequenceFormat.NativeText)
        menu.addAction(f"{tr('Leave it unnamed')}\t{escape}")
        menu.setActiveAction(menu.actions()[0])
        menu.aboutToHide.connect(menu.deleteLater)
        at = self._canvas.to_view(*drawn[-1]).toPoint() + _BESIDE
        menu.popup(self._canvas.viewport().mapToGlobal(at))

    def _name(self, class_name: str, name: str) -> None:
        services = self._services
        state = services.state
        drawn, title = state.annotation.get(class_name), state.title_of(name)
        if state.selected_class != class_name or drawn is None:
            return
        if state.annotation.get(name) is not None:  # the two would be swapped
            services.say(tr("{element} is annotated already", element=title), "warning")
            return
        self._edits.change_class(name)
        unclear = name in self._canvas.editor.curved and len(drawn.points) < _CURVE
        # Otherwise a line comes next.
        services.selection.select_class(name if unclear else None, continues=unclear)
        if unclear:
            why = tr("{element} is a curve, which two points do not show: click on", element=title)
            services.say(why, "warning")

    def _likely(self, drawn: FloatArray, by_views: tuple[str, ...] = ()) -> tuple[str, ...]:
        """By the camera that is known, else by what the frame before had there and by the usual
        views of such a field; then by what usually comes next."""
        services = self._services
        field, annotation = services.state.field, services.state.annotation
        there = {p.class_name for p in annotation}
        if len(drawn) < _CURVE:
            there |= self._canvas.editor.curved
        size = services.state.picture_size or (2, 2)
        before, last = self._canvas.editor.seen_before, services.state.selection.last_finished
        following = services.ghosts.following(last, before)
        usual = [following] if following is not None and following not in there else []
        usual += [e.name for e in field.elements if e.name not in there and not e.optional]
        fit = self._fit if services.state.projection_visible else None
        if fit is not None and fit.camera is not None:
            # All that it has in sight, also what it knows too little of for a ghost: which of them
            # a line is can be distinguished from much farther off.
            courses: dict[str, list[FloatArray]] = {}
            for stretch in visible_stretches(field, fit.camera, fit.size, there):
                courses.setdefault(stretch.name, []).append(stretch.points_px)
            return rank_classes(drawn, courses, usual, farthest=_FARTHEST * size[0])
        expected = self._before(size, there)
        usual = [*(name for name in by_views if name not in there), *usual]
        return rank_classes(drawn, expected, usual, farthest=_FARTHEST * size[0])

    def _before(self, size: tuple[int, int], there: set[str]) -> dict[str, list[FloatArray]]:
        """Return what the frame before had and this one has not yet, px of this picture."""
        services = self._services
        if services.state.workspace is None:
            return {}
        found = annotated_before(services.state.workspace, services.state.frame_index)
        if found is None:
            return {}
        return {
            p.class_name: [np.asarray(points_px(p, size))]
            for p in found[1]
            if p.class_name not in there and services.state.field.element(p.class_name) is not None
        }
