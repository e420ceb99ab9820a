"""Panels come by the kind of work: annotate, judge, review; each is found as it was left."""

from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QTabBar, QToolButton

from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import DESKS as KEPT
from procc_annotator.gui.settings import Settings
from procc_annotator.gui.window.workspaces import WORKSPACES
from tests.gui.conftest import all_done

InFront = Callable[[MainWindow, str], bool]
SHIFT = Qt.KeyboardModifier.ShiftModifier
JUDGE = set(WORKSPACES["judge"])


def opened(window: MainWindow) -> set[str]:
    """The panels that are open, in front of their tabs or not."""
    docks = {name for desk in WORKSPACES.values() for name in desk}
    return {name for name in docks if not window.docks[name].isHidden()}


@pytest.fixture
def in_front(qtbot) -> InFront:
    """Whether a panel comes to the front of its tabs: the window lays them out when it gets to it,
    and what it is doing else may take it more than one turn."""

    def comes(window: MainWindow, panel: str) -> bool:
        qtbot.waitUntil(lambda: not window.docks[panel].visibleRegion().isEmpty())
        return True

    return comes


def test_keys_and_buttons_turn_to_the_panels_of_a_work(window, in_front):
    assert opened(window) == set(WORKSPACES["annotate"])
    QTest.keyClick(window.canvas, Qt.Key.Key_F2, SHIFT)
    assert opened(window) == JUDGE
    assert in_front(window, "scores")
    button = window.workspace_switch.findChild(QToolButton, "desk_review")
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)
    assert opened(window) == {"review"}
    assert button.isChecked()
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)  # it is there already
    assert button.isChecked()
    assert opened(window) == {"review"}


def test_a_panel_that_is_asked_for_brings_its_work(window, in_front):
    window.panels.show("plots")
    assert window.actions_["desk_judge"].isChecked()
    assert in_front(window, "plots")
    window.panels.enter("elements")
    assert window.actions_["desk_annotate"].isChecked()
    assert in_front(window, "elements")


def test_each_is_found_as_it_was_left(window, in_front, qtbot):
    window.panels.show("fit")
    window.docks["scores"].close()
    all_done(qtbot)
    window.resizeDocks([window.docks["fit"]], [420], Qt.Orientation.Horizontal)
    all_done(qtbot)
    wide = window.docks["fit"].width()
    assert wide > 400
    window.panels.turn_to("annotate")
    window.resizeDocks([window.docks["elements"]], [300], Qt.Orientation.Horizontal)
    all_done(qtbot)
    window.panels.turn_to("judge")
    assert opened(window) == {"cameras", "fit", "plots"}
    assert in_front(window, "fit")
    all_done(qtbot)
    assert abs(window.docks["fit"].width() - wide) <= 2


def test_a_panel_that_was_torn_off_stays(window):
    window.panels.show("scores")
    window.docks["scores"].setFloating(True)
    window.panels.turn_to("annotate")
    assert not window.docks["scores"].isHidden()
    window.panels.show("scores")
    assert window.actions_["desk_annotate"].isChecked()  # it needs no turn
    window.panels.reset_layout()
    assert not window.docks["scores"].isFloating()
    assert opened(window) == set(WORKSPACES["annotate"])


def test_hidden_panels_come_back_with_a_work(window):
    window.panels.enter("elements")
    QTest.keyClick(window.elements.search, Qt.Key.Key_F11)
    assert window.canvas.hasFocus()
    assert window.focus_ring.widget is not window.field_map
    assert not opened(window)
    QTest.keyClick(window.canvas, Qt.Key.Key_F3, SHIFT)
    assert opened(window) == {"review"}
    assert not window.actions_["hide_panels"].isChecked()


@pytest.mark.new_window
def test_the_next_run_begins_at_the_same_work(make_window, dataset, in_front):
    first = make_window(dataset)
    first.panels.show("cameras")
    first.close()
    second = make_window(dataset)
    assert second.actions_["desk_judge"].isChecked()
    assert opened(second) == JUDGE
    assert in_front(second, "cameras")


@pytest.mark.new_window
def test_what_is_kept_in_another_form_is_passed_over(make_window, dataset):
    first = make_window(dataset)
    first.close()
    judge = {"open": ["nothing", "fit"], "front": "fit"}
    review = {"open": [], "front": "review", "width": "wide"}
    Settings().set(KEPT, {"desk": 7, "judge": judge, "review": review})
    second = make_window(dataset)
    assert opened(second) == set(WORKSPACES["annotate"])
    second.panels.turn_to("judge")
    assert opened(second) == {"fit"}
    second.panels.turn_to("review")
    assert opened(second) == {"review"}


@pytest.mark.new_window
@pytest.mark.parametrize("desk", WORKSPACES)
def test_no_tab_hides_behind_an_arrow(make_window, dataset, qtbot, desk):
    window = make_window(dataset, size=(1280, 720))
    qtbot.waitUntil(lambda: window.docks["elements"].width() >= 200)
    window.panels.turn_to(desk)
    all_done(qtbot)
    direct = Qt.FindChildOption.FindDirectChildrenOnly
    for bar in window.findChildren(QTabBar, options=direct):
        if bar.isVisible():
            assert bar.tabRect(bar.count() - 1).right() <= bar.width()


def test_plots_are_a_panel_like_the_others(window, in_front):
    QTest.keyClick(window.canvas, Qt.Key.Key_F5)
    assert in_front(window, "plots")
    QTest.keyClick(window.canvas, Qt.Key.Key_F5)
    assert opened(window) == JUDGE - {"plots"}
    window.panels.turn_to("annotate")
    window.panels.turn_to("judge")
    assert opened(window) == JUDGE - {"plots"}
    window.panels.show("plots")
    window.docks["plots"].setFloating(True)
    window.panels.turn_to("annotate")
    assert not window.docks["plots"].isHidden()


def test_frames_have_one_place(window, qtbot):
    """The strip below the picture, or the list with its filter, workspace by workspace."""
    strips, frames, film = window.strips, window.frames, window.strips.film
    assert strips.isVisible()
    assert frames.isHidden() or not frames.isVisible()
    at = film.visualRect(film.model().index(0, 2)).center()
    QTest.mouseClick(film.viewport(), Qt.MouseButton.LeftButton, pos=at)
    assert window.services.state.frame_index == 2
    QTest.keyClick(window.canvas, Qt.Key.Key_F, Qt.KeyboardModifier.ControlModifier)
    assert frames.isVisible()
    assert strips.isHidden()
    frames.filter.setText("frame_1")
    qtbot.waitUntil(lambda: frames.model.shown == 1)
    QTest.keyClick(window.canvas, Qt.Key.Key_F4, SHIFT)
    assert not frames.isVisible()
    assert window.canvas.hasFocus()
    assert "frame_1" in strips.filtered.text()
    assert film.model().columnCount() == 1
    QTest.mouseClick(strips.filtered, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: film.model().columnCount() == frames.model.total)
    assert strips.filtered.isHidden()
    window.panels.turn_to("review")
    assert frames.isVisible()
    assert strips.isHidden()
    window.panels.hide_all(True)
    assert strips.isHidden()
