"""Whether cameras whose format alone says which field they are of belong to the one that is shown.

A bare homography tells nothing of its ground: it is read as one of the World Cup's only where the
pictures may show a soccer field.
"""

from __future__ import annotations

from procc_annotator.field.load import field_titles, is_builtin_field
from procc_annotator.field.model import Field

NAME_THE_FORMAT = "choose its camera format: world takes metres from the field's centre"


def field_mismatch(assumed: str, field: Field) -> str:
    """Why a camera cannot be taken for one of a field; empty if it can.

    A field of the user's own may be any, soccer too.

    Args:
        assumed: as of `LoadedCamera`.
        field: what the pictures show.
    """
    if not assumed or field.name == assumed:
        return ""
    if field.source is not None and not is_builtin_field(field.source):
        return ""
    titles = field_titles()
    return (
        f"nothing says which ground it is of, so that it would be taken for a"
        f" {titles[assumed].lower()} field's, and this is {titles.get(field.name, field.title)}"
    )
