"""``evaluate`` over several sets, methods and sizes; groups of frames; the table that grows."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy

from tests.cli.conftest import rows_in

KEYS = [
    "protocol", "field", "field_name", "field_dimensions", "field_lines", "size", "thresholds",
    "images",
    "summary",
]  # fmt: skip


def load(path: Path) -> dict[str, Any]:
    return json.loads(path.read_text())


@pytest.fixture
def sets(dataset, tmp_path, monkeypatch) -> Path:
    """Two sets, two methods each: ``good`` sees everything, ``poor`` misses a frame a set."""
    for name in ("day", "night"):
        shutil.copytree(dataset.annotations, tmp_path / name / "annotations")
        for method in ("good", "poor"):
            shutil.copytree(dataset.cameras, tmp_path / name / method)
        (tmp_path / name / "poor" / "camera_3.json").unlink()
    (tmp_path / "night/annotations/11.json").unlink()
    monkeypatch.chdir(tmp_path)
    return tmp_path


SEVERAL = (
    "--set", "day=day/annotations", "--set", "night=night/annotations",
    "--cameras", "A={set}/good", "--cameras", "B:soccernet={set}/poor",
)  # fmt: skip


def test_every_method_is_scored_on_every_set_at_every_size(cli, sets):
    done = cli(
        "evaluate", *SEVERAL, "--size", "960x540", "--size", "480x270", "-t", "5", "-t", "2",
        "-o", "out.json",
    )  # fmt: skip
    found = load(sets / "out.json")
    assert list(found) == ["evaluations"]
    assert all(list(e) == ["set", "method", *KEYS] for e in found["evaluations"])
    names = [(e["set"], e["method"], e["size"][0]) for e in found["evaluations"]]
    assert names == [
        (s, m, w) for s in ("day", "night") for m in ("A", "B") for w in (960, 480)
    ]  # fmt: skip
    assert [len(e["images"]) for e in found["evaluations"]] == [5, 5, 5, 5, 4, 4, 4, 4]
    completeness = [e["summary"]["5"]["completeness"] for e in found["evaluations"]]
    assert completeness == [1, 1, 0.8, 0.8, 1, 1, 0.75, 0.75]
    # The cameras belong to the first size, and fit the annotations at the second.
    assert [e["summary"]["2"]["mean_jac"] for e in found["evaluations"]] == [1] * 8
    assert done.stderr.count("scaled from 960x540 to 480x270") == 4
    rows = [line.split() for line in done.stdout.splitlines() if line.startswith("│")]
    assert [(r[1], r[3]) for r in rows] == [(s, m) for s, m, _ in names]
    assert sum("480x270" in row for row in rows) == 4


def test_homographies_belong_to_their_own_size_at_every_size(cli, sets, sample_data):
    """They know it, as no SoccerNet camera does."""
    cameras = f"H={sample_data / 'cameras' / 'homography'}"
    for sizes in (("960x540", "1280x720"), ("1280x720", "960x540")):
        asked = [part for size in sizes for part in ("--size", size)]
        cli("evaluate", sample_data, "--cameras", cameras, *asked, "-o", "h.json")
        for one in load(sets / "h.json")["evaluations"]:
            assert one["summary"]["5"]["mean_error"] < 3, one["size"]


def test_each_part_of_several_is_what_it_is_alone(cli, sets):
    cli("evaluate", *SEVERAL, "-o", "all.json")
    cli("evaluate", *SEVERAL, "-o", "all.csv")
    for i, (name, method) in enumerate((s, m) for s in ("day", "night") for m in ("good", "poor")):
        arguments = ("evaluate", f"{name}/annotations", f"{name}/{method}")
        cli(*arguments, "-o", "one.json")
        cli(*arguments, "-o", "one.csv")
        part = load(sets / "all.json")["evaluations"][i]
        alone = load(sets / "one.json")
        assert list(alone) == KEYS
        assert {k: part[k] for k in KEYS} == alone
        label = {"good": "A", "poor": "B"}[method]
        rows = [r for r in rows_in(sets / "all.csv") if (r["set"], r["method"]) == (name, label)]
        assert [list(r)[:2] for r in rows] == [["set", "method"]] * len(rows)
        own = rows_in(sets / "one.csv")
        assert [r["jac"] for r in rows] == [r["jac"] for r in own]
        assert "set" not in own[0]


def test_one_named_method_says_its_name(cli, sets):
    done = cli("evaluate", "day/annotations", "--cameras", "A=day/good", "-o", "out.json")
    assert "Summary of 5 frames, 5 with a camera" in done.stdout
    (only,) = load(sets / "out.json")["evaluations"]
    assert (only["set"], only["method"]) == ("day", "A")


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ([], "annotations are needed"),
        (["day/annotations"], "cameras are needed"),
        (["--set", "a=day/annotations"], "cameras are needed"),
        (["day/annotations", "--cameras", "day/good", "--cameras", "night/good"], "called 'good'"),
        (["--set", "a=x", "--set", "a=y", "--cameras", "z"], "two sets are called 'a'"),
        (["--set", "day/annotations", "--cameras", "z"], "expected NAME=ANNOTATIONS"),
        (["--set", "noon=day/annotations", "--cameras", "a={set}/good"], "noon/good"),
        (["day/annotations", "--cameras", "a:fbx=day/good"], "fbx"),
    ],
)
def test_what_is_missing_or_twice_is_one_line(cli, sets, arguments, says):
    done = cli("evaluate", *arguments, code=2)
    assert says in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_planar_only_takes_goals_out_for_every_camera(cli, sets):
    plain, planar = sets / "plain.json", sets / "planar.json"
    cli("evaluate", "day/annotations", "day/good", "-o", plain)
    done = cli("evaluate", "day/annotations", "day/good", "--planar-only", "-o", planar)
    assert "planar elements only" in done.stdout
    goals = {"Goal left crossbar", "Goal right crossbar"}
    assert goals & load(plain)["summary"]["5"]["per_class"].keys()
    assert not goals & load(planar)["summary"]["5"]["per_class"].keys()
    assert load(planar)["planar_only"] is True


def test_groups_by_tag_and_model(cli, sets):
    (sets / "tags.csv").write_text("frame,light\n1,day\n2,day\n3,dusk\n10,\n00012,day\n")
    done = cli(
        "evaluate", "day/annotations", "day/poor", "--tags", "tags.csv", "--by", "light",
        "--by", "model", "-o", "out.json",
    )  # fmt: skip
    assert "note: tags.csv: 1 row of no annotated frame (00012)" in done.stderr
    found = load(sets / "out.json")
    assert list(found) == [*KEYS, "groups"]
    assert found["images"][0]["groups"] == {"light": "day", "model": "pinhole P"}
    assert found["images"][2]["groups"] == {"light": "dusk", "model": None}
    groups = [(g["by"], g["value"], g["images"], g["evaluated"]) for g in found["groups"]]
    assert groups == [
        ("light", "day", 2, 2), ("light", "dusk", 1, 0), ("light", None, 2, 2),
        ("model", "pinhole P", 4, 4), ("model", None, 1, 0),
    ]  # fmt: skip
    assert found["groups"][0]["summary"]["5"]["mean_jac"] == 1
    shown = done.stdout.split("By light")[1]
    rows = [line.split()[1] for line in shown.splitlines() if line.startswith("│")]
    assert rows == ["day", "dusk", "–", "pinhole", "–"]
    cli("evaluate", "day/annotations", "day/poor", "--tags", "tags.csv", "-o", "out.csv")
    assert [r["by_light"] for r in rows_in(sets / "out.csv")] == ["day", "day", "dusk", "", ""]


def test_tags_that_belong_to_no_frame_are_refused(cli, sets):
    (sets / "tags.csv").write_text("frame,light\n00001,day\n")
    done = cli("evaluate", "day/annotations", "day/good", "--tags", "tags.csv", code=2)
    assert "'00001'" in done.stderr
    assert "'1'" in done.stderr


def test_unreadable_annotations_are_listed_once_for_all_methods(cli, sets):
    (sets / "day/annotations/1.json").write_text("{")
    done = cli("evaluate", *SEVERAL, code=1)
    assert sum(line.startswith("unreadable: ") for line in done.stderr.splitlines()) == 1


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with SIGPIPE")
def test_a_reader_that_has_seen_enough_is_no_error(sets):
    """As ``| head`` does: the pipe is closed before anything is written."""
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "wb") as pipe:
        done = subprocess.run(
            [sys.executable, "-m", "procc_annotator", "evaluate", *SEVERAL, "-o", "b.csv"],
            stdout=pipe, stderr=subprocess.PIPE, check=False, text=True,
        )  # fmt: skip
    assert (done.returncode, done.stderr) == (141, "")
    assert len(rows_in(sets / "b.csv")) == 18


# How much of a frame is annotated stands beside its figures, and sets are broken down by it.

FEW = ("--resamples", 200, "--seed", 1, "--workers", 1)


def keep(annotations: Path, frame: str, names: int) -> None:
    path = annotations / f"{frame}.json"
    content = json.loads(path.read_text())
    path.write_text(json.dumps(dict(list(content.items())[:names])))


def test_every_frame_has_number_and_spread_of_its_elements(cli, dataset, tmp_path):
    keep(dataset.annotations, "1", 1)
    (dataset.annotations / "2.json").write_text("{}")
    (dataset.cameras / "camera_3.json").unlink()
    outputs = ("-o", tmp_path / "s.csv", "-o", tmp_path / "s.json")
    cli("evaluate", *dataset.set_arguments, *outputs)
    by_csv = {r["name"]: r for r in rows_in(tmp_path / "s.csv")}
    by_json = {i["name"]: i for i in json.loads((tmp_path / "s.json").read_text())["images"]}
    assert len(by_csv) == 5
    for name, row in by_csv.items():
        content = json.loads((dataset.annotations / f"{name}.json").read_text())
        image = by_json[name]
        assert int(row["annotated_elements"]) == image["annotated_elements"] == len(content)
        points = np.array([[p["x"], p["y"]] for line in content.values() for p in line])
        if not len(points):
            assert row["spread"] == ""
            assert image["spread"] is None
            continue
        hull = 0.0 if len(content) == 1 else scipy.spatial.ConvexHull(points.clip(0, 1)).volume
        assert float(row["spread"]) == pytest.approx(hull, abs=1e-5)
        assert image["spread"] == pytest.approx(hull, abs=1e-5)
    models = {name: row["model"] for name, row in by_csv.items()}
    assert models == {n: "" if n == "3" else "pinhole P" for n in dataset.pans}
    assert by_json["3"]["model"] is None


@pytest.mark.parametrize("by", ["spread", "elements", "model"])
def test_a_report_is_broken_down_by_it(cli, dataset, tmp_path, by):
    keep(dataset.annotations, "1", 3)
    out = tmp_path / "r.json"
    given = ("--cameras", f"a={dataset.cameras}")
    cli("report", dataset.root, *given, "--by", by, "-o", out, *FEW)
    rows = json.loads(out.read_text())["chance"][0][f"by_{by}"]["rows"]
    assert sum(row["frames"] for row in rows) == 5
    if by == "model":
        assert [row["value"] for row in rows] == ["pinhole P"]
    else:
        words = {"spread": "% of the picture", "elements": "elements"}[by]
        assert len(rows) > 1
        assert all(words in row["value"] for row in rows)


def test_frames_of_few_elements_are_a_part_of_their_own(cli, dataset, tmp_path):
    for frame in ("1", "2"):
        keep(dataset.annotations, frame, 2)
    out = tmp_path / "s.json"
    cli("evaluate", *dataset.set_arguments, "--by", "elements", "-o", out, *FEW)
    rows = json.loads(out.read_text())["chance"][0]["by_elements"]["rows"]
    assert {row["value"]: row["frames"] for row in rows}["2 to 2 elements"] == 2
