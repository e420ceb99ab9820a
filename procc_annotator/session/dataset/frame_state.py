"""What happened to a frame in this session: its history, and what its file held last."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.errors import InputError, SaveError
from procc_annotator.language import word
from procc_annotator.session.dataset.frames import Frame
from procc_annotator.session.dataset.history import History
from procc_annotator.session.dataset.pending_save import PendingSave

EMPTY = FrameAnnotation()


class FrameState:
    """What happened to a frame in this session.

    Attributes:
        history: its annotations; the current one is what is shown.
        error: why the annotation file cannot be used; the frame cannot be edited then.
        save_error: why the last save failed; None once one succeeded.
        kept_unconfirmed: the unconfirmed elements that are remembered beside the file.
        under_way: what is being drawn, kept beside the file like what is unconfirmed.
        digest: of the file as it was read or written last; None where there was none.
        made_here: whether whatever file there is was made in this session.
        attempted: digests of what writes that failed may have left in the file; none if it is known
            to be as it was.
        being_written: whether a thread is at its file: what that holds is known once it told.
    """

    def __init__(self, annotation: FrameAnnotation, digest: bytes | None) -> None:
        self.history = History(annotation)
        self.error: InputError | None = None
        self.save_error: SaveError | None = None
        self.kept_unconfirmed = annotation.unconfirmed
        self.under_way: Polyline | None = None
        self._on_disk = annotation
        self.digest = digest
        self.made_here = digest is None
        self.attempted: frozenset[bytes | None] = frozenset()
        self.being_written = False

    @property
    def counts(self) -> bool:
        """Whether the frame belongs to the figures of a set: a frame without a file does not, one
        with a file does even if nothing is in it, as for `evaluate`."""
        if self.error is not None:
            return False
        return self.digest is not None or bool(self.history.current.annotated)

    @property
    def is_undone(self) -> bool:
        """Whether a file that was made here would hold nothing any more."""
        made = self.made_here and (self.digest is not None or bool(self.attempted))
        return made and self.history.current.same_content(EMPTY)

    @property
    def dirty(self) -> bool:
        """Whether what is shown differs from the file, or may do so."""
        unsure = self.being_written or bool(self.attempted)
        return unsure or not self.history.current.same_content(self._on_disk)

    def rename(self, name_of: Callable[[str], str]) -> None:
        """Spell the classes of every step as another field does."""
        self.history.change_all(lambda annotation: annotation.renamed(name_of))
        self._on_disk = self._on_disk.renamed(name_of)
        self.kept_unconfirmed = self.history.current.unconfirmed

    def stored(self, annotation: FrameAnnotation, digest: bytes | None) -> None:
        """Take down what the file holds now."""
        self._on_disk, self.digest, self.save_error = annotation, digest, None
        self.attempted = frozenset()


def pending_of(index: int, frame: Frame, state: FrameState, root: Path) -> PendingSave:
    """What is to be written of a frame as it is now.

    Args:
        root: the dataset. Links may lead anywhere within it, or within the folder chosen for
            annotations.
    """
    path = frame.annotation_path
    removes = state.is_undone and not path.is_symlink()
    return PendingSave(
        index,
        path,
        frame.image_path.parent,
        root if path.is_relative_to(root) else path.parent,
        state.digest,
        state.history.current,
        state.history.undo_label or (word("taken back") if removes else word("saved")),
        removes,
        state.attempted,
    )
