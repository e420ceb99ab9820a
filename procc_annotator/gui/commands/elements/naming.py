"""A line that was drawn without a class gets its name: the likeliest elements, at the pen."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np
from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import QMenu, QWidget

from procc_annotator.annotation import points_px
from procc_annotator.arrays import FloatArray
from procc_annotator.assist.copying import annotated_before
from procc_annotator.calibration.prediction.suggestions import likely_classes
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.calibration.result import FitResult
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.commands.elements.element_edits import ElementEdits
from procc_annotator.gui.digit_row import keys_by_place
from procc_annotator.gui.element_keys import element_keys
from procc_annotator.gui.keymap import NATIVE
from procc_annotator.gui.panels.element_states import class_swatch
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import LatestOnlyTask, Priority
from procc_annotator.gui.state.document import Document
from procc_annotator.interaction.class_choice import next_element, rank_classes
from procc_annotator.translation import tr

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

    def __init__(self, document: Document, canvas: Canvas, edits: ElementEdits) -> None:
        super().__init__(canvas)
        self._document, self._canvas, self._edits = document, canvas, edits
        self.menu: QMenu | None = None
        self._fit: FitResult | None = None  # the last camera of this frame
        self._looking = LatestOnlyTask(
            self, lambda text: document.say(text, "error"), priority=Priority.URGENT
        )
        canvas.editor.lineFinished.connect(self._ask_soon)
        document.store.watch(select.frame, self._forget)
        document.foresight.changed.connect(self._learn)
        document.store.watch(select.blind, self._forget)

    def _forget(self) -> None:
        self._fit = None
        self._learn()

    def _learn(self) -> None:
        """A camera stays known while the line that was just drawn makes another one."""
        insight = self._document.foresight.insight
        if insight is not None:
            self._fit = insight.fit

    def _ask_soon(self, class_name: str) -> None:
        document = self._document
        polyline, size = document.state.annotation.get(class_name), document.state.picture_size
        if polyline is None or size is None:
            return
        drawn = points_px(polyline, size)
        if self._camera_known:
            likely = self._likely(drawn)  # by what was foreseen before this line
            # Once the click that finished the line is through: a menu would take its release.
            QTimer.singleShot(0, self, lambda: self._ask(class_name, drawn, likely))
            return
        field, known = document.state.field, self._named(size)
        self._looking.start(
            lambda _: likely_classes(field, drawn, size, known),
            lambda names: self._ask(class_name, drawn, self._likely(drawn, names)),
        )

    @property
    def _camera_known(self) -> bool:
        allowed = self._document.foresight.allowed
        return allowed and self._fit is not None and self._fit.camera is not None

    def _named(self, size: tuple[int, int]) -> dict[str, FloatArray]:
        """The elements of the frame that have names, px."""
        document = self._document
        return {
            p.class_name: np.asarray(points_px(p, size))
            for p in document.state.annotation
            if p.points and document.state.field.element(p.class_name) is not None
        }

    def _ask(self, class_name: str, drawn: FloatArray, likely: tuple[str, ...]) -> None:
        document = self._document
        if (
            document.state.selected_class != class_name
            or document.state.annotation.get(class_name) is None
        ):
            return  # the frame was left, or the line taken back
        field = document.state.field
        keys = element_keys(field, document.state.keymap)
        menu = self.menu = _Offer(keys, partial(self._name, class_name), self._canvas)
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
        escape = QKeySequence(Qt.Key.Key_Escape).toString(QKeySequence.SequenceFormat.NativeText)
        menu.addAction(f"{tr('Leave it unnamed')}\t{escape}")
        menu.setActiveAction(menu.actions()[0])
        menu.aboutToHide.connect(menu.deleteLater)
        at = self._canvas.to_view(*drawn[-1]).toPoint() + _BESIDE
        menu.popup(self._canvas.viewport().mapToGlobal(at))

    def _name(self, class_name: str, name: str) -> None:
        document = self._document
        drawn, title = (
            document.state.annotation.get(class_name),
            tr(document.state.field.title_of(name)),
        )
        if document.state.selected_class != class_name or drawn is None:
            return
        if document.state.annotation.get(name) is not None:  # the two would be swapped
            document.say(tr("{element} is annotated already", element=title), "warning")
            return
        self._edits.change_class(name)
        unclear = name in self._canvas.editor.curved and len(drawn.points) < _CURVE
        document.selecting.select_class(
            name if unclear else None, continues=unclear
        )  # or a line comes next
        if unclear:
            why = tr("{element} is a curve, which two points do not show: click on", element=title)
            document.say(why, "warning")

    def _likely(self, drawn: FloatArray, by_views: tuple[str, ...] = ()) -> tuple[str, ...]:
        """By the camera that is known, else by what the frame before had there and by the usual
        views of such a field; then by what usually comes next."""
        document = self._document
        field, annotation = document.state.field, document.state.annotation
        there = {p.class_name for p in annotation}
        if len(drawn) < _CURVE:
            there |= self._canvas.editor.curved
        size = document.state.picture_size or (2, 2)
        before, last = self._canvas.editor.seen_before, document.state.selection.last_finished
        following = next_element(field, annotation, last, before)
        usual = [following] if following is not None and following not in there else []
        usual += [e.name for e in field.elements if e.name not in there and not e.optional]
        fit = self._fit if document.foresight.allowed else None
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
        document = self._document
        if document.state.workspace is None:
            return {}
        found = annotated_before(document.state.workspace, document.state.frame_index)
        if found is None:
            return {}
        return {
            p.class_name: [np.asarray(points_px(p, size))]
            for p in found[1]
            if p.class_name not in there and document.state.field.element(p.class_name) is not None
        }
