"""Load a field by name or from a TOML file, change its dimensions, and get it per stadium and
frame.
"""

from __future__ import annotations

import hashlib
import re
import tomllib
from collections.abc import Mapping
from dataclasses import replace
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

from procc_annotator.errors import FieldError, InputError, UsageError
from procc_annotator.field.file_reader import line_number_of, read_field
from procc_annotator.field.formulas import did_you_mean
from procc_annotator.field.landmarks import field_at, with_landmarks
from procc_annotator.field.markings import with_centred_markings
from procc_annotator.field.model import LINE_POSITIONS, MIDDLE_LINE, Field, Stadiums
from procc_annotator.field.sampling import sample_official
from procc_annotator.regular_file import read_head
from procc_annotator.resources import resources_dir

# The TOML reader takes time by the square of a dotted key's length.
_MAX_FILE_BYTES = 256 * 1024
_MAX_KEY_DOTS = 60
_SINGLE_BRACKET_ELEMENTS = re.compile(r"^[ \t]*\[elements\]", re.MULTILINE)


def field_names() -> tuple[str, ...]:
    """Names of the fields the package ships, sorted."""
    return tuple(sorted(p.stem for p in (resources_dir() / "field").glob("*.toml")))


@cache
def field_titles() -> dict[str, str]:
    """Return what people call the fields the package ships, by name; in the order of their
    titles."""
    titles = {}
    for name in field_names():
        # What stands before the first table is read at once; the elements take far longer.
        head = read_toml_text(builtin_field_file(name)).split("\n[", 1)[0]
        titles[name] = str(tomllib.loads(head)["title"])
    return dict(sorted(titles.items(), key=lambda item: item[1].casefold()))


def builtin_field_file(name: str) -> Path:
    """Return where the package keeps a field's description."""
    return resources_dir() / "field" / f"{name}.toml"


def is_builtin_field(source: Path) -> bool:
    """Return whether a description is one of the package's, not a file of the user's own."""
    return source == builtin_field_file(source.stem)


@cache
def default_field_name() -> str:
    """The field that is meant where nothing is said: the sport this protocol began with."""
    return (resources_dir() / "field" / "default.txt").read_text(encoding="utf-8").strip()


def load_field(name_or_path: str | Path | None = None, **dimensions: float) -> Field:
    """Load a field by name (one of `field_names`) or from a file (with a ``.toml`` suffix).

    Args:
        name_or_path: a shipped field's name or a path; None for the default field.
        **dimensions: values in metres that replace the nominal ones (``length=100``).

    Raises:
        FieldError: names the file, the element and the key that is wrong.
    """
    if name_or_path is None:
        name_or_path = default_field_name()
    return _load(name_or_path, dimensions)


def load_field_of(text: str) -> Field:
    """The field that a text names, with its dimensions if any are given: ``soccer:length=105``."""
    name, dimensions = named_field(text)
    return load_field(name, **dimensions)


def named_field(text: str) -> tuple[str, dict[str, float]]:
    """Return the field, and dimensions in metres by name, of ``soccer:length=105``; UsageError for
    dimensions that are not written as ``name=metres``."""
    name, colon, given = text.rpartition(":")
    if not name or ("=" not in given and not _is_dimension(name, colon, given)):
        return text, {}
    dimensions: dict[str, float] = {}
    for part in given.split(","):
        key, _, value = (word.strip() for word in part.partition("="))
        if key in dimensions:
            raise UsageError(f"field {text}: {key} is given twice")
        try:
            dimensions[key] = float(value)
        except ValueError as error:
            wanted = _dimension_example(name, key)
            said = f"{part!r} is no dimension, write" if part else "write"
            raise UsageError(f"field {text}: {said} e.g. {wanted} (metres)") from error
    return name, dimensions


def _is_dimension(name: str, colon: str, given: str) -> bool:
    """Return whether what follows a colon can only be meant for a dimension: it belongs to no
    path."""
    return bool(colon) and not any(mark in given for mark in "/\\.") and len(name) > 1


def _dimension_example(name: str, key: str) -> str:
    try:
        field = load_field(name)
    except FieldError:
        return f"{name}:length=28"
    shown = field.dimension(key) or next(iter(field.dimensions), None)
    return f"{name}:{shown.name}={shown.value:g}" if shown is not None else name


