"""``export --split``: what the official evaluation takes as it is; and sets without pictures."""

from __future__ import annotations

import csv
import json
import zipfile
from pathlib import Path

import pytest

# The names that the official code mirrors labels by; it stops at any other.
OFFICIAL = {
    *(f"{size} rect. {end} {side}" for size in ("Big", "Small") for end in ("left", "right")
      for side in ("main", "top", "bottom")),
    *(f"Side line {side}" for side in ("left", "right", "top", "bottom")),
    *(f"Circle {where}" for where in ("left", "right", "central")),
    "Goal left crossbar", "Goal left post left ", "Goal left post right", "Goal right crossbar",
    "Goal right post left", "Goal right post right", "Goal unknown", "Line unknown", "Middle line",
}  # fmt: skip


def read_as_official(path: Path) -> dict[str, dict[str, list[dict[str, float]]]]:
    """Frames of an archive as the official evaluation goes over them: every entry is one, its name
    has one slash, and every value is a list of points of a class it knows."""
    frames = {}
    with zipfile.ZipFile(path) as archive:
        for entry in archive.namelist():
            split, name = entry.split("/")
            assert split == "test"
            content = json.loads(archive.read(entry).decode("utf-8"))
            assert content.keys() <= OFFICIAL
            for points in content.values():
                assert all({"x", "y"} <= point.keys() for point in points)
            frames[name.removesuffix(".json")] = content
    return frames


def test_an_archive_holds_nothing_but_frames_and_scores_lie_beside_it(
    cli, dataset, tmp_path
) -> None:
    out = tmp_path / "gt.zip"
    done = cli("export", dataset.root, out, "--split", "test", "--cameras", dataset.cameras)
    assert done.exit_code == 0, done.output
    assert sorted(read_as_official(out)) == ["1", "10", "11", "2", "3"]
    assert f"scores in {tmp_path / 'gt_jac.csv'} and {tmp_path / 'gt_jac.json'}" in done.stdout
    with (tmp_path / "gt_jac.csv").open(newline="") as stream:
        assert {row["name"] for row in csv.DictReader(stream)} == {"1", "2", "3", "10", "11"}
    assert json.loads((tmp_path / "gt_jac.json").read_text())["summary"]["5"]["mean_jac"] == 1


def test_a_folder_holds_the_split_and_scores_above_it(cli, dataset, tmp_path) -> None:
    out = tmp_path / "set"
    assert cli("export", dataset.root, out, "--split", "valid").exit_code == 0
    assert [p.name for p in out.iterdir()] == ["valid"]  # no cameras: no scores
    done = cli(
        "export", dataset.root, out, "--split", "valid", "--cameras", dataset.cameras, "--overwrite"
    )
    assert done.exit_code == 0, done.output
    assert sorted(p.name for p in out.iterdir()) == ["jac.csv", "jac.json", "valid"]
    names = sorted(p.name for p in (out / "valid").iterdir())
    assert names == ["1.json", "10.json", "11.json", "2.json", "3.json"]


def test_a_folder_is_made_for_scores_too(cli, dataset, tmp_path) -> None:
    out = tmp_path / "new" / "set"
    done = cli("export", dataset.root, out, "--split", "valid", "--cameras", dataset.cameras)
    assert done.exit_code == 0, done.output
    assert sorted(p.name for p in out.iterdir()) == ["jac.csv", "jac.json", "valid"]


def test_what_the_evaluation_stops_at_is_left_out_told_and_not_scored(
    cli, dataset, tmp_path
) -> None:
    path = dataset.annotations / "2.json"
    content = json.loads(path.read_text())
    content |= {"Dugout": [{"x": 0.5, "y": 0.5}], "author": "me", "Penalty mark left": []}
    content["Line unknown"] = [{"x": 0.1, "y": 0.1}, {"x": 0.2, "y": 0.1}]
    path.write_text(json.dumps(content))
    out = tmp_path / "gt.zip"
    done = cli("export", dataset.root, out, "--split", "test", "--cameras", dataset.cameras)
    assert done.exit_code == 0, done.output
    assert "Dugout is left out: the official evaluation stops at it (1 frame)" in done.stderr
    assert "the entry author is left out" in done.stderr
    written = read_as_official(out)["2"]
    assert "Line unknown" in written
    assert written == {k: content[k] for k in written}
    scores = json.loads((tmp_path / "gt_jac.json").read_text())
    again = tmp_path / "again.json"
    assert cli("evaluate", out, dataset.cameras, "-o", again).exit_code == 0
    assert json.loads(again.read_text())["summary"] == scores["summary"]


