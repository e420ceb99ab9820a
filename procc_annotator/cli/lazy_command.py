"""A command that is imported when it is chosen: the list of commands loads none of them."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields, is_dataclass
from functools import cached_property
from importlib import import_module
from inspect import Parameter, Signature, signature
from typing import Any, get_type_hints

import typer
from typer.core import TyperCommand
from typer.main import get_command


def with_options(command: Callable[..., None]) -> Callable[..., None]:
    """A command as typer reads it: each parameter that is a class of options becomes those.

    Args:
        command: its parameters are options, or dataclasses whose fields are options or such classes
            again, in the order of its help.
    """
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
        alone.command(self.name, help=text, epilog=module.EXAMPLE)(with_options(chosen))
        return get_command(alone)

    def make_context(
        self, info_name: str | None, args: list[str], parent: Any = None, **extra: Any
    ) -> Any:
        return self.load().make_context(info_name, args, parent, **extra)
