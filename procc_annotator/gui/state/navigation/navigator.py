"""Opens datasets, and goes from frame to frame."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, ProccError, UsageError
from procc_annotator.gui.state.background import LatestOnlyTask, Priority, after_paint
from procc_annotator.gui.state.editing.editor import Editing, held
from procc_annotator.gui.state.editing.outside_changes import OutsideChanges
from procc_annotator.gui.state.landmarks import PROBLEM, STRANGE, Landmarks
from procc_annotator.gui.state.messages import notify, say
from procc_annotator.gui.state.navigation.field_choice import FieldChoice
from procc_annotator.gui.state.review_state import BlindLock
from procc_annotator.gui.state.scoring.dataset_scores import DatasetScoring
from procc_annotator.gui.state.second import SecondAnnotator
from procc_annotator.gui.state.state import ChosenElement
from procc_annotator.gui.state.store import Store
from procc_annotator.image.decoding import FrameCache, decode_half_size
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import tr


class Navigator(QObject):
    """Goes to frames; what is under way on the one on screen is set aside or finished first."""

    def __init__(
        self,
        store: Store,
        cache: FrameCache,
        editing: Editing,
        scoring: DatasetScoring,
        second: SecondAnnotator,
        outside: OutsideChanges,
    ) -> None:
        super().__init__(store)
        self._store, self._cache = store, cache
        self._editing, self._scoring = editing, scoring
        self._second, self._outside = second, outside
        # The whole picture, once half its size was painted: who walks on before spares it.
        self._whole = LatestOnlyTask(
            self,
            lambda text: self._end_first_look(picture_error=text),
            priority=Priority.IMMEDIATE,
            delay_ms=0,
        )
        # The picture of a frame to come to; the frame itself says that it cannot be read.
        self._bringing = LatestOnlyTask(self, None, priority=Priority.IMMEDIATE)
        self.within: frozenset[int] | None = None  # the frames that a filter shows; None: all
        self._aim = -1  # the frame that is come to once its picture is there
        self._soon = after_paint(self, self._foresee)

    def go_to(self, index: int) -> None:
        """Show another frame, with nothing chosen."""
        workspace = self._store.state.workspace
        if workspace is None or index == self._store.state.frame_index:
            return
        if not 0 <= index < len(workspace.frames):
            return
        self.leave()
        changed = workspace.look_again(index)
        arrived = self.arrival(workspace, index)
        self._store.update(**arrived)
        if changed:
            self._scoring.frame_edited()
            if index not in workspace.dirty_frames():
                self._editing.saver.save(index)  # nothing to save: a conflict is decided
            self._store.events.framesEdited.emit([index])
        name = workspace.frames[index].name
        if any(s.files and s.files.written_since(name) for s in self._store.state.sources):
            self._outside.look()

    def come_to(self, index: int) -> None:
        """As `go_to`, once the picture is decoded: paging through many frames waits for none of
        them, and only the last requested one is shown."""
        workspace = self._store.state.workspace
        if workspace is None or not 0 <= index < len(workspace.frames):
            return
        if index == self._store.state.frame_index:
            self.stay()
            return
        self._aim = index
        if self._bringing.running:
            return
        path = workspace.frames[index].image_path
        if self._cache.peek(path) is not None:
            self.go_to(index)
            return
        self._bringing.start(
            lambda _: self._cache.get_ready(path),
            lambda _: self._come(index),
            failed=lambda _: self._come(index),
        )

    def stay(self) -> None:
        """Give up the frame that is still to be come to: a person went elsewhere, or stays."""
        self._aim = -1
        self._bringing.cancel()

    @property
    def coming(self) -> bool:
        """Return whether a frame is still to be come to."""
        return self._bringing.running

    def _come(self, index: int) -> None:
        """A picture is there; another one may have been asked for meanwhile."""
        aim = self._aim
        self.go_to(index)
        if aim != index:
            self.come_to(aim)

    def next_frame(self) -> None:
        """Show the next frame of those that the filter shows, if there is one."""
        self._step(1)

    def previous_frame(self) -> None:
        """Show the previous frame of those that the filter shows, if there is one."""
        self._step(-1)

    def _step(self, step: int) -> None:
        here = self._store.state.frame_index
        if self.within is None:
            self.go_to(here + step)
        elif beyond := [index for index in self.within if (index - here) * step > 0]:
            self.go_to(min(beyond) if step > 0 else max(beyond))
        else:
            say(self._store, tr("the filter shows no further frame this way"))

    def leave(self) -> None:
        """The frame on screen is left, and may be another window's: what is being drawn is set
        aside, what else is under way finished, up to the disk."""
        self._store.events.frameLeft.emit()
        self._store.events.aboutToLeave.emit()
        self._editing.saver.settle(self._store.state.frame_index)
        self._scoring.settle()

    def arrival(self, workspace: Workspace, index: int) -> dict[str, object]:
        """Return what the state is to hold of a frame that is come to; -1 for none."""
        frame = workspace.frames[index] if index >= 0 else None
        name = frame.name if frame is not None else None
        self._whole.cancel()
        self.stay()
        self._outside.watch.watch(None if frame is None else frame.annotation_path)
        self._editing.review.enter(name)
        self._second.show(name)
        found: dict[str, object] = {
            "workspace": workspace,
            "selection": ChosenElement(),
            "hovered_class": None,
            "frame_index": index,
            "preview": None,
            "picture": None,
            "half": None,
            "picture_error": "",
            "holder": self._editing.frame_lock.enter(name),
        }
        if frame is None:
            return {**found, "annotation": FrameAnnotation(), "damage": "", "counts": False}
        try:
            found |= self._look_at(frame.image_path)
        except ImageError as error:
            found["picture_error"] = str(error)
        self._cache.prefetch(())  # what waited is not next any more
        self._soon.start()
        return found | held(workspace, index)

    @property
    def picture(self) -> PixelArray | None:
        """The whole picture of the frame on screen; waits for it while half its size is shown."""
        self.see_whole()
        return self._store.state.picture

    def see_whole(self) -> None:
        """Wait for the whole picture where only half its size is shown yet."""
        self._whole.finish()

    # --- inside ---

    def _look_at(self, path: Path) -> dict[str, object]:
        """The picture; where that is to be decoded, a large one is examined in half its size first.
        `ImageError` if it is not a readable picture."""
        half = decode_half_size(path) if self._cache.peek(path) is None else None
        if half is None:
            return {"picture": self._cache.get(path)}
        self._whole.start(
            lambda _: self._cache.get_ready(path),
            lambda picture: self._end_first_look(picture=picture),
        )
        return {"half": half}

    def _end_first_look(self, **found: object) -> None:
        self._store.update(**found, half=None)
        self._foresee()

    def _foresee(self) -> None:
        """These may be on screen next; a whole picture that is still to come goes before them."""
        state = self._store.state
        if state.workspace is None or state.frame is None:
            return
        frames, index = state.workspace.frames, state.frame_index
        around = (index + step for step in (0, 1, -1))
        here, *soon = [frames[i] for i in around if 0 <= i < len(frames)]
        self._cache.prefetch([frame.image_path for frame in soon] if state.half is None else ())
        self._editing.review.foresee(frame.name for frame in (here, *soon))


class Opening(QObject):
    """Opens datasets, one after the other; on failure the one on screen stays."""

    def __init__(
        self,
        store: Store,
        walk: Navigator,
        editing: Editing,
        blind_lock: BlindLock,
        field_choice: FieldChoice,
        landmarks: Landmarks,
        second: SecondAnnotator,
    ) -> None:
        super().__init__(store)
        self._store, self._walk, self._editing = store, walk, editing
        self._blind_lock, self._second = blind_lock, second
        self._field_choice, self._landmarks = field_choice, landmarks
        self._opened: tuple[Path, Path | None] | None = None

    def open_path(self, path: Path, annotations: Path | None = None) -> bool:
        """Open a folder of pictures or one picture; on failure the session stays as it is."""
        if not self._leave(tr("not everything is saved yet: the other dataset was not opened")):
            return False
        try:
            workspace = Workspace.open(path, self._store.state.field, annotations)
        except ProccError as error:
            say(self._store, str(error), "error")
            return False
        self._take(workspace)
        self._opened = (path, annotations)
        return True

    def open_workspace(self, workspace: Workspace) -> bool:
        """Show a dataset that was put together elsewhere (frames of a video)."""
        if not self._leave(tr("not everything is saved yet: the video was not opened")):
            return False
        self._take(workspace)
        self._opened = None
        return True

    def reopener(self) -> Callable[[], Workspace]:
        """Return what opens the dataset as it is on disk, in a thread of its own: this dataset with
        this field, whatever is shown by then. It raises `ProccError` if that cannot be opened any
        more; this raises `UsageError` if nothing is open."""
        workspace, field = self._store.state.workspace, self._store.state.field
        if workspace is None:
            raise UsageError(tr("nothing is open"))
        if self._opened is None:  # frames of a video
            return partial(Workspace, workspace.root, workspace.frames, field, ())
        path, annotations = self._opened
        return partial(Workspace.open, path, field, annotations)

    # --- inside ---

    def _leave(self, refusal: str) -> bool:
        self._walk.leave()
        if self._editing.saver.save_all():
            return True
        say(self._store, refusal, "error")
        return False

    def _take(self, workspace: Workspace) -> None:
        review, author = self._editing.review, self._store.state.author
        if review.database is not None:
            review.database.flush()  # the same dataset may be opened again
        database = WorkspaceDatabase.open(workspace.root, author)
        workspace.memory.database = database
        review.set_database(database)
        self._editing.frame_lock.set_dataset(workspace.root, author)
        self._editing.saver.set_workspace(workspace)
        self._second.close()
        shown = self._field_choice.field_of(workspace, database)
        field = self._landmarks.take(workspace, shown.field)
        workspace.set_field(field)
        first = workspace.index.get(database.last_frame or "", 0) if workspace.frames else -1
        setup = self._store.state.setup
        other_field = field != setup.field or field.source != setup.field.source
        self._store.update(
            **self._walk.arrival(workspace, first),
            **self._blind_lock.of_dataset(),
            setup=replace(setup, field=field) if other_field else setup,
        )
        if waiting := self._store.state.annotation.unconfirmed:
            titles = ", ".join(tr(field.title_of(p.class_name)) for p in waiting)
            say(self._store, tr("unfinished elements were kept: {titles}", titles=titles))
        if field.own_terms:
            say(self._store, tr("the field of this dataset: {field}", field=field.described))
        landmarks = {PROBLEM: self._landmarks.problem, STRANGE: self._landmarks.strange}
        notices = [
            *_unwritable(workspace),
            *shown.notices,
            *filter(None, landmarks.values()),
            *database.notices,
            *workspace.notices,
        ]
        keys = [key for key, text in landmarks.items() if [text] == notices]
        if keys:  # what may be mended is told alone
            notify(self._store, keys[0], notices[0])
        elif notices:
            say(self._store, "; ".join(notices[:3]), "warning")


def _unwritable(workspace: Workspace) -> Iterator[str]:
    folder = workspace.frames[0].annotation_folder if workspace.frames else workspace.folder
    if folder.is_dir() and not os.access(folder, os.W_OK):
        yield tr(
            "{folder} cannot be written: what is annotated here has to be saved elsewhere (File >"
            " Save copies to…)",
            folder=folder,
        )
