"""``procc-annotator render``: overlay pictures, drawn by the painter of the window."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.arrays import FloatArray
from procc_annotator.cli import input_files, options, outputs, remarks
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.drawing_options import DrawingOptions
from procc_annotator.cli.echo import echo
from procc_annotator.cli.matches import place_of_match
from procc_annotator.cli.painters import overlay_painter
from procc_annotator.dataset.season import Match
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import UsageError
from procc_annotator.figures.top_view import SUFFIXES, TopViewPainter
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX
from procc_annotator.formats.frame_names import frame_finder
from procc_annotator.formats.point_tables import PointTable
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.messages import list_names, pluralize
from procc_annotator.report.overlay_scene import (
    VIDEO_SUFFIX,
    OverlayLook,
    Rendered,
    Rendering,
    render_pictures,
    render_video,
)

HELP = """\
DATASET may be a video. OUT is a folder, or a video if it ends in .mp4; with --top-view also one
picture (.png, .jpg, .svg, .pdf): the median of the frames from above, without moving objects.

Colours and dashes are those of the window, at --threshold; --legend explains them below each
picture. Existing pictures are replaced only with --overwrite, or after a run that was stopped.

Exit code: 0; 1 if some files were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator render sample_data overlays/ --cameras sample_data/cameras/bad --threshold 5
  procc-annotator render sample_data figures/ --format svg --scale 2 --legend
  procc-annotator render sample_data above/ --cameras sample_data/cameras/true --top-view
"""


_FILES = {*SUFFIXES, *PICTURE_SUFFIXES, *VIDEO_SUFFIXES}  # names that folders do not have


class PictureFormat(StrEnum):
    """Encodings of overlay pictures."""

    png = "png"
    jpg = "jpg"
    svg = "svg"


Out = Annotated[Path, typer.Argument(help="Folder of pictures, or a file.")]
Encoding = Annotated[PictureFormat, typer.Option("--format", help="Encoding of the pictures.")]
Scale = Annotated[
    float,
    typer.Option(
        "--scale", metavar="X", help="Px of the result per px of the picture, e.g. 2 or 0.5."
    ),
]
PaintedWidth = Annotated[
    bool,
    typer.Option(
        "--painted-width",
        help="Also draw the borders of the paint: how wide the lines of the field must appear.",
    ),
]
Legend = Annotated[
    bool, typer.Option("--legend", help="Explain colours, dashes and marks below each picture.")
]


TopView = Annotated[
    bool,
    typer.Option("--top-view", help="Draw the pictures on the field, from above, 10 px per metre."),
]
Positions = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE", help="CSV of ground positions (as of ground) to draw on a top view."
    ),
]
Fps = Annotated[
    float | None,
    typer.Option(
        min=0.1,
        max=1000,
        metavar="N",
        help="Frames per second of a video.  [default: the times of DATASET's video, else 25]",
    ),
]


def render(
    dataset: input_files.Dataset,
    out: Out,
    given: DrawingOptions,
    cameras: input_files.Cameras = None,
    picture_format: Encoding = PictureFormat.png,
    scale: Scale = 1.0,
    painted_width: PaintedWidth = False,
    legend: Legend = False,
    overwrite: options.Overwrite = False,
    top_view: TopView = False,
    positions: Positions = None,
    fps: Fps = None,
) -> None:
    setup = given.setup(dataset)
    workspace = given.open(dataset, setup)
    cameras = place_of_match(cameras, Match(dataset.stem, dataset), PACKED_SUFFIX) or cameras
    camera_set = input_files.open_cameras(cameras, given.camera_format, given.own_size, setup.field)
    outputs.check_folder_apart(
        out, [workspace.annotations, *([camera_set] if camera_set is not None else [])]
    )
    rendering = given.rendering(workspace, setup, camera_set, painted_width=painted_width)
    single = _single_file(out, top_view=top_view)
    suffix = single if single in SUFFIXES else f".{picture_format.value}"
    if positions is not None and not top_view:
        raise UsageError("--positions are drawn from above: add --top-view")
    if top_view and camera_set is None:
        raise UsageError("--top-view needs --cameras")
    if single:
        outputs.check_output_folder(out)
        outputs.check_not_inputs([out], [dataset] if dataset.is_file() else [])
        if out.exists() and not overwrite:
            raise UsageError(f"{out}: exists already, choose another name, or --overwrite")
    above = TopViewPainter(suffix, scale, _positions(positions, workspace)) if top_view else None
    painter = above or overlay_painter(suffix, OverlayLook(scale, legend))
    if single == VIDEO_SUFFIX:
        steps = render_video(rendering, out, painter, fps)
        rendered = _last(steps, rendering)
        echo(f"{pluralize(len(rendered.pictures), 'frame')} written to {out}")
    elif above is not None and single:
        rendered = _write_panorama(rendering, above, out)
    else:
        names = (f"{frame.name}{suffix}" for frame in workspace.frames)
        with outputs.replacing_nothing(out, names, "render", overwrite=overwrite):
            rendered = _last(render_pictures(rendering, out, painter, suffix), rendering)
        echo(f"{pluralize(len(rendered.pictures), 'picture')} written to {out}")
    remarks.report_notices(rendered.notices)
    if rendered.bare:
        frames = list_names(rendered.bare, "frame")
        remarks.report_remarks([f"neither annotation nor camera, nothing is drawn: {frames}"])
    raise typer.Exit(remarks.report_unreadable(rendered.problems))


def _single_file(out: Path, *, top_view: bool) -> str:
    """The suffix of the one file to write; empty for a folder."""
    suffix = out.suffix.lower()
    if out.is_dir() or suffix not in _FILES:
        return ""
    if suffix != VIDEO_SUFFIX and not (top_view and suffix in SUFFIXES):
        kinds = f"; with --top-view also {', '.join(SUFFIXES)}"
        raise UsageError(f"{out}: expected a folder, or a name that ends in {VIDEO_SUFFIX}{kinds}")
    return suffix


def _last(steps: Iterator[Rendered], rendering: Rendering) -> Rendered:
    """What was rendered when all steps are done; there is at least one frame."""
    *_, done = with_progress(steps, len(rendering.workspace.frames), "drawing")
    return done


def _write_panorama(rendering: Rendering, painter: TopViewPainter, out: Path) -> Rendered:
    rendered, count = Rendered(out), len(rendering.workspace.frames)
    scenes = with_progress(rendering.scenes(rendered), count, "drawing")
    data = painter.panorama(scenes, count, rendered)
    if data is None:
        raise UsageError("nothing to do: no frame has a camera and a picture")
    write_atomic(out, data)
    echo(f"written: {out}")
    return rendered


def _positions(path: Path | None, workspace: Workspace) -> dict[str, FloatArray]:
    """Frame name -> (N, 2) metres, of a table of ``ground``."""
    if path is None:
        return {}
    table = PointTable.read(path, metres=True)
    if table.columns == ("x", "y"):
        raise UsageError(f"{path}: has x, y in px alone: positions have X, Y in metres (ground)")
    if axes := {str(row["axes"]) for row in table.rows if "axes" in row}:
        raise UsageError(f"{path}: positions in the axes {min(axes)}: write them in those of field")
    rows, find = dict[str, list[int]](), frame_finder(workspace.index)
    for row, frame in enumerate(table.frames):
        if (name := find(frame)) is not None:
            rows.setdefault(name, []).append(row)
    found = {name: table.places[chosen] for name, chosen in rows.items()}
    if not found:
        raise UsageError(f"{path}: no position is of a frame of {workspace.root}")
    return found
