"""Findings as a table for a spreadsheet."""

from __future__ import annotations

import csv
import io

from procc_annotator.field.load import load_field
from procc_annotator.fit.labels.finding import Finding, Remedy, RemedyKind, Rule, Severity
from procc_annotator.report.findings import findings_csv

FIELD = load_field("soccer")
SWAPPED = Finding(
    Rule.SWAPPED,
    Severity.ERROR,
    ("Middle line", "Side line top"),
    'both fit "the other", without a doubt',
    (
        Remedy(RemedyKind.SWAP, "swap Halfway line and Far touchline"),
        Remedy(RemedyKind.LOOK, "look"),
    ),
    error_px=31.25,
)
SHORT = Finding(Rule.SHORT, Severity.HINT, ("Middle line",), "it stops short", ())


def test_one_row_a_finding_with_titles_and_suggestions() -> None:
    text = findings_csv([("a", SWAPPED), ("=b", SHORT)], FIELD)
    assert "\r\n" in text
    first, second = csv.DictReader(io.StringIO(text))
    assert first == {
        "frame": "a",
        "element": "Halfway line; Far touchline",
        "severity": "error",
        "rule": "swapped",
        "reason": 'both fit "the other", without a doubt',
        "suggestion": "swap Halfway line and Far touchline; look",
        "error_px": "31.25",
    }
    assert second["frame"] == "'=b"  # a spreadsheet would run it
    assert (second["suggestion"], second["error_px"]) == ("", "")


def test_a_set_without_findings_is_a_head_alone() -> None:
    assert len(findings_csv([], FIELD).splitlines()) == 1
