"""Label-check findings as CSV, JSON and terminal tables."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, NamedTuple

from procc_annotator.batch.execution.executor import Progress
from procc_annotator.batch.label_check import Checked, CheckRun
from procc_annotator.calibration.label_check.finding import Finding, RemedyKind, Rule, Severity
from procc_annotator.calibration.optimization.robust_fit import MIN_ELEMENTS
from procc_annotator.errors import UsageError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.messages import pluralize
from procc_annotator.report.scores.score_files import field_terms
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes
from procc_annotator.report.tables.table import Column, MetricTable, Row, count_column, shortened

_COLUMNS = (
    Column("frame"), Column("severity"), Column("rule"), Column("elements"), Column("reason"),
    Column("suggestion"), count_column("point"), Column("error_px", kind="number", written=".2f"),
    Column("model"), count_column("width"), count_column("height"),
)  # fmt: skip
UNREADABLE = "unreadable"
NO_CAMERA = "no camera"
_SHOWN = 20
_SUFFIXES = (".csv", ".json")


class ReportedFinding(NamedTuple):
    """A finding as it is reported, with the (width, height) px of the picture that its distances
    are px of, and a key of what was found in which points, as the window ignores it."""

    frame: str
    finding: Finding
    size: tuple[int, int]
    key: str = ""


class FrameWithoutCamera(NamedTuple):
    """A frame without a camera: only the rules that need none were examined.

    Attributes:
        elements: number of annotated classes.
        failure: why there is no camera.
        size: as of `ReportedFinding`.
    """

    frame: str
    elements: int
    failure: str
    size: tuple[int, int]


@dataclass
class CheckReport:
    """Result of the label check of a set.

    Attributes:
        described: model, field and size.
        frames: number of annotations that could be read.
        found: in the order of the frames; those that were asked for.
        severities: of all findings, also of those no one asked for.
        unreadable: (frame, why its annotation cannot be read).
        remarks: on the sizes of the pictures, one line each.
        wrong_field: whether the set must be another field's: what is said of it as a whole is not
            reported again class by class.
    """

    described: str = ""
    frames: int = 0
    found: list[ReportedFinding] = field(default_factory=list)
    severities: set[Severity] = field(default_factory=set)
    unreadable: list[tuple[str, str]] = field(default_factory=list)
    without_camera: list[FrameWithoutCamera] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    wrong_field: bool = False

    @property
    def worth_listing(self) -> list[ReportedFinding]:
        """Return what informs a person about a single label."""
        if not self.wrong_field:
            return self.found
        return [one for one in self.found if one.finding.rule is not Rule.UNKNOWN_CLASS]

    def frames_with(self, severity: Severity) -> int:
        """Number of frames with a finding of this severity."""
        return len({one.frame for one in self.found if one.finding.severity is severity})

    def has_any(self, least: Severity) -> bool:
        """Return whether something is at least so severe; an unreadable annotation is."""
        return bool(self.unreadable) or any(s.rank <= least.rank for s in self.severities)


def check_findings_suffix(path: Path) -> None:
    """Raises UsageError unless findings can be written to a file of this name."""
    if path.suffix.lower() not in _SUFFIXES:
        raise UsageError(f"{path}: findings are written as .csv or .json, end the name so")


def check_set(
    run: CheckRun,
    progress: Progress[Checked],
    *,
    outputs: Sequence[Path] = (),
    least: Severity = Severity.HINT,
    wrong_field: bool = False,
) -> CheckReport:
    """Check a set and write what is at least as severe as ``least`` to .csv and .json files, each
    replaced in one step. `SaveError` if writing fails."""
    report = CheckReport(wrong_field=wrong_field)
    for name, checked in run.together(progress(run, run.total, "checking")):
        if isinstance(checked, str):
            report.unreadable.append((name, checked))
            continue
        report.frames += 1
        if checked.failure:
            report.without_camera.append(
                FrameWithoutCamera(name, checked.elements, checked.failure, checked.size)
            )
        findings = [found.finding for found in checked.found]
        if wrong_field:
            findings = [_without_remedy(finding) for finding in findings]
        report.severities.update(finding.severity for finding in findings)
        report.found += [
            ReportedFinding(name, finding, checked.size, found.key)
            for finding, found in zip(findings, checked.found, strict=True)
            if finding.severity.rank <= least.rank
        ]
    report.described, report.remarks = run.describe(), run.sizes.remarks()
    for output in outputs:
        is_json = output.suffix.lower() == ".json"
        write_atomic(output, findings_json(report, run) if is_json else findings_csv(report))
    return report


def _without_remedy(finding: Finding) -> Finding:
    """Under a wrong field the class that is spelt most alike is another sport's."""
    if finding.rule is not Rule.UNKNOWN_CLASS:
        return finding
    names = ", ".join(repr(name.strip()) for name in finding.elements)
    return replace(finding, reason=f"no such class: {names}", remedies=())


