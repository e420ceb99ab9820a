"""``evaluate`` with intervals: what is printed and written, and what stays the same."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

SHEETS = ["intervals", "differences", "ranks"]


@pytest.fixture
def methods(dataset, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
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


def test_intervals_and_differences_are_printed_and_written(cli, methods) -> None:
    plain = cli("evaluate", *BOTH, "-o", "plain.json", "-o", "plain.csv")
    done = cli("evaluate", *BOTH, "--intervals", "-o", "out.json", "-o", "out.csv")
    assert done.exit_code == 0, done.output
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
    again = cli("evaluate", *BOTH, "--intervals", "-o", "again.json")
    assert again.exit_code == 0
    assert (methods / "again.json").read_bytes() == (methods / "out.json").read_bytes()


def test_a_single_method_has_intervals_alone(cli, methods) -> None:
    done = cli("evaluate", "annotations", "good", "--intervals", "--power", "-o", "out.json")
    assert done.exit_code == 0, done.output
    assert list(chance(methods / "out.json"))[2:] == ["intervals", "power"]
    (row,) = chance(methods / "out.json")["power"]["rows"]
    assert row["a"] == "good"
    assert row["b"] is None


@pytest.mark.parametrize("method", ["t", "percentile", "bca"])
def test_frames_are_clustered_by_a_tag(cli, methods, method) -> None:
    done = cli(
        "evaluate", *BOTH, "--tags", "tags.csv", "--cluster", "match", "--interval-method", method,
        "--draws", "500", "--seed", "3", "-o", "out.json",
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    found = chance(methods / "out.json")
    (note,) = found["intervals"]["notes"]
    assert "3 clusters by match" in note
    assert "500 draws, seed 3" in note
    # What frames are clustered by is not what they are broken down by.
    assert "By match" not in done.stdout
    assert "By light" in done.stdout
    assert len(found["by_light"]["rows"]) == 2


def test_what_the_clicks_leave_open_and_strata_of_the_cameras(cli, methods) -> None:
    done = cli(
        "evaluate", *BOTH, "--click-noise", "1.5", "--by", "zoom", "--by", "elements", "--by",
        "side", "--power", "-o", "out.json",
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    found = chance(methods / "out.json")
    rest = ["power", "clicks", "clicked_differences", "by_zoom", "by_elements", "by_side"]
    rest.append("difference_curves")
    assert list(found)[2:] == [*SHEETS, *rest]
    jac = found["clicks"]["rows"][0]
    assert jac["moved_jac"] < jac["mean_jac"] == 1.0
    assert sum(row["frames"] for row in found["by_side"]["rows"]) == 5


def test_several_sets_are_told_apart(cli, methods) -> None:
    done = cli(
        "evaluate", "--set", "one=annotations", "--set", "two=annotations", "--cameras", "A=good",
        "--cameras", "B=poor", "--intervals", "-o", "out.json",
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    found = json.loads((methods / "out.json").read_text())["chance"]
    assert [one["set"] for one in found] == ["one", "two"]
    assert "one: Intervals" in done.stdout


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("--cluster", "match"), "cannot cluster by 'match': there is shot, none; tags come from"),
        (("--cluster", "x", "--tags", "tags.csv"), "there is shot, none, light, match"),
        (("--cluster", "shot"), "names of frames tell no shots"),
        (("--interval-method", "guess"), "is none of t, percentile, bca"),
        (("--by", "weather"), "cannot group by 'weather'"),
    ],
)
def test_what_cannot_be_done_is_one_line(cli, methods, arguments, says) -> None:
    done = cli("evaluate", *BOTH, "--intervals", *arguments)
    assert done.exit_code == 2
    assert says in " ".join(done.stderr.replace("│", " ").split())
