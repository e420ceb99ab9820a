"""The sentence in the status bar: what the next click, Enter and Esc will do.

These three come first in every state, since a narrow window shows only the beginning.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from procc_annotator.field.model import Field
from procc_annotator.interact.draw_tool import DrawTool
from procc_annotator.interact.edit_tool import FAR_NUDGE_PX, FINE_NUDGE_PX, NUDGE_PX, EditTool
from procc_annotator.interact.gesture import Context
from procc_annotator.interact.hit import Hit
from procc_annotator.words import count_of


@dataclass(frozen=True, slots=True)
class GhostHint:
    """What there is to know of ghosts.

    Attributes:
        count: how many are shown.
        current: the class of the one that is looked at.
        points: how many points accepting it adds; None while they are looked for.
        resumes: whether the next one is not the first: it comes behind where a walk was left.
        coming: whether a walk waits for the ghosts of a new fit.
    """

    count: int = 0
    current: str | None = None
    points: int | None = None
    resumes: bool = False
    coming: bool = False


SEPARATOR = "  •  "
_ANSWERS = 4  # what is said first: the tool, click, Enter and Esc
_NOTHING_TO_DO = "click, Enter and Esc do nothing yet"


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
    upcoming: str | None = None,
    suggested: str | None = None,
    ghosts: GhostHint = GhostHint(),
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
        upcoming: the class that is chosen by itself once this one is finished.
        suggested: the class to draw next.
        ghosts: how many there are, and which one is looked at.
    """
    if context is None:
        words = ["Drop a folder of pictures here, or open one with Ctrl+O", _NOTHING_TO_DO]
    elif blocked:
        words = ["READ ONLY", blocked, *_blocked_words(ghosts, field)]
    elif ghosts.current is not None and not draw.busy and not edit.busy:
        click = "click begins it by hand" if mode == "draw" else _click_words(context, field, over)
        words = _ghost_words(ghosts, _title(ghosts.current, field), click)
    else:
        if mode == "draw":
            words = _draw_words(draw, context, field, upcoming)
        else:
            words = _edit_words(edit, context, field, over)
        if not draw.busy and not edit.busy:
            all_too = not context.is_unconfirmed(context.selected_class or "")  # Enter confirms it
            words = _with_ghosts(words, ghosts, all_too=all_too)
            if suggested is not None and (mode == "edit" or suggested != context.selected_class):
                following = f"next: {_title(suggested, field)}"
                words = [*words[:_ANSWERS], following, *words[_ANSWERS:]]
    if blind and context is not None and not blocked:
        words = ["BLIND", *words, "Ctrl+Enter commits the frame and shows the projection"]
    return SEPARATOR.join(words)


def _blocked_words(ghosts: GhostHint, field: Field) -> list[str]:
    if ghosts.current is None and not ghosts.coming:
        return [_NOTHING_TO_DO]
    title = _title(ghosts.current, field) if ghosts.current is not None else "the next one comes"
    return [f"GHOST {title}", "click and Enter do nothing", "Esc goes back", "Tab goes on"]


def _with_ghosts(words: list[str], ghosts: GhostHint, *, all_too: bool) -> list[str]:
    """What is to be said of ghosts while none is looked at."""
    if ghosts.coming:
        click = next((w for w in words if w.startswith("click ")), "")
        waiting = ["GHOST the next one comes in a moment", click, "Enter does nothing yet"]
        return [*filter(None, waiting), "Esc goes back"]
    if not ghosts.count:
        return words
    which = "next" if ghosts.resumes else "first"
    tab = f"Tab: {which} of {counted(ghosts.count, 'ghost')}"
    told = [tab, *(["Shift+Enter: accept all"] if all_too else [])]
    return [*words[:_ANSWERS], *told, *words[_ANSWERS:]]


def _ghost_words(ghosts: GhostHint, title: str, click: str) -> list[str]:
    if ghosts.points is None:
        enter = "Enter accepts it"
    elif ghosts.points:
        enter = f"Enter accepts {_points(ghosts.points)}"
    else:
        enter = "Enter does nothing: no line is found along it"
    return [
        f"GHOST {title}",
        click,
        enter,
        "Esc goes back",
        "Tab goes on",
        ". not visible here",
        "Shift+Enter: all",
    ]


