"""Sources of cameras as they are named on a command line."""

import json
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.api.loading import load_cameras
from procc_annotator.cli.echo import condense_problems
from procc_annotator.cli.method_arguments import SourceSpec, parse_source, parse_sources
from procc_annotator.errors import CameraError, UsageError
from tests.cli.conftest import camera_file


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("nbjw=out/nbjw", ("nbjw", "auto", "out/nbjw")),
        ("nbjw:carwc=out/nbjw", ("nbjw", "carwc", "out/nbjw")),
        ("our method=out=2/x", ("our method", "auto", "out=2/x")),
        ("out/nbjw/", ("nbjw", "auto", "out/nbjw")),
        ("out/nbjw.zip", ("nbjw", "auto", "out/nbjw.zip")),
        ("out/lr=3/cameras", ("cameras", "auto", "out/lr=3/cameras")),
        ("C:\\runs\\lr=3", None),
        ("D:\\runs", None),
        ("a=C:\\runs", ("a", "auto", "C:\\runs")),
        ("a:wc14=C:\\runs", ("a", "wc14", "C:\\runs")),
        ("{set}/pnl", ("pnl", "auto", "{set}/pnl")),
        ("pnl/{set}", ("pnl", "auto", "pnl/{set}")),
    ],
)
def test_forms(text, expected):
    spec = parse_source(text)
    if expected is None:  # a Windows path: all of it is the path, whatever holds the name
        assert str(spec.path) == text
        assert spec.format == "auto"
    else:
        assert (spec.name, spec.format, str(spec.path)) == expected


@pytest.mark.parametrize("text", ["", "  ", "=x", "a=", "a:=x", ":carwc=x", " =x", "a\x1bb=x"])
def test_what_is_no_source(text):
    with pytest.raises(UsageError):
        parse_source(text)


def test_a_folder_is_called_like_itself_wherever_one_stands(tmp_path, monkeypatch):
    folder = tmp_path / "v1.2"
    folder.mkdir()
    monkeypatch.chdir(folder)
    assert parse_source(".").name == "v1.2"
    assert parse_source(str(folder)).name == "v1.2"


def test_an_existing_path_with_an_equals_sign_is_a_path(tmp_path, monkeypatch):
    (tmp_path / "lr=3").mkdir()
    monkeypatch.chdir(tmp_path)
    assert parse_source("lr=3") == SourceSpec("lr=3", "auto", Path("lr=3"))


def test_the_default_format_is_for_sources_without_their_own():
    a, b = parse_sources(["a=x", "b:wc14=y"], "carwc")
    assert (a.format, b.format) == ("carwc", "wc14")


def test_two_of_one_name_are_refused():
    with pytest.raises(UsageError, match=r"'cameras'.*NAME=PATH"):
        parse_sources(["one/cameras", "two/cameras"])


def test_a_pattern_takes_the_name_of_the_set():
    spec = parse_source("pnl:wc14=data/{set}/pnl/{set}.zip").for_set("ts")
    assert spec == SourceSpec("pnl", "wc14", Path("data/ts/pnl/ts.zip"))


@pytest.mark.usefixtures("no_charts")
def test_a_cut_record_of_many_cameras_is_named_by_every_command(cli, dataset, tmp_path):
    records = [
        {"image_ids": f"{name}.jpg", **camera_file(pan)} for name, pan in dataset.pans.items()
    ]
    cut = "\n".join(map(json.dumps, records))[:-40]
    cameras = tmp_path / "per_sample_output.json"
    cameras.write_text(cut)
    for command in (
        ["evaluate", dataset.annotations, cameras],
        ["compare", cameras, f"ours={dataset.cameras}"],
        ["convert", cameras, tmp_path / "written", "--to", "opencv"],
        ["export", dataset.root, tmp_path / "out", "--cameras", cameras],
        ["render", dataset.root, tmp_path / "drawn", "--cameras", cameras],
        ["report", dataset.root, "--cameras", cameras, "-o", tmp_path / "report.html"],
    ):
        done = cli(*command)
        assert "passed over: " in done.stderr, command
        assert f"line {len(records)}" in done.stderr, command
    damaged = []
    assert len(load_cameras(cameras, on_damaged=damaged.append)) == len(records) - len(damaged)
    with pytest.raises(CameraError, match=f"line {len(records)}"):
        load_cameras(cameras)


