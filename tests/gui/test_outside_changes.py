"""Files that other windows and programs write: the window's figures are those of the files."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from pytestqt.qtbot import QtBot

from procc_annotator.field.load import load_field
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.panels.frames_model import RowInfo
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.source import open_source
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.session.evaluation_run import run_evaluation
from tests.gui.conftest import let_work_end, settle

if TYPE_CHECKING:
    from tests.gui.conftest import Hand, MakeWindow

HandOn = Callable[[MainWindow], "Hand"]
TAU = 5.0


def evaluated(dataset: Path, cameras: str = "true") -> dict[str, float]:
    """Frame name -> JaC as `evaluate` has it; "" is the set's mean."""
    source = open_source(dataset)
    collection = CameraCollection.open(dataset / "cameras" / cameras)
    run = run_evaluation(source, collection, EvaluationSetup(load_field()), [TAU])
    found = {result.name: result.scores[TAU].jac for result in run if result.scores}
    mean = run.summary()[TAU].mean_jac
    return {**found, "": mean if mean is not None else -1.0}


def shown(window: MainWindow, cameras: str = "true") -> dict[str, float]:
    """The same as the frame list and the Cameras panel have it."""
    document = window.document
    source = next(s for s in document.sources if s.name == cameras)
    found = {name: audit.jac_at(TAU) for name, audit in source.audits.items()}
    mean = source.mean_jac(TAU)
    return {**found, "": mean if mean is not None else -1.0}


def row(window: MainWindow, index: int) -> RowInfo:
    info = window.frames.model.info(window.frames.model.row_of(index))
    assert info is not None
    return info


def test_what_is_taken_back_counts_nowhere(
    audited: MainWindow, annotated: Path, hand_on: HandOn, qtbot: QtBot
) -> None:
    path = annotated / "00005.json"
    audited.document.go_to(4)
    settle(audited, qtbot)
    before = evaluated(annotated)
    hand_on(audited).draw("Middle line", (100, 100), (200, 200))
    assert path.exists()
    audited.actions_["undo"].trigger()
    settle(audited, qtbot)
    let_work_end(qtbot)
    assert not path.exists()
    assert evaluated(annotated) == before
    assert shown(audited) == pytest.approx(before, abs=1e-6)


def test_a_file_without_elements_counts_as_it_does_for_evaluate(
    make_window: MakeWindow, annotated: Path, qtbot: QtBot
) -> None:
    (annotated / "00003.json").write_text("{}")
    window = make_window(annotated)
    window.document.live_fit.set_wanted(False)
    window.document.load_cameras(annotated / "cameras" / "true")
    settle(window, qtbot)
    assert evaluated(annotated)["00003"] == 0.0
    assert shown(window) == pytest.approx(evaluated(annotated), abs=1e-6)
    window.document.go_to(2)
    assert "0.000" in window.toolbar.jac.text()
