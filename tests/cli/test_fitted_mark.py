"""Cameras that were fitted to the clicks they are judged by say so beside methods."""

from __future__ import annotations

import csv
import io
import json
import shutil
from pathlib import Path

import pytest

MARK = "fitted on these clicks"
OTHER = "fitted to another version of these annotations"
FEW = ("--resamples", 200, "--seed", 1)


def rows(path: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(path.read_text())))


def plain(text: str) -> str:
    return " ".join(text.split())


@pytest.fixture
def fits(cli, dataset, tmp_path) -> Path:
    out = tmp_path / "fits"
    assert cli("calibrate", dataset.root, out).exit_code == 0
    return out


def test_evaluate_marks_them_in_every_output(cli, dataset, fits, tmp_path) -> None:
    out, table = tmp_path / "scores.json", tmp_path / "scores.csv"
    done = cli(
        "evaluate", dataset.annotations, "--cameras", f"theirs={dataset.cameras}",
        "--cameras", f"ours={fits}", "-o", out, "-o", table,
        "--intervals", *FEW,
    )  # fmt: skip
    assert done.exit_code == 0, done.stderr
    assert MARK in plain(done.stdout)
    assert f"ours ({MARK})" in plain(done.stdout)
    theirs, ours = json.loads(out.read_text())["evaluations"]
    assert all(image["fitted_on_these_clicks"] for image in ours["images"])
    assert not any("fitted_on_these_clicks" in image for image in theirs["images"])
    found = {(row["method"], row["fitted_on_these_clicks"]) for row in rows(table)}
    assert found == {("theirs", "false"), ("ours", "true")}


def move_a_point(dataset, names) -> None:
    for name in names:
        path = dataset.annotations / f"{name}.json"
        content = json.loads(path.read_text())
        next(iter(content.values()))[0]["x"] += 1e-6
        path.write_text(json.dumps(content))


def test_a_point_moved_since_makes_a_fit_no_method(cli, dataset, fits, tmp_path) -> None:
    move_a_point(dataset, ("1", "2"))
    some = f"{MARK}, or to another version of these annotations"
    assert some in plain(cli("evaluate", dataset.annotations, fits).stdout)
    move_a_point(dataset, ("3", "10", "11"))
    out = [part for name in ("s.json", "s.csv") for part in ("-o", tmp_path / name)]
    both = ("--cameras", f"theirs={dataset.cameras}", "--cameras", f"ours={fits}")
    done = cli("evaluate", dataset.annotations, *both, *out, "--intervals", *FEW)
    assert f"ours ({OTHER})" in plain(done.stdout)
    assert f"({MARK})" not in plain(done.stdout)
    theirs, ours = json.loads((tmp_path / "s.json").read_text())["evaluations"]
    assert all(image["fitted_on_another_version"] for image in ours["images"])
    assert not any("fitted_on" in key for image in theirs["images"] for key in image)
    told = {(row["method"], row["fitted_on_another_version"]) for row in rows(tmp_path / "s.csv")}
    assert told == {("theirs", "false"), ("ours", "true")}
    files = [part for name in ("r.html", "r.csv") for part in ("-o", tmp_path / name)]
    assert cli("report", dataset.root, *both, *files, "--worst", 0, *FEW).exit_code == 0
    assert f"ours ({OTHER})" in (tmp_path / "r.html").read_text()
    ranks = {row["source"]: row["rank"] for row in rows(tmp_path / "r.csv") if not row["class"]}
    assert ranks == {"theirs": "1", "ours": ""}


@pytest.mark.parametrize("to", ["krt", "opencv", "soccernet-camera", "submission", "polylines"])
def test_a_converted_fit_is_still_one(cli, dataset, fits, tmp_path, to) -> None:
    first, out = tmp_path / "first", tmp_path / "out.zip"
    assert cli("convert", fits, first, "--to", "krt").exit_code == 0
    assert cli("convert", first, out, "--to", to).exit_code == 0
    fmt = ("--camera-format", to) if to == "polylines" else ()
    assert MARK in plain(cli("evaluate", dataset.annotations, out, *fmt).stdout)


