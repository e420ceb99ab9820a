"""The columns of a table of scores, whatever kind of file keeps it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

Row = tuple[Any, ...]  # one value a column


@dataclass(frozen=True, slots=True)
class Column:
    """A column: ``kind`` is text, whole, number or yes_no; all but keys may be empty."""

    name: str
    kind: str
    is_key: bool = False
    may_be_empty: bool = True


COLUMNS = (
    Column("set", "text", True, False),
    Column("method", "text", True, False),
    Column("frame", "text", True, False),
    Column("threshold", "number", True, False),
    Column("field", "text", True, False),
    Column("protocol", "text", True, False),
    Column("width", "whole", True, False),
    Column("height", "whole", True, False),
    Column("off_plane", "text", True, False),
    Column("mirrored_labels", "yes_no", True, False),
    Column("counted", "yes_no", False, False),
    Column("model", "text"),
    Column("jac", "number"),
    Column("tp", "whole"),
    Column("fp", "whole"),
    Column("fn", "whole"),
    Column("mirrored", "yes_no"),
    Column("precision", "number"),
    Column("recall", "number"),
    Column("mean_reprojection_error", "number"),
    Column("points", "whole"),
    Column("camera", "text"),
    Column("error", "text"),
    Column("version", "text", False, False),
)
NAMES = tuple(column.name for column in COLUMNS)
KEYS = sum(column.is_key for column in COLUMNS)  # they come first
