"""``procc-annotator evaluate`` as a user runs it."""

import errno
import json
import os
import pty
import re
import shutil
import subprocess
import sys
import unicodedata
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import store_field
from procc_annotator.dataset.layout import folder_of_dataset
from procc_annotator.field.load import load_field, with_lines
from tests.cli.conftest import camera_file, rows_in

THRESHOLDS = ("-t", "5", "-t", "2.5")


def load(path: Path) -> dict[str, Any]:
    def no_constants(text: str) -> None:
        raise AssertionError(f"{text} is not JSON")

    return json.loads(path.read_text(), parse_constant=no_constants)


def images(path: Path) -> dict[str, dict[str, Any]]:
    return {image["name"]: image for image in load(path)["images"]}


def test_perfect_cameras_get_a_perfect_score(cli, dataset, tmp_path):
    out = tmp_path / "out.json"
    cli("evaluate", *dataset.set_arguments, *THRESHOLDS, "--output", out)
    scores = load(out)
    field_terms = ["field", "field_name", "field_dimensions", "field_lines"]
    assert list(scores) == ["protocol", *field_terms, "size", "thresholds", "images", "summary"]
    assert scores["protocol"] == "soccernet"
    assert scores["size"] == [960, 540]
    assert scores["thresholds"] == [5, 2.5]
    assert [image["name"] for image in scores["images"]] == ["1", "2", "3", "10", "11"]
    for image in scores["images"]:
        told = ["name", "camera", "error", "model", "annotated_elements", "spread", "results"]
        assert list(image) == told
        assert list(image["results"]) == ["5", "2.5"]
        result = image["results"]["5"]
        assert list(result) == [
            "tp", "fp", "fn", "jac", "mirrored", "precision", "recall",
            "mean_reprojection_error", "mean_error", "elements",
        ]  # fmt: skip
        assert result["jac"] == 1
        assert {e["status"] for e in result["elements"].values()} == {"tp"}
        assert all(len(e["distances"]) == 3 for e in result["elements"].values())
    summary = scores["summary"]["2.5"]
    assert summary["completeness"] == summary["final_score"] == summary["mean_jac"] == 1
    assert summary["per_class"]["Middle line"]["fp"] == 0


def test_lines_lie_where_the_rules_measure_unless_told(cli, dataset, tmp_path):
    def scored(*arguments: str) -> dict[str, Any]:
        out = tmp_path / "out.json"
        cli("evaluate", *dataset.set_arguments, *arguments, "--output", out)
        return load(out)

    usual, middle = scored(), scored("--lines", "middle")
    assert (usual["field"], usual["field_lines"]) == ("soccer", "measured")
    assert scored("--lines", "measured") == usual
    assert (middle["field"], middle["field_lines"]) == ("soccer, lines at their middle", "middle")
    error = "mean_reprojection_error"
    assert usual["summary"]["5"][error] < 0.01 < middle["summary"]["5"][error]
    folder = folder_of_dataset(dataset.annotations)
    database = WorkspaceDatabase.open(folder, "one")
    store_field(database, folder, with_lines(load_field("soccer"), "middle"))
    assert database.close()
    assert scored() == middle  # as the dataset keeps it
    assert scored("--lines", "measured") == usual
    done = cli("evaluate", *dataset.set_arguments, "--lines", "edge", code=2)
    assert "'edge' is not one of measured, middle" in done.stderr


def test_tables_name_protocol_and_size(cli, dataset):
    done = cli("evaluate", *dataset.set_arguments, "--protocol", "procc", "--size", "1280x720")
    titles = [line for line in done.stdout.splitlines() if "(procc, 1280x720)" in line]
    assert len(titles) == 3
    assert "Summary" in titles[0]
    assert "Worst 5 frames" in titles[1]
    assert "Classes" in titles[2]


