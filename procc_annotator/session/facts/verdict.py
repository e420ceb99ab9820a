"""What a person found when a frame scored badly: whose fault it is, as plain values."""

from __future__ import annotations

import os
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from pathlib import Path

from procc_annotator.language import word


class FaultParty(StrEnum):
    """Who is to blame for what a frame's score says of a camera source."""

    CAMERA = word("camera", "a verdict")
    ANNOTATION = word("annotation", "a verdict")
    FINE = word("fine", "a verdict")


_BY_NAME = "name"  # no format is called so

FAULT_WORDS: dict[FaultParty, str] = {
    FaultParty.CAMERA: word("camera fault", "a verdict"),
    FaultParty.ANNOTATION: word("annotation fault", "a verdict"),
    FaultParty.FINE: word("fine", "a verdict"),
}


@dataclass(frozen=True, slots=True)
class Verdict:
    """Somebody's verdict on a frame under a camera source.

    Attributes:
        source: what the camera source is called.
        place: tells it from another one that is called the same (`place_of`, `place_by_name`).
        time: seconds since 1970, UTC.
    """

    frame: str
    source: str
    place: str
    fault: FaultParty
    author: str
    time: float
    comment: str = ""


@lru_cache(maxsize=256)  # asked for every frame of a list
def place_of(cameras: Path, fmt: str, dataset: Path) -> str:
    """Where a source's cameras lie and how they are read, as ``format:path``.

    The path is relative to the dataset's folder for what lies in it or beside it, so that a dataset
    may be moved with its cameras; otherwise absolute.
    """
    path, root = Path(os.path.realpath(cameras)), Path(os.path.realpath(dataset))
    if path.is_relative_to(root.parent):
        path = Path(os.path.relpath(path, root))
    return f"{fmt}:{path.as_posix()}"


def place_by_name(source: str) -> str:
    """The place of a source of which only the name is known, as in older databases."""
    return f"{_BY_NAME}:{source}"


def path_of(place: str) -> str:
    """The path in a place; empty when only the name is known."""
    kind, _, path = place.partition(":")
    return "" if kind == _BY_NAME else path
