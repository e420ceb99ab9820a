"""What a column of the workspace database may hold, and as what it comes out again.

Text is stored as TEXT, or as a BLOB where it is no valid Unicode (names of files may be anything).
"""

from __future__ import annotations

import math

from procc_annotator.session.facts.origins import OriginKind, Status
from procc_annotator.session.facts.verdict import Fault

Value = str | bytes | float | int | None
Row = tuple[Value, ...]

_STATUSES: dict[Value, Status] = {str(status): status for status in Status}
_KINDS: dict[Value, OriginKind] = {str(kind): kind for kind in OriginKind}
_FAULTS: dict[Value, Fault | None] = {"": None, **{str(fault): fault for fault in Fault}}


class DamagedError(Exception):
    """A row holds what this program never wrote."""


def stored(text: str) -> str | bytes:
    """Text as it is bound to a statement; any Python string survives the way there and back."""
    if text.isascii():
        return text
    try:
        text.encode()
    except UnicodeEncodeError:  # lone surrogates: undecodable bytes of a file's name
        return text.encode("utf-8", "surrogatepass")
    return text


def as_text(value: Value) -> str:
    """The way back from `stored`.

    Raises:
        DamagedError: it is no text.
    """
    if isinstance(value, str):
        return value
    if isinstance(value, bytes):
        try:
            return value.decode("utf-8", "surrogatepass")
        except UnicodeDecodeError as error:
            raise DamagedError("a text that is none") from error
    raise DamagedError("a text that is none")


def as_text_or_none(value: Value) -> str | None:
    """The same for what may have been taken back.

    Raises:
        DamagedError: it is something else.
    """
    return None if value is None else as_text(value)


def as_number(value: Value) -> float:
    """A finite number.

    Raises:
        DamagedError: it is none.
    """
    if type(value) is float and math.isfinite(value):
        return value
    if type(value) is int:
        return float(value)
    raise DamagedError("a number that is none")


def as_bytes(value: Value) -> bytes:
    """Bytes.

    Raises:
        DamagedError: it is something else.
    """
    if isinstance(value, bytes):
        return value
    raise DamagedError("contents that are none")


def as_status(value: Value) -> Status | None:
    """A status, or None when nobody has set one.

    Raises:
        DamagedError: it is none.
    """
    if value is None:
        return None
    if value not in _STATUSES:
        raise DamagedError("a status that is none")
    return _STATUSES[value]


def as_kind(value: Value) -> OriginKind:
    """A kind of origin.

    Raises:
        DamagedError: it is none.
    """
    if value not in _KINDS:
        raise DamagedError("an origin that is none")
    return _KINDS[value]


def as_fault(value: Value) -> Fault | None:
    """A verdict's fault, or None when it was taken back.

    Raises:
        DamagedError: it is none.
    """
    if value not in _FAULTS:
        raise DamagedError("a verdict that is none")
    return _FAULTS[value]
