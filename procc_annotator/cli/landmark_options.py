"""What a call of ``triangulate`` asks for: its options, and how their values are read."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import options, outputs
from procc_annotator.cli.datasets import report_remarks
from procc_annotator.cli.sources import parse_source
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import require_known_model
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.landmark_file import LANDMARKS_FILE, LandmarkFile
from procc_annotator.io.source import FileSource
from procc_annotator.session.dataset.camera_set import CameraSet
from procc_annotator.session.dataset.dataset_folder import folder_of_dataset
from procc_annotator.session.dataset.what_lies_there import found_instead_of_cameras
from procc_annotator.session.landmarks import landmark_edits
from procc_annotator.session.landmarks.view_groups import ViewGroups, load_views
from procc_annotator.session.landmarks.view_names import groups_by_name

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
    str,
    typer.Option("--model", "-m", metavar="P|R|R+|R2|F|auto", help="Camera to fit to each frame."),
]


def check_values(model: str, click_px: float | None) -> None:
    """Raise UsageError for what no camera can be fitted or no place be found with."""
    require_known_model(model)
    if model == "H":
        raise UsageError("a homography tells no place in space: choose P, R, R+ or auto, not H")
    if click_px is not None and not click_px > 0:
        raise UsageError(f"--click-px must be a positive number of pixels, not {click_px:g}")


def add_surveyed(known: LandmarkFile, measured: Iterable[str], field: Field) -> LandmarkFile:
    """With measured positions; what else is known of the landmarks stays.

    Raises:
        UsageError: one that is not written as ``NAME=X,Y,Z``, cannot be, moves, or is a class of
            the field.
    """
    for text in measured:
        try:
            name, position = landmark_edits.parse_surveyed(text)
            landmark_edits.require_free(name, field)
            known = landmark_edits.with_surveyed_position(known, name, position)
        except UsageError as error:
            raise UsageError(f"--surveyed {text}: {error}") from error
    return known


def named_in_options(
    surveyed: Sequence[str], moving: Sequence[str], field: Field
) -> dict[str, str]:
    """The landmarks that options name, and the option that does.

    Raises:
        UsageError: one that has two places, or one and moves; one that is a class of the field.
    """
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


def target_file(dataset: Path, output: Path | None) -> Path:
    """Where the landmarks are written to.

    Raises:
        UsageError: nowhere.
    """
    if output is not None:
        if output.suffix.lower() != ".json":
            raise UsageError(f"{output}: landmarks are written as .json, end the name so")
        outputs.check_output_folder(output)
        return output
    if not dataset.exists():
        raise UsageError(f"{dataset}: does not exist")
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
    if views is not None and not views.exists():
        raise UsageError(f"{views}: does not exist")
    return own if views is None else load_views(views)


def chosen_cameras(
    cameras: str | None, camera_format: str, camera_size: str | None, field: Field
) -> CameraSet | None:
    if cameras is None:
        return None
    spec = parse_source(cameras, camera_format)
    if not spec.path.exists():
        raise UsageError(f"{spec.path}: does not exist")
    given = CameraSet.open(
        spec.path, spec.format, spec.name, options.shown_size(camera_size), field
    )
    if not given.frames:
        raise UsageError(
            f"nothing to do: no camera (format {spec.format}) in {spec.path}"
            + found_instead_of_cameras(spec.path)
        )
    report_remarks(given.notices)
    return given
