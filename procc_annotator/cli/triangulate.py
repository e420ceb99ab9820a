"""Command ``triangulate``: triangulate landmarks from clicks in several views."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import require_known_model
from procc_annotator.cli import input_files, options, outputs, remarks
from procc_annotator.cli.console import progress_bar, stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.method_arguments import parse_source
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.diagnostics import classes_of_source
from procc_annotator.dataset.landmarks import dataset_landmarks
from procc_annotator.dataset.landmarks.clicks import LocatedLandmark, with_positions
from procc_annotator.dataset.landmarks.dataset_landmarks import read_dataset_landmarks
from procc_annotator.dataset.landmarks.triangulation import (
    DatasetPaths,
    FoundInDataset,
    TriangulationSettings,
    locate_in_dataset,
)
from procc_annotator.dataset.landmarks.view_groups import (
    ViewGroups,
    groups_by_name,
    load_views,
    save_views,
)
from procc_annotator.dataset.layout import VIEWS_FILE, annotations_of, folder_of_dataset
from procc_annotator.dataset.picture_sizes import PictureSizes
from procc_annotator.errors import UsageError, require_existing
from procc_annotator.field.formulas import did_you_mean
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.registry import read_plain
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.landmark_file import LANDMARKS_FILE, LandmarkFile, save_landmarks
from procc_annotator.messages import pluralize
from procc_annotator.report.landmarks import frames_without_camera, landmarks_table, surveyed_astray

Cameras = Annotated[
    str | None,
    typer.Option(
        "--cameras",
        metavar="[NAME[:FORMAT]=]PATH",
        help="Cameras of the frames: folder, zip or file.  [default: fitted to the annotations]",
    ),
]
ViewsFile = Annotated[
    Path | None,
    typer.Option(
        "--views",
        metavar="FILE.csv",
        help="When each frame was taken, and by which camera.  [default: the dataset's views.csv]",
    ),
]
Pattern = Annotated[
    str | None,
    typer.Option(
        "--pattern",
        metavar="TEXT",
        help="The same from the frames' names: {instant}_{view}, or a regular expression with"
        " (?P<instant>...).",
    ),
]
Moving = Annotated[
    list[str] | None,
    typer.Option(
        "--moving", metavar="NAME", help="A landmark that moves; repeat for several.",
    ),
]  # fmt: skip
Surveyed = Annotated[
    list[str] | None,
    typer.Option(
        "--surveyed",
        metavar="NAME=X,Y,Z",
        help="A landmark whose place was measured, metres from the field's centre (z down); repeat"
        " for several.",
    ),
]
ClickPx = Annotated[
    float | None,
    typer.Option(
        "--click-sd",
        metavar="PX",
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
        help="Write the landmarks here, and leave the dataset as it is, without a views.csv."
        "  [default: landmarks.json in the dataset's folder]",
    ),
]


def check_values(model: str, click_px: float | None) -> None:
    """Raise UsageError for what no camera can be fitted or no place be found with."""
    require_known_model(model)
    if model == "H":
        raise UsageError("a homography has no position in space: choose P, R, R+ or auto, not H")
    if click_px is not None and not click_px > 0:
        raise UsageError(f"--click-sd must be a positive number of pixels, not {click_px:g}")


def add_surveyed(known: LandmarkFile, measured: Iterable[str], field: Field) -> LandmarkFile:
    """With measured positions; what else is known of the landmarks stays. UsageError for one that
    is not written as ``NAME=X,Y,Z``, cannot be, moves, or is a class of the field."""
    for text in measured:
        try:
            name, position = dataset_landmarks.parse_surveyed(text)
            dataset_landmarks.require_free(name, field)
            known = dataset_landmarks.with_surveyed_position(known, name, position)
        except UsageError as error:
            raise UsageError(f"--surveyed {text}: {error}") from error
    return known


def named_in_options(
    surveyed: Sequence[str], moving: Sequence[str], field: Field
) -> dict[str, str]:
    """The landmarks that options name, and the option that does. UsageError for one that has two
    places, or one and moves, or is a class of the field."""
    named: dict[str, str] = {}
    for text in surveyed:
        name, _ = dataset_landmarks.parse_surveyed(text)
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
            dataset_landmarks.require_free(name, field)
        except UsageError as error:
            raise UsageError(f"--moving {name}: {error}") from error
        named[name] = "--moving"
    return named


def target_file(dataset: Path, output: Path | None) -> Path:
    """Return where the landmarks are written to, or raise UsageError."""
    if output is not None:
        if output.suffix.lower() != ".json":
            raise UsageError(f"{output}: landmarks are written as .json, end the name so")
        outputs.check_output_folder(output)
        return output
    require_existing(dataset)
    folder = folder_of_dataset(dataset)
    if folder is None:
        raise UsageError(f"{dataset}: is an archive, name a file for the landmarks with --output")
    return folder / LANDMARKS_FILE


def chosen_view_groups(
    own: ViewGroups, source: FileSource, views: Path | None, pattern: str | None
) -> ViewGroups:
    if views is not None and pattern is not None:
        raise UsageError("--views and --pattern both say when frames were taken: choose one")
    if pattern is not None:
        return groups_by_name(list_annotations(source), pattern)
    require_existing(views)
    return own if views is None else load_views(views)


def chosen_cameras(
    cameras: str | None, camera_format: str, camera_size: str | None, field: Field
) -> CameraSet | None:
    if cameras is None:
        return None
    spec = parse_source(cameras, camera_format)
    size = options.shown_size(camera_size)
    return input_files.open_cameras(spec.path, spec.format, size, field)


def report_strange_rows(groups: ViewGroups, source: FileSource, dataset: Path) -> None:
    folder = folder_of_dataset(dataset)
    pictures = PictureSizes([folder] if folder is not None else [], tree=folder)
    frames = {*list_annotations(source), *pictures.frames()}
    remarks.report_remarks(groups.unknown_rows(frames))


def report_not_clicked(named: Mapping[str, str], located: Iterable[LocatedLandmark]) -> None:
    clicked = {one.clicked.name.strip() for one in located}
    remarks.report_remarks(
        f"{option} {name}: it is clicked in no frame{did_you_mean(name, clicked)}"
        for name, option in named.items()
        if name not in clicked
    )


def print_landmarks(located: Sequence[LocatedLandmark], described: str) -> None:
    stdout_console().print(landmarks_table(located, f"cameras: {described}"))
    remarks.report_remarks(
        f"no camera in {frame}: {why}" for frame, why in frames_without_camera(located).items()
    )
    remarks.report_remarks(surveyed_astray(located))


def write_landmarks(target: Path, known: LandmarkFile) -> None:
    save_landmarks(target, known)
    placed = sum(mark.position is not None for mark in known.landmarks)
    echo(f"written: {pluralize(placed, 'position')} to {target}")


def keep_groups(target: Path, groups: ViewGroups, dataset: Path) -> None:
    """Write the groups where the landmarks were written to the dataset, if it keeps none yet."""
    folder = folder_of_dataset(dataset)
    if folder is None or (folder / LANDMARKS_FILE).resolve() != target.resolve():
        echo(f"note: {VIEWS_FILE} was not written: the dataset stays as it is", err=True)
        return
    path = folder / VIEWS_FILE
    if not path.exists():
        save_views(path, groups)
        echo(f"written: {path}")
    elif load_views(path) != groups:
        echo(f"note: {path} groups the frames otherwise; it was not changed", err=True)


HELP = """\
DATASET is a dataset folder, or a folder or zip archive of annotations. Each class with one point
per frame that the field does not have is a landmark. Fixed landmarks are triangulated from all
frames, moving objects (--moving, or "moving" in landmarks.json) from the frames of each instant, as
given by views.csv (columns frame, instant, view), --views, or --pattern.

