"""Ghosts by hand: Tab, Enter, Shift+Enter, not visible here; never stale, never in blind mode."""

import json
import sys
import threading
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import Point
from procc_annotator.assist.ghost_points import GhostPoints, find_points
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.editing import append_points, delete_point
from procc_annotator.dataset.records import OriginKind
from procc_annotator.gui.commands import ghost_accepting
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import GHOST_SUPPORT
from procc_annotator.gui.state.prediction import ghosts as ghosts_module
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.window.menus import canvas_menu
from procc_annotator.interaction.class_choice import next_element
from procc_annotator.interaction.overlay_predictions import ghost_extent
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY
from tests.gui.conftest import KEPT, Hand, let_work_end, wait_for_ghosts

SHIFT = Qt.KeyboardModifier.ShiftModifier
ALT = Qt.KeyboardModifier.AltModifier
CTRL = Qt.KeyboardModifier.ControlModifier
Key = Qt.Key


@pytest.fixture
def hand(begun, hand_on) -> Hand:
    return hand_on(begun)


def names(window: MainWindow) -> list[str]:
    return [ghost.name for ghost in window.services.ghosts.known]


def current(window: MainWindow) -> str | None:
    ghost = window.services.ghosts.current
    return ghost.name if ghost is not None else None


def go(window: MainWindow, hand: Hand, qtbot: QtBot) -> str:
    """Tab, and wait until the points of the ghost are there."""
    hand.key(Key.Key_Tab)
    ghosts = window.services.ghosts
    qtbot.waitUntil(lambda: ghosts.found(current(window)) is not None)
    name = current(window)
    assert name is not None
    return name


class TestShown:
    def test_they_are_drawn_below_everything_and_hidden_with_the_rest(self, begun, hand):
        item = begun.canvas.overlay_item
        assert len(names(begun)) >= 5
        assert not set(names(begun)) & set(begun.services.state.annotation.annotated)
        assert {s.layer for s in item.ghosts.strokes} == {"ghost"}
        QTest.keyPress(begun.canvas, Key.Key_X)
        assert item.ghosts is EMPTY_OVERLAY
        QTest.keyRelease(begun.canvas, Key.Key_X)
        assert item.ghosts.strokes
        begun.actions_["ghosts"].trigger()
        assert item.ghosts is EMPTY_OVERLAY
        assert not names(begun)

    def test_tab_still_moves_the_focus_in_panels(self, begun):
        search = begun.elements.search
        search.setFocus()
        QTest.keyClick(search, Key.Key_Tab)
        assert QApplication.focusWidget() is not search
        assert current(begun) is None

    def test_they_stay_while_new_ones_are_worked_out_but_not_those_annotated_now(
        self, begun, hand, qtbot
    ):
        services, before = begun.services, names(begun)
        points = services.state.annotation.get(KEPT[0]).points[:2]
        edited = append_points(services.state.annotation, before[0], points)
        with qtbot.waitSignal(services.ghosts.changed):  # after the paint
            services.editing.commit_edit("draw", edited)
        assert services.live_fit.insight is None
        assert [g.name for g in services.ghosts.painted] == before[1:]
        assert not names(begun)  # none of them can be accepted
        wait_for_ghosts(begun, qtbot)
        assert before[0] not in names(begun)


