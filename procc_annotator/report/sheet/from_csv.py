"""What `as_csv` wrote, read back."""

from __future__ import annotations

import math

from procc_annotator.io.csv_text import unescape_formula
from procc_annotator.report.sheet.sheet import Column, Value

_YES_NO = {"true": True, "false": False}
_EXPECTED = {
    "whole": "a whole number",
    "number": "a number",
    "yes_no": "true or false",
    "text": "some text",
}


def value_of(column: Column, cell: str) -> Value:
    """The value of a cell; None for an empty one.

    Raises:
        ValueError: the column holds no such values; says what was expected.
    """
    if not cell and not column.required:
        return None
    try:
        if column.kind == "number":
            value = float(cell)
            if math.isfinite(value):
                return value
        elif column.kind == "whole":
            return int(cell)
        elif column.kind == "yes_no":
            return _YES_NO[cell]
        elif cell:
            return unescape_formula(cell)
    except (ValueError, KeyError):
        pass
    raise ValueError(f"{column.key} is {cell[:40]!r}, expected {_EXPECTED[column.kind]}")
