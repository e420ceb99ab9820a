"""Findings as a table for a spreadsheet."""

from __future__ import annotations

import csv
import io

from procc_annotator.calibration.label_check.finding import (
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.report.label_check import CheckReport, ReportedFinding, findings_csv

LOOK = Remedy(RemedyKind.LOOK, "look at it")


def rows(report: CheckReport) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(findings_csv(report).decode())))


def test_every_error_says_which_pixels_and_whose_camera() -> None:
    off = Finding(
        Rule.RESIDUAL, Severity.ERROR, ("Middle line",), "off", (LOOK,), 0, 20.0, model="R+"
    )
    bent = Finding(Rule.BENT, Severity.WARNING, ("Middle line",), "bent", (LOOK,))
    first, second = rows(
        CheckReport(
            found=[ReportedFinding("a", off, (960, 540)), ReportedFinding("b", bent, (1920, 1080))]
        )
    )
    assert (first["error_px"], first["model"]) == ("20.00", "R+")
    assert (first["width"], first["height"]) == ("960", "540")
    assert (second["error_px"], second["model"]) == ("", "")
    assert (second["width"], second["height"]) == ("1920", "1080")


def test_no_cell_is_run_as_a_formula() -> None:
    found = Finding(Rule.BENT, Severity.ERROR, ("=1+1",), "-bent", (LOOK,))
    report = CheckReport(
        found=[ReportedFinding("+a", found, (960, 540))], unreadable=[("@b", "=c.json: damaged")]
    )
    first, second = rows(report)
    assert (first["frame"], first["elements"], first["reason"]) == ("'+a", "'=1+1", "'-bent")
    assert (second["frame"], second["reason"]) == ("'@b", "'=c.json: damaged")
