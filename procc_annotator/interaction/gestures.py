"""Context, hit test, reactions and edits of gestures; undo steps; edits of selected points."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, points_px
from procc_annotator.arrays import FloatArray, IntArray
from procc_annotator.dataset import editing
from procc_annotator.dataset.editing import PointRef
from procc_annotator.dataset.records import OriginKind, PointKey
from procc_annotator.interaction.palette import PICK_RADIUS_PX
from procc_annotator.translation import translatable, translatable_count, word

_SAME_PX = 0.5


@dataclass(frozen=True, slots=True)
class Hit:
    """A target under the cursor.

    Attributes:
        kind: ``point``, or ``segment`` between ``index`` and ``index + 1``.
        distance_screen: screen px from the cursor.
        foot: nearest position on the target, picture px.
    """

    class_name: str
    kind: Literal["point", "segment"]
    index: int
    distance_screen: float
    foot: tuple[float, float]


def hit_test(
    annotation: FrameAnnotation,
    picture_size: tuple[int, int],
    position: tuple[float, float],
    view_scale: float,
    *,
    prefer: str | None = None,
) -> Hit | None:
    """The nearest point within the pick radius, else the nearest segment within it.

    Args:
        picture_size: (width, height) px.
        position: cursor, picture px.
        view_scale: screen px per picture px; the radius does not shrink or grow with zoom.
        prefer: this class wins where two targets are equally near (crossing elements share points).
    """
    points, owners, starts = _all_points(annotation, picture_size)
    if not len(points):
        return None
    names = [p.class_name for p in annotation.polylines]
    cursor = np.array(position, dtype=np.float64)
    preferred = names.index(prefer) if prefer in names else -1

    def nearest(feet: FloatArray, rows: IntArray, kind: Literal["point", "segment"]) -> Hit | None:
        away = np.hypot(feet[:, 0] - cursor[0], feet[:, 1] - cursor[1]) * view_scale
        near = np.flatnonzero(away <= PICK_RADIUS_PX)
        if not len(near):
            return None
        best = near[np.argmin(away[near] - _SAME_PX * (owners[rows[near]] == preferred))]
        row = rows[best]
        owner = owners[row]
        x, y = feet[best].tolist()
        return Hit(names[owner], kind, int(row - starts[owner]), float(away[best]), (x, y))

    found = nearest(points, np.arange(len(points)), "point")
    if found is not None:
        return found
    first = np.flatnonzero(owners[1:] == owners[:-1])
    return nearest(closest_on_segments(points[first], points[first + 1], cursor), first, "segment")


def _all_points(
    annotation: FrameAnnotation, picture_size: tuple[int, int]
) -> tuple[FloatArray, IntArray, IntArray]:
    counts = np.array([len(p.points) for p in annotation.polylines], dtype=np.intp)
    flat = [c for polyline in annotation.polylines for point in polyline.points for c in point[:2]]
    points = np.array(flat, dtype=np.float64).reshape(-1, 2)
    points *= (picture_size[0] - 1, picture_size[1] - 1)
    return points, np.repeat(np.arange(len(counts)), counts), np.cumsum(counts) - counts


def closest_on_segments(begin: FloatArray, end: FloatArray, cursor: FloatArray) -> FloatArray:
    """(n, 2) the position on each segment nearest to the cursor."""
    step = end - begin
    squared = np.maximum((step * step).sum(axis=1), 1e-12)
    along = ((cursor - begin) * step).sum(axis=1) / squared
    feet: FloatArray = begin + np.clip(along, 0.0, 1.0)[:, None] * step
    return feet


def step_name(text: str, title: str) -> str:
    """Name of an undo step about an element: a `word` with ``{title}``."""
    return translatable(text, title=translatable(title))


DRAW, CONTINUE, CONFIRM = word("draw {title}"), word("continue {title}"), word("confirm {title}")
MOVE, MOVE_ALL, NUDGE = word("move {title}"), word("move all of {title}"), word("nudge {title}")
INSERT, DELETE = word("insert a point in {title}"), word("delete {title}")


Position = tuple[float, float]

# A class, a position and the element's direction there (None: unknown) to the centre of its paint,
# or None.
Snapper = Callable[[str, Position, Position | None], Position | None]

# Where each arrow key goes.
ARROWS: dict[str, Position] = {
    "Left": (-1, 0),  # not shown
    "Right": (1, 0),  # not shown
    "Up": (0, -1),
    "Down": (0, 1),  # not shown
}

_LONG_ENOUGH_PX = 30.0  # two clicks nearer than this do not tell a line's direction


@dataclass(frozen=True, slots=True)
class Modifiers:
    """Keys held during a mouse event."""

    alt: bool = False
    shift: bool = False
    ctrl: bool = False


@dataclass(frozen=True, slots=True)
class ToolContext:
    """Input of a tool.

    Attributes:
        annotation: the finished annotation of the frame.
        picture_size: (width, height) px.
        view_scale: screen px per picture px.
        selected_class, selected_point: the selection.
        selected_points: all selected points, when there are several.
        curved: classes that are no straight lines; their direction changes along them.
        snap: finds the centre of a class's paint near a position; None: snapping is off.
        pinned: elements as a whole cannot be dragged.
        is_two_point_element: a straight element is finished by its second click.
        title: what people call a class.
        spots: classes that are single places: one click annotates them, and no line is near.
        unnamed: the class of a line that is named after it was drawn; None: classes come first.
        continues: whether clicks add to the points the selected element has.
    """

    annotation: FrameAnnotation
    picture_size: tuple[int, int]
    view_scale: float = 1.0
    selected_class: str | None = None
    selected_point: PointRef | None = None
    selected_points: frozenset[PointRef] = frozenset()
    curved: frozenset[str] = frozenset()
    snap: Snapper | None = None
    pinned: bool = True
    is_two_point_element: bool = False
    title: Callable[[str], str] = str.strip
    spots: frozenset[str] = frozenset()
    unnamed: str | None = None
    continues: bool = False

    @property
    def clicked_class(self) -> str | None:
        """The class that clicks begin or continue: never one that is finished or copied, unless it
        was chosen to be continued."""
        name = self.selected_class
        return name if self.continues or self.polyline(name) is None else None

    @property
    def chosen_points(self) -> frozenset[PointRef]:
        """All selected points that the annotation still has."""
        chosen = self.selected_points
        if self.selected_point is not None:
            chosen |= {self.selected_point}
        return frozenset(ref for ref in chosen if self._exists(ref))

    def polyline(self, class_name: str | None) -> Polyline | None:
        """A class's polyline, confirmed or not."""
        if class_name is None:
            return None
        found = self.annotation.get(class_name)
        return found if found is not None else self.annotation.get_unconfirmed(class_name)

    def point_count(self, class_name: str | None) -> int:
        """Points of a class; 0 when it has none."""
        polyline = self.polyline(class_name)
        return len(polyline.points) if polyline is not None else 0

    def is_unconfirmed(self, class_name: str) -> bool:
        """Return whether no one has decided yet where this element is."""
        return self.annotation.get_unconfirmed(class_name) is not None

    def _exists(self, ref: PointRef | None) -> bool:
        return ref is not None and ref[1] < self.point_count(ref[0])

    def snapped(
        self, class_name: str, position: Position, modifiers: Modifiers, direction: Position | None
    ) -> Position | None:
        """The line's centre near a position; None without a line, for a class that has none, or
        while Ctrl suspends it."""
        if self.snap is None or modifiers.ctrl or class_name in self.spots:
            return None
        return self.snap(class_name, position, direction)


