"""The columns of a table of scores, whatever kind of file keeps it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

Row = tuple[Any, ...]  # one value a column


@dataclass(frozen=True, slots=True)
class ScoreColumn:
    """A column: ``kind`` is text, whole, number or yes_no; all but keys may be empty."""

    name: str
    kind: str
    is_key: bool = False
    may_be_empty: bool = True


COLUMNS = (
    ScoreColumn("set", "text", True, False),
    ScoreColumn("method", "text", True, False),
    ScoreColumn("frame", "text", True, False),
    ScoreColumn("threshold", "number", True, False),
    ScoreColumn("field", "text", True, False),
    ScoreColumn("protocol", "text", True, False),
    ScoreColumn("width", "whole", True, False),
    ScoreColumn("height", "whole", True, False),
    ScoreColumn("off_plane", "text", True, False),
    ScoreColumn("mirrored_labels", "yes_no", True, False),
    ScoreColumn("counted", "yes_no", False, False),
    ScoreColumn("model", "text"),
    ScoreColumn("jac", "number"),
    ScoreColumn("tp", "whole"),
    ScoreColumn("fp", "whole"),
    ScoreColumn("fn", "whole"),
    ScoreColumn("mirrored", "yes_no"),
    ScoreColumn("precision", "number"),
    ScoreColumn("recall", "number"),
    ScoreColumn("mean_reprojection_error", "number"),
    ScoreColumn("points", "whole"),
    ScoreColumn("camera", "text"),
    ScoreColumn("error", "text"),
    ScoreColumn("version", "text", False, False),
)
NAMES = tuple(column.name for column in COLUMNS)
KEYS = sum(column.is_key for column in COLUMNS)  # they come first
