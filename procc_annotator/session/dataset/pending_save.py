"""One annotation on its way to its file: what a thread of its own can check and write."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import AnnotationError, ChangedOnDiskError, InputError, SaveError
from procc_annotator.io.annotation_files.soccernet_annotation import write_annotation
from procc_annotator.io.atomic import make_folder, remove, write_atomic
from procc_annotator.io.source import read_optional
from procc_annotator.session.dataset.file_stamps import Stamp, stamp_of

_TOGETHER = 8  # most of a save is waiting for the disk, which takes several at a time


@dataclass(frozen=True)
class PendingSave:
    """What a frame's file is to hold. Knows only files, so any thread may write it.

    Attributes:
        index: the frame.
        path: its annotation file.
        image_folder: where its picture lies.
        inside: links are not followed out of this folder.
        expected: digest of what was read from or written to the file last; None without a file.
        annotation: the new content.
        reason: what the version is called.
        removes: the file was made by edits that are all taken back: it goes away again.
        attempted: digests of what writes that failed may have left in the file.
    """

    index: int
    path: Path
    image_folder: Path
    inside: Path
    expected: bytes | None
    annotation: FrameAnnotation
    reason: str
    removes: bool = False
    attempted: frozenset[bytes | None] = frozenset()

    @cached_property
    def data(self) -> bytes:
        """The bytes of the new content."""
        return write_annotation(self.annotation)

    def look(self) -> bytes | None:
        """What the file holds; None when there is none.

        Raises:
            SaveError: it cannot be read.
        """
        try:
            return read_optional(self.path, AnnotationError)
        except InputError as error:
            raise SaveError(f"{self.path}: could not be saved: {error.problem}") from error

    def check(self) -> bytes | None:
        """As `look`: what is to be kept as a version.

        Raises:
            ChangedOnDiskError: it is neither the one that was read or written last nor this one.
            SaveError: it cannot be read.
        """
        found = self.look()
        # A file that vanished holds nothing that writing could destroy, nor does one that is this
        # already (a batch broke off before it could tell).
        if found is not None and found != self.data and not self._is_known(found):
            raise ChangedOnDiskError(
                f"{self.path}: changed on disk meanwhile, not saved (reload it, or overwrite it)"
            )
        return found

    def _is_known(self, found: bytes) -> bool:
        return digest(found) in (self.expected, *self.attempted)

    def write(self, *, over_anything: bool = False) -> None:
        """Replace the file in one step, or remove it.

        Args:
            over_anything: whatever the file holds by now.

        Raises:
            ChangedOnDiskError: it is not the one that was read or written last.
            SaveError: it could not be written; the file is as it was.
        """
        if self.removes:
            self._remove()
            return
        folder = self.path.parent
        if not folder.is_dir() and self.image_folder.is_dir():
            # A chosen folder may not exist yet. But when the pictures' folder is gone (a drive was
            # unplugged), new folders in its place would only hide that.
            make_folder(folder)
        # Others may write while the disk is waited for.
        look_again = _skip_check if over_anything else self.check
        write_atomic(self.path, self.data, inside=self.inside, look_again=look_again)

    def _remove(self) -> None:
        found = self.check()
        if found is not None and not self._is_known(found):  # the same words of somebody else
            raise ChangedOnDiskError(f"{self.path}: changed on disk meanwhile, not removed")
        try:
            remove(self.path)
        except OSError as error:
            raise SaveError(f"{self.path}: could not be removed: {error.strerror}") from error


@dataclass(frozen=True)
class SaveResult:
    """What became of a save.

    Attributes:
        save: what was to be written.
        error: why it was not; None once it is.
        stamp: of the file right after it was written.
        unsure: it failed, and nobody knows whether the file is as it was or as it should be.
    """

    save: PendingSave
    error: SaveError | None = None
    stamp: Stamp = None
    unsure: bool = False


def write_saves(saves: Sequence[PendingSave]) -> list[SaveResult]:
    """Check and write several files at a time.

    What the files hold must be kept as versions already: this takes a while after that look.
    """
    if len(saves) == 1:
        return [write_save(saves[0])]
    with ThreadPoolExecutor(_TOGETHER, thread_name_prefix="saving") as pool:
        return list(pool.map(write_save, saves))


def write_save(save: PendingSave, *, over_anything: bool = False) -> SaveResult:
    """Check and write one file; ``over_anything``: whatever it holds by now."""
    before = None
    try:
        before = save.look() if over_anything else save.check()
        save.write(over_anything=over_anything)
    except ChangedOnDiskError as error:
        return SaveResult(save, error)
    except SaveError as error:
        return _after_failure(save, before, error)
    return SaveResult(save, stamp=stamp_of(save.path))


def _after_failure(save: PendingSave, before: bytes | None, error: SaveError) -> SaveResult:
    """Look at the file: a drive behind a network may fail to tell what it has done."""
    try:
        found = save.look()
    except SaveError:
        return SaveResult(save, error, unsure=True)
    if found != before and found == (None if save.removes else save.data):
        return SaveResult(save, stamp=stamp_of(save.path))
    return SaveResult(save, error)


def _skip_check() -> None:
    """Somebody decided that the file is to be replaced."""


def digest(data: bytes | None) -> bytes | None:
    """What tells the content of a file from another one."""
    return None if data is None else hashlib.blake2b(data, digest_size=16).digest()
