"""``procc-annotator render``: overlay pictures, drawn by the painter of the window."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import input_files, options, outputs, remarks
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.painters import overlay_painter
from procc_annotator.messages import list_names, pluralize
from procc_annotator.report.overlay_scene import OverlayLook, Rendered, render_pictures

HELP = """\
Colours and dashes are those of the window: they say which elements agree at --threshold; --legend
explains them below each picture. With --format svg lines and text stay sharp at any size. Pictures
that are there already are replaced only with --overwrite, or after a run that was stopped.

Exit code: 0; 1 if some files were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """
Example:

\b
  procc-annotator render match/ overlays/ --cameras predictions/ --threshold 5
  procc-annotator render match/ figures/ --format svg --scale 2 --legend
"""


class PictureFormat(StrEnum):
    """Encodings of overlay pictures."""

    png = "png"
    jpg = "jpg"
    svg = "svg"


Out = Annotated[Path, typer.Argument(help="Folder of the overlay pictures.")]
Threshold = Annotated[
    float, typer.Option("--threshold", "-t", metavar="PX", help="Decides the colours.")
]
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


def render(
    dataset: input_files.Dataset,
    out: Out,
    annotations: input_files.Annotations = None,
    labels: options.LabelsFile = None,
    cameras: input_files.Cameras = None,
    threshold: Threshold = options.DEFAULT_THRESHOLD,
    protocol: options.Protocol = "soccernet",
    size: options.Size = "960x540",
    field: options.FieldName = None,
    lines: options.Lines = None,
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
    off_plane: options.OffPlane = "missed",
    mirrored: options.Mirrored = False,
    picture_format: Encoding = PictureFormat.png,
    scale: Scale = 1.0,
    painted_width: PaintedWidth = False,
    legend: Legend = False,
    overwrite: options.Overwrite = False,
) -> None:

    look = OverlayLook(scale, legend)
    setup = options.make_setup(
        field, size, protocol, off_plane, mirrored, datasets=[dataset], lines=lines
    )
    (tau,) = options.thresholds_or_default([threshold])
    workspace = input_files.open_dataset(
        dataset, setup.field, annotations, options.label_map(labels, setup.field)
    )
    camera_set = input_files.open_cameras(
        cameras, camera_format, options.shown_size(camera_size), setup.field
    )
    outputs.check_folder_apart(
        out, [workspace.annotations, *([camera_set] if camera_set is not None else [])]
    )
    suffix = f".{picture_format.value}"
    names = (f"{frame.name}{suffix}" for frame in workspace.frames)
    steps = render_pictures(
        workspace, out, overlay_painter(suffix, look),
        setup=setup, threshold=tau, cameras=camera_set, suffix=suffix,
        painted_width=painted_width,
    )  # fmt: skip
    rendered = Rendered(out)
    with outputs.replacing_nothing(out, names, "render", overwrite=overwrite):
        for done in with_progress(steps, len(workspace.frames), "drawing"):
            rendered = done
    echo(f"{pluralize(len(rendered.pictures), 'overlay picture')} written to {out}")
    remarks.report_notices(rendered.notices)
    if rendered.bare:
        frames = list_names(rendered.bare, "frame")
        remarks.report_remarks([f"neither annotation nor camera, nothing is drawn: {frames}"])
    raise typer.Exit(remarks.report_unreadable(rendered.problems))
