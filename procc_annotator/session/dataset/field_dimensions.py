"""The dimensions of a dataset's field, kept in its workspace."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from procc_annotator.errors import FieldError
from procc_annotator.field.load import resized
from procc_annotator.field.model import Field

if TYPE_CHECKING:
    from procc_annotator.session.database.database import WorkspaceDatabase

SETTING = "field_dimensions"


@dataclass(frozen=True)
class KeptDimensions:
    """What a workspace keeps of its field.

    Attributes:
        values: metres, by name; empty where all are nominal.
        problem: why what is kept cannot be used; empty if it can.
    """

    values: Mapping[str, float]
    problem: str = ""


def kept_dimensions(database: WorkspaceDatabase, field: Field) -> KeptDimensions:
    """The dimensions that a dataset was given.

    Args:
        database: of its workspace.
        field: the one that is annotated; what was kept for another field is none.
    """
    return kept_dimensions_of(database.settings(), field)


def kept_dimensions_of(settings: Mapping[str, str], field: Field) -> KeptDimensions:
    """The same from the settings of a workspace, by key."""
    text = settings.get(SETTING)
    if text is None:
        return KeptDimensions({})
    try:
        kept = json.loads(text)
        name, values = kept["field"], {str(k): float(v) for k, v in kept["dimensions"].items()}
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        said = f"the dimensions of the field kept with the dataset cannot be read: {error!r}"
        return KeptDimensions({}, said)
    if name != field.name:
        return KeptDimensions({})
    try:
        resized(field, values)
    except FieldError as error:
        said = f"the dimensions of the field kept with the dataset are not used: {error}"
        return KeptDimensions({}, said)
    return KeptDimensions(values)


def keep_dimensions(database: WorkspaceDatabase, field: Field) -> None:
    """Let a dataset have the dimensions of this field; nominal ones are kept as nothing."""
    own = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    text = json.dumps({"field": field.name, "dimensions": own}) if own else None
    database.set_setting(SETTING, text)


def add_dimensions(database: WorkspaceDatabase, field: Field, found: Mapping[str, float]) -> Field:
    """Let a dataset have dimensions that were found, and otherwise those it was given before.

    Args:
        database: of its workspace.
        field: what they were found with; dimensions of it that are not nominal were asked for.
        found: metres, by name.

    Returns:
        The dataset's field.

    Raises:
        FieldError: together they are no field.
    """
    asked_for = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    before = kept_dimensions(database, field).values
    sized = resized(field, {**before, **asked_for, **found})
    keep_dimensions(database, sized)
    return sized
