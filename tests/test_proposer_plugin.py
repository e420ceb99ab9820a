"""The example detector, built, installed and used by the real command line; and broken ones."""

import json
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from procc_annotator.batch import camera_proposals
from procc_annotator.cli.main import app

ROOT = Path(__file__).resolve().parent.parent
EXAMPLE = ROOT / "docs" / "examples" / "proposer_plugin"
HEAD = (
    "from procc_annotator.batch.camera_proposals import PictureProposer\n"
    "from procc_annotator.annotation import FrameAnnotation\n"
)


@pytest.fixture(scope="module")
def installed(tmp_path_factory) -> Path:
    """A folder with the example as its wheel installs it, metadata included."""
    folder = tmp_path_factory.mktemp("plugin")
    shutil.copytree(EXAMPLE, folder / "source")
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", str(folder)],
        cwd=folder / "source",
        check=True,
        capture_output=True,
    )
    (wheel,) = folder.glob("*.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(folder / "site")
    return folder / "site"


@pytest.fixture
def match(sample_data, tmp_path) -> Path:
    """One picture of the sample."""
    folder = tmp_path / "match"
    folder.mkdir()
    shutil.copy(sample_data / "00004.jpg", folder)
    return folder


@pytest.fixture(scope="module")
def alone(sample_data, tmp_path_factory) -> bytes:
    """The camera that is found in this picture without a detector."""
    folder, out = tmp_path_factory.mktemp("alone"), tmp_path_factory.mktemp("out")
    shutil.copy(sample_data / "00004.jpg", folder)
    done = run_here(folder, "propose", folder, out)
    assert done.exit_code == 0, done.output
    return camera_in(out)


def camera_in(out: Path, name: str = "00004") -> bytes:
    """The camera that was found for a frame, sure or not."""
    (path,) = out.rglob(f"camera_{name}.json")
    return path.read_bytes()


def with_plugin(site: Path, code: str) -> Path:
    """A package with a detector called mine, as it lies in a site folder."""
    site.mkdir()
    (site / "my_detector.py").write_text(HEAD + code)
    metadata = site / "my_detector-1.0.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: my-detector\nVersion: 1.0\n")
    entry = "[procc_annotator.proposers]\nmine = my_detector:PROPOSER\n"
    (metadata / "entry_points.txt").write_text(entry)
    return site


def run_here(site: Path, *arguments: object) -> Result:
    """Run a command in this process, which finds a site's plug-ins as a new one does."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(site)
        camera_proposals.proposers.cache_clear()
        try:
            return CliRunner().invoke(app, [str(argument) for argument in arguments])
        finally:
            camera_proposals.proposers.cache_clear()
            sys.modules.pop("my_detector", None)


def test_the_example_is_used_in_worker_processes_too(installed, match, sample_data, tmp_path):
    known = sample_data / "cameras" / "true" / "camera_00004.json"  # which is found sooner
    (match / "00005.jpg").write_bytes((match / "00004.jpg").read_bytes())
    out = tmp_path / "out"
    done = subprocess.run(
        [
            sys.executable, "-m", "procc_annotator", "propose", str(match), str(out),
            "--detector", "usual_views", "--known-positions", str(known), "--workers", "2",
        ],
        env={**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{installed}"},
        capture_output=True,
        text=True,
        check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert not done.stderr
    assert camera_in(out, "00004") == camera_in(out, "00005")


def test_what_a_detector_says_is_made_right_on_the_paint(match, alone, tmp_path):
    """A camera 2 m beside the true one, which looks elsewhere."""
    code = (
        "from tests.drawn_shots import looking_at\n"
        "NEAR = looking_at((1.0, 60.5, -16.0), (30.0, 1.0, 0.0), 1700.0)\n"
        "PROPOSER = PictureProposer('mine', 'Mine', lambda picture, field: [NEAR])\n"
    )
    site = with_plugin(tmp_path / "site", code)
    done = run_here(site, "propose", match, tmp_path / "out", "--detector", "mine")
    assert done.exit_code == 0, done.output
    helped, found = json.loads(camera_in(tmp_path / "out")), json.loads(alone)
    assert helped["pan_degrees"] == pytest.approx(found["pan_degrees"], abs=0.1)
    assert helped["position_meters"] == pytest.approx(found["position_meters"], abs=0.5)


def test_labelled_points_become_a_camera(sample_data, match, tmp_path):
    code = (
        "from procc_annotator import load_annotation\n"
        f"FOUND = load_annotation({str(sample_data / '00004.json')!r})\n"
        "PROPOSER = PictureProposer('mine', 'Mine', lambda picture, field: [FOUND])\n"
    )
    done = run_here(
        with_plugin(tmp_path / "site", code),
        "propose",
        match,
        tmp_path / "out",
        "--detector",
        "mine",
    )
    assert done.exit_code == 0, done.output
    assert camera_in(tmp_path / "out")


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("PROPOSER = PictureProposer('other', 'x', print)", "no such proposer (other)"),
        ("PROPOSER = 7", "gives int, expected PictureProposer"),
        ("1 / 0", "ZeroDivisionError"),
        ("PROPOSER = PictureProposer('mine', 'x', lambda p, f: [5])", "gives int, not Pinhole"),
        ("PROPOSER = PictureProposer('mine', 'x', lambda p, f: 1 / 0)", "ZeroDivisionError"),
        ("PROPOSER = PictureProposer('mine', 'x', lambda p, f: None)", "TypeError"),
    ],
)
def test_a_detector_gone_wrong_is_one_line(match, tmp_path, code, said):
    site = with_plugin(tmp_path / "site", code)
    done = run_here(site, "propose", match, tmp_path / "out", "--detector", "mine")
    assert done.exit_code == 2
    assert said in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_no_detector_of_that_name(match, tmp_path):
    done = run_here(tmp_path, "propose", match, tmp_path / "out", "--detector", "mine")
    assert done.exit_code == 2
    assert "--detector mine: no such proposer (none is installed)" in done.stderr


def test_a_detector_that_sees_nothing_leaves_the_search_as_it_is(match, alone, tmp_path):
    code = "PROPOSER = PictureProposer('mine', 'x', lambda p, f: [FrameAnnotation(())])"
    site = with_plugin(tmp_path / "site", code)
    done = run_here(site, "propose", match, tmp_path / "out", "--detector", "mine")
    assert done.exit_code == 0, done.output
    assert camera_in(tmp_path / "out") == alone
