"""Opening a dataset: what is shown of it first, and what is said of it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.gui.state.blind_lock import BlindLock
from procc_annotator.gui.state.editing.editor import Editing
from procc_annotator.gui.state.landmarks import PROBLEM, STRANGE, Landmarks
from procc_annotator.gui.state.navigation.field_choice import FieldChoice
from procc_annotator.gui.state.navigation.navigator import Navigator
from procc_annotator.gui.state.saying import notify, say
from procc_annotator.gui.state.second import SecondAnnotator
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr


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
        more.

        Raises:
            UsageError: nothing is open.
        """
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
    """Return a warning that nothing can be saved here; shown before any work is done."""
    folder = workspace.frames[0].annotation_folder if workspace.frames else workspace.folder
    if folder.is_dir() and not os.access(folder, os.W_OK):
        yield tr(
            "{folder} cannot be written: nothing that is annotated here can be saved", folder=folder
        )
