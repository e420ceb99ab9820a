"""Scores as CSV: one row an image and threshold."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from typing import IO, Any

from procc_annotator.metric.sets import SetSummary
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.scores.score_files import threshold_key
from procc_annotator.session.runs.evaluation_run import FrameResult, GroupSummary

CSV_COLUMNS = (
    "name", "protocol", "options", "width", "height", "threshold",
    "jac", "tp", "fp", "fn", "mirrored", "precision", "recall", "mean_reprojection_error",
    "camera", "error",
)  # fmt: skip


def csv_fragment(
    result: FrameResult,
    setup: EvaluationSetup,
    thresholds: tuple[float, ...],
    names: Sequence[str] = (),
) -> bytes:
    """One row a threshold; figures of a frame without scores are empty.

    Args:
        names: of set and method, where several evaluations share a file; they come first.
    """
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    for threshold in thresholds:
        rows.writerow([*names, *_csv_row(result, setup, threshold), *result.groups])
    return text.getvalue().encode()


def _csv_row(result: FrameResult, setup: EvaluationSetup, threshold: float) -> list[Any]:
    chosen = [f"off-plane {setup.off_plane}"] if result.ground_only else []
    if setup.planar_only:
        chosen = ["planar elements only"]
    if setup.protocol == "procc" and setup.allow_mirrored:
        chosen.append("mirrored labels allowed")
    terms = [setup.protocol, "; ".join(chosen), *setup.size]
    start = [result.name, *terms, threshold_key(threshold)]
    score = result.scores.get(threshold)
    if score is None:
        return [*start, *[""] * 8, "", result.error or "no camera"]
    figures: list[Any] = [score.jac, score.tp, score.fp, score.fn, str(score.mirrored).lower()]
    figures += [score.precision, score.recall, score.mean_error]
    return [*start, *figures, result.camera, result.error]


class CsvScores:
    """A header, then one row an image and threshold.

    Args:
        names: columns that come first, e.g. set and method.
        by: what the set is grouped by; columns that come last.
        headless: without the header, after another evaluation.
    """

    def __init__(
        self,
        stream: IO[bytes],
        names: Iterable[str] = (),
        by: Iterable[str] = (),
        *,
        headless: bool = False,
    ) -> None:
        self._stream = stream
        self._columns = [*names, *CSV_COLUMNS, *(f"by_{name}" for name in by)]
        self._headless = headless

    def begin(self) -> None:
        if self._headless:
            return
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerow(self._columns)
        self._stream.write(text.getvalue().encode())

    def add(self, fragment: bytes) -> None:
        self._stream.write(fragment)

    def end(
        self,
        summary: Mapping[float, SetSummary] | None,
        *,
        ground_only: bool,
        groups: Sequence[GroupSummary] = (),
    ) -> None:
        """Nothing: a set's figures have no row of their own."""
