"""A dataset being edited: load, edit and save annotations; restore versions; annotated frames
to export.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.dataset import editing
from procc_annotator.dataset.annotation_source import FrameAnnotations
from procc_annotator.dataset.editing import History
from procc_annotator.dataset.frames import Frame, list_frames
from procc_annotator.dataset.saving import (
    EMPTY,
    FileStamps,
    FrameState,
    FrameVersions,
    PendingSave,
    SaveResult,
    Stamp,
    digest,
    pending_of,
    stamp_of,
    write_save,
    write_saves,
)
from procc_annotator.errors import AnnotationError, InputError, SaveError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.registry import read_plain
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER, list_annotations
from procc_annotator.formats.file_source import FileSource, read_optional
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.translation import word

SAVED_ELSEWHERE = word("what was saved elsewhere")  # the step that `refresh` makes


class Workspace:
    """The frames of a folder (or one picture), loaded one by one when asked for.

    Annotations lie next to the pictures, in the folder's ``annotations/`` when it holds any JSON,
    or in a folder chosen by the user; the file is always ``{picture's stem}.json``.

    Attributes:
        root: what was opened: a folder, or a single picture.
        folder: the dataset's; of a single picture the one it lies in.
        memory: what is kept next to the files.
        given: annotations of any format, for who only reads the dataset; None: the frames' own
            files, which can be edited.
    """

    def __init__(
        self,
        root: Path,
        frames: tuple[Frame, ...],
        field: Field,
        notices: tuple[str, ...],
        folder: Path | None = None,
    ):
        self.root = root
        self.folder = folder or root
        self.memory = FrameVersions()
        self.frames = frames
        self.field = field
        self.notices = notices
        self.index = FrameTable((frame.name, i) for i, frame in enumerate(frames))
        self.given: FrameAnnotations | None = None
        self._states: dict[int, FrameState] = {}
        self._stamps: FileStamps[int] = FileStamps()
        self._broken: dict[int, FrameState] = {}  # as they were before others broke their files
        self._outdated: set[int] = set()  # read, then written by others, and not looked at since

    @classmethod
    def open(cls, path: Path, field: Field, annotations: Path | None = None) -> Workspace:
        """List a folder's pictures in natural order, or take a single picture.

        Nothing is decoded and no annotation is read; the folder of the annotation files need not
        exist yet.

        Raises:
            UsageError: no such folder, or a file that is no picture.
            InputError: a folder that cannot be listed.
        """
        root, frames, notices = list_frames(path, annotations)
        return cls(path, frames, field, notices, root)

    def only(self, names: Collection[str] | None) -> Workspace:
        """Return the same dataset with some of its frames (None: all), none read yet."""
        frames = tuple(f for f in self.frames if names is None or f.name in names)
        return Workspace(self.root, frames, self.field, self.notices, self.folder)

    @property
    def annotations(self) -> Path:
        """The folder that all annotation files lie in or below, under the names of their frames."""
        first = self.frames[0]
        beside = "/" in first.name and "/" not in (first.annotation_stem or first.name)
        return self.folder if beside else first.annotation_folder

    @property
    def own_folders(self) -> tuple[Path, ...]:
        """Return where nothing but annotations may be written: of pictures, of annotations, and
        those that annotations are looked for in."""
        if not self.frames:
            return ()
        pictures = dict.fromkeys((self.folder, self.frames[0].image_folder))
        return (*pictures, self.annotations, *(folder / ANNOTATIONS_FOLDER for folder in pictures))

    def state(self, index: int) -> FrameState:
        """A frame's state, read from disk the first time. An unreadable file is its ``error``."""
        state = self._states.get(index)
        if state is None:
            state = self._states[index] = self._load(index)
        return state

    def look_again(self, index: int) -> bool:
        """Follow a frame's file if others wrote it since it was read; unsaved edits stay.

        What the file holds is one more step of the history. A file that cannot be read any more is
        the frame's ``error``, and one that could not be used is read anew.

        Returns:
            Whether what was known of the frame may be another thing now.
        """
        frame = self.frames[index]
        if not frame.image_folder.exists():  # a drive was unplugged: nobody deleted anything
            return False
        changed = self._stamps.renew(index, frame.annotation_path) or index in self._outdated
        self._outdated.discard(index)
        state = self._states.get(index)
        if state is None or not (changed or state.error):
            return changed
        if state.error is not None:
            read = self._load(index)
            if read.error is None and (before := self._broken.pop(index, None)) is not None:
                state = self._states[index] = before
            else:
                self._states[index] = read
                return changed or read.error is None
        if not state.dirty:
            try:
                self.refresh(index)
            except InputError:  # perhaps another program is in the middle of writing
                self._broken[index] = state
                self._states[index] = self._load(index)
        return True

    def changed_outside(self, stopped: Callable[[], bool] = lambda: False) -> dict[int, Stamp]:
        """Frames with files that others wrote since they were read, for `follow`; one look at
        every file that was read, in any thread."""
        if not self.folder.is_dir():
            return {}
        return self._stamps.changed(lambda i: self.frames[i].annotation_path, stopped)

    def follow(self, changed: Mapping[int, Stamp]) -> None:
        """Read these files anew when they are asked for the next time; unsaved edits stay."""
        for index, stamp in changed.items():
            self._stamps.take(index, stamp)
            if index in self._states:
                self._outdated.add(index)

    def read(self, index: int) -> FrameAnnotation:
        """A frame's annotation as it is now, without keeping anything; safe from any thread.
        `InputError` if the file cannot be used."""
        found = self.annotation_to_score(index)
        return found if found is not None else EMPTY

    def annotation_to_score(self, index: int) -> FrameAnnotation | None:
        """As `read`; None for a frame that has no file and so belongs to no figure of the set."""
        state = self._states.get(index)
        if state is not None and (index not in self._outdated or state.dirty):
            if state.error is not None:
                raise state.error
            return state.history.current if state.counts else None
        data = self._bytes(index)
        return self.parse(index, data) if data is not None else None

    def has_file(self, index: int) -> bool:
        """Return whether a frame has an annotation file, even an empty one."""
        frame = self.frames[index]
        return frame.annotation_path.exists() if self.given is None else self.given.has(frame)

    def loaded_annotation(self, index: int) -> FrameAnnotation | None:
        """A frame's annotation as it is now, if it was read in this session; never reads it."""
        state = self._states.get(index)
        if state is None or state.error is not None or index in self._outdated:
            return None
        return state.history.current

    def annotated_count(self, index: int) -> int:
        """Return how many classes of a frame have points; raises as `read` does."""
        return len(self.read(index).annotated)

    def edit(self, index: int, label: str, annotation: FrameAnnotation) -> bool:
        """Make an edit a step of the frame's history; False when it changes nothing. `UsageError`
        if the frame's annotation file is unreadable, so editing could destroy it."""
        assert self.given is None  # opened to be read
        state = self.state(index)
        if state.error is not None:
            raise UsageError(f"this frame cannot be edited: {state.error}")
        changed = state.history.push(label, annotation)
        self.memory.keep_unconfirmed(self.frames[index].name, state)
        return changed

    def keep_clicks(self, index: int, drawn: Polyline | None) -> bool:
        """Remember what is being drawn in a frame (None: nothing); whether that is new."""
        state = self.state(index)
        if drawn == state.under_way:
            return False
        state.under_way = drawn
        self.memory.keep_unconfirmed(self.frames[index].name, state)
        return True

    def undo(self, index: int) -> str | None:
        """Take back a frame's last edit; its label, or None."""
        state = self.state(index)
        label = state.history.undo()
        self.memory.keep_unconfirmed(self.frames[index].name, state)
        return label

    def redo(self, index: int) -> str | None:
        """Do a frame's last undone edit again; its label, or None."""
        state = self.state(index)
        label = state.history.redo()
        self.memory.keep_unconfirmed(self.frames[index].name, state)
        return label

    def set_field(self, field: Field) -> None:
        """Read and write by another field: what was read already bears its spellings.

        Histories and unsaved edits stay.
        """
        self.field = field
        for state in (*self._states.values(), *self._broken.values()):
            state.rename(field.canonical_name)

    def dirty_frames(self) -> list[int]:
        """Frames with an annotation that differs from the file."""
        return sorted(i for i, state in self._states.items() if state.dirty)

    def save(self, index: int) -> None:
        """Write a frame's annotation, unless it is what the file holds already.

        A frame that had no file gets one with its first click; once all is taken back the file is
        removed, for an empty one would count as a frame without a correct element. Files that were
        there before are never removed.

        Raises:
            ChangedOnDiskError: the file is not the one that was read or written last.
            SaveError: it could not be written. Either way the frame stays dirty.
        """
        for written in self.write(self.prepare_saves([index])):
            self.note_saved(written)
            if written.error is not None:
                raise written.error

    def prepare_saves(self, indices: Iterable[int]) -> list[PendingSave]:
        """Return what is to be written of some frames, for a thread of its own.

        Until `note_saved` is called a frame is not saved, whatever it shows.
        """
        states = [(index, self.state(index)) for index in dict.fromkeys(indices)]
        changed = [(index, state) for index, state in states if not state.error and state.dirty]
        assert not any(state.being_written for _, state in changed)
        batch = [pending_of(i, self.frames[i], state, self.root) for i, state in changed]
        for _, state in changed:
            state.being_written = True
        return batch

    def write(self, batch: Sequence[PendingSave]) -> list[SaveResult]:
        """Write what `prepare_saves` made; from any thread.

        What the files hold is kept as versions first, on the disk as far as any can be written.
        """
        names = [self.frames[pending.index].name for pending in batch]
        new = [self.memory.keep_found(*found) for found in zip(names, batch, strict=True)]
        if any(new):
            self.memory.flush()
        done = write_saves(batch)
        for written in done:
            self._keep(written)
        return done

    def note_saved(self, written: SaveResult) -> None:
        """Take down that an annotation was written, or why it was not: then it stays dirty."""
        pending, state = written.save, self.state(written.save.index)
        state.being_written = False
        if written.error is not None:
            state.save_error = written.error
            if written.unsure:
                state.attempted |= {None if pending.removes else digest(pending.data)}
            return
        # The field may have become another one meanwhile, with other spellings.
        annotation = pending.annotation.renamed(self.field.canonical_name)
        state.stored(annotation, None if pending.removes else digest(pending.data))
        if stamp_of(pending.path) == written.stamp:  # else somebody wrote it again already
            self._stamps.take(pending.index, written.stamp)
            self._outdated.discard(pending.index)

    def overwrite(self, index: int) -> None:
        """Write a frame's annotation over whatever the file holds by now, which stays a version.

        Raises:
            SaveError: it could not be written, or the frame is blocked: what its file holds was
                never on screen, so no one can have decided to give it up. Or the file cannot be
                read, so that it could not be kept.
        """
        state = self.state(index)
        try:
            if state.error is not None:
                raise state.error
            found = self._bytes(index)
        except InputError as error:
            state.save_error = SaveError(f"not overwritten, it could not be read: {error}")
            raise state.save_error from error
        if found is not None:
            self.memory.keep(self.frames[index].name, found, word("overwritten"))
        state.made_here = False
        pending = pending_of(index, self.frames[index], state, self.root)
        written = write_save(pending, over_anything=True)
        self._keep(written)
        self.note_saved(written)
        if written.error is not None:
            raise written.error

    def knows_file(self, index: int) -> bool:
        """Return whether a frame's file is the one that was read or written last; one look at
        it."""
        try:
            return digest(self._bytes(index)) == self.state(index).digest
        except InputError:
            return False

    def reload(self, index: int) -> None:
        """Take what the file holds by now, as one more step of the history (so undo brings back).

        A blocked frame begins anew instead: it had nothing that undo could bring back.

        Raises:
            InputError: the file cannot be used; nothing changes.
        """
        self._take(index, self._bytes(index), "reload from disk")

    def _take(self, index: int, data: bytes | None, label: str) -> None:
        state = self.state(index)
        annotation = self.parse(index, data) if data is not None else EMPTY
        if state.error is not None:
            state.error, state.history = None, History(annotation)
        else:
            kept = editing.add_unconfirmed(annotation, state.history.current.unconfirmed)
            state.history.push(label, kept)
        state.stored(annotation, digest(data))
        state.made_here = data is None

    def refresh(self, index: int) -> bool:
        """Take a file that changed outside, unless there are unsaved edits; True when it did.

        Where its folder is there no more (a drive was unplugged) nothing goes from the screen.

        Raises:
            InputError: the file cannot be used; nothing changes.
        """
        state = self.state(index)
        if state.error is None and state.dirty:
            return False
        data = self._bytes(index)
        if data is None and not self.frames[index].annotation_folder.exists():
            return False
        if state.error is None and digest(data) == state.digest:
            return False
        self._take(index, data, SAVED_ELSEWHERE)
        return True

    def parse(self, index: int, data: bytes) -> FrameAnnotation:
        """The annotation that a frame's file, or an earlier version of it, holds. `InputError` if
        it cannot be read."""
        frame = self.frames[index]
        shown = frame.annotation_path if self.given is None else self.given.display(frame)
        return read_plain(data, str(shown), self.field)

    def _load(self, index: int) -> FrameState:
        try:
            data = self._bytes(index)
            annotation = self.parse(index, data) if data is not None else EMPTY
        except InputError as error:
            state = FrameState(EMPTY, None)
            state.error = error
            return state
        name = self.frames[index].name
        shown = self.memory.with_unconfirmed(name, annotation, self.field)
        return FrameState(shown, digest(data))

    def _bytes(self, index: int) -> bytes | None:
        frame = self.frames[index]
        if self.given is not None:
            return self.given.bytes_of(frame)
        self._stamps.note(index, frame.annotation_path)
        return read_optional(frame.annotation_path, AnnotationError)

    def _keep(self, written: SaveResult) -> None:
        save = written.save
        if written.error is None:
            self.memory.keep(self.frames[save.index].name, save.data, save.reason)


def restore_version(workspace: Workspace, index: int, data: bytes) -> None:
    """Write what a version holds over a frame's file, which stays a version.

    Raises:
        InputError: what is there cannot be examined.
        SaveError: it could not be written.
    """
    frame = workspace.frames[index]
    if (found := read_optional(frame.annotation_path, AnnotationError)) is not None:
        workspace.memory.keep(frame.name, found, word("as it was found"))
    write_atomic(frame.annotation_path, data, inside=workspace.root)


@dataclass(frozen=True)
class AnnotatedFrames:
    """Frames by number, and what is annotated in them.

    Attributes:
        names: of all frames, in natural order; some may have no annotation.
        folders: where nothing may be written.
        read: a frame's annotation by its index, however short; None where no one annotated it.
            Raises InputError if its file cannot be used.
    """

    field: Field
    names: Sequence[str]
    folders: Sequence[Path]
    read: Callable[[int], FrameAnnotation | None]


def dataset_frames(workspace: Workspace) -> AnnotatedFrames:
    """Frames of a dataset with pictures, unsaved edits included."""

    def read(index: int) -> FrameAnnotation | None:
        annotation = workspace.read(index)
        known = annotation.polylines or annotation.extra or workspace.has_file(index)
        return annotation if known else None

    names = tuple(frame.name for frame in workspace.frames)
    return AnnotatedFrames(workspace.field, names, workspace.own_folders, read)


def file_frames(source: FileSource, field: Field) -> AnnotatedFrames:
    """Frames of annotation files alone; the source stays open as long as they are read."""
    listed = list_annotations(source)
    files = tuple(listed.values())

    def read(index: int) -> FrameAnnotation | None:
        return read_plain(source.read(files[index]), source.display(files[index]), field)

    folders = (source.path,) if source.path.is_dir() else ()
    return AnnotatedFrames(field, tuple(listed), folders, read)
