"""What a window says and shows of a dataset when it opens it."""

import os
import runpy
import sys
from pathlib import Path

import pytest
from PySide6.QtWidgets import QTableView

from procc_annotator.gui.panels.scores import WORST
from procc_annotator.metrics.score import px_text

ROOT = Path(__file__).parents[2]


def test_pictures_are_ordered_by_their_names_without_suffix(dataset, make_window):
    for old, new in zip(sorted(dataset.iterdir()), ("a10", "a", "a2"), strict=True):
        old.rename(dataset / f"{new}{old.suffix}")
    workspace = make_window(dataset).services.state.workspace
    assert [frame.name for frame in workspace.frames] == ["a", "a2", "a10"]


def test_a_folder_that_cannot_be_written_is_told_of_before_work_begins(
    dataset, make_window, monkeypatch
):
    really = os.access

    def access(path: Path, mode: int) -> bool:
        return not (mode == os.W_OK and Path(path) == dataset) and really(path, mode)

    monkeypatch.setattr("os.access", access)
    window = make_window(dataset)
    assert f"{dataset} cannot be written" in window.message_bar.label.text()
    assert window.message_bar.isVisible()


def test_no_distance_reads_as_if_it_were_on_the_other_side_of_tau(audited, qtbot):
    """Threshold and distance differ by less than a tenth: in the picture and in the table."""
    services = audited.services
    services.camera_sources.set_active_camera(1)
    audited.panels.show("scores")
    table = audited.findChild(QTableView, "scores_table")
    distances = [
        e.max_distance for e in services.scorer.score.elements if e.max_distance is not None
    ]
    near = next(d for d in distances if 1 < d < 19 and 0.004 < d % 0.1 < 0.046)
    tau = round(near - near % 0.1, 1)
    services.evaluation.set_tau(tau)
    wanted = px_text(near, tau)
    assert float(wanted) > tau
    texts = [t for labels in audited.canvas.overlay_item.overlay.labels for t in labels.texts]
    assert wanted in texts
    assert f"{tau:.1f}" not in texts

    def shown() -> list[str]:
        model = table.model()
        return [model.index(row, WORST).data() for row in range(model.rowCount())]

    qtbot.waitUntil(lambda: wanted in shown())


def test_the_example_explains_itself_and_makes_nothing(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "argv", ["three_views.py", "--help"])
    with pytest.raises(SystemExit):
        runpy.run_path(str(ROOT / "docs/examples/three_views.py"), run_name="__main__")
    assert "usage: three_views.py" in capsys.readouterr().out
    assert not list(tmp_path.iterdir())


def test_the_sample_is_tried_on_a_copy(window, sample_copy, qtbot, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setattr("procc_annotator.gui.commands.opening.sample_folder", lambda: sample_copy)
    files = {path: path.stat().st_mtime_ns for path in sample_copy.rglob("*")}
    window.actions_["open_sample"].trigger()
    own = tmp_path / "data" / "procc-annotator" / "sample"
    qtbot.waitUntil(lambda: own.is_dir() and window.services.state.workspace.folder == own)
    assert str(own) in window.status.hint.text_for(2000)
    assert {path: path.stat().st_mtime_ns for path in sample_copy.rglob("*")} == files
