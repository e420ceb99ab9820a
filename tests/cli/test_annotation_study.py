"""``agree --reference`` and ``--power`` as whoever runs an annotation study uses them."""

from __future__ import annotations

import csv
import json
import shutil
import zipfile
from pathlib import Path

import numpy as np
import pytest

import procc_annotator

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
) -> None:
    annotate(dataset, study / "anna", 0.5)
    annotate(dataset, study / "ben", 0.0)
    out, table = tmp_path / "gold.json", tmp_path / "gold.csv"
    asked = ("--reference", dataset.root, "-t", "2", "-t", "5", "-o", out, "-o", table)
    done = cli("agree", study / "anna", study / "ben", *asked)
    assert done.exit_code == 0, done.output
    rows = json.loads(out.read_text())["reference"]["rows"]
    errors = {(r["annotator"], r["threshold"]): r for r in rows}
    assert errors["ben", 2.0]["jac"] == 1.0
    assert errors["ben", 2.0]["max"] == pytest.approx(0.0, abs=1e-6)
    assert errors["anna", 2.0]["jac"] < errors["anna", 5.0]["jac"]
    assert errors["anna", 2.0]["jac_low"] <= errors["anna", 2.0]["jac"]
    with open(table, newline="") as file:
        frames = {row["frame"] for row in csv.DictReader(file) if row["annotator"] == "anna"}
    assert frames == set(GOLD)
    (dataset.root / "gold.csv").unlink()
    alone = cli("agree", study / "anna", "--reference", dataset.root, "-o", out)
    assert alone.exit_code == 0
    assert json.loads(out.read_text())["reference"]["rows"][0]["frames"] == 5  # all of them


def test_no_export_passes_the_mark_of_gold_on(cli, dataset, study, tmp_path) -> None:
    archive, folder = tmp_path / "out.zip", tmp_path / "released"
    assert cli("export", dataset.root, archive).exit_code == 0
    assert cli("release", dataset.root, folder, "--no-check").exit_code == 0
    with zipfile.ZipFile(archive) as packed:
        written = {name: packed.read(name) for name in packed.namelist()}
    written |= {str(p): p.read_bytes() for p in folder.rglob("*") if p.is_file()}
    assert len(written) > 10
    assert not [name for name, data in written.items() if "gold" in name or b"gold" in data]


def test_the_window_knows_nothing_of_gold() -> None:
    """What it never reads it can neither show nor pass on; the command of a study alone does."""
    package = Path(procc_annotator.__file__).parent
    readers = [
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        if "gold.csv" in path.read_text()
    ]
    assert readers == ["cli/agree.py"]


def test_what_cannot_be_done_is_one_line(cli, dataset, study, tmp_path) -> None:
    other, reference = tmp_path / "other.csv", ("--reference", dataset.root)
    other.write_text("frame,x\n1,1\n2,1\n3,1\n10,1\n11,1\n,1\n")
    for arguments, words in (
        ((study / "anna", *reference), "nobody has annotated any of 4 reference frames"),
        ((study / "anna", "--reference", tmp_path / "none"), "none: no such file"),
        ((dataset.annotations, *reference, "--frames", other), "7: names no frame"),
        ((dataset.annotations, *reference, "--power"), "goes without"),
        ((dataset.annotations, study / "anna", "--frames", other), "needs --reference"),
    ):
        done = cli("agree", *arguments)
        assert done.exit_code == 2, (arguments, done.output)
        assert words in done.stderr.splitlines()[-1]
    (dataset.root / "gold.csv").write_text("frame\n77\n")
    done = cli("agree", dataset.annotations, *reference)
    assert "1 frame (77) without an annotation" in done.stderr


def test_frames_needed_grow_with_the_square_of_what_is_wanted(cli, dataset, study) -> None:
    annotate(dataset, study / "anna", 0.5)
    done = cli("agree", dataset.annotations, study / "anna", "--power", "-t", "2")
    assert done.exit_code == 0, done.output
    rows = [
        [cell.strip() for cell in line.split("│")[1:-1]]
        for line in done.stdout.split("Frames needed")[1].splitlines()
        if "JaC, points" in line
    ]
    assert [row[4] for row in rows] == ["1", "2", "5"]
    needed = [int(row[5]) for row in rows]
    assert 3.5 < needed[0] / needed[1] < 4.5
