"""Lines on the terminal: the only way in which a command prints text that is no table."""

from __future__ import annotations

import typer

from procc_annotator.errors import printable


def echo(text: object = "", *, err: bool = False) -> None:
    """Print a line; what a terminal would obey, in a name of a file for instance, is escaped."""
    typer.echo(printable(str(text), keep="\n"), err=err)  # noqa: TID251
