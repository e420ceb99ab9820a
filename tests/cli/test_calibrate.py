"""``calibrate`` writes a camera a frame that scores well, and says why where it does not."""

import json
import os
import re
import shutil
import sqlite3
import subprocess
import sys
import zipfile
from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from procc_annotator import load_dataset
from procc_annotator.batch import calibration, joint_calibration
from procc_annotator.batch.calibration import leave_one_out
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import write_annotation
from procc_annotator.formats.cameras.fit_record import annotation_digest
from tests.bench.sports.views import Views
from tests.cli.conftest import rows_in


def table(out: Path) -> dict[str, dict[str, str]]:
    return {row["name"]: row for row in rows_in(out / "calibration.csv")}


@pytest.mark.parametrize("kind", ["dataset", "annotations", "zip"])
def test_a_camera_for_every_frame(cli, dataset, tmp_path, kind):
    given = {"dataset": dataset.root, "annotations": dataset.annotations}.get(kind)
    if given is None:
        given = tmp_path / "annotations.zip"
        with zipfile.ZipFile(given, "w") as archive:
            for path in dataset.annotations.iterdir():
                archive.write(path, path.name)
    out = tmp_path / "fitted"
    done = cli("calibrate", given, out, "-t", 2, "-t", 5)
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
    assert "100.00" in scored.stdout


def test_homographies_are_read_again_as_they_were_written(cli, dataset, tmp_path):
    out = tmp_path / "flat"
    cli("calibrate", dataset.root, out, "--model", "H", "-t", 5)
    assert sorted(p.name for p in out.glob("*.npy"))[0] == "1.npy"
    assert np.load(out / "1.npy").shape == (3, 3)
    scores = tmp_path / "scores.json"
    cli("evaluate", dataset.annotations, out, "-t", 5, "--off-plane", "left_out", "-o", scores)
    summary = json.loads(scores.read_text())["summary"]["5"]
    jacs = [float(row["jac_5"]) for row in table(out).values()]
    assert summary["mean_jac"] == pytest.approx(np.mean(jacs))
    assert np.mean(jacs) > 0.95


def test_the_model_is_chosen_for_each_frame(cli, dataset, tmp_path):
    out = tmp_path / "chosen"
    done = cli("calibrate", dataset.root, out, "--model", "auto", "-t", 2)
    assert "model chosen for each frame (" in " ".join(done.stdout.split())
    rows = table(out)
    assert {row["model"] for row in rows.values()} <= {"P", "R", "R+"}
    assert all(float(row["jac_2"]) == 1.0 for row in rows.values())


def test_frames_without_a_camera_say_why(cli, dataset, tmp_path):
    two = json.loads((dataset.annotations / "3.json").read_text())
    kept = dict(list(two.items())[:2])
    (dataset.annotations / "3.json").write_text(json.dumps(kept))
    out = tmp_path / "fitted"
    out.mkdir()
    (out / "camera_3.json").write_text("{}")  # of an earlier run
    done = cli("calibrate", dataset.root, out, "--overwrite")
    row = table(out)["3"]
    assert (row["failure"], row["camera"], row["jac_5"]) == ("2 elements, 3 needed", "", "")
    assert "2 elements, 3 needed" in done.stdout
    assert "1 frame without a camera" in done.stdout
    assert "80.00" in done.stdout  # completeness
    assert "camera_3.json" in done.stderr  # not written now and not touched
    assert (out / "camera_3.json").read_text() == "{}"


def test_unreadable_annotations_are_listed_and_the_rest_is_done(cli, dataset, tmp_path):
    (dataset.annotations / "2.json").write_text("{")
    done = cli("calibrate", dataset.root, tmp_path / "out", code=1)
    assert "2.json" in done.stderr
    rows = table(tmp_path / "out")
    assert "2.json" in rows["2"]["failure"]
    assert rows["1"]["camera"] == "camera_1.json"


