"""``procc-annotator agree`` as a user runs it."""

import json
import shutil
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import procc_annotator
from procc_annotator.field.load import load_field
from tests.cli.conftest import rows_in


@pytest.fixture
def other(dataset, tmp_path) -> Path:
    """A second annotator: every click 3 px lower, one element forgotten in frame 3."""
    folder = tmp_path / "other"
    shutil.copytree(dataset.annotations, folder)
    for path in folder.iterdir():
        content = json.loads(path.read_text())
        for points in content.values():
            for point in points:
                point["y"] += 3 / 539
        path.write_text(json.dumps(content))
    edit(folder / "3.json", lambda content: content.pop("Middle line"))
    return folder


def edit(path: Path, change) -> None:
    content = json.loads(path.read_text())
    change(content)
    path.write_text(json.dumps(content))


def load(path: Path) -> dict[str, Any]:
    def no_constants(text: str) -> None:
        raise AssertionError(f"{text} is not JSON")

    return json.loads(path.read_text(), parse_constant=no_constants)


def test_tables_and_the_noise_floor(cli, dataset, other):
    done = cli("agree", dataset.annotations, other, "--tau", "5", "--tau", "1")
    assert done.stderr == ""
    titles = [line.strip() for line in done.stdout.splitlines() if "(soccer, 960x540)" in line]
    assert titles[0].startswith("Agreement of 5 frames both annotated")
    assert titles[1].startswith("Worst 5 frames at 5 px")
    assert titles[2].startswith("Distances between A and B")
    assert titles[3].startswith("Noise floor: median ")
    assert " px, 95 % " in titles[3]
    worst = done.stdout.split("Worst 5 frames")[1].split("Distances")[0]
    assert next(line.split()[1] for line in worst.splitlines() if line.startswith("│")) == "3"
    cells = [line.split("│")[1:-1] for line in done.stdout.splitlines() if "Middle line" in line]
    assert [cell.strip() for cell in cells[-1]][3:7] == ["2", "0", "1", "0"]


def test_json_holds_every_figure(cli, dataset, other, tmp_path):
    out = tmp_path / "out.json"
    cli("agree", dataset.annotations, other, "-t", "5", "-t", "2.5", "-o", out)
    content = load(out)
    field_terms = ["field", "field_name", "field_dimensions", "field_lines"]
    terms = [*field_terms, "size", "thresholds"]
    assert list(content) == [*terms, "a", "b", "images", "summary"]
    assert content["field_name"] == "soccer"
    assert content["field_dimensions"]["length"] == 105
    assert content["size"] == [960, 540]
    assert (content["a"], content["b"]) == (str(dataset.annotations), str(other))
    images = {image["name"]: image for image in content["images"]}
    assert list(images) == ["1", "2", "3", "10", "11"]
    third = images["3"]
    assert third["only_a"] == ["Middle line"]
    assert third["only_b"] == third["errors"] == []
    assert third["jac"]["5"] == len(third["elements"]) / (len(third["elements"]) + 1)
    assert third["jac"]["2.5"] < third["jac"]["5"]
    for element in third["elements"].values():
        assert len(element["distances"]) + element["left_out"] <= 6
        assert element["median"] <= element["p95"] <= element["max"] <= 3.0 + 1e-6
    floor = content["summary"]["noise_floor"]
    everything = [
        d for i in images.values() for e in i["elements"].values() for d in e["distances"]
    ]
    assert floor["points"] == len(everything)
    assert floor["max"] == max(everything)
    assert content["summary"]["per_class"]["Middle line"]["only_a"] == 1


def test_csv_has_a_row_a_frame_and_class(cli, dataset, other, tmp_path):
    (other / "1.json").unlink()
    (other / "2.json").write_text("{")
    (other / "10.json").write_text("{}")
    edit(other / "11.json", lambda c: c.update({"Goal left crossbar": [{"x": 0.1, "y": 0.1}]}))
    out = tmp_path / "out.csv"
    cli("agree", dataset.annotations, other, "-o", out, code=1)
    table = rows_in(out)
    by_frame = {name: [r for r in table if r["name"] == name] for name in ("1", "2", "3", "10")}
    assert [(r["class"], r["status"]) for r in by_frame["1"]] == [("", "frame_only_a")]
    assert [(r["class"], r["status"]) for r in by_frame["2"]] == [("", "unreadable")]
    assert "2.json" in by_frame["2"][0]["error"]
    assert {r["status"] for r in by_frame["10"]} == {"only_a"}
    assert {r["class"]: r["status"] for r in by_frame["3"]}["Middle line"] == "only_a"
    common = [r for r in by_frame["3"] if r["status"] == "common"]
    assert all(float(r["median"]) <= float(r["p95"]) <= float(r["max"]) for r in common)
    assert [r["class"] for r in table if r["status"] == "only_b"] == ["Goal left crossbar"]
    assert {(r["field"], r["width"], r["height"]) for r in table} == {("soccer", "960", "540")}


