"""``procc-annotator ground``: pixels of a table to metres on the ground, and back."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.api.ground_points import AXES, to_ground, to_pixels
from procc_annotator.api.loading import load_cameras
from procc_annotator.cli import options, outputs, remarks
from procc_annotator.cli.echo import echo
from procc_annotator.errors import UsageError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.point_tables import SUFFIXES, encode_table
from procc_annotator.messages import pluralize

HELP = """\
POINTS is CSV, JSON or Parquet with the columns frame and x, y in px, or a box (x, y, w, h; x1, y1,
x2, y2; bbox), of which the middle of the lower edge counts; MOT files are read as they are. A
frame number means the only camera with that number at the end of its name (12:
camera_000012.json). With the output of track for a season, frames are MATCH/FRAME.

The rows are written with X, Y, on_field and, for cameras with a covariance or with --pixel-sd, the
standard deviations sigma_x, sigma_y. Rows without a position have empty cells.

Exit code: 0; 1 if some cameras were unreadable (listed); 2 if there was nothing to do or no row
has a position.
"""

EXAMPLE = """\
  procc-annotator ground sample_data/tracks.csv --cameras sample_data/cameras/true \\
      --size 1280x720 --camera-size 960x540 --output positions.csv
  procc-annotator ground positions.csv --cameras sample_data/cameras/true --to-pixels \\
      --size 1280x720 --camera-size 960x540
"""


@dataclass(frozen=True)
class GroundOptions:
    """Options of `ground`."""

    points: Annotated[Path, typer.Argument(help="Table of points or boxes.")]
    cameras: Annotated[
        Path, typer.Option("--cameras", metavar="PATH", help="Cameras of the frames.")
    ]
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", metavar="FILE", help="CSV, JSON or Parquet.  [CSV here]"),
    ] = None
    field: options.FieldName = None
    size: Annotated[
        str | None,
        typer.Option(
            "--size",
            metavar="WxH",
            callback=options.checked_size,
            help="Picture size the points refer to.  [default: that of the cameras]",
        ),
    ] = None
    camera_format: options.CameraFormat = "auto"
    camera_size: options.CameraSize = None
    axes: Annotated[
        str,
        typer.Option(
            metavar="|".join(AXES),
            help="field: metres from the centre, y towards the main camera; up: y away from it (as"
            " SkillCorner, kloppy); corner: from the far left corner; metrica: that as shares of"
            " the field.",
        ),
    ] = "field"
    pixel_sd: Annotated[
        float | None,
        typer.Option(min=0, metavar="PX", help="Standard deviation of the points along each axis."),
    ] = None
    to_pixels: Annotated[
        bool, typer.Option("--to-pixels", help="X, Y in metres to x, y in px.")
    ] = False


def ground(given: GroundOptions) -> None:
    suffix = ".csv" if given.output is None else given.output.suffix.lower()
    if given.output is not None:
        outputs.check_output_folder(given.output)
        outputs.check_not_inputs([given.output], [given.points])
        if suffix not in SUFFIXES:
            raise UsageError(f"{given.output}: expected a name that ends in {', '.join(SUFFIXES)}")
    problems: list[str] = []
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        cameras = load_cameras(
            given.cameras, format=given.camera_format, on_damaged=lambda e: problems.append(str(e))
        )
    remarks.report_remarks(str(one.message) for one in warned)
    place = to_pixels if given.to_pixels else partial(to_ground, pixel_sd=given.pixel_sd)
    placed = place(
        given.points, cameras, field=options.chosen_field(given.field, given.cameras),
        size=options.shown_size(given.size), camera_size=options.shown_size(given.camera_size),
        axes=given.axes,
    )  # fmt: skip
    data = encode_table(placed.rows, suffix)
    if given.output is None:
        echo(data.decode().rstrip("\n"))
    else:
        write_atomic(given.output, data)
    rows, lost = len(placed.rows), sum(placed.reasons.values())
    inside = sum(row.get("on_field") is True for row in placed.rows)
    of_these = "" if given.to_pixels else f", {inside} on the field"
    echo(f"{rows - lost} of {pluralize(rows, 'row')} placed{of_these}", err=True)
    lines = (f"no place for {pluralize(n, 'row')}: {why}" for why, n in placed.reasons.items())
    remarks.report_remarks([*lines, *placed.notes])
    raise typer.Exit(remarks.report_unreadable(problems) if lost < rows else 2)
