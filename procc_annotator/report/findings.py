"""What the label check found as a table for a spreadsheet."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable

from procc_annotator.field.model import Field
from procc_annotator.fit.labels.finding import Finding

COLUMNS = ("frame", "element", "severity", "rule", "reason", "suggestion", "error_px")
_FORMULA_STARTS = ("=", "+", "-", "@", "\t", "\r")


def findings_csv(findings: Iterable[tuple[str, Finding]], field: Field) -> str:
    """One row a finding, in the order given.

    RFC 4180 with its CRLF line ends (write it with ``newline=""``). Several elements and several
    suggestions are separated by "; ". Text that a spreadsheet would run as a formula gets a leading
    apostrophe.

    Args:
        findings: each with its frame's name.
        field: the elements' titles.
    """
    text = io.StringIO(newline="")
    table = csv.writer(text)
    table.writerow(COLUMNS)
    for frame, finding in findings:
        words = (
            frame,
            "; ".join(field.title_of(name) for name in finding.elements),
            finding.severity.value,
            finding.rule.value,
            finding.reason,
            "; ".join(remedy.text for remedy in finding.remedies),
        )
        error = "" if finding.error_px is None else f"{finding.error_px:.6g}"
        table.writerow([*map(_no_formula, words), error])
    return text.getvalue()


def _no_formula(text: str) -> str:
    return f"'{text}" if text.startswith(_FORMULA_STARTS) else text