class TestWalk:
    def test_tab_goes_through_all_and_gives_the_view_back(self, begun, hand, told):
        services, canvas = begun.services, begun.canvas
        services.selection.select_class("Middle line")
        scale = canvas.view_scale
        visited = []
        for _ in names(begun):
            hand.key(Key.Key_Tab)
            visited.append(current(begun))
            assert services.state.selected_class == current(begun)  # lists and field map show it
            left, top, right, bottom = ghost_extent(services.ghosts.current)
            a, b = canvas.to_view(left, top), canvas.to_view(right, bottom)
            room = canvas.viewport().rect().adjusted(-2, -2, 2, 2)
            assert room.contains(a.toPoint())
            assert room.contains(b.toPoint())
            if (
                not canvas.place.fitted
            ):  # what lies at an edge of the picture lies not at the view's
                assert room.adjusted(30, 30, -30, -30).contains(a.toPoint())
                assert room.adjusted(30, 30, -30, -30).contains(b.toPoint())
            share = max((b.x() - a.x()) / room.width(), (b.y() - a.y()) / room.height())
            assert share > 0.3 or canvas.view_scale >= 4
        assert visited == names(begun)
        hand.key(Key.Key_Tab, SHIFT)
        assert current(begun) == visited[-2]
        hand.key(Key.Key_Tab)
        hand.key(Key.Key_Tab)
        assert current(begun) is None
        assert canvas.view_scale == scale
        assert services.state.selected_class == "Middle line"
        assert told[-1] == f"that was the last ghost; {len(visited)} ghosts left, Tab begins again"
        hand.key(Key.Key_Tab)
        assert current(begun) == visited[0]

    def test_escape_goes_back_and_tab_goes_on_from_there(self, begun, hand):
        place = begun.canvas.place
        hand.key(Key.Key_Tab)
        hand.key(Key.Key_Escape)
        assert current(begun) is None
        assert begun.canvas.place == place
        hand.key(Key.Key_Tab)
        assert current(begun) == names(begun)[1]

    def test_drawing_by_hand_ends_the_walk_where_it_is(self, begun, hand):
        hand.key(Key.Key_Tab)
        name, scale = current(begun), begun.canvas.view_scale
        left, top, right, bottom = ghost_extent(begun.services.ghosts.current)
        hand.click(left, top)
        assert current(begun) is None
        assert begun.canvas.view_scale == scale
        hand.click(right, bottom)
        hand.key(Key.Key_Return)  # finishes what is drawn
        assert len(begun.services.state.annotation.get(name).points) == 2

    def test_choosing_another_element_means_that_one(self, begun, hand):
        hand.key(Key.Key_Tab)
        begun.services.selection.select_class(names(begun)[2])
        assert current(begun) == names(begun)[2]
        begun.services.selection.select_class("Middle line")
        assert current(begun) is None
        assert begun.services.state.selected_class == "Middle line"

    def test_the_status_bar_says_what_the_keys_do(self, begun, hand, qtbot):
        assert f"Tab: first of {len(names(begun))} ghosts" in begun.canvas.hint
        name = go(begun, hand, qtbot)
        count = len(begun.services.ghosts.found(name).points)
        title = begun.services.state.field.title_of(name)
        assert f"GHOST {title}" in begun.canvas.hint
        assert f"Enter accepts {count} points" in begun.canvas.hint
        assert len(begun.canvas.overlay_item.ghosts.marks[0].centres) == count


