"""The field of a dataset: as it says, as its classes say, as its file says."""

import json
import os
import shutil
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.layout import FIELD_FILE
from procc_annotator.field.load import builtin_field_file, field_titles, load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.commands.field_choosing import FieldBar, FieldChoosing
from procc_annotator.gui.keymap import element_keys, key_text
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.settings import Settings
from procc_annotator.gui.state.services import Services
from tests.gui.conftest import heard, let_work_end

YARD = """
name = "yard"
title = "Yard"
[dimensions]
length = { title = "Length", nominal = 20, minimum = 18, maximum = 22 }
width = { title = "Width", nominal = 10, minimum = 10, maximum = 10 }
[[elements]]
name = "fence"
title = "Fence"
group = "Lines"
colour = "#ff0000"
shortcut = "1"
kind = "line"
start = ["-length / 2", "5", "0"]
end = ["length / 2", "5", "0"]
[[elements]]
name = "gate"
title = "Gate"
group = "Lines"
colour = "#00ff00"
shortcut = "D"
kind = "line"
start = ["0", "-5", "0"]
end = ["0", "5", "0"]
"""


def annotate(folder: Path, name: str, classes: list[str]) -> None:
    points = [{"x": 0.2, "y": 0.4}, {"x": 0.6, "y": 0.5}]
    (folder / f"{name}.json").write_text(json.dumps(dict.fromkeys(classes, points)))


BASKETBALL = [element.name for element in load_field("basketball_fiba").elements]


@pytest.fixture
def bar(qtbot) -> FieldBar:
    made = FieldBar()
    qtbot.addWidget(made)
    return made


@pytest.fixture
def open_asked(open_services, bar, widget) -> Callable[[Path], Services]:
    """Open a dataset with the bar that asks about its field."""

    def make(path: Path) -> Services:
        services = open_services()
        FieldChoosing(services, Settings(), bar, widget)
        assert services.opening.open_path(path)
        return services

    return make


def choose(services: Services, name: str, qtbot: QtBot) -> None:
    told = heard(services)
    services.field_choice.choose(name)
    qtbot.waitUntil(lambda: any("from now on: " in text for text in told))
    assert services.state.field.name == name


def test_the_dataset_remembers_its_field(open_asked, bar, qtbot, dataset, tmp_path):
    services = open_asked(dataset)
    choose(services, "volleyball", qtbot)
    other = tmp_path / "other"
    other.mkdir()
    (dataset / "frame_0.png").rename(other / "frame_0.png")
    assert services.opening.open_path(other)
    assert services.state.field.name == "soccer"
    assert services.opening.open_path(dataset)
    assert services.state.field.name == "volleyball"


def asked(bar: FieldBar) -> bool:
    return bar.isVisible() and bar.label.text().startswith("Is this Basketball (FIBA)?")


def test_a_new_dataset_is_asked_about_by_its_classes(open_asked, bar, dataset, qtbot):
    annotate(dataset, "frame_1", BASKETBALL[:4])
    services = open_asked(dataset)
    qtbot.waitUntil(lambda: asked(bar))
    assert services.state.field.name == "soccer"  # nobody said so yet
    services.navigator.next_frame()
    let_work_end(qtbot)
    assert asked(bar)
    bar.switch_button.click()
    assert services.state.field.name == "basketball_fiba"
    assert bar.isHidden()
    services.opening.open_path(dataset)
    assert services.state.field.name == "basketball_fiba"  # at once: it is remembered


def test_a_no_holds_for_a_frame_that_is_still_looked_at(open_asked, bar, dataset, qtbot):
    annotate(dataset, "frame_0", BASKETBALL[:4])
    annotate(dataset, "frame_1", BASKETBALL[:3])
    services = open_asked(dataset)
    qtbot.waitUntil(lambda: asked(bar))
    services.navigator.next_frame()
    bar.no_button.click()
    let_work_end(qtbot)
    assert bar.isHidden()


def test_a_no_is_remembered(open_asked, bar, dataset, qtbot):
    annotate(dataset, "frame_0", BASKETBALL[:4])
    services = open_asked(dataset)
    qtbot.waitUntil(lambda: asked(bar))
    assert bar.no_button.text() == "No, Soccer"
    bar.no_button.click()
    let_work_end(qtbot)
    assert services.state.field.name == "soccer"
    assert bar.isHidden()
    services.opening.open_path(dataset)
    let_work_end(qtbot)
    assert not asked(bar)


@pytest.mark.parametrize("classes", [[], ["Middle line", "Side line top"], ["bench", "dugout"]])
def test_nothing_is_asked_where_soccer_fits_or_nothing_does(
    open_asked, bar, dataset, qtbot, classes
):
    annotate(dataset, "frame_1", classes)
    services = open_asked(dataset)
    let_work_end(qtbot)
    assert services.field_choice.question is None
    assert bar.isHidden()


