"""The sentence in the status bar: what the next click, Enter and Esc will do."""

from __future__ import annotations

from typing import Literal

from procc_annotator.field.model import Field
from procc_annotator.interact.hit import Hit
from procc_annotator.interact.tools import Context, DrawTool, EditTool

SEPARATOR = "  •  "


def hint(
    mode: Literal["draw", "edit"],
    draw: DrawTool,
    edit: EditTool,
    context: Context | None,
    field: Field,
    *,
    blocked: str = "",
    over: Hit | None = None,
    blind: bool = False,
) -> str:
    """Say what comes next.

    Args:
        mode: the tool in hand.
        draw, edit: the tools.
        context: None when no frame is open.
        field: titles of the classes.
        blocked: why the frame cannot be edited; empty when it can.
        over: what is under the cursor in edit mode.
        blind: the projection is hidden until the frame is committed.
    """
    if context is None:
        return "Drop a folder of pictures here, or open one with Ctrl+O"
    if blocked:
        return f"READ ONLY{SEPARATOR}{blocked}"
    words = (
        _draw_words(draw, context, field)
        if mode == "draw"
        else _edit_words(edit, context, field, over)
    )
    if blind:
        words = ["BLIND", *words, "Ctrl+Enter commits the frame and shows the projection"]
    return SEPARATOR.join(words)


def _draw_words(draw: DrawTool, context: Context, field: Field) -> list[str]:
    if draw.busy and draw.class_name is not None:
        count = len(draw.points)
        return [
            f"DRAW {_title(draw.class_name, field)}, {count} point{'s' if count > 1 else ''}",
            "click adds a point",
            "Enter or double-click finishes",
            "Backspace takes back the last point",
            "Esc cancels",
        ]
    if context.selected_class is None:
        return ["DRAW", "choose an element: field map, list, its key, or / to type its name"]
    known = context.annotation.get(context.selected_class)
    verb = "continues it" if known is not None and known.points else "begins it"
    return [
        f"DRAW {_title(context.selected_class, field)}",
        f"click {verb}",
        "Enter does nothing yet",
        "Esc deselects",
    ]


def _edit_words(edit: EditTool, context: Context, field: Field, over: Hit | None) -> list[str]:
    if edit.busy and edit.grabbed is not None:
        name, index = edit.grabbed
        where = f"point {index + 1} of {_title(name, field)}"
        return [f"EDIT {where}", "release drops it here", "Esc puts it back"]
    words = ["EDIT"]
    if over is not None and over.kind == "point":
        place = f"point {over.index + 1} of {_title(over.class_name, field)}"
        words.append(f"drag moves {place}, Alt+Shift+click removes it")
    elif over is not None:
        words.append(f"click selects {_title(over.class_name, field)}, Alt+click inserts a point")
    else:
        words.append("click or drag a point")
    if context.selected_point is not None:
        words += [
            "arrows nudge 1 px, with Shift 0.1 px",
            "Delete removes the point",
            "Esc deselects",
        ]
    elif context.selected_class is not None:
        title = _title(context.selected_class, field)
        words += [f"Delete removes {title}", "Esc deselects"]
    return words


def _title(class_name: str, field: Field) -> str:
    element = field.element(class_name)
    return element.title if element is not None else class_name
