"""``procc-annotator field-size``: the dimensions of the field from all frames of a stadium."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.joint_calibration import FieldSize, find_field_sizes
from procc_annotator.calibration.fitting import require_known_model
from procc_annotator.calibration.joint.field_dimensions import fittable_dimensions
from procc_annotator.cli import options
from procc_annotator.cli.console import progress_bar, stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.remarks import report_remarks, report_set, report_unreadable
from procc_annotator.cli.set_fits import FittedFrames, fit_set, fit_sizes
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import (
    add_dimensions,
    read_stadiums,
    store_field,
    write_stadiums,
)
from procc_annotator.dataset.layout import STADIUMS_FILE, annotations_of, folder_of_dataset
from procc_annotator.dataset.records import default_author
from procc_annotator.errors import SaveError, UsageError
from procc_annotator.field.load import with_stadiums
from procc_annotator.field.model import Field, Stadiums
from procc_annotator.messages import first_names, pluralize
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report import joint_calibration

HELP = """\
DATASET is a dataset folder, or a folder or zip archive of annotations of one stadium, or of several
that --groups or its stadiums.csv names. Length and width (or --dimension) are estimated jointly
with the cameras of all frames. A dimension with a standard deviation above 0.5 m is reported as not
determined and keeps its value.

--save stores the dimensions in the workspace of the dataset, or in stadiums.csv for several
stadiums; window and commands then use them. The official evaluation uses nominal ones, as does
--field with the name alone. Dimensions of a single frame are never stored.

Exit code: 0; 1 if some annotations were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator field-size sample_data
  procc-annotator field-size sample_data --dimension length --save
