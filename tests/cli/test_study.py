"""``gold`` and ``agree --power`` as whoever runs an annotation study uses them."""

from __future__ import annotations

import csv
import json
import shutil
import zipfile
from pathlib import Path

import numpy as np
import pytest

import procc_annotator
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import Origin, OriginKind
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation

GOLD = ("2", "3", "10", "11")


@pytest.fixture
def study(cli, dataset, tmp_path: Path) -> Path:
    """The dataset with gold frames, and a copy of its pictures for each of two annotators."""
    (dataset.root / "gold.csv").write_text("frame\n" + "\n".join(GOLD) + "\n")
    out = tmp_path / "study"
    for annotator in ("anna", "ben"):
        (out / annotator).mkdir(parents=True)
        for picture in dataset.root.glob("*.jpg"):
            shutil.copy(picture, out / annotator)
    return out


def annotate(dataset, folder: Path, rise: float, *, database: bool = True) -> None:
    """Every frame a little more off than the one before, in another order than that of names."""
    rng = np.random.default_rng(7)
    opened = WorkspaceDatabase.open(folder, "somebody") if database else None
    names = sorted((path.stem for path in folder.glob("*.jpg")), key=lambda name: -int(name))
    for place, name in enumerate(names):
        content = json.loads((dataset.annotations / f"{name}.json").read_text())
        for points in content.values():
            for point in points:
                off = rise * (place + 1) * rng.choice((-1, 1))
                point["x"] += off / 959
                point["y"] += off / 539
        file = folder / f"{name}.json"
        file.write_text(json.dumps(content))
        if opened is not None:
            read = read_annotation(file.read_bytes(), path=file, field=load_field("soccer"))
            when = Origin(OriginKind.CLICKED, "somebody", 1000.0 + place)
            opened.put_origins(name, {(p.u, p.v): when for line in read for p in line.points})
    if opened is not None:
        opened.close()


def test_errors_on_gold_frames_rise_in_the_order_of_work(cli, dataset, study, tmp_path) -> None:
    annotate(dataset, study / "anna", 0.5)
    annotate(dataset, study / "ben", 0.0, database=False)
    out, table = tmp_path / "gold.json", tmp_path / "gold.csv"
    arguments = ("gold", dataset.root, study / "anna", study / "ben", "-t", "2", "-t", "5")
    done = cli(*arguments, "-o", out, "-o", table)
    assert done.exit_code == 0, done.output
    assert "No times are known of all frames of ben" in " ".join(done.stdout.split())
    content = json.loads(out.read_text())
    errors = {(r["annotator"], r["threshold"]): r for r in content["gold"]["rows"]}
    assert errors["ben", 2.0]["jac"] == 1.0
    assert errors["ben", 2.0]["max"] == pytest.approx(0.0, abs=1e-6)
    assert errors["anna", 2.0]["jac"] < errors["anna", 5.0]["jac"]
    over_time = {r["annotator"]: r for r in content["over_time"]["rows"]}
    anna = over_time["anna"]
    assert anna["first_median"] < anna["middle_median"] < anna["last_median"]
    assert anna["trend_px"] > 2.0
    assert over_time["ben"]["trend_px"] is None
    with open(table, newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["annotator"] == "anna"]
    assert [row["frame"] for row in rows] == ["11", "10", "3", "2"]
    assert rows[0]["time"] == "1970-01-01T00:16:40+00:00"


def test_without_times_there_is_no_order_of_work(cli, dataset, study, tmp_path) -> None:
    annotate(dataset, study / "ben", 0.5, database=False)
    out = tmp_path / "gold.json"
    done = cli("gold", dataset.root, study / "ben", "-o", out)
    assert done.exit_code == 0, done.output
    assert "errors have no order of work" in " ".join(done.stdout.split())
    assert "third" not in done.stdout
    assert "over_time" not in json.loads(out.read_text())


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
    """What it never reads it can neither show nor pass on; the commands of a study alone do."""
    package = Path(procc_annotator.__file__).parent
    readers = [
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        if "gold_file" in path.read_text() or "gold.csv" in path.read_text()
    ]
    assert set(readers) == {"cli/gold.py", "dataset/annotation_source.py"}


def test_what_cannot_be_done_is_one_line(cli, dataset, study, tmp_path) -> None:
    other = tmp_path / "other.csv"
    for arguments, words in (
        (("gold", dataset.root, study / "anna"), "nobody has annotated any of 4 gold frames"),
        (("gold", tmp_path / "none", study / "anna"), "none: does not exist"),
        (("gold", study / "anna", study / "ben"), "has no gold.csv"),
        (("gold", dataset.root, dataset.annotations, "--gold", other), "7: names no frame"),
    ):
        other.write_text("frame,x\n1,1\n2,1\n3,1\n10,1\n11,1\n,1\n")
        done = cli(*arguments)
        assert done.exit_code == 2, (arguments, done.output)
        (line,) = done.stderr.splitlines()
        assert words in line, line
    (dataset.root / "gold.csv").write_text("frame\n77\n")
    done = cli("gold", dataset.root, dataset.annotations)
    assert "1 gold frame (77) without an annotation" in done.stderr


def test_frames_needed_grow_with_the_square_of_what_is_wanted(cli, dataset, study) -> None:
    annotate(dataset, study / "anna", 0.5, database=False)
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
