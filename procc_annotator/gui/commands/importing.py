"""Taking annotations of other programs into the open dataset."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from procc_annotator.dataset.annotation_source import own_label_map
from procc_annotator.dataset.layout import folder_of_dataset
from procc_annotator.dataset.records import OriginKind
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import (
    LABELS_FILE,
    LabelMap,
    Rule,
    WrittenRule,
    label_map_text,
)
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.commands.dialogs import DialogTask
from procc_annotator.gui.messages import opened_frame
from procc_annotator.gui.state.background import JobControl
from procc_annotator.gui.state.editing.batch_edits import (
    BatchEdits,
    EditedFrames,
    LeftAlone,
    imported,
    why_left_alone,
)
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, tr_count, translatable

if TYPE_CHECKING:
    from procc_annotator.assist.label_proposal import LabelProposal
    from procc_annotator.formats.annotations.registry import ReadSet
    from procc_annotator.gui.commands.exchange_dialogs import ImportDialog, LabelDialog


_HEAD = ("What the labels of other programs stand for; chosen at an import.",)  # not shown


@dataclass(frozen=True)
class LookedAt:
    """The annotations that were read, and proposals for labels that are no class.

    Attributes:
        found: by the dataset's own map, if it has one.
        own: rules of that map.
        better: title of a field whose classes are called more like the labels; may be empty.
        has_file: whether the dataset has a map already.
    """

    found: ReadSet
    own: Mapping[str, Rule]
    proposals: tuple[LabelProposal, ...]
    field: Field
    better: str
    has_file: bool


class LabelLook:
    """One look at annotations, for the dataset that is open when it is made.

    Made on the interface thread; its methods run in another one.
    """

    def __init__(self, path: Path, fmt: str, services: Services) -> None:
        self._path, self._fmt = path, fmt
        self._reopen = services.opening.reopener()
        active = services.state.active
        self._cameras = None if active is None else active.files
        workspace = services.state.workspace
        self._folder = None if workspace is None else folder_of_dataset(workspace.root)

    def read(self, control: JobControl) -> LookedAt:
        """Read by the dataset's own map, and propose what the labels stand for that it leaves open.
        Raises as `report.conversion.read_annotations`, and if the dataset's map cannot be used."""
        from procc_annotator.assist.label_matching import cameras_of, labelled_frames
        from procc_annotator.assist.label_proposal import better_field, propose_labels
        from procc_annotator.report.conversion import read_annotations

        workspace = self._reopen()
        field = workspace.field
        own = None if self._folder is None else own_label_map(self._folder, field)
        found = read_annotations(
            self._path, workspace, fmt=self._fmt, names=own, progress=control.progress_or_stop
        )
        rules = own.rules if own is not None else {}
        frames = labelled_frames(found, field)
        if not any(frame.shapes for frame in frames):
            return LookedAt(found, rules, (), field, "", own is not None)
        cameras = None if self._cameras is None else cameras_of(self._cameras)
        proposals = propose_labels(frames, field, cameras)
        better = better_field([one.count.label for one in proposals], field)
        title = load_field(better).title if better is not None else ""
        return LookedAt(found, rules, tuple(proposals), field, title, own is not None)

    def read_by(
        self, looked: LookedAt, rules: Mapping[str, Rule], control: JobControl, *, keep: bool
    ) -> ReadSet:
        """Read it by more rules, of labels that the dataset's own map does not name; ``keep`` them
        for the dataset. `SaveError` if its map cannot be written."""
        from procc_annotator.report.conversion import read_annotations

        every = {**looked.own, **rules}
        names = LabelMap(Path(LABELS_FILE), every)
        found = read_annotations(
            self._path, self._reopen(), fmt=self._fmt, names=names,
            progress=control.progress_or_stop,
        )  # fmt: skip
        if keep and rules and self._folder is not None:
            lines = [WrittenRule(label, rule) for label, rule in every.items()]
            write_atomic(self._folder / LABELS_FILE, label_map_text(_HEAD, lines).encode())
        return found


_LISTED = 200


