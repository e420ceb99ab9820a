"""Numbers of files that count in pixels, so that normalised coordinates survive the way there and
back to the last digit."""

from __future__ import annotations

import json
import math
import re
from decimal import Context, Decimal
from fractions import Fraction
from typing import Any

# A float never needs more digits than this to be told from its neighbours.
_FLOAT_DIGITS = 17
# Three more, and the quotient of what is written can only round to the coordinate it came from.
_EXACT = Context(prec=20)
_MOST_DIGITS = 40
_PX_DECIMALS = 10  # as many as people and programs write
_SMALLEST, _LARGEST = 1e-30, 1e15


class WrittenNumber(float):
    """A float that remembers the longer text it stands for."""

    __slots__ = ("text",)
    text: str

    def __new__(cls, text: str) -> WrittenNumber:
        number = super().__new__(cls, text)
        number.text = text
        return number


def parse_number(text: str) -> float:
    """A decimal text as a float; one with more digits than a float holds keeps its text."""
    number = float(text)
    if len(text) <= _FLOAT_DIGITS + 1 or not _SMALLEST < abs(number) < _LARGEST:
        return number
    mantissa = re.split("[eE]", text)[0].replace(".", "").lstrip("+-0")
    return WrittenNumber(text) if _FLOAT_DIGITS < len(mantissa) <= _MOST_DIGITS else number


def normalised(px: float, extent: int) -> float:
    """The coordinate of a pixel position, ``px / extent``, rounded once.

    Args:
        px: int, float, or the number `parse_number` made.
        extent: width - 1 or height - 1, px.

    Returns:
        An int where an int divides without rest, so that a 0 stays a 0.
    """
    if type(px) is int:
        whole, rest = divmod(px, extent)
        return px / extent if rest else whole
    if isinstance(px, WrittenNumber):
        return float(Fraction(px.text) / extent)
    return px / extent


def to_px(coordinate: float, extent: int) -> float:
    """The pixel position of a coordinate, which `normalised` takes back to exactly that coordinate.

    Where no float does, the number carries three digits more than a float has.
    """
    if type(coordinate) is int:
        return coordinate * extent
    px = coordinate * extent
    if (short := round(px, _PX_DECIMALS)) / extent == coordinate:
        return short  # 500.0, not 500.00000000000006
    if px / extent == coordinate or not _SMALLEST < abs(px) < _LARGEST:
        return px
    return WrittenNumber(str(_EXACT.multiply(Decimal(coordinate), Decimal(extent))))


def number_text(number: float) -> str:
    """A number as it is written to a file."""
    return number.text if isinstance(number, WrittenNumber) else repr(number)


def json_text(value: Any, open_levels: int = 2, indent: str = "") -> str:
    """A value as JSON; numbers with their longer text, the outer levels one entry a line.

    Args:
        value: what `json.dumps` takes.
        open_levels: how many levels have their entries on lines of their own.
        indent: in front of the entries of this level.
    """
    if isinstance(value, WrittenNumber):
        return value.text
    if type(value) is int or (type(value) is float and math.isfinite(value)):
        return repr(value)  # as json.dumps does, ten times as fast
    if not value or type(value) not in (dict, list, tuple):
        return json.dumps(value, ensure_ascii=False)
    below = indent + "  "
    if type(value) is dict:
        marks = "{}"
        entries = [
            f"{json.dumps(key, ensure_ascii=False)}: {json_text(entry, open_levels - 1, below)}"
            for key, entry in value.items()
        ]
    else:
        marks = "[]"
        entries = [json_text(entry, open_levels - 1, below) for entry in value]
    if open_levels <= 0:
        return f"{marks[0]}{', '.join(entries)}{marks[1]}"
    lines = ",\n".join(below + entry for entry in entries)
    return f"{marks[0]}\n{lines}\n{indent}{marks[1]}"