def test_frames_of_one_annotator_are_noted_and_not_counted(cli, dataset, other):
    (other / "1.json").unlink()
    (dataset.annotations / "2.json").unlink()
    (dataset.annotations / "10.json").unlink()
    done = cli("agree", dataset.annotations, other)
    assert "note: only in A, not compared: 1 frame (1)" in done.stderr
    assert "note: only in B, not compared: 2 frames (2, 10)" in done.stderr
    assert "Agreement of 2 frames both annotated" in done.stdout


def test_mirrored_labels_are_a_hint(cli, dataset, other):
    field = load_field("soccer")
    for name in ("1", "11"):
        content = json.loads((other / f"{name}.json").read_text())
        turned = {field.symmetries[0].name_of(key): points for key, points in content.items()}
        (other / f"{name}.json").write_text(json.dumps(turned))
    done = cli("agree", dataset.annotations, other)
    assert (
        "note: left and right seem to be swapped between A and B, counted as they are:"
        " 2 frames (1, 11)" in done.stderr
    )
    assert done.stdout.count("mirrored?") == 2


def test_where_nothing_can_be_read_no_file_is_written(cli, dataset, other, tmp_path):
    for path in other.iterdir():
        path.write_text("{")
    done = cli("agree", dataset.annotations, other, "-o", tmp_path / "out.csv", code=2)
    assert "of none of the 5 frames both annotations can be read" in done.stderr
    assert not (tmp_path / "out.csv").exists()
    assert not list(tmp_path.glob("*.tmp"))
    assert not list(tmp_path.glob(".*"))


def test_only_the_ten_worst_frames_are_shown_the_worst_first(cli, tmp_path):
    a, b = tmp_path / "a", tmp_path / "b"
    for folder in (a, b):
        folder.mkdir()
        for i in range(15):
            y = 0.5 + (i * 7 % 15) / 539 * (folder == b)
            line = [{"x": 0.2, "y": y}, {"x": 0.8, "y": y}]
            (folder / f"{i}.json").write_text(json.dumps({"Side line top": line}))
    done = cli("agree", a, b, "-t", "20")
    table = done.stdout.split("Worst 10 frames")[1].split("Distances")[0]
    shown = [line.split()[1] for line in table.splitlines() if line.startswith("│")]
    assert [int(name) * 7 % 15 for name in shown] == list(range(14, 4, -1))


# --------------------------------------------------------------------------- several annotators


@pytest.fixture
def third(dataset, tmp_path) -> Path:
    """A third annotator: 1 px lower, without frame 11, and alone with frame 12."""
    folder = tmp_path / "third"
    shutil.copytree(dataset.annotations, folder)
    for path in folder.iterdir():
        content = json.loads(path.read_text())
        for points in content.values():
            for point in points:
                point["y"] += 1 / 539
        path.write_text(json.dumps(content))
    (folder / "11.json").rename(folder / "12.json")
    return folder


def test_three_annotators_in_pairs_and_against_the_others(cli, dataset, other, third, tmp_path):
    out, agreed = tmp_path / "out.json", tmp_path / "agreed"
    three = dataset.annotations, other, third
    done = cli("agree", *three, "-t", "2.5", "--consensus", agreed, "-o", out)
    assert "Each annotator against the consensus of the others" in done.stdout
    assert "Noise floor: median " in done.stdout
    assert "note: only in C, not compared: 1 frame (12)" in done.stderr
    content = load(out)
    summary = content["summary"]
    assert [who["annotator"] for who in content["annotators"]] == ["A", "B", "C"]
    assert content["annotators"][2]["alone"] == ["12"]
    pairs = {(row["a"], row["b"]): row for row in summary["pairs"]["rows"]}
    assert {pair: row["frames"] for pair, row in pairs.items()} == {
        ("A", "B"): 5, ("A", "C"): 4, ("B", "C"): 4,
    }  # fmt: skip
    # B lies 3 px below A and 2 px below C: only what runs up the picture agrees within 2.5 px.
    assert pairs["A", "C"]["jac"] == 1.0
    assert pairs["A", "B"]["jac"] < pairs["B", "C"]["jac"]
    rows = {row["annotator"]: row for row in summary["annotators"]["rows"]}
    assert rows["B"]["missed"] == 1  # of frame 3
    assert rows["C"]["frames"] == 4
    assert rows["B"]["median"] > rows["C"]["median"]
    assert rows["A"]["jac_low"] <= rows["A"]["jac"] <= rows["A"]["jac_high"]
    assert "Of 1 frame with two annotators" in done.stdout
    low, high = summary["noise_floor"]["median_interval"]
    assert low <= summary["noise_floor"]["median"] <= high
    # What all agree on is C's course, in the middle; of frame 11 what A and B do.
    assert sorted(path.stem for path in agreed.iterdir()) == ["1", "10", "11", "2", "3"]
    again = tmp_path / "again.json"
    cli("agree", third, agreed, "-o", again)
    floor = load(again)["summary"]["noise_floor"]
    assert floor["median"] < 0.05
    assert floor["max"] < 0.6  # at ends, where only two run


