"""``procc-annotator export``: what leaves is what was annotated, and scores the same elsewhere."""

import json
import zipfile
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.cameras.fit_record import annotation_digest
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.export import Scoring, export_scores
from tests.cli.conftest import rows_in


def test_folder_of_soccernet_json_with_scores(cli, dataset, tmp_path):
    out = tmp_path / "out"
    done = cli("export", dataset.root, out, "--cameras", dataset.cameras, "-t", 5, "-t", 2)
    assert "5 annotations written" in done.stdout
    assert "JaC@5 100.00 over 5 frames (soccernet, 960x540)" in done.stdout
    assert sorted(p.name for p in out.iterdir()) == [
        "1.json", "10.json", "11.json", "2.json", "3.json", "jac.csv", "jac.json",
    ]  # fmt: skip
    for path in dataset.annotations.iterdir():
        assert json.loads((out / path.name).read_text()) == json.loads(path.read_text())
    scores = json.loads((out / "jac.json").read_text())
    assert scores["summary"]["2"]["mean_jac"] == 1
    assert len(rows_in(out / "jac.csv")) == 10


def test_exported_set_scores_as_exported(cli, dataset, tmp_path):
    out, again = tmp_path / "out.zip", tmp_path / "again.json"
    cli("export", dataset.root, out, "--cameras", dataset.cameras)
    cli("evaluate", out, dataset.cameras, "-o", again)
    with zipfile.ZipFile(out) as archive:
        exported = json.loads(archive.read("jac.json"))
    assert json.loads(again.read_text())["summary"] == exported["summary"]


def test_same_dataset_same_archive(cli, dataset, tmp_path):
    for name in ("a.zip", "b.zip"):
        cli("export", dataset.root, tmp_path / name)
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()


def test_without_cameras_the_score_files_say_so(cli, dataset, tmp_path):
    out = tmp_path / "out"
    done = cli("export", dataset.root, out)
    assert "hold no scores" in done.stdout
    scores = json.loads((out / "jac.json").read_text())
    assert scores["summary"] is None
    assert {image["error"] for image in scores["images"]} == {
        "no cameras were given: nothing to score against"
    }
    assert "no cameras were given" in (out / "jac.csv").read_text()


def test_frames_never_annotated_get_no_file(cli, dataset, tmp_path):
    (dataset.annotations / "2.json").unlink()
    done = cli("export", dataset.root, tmp_path / "out")
    assert "4 annotations written" in done.stdout
    assert "(1 frame has none)" in done.stdout
    assert not (tmp_path / "out" / "2.json").exists()


def test_unreadable_files_are_listed_and_the_rest_goes_on(cli, dataset, tmp_path):
    (dataset.annotations / "2.json").write_text("{")
    dataset.write_camera("3", "[]")
    done = cli("export", dataset.root, tmp_path / "out", "--cameras", dataset.cameras, code=1)
    assert len(done.stderr.splitlines()) == 2
    assert "4 annotations written" in done.stdout
    assert (tmp_path / "out" / "3.json").exists()


def test_an_export_never_hides_the_dataset_it_comes_from(cli, dataset):
    """The folder annotations/ would be read instead of the files beside the pictures."""
    for file in dataset.annotations.iterdir():
        file.rename(dataset.root / file.name)
    dataset.annotations.rmdir()
    done = cli("export", dataset.root, dataset.root / "annotations", code=2)
    assert "this is the dataset itself" in done.stderr


@pytest.mark.parametrize("name", ["out", "out.zip"])
def test_what_is_there_is_replaced_only_on_request(cli, dataset, tmp_path, name):
    out = tmp_path / name
    if out.suffix:
        kept = out
    else:
        out.mkdir()
        kept = out / "2.json"  # of another set
    kept.write_text("somebody's")
    refused = cli("export", dataset.root, out, code=2)
    assert "--overwrite to replace" in refused.stderr
    assert kept.read_text() == "somebody's"
    cli("export", dataset.root, out, "--overwrite")
    assert kept.read_bytes() != b"somebody's"
    cli("export", dataset.root, out, code=2)  # its own files are no exception


