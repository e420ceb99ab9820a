"""Write and re-open the run manifest of a command."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, cast

import typer

from procc_annotator.batch.execution.executor import Executor
from procc_annotator.batch.grouping import Tags
from procc_annotator.cli.inference_options import cluster_of, orders_by_set
from procc_annotator.cli.options import chosen_field, named_field
from procc_annotator.cli.temporal_options import TemporalRequest
from procc_annotator.dataset.annotation_source import ReadSource
from procc_annotator.dataset.dataset_field import field_of_dataset
from procc_annotator.dataset.landmarks.dataset_landmarks import field_of_dataset_with_landmarks
from procc_annotator.dataset.layout import FRAMES_FILE, STADIUMS_FILE, VIEWS_FILE, folder_of_dataset
from procc_annotator.dataset.picture_sizes import PictureSizes, picture_folders, picture_tree
from procc_annotator.errors import InputError
from procc_annotator.field.load import (
    field_fingerprint,
    field_names,
    load_field,
    with_lines,
    with_stadiums,
)
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LabelMap, read_label_map
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import FileSource, read_file
from procc_annotator.formats.landmark_file import LANDMARKS_FILE
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.statistics.intervals import IntervalMethodName
from procc_annotator.report.run_manifest import (
    FORMAT,
    ManifestEvaluation,
    ManifestField,
    ManifestFile,
    ManifestInference,
    ManifestInput,
    ManifestTemporal,
    RunManifest,
    hashed,
    manifest_field,
    manifest_inference,
    over_time_rows,
    set_figures,
)
from procc_annotator.report.scores.inference import InferenceSettings, StatisticalResult
from procc_annotator.report.scores.scoring import EvaluationRequest
from procc_annotator.report.temporal import TemporalMetrics
from procc_annotator.version import __version__


@dataclass(frozen=True)
class FurtherResults:
    """What a command made besides the figures of each set.

    Attributes:
        chance, told: what was asked of chance, and what it said.
        over_time, steady: the same over time.
    """

    chance: InferenceSettings | None = None
    told: Sequence[StatisticalResult] = ()
    over_time: TemporalRequest | None = None
    steady: Sequence[TemporalMetrics] = ()

    def frame_tables(self, asked: Sequence[EvaluationRequest]) -> set[Path]:
        """The tables of frames that were used without being named."""
        if self.chance is None and self.over_time is None:
            return set()
        folders = (folder_of_dataset(one.annotations.path) for one in asked)
        tables = (folder / FRAMES_FILE for folder in folders if folder is not None)
        return {table for table in tables if table.is_file()}


def inference_settings_again(
    known: ManifestInference, recipe: RunManifest, root: Path
) -> InferenceSettings:
    """What a recipe asks of chance, elsewhere.

    Raises:
        UsageError, InputError: a file of tags or frames cannot be used.
    """
    sets = {one.set: root / one.annotations for one in recipe.evaluations}
    tags = None if known.tags is None else Tags.read(root / known.tags)
    shots = None if known.shots is None else root / known.shots
    return InferenceSettings(
        cluster_of(known.cluster, tags), tags, orders_by_set(sets, shots), known.draws,
        cast(IntervalMethodName, known.method), known.power, known.noise, known.by,
    )  # fmt: skip


def temporal_again(
    known: ManifestTemporal, root: Path, asked: Sequence[EvaluationRequest], executor: Executor
) -> list[TemporalMetrics] | str:
    """The figures over time, elsewhere; or why they cannot be made.

    Raises:
        UsageError, InputError: a table of frames cannot be used.
    """
    pictures = None if known.pictures is None else root / known.pictures
    if pictures is not None and not pictures.exists():
        return f"not repeated: over time: {known.pictures} is not here"
    shots = None if known.shots is None else root / known.shots
    return TemporalRequest(shots, pictures, ()).run(asked, known.threshold, executor)


LABELS_ROLE = LABELS_OPTION = "labels"

ManifestOption = Annotated[
    Path | None,
    typer.Option(
        "--recipe",
        metavar="FILE.json",
        show_default=False,
        help="Write what the figures were made from, with the SHA-256 of every file, so that"
        " `procc-annotator repeat` makes them again.",
    ),
]


@dataclass(frozen=True)
class FieldArguments:
    """What was asked of the field: the text of ``--field`` and of ``--lines``."""

    given: str | None
    lines: str | None

    @property
    def file(self) -> Path | None:
        """The field's file, where it was named by one."""
        if self.given is None:
            return None
        path = Path(named_field(self.given)[0])
        return path if path.is_file() else None