class TestAccept:
    def test_enter_accepts_what_is_shown_and_goes_on(self, begun, hand, qtbot, told):
        services = begun.services
        name = go(begun, hand, qtbot)
        found = services.ghosts.found(name)
        following = names(begun)[1]
        hand.key(Key.Key_Return)
        assert services.state.annotation.get(name).points == found.points
        assert f"accepted {services.state.field.title_of(name)}" in told[-1]
        wait_for_ghosts(begun, qtbot)
        assert current(begun) == following
        counts = services.review.origin_counts(services.state.frame.name, services.state.annotation)
        assert counts[OriginKind.SUGGESTED] == len(found.points)
        begun.actions_["colour_origin"].trigger()
        marks = [m for m in begun.canvas.overlay_item.overlay.marks if m.colour == "#CC79A7"]
        assert sum(len(m.centres) for m in marks if m.shape == "ring") == len(found.points)
        hand.key(Key.Key_Z, CTRL)
        assert services.state.annotation.annotated == KEPT
        wait_for_ghosts(begun, qtbot)
        assert name in names(begun)

    def test_ends_that_cannot_be_seen_are_told(self, begun, hand, qtbot, told, monkeypatch):
        def hidden(*terms: Any) -> GhostPoints:
            return replace(find_points(*terms), unsure_ends=1)

        for module in (ghosts_module, ghost_accepting):
            monkeypatch.setattr(module, "find_points", hidden)
        name = go(begun, hand, qtbot)
        hand.key(Key.Key_Return)
        assert begun.services.state.annotation.get(name) is not None
        title = begun.services.state.field.title_of(name)
        assert f"1 end of {title} cannot be seen: the points stop before" in told[-1]

    def test_enter_before_the_points_are_found_accepts_them_then(self, begun, hand, qtbot):
        hand.key(Key.Key_Tab)
        name = current(begun)
        hand.key(Key.Key_Return)
        assert begun.services.state.annotation.get(name) is None
        qtbot.waitUntil(lambda: begun.services.state.annotation.get(name) is not None)

    def test_an_edit_in_between_drops_it(self, begun, hand, qtbot, told):
        services = begun.services
        hand.key(Key.Key_Tab)
        name = current(begun)
        hand.key(Key.Key_Return)
        services.editing.commit_edit("shorten", delete_point(services.state.annotation, KEPT[3], 0))
        wait_for_ghosts(begun, qtbot)
        qtbot.waitUntil(lambda: services.ghosts.found(name) is not None)
        assert services.state.annotation.get(name) is None
        assert any("not accepted: the frame was edited meanwhile" in text for text in told)

    def test_without_a_line_in_the_picture_nothing_is_accepted(
        self, begun, hand, qtbot, told, monkeypatch
    ):
        services = begun.services
        services.store.update(picture=np.full_like(services.navigator.picture, 90))
        name = go(begun, hand, qtbot)
        assert "no line found along it" in begun.canvas.hint
        hand.key(Key.Key_Return)
        assert services.state.annotation.get(name) is None
        assert current(begun) == name
        assert "no painted line is found along it" in told[-1]

    def test_all_with_enough_of_their_line_in_one_step(self, begun, hand, qtbot, told):
        services, known = begun.services, names(begun)
        hand.key(Key.Key_Return, SHIFT)
        qtbot.waitUntil(lambda: services.state.annotation.annotated != KEPT)
        accepted = services.state.annotation.annotated[len(KEPT) :]
        left = set(known) - set(accepted)
        assert len(accepted) >= 4
        said = next(text for text in told if text.startswith("accepted"))
        if left:
            assert f"accepted {len(accepted)} of {len(known)} ghosts" in said
        for name in left:
            assert services.state.field.title_of(name) in said
        begun.canvas.undo()
        assert services.state.annotation.annotated == KEPT

    def test_one_key_accepts_all_and_goes_on(self, begun, hand, qtbot):
        services, here = begun.services, begun.services.state.frame_index
        hand.key(Key.Key_Return, ALT)
        qtbot.waitUntil(lambda: services.state.frame_index == here + 1)
        let_work_end(qtbot)
        assert services.state.frame_index == here + 1
        services.navigator.go_to(here)
        qtbot.waitUntil(lambda: services.state.frame_index == here)
        assert len(services.state.annotation.annotated) >= len(KEPT) + 4

    def test_where_nothing_can_be_accepted_it_goes_on_all_the_same(self, begun, hand, qtbot):
        """The frame is annotated: what is left of its lines cannot be seen."""
        services, here = begun.services, begun.services.state.frame_index
        services.store.update(picture=np.full_like(services.navigator.picture, 90))
        hand.key(Key.Key_Return, ALT)
        qtbot.waitUntil(lambda: services.state.frame_index == here + 1)
        services.navigator.go_to(here)
        qtbot.waitUntil(lambda: services.state.frame_index == here)
        assert services.state.annotation.annotated == KEPT

    def test_the_share_asked_for_is_kept(self, begun, hand, qtbot, told):
        begun.settings.set(GHOST_SUPPORT, 1.0)
        assert begun.ghost_tasks.accepting.least_support == 1.0
        picture = np.full_like(begun.services.navigator.picture, 90)
        begun.services.store.update(picture=picture)
        hand.key(Key.Key_Return, SHIFT)
        qtbot.waitUntil(lambda: not begun.ghost_tasks.accepting.busy)
        assert "no ghost accepted, under 100% of the line visible" in told[-1]
        assert begun.services.state.annotation.annotated == KEPT

    def test_while_drawing_the_keys_keep_their_meaning(self, begun, hand):
        begun.services.selection.select_class("Middle line")
        hand.click(1000, 600)
        hand.click(1100, 650)
        hand.key(Key.Key_Return, SHIFT)
        assert begun.services.state.annotation.annotated == (*KEPT, "Middle line")
        assert not begun.ghost_tasks.accepting.busy

    def test_another_model_drops_what_was_asked_of_the_ghosts_before(
        self, begun, hand, qtbot, told, monkeypatch
    ):
        services, go_on = begun.services, threading.Event()

        def slow(*terms: Any) -> GhostPoints:
            assert go_on.wait(20)
            return find_points(*terms)

        monkeypatch.setattr(ghost_accepting, "find_points", slow)
        hand.key(Key.Key_Return, SHIFT)
        assert begun.ghost_tasks.accepting.busy
        services.live_fit.set_model("P")
        assert not begun.ghost_tasks.accepting.busy
        assert told[-1] == "no ghost was accepted: the camera is another one meanwhile"
        go_on.set()
        wait_for_ghosts(begun, qtbot)
        let_work_end(qtbot)
        assert services.state.annotation.annotated == KEPT

    def test_enter_on_a_ghost_is_for_that_model(self, begun, hand, qtbot, told):
        services = begun.services
        hand.key(Key.Key_Tab)
        name = current(begun)
        hand.key(Key.Key_Return)
        services.live_fit.set_model("P")
        assert "is not accepted: the camera is another one meanwhile" in told[-1]
        wait_for_ghosts(begun, qtbot)
        qtbot.waitUntil(lambda: services.ghosts.found(name) is not None)
        assert services.state.annotation.annotated == KEPT

    def test_all_from_the_menu_while_drawing_finishes_that_first(self, begun, hand, qtbot, told):
        services = begun.services
        services.selection.select_class("Middle line")
        hand.click(1000, 600)
        hand.click(1100, 650)
        begun.actions_["accept_ghosts"].trigger()
        assert services.state.annotation.annotated == (*KEPT, "Middle line")
        assert told[-1] == "what was being drawn is finished: accept the ghosts of the new fit"
        begun.actions_["accept_ghosts"].trigger()
        assert told[-1] == "the camera is being fitted: ghosts come in a moment"
        let_work_end(qtbot)
        assert services.state.annotation.annotated == (*KEPT, "Middle line")


