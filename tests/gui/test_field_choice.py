"""Choosing the field of a dataset in the real window: menu, guess, mismatch, own files."""

import shutil

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.layout import FIELD_FILE
from procc_annotator.field.load import field_titles, load_field
from procc_annotator.gui.element_keys import element_keys, key_text
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import heard
from tests.gui.own_field import YARD, annotate

pytestmark = [
    pytest.mark.new_window,  # the field of a window is the next dataset's
]


def choose(window: MainWindow, title: str, qtbot: QtBot) -> None:
    menu = window.actions_.menus["File/Field"]
    menu.aboutToShow.emit()
    (action,) = [a for a in menu.actions() if a.text() == title]
    told = heard(window.services)
    action.trigger()
    qtbot.waitUntil(lambda: f"from now on: {title}" in " ".join(told), timeout=20_000)
    assert window.services.state.field.title == title


def listed(window: MainWindow) -> set[str]:
    window.panels.show("elements")
    return set(window.elements._items)


def test_everything_follows_the_field_and_nothing_is_lost(window, hand, qtbot, dataset, saved):
    services = window.services
    hand.draw("Middle line", (100, 100), (300, 200))
    hand.draw("Circle central", (200, 200), (240, 220), (260, 260))
    before = saved("Middle line")
    services.selection.select_class("Circle central")
    choose(window, "Basketball (FIBA)", qtbot)
    field = services.state.field
    qtbot.waitUntil(lambda: field.elements[0].name in listed(window))
    assert "Side line top" not in listed(window)
    assert {"Middle line", "Circle central"} <= listed(window)  # still in the file, so still there
    assert window.field_map._shape.names == tuple(e.name for e in field.elements)
    assert services.state.setup.field is services.state.workspace.field is field
    QTest.keyClick(window, Qt.Key.Key_9)
    assert field.title_of(services.state.selected_class) == "Centre line"
    window.commands.show_keys()
    assert any("Left endline" in row.text for row in window.commands._sheet.table.shown())
    titles = [window.plots.classes.itemText(i) for i in range(window.plots.classes.count())]
    assert titles == ["All elements", *(e.title for e in field.elements)]
    services.editing.undo()
    assert services.state.annotation.get("Circle central") is None
    services.editing.redo()
    assert services.state.annotation.get("Circle central") is not None
    assert (saved("Middle line") == before).all()
    choose(window, "Soccer", qtbot)
    qtbot.waitUntil(lambda: "Side line top" in listed(window))


def test_points_that_are_not_finished_are_finished_first(window, hand, qtbot, saved):
    window.services.selection.select_class("Middle line")
    hand.click(100, 100)
    hand.click(300, 200)
    choose(window, "Tennis", qtbot)
    assert len(saved("Middle line")) == 2
    assert window.services.state.selected_class == "Middle line"  # it is here, so it can be edited


def test_one_key_switches_to_the_field_that_fits(window, dataset, qtbot):
    choose(window, "Soccer", qtbot)
    annotate(dataset, "frame_0", [e.name for e in load_field("tennis").elements[:4]])
    assert window.services.opening.open_path(dataset)
    qtbot.waitUntil(lambda: not window.field_bar.isHidden(), timeout=20_000)
    keys = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    QTest.keyClick(window, Qt.Key.Key_F, keys)
    qtbot.waitUntil(lambda: window.services.state.field.name == "tennis", timeout=20_000)
    qtbot.waitUntil(lambda: window.field_bar.isHidden())


def test_files_used_before_are_offered(window, tmp_path, qtbot):
    path = tmp_path / "our court.toml"
    path.write_text(YARD)
    window.services.field_choice.choose(path)
    qtbot.waitUntil(lambda: window.services.state.field.name == "yard", timeout=20_000)
    menu = window.actions_.menus["File/Field"]
    menu.aboutToShow.emit()
    assert [a.text() for a in menu.actions() if a.isChecked()] == ["our court.toml"]
    assert set(field_titles().values()) <= {a.text() for a in menu.actions()}
    choose(window, "Tennis", qtbot)
    window.services.field_choice.choose(tmp_path / "gone.toml")
    qtbot.waitUntil(lambda: "gone.toml" in window.message_bar.label.text(), timeout=20_000)
    assert window.services.state.field.name == "tennis"


