"""Decode JSON strictly: UTF-8, one value, no key twice; every problem names its place."""

from __future__ import annotations

import json
import math
from typing import Any

import msgspec

from procc_annotator.errors import InputError

_BOM = b"\xef\xbb\xbf"


class DuplicateKeyError(ValueError):
    """A JSON object has the same key twice."""


def decode_fast(data: bytes, *, path: str, error: type[InputError]) -> Any:
    """The decoded value at a few microseconds a file; repeated keys go unnoticed.

    Raises:
        error: as `decode_strict` raises it.
    """
    try:
        return msgspec.json.decode(data[3:] if data.startswith(_BOM) else data)
    except (msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        # The slow decoder tells line and column, and reads NaN so that its place can be named.
        return decode_strict(data, path=path, error=error)


def decode_strict(data: bytes, *, path: str, error: type[InputError]) -> Any:
    """The decoded value; a repeated key is an error, NaN and Infinity are let through.

    Raises:
        error: not UTF-8, not JSON, or a repeated key.
    """
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as problem:
        raise error(
            path,
            "is not UTF-8 text",
            place=f"byte {problem.start}",
            advice="save it as UTF-8",
        ) from problem
    if not text.strip():
        raise error(path, "is empty, expected a JSON object", advice="restore it from a backup")
    try:
        return json.loads(text, object_pairs_hook=_no_repeats)
    except json.JSONDecodeError as problem:
        raise error(
            path,
            f"is not valid JSON: {problem.msg}",
            place=f"line {problem.lineno} column {problem.colno}",
            advice="the file may be cut off",
        ) from problem
    except DuplicateKeyError as problem:
        raise error(path, str(problem), advice="keep one of them") from problem
    except RecursionError as problem:
        raise error(path, "is nested too deeply to be read") from problem


def _no_repeats(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(pairs)
    if len(found) != len(pairs):
        seen: set[str] = set()
        for key, _ in pairs:
            if key in seen:
                raise DuplicateKeyError(f"the key {key!r} occurs twice")
            seen.add(key)
    return found


def is_finite_number(value: object) -> bool:
    """Whether a JSON value is a number that can be computed with (true and false are not)."""
    kind = type(value)
    if kind is float:
        return math.isfinite(value)  # type: ignore[arg-type]
    # An integer with more digits than a float can hold is as useless as infinity.
    return kind is int and abs(value) < 1 << 1000  # type: ignore[arg-type]
