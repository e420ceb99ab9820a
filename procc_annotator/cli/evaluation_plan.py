"""Sets, methods and sizes of a call of ``evaluate``, submissions, and printing scores."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

from procc_annotator.batch.grouping import Grouping, Tags
from procc_annotator.cli.console import stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.method_arguments import (
    SourceSpec,
    name_of,
    parse_named,
    parse_sources,
    require_distinct,
)
from procc_annotator.cli.options import FieldOptions
from procc_annotator.cli.remarks import report_notices, report_remarks, report_unreadable
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.layout import annotations_of
from procc_annotator.dataset.picture_sizes import pictures_of_another_shape
from procc_annotator.errors import UsageError
from procc_annotator.field.load import field_fingerprint
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.submissions import (
    POLYLINES,
    method_of,
    read_manifest,
    require_made_for,
)
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import FileSource
from procc_annotator.messages import list_names, pluralize
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.scores import score_tables
from procc_annotator.report.scores.inference import StatisticalResult
from procc_annotator.report.scores.score_tables import (
    EvaluationRow,
    evaluations_table,
    left_out_table,
)
from procc_annotator.report.scores.scoring import EvaluationRequest, Scored


def submitted_source(path: Path) -> str:
    """The submission as a source of cameras, named as its manifest says; InputError if it is no
    submission of polylines."""
    return f"{method_of(read_manifest(path))}:{POLYLINES}={path}"


def require_submitted_for(
    path: Path, setup: EvaluationSetup, frames: Mapping[str, Collection[str]]
) -> None:
    """Raise UsageError for a submission that was made for another setup or for other annotated
    frames (names by set)."""
    every = [name for names in frames.values() for name in names]
    require_made_for(
        path, read_manifest(path), protocol=setup.protocol,
        field_sha256=field_fingerprint(setup.field), size=setup.size, frames=every,
    )  # fmt: skip


# Folders of annotations are often called so; then the folder they lie in names the set.
_ANY_SET = frozenset({"annotations", "labels", "gt", "ground_truth"})


@dataclass(frozen=True)
class Plan:
    """Sets and methods, by name; every method is scored on every set.

    Attributes:
        named: whether they were named, so that files have to state which is which.
        field_options: the options of the field, and of what labels stand for.
    """

    sets: tuple[tuple[str, Path], ...]
    methods: tuple[SourceSpec, ...]
    named: bool
    field_options: FieldOptions

    @classmethod
    def of(
        cls,
        annotations: Path | None,
        cameras: Path | None,
        sets: Sequence[str],
        sources: Sequence[str],
        camera_format: str,
        field_options: FieldOptions,
    ) -> Plan:
        """Read the arguments; UsageError if something is missing or given twice, or two have the
        same name."""
        if (annotations is None) == (not sets):
            raise UsageError(
                "annotations are needed: ANNOTATIONS for one set,"
                " or --set NAME=ANNOTATIONS for each of several"
                if annotations is None
                else f"{annotations}: name it too, with --set NAME=ANNOTATIONS, next to other sets"
            )
        if (cameras is None) == (not sources):
            raise UsageError(
                "cameras are needed: CAMERAS for one method,"
                " or --cameras NAME=PATH for each of several"
                if cameras is None
                else f"{cameras}: name it too, with --cameras NAME=PATH, next to other --cameras"
            )
        chosen = tuple(parse_named(text, "NAME=ANNOTATIONS") for text in sets)
        if annotations is not None:
            chosen = ((set_name_of(annotations), annotations),)
        require_distinct((name for name, _ in chosen), "sets")
        chosen = tuple((name, annotations_of(path)) for name, path in chosen)
        methods = parse_sources(sources, camera_format)
        if cameras is not None:
            methods = (SourceSpec(name_of(str(cameras)), camera_format, cameras),)
        return cls(chosen, methods, bool(sets or sources), field_options)

    def fields(self) -> dict[str, Field]:
        """The field of each set: the one of the options, or else the set's own."""
        return {name: self.field_options.of(path) for name, path in self.sets}

    def open(
        self,
        files: ExitStack,
        fields: Mapping[str, Field],
        setups: Sequence[EvaluationSetup],
        by: tuple[str, ...],
        tags: Tags | None,
        *,
        camera_size: tuple[int, int] | None,
    ) -> list[EvaluationRequest]:
        """Open everything; one evaluation a set, method and setup, in this order.

        A camera that names no picture size cannot belong to several: unless ``camera_size`` states
        it, it belongs to that of the first setup, as it does where this is the only one. The fields
        of the sets take the place of the setups' own.

        Raises UsageError or InputError for what is not there or cannot be listed."""
        first = setups[0].size if len(setups) > 1 else None
        asked: list[EvaluationRequest] = []
        for set_name, path in self.sets:
            source = files.enter_context(self._annotations(path, fields[set_name]))
            own_setups = [_with_field(setup, fields[set_name], first) for setup in setups]
            grouping = tags.grouping(by, set_name) if tags else Grouping(by)
            for method in self.methods:
                spec = method.for_set(set_name)
                cameras = CameraCollection.open(spec.path, spec.format)
                files.enter_context(cameras)
                asked += [
                    EvaluationRequest(
                        set_name, method.name, source, cameras, setup, grouping, camera_size
                    )
                    for setup in own_setups
                ]
        return asked

    def _annotations(self, path: Path, field: Field) -> FileSource:
        return open_annotations(path, field, self.field_options.names(field))

    def frames(self, fields: Mapping[str, Field]) -> dict[str, tuple[str, ...]]:
        """The annotated frames of each set; fields as of `open`."""
        found = {}
        for name, path in self.sets:
            with self._annotations(path, fields[name]) as source:
                found[name] = tuple(list_annotations(source))
        return found

    def remarks(self, fields: Mapping[str, Field], sizes: Sequence[tuple[int, int]]) -> list[str]:
        """On pictures next to the annotations that have another shape than these sizes."""
        said = []
        frames_of = self.frames(fields)
        for name, path in self.sets:
            frames = list(frames_of[name])
            of = f"{name}: " if len(self.sets) > 1 else ""
            said += [of + line for line in pictures_of_another_shape(path, frames, sizes)]
        return said


