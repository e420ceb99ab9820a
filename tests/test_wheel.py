"""The wheel carries everything: it runs outside the repository."""

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent


@pytest.fixture(scope="module")
def installed(tmp_path_factory) -> Path:
    """A folder with the package as the wheel installs it, far from the checkout."""
    folder = tmp_path_factory.mktemp("wheel")
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)],
        cwd=ROOT,
        check=True,
        capture_output=True,
    )
    (wheel,) = folder.glob("*.whl")
    site = folder / "site"
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(site)
    return site


def run(installed: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": str(installed), "QT_QPA_PLATFORM": "offscreen"}
    return subprocess.run(
        [sys.executable, *arguments],
        cwd=installed.parent,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


def test_the_wheel_is_what_runs(installed):
    where = run(installed, "-c", "import procc_annotator; print(procc_annotator.__file__)")
    assert Path(where.stdout.strip()).is_relative_to(installed)


def test_the_wheel_brings_the_guide_and_its_icons(installed):
    code = (
        "from procc_annotator.gui.window.commands import guide_folder;"
        "from procc_annotator.resources import resources_dir;"
        "print(guide_folder()); print(resources_dir() / 'icons' / 'undo.svg')"
    )
    guide, icon = map(Path, run(installed, "-c", code).stdout.split())
    assert guide.is_relative_to(installed)
    assert (guide / "how-to" / "evaluate-cameras.md").is_file()
    assert {path.suffix for path in guide.rglob("*") if path.is_file()} == {".md"}
    assert icon.is_relative_to(installed)
    assert icon.is_file()


def test_the_wheel_writes_a_report(installed, sample_data):
    out = installed.parent / "report.html"
    done = run(
        installed, "-m", "procc_annotator", "report", str(sample_data), "-o", str(out),
        "--cameras", f"bad={sample_data / 'cameras' / 'bad'}", "--worst", "1", "--random", "0",
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "<h2>Definitions</h2>" in out.read_text(encoding="utf-8")


def test_the_wheel_has_the_sample_and_nothing_that_draws_it(installed, sample_data):
    own = installed / "procc_annotator" / "_sample_data"
    there = {str(path.relative_to(own)) for path in own.rglob("*") if path.is_file()}
    suffixes = {".jpg", ".json", ".toml", ".homographyMatrix", ".mp4", ".csv"}
    wanted = {
        str(path.relative_to(sample_data))
        for path in sample_data.rglob("*")
        if path.suffix in suffixes and ".procc" not in path.parts
    }
    assert there - {"README.md"} == wanted
    done = run(installed, "-m", "procc_annotator", "open", "--selftest")
    assert done.returncode == 0, done.stderr
    assert "in a copy of 00001.jpg" in done.stdout