@dataclass(frozen=True, slots=True)
class Edit:
    """A finished gesture: its name in the history, and the annotation it leads to.

    ``kind`` says how its new points came to be; those in ``snapped`` were put on a line's centre.
    """

    label: str
    annotation: FrameAnnotation
    kind: OriginKind = OriginKind.CLICKED
    snapped: frozenset[PointKey] = frozenset()


@dataclass(frozen=True, slots=True)
class Selection:
    """Selection by a gesture; ``point`` is an index in the class's polyline."""

    class_name: str | None
    point: int | None = None
    points: frozenset[PointRef] = frozenset()


@dataclass(frozen=True, slots=True)
class Reaction:
    """A tool's answer to an event; None leaves a value as it is.

    Attributes:
        edit: the gesture ended with this.
        preview: show this annotation while the gesture goes on.
        cancelled: the gesture was given up; show the finished annotation again.
        explanation: why nothing happened; said where it cannot be missed the first time.
        finished: an element was finished by hand: the next one may be offered.
        completed: the element that was finished or confirmed by hand.
        to_name: the class of a line that was finished and has no name yet.
        handled: the event meant something to the tool.
    """

    edit: Edit | None = None
    preview: FrameAnnotation | None = None
    cancelled: bool = False
    select: Selection | None = None
    message: str = ""
    explanation: str = ""
    finished: bool = False
    completed: str | None = None
    to_name: str | None = None
    handled: bool = True


