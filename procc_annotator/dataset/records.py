"""Records about frames and points: status, origins, comments, versions, triage verdicts."""

from __future__ import annotations

import getpass
import hashlib
import os
from collections import Counter
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.translation import word


class Status(StrEnum):
    """Progress of a frame's annotation; set by people, never guessed."""

    UNTOUCHED = word("untouched", "a frame")
    IN_PROGRESS = word("in progress", "a frame")
    DONE = word("done", "a frame")
    APPROVED = word("approved", "a frame")
    REJECTED = word("rejected", "a frame")


class OriginKind(StrEnum):
    """Kind of a point's origin."""

    CLICKED = word("clicked", "points")
    SNAPPED = word("snapped", "points")
    REGULARISED = word("regularised", "points")
    COPIED = word("copied", "points")
    MOVED = word("moved", "points")
    SUGGESTED = word("accepted suggestion", "points")
    # Found in the picture without a click, not checked yet.
    PROPOSED = word("proposed", "points")
    ACCEPTED = word("accepted proposal", "points")  # of a camera found without a click, by a person
    # The program looked for paint there and found none.
    UNCONFIRMED = word("unconfirmed by paint", "points")
    # It was there when the file was read: nothing else is known.
    FILE = word("from the file", "points")


@dataclass(frozen=True, slots=True)
class Origin:
    """Author, kind and time of a point's origin (seconds since 1970, UTC)."""

    kind: OriginKind
    author: str
    time: float


# A point's normalised (u, v) exactly as in the annotation is its identity within its frame, so that
# undo, a change of class and splitting an element all keep its origin.
PointKey = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Comment:
    """A remark on a frame, or on a ``place`` in it (x, y in px of the picture); ``time`` in seconds
    since 1970, UTC."""

    id: str
    frame: str
    author: str
    time: float
    text: str
    resolved: bool = False
    place: tuple[float, float] | None = None


@dataclass(frozen=True, slots=True)
class NotVisible:
    """A person's word that an element cannot be seen in a frame; ``time`` in seconds since 1970,
    UTC."""

    frame: str
    class_name: str
    author: str
    time: float


@dataclass(frozen=True, slots=True)
class Version:
    """A kept state of a frame's annotation file; its bytes are fetched by ``id``."""

    id: str
    frame: str
    author: str
    time: float
    reason: str


@dataclass(frozen=True, slots=True)
class FrameRecord:
    """Record of a frame; ``seconds`` is the time spent on it by everybody."""

    status: Status = Status.UNTOUCHED
    committed: bool = False
    seconds: float = 0.0
    open_comments: int = 0
    comments: int = 0


def digest_of(data: bytes) -> bytes:
    """Return what distinguishes two versions (16 bytes)."""
    return hashlib.blake2b(data, digest_size=16).digest()


def default_author() -> str:
    """The name annotations are signed with: ``PROCC_AUTHOR``, else the login name."""
    named = os.environ.get("PROCC_AUTHOR", "").strip()
    if named:
        return named
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):  # no such user (a container), no pwd (Windows)
        return "unknown"


def point_keys(annotation: FrameAnnotation) -> set[PointKey]:
    """The coordinates of every confirmed point."""
    return {(p.u, p.v) for polyline in annotation.polylines for p in polyline.points}


def new_origins(
    before: FrameAnnotation,
    after: FrameAnnotation,
    kind: OriginKind,
    author: str,
    time: float,
    *,
    snapped: Collection[PointKey] = (),
    unseen: Collection[PointKey] = (),
    known: Mapping[PointKey, Origin] | None = None,
) -> dict[PointKey, Origin]:
    """Origins of the points that an edit brought: ``kind``, or snapped where that is listed.

    Points at which paint was looked for and not found (``unseen``) are reported as such, new or
    not.

    Points that were unconfirmed before and are unchanged now were copied. A place that had an
    origin before and is reached again (a point put back) is new again, by anyone who did that.
    """
    taken = {(p.u, p.v) for polyline in before.unconfirmed for p in polyline.points}
    origins: dict[PointKey, Origin] = {}
    for key in point_keys(after) - point_keys(before):
        if key in snapped:
            found = OriginKind.SNAPPED
        elif key in taken:
            was = known.get(key) if known is not None else None
            found = was.kind if was is not None else OriginKind.COPIED
        else:
            found = kind
        origins[key] = Origin(found, author, time)
    for key in unseen:
        origins[key] = Origin(OriginKind.UNCONFIRMED, author, time)
    return origins


def count_points_by_origin(
    annotation: FrameAnnotation, origins: Mapping[PointKey, Origin]
) -> dict[OriginKind, int]:
    """Return how many confirmed points are of each kind; points nothing is known of are from the
    file."""
    counts = Counter(
        origins[key].kind if (key := (p.u, p.v)) in origins else OriginKind.FILE
        for polyline in annotation.polylines
        for p in polyline.points
    )
    return {kind: counts[kind] for kind in OriginKind if counts[kind]}


class FaultParty(StrEnum):
    """Cause of a frame's bad score under a camera source."""

    CAMERA = word("camera", "a verdict")
    ANNOTATION = word("annotation", "a verdict")
    FINE = word("fine", "a verdict")


_BY_NAME = "name"  # no format is called so

FAULT_WORDS: dict[FaultParty, str] = {
    FaultParty.CAMERA: word("camera wrong", "a verdict"),
    FaultParty.ANNOTATION: word("labels wrong", "a verdict"),
    FaultParty.FINE: word("OK", "a verdict"),
}


@dataclass(frozen=True, slots=True)
class Verdict:
    """A person's verdict on a frame under a camera source.

    Attributes:
        source: what the camera source is called.
        place: distinguishes it from another one that is called the same (`place_of`,
            `place_by_name`).
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
    """Return where a source's cameras lie and how they are read, as ``format:path``.

    The path is relative to the dataset's folder for what is in it or next to it, so that a dataset
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
