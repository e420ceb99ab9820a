"""The field of a dataset: as it says, as its classes say, as its file says."""

import json
import os
import threading
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.layout import FIELD_FILE
from procc_annotator.field.load import builtin_field_file, load_field
from procc_annotator.field.model import Field
from procc_annotator.gui.commands.field.field_choosing import FieldBar, FieldChoosing
from procc_annotator.gui.settings import Settings
from procc_annotator.gui.state.services import Services
from tests.gui.conftest import heard, let_work_end
from tests.gui.own_field import YARD, annotate

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
