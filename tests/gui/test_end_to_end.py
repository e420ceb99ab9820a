"""The whole job by mouse and keyboard: annotate, correct, judge, export; and the numbers agree."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog
from pytestqt.qtbot import QtBot

from procc_annotator.camera.base import Camera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup
from tests.gui.conftest import Hand, until_kept

SIZE = (1280, 720)
EVALUATION = (960, 540)
MAIN, ARC = "Big rect. right main", "Circle right"
CTRL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier


@pytest.fixture
def sample(sample_copy) -> Path:
    """A copy of the sample that may be annotated."""
    return sample_copy


def seen(camera: Camera, points_world: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Ground points in picture px."""
    px, _ = camera.project(np.array([(x, y, 0.0) for x, y in points_world]))
    factor = np.array([(n - 1) / (m - 1) for n, m in zip(SIZE, EVALUATION, strict=True)])
    return [(float(x), float(y)) for x, y in px * factor]


def on_disk(path: Path, class_name: str) -> np.ndarray:
    """A class's points in the file, px."""
    until_kept()
    points = json.loads(path.read_text()).get(class_name, [])
    return np.array([(p["x"], p["y"]) for p in points]).reshape(-1, 2) * (
        SIZE[0] - 1,
        SIZE[1] - 1,
    )


def export(
    window: MainWindow, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, action: str, path: Path
) -> None:
    """Choose an export in the File menu and answer its dialog."""
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
    window.actions_[action].trigger()
    qtbot.waitUntil(path.exists)


def test_annotate_correct_judge_and_export_the_sample(
    make_window, sample, qtbot, monkeypatch, tmp_path
):
    window = make_window(sample, size=(1600, 900))
    hand, services = Hand(window), window.services
    services.selection.set_option("snapping", False)  # this test is about exact clicks
    truth = CameraSet.open(sample / "cameras" / "true").camera("00005", EVALUATION)
    services.navigator.go_to(services.state.workspace.index["00005"])
    file = sample / "00005.json"
    assert not file.exists()

    # Two elements from scratch.
    line = hand.draw(MAIN, *seen(truth.camera, [(36, -19), (36, 3), (36, 8)]))
    angles = (3.9, 3.6, 3.3, 3.0)
    curve = [(41.5 + 9.15 * np.cos(a), 9.15 * np.sin(a)) for a in angles]
    arc = hand.draw(ARC, *seen(truth.camera, curve))
    np.testing.assert_allclose(on_disk(file, MAIN), line, atol=1e-9)
    np.testing.assert_allclose(on_disk(file, ARC), arc, atol=1e-9)

    # Undo and redo, on disk each time.
    hand.key(Qt.Key.Key_Z, CTRL)
    assert on_disk(file, ARC).shape == (0, 2)
    hand.key(Qt.Key.Key_Z, CTRL | SHIFT)
    np.testing.assert_allclose(on_disk(file, ARC), arc, atol=1e-9)

    # Move a point away from its line.
    hand.key(Qt.Key.Key_W)
    start = (float(line[1][0]), float(line[1][1]))
    hand.drag(start, (start[0] + 30, start[1] - 20))
    moved = on_disk(file, MAIN)
    assert np.hypot(*(moved[1] - line[1])) > 20
    np.testing.assert_allclose(np.delete(moved, 1, axis=0), np.delete(line, 1, axis=0), atol=1e-9)

    # Judge: the moved element fails at 5 px, the arc passes.
    services.camera_sources.load_cameras(sample / "cameras" / "true")
    field = load_field()
    annotation = read_annotation(file.read_bytes(), path=str(file), field=field)
    expected = score(measure(annotation, truth.camera, EvaluationSetup(field)), 5.0)
    verdicts = {e.annotated_name: e.status for e in expected.elements}
    assert verdicts[MAIN] == "too_far"
    assert verdicts[ARC] == "tp"
    assert (services.scorer.score.tp, services.scorer.score.fp, services.scorer.score.fn) == (
        expected.tp,
        expected.fp,
        expected.fn,
    )

    # A larger tau accepts it.
    window.top_bar.camera_bar.tau.spin.setValue(30.0)
    assert services.state.tau == 30.0
    assert services.scorer.score.tp == expected.tp + 1

    # Export, and compare with what was clicked.
    export(window, qtbot, monkeypatch, "export_annotations", tmp_path / "out")
    exported = tmp_path / "out" / "00005.json"
    qtbot.waitUntil(exported.exists)
    np.testing.assert_allclose(on_disk(exported, MAIN), moved, atol=1e-9)
    table = tmp_path / "jac.csv"
    export(window, qtbot, monkeypatch, "export_scores", table)
    header, *rows = [row.split(",") for row in table.read_text().splitlines()]
    (row,) = [dict(zip(header, r, strict=True)) for r in rows if r[0] == "00005"]
    assert float(row["jac"]) == pytest.approx(services.scorer.score.jac, abs=1e-6)


def test_annotate_a_real_frame(make_window, shared_data, tmp_path):
    """Clicking the points of a real annotation gives that annotation, to the screen's pixel."""
    folder = tmp_path / "real"
    folder.mkdir()
    shutil.copy(shared_data / "frames" / "bra_mex.jpg", folder)
    reference = json.loads((shared_data / "frames" / "bra_mex.json").read_text())
    window = make_window(folder, size=(1600, 900))
    hand = Hand(window)
    window.services.selection.set_option("snapping", False)
    names = [name for name, points in reference.items() if len(points) >= 2][:2]
    for name in names:
        wanted = on_disk(shared_data / "frames" / "bra_mex.json", name)
        clicked = hand.draw(name, *[(float(x), float(y)) for x, y in wanted])
        stored = on_disk(folder / "bra_mex.json", name)
        np.testing.assert_allclose(stored, clicked, atol=1e-9)
        assert np.abs(stored - wanted).max() <= 1.0 / window.canvas.view_scale
    hand.key(Qt.Key.Key_Z, CTRL)
    assert on_disk(folder / "bra_mex.json", names[1]).shape == (0, 2)
    assert len(on_disk(folder / "bra_mex.json", names[0])) >= 2