def test_worst_frame_comes_first(cli, dataset):
    dataset.write_camera("3", camera_file(pan=1.0))
    done = cli("evaluate", *dataset.set_arguments)
    worst = done.stdout.split("Worst 5 frames")[1].split("Classes")[0]
    rows = [line.split()[1] for line in worst.splitlines() if line.startswith("│")]
    assert rows[0] == "3"


def test_missing_camera_lowers_completeness_only(cli, dataset, tmp_path):
    (dataset.cameras / "camera_3.json").unlink()
    out = tmp_path / "out.json"
    cli("evaluate", *dataset.set_arguments, "-o", out)
    summary = load(out)["summary"]["5"]
    assert summary["completeness"] == pytest.approx(0.8)
    assert summary["mean_jac"] == 1
    assert summary["final_score"] == pytest.approx(0.8)
    without = images(out)["3"]
    assert (without["camera"], without["error"], without["model"]) == (None, None, None)
    assert without["results"] == {}


def test_camera_without_annotation_is_reported_and_not_counted(cli, dataset, tmp_path):
    (dataset.annotations / "3.json").unlink()
    out = tmp_path / "out.json"
    done = cli("evaluate", *dataset.set_arguments, "-o", out)
    assert "without annotation, not counted: 1 camera (3)" in done.stderr
    assert load(out)["summary"]["5"]["completeness"] == 1
    assert "3" not in images(out)


def test_unreadable_camera_counts_as_none_and_is_listed(cli, dataset, tmp_path):
    path = dataset.write_camera("3", '{"pan_degrees": 1.0')
    out = tmp_path / "out.json"
    done = cli("evaluate", *dataset.set_arguments, "-o", out, code=1)
    (line,) = [line for line in done.stderr.splitlines() if line.startswith("unreadable: ")]
    assert str(path) in line
    bad = images(out)["3"]
    assert bad["camera"] is None
    assert str(path) in bad["error"]
    assert load(out)["summary"]["5"]["completeness"] == pytest.approx(0.8)


def test_a_picture_that_is_called_like_a_camera_is_named(cli, dataset):
    shutil.copy(dataset.root / "1.jpg", dataset.root / "camera_7.jpg")
    shutil.copy(dataset.annotations / "1.json", dataset.annotations / "camera_7.json")
    done = cli("evaluate", *dataset.set_arguments)
    assert "note: camera_7.jpg has a name that files of cameras have" in done.stderr


def test_unreadable_annotation_is_listed_and_left_out(cli, dataset, tmp_path):
    path = dataset.annotations / "2.json"
    path.write_text('{"Middle line": [{"x": 0.5}]}')
    out = tmp_path / "out.json"
    done = cli("evaluate", *dataset.set_arguments, "-o", out, code=1)
    assert len(done.stderr.splitlines()) == 1
    assert str(path) in done.stderr
    assert load(out)["summary"]["5"]["completeness"] == 1
    assert images(out)["2"]["results"] == {}


def test_csv_has_one_row_an_image_and_threshold(cli, dataset, tmp_path):
    (dataset.cameras / "camera_11.json").unlink()
    out = tmp_path / "out.csv"
    cli("evaluate", *dataset.set_arguments, *THRESHOLDS, "-o", out)
    rows = rows_in(out)
    assert [(r["name"], r["threshold"]) for r in rows[:3]] == [("1", "5"), ("1", "2.5"), ("2", "5")]
    assert len(rows) == 10
    assert {(r["protocol"], r["width"], r["height"]) for r in rows} == {("soccernet", "960", "540")}
    assert float(rows[0]["jac"]) == 1
    assert rows[-1]["jac"] == ""
    assert rows[-1]["error"] == "no camera"