"""


def field_size(
    dataset: options.AnnotatedSet,
    field_options: options.FieldOptions,
    groups: options.Groups = None,
    dimension: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME", help="Dimension to fit; repeat for several.  [default: length, width]"
        ),
    ] = None,
    model: options.PosedModel = "R",
    save: Annotated[
        bool, typer.Option("--save", help="Keep the dimensions with the dataset.")
    ] = False,
    threshold: options.Thresholds = None,
    protocol: options.Protocol = "soccernet",
    size: options.FitSize = None,
    workers: options.FitWorkers = None,
    dask: options.Dask = None,
) -> None:
    require_known_model(model)
    field = field_options.of(dataset)
    setup = options.setup_for(field, size, protocol, "left_out", mirrored=False)
    names = fittable_dimensions(field, dimension)
    thresholds = options.thresholds_or_default(threshold)
    place = annotations_of(dataset)
    kept_in = _workspace_of(dataset) if save else None
    if kept_in is not None and groups is not None:
        _kept_stadiums(kept_in, field)  # said before anything is fitted
    with open_annotations(place, field, field_options.names(field)) as source:
        report_set(source, field)
        sizes = fit_sizes(source, place, dataset, size)
        fitted = fit_set(source, dataset, setup, sizes, model, groups, workers, dask)
    with progress_bar("field size") as progress:
        found = find_field_sizes(fitted.fits, fitted.frames, setup, thresholds, names, progress)
    said: list[str] = []
    try:  # before the table: whoever reads it may stop after the first lines
        if kept_in is not None:
            said = _save(kept_in, field, found, fitted.fits.groups or {})
    finally:
        _print_sizes(found, fitted, setup)
    for line in said:
        echo(line)
    errors = [frame.error for frame in fitted.frames if frame.error is not None]
    raise typer.Exit(report_unreadable(errors))


def _print_sizes(sizes: list[FieldSize], fitted: FittedFrames, setup: EvaluationSetup) -> None:
    used = fitted.fits.sizes_of(fitted.frames)
    conditions = setup.describe(sizes=used.describe())
    described = f"{fitted.fits.describe(fitted.frames)}, {conditions}"
    stdout_console().print(joint_calibration.field_sizes_table(sizes, described))
    report_remarks(used.remarks())
    for found in sizes:
        for remark in joint_calibration.remarks(found):
            echo(f"note: {remark}", err=True)
    if fitted.fits.groups is not None:
        lonely = sum(fitted.fits.groups.get(f.name) is None for f in fitted.frames)
        if lonely:
            echo(f"note: frames without a group take no part: {lonely}", err=True)


def _workspace_of(dataset: Path) -> Path:
    """The folder whose workspace the window and the other commands read."""
    folder = folder_of_dataset(dataset)
    if folder is None:
        raise UsageError(f"{dataset}: is an archive, --save needs a folder, which has a workspace")
    return folder


def _save(
    dataset: Path, field: Field, sizes: list[FieldSize], groups: Mapping[str, str | None]
) -> list[str]:
    """Keep the dimensions of each stadium and of frames without one; return a line for each."""
    named, of_set = [s for s in sizes if s.group], [s for s in sizes if not s.group]
    said, problems = [], []
    try:
        said += [_save_stadiums(dataset, field, named, groups)] if named else []
    except UsageError as error:
        problems.append(str(error))
    try:
        said += [_save_of_set(dataset, field, size) for size in of_set]
    except UsageError as error:
        problems.append(str(error))
    if not said:
        raise UsageError("; ".join(problems))
    for problem in problems:
        echo(f"note: {problem}", err=True)
    return said


def _save_of_set(dataset: Path, field: Field, size: FieldSize) -> str:
    """Keep the dimensions that are determined, next to those kept before; return what and where."""
    if size.stadium is not None and size.stadium.frames == 1:
        raise UsageError(
            "nothing kept: a single frame determines no dimensions, they absorb what belongs to its"
            " camera; annotate more frames of the stadium"
        )
    values = size.stadium.values if size.stadium is not None else {}
    if not values:
        raise UsageError("nothing to save: no dimension is determined")
    database = WorkspaceDatabase.open(dataset, default_author())
    try:
        sized = add_dimensions(database, field, values)
        store_field(database, dataset, sized)
    finally:
        written = database.close()
    if not written or database.problem:
        raise SaveError(f"{dataset}: {database.problem or 'the dimensions were not written'}")
    if (dataset / STADIUMS_FILE).is_file():
        echo(f"note: frames in {dataset / STADIUMS_FILE} go by the dimensions there", err=True)
    return f"kept in the workspace of {dataset}: {sized.described}"


def _kept_stadiums(dataset: Path, field: Field) -> Stadiums:
    """Return what was kept before; raises `InputError` where that cannot be used."""
    path = dataset / STADIUMS_FILE
    return read_stadiums(path, field) if path.is_file() else Stadiums({}, {})


def _save_stadiums(
    dataset: Path, field: Field, sizes: list[FieldSize], groups: Mapping[str, str | None]
) -> str:
    """Keep the dimensions of each stadium, next to those of others; return what and where."""
    found = {
        size.group: size.stadium.values
        for size in sizes
        if size.stadium is not None and size.stadium.values and size.stadium.frames > 1
    }
    if not found:
        raise UsageError(
            "nothing to save: no dimension of a stadium with several frames is determined"
        )
    path = dataset / STADIUMS_FILE
    known = _kept_stadiums(dataset, field)
    frames = {f: s for f, s in known.frames.items() if groups.get(f) in (None, s)}
    frames |= {frame: group for frame, group in groups.items() if group in found}
    dimensions = {s: {**known.dimensions.get(s, {}), **found.get(s, {})} for s in frames.values()}
    stadiums = Stadiums(frames, dimensions)
    with_stadiums(field, stadiums)  # a field can have them, or nothing is written
    write_stadiums(path, stadiums)
    counted = f"{pluralize(len(found), 'stadium')}, {pluralize(len(frames), 'frame')}"
    left_out = sorted({s.group for s in sizes} - found.keys())
    if left_out:
        echo(
            f"note: not determined, or of a single frame, and not kept: {first_names(left_out)}",
            err=True,
        )
    return f"written: {path} ({counted})"
