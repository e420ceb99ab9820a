"""``open --selftest``: the installed program tries its window, and says what does not work."""

import os
import subprocess
import sys
from pathlib import Path


def run(home: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    homes = {"HOME": str(home), "XDG_CONFIG_HOME": str(home)}
    environment = {**os.environ, **homes, "QT_QPA_PLATFORM": "offscreen"}
    return subprocess.run(
        [sys.executable, *arguments],
        env=environment, capture_output=True, text=True, check=False, timeout=120,
    )  # fmt: skip


def test_the_window_annotates_a_copy_and_leaves_everything_as_it_was(sample_copy, tmp_path):
    home = tmp_path / "home"
    home.mkdir()
    before = {p: p.read_bytes() for p in sample_copy.rglob("*") if p.is_file()}
    done = run(home, "-m", "procc_annotator", "open", str(sample_copy), "--selftest")
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("selftest passed: Qt 6")
    assert "annotated in a copy of 00001.jpg, saved and read back" in done.stdout
    assert {p: p.read_bytes() for p in sample_copy.rglob("*") if p.is_file()} == before
    assert not [p for p in home.rglob("*.ini") if p.is_file()]


def test_pictures_in_folders_of_folders_will_do(sample_copy, tmp_path):
    game = tmp_path / "tree" / "season" / "game"
    for folder in (game, game.with_name("another")):
        folder.mkdir(parents=True)
        (folder / "7.jpg").write_bytes((sample_copy / "00001.jpg").read_bytes())
    done = run(tmp_path, "-m", "procc_annotator", "open", str(tmp_path / "tree"), "--selftest")
    assert done.returncode == 0, done.stderr
    assert "annotated in a copy of 7.jpg, saved and read back" in done.stdout


def test_without_the_sample_a_picture_is_drawn(tmp_path):
    code = """
from procc_annotator.gui import selftest

selftest.sample_folder = lambda: None
print(selftest.run_selftest())
"""
    done = run(tmp_path, "-c", code)
    assert "a copy of drawn.png" in done.stdout, done.stderr


def test_a_folder_without_pictures_is_one_line(cli, tmp_path):
    done = run(tmp_path, "-m", "procc_annotator", "open", str(tmp_path), "--selftest")
    assert done.returncode == 2
    assert "nothing to do: no picture in" in done.stderr


def test_without_a_terminal_an_error_is_shown_in_a_dialog(tmp_path):
    code = """
import sys
from PySide6.QtWidgets import QMessageBox
from procc_annotator.cli.main import run_window

shown = []
QMessageBox.critical = lambda *what: shown.append(what[2])
sys.argv = ["procc-annotator-window", "/no/such/folder"]
terminal, sys.stderr, sys.stdout = sys.stdout, None, None
try:
    run_window()
except SystemExit as ended:
    print(ended.code, shown, file=terminal)
"""
    done = run(tmp_path, "-c", code)
    assert done.stdout.startswith("2 ['procc-annotator: /no/such/folder: does not exist")
    assert done.stderr == ""


def test_a_datasets_field_file_opens_the_dataset(sample_data, tmp_path):
    """As a file manager hands it over."""
    own = sample_data / "basketball" / "field.toml"
    done = run(tmp_path, "-m", "procc_annotator", "open", str(own), "--selftest")
    assert done.returncode == 0, done.stderr
    assert "Court edge" in done.stdout
