"""Which sets, methods and sizes a call of ``evaluate`` asks for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

from procc_annotator.cli.field_option import chosen_field
from procc_annotator.cli.options import label_map
from procc_annotator.cli.sources import (
    SourceSpec,
    name_of,
    parse_named,
    parse_sources,
    require_distinct,
)
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.scores.scoring import EvaluationRequest
from procc_annotator.session.dataset.annotation_source import open_annotations
from procc_annotator.session.dataset.dataset_folder import annotations_of
from procc_annotator.session.dataset.fit_sizes import pictures_of_another_shape
from procc_annotator.session.runs.tags import Grouping, Tags

# Folders of annotations are often called so; then the folder they lie in names the set.
_ANY_SET = frozenset({"annotations", "labels", "gt", "ground_truth"})


@dataclass(frozen=True)
class Plan:
    """Sets and methods, by name; every method is scored on every set.

    Attributes:
        named: whether they were named, so that files have to tell which is which.
        labels: file of what names of another program stand for; None: as the sets say.
    """

    sets: tuple[tuple[str, Path], ...]
    methods: tuple[SourceSpec, ...]
    named: bool
    labels: Path | None = None

    @classmethod
    def of(
        cls,
        annotations: Path | None,
        cameras: Path | None,
        sets: Sequence[str],
        sources: Sequence[str],
        camera_format: str,
        labels: Path | None = None,
    ) -> Plan:
        """Read the arguments.

        Raises:
            UsageError: something is missing or given twice, or two have the same name.
        """
        if (annotations is None) == (not sets):
            raise UsageError(
                "annotations are needed: ANNOTATIONS for one set,"
                " or --set NAME=ANNOTATIONS for each of several"
                if annotations is None
                else f"{annotations}: name it too, with --set NAME=ANNOTATIONS, beside other sets"
            )
        if (cameras is None) == (not sources):
            raise UsageError(
                "cameras are needed: CAMERAS for one method,"
                " or --cameras NAME=PATH for each of several"
                if cameras is None
                else f"{cameras}: name it too, with --cameras NAME=PATH, beside other --cameras"
            )
        chosen = tuple(parse_named(text, "NAME=ANNOTATIONS") for text in sets)
        if annotations is not None:
            chosen = ((set_name_of(annotations), annotations),)
        require_distinct((name for name, _ in chosen), "sets")
        chosen = tuple((name, annotations_of(path)) for name, path in chosen)
        methods = parse_sources(sources, camera_format)
        if cameras is not None:
            methods = (SourceSpec(name_of(str(cameras)), camera_format, cameras),)
        return cls(chosen, methods, bool(sets or sources), labels)

    def fields(self, named: str | None, lines: str | None) -> dict[str, Field]:
        """The field of each set: the one of the options, or else the set's own.

        Raises:
            FieldError: a field cannot be used.
        """
        return {name: chosen_field(named, path, lines=lines) for name, path in self.sets}

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

        A camera that names no picture size cannot belong to several: unless told, it belongs to
        that of the first setup, as it does where this is the only one.

        Args:
            files: closes it all.
            fields: of each set; it takes the place of the setups' own.
            by: what to group frames by.
            camera_size: picture size the cameras refer to, where their files do not say.

        Raises:
            UsageError, InputError: something is not there or cannot be listed.
        """
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
                    EvaluationRequest(set_name, method.name, source, cameras, setup, grouping, camera_size)
                    for setup in own_setups
                ]
        return asked

    def _annotations(self, path: Path, field: Field) -> FileSource:
        return open_annotations(path, field, label_map(self.labels, field))

    def frames(self, fields: Mapping[str, Field]) -> dict[str, tuple[str, ...]]:
        """The annotated frames of each set; fields as of `open`."""
        found = {}
        for name, path in self.sets:
            with self._annotations(path, fields[name]) as source:
                found[name] = tuple(list_annotations(source))
        return found

    def remarks(self, fields: Mapping[str, Field], sizes: Sequence[tuple[int, int]]) -> list[str]:
        """On pictures beside the annotations that have another shape than these sizes."""
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
    """What a set is called that was given by its annotations alone."""
    name = name_of(str(annotations))
    if name.casefold() in _ANY_SET:
        return annotations.resolve().parent.name or name
    return name
