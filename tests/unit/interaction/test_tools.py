"""Each gesture of a hand is one edit, and every state says what comes next."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px, points_px
from procc_annotator.field.load import load_field
from procc_annotator.interaction.draw_tool import DrawTool
from procc_annotator.interaction.edit_tool import EditTool
from procc_annotator.interaction.gestures import (
    Modifiers,
    Reaction,
    Selection,
    ToolContext,
    hit_test,
)
from procc_annotator.interaction.hints import status_hint

FIELD = load_field()
SIZE = (1280, 720)
PLAIN = Modifiers()


def annotated(**polylines: list[tuple[float, float]]) -> FrameAnnotation:
    return FrameAnnotation(
        tuple(
            Polyline(name.replace("_", " "), tuple(point_from_px(x, y, SIZE) for x, y in points))
            for name, points in polylines.items()
        )
    )


LINE = annotated(Middle_line=[(100, 100), (300, 100), (300, 300)])


def px(annotation: FrameAnnotation, name: str = "Middle line") -> list[list[float]]:
    polyline = annotation.get(name)
    assert polyline is not None
    return np.round(points_px(polyline, SIZE), 6).tolist()


class TestDrawing:
    def test_clicks_then_enter_are_one_edit(self) -> None:
        tool, context = DrawTool(), ToolContext(FrameAnnotation(), SIZE, 1.0, "Circle left")
        for position in ((10.25, 20.5), (30.0, 40.0)):
            assert tool.press(position, PLAIN, context).edit is None
        edit = tool.key("Enter", context).edit
        assert edit.label == "draw Circle left"
        assert px(edit.annotation, "Circle left") == [[10.25, 20.5], [30, 40]]
        assert not tool.busy

    def test_a_double_click_finishes_without_a_point_more(self) -> None:
        tool, context = DrawTool(), ToolContext(FrameAnnotation(), SIZE, 1.0, "Circle left")
        tool.press((10, 20), PLAIN, context)
        tool.press((30, 40), PLAIN, context)
        edit = tool.double_click((30, 40), PLAIN, context).edit
        assert px(edit.annotation, "Circle left") == [[10, 20], [30, 40]]

    def test_backspace_takes_back_and_escape_cancels_then_deselects(self) -> None:
        tool, context = DrawTool(), ToolContext(LINE, SIZE, 1.0, "Circle left")
        tool.press((10, 20), PLAIN, context)
        tool.press((30, 40), PLAIN, context)
        tool.key("Backspace", context)
        assert tool.points == [(10, 20)]
        assert tool.key("Escape", context).cancelled
        assert not tool.busy
        assert tool.key("Escape", context).select == Selection(None)
        assert not tool.key("Enter", context).handled

    def test_an_unconfirmed_element_is_continued_and_so_confirmed(self) -> None:
        waiting = FrameAnnotation(unconfirmed=LINE.polylines)
        tool, context = DrawTool(), ToolContext(waiting, SIZE, 1.0, "Middle line", continues=True)
        assert "continues it after its 3 points" in status_hint(
            "draw", tool, EditTool(), context, FIELD
        )
        tool.press((500, 500), PLAIN, context)
        edit = tool.key("Enter", context).edit
        assert px(edit.annotation) == [[100, 100], [300, 100], [300, 300], [500, 500]]
        assert edit.annotation.unconfirmed == ()

    def test_enter_confirms_and_goes_on_to_what_else_waits(self) -> None:
        more = annotated(Circle_left=[(5, 5), (9, 9)])
        waiting = FrameAnnotation(unconfirmed=(*LINE.polylines, *more.polylines))
        for tool in (DrawTool(), EditTool()):
            context = ToolContext(waiting, SIZE, 1.0, "Middle line")
            first = tool.key("Enter", context)
            assert first.edit.annotation.annotated == ("Middle line",)
            assert first.select == Selection("Circle left")
            context = ToolContext(first.edit.annotation, SIZE, 1.0, "Circle left")
            second = tool.key("Enter", context)
            assert second.edit.annotation.unconfirmed == ()
            assert second.finished

    def test_the_first_click_is_put_on_the_line_again_once_its_direction_is_known(self) -> None:
        def snap(
            name: str, at: tuple[float, float], direction: tuple[float, float] | None
        ) -> tuple[float, float] | None:
            return (at[0], 100.0) if direction is not None else (at[0] + 3, at[1])

        tool = DrawTool()
        context = ToolContext(FrameAnnotation(), SIZE, 1.0, "Middle line", snap=snap)
        tool.press((100, 103), PLAIN, context)
        assert tool.points == [(103, 103)]
        tool.press((300, 98), PLAIN, context)
        assert tool.points == [(100, 100), (300, 100)]
        beside = DrawTool()
        beside.press((100, 103), Modifiers(ctrl=True), context)
        beside.press((300, 98), PLAIN, context)
        assert beside.points[0] == (100, 103)  # meant to be there

    def test_the_hint_says_when_the_next_click_finishes(self) -> None:
        def words(annotation: FrameAnnotation, clicks: int) -> str:
            tool = DrawTool()
            context = ToolContext(annotation, SIZE, 1.0, "Middle line", is_two_point_element=True)
            for i in range(clicks):
                tool.press((500.0 + 50 * i, 500.0), PLAIN, context)
            return status_hint("draw", tool, EditTool(), context, FIELD, upcoming="Circle left")

        assert "second point and finishes" in words(FrameAnnotation(), 1)
        assert "finishes and goes on to Left penalty arc" in words(FrameAnnotation(), 1)
        assert "second point and finishes" not in words(LINE, 1)  # continued: no end in sight

    def test_the_hint_of_a_pinned_element_says_so(self) -> None:
        tool, context = EditTool(), ToolContext(LINE, SIZE, 1.0)
        tool.press((200, 100), PLAIN, context)
        assert "pinned" in status_hint("edit", DrawTool(), tool, context, FIELD)

    def test_an_annotated_class_is_continued(self) -> None:
        tool, context = DrawTool(), ToolContext(LINE, SIZE, 1.0, "Middle line", continues=True)
        tool.press((500, 500), PLAIN, context)
        edit = tool.finish(context).edit
        assert edit.label == "continue Middle line"
        assert px(edit.annotation) == [*px(LINE), [500, 500]]

    def test_without_an_element_a_click_says_so(self) -> None:
        tool = DrawTool()
        assert "choose an element" in tool.press((1, 1), PLAIN, ToolContext(LINE, SIZE)).message
        assert not tool.busy

    def test_the_class_is_the_one_the_polyline_began_with(self) -> None:
        tool, context = DrawTool(), ToolContext(FrameAnnotation(), SIZE, 1.0, "Circle left")
        tool.press((10, 20), PLAIN, context)
        edit = tool.finish(replace(context, selected_class="Circle right")).edit
        assert edit.annotation.annotated == ("Circle left",)


class TestEditing:
    context = ToolContext(LINE, SIZE, 1.0, "Middle line")

    def test_a_drag_is_one_edit_and_keeps_the_grip(self) -> None:
        tool = EditTool()
        assert tool.press((303, 98), PLAIN, self.context).select == Selection("Middle line", 1)
        preview = tool.move((313, 98), PLAIN, self.context).preview
        assert preview is not None
        assert px(preview)[1] == [310, 100]
        edit = tool.release((323, 99), PLAIN, self.context).edit
        assert px(edit.annotation) == [[100, 100], [320, 101], [300, 300]]
        assert edit.label == "move Middle line"

    def test_a_click_without_movement_only_selects(self) -> None:
        tool = EditTool()
        tool.press((303, 98), PLAIN, self.context)
        tool.move((303.5, 98.5), PLAIN, self.context)
        assert tool.release((303.5, 98.5), PLAIN, self.context).edit is None

    def test_points_may_be_dragged_out_of_the_picture(self) -> None:
        tool = EditTool()
        tool.press((100, 100), PLAIN, self.context)
        edit = tool.release((-20, -30), PLAIN, self.context).edit
        assert edit is None
        tool.press((100, 100), PLAIN, self.context)
        tool.move((-20, -30), PLAIN, self.context)
        edit = tool.release((-20, -30), PLAIN, self.context).edit
        assert px(edit.annotation)[0] == [-20, -30]

    def test_escape_puts_a_held_point_back(self) -> None:
        tool = EditTool()
        tool.press((100, 100), PLAIN, self.context)
        tool.move((200, 200), PLAIN, self.context)
        assert tool.key("Escape", self.context).cancelled
        assert tool.release((200, 200), PLAIN, self.context).edit is None

    def test_leaving_the_frame_drops_a_held_point_where_it_is(self) -> None:
        tool = EditTool()
        tool.press((100, 100), PLAIN, self.context)
        tool.move((200, 200), PLAIN, self.context)
        edit = tool.finish(self.context).edit
        assert px(edit.annotation)[0] == [200, 200]

    @pytest.mark.parametrize("alt", [False, True])
    def test_undo_during_a_drag_is_not_taken_back_by_the_release(self, alt) -> None:
        tool = EditTool()
        tool.press((200, 100) if alt else (100, 100), Modifiers(alt=alt), self.context)
        tool.move((240, 240), PLAIN, self.context)
        undone = replace(self.context, annotation=annotated(Circle_left=[(5, 5)]))
        assert tool.release((250, 250), PLAIN, undone) == Reaction(cancelled=True)
        assert not tool.busy

    def test_a_move_after_an_interrupted_insertion_is_called_a_move(self) -> None:
        tool = EditTool()
        tool.press((200, 100), Modifiers(alt=True), self.context)  # the release never comes
        tool.press((100, 100), PLAIN, self.context)
        tool.move((120, 120), PLAIN, self.context)
        edit = tool.release((120, 120), PLAIN, self.context).edit
        assert edit.label == "move Middle line"
        assert px(edit.annotation) == [[120, 120], [300, 100], [300, 300]]

    def test_alt_click_on_a_segment_inserts_there(self) -> None:
        tool = EditTool()
        reaction = tool.press((200, 104), Modifiers(alt=True), self.context)
        assert reaction.select == Selection("Middle line", 1)
        edit = tool.release((200, 104), PLAIN, self.context).edit
        assert px(edit.annotation) == [[100, 100], [200, 100], [300, 100], [300, 300]]
        assert edit.label == "insert a point in Middle line"

    def test_alt_shift_click_removes_and_the_last_point_takes_the_class(self) -> None:
        both = Modifiers(alt=True, shift=True)
        edit = EditTool().press((300, 101), both, self.context).edit
        assert px(edit.annotation) == [[100, 100], [300, 300]]
        single = ToolContext(annotated(Middle_line=[(5, 5)]), SIZE)
        edit = EditTool().press((5, 5), both, single).edit
        assert edit.annotation.annotated == ()

    @pytest.mark.parametrize(
        ("key", "step", "expected"),
        [("Left", 1.0, [299, 100]), ("Down", 0.1, [300, 100.1]), ("Up", 10.0, [300, 90])],
    )
    def test_arrows_nudge(self, key, step, expected) -> None:
        context = replace(self.context, selected_point=("Middle line", 1))
        edit = EditTool().nudge(key, step, context).edit
        assert px(edit.annotation)[1] == expected

    def test_delete_removes_the_point_or_else_the_element(self) -> None:
        chosen = replace(self.context, selected_point=("Middle line", 2))
        reaction = EditTool().key("Delete", chosen)
        assert px(reaction.edit.annotation) == [[100, 100], [300, 100]]
        assert reaction.select == Selection("Middle line", 1)
        edit = EditTool().key("Delete", self.context).edit
        assert edit.annotation.annotated == ()
        assert not EditTool().key("Delete", ToolContext(LINE, SIZE)).handled


class TestDraggingBack:
    """A point that snapping put on the wrong line is dragged off it and stays there."""

    WRONG_Y = 105.0  # a line beside the one that is meant, at 100

    def dragged(self, *way: tuple[float, float]) -> tuple[list[float], bool]:
        """Where the point ends that lies on the wrong line at first, and whether it is snapped."""
        context = ToolContext(
            annotated(Middle_line=[(100.0, self.WRONG_Y), (500.0, 100.0)]),
            SIZE,
            selected_class="Middle line",
            snap=lambda name, at, direction: (at[0], self.WRONG_Y),
        )
        tool = EditTool()
        tool.press((100.0, self.WRONG_Y), PLAIN, context)
        for place in way:
            tool.move(place, PLAIN, context)
        edit = tool.release(way[-1], PLAIN, context).edit
        return px(edit.annotation)[0], bool(edit.snapped)

    def test_across_the_line_it_stays_where_the_hand_puts_it(self) -> None:
        assert self.dragged((101.0, 103.0), (102.0, 100.0)) == ([102.0, 100.0], False)

    def test_along_the_line_it_stays_on_it(self) -> None:
        assert self.dragged((110.0, 103.0), (130.0, 102.0)) == ([130.0, self.WRONG_Y], True)

    def test_a_new_point_of_a_chord_goes_to_the_line(self) -> None:
        context = ToolContext(
            annotated(Middle_line=[(100.0, 100.0), (500.0, 100.0)]),
            SIZE,
            selected_class="Middle line",
            snap=lambda name, at, direction: (at[0], 104.0),
        )
        tool = EditTool()
        tool.press((300.0, 100.0), Modifiers(alt=True), context)
        tool.move((300.0, 96.0), PLAIN, context)
        edit = tool.release((300.0, 97.0), PLAIN, context).edit
        assert px(edit.annotation)[1] == [300.0, 104.0]


class TestHitting:
    def test_points_win_over_segments_and_the_selected_class_over_others(self) -> None:
        hit = hit_test(LINE, SIZE, (108, 100), 1.0)
        assert hit.kind == "point"
        crossing = annotated(Middle_line=[(100, 100), (300, 100)], Circle_left=[(100, 100)])
        for name in ("Circle left", "Middle line"):
            hit = hit_test(crossing, SIZE, (101, 101), 1.0, prefer=name)
            assert hit.class_name == name


class TestHints:
    def say(self, mode: str, context: ToolContext | None, **options: object) -> str:
        draw, edit = options.pop("draw", DrawTool()), options.pop("edit", EditTool())
        return status_hint(mode, draw, edit, context, FIELD, **options)

    def test_editing_names_what_is_under_the_cursor(self) -> None:
        context = ToolContext(LINE, SIZE)
        point = hit_test(LINE, SIZE, (300, 100), 1.0)
        assert "drag moves point 2 of Halfway line" in self.say("edit", context, over=point)
        segment = hit_test(LINE, SIZE, (200, 100), 1.0)
        assert "Alt+click inserts" in self.say("edit", context, over=segment)
        held = EditTool(("Middle line", 0))
        assert "Esc puts it back" in self.say("edit", context, edit=held)
        selected = replace(context, selected_class="Middle line", selected_point=("Middle line", 0))
        assert "arrows nudge 1 px, with Shift 0.1 px" in self.say("edit", selected)


class TestSpots:
    """A single place is annotated by one click; so is moving it."""

    MARK = "Penalty mark left"

    def context(self, annotation: FrameAnnotation = FrameAnnotation()) -> ToolContext:  # noqa: B008
        return ToolContext(
            annotation, SIZE, 1.0, self.MARK, spots=frozenset({self.MARK}), title=FIELD.title_of,
            snap=lambda name, position, direction: (0.0, 0.0),
        )  # fmt: skip

    def test_one_click_marks_it_and_finishes(self) -> None:
        tool = DrawTool()
        assert "click marks it" in status_hint("draw", tool, EditTool(), self.context(), FIELD)
        reaction = tool.press((10.25, 20.5), PLAIN, self.context())
        assert px(reaction.edit.annotation, self.MARK) == [[10.25, 20.5]]  # and no line is near
        assert reaction.finished
        assert not tool.busy
        assert reaction.edit.snapped == frozenset()
        assert tool.landing((3, 4), PLAIN, self.context()) is None

    def test_the_second_click_of_a_double_click_is_none(self) -> None:
        tool = DrawTool()
        tool.press((10, 20), PLAIN, self.context())
        following = replace(self.context(), selected_class="Circle left")
        assert not tool.double_click((10, 20), PLAIN, following).handled
        assert not tool.busy
        tool.press((10, 20), PLAIN, following)
        assert tool.busy  # the next press begins the next element

    def test_another_click_moves_it(self) -> None:
        tool, there = DrawTool(), annotated(Penalty_mark_left=[(100, 100)])
        assert tool.press((30, 40), PLAIN, self.context(there)).edit is None  # it is finished
        again = replace(self.context(there), continues=True)
        assert "click moves it here" in status_hint("draw", tool, EditTool(), again, FIELD)
        edit = tool.press((30, 40), PLAIN, again).edit
        assert edit.label.startswith("move ")
        assert px(edit.annotation, self.MARK) == [[30, 40]]

    def test_a_dragged_spot_stays_where_it_is_dropped(self) -> None:
        tool, context = EditTool(), self.context(annotated(Penalty_mark_left=[(100, 100)]))
        tool.press((100, 100), PLAIN, context)
        tool.move((140, 120), PLAIN, context)
        edit = tool.release((140, 120), PLAIN, context).edit
        assert px(edit.annotation, self.MARK) == [[140, 120]]


# What is under the cursor, against a search by plain arithmetic.

HIT_SIZE = (640, 360)

coordinates = st.integers(-20, 660)
positions = st.tuples(coordinates, coordinates)
frames = st.lists(st.lists(positions, max_size=5), max_size=4).map(
    lambda polylines: FrameAnnotation(
        tuple(
            Polyline(f"class {i}", tuple(point_from_px(x, y, HIT_SIZE) for x, y in points))
            for i, points in enumerate(polylines)
        )
    )
)


def to_segment(at: tuple[float, float], a: list[float], b: list[float]) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    squared = dx * dx + dy * dy
    t = 0.0 if squared == 0 else ((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / squared
    t = min(1.0, max(0.0, t))
    return math.hypot(at[0] - a[0] - t * dx, at[1] - a[1] - t * dy)


def targets(
    annotation: FrameAnnotation, at: tuple[float, float]
) -> dict[str, dict[tuple[str, int], float]]:
    """Distance to every target, picture px."""
    found: dict[str, dict[tuple[str, int], float]] = {"point": {}, "segment": {}}
    for polyline in annotation:
        points = points_px(polyline, HIT_SIZE).tolist()
        for i, point in enumerate(points):
            found["point"][polyline.class_name, i] = math.dist(at, point)
        for i in range(len(points) - 1):
            found["segment"][polyline.class_name, i] = to_segment(at, points[i], points[i + 1])
    return found


@settings(max_examples=150)
@given(frames, positions, st.sampled_from([0.25, 1.0, 8.0]))
def test_the_nearest_point_in_reach_else_the_nearest_segment(annotation, at, scale) -> None:
    hit = hit_test(annotation, HIT_SIZE, at, scale)
    found = targets(annotation, at)
    for kind in ("point", "segment"):
        nearest = min(found[kind].values(), default=math.inf) * scale
        if nearest == pytest.approx(10.0, abs=1e-6):
            return  # on the rim of the radius rounding decides
        if nearest < 10.0:
            assert hit.kind == kind
            assert hit.distance_screen == pytest.approx(nearest, abs=1e-6)
            own = found[kind][hit.class_name, hit.index] * scale
            assert own == pytest.approx(nearest, abs=1e-6)
            assert math.dist(hit.foot, at) * scale == pytest.approx(nearest, abs=1e-6)
            return
    assert hit is None


def test_the_selected_class_out_of_reach_does_not_hide_another_in_reach() -> None:
    annotation = FrameAnnotation(
        (
            Polyline("near", (point_from_px(109.9, 100, HIT_SIZE),)),
            Polyline("selected", (point_from_px(89.8, 100, HIT_SIZE),)),
        )
    )
    hit = hit_test(annotation, HIT_SIZE, (100, 100), 1.0, prefer="selected")
    assert hit.class_name == "near"


def test_points_that_coincide_can_be_hit() -> None:
    twice = FrameAnnotation((Polyline("spot", (Point(0.5, 0.5), Point(0.5, 0.5))),))
    x, y = points_px(twice.polylines[0], HIT_SIZE)[0].tolist()
    hit = hit_test(twice, HIT_SIZE, (x + 1, y), 1.0)
    assert hit.kind == "point"
