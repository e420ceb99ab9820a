"""Checkpoint file of an interrupted run, and JSON serialisation of its results."""

from __future__ import annotations

import hashlib
import json
import sys
from base64 import b64decode, b64encode
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from importlib import import_module
from pathlib import Path
from typing import IO, Any, Self

import numpy as np

from procc_annotator.errors import InputError, SaveError, UsageError
from procc_annotator.field.load import field_fingerprint
from procc_annotator.field.model import Field
from procc_annotator.formats.atomic import sibling_path
from procc_annotator.regular_file import open_regular
from procc_annotator.translation import TranslatableText
from procc_annotator.version import __version__

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


_FORMAT = "procc-unfinished-1"
_KEY_LENGTH = 64


def checkpoint_path(out: Path, command: str) -> Path:
    """Return where it lies: in the folder that is written, or next to the archive; hidden, so that
    no listing of cameras or annotations minds it."""
    if out.suffix.lower() == ".zip":
        return sibling_path(out, ".", f".{command}.unfinished")
    return out / f".{command}.unfinished"


class Checkpoint:
    """The results so far of one run; used as a context, which closes the file."""

    def __init__(self, path: Path, terms: Mapping[str, str], *, resume: bool) -> None:
        """Begin, or go on.

        Args:
            path: see `checkpoint_path`; it and its folder are made with the first results.
            terms: what the run was asked for, in words; another one's results are none of this
                one's.
            resume: whether to go on with what is there; else that goes.

        Raises:
            UsageError: what is there was begun with other terms.
            InputError: it cannot be read.
        """
        self.path = path
        self._terms = {**terms, "version": __version__, "numpy": np.__version__}
        self._places: dict[str, tuple[int, int]] = {}  # key -> where its results lie, bytes
        self._file: IO[bytes] | None = None
        self._end = self._read() if resume else 0

    def __contains__(self, key: str) -> bool:
        """Return whether a chunk was done before; what is added now does not count."""
        return key in self._places

    def __len__(self) -> int:
        return len(self._places)

    def results(self, key: str) -> list[Any] | None:
        """The results of a chunk that was done before; None if they cannot be read."""
        at, length = self._places[key]
        try:
            with open_regular(self.path) as file:
                file.seek(at)
                found = deserialize(file.read(length))
        except (OSError, SerializationError):
            return None
        return found if isinstance(found, list) else None

    def add(self, key: str, results: list[Any]) -> None:
        """Keep the results of a chunk, before anything is said of them.

        Raises:
            SaveError: the disk is full, say.
        """
        try:
            if self._file is None:
                self._file = self._begun()
            self._write(f"{key} {serialize(results)}".encode())
        except OSError as error:
            raise SaveError(f"{self.path}: cannot be written: {error.strerror or error}") from error

    def finish(self) -> None:
        """All is written: nothing is left to go on with.

        Raises:
            SaveError: the file cannot be removed.
        """
        self.__exit__()
        try:
            self.path.unlink(missing_ok=True)
        except OSError as error:
            raise SaveError(f"{self.path}: could not be removed: {error.strerror}") from error

    def _begun(self) -> IO[bytes]:
        """The file to add to; what a kill cut off is cut off, and a new one says what it is of."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self._file = self.path.open("r+b" if self._end else "w+b")
        self._file.seek(self._end)
        self._file.truncate()
        if not self._end:
            self._write(json.dumps({"format": _FORMAT, "terms": self._terms}).encode())
        return self._file

    def _write(self, line: bytes) -> None:
        assert self._file is not None
        self._file.write(line + b"\n")
        self._file.flush()

    def _read(self) -> int:
        """Find what is there; where the last whole line ends, 0 for nothing."""
        try:
            with open_regular(self.path) as file:
                head = file.readline()
                if not head.endswith(b"\n"):
                    return 0
                self._check(head)
                at = len(head)
                for line in file:
                    if not line.endswith(b"\n"):
                        break
                    key = line[:_KEY_LENGTH].decode("ascii", "replace")
                    begin = at + _KEY_LENGTH + 1
                    self._places[key] = (begin, len(line) - _KEY_LENGTH - 2)
                    at += len(line)
                return at
        except FileNotFoundError:
            return 0
        except OSError as error:
            raise InputError(self.path, f"cannot be read: {error.strerror or error}") from error

    def _check(self, head: bytes) -> None:
        try:
            found = json.loads(head)
            terms = found["terms"] if found["format"] == _FORMAT else None
        except (ValueError, KeyError, TypeError):
            terms = None
        if not isinstance(terms, dict):
            raise InputError(
                self.path,
                "is not what a run of this program leaves",
                advice="remove it, or begin anew with --overwrite",
            )
        for name in dict.fromkeys((*self._terms, *terms)):
            before, now = terms.get(name), self._terms.get(name)
            if before != now:
                raise UsageError(
                    f"{self.path.parent}: what is there was begun with another {name}"
                    f" ({before or 'none'}, now {now or 'none'}); ask for the same to go on, or"
                    " begin anew with --overwrite"
                )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *failure: object) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None


def hex_digest(*parts: object) -> str:
    """SHA-256, in hexadecimal, of bytes, and of the text of anything else; names of files may be no
    UTF-8."""
    digest = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else str(part).encode("utf-8", "surrogatepass")
        digest.update(len(data).to_bytes(8, "big"))
        digest.update(data)
    return digest.hexdigest()


def field_settings(field: Field) -> str:
    """A field as a term of a run: its words and a digest of all that fits and proposals look at,
    which is more than distinguishes fields."""
    looked_at = (
        field.cameras,
        [(e.name, e.appearance, e.line_width, e.inside) for e in field.elements],
        [(m.name, m.position, m.covariance, m.instant, m.surveyed) for m in field.landmarks],
        sorted(field.instants.items()),
        field.pixels,
    )
    return f"{field.described}, {hex_digest(field_fingerprint(field), repr(looked_at))[:12]}"


def stamp_of_file(path: Path) -> str:
    """Size and time of a file, as a text; empty for none."""
    try:
        found = path.stat()
    except OSError:  # what is not there is told where it is wanted
        return ""
    return f"{found.st_size} {found.st_mtime_ns}"
