"""What a hand does, without Qt: one tool draws polylines, one edits them.

A tool gets presses, moves, releases and keys with positions in picture px and answers with a
`Reaction`. Nothing is an edit before a gesture ends; one gesture is one step of the history.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from procc_annotator.annotation import FrameAnnotation, Point, point_from_px, points_px
from procc_annotator.interact.hit import Hit, hit_test
from procc_annotator.interact.overlay import Draft
from procc_annotator.session import edits

Position = tuple[float, float]

_DRAG_BEGINS_SCREEN_PX = 2.0
_STEPS: dict[str, Position] = {"Left": (-1, 0), "Right": (1, 0), "Up": (0, -1), "Down": (0, 1)}
NUDGE_PX, FINE_NUDGE_PX = 1.0, 0.1


@dataclass(frozen=True, slots=True)
class Modifiers:
    """Keys held during a mouse event."""

    alt: bool = False
    shift: bool = False
    ctrl: bool = False


@dataclass(frozen=True, slots=True)
class Context:
    """What a tool may look at.

    Attributes:
        annotation: the finished annotation of the frame.
        picture_size: (width, height) px.
        view_scale: screen px per picture px.
        selected_class, selected_point: the selection.
    """

    annotation: FrameAnnotation
    picture_size: tuple[int, int]
    view_scale: float = 1.0
    selected_class: str | None = None
    selected_point: tuple[str, int] | None = None

    @property
    def chosen_point(self) -> tuple[str, int] | None:
        """The selected point, if the annotation still has it."""
        if self.selected_point is None:
            return None
        name, index = self.selected_point
        return self.selected_point if index < self.point_count(name) else None

    def point_count(self, class_name: str | None) -> int:
        """Points of a class; 0 when it is not annotated."""
        polyline = self.annotation.get(class_name) if class_name is not None else None
        return len(polyline.points) if polyline is not None else 0


@dataclass(frozen=True, slots=True)
class Edit:
    """A finished gesture: its name in the history, and the annotation it leads to."""

    label: str
    annotation: FrameAnnotation


@dataclass(frozen=True, slots=True)
class Selection:
    """What a gesture selects; ``point`` is an index in the class's polyline."""

    class_name: str | None
    point: int | None = None


@dataclass(frozen=True, slots=True)
class Reaction:
    """A tool's answer to an event; what is None stays as it is.

    Attributes:
        edit: the gesture ended with this.
        preview: show this annotation while the gesture goes on.
        cancelled: the gesture was given up; show the finished annotation again.
        select: change the selection.
        message: say this.
        handled: the event meant something to the tool.
    """

    edit: Edit | None = None
    preview: FrameAnnotation | None = None
    cancelled: bool = False
    select: Selection | None = None
    message: str = ""
    handled: bool = True


_IGNORED = Reaction(handled=False)