def test_frames_are_told_as_evaluate_tells_them(cli, dataset, tmp_path):
    """What a camera is, whether it was fitted to these very clicks, and how much was clicked."""
    camera = json.loads((dataset.cameras / "camera_1.json").read_text())
    path = dataset.annotations / "1.json"
    digest = annotation_digest(
        read_annotation(path.read_bytes(), path=str(path), field=load_field("soccer"))
    )
    dataset.write_camera("1", {**camera, "fit": {"annotation_sha256": digest}})
    cli("export", dataset.root, tmp_path / "out", "--cameras", dataset.cameras)
    cli("evaluate", dataset.annotations, dataset.cameras, "-o", tmp_path / "own.csv")
    told, expected = (
        {row["name"]: row for row in rows_in(path)}
        for path in (tmp_path / "out" / "jac.csv", tmp_path / "own.csv")
    )
    assert expected["1"]["fitted_on_these_clicks"] == "true"
    assert expected["2"]["fitted_on_these_clicks"] == "false"
    for name, row in expected.items():
        for column in ("model", "fitted_on_these_clicks", "annotated_elements", "spread"):
            assert told[name][column] == row[column]


def test_cameras_of_another_field_are_not_scored(tmp_path, sample_data):
    field = load_field("basketball_nba")
    np.save(tmp_path / "00001.npy", np.eye(3))
    path = sample_data / "basketball" / "00001.json"

    class Frames:
        names = ("00001",)
        folders = ()
        field = load_field("basketball_nba")

        def read(self, index: int) -> FrameAnnotation:
            return read_annotation(path.read_bytes(), path=str(path), field=field)

    scoring = Scoring(EvaluationSetup(field), (5.0,), CameraSet.open(tmp_path))
    done = export_scores(Frames(), tmp_path / "jac.json", scoring)
    assert done.scored == 0
    assert done.summary[5.0].evaluated == 0
    assert "would be taken for a soccer field's" in done.problems[0]


def test_annotations_that_stay_in_the_folder_are_told(cli, dataset, tmp_path):
    out = tmp_path / "out"
    cli("export", dataset.root, out)
    (dataset.annotations / "2.json").unlink()
    done = cli("export", dataset.root, out, "--overwrite")
    assert "holds 1 other annotation, not written now and not touched: 2" in done.stderr
    assert (out / "2.json").exists()


# ``export --split``: what the official evaluation takes as it is; and sets without pictures.

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


def test_an_archive_holds_nothing_but_frames_and_scores_lie_beside_it(cli, dataset, tmp_path):
    out = tmp_path / "gt.zip"
    done = cli("export", dataset.root, out, "--split", "test", "--cameras", dataset.cameras)
    assert sorted(read_as_official(out)) == ["1", "10", "11", "2", "3"]
    assert f"scores in {tmp_path / 'gt_jac.csv'} and {tmp_path / 'gt_jac.json'}" in done.stdout
    assert {row["name"] for row in rows_in(tmp_path / "gt_jac.csv")} == {"1", "2", "3", "10", "11"}
    assert json.loads((tmp_path / "gt_jac.json").read_text())["summary"]["5"]["mean_jac"] == 1


def test_a_folder_holds_the_split_and_scores_above_it(cli, dataset, tmp_path):
    out = tmp_path / "set"
    cli("export", dataset.root, out, "--split", "valid")
    assert [p.name for p in out.iterdir()] == ["valid"]  # no cameras: no scores
    cli(
        "export", dataset.root, out, "--split", "valid", "--cameras", dataset.cameras, "--overwrite"
    )
    assert sorted(p.name for p in out.iterdir()) == ["jac.csv", "jac.json", "valid"]
    names = sorted(p.name for p in (out / "valid").iterdir())
    assert names == ["1.json", "10.json", "11.json", "2.json", "3.json"]


