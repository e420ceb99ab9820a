"""The command reproduces the official figures on real predictions, file by file."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

SETS = {
    "pnlcalib": ("wc14/annotations", "wc14/cameras_pnlcalib", "wc14/expected_pnlcalib.json"),
    "nbjw": ("wc14/annotations", "wc14/cameras_nbjw", "wc14/expected_nbjw.json"),
    "cases": (
        "official_cases/annotations",
        "official_cases/cameras",
        "official_cases/expected.json",
    ),
}


@pytest.mark.parametrize("name", SETS)
def test_every_figure_is_the_official_one(cli, shared_data: Path, tmp_path: Path, name) -> None:
    annotations, cameras, expected_file = (shared_data / part for part in SETS[name])
    out = tmp_path / "out.json"
    arguments = [x for t in (2, 5, 10, 20) for x in ("-t", t)]
    done = cli("evaluate", annotations, cameras, *arguments, "-o", out)
    assert done.exit_code == 0, done.stderr
    expected = json.loads(expected_file.read_text())
    got = json.loads(out.read_text())
    images = {image["name"]: image for image in got["images"]}
    assert images.keys() == expected["images"].keys()
    for frame, official in expected["images"].items():
        if official is None:
            assert images[frame]["results"] == {}
            continue
        for tau, figures in official.items():
            same_image(images[frame]["results"][tau], figures)
    for tau, figures in expected["summary"].items():
        same_summary(got["summary"][tau], figures)


def same_image(ours: dict[str, Any], official: dict[str, Any]) -> None:
    for key in ("tp", "fp", "fn", "mirrored"):
        assert ours[key] == official[key]
    assert ours["jac"] == pytest.approx(official["jac"], abs=1e-6)
    error = official["mean_reprojection_error"]
    if error is None:
        assert ours["mean_reprojection_error"] is None
    else:
        assert ours["mean_reprojection_error"] == pytest.approx(error, abs=5e-4)


def same_summary(ours: dict[str, Any], official: dict[str, Any]) -> None:
    for key, value in official.items():
        if key != "per_class":
            tolerance = 5e-4 if key == "mean_reprojection_error" else 1e-6
            assert ours[key] == pytest.approx(value, abs=tolerance), key
    for name, sums in official["per_class"].items():
        mine = ours["per_class"].get(name, {"tp": 0, "fp": 0, "fn": 0})
        assert {k: mine[k] for k in ("tp", "fp", "fn")} == {k: sums[k] for k in ("tp", "fp", "fn")}
