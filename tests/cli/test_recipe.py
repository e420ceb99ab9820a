"""``--recipe`` and ``procc-annotator repeat`` as a user runs them."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

import procc_annotator

SOURCES = ("true", "bad", "homography")


@pytest.fixture
def data(sample_data: Path, tmp_path: Path) -> Path:
    """The sample's annotations and cameras."""
    folder = tmp_path / "sample"
    folder.mkdir()
    for file in sample_data.glob("*.json"):
        shutil.copy(file, folder)
    for file in sample_data.glob("*.jpg"):
        shutil.copy(file, folder)
    shutil.copytree(sample_data / "cameras", folder / "cameras")
    return folder


@pytest.fixture
def recipe(cli, data: Path, tmp_path: Path) -> Path:
    """Of three sources at two thresholds."""
    path = tmp_path / "recipe.json"
    sources = [f"--cameras={name}={data / 'cameras' / name}" for name in SOURCES]
    done = cli("evaluate", data, *sources, "-t", "5", "-t", "2", "--recipe", path)
    assert done.exit_code == 0, done.output
    assert f"written: {path}" in done.output
    return path


def test_a_recipe_holds_everything_and_no_path_of_the_machine(recipe: Path, data: Path) -> None:
    text = recipe.read_text()
    found = json.loads(text)
    assert str(data.parent) not in text
    assert found["version"] == procc_annotator.__version__
    assert found["command"] == "evaluate"
    assert found["options"]["threshold"] == [5, 2]
    assert found["options"]["sources"] == [f"{name}={name}" for name in SOURCES]
    inputs = {(one["role"], one["path"]): one["files"] for one in found["inputs"]}
    assert list(inputs) == [
        ("annotations", "."), *(("cameras", f"cameras/{name}") for name in SOURCES)
    ]  # fmt: skip
    (first, *_) = inputs["annotations", "."]
    assert (first["name"], len(first["sha256"])) == ("00001.json", 64)
    evaluation = found["evaluations"][0]
    assert (evaluation["set"], evaluation["source"]) == ("sample", "true")
    assert evaluation["size"] == [960, 540]
    assert evaluation["protocol"] == "soccernet"
    assert sum(evaluation["picture_sizes"].values()) == len(inputs["annotations", "."])
    assert evaluation["figures"]["5"]["images"] == len(inputs["annotations", "."])
    assert "Universal Protocol" in found["citation"]["protocol"]


def test_it_is_repeated_elsewhere(cli, recipe: Path, data: Path, tmp_path: Path) -> None:
    done = cli("repeat", recipe, "--data", data)
    assert done.exit_code == 0, done.output
    assert "the same" in done.output
    elsewhere = tmp_path / "far" / "away"
    shutil.copytree(data, elsewhere)
    shutil.rmtree(data)
    done = cli("repeat", recipe, "--data", elsewhere)
    assert done.exit_code == 0, done.output
    (elsewhere / "recipes").mkdir()
    beside = shutil.copy(recipe, elsewhere / "recipes")
    assert cli("repeat", beside).exit_code == 0


def test_a_folder_that_is_not_the_one_meant_is_told_what_is(cli, recipe: Path, data: Path) -> None:
    done = cli("repeat", recipe, "--data", data / "cameras")
    assert done.exit_code == 2
    said = " ".join(done.stderr.split())
    assert "is not in" in said
    assert "--data names the folder that it lies in by that path" in said


def test_what_differs_is_said(cli, recipe: Path, data: Path, tmp_path: Path) -> None:
    (data / "00001.json").unlink()
    camera = data / "cameras" / "true" / "camera_00002.json"
    content = json.loads(camera.read_text())
    camera.write_text(json.dumps(content | {"pan_degrees": content["pan_degrees"] + 1}))
    shutil.copy(data / "00002.json", data / "00099.json")
    out = tmp_path / "differences.json"
    done = cli("repeat", recipe, "--data", data, "--output", out)
    assert done.exit_code == 1
    lines = json.loads(out.read_text())["differences"]
    assert "missing: ./00001.json" in lines
    assert "not in the recipe: ./00099.json" in lines
    assert "other content: cameras/true/camera_00002.json" in lines
    figures = [line for line in lines if line.startswith("other figure: sample, true, 960x540: ")]
    assert any("mean_jac@5" in line for line in figures)


def test_another_field_is_said(cli, recipe: Path, data: Path) -> None:
    text = (Path("resources") / "field" / "soccer.toml").read_text()
    (data / "field.toml").write_text(text.replace("105", "104", 1))
    done = cli("repeat", recipe, "--data", data)
    assert done.exit_code == 1
    assert "other field: sample, true" in done.output


def test_a_report_writes_the_same_recipe_and_its_tables_name_it(
    cli, recipe: Path, data: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    sources = [f"--cameras={name}={data / 'cameras' / name}" for name in SOURCES]
    tex, own = tmp_path / "new" / "t.tex", tmp_path / "own.json"
    words = (*sources, "-t", "5", "-t", "2", "--output", "new/t.tex", "--recipe", own)
    done = cli("report", data, *words)
    assert done.exit_code == 0, done.output
    assert "% recipe: own.json" in tex.read_text()
    ours, others = (json.loads(path.read_text()) for path in (own, recipe))
    assert ours["evaluations"] == others["evaluations"]
    assert ours["options"]["output"] == ["t.tex"]  # whether or not it was there before
    assert cli("repeat", own, "--data", data).exit_code == 0


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("{", "is no recipe"),
        ('{"format": "else"}', "is no recipe"),
        ("[]", "is no recipe"),
    ],
)
def test_what_is_no_recipe(cli, tmp_path: Path, content: str, said: str) -> None:
    path = tmp_path / "r.json"
    path.write_text(content)
    done = cli("repeat", path)
    assert done.exit_code == 2
    assert said in done.output


