"""``procc-annotator convert``: annotations and cameras from one format to another."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import options, remarks
from procc_annotator.cli.console import progress_bar
from procc_annotator.cli.echo import echo
from procc_annotator.cli.options import chosen_field
from procc_annotator.dataset.annotation_source import open_files, own_label_map
from procc_annotator.dataset.diagnostics import found_instead_of_cameras
from procc_annotator.dataset.layout import annotations_of
from procc_annotator.errors import UsageError, require_existing
from procc_annotator.formats.annotations.exchange import SIZE_UNKNOWN
from procc_annotator.formats.annotations.registry import WRITTEN
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.homography import CONVENTIONS
from procc_annotator.formats.cameras.submissions import POLYLINES
from procc_annotator.formats.cameras.writers import OFFICIAL_SIZE, writer_of
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.messages import pluralize
from procc_annotator.metrics.ground_plane import region_of
from procc_annotator.metrics.official import fold_back_warnings
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.conversion import convert_annotations, export_cameras, export_polylines
from procc_annotator.report.conversion_output import ConversionRequest

HELP = """\
IN is a dataset, a folder or zip of files, or one file. OUT is a folder, a .zip, or the file itself
for formats that hold a whole set. Inputs are never changed; existing files are replaced only with
--overwrite.

Annotations: soccernet, soccernet-v3, soccernet-gsr, labelme, cvat, cvat-video, coco; yolo-pose and
masks are only written. Cameras: soccernet-camera, opencv, krt, wc14, carwc, world, submission;
polylines (a submission of projections of any camera model, for --protocol at --size, of the frames
in --frames).

What a format cannot hold is listed.