def test_a_name_that_is_no_utf_8(dataset, tmp_path):
    name = os.fsdecode(b"caf\xe9_1")
    few, out = tmp_path / "few", tmp_path / "out"
    few.mkdir()
    (few / f"{name}.json").write_bytes((dataset.annotations / "2.json").read_bytes())
    files = ("-o", tmp_path / "scores.json", "--manifest", tmp_path / "manifest.json")
    for asked in (("calibrate", "-m", "P"), ("evaluate", "--annotation-noise", "1", *files)):
        command = [sys.executable, "-m", "procc_annotator", *asked, few, out]
        done = subprocess.run(command, check=False, capture_output=True)
        assert done.returncode == 0, done.stderr
    assert (out / f"camera_{name}.json").is_file()
    scores = json.loads((tmp_path / "scores.json").read_text())
    assert [image["name"] for image in scores["images"]] == ["caf\\udce9_1"]


@pytest.mark.parametrize(
    ("asked", "code", "said"),
    [
        (("export", "SET", "OUT", "--cameras", "CAMERAS"), 0, ""),
        (("report", "SET", "--cameras", "CAMERAS", "-o", "OUT/x.json"), 0, ""),
        (("release", "SET", "OUT", "--no-check"), 1, "rename the file"),
        (("export", "SET", "OUT/x.zip", "--cameras", "CAMERAS"), 2, "rename the file"),
        (("convert", "SET", "OUT/x.json", "--to", "coco", "--size", "960x540"), 1, "rename"),
        (("convert", "SET", "OUT/x.xml", "--to", "cvat", "--size", "960x540"), 1, "rename"),
        (("convert", "SET", "OUT", "--to", "labelme", "--size", "960x540"), 1, "rename"),
    ],
)
def test_a_name_that_is_no_utf_8_ends_no_command(cli, dataset, tmp_path, asked, code, said):
    name = os.fsdecode(b"caf\xe9_1")
    places = {"SET": tmp_path / "few", "CAMERAS": tmp_path / "seen", "OUT": tmp_path / "out"}
    places["SET"].mkdir()
    places["CAMERAS"].mkdir()
    for called in ("2", name):
        shutil.copy(dataset.annotations / "2.json", places["SET"] / f"{called}.json")
        shutil.copy(dataset.cameras / "camera_2.json", places["CAMERAS"] / f"camera_{called}.json")
    words = [str(places.get(w, w)).replace("OUT/", f"{places['OUT']}/") for w in asked]
    done = cli(*words, code=code)
    assert said in done.stderr


def test_a_wrong_label_is_left_out_and_told(cli, dataset, tmp_path):
    path = dataset.annotations / "1.json"
    content = json.loads(path.read_text())
    content["Middle line"] = content.pop("Small rect. left main")
    path.write_text(json.dumps(content))
    done = cli("calibrate", dataset.root, tmp_path / "out")
    assert table(tmp_path / "out")["1"]["left_out"] == "Middle line"
    assert "were left out: 1" in done.stderr


def test_cameras_that_are_there_stay_unless_asked_for(cli, dataset, tmp_path):
    out = tmp_path / "out"
    cli("calibrate", dataset.root, out, "--model", "P")
    before = {file.name: file.read_bytes() for file in out.iterdir()}
    refused = cli("calibrate", dataset.root, out, code=2)
    assert "--overwrite" in refused.stderr
    assert {file.name: file.read_bytes() for file in out.iterdir()} == before
    cli("calibrate", dataset.root, out, "--overwrite")
    assert {file.name: file.read_bytes() for file in out.iterdir()} != before


def test_cameras_in_folders_of_out_stay_unless_asked_for(cli, dataset, tmp_path):
    match, out = tmp_path / "halves", tmp_path / "out"
    for half in ("1", "2"):
        (match / half).mkdir(parents=True)
        shutil.copy(dataset.annotations / "1.json", match / half)
    theirs = out / "2" / "camera_1.json"
    theirs.parent.mkdir(parents=True)
    theirs.write_text("{}")
    refused = cli("calibrate", match, out, "--model", "P", code=2)
    assert "--overwrite" in refused.stderr
    assert theirs.read_text() == "{}"


