"""Entry points, the table of commands and exit codes."""

from __future__ import annotations

import errno
import gc
import io
import os
import sys
from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields, is_dataclass
from functools import cached_property
from importlib import import_module
from inspect import Parameter, Signature, signature
from typing import Annotated, Any, get_type_hints

import typer
from typer.core import TyperCommand, TyperGroup
from typer.main import get_command

from procc_annotator.cli.echo import echo, example_epilog
from procc_annotator.error_log import install_handlers, log_path
from procc_annotator.errors import ProccError
from procc_annotator.version import __version__


def with_options(command: Callable[..., None]) -> Callable[..., None]:
    """A command as typer reads it: its parameters are options, or dataclasses whose fields are
    options or such classes again, each of which becomes those, in the order of its help."""
    hints = get_type_hints(command, include_extras=True)
    groups = {name: hint for name, hint in hints.items() if is_dataclass(hint)}
    parameters = [
        option
        for name, one in signature(command).parameters.items()
        for option in _expand_options(name, hints[name], one.default)
    ]

    def called(**given: Any) -> None:
        for name, group in groups.items():
            given[name] = _filled(group, given)
        command(**given)

    vars(called)["__signature__"] = Signature(parameters)
    called.__annotations__ = {one.name: one.annotation for one in parameters}
    return called


def _expand_options(name: str, hint: Any, default: Any) -> Iterator[Parameter]:
    """The options of a group, or of groups within it, in order; one option is itself."""
    if not is_dataclass(hint):
        yield Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=hint)
        return
    hints = get_type_hints(hint, include_extras=True)
    for one in fields(hint):
        own = Parameter.empty if one.default is MISSING else one.default
        yield from _expand_options(one.name, hints[one.name], own)


def _filled(group: Any, given: dict[str, Any]) -> Any:
    """A group with its options, which are taken out of those given."""
    hints = get_type_hints(group, include_extras=True)
    return group(
        **{
            one.name: _filled(hints[one.name], given)
            if is_dataclass(hints[one.name])
            else given.pop(one.name)
            for one in fields(group)
        }
    )


_NEW_OBJECTS = 20_000  # before garbage is looked for: arrays and frozen values make hardly any


class LazyCommand(TyperCommand):
    """A command by its name and first sentence; all else about it is in its module.

    The module is called like the command and holds ``HELP``, what follows the first sentence,
    ``EXAMPLE``, and the function; or a `typer.Typer`, for a command of several.

    Args:
        name: what is typed.
        summary: its first sentence.
        attribute: of the module, if it is not called like it.
        hidden: whether the list leaves it out.
    """

    def __init__(
        self, name: str, summary: str, attribute: str | None = None, *, hidden: bool = False
    ) -> None:
        super().__init__(name, help=summary, hidden=hidden, rich_markup_mode=None)
        self._module = name.replace("-", "_")
        self._attribute = attribute or self._module

    def load(self) -> Any:
        """The command itself, with its options."""
        return self._loaded

    @cached_property
    def _loaded(self) -> Any:
        gc.disable()  # what is imported stays: to look through it is a tenth of the start
        try:
            return self._imported()
        finally:
            gc.freeze()  # nor later
            gc.set_threshold(_NEW_OBJECTS)
            gc.enable()

    def _imported(self) -> Any:
        module = import_module(f"procc_annotator.cli.{self._module}")
        chosen = getattr(module, self._attribute)
        if isinstance(chosen, typer.Typer):
            command = get_command(chosen)
            command.help = self.help
            return command
        alone = typer.Typer(add_completion=False, rich_markup_mode=None)
        text = f"{self.help}\n\n{module.HELP}"
        alone.command(self.name, help=text, epilog=example_epilog(module.EXAMPLE))(
            with_options(chosen)
        )
        return get_command(alone)

    def make_context(
        self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any
    ) -> Any:
        return self.load().make_context(info_name, args, parent, **extra)


EXAMPLES = """\
  procc-annotator                  open the window
  procc-annotator sample_data      ... on a folder of pictures
  procc-annotator evaluate sample_data sample_data/cameras/bad --threshold 5
  procc-annotator COMMAND --help   options and examples of a command
"""

