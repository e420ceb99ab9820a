"""Options shared by commands, and resolving ``--field``."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path, PurePosixPath
from typing import Annotated, TypeVar, cast

import typer

from procc_annotator.cli.echo import echo
from procc_annotator.dataset.dataset_field import (
    field_of_datasets,
    stored_pixel_aspect,
    with_dataset_pixels,
)
from procc_annotator.dataset.landmarks.dataset_landmarks import field_of_dataset_with_landmarks
from procc_annotator.dataset.layout import FIELD_FILE
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.load import load_field_of, with_lines
from procc_annotator.field.model import LINE_POSITIONS, Field, PixelAspect
from procc_annotator.formats.annotations.label_map import LabelMap, read_label_map
from procc_annotator.formats.file_source import ZipSource
from procc_annotator.image.headers import is_valid_size
from procc_annotator.metrics.setup import EvaluationSetup, check_thresholds

T = TypeVar("T")

AUTO_ASPECT = "auto"
CAMERA_FORMAT_NAMES = (
    "soccernet", "tvcalib", "opencv", "packed", "broadtrack", "deepsportradar", "synloc",
    "opentrackio", "fifa", "pose2sim", "panoptic", "vggt", "krt", "polylines", "projection",
    "transforms", "sccvsd", "ptz-slam", "qualisys", "table", "wc14", "carwc", "world", "colmap",
    "easymocap",
)  # fmt: skip


def chosen_field(
    text: str | None,
    *datasets: Path | None,
    lines: str | None = None,
    pixel_aspect: str = AUTO_ASPECT,
) -> Field:
    """The field an option names, with its dimensions if any are given; without it the datasets'
    own, with the dimensions they keep; with their landmarks either way.

    Args:
        text: of the option.
        datasets: what has no folder says nothing.
        lines: where its lines lie; None: as the dataset keeps it, or the file of the field says.
        pixel_aspect: of the pictures; see `parse_pixel_aspect`.

    Raises:
        FieldError: the field's description or a dimension cannot be used.
        InputError: the file of their landmarks cannot be used.
        UsageError: dimensions that are not written as ``name=metres``; datasets of several fields.
    """
    field = _own_field(*datasets) if text is None else load_field_of(text)
    field = field if lines is None else with_lines(field, lines)
    if text is not None and datasets and datasets[0] is not None:
        field = with_dataset_pixels(field, datasets[0])
    if (pixels := parse_pixel_aspect(pixel_aspect)) is not None:
        field = replace(field, pixels=pixels)
    return field_of_dataset_with_landmarks(field, *(place for place in datasets if place))


def _own_field(*datasets: Path | None) -> Field:
    places = [place for place in datasets if place is not None]
    found = field_of_datasets(places)
    packed = [
        f"{place} holds a field.toml, which is not used: unpack it and name it with --field"
        for place in places
        if _packs_field_file(place)
    ]
    for notice in (*found.notices, *packed):
        echo(f"note: {notice}", err=True)
    return found.field


def _packs_field_file(place: Path) -> bool:
    """Return whether an archive holds a field's description; one that cannot be read says so
    elsewhere."""
    if place.suffix.lower() != ".zip" or not place.is_file():
        return False
    try:
        with ZipSource(place) as archive:
            return any(PurePosixPath(name).name == FIELD_FILE for name in archive.names())
    except InputError:
        return False


def parse_pixel_aspect(text: str) -> PixelAspect | None:
    """The ratio that ``--pixel-aspect`` gives; None for ``auto``; refused if it is neither."""
    if text == AUTO_ASPECT:
        return None
    if (known := stored_pixel_aspect(f"{text} 1")) is None:
        raise UsageError(
            f"--pixel-aspect {text}: expected auto, or the width of a pixel over its height, such"
            " as 1.778"
        )
    return known


def with_estimated_pixels(
    field: Field, pictures: Sequence[tuple[str, Path | None]], size: str | None = None
) -> Field:
    """The field with the pixels of the pictures, which are estimated if nothing says what they are,
    and stated if they are not square.

    Args:
        field: the elements.
        pictures: each with the name of its frame, of some set; None for one that is not there.
        size: ``WIDTHxHEIGHT`` of pictures that are not there.
    """
    # Loads what finds cameras, which most commands do without.
    from procc_annotator.batch.camera_proposals import set_pixel_aspect
    from procc_annotator.calibration.single_image.pixel_aspect import possible_pixel_aspects

    there = [(name, path) for name, path in pictures if path is not None]
    searching = cache(
        lambda: echo("the pictures may be squeezed: estimating their pixel aspect ...", err=True)
    )
    pixels = field.pixels or set_pixel_aspect(there, field, searching)
    if pixels is not None:
        estimated = f" (probability {100 * pixels.probability:.1f} %)"
        echo(
            f"pixels are {pixels.value:.3f} times as wide as high"
            f"{', as stated' if pixels.probability == 1 else estimated}"
        )
    elif not there and size and len(possible_pixel_aspects(parse_size(size))) > 1:
        echo(
            f"pictures of {size} may be squeezed, and none is there to tell: their pixels are taken"
            " for square, unless --pixel-aspect states otherwise"
        )
    return field if pixels is None else replace(field, pixels=pixels)


DEFAULT_THRESHOLD = 5.0
DEFAULT_SIZE = "960x540"


def parse_size(text: str) -> tuple[int, int]:
    """``960x540`` as (960, 540); typer.BadParameter for anything else."""
    found = re.fullmatch(r"\s*(\d{1,6})\s*[xX×]\s*(\d{1,6})\s*", text, re.ASCII)
    if found is None or min(int(found[1]), int(found[2])) < 2:
        raise typer.BadParameter(f"{text!r} is not WIDTHxHEIGHT in pixels, e.g. 960x540")
    size = int(found[1]), int(found[2])
    if not is_valid_size(*size):
        raise typer.BadParameter(f"{text!r} is no shape of a picture, expected e.g. 960x540")
    return size


def checked_size(given: T) -> T:
    """The size or sizes of an option, or None; see `parse_size`."""
    for text in [given] if isinstance(given, str) else cast(list[str] | None, given) or ():
        parse_size(text)
    return given


def _checked_lines(text: str | None) -> str | None:
    if text is None:
        return None
    if text not in LINE_POSITIONS:
        raise typer.BadParameter(f"{text!r} is not one of {', '.join(LINE_POSITIONS)}")
    return text


Thresholds = Annotated[
    list[float] | None,
    typer.Option(
        "--threshold",
        "-t",
        metavar="PX",
        help="A point agrees if it is closer than this many pixels; repeat for several."
        "  [default: 5]",
    ),
]
Protocol = Annotated[
    str,
    typer.Option(
        metavar="soccernet|procc",
        help="soccernet: the official evaluation, quirks included; procc: the paper's definition.",
    ),
]
Size = Annotated[
    str,
    typer.Option(
        metavar="WxH", callback=checked_size, help="Picture size at which everything is compared."
    ),
]
FitSize = Annotated[
    str | None,
    typer.Option(
        "--size",
        metavar="WxH",
        callback=checked_size,
        help="Picture size that cameras and distances are for.  [default: 960 px wide, in the shape"
        " of the picture next to the annotation; 960x540 without pictures]",
    ),
]
FieldName = Annotated[
    str | None,
    typer.Option(
        "--field",
        metavar="NAME|FILE[:DIMENSIONS]",
        help="The field: a name, or a .toml file; with dimensions that are not nominal e.g."
        " futsal:length=39.8,width=19.9 (metres).  [default: the dataset's own; where it has none"
        " the one marked in field list]",
    ),
]
Lines = Annotated[
    str | None,
    typer.Option(
        metavar="measured|middle",
        callback=_checked_lines,
        help="Where the lines of the field lie: measured: where the rules measure them, often an"
        " edge of their paint; middle: in the middle of their paint, where clicks are put."
        "  [default: what the dataset keeps; measured]",
    ),
]
LabelsFile = Annotated[
    Path | None,
    typer.Option(
        "--map",
        metavar="labels.toml",
        help="What the names of another program stand for.  [default: labels.toml of the dataset,"
        " if there is one]",
    ),
]
KeepOptional = Annotated[
    bool,
    typer.Option(
        "--keep-optional",
        help="Write elements, too, that SoccerNet has no class for (marks, landmarks).",
    ),
]
Model = Annotated[
    str,
    typer.Option(
        "--model", "-m", metavar="H|P|R|R+|R2|F|auto", help="Camera to fit to each frame."
    ),
]
PosedModel = Annotated[
    str,
    typer.Option("--model", "-m", metavar="P|R|R+|R2|F|auto", help="Camera to fit to each frame."),
]
PicturesOrVideo = Annotated[
    Path, typer.Argument(help="Folder or archive of pictures, one picture, a video, or their URL.")
]
Every = Annotated[int, typer.Option(min=1, metavar="N", help="Every N-th frame only.")]
Resume = Annotated[
    bool,
    typer.Option("--resume", help="Go on where a run in the same words was stopped; else begin."),
]
Overwrite = Annotated[
    bool, typer.Option("--overwrite", help="Replace files of OUT that are there.")
]
Groups = Annotated[
    Path | None,
    typer.Option(
        "--groups",
        metavar="FILE.csv",
        help="Groups of frames that belong together: a column 'frame' and one that names the group"
        " (and 'set', if there are several).  [default: the stadiums of stadiums.csv, else all]",
    ),
]
CameraFormat = Annotated[
    str,
    typer.Option(
        metavar="NAME",
        help="What the camera files hold: " + ", ".join(CAMERA_FORMAT_NAMES) + ", or a plug-in's."
        " auto goes by suffix and content (.homographyMatrix and .txt: wc14, .npy: carwc).",
    ),
]
CameraSize = Annotated[
    str | None,
    typer.Option(
        metavar="WxH",
        callback=checked_size,
        help="Picture size the cameras refer to, where their files do not say (a homography's does"
        " not: 1280x720 is only usual).",
    ),
]
OffPlane = Annotated[
    str,
    typer.Option(
        metavar="missed|left_out",
        help="How goals, baskets and nets count for cameras that know only the ground"
        " (homographies).",
    ),
]
PlanarOnly = Annotated[
    bool,
    typer.Option(
        "--planar-only",
        help="Leave everything off the ground (goals, baskets, nets) out, for every camera.",
    ),
]
Mirrored = Annotated[
    bool,
    typer.Option(
        "--mirrored",
        help="Let labels of the turned field count too (procc; soccernet always does).",
    ),
]
Sources = Annotated[
    list[str] | None,
    typer.Option(
        "--cameras",
        metavar="[NAME[:FORMAT]=]PATH",
        help="A source of cameras: folder, zip or file. Repeat for several; without NAME it is"
        " called like its folder.",
    ),
]
FigureFiles = Annotated[
    list[Path] | None,
    typer.Option(
        "--output",
        "-o",
        metavar="FILE",
        help="Write all of it to a .json or .csv file; repeat for both.",
    ),
]
AnnotatedSet = Annotated[
    Path, typer.Argument(help="Dataset folder, season, or folder or zip of annotation files.")
]
FitWorkers = Annotated[
    int | None,
    typer.Option(
        "--workers",
        min=1,
        metavar="N",
        help="Processes that share the work.  [default: 1; from 200 frames one a CPU]",
    ),
]
Workers = Annotated[
    int | None,
    typer.Option(
        min=1,
        metavar="N",
        help="Processes that share the work.  [default: 1; from 2000 frames one a CPU]",
    ),
]
Dask = Annotated[
    str | None,
    typer.Option(
        metavar="tcp://HOST:PORT",
        help="Scheduler of a Dask cluster that shares the work instead; the data must lie under the"
        " same path on every machine.",
    ),
]


def label_map(path: Path | None, field: Field) -> LabelMap | None:
    """The map that ``--map`` names, or InputError; None leaves it to the dataset."""
    return None if path is None else read_label_map(path, field)


def thresholds_or_default(thresholds: list[float] | None) -> tuple[float, ...]:
    """The thresholds asked for, or 5 px; UsageError for one that is not a positive number."""
    return check_thresholds(thresholds or [DEFAULT_THRESHOLD])


def setup_for(
    field: Field,
    size: str | None,
    protocol: str,
    off_plane: str,
    mirrored: bool,
    planar_only: bool = False,
) -> EvaluationSetup:
    """The evaluation the options describe, without a size at the default one; UsageError for
    options that contradict each other, or an unknown protocol."""
    if mirrored and protocol == "soccernet":
        raise UsageError(
            "--mirrored is for --protocol procc: soccernet always considers mirrored labels"
        )
    shown = parse_size(DEFAULT_SIZE if size is None else size)
    return EvaluationSetup(field, shown, protocol, mirrored, off_plane, planar_only)


def shown_size(size: str | None) -> tuple[int, int] | None:
    """An optional size, read."""
    return None if size is None else parse_size(size)


@dataclass(frozen=True, kw_only=True)
class FieldOptions:
    """The field of a dataset, and what its labels stand for."""

    field: FieldName = None
    lines: Lines = None
    labels: LabelsFile = None

    def of(self, *datasets: Path | None) -> Field:
        """The field; see `chosen_field`."""
        return chosen_field(self.field, *datasets, lines=self.lines)

    def names(self, field: Field) -> LabelMap | None:
        """What labels stand for; see `label_map`."""
        return label_map(self.labels, field)


@dataclass(frozen=True, kw_only=True)
class PictureFieldOptions(FieldOptions):
    """The same of pictures that may be squeezed."""

    pixel_aspect: Annotated[
        str,
        typer.Option(
            "--pixel-aspect",
            metavar="auto|RATIO",
            help="Width of the pictures' pixels over their height, such as 1.778; auto: what"
            " the video or the dataset says, else estimated from nearly square pictures.",
        ),
    ] = AUTO_ASPECT

    def of(self, *datasets: Path | None) -> Field:
        """The field, its pixels as the option states them; see `chosen_field`."""
        return chosen_field(self.field, *datasets, lines=self.lines, pixel_aspect=self.pixel_aspect)


@dataclass(frozen=True, kw_only=True)
class ScoringOptions(FieldOptions):
    """How frames are scored, and what is said of their labels and cameras."""

    protocol: Protocol = "soccernet"
    size: Size = DEFAULT_SIZE
    camera_format: CameraFormat = "auto"
    camera_size: CameraSize = None
    off_plane: OffPlane = "missed"
    mirrored: Mirrored = False

    def setup(self, dataset: Path, *, planar_only: bool = False) -> EvaluationSetup:
        """How frames are scored; raises as `chosen_field` and `setup_for`."""
        return setup_for(
            self.of(dataset), self.size, self.protocol, self.off_plane, self.mirrored, planar_only
        )

    @property
    def own_size(self) -> tuple[int, int] | None:
        """(width, height) px that cameras refer to, where their files do not say."""
        return shown_size(self.camera_size)
