"""The ``procc-annotator`` command; cheap to import: a command imports what it needs when run."""

from __future__ import annotations

import errno
import os
import sys
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from procc_annotator import __version__
from procc_annotator.cli import (
    agree,
    calibrate,
    check,
    check_submission,
    compare,
    convert,
    evaluate,
    export,
    field,
    field_size,
    headless,
    open,
    render,
    report,
    triangulate,
)
from procc_annotator.errors import ProccError

EXAMPLES = """
Examples:

\b
  procc-annotator                        open the window
  procc-annotator match/                 ... on a folder of pictures
  procc-annotator evaluate annotations/ cameras/ --threshold 5
  procc-annotator COMMAND --help         options and an example of a command
"""

INTERRUPTED = 130  # 128 + SIGINT
READER_GONE = 141  # 128 + SIGPIPE, as a shell has it
_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)


class CommandOrPath(TyperGroup):
    """A first argument that is a path, or none at all, opens the window."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        if self._opens_window(args):
            args = ["open", *args]
        return super().parse_args(ctx, args)

    def _opens_window(self, args: list[str]) -> bool:
        if not args:
            return True
        first = args[0]
        if first in self.commands:
            return False
        if first.startswith("-"):
            own = {name for option in self.params for name in option.opts} | {"--help", "-h"}
            return first not in own
        # A mistyped command is no path: leave it to the group, which knows what was meant.
        return os.path.exists(first) or os.sep in first

    def invoke(self, ctx: Any) -> Any:
        try:
            result = super().invoke(ctx)
            sys.stdout.flush()
            return result
        except ProccError as error:
            typer.echo(f"procc-annotator: {error}", err=True)
            raise typer.Exit(2) from error
        except KeyboardInterrupt as error:
            typer.echo(f"procc-annotator: interrupted{_what_is_done(error)}", err=True)
            raise typer.Exit(INTERRUPTED) from error
        except BrokenPipeError as error:
            # Who reads our output has seen enough (``| head``): end as other programs do.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            raise typer.Exit(READER_GONE) from error
        except OSError as error:
            # Files are written by functions that name them; what is left is the standard output.
            if error.errno not in _FULL or error.filename is not None:
                raise
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            said = f"the standard output cannot be written: {error.strerror}"
            typer.echo(f"procc-annotator: {said} (make room, or send it elsewhere)", err=True)
            raise typer.Exit(2) from error


def _what_is_done(stopped: KeyboardInterrupt) -> str:
    """What a command that was stopped said of its work: the interrupt's text, if it has one."""
    return f": {stopped}" if str(stopped) else ""


app = typer.Typer(
    name="procc-annotator",
    cls=CommandOrPath,
    help="Annotate and audit the calibration of sports cameras.",
    epilog=EXAMPLES,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"procc-annotator {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version."
        ),
    ] = False,
) -> None:
    """Annotate and audit the calibration of sports cameras."""


for _module, _command in (
    (open, open.open_window),
    (evaluate, evaluate.evaluate),
    (agree, agree.agree),
    (compare, compare.compare),
    (report, report.report),
    (calibrate, calibrate.calibrate),
    (check, check.check),
    (field_size, field_size.field_size),
    (triangulate, triangulate.triangulate),
    (export, export.export),
    (convert, convert.convert),
    (render, render.render),
    (check_submission, check_submission.check_submission),
    (headless, headless.headless),
):
    _name = _module.__name__.rpartition(".")[2].replace("_", "-")
    app.command(_name, help=_module.HELP, epilog=_module.EXAMPLE, hidden=_module is headless)(
        _command
    )
app.add_typer(field.app, name="field")


def run() -> None:
    """Entry point of the console script."""
    try:
        app(prog_name="procc-annotator")
    except KeyboardInterrupt:  # the commands were not put together yet
        typer.echo("procc-annotator: interrupted", err=True)
        sys.exit(INTERRUPTED)