Cameras come from --cameras, taken as exact, or are fitted to each frame's annotation, with their
uncertainty. Landmarks that were triangulated do not influence these fits; surveyed ones do.

Positions are written to landmarks.json in the dataset's folder and used from then on. Surveyed
positions are never changed, only compared with their clicks.

Exit code: 0; 1 if some annotations were unreadable (listed); 2 if there was nothing to do. A
landmark without a position is listed with the reason and is no error.
"""

EXAMPLE = """\
  procc-annotator triangulate sample_data/views --pattern '{instant}_{view}' -o landmarks.json
  procc-annotator triangulate sample_data/views --cameras sample_data/views/cameras \\
      --surveyed 'Clock=12.0,-52.0,-11.0'
"""


def triangulate(
    dataset: options.AnnotatedSet,
    field_options: options.FieldOptions,
    cameras: Cameras = None,
    views: ViewsFile = None,
    pattern: Pattern = None,
    moving: Moving = None,
    surveyed: Surveyed = None,
    output: Output = None,
    model: options.PosedModel = "R",
    click_px: ClickPx = None,
    size: options.FitSize = None,
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
) -> None:
    check_values(model, click_px)
    place = annotations_of(dataset)
    target = target_file(dataset, output)
    known, groups = read_dataset_landmarks(dataset)
    shown = field_options.of(dataset)
    known = add_surveyed(known, surveyed or (), shown)
    named = named_in_options(surveyed or (), moving or (), shown)
    shown = with_landmarks(shown, known.landmarks)
    with open_annotations(place, shown, field_options.names(shown)) as source:
        remarks.report_remarks(list_annotations(source).notices)
        _refuse_classes_of_another_field(source, shown)
        groups = chosen_view_groups(groups, source, views, pattern)
        report_strange_rows(groups, source, dataset)
        given = chosen_cameras(cameras, camera_format, camera_size, shown)
        search = TriangulationSettings(
            known, groups, given, moving=moving or (),
            model=model, click_px=click_px, size=options.shown_size(size),
        )  # fmt: skip
        found = _locate(source, place, dataset, shown, search)
    if not found.located and not surveyed:
        raise UsageError(f"nothing to do: no landmark is clicked in {place}")
    if given is not None:
        _require_cameras_of(found, given)
    if found.located:
        print_landmarks(found.located, cameras or f"fitted, model {model}")
    report_not_clicked(named, found.located)
    # A person may have surveyed a landmark meanwhile.
    known = add_surveyed(read_dataset_landmarks(dataset)[0], surveyed or (), shown)
    known = with_positions(known, found.located)
    write_landmarks(target, known)
    if views or pattern:
        keep_groups(target, groups, dataset)
    raise typer.Exit(remarks.report_unreadable(list(found.problems)))


def _require_cameras_of(found: FoundInDataset, cameras: CameraSet) -> None:
    """Raise UsageError where the cameras are those of other frames: nothing would be placed."""
    frames = [click.frame for one in found.located for click in one.clicked.clicks]
    if frames and not any(frame in cameras.frames for frame in frames):
        raise UsageError(
            "nothing was triangulated: no camera has the name of a frame with a landmark (frames"
            f" are named like {frames[0]!r}, cameras like {next(iter(cameras.frames))!r})"
        )


def _refuse_classes_of_another_field(source: FileSource, field: Field) -> None:
    """Raise UsageError where the set shows another field: its classes would become landmarks, and
    no field can be chosen that has a class of a landmark's name."""
    classes = classes_of_source(source, field)
    mismatch, _ = remarks.mismatch_at(classes, field, source.path)
    if mismatch is None or mismatch.better is None:
        return
    remarks.report_mismatch_of(classes, field, source.path)
    raise UsageError(
        f"nothing was triangulated: classes of {mismatch.better.title} are no landmarks (one that"
        " is a landmark all the same: name it in landmarks.json)"
    )


def _locate(
    source: FileSource, place: Path, dataset: Path, field: Field, search: TriangulationSettings
) -> FoundInDataset:
    def read(file: str) -> FrameAnnotation:
        return read_plain(source.read(file), source.display(file), field)

    readers = {frame: partial(read, file) for frame, file in list_annotations(source).items()}
    with progress_bar("triangulating") as progress:
        files = DatasetPaths(dataset, place, tuple(readers))
        return locate_in_dataset(readers, field, files, search, progress)