def test_one_file_of_cameras_that_cannot_be_read_says_why(cli, dataset, tmp_path):
    cameras = tmp_path / "cameras.mat"
    cameras.write_bytes(b"MATLAB 5.0 MAT-file" + bytes(200))
    done = cli("evaluate", dataset.annotations, cameras, code=2)
    assert "cameras.mat: " in done.stderr
    assert "has the name of an annotation" not in done.stderr


# What is said of many files with one problem, and of cameras of another sport.


def test_the_same_problem_of_many_files_is_one_line():
    same = [f"/a/{i}.npy: expected 3 x 3 numbers (write it again)" for i in range(186)]
    other = ["/a/x.npy: is empty"]
    lines = ["/a/0.npy and 185 more: expected 3 x 3 numbers (write it again)", *other]
    assert condense_problems([*same, *other]) == lines


def test_the_same_problem_of_many_places_is_one_line():
    same = [f"/a.mat: annotation({i}): is of another sport" for i in range(1, 9)]
    assert condense_problems(same) == ["/a.mat: annotation(1) and 7 more: is of another sport"]


def test_frames_of_a_video_with_the_same_problem_are_counted_and_named_in_one_line():
    some = [f"/a.mp4: frame {n}: damaged" for n in (20, 21, 22, 40)]
    other = ["/a.mp4: frame 7: its size changes", "/b.mp4: frame 1: damaged"]
    assert condense_problems([*some, *other]) == [
        "/a.mp4: 4 frames (20 to 22, 40): damaged",
        *other,
    ]


def test_different_problems_and_few_of_them_stay_as_they_are():
    few = [f"/a/{i}.npy: is empty" for i in range(5)]
    different = [f"/a.json: holds {i} numbers (expected: 9)" for i in range(9)]
    assert condense_problems([*few, *different]) == [*few, *different]


@pytest.mark.parametrize("command", ["export", "render", "compare", "report", "evaluate"])
def test_a_bare_homography_is_not_taken_for_one_of_another_sport(cli, dataset, tmp_path, command):
    bare = tmp_path / "bare"
    bare.mkdir()
    for frame in ("1", "2", "3", "10", "11"):
        np.save(bare / f"{frame}.npy", np.diag([0.1, 0.1, 1.0]))
    root, out = dataset.root, tmp_path / "out"
    arguments = {
        "export": (root, out, "--cameras", bare),
        "render": (root, out, "--cameras", bare),
        "compare": (bare, dataset.cameras, root),
        "report": (root, "--cameras", f"bare={bare}", "-o", tmp_path / "report.json"),
        "evaluate": (dataset.annotations, bare),
    }
    done = cli(command, *arguments[command], "--field", "futsal", code=None)
    assert done.exit_code in (1, 2)
    assert "nothing says which ground it is of" in done.stderr
    assert "this is Futsal" in done.stderr
    assert "choose its camera format" in done.stderr


def test_a_damaged_file_of_many_cameras_is_told_by_itself(cli, dataset, tmp_path):
    for name, content in (
        ("cut.mat", b"MATLAB 5.0 MAT-file" + bytes(99)),
        ("cut.json", b'{"1": {'),
    ):
        (tmp_path / name).write_bytes(content)
        done = cli("evaluate", dataset.annotations, tmp_path / name, code=2)
        assert done.stderr.startswith(f"procc-annotator: {tmp_path / name}: ")
        assert len(done.stderr.splitlines()) == 1
