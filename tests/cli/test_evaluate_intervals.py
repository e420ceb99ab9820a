"""``evaluate`` with intervals: what is printed and written, and what stays the same."""

import hashlib
import json
import re
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.cli.conftest import rows_in

SHEETS = ["intervals", "differences", "ranks"]


@pytest.fixture
def methods(dataset, tmp_path, monkeypatch) -> Path:
    shutil.copytree(dataset.annotations, tmp_path / "annotations")
    for method in ("good", "poor"):
        shutil.copytree(dataset.cameras, tmp_path / method)
    (tmp_path / "poor" / "camera_3.json").unlink()
    names = sorted(path.stem for path in (tmp_path / "annotations").glob("*.json"))
    rows = [f"{name},{'ab'[n % 2]},x{n % 3}" for n, name in enumerate(names)]
    (tmp_path / "tags.csv").write_text("\n".join(["frame,light,match", *rows]) + "\n")
    monkeypatch.chdir(tmp_path)
    return tmp_path


BOTH = ("annotations", "--cameras", "A=good", "--cameras", "B=poor")


def chance(path: Path) -> dict[str, Any]:
    (found,) = json.loads(path.read_text())["chance"]
    return found


def test_intervals_and_differences_are_printed_and_written(cli, methods):
    plain = cli("evaluate", *BOTH, "-o", "plain.json", "-o", "plain.csv")
    done = cli("evaluate", *BOTH, "--intervals", "-o", "out.json", "-o", "out.csv")
    assert (methods / "out.csv").read_bytes() == (methods / "plain.csv").read_bytes()
    before, after = (json.loads((methods / f).read_text()) for f in ("plain.json", "out.json"))
    assert before["evaluations"] == after["evaluations"]
    assert "chance" not in before
    found = chance(methods / "out.json")
    assert list(found) == ["set", "described", *SHEETS, "difference_curves"]
    (row,) = found["differences"]["rows"]
    assert (row["a"], row["b"], row["shared"], row["only_a"]) == ("A", "B", 4, 1)
    assert row["verdict"] == "undecided"
    assert plain.stdout.split("written:")[0] in done.stdout
    assert "not clustered" in done.stdout.replace("\n", " ")
    cli("evaluate", *BOTH, "--intervals", "-o", "again.json")
    assert (methods / "again.json").read_bytes() == (methods / "out.json").read_bytes()


def test_a_single_method_has_intervals_alone(cli, methods):
    cli("evaluate", "annotations", "good", "--intervals", "--power", "-o", "out.json")
    assert list(chance(methods / "out.json"))[2:] == ["intervals", "power"]
    (row,) = chance(methods / "out.json")["power"]["rows"]
    assert row["a"] == "good"
    assert row["b"] is None


@pytest.mark.parametrize("method", ["t", "percentile", "bca"])
def test_frames_are_clustered_by_a_tag(cli, methods, method):
    done = cli(
        "evaluate", *BOTH, "--tags", "tags.csv", "--cluster", "match", "--interval-method", method,
        "--resamples", "500", "--seed", "3", "-o", "out.json",
    )  # fmt: skip
    found = chance(methods / "out.json")
    note, *cautions = found["intervals"]["notes"]
    assert "3 clusters by match" in note
    assert "500 resamples, seed 3" in note
    assert "no interval is to be relied on" in cautions[0]
    assert "Of 3 clusters no p is below 0.25" in cautions[1]
    # What frames are clustered by is not what they are broken down by.
    assert "By match" not in done.stdout
    assert "By light" in done.stdout
    assert len(found["by_light"]["rows"]) == 2


def test_what_the_clicks_leave_open_and_strata_of_the_cameras(cli, methods):
    cli(
        "evaluate", *BOTH, "--annotation-noise", "1.5", "--by", "zoom", "--by", "elements", "--by",
        "side", "--power", "-o", "out.json",
    )  # fmt: skip
    found = chance(methods / "out.json")
    parts = ("by_zoom", "by_elements", "by_side")
    rest = ["power", "clicks", "clicked_differences"]
    rest += [name for part in parts for name in (part, f"{part}_figures")]
    rest += [*(f"{part}_differences" for part in parts), "difference_curves"]
    assert list(found)[2:] == [*SHEETS, *rest]
    jac = found["clicks"]["rows"][0]
    assert jac["moved_jac"] < jac["mean_jac"] == 1.0
    assert sum(row["frames"] for row in found["by_side"]["rows"]) == 5


