"""`calibrate --leave-one-out` leaves its figures where `evaluate` and `report` find them."""

import json
import random
import shutil
from pathlib import Path

import pytest

from tests.cli.conftest import rows_in

FEW = ("--resamples", 200, "--seed", 1)
TAUS = ("-t", 2, "-t", 6)


def plain(text: str) -> str:
    return " ".join(text.split())


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
    cli("calibrate", clicked, out, "--leave-one-out", *TAUS)
    return out


def passed(found: list[dict[str, str]], column: str, tau: float) -> float:
    return sum(bool(row[column]) and float(row[column]) < tau for row in found) / len(found)


def test_frames_annotated_alike_count_once_each(cli, clicked, tmp_path):
    (alike := tmp_path / "alike").mkdir()
    for name in ("a", "b", "c"):
        shutil.copy(clicked / ("3.json" if name == "c" else "1.json"), alike / f"{name}.json")
    cli("calibrate", alike, tmp_path / "fits", "--leave-one-out", *TAUS)
    told = [row for row in rows_in(tmp_path / "fits" / "held_out.csv") if row["class"]]
    out = tmp_path / "s.json"
    cli("evaluate", alike, tmp_path / "fits", *TAUS, "-o", out)
    assert json.loads(out.read_text())["held_out"]["elements"] == len(told)


@pytest.mark.usefixtures("no_charts")
def test_the_report_tells_them_beside_the_fit(cli, clicked, fits, tmp_path):
    report = tmp_path / "r"
    outputs = [arg for kind in ("html", "csv", "json", "tex") for arg in ("-o", f"{report}.{kind}")]
    cli(
        "report", clicked, "--cameras", f"ours={fits}", *TAUS, *outputs,
        "--worst", 0, "--random", 0, *FEW,
    )  # fmt: skip
    elements = [row for row in rows_in(fits / "held_out.csv") if row["class"]]
    assert len(elements) > 20
    found = json.loads(Path(f"{report}.json").read_text())["sources"][0]["held_out"]
    frames = len({row["name"] for row in elements})
    assert (found["elements"], found["frames"], found["missing"]) == (len(elements), frames, None)
    for tau in (2, 6):
        told = found["results"][str(tau)]
        assert told["held_out"] == pytest.approx(passed(elements, "held_out_px", tau))
        assert told["in_sample"] == pytest.approx(passed(elements, "in_sample_px", tau))
    assert found["results"]["2"]["held_out"] < found["results"]["2"]["in_sample"]
    of_set = [row for row in rows_in(Path(f"{report}.csv")) if not row["class"]]
    assert [float(row["held_out"]) for row in of_set] == pytest.approx(
        [found["results"][row["threshold"]]["held_out"] for row in of_set]
    )
    share = f"{100 * found['results']['2']['held_out']:.2f}"
    for kind in ("html", "tex"):
        text = plain(Path(f"{report}.{kind}").read_text())
        assert "elements left out in turn" in text
        assert share in text


def test_evaluate_tells_them_and_how_to_get_them(cli, clicked, fits, tmp_path):
    out = tmp_path / "s.json"
    done = cli("evaluate", clicked, fits, *TAUS, "-o", out)
    assert "elements left out in turn" in plain(done.stdout)
    assert json.loads(out.read_text())["held_out"]["missing"] is None
    bare = tmp_path / "bare"
    shutil.copytree(fits, bare, ignore=shutil.ignore_patterns("held_out.csv"))
    done = cli("evaluate", clicked, bare, *TAUS, "-o", out)
    assert "none of its 5 cameras has such figures; calibrate --leave-one-out writes" in plain(
        done.stdout
    )
    assert json.loads(out.read_text())["held_out"]["results"] == {}


def test_terms_that_differ_are_told(cli, clicked, fits):
    done = cli("evaluate", clicked, fits, "--protocol", "procc")
    assert "for this protocol, size and field (but for soccernet, 960x540)" in plain(done.stdout)


