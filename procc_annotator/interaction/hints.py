"""Status bar hints in two parts: what the next click does, and what at most four keys do.

Keys that do nothing are left out; the sheet of keys (F1) has all of them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from procc_annotator.field.model import Field
from procc_annotator.interaction.draw_tool import DrawTool
from procc_annotator.interaction.edit_tool import FAR_NUDGE_PX, FINE_NUDGE_PX, NUDGE_PX, EditTool
from procc_annotator.interaction.gestures import Hit, ToolContext
from procc_annotator.translation import tr, tr_count, word


@dataclass(frozen=True, slots=True)
class GhostHint:
    """State of the ghosts.

    Attributes:
        current: the class of the one that is examined.
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
KEYS = "    |    "  # before the second part
_MOST_KEYS = 4
_NAMED_AFTER = word("click to draw; choose its class afterwards")


@dataclass(frozen=True, slots=True)
class _HintText:
    """The phrases of a state: tool in hand, effect of a click, effects of keys, the most used
    first; "" for what does nothing.

    Attributes:
        answers: of Enter and Esc.
        more: of further keys.
    """

    tool: str
    click: str
    answers: tuple[str, ...] = ()
    more: tuple[str, ...] = ()

    def __str__(self) -> str:
        keys = [phrase for phrase in (*self.answers, *self.more) if phrase][:_MOST_KEYS]
        return join_hint((self.tool, self.click), keys)


def join_hint(parts: Sequence[str], keys: Sequence[str]) -> str:
    """Return the two parts of a hint as one text."""
    texts = (SEPARATOR.join(filter(None, phrases)) for phrases in (parts, keys))
    return KEYS.join(filter(None, texts))


def status_hint(
    mode: Literal["draw", "edit"],
    draw: DrawTool,
    edit: EditTool,
    context: ToolContext | None,
    field: Field,
    *,
    blocked: str = "",
    over: Hit | None = None,
    blind: bool = False,
    upcoming: str | None = None,
    ghosts: GhostHint = GhostHint(),
) -> str:
    """Say what comes next.

    Args:
        context: None when no frame is open.
        blocked: why the frame cannot be edited; empty when it can.
        over: what is under the cursor in edit mode.
        blind: the projection is hidden until the frame is committed.
        upcoming: the class that is chosen by itself once this one is finished.
        ghosts: how many there are, and which one is examined.
    """
    if context is None:
        return tr("Drop a folder of pictures here, or open one with Ctrl+O")
    walking = ghosts.current is not None or ghosts.coming
    if blocked:
        keys = (tr("Esc goes back"), tr("Tab goes on")) if walking else ()
        return join_hint((tr("READ ONLY"), blocked, _ghost_title(ghosts, field)), keys)
    if ghosts.current is not None and not draw.busy and not edit.busy:
        by_hand = mode == "draw"
        click = tr("click draws it by hand") if by_hand else _click_words(context, field, over)
        words = _ghost_words(ghosts, _ghost_title(ghosts, field), click)
    else:
        words = (
            _draw_words(draw, context, field, upcoming)
            if mode == "draw"
            else _edit_words(edit, context, field, over)
        )
        if not draw.busy and not edit.busy:
            all_too = not context.is_unconfirmed(context.selected_class or "")  # Enter confirms it
            words = _with_ghosts(words, ghosts, field, all_too=all_too)
    if blind:
        commits = tr("Ctrl+Enter commits the frame and shows the projection")
        tool = SEPARATOR.join((tr("BLIND"), words.tool))
        words = replace(words, tool=tool, answers=(*words.answers, commits))
    return str(words)


def _ghost_title(ghosts: GhostHint, field: Field) -> str:
    if ghosts.current is not None:
        return tr("GHOST {title}", title=_title(ghosts.current, field))
    return tr("GHOST the next one comes in a moment") if ghosts.coming else ""


def _with_ghosts(words: _HintText, ghosts: GhostHint, field: Field, *, all_too: bool) -> _HintText:
    if ghosts.coming:
        return _HintText(_ghost_title(ghosts, field), words.click, (tr("Esc goes back"),))
    if not ghosts.count:
        return words
    count = ghosts.count
    tab = (
        tr_count(count, "Tab: next of {n} ghost", "Tab: next of {n} ghosts")
        if ghosts.resumes
        else tr_count(count, "Tab: first of {n} ghost", "Tab: first of {n} ghosts")
    )
    every = tr("Shift+Enter: accept all") if all_too else ""
    return replace(words, more=(tab, every, *words.more))


def _ghost_words(ghosts: GhostHint, title: str, click: str) -> _HintText:
    if ghosts.points is None:
        enter = tr("Enter accepts it")
    elif ghosts.points:
        enter = tr_count(ghosts.points, "Enter accepts {n} point", "Enter accepts {n} points")
    else:
        enter = tr("no line found along it")
    answers = (enter, tr("Tab goes on"), tr(". not visible here"), tr("Esc goes back"))
    return _HintText(title, click, answers)


def _draw_words(
    draw: DrawTool, context: ToolContext, field: Field, upcoming: str | None
) -> _HintText:
    if draw.busy and draw.class_name is not None:
        return _drawing_words(draw, context, field, upcoming)
    if context.selected_class is not None:
        return _chosen_words(context.selected_class, context, field, upcoming)
    if context.unnamed is not None:
        find = tr("/ finds an element")
        return _HintText(tr("DRAW"), tr(_NAMED_AFTER), more=(find, *_snap_words(context)))
    return _HintText(tr("DRAW"), tr("choose an element: field map, list, its key or /"))


