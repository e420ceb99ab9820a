"""Drawing tool: clicks along an element snapped to its line, and the cursor state."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from procc_annotator.annotation import FrameAnnotation, Point, point_from_px, points_px
from procc_annotator.dataset import editing
from procc_annotator.dataset.records import PointKey
from procc_annotator.interaction.class_choice import UNNAMED
from procc_annotator.interaction.gestures import (
    CONTINUE,
    DRAW,
    IGNORED,
    MOVE,
    Edit,
    Modifiers,
    Position,
    Reaction,
    Selection,
    ToolContext,
    confirmation,
    line_direction,
    point_key,
    step_name,
)
from procc_annotator.interaction.overlay_primitives import NO_DRAFT_STATE, Draft, DraftState, Snap
from procc_annotator.interaction.palette import PICK_RADIUS_PX
from procc_annotator.translation import tr, tr_count


@dataclass
class DrawTool:
    """Clicks along an element; one that has points already is continued at its last one if the user
    chose it for that.

    Continuing an unconfirmed element confirms it.
    """

    class_name: str | None = None
    points: list[Position] = field(default_factory=list)
    unnamed: bool = False  # what is drawn is to be named after
    _snapped: set[Position] = field(default_factory=set)
    _spot_placed: bool = False  # by the click before, which a double click would repeat
    _first: Position | None = None  # where the first click was meant, if it may be snapped again
    # What Escape cancelled: the annotation by then, and the points.
    _cancelled: tuple[FrameAnnotation, list[Position]] | None = None

    @property
    def busy(self) -> bool:
        """Return whether a polyline is under way."""
        return bool(self.points)

    def draft(
        self,
        selected_class: str | None,
        cursor: Position | None,
        landing: Position | None = None,
        hand: DraftState = NO_DRAFT_STATE,
    ) -> Draft | None:
        """Return what to show: the polyline under way, or the class the next click begins."""
        name = self.class_name if self.busy else selected_class
        if name is None:
            return None
        return Draft(name, tuple(self.points), cursor, landing, hand)

    def landing(
        self, position: Position, modifiers: Modifiers, context: ToolContext
    ) -> Position | None:
        """Return where a click here would be put by snapping; None: exactly here."""
        name = self.class_name if self.busy else context.clicked_class
        if name is None:
            return None
        direction = self._direction(name, position, context)
        return context.snapped(name, position, modifiers, direction)

    def press(self, position: Position, modifiers: Modifiers, context: ToolContext) -> Reaction:
        """Add a point; the first one finishes a spot, the second one a straight element where that
        is wanted."""
        self._spot_placed, self._cancelled = False, None
        if not self.busy:
            if context.clicked_class is None and self._take_up(position, context):
                edited = context.annotation.without(self.class_name or "")
                label = step_name(CONTINUE, context.title(self.class_name or ""))
                return Reaction(edit=Edit(label, edited), select=Selection(None))
            begun = context.clicked_class or context.unnamed
            if begun is None:
                return Reaction(message=tr("choose an element first: field map, list, or its key"))
            self.class_name, self.unnamed = begun, context.clicked_class is None
            if self.class_name in context.spots:
                return self._place(self.class_name, position, context)
        placed = self.landing(position, modifiers, context)
        if not self.points:
            self._first = None if modifiers.ctrl else position
        elif len(self.points) == 1:
            self._snap_first_again(position, context)
        if placed is not None:
            self._snapped.add(placed)
        self.points.append(placed if placed is not None else position)
        if len(self.points) == 2 and self._ends_with_second(context):
            return self.finish(context, finished=True)
        return Reaction(select=Selection(None)) if self.unnamed else Reaction()

    def move(self, position: Position, modifiers: Modifiers, context: ToolContext) -> Reaction:
        return IGNORED

    def release(self, position: Position, modifiers: Modifiers, context: ToolContext) -> Reaction:
        return IGNORED

    def double_click(
        self, position: Position, modifiers: Modifiers, context: ToolContext
    ) -> Reaction:
        """Finish: the first click of the two has already added its point."""
        if self._spot_placed:
            self._spot_placed = False
            return IGNORED  # the first of the two clicks was all that there is to do
        if self.busy:
            return self.finish(context, finished=True)
        if context.is_two_point_element:
            return IGNORED  # the first of the two clicks has just finished the element
        return self.press(position, modifiers, context)

    def key(self, name: str, context: ToolContext, *, shift: bool = False) -> Reaction:
        """Enter finishes (with Shift: and stays with this element) or confirms an unconfirmed
        element, Backspace removes the last point, Escape cancels, then deselects."""
        if not self.busy:
            if context.selected_class is None:
                return IGNORED
            if name == "Escape":
                return Reaction(select=Selection(None))
            return confirmation(context) if name == "Enter" else IGNORED
        if name == "Enter":
            return self.finish(context, finished=not shift)
        if name == "Backspace":
            self.points.pop()
            return Reaction()
        if name == "Escape":
            self._cancelled = context.annotation, self.points
            self.points = []
            return Reaction(cancelled=True)
        return IGNORED

    def restore(self, context: ToolContext) -> Reaction:
        """Take the points back that Escape cancelled, unless something was done since."""
        annotation, points = self._cancelled or (None, [])
        self._cancelled = None
        if self.busy or not points or annotation is not context.annotation:
            return IGNORED
        self.points = points
        return Reaction(select=Selection(None if self.unnamed else self.class_name))

    def finish(self, context: ToolContext, *, finished: bool = False) -> Reaction:
        """Make what was clicked an edit; also used before anything that would leave the frame."""
        if not self.busy or self.class_name is None:
            return IGNORED
        name = self.class_name
        points, snapped = self.drawn(context)
        self.points.clear()
        self._snapped.clear()
        goes_on, title = context.polyline(name) is not None, context.title(name)
        edited = editing.append_points(editing.confirm(context.annotation, name), name, points)
        label = step_name(CONTINUE if goes_on else DRAW, title)
        edit = Edit(label, edited, snapped=snapped)
        if self.unnamed:
            asked = name if finished else None
            return Reaction(edit=edit, select=Selection(name), completed=name, to_name=asked)
        return Reaction(edit=edit, select=Selection(name), finished=finished, completed=name)

    def drawn(self, context: ToolContext) -> tuple[tuple[Point, ...], frozenset[PointKey]]:
        """The points under way, and those of them that were put on a line's centre."""
        points = tuple(point_from_px(x, y, context.picture_size) for x, y in self.points)
        on_line = zip(points, self.points, strict=True)
        return points, frozenset(point_key(q) for q, p in on_line if p in self._snapped)

    def call(self, name: str) -> bool:
        """Give what is under way its name; False for what has one, or is named already."""
        if not self.busy or not self.unnamed:
            return False
        self.class_name, self.unnamed = name, False
        return True

    def _take_up(self, position: Position, context: ToolContext) -> bool:
        """Go on with an unnamed line that waits unfinished, at its end at a position; False where
        there is none."""
        for waiting in context.annotation.unconfirmed:
            points = [(x, y) for x, y in points_px(waiting, context.picture_size).tolist()]
            ends = [math.dist(position, points[end]) * context.view_scale for end in (0, -1)]
            if waiting.class_name.startswith(UNNAMED) and min(ends) <= PICK_RADIUS_PX:
                self.points = points if ends[1] <= ends[0] else points[::-1]
                self.class_name, self.unnamed, self._first = waiting.class_name, True, None
                return True
        return False

    def _place(self, name: str, position: Position, context: ToolContext) -> Reaction:
        """A single place: where it was clicked before it is no more."""
        self._spot_placed = True
        moves, title = context.polyline(name) is not None, context.title(name)
        point = point_from_px(*position, context.picture_size)
        confirmed = editing.confirm(context.annotation, name)
        drawn = confirmed.get(name)
        if drawn is not None and len(drawn.points) == 1:
            edited = editing.move_point(confirmed, name, 0, point)
        else:
            edited = editing.set_points(confirmed, name, [point])
        label = step_name(MOVE if moves else DRAW, title)
        edit = Edit(label, edited)
        return Reaction(edit=edit, select=Selection(name), finished=True, completed=name)

    def is_last_click(self, context: ToolContext) -> bool:
        """Return whether another click would finish the element by itself."""
        return len(self.points) == 1 and self._ends_with_second(context)

    def _ends_with_second(self, context: ToolContext) -> bool:
        """Return whether the second point finishes what is drawn: a new straight element."""
        name = self.class_name
        is_new = name not in context.curved and context.polyline(name) is None
        return context.is_two_point_element and not self.unnamed and is_new  # unnamed: maybe curved

    def _snap_first_again(self, second: Position, context: ToolContext) -> None:
        """Only now is a straight element's direction known, which finds its line more surely."""
        name = self.class_name
        if self._first is None or name is None or self.unnamed or name in context.curved:
            return
        if context.polyline(name) is not None:  # its earlier points told the direction
            return
        direction = line_direction(self._first, second)
        if direction is None:
            return
        placed = context.snapped(name, self._first, Modifiers(), direction)
        if placed is not None:
            self._snapped.discard(self.points[0])
            self._snapped.add(placed)
            self.points[0] = placed

    def _direction(self, name: str, position: Position, context: ToolContext) -> Position | None:
        if name in context.curved or self.unnamed:
            return None
        drawn = context.polyline(name)
        earlier = points_px(drawn, context.picture_size).tolist() if drawn is not None else []
        line: list[Position] = [*((x, y) for x, y in earlier), *self.points]
        if not line:
            return None
        # With one point, the line from it to this click is as good as two points.
        return line_direction(line[0], line[-1]) or line_direction(line[0], position)


