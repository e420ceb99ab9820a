"""``procc-annotator triangulate``: landmarks of a dataset from clicks in several views."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from procc_annotator.cli import datasets, options, outputs

if TYPE_CHECKING:
    from procc_annotator.annotation import FrameAnnotation
    from procc_annotator.field.landmarks import Landmark
    from procc_annotator.field.model import Field
    from procc_annotator.io.landmark_file import LandmarkFile
    from procc_annotator.io.source import FileSource
    from procc_annotator.session.fit_sizes import FitSizes
    from procc_annotator.session.landmark_clicks import ClickedLandmark
    from procc_annotator.session.landmark_views import Views
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
fitting, checking and rendering then use. Positions that were surveyed are never changed, nor is
what cannot be triangulated.

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
        help="Write the landmarks here.  [default: landmarks.json in the dataset's folder]",
    ),
]
Model = Annotated[
    str, typer.Option("--model", "-m", metavar="P|R|R+|auto", help="Camera to fit to each frame.")
]


@dataclass
class _Clicked:
    """What was read of a dataset: landmarks that were clicked, and the frames they are in."""

    landmarks: tuple[ClickedLandmark, ...]
    annotations: dict[str, FrameAnnotation]
    problems: list[str]


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
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
) -> None:
    from procc_annotator.cli.together import fit_sizes
    from procc_annotator.errors import UsageError
    from procc_annotator.field.landmarks import with_landmarks
    from procc_annotator.fit.fitting import check_model
    from procc_annotator.io.source import open_source
    from procc_annotator.session.calibration_run import annotations_of
    from procc_annotator.session.dataset_landmarks import read_dataset_landmarks

    check_model(model)
    if model == "H":
        raise UsageError("a homography tells no place in space: choose P, R, R+ or auto, not H")
    if click_px is not None and not click_px > 0:
        raise UsageError(f"--click-px must be a positive number of pixels, not {click_px:g}")
    measured = [parse_surveyed(text) for text in surveyed or ()]
    place = annotations_of(dataset)
    target = _target(dataset, output)
    known, groups = read_dataset_landmarks(dataset)
    for mark in measured:
        known = _with_surveyed(known, mark)
    shown = with_landmarks(options.read_field(field, dataset), known.landmarks)
    with open_source(place) as source:
        groups = _groups(groups, source, views, pattern)
        clicked = _clicks(source, shown, known, groups, moving or [])
        if not clicked.landmarks and not measured:
            raise UsageError(f"nothing to do: no landmark is clicked in {place}")
        if clicked.landmarks:
            sizes = fit_sizes(source, place, dataset, size)
            taken = _views(cameras, camera_format, camera_size, shown, clicked, sizes, model)
            known = _locate(clicked, known, taken, click_px, cameras or f"fitted, model {model}")
    _write(target, known, groups, keep_groups=bool(views or pattern) and output is None)
    raise typer.Exit(datasets.report_unreadable(clicked.problems))


def parse_surveyed(text: str) -> Landmark:
    """Read ``NAME=X,Y,Z``.

    Raises:
        UsageError: it is something else.
    """
    from procc_annotator.errors import InputError, UsageError
    from procc_annotator.field.landmarks import Landmark
    from procc_annotator.io.landmark_file import LandmarkFile, read_landmarks, write_landmarks

    name, _, place = text.rpartition("=")
    try:
        x, y, z = (float(number) for number in place.split(","))
        mark = Landmark(name, position=(x, y, z))
        # What a file of landmarks may hold is decided in one place.
        return read_landmarks(write_landmarks(LandmarkFile((mark,))), path=text).landmarks[0]
    except InputError as error:
        raise UsageError(f"--surveyed {text}: {error.problem}") from error
    except ValueError as error:
        raise UsageError(
            f"--surveyed {text}: expected NAME=X,Y,Z in metres from the field's centre"
        ) from error


def _with_surveyed(known: LandmarkFile, mark: Landmark) -> LandmarkFile:
    """With a measured position; what else is known of the landmark stays."""
    from dataclasses import replace

    own = next((m for m in known.landmarks if (m.name, m.instant) == (mark.name, None)), mark)
    own = replace(own, surveyed=True, moving=False, frames=())
    return known.with_landmark(replace(own, position=mark.position, covariance=None))


def _target(dataset: Path, output: Path | None) -> Path:
    """Where the landmarks are written to.

    Raises:
        UsageError: nowhere.
    """
    from procc_annotator.errors import UsageError
    from procc_annotator.io.landmark_file import LANDMARKS_FILE
    from procc_annotator.session.dataset_landmarks import landmark_folder

    if output is not None:
        if output.suffix.lower() != ".json":
            raise UsageError(f"{output}: landmarks are written as .json, end the name so")
        outputs.check_output_folder(output)
        return output
    folder = landmark_folder(dataset)
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


def _clicks(
    source: FileSource,
    field: Field,
    known: LandmarkFile,
    groups: ViewGroups,
    moving: list[str],
) -> _Clicked:
    """Read every annotation; those with landmarks are kept."""
    from procc_annotator.cli.console import with_progress
    from procc_annotator.errors import InputError
    from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
    from procc_annotator.io.collections import list_annotations
    from procc_annotator.session.landmark_clicks import ClickGathering

    gathering = ClickGathering(field, known.landmarks, groups, moving)
    read: dict[str, FrameAnnotation] = {}
    problems: list[str] = []
    files = list_annotations(source)
    for frame, file in with_progress(files.items(), len(files), "reading"):
        try:
            data = source.read(file)
            annotation = read_annotation(data, path=source.display(file), field=field)
        except InputError as error:
            problems.append(str(error))
            continue
        if gathering.add(frame, annotation):
            read[frame] = annotation
    return _Clicked(gathering.clicked(), read, problems)


def _views(
    cameras: str | None,
    camera_format: str,
    camera_size: str | None,
    field: Field,
    clicked: _Clicked,
    sizes: FitSizes,
    model: str,
) -> Views:
    from procc_annotator.cli.sources import parse_source
    from procc_annotator.errors import UsageError
    from procc_annotator.session.camera_set import CameraSet
    from procc_annotator.session.landmark_views import FittedViews, ViewsOfSet

    annotation_of: Callable[[str], FrameAnnotation] = clicked.annotations.__getitem__

    def size_of(frame: str) -> tuple[int, int]:
        return sizes.of_frame(frame, annotation_of(frame)).fitted

    if cameras is None:
        return FittedViews(field, annotation_of, size_of, model)
    spec = parse_source(cameras, camera_format)
    if not spec.path.exists():
        raise UsageError(f"{spec.path}: does not exist")
    given = CameraSet.open(spec.path, spec.format, spec.name, options.shown_size(camera_size))
    if not given.frames:
        raise UsageError(f"nothing to do: no camera (format {spec.format}) in {spec.path}")
    return ViewsOfSet(given, size_of)


def _locate(
    clicked: _Clicked,
    known: LandmarkFile,
    views: Views,
    click_px: float | None,
    described: str,
) -> LandmarkFile:
    """Triangulate, print, and return the landmarks with their positions."""
    from procc_annotator.cli.console import stdout_console, with_progress
    from procc_annotator.report.landmarks import frames_without_camera, landmarks_table
    from procc_annotator.session.landmark_clicks import is_surveyed, with_positions
    from procc_annotator.session.landmark_views import locate

    located = [
        locate(
            one, views, click_px=click_px,
            kept=is_surveyed(known.landmarks, one.name, one.instant),
        )
        for one in with_progress(clicked.landmarks, len(clicked.landmarks), "triangulating")
    ]  # fmt: skip
    stdout_console().print(landmarks_table(located, f"cameras: {described}"))
    datasets.report_remarks(
        f"no camera in {frame}: {why}" for frame, why in frames_without_camera(located).items()
    )
    return with_positions(known, located)


def _write(target: Path, known: LandmarkFile, groups: ViewGroups, *, keep_groups: bool) -> None:
    """Write the landmarks, and the groups where the dataset keeps none yet."""
    from procc_annotator.io.landmark_file import save_landmarks
    from procc_annotator.session.view_groups import VIEWS_FILE, load_views, save_views

    save_landmarks(target, known)
    placed = sum(mark.position is not None for mark in known.landmarks)
    typer.echo(f"written: {placed} {'position' if placed == 1 else 'positions'} to {target}")
    if not keep_groups:
        return
    path = target.with_name(VIEWS_FILE)
    if not path.exists():
        save_views(path, groups)
        typer.echo(f"written: {path}")
    elif load_views(path) != groups:
        typer.echo(f"note: {path} groups the frames otherwise; it was not changed", err=True)
