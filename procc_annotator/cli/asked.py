"""What a command is asked for, declared once as a class: its fields are the options."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import MISSING, fields, is_dataclass
from inspect import Parameter, Signature, signature
from typing import Any, get_type_hints


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
        for option in _options(name, hints[name], one.default)
    ]

    def called(**given: Any) -> None:
        for name, group in groups.items():
            given[name] = _filled(group, given)
        command(**given)

    vars(called)["__signature__"] = Signature(parameters)
    called.__annotations__ = {one.name: one.annotation for one in parameters}
    return called


def _options(name: str, hint: Any, default: Any) -> Iterator[Parameter]:
    """The options of a group, or of groups within it, in order; one option is itself."""
    if not is_dataclass(hint):
        yield Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=hint)
        return
    hints = get_type_hints(hint, include_extras=True)
    for one in fields(hint):
        own = Parameter.empty if one.default is MISSING else one.default
        yield from _options(one.name, hints[one.name], own)


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
