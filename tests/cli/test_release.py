"""``procc-annotator release`` as the keeper of a dataset runs it."""

import hashlib
import json
import shutil
import zipfile
from pathlib import Path

import pytest

from procc_annotator.batch.label_check import CheckRun
from procc_annotator.cli.set_fits import fit_sizes
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.review import SETTING
from procc_annotator.field.load import load_field
from procc_annotator.formats.file_source import open_source
from procc_annotator.report.label_check import check_set
from tests.cli.conftest import rows_in


@pytest.fixture
def keep(sample_copy) -> Path:
    """The sample, as somebody keeps it."""
    return sample_copy


def made(cli, *arguments: object) -> str:
    done = cli("release", *arguments, "--date", "2026-05-01")
    return done.output


def index_of(folder: Path) -> dict[str, dict[str, str]]:
    return {row["frame"]: row for row in rows_in(folder / "index.csv")}


def sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


def test_annotations_and_hashes_without_pictures(cli, keep, tmp_path):
    out = tmp_path / "release"
    said = made(cli, keep, out, "--version", "1.0", "--licence", "CC-BY-4.0", "--no-check")
    assert "all: 11 frames" in said
    assert not (out / "images").exists()
    annotated = sorted(path.name for path in keep.glob("0*.json"))
    assert sorted(path.name for path in (out / "annotations").iterdir()) == annotated
    for name in annotated:
        assert (out / "annotations" / name).read_bytes() == (keep / name).read_bytes()
    assert (out / "splits" / "all.txt").read_text().split() == [n[:-5] for n in annotated]
    row = index_of(out)["00002"]
    assert row["annotation_sha256"] == sha256(keep / "00002.json")
    assert row["picture_sha256"] == sha256(keep / "00002.jpg")
    assert (row["picture"], row["width"], row["height"]) == ("00002.jpg", "1280", "720")
    assert "The first release." in (out / "CHANGELOG.md").read_text()
    assert not any(path.name.startswith(".procc") for path in out.rglob("*"))


def test_the_card_has_the_header_that_hubs_read(cli, keep, tmp_path):
    out = tmp_path / "release"
    made(
        cli, keep, out, "--name", "Cup: 'one'", "--licence", "CC-BY-4.0", "--creator", "A | B",
        "--description", "Drawn <frames>.", "--no-check",
    )  # fmt: skip
    card = (out / "README.md").read_text()
    begin, header, _ = card.split("---\n", 2)
    assert begin == ""
    assert "license: cc-by-4.0\n" in header
    assert "pretty_name: \"Cup: 'one'\"\n" in header
    assert "- n<1K\n" in header
    assert "| by | A \\| B |" in card
    assert "Drawn &lt;frames>." in card
    assert "| Side line top | 9 |" in card
    assert "No quality checks were run" in card


def test_croissant_names_every_column_by_what_is_there(cli, keep, tmp_path):
    out = tmp_path / "release"
    made(cli, keep, out, "--pictures", "--version", "2.1", "--no-check", "--url", "https://x.org")
    found = json.loads((out / "croissant.json").read_text())
    assert found["@type"] == "sc:Dataset"
    assert found["version"] == "2.1.0"
    assert found["conformsTo"] == "http://mlcommons.org/croissant/1.0"
    index, annotations, pictures = found["distribution"]
    assert index["sha256"] == sha256(out / "index.csv")
    assert index["contentSize"] == f"{(out / 'index.csv').stat().st_size} B"
    assert annotations["includes"] == "annotations/*.json"
    assert pictures["includes"] == "images/*.jpg"
    header = (out / "index.csv").read_text().splitlines()[0].split(",")
    columns = [f["source"]["extract"]["column"] for f in found["recordSet"][0]["field"]]
    assert columns == header
    assert (out / "images" / "00002.jpg").read_bytes() == (keep / "00002.jpg").read_bytes()


def test_names_as_nobody_expects_them(cli, keep, tmp_path):
    out = tmp_path / "release"
    (keep / "00002.jpg").rename(keep / "00002.JPG")
    terms = ("--name", "<b>Cup}</b>", "--creator", "A {B")
    made(cli, keep, out, "--pictures", "--no-check", *terms)
    found = json.loads((out / "croissant.json").read_text())
    kinds = {one["includes"]: one["encodingFormat"] for one in found["distribution"][1:]}
    assert kinds["images/*.JPG"] == kinds["images/*.jpg"] == "image/jpeg"
    cited = found["citeAs"]
    assert cited.count("{") == cited.count("}") == 5
    assert "\n# &lt;b>Cup}&lt;/b>\n" in (out / "README.md").read_text()


