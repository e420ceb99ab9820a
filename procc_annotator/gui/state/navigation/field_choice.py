"""Which field a dataset shows: as it says, as its classes say, and as its file is written anew."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import takewhile
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.database.location import folder_of
from procc_annotator.dataset.dataset_field import (
    ASPECT_SETTING,
    DatasetField,
    field_of_settings,
    field_settings,
    own_field_file,
    stored_field_source,
    stored_pixel_aspect,
    video_pixel_aspect,
)
from procc_annotator.dataset.diagnostics import (
    Mismatch,
    classes_in,
    distinctive_classes,
    mismatch_of,
)
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import FieldError
from procc_annotator.field.load import is_builtin_field, load_field, with_dimensions, with_lines
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_official
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import (
    ComputedValue,
    Inputs,
    Job,
    JobControl,
    Priority,
    run_in_background,
)
from procc_annotator.gui.state.editing.outside_changes import FileWatch
from procc_annotator.gui.state.messages import notify, say, withdraw
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.scoring.commands import EvaluationSettings
from procc_annotator.gui.state.store import Store, When
from procc_annotator.translation import tr


def mismatch_among(
    classes: frozenset[str], field: Field, own_files: Sequence[Path]
) -> Mismatch | None:
    """Return what is to say of classes on a field, where it does not know all of them; reads the
    files."""
    if not any(not field.knows(name) for name in classes):
        return None
    more = []
    for path in own_files:
        try:
            more.append(load_field(path))
        except FieldError:
            continue  # it may be gone, or half written: then it fits nothing
    return mismatch_of(classes, field, more)


def read_for_dataset(
    path: Path, shown: Field, settings: Mapping[str, str]
) -> tuple[Field | None, str]:
    """The field of a file with the dataset's dimensions as far as it still has them, its lines
    where the dataset has them; or why not. Dimensions shown stay if they are of the same file."""
    try:
        nominal = load_field(path)
        own = field_settings(settings, nominal)
        dimensions = own.dimensions
        if shown.source == path:
            dimensions = {d.name: d.value for d in shown.dimensions if d.value != d.nominal}
        fits = {
            d.name: dimensions[d.name]
            for d in nominal.dimensions
            if d.name in dimensions and d.minimum <= dimensions[d.name] <= d.maximum
        }
        sized = with_dimensions(nominal, fits) if fits else nominal
        return with_lines(sized, own.lines or nominal.lines), ""
    except FieldError as error:
        return None, str(error)


def own_source(field: Field) -> Path | None:
    """The file of the user's own that a field was read from; None for a shipped one."""
    return field.source if field.source is not None and not is_builtin_field(field.source) else None


def field_file_of(folder: Path, settings: Mapping[str, str]) -> Path | None:
    """The file of the user's own that a dataset names."""
    try:
        source = stored_field_source(folder, settings)
    except FieldError:
        return None
    return source if isinstance(source, Path) else None


_REFUSAL = "field"  # the notice that another one cannot be chosen
_LOOKED_AT = 20  # frames, where a dataset does not say which field it shows


