"""Blind mode: who locked a dataset to it, and which clicks no camera was shown to.

What was committed is known by its points. So it does not matter how a frame is edited afterwards
(in this window, in another one, by an import or another program), and taking an edit back makes the
frame blind work again.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from enum import StrEnum

import msgspec

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.session.facts.frame_check import content_of

# What these are kept under with the dataset; a commit with the frame's name behind it.
_COMMIT_SETTING = "blind commit of "


class BlindStatus(StrEnum):
    """What may be said of a frame's clicks."""

    UNKNOWN = ""  # not committed in blind mode: cameras may have been shown all along
    BLIND = "blind"
    EDITED = "edited after the cameras were shown"


@dataclass(frozen=True, slots=True)
class BlindCommit:
    """The first time that a frame was committed, which was in blind mode.

    Attributes:
        author: who did it.
        time: seconds since 1970, UTC.
        content: of what was committed, see `content_of`; empty if that is not known any more.
    """

    author: str
    time: float
    content: str

    def work(self, annotation: FrameAnnotation) -> BlindStatus:
        """Whether a frame that holds this annotation now is still what was committed."""
        same = self.content == content_of(annotation)
        return BlindStatus.BLIND if same else BlindStatus.EDITED


def setting_of(frame: str) -> str:
    """What a frame's commit is kept under with the dataset."""
    return _COMMIT_SETTING + frame


def read_commit(text: str | None) -> BlindCommit | None:
    """The commit that `write_commit` wrote; None for none. Of a damaged text nothing is known but
    that there was one."""
    if text is None:
        return None
    try:
        return msgspec.json.decode(text, type=BlindCommit)
    except msgspec.DecodeError:
        return BlindCommit("", 0.0, "")


def write_commit(commit: BlindCommit) -> str:
    """The text that `read_commit` reads."""
    return json.dumps(asdict(commit), ensure_ascii=False)


def blind_status(text: str | None, annotation: FrameAnnotation) -> BlindStatus:
    """What may be said of a frame's clicks.

    Args:
        text: what is kept under `setting_of` the frame.
        annotation: of the frame, as it is now.
    """
    commit = read_commit(text)
    return commit.work(annotation) if commit is not None else BlindStatus.UNKNOWN


LOCK_SETTING = "blind lock"  # what it is kept under with the dataset


@dataclass(frozen=True, slots=True)
class LockEvent:
    """The dataset was locked to blind mode, or unlocked.

    Attributes:
        time: seconds since 1970, UTC.
    """

    locked: bool
    author: str
    time: float


def read_events(text: str | None) -> tuple[LockEvent, ...]:
    """What happened, oldest first. A text that cannot be read is a lock by nobody known: whoever
    may not see the fit must not come to see it through a damaged entry."""
    if text is None:
        return ()
    try:
        return tuple(msgspec.json.decode(text, type=list[LockEvent]))
    except msgspec.DecodeError:
        return (LockEvent(True, "", 0.0),)


def write_events(events: Sequence[LockEvent]) -> str:
    """The text that `read_events` reads."""
    return json.dumps([asdict(event) for event in events], ensure_ascii=False)


def lock_of(events: Sequence[LockEvent]) -> LockEvent | None:
    """The lock that holds now, if one does."""
    return events[-1] if events and events[-1].locked else None
