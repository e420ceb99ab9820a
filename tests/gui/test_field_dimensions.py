"""The dimensions of a dataset's field: the picture, map, scores and fit go by them at once."""

import json
import threading
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialogButtonBox

from procc_annotator.batch.joint_calibration import Estimate, estimate_dimensions
from procc_annotator.field.load import load_field
from procc_annotator.gui.commands import field_dimensions
from procc_annotator.gui.commands.field_dimensions import (
    FieldDimensionsDialog,
    FieldDimensionsTask,
)
from procc_annotator.gui.panels.field_map.field_map_panel import FieldMapPanel
from procc_annotator.gui.panels.scores import ScoresPanel
from procc_annotator.gui.state.services import Services
from tests.gui.conftest import heard, let_work_end


@pytest.fixture
def task(services, widget) -> FieldDimensionsTask:
    widget.show()
    return FieldDimensionsTask(services, widget)


def asked(task: FieldDimensionsTask) -> FieldDimensionsDialog:
    task.ask()
    dialog = task.dialog
    assert dialog is not None
    return dialog


def enter(dialog: FieldDimensionsDialog, **values: float) -> None:
    for name, value in values.items():
        dialog.boxes[name].setValue(value)


def sides(dialog: FieldDimensionsDialog) -> dict[str, float]:
    return {name: dialog.values[name] for name in ("length", "width")}


@pytest.fixture
def services(open_services, annotated, qtbot) -> Services:
    """A well annotated frame of the sample, judged by its true camera."""
    services = open_services(annotated)
    assert services.camera_sources.load_cameras(annotated / "cameras" / "true")
    services.navigator.go_to(1)
    qtbot.waitUntil(lambda: services.live_fit.result is not None)
    qtbot.waitUntil(lambda: services.scorer.score is not None)
    return services


def test_everything_goes_by_what_is_entered(show, task, services, qtbot):
    scores, field_map = ScoresPanel(services), FieldMapPanel(services)
    show(scores)
    before = services.scorer.score
    fit = services.live_fit.result
    bounds = field_map._shape.ground
    dialog = asked(task)
    assert sides(dialog) == {"length": 105.0, "width": 68.0}
    assert dialog.note.isHidden()
    enter(dialog, length=101.3, width=66.2)
    assert "nominal field (length 105 m, width 68 m" in dialog.note.text()
    qtbot.waitUntil(lambda: services.state.field.described == "soccer 101.3 x 66.2 m")
    assert services.scorer.score.jac < before.jac
    assert field_map._shape.ground[2] < bounds[2]
    qtbot.waitUntil(lambda: "soccer 101.3 x 66.2 m" in scores.terms.text())
    qtbot.waitUntil(lambda: services.live_fit.result not in (None, fit))
    assert services.live_fit.result.mean_px > fit.mean_px
    dialog.reject()
    qtbot.waitUntil(lambda: services.state.field.is_nominal)
    assert services.scorer.score.jac == before.jac
    assert services.review.database.setting("field_dimensions") is None


def test_the_dataset_keeps_them_until_they_are_nominal_again(
    task, services, qtbot, annotated, dataset
):
    dialog = asked(task)
    enter(dialog, length=101.3)
    dialog.accept()
    assert task.dialog is None
    qtbot.waitUntil(lambda: services.state.field.described == "soccer 101.3 x 68 m")
    kept = json.loads(services.review.database.setting("field_dimensions"))
    assert kept["dimensions"] == {"length": 101.3}
    assert services.opening.open_path(dataset)  # another dataset has a field of its own
    assert services.state.field.is_nominal
    assert services.state.setup.field.is_nominal
    assert services.opening.open_path(annotated)
    assert services.state.field.described == "soccer 101.3 x 68 m"
    assert services.state.setup.field is services.state.field
    assert services.state.workspace.field is services.state.field
    dialog = asked(task)
    dialog.nominal_button.click()
    assert sides(dialog) == {"length": 105.0, "width": 68.0}
    dialog.findChild(QDialogButtonBox).accepted.emit()
    qtbot.waitUntil(lambda: services.state.field.is_nominal)
    assert services.review.database.setting("field_dimensions") is None


def test_what_is_kept_is_kept_when_the_dataset_is_left_at_once(task, services, annotated, dataset):
    dialog = asked(task)
    enter(dialog, length=101.3)
    dialog.accept()
    assert services.opening.open_path(dataset)
    assert services.state.field.is_nominal
    assert services.opening.open_path(annotated)
    assert services.state.field.described == "soccer 101.3 x 68 m"


