"""The tables of a report, for its page and for LaTeX."""

from __future__ import annotations

import numpy as np

from procc_annotator.field.landmarks import element_titles
from procc_annotator.io.camera_files.fitted_on import SOME_OTHER_VERSION
from procc_annotator.report.page.audit_report import AuditReport, ReportedSource
from procc_annotator.report.scores.held_out_sheet import left_out_table
from procc_annotator.report.sheet.counts import (
    ERROR_POINTS,
    EVALUATED,
    IMAGES,
    MIRRORED,
    UNDEFINED,
    UNMATCHED,
    WITHOUT,
)
from procc_annotator.report.sheet.figure import shortest_number
from procc_annotator.report.sheet.figures import (
    BIAS_DOWN,
    BIAS_RIGHT,
    COMPLETENESS,
    FINAL_SCORE,
    JAC,
    LARGEST_PX,
    MEAN_ERROR,
    MEAN_JAC,
    MEDIAN_PX,
    P95_PX,
)
from procc_annotator.report.sheet.sheet import Column, MetricTable, defined_count_column, metric_column
from procc_annotator.session.runs.audit_figures import bias, gather

SOURCE = Column("source", "Source")


def comparison_table(report: AuditReport) -> MetricTable:
    """The sources side by side, as the paper compares camera models."""
    taus = sorted(report.thresholds)
    columns = (
        SOURCE,
        Column("model", "Camera model"),
        *(metric_column(MEAN_JAC, f"@{tau:g}", key=f"mean_jac@{shortest_number(tau)}") for tau in taus),
        metric_column(MEAN_ERROR, f"@{taus[-1]:g}"),
        metric_column(COMPLETENESS),
        metric_column(FINAL_SCORE, f"@{report.tau:g}"),
    )
    rows = tuple(
        (s.marked_name, s.model or None, *_figures(s, taus, report.tau)) for s in report.sources
    )
    return MetricTable(
        "comparison", "Comparison of camera sources", columns, rows, terms(report),
        (_rests_on(report),), _significantly_best(report, taus),
    )  # fmt: skip


def _figures(source: ReportedSource, taus: list[float], leading: float) -> list[float | None]:
    if not source.summaries:
        return [None] * (len(taus) + 3)
    first = source.summaries[leading]
    return [
        *(source.summaries[tau].mean_jac for tau in taus),
        source.summaries[taus[-1]].mean_error,
        first.completeness,
        first.final_score,
    ]


def _significantly_best(report: AuditReport, taus: list[float]) -> frozenset[tuple[int, int]]:
    """Places of the values that are better than those of every other source beyond chance."""
    keys = [(MEAN_JAC.key, tau) for tau in taus]
    keys += [(MEAN_ERROR.key, taus[-1]), (COMPLETENESS.key, report.tau)]
    keys.append((FINAL_SCORE.key, report.tau))
    rows = [at for at, source in enumerate(report.sources) if source.summaries]
    best = [report.certainty.best(*key) for key in keys]
    on_ground = [source.ground_only for source in report.evaluated]
    error = best[len(taus)]
    if error is not None and on_ground[error] and not all(on_ground):
        best[len(taus)] = None  # of a homography it is the error of fewer points
    return frozenset((rows[b], 2 + at) for at, b in enumerate(best) if b is not None)


def _rests_on(report: AuditReport) -> str:
    """Which frames the figures rest on, and what is bold."""
    first = report.evaluated[0].summaries[report.tau]
    counts = {s.name: s.summaries[report.tau].evaluated for s in report.evaluated}
    if len(set(counts.values())) == 1:
        own = f"{next(iter(counts.values()))}"
    else:
        own = ", ".join(f"{name} {count}" for name, count in counts.items())
    rests = (
        f"JaC is the mean over the frames with a camera ({own} of {first.images}), mean error that"
        f" over all their points, with the labels that count at {max(report.thresholds):g} px."
    )
    if len(counts) < 2:
        return rests
    if any(source.fitted for source in report.evaluated):
        rests += f" Cameras {SOME_OTHER_VERSION} explain them and are no method: never bold."
    return (
        f"{rests} Bold is what is better than every other source beyond chance, on the frames both"
        " have; completeness and final score over all frames."
    )


