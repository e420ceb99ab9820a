"""How much of a frame is annotated stands beside its figures, and sets are broken down by it."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import numpy as np
import pytest
import scipy

FEW = ("--resamples", 200, "--seed", 1, "--workers", 1)


def keep(annotations: Path, frame: str, names: int) -> None:
    path = annotations / f"{frame}.json"
    content = json.loads(path.read_text())
    path.write_text(json.dumps(dict(list(content.items())[:names])))


def test_every_frame_has_number_and_spread_of_its_elements(cli, dataset, tmp_path) -> None:
    keep(dataset.annotations, "1", 1)
    (dataset.annotations / "2.json").write_text("{}")
    (dataset.cameras / "camera_3.json").unlink()
    outputs = ("-o", tmp_path / "s.csv", "-o", tmp_path / "s.json")
    assert cli("evaluate", *dataset.set_arguments, *outputs).exit_code == 0
    by_csv = {r["name"]: r for r in csv.DictReader(io.StringIO((tmp_path / "s.csv").read_text()))}
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
def test_a_report_is_broken_down_by_it(cli, dataset, tmp_path, by) -> None:
    keep(dataset.annotations, "1", 3)
    out = tmp_path / "r.json"
    given = ("--cameras", f"a={dataset.cameras}")
    done = cli("report", dataset.root, *given, "--by", by, "-o", out, *FEW)
    assert done.exit_code == 0, done.output
    rows = json.loads(out.read_text())["chance"][0][f"by_{by}"]["rows"]
    assert sum(row["frames"] for row in rows) == 5
    if by == "model":
        assert [row["value"] for row in rows] == ["pinhole P"]
    else:
        words = {"spread": "% of the picture", "elements": "elements"}[by]
        assert len(rows) > 1
        assert all(words in row["value"] for row in rows)


def test_frames_of_few_elements_are_a_part_of_their_own(cli, dataset, tmp_path) -> None:
    for frame in ("1", "2"):
        keep(dataset.annotations, frame, 2)
    out = tmp_path / "s.json"
    done = cli("evaluate", *dataset.set_arguments, "--by", "elements", "-o", out, *FEW)
    assert done.exit_code == 0, done.output
    rows = json.loads(out.read_text())["chance"][0]["by_elements"]["rows"]
    assert {row["value"]: row["frames"] for row in rows}["2 to 2 elements"] == 2