@dataclass(frozen=True)
class ManifestRequest:
    """A recipe that was asked for.

    Attributes:
        path: of the file.
        context: of the command, with what was typed.
        field: what was asked of the field.
        beside: files that were read beside sets and sources, with their roles.
    """

    path: Path
    context: typer.Context
    field: FieldArguments
    beside: tuple[tuple[str, Path], ...] = ()

    def write(
        self,
        asked: Sequence[EvaluationRequest],
        summaries: Sequence[Mapping[float, SetSummary]],
        further: FurtherResults | None = None,
    ) -> None:
        """Write it.

        Args:
            asked: what was evaluated, still open.
            summaries: their figures, in the same order.
            further: what was made besides.

        Raises:
            InputError: an input cannot be read any more.
            SaveError: it cannot be written.
        """
        further, own_file = further or FurtherResults(), self.field.file
        maps = {m.path for m in (map_of(one.annotations) for one in asked) if m is not None}
        stadiums = {p for one in asked if (p := stadiums_of(one)) is not None}
        landmarks = {told for one in asked for told in landmarks_of(one)}
        more = [
            *((("field", own_file),) if own_file is not None else ()),
            *self.beside,
            *((LABELS_ROLE, path) for path in sorted(maps)),
            *(("stadiums", path) for path in sorted(stadiums)),
            *sorted(landmarks),
            *(("frames", path) for path in sorted(further.frame_tables(asked))),
        ]
        paths = [p for one in asked for p in (one.annotations.path, one.cameras.path)]
        root = common_folder([*paths, *(path for _, path in more)])
        found: dict[tuple[str, Path], ManifestInput] = {}
        for one in asked:
            for role, source in (("annotations", one.annotations), ("cameras", one.cameras)):
                if (role, source.path) not in found:
                    found[role, source.path] = hashed_input(role, source, root)
        for role, path in more:
            files = (hashed(".", read_file(path)),)
            found[role, path] = ManifestInput(role, relative(path, root), files)
        recipe = RunManifest(
            FORMAT,
            __version__,
            str(self.context.info_name),
            _typed_options(self.context),
            tuple(found.values()),
            tuple(
                evaluation_of(one, figures, self.field, root)
                for one, figures in zip(asked, summaries, strict=True)
            ),
            *self._further(further, asked, root),
        )
        write_atomic(self.path, recipe.encoded())

    def _further(
        self, made: FurtherResults, asked: Sequence[EvaluationRequest], root: Path
    ) -> tuple[ManifestInference | None, ManifestTemporal | None]:
        """The figures besides those of each set."""
        files = {role: relative(path, root) for role, path in self.beside}
        tags, shots = files.get("tags"), files.get("shots")
        chance = over_time = None
        if made.chance is not None:
            chance = manifest_inference(made.chance, made.told, tags, shots)
        if made.over_time and made.steady:
            pictures = made.over_time.pictures
            over_time = ManifestTemporal(
                made.steady[0].threshold, shots,
                None if pictures is None else relative(pictures, root),
                over_time_rows(made.steady),
            )  # fmt: skip
        return chance, over_time


def manifest_request(
    path: Path | None,
    context: typer.Context,
    field: FieldArguments,
    beside: Mapping[str, Path | None],
) -> ManifestRequest | None:
    """The recipe that was asked for, if one was.

    Args:
        beside: role -> what was read beside sets and sources, where there is such a file.
    """
    if path is None:
        return None
    files = tuple((role, file) for role, file in beside.items() if file is not None)
    return ManifestRequest(path, context, field, files)


def evaluation_of(
    one: EvaluationRequest, summaries: Mapping[float, SetSummary], field: FieldArguments, root: Path
) -> ManifestEvaluation:
    """One evaluation with its figures."""
    setup, given = one.setup, field.given
    if field.file is not None and given is not None:
        given = given.replace(named_field(given)[0], relative(field.file, root))
    return ManifestEvaluation(
        one.set_name,
        one.method,
        relative(one.annotations.path, root),
        relative(one.cameras.path, root),
        one.cameras.format,
        manifest_field(setup.field, given, field.lines),
        setup.size,
        setup.protocol,
        setup.off_plane,
        setup.allow_mirrored,
        setup.planar_only,
        tuple(summaries),
        one.camera_size,
        setup.unsized,
        _picture_sizes(one.annotations),
        set_figures(summaries),
    )


def stadiums_of(one: EvaluationRequest) -> Path | None:
    """The file that gives frames the dimensions of their stadiums; None where none does."""
    folder = folder_of_dataset(one.annotations.path)
    used = one.setup.field.stadiums is not None and folder is not None
    return folder / STADIUMS_FILE if used and folder is not None else None


