"""Sources of cameras as they are named on a command line."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from procc_annotator.cli.method_arguments import SourceSpec, parse_source, parse_sources
from procc_annotator.errors import UsageError
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
def test_forms(text, expected) -> None:
    spec = parse_source(text)
    if expected is None:  # a Windows path: all of it is the path, whatever holds the name
        assert str(spec.path) == text
        assert spec.format == "auto"
    else:
        assert (spec.name, spec.format, str(spec.path)) == expected


@pytest.mark.parametrize("text", ["", "  ", "=x", "a=", "a:=x", ":carwc=x", " =x", "a\x1bb=x"])
def test_what_is_no_source(text) -> None:
    with pytest.raises(UsageError):
        parse_source(text)


def test_a_folder_is_called_like_itself_wherever_one_stands(tmp_path, monkeypatch) -> None:
    folder = tmp_path / "v1.2"
    folder.mkdir()
    monkeypatch.chdir(folder)
    assert parse_source(".").name == "v1.2"
    assert parse_source(str(folder)).name == "v1.2"


def test_an_existing_path_with_an_equals_sign_is_a_path(tmp_path, monkeypatch) -> None:
    (tmp_path / "lr=3").mkdir()
    monkeypatch.chdir(tmp_path)
    assert parse_source("lr=3") == SourceSpec("lr=3", "auto", Path("lr=3"))


def test_the_default_format_is_for_sources_without_their_own() -> None:
    a, b = parse_sources(["a=x", "b:wc14=y"], "carwc")
    assert (a.format, b.format) == ("carwc", "wc14")


def test_two_of_one_name_are_refused() -> None:
    with pytest.raises(UsageError, match=r"'cameras'.*NAME=PATH"):
        parse_sources(["one/cameras", "two/cameras"])


def test_a_pattern_takes_the_name_of_the_set() -> None:
    spec = parse_source("pnl:wc14=data/{set}/pnl/{set}.zip").for_set("ts")
    assert spec == SourceSpec("pnl", "wc14", Path("data/ts/pnl/ts.zip"))


@pytest.mark.usefixtures("no_charts")
def test_a_cut_record_of_many_cameras_is_named_by_every_command(cli, dataset, tmp_path) -> None:
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
        assert done.exit_code == 0, (command, done.output)
        assert "passed over: " in done.stderr, command
        assert f"line {len(records)}" in done.stderr, command


def test_one_file_of_cameras_that_cannot_be_read_says_why(cli, dataset, tmp_path) -> None:
    cameras = tmp_path / "cameras.mat"
    cameras.write_bytes(b"MATLAB 5.0 MAT-file" + bytes(200))
    done = cli("evaluate", dataset.annotations, cameras)
    assert done.exit_code == 2
    assert "cameras.mat: " in done.stderr
    assert "has the name of an annotation" not in done.stderr
