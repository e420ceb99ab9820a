"""The example plug-in, built, installed and used by the real command line; and broken ones."""

import csv
import math
import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.cli.main import app
from procc_annotator.formats.cameras import registry
from procc_annotator.formats.cameras.registry import read_camera_file

ROOT = Path(__file__).resolve().parent.parent
EXAMPLE = ROOT / "docs" / "examples" / "camera_plugin"


@pytest.fixture(scope="module")
def installed(tmp_path_factory) -> Path:
    """A folder with the plug-in as its wheel installs it, metadata included."""
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


def run_here(site: Path, *arguments: str) -> Result:
    """Run a command in this process, which finds a site's plug-ins as a new one does."""
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(site)
        patch.setattr(registry, "_found", [])
        try:
            return CliRunner().invoke(app, list(arguments))
        finally:
            sys.modules.pop("broken_lens", None)


def run(site: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}{os.pathsep}{site}"}
    return subprocess.run(
        [sys.executable, "-m", "procc_annotator", *arguments],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


def broken_plugin(site: Path, value: str, code: str) -> Path:
    """A package with an entry point, as it lies in a site folder."""
    site.mkdir()
    (site / "broken_lens.py").write_text(code)
    metadata = site / "broken_lens-1.0.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text("Metadata-Version: 2.1\nName: broken-lens\nVersion: 1.0\n")
    (metadata / "entry_points.txt").write_text(f"[procc_annotator.cameras]\nbroken = {value}\n")
    return site


def scores(path: Path) -> dict[str, str]:
    with path.open() as file:
        return {row["name"]: row["jac"] for row in csv.DictReader(file) if row.get("jac")}


def divided(camera: PinholeCamera) -> str:
    """A sample camera without its distortion, in the plug-in's format."""
    angles = (camera.pan_rad, camera.tilt_rad, camera.roll_rad)
    numbers = {
        "size": (960, 540),
        "pan_tilt_roll": [math.degrees(angle) for angle in angles],
        "position": camera.position_world,
        "focal": camera.focal_px[:1],
        "centre": camera.principal_point_px,
        "lambda": (0.0,),
    }
    lines = (f"{key} = {' '.join(map(repr, map(float, v)))}" for key, v in numbers.items())
    return "# a comment\n" + "\n".join(lines) + "\n"


def test_the_example_scores_as_the_same_camera_does(installed, sample_data, tmp_path):
    pinhole = sample_data / "cameras" / "pinhole"
    theirs = tmp_path / "division"
    theirs.mkdir()
    for file in pinhole.glob("camera_*.json"):
        camera = read_camera_file(file.read_bytes(), path=file.name).camera
        assert not camera.is_distorted
        (theirs / f"{file.stem}.division").write_text(divided(camera))
    found = {}
    for name, folder, fmt in (
        ("own", pinhole, "soccernet"),
        ("named", theirs, "division"),
        ("auto", theirs, "auto"),
    ):
        output = tmp_path / f"{name}.csv"
        done = run(
            installed, "evaluate", str(sample_data), str(folder), "--camera-format", fmt,
            "--output", str(output),
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        found[name] = scores(output)
    assert len(found["own"]) > 3
    assert found["named"] == found["auto"] == found["own"]


def test_a_damaged_file_of_the_plugin_is_one_line(installed, sample_data, tmp_path):
    frame = sorted(sample_data.glob("*.json"))[0].stem
    (tmp_path / f"{frame}.division").write_text("focal = wide\n")
    done = run(
        installed, "evaluate", str(sample_data), str(tmp_path), "--camera-format", "division"
    )
    assert done.returncode == 1
    assert "line 1: expected 1 numbers, found 'focal = wide'" in done.stderr
    assert "Traceback" not in done.stderr


def test_a_plugin_gone_wrong_leaves_a_program_of_its_own_running(tmp_path, sample_data):
    site = broken_plugin(tmp_path / "site", "broken_lens:FORMAT", "import absent_module")
    done = run(site, "evaluate", str(sample_data), str(sample_data / "cameras" / "true"))
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    assert "ModuleNotFoundError" in done.stderr


@pytest.mark.parametrize(
    ("value", "code", "said"),
    [
        ("broken_lens:FORMAT", "raise RuntimeError('no licence\\nfound')", "RuntimeError: no lic"),
        ("broken_lens:FORMAT", "import absent_module", "ModuleNotFoundError"),
        ("broken_lens:FORMAT", "x = (", "SyntaxError"),
        ("broken_lens:FORMAT", "", "AttributeError"),
        ("broken_lens:FORMAT", "FORMAT = 5", "gives int, expected CameraFormat"),
        ("broken_lens:FORMAT", "FORMAT = lambda: [1]", "gives int, expected CameraFormat"),
        ("broken_lens:FORMAT", "FORMAT = lambda: 1 / 0", "ZeroDivisionError"),
        (
            "broken_lens:FORMAT",
            "from procc_annotator.formats.cameras.registry import CameraFormat\n"
            "FORMAT = CameraFormat('soccernet', 'mine', ('.json',), ('.json',), print)",
            "gives a format 'soccernet', which there is already; it is not used",
        ),
        (
            "broken_lens:FORMAT",
            "from procc_annotator.formats.cameras.registry import CameraFormat\n"
            "FORMAT = CameraFormat('mine', 'mine', ('.mine',), ('.mine',), None)",
            "needs a name and a function to read with",
        ),
    ],
)
def test_a_plugin_gone_wrong_is_one_line_and_the_program_goes_on(
    tmp_path, sample_data, value, code, said
):
    site = broken_plugin(tmp_path / "site", value, code)
    done = run_here(site, "evaluate", str(sample_data), str(sample_data / "cameras" / "true"))
    assert done.exit_code == 0, done.stderr
    assert "Traceback" not in done.stderr
    (line,) = [line for line in done.stderr.splitlines() if "plug-in" in line]
    assert said in line


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("return data[99999]", "IndexError"),
        ("return 5", "it gives int, expected a LoadedCamera"),
        ("return LoadedCamera(5, 'mine')", "a int has no method project"),
        ("return LoadedCamera(Lens(lambda p: 1 / 0), 'mine')", "ZeroDivisionError"),
        ("return LoadedCamera(Lens(lambda p: (p, p)), 'mine')", "project gives something else"),
        ("return LoadedCamera(Lens(lambda p: p), 'mine')", "cannot be read by the plug-in 'brok"),
    ],
)
def test_a_plugins_reader_gone_wrong_is_an_unreadable_camera(tmp_path, sample_data, body, said):
    code = (
        "from procc_annotator.formats.cameras.registry import CameraFormat\n"
        "from procc_annotator.formats.cameras.loaded_camera import LoadedCamera\n"
        "class Lens:\n    def __init__(self, project):\n        self.project = project\n"
        f"def read(data, *, path):\n    {body}\n"
        "def formats():\n    return [CameraFormat('mine', 'mine', ('.mine',), ('.mine',), read)]\n"
    )
    site = broken_plugin(tmp_path / "site", "broken_lens:formats", code)
    frame = sorted(sample_data.glob("*.json"))[0].stem
    (tmp_path / "cameras").mkdir()
    (tmp_path / "cameras" / f"{frame}.mine").write_text("x")
    done = run_here(site, "evaluate", str(sample_data), str(tmp_path / "cameras"))
    assert done.exit_code == 1
    assert said in done.stderr
    assert "Traceback" not in done.stderr
