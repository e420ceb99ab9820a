"""``procc-annotator triangulate``: landmarks of a dataset from clicks in several views."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from procc_annotator.cli import datasets, options, outputs
from procc_annotator.cli.field_option import read_field

if TYPE_CHECKING:
    from procc_annotator.annotation import FrameAnnotation
    from procc_annotator.field.model import Field
    from procc_annotator.io.landmark_file import LandmarkFile
    from procc_annotator.io.source import FileSource
    from procc_annotator.session.camera_set import CameraSet
    from procc_annotator.session.landmark_clicks import LocatedLandmark
    from procc_annotator.session.landmark_scan import FoundInDataset, Search
    from procc_annotator.session.view_groups import ViewGroups

HELP = """Find where landmarks are from clicks in several calibrated views.

DATASET is a dataset folder, or a folder or zip archive of annotations. Every class with one point a
frame that the field does not know is a landmark. What stays in its place is triangulated from all
frames; a moving object (--moving, or "moving" in landmarks.json) from the frames of each instant,
which views.csv in the dataset's folder tells (columns frame, instant, view), or --views, or
--pattern from the frames' names.

Cameras are those of --cameras, which are taken as they are; without it one is fitted to each
frame's annotation, and its uncertainty is part of the landmark's. Triangulated landmarks take no
part in these fits; surveyed ones do.

The positions are written to landmarks.json in the dataset's folder, which annotating, scoring,
fitting, checking and rendering then use. Positions that were surveyed are never changed, but
compared to their clicks; nor is what cannot be triangulated.

Exit code: 0; 1 if some annotations were unreadable (listed); 2 if there was nothing to do. A
landmark without a position is listed with the reason and is no error.
"""

EXAMPLE = """
Examples:

\b
  procc-annotator triangulate match/ --cameras match/cameras/
  procc-annotator triangulate match/ --pattern '{instant}_{view}' --moving Ball
  procc-annotator triangulate match/ --surveyed 'Floodlight NE=61.2,-45.0,-28.4'
