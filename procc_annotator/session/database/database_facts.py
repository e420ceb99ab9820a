"""What is kept in memory of the workspace database, said and asked frame by frame.

Asking costs no disk; what is said is queued to be written.
"""

from __future__ import annotations

import math
import time
import uuid
from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from procc_annotator.session.database import database_rows as rows
from procc_annotator.session.database.database_memory import Memory
from procc_annotator.session.database.database_rows import SETTING_KEY, Snapshot, Write
from procc_annotator.session.database.database_values import stored
from procc_annotator.session.database.database_writer import DatabaseWriter
from procc_annotator.session.facts.origins import Comment, FrameRecord, NotVisible, Status
from procc_annotator.session.facts.verdict import Fault, Verdict, by_name


class DatabaseFacts:
    """Statuses, comments, verdicts, elements not visible, drafts and settings.

    Belongs to one thread, but for `record` and `records`. Frames are known by name, which may hold
    any characters.

    Attributes:
        author: signs what is said.
    """

    def __init__(self, author: str, memory: Memory, writer: DatabaseWriter) -> None:
        self.author = author
        self._memory = memory
        self._writer = writer
        self._changes = 0

    def record(self, frame: str) -> FrameRecord:
        """What is remembered about a frame."""
        return self._memory.record(frame)

    def records(self) -> Mapping[str, FrameRecord]:
        """All frames about which anything is remembered: a live view."""
        return MappingProxyType(self._memory.records)

    def set_status(self, frame: str, status: Status) -> None:
        """Say how far a frame has come."""
        status = Status(status)
        if self.record(frame).status is not status:
            self._put_write(Write(rows.SET_STATUS, ((stored(frame), str(status)),)))
            self._memory.records[frame] = replace(self.record(frame), status=status)

    def set_committed(self, frame: str, committed: bool) -> None:
        """Say whether a frame's clicks were declared final."""
        if self.record(frame).committed != committed:
            self._put_write(Write(rows.SET_COMMITTED, ((stored(frame), int(committed)),)))
            self._memory.records[frame] = replace(self.record(frame), committed=bool(committed))

    def add_seconds(self, frame: str, seconds: float) -> None:
        """Add to the time spent on a frame; what no clock that runs forward says is left out."""
        if not (math.isfinite(seconds) and seconds > 0):
            return
        self._put_write(self._memory.add_seconds(frame, seconds))

    def add_comment(self, frame: str, text: str) -> Comment:
        """Remark something on a frame."""
        comment = Comment(uuid.uuid4().hex, frame, self.author, time.time(), text)
        self._put_write(rows.comment_write(comment))
        self._memory.set_comments(frame, (*self.comments(frame), comment))
        return comment

    def comments(self, frame: str) -> tuple[Comment, ...]:
        """A frame's comments, oldest first (in the order written, whatever the clocks said)."""
        return self._memory.comments.get(frame, ())

    def resolve_comment(self, comment_id: str, resolved: bool) -> None:
        """Settle a comment, or open it again; nothing happens when there is none of this id."""
        found = self._memory.find_comment(comment_id)
        if found is None:
            return
        settled = replace(found, resolved=bool(resolved))
        self._put_write(rows.comment_write(settled, rows.SET_COMMENT))
        remarks = self.comments(found.frame)
        changed = tuple(settled if remark.id == comment_id else remark for remark in remarks)
        self._memory.set_comments(found.frame, changed)

    def comment_text(self, frame: str) -> str:
        """All that was remarked on a frame, to be searched."""
        return "\n".join(remark.text for remark in self.comments(frame))

    def set_verdict(
        self, frame: str, source: str, fault: Fault | None, comment: str = "", *, place: str = ""
    ) -> Verdict | None:
        """Say whose fault a frame's score is under a camera source; None takes it back.

        Args:
            source: its name.
            place: where it lies (`verdict.place_of`); empty when only the name is known.
        """
        known_as = by_name(source)
        found = Verdict(
            frame, source, place or known_as, fault or Fault.FINE, self.author, time.time(), comment
        )
        self._put_verdict(found, withdrawn=fault is None)
        if place and (older := self.verdicts(frame).get(known_as)) is not None:
            self._put_verdict(older, withdrawn=True)
        return None if fault is None else found

    def rename_source(self, place: str, before: str, name: str) -> None:
        """Have the verdicts on the source at a place say its new name.

        Those of which only the name before is known go along: that is where they were shown.
        """
        known_as = by_name(before)
        self._put_write(Write(rows.RENAME_SOURCE, ((stored(place), stored(name)),)))
        for of_frame in self.all_verdicts().values():
            found, older = of_frame.get(place), of_frame.get(known_as)
            if found is not None:
                self._memory.set_verdict(replace(found, source=name), withdrawn=False)
            if older is not None:
                self._put_verdict(older, withdrawn=True)
                if found is None:
                    moved = replace(older, source=name, place=place)
                    self._put_verdict(moved, withdrawn=False)

    def _put_verdict(self, verdict: Verdict, *, withdrawn: bool) -> None:
        self._put_write(rows.verdict_write(verdict, withdrawn=withdrawn))
        self._memory.set_verdict(verdict, withdrawn=withdrawn)

    def verdicts(self, frame: str) -> Mapping[str, Verdict]:
        """What was found of a frame, by the camera source's place."""
        return MappingProxyType(self._memory.verdicts.get(frame, {}))

    def all_verdicts(self) -> dict[str, Mapping[str, Verdict]]:
        """What was found of every frame, by frame and the camera source's place."""
        return dict(self._memory.verdicts)

    def not_visible(self, frame: str) -> frozenset[str]:
        """The classes of the elements that somebody said cannot be seen in a frame."""
        return frozenset(self.marks_not_visible(frame))

    def marks_not_visible(self, frame: str) -> Mapping[str, NotVisible]:
        """Who said so, and when, by class."""
        return MappingProxyType(self._memory.not_visible.get(frame, {}))

    def set_not_visible(self, frame: str, class_name: str, hidden: bool) -> None:
        """Say that an element cannot be seen in a frame, or take it back."""
        if (class_name in self.marks_not_visible(frame)) == hidden:
            return
        mark = NotVisible(frame, class_name, self.author, time.time())
        self._put_write(rows.not_visible_write(mark, withdrawn=not hidden))
        self._memory.set_not_visible(mark, withdrawn=not hidden)

    def set_draft(self, frame: str, data: bytes | None) -> None:
        """Keep what is unfinished in a frame, or forget it (None, or nothing in it)."""
        data = data or None
        if self._memory.drafts.get(frame) == data:
            return
        self._put_write(rows.draft_write(frame, data))
        if data is None:
            self._memory.drafts.pop(frame, None)
        else:
            self._memory.drafts[frame] = bytes(data)

    def draft(self, frame: str) -> bytes | None:
        """What was unfinished in a frame."""
        return self._memory.drafts.get(frame)

    def drafts(self) -> tuple[str, ...]:
        """The frames in which something was unfinished."""
        return tuple(self._memory.drafts)

    @property
    def last_frame(self) -> str | None:
        """The frame this author looked at last."""
        return self._memory.meta.get(f"last frame of {self.author}")

    @last_frame.setter
    def last_frame(self, frame: str) -> None:
        key = f"last frame of {self.author}"
        if self._memory.meta.get(key) != frame:
            self._put_write(rows.meta_write(key, frame))
            self._memory.meta[key] = frame

    def setting(self, key: str) -> str | None:
        """What the dataset was given under a key; None when nothing is."""
        return self._memory.meta.get(SETTING_KEY + key)

    def settings(self) -> dict[str, str]:
        """All that the dataset was given, by key."""
        meta = self._memory.meta.items()
        return {k.removeprefix(SETTING_KEY): v for k, v in meta if k.startswith(SETTING_KEY)}

    def set_setting(self, key: str, value: str | None) -> None:
        """Give the dataset a setting, for all its windows; None takes it back."""
        if self.setting(key) == value:
            return
        self._put_write(rows.meta_write(SETTING_KEY + key, value))
        if value is None:
            self._memory.meta.pop(SETTING_KEY + key, None)
        else:
            self._memory.meta[SETTING_KEY + key] = value

    def _settings_changed(self, found: Snapshot) -> frozenset[str]:
        """The settings of which the file says something else; may be called by another thread."""
        known = self._memory.meta.copy()
        keys = known.keys() | found.meta.keys()
        return frozenset(
            key.removeprefix(SETTING_KEY)
            for key in keys
            if key.startswith(SETTING_KEY) and known.get(key) != found.meta.get(key)
        )

    def _put_write(self, write: Write) -> None:
        self._writer.put(write)
        self._changes += 1  # after it is queued, so that no look misses it