def landmarks_of(one: EvaluationRequest) -> list[tuple[str, Path]]:
    """The files that tell a set's landmarks and what is seen of them, with their roles."""
    folder = folder_of_dataset(one.annotations.path)
    if folder is None or not one.setup.field.landmarks:
        return []
    told = (("landmarks", folder / LANDMARKS_FILE), ("views", folder / VIEWS_FILE))
    return [(role, path) for role, path in told if path.is_file()]


def map_of(annotations: FileSource) -> LabelMap | None:
    """By which map the names of another program were read; None without."""
    return annotations.labels if isinstance(annotations, ReadSource) else None


def reopen_label_map(known: RunManifest, root: Path, field: Field) -> LabelMap | None:
    """The map that a recipe was given, elsewhere; None leaves it to the datasets.

    Raises:
        InputError: it cannot be used.
    """
    if LABELS_OPTION not in known.options:
        return None
    paths = [one.path for one in known.inputs if one.role == LABELS_ROLE]
    return read_label_map(root / paths[0], field) if paths else None


def reopen_field(asked: ManifestField, root: Path, dataset: Path) -> Field:
    """The field of a recipe, elsewhere.

    What a set's workspace kept of it need not be there: where the set says nothing here, it is the
    field of the name, dimensions and lines that the recipe tells, if these make the same one.

    Raises:
        FieldError: it cannot be used.
    """
    given = asked.given
    if given is not None:
        name = named_field(given)[0]
        if (root / name).is_file():
            given = given.replace(name, str(root / name))
    shown = chosen_field(given, dataset, lines=asked.lines)
    if given is not None or field_fingerprint(shown) == asked.sha256:
        return shown
    said = field_of_dataset(dataset)
    silent = not said.chosen or with_stadiums(said.field, None) == load_field()
    if not silent or asked.name not in field_names():
        return shown
    told = with_lines(load_field(asked.name, **asked.dimensions), asked.at or shown.lines)
    if shown.name == asked.name:
        told = with_stadiums(told, shown.stadiums)
    told = field_of_dataset_with_landmarks(told, dataset)
    return told if field_fingerprint(told) == asked.sha256 else shown


def common_folder(paths: Iterable[Path]) -> Path:
    """The folder that holds all inputs; an input may be this folder itself."""
    whole = [os.path.abspath(path) for path in paths]
    common = Path(os.path.commonpath(whole))
    return common if common.is_dir() else common.parent


def relative(path: Path, root: Path) -> str:
    """A path as a recipe has it."""
    return Path(os.path.relpath(os.path.abspath(path), root)).as_posix()


def hashed_input(role: str, source: FileSource | CameraCollection, root: Path) -> ManifestInput:
    """An input with the SHA-256 of what is read of it; an archive is one file.

    Raises:
        InputError: a file cannot be read.
    """
    path = source.path
    if not path.is_dir():
        return ManifestInput(role, relative(path, root), (hashed(".", read_file(path)),))
    if isinstance(source, CameraCollection):
        names = sorted(os.path.relpath(file, path) for file in source.files())
        names += source.beside()
    else:
        names = sorted(source.decoded or list_annotations(source).values())
    files = [_hashed_file(path, Path(name).as_posix()) for name in names]
    return ManifestInput(role, relative(path, root), tuple(f for f in files if f is not None))


def _hashed_file(folder: Path, name: str) -> ManifestFile | None:
    try:
        return hashed(name, read_file(folder / name))
    except InputError:  # an unreadable one is listed by the command, and has no content
        return None


def _picture_sizes(annotations: FileSource) -> dict[str, int]:
    place = annotations.path
    sizes = PictureSizes(picture_folders(place, place), tree=picture_tree(place))
    known = (sizes.size(name) for name in list_annotations(annotations))
    return dict(sorted(Counter(f"{s[0]}x{s[1]}" for s in known if s is not None).items()))


def _typed_options(context: typer.Context) -> dict[str, Any]:
    """What was typed, by the names of the parameters; of paths the last part only."""
    found: dict[str, Any] = {}
    for name, value in sorted(context.params.items()):
        source = context.get_parameter_source(name)
        if source is not None and source.name == "COMMANDLINE" and name != "recipe":
            found[name] = _plain(value)
    return found


def _plain(value: Any) -> Any:
    if isinstance(value, list | tuple):
        return [_plain(one) for one in value]
    if isinstance(value, Path):
        return value.name or "."
    if isinstance(value, str):
        name, equals, path = value.rpartition("=")
        return f"{name}{equals}{Path(path).name or path}"
    return value


def evaluated_here(
    one: ManifestEvaluation, summaries: Mapping[float, SetSummary], again: EvaluationRequest
) -> Any:
    """The evaluation as it is here."""
    field = manifest_field(again.setup.field, one.field.given, one.field.lines)
    return replace(
        one,
        field=field,
        picture_sizes=_picture_sizes(again.annotations),
        figures=set_figures(summaries),
    )
