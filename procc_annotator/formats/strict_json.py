"""Strict JSON decoding (no repeated keys, errors with their place); numbers with all digits."""

from __future__ import annotations

import json
import math
import re
from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeGuard, TypeVar

import msgspec

from procc_annotator.errors import CameraError, InputError

T = TypeVar("T")

_BOM = b"\xef\xbb\xbf"
# What is read must be writable again, also from deep inside a program: Python gives up a writer at
# some depth that depends on who called it.
_DEEPEST = 64
_LONGEST_KEY = 60
_QUOTED = re.compile("`([^`]*)`")


class DuplicateKeyError(ValueError):
    """A JSON object has the same key twice."""


def strip_bom(data: bytes) -> bytes:
    """The bytes behind UTF-8's byte order mark, which some editors write."""
    return data[3:] if data.startswith(_BOM) else data


def utf8_text(data: bytes, path: Path | str, error: type[InputError] = CameraError) -> str:
    """Text of a file, without a byte order mark.

    Raises:
        error: not UTF-8, or with zero bytes.
    """
    at, advice = data.find(b"\0"), "it looks like UTF-16 or a binary file: save it as UTF-8"
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        if at < 0:
            at, advice = problem.start, "save it as UTF-8"
    if at >= 0:
        raise error(path, "is not UTF-8 text", place=f"byte {at}", advice=advice)
    return text


def has_only_keys(data: bytes, keys: int) -> bool:
    """Return whether decoded JSON text certainly holds no more keys, of all its objects together.

    Fast decoders drop all but the last of repeated keys. Each key is followed by a colon; as many
    colons as decoded keys therefore prove that none was dropped. More of them may as well stand in
    texts, so that a False only means to look closer.
    """
    return data.count(b":") == keys


def decode_fast(data: bytes, *, path: str, error: type[InputError]) -> Any:
    """The decoded value at a few microseconds a file.

    Only the keys of the outermost object are counted by `has_only_keys`: give files with objects
    inside to a decoder that knows them.

    Raises:
        error: as `decode_strict` raises it.
    """
    try:
        content = msgspec.json.decode(strip_bom(data))
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        # The slow decoder says line and column, and reads NaN so that its place can be named.
        return decode_strict(data, path=path, error=error)
    flat = data.count(b"[") < _DEEPEST
    if type(content) is dict and flat and has_only_keys(data, len(content)):
        return content
    return decode_strict(data, path=path, error=error)


def decode_strict(
    data: bytes,
    *,
    path: str,
    error: type[InputError],
    parse_float: Callable[[str], float] = float,
) -> Any:
    """The decoded value; a repeated key is an error, NaN and Infinity are let through.

    Raises:
        error: not UTF-8, not JSON, or a repeated key.
    """
    text = _text(data, path, error)
    try:
        content = json.loads(text, object_pairs_hook=_no_repeats, parse_float=parse_float)
        # Half of a surrogate pair can be spelled (\ud83d) but never written as UTF-8 again.
        if "\\u" in text:
            json.dumps(content, ensure_ascii=False).encode()
    except json.JSONDecodeError as problem:
        raise error(
            path,
            f"is not valid JSON: {problem.msg}",
            place=f"line {problem.lineno} column {problem.colno}",
            advice="the file may be cut off: restore it or correct this place",
        ) from problem
    except DuplicateKeyError as problem:
        place = _place_of_repeat(text)
        raise error(path, str(problem), place=place, advice="keep one of them") from problem
    except UnicodeEncodeError as problem:
        raise error(
            path, "holds half a character, as in \\ud83d", advice="correct the text"
        ) from problem
    except RecursionError as problem:
        raise _too_deep(path, error) from problem
    except ValueError as problem:  # an integer of thousands of digits
        raise error(
            path, "holds an integer of thousands of digits, which is not read", advice="correct it"
        ) from problem
    if _is_deep(content):
        raise _too_deep(path, error)
    return content


def decode_as(data: bytes, kind: type[T], what: str, *, path: Path | str) -> T:
    """The decoded value of a known type, without keys that the type does not know. `InputError` if
    it is not UTF-8, not JSON, nested too deeply, or of another type."""
    try:
        return msgspec.json.decode(strip_bom(data), type=kind)
    except (msgspec.DecodeError, UnicodeDecodeError) as problem:
        raise InputError(path, f"is no {what}: {problem}") from problem
    except RecursionError as problem:
        raise _too_deep(path, InputError) from problem


_KINDS = {
    "str": "text", "int": "a whole number", "float": "a number", "bool": "true or false",
    "array": "a list", "object": "an object", "null": "null",
}  # fmt: skip
_PHRASES = (
    ("Object missing required field", "lacks the key"), ("Expected", "expected"),
    (", got", ", found"), ("<=", "at most"), (">=", "at least"),
)  # fmt: skip