def test_homographies_say_how_goals_count(cli, dataset, tmp_path):
    folder = tmp_path / "homographies"
    folder.mkdir()
    # Image px (1280x720) -> yards of a pitch seen from straight above.
    (folder / "3.homographyMatrix").write_text("0.08 0 6.3\n0 0.08 8.2\n0 0 1\n")
    out = tmp_path / "out.json"
    for choice, words in (("missed", "counted as missed"), ("left_out", "left out")):
        done = cli("evaluate", dataset.annotations, folder, "--off-plane", choice, "-o", out)
        assert f"off-plane elements {words}" in done.stdout
        assert "1280x720" in done.stderr
        assert load(out)["off_plane"] == choice


def test_all_annotations_unreadable_leaves_the_old_scores(cli, dataset, tmp_path):
    out = tmp_path / "out.json"
    out.write_text("old")
    for path in dataset.annotations.iterdir():
        path.write_text("{")
    cli("evaluate", *dataset.set_arguments, "-o", out, code=2)
    assert out.read_text() == "old"
    assert [p.name for p in tmp_path.iterdir() if p.name.startswith(".")] == []


def test_progress_shows_on_a_terminal_only(dataset):
    command = [sys.executable, "-m", "procc_annotator", "evaluate", *dataset.set_arguments]
    piped = subprocess.run(command, check=True, capture_output=True, text=True)
    assert piped.stderr == ""
    leader, follower = pty.openpty()
    environment = {**os.environ, "TERM": "xterm", "COLUMNS": "100"}
    subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=follower, env=environment)
    os.close(follower)
    shown = os.read(leader, 100_000).decode()
    os.close(leader)
    assert "scoring" in shown


def test_figures_are_never_cut(cli, dataset, monkeypatch):
    monkeypatch.setenv("COLUMNS", "200")
    wide = cli("evaluate", *dataset.set_arguments).stdout
    figures = sorted(re.findall(r"\d+\.\d+", wide))
    assert figures
    for columns in ("60", "20"):
        monkeypatch.setenv("COLUMNS", columns)
        narrow = cli("evaluate", *dataset.set_arguments).stdout
        assert sorted(re.findall(r"\d+\.\d+", narrow)) == figures


@pytest.mark.parametrize("full_at", ["output", "both"])
def test_a_full_disk_takes_neither_the_figures_nor_the_other_output(
    cli, dataset, tmp_path, monkeypatch, full_at
):
    output, table = tmp_path / "o.json", tmp_path / "t.csv"
    output.write_text("before")
    calls: list[int] = []

    def full(descriptor: int) -> None:
        calls.append(descriptor)
        if len(calls) == 1 or full_at == "both":
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    done = cli("evaluate", *dataset.set_arguments, "-o", table, "-o", output, code=2)
    assert "Summary of 5 frames" in done.stdout
    assert f"{output}: could not be saved: No space left on device" in done.stderr
    assert output.read_text() == "before"
    assert table.exists() == (full_at == "output")
    assert len(done.stderr.splitlines()) == (1 if full_at == "output" else 2)
    assert not list(tmp_path.glob(".*"))


def test_a_missing_file_of_tags_is_no_matter_of_permissions(cli, dataset, tmp_path):
    done = cli("evaluate", *dataset.set_arguments, "--tags", tmp_path / "nope.csv", code=2)
    assert "nope.csv: cannot be read: No such file or directory (check its name)" in done.stderr


def test_cameras_of_another_size_are_doubted_until_it_is_named(cli, dataset, tmp_path):
    doubted = cli("evaluate", *dataset.set_arguments, "--size", "1920x1080")
    assert "principal point far from the middle of 1920x1080" in doubted.stderr
    for other in ("800x600", "640x480", "960x720"):
        doubted = cli("evaluate", *dataset.set_arguments, "--size", other)
        assert f"of {other}: if the camera belongs to another picture" in doubted.stderr
    named = cli(
        "evaluate", *dataset.set_arguments, "--size", "1920x1080", "--camera-size", "960x540",
        "-o", tmp_path / "o.json",
    )  # fmt: skip
    assert "principal point" not in named.stderr
    assert "scaled from 960x540 to 1920x1080" in named.stderr
    assert load(tmp_path / "o.json")["summary"]["5"]["mean_jac"] == 1.0


