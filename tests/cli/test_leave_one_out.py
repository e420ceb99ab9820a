"""`calibrate --leave-one-out` leaves its figures where `evaluate` and `report` find them."""

from __future__ import annotations

import csv
import io
import json
import random
import shutil
from pathlib import Path

import pytest

FEW = ("--resamples", 200, "--seed", 1)
TAUS = ("-t", 2, "-t", 6)


def plain(text: str) -> str:
    return " ".join(text.split())


def rows(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(path.read_text())))


@pytest.fixture(scope="module")
def clicked(new_dataset) -> Path:
    """Annotations with points moved by some px: what is left out is predicted worse than fitted."""
    annotations = new_dataset().annotations
    chance = random.Random(7)
    for path in sorted(annotations.glob("*.json")):
        content = json.loads(path.read_text())
        for points in content.values():
            for point in points:
                point["x"] += chance.gauss(0, 1.5 / 959)
                point["y"] += chance.gauss(0, 1.5 / 539)
        path.write_text(json.dumps(content))
    return annotations


@pytest.fixture(scope="module")
def fits(cli, clicked, tmp_path_factory) -> Path:
    out = tmp_path_factory.mktemp("fits") / "R"
    done = cli("calibrate", clicked, out, "--leave-one-out", *TAUS)
    assert done.exit_code == 0, done.stderr
    return out


def passed(found: list[dict[str, str]], column: str, tau: float) -> float:
    return sum(bool(row[column]) and float(row[column]) < tau for row in found) / len(found)


def test_frames_annotated_alike_count_once_each(cli, clicked, tmp_path) -> None:
    (alike := tmp_path / "alike").mkdir()
    for name in ("a", "b", "c"):
        shutil.copy(clicked / ("3.json" if name == "c" else "1.json"), alike / f"{name}.json")
    done = cli("calibrate", alike, tmp_path / "fits", "--leave-one-out", *TAUS)
    assert done.exit_code == 0, done.stderr
    told = [row for row in rows(tmp_path / "fits" / "held_out.csv") if row["class"]]
    out = tmp_path / "s.json"
    done = cli("evaluate", alike, tmp_path / "fits", *TAUS, "-o", out)
    assert done.exit_code == 0, done.stderr
    assert json.loads(out.read_text())["held_out"]["elements"] == len(told)


@pytest.mark.usefixtures("no_charts")
def test_the_report_tells_them_beside_the_fit(cli, clicked, fits, tmp_path) -> None:
    report = tmp_path / "r"
    outputs = [arg for kind in ("html", "csv", "json", "tex") for arg in ("-o", f"{report}.{kind}")]
    done = cli(
        "report", clicked, "--cameras", f"ours={fits}", *TAUS, *outputs,
        "--worst", 0, "--random", 0, *FEW,
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    elements = [row for row in rows(fits / "held_out.csv") if row["class"]]
    assert len(elements) > 20
    found = json.loads(Path(f"{report}.json").read_text())["sources"][0]["held_out"]
    assert (found["elements"], found["frames"], found["missing"]) == (len(elements), 5, None)
    for tau in (2, 6):
        told = found["results"][str(tau)]
        assert told["held_out"] == pytest.approx(passed(elements, "held_out_px", tau))
        assert told["in_sample"] == pytest.approx(passed(elements, "in_sample_px", tau))
    assert found["results"]["2"]["held_out"] < found["results"]["2"]["in_sample"]
    of_set = [row for row in rows(Path(f"{report}.csv")) if not row["class"]]
    assert [float(row["held_out"]) for row in of_set] == pytest.approx(
        [found["results"][row["threshold"]]["held_out"] for row in of_set]
    )
    share = f"{100 * found['results']['2']['held_out']:.2f}"
    for kind in ("html", "tex"):
        text = plain(Path(f"{report}.{kind}").read_text())
        assert "elements left out in turn" in text
        assert share in text


def test_evaluate_tells_them_and_how_to_get_them(cli, clicked, fits, tmp_path) -> None:
    out = tmp_path / "s.json"
    done = cli("evaluate", clicked, fits, *TAUS, "-o", out)
    assert "elements left out in turn" in plain(done.stdout)
    assert json.loads(out.read_text())["held_out"]["frames"] == 5
    bare = tmp_path / "bare"
    shutil.copytree(fits, bare, ignore=shutil.ignore_patterns("held_out.csv"))
    done = cli("evaluate", clicked, bare, *TAUS, "-o", out)
    assert "none of its 5 cameras has such figures; calibrate --leave-one-out writes" in plain(
        done.stdout
    )
    assert json.loads(out.read_text())["held_out"]["results"] == {}


def test_terms_that_differ_are_told(cli, clicked, fits) -> None:
    done = cli("evaluate", clicked, fits, "--protocol", "procc")
    assert "for this protocol, size and field (but for soccernet, 960x540)" in plain(done.stdout)


def test_figures_belong_to_the_camera_they_were_made_for(cli, clicked, fits, tmp_path) -> None:
    """Fitted anew with another model, or to clicks that changed since, a camera has none."""
    other = tmp_path / "P"
    shutil.copytree(fits, other)
    done = cli("calibrate", clicked, other, "--model", "P", "--overwrite")
    assert done.exit_code == 0, done.stderr
    assert "none of its 5 cameras has such figures" in plain(cli("evaluate", clicked, other).stdout)
    moved = tmp_path / "moved"
    shutil.copytree(clicked, moved)
    content = json.loads((moved / "3.json").read_text())
    next(iter(content.values()))[0]["x"] += 1e-4
    (moved / "3.json").write_text(json.dumps(content))
    out = tmp_path / "s.json"
    assert cli("evaluate", moved, fits, "-o", out).exit_code == 0
    found = json.loads(out.read_text())["held_out"]
    told = [row for row in rows(fits / "held_out.csv") if row["class"] and row["name"] != "3"]
    assert (found["frames"], found["elements"]) == (4, len(told))


def test_a_damaged_table_is_told_and_loses_nothing(cli, clicked, fits, tmp_path) -> None:
    broken = tmp_path / "broken"
    shutil.copytree(fits, broken)
    lines = (broken / "held_out.csv").read_text().splitlines()
    lines[3] = lines[3].replace(",960,", ",wide,")
    (broken / "held_out.csv").write_text("\n".join(lines))
    done = cli("evaluate", clicked, broken)
    assert done.exit_code == 0
    assert "held_out.csv, line 4" in plain(done.stderr)
    assert "calibrate --leave-one-out writes it anew" in plain(done.stderr)
    assert "5 with a camera" in plain(done.stdout)


def test_methods_have_no_such_table(cli, dataset) -> None:
    assert "left out" not in cli("evaluate", *dataset.set_arguments).stdout


@pytest.mark.parametrize("model", ["R", "H"])
def test_fits_of_a_tree_are_known_by_the_tables_at_its_top(cli, dataset, tmp_path, model) -> None:
    tree, fits, out = tmp_path / "tree", tmp_path / "fits", tmp_path / "s.json"
    for folder, frames in (("one", ("1", "2")), ("two", ("3",))):
        (tree / folder).mkdir(parents=True)
        for frame in frames:
            shutil.copy(dataset.annotations / f"{frame}.json", tree / folder)
    assert cli("calibrate", tree, fits, "--model", model, "--leave-one-out").exit_code == 0
    done = cli("evaluate", tree, fits, "-o", out)
    assert done.exit_code == 0, done.output
    scores = json.loads(out.read_text())
    assert all(image["fitted_on_these_clicks"] for image in scores["images"])
    assert (len(scores["images"]), scores["held_out"]["frames"]) == (3, 3)
