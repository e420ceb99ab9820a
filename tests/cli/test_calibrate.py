"""``calibrate`` writes a camera a frame that scores well, and says why where it does not."""

from __future__ import annotations

import csv
import json
import zipfile
from pathlib import Path

import numpy as np
import pytest


def table(out: Path) -> dict[str, dict[str, str]]:
    with open(out / "calibration.csv", newline="") as file:
        return {row["name"]: row for row in csv.DictReader(file)}


@pytest.mark.parametrize("kind", ["dataset", "annotations", "zip"])
def test_a_camera_for_every_frame(cli, dataset, tmp_path, kind) -> None:
    given = {"dataset": dataset.root, "annotations": dataset.annotations}.get(kind)
    if given is None:
        given = tmp_path / "annotations.zip"
        with zipfile.ZipFile(given, "w") as archive:
            for path in dataset.annotations.iterdir():
                archive.write(path, path.name)
    out = tmp_path / "fitted"
    done = cli("calibrate", given, out, "-t", 2, "-t", 5)
    assert done.exit_code == 0, done.stderr
    assert "5 cameras and calibration.csv" in done.stdout
    rows = table(out)
    assert list(rows) == ["1", "2", "3", "10", "11"]
    for name, row in rows.items():
        assert (row["model"], row["failure"], row["left_out"]) == ("R", "", "")
        assert float(row["jac_2"]) == 1.0
        assert float(row["mean_reprojection_error"]) < 0.2
        assert 0 < float(row["sd_pan_degrees"]) < 1
        fitted = json.loads((out / row["camera"]).read_text())
        truth = json.loads((dataset.cameras / f"camera_{name}.json").read_text())
        # Zoom and distance are nearly exchangeable around the centre circle: the table says so.
        said = [float(row[f"sd_{axis}_m"]) for axis in "xyz"]
        apart = np.abs(np.subtract(fitted["position_meters"], truth["position_meters"]))
        assert (apart < 2 * np.array(said)).all()
        off = abs(fitted["pan_degrees"] - truth["pan_degrees"])
        assert off < 2 * float(row["sd_pan_degrees"])
        assert (fitted["image_width"], fitted["image_height"]) == (960, 540)
    scored = cli("evaluate", dataset.annotations, out, "-t", 2)
    assert scored.exit_code == 0, scored.stderr
    assert "100.00" in scored.stdout


def test_homographies_are_read_again_as_they_were_written(cli, dataset, tmp_path) -> None:
    out = tmp_path / "flat"
    done = cli("calibrate", dataset.root, out, "--model", "H", "-t", 5)
    assert done.exit_code == 0, done.stderr
    assert sorted(p.name for p in out.glob("*.npy"))[0] == "1.npy"
    assert np.load(out / "1.npy").shape == (3, 3)
    scores = tmp_path / "scores.json"
    again = cli(
        "evaluate", dataset.annotations, out, "-t", 5, "--off-plane", "left_out", "-o", scores
    )
    assert again.exit_code == 0, again.stderr
    summary = json.loads(scores.read_text())["summary"]["5"]
    jacs = [float(row["jac_5"]) for row in table(out).values()]
    assert summary["mean_jac"] == pytest.approx(np.mean(jacs))
    assert np.mean(jacs) > 0.95


def test_the_model_is_chosen_for_each_frame(cli, dataset, tmp_path) -> None:
    out = tmp_path / "chosen"
    done = cli("calibrate", dataset.root, out, "--model", "auto", "-t", 2)
    assert done.exit_code == 0, done.stderr
    assert "model chosen for each frame (" in " ".join(done.stdout.split())
    rows = table(out)
    assert {row["model"] for row in rows.values()} <= {"P", "R", "R+"}
    assert all(float(row["jac_2"]) == 1.0 for row in rows.values())


def test_frames_without_a_camera_say_why(cli, dataset, tmp_path) -> None:
    two = json.loads((dataset.annotations / "3.json").read_text())
    kept = dict(list(two.items())[:2])
    (dataset.annotations / "3.json").write_text(json.dumps(kept))
    out = tmp_path / "fitted"
    out.mkdir()
    (out / "camera_3.json").write_text("{}")  # of an earlier run
    done = cli("calibrate", dataset.root, out, "--overwrite")
    assert done.exit_code == 0, done.stderr
    row = table(out)["3"]
    assert (row["failure"], row["camera"], row["jac_5"]) == ("2 elements, 3 needed", "", "")
    assert "2 elements, 3 needed" in done.stdout
    assert "1 frame without a camera" in done.stdout
    assert "80.00" in done.stdout  # completeness
    assert "camera_3.json" in done.stderr  # not written now and not touched
    assert (out / "camera_3.json").read_text() == "{}"