def test_parts_of_a_set_have_every_figure_at_every_threshold(cli, methods):
    """The dataset's table says which frames are of one shot: names do not."""
    (methods / "frames.csv").write_text("frame,shot\n1,a\n2,a\n3,b\n10,b\n11,b\n")
    alone = ("--by", "shot", "--cluster", "none")
    done = cli("evaluate", *BOTH, "-t", "5", "-t", "2", *alone, "-o", "out.json")
    assert "By shot, every figure" in done.stdout
    found = chance(methods / "out.json")
    rows = {(r["value"], r["source"], r["threshold"]): r for r in found["by_shot_figures"]["rows"]}
    assert set(rows) == {(shot, who, tau) for shot in "ab" for who in "AB" for tau in (5.0, 2.0)}
    poor = rows["b", "B", 2.0]
    assert (poor["frames"], poor["completeness"], poor["mean_jac"]) == (3, 2 / 3, 1.0)
    assert poor["final_score"] == pytest.approx(2 / 3)
    assert poor["completeness_low"] <= 2 / 3 <= poor["completeness_high"]
    differences = found["by_shot_differences"]["rows"]
    assert [(r["value"], r["threshold"]) for r in differences] == [
        ("a", 5.0), ("a", 2.0), ("b", 5.0), ("b", 2.0),
    ]  # fmt: skip
    last = differences[-1]
    assert last["final_score_difference"] == pytest.approx(1 / 3)
    assert last["final_score_p_holm"] >= last["final_score_p"]
    assert (last["mean_jac_frames"], last["final_score_frames"]) == (2, 3)


@pytest.mark.parametrize("tag", ["zoom", "elements", "shot"])
def test_a_tag_called_like_what_is_told_from_cameras_is_the_one_that_counts(cli, methods, tag):
    (methods / "own.csv").write_text(f"frame,{tag}\n1,x\n2,x\n3,y\n10,y\n11,y\n")
    cli("evaluate", *BOTH, "--by", tag, "--tags", "own.csv", "--intervals", "-o", "out.json")
    rows = chance(methods / "out.json")[f"by_{tag}"]["rows"]
    assert {(row["value"], row["frames"]) for row in rows} == {("x", 2), ("y", 3)}


def test_several_sets_are_told_apart(cli, methods):
    done = cli(
        "evaluate", "--set", "one=annotations", "--set", "two=annotations", "--cameras", "A=good",
        "--cameras", "B=poor", "--intervals", "-o", "out.json",
    )  # fmt: skip
    found = json.loads((methods / "out.json").read_text())["chance"]
    assert [one["set"] for one in found] == ["one", "two"]
    assert "one: Intervals" in done.stdout


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("--cluster", "match"), "cannot cluster by 'match': there is shot, none; tags come from"),
        (("--cluster", "x", "--tags", "tags.csv"), "there is shot, none, light, match"),
        (("--cluster", "shot"), "names of frames contain no shots"),
        (("--interval-method", "guess"), "is not one of t, percentile, bca"),
        (("--by", "weather"), "cannot group by 'weather'"),
    ],
)
def test_what_cannot_be_done_is_one_line(cli, methods, arguments, says):
    done = cli("evaluate", *BOTH, "--intervals", *arguments, code=2)
    assert says in " ".join(done.stderr.replace("│", " ").split())


def agreement(cli, methods, size: str) -> str:
    """The second annotator's clicks are off by a normal error of 1 px."""
    rng = np.random.default_rng(5)
    second = methods / "second"
    second.mkdir(exist_ok=True)
    for path in (methods / "annotations").iterdir():
        content = json.loads(path.read_text())
        for points in content.values():
            for point in points:
                point["x"] += rng.normal() / 959
                point["y"] += rng.normal() / 539
        (second / path.name).write_text(json.dumps(content))
    name = f"agreement_{size}.json"
    cli("agree", "annotations", "second", "--size", size, "-o", name)
    return name


def test_the_noise_of_clicks_is_what_annotators_differ_by(cli, methods):
    moved = []
    for size in ("960x540", "1919x1079"):
        file = agreement(cli, methods, size)
        cli("evaluate", *BOTH, "--annotation-noise", file, "-t", "1", "-o", f"out_{size}.json")
        found = chance(methods / f"out_{size}.json")["clicks"]
        moved.append([row["moved_jac"] for row in found["rows"]])
        assert f"px of {size} (" in found["notes"][0]
        assert f"from {file})" in found["notes"][0]
    assert moved[0] == pytest.approx(moved[1], abs=0.03)  # px of another size are the same noise
    cli("evaluate", *BOTH, "--annotation-noise", "0.7", "-t", "1", "-o", "given.json")
    rows = chance(methods / "given.json")["clicks"]["rows"]
    assert [row["moved_jac"] for row in rows] == pytest.approx(moved[0], abs=0.12)


