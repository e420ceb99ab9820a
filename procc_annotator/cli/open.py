"""``procc-annotator open``, and plain ``procc-annotator [PATH]``: the window."""

from __future__ import annotations

import gc
import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli.echo import echo
from procc_annotator.cli.field_option import chosen_field
from procc_annotator.cli.options import Lines, Sources
from procc_annotator.cli.qt_libraries import require_qt_libraries
from procc_annotator.cli.sources import parse_sources
from procc_annotator.errors import UsageError
from procc_annotator.image.suffixes import VIDEO_SUFFIXES
from procc_annotator.session.dataset.dataset_folder import FIELD_FILE, frames_folder

HELP = """\
PATH is a folder of pictures (or its field.toml), one picture, a video, or nothing. The word "open"
may be left out.

With --selftest the program tries itself: the window opens (out of sight, unless QT_QPA_PLATFORM
says otherwise), one element is annotated in a copy of a picture, saved and read back, and the
window closes. Exit code: 0 if all went well, 2 if not. No setting and no file of yours is changed.
"""

EXAMPLE = """
Example:

\b
  procc-annotator open match/ --cameras predictions/

  procc-annotator open match/ --field basketball_fiba

  procc-annotator open match/ --cameras ours=predictions/ --cameras carwc:carwc=npy/
"""


@dataclass(frozen=True)
class OpenOptions:
    """What `open` is asked for."""

    path: Annotated[
        Path | None, typer.Argument(help="Folder of pictures, one picture, or a video.")
    ] = None
    annotations: Annotated[
        Path | None,
        typer.Option(
            metavar="DIR", help="Folder of the annotation files, if not beside the pictures."
        ),
    ] = None
    cameras: Sources = None
    field: Annotated[
        str | None,
        typer.Option(
            "--field",
            metavar="NAME|FILE[:DIMENSIONS]",
            show_default=False,
            help="The field that PATH shows, which its dataset remembers.  [default: what it"
            " remembers, or what its classes tell]",
        ),
    ] = None
    lines: Lines = None
    selftest: Annotated[
        bool,
        typer.Option("--selftest", help="Try the window on a copy of a picture, and end."),
    ] = False


def open_window(given: OpenOptions) -> None:
    path = given.path
    if path is not None and path.name == FIELD_FILE and path.is_file():
        path = path.parent  # a dataset's own, opened from a file manager
    if given.selftest:
        os.environ["QT_QPA_PLATFORM"] = os.environ.get("QT_QPA_PLATFORM") or "offscreen"
        raise typer.Exit(_selftest(path, given.field, given.lines))
    texts = given.cameras or []
    sources = parse_sources(texts)
    for place in (path, given.annotations, *(source.path for source in sources)):
        if place is not None and not place.exists():
            raise UsageError(f"{place}: does not exist")
    if path is not None and given.annotations is not None and path.suffix.lower() in VIDEO_SUFFIXES:
        raise UsageError(
            f"{path} is a video, whose annotations lie in {frames_folder(path)}: open it without"
            " --annotations, or move them there"
        )
    if not display_available():
        raise UsageError(
            "there is no display for the window; `evaluate`, `export` and `render` work without"
        )
    require_qt_libraries()
    gc.disable()  # what is imported stays; the window looks for garbage when it is there
    from procc_annotator.gui.app import CameraChoice, main

    shown = None
    if given.field is not None:
        shown = chosen_field(given.field, lines=given.lines)
    elif given.lines is not None:
        shown = chosen_field(None, path, lines=given.lines)
    choices = [
        # A path alone leaves the name open, so that one given in the window earlier comes back.
        CameraChoice(s.path, s.format, None if str(s.path) == str(Path(text)) else s.name)
        for s, text in zip(sources, texts, strict=True)
    ]
    raise typer.Exit(main(path, annotations=given.annotations, cameras=choices, field=shown))


def _selftest(path: Path | None, field: str | None, lines: str | None) -> int:
    if path is not None and not path.exists():
        raise UsageError(f"{path}: does not exist")
    require_qt_libraries()
    from procc_annotator.gui.selftest import run_selftest

    shown = chosen_field(field, lines=lines) if field is not None else None
    echo(run_selftest(path, shown))
    return 0


def display_available() -> bool:
    """Whether Qt can show a window here; asking Qt itself would end the process."""
    if not sys.platform.startswith("linux"):
        return True
    return any(os.environ.get(n) for n in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"))
