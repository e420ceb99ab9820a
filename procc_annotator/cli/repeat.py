"""``procc-annotator repeat``: make the figures of a recipe again, and say what differs."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.cli import options, outputs
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.manifest import (
    evaluated_here,
    hashed_input,
    inference_settings_again,
    reopen_field,
    reopen_label_map,
    temporal_again,
)
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import read_file
from procc_annotator.messages import pluralize
from procc_annotator.report.run_manifest import (
    ManifestEvaluation,
    ManifestInput,
    RunManifest,
    differing_figures,
    differing_files,
    differing_inference,
    differing_over_time,
    hashed,
    read_manifest,
    setup_of,
)
from procc_annotator.report.scores.scoring import EvaluationRequest, Evaluations, RequestedOutputs
from procc_annotator.report.tables.data_files import json_bytes
from procc_annotator.version import __version__

HELP = """\
RECIPE is what evaluate or report wrote with --recipe. Its inputs are looked for by their relative
paths in --data DIR; without it beside the recipe, in the folder above it, and in the current one.

Every file is held against its SHA-256, everything is evaluated again, and what differs is listed:
a missing file, other content, a file that the recipe does not know, another field, another figure.

Exit code: 0 if nothing differs; 1 if something does; 2 if it cannot be repeated.
"""

EXAMPLE = """
Example:

\b
  procc-annotator evaluate wc14/annotations wc14/cameras_pnlcalib --recipe wc14.json
  procc-annotator repeat wc14.json --data downloads/wc14
