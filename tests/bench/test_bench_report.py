"""A report is made while one waits: three sources on World Cup 2014, and 200 pictures."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from pytest_benchmark.fixture import BenchmarkFixture
from typer.testing import CliRunner

from procc_annotator.cli.main import app

FRAMES = 200

pytestmark = pytest.mark.usefixtures("qapp")


def make_report(*arguments: object) -> None:
    done = CliRunner().invoke(app, ["report", *(str(a) for a in arguments)])
    assert done.exit_code == 0, done.output


def sources(shared_data: Path) -> list[str]:
    named = {
        "CARWC:carwc": "homographies_carwc",
        "NBJW": "cameras_nbjw",
        "PnLCalib": "cameras_pnlcalib",
    }
    given = [("--cameras", f"{n}={shared_data / 'wc14' / folder}") for n, folder in named.items()]
    return [text for pair in given for text in pair]


def test_world_cup_without_pictures(
    benchmark: BenchmarkFixture, shared_data: Path, tmp_path: Path
) -> None:
    given = (shared_data / "wc14" / "annotations", *sources(shared_data))
    out = ("-o", tmp_path / "r.html", "-o", tmp_path / "r.json", "-o", tmp_path / "r.tex")
    benchmark.pedantic(make_report, (*given, *out), rounds=1)
    if benchmark.enabled:
        assert benchmark.stats["max"] <= 10


def test_two_hundred_pictures(
    benchmark: BenchmarkFixture, sample_data: Path, tmp_path: Path
) -> None:
    """A set of 200 pictures of 1280x720, 200 overlays drawn."""
    match, cameras = tmp_path / "match", tmp_path / "cameras"
    match.mkdir()
    cameras.mkdir()
    for i in range(FRAMES):
        for suffix in (".jpg", ".json"):
            shutil.copy(sample_data / f"00001{suffix}", match / f"{i:05}{suffix}")
        camera = sample_data / "cameras" / "bad" / "camera_00001.json"
        shutil.copy(camera, cameras / f"camera_{i:05}.json")
    given = (match, "--cameras", cameras, "--worst", FRAMES, "--random", 0)
    benchmark.pedantic(make_report, (*given, "-o", tmp_path / "r.html"), rounds=1)
    if benchmark.enabled:
        assert benchmark.stats["max"] <= 60