@dataclass
class DrawTool:
    """Clicks along an element; a class that has points already is continued at its last one."""

    class_name: str | None = None
    points: list[Position] = field(default_factory=list)

    @property
    def busy(self) -> bool:
        """Whether a polyline is under way."""
        return bool(self.points)

    def draft(self, selected_class: str | None, cursor: Position | None) -> Draft | None:
        """What to show: the polyline under way, or the class the next click begins."""
        name = self.class_name if self.busy else selected_class
        return Draft(name, tuple(self.points), cursor) if name is not None else None

    def press(self, position: Position, modifiers: Modifiers, context: Context) -> Reaction:
        """Add a point."""
        if not self.busy:
            if context.selected_class is None:
                return Reaction(message="choose an element first: field map, list, or its key")
            self.class_name = context.selected_class
        self.points.append(position)
        return Reaction()

    def move(self, position: Position, modifiers: Modifiers, context: Context) -> Reaction:
        return _IGNORED

    def release(self, position: Position, modifiers: Modifiers, context: Context) -> Reaction:
        return _IGNORED

    def double_click(self, position: Position, modifiers: Modifiers, context: Context) -> Reaction:
        """Finish: the first click of the two has already added its point."""
        return self.finish(context) if self.busy else self.press(position, modifiers, context)

    def key(self, name: str, context: Context, *, shift: bool = False) -> Reaction:
        """Enter finishes, Backspace takes back the last point, Escape cancels, then deselects."""
        if name == "Escape" and not self.busy and context.selected_class is not None:
            return Reaction(select=Selection(None))
        if not self.busy:
            return _IGNORED
        if name == "Enter":
            return self.finish(context)
        if name == "Backspace":
            self.points.pop()
            return Reaction()
        if name == "Escape":
            self.points.clear()
            return Reaction(cancelled=True)
        return _IGNORED

    def finish(self, context: Context) -> Reaction:
        """Make what was clicked an edit; also used before anything that would leave the frame."""
        if not self.busy or self.class_name is None:
            return _IGNORED
        name = self.class_name
        points = [point_from_px(x, y, context.picture_size) for x, y in self.points]
        self.points.clear()
        verb = "continue" if context.point_count(name) else "draw"
        edited = edits.append_points(context.annotation, name, points)
        return Reaction(edit=Edit(f"{verb} {name.strip()}", edited), select=Selection(name))


