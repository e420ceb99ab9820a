"""Frames of several stadiums: a field with the dimensions of each frame's own stadium."""

from __future__ import annotations

from dataclasses import replace

from procc_annotator.field.landmarks import field_at
from procc_annotator.field.load import with_dimensions
from procc_annotator.field.model import Field, Stadiums


def with_stadiums(field: Field, stadiums: Stadiums | None) -> Field:
    """The field with stadiums whose dimensions it can have, in place of those it may have had.

    Raises:
        FieldError: a stadium's dimensions are none of this field.
    """
    if stadiums is None or not stadiums.dimensions:
        return field if field.stadiums is None else replace(field, stadiums=None)
    sized = replace(field, stadiums=stadiums)
    for stadium in stadiums.dimensions:
        field_for_stadium(sized, stadium)
    return sized


def field_for_stadium(field: Field, stadium: str | None) -> Field:
    """The field with a stadium's dimensions; those that it does not name are the field's own.

    Args:
        stadium: one of the field's; itself for another one, or None.

    Raises:
        FieldError: the dimensions are none of this field.
    """
    if field.stadiums is None or stadium is None or stadium not in field.stadiums.dimensions:
        return field
    known = field.of_stadiums.get(stadium)
    if known is None:
        own = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
        known = with_dimensions(field, {**own, **field.stadiums.dimensions[stadium]})
        known = field.of_stadiums[stadium] = replace(known, stadiums=None)
    return known


def stadium_of(field: Field, frame: str) -> str | None:
    """The stadium that a frame was taken in, where its dimensions are known."""
    return None if field.stadiums is None else field.stadiums.frames.get(frame)


def field_for_frame(field: Field, frame: str) -> Field:
    """The field as it is in a frame: with the dimensions of its stadium, and with its landmarks
    where they are then; itself where a frame has nothing of its own."""
    own = field_for_stadium(field, stadium_of(field, frame))
    return field_at(own, field.instants.get(frame)) if field.instants else own
