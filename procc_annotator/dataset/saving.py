"""Save annotations: file stamps, pending saves, frame state and versions."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Generic, TypeVar

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.editing import History
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.records import digest_of
from procc_annotator.errors import AnnotationError, ChangedOnDiskError, InputError, SaveError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation
from procc_annotator.formats.atomic import make_folder, remove, write_atomic
from procc_annotator.formats.file_source import read_optional
from procc_annotator.translation import word

Stamp = tuple[int, int, int] | None  # time of change (ns), size, inode; None without a file

K = TypeVar("K", bound=Hashable)


def stamp_of(path: Path) -> Stamp:
    """Return what differs once a file was written; None if absent."""
    try:
        status = path.stat()
    except OSError:
        return None
    return status.st_mtime_ns, status.st_size, status.st_ino


class FileStamps(Generic[K]):
    """The stamps of files by whatever they are known by; safe to be used from several threads.

    A file keeps the stamp of its first reading until a person followed the change: who reads it in
    between hides nothing from those who read it before.
    """

    def __init__(self) -> None:
        self._stamps: dict[K, Stamp] = {}

    def note(self, key: K, path: Path) -> None:
        """A file is about to be read."""
        if key not in self._stamps:
            self._stamps.setdefault(key, stamp_of(path))

    def take(self, key: K, stamp: Stamp) -> None:
        """All that was made from a file is made from this state of it now."""
        self._stamps[key] = stamp

    def renew(self, key: K, path: Path) -> bool:
        """Take a file as it is now; whether it is another one than was read."""
        before, now = self._stamps.get(key), stamp_of(path)
        known = key in self._stamps
        self._stamps[key] = now
        return known and now != before

    def keep(self, other: FileStamps[K], without: Mapping[K, Stamp]) -> None:
        """Take over what others know, but of these files."""
        for key, stamp in list(other._stamps.items()):
            if key not in without:
                self._stamps.setdefault(key, stamp)

    def changed(
        self,
        path_of: Callable[[K], Path],
        stopped: Callable[[], bool] = lambda: False,
        *,
        only: Iterable[K] | None = None,
    ) -> dict[K, Stamp]:
        """Files that are not as they were read, and how they are now; one look at each, as far as
        they were read (and at these ``only``), until ``stopped``."""
        found: dict[K, Stamp] = {}
        stamps = self._stamps
        asked = list(stamps) if only is None else [key for key in only if key in stamps]
        for key in asked:
            stamp = stamps[key]
            if stopped():
                break
            now = stamp_of(path_of(key))
            if now != stamp:
                found[key] = now
        return found


_TOGETHER = 8  # most of a save is waiting for the disk, which takes several at a time


@dataclass(frozen=True)
class PendingSave:
    """Content to be saved to a frame's file. Knows only files, so any thread may write it.

    Attributes:
        image_folder: where its picture lies.
        inside: links are not followed out of this folder.
        expected: digest of what was read from or written to the file last; None without a file.
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
        """Return what the file holds; None if absent. `SaveError` if it cannot be read."""
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
        # already (a batch broke off before it could say).
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
        look_again = (lambda: None) if over_anything else self.check  # as a person decided
        write_atomic(self.path, self.data, inside=self.inside, look_again=look_again)

    def _remove(self) -> None:
        found = self.check()
        if found is not None and not self._is_known(found):  # the same words of somebody else
            raise ChangedOnDiskError(f"{self.path}: changed on disk meanwhile, not removed")
        remove(self.path)


@dataclass(frozen=True)
class SaveResult:
    """Result for a save.

    Attributes:
        error: why it was not; None once it is.
        stamp: of the file right after it was written.
        unsure: it failed, and no one knows whether the file is as it was or as it should be.
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
    """Look at the file: a drive behind a network may fail to report what it has done."""
    try:
        found = save.look()
    except SaveError:
        return SaveResult(save, error, unsure=True)
    if found != before and found == (None if save.removes else save.data):
        return SaveResult(save, stamp=stamp_of(save.path))
    return SaveResult(save, error)


def digest(data: bytes | None) -> bytes | None:
    """Return what distinguishes the content of a file from another one."""
    return None if data is None else digest_of(data)


EMPTY = FrameAnnotation()


class FrameState:
    """State of a frame in this session.

    Attributes:
        history: its annotations; the current one is what is shown.
        error: why the annotation file cannot be used; the frame cannot be edited then.
        save_error: why the last save failed; None once one succeeded.
        kept_unconfirmed: the unconfirmed elements that are remembered next to the file.
        under_way: what is being drawn, kept next to the file like what is unconfirmed.
        digest: of the file as it was read or written last; None where there was none.
        made_here: whether whatever file there is was made in this session.
        attempted: digests of what writes that failed may have left in the file; none if it is known
            to be as it was.
        being_written: whether a thread is at its file: what that holds is known once it has
            reported.
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
        """Return whether the frame belongs to the figures of a set: a frame without a file does
        not, one with a file does even if nothing is in it, as for `evaluate`."""
        if self.error is not None:
            return False
        return self.digest is not None or bool(self.history.current.annotated)

    @property
    def is_undone(self) -> bool:
        """Return whether a file that was made here would hold nothing any more."""
        made = self.made_here and (self.digest is not None or bool(self.attempted))
        return made and self.history.current.same_content(EMPTY)

    @property
    def dirty(self) -> bool:
        """Return whether what is shown differs from the file, or may do so."""
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
    """Return what is to be written of a frame as it is now.

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
        """The annotation with what was copied here earlier and still waits for the user."""
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
        """Keep what waits for the user, unless it is kept already."""
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