def test_a_manifest_knows_the_agreement_and_the_tags(cli, methods):
    file = agreement(cli, methods, "960x540")
    terms = ("--annotation-noise", file, "--tags", "tags.csv", "--cluster", "match")
    cli("evaluate", *BOTH, *terms, "--manifest", "manifest.json")
    inputs = json.loads(Path("manifest.json").read_text())["inputs"]
    data = Path(file).read_bytes()
    assert inputs[file] == [hashlib.sha256(data).hexdigest(), len(data)]
    assert "tags.csv" in inputs
    cli("repeat", "manifest.json")
    Path(file).write_text(Path(file).read_text().replace('"points"', '"Points"', 1))
    done = cli("repeat", "manifest.json", code=1)
    assert file in done.output


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("{", "is no JSON"),
        ("[1]", "has no size of pictures"),
        ('{"size": [960, 540], "summary": {}}', "is no agreement"),
        ('{"size": [960, 540], "summary": {"noise_floor": {"median": 0}}}', "expected one above 0"),
        ('{"size": [960, 540], "summary": {"noise_floor": {"median": null}}}', "distance of None"),
    ],
)
def test_a_file_that_tells_no_noise_is_one_line(cli, methods, content, says):
    (methods / "odd.json").write_text(content)
    done = cli("evaluate", *BOTH, "--annotation-noise", "odd.json", code=2)
    (line,) = done.stderr.splitlines()
    assert line.startswith("procc-annotator: odd.json")
    assert says in line
    for odd in ("0", "nan", "1e9"):
        assert (
            "expected 0.01 to 100 px"
            in cli("evaluate", *BOTH, "--annotation-noise", odd, code=2).stderr
        )


# A report says which differences are real: in bold, with intervals, on its page and in files.


@pytest.fixture(scope="module")
def real(shared_data) -> tuple[str, ...]:
    folder = shared_data / "wc14"
    sources = {
        "pnlcalib": "cameras_pnlcalib", "nbjw": "cameras_nbjw", "carwc": "homographies_carwc",
    }  # fmt: skip
    cameras = (f"{name}={folder / place}" for name, place in sources.items())
    options = (part for one in cameras for part in ("--cameras", one))
    return (str(folder / "annotations"), *options)


@pytest.fixture(scope="module")
def written(cli, real, tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("chance")
    cli(
        "report", *real, "-o", folder / "r.tex", "-o", folder / "r.json", "-o", folder / "r.csv",
        "--by", "elements", "--power", "--date", "today",
    )  # fmt: skip
    return folder


def test_bold_is_only_what_is_best_beyond_chance(written):
    tex = (written / "r.tex").read_text()
    comparison = tex[: tex.index(r"\end{table")]
    bold = re.findall(r"textbf\{([^}]*)\}", comparison)
    # At 2 px no method is better than the others beyond chance; nor is an error of fewer points.
    assert bold == ["84.94", "93.79", "84.94"]
    assert "pnlcalib 186, nbjw 184, carwc 186 of 186" in comparison


def test_files_hold_intervals_differences_ranks_and_the_curve(written):
    (found,) = json.loads((written / "r.json").read_text())["chance"]
    sheets = ["intervals", "differences", "ranks", "power", "by_elements", "by_elements_figures"]
    sheets += ["by_elements_differences", "difference_curves"]
    assert list(found)[2:] == sheets
    verdicts = {
        (row["threshold"], row["a"], row["b"]): row["verdict"]
        for row in found["differences"]["rows"]
    }
    assert verdicts[2.0, "pnlcalib", "nbjw"] == "undecided"
    assert verdicts[5.0, "pnlcalib", "nbjw"] == "significant"
    parts = found["by_elements"]["rows"]
    assert sorted(part["frames"] for part in parts) == [40, 69, 77]
    most = [max(abs(v) for k, v in p.items() if k.startswith("jac_difference ")) for p in parts]
    assert most == sorted(most, reverse=True)
    rows = rows_in(written / "r.csv")
    of_set = {(row["source"], row["threshold"]): row for row in rows if not row["class"]}
    own = of_set["pnlcalib", "5"]
    assert float(own["mean_jac_low"]) < float(own["mean_jac"]) < float(own["mean_jac_high"])
    assert [of_set[name, "2"]["rank"] for name in ("pnlcalib", "nbjw", "carwc")] == ["1"] * 3
    assert [of_set[name, "5"]["rank"] for name in ("pnlcalib", "nbjw", "carwc")] == list("123")
    assert own["clusters"].startswith("not clustered")