def test_allowed_mirrored_labels_are_written_down(cli, dataset, tmp_path):
    arguments = ["evaluate", *dataset.set_arguments, "--protocol", "procc", "--mirrored"]
    cli(*arguments, "-o", tmp_path / "o.json")
    cli(*arguments, "-o", tmp_path / "o.csv")
    assert load(tmp_path / "o.json")["mirrored_labels"] is True
    rows = rows_in(tmp_path / "o.csv")
    assert {(r["protocol"], r["options"]) for r in rows} == {("procc", "mirrored labels allowed")}


def test_several_splits_are_named_to_choose_from(cli, dataset, tmp_path):
    for split in ("train", "valid"):
        shutil.copytree(dataset.annotations, tmp_path / "sets" / split)
    done = cli("evaluate", tmp_path / "sets", dataset.cameras, code=2)
    assert "it holds 2 folders (train, valid), choose one" in done.stderr


def test_a_dataset_folder_stands_for_its_annotations(cli, dataset, tmp_path):
    files = [tmp_path / "whole.json", tmp_path / "inner.json"]
    for place, out in zip((dataset.root, dataset.annotations), files, strict=True):
        cli("evaluate", place, dataset.cameras, "--output", out)
    whole, inner = (json.loads(file.read_text()) for file in files)
    assert whole["images"] == inner["images"]
    assert len(whole["images"]) == 5


@pytest.mark.usefixtures("no_charts")
def test_the_worst_frames_are_told_as_they_are_scored_on_a_tie(cli, dataset, tmp_path):
    """The official evaluation takes labels mirrored on a tie, and so do table, files and report;
    the errors in front are those of the labels as they are."""
    for name, pan in dataset.pans.items():
        dataset.write_camera(name, camera_file(pan + 2.0))
    out = tmp_path / "out.json"
    done = cli("evaluate", *dataset.set_arguments, "-t", 1, "--output", out)
    results = [image["results"]["1"] for image in load(out)["images"]]
    assert {result["tp"] for result in results} == {0}
    assert {result["mirrored"] for result in results} == {True}
    assert all(result["mean_error"] < result["mean_reprojection_error"] for result in results)
    rows = [
        [cell.strip() for cell in line.split("│")[1:-1]]
        for line in done.stdout.split("Worst 5 frames")[1].split("Classes")[0].splitlines()
        if line.startswith("│")
    ]
    told = {row[0]: (*map(int, row[2:5]), float(row[5]), row[8]) for row in rows}
    assert told == {
        image["name"]: (
            *(image["results"]["1"][key] for key in ("tp", "fp", "fn")),
            round(image["results"]["1"]["mean_error"], 2),
            "mirrored",
        )
        for image in load(out)["images"]
    }
    report = tmp_path / "report.html"
    cli("report", dataset.annotations, "-t", 1, "--cameras", dataset.cameras, "-o", report)
    page = report.read_text()
    assert "explained with the labels as they are, the score takes them mirrored" in page
    frames = page.split("Labels mirrored@1</th>")[1].split("</tr>")[1]
    counts = re.findall(r'"number">(\d+)<', frames)
    assert counts == ["5", "5", "0", "5", "0"]  # annotated, with a camera, without, mirrored
    assert re.search("frames [^ ]+ 5 at 1 px", page)


STRAY = {"match": "BRA-GER", "frames": 5, "teams": ["BRA", "GER"], "score": {"BRA": 1, "GER": 7}}


