"""A report says which differences are real: in bold, with intervals, on its page and in files."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path

import pytest


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
    done = cli(
        "report", *real, "-o", folder / "r.tex", "-o", folder / "r.json", "-o", folder / "r.csv",
        "--by", "elements", "--power", "--date", "today",
    )  # fmt: skip
    assert done.exit_code == 0, done.output
    return folder


def test_bold_is_only_what_is_best_beyond_chance(written) -> None:
    tex = (written / "r.tex").read_text()
    comparison = tex[: tex.index(r"\end{table}")]
    bold = re.findall(r"textbf\{([^}]*)\}", comparison)
    # At 2 px no method is better than the others beyond chance; nor is an error of fewer points.
    assert bold == ["84.94", "93.79", "84.94"]
    assert "pnlcalib 186, nbjw 184, carwc 186 of 186" in comparison


def test_files_hold_intervals_differences_ranks_and_the_curve(written) -> None:
    (found,) = json.loads((written / "r.json").read_text())["chance"]
    sheets = ["intervals", "differences", "ranks", "power", "by_elements", "by_elements_figures"]
    sheets += ["by_elements_differences", "difference_curves"]
    assert list(found)[2:] == sheets
    verdicts = {
        (row["threshold"], row["a"], row["b"]): row["verdict"]
        for row in found["differences"]["rows"]
    }
    assert verdicts[2.0, "pnlcalib", "nbjw"] == "undecided"
    assert verdicts[5.0, "pnlcalib", "nbjw"] == "beyond chance"
    parts = found["by_elements"]["rows"]
    assert sorted(part["frames"] for part in parts) == [40, 69, 77]
    most = [max(abs(v) for k, v in p.items() if k.startswith("jac_difference ")) for p in parts]
    assert most == sorted(most, reverse=True)
    with (written / "r.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    of_set = {(row["source"], row["threshold"]): row for row in rows if not row["class"]}
    own = of_set["pnlcalib", "5"]
    assert float(own["mean_jac_low"]) < float(own["mean_jac"]) < float(own["mean_jac_high"])
    assert [of_set[name, "2"]["rank"] for name in ("pnlcalib", "nbjw", "carwc")] == ["1"] * 3
    assert [of_set[name, "5"]["rank"] for name in ("pnlcalib", "nbjw", "carwc")] == list("123")
    assert own["clusters"].startswith("not clustered")