def test_a_recipe_cannot_lead_out_of_its_folder(cli, recipe: Path, data: Path) -> None:
    content = json.loads(recipe.read_text())
    for one in content["evaluations"]:
        one["annotations"] = "../.."
    recipe.write_text(json.dumps(content))
    done = cli("repeat", recipe, "--data", data)
    assert done.exit_code == 2
    assert "leads out" in done.output


def test_inputs_that_are_not_there(cli, recipe: Path, tmp_path: Path) -> None:
    done = cli("repeat", recipe, "--data", tmp_path / "nowhere")
    assert done.exit_code == 2


def test_intervals_are_made_again_and_compared(cli, data: Path, tmp_path: Path) -> None:
    tags = data / "tags.csv"
    frames = sorted(path.stem for path in data.glob("*.json"))
    tags.write_text("frame,half\n" + "\n".join(f"{f},{n % 2}" for n, f in enumerate(frames)))
    recipe = tmp_path / "recipe.json"
    sources = [f"--cameras={name}={data / 'cameras' / name}" for name in ("true", "bad")]
    asked = ("--tags", tags, "--by", "zoom", "--power", "--click-noise", 1, "--draws", 200)
    done = cli("report", data, *sources, *asked, "--recipe", recipe, "-o", tmp_path / "r.json")
    assert done.exit_code == 0, done.output
    found = json.loads(recipe.read_text())["chance"]
    assert {"intervals", "by_zoom"} < found["told"][0].keys()
    assert all(rows for rows in found["told"][0].values())
    assert found["draws"]["count"] == 200
    done = cli("repeat", recipe, "--data", data)
    assert (done.exit_code, "the same" in done.stdout) == (0, True), done.output
    found["told"][0]["intervals"][0]["mean_jac_low"] += 1e-6
    content = json.loads(recipe.read_text())
    recipe.write_text(json.dumps(content | {"chance": found}))
    done = cli("repeat", recipe, "--data", data)
    assert done.exit_code == 1
    assert "other figure: intervals, true@5: mean_jac_low" in done.stdout


def test_other_clusters_are_other_intervals(cli, data: Path, tmp_path: Path) -> None:
    tags, recipe = data / "tags.csv", tmp_path / "recipe.json"
    frames = sorted(path.stem for path in data.glob("*.json"))
    tags.write_text("frame,half\n" + "\n".join(f"{f},{n % 3}" for n, f in enumerate(frames)))
    given = (data, data / "cameras" / "bad", "--tags", tags, "--cluster", "half")
    assert cli("evaluate", *given, "--draws", 200, "--recipe", recipe).exit_code == 0
    tags.write_text("frame,half\n" + "\n".join(f"{f},{n % 2}" for n, f in enumerate(frames)))
    done = cli("repeat", recipe, "--data", data)
    assert done.exit_code == 1
    assert "other content: tags.csv" in done.stdout
    assert "other figure: intervals" in done.stdout
    assert "mean_jac@" not in done.stdout  # the figures themselves are the same


def test_what_tells_fits_is_hashed_beside_them(cli, data: Path, tmp_path: Path) -> None:
    fits, recipe = data / "fits", tmp_path / "recipe.json"
    assert cli("calibrate", data, fits, "--model", "H").exit_code == 0
    assert cli("evaluate", data, fits, "--recipe", recipe).exit_code == 0
    inputs = {one["role"]: one["files"] for one in json.loads(recipe.read_text())["inputs"]}
    assert "calibration.csv" in {file["name"] for file in inputs["cameras"]}
    assert cli("repeat", recipe, "--data", data).exit_code == 0
    (fits / "calibration.csv").unlink()
    done = cli("repeat", recipe, "--data", data)
    assert "missing: fits/calibration.csv" in done.stdout


def test_dimensions_of_a_workspace_go_along(cli, data: Path, tmp_path: Path) -> None:
    recipe = tmp_path / "recipe.json"
    done = cli("field-size", data, "--save")
    assert done.exit_code == 0, done.output
    cameras = data / "cameras" / "true"
    assert cli("evaluate", data, cameras, "--recipe", recipe).exit_code == 0
    elsewhere = tmp_path / "elsewhere"
    shutil.copytree(data, elsewhere, ignore=shutil.ignore_patterns(".procc"))
    done = cli("repeat", recipe, "--data", elsewhere)
    assert (done.exit_code, "the same" in done.stdout) == (0, True), done.output


def test_landmarks_and_views_of_the_set_are_inputs(cli, data: Path, tmp_path: Path) -> None:
    known = {"name": "Floodlight NE", "position": [61.2, -45.0, -28.4]}
    (data / "landmarks.json").write_text(json.dumps({"landmarks": [known]}))
    (data / "views.csv").write_text("frame,instant,view\n00001,1,main\n")
    path = tmp_path / "recipe.json"
    done = cli("evaluate", data, data / "cameras" / "true", "--recipe", path)
    assert done.exit_code == 0, done.output
    inputs = [(one["role"], one["path"]) for one in json.loads(path.read_text())["inputs"]]
    assert inputs[2:] == [("landmarks", "landmarks.json"), ("views", "views.csv")]
    known["position"] = [61.2, -45.0, -29.4]
    (data / "landmarks.json").write_text(json.dumps({"landmarks": [known]}))
    done = cli("repeat", path, "--data", data)
    assert "other content: landmarks.json" in done.stdout
