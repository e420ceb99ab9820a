"""Parse camera methods on the command line: ``PATH``, ``NAME=PATH``, ``NAME:FORMAT=PATH``."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace
from pathlib import Path

from procc_annotator.errors import UsageError, printable

_FORM = "PATH, NAME=PATH or NAME:FORMAT=PATH"
SET_PLACE = "{set}"  # stands for the name of a set in the path of a source


@dataclass(frozen=True, slots=True)
class SourceSpec:
    """A source of cameras as it was asked for.

    Attributes:
        name: what it is called in tables and files.
        format: the format of its files; ``auto`` unless named.
        path: folder, archive or file; may hold `SET_PLACE`.
    """

    name: str
    format: str
    path: Path

    def for_set(self, name: str) -> SourceSpec:
        """The source with a set's name in its path."""
        return replace(self, path=Path(str(self.path).replace(SET_PLACE, name)))


def parse_source(text: str, default_format: str = "auto") -> SourceSpec:
    """Read ``PATH``, ``NAME=PATH`` or ``NAME:FORMAT=PATH``.

    What stands before the first ``=`` is a name unless it looks like part of a path (``runs/a=1``,
    ``C:\\runs\\a=1``) or the whole text is something that exists.

    Args:
        default_format: for a source that does not name its own.

    Raises:
        UsageError: a part is empty, or a name that could not stand in a table.
    """
    name, equals, path = text.partition("=")
    if not equals or "/" in name or "\\" in name or _exists(text):
        return SourceSpec(name_of(_filled(text, text, _FORM)), default_format, Path(text))
    name, colon, fmt = name.partition(":")
    name = _checked_name(name, text, _FORM)
    fmt = _filled(fmt.strip(), text, _FORM) if colon else default_format
    return SourceSpec(name, fmt, Path(_filled(path, text, _FORM)))


def parse_sources(texts: Iterable[str], default_format: str = "auto") -> tuple[SourceSpec, ...]:
    """Read several sources, in the order given; UsageError as of `parse_source`, or for two of the
    same name."""
    sources = tuple(parse_source(text, default_format) for text in texts)
    require_distinct((source.name for source in sources), "sources of cameras")
    return sources


def parse_named(text: str, form: str) -> tuple[str, Path]:
    """Read ``NAME=PATH``; UsageError for something else than ``form``, which it names."""
    name, equals, path = text.partition("=")
    if not equals:
        raise UsageError(f"{text!r}: expected {form}")
    return _checked_name(name, text, form), Path(_filled(path, text, form))


def require_distinct(names: Iterable[str], what: str) -> None:
    """Raise UsageError if a name occurs twice: the results could not be distinguished."""
    twice = [name for name, count in Counter(names).items() if count > 1]
    if twice:
        raise UsageError(f"two {what} are called {twice[0]!r}: give each its own name, NAME=PATH")


def _checked_name(name: str, text: str, form: str) -> str:
    name = _filled(name.strip(), text, form)
    if not name.isprintable():
        raise UsageError(f"{name!r} cannot be a name: it holds characters that cannot be shown")
    return name


def _filled(part: str, text: str, form: str) -> str:
    if not part.strip():
        raise UsageError(f"{text!r}: expected {form}")
    return part


def _exists(text: str) -> bool:
    try:
        return Path(text).exists()
    except (OSError, ValueError):  # a name the system cannot even look for
        return False


def name_of(path: str) -> str:
    """Return what a source without a name is called: like its folder, or its file without the
    suffix.

    Where the path has a place for the set, that part of it names nothing.
    """
    parts = [part for part in Path(path).parts if SET_PLACE not in part] or [path]
    if SET_PLACE not in path:
        parts = list(Path(path).resolve().parts) if _exists(path) else parts
    last = Path(parts[-1])
    # A dot belongs to the name of a folder (``v1.2``) but ends that of a file (``a.zip``).
    return printable(last.name if Path(path).is_dir() or not last.stem else last.stem)