def test_cameras_do_not_go_among_annotations_of_another_set(cli, dataset, tmp_path):
    other = tmp_path / "other"
    other.mkdir()
    (other / "7.json").write_bytes((dataset.annotations / "1.json").read_bytes())
    done = cli("calibrate", dataset.root, other, "--overwrite", code=2)
    assert "holds annotations (7.json), write to another folder" in done.stderr
    assert [file.name for file in other.iterdir()] == ["7.json"]
    (other / "7.json").write_text('{"mean_jac": 1.0}')  # scores, say
    cli("calibrate", dataset.root, other)


def test_an_interrupted_run_says_what_is_there_and_how_to_go_on(
    cli, dataset, tmp_path, monkeypatch, fit_once
):
    for number in range(15):  # more than one chunk
        copy = dataset.annotations / f"again{number}.json"
        copy.write_bytes((dataset.annotations / "1.json").read_bytes())
    fits = 0

    def stopped(*args, **options):
        nonlocal fits
        fits += 1
        if fits == 18:
            raise KeyboardInterrupt
        return fit_once(*args, **options)

    with monkeypatch.context() as patched:
        fits_come_from(stopped, patched)
        out = tmp_path / "out"
        done = cli("calibrate", dataset.root, out, "-m", "P", code=130)
        assert (
            f"interrupted: 16 cameras of 20 frames written to {out}, calibration.csv not"
            in done.stderr
        )
        assert "again with --resume" in done.stderr
        assert len(list(out.glob("camera_*.json"))) == 16
        fits = 0
        archive = cli("calibrate", dataset.root, tmp_path / "out.zip", "-m", "P", code=130)
        assert "out.zip was not written" in archive.stderr
        assert not (tmp_path / "out.zip").exists()
    again = cli("calibrate", dataset.root, out, code=2)
    assert "a run was stopped here; --resume goes on with it, --overwrite begins" in again.stderr
    cli("calibrate", dataset.root, out, "-m", "P", "--overwrite")
    assert len(table(out)) == 20


@pytest.fixture(scope="module")
def held_out_once() -> Callable[..., object]:
    """As `leave_one_out`, but of an annotation that was seen before it knows the outcome: most
    of the frames below are the same one, and its fits take longer than all the rest."""
    known: dict[str, object] = {}

    def held_out(annotation, fit, own, model):
        key = f"{annotation_digest(annotation)} {model}"
        if key not in known:
            known[key] = leave_one_out(annotation, fit, own, model)
        return known[key]

    return held_out


@pytest.fixture(scope="module")
def fit_once() -> Callable[..., FitResult]:
    """As `fit_camera`, likewise."""
    known: dict[str, FitResult] = {}

    def fit(annotation, field, **options):
        key = f"{annotation_digest(annotation)} {field.name} {options}"
        if key not in known:
            known[key] = fit_camera(annotation, field, **options)
        return known[key]

    return fit


def fits_come_from(fit: Callable[..., FitResult], patched: pytest.MonkeyPatch) -> None:
    def of_chunk(given, *, model: str) -> list[FitResult]:
        return [fit(clicks, field, model=model, size=size) for clicks, field, size in given]

    for module in (calibration, joint_calibration):
        patched.setattr(module, "fit_cameras", of_chunk)


