"""What is kept in memory of the workspace database, so that asking for it costs no disk."""

from __future__ import annotations

import uuid
from collections.abc import Iterator
from dataclasses import replace
from typing import TypeVar

from procc_annotator.session.database import database_rows as rows
from procc_annotator.session.database.database_rows import Snapshot, Write
from procc_annotator.session.database.database_values import stored
from procc_annotator.session.facts.origins import Comment, FrameRecord, NotVisible, Status
from procc_annotator.session.facts.verdict import Verdict

T = TypeVar("T")

_UNTOUCHED = FrameRecord()


class Memory:
    """Records, comments, drafts, verdicts and elements not visible by frame, texts by key, and what
    this session added to them.

    Changed by one thread; `differences` and `restoring` may be called by another meanwhile.
    """

    def __init__(self, snapshot: Snapshot) -> None:
        self.records = snapshot.records
        self.comments = snapshot.comments
        self.drafts = snapshot.drafts
        self.meta = snapshot.meta
        self.verdicts = snapshot.verdicts
        self.not_visible = snapshot.not_visible
        self._session = uuid.uuid4().hex[:16]
        self._seconds: dict[str, float] = {}  # spent in this session

    def record(self, frame: str) -> FrameRecord:
        """What is known of a frame."""
        return self.records.get(frame, _UNTOUCHED)

    def add_seconds(self, frame: str, seconds: float) -> Write:
        """Add to the time spent on a frame; what is to be written."""
        total = self._seconds[frame] = self._seconds.get(frame, 0.0) + seconds
        record = self.record(frame)
        self.records[frame] = replace(record, seconds=record.seconds + seconds)
        return rows.seconds_write(frame, self._session, total)

    def set_comments(self, frame: str, remarks: tuple[Comment, ...]) -> None:
        """Replace a frame's comments, and count them."""
        self.comments[frame] = remarks
        self.records[frame] = rows.with_comments(self.record(frame), remarks)

    def set_verdict(self, verdict: Verdict, *, withdrawn: bool) -> None:
        """Replace what was found of a frame under a source; the frame's others stay."""
        others = dict(self.verdicts.get(verdict.frame, {}))
        others.pop(verdict.place, None)
        if not withdrawn:
            others[verdict.place] = verdict
        if others:
            self.verdicts[verdict.frame] = others
        else:
            self.verdicts.pop(verdict.frame, None)

    def set_not_visible(self, mark: NotVisible, *, withdrawn: bool) -> None:
        """Replace what was said of an element of a frame; the frame's others stay."""
        others = dict(self.not_visible.get(mark.frame, {}))
        others.pop(mark.class_name, None)
        if not withdrawn:
            others[mark.class_name] = mark
        if others:
            self.not_visible[mark.frame] = others
        else:
            self.not_visible.pop(mark.frame, None)

    def find_comment(self, comment_id: str) -> Comment | None:
        """The comment of this id."""
        everywhere = (remark for remarks in self.comments.values() for remark in remarks)
        return next((remark for remark in everywhere if remark.id == comment_id), None)

    def differences(self, found: Snapshot) -> frozenset[str]:
        """The frames of which the file says something else."""
        return (
            _differences(self.records.copy(), found.records)
            | _differences(self.comments.copy(), found.comments)
            | _differences(self.drafts.copy(), found.drafts)
            | _differences(self.verdicts.copy(), found.verdicts)
            | _differences(self.not_visible.copy(), found.not_visible)
        )

    def take(self, found: Snapshot, frames: frozenset[str]) -> None:
        """Have these frames say what the file says; what it does not know stays."""
        for frame in frames:
            if frame in found.records:
                self.records[frame] = found.records[frame]
            if frame in found.comments:
                self.comments[frame] = found.comments[frame]
            self.drafts.pop(frame, None)
            if frame in found.drafts:
                self.drafts[frame] = found.drafts[frame]
            self.verdicts.pop(frame, None)
            if frame in found.verdicts:
                self.verdicts[frame] = found.verdicts[frame]
            self.not_visible.pop(frame, None)
            if frame in found.not_visible:
                self.not_visible[frame] = found.not_visible[frame]
        self.meta = found.meta

    def restoring(self, found: Snapshot) -> Iterator[Write]:
        """All that must be written into a file begun anew, which says what was found."""
        records = self.records.copy()
        for name, record in records.items():
            if record.status is not Status.UNTOUCHED:
                yield Write(rows.SET_STATUS, ((stored(name), str(record.status)),))
            if record.committed:
                yield Write(rows.SET_COMMITTED, ((stored(name), 1),))
            # What this session spent is written as such, and never is anything counted twice.
            there = found.records.get(name, _UNTOUCHED).seconds
            missing = record.seconds - self._seconds.get(name, 0.0) - there
            if missing > 0:
                yield rows.seconds_write(name, "before", missing)
        for remarks in self.comments.copy().values():
            for remark in remarks:
                yield rows.comment_write(remark, rows.SET_COMMENT)
        for name, data in self.drafts.copy().items():
            yield rows.draft_write(name, data)
        for verdicts in self.verdicts.copy().values():
            for verdict in verdicts.values():
                yield rows.verdict_write(verdict)
        for marks in self.not_visible.copy().values():
            for mark in marks.values():
                yield rows.not_visible_write(mark)
        meta = self.meta.copy()
        yield Write(rows.SET_META, tuple((stored(k), stored(v)) for k, v in meta.items()))


def _differences(known: dict[str, T], found: dict[str, T]) -> frozenset[str]:
    return frozenset(
        name for name in known.keys() | found.keys() if known.get(name) != found.get(name)
    )
