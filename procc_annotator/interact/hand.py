"""How far what is drawn has come, for the cursor to tell."""

from __future__ import annotations

from procc_annotator.interact.draw_tool import DrawTool
from procc_annotator.interact.gesture import ToolContext, Modifiers, Position
from procc_annotator.interact.overlay_shapes import Draft, DraftState, Snap
from procc_annotator.language import tr_count

# So many clicks are enough for points all along the line: see `session.strokes.regularise`.
_STRAIGHT, _CURVE = 2, 5


def draft_with_cursor(
    draw: DrawTool, context: ToolContext, cursor: Position | None, held: Modifiers
) -> Draft | None:
    """The polyline under way, with its line to the cursor and what is told there; before the first
    click what that begins; None where it would begin nothing.

    Args:
        draw: the tool.
        context: what the next click would work on.
        cursor: where it would be.
        held: keys.
    """
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
