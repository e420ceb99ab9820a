"""What fitted cameras say of elements that were left out of the fit, beside methods' figures."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol

from procc_annotator.io.camera_files.fitted_on import SOME_OTHER_VERSION, FitCounts
from procc_annotator.io.camera_files.held_out_table import LEFT_OUT_FILE
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.sheet.counts import FRAMES, HELD_OUT_ELEMENTS
from procc_annotator.report.sheet.figure import shortest_number
from procc_annotator.report.sheet.figures import LEFT_OUT_SCORE, IN_SAMPLE
from procc_annotator.report.sheet.sheet import Column, MetricTable, Value, defined_count_column, metric_column
from procc_annotator.session.runs.held_out import LeftOutMetrics
from procc_annotator.words import count_words

LEFT_OUT_METHOD = "calibrate --held-out"


class MethodWithLeftOut(Protocol):
    """A source some of whose cameras may have been fitted to the clicks they are judged by."""

    @property
    def held_out(self) -> LeftOutMetrics: ...
    @property
    def fitted(self) -> FitCounts: ...
    @property
    def ground_only(self) -> bool: ...


def left_out_table(
    sources: Sequence[tuple[str, MethodWithLeftOut]], thresholds: Sequence[float], setup: EvaluationSetup
) -> MetricTable | None:
    """The fits among the sources, each with the share of elements that are correct left out, and in
    sample; of fits without such figures the notes say how to get them. None without fits.

    Args:
        sources: with their names. thresholds: px. setup: of them all.
    """
    fits = [(name, source) for name, source in sources if source.fitted]
    if not fits:
        return None
    columns = [Column("source", "Source"), defined_count_column(HELD_OUT_ELEMENTS), defined_count_column(FRAMES)]
    columns += [
        metric_column(figure, f"@{tau:g}", key=f"{figure.key}@{shortest_number(tau)}")
        for tau in thresholds
        for figure in (LEFT_OUT_SCORE, IN_SAMPLE)
    ]
    rows = []
    for name, source in fits:
        figures = source.held_out
        row: list[Value] = [name, len(figures.elements) or None, figures.frames or None]
        for tau in thresholds:
            row += figures.shares(tau) or (None, None)
        rows.append(tuple(row))
    notes = [
        f"A camera {SOME_OTHER_VERSION} explains them. Held out, every element is judged by the"
        " camera of the frame's other elements; in sample, the same elements by the camera of all."
    ]
    notes += [f"{name}: {why}" for name, source in fits if (why := _why_none(source))]
    all_on_ground = all(source.ground_only for _, source in fits)
    if not all_on_ground:
        notes += [f"{name}: {setup.describe(True)}" for name, source in fits if source.ground_only]
    title, described = "Fits, and elements left out in turn", setup.describe(all_on_ground)
    return MetricTable("held_out", title, tuple(columns), tuple(rows), described, tuple(notes))


def left_out_entry(source: MethodWithLeftOut, thresholds: Sequence[float]) -> dict[str, Any]:
    """As files of figures hold it; nothing of a source that is no fit."""
    if not source.fitted:
        return {}
    figures = source.held_out
    shares = {shortest_number(tau): figures.shares(tau) for tau in thresholds}
    told = {
        "frames": figures.frames,
        "elements": len(figures.elements),
        "results": {
            tau: {LEFT_OUT_SCORE.key: found[0], IN_SAMPLE.key: found[1]}
            for tau, found in shares.items()
            if found is not None
        },
        "missing": _why_none(source) or None,
    }
    return {"held_out": told}


def _why_none(source: MethodWithLeftOut) -> str:
    """Why some cameras have no such figures; empty where all have."""
    figures = source.held_out
    if figures.frames >= source.fitted.count:
        return ""
    cameras = count_words(source.fitted.count, "camera")
    without = source.fitted.count - figures.frames
    which = (
        f"{without} of its {cameras} have no such figures"
        if figures.frames
        else f"none of its {cameras} has such figures"
    )
    if figures.others:
        made = ", ".join(f"{protocol}, {w}x{h}" for protocol, (w, h) in figures.others)
        return (
            f"{which} for this protocol, size and field"
            f" (but for {made}); {LEFT_OUT_METHOD} makes them with --protocol and --size"
        )
    return f"{which}; {LEFT_OUT_METHOD} writes {LEFT_OUT_FILE} beside the cameras it fits"
