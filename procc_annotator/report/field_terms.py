"""Which field figures are about, as files say it."""

from __future__ import annotations

from typing import Any

from procc_annotator.field.model import Field


def field_terms(field: Field) -> dict[str, Any]:
    """``field`` in words for people; ``field_name``, ``field_dimensions`` (metres, by name) and
    ``field_lines`` (``measured`` or ``middle``) for programs, which need not take the words apart;
    ``field_file`` where a file of the user's own describes another field than the shipped one of
    its name; ``field_stadiums`` (stadium -> its own dimensions) where frames have such.
    """
    own: dict[str, Any] = {"field_file": field.own_file} if field.own_file else {}
    if field.stadiums is not None:
        own["field_stadiums"] = {s: dict(v) for s, v in field.stadiums.dimensions.items()}
    return {
        "field": field.described,
        "field_name": field.name,
        **own,
        "field_dimensions": {d.name: d.value for d in field.dimensions},
        "field_lines": field.lines,
    }