def _drawing_words(
    draw: DrawTool, context: ToolContext, field: Field, upcoming: str | None
) -> _HintText:
    count, stay = len(draw.points), tuple[str, ...]()
    if draw.unnamed:
        tool = tr_count(count, "DRAW a line, {n} point", "DRAW a line, {n} points")
        enter = tr("Enter or double-click finishes, then choose the class")
        stay = (tr("an element's key names it"),)
    else:
        title = _title(draw.class_name or "", field)
        tool = tr_count(count, "DRAW {title}, {n} point", "DRAW {title}, {n} points", title=title)
        enter = tr("Enter or double-click finishes")
        if upcoming is not None:
            following = _title(upcoming, field)
            enter = tr("Enter or double-click finishes and goes on to {title}", title=following)
            stay = (tr("Shift+Enter finishes and stays"),)
    last = draw.is_last_click(context)
    click = tr("click adds the second point and finishes") if last else tr("click adds a point")
    back = tr("Backspace removes the last point")
    return _HintText(tool, click, (enter, tr("Esc cancels")), (*stay, back, *_snap_words(context)))


def _chosen_words(
    class_name: str, context: ToolContext, field: Field, upcoming: str | None
) -> _HintText:
    title, count = _title(class_name, field), context.point_count(class_name)
    waiting, spot = context.is_unconfirmed(class_name), class_name in context.spots
    tool = (
        tr("DRAW {title}, unconfirmed", title=title) if waiting else tr("DRAW {title}", title=title)
    )
    enter = tr("Enter confirms it") if waiting else ""
    answers, more = (enter, tr("Esc deselects")), _point_words(context)
    if context.clicked_class is None:
        click = tr("choose it again, then clicks continue it")
        return _HintText(tool, tr(_NAMED_AFTER) if context.unnamed else click, answers, more)
    if spot:
        following = _title(upcoming, field) if upcoming is not None else None
        return _HintText(tool, _placing_words(following, placed=count > 0), answers, more)
    click = (
        tr_count(
            count,
            "click continues it after its {n} point",
            "click continues it after its {n} points",
        )
        if count
        else tr("click starts it")
    )
    return _HintText(tool, click, answers, (*more, *_snap_words(context)))


def _placing_words(following: str | None, *, placed: bool) -> str:
    if following is None:
        return tr("click moves it here") if placed else tr("click marks it")
    if placed:
        return tr("click moves it here and goes on to {title}", title=following)
    return tr("click marks it and goes on to {title}", title=following)


def _snap_words(context: ToolContext) -> tuple[str, ...]:
    return (tr("hold Ctrl: no snapping"),) if context.snap is not None else ()


def _edit_words(edit: EditTool, context: ToolContext, field: Field, over: Hit | None) -> _HintText:
    if edit.busy:
        return _held_words(edit, context, field)
    click, selected = _click_words(context, field, over), context.selected_class
    enter = ""
    if selected is not None and context.is_unconfirmed(selected):
        enter = tr("Enter confirms {title}", title=_title(selected, field))
    if count := len(context.chosen_points):
        lets_go = tr_count(count, "Esc deselects the point", "Esc deselects {n} points")
        return _HintText(tr("EDIT"), click, (enter, lets_go), _point_words(context))
    if selected is None:
        return _HintText(tr("EDIT"), click)
    removes = tuple[str, ...]()
    if context.point_count(selected):
        removes = (tr("Delete removes {title}", title=_title(selected, field)),)
    return _HintText(tr("EDIT"), click, (enter, tr("Esc deselects")), removes)


def _held_words(edit: EditTool, context: ToolContext, field: Field) -> _HintText:
    back = (tr("Esc puts it back"),)
    drops = tr("release drops it here")
    if edit.held == "frame":
        chooses = tr("release selects all points inside")
        return _HintText(tr("EDIT choosing points"), chooses, (tr("Esc cancels"),))
    if edit.held == "points":
        count = len(context.chosen_points)
        return _HintText(tr_count(count, "EDIT {n} point", "EDIT {n} points"), drops, back)
    if edit.grabbed is not None:
        name, index = edit.grabbed
        point = tr("EDIT point {number} of {title}", number=index + 1, title=_title(name, field))
        if edit.inserting:
            back = (tr("Esc removes the new point"),)
        return _HintText(point, drops, back)
    if edit.held == "pinned":
        selects = tr("release selects the element, which is pinned")
        return _HintText(tr("EDIT"), selects, (tr("Esc lets go"),))
    return _HintText(tr("EDIT the element"), drops, back)


def _click_words(context: ToolContext, field: Field, over: Hit | None) -> str:
    if over is not None and over.kind == "point":
        return tr(
            "drag moves point {number} of {title}, Alt+Shift+click removes it",
            number=over.index + 1,
            title=_title(over.class_name, field),
        )
    if over is not None:
        title = _title(over.class_name, field)
        return tr("click selects {title}, Alt+click inserts a point", title=title)
    if not context.annotation.annotated and not context.annotation.unconfirmed:
        return tr("click does nothing: there are no points to edit, draw an element first")
    if context.chosen_points:
        return tr("click a point to drag it, elsewhere to deselect")
    return tr("click or drag a point, drag elsewhere to select several")


def _point_words(context: ToolContext) -> tuple[str, ...]:
    count = len(context.chosen_points)
    if not count:
        return ()
    nudge = tr(
        "arrows nudge {step:g} px, with Shift {fine:g} px, Ctrl {far:g} px",
        step=NUDGE_PX,
        fine=FINE_NUDGE_PX,
        far=FAR_NUDGE_PX,
    )
    return nudge, tr_count(count, "Delete removes the point", "Delete removes {n} points")


def _title(class_name: str, field: Field) -> str:
    return tr(field.title_of(class_name))
