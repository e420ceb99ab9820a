"""In-memory frame metadata: statuses, comments, verdicts, drafts, settings.

Asking costs no disk; what is said is queued for the thread that writes it.
"""

from __future__ import annotations

import math
import time
import uuid
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import TypeVar

from procc_annotator.dataset.database import schema
from procc_annotator.dataset.database.connection import OpenedDatabase
from procc_annotator.dataset.database.schema import SETTING_KEY, Snapshot, Write, write
from procc_annotator.dataset.database.writer import DatabaseWriter
from procc_annotator.dataset.records import (
    Comment,
    FaultParty,
    FrameRecord,
    NotVisible,
    Status,
    Verdict,
    place_by_name,
)

T = TypeVar("T")

_UNTOUCHED = FrameRecord()
_BY_FRAME = ("records", "comments", "drafts", "verdicts", "not_visible")


class MetadataCache:
    """Statuses, comments, verdicts, elements not visible, drafts and settings.

    Belongs to one thread, but for `record`, `records`, ``problem`` and what the writer's thread
    calls. Frames are known by name, which may hold any characters.

    Attributes:
        path: the file; None when everything is in memory only and will be lost.
        author: signs what is said.
    """

    def __init__(
        self, path: Path | None, opened: OpenedDatabase, author: str, notices: tuple[str, ...]
    ) -> None:
        self.path = path
        self.author = author
        self._notices = notices + opened.notices
        self._known = opened.snapshot
        self._session = uuid.uuid4().hex[:16]
        self._seconds: dict[str, float] = {}  # spent in this session
        self._changes = 0
        self._writer = DatabaseWriter(path, opened, self._notify)

    @property
    def notices(self) -> tuple[str, ...]:
        """Return what the user should know of the file, one line each; may grow."""
        return self._notices

    @property
    def problem(self) -> str:
        """Why the latest changes are not written, in one line; empty when they are."""
        return self._writer.problem

    def record(self, frame: str) -> FrameRecord:
        """Return what is remembered about a frame."""
        return self._known.records.get(frame, _UNTOUCHED)

    def records(self) -> Mapping[str, FrameRecord]:
        """All frames about which anything is remembered: a live view."""
        return MappingProxyType(self._known.records)

    def set_status(self, frame: str, status: Status) -> None:
        """Say how far a frame has come."""
        status = Status(status)
        if self.record(frame).status is not status:
            self._put_write(write(schema.SET_STATUS, frame, str(status)))
            self._known.records[frame] = replace(self.record(frame), status=status)

    def commit(self, frame: str) -> None:
        """Declare a frame's clicks final."""
        if not self.record(frame).committed:
            self._put_write(write(schema.SET_COMMITTED, frame, 1))
            self._known.records[frame] = replace(self.record(frame), committed=True)

    def add_seconds(self, frame: str, seconds: float) -> None:
        """Add to the time spent on a frame; what no clock that runs forward says is left out."""
        if not (math.isfinite(seconds) and seconds > 0):
            return
        total = self._seconds[frame] = self._seconds.get(frame, 0.0) + seconds
        self._put_write(write(schema.SET_SECONDS, frame, self._session, total))
        record = self.record(frame)
        self._known.records[frame] = replace(record, seconds=record.seconds + seconds)

    def add_comment(
        self, frame: str, text: str, place: tuple[float, float] | None = None
    ) -> Comment:
        """Remark something on a frame, or on a ``place`` in it (px of the picture)."""
        comment = Comment(uuid.uuid4().hex, frame, self.author, time.time(), text, place=place)
        if place is not None:  # first, so that no other window reads the comment without it
            self._put_write(write(schema.PLACE_COMMENT, comment.id, *place))
        self._put_write(schema.comment_write(comment))
        self._set_comments(frame, (*self.comments(frame), comment))
        return comment

    def comments(self, frame: str) -> tuple[Comment, ...]:
        """A frame's comments, oldest first (in the order written, whatever the clocks said)."""
        return self._known.comments.get(frame, ())

    def resolve_comment(self, comment_id: str, resolved: bool) -> None:
        """Settle a comment, or open it again; an unknown id is ignored."""
        everywhere = (remark for remarks in self._known.comments.values() for remark in remarks)
        found = next((remark for remark in everywhere if remark.id == comment_id), None)
        if found is None:
            return
        settled = replace(found, resolved=bool(resolved))
        self._put_write(schema.comment_write(settled, schema.SET_COMMENT))
        remarks = self.comments(found.frame)
        changed = tuple(settled if remark.id == comment_id else remark for remark in remarks)
        self._set_comments(found.frame, changed)

    def _set_comments(self, frame: str, remarks: tuple[Comment, ...]) -> None:
        self._known.comments[frame] = remarks
        self._known.records[frame] = schema.with_comments(self.record(frame), remarks)

    def comment_text(self, frame: str) -> str:
        """All that was remarked on a frame, to be searched."""
        return "\n".join(remark.text for remark in self.comments(frame))

    def set_verdict(
        self,
        frame: str,
        source: str,
        fault: FaultParty | None,
        comment: str = "",
        *,
        place: str = "",
    ) -> Verdict | None:
        """Set the party at fault for a frame's score under a camera source (its name); None takes
        it back. Where it lies (`verdict.place_of`) is empty when only the name is known."""
        known_as = place_by_name(source)
        found = Verdict(
            frame,
            source,
            place or known_as,
            fault or FaultParty.FINE,
            self.author,
            time.time(),
            comment,
        )
        self._put_verdict(found, withdrawn=fault is None)
        if place and (older := self.verdicts(frame).get(known_as)) is not None:
            self._put_verdict(older, withdrawn=True)
        return None if fault is None else found

    def rename_source(self, place: str, before: str, name: str) -> None:
        """Have the verdicts on the source at a place say its new name.

        Those of which only the name before is known go along: that is where they were shown.
        """
        known_as = place_by_name(before)
        self._put_write(write(schema.RENAME_SOURCE, place, name))
        for of_frame in self.all_verdicts().values():
            found, older = of_frame.get(place), of_frame.get(known_as)
            if found is not None:
                self._keep_verdict(replace(found, source=name), withdrawn=False)
            if older is not None:
                self._put_verdict(older, withdrawn=True)
                if found is None:
                    moved = replace(older, source=name, place=place)
                    self._put_verdict(moved, withdrawn=False)

    def _put_verdict(self, verdict: Verdict, *, withdrawn: bool) -> None:
        self._put_write(schema.verdict_write(verdict, withdrawn=withdrawn))
        self._keep_verdict(verdict, withdrawn=withdrawn)

    def _keep_verdict(self, verdict: Verdict, *, withdrawn: bool) -> None:
        _with_value(
            self._known.verdicts, verdict.frame, verdict.place, None if withdrawn else verdict
        )

    def verdicts(self, frame: str) -> Mapping[str, Verdict]:
        """Return what was found of a frame, by the camera source's place."""
        return MappingProxyType(self._known.verdicts.get(frame, {}))

    def all_verdicts(self) -> dict[str, Mapping[str, Verdict]]:
        """Return what was found of every frame, by frame and the camera source's place."""
        return dict(self._known.verdicts)

    def not_visible(self, frame: str) -> frozenset[str]:
        """The classes of the elements that a person said cannot be seen in a frame."""
        return frozenset(self.is_marked_not_visible(frame))

    def is_marked_not_visible(self, frame: str) -> Mapping[str, NotVisible]:
        """Return who said so, and when, by class."""
        return MappingProxyType(self._known.not_visible.get(frame, {}))

    def set_not_visible(self, frame: str, class_name: str, hidden: bool) -> None:
        """Say that an element cannot be seen in a frame, or take it back."""
        if (class_name in self.is_marked_not_visible(frame)) == hidden:
            return
        mark = NotVisible(frame, class_name, self.author, time.time())
        self._put_write(
            write(schema.SET_NOT_VISIBLE, frame, class_name, int(hidden), self.author, mark.time)
        )
        _with_value(self._known.not_visible, frame, class_name, mark if hidden else None)

    def set_draft(self, frame: str, data: bytes | None) -> None:
        """Keep what is unfinished in a frame, or forget it (None, or nothing in it)."""
        data = data or None
        if self._known.drafts.get(frame) == data:
            return
        self._put_write(write(schema.SET_DRAFT, frame, bytes(data or b"")))
        if data is None:
            self._known.drafts.pop(frame, None)
        else:
            self._known.drafts[frame] = bytes(data)

    def draft(self, frame: str) -> bytes | None:
        """Return what was unfinished in a frame."""
        return self._known.drafts.get(frame)

    def drafts(self) -> tuple[str, ...]:
        """The frames in which something was unfinished."""
        return tuple(self._known.drafts)

    @property
    def last_frame(self) -> str | None:
        """The frame this author examined last."""
        return self._known.meta.get(f"last frame of {self.author}")

    @last_frame.setter
    def last_frame(self, frame: str) -> None:
        key = f"last frame of {self.author}"
        if self._known.meta.get(key) != frame:
            self._put_write(write(schema.SET_META, key, frame))
            self._known.meta[key] = frame

    def setting(self, key: str) -> str | None:
        """Return what the dataset was given under a key; None when nothing is."""
        return self._known.meta.get(SETTING_KEY + key)

    def settings(self) -> dict[str, str]:
        """All that the dataset was given, by key."""
        meta = self._known.meta.items()
        return {k.removeprefix(SETTING_KEY): v for k, v in meta if k.startswith(SETTING_KEY)}

    def set_setting(self, key: str, value: str | None) -> None:
        """Give the dataset a setting, for all its windows; None takes it back."""
        if self.setting(key) == value:
            return
        self._put_write(write(schema.SET_META, SETTING_KEY + key, value))
        if value is None:
            self._known.meta.pop(SETTING_KEY + key, None)
        else:
            self._known.meta[SETTING_KEY + key] = value

    def _put_write(self, write: Write) -> None:
        self._writer.put(write)
        self._changes += 1  # after it is queued, so that no look misses it

    def _take_over(self, found: Snapshot, frames: frozenset[str]) -> None:
        """Have these frames say what the file says; records and comments it does not know stay."""
        known = self._known
        for name in _BY_FRAME:
            kept, there = getattr(known, name), getattr(found, name)
            for frame in frames:
                if frame in there:
                    kept[frame] = there[frame]
                elif name not in ("records", "comments"):
                    kept.pop(frame, None)
        known.meta = found.meta

    # What follows is called by the writer's thread.

    def _notify(self, notices: tuple[str, ...]) -> None:
        self._notices += tuple(line for line in notices if line not in self._notices)

    def _differences(self, found: Snapshot) -> frozenset[str]:
        each = (_differences(getattr(self._known, n), getattr(found, n)) for n in _BY_FRAME)
        return frozenset[str]().union(*each)

    def _settings_changed(self, found: Snapshot) -> frozenset[str]:
        keys = _differences(self._known.meta, found.meta)
        return frozenset(k.removeprefix(SETTING_KEY) for k in keys if k.startswith(SETTING_KEY))


def _with_value(kept: dict[str, dict[str, T]], frame: str, key: str, value: T | None) -> None:
    """Replace (or with None forget) one of a frame's values; its others stay. Each change makes new
    values of the frame, for another thread may read the old ones."""
    others = {name: other for name, other in kept.get(frame, {}).items() if name != key}
    if value is not None:
        others[key] = value
    if others:
        kept[frame] = others
    else:
        kept.pop(frame, None)


def _differences(known: dict[str, T], found: dict[str, T]) -> frozenset[str]:
    known = known.copy()  # another thread may change it
    return frozenset(
        name for name in known.keys() | found.keys() if known.get(name) != found.get(name)
    )