def test_of_three_every_frame_annotator_and_class_is_a_row(cli, dataset, other, third, tmp_path):
    (other / "2.json").write_text("{")
    out = tmp_path / "out.csv"
    cli("agree", dataset.annotations, other, third, "-o", out, code=1)
    table = rows_in(out)
    missed = [(r["name"], r["annotator"], r["class"]) for r in table if r["status"] == "missed"]
    assert missed == [("3", "B", "Middle line")]
    assert [(r["name"], r["annotator"]) for r in table if r["status"] == "alone"] == [("12", "C")]
    (unreadable,) = [r for r in table if r["status"] == "unreadable"]
    assert "2.json" in unreadable["error"]
    assert {r["annotator"] for r in table if r["name"] == "2"} == {"A", "C", ""}


def test_intervals_of_agreement_are_clustered_by_a_tag(cli, dataset, other, third, tmp_path):
    tags = tmp_path / "tags.csv"
    tags.write_text("frame,match\n1,a\n2,a\n3,b\n10,b\n11,b\n")
    three = dataset.annotations, other, third
    done = cli("agree", *three, "--tags", tags, "--cluster", "match")
    assert "2 clusters by match" in done.stdout
    cli("agree", *three, "--cluster", "match", code=2)
    out = tmp_path / "out.json"
    cli("agree", *three[:2], "--tags", tags, "--cluster", "match", "-o", out)
    floor = load(out)["summary"]["noise_floor"]
    assert floor["median_interval"][0] <= floor["median"] <= floor["median_interval"][1]
    assert "2 clusters by match" in floor["intervals"]


def test_a_consensus_replaces_nothing(cli, dataset, other, third):
    three = dataset.annotations, other, third
    done = cli("agree", *three, "--consensus", other, code=2)
    assert "holds the files to be read" in done.stderr
    cli("agree", dataset.annotations, code=2)
    agreed = other.parent / "agreed"
    cli("agree", *three, "--consensus", agreed)
    again = cli("agree", *three, "--consensus", agreed, code=2)
    assert "--overwrite to replace them" in " ".join(again.stderr.split())
    cli("agree", *three, "--consensus", agreed, "--overwrite")


def test_folders_that_may_be_matches_are_told_and_known_ones_kept_apart(cli, dataset, tmp_path):
    """Whether only folders are of annotators or of matches their names do not say."""
    for who, folder in (("anna", "g1"), ("ben", "g2"), ("ute", "ute"), ("cleo", "g1")):
        shutil.copytree(dataset.annotations, tmp_path / who / folder)
    shutil.copytree(dataset.annotations, tmp_path / "cleo/g2")
    anna, ben, ute, cleo = (tmp_path / who for who in ("anna", "ben", "ute", "cleo"))
    done = cli("agree", anna, ben)
    assert "Agreement of 5 frames" in done.stdout
    assert f"{anna}/g1/ and {ben}/g2/ are taken as the same frames" in done.stderr
    assert cli("agree", anna, ute).stderr == ""
    out = tmp_path / "out.json"
    done = cli("agree", anna, ben, cleo, "-o", out)  # of whom one has both folders
    frames = {image["name"]: set(image["annotators"]) for image in load(out)["images"]}
    assert frames["g1/3"] == {"A", "C"}
    assert frames["g2/3"] == {"B", "C"}
    assert len(frames) == 10
    assert done.stderr == ""


# ``agree --reference`` and ``--power`` as whoever runs an annotation study uses them.

GOLD = ("2", "3", "10", "11")