@dataclass
class EditTool:
    """Moves, inserts and removes single points; elements as a whole stay where they are."""

    grabbed: tuple[str, int] | None = None
    _pressed: Position = (0.0, 0.0)
    _last: Position = (0.0, 0.0)
    _offset: Position = (0.0, 0.0)
    _found: FrameAnnotation | None = None
    _before: FrameAnnotation | None = None
    _inserted: bool = False
    _moved: bool = False

    @property
    def busy(self) -> bool:
        """Whether a point is held."""
        return self.grabbed is not None

    @property
    def inserting(self) -> bool:
        """Whether the held point is a new one."""
        return self._inserted

    def hover(self, position: Position, context: Context) -> Hit | None:
        """What the next press would take."""
        return hit_test(
            context.annotation,
            context.picture_size,
            position,
            context.view_scale,
            prefer=context.selected_class,
        )

    def press(self, position: Position, modifiers: Modifiers, context: Context) -> Reaction:
        """Take, insert (Alt on a segment), remove (Alt+Shift on a point), or deselect a point."""
        hit = self.hover(position, context)
        if hit is None:
            keep = context.selected_class
            return Reaction(select=Selection(keep)) if context.selected_point else _IGNORED
        if modifiers.alt and modifiers.shift:
            if hit.kind != "point":
                return Reaction(select=Selection(hit.class_name))
            return _deletion(context.annotation, hit.class_name, hit.index)
        if hit.kind == "point":
            return self._grab(hit, hit.index, position, context, context.annotation)
        if modifiers.alt:
            point = point_from_px(*hit.foot, context.picture_size)
            edited = edits.insert_point(context.annotation, hit.class_name, hit.index + 1, point)
            taken = self._grab(hit, hit.index + 1, position, context, edited)
            self._inserted = True
            return Reaction(preview=edited, select=taken.select)
        return Reaction(select=Selection(hit.class_name))

    def _grab(
        self, hit: Hit, index: int, position: Position, context: Context, before: FrameAnnotation
    ) -> Reaction:
        self._let_go()
        self.grabbed = (hit.class_name, index)
        self._found, self._before = context.annotation, before
        self._pressed = self._last = position
        self._offset = (hit.foot[0] - position[0], hit.foot[1] - position[1])
        return Reaction(select=Selection(hit.class_name, index))

    def _lost(self, context: Context) -> bool:
        """Let go when undo or a reload changed the frame under the held point: carrying on would
        bring back what was just taken away."""
        if context.annotation == self._found:
            return False
        self._let_go()
        return True

    def move(self, position: Position, modifiers: Modifiers, context: Context) -> Reaction:
        """Carry the held point along; it keeps its distance to the cursor."""
        if self.grabbed is None or self._before is None:
            return _IGNORED
        if self._lost(context):
            return Reaction(cancelled=True)
        self._last = position
        if not self._moved:
            travelled = math.dist(position, self._pressed) * context.view_scale
            if travelled < _DRAG_BEGINS_SCREEN_PX:
                return Reaction()
            self._moved = True
        return Reaction(preview=self._carried(position, context))

    def release(self, position: Position, modifiers: Modifiers, context: Context) -> Reaction:
        """End the gesture: one edit, or none when nothing moved."""
        if self.grabbed is None or self._before is None:
            return _IGNORED
        if self._lost(context):
            return Reaction(cancelled=True)
        name = self.grabbed[0].strip()
        edited = self._carried(position, context) if self._moved else self._before
        inserted, changed = self._inserted, self._inserted or self._moved
        self._let_go()
        if not changed:
            return Reaction()
        return Reaction(edit=Edit(f"{'insert a point in' if inserted else 'move'} {name}", edited))

    def double_click(self, position: Position, modifiers: Modifiers, context: Context) -> Reaction:
        """A second click is a press like any other."""
        return self.press(position, modifiers, context)

    def key(self, name: str, context: Context, *, shift: bool = False) -> Reaction:
        """Delete removes, arrows nudge, Escape gives up the gesture, then the selection."""
        if name == "Escape":
            if self.busy:
                self._let_go()
                return Reaction(cancelled=True)
            if context.selected_point is not None:
                return Reaction(select=Selection(context.selected_class))
            if context.selected_class is not None:
                return Reaction(select=Selection(None))
            return _IGNORED
        if self.busy:
            return _IGNORED
        if context.chosen_point is None:
            if name in ("Delete", "Backspace") and context.selected_class is not None:
                return self.delete_element(context)
            return _IGNORED
        if name in ("Delete", "Backspace"):
            return _deletion(context.annotation, *context.chosen_point)
        if name in _STEPS:
            return _nudge(context, *context.chosen_point, name, fine=shift)
        return _IGNORED

    def delete_element(self, context: Context) -> Reaction:
        """Remove the selected element with all its points."""
        name = context.selected_class
        if name is None or context.annotation.get(name) is None:
            return _IGNORED
        edited = edits.delete_element(context.annotation, name)
        return Reaction(edit=Edit(f"delete {name.strip()}", edited))

    def finish(self, context: Context) -> Reaction:
        """Drop the held point where it is, before anything that would leave the frame."""
        return self.release(self._last, Modifiers(), context)

    def _carried(self, position: Position, context: Context) -> FrameAnnotation:
        assert self.grabbed is not None
        assert self._before is not None
        x, y = position[0] + self._offset[0], position[1] + self._offset[1]
        point = point_from_px(x, y, context.picture_size)
        return edits.move_point(self._before, *self.grabbed, point)

    def _let_go(self) -> None:
        self.grabbed = self._found = self._before = None
        self._inserted = self._moved = False


def _deletion(annotation: FrameAnnotation, class_name: str, index: int) -> Reaction:
    edited = edits.delete_point(annotation, class_name, index)
    left = edited.get(class_name)
    after = min(index, len(left.points) - 1) if left is not None else None
    label = f"delete point {index + 1} of {class_name.strip()}"
    return Reaction(edit=Edit(label, edited), select=Selection(class_name, after))


def _nudge(context: Context, class_name: str, index: int, key: str, *, fine: bool) -> Reaction:
    polyline = context.annotation.get(class_name)
    assert polyline is not None  # it has the chosen point
    x, y = points_px(polyline, context.picture_size)[index]
    step = FINE_NUDGE_PX if fine else NUDGE_PX
    dx, dy = _STEPS[key]
    moved: Point = point_from_px(x + dx * step, y + dy * step, context.picture_size)
    edited = edits.move_point(context.annotation, class_name, index, moved)
    return Reaction(edit=Edit(f"nudge {class_name.strip()}", edited))
