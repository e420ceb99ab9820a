"""Findings of a report: the best method, by how much, where, and what the figures do not count."""

from __future__ import annotations

from collections.abc import Iterator

from procc_annotator.batch.inference import Inference
from procc_annotator.formats.cameras.fit_record import MARKS
from procc_annotator.messages import pluralize
from procc_annotator.metrics.statistics.significance import PairedDifference
from procc_annotator.report.page.report_data import AuditReport
from procc_annotator.report.tables.metrics import MEAN_ERROR, MEAN_JAC
from procc_annotator.report.tables.table import MetricTable

_MOST_NAMED = 5


def findings(report: AuditReport) -> list[str]:
    """Sentences for the head of the page, the most important first."""
    certainty, tau = report.certainty, report.tau
    found = [_best_at(report, px) for px in report.thresholds] if certainty.methods else []
    found += _error(report)
    found += _where(report)
    for pair in certainty.held_out_pairs:
        shares, difference = pair.held_out[tau], pair.differences["held_out", tau]
        sign = 1 if shares[0] >= shares[1] else -1
        names = [certainty.sources[at].marked_name for at in (pair.a, pair.b)]
        better, worse = zip(names[::sign], shares[::sign], strict=True)
        found.append(
            f"Leave-one-element-out at {tau:g} px: {better[0]} {100 * better[1]:.2f} %,"
            f" above {worse[0]} {100 * worse[1]:.2f} %"
            f" {_ahead(difference, sign)}"
            f" ({pluralize(pair.shared, 'element')} that both determine)."
        )
    return [*found, *_uncounted(report)]


def _jac(certainty: Inference, at: int, tau: float) -> float:
    own, column = certainty.sources[at].ratios(MEAN_JAC.key), certainty.thresholds.index(tau)
    return own.value(column) or 0.0


def _best_at(report: AuditReport, tau: float) -> str:
    certainty, key = report.certainty, MEAN_JAC.key
    ordered = sorted(certainty.methods, key=lambda at: -_jac(certainty, at, tau))
    lead = ordered[0]
    name = certainty.sources[lead].name
    interval = certainty.intervals[lead][key, tau]
    ends = "" if interval is None else f" [{100 * interval.low:.2f}, {100 * interval.high:.2f}]"
    value = f"{100 * _jac(certainty, lead, tau):.2f} %{ends}"
    if not ordered[1:]:
        return f"{name} has JaC@{tau:g} {value}."
    found = certainty.differences(key, tau)
    said = "; ".join(
        f"{certainty.sources[at].name} "
        + _ahead(found.get((lead, at)) or found[at, lead], 1 if (lead, at) in found else -1)
        for at in ordered[1 : _MOST_NAMED + 1]
    )
    if certainty.best(key, tau) == lead:
        return f"{name} is significantly best at {tau:g} px: JaC {value}, ahead of {said}."
    return f"No method is significantly best at {tau:g} px. {name} leads with {value}, over {said}."


def _ahead(found: PairedDifference, sign: int) -> str:
    """A difference of shares; sign: -1 to turn it round."""
    if found.value is None:
        return "(not comparable)"
    by = f"by {sign * 100 * found.value:+.2f} points"
    if found.interval is None or found.corrected is None:
        return f"{by} (not tested)"
    low, high = sorted(sign * 100 * end for end in (found.interval.low, found.interval.high))
    word = "" if found.beyond_chance else ", undecided"
    return f"{by} [{low:+.2f}, {high:+.2f}], p = {found.corrected:.4f}{word}"


def _error(report: AuditReport) -> Iterator[str]:
    certainty, tau = report.certainty, max(report.thresholds)
    best = certainty.best(MEAN_ERROR.key, tau)
    if (
        best is not None
        and len({certainty.sources[at].ground_only for at in certainty.methods}) < 2
    ):
        value = report.evaluated[best].summaries[tau].mean_error
        name = certainty.sources[best].name
        yield f"{name} has the significantly smallest mean error over points, {value:.2f} px."


def _where(report: AuditReport) -> Iterator[str]:
    """Parts of the set with significant differences; the class where two methods differ most."""
    for sheet in report.statistics.sheets:
        if sheet.name.startswith("by_") and not sheet.parts:
            yield from _in_parts(sheet)
    certainty = report.certainty
    ordered = sorted(certainty.methods, key=lambda at: -_jac(certainty, at, report.tau))
    if len(ordered) < 2:
        return
    first, second = (report.evaluated[at] for at in ordered[:2])
    classes = [s.summaries[report.tau].per_class for s in (first, second)]
    off = {
        name: 100 * (own.jac - other.jac)
        for name, own in classes[0].items()
        if (other := classes[1].get(name)) and own.jac is not None and other.jac is not None
    }
    if any(off.values()):
        name = max(off, key=lambda key: abs(off[key]))
        yield (
            f"Among classes {first.name} and {second.name} differ most on {name.strip()}:"
            f" {off[name]:+.2f} points of JaC counted in points (not tested)."
        )


def _in_parts(sheet: MetricTable) -> Iterator[str]:
    significant = [
        f"{sheet.columns[column].group} in {sheet.rows[row][0]}"
        f" ({sheet.columns[column].text(sheet.rows[row][column])} points)"
        for row, column in sorted(sheet.bold)
    ]
    if significant:
        more = f" and {len(significant) - _MOST_NAMED} more" if significant[_MOST_NAMED:] else ""
        yield f"{sheet.title}, significant: {'; '.join(significant[:_MOST_NAMED])}{more}."


def _uncounted(report: AuditReport) -> Iterator[str]:
    """What a reader must know of annotations, and of methods that are not ranked."""
    for sign, why in MARKS.items():
        names = [s.name for s in report.evaluated if sign in s.marked_name[len(s.name) :]]
        if names:
            yield f"{sign} {', '.join(names)}: {why}; not ranked, bold or tested."
    for note in dict.fromkeys(note for s in report.evaluated for note in s.annotation_notes):
        yield f"{note[0].upper()}{note[1:]}."
    yield from (f"{s.name}: {s.size_doubt}" for s in report.evaluated if s.size_doubt)