"""


Cameras = Annotated[
    str | None,
    typer.Option(
        "--cameras",
        metavar="[NAME[:FORMAT]=]PATH",
        show_default=False,
        help="Cameras of the frames: folder, zip or file.  [default: fitted to the annotations]",
    ),
]
ViewsFile = Annotated[
    Path | None,
    typer.Option(
        "--views",
        metavar="FILE.csv",
        show_default=False,
        help="When each frame was taken, and by which camera.  [default: the dataset's views.csv]",
    ),
]
Pattern = Annotated[
    str | None,
    typer.Option(
        "--pattern",
        metavar="TEXT",
        show_default=False,
        help="The same from the frames' names: {instant}_{view}, or a regular expression with"
        " (?P<instant>...).",
    ),
]
Moving = Annotated[
    list[str] | None,
    typer.Option(
        "--moving", metavar="NAME", help="A landmark that moves; repeat for several.",
        show_default=False,
    ),
]  # fmt: skip
Surveyed = Annotated[
    list[str] | None,
    typer.Option(
        "--surveyed",
        metavar="NAME=X,Y,Z",
        show_default=False,
        help="A landmark whose place was measured, metres from the field's centre (z down); repeat"
        " for several.",
    ),
]
ClickPx = Annotated[
    float | None,
    typer.Option(
        "--click-px",
        metavar="PX",
        show_default=False,
        help="Standard deviation of a click and its camera together, px of --size.  [default: 1.5"
        " at 960 px, corrected by the residuals]",
    ),
]
Output = Annotated[
    Path | None,
    typer.Option(
        "--output",
        "-o",
        metavar="FILE.json",
        show_default=False,
        help="Write the landmarks here, and leave the dataset as it is, without a views.csv."
        "  [default: landmarks.json in the dataset's folder]",
    ),
]
Model = Annotated[
    str, typer.Option("--model", "-m", metavar="P|R|R+|auto", help="Camera to fit to each frame.")
]


def triangulate(
    dataset: options.AnnotatedSet,
    cameras: Cameras = None,
    views: ViewsFile = None,
    pattern: Pattern = None,
    moving: Moving = None,
    surveyed: Surveyed = None,
    output: Output = None,
    model: Model = "R",
    click_px: ClickPx = None,
    size: options.FitSize = None,
    field: options.FieldName = None,
    lines: options.Lines = None,
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
) -> None:
    from procc_annotator.errors import UsageError
    from procc_annotator.field.landmarks import with_landmarks
    from procc_annotator.io.source import open_source
    from procc_annotator.session.calibration_run import annotations_of
    from procc_annotator.session.dataset_landmarks import read_dataset_landmarks
    from procc_annotator.session.landmark_clicks import with_positions
    from procc_annotator.session.landmark_scan import Search

    _check(model, click_px)
    place = annotations_of(dataset)
    target = _target(dataset, output)
    known, groups = read_dataset_landmarks(dataset)
    shown = read_field(field, dataset, lines=lines)
    known = _with_surveyed(known, surveyed or (), shown)
    named = _named(surveyed or (), moving or (), shown)
    shown = with_landmarks(shown, known.landmarks)
    with open_source(place) as source:
        _refuse_classes_of_another_field(source, shown)
        groups = _groups(groups, source, views, pattern)
        _report_strange_rows(groups, source, dataset)
        search = Search(
            known, groups, _cameras(cameras, camera_format, camera_size), moving=moving or (),
            model=model, click_px=click_px, size=options.shown_size(size),
        )  # fmt: skip
        found = _locate(source, place, dataset, shown, search)
    if not found.located and not surveyed:
        raise UsageError(f"nothing to do: no landmark is clicked in {place}")
    if found.located:
        _print(found.located, cameras or f"fitted, model {model}")
    _report_not_clicked(named, found.located)
    # Somebody may have surveyed a landmark meanwhile.
    known = _with_surveyed(read_dataset_landmarks(dataset)[0], surveyed or (), shown)
    known = with_positions(known, found.located)
    _write(target, known)
    if views or pattern:
        _keep_groups(target, groups, dataset)
    raise typer.Exit(datasets.report_unreadable(list(found.problems)))


def _check(model: str, click_px: float | None) -> None:
    """Raise UsageError for what no camera can be fitted or no place be found with."""
    from procc_annotator.errors import UsageError
    from procc_annotator.fit.fitting import check_model

    check_model(model)
    if model == "H":
        raise UsageError("a homography tells no place in space: choose P, R, R+ or auto, not H")
    if click_px is not None and not click_px > 0:
        raise UsageError(f"--click-px must be a positive number of pixels, not {click_px:g}")


def _named(surveyed: Sequence[str], moving: Sequence[str], field: Field) -> dict[str, str]:
    """The landmarks that options name, and the option that does.

    Raises:
        UsageError: one that has two places, or one and moves; one that is a class of the field.
    """
    from procc_annotator.errors import UsageError
    from procc_annotator.session import landmark_edits

    named: dict[str, str] = {}
    for text in surveyed:
        name, _ = landmark_edits.parse_surveyed(text)
        if name in named:
            raise UsageError(
                f"--surveyed {text}: {name} has a place already: leave one of them out"
            )
        named[name] = "--surveyed"
    for name in map(str.strip, moving):
        if named.get(name) == "--surveyed":
            raise UsageError(
                f"--moving {name}: --surveyed says where it stays: leave one of them out"
            )
        try:
            landmark_edits.require_free(name, field)
        except UsageError as error:
            raise UsageError(f"--moving {name}: {error}") from error
        named[name] = "--moving"
    return named


def _report_not_clicked(named: Mapping[str, str], located: Iterable[LocatedLandmark]) -> None:
    from procc_annotator.field.words import did_you_mean

    clicked = {one.clicked.name.strip() for one in located}
    datasets.report_remarks(
        f"{option} {name}: it is clicked in no frame{did_you_mean(name, clicked)}"
        for name, option in named.items()
        if name not in clicked
    )


def _refuse_classes_of_another_field(source: FileSource, field: Field) -> None:
    """Raise UsageError where the set shows another field: its classes would become landmarks, and
    no field can be chosen that has a class of a landmark's name."""
    from procc_annotator.errors import UsageError
    from procc_annotator.session.field_match import classes_of_source

    classes = classes_of_source(source, field)
    mismatch, _ = datasets.mismatch_at(classes, field, source.path)
    if mismatch is None or mismatch.better is None:
        return
    datasets.tell_mismatch(classes, field, source.path)
    raise UsageError(
        f"nothing was triangulated: classes of {mismatch.better.title} are no landmarks (one that"
        " is a landmark all the same: name it in landmarks.json)"
    )


def _with_surveyed(known: LandmarkFile, measured: Iterable[str], field: Field) -> LandmarkFile:
    """With measured positions; what else is known of the landmarks stays.

    Raises:
        UsageError: one that is not written as ``NAME=X,Y,Z``, cannot be, moves, or is a class of
            the field.
    """
    from procc_annotator.errors import UsageError
    from procc_annotator.session import landmark_edits

    for text in measured:
        try:
            name, position = landmark_edits.parse_surveyed(text)
            landmark_edits.require_free(name, field)
            known = landmark_edits.surveyed(known, name, position)
        except UsageError as error:
            raise UsageError(f"--surveyed {text}: {error}") from error
    return known