@pytest.mark.parametrize("more", [(), ("--leave-one-out",), ("--shared-position",)])
@pytest.mark.parametrize("name", ["out", "out.zip"])
def test_a_stopped_run_goes_on_and_writes_the_bytes_of_one_run(
    cli, dataset, tmp_path, monkeypatch, held_out_once, fit_once, more, name
):
    monkeypatch.setattr(calibration, "leave_one_out", held_out_once)
    fits_come_from(fit_once, monkeypatch)
    for number in range(15):  # more than one chunk
        copy = dataset.annotations / f"again{number}.json"
        copy.write_bytes((dataset.annotations / "1.json").read_bytes())
    asked = ("calibrate", dataset.root, "-m", "P", *more)
    cli(*asked, tmp_path / "one" / name)
    fitted = []

    def counted(annotation, *args, **options):
        fitted.append(annotation)
        if len(fitted) == 18:
            raise KeyboardInterrupt
        return fit_once(annotation, *args, **options)

    out = tmp_path / "two" / name
    with monkeypatch.context() as patched:
        fits_come_from(counted, patched)
        cli(*asked, out, code=130)
        fitted.clear()
        other = cli("calibrate", dataset.root, "-m", "R", *more, out, "--resume", code=2)
        assert fitted == []
        assert "begun with another model (P, now R)" in other.stderr
        fitted.extend([None] * 20)  # no further interrupt
        cli(*asked, out, "--resume")
    assert len(fitted) == 20 + 4  # the first chunk of 16 was kept
    assert contents(tmp_path / "two") == contents(tmp_path / "one")


def contents(folder: Path) -> dict[str, bytes]:
    """Every file below a folder, hidden ones too."""
    found = (path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in found}


def test_a_killed_run_goes_on_but_fits_anew_what_changed(cli, dataset, tmp_path):
    """Also where a result is damaged on the disk; and somebody corrects a click meanwhile."""
    out = tmp_path / "out"
    left = out / ".calibrate.unfinished"
    code = (
        "import os; from procc_annotator.report import calibration;"
        "calibration.csv_bytes = lambda table: os.kill(os.getpid(), 9);"
        "from procc_annotator.cli.main import run; run()"
    )
    words = ["calibrate", str(dataset.root), str(out), "-m", "P"]
    killed = subprocess.run([sys.executable, "-c", code, *words], check=False, capture_output=True)
    assert killed.returncode == -9
    undamaged = left.read_bytes()
    with closing(sqlite3.connect(left)) as units, units:
        assert units.execute("UPDATE units SET result = substr(result, 1, 40)").rowcount == 1
    cli(*words, "--resume")
    assert not left.exists()
    whole = contents(out)
    left.write_bytes(undamaged)
    file = dataset.annotations / "3.json"
    file.write_bytes((dataset.annotations / "2.json").read_bytes())
    cli(*words, "--resume")
    changed = contents(out)
    assert {name for name in whole if whole[name] != changed[name]} == {
        "camera_3.json", "calibration.csv"
    }  # fmt: skip


def test_resume_says_what_it_cannot_go_on_with(cli, dataset, tmp_path):
    out = tmp_path / "out"
    asked = ("calibrate", dataset.root, out, "--resume")
    assert "give one of them" in cli(*asked, "--overwrite", code=2).stderr
    cli(*asked)  # nothing is there: it begins
    again = cli(*asked)
    assert "already complete: calibration.csv is there and no run was stopped here" in again.stdout
    (out / ".calibrate.unfinished").write_text("[]\n")
    damaged = cli(*asked, code=2)
    assert "is not what a run of this program leaves" in damaged.stderr


def test_cameras_that_are_hardly_determined_are_named(cli, dataset, tmp_path):
    kept = ("Middle line", "Side line top", "Circle central")
    content = json.loads((dataset.annotations / "3.json").read_text())
    few = {name: content[name][:2] for name in kept}
    (dataset.annotations / "3.json").write_text(json.dumps(few))
    done = cli("calibrate", dataset.root, tmp_path / "out", "-m", "P")
    rows = table(tmp_path / "out")
    assert "position ± " in rows["3"]["hardly_determined"]
    assert rows["1"]["hardly_determined"] == ""
    named = {name for name, row in rows.items() if row["hardly_determined"]}
    assert "hardly determined (pan, tilt or roll ± more than 1°" in done.stderr
    told = next(line for line in done.stderr.splitlines() if "hardly determined" in line)
    assert set(told.rpartition("): ")[2].split(", ")) == named


