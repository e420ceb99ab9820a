"""A set that was annotated by the program says so when it is opened."""

import shutil

from PySide6.QtWidgets import QLabel
from typer.testing import CliRunner

from procc_annotator.cli.main import app
from procc_annotator.dataset.records import OriginKind


def test_points_of_annotate_are_proposed(make_window, qtbot, sample_data, tmp_path):
    match = tmp_path / "match"
    match.mkdir()
    shutil.copy(sample_data / "00004.jpg", match)
    cameras = sample_data / "cameras" / "true"
    arguments = ["annotate", match, match / "annotations", "--cameras", cameras]
    assert CliRunner().invoke(app, [str(argument) for argument in arguments]).exit_code == 0
    window = make_window(match)
    services = window.services
    counts = services.review.origin_counts(services.state.frame.name, services.state.annotation)
    assert set(counts) == {OriginKind.PROPOSED}
    assert counts[OriginKind.PROPOSED] > 20
    window.panels.show("review")
    shown = window.findChild(QLabel, "reviewOrigins")
    qtbot.waitUntil(lambda: "proposed" in shown.text())
