"""A command that is imported when it is chosen: the list of commands loads none of them."""

from __future__ import annotations

import gc
from functools import cached_property
from importlib import import_module
from typing import Any

import typer
from typer.core import TyperCommand
from typer.main import get_command

from procc_annotator.cli.asked import with_options

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
        alone.command(self.name, help=text, epilog=module.EXAMPLE)(with_options(chosen))
        return get_command(alone)

    def make_context(
        self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any
    ) -> Any:
        return self.load().make_context(info_name, args, parent, **extra)