class AnnotationImporter(DialogTask):
    """Asks what to import, reads it in the background, asks what labels stand for that are no
    class, and saves it frame by frame."""

    dialog: ImportDialog | None
    names: LabelDialog | None = None

    def __init__(self, services: Services, parent: QWidget) -> None:
        super().__init__(services, parent)
        self._edits = BatchEdits(services.store, services.editing, services.scoring, self)

    def ask(self) -> None:
        """Show the dialog."""
        from procc_annotator.gui.commands.exchange_dialogs import ImportDialog

        workspace = self._services.state.workspace
        if opened_frame(self._services) is None or workspace is None:
            return
        self._leave()
        self.dialog = dialog = ImportDialog(self._parent, str(workspace.folder))
        dialog.start_button.clicked.connect(lambda: self.start(Path(dialog.path.text().strip())))
        dialog.cancelled.connect(self.cancel)
        dialog.open()

    def start(self, path: Path) -> None:
        """Read the annotations and take them over, as the dialog says."""

        services, dialog = self._services, self.dialog
        if dialog is None:
            return
        services.editing.save_now()
        self._look = LabelLook(path, str(dialog.formats.currentData()), services)
        self._replace = dialog.replace.isChecked()
        dialog.set_running(True)
        self._work.start(self._look.read, self._ask_names, progress=dialog.advance)

    def _ask_names(self, looked: LookedAt) -> None:
        """Ask what labels stand for that are no class; where there are none, begin to save."""
        from procc_annotator.gui.commands.exchange_dialogs import LabelDialog

        if not looked.proposals or self.dialog is None:
            self._take(looked.found)
            return
        self.dialog.set_running(False)
        self.names = names = LabelDialog(
            self.dialog, looked.proposals, looked.field, better=looked.better,
            has_file=looked.has_file,
        )  # fmt: skip
        names.accepted.connect(lambda: self._read_again(looked, names))
        names.rejected.connect(lambda: self._fail(tr("Cancelled; nothing was imported.")))
        names.open()

    def _read_again(self, looked: LookedAt, names: LabelDialog) -> None:
        """Read by the names that were chosen, and keep them with the dataset if that is wanted."""
        if self.dialog is None:
            return
        rules, keep = names.rules, names.keep.isChecked()
        self.dialog.set_running(True)
        self._work.start(
            partial(self._look.read_by, looked, rules, keep=keep), self._take,
            progress=self.dialog.advance,
        )  # fmt: skip

    def cancel(self) -> None:
        """Stop; frames that are saved already stay so, and are reported."""
        if self._work.cancel():
            self._fail(tr("Cancelled; nothing was imported."))
        else:
            self._edits.stop()

    def stop(self) -> None:
        """Import no more, and say nothing: the window closes. What is edited is saved by then."""
        self._leave()

    def _leave(self) -> None:
        self._edits.forget()
        super()._leave()

    def _take(self, read: ReadSet) -> None:
        workspace = self._services.state.workspace
        assert workspace is not None
        self._imported = read
        self._unmatched = [name for name in read.frames if name not in workspace.index]
        indices = [workspace.index[name] for name in read.frames if name in workspace.index]
        self._edits.start(indices, partial(self._take_one, workspace), self._finish, self._advance)

    def _take_one(self, workspace: Workspace, index: int) -> str:
        incoming = self._imported.frames[workspace.frames[index].name].annotation
        state = workspace.state(index)
        if state.error is None:  # most frames that stay as they are need no lock
            before = state.history.current
            why = why_left_alone(before, incoming, replacing=self._replace)
            if why is not None:
                return why
        change = imported(incoming, replacing=self._replace)
        label = translatable("import", "a step")
        return self._edits.edit_frame(index, change, label, OriginKind.FILE)

    def _advance(self, done: int, total: int) -> None:
        if self.dialog is not None:
            self.dialog.advance(done, total)

    def _finish(self, outcome: EditedFrames) -> None:
        services = self._services
        edited, total = len(outcome.edited), outcome.total
        services.say(
            tr_count(
                total,
                "{edited} of {n:,} frame imported",
                "{edited} of {n:,} frames imported",
                edited=edited,
            )
        )
        if self.dialog is None:
            return
        self.dialog.set_running(False)
        self.dialog.tell(
            "\n".join(_said(outcome, self._imported.title)),
            (tr("Left as they were"), self._refused(outcome)[:_LISTED]),
            (tr("Could not be read"), self._imported.problems[:_LISTED]),
            (tr("Without a picture here ({n})", n=len(self._unmatched)), self._unmatched[:_LISTED]),
            (tr("Changed or left out"), self._imported.losses),
        )

    def _refused(self, outcome: EditedFrames) -> list[str]:
        workspace = self._services.state.workspace
        frames = workspace.frames if workspace is not None else ()
        left = [(i, why) for i, why in outcome.left if not isinstance(why, LeftAlone)]
        unsaved = [(i, tr("it could not be saved: {why}", why=why)) for i, why in outcome.unsaved]
        return [f"{frames[i].name}: {why}" for i, why in sorted(left + unsaved)]


def _said(outcome: EditedFrames, format_title: str) -> list[str]:
    reasons = Counter(why for _, why in outcome.left)
    annotated, same = reasons[LeftAlone.ANNOTATED], reasons[LeftAlone.SAME]
    imported = tr_count(
        outcome.total,
        "{edited} of {n:,} frame imported ({format}).",
        "{edited} of {n:,} frames imported ({format}).",
        edited=len(outcome.edited),
        format=format_title,
    )
    waiting = tr_count(
        outcome.waiting,
        "Cancelled: {n:,} frame was not checked.",
        "Cancelled: {n:,} frames were not checked.",
    )
    left = tr_count(
        annotated,
        "{n:,} frame is annotated already and left unchanged.",
        "{n:,} frames are annotated already and left unchanged.",
    )
    alike = tr_count(
        same, "{n:,} frame holds the same already.", "{n:,} frames hold the same already."
    )
    lines = ((imported, 1), (waiting, outcome.waiting), (left, annotated), (alike, same))
    return [words for words, count in lines if count]
