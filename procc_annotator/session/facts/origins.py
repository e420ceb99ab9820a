"""What the workspace's memory knows of frames and points, as plain values."""

from __future__ import annotations

import getpass
import hashlib
import os
from dataclasses import dataclass
from enum import StrEnum


class Status(StrEnum):
    """How far a frame's annotation has come; set by people, never guessed."""

    UNTOUCHED = "untouched"
    IN_PROGRESS = "in progress"
    DONE = "done"
    APPROVED = "approved"
    REJECTED = "rejected"


class OriginKind(StrEnum):
    """How a point came to be where it is."""

    CLICKED = "clicked"
    SNAPPED = "snapped"
    REGULARISED = "regularised"
    COPIED = "copied"
    MOVED = "moved"
    SUGGESTED = "accepted suggestion"
    FILE = "from the file"  # it was there when the file was read: nothing else is known


@dataclass(frozen=True, slots=True)
class Origin:
    """Who put a point where it is, how, and when (seconds since 1970, UTC)."""

    kind: OriginKind
    author: str
    time: float


# A point's normalised (u, v) exactly as in the annotation is its identity within its frame, so that
# undo, a change of class and splitting an element all keep its origin.
PointKey = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Comment:
    """A remark on a frame; ``time`` in seconds since 1970, UTC."""

    id: str
    frame: str
    author: str
    time: float
    text: str
    resolved: bool = False


@dataclass(frozen=True, slots=True)
class NotVisible:
    """Somebody's word that an element cannot be seen in a frame; ``time`` in seconds since 1970,
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
    """What is remembered about a frame; ``seconds`` is the time spent on it by everybody."""

    status: Status = Status.UNTOUCHED
    committed: bool = False
    seconds: float = 0.0
    open_comments: int = 0
    comments: int = 0


def digest_of(data: bytes) -> bytes:
    """What tells two versions apart (16 bytes)."""
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