def test_splits_findings_and_a_second_annotator(cli, keep, tmp_path):
    splits = tmp_path / "splits.csv"
    splits.write_text("frame,split\n00001,train\n00002,train\n00003,test\n")
    second = tmp_path / "second"
    second.mkdir()
    for name in ("00001", "00002"):
        content = json.loads((keep / f"{name}.json").read_text())
        moved = {k: [{"x": p["x"] + 0.001, "y": p["y"]} for p in v] for k, v in content.items()}
        (second / f"{name}.json").write_text(json.dumps(moved))
    out = tmp_path / "release.zip"
    done = cli("release", keep, out, "--splits", splits, "--second-annotator", second, code=1)
    assert "left out: 00004 and 7 more: is in no split" in done.output
    assert "train: 2 frames" in done.output
    with zipfile.ZipFile(out) as archive:
        names = set(archive.namelist())
        assert {"findings.csv", "agreement.json", "splits/train.txt", "splits/test.txt"} <= names
        card = archive.read("README.md").decode()
        assert archive.read("splits/train.txt") == b"00001\n00002\n"
    assert "Noise floor: median" in card
    assert "Label check, still open:" in card


def test_nothing_is_told_of_frames_that_are_in_no_split(cli, keep, tmp_path):
    splits, second = tmp_path / "splits.csv", tmp_path / "second"
    splits.write_text("frame,split\n00001,train\n")
    second.mkdir()
    for name in ("00001", "00002"):
        shutil.copy(keep / f"{name}.json", second)
    content = json.loads((keep / "00003.json").read_text())
    (keep / "00003.json").write_text(json.dumps(content | {"No such line": [{"x": 0, "y": 0}] * 2}))
    WorkspaceDatabase.open(keep, "ann").close()
    out = tmp_path / "release"
    cli("release", keep, out, "--splits", splits, "--second-annotator", second, code=1)
    assert {row["frame"] for row in rows_in(out / "findings.csv")} <= {"00001"}
    agreed = json.loads((out / "agreement.json").read_text())
    assert [image["name"] for image in agreed["images"]] == ["00001"]
    assert "00003" not in json.dumps(agreed)
    assert list(json.loads((out / "provenance.json").read_text())["frames"]) == ["00001"]


def test_what_was_taken_out_is_not_published_again(cli, keep, tmp_path):
    out = tmp_path / "release"
    made(cli, keep, out, "--pictures")
    (out / "notes.txt").write_text("ours")
    (keep / "00001.json").unlink()
    made(cli, keep, out, "--pictures", "--no-check", "--overwrite")
    assert not (out / "annotations" / "00001.json").exists()
    assert not (out / "images" / "00001.jpg").exists()
    assert (out / "images" / "00002.jpg").exists()
    assert not (out / "findings.csv").exists()
    assert (out / "notes.txt").read_text() == "ours"
    made(cli, keep, out, "--no-check", "--overwrite")
    assert not (out / "images" / "00002.jpg").exists()


@pytest.mark.parametrize(
    ("rows", "says"),
    [
        ("train,00001\ntest\n", "line 3: has 1 cell, expected 2"),
        ("train,00001\ntest,00001\n", "line 3: frame '00001' again"),
    ],
)
def test_a_table_of_splits_that_cannot_be_used(cli, keep, tmp_path, rows, says):
    splits = tmp_path / "splits.csv"
    splits.write_text(f"split,frame\n{rows}")
    done = cli("release", keep, tmp_path / "out", "--splits", splits, "--no-check", code=2)
    assert says in done.stderr


@pytest.mark.parametrize("option", [("--date", "yesterday"), ("--version", " ")])
def test_terms_that_are_none(cli, keep, tmp_path, option):
    done = cli("release", keep, tmp_path / "out", *option, "--no-check", code=2)
    assert option[0] in done.stderr
    assert not (tmp_path / "out").exists()


def test_a_release_of_a_tree_goes_before_another(cli, keep, tmp_path):
    tree, splits = tmp_path / "tree", tmp_path / "splits.csv"
    for game in ("g1", "g2"):
        (tree / game).mkdir(parents=True)
        shutil.copy(keep / "00001.json", tree / game)
    splits.write_text("frame,split\ng1/00001,train\ng2/00001,test\ng3/00001,test\n")
    first = tmp_path / "first"
    done = cli("release", tree, first, "--splits", splits, "--no-check")
    assert "in a split, but not annotated: 1 frame (g3/00001)" in done.stderr
    said = made(cli, tree, tmp_path / "then", "--previous", first, "--no-check")
    assert "0 added, 0 removed, 0 changed" in said


def test_what_is_known_of_points_goes_along(cli, keep, tmp_path):
    database = WorkspaceDatabase.open(keep, "Ann")
    database.set_setting("anything", "yes")
    assert database.close()
    out = tmp_path / "release"
    made(cli, keep, out, "--no-check")
    provenance = json.loads((out / "provenance.json").read_text())
    assert set(provenance["frames"]) == set(index_of(out))
    assert "points came to be: from a file 100 %" in (out / "README.md").read_text()


