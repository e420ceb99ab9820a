"""What a person found when a frame scored badly: whose fault it is, as plain values."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Fault(StrEnum):
    """Who is to blame for what a frame's score says of a camera source."""

    CAMERA = "camera"
    ANNOTATION = "annotation"
    FINE = "fine"


FAULT_WORDS: dict[Fault, str] = {
    Fault.CAMERA: "camera fault",
    Fault.ANNOTATION: "annotation fault",
    Fault.FINE: "fine",
}


@dataclass(frozen=True, slots=True)
class Verdict:
    """Somebody's verdict on a frame under a camera source; ``time`` in seconds since 1970, UTC."""

    frame: str
    source: str
    fault: Fault
    author: str
    time: float
    comment: str = ""
