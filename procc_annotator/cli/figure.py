"""``procc-annotator figure``: frames by methods in one figure."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from procc_annotator.cli import input_files, options, outputs, remarks
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.drawing_options import DrawingOptions
from procc_annotator.cli.echo import echo
from procc_annotator.cli.method_arguments import parse_sources
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import UsageError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.report.overlay_scene import Rendered, Rendering, Scene

HELP = """\
Rows are frames, columns are methods; each cell shows the overlay of the window and its JaC. OUT
ends in .svg, .pdf or .png. Without --frame, frames are chosen at evenly spaced ranks of their mean
JaC, from the worst to the best.

Exit code: 0; 1 if some files were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator figure sample_data figure.pdf --cameras a=sample_data/cameras/pinhole \\
      --cameras b=sample_data/cameras/bad
  procc-annotator figure sample_data figure.svg --cameras sample_data/cameras/bad --frame 00003
"""


def figure(
    dataset: input_files.Dataset,
    out: Annotated[Path, typer.Argument(help="File of the figure: .svg, .pdf or .png.")],
    given: DrawingOptions,
    cameras: options.Sources = None,
    frames: Annotated[
        list[str] | None, typer.Option("--frame", metavar="NAME", help="A frame; repeat.")
    ] = None,
    count: Annotated[
        int, typer.Option("--count", min=1, max=50, metavar="N", help="Frames to choose.")
    ] = 4,
    width: Annotated[
        float, typer.Option(min=1, max=40, metavar="INCHES", help="Width of the figure.")
    ] = 7.0,
    overwrite: options.Overwrite = False,
) -> None:
    from procc_annotator.figures.qualitative import SUFFIXES, qualitative_figure

    suffix = out.suffix.lower()
    if suffix not in SUFFIXES:
        raise UsageError(f"{out}: expected a name that ends in {', '.join(SUFFIXES)}")
    if not cameras:
        raise UsageError("a figure needs methods: --cameras NAME=PATH")
    outputs.check_output_folder(out)
    if out.exists() and not overwrite:
        raise UsageError(f"{out}: exists already, choose another name, or --overwrite")
    setup = given.setup(dataset)
    workspace = given.open(dataset, setup)
    methods = [
        CameraSet.open(spec.path, spec.format, spec.name, given.own_size, setup.field)
        for spec in parse_sources(cameras, given.camera_format)
    ]
    renderings = [given.rendering(workspace, setup, method) for method in methods]
    rendered = Rendered(out)
    chosen = _named(frames, workspace) if frames else _spread(renderings, count, rendered)
    rows = [[one.scene(index, rendered) for one in renderings] for index in chosen]
    write_atomic(out, qualitative_figure(rows, [m.name for m in methods], suffix, width))
    names = ", ".join(workspace.frames[index].name for index in chosen)
    echo(f"written: {out} (frames {names})")
    remarks.report_notices(rendered.notices)
    raise typer.Exit(remarks.report_unreadable(list(dict.fromkeys(rendered.problems))))


def _named(names: list[str], workspace: Workspace) -> list[int]:
    found = []
    for name in names:
        index = workspace.index.get(name)
        if index is None:
            raise UsageError(f"{workspace.root}: has no frame {name!r}")
        found.append(index)
    return found


def _spread(renderings: list[Rendering], count: int, rendered: Rendered) -> list[int]:
    """Frames at evenly spaced ranks of their mean JaC over the methods."""
    frames = renderings[0].workspace.frames
    means: list[tuple[float, int]] = []
    for index in with_progress(range(len(frames)), len(frames), "choosing"):
        scenes: list[Scene] = [one.scene(index, rendered) for one in renderings]
        scores = [scene.score.jac for scene in scenes if scene.score is not None]
        if scores:
            means.append((sum(scores) / len(renderings), index))
    if not means:
        raise UsageError("nothing to do: no annotated frame has a camera")
    means.sort()
    ranks = np.unique(np.linspace(0, len(means) - 1, count).round().astype(int))
    return [means[rank][1] for rank in ranks]