def _with_field(
    setup: EvaluationSetup, field: Field, unsized: tuple[int, int] | None
) -> EvaluationSetup:
    own = setup.field if setup.field == field else field  # what was computed of it is kept
    return replace(setup, field=own, unsized=unsized)


def set_name_of(annotations: Path) -> str:
    """Return what a set is called that was given by its annotations alone."""
    name = name_of(str(annotations))
    if name.casefold() in _ANY_SET:
        return annotations.resolve().parent.name or name
    return name


def print_all(scored: list[Scored]) -> None:
    """Everything about one evaluation, or several side by side; then their groups."""
    console = stdout_console()
    if len(scored) == 1:
        print_scores(scored[0])
    else:
        rows = [EvaluationRow((s.set_name, s.method), s.described, s.summaries) for s in scored]
        console.print(evaluations_table("Evaluations", ("set", "method"), rows))
    fits = [(" ".join(filter(None, (s.set_name, s.method))) or "cameras", s) for s in scored]
    for size in dict.fromkeys(s.setup.size for s in scored):
        of_size = [(name, s) for name, s in fits if s.setup.size == size]
        taus = list(of_size[0][1].summaries)
        held_out = left_out_table(of_size, taus, of_size[0][1].setup)
        if held_out is not None:
            console.print(held_out)
    for by in dict.fromkeys(group.by for s in scored for group in s.groups):
        rows = [
            EvaluationRow((group.value or "–", s.set_name, s.method), s.described, group.summaries)
            for s in scored
            for group in s.groups
            if group.by == by
        ]
        console.print(evaluations_table(f"By {by}", (by, "set", "method"), rows))


def print_inference(results: Sequence[StatisticalResult]) -> None:
    """The sheets of every set."""
    console = stdout_console()
    for one in results:
        for sheet in one.sheets:
            named = f"{one.set_name}: {sheet.title}" if len(results) > 1 else sheet.title
            console.print(replace(sheet, title=named))


def print_scores(scored: Scored) -> None:
    """The tables of one set."""
    console = stdout_console()
    frames = pluralize(scored.frames, "frame")
    title = f"Summary of {frames}, {scored.with_camera} with a camera"
    console.print(score_tables.summary_table(scored.summaries, scored.described, title=title))
    if scored.worst:
        console.print(
            score_tables.worst_frames_table(scored.worst, scored.first_threshold, scored.described)
        )
    console.print(score_tables.classes_table(scored.summaries, scored.described))


def report_problems(scored: list[Scored]) -> int:
    """Say on stderr what could not be used; returns the exit code."""
    for one in scored:
        of = f"{one.set_name}, {one.method}: " if len(scored) > 1 else ""
        report_notices({f"{of}{notice}": count for notice, count in one.notices.items()})
        if one.unmatched_cameras:
            counted = list_names(one.unmatched_cameras, "camera")
            echo(f"note: {of}without annotation, not counted: {counted}", err=True)
    # The annotations of a set are read for every method and size.
    sets = {one.set_name: one for one in scored}
    for name, one in sets.items():
        of = f"{name}: " if len(sets) > 1 else ""
        report_remarks(f"{of}{note}" for note in one.annotation_notes)
    errors = dict.fromkeys(error for one in scored for error in one.errors)
    return report_unreadable(list(errors))