class FieldChoice(QObject):
    """Chooses the field, and follows its file; knows no widget.

    Attributes:
        mismatch: what is to say of the classes of the frame on screen; None where the field fits.
        question: the field whose classes a dataset has that does not say what it shows; a person
            is to say whether it is that one. None where there is nothing to ask.
        problem: why the dataset's own file cannot be used as it is; the last good field stays.
        own_files: descriptions of the user's own, which may fit where no shipped field does.
        preparing: what judge and widgets work out of a field and remember, done before it is shown.
    """

    changed = Signal()

    def __init__(self, store: Store, review: ReviewState, terms: EvaluationSettings) -> None:
        super().__init__(store)
        self._store, self._review, self._terms = store, review, terms
        self._fail = partial(say, store, level="error")
        self._default = store.state.field
        self.mismatch: Mismatch | None = None
        self.question: Field | None = None
        self.problem = ""
        self.own_files: Sequence[Path] = ()
        self.preparing: list[Callable[[Field], object]] = [sample_official]
        self._chosen = self._closed = False
        self._matching = ComputedValue(self._to_match, mismatch_among, self)
        self._matching.changed.connect(self._take_match)
        self._skipped: set[frozenset[str]] = set()  # mismatches that the user ignores
        self._jobs: dict[str, Job] = {}
        self._watch = FileWatch(self, self.read_again)
        store.events.aboutToLeave.connect(self._finish_size)
        store.watch(select.dataset, self._begin)
        store.watch(select.field, self._watch_file)
        store.keep_current(self._matching, when=When.NOW)
        store.watch(lambda s: (select.annotation(s), s.field, s.selection), self._forget_refusal)

    @property
    def decided_by_file(self) -> Path | None:
        """The file in the dataset's folder that says what its field is: no other can be chosen."""
        workspace = self._store.state.workspace
        return own_field_file(folder_of(workspace.root)) if workspace is not None else None

    def field_of(self, workspace: Workspace, database: WorkspaceDatabase) -> DatasetField:
        """The field of a dataset that is being opened; the default one if its own cannot be used,
        until its file can be."""
        folder, settings = folder_of(workspace.root), database.settings()
        self.problem, self._skipped = "", set()
        self.question = self.mismatch = None
        self._matching.clear()
        self._cancel()
        try:
            found = field_of_settings(folder, settings)
        except FieldError as error:
            self._chosen = True
            self._watch.watch(field_file_of(folder, settings))
            self.problem = str(error)
            return DatasetField(self._default, True)
        self._chosen = found.chosen
        shown = found if found.chosen else DatasetField(self._default, False, found.notices)
        self._watch.watch(own_source(shown.field))
        stated = video_pixel_aspect(workspace.frames[0].image_path) if workspace.frames else None
        pixels = stated or stored_pixel_aspect(settings.get(ASPECT_SETTING))
        return replace(shown, field=replace(shown.field, pixels=pixels))

    def choose(self, source: str | Path) -> None:
        """Show another field, a shipped one by name or one in a file, from now on, and let the
        dataset remember it; reported where it cannot be used."""
        if not self._may_choose(Path(source)):
            return
        before = self._store.state.field  # the clicks are the same, whatever field they are on
        own = before.lines if before.lines != before.usual_lines else None

        def work(_: JobControl) -> Field:
            field = load_field(source)
            return self._prepared(with_lines(field, own or field.lines))

        self._start("choose", work, self.take)

    def take(self, field: Field) -> None:
        """As `choose`, with a field that is loaded."""
        if not self._may_choose(field.source):
            return
        before, self.problem = self.problem, ""
        try:
            self._terms.set_field(field)
        except FieldError as error:
            self.problem = before
            self._fail(str(error))
            return
        if (read := self._jobs.pop("read", None)) is not None:  # of the field before
            read.cancel()
        self._chosen, self.question = True, None
        self._tell_own(field.described if field.own_terms else tr(field.title))
        self.changed.emit()

    def resize(
        self, dimensions: Mapping[str, float], *, lines: str | None = None, keep: bool = True
    ) -> None:
        """Show the field with other dimensions from now on; reported where it cannot have them.

        Args:
            dimensions: metres, by name; those that are not named are nominal.
            lines: where its lines are, one of `LINES`; None: where they are now.
            keep: whether the dataset keeps this.
        """
        asked = self._store.state.field

        def work(_: JobControl) -> Field:
            sized = with_dimensions(asked, dimensions)
            return self._prepared(with_lines(sized, lines or asked.lines))

        def take(field: Field) -> None:
            try:
                self._terms.set_sized_field(field, keep=keep)
            except FieldError as error:
                self._fail(str(error))
                return
            if keep:
                self._tell_own(field.described)

        self._start("size", work, take)

    def read_again(self) -> None:
        """Read the user's own file again; what is wrong with it is reported, and the field
        stays."""
        if (path := self._watch.path) is None:
            return
        field, database = self._store.state.field, self._review.database
        settings = database.settings() if database is not None else {}

        def work(_: JobControl) -> tuple[Field | None, str]:
            found, problem = read_for_dataset(path, field, settings)
            return (None if found is None else self._prepared(found)), problem

        self._start("read", work, self._take_read)

    def switch(self) -> None:
        """Show the field that is asked about, or that knows the classes of the frame on screen."""
        if self.question is not None:
            self.take(self.question)
        elif self.mismatch is not None and self.mismatch.better is not None:
            self.choose(self.mismatch.better.name)
        else:
            say(self._store, tr("no other field knows the classes here better"))

    def leave(self) -> None:
        """Decline the proposed field, and remember it; or ignore these classes."""
        if self.question is None and self.mismatch is None:
            return
        self._skipped.add(self._unknown())  # also while it is computed what they are
        self._matching.invalidate()
        if self.question is not None:
            self.take(self._store.state.field)

    def close(self) -> None:
        """Watch and work out nothing any more; what is under way has ended then."""
        self._closed = True
        self._watch.watch(None)
        for job in self._jobs.values():
            job.stop()
        self._jobs.clear()

    # --- inside ---

    def _start(
        self, what: str, work: Callable[[JobControl], object], take: Callable[..., None]
    ) -> None:
        if (before := self._jobs.pop(what, None)) is not None:
            before.cancel()
        if self._closed:  # a dialog that goes with its window takes back what was entered
            return
        self._jobs[what] = run_in_background(
            work, on_result=take, on_error=self._fail, owner=self, priority=Priority.URGENT
        )

    def _prepared(self, field: Field) -> Field:
        """In the background: a field, once everything is known that showing it takes."""
        for prepare in self.preparing:
            prepare(field)
        return field

    def _cancel(self) -> None:
        for job in self._jobs.values():
            job.cancel()
        self._jobs.clear()

    def _finish_size(self) -> None:
        """Also when another field or dataset comes at once, what was entered is for this one."""
        if (job := self._jobs.pop("size", None)) is not None:
            job.finish()

    def _tell_own(self, field: str) -> None:
        reach = self._review.reach
        if self._store.state.workspace is None:
            text = tr("field: {field}", field=field)
        elif not reach:
            text = tr("this dataset's field from now on: {field}", field=field)
        else:
            text = tr(
                "this dataset's field from now on, {reach}: {field}", reach=reach, field=field
            )
        say(self._store, text)

    def _may_choose(self, source: Path | None) -> bool:
        own = self.decided_by_file
        if own is None or source == own:
            return True
        refusal = tr(
            "{file} says what the field of this dataset is: to choose another one, move that file"
            " away and open the dataset again",
            file=own,
        )
        notify(self._store, _REFUSAL, refusal)
        return False

    def _forget_refusal(self) -> None:
        withdraw(self._store, _REFUSAL)  # work has gone on

    def _take_read(self, outcome: tuple[Field | None, str]) -> None:
        self._finish_size()
        field, problem = outcome
        before, self.problem = self.problem, ""
        if field is not None:
            try:
                self._terms.set_field(field, keep=False)
            except FieldError as error:
                problem = str(error)
        self.problem = problem
        if problem != before:
            self.changed.emit()

    def _watch_file(self) -> None:
        if self.problem:  # the dataset's own file is waited for
            return
        self._watch.watch(own_source(self._store.state.field))

    # --- what the classes say ---

    def _begin(self) -> None:
        """Another dataset is open: if it does not say which field it shows, its classes may."""
        self.changed.emit()
        workspace = self._store.state.workspace
        if workspace is None or self._chosen or not workspace.frames:
            return
        count = len(workspace.frames)
        frames = range(0, count, max(1, count // _LOOKED_AT))
        readers = [partial(workspace.read, i) for i in frames]
        own, field = tuple(self.own_files), self._store.state.field

        def work(control: JobControl) -> tuple[Workspace, Mismatch | None, Field | None]:
            wanted = takewhile(lambda _: not control.cancelled, readers)
            mismatch = mismatch_among(classes_in(wanted), field, own)
            better = mismatch.better if mismatch is not None else None
            found = self._prepared(load_field(better.name)) if better is not None else None
            return workspace, mismatch, found

        self._start("guess", work, self._take_guess)

    def _take_guess(self, found: tuple[Workspace, Mismatch | None, Field | None]) -> None:
        workspace, mismatch, field = found
        if workspace is not self._store.state.workspace or self._chosen:
            return
        if field is None or mismatch is None or mismatch.better is None:
            return
        self.question = field
        self.changed.emit()

    def _to_match(self) -> Inputs | None:
        """The frame on screen may hold classes that the field does not know."""
        unknown = self._unknown()
        if not unknown or unknown in self._skipped:
            return None
        state = self._store.state
        return frozenset(state.annotation.annotated), state.field, tuple(self.own_files)

    def _take_match(self) -> None:
        if not self._matching.working:
            found = self._matching.value
            self._tell(found if found is not None and found.is_worth_reporting else None)

    def _unknown(self) -> frozenset[str]:
        """Classes of the frame on screen that the field does not know."""
        state = self._store.state
        names = state.annotation.annotated
        return distinctive_classes(name for name in names if not state.field.knows(name))

    def _tell(self, mismatch: Mismatch | None) -> None:
        if mismatch != self.mismatch:
            self.mismatch = mismatch
            self.changed.emit()