def test_unreadable_annotations_are_listed_and_the_rest_is_done(cli, dataset, tmp_path) -> None:
    (dataset.annotations / "2.json").write_text("{")
    done = cli("calibrate", dataset.root, tmp_path / "out")
    assert done.exit_code == 1
    assert "2.json" in done.stderr
    rows = table(tmp_path / "out")
    assert "2.json" in rows["2"]["failure"]
    assert rows["1"]["camera"] == "camera_1.json"


def test_a_wrong_label_is_left_out_and_told(cli, dataset, tmp_path) -> None:
    path = dataset.annotations / "1.json"
    content = json.loads(path.read_text())
    content["Middle line"] = content.pop("Small rect. left main")
    path.write_text(json.dumps(content))
    done = cli("calibrate", dataset.root, tmp_path / "out")
    assert table(tmp_path / "out")["1"]["left_out"] == "Middle line"
    assert "were left out: 1" in done.stderr


def test_workers_give_the_same_files(cli, dataset, tmp_path) -> None:
    for number in range(20):  # more than one chunk
        copy = dataset.annotations / f"again{number}.json"
        copy.write_text((dataset.annotations / "1.json").read_text())
    one, two = tmp_path / "one", tmp_path / "two"
    for out, workers in ((one, 1), (two, 2)):
        done = cli("calibrate", dataset.root, out, "--workers", workers)
        assert done.exit_code == 0, done.stderr
    names = sorted(p.name for p in one.iterdir())
    assert len(names) == 26
    assert names == sorted(p.name for p in two.iterdir())
    for name in names:
        assert (one / name).read_bytes() == (two / name).read_bytes()


def test_an_archive_can_be_written(cli, dataset, tmp_path) -> None:
    out = tmp_path / "cameras.zip"
    done = cli("calibrate", dataset.root, out)
    assert done.exit_code == 0, done.stderr
    assert "camera_10.json" in zipfile.ZipFile(out).namelist()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--model", "Q"], "choose one of H, P, R, R+"),
        (["--model", "r+"], "did you mean R+"),
        (["--field", "soccr"], "soccer"),
    ],
)
def test_requests_that_make_no_sense(cli, dataset, tmp_path, arguments, message) -> None:
    done = cli("calibrate", dataset.root, tmp_path / "out", *arguments)
    assert done.exit_code == 2
    assert message in done.stderr
    assert not (tmp_path / "out").exists()


def test_nothing_to_do(cli, tmp_path) -> None:
    (tmp_path / "empty").mkdir()
    done = cli("calibrate", tmp_path / "empty", tmp_path / "out")
    assert done.exit_code == 2
    assert "nothing to do" in done.stderr
    assert cli("calibrate", tmp_path / "none", tmp_path / "out").exit_code == 2


def test_out_must_not_be_a_file_or_what_is_read(cli, dataset, tmp_path) -> None:
    (tmp_path / "file").write_text("")
    assert "a folder is needed" in cli("calibrate", dataset.root, tmp_path / "file").stderr
    given = tmp_path / "a.zip"
    with zipfile.ZipFile(given, "w") as archive:
        archive.write(dataset.annotations / "1.json", "1.json")
    assert "to be read" in cli("calibrate", given, given).stderr


def test_cameras_are_not_written_among_the_annotations(cli, dataset) -> None:
    before = set(dataset.root.rglob("*"))
    done = cli("calibrate", dataset.root, dataset.annotations)
    assert done.exit_code == 2
    assert "holds the files to be read" in done.stderr
    assert set(dataset.root.rglob("*")) == before


def test_cameras_that_are_there_stay_unless_asked_for(cli, dataset, tmp_path) -> None:
    out = tmp_path / "out"
    assert cli("calibrate", dataset.root, out, "--model", "P").exit_code == 0
    before = {file.name: file.read_bytes() for file in out.iterdir()}
    refused = cli("calibrate", dataset.root, out)
    assert refused.exit_code == 2
    assert "--overwrite" in refused.stderr
    assert {file.name: file.read_bytes() for file in out.iterdir()} == before
    assert cli("calibrate", dataset.root, out, "--overwrite").exit_code == 0
    assert {file.name: file.read_bytes() for file in out.iterdir()} != before
