"""What is kept of frames beside their files: earlier versions, and elements that wait for a hand.

Annotations never depend on it.
"""

from __future__ import annotations

from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, SaveError
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.soccernet_annotation import (
    read_annotation,
    write_annotation,
)
from procc_annotator.language import word
from procc_annotator.session.database.database import WorkspaceDatabase
from procc_annotator.session.dataset.frame_state import FrameState
from procc_annotator.session.dataset.pending_save import PendingSave, digest


class FrameVersions:
    """Keeps versions and unconfirmed elements of frames, by their names.

    Attributes:
        database: where; None keeps nothing.
    """

    def __init__(self) -> None:
        self.database: WorkspaceDatabase | None = None
        self._kept: dict[str, bytes | None] = {}  # digests of the versions kept last

    def with_unconfirmed(
        self, frame: str, annotation: FrameAnnotation, field: Field
    ) -> FrameAnnotation:
        """The annotation with what was copied here earlier and still waits for a hand."""
        if self.database is None:
            return annotation
        kept = self.database.draft(frame)
        if kept is None:
            return annotation
        try:
            waiting = read_annotation(kept, path="unconfirmed elements", field=field)
        except InputError:
            return annotation  # a damaged memory costs the proposals only, never an annotation
        known = set(annotation.annotated)
        polylines = tuple(p for p in waiting.polylines if p.class_name not in known)
        return replace(annotation, unconfirmed=polylines)

    def keep_unconfirmed(self, frame: str, state: FrameState) -> None:
        """Keep what waits for a hand, unless it is kept already."""
        waiting = state.history.current.unconfirmed
        if (drawn := state.under_way) is not None:
            waiting = (*(p for p in waiting if p.class_name != drawn.class_name), drawn)
        if self.database is None or waiting == state.kept_unconfirmed:
            return
        state.kept_unconfirmed = waiting
        data = write_annotation(FrameAnnotation(waiting)) if waiting else None
        self.database.set_draft(frame, data)

    def keep_found(self, frame: str, pending: PendingSave) -> bool:
        """Keep what a file holds before it is replaced; whether that is new."""
        try:
            found = pending.check()
        except SaveError:
            return False  # writing says so
        return found is not None and self.keep(frame, found, word("as it was found"))

    def keep(self, frame: str, data: bytes, reason: str) -> bool:
        """Keep a version, unless it is the one that was kept last; from any thread."""
        if self.database is None or self._kept.get(frame) == (kept := digest(data)):
            return False
        self.database.add_version(frame, data, reason)
        self._kept[frame] = kept
        return True

    def flush(self) -> None:
        """Have what was kept on the disk, as far as anything can be written."""
        if self.database is not None and not self.database.problem:
            self.database.flush()