def fits_table(report: AuditReport) -> MetricTable | None:
    """The fits among the sources by elements left out; None without fits."""
    sources = [(source.name, source) for source in report.evaluated]
    return left_out_table(sources, sorted(report.thresholds), report.setup)


def frames_table(report: AuditReport) -> MetricTable:
    """How many frames each source was evaluated on."""
    columns = (
        SOURCE,
        Column("folder", "Folder"),
        *map(defined_count_column, (IMAGES, EVALUATED, WITHOUT)),
        defined_count_column(MIRRORED, f"@{report.tau:g}"),
        defined_count_column(UNMATCHED),
    )
    rows = []
    for source in report.sources:
        counts: tuple[int | None, ...] = (None,) * 4
        if source.summaries:
            figures = source.summaries[report.tau]
            mirrored = sum(
                frame.figures[report.tau].mirrored for frame in source.frames if frame.figures
            )
            missing = figures.images - figures.evaluated
            counts = (figures.images, figures.evaluated, missing, mirrored)
        rows.append((source.marked_name, source.folder, *counts, len(source.unmatched)))
    return MetricTable("frames", "Frames behind the figures", columns, tuple(rows))


def classes_section(report: AuditReport) -> MetricTable:
    """Per class and source: JaC counted in points, and the median error."""
    sources = report.evaluated
    columns = [Column("class", "Class")]
    for source in sources:
        jac = metric_column(JAC, f"@{report.tau:g}", key=f"jac:{source.name}", group=source.marked_name)
        columns += [jac, metric_column(MEDIAN_PX, key=f"median:{source.name}", group=source.marked_name)]
    titles = element_titles(report.setup.field)
    medians = [_class_medians(source) for source in sources]
    figures = [source.summaries[report.tau].per_class for source in sources]
    known = list(titles)
    found = {name for per_class in figures for name in per_class}
    rows = []
    for name in [n for n in known if n in found] + sorted(found - set(known)):
        row: list[str | float | None] = [titles.get(name, name.strip())]
        index = known.index(name) if name in known else -1
        for per_class, median in zip(figures, medians, strict=True):
            found_here = per_class.get(name)
            row += [None if found_here is None else found_here.jac, median.get(index)]
        rows.append(tuple(row))
    title = "Classes, counted in points"
    return MetricTable("classes", title, tuple(columns), tuple(rows), terms(report))


def _class_medians(source: ReportedSource) -> dict[int, float]:
    points = gather(list(source.audits.values()))
    rows = points.counted_rows
    return {r: float(np.median(points.errors_px[rows == r])) for r in np.unique(rows).tolist()}


def errors_table(report: AuditReport) -> MetricTable:
    """How the distances of points are spread, and whether they lean to one side."""
    columns = (
        SOURCE,
        *map(defined_count_column, (ERROR_POINTS, UNDEFINED)),
        *map(metric_column, (MEDIAN_PX, P95_PX, LARGEST_PX, BIAS_RIGHT, BIAS_DOWN)),
    )
    rows = []
    for source in report.evaluated:
        points = gather(list(source.audits.values()))
        errors, lean = points.errors_px, bias(points)
        spread: tuple[float | None, ...] = (None,) * 3
        if len(errors):
            spread = (*np.percentile(errors, (50, 95)).tolist(), float(errors.max()))
        row = (source.marked_name, len(errors), points.undefined, *spread, *(lean or (None, None)))
        rows.append(row)
    return MetricTable("errors", "Reprojection errors", columns, tuple(rows), terms(report))


def every_frame_table(report: AuditReport) -> MetricTable:
    """JaC of every frame under every source."""
    sources = report.evaluated
    columns = (
        Column("frame", "Frame"),
        *(metric_column(JAC, key=f"jac:{source.name}", heading=source.marked_name) for source in sources),
    )
    rows = []
    for name in report.frames:
        found = [source.figures(name, report.tau) for source in sources]
        rows.append((name, *(None if f is None else f.jac for f in found)))
    title = f"JaC@{report.tau:g} of every frame, %"
    return MetricTable("every_frame", title, columns, tuple(rows), terms(report))


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
