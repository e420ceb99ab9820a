"""Files that other windows and programs write: the window's figures are those of the files."""

import json
from collections.abc import Callable
from operator import attrgetter
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QApplication

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.evaluation import run_evaluation
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import open_source
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.frame_rows import RowInfo
from procc_annotator.metrics.setup import EvaluationSetup
from tests.gui.conftest import Hand, heard, let_work_end, settle

HandOn = Callable[[MainWindow], "Hand"]
TAU = 5.0


def evaluated(dataset: Path, cameras: str = "true") -> dict[str, float]:
    """Frame name -> JaC as `evaluate` has it; "" is the set's mean."""
    source = open_source(dataset)
    collection = CameraCollection.open(dataset / "cameras" / cameras)
    run = run_evaluation(
        source, collection, EvaluationSetup(load_field()), [TAU], attrgetter("result")
    )
    found = {result.name: result.scores[TAU].jac for result in run if result.scores}
    mean = run.summary()[TAU].mean_jac
    return {**found, "": mean if mean is not None else -1.0}


def shown(window: MainWindow, cameras: str = "true") -> dict[str, float]:
    """The same as the frame list and the Cameras panel have it."""
    services = window.services
    source = next(s for s in services.state.sources if s.name == cameras)
    found = {name: audit.jac_at(TAU) for name, audit in source.audits.items()}
    mean = source.mean_jac(TAU)
    return {**found, "": mean if mean is not None else -1.0}


def row(window: MainWindow, index: int) -> RowInfo:
    info = window.frames.model.info(window.frames.model.row_of(index))
    assert info is not None
    return info


def test_what_is_taken_back_counts_nowhere(audited, annotated, hand_on, qtbot):
    path = annotated / "00005.json"
    audited.services.navigator.go_to(4)
    settle(audited.services, qtbot)
    before = evaluated(annotated)
    hand_on(audited).draw("Middle line", (100, 100), (200, 200))
    assert path.exists()
    audited.actions_["undo"].trigger()
    settle(audited.services, qtbot)
    let_work_end(qtbot)
    assert not path.exists()
    assert evaluated(annotated) == before
    assert shown(audited) == pytest.approx(before, abs=1e-6)


def test_a_file_without_elements_counts_as_it_does_for_evaluate(make_window, annotated, qtbot):
    (annotated / "00003.json").write_text("{}")
    window = make_window(annotated)
    window.services.live_fit.set_wanted(False)
    window.services.camera_sources.load_cameras(annotated / "cameras" / "true")
    settle(window.services, qtbot)
    assert evaluated(annotated)["00003"] == 0.0
    assert shown(window) == pytest.approx(evaluated(annotated), abs=1e-6)
    window.services.navigator.go_to(2)
    qtbot.waitUntil(lambda: "0.000" in window.top_bar.camera_bar.jac.text())


def change(path: Path, keep: int) -> None:
    """Another program leaves the first elements of an annotation only."""
    entries = list(json.loads(path.read_text()).items())
    path.write_text(json.dumps(dict(entries[:keep])))


def test_a_file_written_after_the_set_was_judged_counts_when_its_frame_is_visited(
    audited, annotated, qtbot
):
    services = audited.services
    row(audited, 5)
    qtbot.waitUntil(lambda: row(audited, 5).count not in (None, 3))
    change(annotated / "00006.json", 3)
    services.navigator.go_to(5)
    settle(audited.services, qtbot)
    let_work_end(qtbot)
    expected = evaluated(annotated)
    assert f"{expected['00006']:.3f}" in audited.top_bar.camera_bar.jac.text()
    assert shown(audited) == pytest.approx(expected, abs=1e-6)
    assert shown(audited, "bad") == pytest.approx(evaluated(annotated, "bad"), abs=1e-6)
    assert row(audited, 5).count == 3
    (annotated / "00006.json").unlink()
    services.editing.look_at_frame()
    assert not services.state.annotation.annotated
    qtbot.waitUntil(lambda: "nothing annotated" in audited.top_bar.camera_bar.jac.text())
    change(annotated / "00002.json", 2)  # it was on screen already
    services.navigator.go_to(1)
    assert len(services.state.annotation.annotated) == 2
    for _ in range(2):  # it is somebody else's work: the first time is told only
        services.editing.undo()
    assert len(services.state.annotation.annotated) > 2  # what was read is a step of the history