# So many clicks are enough for points all along the line: see `assist.regularise`.
_STRAIGHT, _CURVE = 2, 5


def draft_with_cursor(
    draw: DrawTool, context: ToolContext, cursor: Position | None, held: Modifiers
) -> Draft | None:
    """The polyline under way, with its line to the cursor and what is reported there; before the
    first click what that begins; None where it would begin nothing."""
    name = draw.class_name if draw.busy else context.clicked_class
    if name is None or cursor is None:
        return draw.draft(context.clicked_class, cursor)
    landing = draw.landing(cursor, held, context)
    hand = _draft_state(name, len(draw.points), context, landing, suspended=held.ctrl)
    return draw.draft(context.clicked_class, cursor, landing, hand)


def _draft_state(
    class_name: str, drawn: int, context: ToolContext, landing: Position | None, *, suspended: bool
) -> DraftState:
    points = drawn + context.point_count(class_name)
    if class_name in context.spots:
        return DraftState(points, max(0, 1 - points))
    snap: Snap = "found" if landing is not None else "none"
    if context.snap is None or suspended:
        snap = "off"
    needed = _CURVE if class_name in context.curved else _STRAIGHT
    return DraftState(points, max(0, needed - points), snap)


def draft_words(hand: DraftState) -> str:
    """The same in words."""
    if hand.missing:
        return tr_count(hand.missing, "{n} to go", "{n} to go")
    return tr_count(hand.points, "{n} point", "{n} points")