def test_figures_belong_to_the_camera_they_were_made_for(cli, clicked, fits, tmp_path):
    """Fitted anew with another model, or to clicks that changed since, a camera has none."""
    other = tmp_path / "P"
    shutil.copytree(fits, other)
    cli("calibrate", clicked, other, "--model", "P", "--overwrite")
    assert "none of its 5 cameras has such figures" in plain(cli("evaluate", clicked, other).stdout)
    moved = tmp_path / "moved"
    shutil.copytree(clicked, moved)
    content = json.loads((moved / "3.json").read_text())
    next(iter(content.values()))[0]["x"] += 1e-4
    (moved / "3.json").write_text(json.dumps(content))
    out = tmp_path / "s.json"
    cli("evaluate", moved, fits, "-o", out)
    found = json.loads(out.read_text())["held_out"]
    told = [row for row in rows_in(fits / "held_out.csv") if row["class"] and row["name"] != "3"]
    assert (found["frames"], found["elements"]) == (len({r["name"] for r in told}), len(told))


def test_a_damaged_table_is_told_and_loses_nothing(cli, clicked, fits, tmp_path):
    broken = tmp_path / "broken"
    shutil.copytree(fits, broken)
    lines = (broken / "held_out.csv").read_text().splitlines()
    lines[3] = lines[3].replace(",960,", ",wide,")
    (broken / "held_out.csv").write_text("\n".join(lines))
    done = cli("evaluate", clicked, broken)
    assert "held_out.csv, line 4" in plain(done.stderr)
    assert "calibrate --leave-one-out writes it anew" in plain(done.stderr)
    assert "5 with a camera" in plain(done.stdout)


def test_methods_have_no_such_table(cli, dataset):
    assert "left out" not in cli("evaluate", *dataset.set_arguments).stdout


@pytest.mark.parametrize("model", ["R", "H"])
def test_fits_of_a_tree_are_known_by_the_tables_at_its_top(cli, dataset, tmp_path, model):
    tree, fits, out = tmp_path / "tree", tmp_path / "fits", tmp_path / "s.json"
    for folder, frames in (("one", ("1", "2")), ("two", ("3",))):
        (tree / folder).mkdir(parents=True)
        for frame in frames:
            shutil.copy(dataset.annotations / f"{frame}.json", tree / folder)
    cli("calibrate", tree, fits, "--model", model, "--leave-one-out")
    cli("evaluate", tree, fits, "-o", out)
    scores = json.loads(out.read_text())
    assert all(image["fitted_on_these_clicks"] for image in scores["images"])
    assert (len(scores["images"]), scores["held_out"]["missing"]) == (3, None)


# Cameras that were fitted to the clicks they are judged by say so beside methods.

MARK = "fitted on these clicks"
OTHER = "fitted to another version of these annotations"


@pytest.fixture
def exact_fits(cli, dataset, tmp_path) -> Path:
    out = tmp_path / "fits"
    cli("calibrate", dataset.root, out)
    return out


def test_evaluate_marks_them_in_every_output(cli, dataset, exact_fits, tmp_path):
    out, table = tmp_path / "scores.json", tmp_path / "scores.csv"
    done = cli(
        "evaluate", dataset.annotations, "--cameras", f"theirs={dataset.cameras}",
        "--cameras", f"ours={exact_fits}", "-o", out, "-o", table,
        "--intervals", *FEW,
    )  # fmt: skip
    assert MARK in plain(done.stdout)
    assert "ours†" in plain(done.stdout)
    assert f"† {MARK}: not ranked" in plain(done.stdout)
    theirs, ours = json.loads(out.read_text())["evaluations"]
    assert all(image["fitted_on_these_clicks"] for image in ours["images"])
    assert not any("fitted_on_these_clicks" in image for image in theirs["images"])
    found = {(row["method"], row["fitted_on_these_clicks"]) for row in rows_in(table)}
    assert found == {("theirs", "false"), ("ours", "true")}


def move_a_point(dataset, names) -> None:
    for name in names:
        path = dataset.annotations / f"{name}.json"
        content = json.loads(path.read_text())
        next(iter(content.values()))[0]["x"] += 1e-6
        path.write_text(json.dumps(content))