def test_the_whole_set_follows_once_the_window_is_active_again(audited, annotated, qtbot):
    services = audited.services
    services.navigator.go_to(2)
    services.navigator.go_to(1)
    for index in (2, 5, 3):
        row(audited, index)
    qtbot.waitUntil(lambda: row(audited, 3).count is not None)
    change(annotated / "00003.json", 2)  # visited before
    change(annotated / "00006.json", 3)  # never
    (annotated / "00004.json").unlink()
    (annotated / "00002.json").write_text("{")  # on screen
    (annotated / "00005.json").write_text("{}")
    activate(audited)
    let_work_end(qtbot)
    settle(audited.services, qtbot)
    assert shown(audited) == pytest.approx(evaluated(annotated), abs=1e-6)
    qtbot.waitUntil(lambda: [row(audited, i).count for i in (2, 5, 3)] == [2, 3, 0])
    assert "00002.json" in audited.frame_bar.label.text()
    assert row(audited, 1).jac is None


def test_a_file_in_the_middle_of_being_written_costs_no_history(audited, annotated, hand_on):
    services, path = audited.services, annotated / "00002.json"
    hand_on(audited).draw("Middle line", (100, 100), (200, 200))
    whole = path.read_text()
    said = heard(services)
    path.write_text(whole[:20])
    services.editing.look_at_frame()
    assert not said  # it was not read; the frame says why
    assert not services.state.editable
    assert not services.state.annotation.annotated
    path.write_text(whole)
    services.editing.look_at_frame()
    assert services.state.editable
    assert "read again" in said[-1]
    drawn = services.state.annotation
    services.editing.undo()
    assert services.state.annotation != drawn


def test_own_edits_that_are_not_saved_stay(audited, annotated, hand_on, qtbot):
    change(annotated / "00002.json", 2)
    hand_on(audited).draw("Middle line", (100, 100), (200, 200))
    change(annotated / "00002.json", 1)
    audited.services.state.workspace.edit(1, "mine", FrameAnnotation())
    activate(audited)
    let_work_end(qtbot)
    assert not audited.services.state.workspace.read(1).annotated
    assert audited.services.saver.save(1) is False
    assert not audited.conflict_bar.isHidden()


def test_the_frame_on_screen_follows_its_file_at_once(audited, annotated, qtbot):
    change(annotated / "00002.json", 2)
    qtbot.waitUntil(lambda: len(audited.services.state.annotation.annotated) == 2)


@pytest.mark.parametrize("how", ["active again", "visited"])
def test_cameras_written_anew_are_judged(audited, annotated, qtbot, how):
    cameras = annotated / "cameras"
    services = audited.services
    assert services.scorer.score.jac == pytest.approx(1.0)
    for frame in ("00002", "00003"):
        worse = (cameras / "bad" / f"camera_{frame}.json").read_text()
        (cameras / "true" / f"camera_{frame}.json").write_text(worse)
    (cameras / "true" / "camera_00006.json").unlink()
    if how == "visited":
        services.navigator.go_to(2)
    else:
        activate(audited)
    let_work_end(qtbot)
    settle(audited.services, qtbot)
    expected = evaluated(annotated)
    assert expected["00002"] < 1.0
    assert "00006" not in expected
    assert shown(audited) == pytest.approx(expected, abs=1e-6)
    assert services.scorer.score.jac == pytest.approx(expected[services.state.frame.name])


def test_a_frame_that_no_figure_counts_has_no_score(audited, annotated, hand_on, qtbot):
    services, judged = audited.services, audited.top_bar.camera_bar
    audited.panels.show("scores")
    services.navigator.go_to(4)
    assert services.scorer.score is not None  # its projection is drawn all the same
    qtbot.waitUntil(lambda: judged.jac.text() == "nothing annotated yet")
    scores = audited.scores
    qtbot.waitUntil(lambda: "nothing annotated yet" in scores.empty.text())
    assert scores.empty.isVisible()
    hand_on(audited).draw("Middle line", (100, 100), (200, 200))
    qtbot.waitUntil(lambda: judged.jac.text() != "nothing annotated yet")
    qtbot.waitUntil(lambda: not scores.empty.isVisible())
    (annotated / "00003.json").write_text("{")
    services.navigator.go_to(2)
    qtbot.waitUntil(lambda: "annotation cannot be read" in judged.jac.text())
    qtbot.waitUntil(lambda: "annotation cannot be read" in scores.empty.text())


def activate(window: MainWindow) -> None:
    """As the window system tells that the window is the active one again."""
    QApplication.sendEvent(window, QEvent(QEvent.Type.ActivationChange))