"""

_LISTED = 50


def repeat(
    recipe: Annotated[
        Path, typer.Argument(metavar="RECIPE", help="The recipe, a JSON file.", show_default=False)
    ],
    data: Annotated[
        Path | None,
        typer.Option(metavar="DIR", show_default=False, help="Folder that holds all inputs."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(metavar="FILE.json", show_default=False, help="Write what differs."),
    ] = None,
    workers: options.Workers = None,
    dask: options.Dask = None,
) -> None:
    if output is not None:
        outputs.check_output_folder(output)
    known = read_manifest(recipe)
    root = _root(known, recipe, data)
    differences = _other_version(known)
    with ExitStack() as opened:
        asked, found = _open(known, root, opened)
        differences += found
        again, more = _reevaluate(known, root, asked, workers, dask)
    for was, now in zip(known.evaluations, again, strict=True):
        differences += differing_figures(was, now)
    differences += more
    _print_differences(known, differences)
    if output is not None:
        write_atomic(output, json_bytes({"recipe": recipe.name, "differences": differences}))
        echo(f"written: {output}")
    raise typer.Exit(1 if differences else 0)


def _root(known: RunManifest, recipe: Path, data: Path | None) -> Path:
    """The folder of the inputs.

    Raises:
        UsageError: there is none.
    """
    if not known.evaluations or not known.inputs:
        raise UsageError(f"{recipe}: holds no evaluation")
    if any(_leads_out(one.path) for one in known.inputs):
        raise UsageError(f"{recipe}: names paths outside of its folder")
    beside = recipe.absolute().parent
    places = [data] if data is not None else [beside, beside.parent, Path.cwd()]
    paths = {path for one in known.evaluations for path in (one.annotations, one.cameras)}
    for place in places:
        missing = [path for path in sorted(paths) if not (place / path).exists()]
        if not missing:
            return place
    raise UsageError(
        f"{missing[0]}: is not in {data}; --data names the folder that it lies in by that path"
        if data is not None
        else f"{missing[0]}: is not beside the recipe; say where with --data DIR"
    )  # fmt: skip


def _leads_out(path: str) -> bool:
    return Path(path).is_absolute() or ".." in Path(path).parts


def _other_version(known: RunManifest) -> list[str]:
    own = __version__
    return [] if known.version == own else [f"other version: {own}, was {known.version}"]


def _open(
    known: RunManifest, root: Path, opened: ExitStack
) -> tuple[list[EvaluationRequest], list[str]]:
    """The evaluations with what is here, and which files differ.

    Raises:
        UsageError, InputError: an input is not there at all, or cannot be opened.
    """
    asked: list[EvaluationRequest] = []
    here: dict[tuple[str, str], ManifestInput] = {}
    for one in known.evaluations:
        for path in (one.annotations, one.cameras):
            if _leads_out(path):
                raise UsageError(f"{path}: leads out of the folder of the inputs")
        cameras = opened.enter_context(CameraCollection.open(root / one.cameras, one.format))
        place = root / one.annotations
        shown = reopen_field(one.field, root, place)
        names = reopen_label_map(known, root, shown)
        annotations = opened.enter_context(open_annotations(place, shown, names))
        asked.append(
            EvaluationRequest(
                one.set, one.source, annotations, cameras, setup_of(one, shown),
                camera_size=one.camera_size,
            )
        )  # fmt: skip
        for role, path, source in (
            ("annotations", one.annotations, annotations),
            ("cameras", one.cameras, cameras),
        ):
            if (role, path) not in here:
                here[role, path] = hashed_input(role, source, root.absolute())
    differences: list[str] = []
    for wanted in known.inputs:
        now = here.get((wanted.role, wanted.path)) or _single(wanted, root)
        differences += differing_files(wanted, now)
    return asked, differences


def _single(wanted: ManifestInput, root: Path) -> ManifestInput:
    try:
        file = hashed(".", read_file(root / wanted.path))
    except InputError:
        return ManifestInput(wanted.role, wanted.path, ())
    return ManifestInput(wanted.role, wanted.path, (file,))


def _reevaluate(
    known: RunManifest,
    root: Path,
    asked: Sequence[EvaluationRequest],
    workers: int | None,
    dask: str | None,
) -> tuple[list[ManifestEvaluation], list[str]]:
    """The evaluations as they are here, and what of the other figures differs."""
    different: list[str] = []
    terms = None if known.chance is None else inference_settings_again(known.chance, known, root)
    outcome = RequestedOutputs(named=len(asked) > 1, chance=terms)
    evaluations = Evaluations.prepare(asked, _thresholds(known), outcome)
    with make_executor(workers, dask, frames=evaluations.frames) as executor:
        scored = evaluations.score(executor, progress=with_progress)
        if known.over_time is not None:
            found = temporal_again(known.over_time, root, asked, executor)
            if isinstance(found, str):
                different.append(found)
            else:
                different += differing_over_time(known.over_time, found)
    if known.chance is not None:
        different += differing_inference(known.chance, evaluations.told)
    again = [
        evaluated_here(was, own.summaries, one)
        for was, own, one in zip(known.evaluations, scored, asked, strict=True)
    ]
    return again, different


def _thresholds(known: RunManifest) -> tuple[float, ...]:
    """Of all evaluations: those of a command have the same.

    Raises:
        UsageError: they have not.
    """
    found = {one.thresholds for one in known.evaluations}
    if len(found) > 1:
        raise UsageError("the recipe's evaluations have different thresholds: no command does that")
    return found.pop()


def _print_differences(known: RunManifest, differences: Sequence[str]) -> None:
    for line in differences[:_LISTED]:
        echo(line)
    if (more := len(differences) - _LISTED) > 0:
        echo(f"... and {pluralize(more, 'more difference')}")
    files = sum(len(one.files) for one in known.inputs)
    figures = sum(len(f) for one in known.evaluations for f in one.figures.values())
    if known.chance is not None:
        sheets = [rows for one in known.chance.told for rows in one.values()]
        figures += sum(len(row) for rows in sheets for row in rows)
    if known.over_time is not None:
        figures += sum(len(row) for row in known.over_time.rows)
    if not differences:
        echo(
            f"the same: {pluralize(files, 'file')} and {pluralize(figures, 'figure')} of"
            f" {pluralize(len(known.evaluations), 'evaluation')}"
        )