def test_the_last_numbers_count(services, qtbot):
    for length in (99.0, 100.0, 101.0):
        services.field_choice.resize({"length": length}, keep=False)
    services.field_choice.resize({"length": 200.0}, keep=False)  # no rules allow it
    services.field_choice.resize({"length": 102.0}, keep=False)
    let_work_end(qtbot)
    assert services.state.field.dimension("length").value == 102.0
    services.field_choice.resize({"length": 103.0}, keep=False)
    services.evaluation.set_field(load_field("soccer", width=66.0))
    let_work_end(qtbot)
    services.field_choice.resize({"length": 103.0})
    services.evaluation.set_field(load_field("tennis"))
    let_work_end(qtbot)
    assert services.state.field.name == "tennis"


def test_the_set_tells_its_dimensions(task, services, qtbot):
    dialog = asked(task)
    enter(dialog, width=66.2)
    dialog.estimate_button.click()
    assert dialog.estimate_button.text() == "Stop"
    qtbot.waitUntil(lambda: not dialog.found.isHidden())
    assert dialog.estimate_button.text() == "Estimate from this set"
    assert dialog.values["width"] == pytest.approx(68, abs=0.4)
    assert "Width: " in dialog.found.text()
    assert " ± " in dialog.found.text()
    assert "From the cameras of" in dialog.found.text()
    dialog.reject()


def test_frames_of_stadiums_take_no_part(services, task, annotated, qtbot, monkeypatch):
    """What is found is for the others, as the dialog says."""
    (annotated / "stadiums.csv").write_text("frame,stadium,width\n00001,A,64\n00002,A,64\n")
    assert services.opening.open_path(annotated)
    looked_at: list[str] = []

    def note(read: Any, *terms: Any, **more: Any) -> Estimate:
        looked_at.extend(read)
        return estimate_dimensions({}, *terms, **more)

    monkeypatch.setattr(field_dimensions, "estimate_dimensions", note)
    dialog = asked(task)
    dialog.estimate_button.click()
    qtbot.waitUntil(lambda: not dialog.found.isHidden())
    assert "No frame has a camera" in dialog.found.text()  # as where all have stadiums
    names = [frame.name for frame in services.state.workspace.frames]
    assert looked_at == [name for name in names if name not in ("00001", "00002")]
    dialog.reject()


def test_the_estimate_can_be_stopped(task, services, qtbot, monkeypatch):
    begun, go_on, looked_at = threading.Event(), threading.Event(), []

    def hold(*terms: Any, progress: Callable[[int, int], None], **more: Any) -> Estimate:
        begun.set()
        assert go_on.wait(20)

        def count(done: int, total: int) -> None:
            progress(done, total)
            looked_at.append(done)

        return estimate_dimensions(*terms, progress=count, **more)

    monkeypatch.setattr(field_dimensions, "estimate_dimensions", hold)
    dialog = asked(task)
    before = dialog.values
    dialog.estimate_button.click()
    assert begun.wait(20)
    dialog.estimate_button.click()
    assert dialog.estimate_button.text() == "Estimate from this set"
    assert dialog.bar.isHidden()
    go_on.set()
    let_work_end(qtbot)
    assert not looked_at  # it is left, not only kept silent
    assert dialog.found.isHidden()
    assert dialog.values == before
    dialog.reject()


def test_another_dataset_closes_the_question(task, services, dataset):
    dialog = asked(task)
    enter(dialog, length=100.0)
    assert services.opening.open_path(dataset)
    assert task.dialog is None
    assert services.state.field.is_nominal


def test_whatever_the_rules_leave_open_can_be_set(task, services, qtbot):
    services.evaluation.set_field(load_field("tennis"))
    dialog = asked(task)
    assert set(dialog.boxes) == {d.name for d in services.state.field.dimensions if d.is_open}
    box = dialog.boxes["line_width"]
    assert (box.minimum(), box.maximum(), box.decimals()) == (0.025, 0.05, 3)
    assert not dialog.estimate_button.isEnabled()  # the rules fix length and width
    box.setValue(0.03)
    qtbot.waitUntil(lambda: services.state.field.dimension("line_width").value == 0.03)
    dialog.accept()
    let_work_end(qtbot)
    kept = json.loads(services.review.database.setting("field_dimensions"))
    assert kept == {"field": "tennis", "dimensions": {"line_width": 0.03}}
    dialog = asked(task)
    services.evaluation.set_field(load_field("soccer"))
    assert task.dialog is None  # the numbers were another field's
    handball = load_field("handball")  # the rules fix all of it, but not where clicks lie
    services.evaluation.set_field(handball)
    dialog = asked(task)
    assert not dialog.boxes
    assert dialog.lines_box.isVisible()
    dialog.reject()
    let_work_end(qtbot)
    unpainted = tuple(replace(e, line_width=0.0, inside=None) for e in handball.elements)
    services.evaluation.set_field(replace(handball, elements=unpainted))
    told = heard(services)
    task.ask()
    assert task.dialog is None
    assert told == ["the rules fix every dimension of the field Handball"]


