"""Editing tool: move, insert, delete and select points."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

from procc_annotator.annotation import FrameAnnotation, point_from_px, points_px
from procc_annotator.dataset import editing
from procc_annotator.dataset.editing import PointRef
from procc_annotator.dataset.records import OriginKind, PointKey
from procc_annotator.interaction.gestures import (
    DELETE,
    IGNORED,
    INSERT,
    MOVE,
    MOVE_ALL,
    Edit,
    Hit,
    Modifiers,
    Position,
    Reaction,
    Selection,
    ToolContext,
    confirmation,
    confirmed,
    deletion,
    hit_test,
    line_direction,
    nudged,
    point_key,
    points_within,
    step_name,
    toggled,
)
from procc_annotator.translation import tr, translatable_count

_DRAG_BEGINS_SCREEN_PX = 2.0
NUDGE_PX, FINE_NUDGE_PX, FAR_NUDGE_PX = 1.0, 0.1, 10.0
_Held = Literal["point", "points", "element", "pinned", "frame"]


@dataclass
class EditTool:
    """Moves, inserts and removes points; drags on empty ground choose several points.

    Unconfirmed elements can be taken like all others, as a whole too; moving them confirms them.
    """

    grabbed: PointRef | None = None
    band: tuple[Position, Position] | None = None
    _held: _Held = "point"
    _pressed: Position = (0.0, 0.0)
    _last: Position = (0.0, 0.0)
    _offset: Position = (0.0, 0.0)
    _found: FrameAnnotation | None = None
    _before: FrameAnnotation | None = None
    _together: frozenset[PointRef] = frozenset()
    _snapped: frozenset[PointKey] = frozenset()
    inserting: bool = False  # the held point is a new one
    _moved: bool = False
    _refused: bool = False

    @property
    def busy(self) -> bool:
        """Return whether something is held or a band is drawn."""
        held = self.grabbed is not None or self._before is not None
        return held or self.band is not None

    @property
    def held(self) -> str:
        """Return what is held: "point", "points", "element", "pinned" or "frame" (a band)."""
        return "frame" if self.band is not None else self._held

    def hover(self, position: Position, context: ToolContext) -> Hit | None:
        """Return what the next press would take; unconfirmed elements are below the others, but for
        a selected one."""
        waiting = FrameAnnotation(polylines=context.annotation.unconfirmed)
        layers = [context.annotation, waiting]
        selected = context.selected_class
        if selected is not None and context.is_unconfirmed(selected):
            layers.reverse()
        for annotation in layers:
            hit = hit_test(
                annotation,
                context.picture_size,
                position,
                context.view_scale,
                prefer=selected,
            )
            if hit is not None:
                return hit
        return None

    # --- pressing -------------------------------------------------------------------------

    def press(self, position: Position, modifiers: Modifiers, context: ToolContext) -> Reaction:
        """Take a point or an element, insert (Alt on a line), remove (Alt+Shift on a point), add
        to the chosen points (Shift), or begin a band on empty ground."""
        hit = self.hover(position, context)
        if hit is None:
            self._let_go()
            self.band, self._pressed = (position, position), position
            return Reaction()
        if modifiers.alt and modifiers.shift:
            if hit.kind != "point":
                return Reaction(select=Selection(hit.class_name))
            return deletion(context, hit.class_name, hit.index)
        if hit.kind == "point":
            ref = (hit.class_name, hit.index)
            if modifiers.shift:
                return toggled(ref, context)
            together = context.chosen_points if ref in context.chosen_points else frozenset()
            return self._grab(hit, hit.index, position, context, together=together)
        if modifiers.alt:
            return self._insert(hit, position, context)
        return self._grab_element(hit, position, context)

    def _insert(self, hit: Hit, position: Position, context: ToolContext) -> Reaction:
        point = point_from_px(*hit.foot, context.picture_size)
        base = editing.confirm(context.annotation, hit.class_name)
        edited = editing.insert_point(base, hit.class_name, hit.index + 1, point)
        taken = self._grab(hit, hit.index + 1, position, context, before=edited)
        self.inserting = True
        return Reaction(preview=edited, select=taken.select)

    def _grab_element(self, hit: Hit, position: Position, context: ToolContext) -> Reaction:
        self._grab(hit, 0, position, context)
        self.grabbed = None
        free = not context.pinned or context.is_unconfirmed(hit.class_name)
        self._held = "element" if free else "pinned"
        count = context.point_count(hit.class_name)
        self._together = frozenset((hit.class_name, i) for i in range(count))
        return Reaction(select=Selection(hit.class_name))

    def _grab(
        self,
        hit: Hit,
        index: int,
        position: Position,
        context: ToolContext,
        *,
        before: FrameAnnotation | None = None,
        together: frozenset[PointRef] = frozenset(),
    ) -> Reaction:
        self._let_go()
        self.grabbed = (hit.class_name, index)
        self._held = "points" if len(together) > 1 else "point"
        self._together = together
        self._found = context.annotation
        self._before = before if before is not None else context.annotation
        self._pressed = self._last = position
        self._offset = (hit.foot[0] - position[0], hit.foot[1] - position[1])
        return Reaction(select=Selection(hit.class_name, index, together))

    # --- moving ---------------------------------------------------------------------------

    def _lost(self, context: ToolContext) -> bool:
        """Let go when undo or a reload changed the frame under the held point: carrying on would
        bring back what was just taken away."""
        if context.annotation == self._found:
            return False
        self._let_go()
        return True

    def move(self, position: Position, modifiers: Modifiers, context: ToolContext) -> Reaction:
        """Carry what is held along; it keeps its distance to the cursor, or draws the band."""
        if self.band is not None:
            self.band = (self._pressed, position)
            return Reaction()
        if self._before is None:
            return IGNORED
        if self._lost(context):
            return Reaction(cancelled=True)
        self._last = position
        if not self._moved:
            travelled = math.dist(position, self._pressed) * context.view_scale
            if travelled < _DRAG_BEGINS_SCREEN_PX:
                return Reaction()
            if self._held == "pinned":
                self._refused = True
                return Reaction()
            self._moved = True
        return Reaction(preview=self._carried(position, modifiers, context))

    def release(self, position: Position, modifiers: Modifiers, context: ToolContext) -> Reaction:
        """End the gesture: one edit, or none when nothing moved."""
        if self.band is not None:
            return self._end_band(position, modifiers, context)
        if self._before is None:
            return IGNORED
        if self._lost(context):
            return Reaction(cancelled=True)
        if self._refused:
            name = next(iter(self._together))[0]
            self._let_go()
            return Reaction(explanation=_pinned_words(context.title(name)))
        edited = self._carried(position, modifiers, context) if self._moved else self._before
        label, snapped = self._label(context), self._snapped
        changed, grabbed = self.inserting or self._moved, self.grabbed
        single = self._held == "points" and not self._moved
        self._let_go()
        if not changed:
            # A click on one of several chosen points means that one.
            return Reaction(select=Selection(*grabbed)) if single and grabbed else Reaction()
        return Reaction(edit=Edit(label, edited, OriginKind.MOVED, snapped))

    def _label(self, context: ToolContext) -> str:
        if self._held == "points":
            return translatable_count(len(self._together), "move {n} point", "move {n} points")
        name = next(iter(self._together))[0] if self.grabbed is None else self.grabbed[0]
        title = context.title(name)
        step = MOVE_ALL if self._held == "element" else INSERT if self.inserting else MOVE
        return step_name(step, title)

    def _end_band(self, position: Position, modifiers: Modifiers, context: ToolContext) -> Reaction:
        begin = self._pressed
        self.band = None
        if math.dist(begin, position) * context.view_scale < _DRAG_BEGINS_SCREEN_PX:
            keep = context.selected_class
            return Reaction(select=Selection(keep)) if context.chosen_points else Reaction()
        inside = points_within(begin, position, context)
        if modifiers.shift:
            inside |= context.chosen_points
        if not inside:
            return Reaction(select=Selection(context.selected_class))
        name, index = min(inside)
        return Reaction(select=Selection(name, index, frozenset(inside)))

    def double_click(
        self, position: Position, modifiers: Modifiers, context: ToolContext
    ) -> Reaction:
        """A second click is a press like any other."""
        return self.press(position, modifiers, context)

    # --- keys -----------------------------------------------------------------------------

    def key(self, name: str, context: ToolContext, *, shift: bool = False) -> Reaction:
        """Delete removes, Enter confirms an unconfirmed element, Escape gives up the
        gesture, then the points, then the element."""
        if name == "Escape":
            return self._escape(context)
        if self.busy:
            return IGNORED
        selected = context.selected_class
        if name == "Enter":
            return confirmation(context)
        chosen = context.chosen_points
        if not chosen:
            if name in ("Delete", "Backspace") and selected is not None:
                return self.delete_element(context)
            return IGNORED
        if name in ("Delete", "Backspace"):
            if len(chosen) == 1:
                return deletion(context, *next(iter(chosen)))
            base = confirmed(context.annotation, chosen)
            edited = editing.delete_points(base, chosen)
            label = translatable_count(len(chosen), "delete {n} point", "delete {n} points")
            return Reaction(edit=Edit(label, edited), select=Selection(selected))
        return IGNORED

    def nudge(self, arrow: str, step: float, context: ToolContext) -> Reaction:
        """Move the chosen points by ``step`` picture px."""
        chosen = context.chosen_points
        if self.busy or not chosen:
            return IGNORED
        return nudged(context, chosen, arrow, step)

    def _escape(self, context: ToolContext) -> Reaction:
        if self.busy:
            inserted = self.inserting
            self._let_go()
            # The point that was selected with the gesture is gone again.
            select = Selection(context.selected_class) if inserted else None
            return Reaction(cancelled=True, select=select)
        if context.selected_point is not None or context.selected_points:
            return Reaction(select=Selection(context.selected_class))
        if context.selected_class is not None:
            return Reaction(select=Selection(None))
        return IGNORED

    def delete_element(self, context: ToolContext) -> Reaction:
        """Remove the selected element."""
        name = context.selected_class
        if name is None or context.polyline(name) is None:
            return IGNORED
        edited = context.annotation.without(name)
        return Reaction(edit=Edit(step_name(DELETE, context.title(name)), edited))

    def finish(self, context: ToolContext) -> Reaction:
        """Drop what is held where it is, before anything that would leave the frame."""
        self.band = None
        return self.release(self._last, Modifiers(ctrl=not self._snapped), context)

    # --- inside ---------------------------------------------------------------------------

    def _carried(
        self, position: Position, modifiers: Modifiers, context: ToolContext
    ) -> FrameAnnotation:
        assert self._before is not None
        self._snapped = frozenset()
        if self.grabbed is None or self._held == "points":
            dx, dy = position[0] - self._pressed[0], position[1] - self._pressed[1]
            width, height = context.picture_size
            base = confirmed(self._before, self._together)
            return editing.move_points(base, self._together, dx / (width - 1), dy / (height - 1))
        x, y = position[0] + self._offset[0], position[1] + self._offset[1]
        base = editing.confirm(self._before, self.grabbed[0])
        direction = self._direction(base, (x, y), context)
        placed = context.snapped(self.grabbed[0], (x, y), modifiers, direction)
        if placed is not None and self._leads_back(placed, (x, y), context):
            placed = None
        point = point_from_px(*(placed if placed is not None else (x, y)), context.picture_size)
        if placed is not None:
            self._snapped = frozenset({point_key(point)})
        return editing.move_point(base, *self.grabbed, point)

    def _leads_back(self, placed: Position, at: Position, context: ToolContext) -> bool:
        """Return whether snapping would take a point back to the line that it is dragged away
        from: it has come farther across that line than along it."""
        assert self._before is not None
        assert self.grabbed is not None
        polyline = None if self.inserting else self._before.get(self.grabbed[0])
        if polyline is None:
            return False
        begin = points_px(polyline, context.picture_size)[self.grabbed[1]]
        return math.dist(placed, begin.tolist()) < math.dist(placed, at)

    def _direction(
        self, annotation: FrameAnnotation, at: Position, context: ToolContext
    ) -> Position | None:
        assert self.grabbed is not None
        name, index = self.grabbed
        polyline = annotation.get(name)
        assert polyline is not None
        points = points_px(polyline, context.picture_size).tolist()
        others: list[Position] = [(x, y) for i, (x, y) in enumerate(points) if i != index]
        if name in context.curved:
            if not 0 < index < len(points) - 1:
                return None
            return line_direction(others[index - 1], others[index])
        if not others:
            return None
        return line_direction(others[0], others[-1]) or line_direction(others[0], at)

    def _let_go(self) -> None:
        self.grabbed = self._found = self._before = self.band = None
        self._together, self._snapped = frozenset(), frozenset()
        self.inserting = self._moved = self._refused = False
        self._held = "point"


def _pinned_words(title: str) -> str:
    return tr(
        "{title} is pinned, so that a slip does not move it: drag its points, or unpin elements"
        " (Ctrl+P, menu Element) to drag it as a whole",
        title=tr(title),
    )