def test_a_point_moved_since_makes_a_fit_no_method(cli, dataset, exact_fits, tmp_path):
    move_a_point(dataset, ("1", "2"))
    some = f"{MARK}, or to another version of these annotations"
    assert some in plain(cli("evaluate", dataset.annotations, exact_fits).stdout)
    move_a_point(dataset, ("3", "10", "11"))
    out = [part for name in ("s.json", "s.csv") for part in ("-o", tmp_path / name)]
    both = ("--cameras", f"theirs={dataset.cameras}", "--cameras", f"ours={exact_fits}")
    done = cli("evaluate", dataset.annotations, *both, *out, "--intervals", *FEW)
    assert "ours‡" in plain(done.stdout)
    assert f"‡ {OTHER}" in plain(done.stdout)
    assert "†" not in plain(done.stdout)
    theirs, ours = json.loads((tmp_path / "s.json").read_text())["evaluations"]
    assert all(image["fitted_on_another_version"] for image in ours["images"])
    assert not any("fitted_on" in key for image in theirs["images"] for key in image)
    told = {
        (row["method"], row["fitted_on_another_version"]) for row in rows_in(tmp_path / "s.csv")
    }
    assert told == {("theirs", "false"), ("ours", "true")}
    files = [part for name in ("r.html", "r.csv") for part in ("-o", tmp_path / name)]
    cli("report", dataset.root, *both, *files, "--worst", 0, *FEW)
    page = (tmp_path / "r.html").read_text()
    assert "ours‡" in page
    assert f"‡ {OTHER}" in page
    ranks = {row["source"]: row["rank"] for row in rows_in(tmp_path / "r.csv") if not row["class"]}
    assert ranks == {"theirs": "1", "ours": ""}


@pytest.mark.parametrize("to", ["krt", "opencv", "soccernet-camera", "submission", "polylines"])
def test_a_converted_fit_is_still_one(cli, dataset, exact_fits, tmp_path, to):
    first, out = tmp_path / "first", tmp_path / "out.zip"
    cli("convert", exact_fits, first, "--to", "krt")
    cli("convert", first, out, "--to", to)
    fmt = ("--camera-format", to) if to == "polylines" else ()
    assert MARK in plain(cli("evaluate", dataset.annotations, out, *fmt).stdout)


@pytest.mark.parametrize(("model", "kept"), [("H", "calibration.csv"), ("R", "camera_*.json")])
def test_one_of_both_places_is_enough(cli, dataset, tmp_path, model, kept):
    """Homographies are known by the table beside them, pinholes by their own file as well."""
    exact_fits, moved = tmp_path / "all", tmp_path / "moved"
    cli("calibrate", dataset.root, exact_fits, "--model", model)
    moved.mkdir()
    for path in (*exact_fits.glob("*.npy"), *exact_fits.glob(kept)):
        shutil.copy(path, moved)
    assert MARK in plain(cli("evaluate", dataset.annotations, moved).stdout)
    archive = shutil.make_archive(str(tmp_path / "zipped"), "zip", moved)
    assert MARK in plain(cli("evaluate", dataset.annotations, archive).stdout)


def test_a_table_of_something_else_says_nothing(cli, dataset):
    for text in ("name,jac\n1,2\n", "\x00\xff", 'name,annotation_sha256\n"1'):
        (dataset.cameras / "calibration.csv").write_text(text)
        done = cli("evaluate", dataset.annotations, dataset.cameras)
        assert MARK not in done.stdout


def test_the_report_marks_them_and_ranks_methods_only(cli, dataset, exact_fits, tmp_path):
    out = tmp_path / "r.html"
    given = [f"theirs={dataset.cameras}", f"ours={exact_fits}"]
    cli(
        "report", dataset.root, "--cameras", given[0], "--cameras", given[1], "-o", out,
        "-o", tmp_path / "r.tex", "-o", tmp_path / "r.csv", "-o", tmp_path / "r.json",
        "--worst", 0, "--random", 0, "--disagreement", "theirs,ours", "--reference", "ours", *FEW,
    )  # fmt: skip
    page = out.read_text()
    assert page.count("ours†") > 5  # tables and charts
    assert f"† {MARK}: not ranked" in page
    assert "theirs, ours†" in page
    assert "Metrics of earlier papers against ours†" in page
    tables = plain((tmp_path / "r.tex").read_text())
    assert r"ours\textdagger{}" in tables
    assert rf"\textdagger{{}} {MARK}" in tables
    ranks = {row["source"]: row["rank"] for row in rows_in(tmp_path / "r.csv") if not row["class"]}
    assert ranks == {"theirs": "1", "ours": ""}
    fitted = {row["source"]: row["fitted_on_these_clicks"] for row in rows_in(tmp_path / "r.csv")}
    assert fitted == {"theirs": "0", "ours": "5"}
    theirs, ours = json.loads((tmp_path / "r.json").read_text())["sources"]
    assert (ours["fitted_on_these_clicks"], "fitted_on_these_clicks" in theirs) == (5, False)


