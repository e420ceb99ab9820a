"""Names and texts of files reach terminal, pages and Markdown as text, never as commands."""

import json
import os
import shutil
import sys
from pathlib import Path

import pytest

from procc_annotator.batch.unit_store import Unit, UnitStore
from procc_annotator.cli.main import COMMANDS

EVIL = "\x1b]0;pwn\x07\x1b[31m<script>x"
SHOWN = r"\x1b]0;pwn\x07\x1b[31m"
# Commands without a dataset, and those of which a test here would take minutes.
WITHOUT = {
    "open",
    "desktop-entry",
    "repeat",
    "field",
    "track",
    "propose",
    "triangulate",
}

pytestmark = pytest.mark.skipif(os.name == "nt", reason="no such names of files on this system")


@pytest.fixture
def evil(dataset, tmp_path) -> Path:
    """A dataset whose frames, annotators, classes and folder have hostile names."""
    for path in [*dataset.root.rglob("*.jpg"), *dataset.root.rglob("*.json")]:
        path.rename(path.with_name(path.name.replace("1", f"{EVIL}1")))
    for path in dataset.annotations.glob("*2.json"):
        content = json.loads(path.read_text())
        path.write_text(json.dumps({**content, EVIL: [{"x": 0.5, "y": 0.5}]}))
    (dataset.annotations / f"{EVIL}.json").write_text("{")
    (dataset.cameras / f"camera_{EVIL}.json").write_text("{")
    return dataset.root.rename(tmp_path / EVIL)


def _commands(evil: Path, out: Path) -> dict[str, list[object]]:
    annotations, cameras, second = evil / "annotations", evil / "cameras", out / EVIL
    shutil.copytree(annotations, second / "annotations")
    points = out / "points.csv"
    points.write_text(f"frame,x,y,{EVIL}\n{EVIL},1,2,{EVIL}\n{EVIL}1,1,2,3\n")
    with UnitStore(out / "season" / "track.sqlite", {}, resume=False) as store:
        store.fail(Unit(EVIL, match=EVIL, error=EVIL, tries=3))
    return {
        "status": [out / "season"],
        "evaluate": [annotations, cameras, "--output", out / "e.csv", "--intervals"],
        "agree": [second / "annotations", "--reference", evil],
        "compare": [cameras, cameras, "--dataset", evil],
        "report": [evil, "--cameras", cameras, "-o", out / "r.html", "-o", out / "r.tex"],
        "calibrate": [annotations, out / "cal"],
        "annotate": [evil, out / "ann", "--cameras", cameras],
        "check": [evil],
        "field-size": [evil],
        "export": [evil, out / "ex"],
        "ground": [points, "--cameras", cameras, "--pixel-sd", "1"],
        "convert": [annotations, out / "c.json", "--to", "coco"],
        "propose-map": [annotations, out / "map.toml"],
        "release": [evil, out / "rel", "--name", EVIL, "--second-annotator", second, "--no-check"],
        "render": [evil, out / "ren", "--cameras", cameras],
        "figure": [evil, out / "fig.svg", "--cameras", cameras],
        "check-submission": [annotations],
    }


def test_every_command_is_walked(dataset, tmp_path):
    known = {str(command.name) for command in COMMANDS} - WITHOUT
    assert known == set(_commands(dataset.root, tmp_path / "out"))


@pytest.mark.parametrize("terminal", [False, True])
def test_nothing_that_a_terminal_would_obey_is_printed(
    cli, evil, tmp_path, monkeypatch, no_charts, terminal
):
    monkeypatch.chdir(tmp_path)
    if terminal:
        monkeypatch.setenv("FORCE_COLOR", "1")
        monkeypatch.setenv("COLUMNS", "200")
    told = ""
    for name, arguments in _commands(evil, tmp_path / "out").items():
        done = cli(name, *arguments, code=None)
        said = done.stdout + done.stderr
        assert "\x1b]0" not in said, name
        assert "\x07" not in said, name
        assert terminal or "\x1b" not in said, name
        told += said
    assert SHOWN in told
    page = (tmp_path / "out" / "r.html").read_text()
    assert "<script>x" not in page
    assert "\x1b" not in page
    released = tmp_path / "out" / "rel"
    for name in ("README.md", "CHANGELOG.md"):
        text = (released / name).read_text()
        assert "<script" not in text
        assert "\x1b" not in text
    assert "&lt;script>x" in (released / "README.md").read_text()


@pytest.mark.skipif(sys.platform != "linux", reason="names of files are valid Unicode here")
def test_a_folder_whose_name_is_not_unicode_is_reported(cli, dataset, tmp_path):
    cameras = dataset.cameras.rename(tmp_path / "c\udcff$x^$")
    outputs = [
        part for kind in ("html", "tex", "csv", "json") for part in ("-o", tmp_path / f"r.{kind}")
    ]
    cli("report", dataset.root, "--cameras", cameras, *outputs)
    assert r"c\udcff$x^$" in (tmp_path / "r.html").read_text()
