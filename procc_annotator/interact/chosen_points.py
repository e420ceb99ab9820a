"""What is done to points that are chosen, one or several."""

from __future__ import annotations

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.interact import step_names
from procc_annotator.interact.gesture import ARROWS, ToolContext, Edit, Position, Reaction, Selection
from procc_annotator.session.dataset import edits
from procc_annotator.session.dataset.edits import PointRef
from procc_annotator.session.facts.origins import OriginKind


def confirmed(annotation: FrameAnnotation, chosen: frozenset[PointRef]) -> FrameAnnotation:
    """An annotation with the elements of some points confirmed."""
    for name in sorted({name for name, _ in chosen}):
        annotation = edits.confirm(annotation, name)
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
    base = edits.confirm(context.annotation, class_name)
    edited = edits.delete_point(base, class_name, index)
    left = edited.get(class_name)
    after = min(index, len(left.points) - 1) if left is not None else None
    label = step_names.deleting_point(index + 1, context.title(class_name))
    return Reaction(edit=Edit(label, edited), select=Selection(class_name, after))


def nudged(context: ToolContext, chosen: frozenset[PointRef], arrow: str, step: float) -> Reaction:
    """The chosen points go one step of an arrow, picture px."""
    width, height = context.picture_size
    dx, dy = ARROWS[arrow]
    base = confirmed(context.annotation, chosen)
    edited = edits.move_points(base, chosen, dx * step / (width - 1), dy * step / (height - 1))
    names = {name for name, _ in chosen}
    label = (
        step_names.nudging(context.title(next(iter(names))))
        if len(names) == 1
        else step_names.nudging_points(len(chosen))
    )
    return Reaction(edit=Edit(label, edited, OriginKind.MOVED))