IGNORED = Reaction(handled=False)


def confirmation(context: ToolContext) -> Reaction:
    """Confirm the selected element if it is unconfirmed, and go on to the next such one."""
    name = context.selected_class
    if name is None or not context.is_unconfirmed(name):
        return IGNORED
    edited = editing.confirm(context.annotation, name)
    label = step_name(CONFIRM, context.title(name))
    return Reaction(
        edit=Edit(label, edited, OriginKind.COPIED),
        select=Selection(next_unconfirmed(context) or name),
        finished=not edited.unconfirmed,
        completed=name,
    )


def next_unconfirmed(context: ToolContext) -> str | None:
    """The unconfirmed element that comes after the selected one, round and round."""
    names = [p.class_name for p in context.annotation.unconfirmed]
    at = names.index(context.selected_class) if context.selected_class in names else -1
    others = [*names[at + 1 :], *names[: max(at, 0)]]
    return others[0] if others else None


def line_direction(begin: Position, end: Position) -> Position | None:
    """Unit direction from one position to another; None when they are too near to say."""
    length = math.dist(begin, end)
    if length < _LONG_ENOUGH_PX:
        return None
    return (end[0] - begin[0]) / length, (end[1] - begin[1]) / length


def point_key(point: Point) -> PointKey:
    """A point's identity within its frame."""
    return point.u, point.v


def confirmed(annotation: FrameAnnotation, chosen: frozenset[PointRef]) -> FrameAnnotation:
    """An annotation with the elements of some points confirmed."""
    for name in sorted({name for name, _ in chosen}):
        annotation = editing.confirm(annotation, name)
    return annotation


def toggled(ref: PointRef, context: ToolContext) -> Reaction:
    """One more point is chosen, or one fewer."""
    chosen = context.chosen_points ^ {ref}
    if not chosen:
        return Reaction(select=Selection(ref[0]))
    name, index = ref if ref in chosen else min(chosen)
    return Reaction(select=Selection(name, index, frozenset(chosen)))


def points_within(begin: Position, end: Position, context: ToolContext) -> set[PointRef]:
    """The points in a rectangle, of unconfirmed elements too."""
    left, right = sorted((begin[0], end[0]))
    top, bottom = sorted((begin[1], end[1]))
    inside: set[PointRef] = set()
    for polyline in (*context.annotation.polylines, *context.annotation.unconfirmed):
        for i, (x, y) in enumerate(points_px(polyline, context.picture_size).tolist()):
            if left <= x <= right and top <= y <= bottom:
                inside.add((polyline.class_name, i))
    return inside


def deletion(context: ToolContext, class_name: str, index: int) -> Reaction:
    """A point goes; the next one of its element is chosen."""
    base = editing.confirm(context.annotation, class_name)
    edited = editing.delete_point(base, class_name, index)
    left = edited.get(class_name)
    after = min(index, len(left.points) - 1) if left is not None else None
    title = translatable(context.title(class_name))
    label = translatable("delete point {number} of {title}", number=index + 1, title=title)
    return Reaction(edit=Edit(label, edited), select=Selection(class_name, after))


def nudged(context: ToolContext, chosen: frozenset[PointRef], arrow: str, step: float) -> Reaction:
    """The chosen points go one step of an arrow, picture px."""
    width, height = context.picture_size
    dx, dy = ARROWS[arrow]
    base = confirmed(context.annotation, chosen)
    edited = editing.move_points(base, chosen, dx * step / (width - 1), dy * step / (height - 1))
    names = {name for name, _ in chosen}
    label = (
        step_name(NUDGE, context.title(next(iter(names))))
        if len(names) == 1
        else translatable_count(len(chosen), "nudge {n} point", "nudge {n} points")
    )
    return Reaction(edit=Edit(label, edited, OriginKind.MOVED))
