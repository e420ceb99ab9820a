"""The dimensions of a dataset's field: the picture, map, scores and fit go by them at once."""

from __future__ import annotations

import json
import threading
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialogButtonBox
from pytestqt.qtbot import QtBot

from procc_annotator.batch.joint_calibration import Estimate, estimate_dimensions
from procc_annotator.field.load import load_field
from procc_annotator.gui.commands.field import field_dimensions
from procc_annotator.gui.commands.field.field_dimensions import FieldDimensionsDialog
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import let_work_end


def asked(window: MainWindow) -> FieldDimensionsDialog:
    window.actions_["field_dimensions"].trigger()
    dialog = window.field_dimensions.dialog
    assert dialog is not None
    return dialog


def enter(dialog: FieldDimensionsDialog, **values: float) -> None:
    for name, value in values.items():
        dialog.boxes[name].setValue(value)


def sides(dialog: FieldDimensionsDialog) -> dict[str, float]:
    return {name: dialog.values[name] for name in ("length", "width")}


@pytest.fixture
def judged(make_window, annotated: Path, qtbot: QtBot) -> MainWindow:
    """The window on a well annotated frame of the sample, judged by its true camera."""
    window = make_window(annotated)
    assert window.document.camera_sources.load_cameras(annotated / "cameras" / "true")
    window.document.walk.go_to(1)
    qtbot.waitUntil(lambda: window.document.live_fit.result is not None, timeout=20_000)
    qtbot.waitUntil(lambda: window.document.judge.score is not None, timeout=20_000)
    return window


def test_everything_goes_by_what_is_entered(judged: MainWindow, qtbot: QtBot) -> None:
    document = judged.document
    judged.panels.show("scores")
    before = document.judge.score
    fit = document.live_fit.result
    assert before is not None
    bounds = judged.field_map._shape.ground
    dialog = asked(judged)
    assert sides(dialog) == {"length": 105.0, "width": 68.0}
    assert dialog.note.isHidden()
    enter(dialog, length=101.3, width=66.2)
    assert "nominal field (length 105 m, width 68 m" in dialog.note.text()
    qtbot.waitUntil(lambda: document.state.field.described == "soccer 101.3 x 66.2 m")
    assert document.judge.score is not None
    assert document.judge.score.jac < before.jac
    assert judged.field_map._shape.ground[2] < bounds[2]
    qtbot.waitUntil(lambda: "soccer 101.3 x 66.2 m" in judged.scores.terms.text())
    qtbot.waitUntil(lambda: document.live_fit.result not in (None, fit), timeout=20_000)
    assert document.live_fit.result.mean_px > fit.mean_px
    dialog.reject()
    qtbot.waitUntil(lambda: document.state.field.is_nominal)
    assert document.judge.score.jac == before.jac
    assert document.review.database.setting("field_dimensions") is None


def test_the_dataset_keeps_them_until_they_are_nominal_again(
    judged: MainWindow, qtbot: QtBot, annotated: Path, dataset: Path
) -> None:
    document = judged.document
    dialog = asked(judged)
    enter(dialog, length=101.3)
    dialog.accept()
    assert judged.field_dimensions.dialog is None
    qtbot.waitUntil(lambda: document.state.field.described == "soccer 101.3 x 68 m")
    kept = json.loads(document.review.database.setting("field_dimensions"))
    assert kept["dimensions"] == {"length": 101.3}
    assert document.opening.open_path(dataset)  # another dataset has a field of its own
    assert document.state.field.is_nominal
    assert document.state.setup.field.is_nominal
    assert document.opening.open_path(annotated)
    assert document.state.field.described == "soccer 101.3 x 68 m"
    assert document.state.setup.field is document.state.field
    assert document.state.workspace.field is document.state.field
    dialog = asked(judged)
    dialog.nominal_button.click()
    assert sides(dialog) == {"length": 105.0, "width": 68.0}
    dialog.findChild(QDialogButtonBox).accepted.emit()
    qtbot.waitUntil(lambda: document.state.field.is_nominal)
    assert document.review.database.setting("field_dimensions") is None


def test_what_is_kept_is_kept_when_the_dataset_is_left_at_once(
    judged: MainWindow, annotated: Path, dataset: Path
) -> None:
    document = judged.document
    dialog = asked(judged)
    enter(dialog, length=101.3)
    dialog.accept()
    assert document.opening.open_path(dataset)
    assert document.state.field.is_nominal
    assert document.opening.open_path(annotated)
    assert document.state.field.described == "soccer 101.3 x 68 m"