def _load(
    name_or_path: str | Path,
    dimensions: Mapping[str, float],
    *,
    lines: str | None = None,
    related: bool = True,
) -> Field:
    """See `load_field`; without ``lines`` they are where the file says, and only ``related``
    dimensions must be as the rules relate them to one another."""
    path = Path(name_or_path)
    if path.suffix.lower() != ".toml":
        known = field_names()
        if str(name_or_path) not in known:
            raise FieldError(
                str(name_or_path) or "''",
                f"no such field{did_you_mean(str(name_or_path), known)}",
                advice=f"known: {', '.join(known)}; or the path of a .toml file",
            )
        path = builtin_field_file(str(name_or_path))
    chosen = tuple((name, type(value), value) for name, value in dimensions.items())
    return _field_from_text(path, read_toml_text(path), chosen, lines, related)


# A command, and a window even more so, asks for the same field many times; evaluating its formulas
# takes ten milliseconds or more.
@lru_cache(maxsize=32)
def _field_from_text(
    path: Path,
    text: str,
    chosen: tuple[tuple[str, type, float], ...],
    lines: str | None,
    related: bool,
) -> Field:
    """The field of a description's text; of each dimension its name, type and value."""
    try:
        data = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # tomllib's own error is a ValueError
        single = _SINGLE_BRACKET_ELEMENTS.search(text)
        advice = "elements begin with [[elements]], two brackets" if single else ""
        raise FieldError(path, f"is not valid TOML: {error}", advice=advice) from error
    dimensions = {name: value for name, _, value in chosen}
    try:
        data = _with_base(path, data)
        field = read_field(path, data, dimensions, related=related)
        field = _with_distinct_name(field, path, dimensions, related)
        middle = (field.usual_lines if lines is None else lines) == MIDDLE_LINE
        return with_centred_markings(field) if middle else field
    except FieldError as error:
        if not error.place and is_builtin_field(path):  # nobody is to look for a mistake in there
            raise FieldError(path.stem, error.problem, advice=error.advice) from error
        if (line := line_number_of(text, error.place)) is None:
            raise
        place = f"line {line}: {error.place}"
        raise FieldError(path, error.problem, place=place, advice=error.advice) from error


def _with_base(path: Path, data: dict[str, Any]) -> dict[str, Any]:
    """Add to a description what it leaves out of the shipped field that it is ``like``: keys of a
    table and of an element of the same name; elements of its own come last."""
    if "like" not in data:
        return data
    name = data["like"]
    if name not in (known := field_names()):
        problem = f"no such field{did_you_mean(str(name), known)}"
        raise FieldError(path, problem, place="like", advice=f"known: {', '.join(known)}")
    file = builtin_field_file(name)
    base = _with_base(file, tomllib.loads(read_toml_text(file)))
    found = base | {key: value for key, value in data.items() if key != "like"}
    for key, table in base.items():
        if isinstance(table, dict) and isinstance(data.get(key), dict):
            found[key] = table | data[key]
    own, shared = data.get("elements", []), base["elements"]
    if isinstance(own, list) and all(isinstance(one, dict) for one in own):  # else it is refused
        names = [element["name"] for element in shared]
        found["elements"] = [
            one | next((o for o in own if o.get("name") == one["name"]), {}) for one in shared
        ]
        found["elements"] += [one for one in own if one.get("name") not in names]
    return found


def place_in_file(field: Field, place: str) -> str:
    """Return where something in the description of a field, as it was loaded, stands, as errors
    name it: file, line and place; see `field.file_reader` and `field.validation`."""
    if field.source is None or is_builtin_field(field.source):
        return f"{field.name}: {place}"
    line = line_number_of(read_toml_text(field.source), place)
    return f"{field.source}: {place}" if line is None else f"{field.source}: line {line}: {place}"


def _with_distinct_name(
    field: Field, path: Path, dimensions: Mapping[str, float], related: bool
) -> Field:
    """Figures on a field of one's own must not pass for those on the shipped one of its name."""
    if is_builtin_field(path) or field.name not in field_names():
        return field
    try:
        same = field == _load(field.name, dimensions, related=related)
    except FieldError:  # the shipped one has no such dimensions
        same = False
    return field if same else replace(field, own_file=path.name)


def with_dimensions(
    field: Field, dimensions: Mapping[str, float], *, related: bool = True
) -> Field:
    """The same field with other dimensions; those that are not named are nominal.

    Landmarks and stadiums stay as they are, lines in the middle of their paint or where they are
    measured.

    Args:
        dimensions: metres, by name.
        related: whether they must be as the rules relate them to one another; a search may pass
            through others.

    Raises:
        FieldError: no such dimension, a value outside the range of the rules, values that the rules
            do not allow together, or the field's description cannot be read any more.
    """
    if field.source is None:
        raise FieldError(field.name, "was not read from a file: its dimensions cannot be changed")
    sized = _load(field.source, dimensions, lines=field.lines, related=related)
    return _with_dataset_additions(sized, field)