def test_a_field_that_clashes_with_a_landmark_is_told(open_asked, bar, dataset, qtbot):
    annotate(dataset, "frame_1", BASKETBALL[:4])
    path = dataset / "landmarks.json"
    path.write_text(json.dumps({"landmarks": [{"name": BASKETBALL[4], "position": [1, 2, -3]}]}))
    services = open_asked(dataset)
    qtbot.waitUntil(lambda: asked(bar))
    told = heard(services)
    bar.switch_button.click()
    assert "has the name of a class" in told[-1]
    assert services.state.field.name == "soccer"
    # Nothing was chosen: once the landmark is gone it can be.
    path.unlink()
    assert services.opening.open_path(dataset)
    qtbot.waitUntil(lambda: asked(bar))
    bar.switch_button.click()
    assert services.state.field.name == "basketball_fiba"


def test_no_work_outlives_a_window_that_is_closed(open_asked, dataset, monkeypatch):
    annotate(dataset, "frame_1", ["Middle line"])
    began, may_go_on, ended = threading.Event(), threading.Event(), threading.Event()

    def slow(*_: object) -> None:
        began.set()
        may_go_on.wait(10)
        ended.set()

    monkeypatch.setattr("procc_annotator.gui.state.navigation.field_choice.mismatch_among", slow)
    services = open_asked(dataset)
    assert began.wait(10)
    threading.Timer(0.05, may_go_on.set).start()
    services.field_choice.close()
    assert ended.is_set()


def test_a_dataset_that_said_what_it_shows_is_not_guessed_at(open_asked, bar, dataset, qtbot):
    services = open_asked(dataset)
    choose(services, "soccer", qtbot)
    annotate(dataset, "frame_0", BASKETBALL[:4])
    assert services.opening.open_path(dataset)
    qtbot.waitUntil(lambda: not bar.isHidden())
    assert services.state.field.name == "soccer"
    text = bar.label.text()
    assert "Soccer does not know any of the 4 classes" in text
    assert "Basketball (FIBA) knows all" in text
    assert bar.switch_button.text() == "Switch to Basketball (FIBA)"
    services.navigator.next_frame()
    assert bar.isHidden()
    services.navigator.previous_frame()
    qtbot.waitUntil(lambda: not bar.isHidden())
    bar.close_button.click()
    assert bar.isHidden()
    services.navigator.next_frame()
    services.navigator.previous_frame()
    let_work_end(qtbot)
    assert bar.isHidden()  # somebody does not want to hear of it


def test_spellings_follow_the_field(open_asked, dataset, qtbot):
    annotate(dataset, "frame_0", ["Goal left post left"])  # the official name ends in a space
    services = open_asked(dataset)
    assert services.state.annotation.annotated == ("Goal left post left ",)
    services.evaluation.set_field(load_field("tennis"))
    assert services.opening.open_path(dataset)
    assert services.state.annotation.annotated == ("Goal left post left",)
    services.evaluation.set_field(load_field("soccer"))
    assert services.state.annotation.annotated == ("Goal left post left ",)
    assert not services.state.workspace.dirty_frames()


def test_what_showing_a_field_takes_is_worked_out_before(open_asked, dataset, qtbot):
    services = open_asked(dataset)
    order: list[tuple[str, bool]] = []

    def note(field: Field) -> None:
        order.append((field.name, threading.current_thread() is threading.main_thread()))

    services.field_choice.preparing.append(note)
    services.store.watch(lambda s: s.field, lambda: note(services.state.field))
    services.field_choice.choose("tennis")
    qtbot.waitUntil(lambda: len(order) == 2)
    services.field_choice.resize({"line_width": 0.04})
    qtbot.waitUntil(lambda: len(order) == 4)
    assert order == [("tennis", False), ("tennis", True)] * 2


@pytest.mark.parametrize("replaced", [False, True])
def test_a_file_of_ones_own_is_read_as_it_is_written(open_asked, bar, dataset, qtbot, replaced):
    path = dataset / FIELD_FILE
    path.write_text(YARD)
    services = open_asked(dataset)
    assert services.state.field.title == "Yard"
    services.field_choice.resize({"length": 21})
    qtbot.waitUntil(lambda: services.state.field.described == "yard 21 x 10 m")

    def write(text: str) -> None:
        if not replaced:
            path.write_text(text)
            return
        new = path.with_suffix(".new")
        new.write_text(text)
        os.replace(new, path)

    write(YARD.replace('title = "Gate"', 'title = "Great gate"'))
    qtbot.waitUntil(lambda: services.state.field.title_of("gate") == "Great gate")
    assert services.state.field.described == "yard 21 x 10 m"
    write(YARD.replace('"length / 2", "5"', '"lenght / 2", "5"'))
    qtbot.waitUntil(lambda: not bar.isHidden())
    text = bar.label.text()
    assert str(path) in text
    assert "element 'fence'.end" in text
    assert "did you mean 'length'" in text
    assert services.state.field.title_of("gate") == "Great gate"  # the last good one stays
    write(YARD)
    qtbot.waitUntil(lambda: services.state.field.title_of("gate") == "Gate")
    assert bar.isHidden()