def findings_csv(report: CheckReport) -> bytes:
    """One row a finding, in the order of the frames, then one a frame that has no camera (without a
    severity), then one an unreadable annotation.

    Elements are named exactly as in annotation files, spaces at their ends included.
    """
    rows: list[Row] = []
    nothing = (None,) * 4  # suggestion, point, error and model
    for name, finding, size, _ in report.found:
        elements = "; ".join(finding.elements)
        words = (name, finding.severity.value, finding.rule.value, elements, finding.reason)
        point = None if finding.point is None else finding.point + 1
        where = (_suggestion(finding), point, finding.error_px, finding.model)
        rows.append((*words, *where, *size))
    for name, _, failure, size in report.without_camera:
        rows.append((name, None, NO_CAMERA, None, f"by eye only: {failure}", *nothing, *size))
    for name, problem in report.unreadable:
        known = (name, Severity.ERROR.value, UNREADABLE, None, problem)
        rows.append((*known, *nothing, None, None))
    return csv_bytes(MetricTable("findings", "Findings", _COLUMNS, tuple(rows)))


def findings_json(report: CheckReport, run: CheckRun) -> bytes:
    """All of it, remedies included; indented."""
    content = {
        "model": run.task.model,
        **field_terms(run.task.field),
        "size": _only(size.fitted for size in run.sizes.counts),
        "frames": report.frames,
        "findings": [_entry(one) for one in report.found],
        "without_camera": [
            {"frame": one.frame, "elements": one.elements, "failure": one.failure}
            for one in report.without_camera
        ],
        "unreadable": [{"frame": n, "problem": problem} for n, problem in report.unreadable],
    }
    return json_bytes(content, indent=2)


def _only(sizes: Iterable[tuple[int, int]]) -> list[int] | None:
    """The size of all frames; None where they have several, as every finding says."""
    found = set(sizes)
    return list(found.pop()) if len(found) == 1 else None


def _entry(one: ReportedFinding) -> dict[str, Any]:
    finding = one.finding
    return {
        "frame": one.frame,
        "size": list(one.size),
        "severity": finding.severity.value,
        "rule": finding.rule.value,
        "elements": list(finding.elements),
        "reason": finding.reason,
        "remedies": [
            {"kind": r.kind.value, "text": r.text, "renamed": [list(pair) for pair in r.renamed]}
            for r in finding.remedies
        ],
        "point": None if finding.point is None else finding.point + 1,
        "error_px": finding.error_px,
        "model": finding.model,
    }


def _suggestion(finding: Finding) -> str:
    """The likeliest remedies in words; several of one kind leave a choice."""
    first = finding.remedies[0] if finding.remedies else None
    if first is None:
        return ""
    alike = [r.text for r in finding.remedies if r.kind is first.kind]
    return " or ".join(alike) if first.kind is not RemedyKind.LOOK else first.text


def counts_table(report: CheckReport) -> MetricTable:
    """One row a rule that found something: how often, and how surely."""
    columns = (
        Column("rule", "found"),
        *(count_column(severity.value, f"{severity}s") for severity in Severity),
    )
    counts = Counter((one.finding.rule, one.finding.severity) for one in report.found)
    by_rule: list[Row] = [(rule.value, *(counts[rule, s] for s in Severity)) for rule in Rule]
    rows = [row for row in by_rule if any(row[1:])]
    concerned: Row = ("frames concerned", *(report.frames_with(severity) for severity in Severity))
    return MetricTable(
        "findings",
        f"Checked {pluralize(report.frames, 'frame')}",
        columns,
        (*rows, concerned),
        notes=(report.described,),
        parts=(len(rows),),
    )


def frames_without_camera_words(report: CheckReport) -> list[str]:
    """Return how many frames were checked without a camera, and why, one line each."""
    counts = [one.elements for one in report.without_camera]
    empty = sum(count == 0 for count in counts)
    few = sum(0 < count < MIN_ELEMENTS for count in counts)
    no_fit = len(counts) - empty - few
    lines = [
        (empty, "no element at all: nothing to look at"),
        (few, "too few elements for a camera: only checked by rules that need no camera"),
        (no_fit, "no camera that fits: only checked by rules that need no camera"),
    ]
    return [
        f"{pluralize(count, 'frame has', 'frames have')} {words}" for count, words in lines if count
    ]


def findings_table(report: CheckReport, *, in_file: bool) -> MetricTable:
    """The worst findings: surest first, then the largest errors."""
    columns = (
        Column("frame", "frame"), Column("severity", "severity"), Column("reason", "why"),
        Column("suggestion", "suggestion"),
    )  # fmt: skip
    worst = sorted(
        report.worth_listing, key=lambda t: (t.finding.severity.rank, -(t.finding.error_px or 0.0))
    )
    rows = tuple(
        (name, finding.severity.value, finding.reason, _suggestion(finding))
        for name, finding, _, _ in worst
    )
    table = MetricTable("worst_findings", "Worst findings", columns, rows)
    return shortened(table, _SHOWN, "in the file" if in_file else "with --output")
