"""``procc-annotator field``: the sports this program knows, and a field file of one's own."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli.console import stdout_console
from procc_annotator.cli.echo import echo, example_epilog
from procc_annotator.cli.open import display_available, require_qt_libraries
from procc_annotator.cli.options import chosen_field
from procc_annotator.cli.outputs import check_not_inputs, check_output_folder
from procc_annotator.errors import FieldError, UsageError
from procc_annotator.field.load import field_names, load_field, named_field, place_in_file
from procc_annotator.field.model import Field
from procc_annotator.field.validation import WarningSeverity, validate_field
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.messages import pluralize
from procc_annotator.report import field_tables
from procc_annotator.report.field_tables import (
    FlatField,
    check_picture_suffix,
    field_picture,
    list_table,
)

LIST_HELP = "List the fields that come with the program."
LIST_EXAMPLE = """\
  procc-annotator field list
  procc-annotator field list --help
"""
CHECK_HELP = """Check a field file.

Errors name the line, what was expected and what to do. Warnings are probable mistakes: elements
outside the field, below the ground or at the place of another, similar colours, keys that the
window needs, ranges that the relations of dimensions do not allow. Notes may be ignored.

Exit code: 0 without errors and warnings; 1 with some; 2 if the field cannot be read.
"""
CHECK_EXAMPLE = """\
  procc-annotator field check tennis
  procc-annotator field check soccer
"""
SHOW_HELP = """Show a field: its elements, dimensions and symmetries as tables, and its map.

--output writes the map as a picture. On a terminal a window with the map opens as well and follows
the file while you edit it (--no-window: none). Dimensions that are not nominal follow the name:
futsal:length=39.8,width=19.9 (metres).

Exit code: 0; 2 if the field cannot be read.
"""
SHOW_EXAMPLE = """\
  procc-annotator field show basketball_fiba
  procc-annotator field show sample_data/volleyball/field.toml --output map.svg
"""

app = typer.Typer(
    add_completion=False,
    rich_markup_mode=None,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)
FieldText = Annotated[
    str, typer.Argument(metavar="NAME|FILE", help="A field by name, or a .toml file.")
]


@app.command("list", help=LIST_HELP, epilog=example_epilog(LIST_EXAMPLE))
def list_fields() -> None:
    stdout_console().print(list_table(load_field(name) for name in field_names()))


@app.command("check", help=CHECK_HELP, epilog=example_epilog(CHECK_EXAMPLE))
def check(field: FieldText) -> None:
    read = chosen_field(field)
    remarks = validate_field(read, _keys_of_the_window())
    for remark in remarks:
        echo(remark.with_location(place_in_file(read, remark.place)))
    doubtful = sum(remark.severity is not WarningSeverity.NOTE for remark in remarks)
    elements = pluralize(len(read.elements), "element")
    found = f"{elements}, {pluralize(len(read.dimensions), 'dimension')}"
    verdict = "nothing to mend" if not doubtful else f"{doubtful} to look at"
    echo(f"{read.title}: {found}: {verdict}")
    raise typer.Exit(1 if doubtful else 0)


@app.command("show", help=SHOW_HELP, epilog=example_epilog(SHOW_EXAMPLE))
def show(
    field: FieldText,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", metavar="FILE.png|.svg",
            help="Write the map as a picture.",
        ),
    ] = None,
    window: Annotated[
        bool | None,
        typer.Option(
            "--window/--no-window",
            help="Open a window that follows the file.  [default: on a terminal, without --output]",
        ),
    ] = None,
) -> None:  # fmt: skip
    wanted = window
    if wanted is None:
        wanted = output is None and sys.stdout.isatty() and display_available()
    try:
        read = chosen_field(field)
    except FieldError as error:
        if not wanted:
            raise
        echo(f"procc-annotator: {error}", err=True)  # the window waits until it is mended
    else:
        if output is not None:
            _write_picture(read, output)
        _print(read)
        if output is not None:
            echo(f"map written to {output}")
    if wanted:
        if not display_available():
            raise UsageError("there is no display for the window; --output writes the map")
        require_qt_libraries()
        from procc_annotator.gui.field_preview import run_preview

        raise typer.Exit(run_preview(*named_field(field), _keys_of_the_window()))


def _print(field: Field) -> None:
    console = stdout_console()
    console.print(field_tables.elements_table(field))
    console.print(field_tables.dimensions_table(field))
    for fact in field_tables.facts(field):
        echo(fact)


def _write_picture(field: Field, out: Path) -> None:
    from procc_annotator.gui.panels.field_map.field_shape import FieldShape

    check_picture_suffix(out)
    check_output_folder(out)
    check_not_inputs([out], [field.source] if field.source is not None else [])
    shape = FieldShape.of(field)
    write_atomic(out, field_picture(field, FlatField(shape.lines, shape.ground), out.suffix))


def _keys_of_the_window() -> dict[str, str]:
    """Keys that do something else in the window; its tables need no Qt."""
    from procc_annotator.gui.actions import ACTIONS
    from procc_annotator.gui.keymap import GESTURES

    taken = {key: action.text.lstrip("-").rstrip("…") for action in ACTIONS for key in action.keys}
    for gesture, does in GESTURES:
        word, _, key = gesture.partition(" ")
        if word == "Hold" and len(key) == 1:
            taken[key] = does
    return taken
