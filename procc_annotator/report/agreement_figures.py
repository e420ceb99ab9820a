"""What agreements of all kinds share: figures with their intervals, and the frames these need."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from procc_annotator.metric.agreement import FrameAgreement
from procc_annotator.metric.chance.intervals import Interval
from procc_annotator.metric.chance.sampling import BootstrapSettings
from procc_annotator.report.scores.chance_sheets import interval_columns, interval_ends
from procc_annotator.report.scores.tables import pixels
from procc_annotator.report.sheet.as_json import metric_entry
from procc_annotator.report.sheet.figure import shortest_number, metric_values
from procc_annotator.report.sheet.figures import DISTANCES, JAC, MEDIAN_PX, OF_AGREEMENT, P95_PX
from procc_annotator.report.sheet.sheet import TAU, Column, Row, MetricTable, Value, metric_column, count_column
from procc_annotator.session.runs.clusters import Clusters
from procc_annotator.session.runs.sure_agreement import AgreementInference

WORST = 10  # frames that tables of the worst show
ELEMENT_COLUMNS = (
    Column("class"), Column("status"), count_column("points"), count_column("left_out"), *map(metric_column, DISTANCES),
    Column("mirrored_hint", kind="yes_no"), Column("error"),
)  # fmt: skip
_POINTS = (0.01, 0.02, 0.05)  # of JaC
_SHARES = (0.05, 0.1, 0.2)  # of a distance


def element_rows(frame: FrameAgreement, lone: tuple[str, str]) -> list[Row]:
    """One row of `ELEMENT_COLUMNS` an element.

    Args:
        lone: the status of elements of the first annotation alone, and of the second alone.
    """
    hint = frame.mirrored_hint
    rows: list[Row] = [
        (own.class_name, "apart" if own.apart else "common", len(own.distances), own.left_out,
         *metric_values(DISTANCES, own), hint, None)
        for own in frame.by_class.values()
    ]  # fmt: skip
    for status, names in zip(lone, (frame.only_a, frame.only_b), strict=True):
        rows += [status_row(status, name, hint=hint) for name in names]
    return rows


def status_row(
    status: str, name: str | None = None, *, hint: bool | None = None, error: str | None = None
) -> Row:
    """A row of `ELEMENT_COLUMNS` without distances."""
    return (name, status, *(None,) * (2 + len(DISTANCES)), hint, error)


def frame_entry(
    frame: FrameAgreement, thresholds: Sequence[float], lone: tuple[str, str]
) -> dict[str, Any]:
    """The agreement of two annotations of one frame in files; ``lone`` as of `element_rows`."""
    return {
        "jac": {shortest_number(tau): frame.jac(tau) for tau in thresholds},
        lone[0]: list(frame.only_a),
        lone[1]: list(frame.only_b),
        "mirrored_hint": frame.mirrored_hint,
        "elements": {
            name: metric_entry(DISTANCES, own)
            | {"left_out": own.left_out, "distances": own.distances.tolist()}
            for name, own in frame.by_class.items()
        },
    }


def farthest(frame: FrameAgreement) -> tuple[float | None, str]:
    """The largest distance, px, and the class of its element."""
    by_size = [(c.largest, n) for n, c in frame.by_class.items() if c.largest is not None]
    largest, name = max(by_size, default=(None, ""))
    return largest, name.strip()


def agreement_columns() -> list[Column]:
    """JaC, median and 95 %, each with its interval."""
    figures = (JAC, MEDIAN_PX, P95_PX)
    return [c for figure in figures for c in (metric_column(figure), *interval_columns(figure))]


def agreement_values(found: AgreementInference, tau: float) -> tuple[Value, ...]:
    """The values of `agreement_columns` at a threshold, px."""
    overall, known = found.summary.overall, found.known
    low, high = interval_ends(known.jac[tau])
    ends = (None if low is None else max(0.0, low), None if high is None else min(1.0, high))
    return (
        found.summary.mean_jac[tau], *ends,
        overall.median, *interval_ends(known.median), overall.p95, *interval_ends(known.p95),
    )  # fmt: skip


def intervals_described(draws: BootstrapSettings, clusters: Clusters) -> str:
    """What the intervals of an agreement rest on, in words."""
    said = f"{100 * draws.level:g} % intervals (t, jackknife of clusters); {clusters.described}"
    return f"{said}. {clusters.caution.rstrip('.')}" if clusters.caution else said


def inter_annotator_words(floor: AgreementInference) -> str:
    """The noise floor with its intervals, in words."""
    found, known = floor.summary.overall, floor.known

    def told(value: float | None, interval: Interval | None) -> str:
        around = ""
        if interval is not None:
            around = f" [{pixels(interval.low)}, {pixels(interval.high)}]"
        return f"{pixels(value)} px{around}"

    return f"median {told(found.median, known.median)}, 95 % {told(found.p95, known.p95)}"


def inter_annotator_entry(floor: AgreementInference, described: str) -> dict[str, Any]:
    """The noise floor in files: the figures, and the intervals of median and 95 %.

    Args:
        described: what the intervals rest on.
    """
    known = floor.known
    ends = {
        f"{figure.key}_interval": None if found is None else [found.low, found.high]
        for figure, found in ((MEDIAN_PX, known.median), (P95_PX, known.p95))
    }
    return metric_entry(OF_AGREEMENT, floor.summary.overall) | ends | {"intervals": described}


def sample_size_table(found: AgreementInference, described: str, known: str) -> MetricTable:
    """How many frames such a study needs before JaC is known to 1, 2 and 5 points and distances to
    5, 10 and 20 %.

    Args:
        found: the pilot. described: field and size. known: what intervals rest on.
    """
    columns = (
        Column("figure", "figure"), TAU, count_column("frames", "frames now"),
        Column("known_to", "known to ±", "number", written=".3g"),
        Column("wanted", "wanted ±", "number", written=".3g"), count_column("needed", "frames needed"),
    )  # fmt: skip
    rows: list[Row] = []
    overall = found.summary.overall
    for tau, interval in found.known.jac.items():
        rows += [
            ("JaC, points", tau, found.frames, _half(interval, 100.0), 100 * points,
             found.frames_for(interval, points))
            for points in _POINTS
        ]  # fmt: skip
    for title, value, interval in (
        ("median, px", overall.median, found.known.median),
        ("95 %, px", overall.p95, found.known.p95),
    ):
        if not value:
            continue
        if interval is not None and interval.high >= (overall.largest or 0.0):
            interval = None  # it ends because the distances do
        rows += [
            (title, None, found.frames, _half(interval, 1.0), share * value,
             found.frames_for(interval, share * value))
            for share in _SHARES
        ]  # fmt: skip
    note = (
        "Frames of the same kind, in clusters like these. No answer where an interval ends with the"
        f" largest distance: how far it would reach is not known. {known}."
    )
    return MetricTable("power", "Frames needed", columns, tuple(rows), described, (note,))


def _half(interval: Interval | None, times: float) -> float | None:
    return None if interval is None else times * (interval.high - interval.low) / 2
