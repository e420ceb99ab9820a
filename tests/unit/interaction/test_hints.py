"""The status bar says what a click does, and promises only keys that do something."""

import copy
from dataclasses import dataclass, field, replace

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.field.load import load_field
from procc_annotator.interaction.draw_tool import DrawTool
from procc_annotator.interaction.edit_tool import EditTool
from procc_annotator.interaction.gestures import Hit, Modifiers, ToolContext
from procc_annotator.interaction.hints import KEYS, SEPARATOR, GhostHint, status_hint

FIELD = load_field()
SIZE = (1280, 720)
NAME = "Middle line"
LINE = FrameAnnotation((Polyline(NAME, (Point(0.1, 0.1), Point(0.5, 0.5), Point(0.9, 0.2))),))

NOTHING = ToolContext(FrameAnnotation(), SIZE)
FREE = ToolContext(LINE, SIZE)
CHOSEN = replace(FREE, selected_class=NAME)
POINT = replace(CHOSEN, selected_point=(NAME, 1))
OVER_POINT = Hit(NAME, "point", 1, 2.0, (600.0, 300.0))
OVER_SEGMENT = Hit(NAME, "segment", 1, 2.0, (600.0, 300.0))


def dragging(*, new: bool = False) -> EditTool:
    tool = EditTool()
    at = (0.3 * 1279, 0.3 * 719) if new else (0.5 * 1279, 0.5 * 719)
    tool.press(at, Modifiers(alt=new), FREE)
    tool.move((at[0] + 30, at[1]), Modifiers(), FREE)
    assert tool.busy
    return tool


@dataclass
class State:
    """A state of the window."""

    mode: str
    context: ToolContext | None
    draw: DrawTool = field(default_factory=DrawTool)
    edit: EditTool = field(default_factory=EditTool)
    over: Hit | None = None
    blocked: str = ""
    blind: bool = False
    ghosts: GhostHint = field(default_factory=GhostHint)

    def say(self) -> str:
        return status_hint(
            self.mode,
            self.draw,
            self.edit,
            self.context,
            FIELD,
            blocked=self.blocked,
            over=self.over,
            blind=self.blind,
            ghosts=self.ghosts,
        )


STATES = {
    "no dataset": State("draw", None),
    "no dataset, blind": State("draw", None, blind=True),
    "blocked": State("draw", CHOSEN, blocked="7.json: line 3: expected a number"),
    "blocked, blind": State("edit", FREE, blocked="7.json: is empty", blind=True),
    "draw, nothing chosen": State("draw", FREE),
    "draw, a new class": State("draw", replace(NOTHING, selected_class="Circle left")),
    "draw, an annotated class": State("draw", CHOSEN),
    "draw, a point chosen in the table": State("draw", POINT),
    "drawing, one point": State("draw", CHOSEN, DrawTool(NAME, [(1, 2)])),
    "drawing, three points": State("draw", CHOSEN, DrawTool(NAME, [(1, 2), (3, 4), (5, 6)])),
    "drawing, blind": State("draw", CHOSEN, DrawTool(NAME, [(1, 2)]), blind=True),
    "edit, nothing there": State("edit", NOTHING),
    "edit, nothing chosen": State("edit", FREE),
    "edit, over a point": State("edit", FREE, over=OVER_POINT),
    "edit, over a segment": State("edit", FREE, over=OVER_SEGMENT),
    "edit, a class chosen": State("edit", CHOSEN),
    "edit, a class without points chosen": State("edit", replace(NOTHING, selected_class=NAME)),
    "edit, a point chosen": State("edit", POINT),
    "edit, a point chosen, blind": State("edit", POINT, blind=True),
    "dragging": State("edit", POINT, edit=dragging()),
    "dragging a new point": State("edit", POINT, edit=dragging(new=True)),
}
every_state = pytest.mark.parametrize("name", STATES)


def keys_of(text: str) -> list[str]:
    """The second part of a hint."""
    return text.partition(KEYS)[2].split(SEPARATOR)


@every_state
def test_a_click_and_at_most_four_keys_are_answered(name):
    state = STATES[name]
    first = state.say().partition(KEYS)[0]
    if state.context is not None and not state.blocked:
        assert any(word in first for word in ("click", "release", "drag", "choose"))
    assert len(keys_of(state.say())) <= 4
    assert "nothing" not in "".join(keys_of(state.say()))


@every_state
def test_enter_and_escape_do_something_exactly_if_announced(name):
    state = STATES[name]
    if state.context is None or state.blocked:
        assert keys_of(state.say()) == [""]
        return
    for key, words in (("Enter", "Enter"), ("Escape", "Esc")):
        tool = copy.deepcopy(state.draw if state.mode == "draw" else state.edit)
        announced = any(phrase.startswith(words) for phrase in keys_of(state.say()))
        assert tool.key(key, state.context).handled is announced, key