@pytest.mark.parametrize("packed", [False, pytest.param(True, marks=pytest.mark.soak)])
@pytest.mark.usefixtures("no_charts")
def test_other_json_among_annotations_is_named_and_not_counted(cli, dataset, tmp_path, packed):
    (dataset.annotations / "per_match_info.json").write_text(json.dumps(STRAY))
    (dataset.annotations / "12.json").write_text("{}")  # a frame without annotations stays one
    place = dataset.annotations
    if packed:
        place = Path(shutil.make_archive(str(tmp_path / "set"), "zip", dataset.annotations))
    out = tmp_path / "out.json"
    done = cli("evaluate", place, dataset.cameras, "-o", out)
    assert "note: per_match_info.json holds no list of points" in done.stderr
    images = load(out)["images"]
    assert [image["name"] for image in images] == ["1", "2", "3", "10", "11", "12"]
    for command in (
        ["calibrate", place, tmp_path / "fitted"],
        ["check", place],
        ["report", place, "--cameras", dataset.cameras, "-o", tmp_path / "report.html"],
        ["convert", place, tmp_path / "v3.json", "--to", "soccernet-v3", "--size", "960x540"],
    ):
        done = cli(*command)
        assert "per_match_info.json holds no list of points" in done.stderr, command
    assert not list((tmp_path / "fitted").glob("*per_match*"))


def test_damaged_annotations_are_never_taken_for_other_files(cli, dataset, tmp_path):
    damaged = {
        "cut": '{"Circle left": [{"x": 0.1',
        "null": '{"Circle left": null}',
        "bare": '{"Circle left": {"x": 0.5, "y": 0.5}}',
        "text": '{"Circle left": [{"x": "0.5", "y": 0.5}]}',
    }
    for name, text in damaged.items():
        (dataset.annotations / f"{name}.json").write_text(text)
    done = cli("evaluate", *dataset.set_arguments, code=1)
    unreadable = [line for line in done.stderr.splitlines() if line.startswith("unreadable: ")]
    assert len(unreadable) == len(damaged)
    assert "no list of points" not in done.stderr


def test_every_output_that_is_asked_for_is_written(cli, dataset, tmp_path):
    commands = {
        "agree": [dataset.annotations, dataset.annotations],
        "evaluate": dataset.set_arguments,
        "compare": [f"a={dataset.cameras}", f"b={dataset.cameras}"],
        "check": [dataset.annotations],
    }
    for command, arguments in commands.items():
        written = [tmp_path / f"{command}.json", tmp_path / f"{command}.csv"]
        done = cli(command, *arguments, "-o", written[0], "-o", written[1])
        assert load(written[0])
        assert written[1].read_text().startswith(("name,", "frame,"))
        assert all(f"written: {path}" in done.stdout.replace("\n", "") for path in written)


@pytest.mark.parametrize("forms", [("NFC", "NFD", "NFC"), ("NFD", "NFC", "NFC")])
def test_names_are_paired_however_their_letters_are_composed(cli, dataset, tmp_path, forms):
    annotation, camera, picture = (unicodedata.normalize(form, "Málaga") for form in forms)
    (dataset.annotations / "1.json").rename(dataset.annotations / f"{annotation}.json")
    (dataset.cameras / "camera_1.json").rename(dataset.cameras / f"camera_{camera}.json")
    (dataset.root / "1.jpg").rename(dataset.root / f"{picture}.jpg")
    out = tmp_path / "out.json"
    done = cli("evaluate", *dataset.set_arguments, "-o", out)
    assert "not counted" not in done.stderr
    scores = load(out)
    assert scores["summary"]["5"]["mean_jac"] == scores["summary"]["5"]["completeness"] == 1.0
    assert annotation in {image["name"] for image in scores["images"]}
    compared = cli("compare", f"a={dataset.cameras}", f"b={dataset.cameras}", dataset.annotations)
    assert "note: " not in compared.stderr
    exported = cli("export", dataset.root, tmp_path / "out", "--cameras", dataset.cameras)
    assert "5 annotations written" in exported.stdout
    assert "over 5 frames" in exported.stdout
    assert (dataset.annotations / f"{annotation}.json").exists()
