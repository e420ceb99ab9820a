"""The same camera has one mean error, whichever command tells it."""

from __future__ import annotations

import csv
import io
import json
import random
from pathlib import Path

import pytest

TAUS = ("-t", 2, "-t", 5, "-t", 10)


def rows(path: Path) -> dict[str, dict[str, str]]:
    return {row["name"]: row for row in csv.DictReader(io.StringIO(path.read_text()))}


@pytest.fixture
def clicked(dataset) -> Path:
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
def test_calibrate_evaluate_and_report_agree(cli, clicked, tmp_path, model, protocol) -> None:
    fits, scores, report = tmp_path / "fits", tmp_path / "s", tmp_path / "r.json"
    terms = (*TAUS, "--protocol", protocol)
    assert cli("calibrate", clicked, fits, "--model", model, *terms).exit_code == 0
    outputs = ("-o", f"{scores}.json", "-o", f"{scores}.csv")
    assert cli("evaluate", clicked, fits, *terms, *outputs).exit_code == 0
    assert cli("report", clicked, "--cameras", f"a={fits}", *terms, "-o", report).exit_code == 0

    by_calibrate, by_evaluate = rows(fits / "calibration.csv"), rows(Path(f"{scores}.csv"))
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