def test_findings_that_were_ignored_are_not_open(cli, keep, tmp_path):
    for path in sorted(keep.glob("0*.json"))[4:]:
        path.unlink()
    content = json.loads((keep / "00002.json").read_text())
    content["Side line botom"] = content.pop(next(iter(content)))
    (keep / "00002.json").write_text(json.dumps(content))
    field = load_field("soccer")
    with open_source(keep) as source:
        run = CheckRun(source, field, fit_sizes(source, keep, keep, None), "R")
        report = check_set(run, lambda items, total, what: items)
    keys = [told.key for told in report.found if told.frame == "00002"]
    made(cli, keep, tmp_path / "before")
    before = [row["frame"] for row in rows_in(tmp_path / "before" / "findings.csv")]
    assert before.count("00002") == len(keys) > 0
    database = WorkspaceDatabase.open(keep, "Ann")
    for key in keys:
        database.set_setting(f"{SETTING}{key} 00002", "yes")
    assert database.close()
    made(cli, keep, tmp_path / "after")
    after = [row["frame"] for row in rows_in(tmp_path / "after" / "findings.csv")]
    assert "00002" not in after
    assert len(after) == len(before) - len(keys)


def test_changes_against_the_release_before(cli, keep, tmp_path):
    first, then = tmp_path / "first", tmp_path / "then"
    made(cli, keep, first, "--version", "1.0", "--no-check")
    (keep / "00001.json").unlink()
    content = json.loads((keep / "00002.json").read_text())
    kept, gone, *_ = content
    content[kept][0]["x"] += 4 / 959
    content["Circle central left"] = content.pop(gone)
    (keep / "00002.json").write_text(json.dumps(content))
    shutil.copy(keep / "00003.json", keep / "00005.json")
    said = made(cli, keep, then, "--version", "1.1", "--previous", first, "--no-check")
    assert "since version 1.0: 1 added, 1 removed, 1 changed" in said
    text = (then / "CHANGELOG.md").read_text()
    assert "1 frame added: 00005" in text
    assert "1 frame removed: 00001" in text
    assert "+Circle central left" in text
    assert f"-{gone}" in text
    assert f"{kept} (up to 4.0 px)" in text
    assert text.index("## 1.1") < text.index("## 1.0")
    same = made(cli, keep, tmp_path / "same", "--version", "1.2", "--previous", then, "--no-check")
    assert "0 added, 0 removed, 0 changed" in same


def test_another_picture_is_a_change(cli, keep, tmp_path):
    made(cli, keep, tmp_path / "first", "--version", "1.0", "--no-check")
    shutil.copy(keep / "00003.jpg", keep / "00002.jpg")
    before = ("--previous", tmp_path / "first")
    said = made(cli, keep, tmp_path / "then", "--version", "1.1", *before, "--no-check")
    assert "0 changed, 1 with another picture" in said
    text = (tmp_path / "then" / "CHANGELOG.md").read_text()
    assert "1 frame with another picture: 00002" in text


def test_the_same_release_is_the_same_bytes(cli, keep, tmp_path):
    for name in ("a.zip", "b.zip"):
        made(cli, keep, tmp_path / name, "--no-check")
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()


def test_where_it_may_not_be_written(cli, keep, tmp_path):
    out = tmp_path / "release"
    made(cli, keep, out, "--no-check")
    again = cli("release", keep, out, "--no-check", code=2)
    assert "holds a release already" in again.output
    made(cli, keep, out, "--no-check", "--overwrite")


def test_a_release_before_that_is_none(cli, keep, tmp_path):
    before = tmp_path / "before"
    before.mkdir()
    (before / "release.json").write_text('{"format": "else"}')
    done = cli("release", keep, tmp_path / "out", "--previous", before, "--no-check", code=2)
    assert "is no release" in done.output
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("flat", [True, False])
def test_an_archive_of_a_release_is_read_as_what_it_was_made_of(cli, keep, tmp_path, flat):
    place = keep if flat else tmp_path / "season"
    cameras = keep / "cameras/pinhole" if flat else tmp_path / "cameras"
    for match in () if flat else ("a", "b"):
        (place / match).mkdir(parents=True)
        shutil.copy(keep / "00001.json", place / match)
        shutil.copytree(keep / "cameras/pinhole", cameras / match)
    out, before, after = tmp_path / "r.zip", tmp_path / "before.csv", tmp_path / "after.csv"
    made(cli, place, out, "--version", "1.0", "--licence", "CC-BY-4.0", "--no-check")
    cli("evaluate", place, cameras, "-o", before)
    cli("evaluate", out, cameras, "-o", after)
    assert after.read_text() == before.read_text()