def test_left_out_classes_are_written_as_in_the_files(cli, dataset, tmp_path):
    path = dataset.annotations / "1.json"
    content = json.loads(path.read_text())
    content["Goal right post left"] = content.pop("Goal left post left ")
    content["Goal left post left "] = content["Goal right post left"][::-1]
    content["Goal left post left "] = [
        {"x": p["x"], "y": p["y"] + 0.3} for p in content["Goal left post left "]
    ]
    del content["Goal right post left"]
    path.write_text(json.dumps(content))
    cli("calibrate", dataset.root, tmp_path / "out")
    assert table(tmp_path / "out")["1"]["left_out"] == "Goal left post left "


@pytest.mark.parametrize("command", ["calibrate", "check", "field-size"])
def test_tables_fit_a_narrow_terminal(cli, dataset, tmp_path, monkeypatch, command):
    monkeypatch.setenv("COLUMNS", "80")
    out = [tmp_path / "out", "--shared-position"] if command == "calibrate" else []
    taus = [] if command == "check" else ["-t", 2, "-t", 5]
    done = cli(command, dataset.root, *out, *taus)
    for line in done.stdout.splitlines():
        assert len(line) <= 80 or line.startswith("written: ")
        assert line == line.rstrip()
        assert "…" not in line
        assert not line.startswith("│ ±")
    if command == "calibrate":
        for word in ("completeness", "precision", "recall", "farthest element"):
            assert word in done.stdout
        assert re.search(r"-?\d+\.\d\d ± \d+\.\d\d", done.stdout)


@pytest.mark.parametrize("command", ["calibrate", "check", "field-size"])
def test_other_files_are_no_datasets(cli, tmp_path, command):
    (tmp_path / "notes.txt").write_text("x")
    out = [tmp_path / "out"] if command == "calibrate" else []
    done = cli(command, tmp_path / "notes.txt", *out, code=2)
    assert "is neither a folder nor an archive" in done.stderr


def test_an_annotated_video_is_a_dataset_to_every_command(cli, dataset, tmp_path):
    video, folder = tmp_path / "match.mp4", tmp_path / "match_frames"
    video.write_bytes(b"no video")
    cameras, out = tmp_path / "cams", tmp_path / "out"
    cameras.mkdir()
    for command in (["report", video, "--cameras", dataset.cameras, "-o", tmp_path / "r.json"],
                    ["convert", video, out, "--to", "labelme", "--size", "960x540"]):  # fmt: skip
        assert "1 video, not annotated yet" in cli(*command, code=2).stderr
    folder.mkdir()
    (folder / "match_000001.json").write_bytes((dataset.annotations / "1.json").read_bytes())
    camera = (dataset.cameras / "camera_1.json").read_bytes()
    (cameras / "camera_match_000001.json").write_bytes(camera)
    for command in (
        ["report", video, "--cameras", cameras, "-o", tmp_path / "r.json"],
        ["convert", video, out, "--to", "labelme", "--size", "960x540"],
        ["compare", f"a={cameras}", f"b={cameras}", video],
        ["evaluate", video, cameras],
    ):
        cli(*command)
    assert (out / "match_000001.json").is_file()
    assert set(load_dataset(video).annotations) == {"match_000001"}
    assert "expected a video" in cli("render", video, tmp_path / "drawn", code=2).stderr


def test_a_video_has_its_annotations_beside_it(cli, dataset, tmp_path):
    folder = tmp_path / "vid" / "match_frames"
    folder.mkdir(parents=True)
    video = tmp_path / "vid" / "match.mp4"
    video.write_bytes(b"no video")
    assert "match_frames" in cli("check", video, code=2).stderr
    (folder / "match_000001.json").write_bytes((dataset.annotations / "1.json").read_bytes())
    for given in (video, video.parent, folder):
        done = cli("check", given)
        assert "Checked 1 frame\n" in done.stdout
    for name in ("landmarks.json", "field.toml"):  # its own things lie there too
        (folder / name).write_text("damaged")
        for given in (video, video.parent):
            assert f"match_frames/{name}" in cli("check", given, code=2).stderr.replace("\n", "")
        (folder / name).unlink()
    second = tmp_path / "vid" / "other.mov"
    second.write_bytes(b"")
    (tmp_path / "vid" / "other_frames").mkdir()
    cli("check", video.parent)
    (tmp_path / "vid" / "other_frames" / "other_000002.json").write_text("{}")
    assert "Checked 2 frames\n" in cli("check", video.parent).stdout