def _draw_words(draw: DrawTool, context: Context, field: Field, upcoming: str | None) -> list[str]:
    if draw.busy and draw.class_name is not None:
        last = draw.next_click_finishes(context)
        then = f" and goes on to {_title(upcoming, field)}" if upcoming is not None else ""
        return [
            f"DRAW {_name(draw, field)}, {_points(len(draw.points))}",
            "click adds the second point and finishes" if last else "click adds a point",
            f"Enter or double-click finishes{' and asks its name' if draw.unnamed else then}",
            "Esc cancels",
            *_stay_words(draw, upcoming),
            "Backspace takes back the last point",
            *_snap_words(context),
        ]
    if context.selected_class is None and context.unnamed is not None:
        return [
            "DRAW",
            "click begins a line that is named after",
            "Enter and Esc do nothing yet",
            "or choose its element first: field map, list, its key or /",
            *_snap_words(context),
        ]
    if context.selected_class is None:
        return [
            "DRAW",
            "choose an element: field map, list, its key or /",
            _NOTHING_TO_DO,
        ]
    count = context.point_count(context.selected_class)
    waiting = context.is_unconfirmed(context.selected_class)
    if context.selected_class in context.spots:
        then = f" and goes on to {_title(upcoming, field)}" if upcoming is not None else ""
        return [
            f"DRAW {_title(context.selected_class, field)}{', unconfirmed' if waiting else ''}",
            f"click {'moves it here' if count else 'marks it'}{then}",
            "Enter confirms it" if waiting else "Enter does nothing",
            "Esc deselects",
            *_point_words(context),
        ]
    return [
        f"DRAW {_title(context.selected_class, field)}{', unconfirmed' if waiting else ''}",
        f"click continues it after its {_points(count)}" if count else "click begins it",
        "Enter confirms it" if waiting else "Enter does nothing yet",
        "Esc deselects",
        *_point_words(context),
        *_snap_words(context),
    ]


def _name(draw: DrawTool, field: Field) -> str:
    return "a line" if draw.unnamed else _title(draw.class_name or "", field)


def _stay_words(draw: DrawTool, upcoming: str | None) -> list[str]:
    if draw.unnamed:
        return ["an element's key names it"]
    return ["Shift+Enter finishes and stays"] if upcoming is not None else []


def _snap_words(context: Context) -> list[str]:
    return ["hold Ctrl to click beside the line"] if context.snap is not None else []


def _edit_words(edit: EditTool, context: Context, field: Field, over: Hit | None) -> list[str]:
    if edit.busy and (edit.grabbed is None or edit.held == "points"):
        return _held_words(edit, context)
    if edit.busy and edit.grabbed is not None:
        name, index = edit.grabbed
        return [
            f"EDIT point {index + 1} of {_title(name, field)}",
            "release drops it here",
            "Enter does nothing",
            "Esc takes the new point away" if edit.inserting else "Esc puts it back",
        ]
    words = ["EDIT", _click_words(context, field, over)]
    selected = context.selected_class
    enter = "Enter does nothing"
    if selected is not None and context.is_unconfirmed(selected):
        enter = f"Enter confirms {_title(selected, field)}"
    if count := len(context.chosen_points):
        points = "the point" if count == 1 else _points(count)
        return [*words, enter, f"Esc lets go of {points}", *_point_words(context)]
    if context.selected_class is None:
        return [*words, "Enter and Esc do nothing"]
    words += [enter, "Esc deselects"]
    if context.point_count(context.selected_class):
        words.append(f"Delete removes {_title(context.selected_class, field)}")
    return words


def _held_words(edit: EditTool, context: Context) -> list[str]:
    if edit.held == "frame":
        return [
            "EDIT choosing points",
            "release chooses all points inside",
            "Enter does nothing",
            "Esc gives up",
        ]
    if edit.held == "pinned element":
        return [
            "EDIT",
            "release selects the element, which is pinned",
            "Enter does nothing",
            "Esc lets go",
        ]
    what = "the element" if edit.held != "points" else _points(len(context.chosen_points))
    return [f"EDIT {what}", "release drops it here", "Enter does nothing", "Esc puts it back"]


def _click_words(context: Context, field: Field, over: Hit | None) -> str:
    if over is not None and over.kind == "point":
        place = f"point {over.index + 1} of {_title(over.class_name, field)}"
        return f"drag moves {place}, Alt+Shift+click removes it"
    if over is not None:
        return f"click selects {_title(over.class_name, field)}, Alt+click inserts a point"
    if not context.annotation.annotated and not context.annotation.unconfirmed:
        return "click does nothing: there are no points to edit, draw an element first"
    if context.chosen_points:
        return "click a point to drag it, beside it to let go"
    return "click or drag a point, drag on empty ground to choose several"


def _point_words(context: Context) -> list[str]:
    count = len(context.chosen_points)
    if not count:
        return []
    return [
        f"arrows nudge {NUDGE_PX:g} px, with Shift {FINE_NUDGE_PX:g} px, Ctrl {FAR_NUDGE_PX:g} px",
        "Delete removes the point" if count == 1 else f"Delete removes {count} points",
    ]


def counted(count: int, what: str, several: str = "") -> str:
    """A number and what it counts: "1 point", "2 points", or what is to be said of ``several``."""
    return count_of(count, what, several, thousands=",")


def _points(count: int) -> str:
    return counted(count, "point")


def _title(class_name: str, field: Field) -> str:
    element = field.element(class_name)
    return element.title if element is not None else class_name
