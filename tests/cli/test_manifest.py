"""``--manifest`` and ``procc-annotator repeat`` as a user runs them."""

import json
import shutil
from pathlib import Path

import pytest

import procc_annotator

SOURCES = ("true", "bad", "homography")


@pytest.fixture
def data(sample_data, tmp_path) -> Path:
    """The sample's annotations and cameras."""
    folder = tmp_path / "sample"
    folder.mkdir()
    for file in sample_data.glob("*.json"):
        shutil.copy(file, folder)
    shutil.copytree(sample_data / "cameras", folder / "cameras")
    return folder


@pytest.fixture
def manifest(cli, data, tmp_path) -> Path:
    """Of three sources at two thresholds."""
    path = tmp_path / "manifest.json"
    sources = [f"--cameras={name}={data / 'cameras' / name}" for name in SOURCES]
    done = cli("evaluate", data, *sources, "-t", "5", "-t", "2", "--manifest", path)
    assert f"written: {path}" in done.output
    return path


def test_a_manifest_holds_the_run_and_no_path_of_the_machine(manifest, data):
    text = manifest.read_text()
    found = json.loads(text)
    assert str(data.parent) not in text
    assert found["versions"].keys() == {"procc-annotator", "numpy", "opencv"}
    assert found["versions"]["procc-annotator"] == procc_annotator.__version__
    assert found["command"] == "evaluate"
    assert found["options"] == {
        "annotations": ".",
        "sources": [f"{name}=cameras/{name}" for name in SOURCES],
        "threshold": [5, 2],
    }
    digest, size = found["inputs"]["00001.json"]
    assert (len(digest), size) == (64, (data / "00001.json").stat().st_size)
    assert "cameras/bad/camera_00001.json" in found["inputs"]
    evaluation = found["metrics"]["evaluations"][0]
    assert (evaluation["method"], evaluation["size"]) == ("true", [960, 540])
    assert evaluation["summary"].keys() == {"5", "2"}


def test_it_is_repeated_elsewhere(cli, manifest, data, tmp_path):
    elsewhere = tmp_path / "far" / "away"
    shutil.copytree(data, elsewhere)
    shutil.rmtree(data)
    done = cli("repeat", manifest, "--data", elsewhere)
    assert (done.exit_code, "the same" in done.stdout) == (0, True), done.output
    (elsewhere / "runs").mkdir()
    cli("repeat", shutil.copy(manifest, elsewhere / "runs"))


def test_what_differs_is_listed(cli, manifest, data, tmp_path):
    (data / "00001.json").unlink()
    camera = data / "cameras" / "true" / "camera_00002.json"
    content = json.loads(camera.read_text())
    camera.write_text(json.dumps(content | {"pan_degrees": content["pan_degrees"] + 1}))
    shutil.copy(data / "00002.json", data / "00099.json")
    text = (Path("resources") / "field" / "soccer.toml").read_text()
    (data / "field.toml").write_text(text.replace("105", "104", 1))
    out = tmp_path / "differences.json"
    done = cli("repeat", manifest, "--data", data, "--output", out, code=1)
    lines = json.loads(out.read_text())["differences"]
    assert {
        "missing: 00001.json",
        "not in the manifest: 00099.json",
        "not in the manifest: field.toml",
        "other content: cameras/true/camera_00002.json",
        "other field: sample",
    } <= set(lines)
    metrics = [line for line in lines if line.startswith("other metric: evaluations true")]
    assert any("summary 5 mean_jac: " in line for line in metrics)
    shown = [line for line in done.stdout.splitlines() if line.startswith("other metric")]
    assert len(shown) < 50 < len(lines)


def test_the_least_change_of_a_metric_is_a_difference(cli, manifest, data):
    content = json.loads(manifest.read_text())
    content["metrics"]["evaluations"][1]["summary"]["5"]["mean_jac"] *= 1 + 1e-11
    manifest.write_text(json.dumps(content))
    done = cli("repeat", manifest, "--data", data, code=1)
    (line,) = done.stdout.splitlines()
    assert line.startswith("other metric: evaluations bad soccernet soccer summary 5 mean_jac: ")