def convert_as(value: object, kind: type[T], *, path: Path | str, place: str) -> T:
    """A decoded value as a type of msgspec; keys that the type does not know are left out.

    Raises:
        InputError: it is of another type: the place inside it, and what was expected.
    """
    try:
        return msgspec.convert(value, kind)
    except msgspec.ValidationError as problem:
        text, _, inside = str(problem).partition(" - at `$")
        for theirs, ours in _PHRASES:
            text = text.replace(theirs, ours)
        text = _QUOTED.sub(
            lambda m: " or ".join(_KINDS.get(k, repr(k)) for k in m[1].split(" | ")), text
        )
        advice = "correct the file"
        raise InputError(path, text, place=place + inside[:-1], advice=advice) from problem


def is_finite_number(value: object) -> TypeGuard[float]:
    """Return whether a JSON value is a number that can be computed with (true and false are
    not)."""
    if type(value) is float:
        return math.isfinite(value)
    # An integer with more digits than a float can hold is as useless as infinity.
    return type(value) is int and abs(value) < 1 << 1000


def finite_number(text: str) -> float | None:
    """The number that a text spells as every program reads it; None for any other text.

    Python also reads 1_0 as ten, and digits of every script.
    """
    if not text.isascii() or "_" in text:
        return None
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def json_repr(value: object) -> str:
    """A JSON value in an error message, as the file spells it; long ones cut."""
    return printable(json.dumps(value, ensure_ascii=False), 40)


def is_unicode(text: str) -> bool:
    """Return whether text can be written to a file: the name of a file need not be valid
    Unicode."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def printable(text: str, longest: int = _LONGEST_KEY) -> str:
    """A key or text of a file in an error message: cut, and nothing a terminal would obey."""
    short = text if len(text) <= longest else f"{text[: longest - 3]}..."
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in short)


def json_kind(value: object) -> str:
    """Return what sort of JSON value this is, in words."""
    names = {
        dict: "an object",
        list: "a list",
        str: "text",
        bool: "true or false",
        type(None): "null",
    }
    return names.get(type(value), "a number")


def _text(data: bytes, path: str, error: type[InputError]) -> str:
    if not data.strip(b" \t\r\n\0"):
        raise error(path, "is empty, expected a JSON object", advice="restore it from a backup")
    return utf8_text(data, path, error)


def _no_repeats(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) != len(pairs):
        seen: set[str] = set()
        for key, _ in pairs:
            if key in seen:
                raise DuplicateKeyError(f"the key {printable(key)!r} occurs twice")
            seen.add(key)
    return found


class _KeyValuePairs(list[tuple[str, Any]]):
    """An object as it stands in the file, repeated keys included."""


def _place_of_repeat(text: str) -> str:
    """Return where the object with a repeated key is (``Circle left[3]``).

    Empty for the outermost object, and if undetermined.
    """
    try:
        content = json.loads(text, object_pairs_hook=_KeyValuePairs)
    except (ValueError, RecursionError):  # something further down is wrong as well
        return ""
    waiting: deque[tuple[str, Any]] = deque([("", content)])
    while waiting:
        place, value = waiting.popleft()
        if type(value) is _KeyValuePairs:
            if len(dict(value)) < len(value):
                return printable(place, 3 * _LONGEST_KEY)
            waiting.extend((f"{place}.{key}" if place else key, below) for key, below in value)
        elif type(value) is list:
            waiting.extend((f"{place}[{i}]", below) for i, below in enumerate(value))
    return ""


def _is_deep(content: Any) -> bool:
    level = [content]
    for _ in range(_DEEPEST):
        below: list[Any] = []
        for value in level:
            if type(value) is dict:
                below.extend(value.values())
            elif type(value) is list:
                below.extend(value)
        if not below:
            return False
        level = below
    return True


def _too_deep(path: Path | str, error: type[InputError]) -> InputError:
    return error(path, "is nested too deeply to be read", advice="is it this file?")


# A float never needs more digits than this to be distinguished from its neighbours.
_FLOAT_DIGITS = 17
_MOST_DIGITS = 40
SMALLEST_EXACT, LARGEST_EXACT = 1e-30, 1e15  # numbers whose longer text is kept


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
    if len(text) <= _FLOAT_DIGITS + 1 or not SMALLEST_EXACT < abs(number) < LARGEST_EXACT:
        return number
    mantissa = re.split("[eE]", text)[0].replace(".", "").lstrip("+-0")
    return WrittenNumber(text) if _FLOAT_DIGITS < len(mantissa) <= _MOST_DIGITS else number


def number_text(number: float) -> str:
    """A number as it is written to a file."""
    return number.text if isinstance(number, WrittenNumber) else repr(number)


def json_text(value: Any, open_levels: int = 2, indent: str = "") -> str:
    """A value as JSON; numbers with their longer text, the outer levels one entry a line.

    Args:
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