COMMANDS = (
    LazyCommand("open", "Open the window.", "open_window"),
    LazyCommand("evaluate", "Score cameras against annotations."),
    LazyCommand("agree", "Compare annotators with each other or a reference."),
    LazyCommand("compare", "Compare two sets of cameras, in metres and IoU."),
    LazyCommand("report", "Write a report on methods: HTML, LaTeX, CSV, JSON."),
    LazyCommand("repeat", "Repeat a run from its manifest; list differences."),
    LazyCommand("calibrate", "Fit a camera to the annotation of every frame."),
    LazyCommand("propose", "Find the camera of pictures without annotations."),
    LazyCommand("track", "Track the camera through videos or a season."),
    LazyCommand("status", "Show the progress of track."),
    LazyCommand("annotate", "Annotate the lines that known cameras show."),
    LazyCommand(
        "check",
        "Find wrong labels and misplaced points.",
    ),
    LazyCommand("field-size", "Estimate length and width of a stadium's field."),
    LazyCommand("triangulate", "Triangulate landmarks from several views."),
    LazyCommand(
        "export",
        "Write SoccerNet JSON with JaC per frame.",
    ),
    LazyCommand("ground", "Convert pixels of a table to metres, or back."),
    LazyCommand("convert", "Convert annotations or cameras to another format."),
    LazyCommand("propose-map", "Propose a map from foreign labels to classes."),
    LazyCommand("release", "Write a dataset release: hashes, card, metadata."),
    LazyCommand(
        "render",
        "Draw overlays, overlay videos and top views.",
    ),
    LazyCommand("figure", "Draw a figure of frames and methods."),
    LazyCommand("check-submission", "Check a submission to the SoccerNet evaluation."),
    LazyCommand("desktop-entry", "Add the program to the menus of a Linux desktop."),
    LazyCommand(
        "field",
        "List, check and show fields; write your own.",
        "app",
    ),
)

FAULT = 3  # of the program, not of what it was given
INTERRUPTED = 130  # 128 + SIGINT
BROKEN_PIPE = 141  # 128 + SIGPIPE, as a shell has it
_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)


class CommandOrPath(TyperGroup):
    """The commands of the program; a first argument that is a path, or none, opens the window."""

    def __init__(self, **settings: Any) -> None:
        super().__init__(**settings)
        self.commands = {str(command.name): command for command in COMMANDS}

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
            echo(f"procc-annotator: {error}", err=True)
            raise typer.Exit(2) from error
        except KeyboardInterrupt as error:
            said = f": {error}" if str(error) else ""  # what the command said of its work
            echo(f"procc-annotator: interrupted{said}", err=True)
            raise typer.Exit(INTERRUPTED) from error
        except BrokenPipeError as error:
            # Who reads our output has seen enough (``| head``): end as other programs do.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            raise typer.Exit(BROKEN_PIPE) from error
        except ImportError as error:
            if not _is_of_qt(error):
                raise
            from procc_annotator.cli.open import qt_missing_words

            echo(f"procc-annotator: {qt_missing_words(error)}", err=True)
            raise typer.Exit(2) from error
        except OSError as error:
            if error.filename is not None:  # one that no function names better
                name, why = os.fsdecode(error.filename), error.strerror or str(error)
                echo(f"procc-annotator: {ProccError(f'{name}: {why}')}", err=True)
                raise typer.Exit(2) from error
            if error.errno not in _FULL:
                raise
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            said = f"the standard output cannot be written: {error.strerror}"
            echo(f"procc-annotator: {said} (make room, or send it elsewhere)", err=True)
            raise typer.Exit(2) from error


def _is_of_qt(error: ImportError) -> bool:
    """Return whether it is Qt, or a library of the system that Qt needs, that could not be
    imported."""
    return "PySide6" in f"{error.name} {error.path}" or "shiboken6" in f"{error.name} {error.path}"


app = typer.Typer(
    name="procc-annotator",
    cls=CommandOrPath,
    help="Annotate and audit the calibration of sports cameras.",
    epilog=example_epilog(EXAMPLES),
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        echo(f"procc-annotator {__version__}")
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


def run() -> None:
    """Entry point of the console script."""
    # Matrices here are small: threads that multiply them cost more time than they save, and sums
    # that they share end in other digits. Read when NumPy is loaded, by processes it starts, too.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    # A character that the reader's encoding lacks is no reason to lose the whole table.
    if isinstance(sys.stdout, io.TextIOWrapper) and sys.stdout.errors == "strict":
        sys.stdout.reconfigure(errors="replace")
    install_handlers(_report_fault)
    try:
        # Called as ``app()``, typer would put its own hook for exceptions in place of ours.
        get_command(app)(prog_name="procc-annotator")
    except KeyboardInterrupt:  # the commands were not put together yet
        echo("procc-annotator: interrupted", err=True)
        sys.exit(INTERRUPTED)
    except Exception as error:  # noqa: BLE001 - a fault of the program: logged and reported
        sys.excepthook(type(error), error, error.__traceback__)
        sys.exit(FAULT)


def _report_fault(line: str, _details: str) -> None:
    echo(f"procc-annotator: unexpected error: {line} (see {log_path()})", err=True)


def run_window() -> None:
    """Entry point of the graphical script; its arguments are those of ``procc-annotator open``.

    Where the system gives no standard error (a program of Windows without a console), what would
    have been written there is shown in a dialog.
    """
    sys.argv[1:1] = ["open"]
    if sys.stderr is not None:
        run()
        return
    output = io.StringIO()
    sys.stdout = sys.stderr = output
    try:
        run()
    except SystemExit as ended:
        if ended.code and output.getvalue():
            _show(output.getvalue())
        raise


def _show(text: str) -> None:
    from PySide6.QtWidgets import QMessageBox

    from procc_annotator.gui.app import application

    application()
    QMessageBox.critical(None, "ProCC Annotator", text)