Exit code: 0; 1 if some files or frames were left out (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator convert sample_data cvat.zip --to cvat --pictures
  procc-annotator convert cvat.zip back/ --to soccernet
  procc-annotator convert sample_data masks/ --to masks --line-width 6
  procc-annotator convert sample_data/cameras/true submission.zip --to submission --split test
"""

# By --to, the format written; annotations of SoccerNet are what "soccernet" alone means here.
CAMERA_TARGETS = {
    "soccernet-camera": "soccernet",
    **{name: name for name in ("opencv", "krt", "wc14", "carwc", "world", "submission")},
}


@dataclass(frozen=True)
class ConvertOptions:
    """Options of `convert`."""

    source: Annotated[Path, typer.Argument(metavar="IN", help="What is read.")]
    out: Annotated[Path, typer.Argument(metavar="OUT", help="File, folder or .zip to write.")]
    to: Annotated[str, typer.Option("--to", metavar="FORMAT", help="Format to write.")]
    from_: Annotated[
        str, typer.Option("--from", metavar="auto|FORMAT", help="Format of IN; auto looks into it.")
    ] = "auto"
    field: options.FieldName = None
    labels: options.LabelsFile = None
    size: Annotated[
        str | None,
        typer.Option(
            metavar="WxH",
            callback=options.checked_size,
            help="Size of pictures that are missing and not stated in a file; of cameras:"
            " the size they are written for.",
        ),
    ] = None
    camera_size: options.CameraSize = None
    line_width: Annotated[
        float, typer.Option("--line-width", metavar="PX", help="Width of the lines of masks.")
    ] = 4.0
    split: Annotated[
        str,
        typer.Option(
            "--split",
            metavar="NAME",
            help="Folder inside OUT that files of single frames go to; the subset of coco,"
            " yolo-pose.  [submission: test, coco: default, yolo-pose: train]",
        ),
    ] = ""
    into: Annotated[
        Path | None,
        typer.Option(
            "--into",
            metavar="FILE",
            help="Labels-v3.json or Labels-GameState.json whose other content OUT keeps.",
        ),
    ] = None
    protocol: options.Protocol = "soccernet"
    frames: Annotated[
        Path | None,
        typer.Option(
            "--frames",
            metavar="DIR",
            help="Of polylines: a dataset, folder or zip of JSON files whose names are the frames"
            " that are judged.  [default: the frames that have a camera]",
        ),
    ] = None
    method: Annotated[
        str | None,
        typer.Option(
            "--method",
            metavar="NAME",
            help="Of polylines: what the method is called.  [default: the name of IN]",
        ),
    ] = None
    region: Annotated[
        str | None,
        typer.Option(
            "--region",
            metavar="field|X0,Y0,X1,Y1",
            help="Of wc14, carwc and world: write the homography nearest to each camera over what"
            " its picture shows of the field, or of a rectangle in metres, and list its errors.",
        ),
    ] = None
    overwrite: options.Overwrite = False
    keep_optional: options.KeepOptional = False
    pictures: Annotated[
        bool,
        typer.Option(
            "--pictures", help="Copy the pictures as well, to where readers of the format look."
        ),
    ] = False


def convert(given: ConvertOptions) -> None:
    if given.to == POLYLINES:
        raise typer.Exit(_convert_to_polylines(given))
    if given.to in CAMERA_TARGETS:
        raise typer.Exit(_convert_cameras(given))
    names = [known.name for known in WRITTEN]
    if given.to not in names:
        known_names = ", ".join((*names, *CAMERA_TARGETS, POLYLINES))
        raise UsageError(f"no format {given.to!r}; there are {known_names}")
    raise typer.Exit(_convert_annotations(given))


def _convert_annotations(given: ConvertOptions) -> int:
    wanted = ConversionRequest(
        given.to, given.line_width, given.split, given.into, given.overwrite,
        given.keep_optional, given.pictures,
    )  # fmt: skip
    size, source = options.shown_size(given.size), given.source
    known = chosen_field(given.field, source)
    with progress_bar("converting") as progress:
        done = convert_annotations(
            source,
            given.out,
            wanted,
            known,
            fmt=given.from_,
            names=options.label_map(given.labels, known) or own_label_map(source, known),
            size=size,
            progress=progress,
        )
    remarks.report_mismatch_of(done.classes, known, source, unknown=done.unknown)
    remarks.report_remarks(done.losses)
    if not done.frames and done.problems and all(SIZE_UNKNOWN in one for one in done.problems):
        raise UsageError(
            f"nothing to do: {done.title} is in pixels, and the size of no picture of {source} is"
            " known; put the pictures next to the annotations, or name their size: --size WxH"
        )
    unreadable = remarks.report_unreadable(done.problems, "left out")
    if not done.frames:
        raise UsageError(f"nothing to do: no frame of {source} could be written to {given.out}")
    echo(
        f"{pluralize(done.frames, 'frame')}, {pluralize(done.elements, 'element')},"
        f" {pluralize(done.points, 'point')}"
        f" written to {given.out} ({done.title})"
    )
    return unreadable


def _convert_to_polylines(given: ConvertOptions) -> int:
    size = options.shown_size(given.size) or OFFICIAL_SIZE
    setup = EvaluationSetup(chosen_field(given.field, given.frames), size, given.protocol)
    method, own = given.method or given.source.stem, options.shown_size(given.camera_size)
    names = None
    with _cameras(given) as (cameras, progress):
        if given.frames is not None:
            with open_files(annotations_of(given.frames)) as annotated:
                names = list(list_annotations(annotated))
        done = export_polylines(
            cameras, given.out, setup, method, names, camera_size=own, progress=progress
        )
        remarks.report_remarks(cameras.notices)
    remarks.report_notices(done.losses)
    unreadable = remarks.report_unreadable(done.problems, "left out")
    echo(
        f"polylines of {pluralize(done.written, 'frame')} written to {given.out}"
        f" ({setup.describe()}, method {method})"
    )
    return unreadable


def _convert_cameras(given: ConvertOptions) -> int:
    size, own = options.shown_size(given.size), options.shown_size(given.camera_size)
    region = None
    if given.region is not None:
        if given.to not in CONVENTIONS:
            raise UsageError(f"--region is for homographies: --to {', '.join(CONVENTIONS)}")
        region = region_of(given.region, chosen_field(given.field, given.source))
    with _cameras(given) as (cameras, progress):
        done = export_cameras(
            cameras, given.out, CAMERA_TARGETS[given.to], size=size, camera_size=own,
            split=given.split or "test", region=region, progress=progress,
        )  # fmt: skip
        remarks.report_remarks(cameras.notices)
    remarks.report_notices(done.losses)
    remarks.report_remarks(fold_back_warnings(done.folded))
    unreadable = remarks.report_unreadable(done.problems, "left out")
    if not done.written:
        raise UsageError(
            f"nothing to do: no camera of {given.source} could be written to {given.out}"
        )
    fixed = writer_of(CAMERA_TARGETS[given.to]).size
    of = f", for pictures of {fixed[0]}x{fixed[1]} px, as the format has it" if fixed else ""
    echo(f"{pluralize(done.written, 'camera')} written to {given.out}{of}")
    if given.to == "world":
        note = "these files look like wc14: read them with --camera-format world"
        remarks.report_remarks([note])
    return unreadable


@contextmanager
def _cameras(
    given: ConvertOptions,
) -> Iterator[tuple[CameraCollection, Callable[[int, int], None]]]:
    """The cameras to convert, at least one, and a bar while a person watches."""
    source, out = given.source, given.out
    require_existing(source)
    if source.resolve() == out.resolve() or out.resolve().is_relative_to(source.resolve()):
        raise UsageError(f"{out}: lies in what is read, write to another place than {source}")
    if out.exists() and not given.overwrite and (out.is_file() or any(out.iterdir())):
        raise UsageError(f"{out}: exists already, choose another name or ask to overwrite it")
    with (
        CameraCollection.open(source, given.from_) as cameras,
        progress_bar("converting") as progress,
    ):
        if not cameras.frames:
            instead = found_instead_of_cameras(source)
            raise UsageError(
                f"nothing to do: no camera (format {given.from_}) in {source}{instead}"
            )
        yield cameras, progress