def test_a_broken_file_is_waited_for(open_asked, bar, dataset, qtbot):
    (dataset / FIELD_FILE).write_text("name = ")
    services = open_asked(dataset)
    assert services.state.field.name == "soccer"
    assert FIELD_FILE in bar.label.text()
    assert not bar.isHidden()
    (dataset / FIELD_FILE).write_text(YARD)
    qtbot.waitUntil(lambda: services.state.field.name == "yard")
    assert bar.isHidden()


def test_the_file_in_the_dataset_decides(open_asked, dataset, qtbot):
    (dataset / FIELD_FILE).write_text(YARD)
    services = open_asked(dataset)
    told = heard(services)
    services.field_choice.choose("tennis")
    assert "move that file away" in told[-1]
    assert services.state.field.name == "yard"


def test_where_a_file_decides_no_other_field_is_offered(
    open_asked, bar, widget, dataset, qtbot, monkeypatch
):
    court = load_field("basketball_fiba")
    text = builtin_field_file("basketball_fiba").read_text()
    first = f'name = "{court.elements[0].name}"'
    assert first in text
    (dataset / FIELD_FILE).write_text(text.replace(first, 'name = "another line"'))
    annotate(dataset, "frame_0", [court.elements[0].name])
    monkeypatch.chdir(dataset.parent)
    open_asked(Path(dataset.name))
    qtbot.waitUntil(lambda: not bar.isHidden())
    told = bar.label.text()
    assert "Basketball (FIBA) of field.toml does not know" in told
    assert "program's own Basketball (FIBA) knows all, but field.toml" in told
    assert bar.switch_button.isHidden()
    assert not bar.close_button.isHidden()
    menu = QMenu(widget)
    widget.findChild(FieldChoosing).fill(menu, menu.addAction("Browse"), QAction(menu))
    menu.aboutToShow.emit()
    assert [a.text() for a in menu.actions() if a.isChecked()] == ["field.toml"]


def test_a_path_is_told_as_it_is_written(bar):
    for text, shown in (("clips/field.toml: line 1", "clips/"), ("the field is gone", "The field")):
        bar.tell(text)
        assert bar.label.text().startswith(shown)


def choose_in(window: MainWindow, title: str, qtbot: QtBot) -> None:
    menu = window.actions_.menus["File/Field"]
    menu.aboutToShow.emit()
    (action,) = [a for a in menu.actions() if a.text() == title]
    told = heard(window.services)
    action.trigger()
    qtbot.waitUntil(lambda: f"from now on: {title}" in " ".join(told))
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
    choose_in(window, "Basketball (FIBA)", qtbot)
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
    choose_in(window, "Soccer", qtbot)
    qtbot.waitUntil(lambda: "Side line top" in listed(window))


def test_points_that_are_not_finished_are_finished_first(window, hand, qtbot, saved):
    window.services.selection.select_class("Middle line")
    hand.click(100, 100)
    hand.click(300, 200)
    choose_in(window, "Tennis", qtbot)
    assert len(saved("Middle line")) == 2
    assert window.services.state.selected_class == "Middle line"  # it is here, so it can be edited


def test_one_key_switches_to_the_field_that_fits(window, dataset, qtbot):
    choose_in(window, "Soccer", qtbot)
    annotate(dataset, "frame_0", [e.name for e in load_field("tennis").elements[:4]])
    assert window.services.opening.open_path(dataset)
    qtbot.waitUntil(lambda: not window.field_bar.isHidden())
    keys = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier
    QTest.keyClick(window, Qt.Key.Key_F, keys)
    qtbot.waitUntil(lambda: window.services.state.field.name == "tennis")
    qtbot.waitUntil(lambda: window.field_bar.isHidden())


def test_files_used_before_are_offered(window, tmp_path, qtbot):
    path = tmp_path / "our court.toml"
    path.write_text(YARD)
    window.services.field_choice.choose(path)
    qtbot.waitUntil(lambda: window.services.state.field.name == "yard")
    menu = window.actions_.menus["File/Field"]
    menu.aboutToShow.emit()
    assert [a.text() for a in menu.actions() if a.isChecked()] == ["our court.toml"]
    assert set(field_titles().values()) <= {a.text() for a in menu.actions()}
    choose_in(window, "Tennis", qtbot)
    window.services.field_choice.choose(tmp_path / "gone.toml")
    qtbot.waitUntil(lambda: "gone.toml" in window.message_bar.label.text())
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
    qtbot.waitUntil(lambda: services.state.field.title_of("gate") == "Great gate")
    assert window.canvas.editor.drawing
    assert saved("gate").shape == (0, 2)
    hand.click(300, 200)
    hand.key(Qt.Key.Key_Return)
    assert len(saved("gate")) == 2
    services.selection.select_class("gate", continues=True)
    hand.click(200, 100)
    path.write_text(YARD.replace('name = "gate"', 'name = "door"'))  # the class is gone
    qtbot.waitUntil(lambda: services.state.field.knows("door"))
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
    choose_in(window, "Basketball (FIBA)", qtbot)
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
    choose_in(window, "Tennis", qtbot)
    assert services.state.selected_class == "Circle central"
    services.navigator.next_frame()
    assert services.state.selected_class is None