def test_a_report_with_intervals_is_repeated_and_its_tables_name_the_manifest(cli, data, tmp_path):
    tags, tex, own = data / "tags.csv", tmp_path / "t.tex", tmp_path / "own.json"
    frames = sorted(path.stem for path in data.glob("*.json"))
    tags.write_text("frame,half\n" + "\n".join(f"{f},{n % 2}" for n, f in enumerate(frames)))
    sources = [f"--cameras={name}={data / 'cameras' / name}" for name in ("true", "bad")]
    asked = (
        "--tags",
        tags,
        "--by",
        "zoom",
        "--annotation-noise",
        1,
        "--resamples",
        200,
        "--planar-only",
    )
    done = cli("report", data, *sources, *asked, "--manifest", own, "-o", tex)
    assert "% manifest: own.json" in tex.read_text()
    found = json.loads(own.read_text())
    assert "tags.csv" in found["inputs"]
    assert {"intervals", "by_zoom"} < found["metrics"]["chance"][0].keys()
    done = cli("repeat", own, "--data", data)
    assert (done.exit_code, "the same" in done.stdout) == (0, True), done.output
    tags.write_text(tags.read_text() + "\n")
    assert cli("repeat", own, "--data", data, code=1).stdout == "other content: tags.csv\n"


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("{", "is no manifest"),
        ("[]", "is no manifest"),
        ('{"format": "procc-annotator manifest 1"}', "is no manifest"),
        ('{"format": "procc-annotator recipe 1"}', "run its command again with --manifest"),
    ],
)
def test_what_is_no_manifest(cli, tmp_path, content, says):
    path = tmp_path / "r.json"
    path.write_text(content)
    done = cli("repeat", path, code=2)
    assert len(done.stderr.splitlines()) == 1
    assert says in done.stderr


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"options": {"annotations": "../.."}}, "leads out"),
        ({"options": {"annotations": ".", "sources": ["a:pinhole=/etc"]}}, "leads out"),
        ({"inputs": {"/etc/passwd": ["", 0]}}, "leads out"),
        ({"command": "release"}, "is not repeated"),
        ({"options": {"annotations": ".", "nonsense": 1}}, "no option 'nonsense'"),
        ({"inputs": {"else.json": ["", 0]}}, "is not in"),
    ],
)
def test_a_manifest_that_is_refused(cli, manifest, data, change, says):
    manifest.write_text(json.dumps(json.loads(manifest.read_text()) | change))
    done = cli("repeat", manifest, "--data", data, code=2)
    assert says in " ".join(done.stderr.split())


def test_a_manifest_writes_nothing_among_the_data(cli, manifest, data):
    content = json.loads(manifest.read_text())
    content["options"] |= {"output": ["00001.json"], "over_time_output": ["t.csv"]}
    manifest.write_text(json.dumps(content))
    before = {path: path.read_bytes() for path in data.rglob("*") if path.is_file()}
    cli("repeat", manifest, "--data", data)
    assert {path: path.read_bytes() for path in data.rglob("*") if path.is_file()} == before


def test_fits_landmarks_and_views_are_inputs(cli, data, tmp_path):
    known = {"name": "Floodlight NE", "position": [61.2, -45.0, -28.4]}
    (data / "landmarks.json").write_text(json.dumps({"landmarks": [known]}))
    (data / "views.csv").write_text("frame,instant,view\n00001,1,main\n")
    fits, path = data / "fits", tmp_path / "manifest.json"
    cli("calibrate", data, fits, "--model", "H")
    cli("evaluate", data, fits, "--manifest", path)
    inputs = json.loads(path.read_text())["inputs"].keys()
    assert {"landmarks.json", "views.csv", "fits/calibration.csv"} < inputs
    known["position"] = [61.2, -45.0, -29.4]
    (data / "landmarks.json").write_text(json.dumps({"landmarks": [known]}))
    (fits / "calibration.csv").unlink()
    done = cli("repeat", path, "--data", data, code=1)
    assert "other content: landmarks.json" in done.stdout
    assert "missing: fits/calibration.csv" in done.stdout