def _target(dataset: Path, output: Path | None) -> Path:
    """Where the landmarks are written to.

    Raises:
        UsageError: nowhere.
    """
    from procc_annotator.errors import UsageError
    from procc_annotator.io.landmark_file import LANDMARKS_FILE
    from procc_annotator.session.dataset_folder import folder_of_dataset

    if output is not None:
        if output.suffix.lower() != ".json":
            raise UsageError(f"{output}: landmarks are written as .json, end the name so")
        outputs.check_output_folder(output)
        return output
    folder = folder_of_dataset(dataset)
    if folder is None:
        raise UsageError(f"{dataset}: is an archive, name a file for the landmarks with --output")
    return folder / LANDMARKS_FILE


def _groups(
    own: ViewGroups, source: FileSource, views: Path | None, pattern: str | None
) -> ViewGroups:
    from procc_annotator.errors import UsageError
    from procc_annotator.io.collections import list_annotations
    from procc_annotator.session.view_groups import groups_by_name, load_views

    if views is not None and pattern is not None:
        raise UsageError("--views and --pattern both say when frames were taken: choose one")
    if pattern is not None:
        return groups_by_name(list_annotations(source), pattern)
    if views is not None and not views.exists():
        raise UsageError(f"{views}: does not exist")
    return own if views is None else load_views(views)


def _report_strange_rows(groups: ViewGroups, source: FileSource, dataset: Path) -> None:
    from procc_annotator.io.collections import list_annotations
    from procc_annotator.session.dataset_folder import folder_of_dataset
    from procc_annotator.session.picture_sizes import PictureSizes

    folder = folder_of_dataset(dataset)
    pictures = PictureSizes([folder] if folder is not None else []).files()
    frames = {*list_annotations(source), *(path.stem for path in pictures)}
    datasets.report_remarks(groups.strange_rows(frames))


def _cameras(cameras: str | None, camera_format: str, camera_size: str | None) -> CameraSet | None:
    from procc_annotator.cli.sources import parse_source
    from procc_annotator.errors import UsageError
    from procc_annotator.session.camera_set import CameraSet

    if cameras is None:
        return None
    spec = parse_source(cameras, camera_format)
    if not spec.path.exists():
        raise UsageError(f"{spec.path}: does not exist")
    given = CameraSet.open(spec.path, spec.format, spec.name, options.shown_size(camera_size))
    if not given.frames:
        raise UsageError(f"nothing to do: no camera (format {spec.format}) in {spec.path}")
    return given


def _locate(
    source: FileSource, place: Path, dataset: Path, field: Field, search: Search
) -> FoundInDataset:
    """Read every annotation, and triangulate what is clicked."""
    from functools import partial

    from procc_annotator.cli.console import progress_bar
    from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
    from procc_annotator.io.collections import list_annotations
    from procc_annotator.session.landmark_scan import PlaceOfFiles, locate_in_dataset

    def read(file: str) -> FrameAnnotation:
        return read_annotation(source.read(file), path=source.display(file), field=field)

    readers = {frame: partial(read, file) for frame, file in list_annotations(source).items()}
    with progress_bar("triangulating") as progress:
        files = PlaceOfFiles(dataset, place, tuple(readers))
        return locate_in_dataset(readers, field, files, search, progress)


def _print(located: Sequence[LocatedLandmark], described: str) -> None:
    from procc_annotator.cli.console import stdout_console
    from procc_annotator.report.landmarks import (
        frames_without_camera,
        landmarks_table,
        surveyed_astray,
    )

    stdout_console().print(landmarks_table(located, f"cameras: {described}"))
    datasets.report_remarks(
        f"no camera in {frame}: {why}" for frame, why in frames_without_camera(located).items()
    )
    datasets.report_remarks(surveyed_astray(located))


def _write(target: Path, known: LandmarkFile) -> None:
    from procc_annotator.io.landmark_file import save_landmarks

    save_landmarks(target, known)
    placed = sum(mark.position is not None for mark in known.landmarks)
    typer.echo(f"written: {placed} {'position' if placed == 1 else 'positions'} to {target}")


def _keep_groups(target: Path, groups: ViewGroups, dataset: Path) -> None:
    """Write the groups where the landmarks were written to the dataset, if it keeps none yet."""
    from procc_annotator.io.landmark_file import LANDMARKS_FILE
    from procc_annotator.session.dataset_folder import folder_of_dataset
    from procc_annotator.session.view_groups import VIEWS_FILE, load_views, save_views

    folder = folder_of_dataset(dataset)
    if folder is None or (folder / LANDMARKS_FILE).resolve() != target.resolve():
        typer.echo(f"note: {VIEWS_FILE} was not written: the dataset stays as it is", err=True)
        return
    path = folder / VIEWS_FILE
    if not path.exists():
        save_views(path, groups)
        typer.echo(f"written: {path}")
    elif load_views(path) != groups:
        typer.echo(f"note: {path} groups the frames otherwise; it was not changed", err=True)
