"""``procc-annotator render``: overlay pictures, drawn by the painter of the window."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli import datasets, options

HELP = """Draw the pictures of a dataset with annotation and, given cameras, the projected field.

Colours and dashes are those of the window: they say which elements agree at --threshold.

Exit code: 0; 1 if some files were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """
Example:

\b
  procc-annotator render match/ overlays/ --cameras predictions/ --threshold 5
"""


class PictureFormat(StrEnum):
    """Encodings of overlay pictures."""

    png = "png"
    jpg = "jpg"


def render(
    dataset: datasets.Dataset,
    out: Annotated[Path, typer.Argument(help="Folder of the overlay pictures.")],
    annotations: datasets.Annotations = None,
    cameras: datasets.Cameras = None,
    threshold: Annotated[
        float, typer.Option("--threshold", "-t", metavar="PX", help="Decides the colours.")
    ] = options.DEFAULT_THRESHOLD,
    protocol: options.Protocol = "soccernet",
    size: options.Size = "960x540",
    field: options.FieldName = "soccer",
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
    off_plane: options.OffPlane = "missed",
    mirrored: options.Mirrored = False,
    picture_format: Annotated[
        PictureFormat, typer.Option("--format", help="Encoding of the pictures.")
    ] = PictureFormat.png,
) -> None:
    from procc_annotator.cli.console import with_progress
    from procc_annotator.gui.picture.overlay_picture import OverlayPictures
    from procc_annotator.report.pictures import Rendered, render_pictures

    setup = options.make_setup(field, size, protocol, off_plane, mirrored)
    (tau,) = options.thresholds_or_default([threshold])
    workspace = datasets.open_dataset(dataset, setup.field, annotations)
    camera_set = datasets.open_cameras(cameras, camera_format, options.shown_size(camera_size))
    suffix = f".{picture_format.value}"
    steps = render_pictures(
        workspace, out, OverlayPictures(suffix),
        setup=setup, threshold=tau, cameras=camera_set, suffix=suffix,
    )  # fmt: skip
    rendered = Rendered(out)
    for done in with_progress(steps, len(workspace.frames), "drawing"):
        rendered = done
    typer.echo(f"{len(rendered.pictures)} overlay pictures written to {out}")
    datasets.report_notices(rendered.notices)
    raise typer.Exit(datasets.report_unreadable(rendered.problems))
