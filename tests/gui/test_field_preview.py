"""The window of ``field show``: map and elements of a file, as it is written."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner

from procc_annotator.cli.main import app
from procc_annotator.field.load import load_field
from procc_annotator.gui import field_preview
from procc_annotator.gui.field_preview import FieldPreview
from tests.gui.state.test_field_choice import YARD


@pytest.fixture
def preview(qtbot, qapp):
    made: list[FieldPreview] = []

    def show(source: str | Path, **dimensions: float) -> FieldPreview:
        window = FieldPreview(source, dimensions, {"D": "Next frame"})
        made.append(window)
        qtbot.addWidget(window)
        window.show()
        return window

    yield show
    for window in made:
        window.close()


def listed(window: FieldPreview) -> set[str]:
    return set(window.elements._items)


def test_a_shipped_field_is_shown_with_its_dimensions(preview, qtbot):
    window = preview("soccer", length=100.0)
    field = load_field("soccer", length=100.0)
    qtbot.waitUntil(lambda: window.services.state.field == field)
    assert window.windowTitle().startswith("Soccer")
    assert "Length: 100 m (the rules allow 90 to 120 m)" in window.facts.text()
    assert window.map.position_of("Penalty mark left") is not None
    assert window.problem_bar.isHidden()


def test_a_file_is_followed_while_it_is_written(preview, qtbot, tmp_path):
    path = tmp_path / "yard.toml"
    path.write_text("name = ")
    window = preview(path)
    qtbot.waitUntil(lambda: not window.problem_bar.isHidden())
    assert str(path) in window.problem_bar.label.text()
    assert window.pages.currentIndex() == 0  # no other field in its place
    path.write_text(YARD)
    qtbot.waitUntil(lambda: window.pages.currentIndex() == 1)
    assert window.problem_bar.isHidden()
    qtbot.waitUntil(lambda: listed(window) == {"fence", "gate"})
    assert "Next frame" in window.remarks.text()  # what the key of the gate means already
    path.write_text(YARD.replace('kind = "line"', 'kind = "lime"', 1))
    qtbot.waitUntil(lambda: not window.problem_bar.isHidden())
    assert "element 'fence'.kind" in window.problem_bar.label.text()
    assert listed(window) == {"fence", "gate"}
    path.write_text(YARD.replace('name = "gate"', 'name = "door"'))
    qtbot.waitUntil(lambda: listed(window) == {"fence", "door"})
    assert window.map.position_of("door") is not None


def test_the_command_opens_it(monkeypatch, tmp_path):
    asked: list[tuple[object, ...]] = []

    def run(*terms: object) -> int:
        asked.append(terms)
        return 0

    monkeypatch.setattr(field_preview, "run_preview", run)
    done = CliRunner().invoke(app, ["field", "show", "soccer:length=100", "--window"])
    assert done.exit_code == 0, done.output
    assert asked[0][:2] == ("soccer", {"length": 100.0})
    broken = tmp_path / "yard.toml"
    broken.write_text("name = ")
    done = CliRunner().invoke(app, ["field", "show", str(broken), "--window"])
    assert done.exit_code == 0
    assert asked[1][0] == str(broken)  # which waits until it is mended
    assert CliRunner().invoke(app, ["field", "show", str(broken)]).exit_code == 2
    assert CliRunner().invoke(app, ["field", "show", "soccer"]).exit_code == 0
    assert len(asked) == 2  # not without a terminal


def test_ctrl_c_in_the_terminal_closes_it(tmp_path):
    code = """
import signal
from PySide6.QtCore import QTimer
from procc_annotator.gui import app, field_preview
application, before = app.application(), signal.getsignal(signal.SIGINT)
interrupt = QTimer(interval=50)
interrupt.timeout.connect(
    lambda: signal.getsignal(signal.SIGINT) is before or signal.raise_signal(signal.SIGINT)
)
interrupt.start()
raise SystemExit(field_preview.run_preview("soccer"))
"""
    own = {**os.environ, "XDG_CONFIG_HOME": str(tmp_path), "QT_QPA_PLATFORM": "offscreen"}
    ended = subprocess.run([sys.executable, "-c", code], env=own, timeout=120, check=False)
    assert ended.returncode == 0