def test_clicks_lie_on_the_middle_of_the_paint(task, services, qtbot, annotated, dataset):
    before = services.scorer.score
    dialog = asked(task)
    dialog.lines_box.setCurrentText("the middle of the paint")
    assert "where the rules measure" in dialog.note.text()
    qtbot.waitUntil(lambda: services.state.field.described == "soccer, lines at their middle")
    qtbot.waitUntil(lambda: services.scorer.score.mean_error > before.mean_error)
    dialog.reject()
    qtbot.waitUntil(lambda: services.state.field == load_field("soccer"))
    dialog = asked(task)
    dialog.lines_box.setCurrentText("the middle of the paint")
    dialog.accept()
    assert services.opening.open_path(dataset)  # at once, and it has a choice of its own
    assert services.state.field.lines == "measured"
    assert services.opening.open_path(annotated)
    assert services.state.field.lines == "middle"
    services.field_choice.choose("basketball_fiba")  # the clicks are the same
    qtbot.waitUntil(lambda: services.state.field.name == "basketball_fiba")
    assert services.state.field.lines == "middle"
    dialog = asked(task)
    dialog.nominal_button.click()
    assert dialog.lines_box.currentText() == "where the rules measure"
    dialog.accept()
    qtbot.waitUntil(lambda: services.state.field.lines == "measured")
    assert services.review.database.setting("field_lines") is None


@pytest.mark.parametrize("typed", ["101,3", "101.3"])
def test_a_decimal_comma_is_a_point(task, services, qtbot, typed):
    dialog = asked(task)
    qtbot.waitUntil(dialog.isActiveWindow)
    box = dialog.boxes["length"]
    box.selectAll()
    QTest.keyClicks(box, typed)
    assert dialog.values["length"] == 101.3
    QTest.keyClick(box, Qt.Key.Key_Return)  # keeps it
    qtbot.waitUntil(lambda: services.state.field.described == "soccer 101.3 x 68 m")
    assert "101.3" in (services.review.database.setting("field_dimensions") or "")


def test_a_number_outside_the_rules_is_told(task, services, qtbot):
    dialog = asked(task)
    qtbot.waitUntil(dialog.isActiveWindow)
    box, rule = dialog.boxes["length"], dialog.rules["length"]
    box.selectAll()
    QTest.keyClicks(box, "199")
    QTest.keyClick(box, Qt.Key.Key_Return)
    assert dialog.isVisible()  # what was entered is not what would be kept
    assert dialog.values["length"] == 105.0
    assert "not 199 m: the rules allow 90 to 120 m" in rule.text()
    box.selectAll()
    QTest.keyClicks(box, "100")
    assert "not 199 m" not in rule.text()
    QTest.keyClick(box, Qt.Key.Key_Return)
    qtbot.waitUntil(lambda: services.state.field.described == "soccer 100 x 68 m")
    assert task.dialog is None


def test_numbers_that_the_rules_do_not_allow_together_are_told(said, task, services, qtbot):
    dialog = asked(task)
    enter(dialog, length=90.0, width=88.0)
    qtbot.waitUntil(lambda: services.state.field.described == "soccer 90 x 88 m")
    enter(dialog, width=90.0)
    assert "length &gt; width, and 90 &gt; 90 does not hold" in dialog.broken.text()
    assert dialog.broken.isVisible()
    dialog.accept()
    let_work_end(qtbot)
    assert dialog.isVisible()
    assert services.state.field.described == "soccer 90 x 88 m"
    assert not said  # said once, where it is entered
    dialog.nominal_button.click()
    assert dialog.broken.isHidden()
    dialog.accept()
    qtbot.waitUntil(lambda: services.state.field.is_nominal)


def test_a_window_that_is_closed_changes_no_field_any_more(task, services, qtbot):
    dialog = asked(task)
    enter(dialog, length=101.0)
    qtbot.waitUntil(lambda: not services.state.field.is_nominal)
    services.close()
    changed: list[object] = []
    services.store.watch(lambda s: s.field, lambda: changed.append(services.state.field))
    dialog.reject()
    let_work_end(qtbot)
    assert not changed
