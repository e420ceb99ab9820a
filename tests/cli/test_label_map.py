"""``--map``: names of another program, with every command that reads annotations."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import Proposal
from procc_annotator.calibration.tracking import shot_tracker
from procc_annotator.cli import track
from procc_annotator.field.load import load_field


@pytest.fixture
def renamed(cli, dataset, tmp_path) -> tuple[Path, Path]:
    """The dataset as labelme files whose labels are numbers, and the map back."""
    folder = tmp_path / "renamed"
    assert cli("convert", dataset.root, folder, "--to", "labelme").exit_code == 0
    names = [e.name.strip() for e in load_field(None).elements]
    for file in folder.glob("*.json"):
        content = json.loads(file.read_text())
        for shape in content["shapes"]:
            shape["label"] = f"element {names.index(shape['label'].strip())}"
        file.write_text(json.dumps(content))
    labels = tmp_path / "names.toml"
    rules = [f'"element {i}" = "{name}"' for i, name in enumerate(names)]
    labels.write_text("\n".join(["[labels]", *rules]))
    return folder, labels


def test_figures_are_those_of_the_official_names(cli, dataset, renamed, tmp_path) -> None:
    folder, labels = renamed
    cameras = dataset.cameras
    cli("evaluate", dataset.annotations, cameras, "-o", tmp_path / "own.json")
    manifest = tmp_path / "manifest.json"
    done = cli(
        "evaluate",
        folder,
        cameras,
        "--map",
        labels,
        "-o",
        tmp_path / "s.json",
        "--manifest",
        manifest,
    )
    assert "names by" in done.stderr
    summaries = [json.loads((tmp_path / f"{n}.json").read_text())["summary"] for n in ("own", "s")]
    assert summaries[0] == summaries[1]
    again = cli("repeat", manifest)
    assert again.exit_code == 0, again.stdout + again.stderr
    agreed = cli("agree", dataset.annotations, folder, "--map", labels)
    assert "100.00" in agreed.stdout


def test_the_map_of_a_dataset_is_used_by_itself(cli, renamed, tmp_path) -> None:
    folder, labels = renamed
    (folder / "labels.toml").write_bytes(labels.read_bytes())
    done = cli("check", folder, "--no-line-evidence")
    assert done.exit_code == 0, done.stderr
    assert "unknown class" not in done.stdout
    assert cli("convert", folder, tmp_path / "back", "--to", "soccernet").exit_code == 0
    classes = {
        name for f in (tmp_path / "back").glob("*.json") for name in json.loads(f.read_text())
    }
    assert classes <= {e.name for e in load_field(None).elements}


def test_an_export_has_the_official_names(cli, dataset, renamed, tmp_path) -> None:
    """Of annotations alone, and of a dataset with pictures."""
    folder, labels = renamed
    for place in (folder, dataset.root):
        if place is dataset.root:
            for file in dataset.annotations.glob("*.json"):
                content = json.loads(file.read_text())
                names = [e.name for e in load_field(None).elements]
                named = {f"element {names.index(n)}": p for n, p in content.items()}
                file.write_text(json.dumps(named))
        out = tmp_path / f"out_{place.name}"
        assert cli("export", place, out, "--map", labels).exit_code == 0
        frames = [f for f in out.glob("*.json") if not f.name.startswith("jac")]
        assert len(frames) == 5
        classes = {name for f in frames for name in json.loads(f.read_text())}
        assert classes >= {"Middle line", "Side line top"}
        assert not any(name.startswith("element ") for name in classes)


def test_unknown_labels_are_listed_once_with_counts(cli, renamed) -> None:
    folder, _ = renamed
    done = cli("check", folder, "--no-line-evidence")
    lines = [line for line in done.stderr.splitlines() if "does not know" in line]
    assert len(lines) == 1
    assert "does not know 26 labels: element " in lines[0]
    assert "and 14 more" in lines[0]
    assert "labels.toml" in lines[0]


def test_a_map_that_is_wrong_is_one_line(cli, renamed) -> None:
    folder, labels = renamed
    labels.write_text('[labels]\n"element 1" = "Side line bottm"')
    done = cli("check", folder, "--map", labels)
    assert done.exit_code == 2
    assert len(done.stderr.splitlines()) == 1
    assert "line 2: label 'element 1'" in done.stderr
    assert "did you mean 'Side line bottom'?" in done.stderr


def test_pictures_are_drawn_by_the_map(cli, dataset, renamed, tmp_path) -> None:
    folder, labels = renamed
    runs = {
        "own": ("--annotations", dataset.annotations),
        "mapped": ("--annotations", folder, "--map", labels),
        "unnamed": ("--annotations", folder),
    }
    drawn = {}
    for name, given in runs.items():
        out = tmp_path / name
        done = cli("render", dataset.root, out, "--cameras", dataset.cameras, *given)
        assert done.exit_code == 0, done.stderr
        drawn[name] = {file.name: file.read_bytes() for file in out.glob("*.png")}
    assert len(drawn["own"]) == 5
    assert drawn["mapped"] == drawn["own"]
    assert drawn["unnamed"] != drawn["own"]
    (dataset.root / "labels.toml").write_bytes(labels.read_bytes())
    by_itself = tmp_path / "by_itself"
    args = ("--cameras", dataset.cameras, "--annotations", folder)
    assert cli("render", dataset.root, by_itself, *args).exit_code == 0
    assert {file.name: file.read_bytes() for file in by_itself.glob("*.png")} == drawn["own"]


def test_anchors_of_a_track_are_fitted_by_the_map(
    cli, dataset, renamed, monkeypatch, tmp_path
) -> None:
    """Nothing is found in pictures alone, which would take long where no anchor is known."""
    folder, labels = renamed

    def none(picture, field, *, known, **_) -> Proposal:
        why = "not looked for"
        fit = FitResult("R", (picture.shape[1], picture.shape[0]), None, why)
        return Proposal("none", why, fit, 0.0, 0.0, None, 0.0, None)

    monkeypatch.setattr(shot_tracker, "propose_camera", none)
    monkeypatch.setattr(track, "warm_up_caches", lambda *_: None)
    said = []
    for given in ((), ("--map", labels)):
        out = tmp_path / f"tracked{len(given)}"
        done = cli("track", dataset.root, out, "--annotations", folder, *given)
        said.append("no frame here has a camera in" in done.stderr)
    assert said == [True, False]


def test_annotated_frames_are_told_by_the_map(cli, dataset, renamed, tmp_path) -> None:
    folder, labels = renamed
    done = cli("propose", dataset.root, tmp_path / "p", "--annotations", folder, "--map", labels)
    assert "names by" in done.stderr
    assert "all frames are annotated" in done.stderr
    done = cli("annotate", dataset.root, folder, "--cameras", dataset.cameras, "--map", labels)
    assert "names by" in done.stderr
    assert "not touched: 5 frames annotated already" in done.stdout
