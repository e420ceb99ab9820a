"""Where the lines of a dataset's field lie, if that is not where its field file says."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from procc_annotator.field.model import LINES, Field

if TYPE_CHECKING:
    from procc_annotator.session.database.database import WorkspaceDatabase

SETTING = "field_lines"


@dataclass(frozen=True)
class KeptLines:
    """What a workspace keeps of them.

    Attributes:
        lines: one of `LINES`; empty where nothing is kept.
        problem: why what is kept cannot be used; empty if it can.
    """

    lines: str = ""
    problem: str = ""


def kept_lines_of(settings: Mapping[str, str], field: Field) -> KeptLines:
    """Where a dataset's clicks lie on the lines.

    Args:
        settings: of its workspace, by key.
        field: the one that is annotated; what was kept for another field is nothing.
    """
    text = settings.get(SETTING)
    if text is None:
        return KeptLines()
    try:
        kept = json.loads(text)
        name, lines = kept["field"], kept["lines"]
        if lines not in LINES:
            raise ValueError(lines)
    except (ValueError, TypeError, KeyError) as error:
        said = f"where the lines of the field lie, kept with the dataset, cannot be read: {error!r}"
        return KeptLines(problem=said)
    return KeptLines(lines) if name == field.name else KeptLines()


def keep_lines(database: WorkspaceDatabase, field: Field) -> None:
    """Let a dataset have its lines where this field has them; as its file has them is nothing."""
    own = {"field": field.name, "lines": field.lines}
    usual = field.lines == field.usual_lines
    database.set_setting(SETTING, None if usual else json.dumps(own))
