"""Annotations of another program, read in the background; and what their labels may stand for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from procc_annotator.dataset.annotation_source import own_label_map
from procc_annotator.dataset.layout import folder_of_dataset
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
from procc_annotator.gui.state.background import JobControl
from procc_annotator.gui.state.document import Document

if TYPE_CHECKING:
    from procc_annotator.assist.label_proposal import LabelProposal
    from procc_annotator.formats.annotations.registry import ReadSet

_HEAD = ("What the labels of other programs stand for; chosen at an import.",)  # not shown


@dataclass(frozen=True)
class LookedAt:
    """What was read, and what is proposed for labels of it that are no class.

    Attributes:
        found: by the dataset's own map, if it has one.
        own: rules of that map.
        proposals: of the other labels.
        field: of the dataset.
        better: title of a field whose classes are called more like the labels; may be empty.
        has_file: whether the dataset has a map already.
        look: what reads it again.
    """

    found: ReadSet
    own: Mapping[str, Rule]
    proposals: tuple[LabelProposal, ...]
    field: Field
    better: str
    has_file: bool
    look: LabelLook


class LabelLook:
    """One look at annotations, for the dataset that is open when it is made.

    Made on the interface thread; its methods run in another one.
    """

    def __init__(self, path: Path, fmt: str, document: Document) -> None:
        self._path, self._fmt = path, fmt
        self._reopen = document.opening.reopener()
        active = document.state.active
        self._cameras = None if active is None else active.files
        self._folder = (
            folder_of_dataset(document.state.workspace.root) if document.state.workspace else None
        )

    def read(self, control: JobControl) -> LookedAt:
        """Read by the dataset's own map, and propose what the labels stand for that it leaves open.

        Raises:
            UsageError, InputError: as of `report.conversion.read_annotations`; the dataset's map
                cannot be used.
        """
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
            return LookedAt(found, rules, (), field, "", own is not None, self)
        cameras = None if self._cameras is None else cameras_of(self._cameras)
        proposals = propose_labels(frames, field, cameras)
        better = better_field([one.count.label for one in proposals], field)
        title = load_field(better).title if better is not None else ""
        return LookedAt(found, rules, tuple(proposals), field, title, own is not None, self)

    def read_by(
        self, looked: LookedAt, rules: Mapping[str, Rule], control: JobControl, *, keep: bool
    ) -> ReadSet:
        """Read it by more rules.

        Args:
            looked: what the first look found.
            rules: of labels that the dataset's own map does not name.
            control: of the job.
            keep: whether the dataset is to have them.

        Raises:
            UsageError, InputError: as of `read`.
            SaveError: the dataset's map cannot be written.
        """
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