def test_a_folder_is_made_for_scores_too(cli, dataset, tmp_path):
    out = tmp_path / "new" / "set"
    cli("export", dataset.root, out, "--split", "valid", "--cameras", dataset.cameras)
    assert sorted(p.name for p in out.iterdir()) == ["jac.csv", "jac.json", "valid"]


def test_what_the_evaluation_stops_at_is_left_out_told_and_not_scored(cli, dataset, tmp_path):
    path = dataset.annotations / "2.json"
    content = json.loads(path.read_text())
    content |= {"Dugout": [{"x": 0.5, "y": 0.5}], "author": "me", "Penalty mark left": []}
    content["Line unknown"] = [{"x": 0.1, "y": 0.1}, {"x": 0.2, "y": 0.1}]
    path.write_text(json.dumps(content))
    out = tmp_path / "gt.zip"
    done = cli("export", dataset.root, out, "--split", "test", "--cameras", dataset.cameras)
    assert "Dugout is left out: the official evaluation stops at it (1 frame)" in done.stderr
    assert "the entry author is left out" in done.stderr
    written = read_as_official(out)["2"]
    assert "Line unknown" in written
    assert written == {k: content[k] for k in written}
    scores = json.loads((tmp_path / "gt_jac.json").read_text())
    again = tmp_path / "again.json"
    cli("evaluate", out, dataset.cameras, "-o", again)
    assert json.loads(again.read_text())["summary"] == scores["summary"]


def test_what_makes_no_sense_is_refused_before_anything_is_written(
    cli, dataset, sample_data, tmp_path
):
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
        done = cli("export", *arguments, code=2)
        assert said in done.stderr
        assert len(done.stderr.splitlines()) == 1
    assert not (tmp_path / "x.zip").exists()
    assert [p.name for p in (out / "test").iterdir()] == ["other.json"]


def test_a_tree_is_exported_folder_by_folder(cli, dataset, tmp_path):
    for game in ("a", "b"):
        (tmp_path / "tree" / game).mkdir(parents=True)
        for file in dataset.annotations.iterdir():
            (tmp_path / "tree" / game / file.name).write_bytes(file.read_bytes())
    done = cli("export", tmp_path / "tree", tmp_path / "gt.zip", "--split", "test", code=2)
    assert "export the folders one by one, e.g. a" in done.stderr
    done = cli("export", tmp_path / "tree", tmp_path / "all.zip")
    with zipfile.ZipFile(tmp_path / "all.zip") as archive:
        assert {"a/1.json", "b/11.json"} <= set(archive.namelist())


@pytest.mark.parametrize("kind", ["folder", "archive", "labelme"])
def test_annotations_without_pictures_are_exported(cli, dataset, tmp_path, kind):
    source = dataset.annotations
    if kind == "archive":
        source = tmp_path / "annotations.zip"
        with zipfile.ZipFile(source, "w") as archive:
            for file in dataset.annotations.iterdir():
                archive.write(file, file.name)
    if kind == "labelme":
        source = tmp_path / "labelme"
        done = cli("convert", dataset.annotations, source, "--to", "labelme", "--size", "960x540")
    out = tmp_path / "gt.zip"
    done = cli("export", source, out, "--split", "test", "--cameras", dataset.cameras)
    assert "JaC@5 100.00 over 5 frames" in done.stdout
    frames = read_as_official(out)
    for file in dataset.annotations.iterdir():
        assert frames[file.stem].keys() == json.loads(file.read_text()).keys()
    before = {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()}
    cli("export", source, source, "--overwrite", code=2)
    assert {p: p.read_bytes() for p in tmp_path.rglob("*") if p.is_file()} == before


@pytest.mark.parametrize("method", ["nbjw", "pnlcalib"])
def test_an_exported_split_scores_as_the_official_evaluation_did(
    cli, shared_data, tmp_path, method
):
    wc14, out = shared_data / "wc14", tmp_path / "gt.zip"
    cli(
        "export", wc14 / "annotations", out, "--split", "test", "-t", "10",
        "--cameras", wc14 / f"cameras_{method}",
    )  # fmt: skip
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