def test_compare_marks_them_where_it_knows_the_dataset(cli, dataset, exact_fits, tmp_path):
    out = tmp_path / "compared.json"
    done = cli(
        "compare", f"theirs={dataset.cameras}", f"ours={exact_fits}", dataset.root, "-o", out
    )
    assert "ours†" in plain(done.stdout)
    assert f"† {MARK}: not ranked" in plain(done.stdout)
    said = json.loads(out.read_text())
    assert (said["b"]["fitted_on_these_clicks"], "fitted_on_these_clicks" in said["a"]) == (
        True,
        False,
    )


def test_compare_marks_them_in_the_intervals_of_both(cli, dataset, exact_fits, tmp_path):
    out = tmp_path / "compared.json"
    pair = (f"theirs={dataset.cameras}", f"ours={exact_fits}", dataset.root)
    cli("compare", *pair, "--versus", f"again={exact_fits}", "-o", out)
    titles = {key: sheet["title"] for key, sheet in json.loads(out.read_text())["chance"].items()}
    assert titles == {
        "intervals": "ours† against theirs, intervals",
        "intervals_versus": "again† against theirs, intervals",
        "nearer": "Is ours† or again† nearer to theirs",
    }


# The same camera has one mean error, whichever command tells it.

THREE_TAUS = ("-t", 2, "-t", 5, "-t", 10)


def rows_by_name(path: Path) -> dict[str, dict[str, str]]:
    return {row["name"]: row for row in rows_in(path)}


@pytest.fixture
def clicked_wide(dataset) -> Path:
    """Points moved by some px, so that no camera explains them all."""
    chance = random.Random(4)
    for path in dataset.annotations.glob("*.json"):
        content = json.loads(path.read_text())
        for points in content.values():
            for point in points:
                point["x"] += chance.gauss(0, 3 / 959)
                point["y"] += chance.gauss(0, 3 / 539)
        path.write_text(json.dumps(content))
    return dataset.annotations


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
@pytest.mark.parametrize("model", ["R", "H"])
def test_calibrate_evaluate_and_report_agree(cli, clicked_wide, tmp_path, model, protocol):
    fits, scores, report = tmp_path / "fits", tmp_path / "s", tmp_path / "r.json"
    terms = (*THREE_TAUS, "--protocol", protocol)
    cli("calibrate", clicked_wide, fits, "--model", model, *terms)
    outputs = ("-o", f"{scores}.json", "-o", f"{scores}.csv")
    cli("evaluate", clicked_wide, fits, *terms, *outputs)
    cli("report", clicked_wide, "--cameras", f"a={fits}", *terms, "-o", report)

    by_calibrate, by_evaluate = (
        rows_by_name(fits / "calibration.csv"),
        rows_by_name(Path(f"{scores}.csv")),
    )
    assert len(by_calibrate) == 5
    for frame, row in by_calibrate.items():
        told = float(row["mean_error"])
        assert told > 0.5
        assert told == pytest.approx(float(by_evaluate[frame]["mean_error"]), abs=1e-9)

    of_set = json.loads(Path(f"{scores}.json").read_text())["summary"]
    of_report = json.loads(report.read_text())["sources"][0]["summary"]
    errors = [of_set[tau]["mean_error"] for tau in ("2", "5", "10")]
    assert errors == [of_report[tau]["mean_error"] for tau in ("2", "5", "10")]
    # As no turned labels fit these frames better, it does not depend on tau either.
    assert max(errors) - min(errors) < 1e-9