@every_state
def test_delete_is_announced_only_where_it_works(name):
    state = STATES[name]
    if "Delete removes" in state.say():
        assert state.context is not None
        assert state.edit.key("Delete", state.context).edit is not None


def test_a_point_that_undo_took_away_is_not_spoken_of():
    gone = replace(POINT, selected_point=(NAME, 7))
    assert "arrows" not in State("edit", gone).say()
    assert not EditTool().key("Left", gone).handled
    assert EditTool().key("Escape", gone).handled


def test_counts_are_those_of_the_polylines():
    assert "1 point" in STATES["drawing, one point"].say()
    assert "3 points" in STATES["drawing, three points"].say()
    assert "after its 3 points" in State("draw", replace(CHOSEN, continues=True)).say()
    assert "continues it after" not in STATES["draw, an annotated class"].say()


def test_a_class_the_field_does_not_know_is_called_as_in_the_file():
    strange = FrameAnnotation((Polyline("Corner flag", (Point(0.5, 0.5),)),))
    context = ToolContext(strange, SIZE, 1.0, "Corner flag")
    assert "Corner flag" in State("edit", context).say()


def test_blind_says_how_to_see_the_projection():
    text = STATES["drawing, blind"].say()
    assert text.startswith("BLIND")
    assert "Ctrl+Enter commits the frame" in text


def test_a_blocked_frame_says_why():
    assert "7.json: line 3: expected a number" in STATES["blocked"].say()


class TestGhosts:
    LOOKED_AT = GhostHint(7, NAME)

    def say(self, mode: str, points: int | None) -> str:
        return State(mode, FREE, ghosts=replace(self.LOOKED_AT, points=points)).say()

    @pytest.mark.parametrize("mode", ["draw", "edit"])
    def test_of_the_current_one_the_click_and_its_keys_are_said(self, mode):
        text = self.say(mode, 9)
        first, click = text.partition(KEYS)[0].split(SEPARATOR)
        assert first == f"GHOST {FIELD.title_of(NAME)}"
        assert "click" in click
        assert keys_of(text)[0] == "Enter accepts 9 points"
        assert "Esc goes back" in keys_of(text)

    def test_enter_promises_nothing_that_is_not_there(self):
        assert "Enter accepts it" in keys_of(self.say("draw", None))
        assert "no line found along it" in self.say("draw", 0)

    def test_without_a_current_one_it_is_said_how_to_get_there(self):
        text = State("draw", CHOSEN, ghosts=GhostHint(7)).say()
        assert "Tab: first of 7 ghosts" in text
        assert "Shift+Enter: accept all" in text

    def test_they_come_before_further_keys(self):
        context = replace(CHOSEN, continues=True, snap=lambda name, position, direction: position)
        _, *words = keys_of(State("draw", context, ghosts=GhostHint(7)).say())
        assert words[:2] == ["Tab: first of 7 ghosts", "Shift+Enter: accept all"]
        assert "Ctrl" in words[2]

    def test_behind_a_walk_that_was_left_comes_the_next_one(self):
        text = State("draw", CHOSEN, ghosts=GhostHint(7, resumes=True)).say()
        assert "Tab: next of 7 ghosts" in text

    @pytest.mark.parametrize("context", [FREE, CHOSEN])
    def test_while_the_next_one_is_worked_out_escape_ends_the_walk(self, context):
        text = State("draw", context, ghosts=GhostHint(7, coming=True)).say()
        assert text.startswith("GHOST the next one comes in a moment")
        assert keys_of(text) == ["Esc goes back"]

    def test_in_a_frame_that_cannot_be_edited_they_can_be_looked_at(self):
        text = State("draw", FREE, blocked="Ada has it", ghosts=self.LOOKED_AT).say()
        assert text.startswith("READ ONLY")
        assert keys_of(text) == ["Esc goes back", "Tab goes on"]

    def test_while_something_is_drawn_or_held_ghosts_are_not_mentioned(self):
        drawing = State("draw", CHOSEN, DrawTool(NAME, [(1, 2)]), ghosts=GhostHint(7))
        held = State("edit", POINT, edit=dragging(), ghosts=GhostHint(7))
        assert "ghost" not in drawing.say() + held.say()

    def test_an_unconfirmed_element_is_what_shift_enter_means(self):
        waiting = replace(
            NOTHING, annotation=FrameAnnotation(unconfirmed=LINE.polylines), selected_class=NAME
        )
        assert "Shift+Enter" not in State("edit", waiting, ghosts=GhostHint(2)).say()