@pytest.mark.parametrize(("model", "kept"), [("H", "calibration.csv"), ("R", "camera_*.json")])
def test_one_of_both_places_is_enough(cli, dataset, tmp_path, model, kept) -> None:
    """Homographies are known by the table beside them, pinholes by their own file as well."""
    fits, moved = tmp_path / "all", tmp_path / "moved"
    assert cli("calibrate", dataset.root, fits, "--model", model).exit_code == 0
    moved.mkdir()
    for path in (*fits.glob("*.npy"), *fits.glob(kept)):
        shutil.copy(path, moved)
    assert MARK in plain(cli("evaluate", dataset.annotations, moved).stdout)
    archive = shutil.make_archive(str(tmp_path / "zipped"), "zip", moved)
    assert MARK in plain(cli("evaluate", dataset.annotations, archive).stdout)


def test_a_table_of_something_else_says_nothing(cli, dataset) -> None:
    for text in ("name,jac\n1,2\n", "\x00\xff", 'name,annotation_sha256\n"1'):
        (dataset.cameras / "calibration.csv").write_text(text)
        done = cli("evaluate", dataset.annotations, dataset.cameras)
        assert done.exit_code == 0
        assert MARK not in done.stdout


def test_the_report_marks_them_and_ranks_methods_only(cli, dataset, fits, tmp_path) -> None:
    out = tmp_path / "r.html"
    given = [f"theirs={dataset.cameras}", f"ours={fits}"]
    done = cli(
        "report", dataset.root, "--cameras", given[0], "--cameras", given[1], "-o", out,
        "-o", tmp_path / "r.tex", "-o", tmp_path / "r.csv", "-o", tmp_path / "r.json",
        "--worst", 0, "--random", 0, "--disagreement", "theirs,ours", "--reference", "ours", *FEW,
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    page = out.read_text()
    assert page.count(f"ours ({MARK})") > 5  # tables and charts
    assert f"theirs, ours ({MARK})" in page
    assert f"Metrics of earlier papers against ours ({MARK})" in page
    assert f"ours ({MARK})" in plain((tmp_path / "r.tex").read_text())
    ranks = {row["source"]: row["rank"] for row in rows(tmp_path / "r.csv") if not row["class"]}
    assert ranks == {"theirs": "1", "ours": ""}
    fitted = {row["source"]: row["fitted_on_these_clicks"] for row in rows(tmp_path / "r.csv")}
    assert fitted == {"theirs": "0", "ours": "5"}
    theirs, ours = json.loads((tmp_path / "r.json").read_text())["sources"]
    assert (ours["fitted_on_these_clicks"], "fitted_on_these_clicks" in theirs) == (5, False)


def test_compare_marks_them_where_it_knows_the_dataset(cli, dataset, fits, tmp_path) -> None:
    out = tmp_path / "compared.json"
    done = cli("compare", f"theirs={dataset.cameras}", f"ours={fits}", dataset.root, "-o", out)
    assert done.exit_code == 0, done.stderr
    assert f"ours ({MARK})" in plain(done.stdout)
    said = json.loads(out.read_text())
    assert (said["b"]["fitted_on_these_clicks"], "fitted_on_these_clicks" in said["a"]) == (
        True,
        False,
    )


def test_compare_marks_them_in_the_intervals_of_both(cli, dataset, fits, tmp_path) -> None:
    out = tmp_path / "compared.json"
    pair = (f"theirs={dataset.cameras}", f"ours={fits}", dataset.root)
    done = cli("compare", *pair, "--versus", f"again={fits}", "-o", out)
    assert done.exit_code == 0, done.stderr
    titles = {key: sheet["title"] for key, sheet in json.loads(out.read_text())["chance"].items()}
    assert titles == {
        "intervals": f"ours ({MARK}) against theirs, intervals",
        "intervals_versus": f"again ({MARK}) against theirs, intervals",
        "nearer": f"Is ours ({MARK}) or again ({MARK}) nearer to theirs",
    }