def test_the_last_numbers_count(judged: MainWindow, qtbot: QtBot) -> None:
    document = judged.document
    for length in (99.0, 100.0, 101.0):
        document.field_choice.resize({"length": length}, keep=False)
    document.field_choice.resize({"length": 200.0}, keep=False)  # no rules allow it
    document.field_choice.resize({"length": 102.0}, keep=False)
    let_work_end(qtbot)
    assert document.state.field.dimension("length").value == 102.0
    document.field_choice.resize({"length": 103.0}, keep=False)
    document.terms.set_field(load_field("soccer", width=66.0))
    let_work_end(qtbot)
    document.field_choice.resize({"length": 103.0})
    document.terms.set_field(load_field("tennis"))
    let_work_end(qtbot)
    assert document.state.field.name == "tennis"


def test_the_set_tells_its_dimensions(judged: MainWindow, qtbot: QtBot) -> None:
    dialog = asked(judged)
    enter(dialog, width=66.2)
    dialog.estimate_button.click()
    assert dialog.estimate_button.text() == "Stop"
    qtbot.waitUntil(lambda: not dialog.found.isHidden(), timeout=60_000)
    assert dialog.estimate_button.text() == "Estimate from this set"
    assert dialog.values["width"] == pytest.approx(68, abs=0.4)
    assert "Width: " in dialog.found.text()
    assert " ± " in dialog.found.text()
    assert "From the cameras of" in dialog.found.text()
    dialog.reject()


