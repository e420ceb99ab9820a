"""Which line of a field file an error is about, so that an editor can go there."""

from __future__ import annotations

import re
import tomllib
from itertools import pairwise

from procc_annotator.field.words import short_repr

_HEADER_PATTERN = re.compile(r"\s*\[{1,2}\s*([^\]]+?)\s*\]{1,2}\s*(#.*)?$")
_MAX_HEADER_LENGTH = 200  # looking at longer lines would take time by their square
_ELEMENT_PATTERN = re.compile(r"element ('(?:[^'\\]|\\.)*'|\"(?:[^\"\\]|\\.)*\"|\d+)")


def line_number_of(text: str, place: str) -> int | None:
    """The line of a place that an error of `field.reading` names, counted from 1.

    Args:
        text: the file.
        place: as ``element 'Net'.start[2]``, ``dimensions.length``, ``symmetries[0]``.

    Returns:
        The line of the key, else of the element or table; None where the file gives no hint.
    """
    lines = text.splitlines()
    blocks = _table_blocks(lines)
    if found := _ELEMENT_PATTERN.match(place):
        return _line_in_element(lines, blocks, found[1], _key_in_line(place[found.end() :].lstrip(".")))
    table, dot, rest = place.partition(".")
    for header, start, end in blocks:
        if dot and header == table:
            return _line_of_key(lines, start, end, _key_in_line(rest))
        if not dot and header == "" and (line := _line_of_key(lines, start, end, _key_in_line(table))):
            return line
        if not dot and header == table != "":
            return start + 1
    return None


def _table_blocks(lines: list[str]) -> list[tuple[str, int, int]]:
    """(header, first line, line behind the last) of each table, the keys before any as ""."""
    short = [(i, line) for i, line in enumerate(lines) if len(line) <= _MAX_HEADER_LENGTH]
    heads = [(i, found[1]) for i, line in short if (found := _HEADER_PATTERN.match(line))]
    marks = [(0, ""), *heads, (len(lines), "")]
    return [(header, start, end) for (start, header), (end, _) in pairwise(marks)]


def _line_in_element(
    lines: list[str], blocks: list[tuple[str, int, int]], wanted: str, key: str
) -> int | None:
    elements = [(start, end) for header, start, end in blocks if header == "elements"]
    if wanted.isdigit():
        chosen = elements[int(wanted) - 1 : int(wanted)]
    else:  # of two elements with one name the later one is wrong
        chosen = [
            (start, end) for start, end in elements if short_repr(_block_name(lines[start:end])) == wanted
        ][-1:]
    if not chosen:
        return None
    ((start, end),) = chosen
    return _line_of_key(lines, start, end, key) or start + 1


def _block_name(block: list[str]) -> object:
    for line in block:
        if re.match(r"\s*name\s*=", line):
            try:
                return tomllib.loads(line)["name"]
            except ValueError:  # a text of several lines
                return None
    return None


def _line_of_key(lines: list[str], start: int, end: int, key: str) -> int | None:
    if not key:
        return None
    pattern = re.compile(rf"\s*[\"']?{re.escape(key)}[\"']?\s*[=.]")
    return next((i + 1 for i in range(start, end) if pattern.match(lines[i])), None)


def _key_in_line(rest: str) -> str:
    return re.split(r"[.\[]", rest, maxsplit=1)[0]
