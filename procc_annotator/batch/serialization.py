"""Results of this package's own classes as one line of JSON, and back."""

from __future__ import annotations

import json
import sys
from base64 import b64decode, b64encode
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.translation import TranslatableText

_PACKAGE = "procc_annotator"
# Kinds of numbers that an array may be of: booleans, whole numbers, floats.
_NUMBERS = "biuf"


class SerializationError(ValueError):
    """Text that no value was kept as."""


def serialize(value: object) -> str:
    """A value as one line of JSON.

    Raises:
        TypeError: it is, or holds, something else than plain data.
    """
    return json.dumps(_Serializer().plain(value), separators=(",", ":"))


def deserialize(text: str | bytes) -> Any:
    """The value again; what was one object in it is one again.

    Raises:
        KeptValueError: nothing was kept like this, or by another version.
    """
    try:
        return _Deserializer().value(json.loads(text))
    except (ValueError, TypeError, KeyError, IndexError, AttributeError, ImportError) as error:
        raise SerializationError(str(error)) from error


class _Serializer:
    def __init__(self) -> None:
        self._objects: dict[int, int] = {}
        self._alive: list[object] = []  # an id is an object's own only as long as that is there

    def plain(self, value: Any) -> Any:
        if value is None or type(value) in (bool, int, float, str):
            return value
        if isinstance(value, TranslatableText):
            return str(value)  # for commands, which speak English
        if isinstance(value, list):
            return [self.plain(one) for one in value]
        if isinstance(value, np.generic) and value.dtype.kind in _NUMBERS:
            return {"n": [value.dtype.str, value.item()]}
        if isinstance(value, np.ndarray) and value.dtype.kind in _NUMBERS:
            data = b64encode(np.ascontiguousarray(value).tobytes()).decode()
            return {"a": [value.dtype.str, list(value.shape), data]}
        if isinstance(value, bytes):
            return {"b": b64encode(value).decode()}
        if isinstance(value, Path):
            return {"p": str(value)}
        if isinstance(value, dict):
            return {"d": [[self.plain(key), self.plain(one)] for key, one in value.items()]}
        return self._of_class(value)

    def _of_class(self, value: Any) -> Any:
        kind = type(value)
        if kind is tuple:
            return {"t": [self.plain(one) for one in value]}
        if not kind.__module__.startswith(f"{_PACKAGE}."):
            raise TypeError(f"{kind.__module__}.{kind.__qualname__} is no plain data")
        if hasattr(kind, "_fields"):
            own = list(value)
        elif is_dataclass(kind):
            if id(value) in self._objects:
                return {"r": self._objects[id(value)]}
            own = [getattr(value, field.name) for field in fields(value) if field.init]
        else:
            raise TypeError(f"{kind.__module__}.{kind.__qualname__} is no plain data")
        found = {"c": [f"{kind.__module__}:{kind.__qualname__}", [self.plain(one) for one in own]]}
        if is_dataclass(kind):
            self._objects[id(value)] = len(self._alive)
            self._alive.append(value)
        return found


class _Deserializer:
    def __init__(self) -> None:
        self._objects: list[Any] = []

    def value(self, plain: Any) -> Any:
        if isinstance(plain, list):
            return [self.value(one) for one in plain]
        if not isinstance(plain, dict):
            return plain
        ((kind, content),) = plain.items()
        if kind == "t":
            return tuple(self.value(one) for one in content)
        if kind == "d":
            return {self.value(key): self.value(one) for key, one in content}
        if kind == "n":
            return _number_type(content[0]).type(content[1])
        if kind == "a":
            dtype, shape, data = content
            return np.frombuffer(bytearray(b64decode(data)), _number_type(dtype)).reshape(shape)
        if kind == "b":
            return b64decode(content)
        if kind == "p":
            return Path(content)
        if kind == "r":
            return self._objects[content]
        if kind == "c":
            return self._of_class(*content)
        raise SerializationError(f"no kind {kind!r}")

    def _of_class(self, name: str, content: list[Any]) -> Any:
        kind, named = _plain_class(name)
        own = [self.value(one) for one in content]
        if named is None:
            return kind(*own)
        made = kind(**dict(zip(named, own, strict=True)))
        self._objects.append(made)
        return made


def _number_type(text: str) -> np.dtype[Any]:
    dtype = np.dtype(text)
    if dtype.kind not in _NUMBERS:
        raise SerializationError(f"{text} is no kind of numbers")
    return dtype


def _plain_class(name: str) -> tuple[Callable[..., Any], list[str] | None]:
    """A dataclass of this package, by its module and name, with the names of what it is made from;
    or a named tuple, with None."""
    module, _, qualified = name.partition(":")
    if not module.startswith(f"{_PACKAGE}.") or not qualified.isidentifier():
        raise SerializationError(f"{name} is no class of {_PACKAGE}")
    found = getattr(sys.modules.get(module) or import_module(module), qualified)
    if not isinstance(found, type) or found.__module__ != module:
        raise SerializationError(f"{name} is no class of {module}")
    if is_dataclass(found):
        return found, [field.name for field in fields(found) if field.init]
    if issubclass(found, tuple) and hasattr(found, "_fields"):
        return found, None
    raise SerializationError(f"{name} is no plain data")