def with_lines(field: Field, lines: str) -> Field:
    """The same field with its lines in the middle of their paint, or where the rules measure them,
    by one of `LINES`; dimensions and landmarks stay.

    Raises:
        FieldError: no such choice, or the field's description cannot be read any more.
    """
    if lines not in LINE_POSITIONS:
        raise FieldError(
            field.name, f"lines: expected one of {', '.join(LINE_POSITIONS)}, found {lines!r}"
        )
    if lines == field.lines:
        return field
    if field.source is None:
        if lines == MIDDLE_LINE:
            return with_centred_markings(field)
        raise FieldError(field.name, "was not read from a file: its lines cannot be put back")
    own = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    found = _load(field.source, own, lines=lines, related=False)
    return _with_dataset_additions(found, field)


def _with_dataset_additions(loaded: Field, of: Field) -> Field:
    found = with_landmarks(loaded, of.landmarks, of.instant, of.instants)
    if of.stadiums is None and of.pixels is None:
        return found
    return replace(found, stadiums=of.stadiums, pixels=of.pixels)


def read_toml_text(path: Path, error: type[InputError] = FieldError) -> str:
    """The text of a TOML file that is small enough to be parsed at once; ``error`` if it cannot be
    read, is too large, no UTF-8, or has a key of too many parts."""
    try:
        data = read_head(path, _MAX_FILE_BYTES + 1)
        if len(data) > _MAX_FILE_BYTES:
            size = _MAX_FILE_BYTES // 1024
            raise error(path, f"is larger than {size} kB", advice="is it this file?")
        text = data.decode("utf-8-sig")  # some editors put a mark in front
    except FileNotFoundError as problem:
        raise error(path, "no such file") from problem
    except OSError as problem:
        raise error(path, f"cannot be read: {problem.strerror or problem}") from problem
    except ValueError as problem:  # not UTF-8, or no possible path
        raise error(path, f"cannot be read as UTF-8 text: {problem}") from problem
    for number, line in enumerate(text.splitlines(), 1):
        if line.count(".") > _MAX_KEY_DOTS:
            what = f"has more than {_MAX_KEY_DOTS} dots in a line"
            raise error(path, what, place=f"line {number}")
    return text


def with_stadiums(field: Field, stadiums: Stadiums | None) -> Field:
    """The field with stadiums that have dimensions it allows, in place of its former ones;
    `FieldError` if a stadium's dimensions are none of this field."""
    if stadiums is None or not stadiums.dimensions:
        return field if field.stadiums is None else replace(field, stadiums=None)
    sized = replace(field, stadiums=stadiums)
    for stadium in stadiums.dimensions:
        field_for_stadium(sized, stadium)
    return sized


def field_for_stadium(field: Field, stadium: str | None) -> Field:
    """The field with a stadium's dimensions; those that it does not name are the field's own.
    Itself for no stadium of its own. `FieldError` if the dimensions are none of this field."""
    if field.stadiums is None or stadium is None or stadium not in field.stadiums.dimensions:
        return field
    known = field.of_stadiums.get(stadium)
    if known is None:
        own = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
        known = with_dimensions(field, {**own, **field.stadiums.dimensions[stadium]})
        known = field.of_stadiums[stadium] = replace(known, stadiums=None)
    return known


def stadium_of(field: Field, frame: str) -> str | None:
    """The stadium that a frame was taken in, where its dimensions are known."""
    return None if field.stadiums is None else field.stadiums.frames.get(frame)


def field_for_frame(field: Field, frame: str) -> Field:
    """The field as it is in a frame: with the dimensions of its stadium, and with its landmarks
    where they are then; itself where a frame has nothing of its own."""
    own = field_for_stadium(field, stadium_of(field, frame))
    return field_at(own, field.instants.get(frame)) if field.instants else own


def field_fingerprint(field: Field) -> str:
    """SHA-256, in hexadecimal, of the elements, their places to a nanometre, and the turns that
    take the field to itself; the same of each stadium, and which frames are of it."""
    samples = sample_official(field)
    digest = hashlib.sha256()
    for row, element in enumerate(field.elements):
        digest.update(repr((element.name, element.on_ground, element.optional)).encode())
        digest.update((samples.of(row).round(9) + 0.0).tobytes())
    for turn in field.symmetries:
        digest.update(repr(turn.turn_rad).encode())
    if field.stadiums is not None:
        digest.update(repr(sorted(field.stadiums.frames.items())).encode())
        for stadium in sorted(field.stadiums.dimensions):
            digest.update(field_fingerprint(field_for_stadium(field, stadium)).encode())
    return digest.hexdigest()