def test_fits_that_the_official_evaluation_folds_into_the_picture_are_told(cli, tmp_path):
    pitch = Views(load_field("soccer"))
    rng = np.random.default_rng(0)
    annotations = tmp_path / "annotations"
    annotations.mkdir()
    for frame, k1 in (("wide", -0.12), ("ordinary", 0.0)):
        camera = PinholeCamera(
            0.0, np.deg2rad(76), 0.0, (0.0, 45.0, -8.0), (600.0, 600.0), (479.5, 269.5),
            (k1, 0.0, 0.0, 0.0, 0.0, 0.0),
        )  # fmt: skip
        clicks = pitch.clicks(camera, rng, noise_px=0.3)
        (annotations / f"{frame}.json").write_bytes(write_annotation(clicks))
    done = cli("calibrate", annotations, tmp_path / "out")
    (told,) = [line for line in done.stderr.splitlines() if "fold" in line]
    assert told.startswith("note: 1 camera folds lines from far outside back into the picture")
    assert told.endswith(": wide")


def test_a_camera_has_one_mean_error_in_calibrate_and_in_evaluate(cli, dataset, tmp_path):
    """At a tau no click is below, where the official evaluation takes all labels mirrored."""
    out = tmp_path / "fits"
    cli("calibrate", dataset.annotations, out, "-t", 0.0001)
    scores = tmp_path / "scores.json"
    cli("evaluate", dataset.annotations, out, "-t", 0.0001, "--output", scores)
    own = {row["name"]: row for row in rows_in(out / "calibration.csv")}
    images = json.loads(scores.read_text())["images"]
    assert len(images) == len(own) > 1
    for image in images:
        result = image["results"]["0.0001"]
        for key in ("mean_error", "mean_reprojection_error"):
            assert float(own[image["name"]][key]) == pytest.approx(result[key], abs=1e-6)
        assert result["mean_error"] < 1
    results = [image["results"]["0.0001"] for image in images]
    assert any(r["mirrored"] and r["mean_reprojection_error"] > 100 for r in results)


def test_elements_left_out_are_judged_by_the_others(cli, dataset, tmp_path):
    path = dataset.annotations / "1.json"
    content = json.loads(path.read_text())
    name = next(n for n in content if n.startswith("Circle"))
    content[name] = [{"x": p["x"], "y": p["y"] + 12 / 539} for p in content[name]]
    path.write_text(json.dumps(content))
    out = tmp_path / "fitted"
    done = cli("calibrate", dataset.root, out, "-t", 2, "-t", 5, "--leave-one-out")
    assert "Elements left out in turn" in done.stdout
    rows = table(out)
    assert list(rows["1"])[-3:] == ["held_out_elements", "held_out_passed_2", "held_out_passed_5"]
    assert rows["3"]["held_out_elements"] == "0"  # few elements: the others determine no camera
    exact = rows["2"]
    assert int(exact["held_out_elements"]) > 3
    assert exact["held_out_passed_5"] == exact["held_out_elements"]
    moved = rows["1"]
    assert int(moved["held_out_passed_5"]) < int(moved["held_out_elements"])
    cli("calibrate", dataset.root, tmp_path / "no", "--leave-one-out", "--shared-position", code=2)


def test_cameras_of_frames_that_are_gone_are_told(cli, dataset, tmp_path):
    out = tmp_path / "out"
    cli("calibrate", dataset.root, out, "--model", "P")
    (dataset.annotations / "2.json").unlink()
    done = cli("calibrate", dataset.root, out, "--model", "P", "--overwrite")
    assert "holds 1 other camera, not written now and not touched: camera_2.json" in done.stderr