class TestNotVisible:
    def test_the_key_hides_a_ghost_for_good_and_goes_on(self, begun, hand, qtbot):
        services = begun.services
        hand.key(Key.Key_Tab)
        name, following = names(begun)[:2]
        hand.key(Key.Key_Period)
        assert name not in [ghost.name for ghost in services.ghosts.painted]
        qtbot.waitUntil(lambda: current(begun) == following)
        assert name not in [ghost.name for ghost in services.live_fit.insight.ghosts]
        services.navigator.go_to(2)
        services.navigator.go_to(1)
        wait_for_ghosts(begun, qtbot)
        assert name not in names(begun)
        hand.key(Key.Key_Period, CTRL)
        qtbot.waitUntil(lambda: name in names(begun))

    def test_the_same_key_on_the_chosen_element_takes_it_back(self, begun, hand, qtbot):
        services, name = begun.services, names(begun)[0]
        services.selection.select_class(name)
        for hidden in (True, False):
            hand.key(Key.Key_Period)
            assert (name in services.review.not_visible(services.state.frame.name)) is hidden
        qtbot.waitUntil(lambda: name in names(begun))

    def test_an_annotated_element_is_visible(self, begun, hand, told):
        begun.services.selection.select_class(KEPT[0])
        hand.key(Key.Key_Period)
        assert not begun.services.review.not_visible("00002")
        assert "is annotated here" in told[-1]

    def test_the_menu_lists_them(self, begun, hand, qtbot):
        services, name = begun.services, names(begun)[0]
        title = services.state.field.title_of(name)
        begun.ghost_tasks.set_not_visible(name, True)
        menu = self.menu(begun)
        (submenu,) = [m for m in menu.findChildren(QMenu) if "take back" in m.title()]
        (action,) = submenu.actions()
        assert action.text() == title
        action.trigger()
        assert not services.review.not_visible("00002")
        assert not [m for m in self.menu(begun).findChildren(QMenu) if "back" in m.title()]

    def test_a_ghost_under_the_cursor_is_in_the_menu(self, begun, hand, qtbot):
        ghost = begun.services.ghosts.named("Side line top")
        x, y = ghost.pieces[0].points_px[len(ghost.pieces[0].points_px) // 2].tolist()
        hand.move(x, y)
        assert begun.ghost_tasks.at_cursor() == "Side line top"
        accept = next(a for a in self.menu(begun).actions() if a.text() == "Accept")
        place = begun.canvas.place
        accept.trigger()
        qtbot.waitUntil(lambda: begun.services.state.annotation.get("Side line top") is not None)
        assert begun.canvas.place == place

    @staticmethod
    def menu(window: MainWindow) -> QMenu:
        return canvas_menu(
            window,
            window.services,
            window.actions_,
            window.element_edits,
            on_ground=True,
            ghost_tasks=window.ghost_tasks,
            ghost=window.ghost_tasks.at_cursor(),
        )


class TestNext:
    def test_the_field_map_says_what_tells_most(self, begun, qtbot):
        services, field_map = begun.services, begun.field_map
        best = services.live_fit.insight.suggestions[0]
        assert services.ghosts.suggestion == best
        at = field_map.place_of_next()
        ring = at + QPointF(9, 0)
        image = field_map.grab().toImage()
        ratio = image.devicePixelRatio()
        seen = image.pixelColor((ring * ratio).toPoint())
        assert seen.blue() > 150 > seen.red()
        QTest.mouseClick(field_map, Qt.MouseButton.LeftButton, pos=at.toPoint())
        assert services.state.selected_class == best.name
        begun.actions_["suggest"].trigger()
        assert services.ghosts.suggestion is None

    def test_it_is_never_what_cannot_be_seen(self, begun):
        best = begun.services.ghosts.suggestion.name
        begun.ghost_tasks.set_not_visible(best, True)
        suggestion = begun.services.ghosts.suggestion
        assert suggestion is None or suggestion.name != best


class TestAutoAdvance:
    def finish(self, window: MainWindow, hand: Hand, name: str) -> str | None:
        window.services.selection.select_class(name)
        hand.click(600, 300)
        hand.click(700, 350)
        hand.key(Key.Key_Return)
        return window.services.state.selected_class

    def test_it_goes_on_to_what_tells_most(self, begun, hand):
        best = begun.services.ghosts.suggestion.name
        other = next(name for name in names(begun) if name != best)
        begun.services.selection.select_class(other)
        hand.click(600, 300)
        assert f"goes on to {begun.services.state.field.title_of(best)}" in begun.canvas.hint
        hand.click(700, 350)
        hand.key(Key.Key_Return)
        assert begun.services.state.selected_class == best

    def test_never_to_what_is_not_in_sight(self, begun, hand):
        services = begun.services
        begun.actions_["suggest"].trigger()  # the nearest on the field comes next
        away = services.ghosts.out_of_sight
        assert "Middle line" in away
        assert self.finish(begun, hand, "Side line top") not in away | {"Side line top"}

    def test_without_a_fit_as_ever(self, begun, hand):
        services = begun.services
        services.live_fit.set_wanted(False)
        assert not services.ghosts.out_of_sight
        expected = next_element(
            services.state.field,
            append_points(services.state.annotation, "Side line top", (Point(0.1, 0.1),)),
            "Side line top",
            begun.canvas.editor.seen_before,
        )
        assert self.finish(begun, hand, "Side line top") == expected


def test_nothing_is_looked_for_twice(begun, hand, qtbot, monkeypatch):
    """The next ghost's points are there before Tab asks for them."""
    asked: list[str] = []
    original = ghosts_module.find_points

    def find(ghost, *rest):
        asked.append(ghost.name)
        return original(ghost, *rest)

    monkeypatch.setattr(ghosts_module, "find_points", find)
    go(begun, hand, qtbot)
    first, second = names(begun)[:2]
    qtbot.waitUntil(lambda: begun.services.ghosts.found(second) is not None)
    hand.key(Key.Key_Tab)
    assert current(begun) == second
    assert begun.services.ghosts.found(second) is not None
    hand.key(Key.Key_Tab, SHIFT)
    assert begun.services.ghosts.found(first) is not None
    assert asked.count(first) == asked.count(second) == 1


def test_a_search_that_fails_unexpectedly_does_not_end_the_searches(
    begun, hand, qtbot, told, monkeypatch
):
    bugs: list[BaseException] = []

    def fail(*_: Any) -> GhostPoints:
        raise ZeroDivisionError("in a search")

    with monkeypatch.context() as broken:
        broken.setattr(sys, "excepthook", lambda kind, error, trace: bugs.append(error))
        broken.setattr(ghosts_module, "find_points", fail)
        hand.key(Key.Key_Tab)
        qtbot.waitUntil(lambda: any("ZeroDivisionError" in text for text in told))
    assert len(bugs) == 1
    go(begun, hand, qtbot)


class TestState:
    """The ghosts of the state, without a hand."""

    @pytest.fixture
    def services(self, open_services, annotated, qtbot) -> Services:
        path = annotated / "00002.json"
        entries = json.loads(path.read_text())
        path.write_text(json.dumps({name: entries[name] for name in KEPT}))
        services = open_services(annotated)
        services.navigator.go_to(1)
        qtbot.waitUntil(lambda: services.live_fit.insight is not None)
        return services

    def test_a_walk(self, services):
        ghosts = services.ghosts
        known = [ghost.name for ghost in ghosts.known]
        assert known == sorted(known, key=services.state.field.index.__getitem__)
        assert ghosts.step(-1).name == known[-1]  # from behind
        assert ghosts.step(1) is None
        assert not ghosts.walking
        ghosts.go_to(known[1])
        ghosts.leave()
        assert ghosts.step(-1).name == known[0]  # on from where it was left
        ghosts.go_to("no ghost")
        assert ghosts.current.name == known[0]
        ghosts.set_wanted(False)
        assert not ghosts.walking
        assert ghosts.step(1) is None

    def test_behind_the_last_one_come_those_that_were_passed_over(self, services, qtbot):
        ghosts, ends = services.ghosts, []
        ghosts.ended.connect(lambda: ends.append(True))
        first, *_, last = [ghost.name for ghost in ghosts.known]
        ghosts.go_to(last)
        services.review.set_not_visible(services.state.frame.name, last, True)
        assert ghosts.current is None
        qtbot.waitUntil(lambda: ghosts.current is not None)
        assert ghosts.current.name == first
        for name in [ghost.name for ghost in ghosts.known]:
            services.review.set_not_visible(services.state.frame.name, name, True)
        qtbot.waitUntil(lambda: not ghosts.walking)
        assert ends == [True]

    def test_another_frame_ends_the_walk(self, services):
        services.ghosts.step(1)
        services.navigator.go_to(2)
        assert not services.ghosts.walking
        assert services.ghosts.painted == ()

    def test_another_window_says_what_cannot_be_seen(self, services, annotated, qtbot):
        name = services.ghosts.known[0].name
        settings: list[str] = []
        services.review.settingChanged.connect(settings.append)
        theirs = WorkspaceDatabase.open(annotated, "Ben")
        theirs.set_not_visible(services.state.frame.name, name, True)
        theirs.set_setting("length", "104.3")
        assert theirs.close()

        def gone() -> bool:
            services.review.poll()
            return name not in [ghost.name for ghost in services.ghosts.painted]

        qtbot.waitUntil(gone)
        assert settings == ["length"]
        assert services.review.setting("length") == "104.3"

    def test_what_was_found_goes_with_its_insight(self, services, qtbot):
        ghosts = services.ghosts
        name = ghosts.step(1).name
        qtbot.waitUntil(lambda: ghosts.found(name) is not None)
        services.editing.commit_edit("shorten", delete_point(services.state.annotation, KEPT[3], 0))
        assert ghosts.found(name) is None
        assert ghosts.walking  # and goes on where it was
        qtbot.waitUntil(lambda: ghosts.current is not None)
        assert ghosts.current.name == name


def test_points_in_pictures_of_frames_that_were_left_are_let_go(begun, hand, qtbot):
    """Each keeps the picture alive that it was looked for in."""
    name = go(begun, hand, qtbot)
    begun.services.navigator.go_to(2)
    begun.services.navigator.go_to(1)
    assert begun.services.ghosts.found(name) is None
    wait_for_ghosts(begun, qtbot)
    assert go(begun, hand, qtbot) == name