def test_keys_of_the_window_stay_its_own(window, tmp_path, qtbot):
    path = tmp_path / "yard.toml"
    twice = YARD.replace('shortcut = "1"', 'shortcut = "Ctrl+J, 1"')
    path.write_text(twice)
    services = window.services
    services.field_choice.take(load_field(path))
    assert set(element_keys(services.state.field)) == {"fence"}  # D goes to the next frame
    assert key_text(services.state.field, "gate") == ""
    QTest.keyClick(window, Qt.Key.Key_D)
    assert services.state.frame_index == 1
    QTest.keyClick(window, Qt.Key.Key_J, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClick(window, Qt.Key.Key_1)
    assert services.state.selected_class == "fence"
    services.field_choice.take(load_field("soccer"))
    services.selection.select_class(None)
    QTest.keyClick(window, Qt.Key.Key_1)
    assert services.state.field.title_of(services.state.selected_class) != "Fence"
    assert services.state.selected_class is not None


def test_a_reload_leaves_what_is_being_drawn(make_window, hand_on, dataset, qtbot, saved):
    path = dataset / FIELD_FILE
    path.write_text(YARD)
    window = make_window(dataset)
    hand, services = hand_on(window), window.services
    services.selection.select_class("gate")
    hand.click(100, 100)
    path.write_text(YARD.replace('title = "Gate"', 'title = "Great gate"'))
    qtbot.waitUntil(lambda: services.state.field.title_of("gate") == "Great gate", timeout=20_000)
    assert window.canvas.editor.drawing
    assert saved("gate").shape == (0, 2)
    hand.click(300, 200)
    hand.key(Qt.Key.Key_Return)
    assert len(saved("gate")) == 2
    services.selection.select_class("gate", continues=True)
    hand.click(200, 100)
    path.write_text(YARD.replace('name = "gate"', 'name = "door"'))  # the class is gone
    qtbot.waitUntil(lambda: services.state.field.knows("door"), timeout=20_000)
    assert not window.canvas.editor.drawing


def test_a_refused_choice_is_told_until_work_goes_on(make_window, dataset, tmp_path, qtbot):
    (dataset / FIELD_FILE).write_text(YARD)
    window = make_window(dataset)
    window.services.field_choice.choose("tennis")
    assert not window.message_bar.isHidden()
    window.services.selection.select_class("gate")
    assert window.message_bar.isHidden()
    other = tmp_path / "other"
    other.mkdir()
    (dataset / "frame_0.png").rename(other / "frame_0.png")
    (dataset / FIELD_FILE).unlink()
    assert window.services.opening.open_path(other)
    menu = window.actions_.menus["File/Field"]
    menu.aboutToShow.emit()
    assert "field.toml" not in [a.text() for a in menu.actions()]  # it is gone


def test_rows_below_a_heading_do_not_repeat_it(make_window, dataset, qtbot):
    window = make_window(dataset)
    choose(window, "Basketball (FIBA)", qtbot)
    panel = window.elements
    window.panels.show("elements")
    qtbot.waitUntil(lambda: window.services.state.field.elements[0].name in panel._items)
    rows = {
        (item.parent().text(0), item.text(0)): item.toolTip(0) for item in panel._items.values()
    }
    tip = rows["Left three-point line", "Far straight"]
    assert tip.startswith("Left three-point far straight\n")
    assert ("Left three-point line", "Near straight") in rows
    assert ("Court", "Far sideline") in rows  # nothing there is shared
    QTest.keyClicks(panel.search, "left three-point far")  # the whole title is searched
    assert [item.text(0) for item in panel._items.values() if not item.isHidden()] == [
        "Far straight"
    ]


def test_nothing_stays_chosen_when_another_dataset_opens(
    window, hand, tmp_path, dataset, sample_data, qtbot
):
    """The next click would write a class into files of another sport."""
    services, field = window.services, load_field("volleyball")
    services.field_choice.take(field)
    services.selection.select_class(field.elements[0].name)
    other = tmp_path / "other"
    other.mkdir()
    shutil.copy(sample_data / "00005.jpg", other)
    assert services.opening.open_path(other)
    assert services.state.field.name == "soccer"
    assert services.state.selected_class is None
    hand.click(100, 100)
    assert services.state.annotation.polylines == ()
    services.selection.select_class(
        "Middle line"
    )  # of this field too: it was chosen for other pictures
    assert services.opening.open_path(dataset)
    assert services.state.selected_class is None


def test_a_class_without_a_field_stays_in_its_frame(window, hand, qtbot):
    services = window.services
    hand.draw("Circle central", (200, 200), (240, 220), (260, 260))
    services.selection.select_class("Circle central")
    choose(window, "Tennis", qtbot)
    assert services.state.selected_class == "Circle central"
    services.navigator.next_frame()
    assert services.state.selected_class is None
    field = services.state.field
    services.selection.select_class(field.elements[0].name)
    services.navigator.next_frame()
    assert services.state.selected_class == field.elements[0].name