def test_what_makes_no_sense_is_refused_before_anything_is_written(
    cli, dataset, sample_data, tmp_path
) -> None:
    out = tmp_path / "set"
    (out / "test").mkdir(parents=True)
    (out / "test" / "other.json").write_text("{}")
    for arguments, said in (
        ((dataset.root, out, "--split", "test", "--overwrite"), "holds other.json"),
        ((dataset.root, tmp_path / "x.zip", "--split", "a/b"), "is not the name of a folder"),
        ((dataset.root, tmp_path / "x.zip", "--split", "test", "--keep-optional"), "--split"),
        ((sample_data / "basketball", tmp_path / "x.zip", "--split", "test"), "Basketball"),
        ((dataset.root, dataset.root, "--split", "annotations", "--overwrite"), "dataset itself"),
    ):
        done = cli("export", *arguments)
        assert done.exit_code == 2
        assert said in done.stderr
        assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "x.zip").exists()
    assert [p.name for p in (out / "test").iterdir()] == ["other.json"]


def test_a_tree_is_exported_folder_by_folder(cli, dataset, tmp_path) -> None:
    for game in ("a", "b"):
        (tmp_path / "tree" / game).mkdir(parents=True)
        for file in dataset.annotations.iterdir():
            (tmp_path / "tree" / game / file.name).write_bytes(file.read_bytes())
    done = cli("export", tmp_path / "tree", tmp_path / "gt.zip", "--split", "test")
    assert done.exit_code == 2
    assert "export the folders one by one, e.g. a" in done.stderr
    done = cli("export", tmp_path / "tree", tmp_path / "all.zip")
    assert done.exit_code == 0, done.output
    with zipfile.ZipFile(tmp_path / "all.zip") as archive:
        assert {"a/1.json", "b/11.json"} <= set(archive.namelist())


@pytest.mark.parametrize("kind", ["folder", "archive", "labelme"])
def test_annotations_without_pictures_are_exported(cli, dataset, tmp_path, kind) -> None:
    source = dataset.annotations
    if kind == "archive":
        source = tmp_path / "annotations.zip"
        with zipfile.ZipFile(source, "w") as archive:
            for file in dataset.annotations.iterdir():
                archive.write(file, file.name)
    if kind == "labelme":
        source = tmp_path / "labelme"
        done = cli("convert", dataset.annotations, source, "--to", "labelme", "--size", "960x540")
        assert done.exit_code == 0, done.output
    out = tmp_path / "gt.zip"
    done = cli("export", source, out, "--split", "test", "--cameras", dataset.cameras)
    assert done.exit_code == 0, done.output
    assert "JaC@5 100.00 over 5 frames" in done.stdout
    frames = read_as_official(out)
    for file in dataset.annotations.iterdir():
        assert frames[file.stem].keys() == json.loads(file.read_text()).keys()
    before = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()}
    assert cli("export", source, source, "--overwrite").exit_code == 2
    assert {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()} == before


@pytest.mark.parametrize("method", ["nbjw", "pnlcalib"])
def test_an_exported_split_scores_as_the_official_evaluation_did(
    cli, shared_data, tmp_path, method
) -> None:
    wc14, out = shared_data / "wc14", tmp_path / "gt.zip"
    done = cli(
        "export", wc14 / "annotations", out, "--split", "test", "-t", "10",
        "--cameras", wc14 / f"cameras_{method}",
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    assert len(read_as_official(out)) == 186
    expected = json.loads((wc14 / f"expected_{method}.json").read_text())["images"]
    scores = json.loads((tmp_path / "gt_jac.json").read_text())["images"]
    assert len(scores) == len(expected) == 186
    for image in scores:
        official = expected[image["name"]]
        if official is None:
            assert image["results"] == {}
            continue
        counts = {key: image["results"]["10"][key] for key in ("tp", "fp", "fn")}
        assert counts == {key: official["10"][key] for key in ("tp", "fp", "fn")}