def test_frames_of_stadiums_take_no_part(
    make_window, annotated: Path, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What is found is for the others, as the dialog says."""
    (annotated / "stadiums.csv").write_text("frame,stadium,width\n00001,A,64\n00002,A,64\n")
    window = make_window(annotated)
    looked_at: list[str] = []

    def note(read: Any, *terms: Any, **more: Any) -> Estimate:
        looked_at.extend(read)
        return estimate_dimensions({}, *terms, **more)

    monkeypatch.setattr(field_dimensions, "estimate_dimensions", note)
    dialog = asked(window)
    dialog.estimate_button.click()
    qtbot.waitUntil(lambda: not dialog.found.isHidden(), timeout=20_000)
    assert "No frame has a camera" in dialog.found.text()  # as where all have stadiums
    names = [frame.name for frame in window.document.state.workspace.frames]
    assert looked_at == [name for name in names if name not in ("00001", "00002")]
    dialog.reject()


def test_the_estimate_can_be_stopped(
    judged: MainWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun, go_on, looked_at = threading.Event(), threading.Event(), []

    def hold(*terms: Any, progress: Callable[[int, int], None], **more: Any) -> Estimate:
        begun.set()
        assert go_on.wait(20)

        def count(done: int, total: int) -> None:
            progress(done, total)
            looked_at.append(done)

        return estimate_dimensions(*terms, progress=count, **more)

    monkeypatch.setattr(field_dimensions, "estimate_dimensions", hold)
    dialog = asked(judged)
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


def test_another_dataset_closes_the_question(judged: MainWindow, dataset: Path) -> None:
    dialog = asked(judged)
    enter(dialog, length=100.0)
    assert judged.document.opening.open_path(dataset)
    assert judged.field_dimensions.dialog is None
    assert judged.document.state.field.is_nominal


def test_whatever_the_rules_leave_open_can_be_set(window: MainWindow, qtbot: QtBot) -> None:
    document = window.document
    document.terms.set_field(load_field("tennis"))
    dialog = asked(window)
    assert set(dialog.boxes) == {d.name for d in document.state.field.dimensions if d.is_open}
    box = dialog.boxes["line_width"]
    assert (box.minimum(), box.maximum(), box.decimals()) == (0.025, 0.05, 3)
    assert not dialog.estimate_button.isEnabled()  # the rules fix length and width
    box.setValue(0.03)
    qtbot.waitUntil(lambda: document.state.field.dimension("line_width").value == 0.03)
    dialog.accept()
    let_work_end(qtbot)
    kept = json.loads(document.review.database.setting("field_dimensions"))
    assert kept == {"field": "tennis", "dimensions": {"line_width": 0.03}}
    dialog = asked(window)
    document.terms.set_field(load_field("soccer"))
    assert window.field_dimensions.dialog is None  # the numbers were another field's
    handball = load_field("handball")  # the rules fix all of it, but not where clicks lie
    document.terms.set_field(handball)
    dialog = asked(window)
    assert not dialog.boxes
    assert dialog.lines_box.isVisible()
    dialog.reject()
    let_work_end(qtbot)
    unpainted = tuple(replace(e, line_width=0.0, inside=None) for e in handball.elements)
    document.terms.set_field(replace(handball, elements=unpainted))
    told: list[str] = []
    document.store.events.message.connect(lambda m: told.append(m.text))
    window.actions_["field_dimensions"].trigger()
    assert window.field_dimensions.dialog is None
    assert told == ["the rules fix every dimension of the field Handball"]


def test_clicks_lie_on_the_middle_of_the_paint(
    judged: MainWindow, qtbot: QtBot, annotated: Path, dataset: Path
) -> None:
    document = judged.document
    before = document.judge.score
    dialog = asked(judged)
    dialog.lines_box.setCurrentText("the middle of the paint")
    assert "where the rules measure" in dialog.note.text()
    qtbot.waitUntil(lambda: document.state.field.described == "soccer, lines at their middle")
    qtbot.waitUntil(lambda: document.judge.score.mean_error > before.mean_error)
    dialog.reject()
    qtbot.waitUntil(lambda: document.state.field == load_field("soccer"))
    dialog = asked(judged)
    dialog.lines_box.setCurrentText("the middle of the paint")
    dialog.accept()
    assert document.opening.open_path(dataset)  # at once, and it has a choice of its own
    assert document.state.field.lines == "measured"
    assert document.opening.open_path(annotated)
    assert document.state.field.lines == "middle"
    document.field_choice.choose("basketball_fiba")  # the clicks are the same
    qtbot.waitUntil(lambda: document.state.field.name == "basketball_fiba")
    assert document.state.field.lines == "middle"
    dialog = asked(judged)
    dialog.nominal_button.click()
    assert dialog.lines_box.currentText() == "where the rules measure"
    dialog.accept()
    qtbot.waitUntil(lambda: document.state.field.lines == "measured")
    assert document.review.database.setting("field_lines") is None


@pytest.mark.parametrize("typed", ["101,3", "101.3"])
def test_a_decimal_comma_is_a_point(judged: MainWindow, qtbot: QtBot, typed: str) -> None:
    dialog = asked(judged)
    qtbot.waitUntil(dialog.isActiveWindow)
    box = dialog.boxes["length"]
    box.selectAll()
    QTest.keyClicks(box, typed)
    assert dialog.values["length"] == 101.3
    QTest.keyClick(box, Qt.Key.Key_Return)  # keeps it
    qtbot.waitUntil(lambda: judged.document.state.field.described == "soccer 101.3 x 68 m")
    assert "101.3" in (judged.document.review.database.setting("field_dimensions") or "")


def test_a_number_outside_the_rules_is_told(judged: MainWindow, qtbot: QtBot) -> None:
    dialog = asked(judged)
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
    qtbot.waitUntil(lambda: judged.document.state.field.described == "soccer 100 x 68 m")
    assert judged.field_dimensions.dialog is None


def test_numbers_that_the_rules_do_not_allow_together_are_told(
    judged: MainWindow, qtbot: QtBot
) -> None:
    document, dialog = judged.document, asked(judged)
    enter(dialog, length=90.0, width=88.0)
    qtbot.waitUntil(lambda: document.state.field.described == "soccer 90 x 88 m")
    enter(dialog, width=90.0)
    assert "length &gt; width, and 90 &gt; 90 does not hold" in dialog.broken.text()
    assert dialog.broken.isVisible()
    dialog.accept()
    let_work_end(qtbot)
    assert dialog.isVisible()
    assert document.state.field.described == "soccer 90 x 88 m"
    assert judged.message_bar.isHidden()  # said once, where it is entered
    dialog.nominal_button.click()
    assert dialog.broken.isHidden()
    dialog.accept()
    qtbot.waitUntil(lambda: document.state.field.is_nominal)


def test_a_window_that_is_closed_changes_no_field_any_more(
    judged: MainWindow, qtbot: QtBot
) -> None:
    document = judged.document
    dialog = asked(judged)
    enter(dialog, length=101.0)
    qtbot.waitUntil(lambda: not document.state.field.is_nominal)
    judged.close()
    changed: list[object] = []
    document.store.watch(lambda s: s.field, lambda: changed.append(document.state.field))
    dialog.reject()
    let_work_end(qtbot)
    assert not changed