@pytest.fixture
def study(cli, dataset, tmp_path) -> Path:
    """The dataset with gold frames, and a copy of its pictures for each of two annotators."""
    (dataset.root / "gold.csv").write_text("frame\n" + "\n".join(GOLD) + "\n")
    out = tmp_path / "study"
    for annotator in ("anna", "ben"):
        (out / annotator).mkdir(parents=True)
        for picture in dataset.root.glob("*.jpg"):
            shutil.copy(picture, out / annotator)
    return out


def annotate(dataset, folder: Path, rise: float) -> None:
    """Every frame a little more off than the one before."""
    rng = np.random.default_rng(7)
    for place, picture in enumerate(sorted(folder.glob("*.jpg"), key=lambda p: -int(p.stem))):
        content = json.loads((dataset.annotations / f"{picture.stem}.json").read_text())
        for points in content.values():
            for point in points:
                off = rise * (place + 1) * rng.choice((-1, 1))
                point["x"] += off / 959
                point["y"] += off / 539
        picture.with_suffix(".json").write_text(json.dumps(content))


def test_each_annotator_is_compared_with_the_gold_frames_of_the_reference(
    cli, dataset, study, tmp_path
):
    annotate(dataset, study / "anna", 0.5)
    annotate(dataset, study / "ben", 0.0)
    out, table = tmp_path / "gold.json", tmp_path / "gold.csv"
    asked = ("--reference", dataset.root, "-t", "2", "-t", "5", "-o", out, "-o", table)
    cli("agree", study / "anna", study / "ben", *asked)
    rows = json.loads(out.read_text())["reference"]["rows"]
    errors = {(r["annotator"], r["threshold"]): r for r in rows}
    assert errors["ben", 2.0]["jac"] == 1.0
    assert errors["ben", 2.0]["max"] == pytest.approx(0.0, abs=1e-6)
    assert errors["anna", 2.0]["jac"] < errors["anna", 5.0]["jac"]
    assert errors["anna", 2.0]["jac_low"] <= errors["anna", 2.0]["jac"]
    frames = {row["frame"] for row in rows_in(table) if row["annotator"] == "anna"}
    assert frames == set(GOLD)
    (dataset.root / "gold.csv").unlink()
    cli("agree", study / "anna", "--reference", dataset.root, "-o", out)
    assert json.loads(out.read_text())["reference"]["rows"][0]["frames"] == 5  # all of them


def test_no_export_passes_the_mark_of_gold_on(cli, dataset, study, tmp_path):
    archive, folder = tmp_path / "out.zip", tmp_path / "released"
    cli("export", dataset.root, archive)
    cli("release", dataset.root, folder, "--no-check")
    with zipfile.ZipFile(archive) as packed:
        written = {name: packed.read(name) for name in packed.namelist()}
    written |= {str(p): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    assert len(written) > 10
    assert not [name for name, data in written.items() if "gold" in name or b"gold" in data]


def test_the_window_knows_nothing_of_gold():
    """What it never reads it can neither show nor pass on; the command of a study alone does."""
    package = Path(procc_annotator.__file__).parent
    readers = [
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        if "gold.csv" in path.read_text()
    ]
    assert readers == ["cli/agree.py"]


def test_what_cannot_be_done_is_one_line(cli, dataset, study, tmp_path):
    other, reference = tmp_path / "other.csv", ("--reference", dataset.root)
    other.write_text("frame,x\n1,1\n2,1\n3,1\n10,1\n11,1\n,1\n")
    for arguments, words in (
        ((study / "anna", *reference), "there is no annotation of any of 4 reference frames"),
        ((study / "anna", "--reference", tmp_path / "none"), "none: no such file"),
        ((dataset.annotations, *reference, "--frames", other), "7: names no frame"),
        ((dataset.annotations, *reference, "--power"), "goes without"),
        ((dataset.annotations, study / "anna", "--frames", other), "needs --reference"),
    ):
        done = cli("agree", *arguments, code=2)
        assert words in done.stderr.splitlines()[-1]
    (dataset.root / "gold.csv").write_text("frame\n77\n")
    done = cli("agree", dataset.annotations, *reference, code=2)
    assert "1 frame (77) without an annotation" in done.stderr


def test_frames_needed_grow_with_the_square_of_what_is_wanted(cli, dataset, study):
    annotate(dataset, study / "anna", 0.5)
    done = cli("agree", dataset.annotations, study / "anna", "--power", "-t", "2")
    rows = [
        [cell.strip() for cell in line.split("│")[1:-1]]
        for line in done.stdout.split("Frames needed")[1].splitlines()
        if "JaC, points" in line
    ]
    assert [row[4] for row in rows] == ["1", "2", "5"]
    needed = [int(row[5]) for row in rows]
    assert 3.5 < needed[0] / needed[1] < 4.5
