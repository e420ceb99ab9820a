"""The tables of a report as text, the same for its page and for LaTeX."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from procc_annotator.field.landmarks import titles_of_all_frames
from procc_annotator.report.page.audit_report import AuditReport, ReportedSource
from procc_annotator.report.scores.tables import percent_text, pixels
from procc_annotator.report.sheet.figure import DASH
from procc_annotator.session.runs.audit_figures import bias, gather


@dataclass(frozen=True, slots=True)
class ReportColumn:
    """A heading; ``group`` spans neighbouring columns, ``better`` is +1, -1 or 0 (no best)."""

    heading: str
    better: int = 0
    group: str = ""
    numeric: bool = True


@dataclass(frozen=True, slots=True)
class Cell:
    """What is shown; best values are set in bold."""

    text: str
    best: bool = False


@dataclass(frozen=True, eq=False)
class ReportTable:
    """A table with its caption; the first cell of a row is its heading."""

    caption: str
    columns: tuple[ReportColumn, ...]
    rows: tuple[tuple[Cell, ...], ...]

    @property
    def groups(self) -> tuple[tuple[str, int], ...]:
        """Groups of columns with their widths; empty where no column has one."""
        spans: list[tuple[str, int]] = []
        for column in self.columns:
            if spans and spans[-1][0] == column.group:
                spans[-1] = column.group, spans[-1][1] + 1
            else:
                spans.append((column.group, 1))
        return tuple(spans) if any(name for name, _ in spans) else ()


_Row = Sequence[str | float | None]
_Format = Callable[[float | None], str]


def comparison_table(report: AuditReport) -> ReportTable:
    """The sources side by side, as the paper compares camera models."""
    taus = sorted(report.thresholds)
    columns = [
        ReportColumn("Source", numeric=False),
        ReportColumn("Camera model", numeric=False),
        *(ReportColumn(f"JaC@{tau:g} %", +1) for tau in taus),
        ReportColumn(f"Reprojection error@{taus[-1]:g} px", -1),
        ReportColumn("Completeness %", +1),
        ReportColumn(f"Final score@{report.tau:g} %", +1),
    ]
    formats = [*([percent_text] * len(taus)), pixels, percent_text, percent_text]
    rows = [(s.name, s.model or DASH, *_figures(s, taus, report.tau)) for s in report.sources]
    return _table(f"Comparison of camera sources ({terms(report)})", columns, rows, formats)


def _figures(source: ReportedSource, taus: list[float], leading: float) -> list[float | None]:
    if not source.summaries:
        return [None] * (len(taus) + 3)
    first = source.summaries[leading]
    return [
        *(source.summaries[tau].mean_jac for tau in taus),
        source.summaries[taus[-1]].mean_reprojection_error,
        first.completeness,
        first.final_score,
    ]


def frames_table(report: AuditReport) -> ReportTable:
    """How many frames each source was evaluated on."""
    columns = [
        ReportColumn("Source", numeric=False),
        ReportColumn("Folder", numeric=False),
        ReportColumn("Annotated frames"),
        ReportColumn("With a camera"),
        ReportColumn("Without"),
        ReportColumn(f"Labels mirrored@{report.tau:g}"),
        ReportColumn("Cameras without annotation"),
    ]
    rows: list[_Row] = []
    for source in report.sources:
        counts: list[str] = [DASH] * 4
        if source.summaries:
            figures = source.summaries[report.tau]
            missing = figures.images - figures.evaluated
            mirrored = sum(
                frame.figures[report.tau].mirrored for frame in source.frames if frame.figures
            )
            numbers = (figures.images, figures.evaluated, missing, mirrored)
            counts = [str(number) for number in numbers]
        rows.append((source.name, source.folder, *counts, str(len(source.unmatched))))
    return _table("Frames behind the figures", columns, rows, [])


def classes_section(report: AuditReport) -> ReportTable:
    """Per class and source: JaC counted in points, and the median error."""
    sources = report.evaluated
    columns = [ReportColumn("Class", numeric=False)]
    for source in sources:
        columns.append(ReportColumn(f"JaC@{report.tau:g} %", +1, source.name))
        columns.append(ReportColumn("median px", -1, source.name))
    titles = titles_of_all_frames(report.setup.field)
    medians = [_class_medians(source) for source in sources]
    figures = [source.summaries[report.tau].per_class for source in sources]
    known = list(titles)
    found = {name for per_class in figures for name in per_class}
    names = [n for n in known if n in found] + sorted(found - set(known))
    rows: list[_Row] = []
    for name in names:
        row: list[str | float | None] = [titles.get(name, name.strip())]
        index = known.index(name) if name in known else -1
        for per_class, median in zip(figures, medians, strict=True):
            found_here = per_class.get(name)
            row += [None if found_here is None else found_here.jac, median.get(index)]
        rows.append(row)
    caption = f"Classes, counted in points ({terms(report)})"
    return _table(caption, columns, rows, [percent_text, pixels] * len(sources), across=True)


def _class_medians(source: ReportedSource) -> dict[int, float]:
    points = gather(list(source.audits.values()))
    rows = np.unique(points.class_rows).tolist()
    return {r: float(np.median(points.errors_px[points.class_rows == r])) for r in rows}


def errors_table(report: AuditReport) -> ReportTable:
    """How the distances of points are spread, and whether they lean to one side."""
    columns = [
        ReportColumn("Source", numeric=False),
        ReportColumn("Points"),
        ReportColumn("without distance"),
        ReportColumn("median px", -1),
        ReportColumn("95 % px", -1),
        ReportColumn("max px", -1),
        ReportColumn("bias right px"),
        ReportColumn("bias down px"),
    ]
    rows: list[_Row] = []
    for source in report.evaluated:
        points = gather(list(source.audits.values()))
        errors, lean = points.errors_px, bias(points)
        spread: list[float | None] = [None] * 3
        if len(errors):
            spread = [*np.percentile(errors, (50, 95)).tolist(), float(errors.max())]
        signed = [DASH, DASH] if lean is None else [_signed(v) for v in lean]
        rows.append((source.name, str(len(errors)), str(points.undefined), *spread, *signed))
    return _table(f"Reprojection errors ({terms(report)})", columns, rows, [pixels] * 3)


def _signed(value: float) -> str:
    text = f"{value:+.2f}"
    return "0.00" if float(text) == 0 else text


def terms(report: AuditReport) -> str:
    """Protocol, size and options behind the figures; by source where they differ."""
    sources = report.evaluated
    said = dict.fromkeys(source.described for source in sources)
    if len(said) < 2:
        return next(iter(said), report.setup.describe())
    common = report.setup.describe()
    special = [
        f"{s.name}: {s.described.removeprefix(common).lstrip(', ')}"
        for s in sources
        if s.described != common
    ]
    return "; ".join([common, *special])


def _table(
    caption: str,
    columns: Sequence[ReportColumn],
    rows: Sequence[_Row],
    formats: Sequence[_Format],
    *,
    across: bool = False,
) -> ReportTable:
    """Numbers of a row take the formats in turn; texts stay as they are.

    The best of a column is set in bold or, ``across``, the best of a row among columns of one
    heading.
    """
    texts = [_texts(row, formats) for row in rows]
    bold: set[tuple[int, int]] = set()
    for places, better in _rivals(columns, len(rows), across):
        numbers = {at: v for at in places if isinstance(v := rows[at[0]][at[1]], float)}
        if len(numbers) > 1:
            best = (max if better > 0 else min)(numbers, key=numbers.__getitem__)
            shown = texts[best[0]][best[1]]
            # What looks the same is as good.
            bold |= {at for at in numbers if texts[at[0]][at[1]] == shown}
    cells = tuple(
        tuple(Cell(text, (r, c) in bold) for c, text in enumerate(line))
        for r, line in enumerate(texts)
    )
    return ReportTable(caption, tuple(columns), cells)


def _texts(row: _Row, formats: Sequence[_Format]) -> list[str]:
    left = iter(formats)
    return [value if isinstance(value, str) else next(left)(value) for value in row]


def _rivals(
    columns: Sequence[ReportColumn], rows: int, across: bool
) -> Iterator[tuple[list[tuple[int, int]], int]]:
    """Places (row, column) that are compared with each other, and what is better."""
    judged = [(i, column) for i, column in enumerate(columns) if column.better]
    if not across:
        for i, column in judged:
            yield [(row, i) for row in range(rows)], column.better
        return
    for row in range(rows):
        for heading in dict.fromkeys(column.heading for _, column in judged):
            same = [(i, column) for i, column in judged if column.heading == heading]
            yield [(row, i) for i, _ in same], same[0][1].better
