"""What tells one field from another: names and places of all its elements."""

from __future__ import annotations

import hashlib

from procc_annotator.field.model import Field
from procc_annotator.field.sample import sample_official
from procc_annotator.field.stadiums import field_for_stadium


def field_fingerprint(field: Field) -> str:
    """SHA-256, in hexadecimal, of the elements, their places to a nanometre, and the turns that
    take the field to itself; the same of each stadium, and which frames are of it."""
    samples = sample_official(field)
    digest = hashlib.sha256()
    for row, element in enumerate(field.elements):
        digest.update(repr((element.name, element.on_ground, element.optional)).encode())
        digest.update((samples.of(row).round(9) + 0.0).tobytes())
    for turn in field.symmetries:
        digest.update(repr(turn.turn_rad).encode())
    if field.stadiums is not None:
        digest.update(repr(sorted(field.stadiums.frames.items())).encode())
        for stadium in sorted(field.stadiums.dimensions):
            digest.update(field_fingerprint(field_for_stadium(field, stadium)).encode())
    return digest.hexdigest()
