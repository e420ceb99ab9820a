"""The columns of scores: of a frame in every file of scores, and of the table that grows."""

from __future__ import annotations

from typing import Any

from procc_annotator.io.camera_files.fitted_on import FITTED_KEYS
from procc_annotator.metric.score import FrameScore
from procc_annotator.report.sheet.figure import metric_values
from procc_annotator.report.sheet.figures import ANNOTATED, FN, FP, JAC, OF_FRAME, SPREAD, TP
from procc_annotator.report.sheet.sheet import Column, Kind, Value, defined_count_column, metric_column, count_column

ScoreRow = tuple[Any, ...]  # one value a column

COUNTS = (TP, FP, FN)

FRAME_COLUMNS = (
    metric_column(JAC), *(count_column(count.key) for count in COUNTS), Column("mirrored", kind="yes_no"),
    *map(metric_column, OF_FRAME),
)  # fmt: skip

# Whether the camera was fitted to the annotation it is judged by, or to another version of it.
FITTED_COLUMNS = tuple(Column(key, kind="yes_no") for key in FITTED_KEYS)


def frame_values(score: FrameScore | None) -> tuple[Value, ...]:
    """A frame's figures at a threshold, a value for each of `FRAME_COLUMNS`."""
    if score is None:
        return (None,) * len(FRAME_COLUMNS)
    return (*metric_values((JAC, *COUNTS), score), score.mirrored, *metric_values(OF_FRAME, score))


def _required(key: str, kind: Kind = "text") -> Column:
    return Column(key, kind=kind, required=True)


_KEY_COLUMNS = (
    _required("set"), _required("method"), _required("frame"), _required("threshold", "number"),
    _required("field"), _required("protocol"), _required("width", "whole"),
    _required("height", "whole"), _required("off_plane"), _required("mirrored_labels", "yes_no"),
)  # fmt: skip
COLUMNS = (
    *_KEY_COLUMNS, _required("counted", "yes_no"), Column("model"), *FRAME_COLUMNS,
    count_column("points"), Column("camera"), Column("error"), _required("version"), *FITTED_COLUMNS,
    defined_count_column(ANNOTATED), metric_column(SPREAD),
)  # fmt: skip
NAMES = tuple(column.key for column in COLUMNS)
KEYS = len(_KEY_COLUMNS)  # they come first
