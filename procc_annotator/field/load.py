"""Read a field description (TOML) into a `Field`; every formula is evaluated, every name checked.

A description holds ``name``, ``title``, ``source``, ``[dimensions]`` (metres, with the rules'
range), ``[formulas]`` (shared expressions), ``[mirror]`` (the half-turn symmetry) and
``[[elements]]``.
"""

from __future__ import annotations

import difflib
import math
import os
import re
import stat
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from procc_annotator.errors import FieldError
from procc_annotator.field.formula import FormulaError, UnknownWordError, evaluate
from procc_annotator.field.model import (
    Arc,
    Circle,
    Dimension,
    Element,
    Field,
    Geometry,
    Line,
    Vector,
)
from procc_annotator.resources import resources_dir

_TOP_KEYS = {"name", "title", "source", "classes_without_geometry"}
_TOP_TABLES = {"dimensions", "formulas", "mirror", "elements"}
_ELEMENT_TEXTS = ("name", "title", "group", "colour", "shortcut")
_GEOMETRY_KEYS = {
    "line": ("start", "end"),
    "arc": ("centre", "radius", "start", "end"),
    "circle": ("centre", "radius"),
}
_DIMENSION_NUMBERS = ("nominal", "minimum", "maximum")
_SAME_PLACE_M = 1e-6
# Far beyond any sports field. Samples lie centimetres apart: without these limits a slip of the pen
# (or a hostile file) would fill the memory with them.
_FARTHEST_M = 1000.0
_SMALLEST_RADIUS_M = 0.01
_MOST_ELEMENTS = 200
# The TOML reader takes time by the square of a dotted key's length.
_LARGEST_FILE = 256 * 1024
_MOST_DOTS = 60
_LONGEST_WORD = 60
_COLOUR = re.compile(r"#[0-9a-fA-F]{6}\Z")


def field_names() -> tuple[str, ...]:
    """Names of the fields the package ships, sorted."""
    return tuple(sorted(p.stem for p in (resources_dir() / "field").glob("*.toml")))


def load_field(name_or_path: str | Path = "soccer", **dimensions: float) -> Field:
    """Load a field by name (``soccer``) or from a file (anything with a ``.toml`` suffix).

    Args:
        name_or_path: a shipped field's name or a path.
        **dimensions: values in metres that replace the nominal ones (``length=100``).

    Raises:
        FieldError: names the file, the element and the key that is wrong.
    """
    path = Path(name_or_path)
    if path.suffix.lower() != ".toml":
        known = field_names()
        if str(name_or_path) not in known:
            raise FieldError(
                str(name_or_path) or "''",
                f"no such field{_did_you_mean(str(name_or_path), known)}",
                advice=f"known: {', '.join(known)}; or the path of a .toml file",
            )
        path = resources_dir() / "field" / f"{name_or_path}.toml"
    try:
        data = tomllib.loads(_read_text(path))
    except (ValueError, RecursionError) as error:  # tomllib's own error is a ValueError
        raise FieldError(path, f"is not valid TOML: {error}") from error
    return _Reader(path, data, dimensions).read()


def resized(field: Field, dimensions: Mapping[str, float]) -> Field:
    """The same field with other dimensions; those that are not named are nominal.

    Args:
        field: as it was loaded.
        dimensions: metres, by name.

    Raises:
        FieldError: no such dimension, a value outside the range of the rules, or the field's
            description cannot be read any more.
    """
    if field.source is None:
        raise FieldError(field.name, "was not read from a file: its dimensions cannot be changed")
    return load_field(field.source, **dimensions)


def _read_text(path: Path) -> str:
    try:
        status = os.stat(path)
        if not stat.S_ISREG(status.st_mode):  # opening a pipe would wait for ever
            kind = "a folder" if stat.S_ISDIR(status.st_mode) else "not a regular file"
            raise FieldError(path, f"expected a field description, this is {kind}")
        if status.st_size > _LARGEST_FILE:
            raise FieldError(
                path,
                f"is larger than {_LARGEST_FILE // 1024} kB, expected a field description",
                advice="is it this file?",
            )
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError as error:
        raise FieldError(path, "no such file") from error
    except OSError as error:
        raise FieldError(path, f"cannot be read: {error.strerror or error}") from error
    except ValueError as error:  # not UTF-8, or no possible path
        raise FieldError(path, f"cannot be read as UTF-8 text: {error}") from error
    for number, line in enumerate(text.splitlines(), 1):
        if line.count(".") > _MOST_DOTS:
            raise FieldError(
                path, f"has more than {_MOST_DOTS} dots in a line", place=f"line {number}"
            )
    return text


class _Reader:
    """One reading of one description; keeps the path so that every error can name it."""

    def __init__(self, path: Path, data: dict[str, Any], dimensions: Mapping[str, float]) -> None:
        self.path = path
        self.data = data
        self.chosen = dimensions
        self.names: dict[str, float] = {"pi": math.pi}

    def read(self) -> Field:
        self._keys("", self.data, _TOP_KEYS | _TOP_TABLES, {"name", "title", *_TOP_TABLES})
        dimensions = tuple(self._dimensions())
        for dimension in dimensions:
            self._define(f"dimensions.{dimension.name}", dimension.name, dimension.value)
        for name, formula in self._table("formulas").items():
            place = f"formulas.{name}"
            self._define(place, name, self._number(place, formula))
        elements = tuple(self._elements())
        self._text("source", self.data.get("source", ""), may_be_empty=True)
        return Field(
            name=self._text("name", self.data["name"]),
            title=self._text("title", self.data["title"]),
            dimensions=dimensions,
            elements=elements,
            mirror=self._mirror(elements),
            classes_without_geometry=self._classes_without_geometry(elements),
            source=self.path,
        )

    def _define(self, place: str, name: str, value: float) -> None:
        """Make a name known to the formulas that follow; a second meaning would hide the first."""
        if not name.isidentifier():
            raise self._error(
                place, f"{_shown(name)} cannot be used in formulas; expected a plain word"
            )
        if name in self.names:
            raise self._error(place, f"the name {_shown(name)} is taken already")
        self.names[name] = value

    def _classes_without_geometry(self, elements: tuple[Element, ...]) -> tuple[str, ...]:
        place = "classes_without_geometry"
        extra = self.data.get(place, [])
        if not isinstance(extra, list):
            raise self._error(place, "expected a list of class names")
        # Files are read with and without spaces around a name, so these must differ without them.
        seen = {e.name.strip() for e in elements}
        for i, name in enumerate(extra):
            if self._text(f"{place}[{i}]", name).strip() in seen:
                raise self._error(f"{place}[{i}]", f"{_shown(name)} is used twice")
            seen.add(name.strip())
        return tuple(extra)

    def _dimensions(self) -> Iterable[Dimension]:
        table = self._table("dimensions")
        for name in self.chosen:
            if name not in table:
                hint = _did_you_mean(name, table)
                raise self._error("dimensions", f"no dimension {_shown(name)}{hint}")
        for name, entry in table.items():
            place = f"dimensions.{name}"
            if not isinstance(entry, dict):
                raise self._error(place, "expected a table with title, nominal, minimum, maximum")
            required = {"title", *_DIMENSION_NUMBERS}
            self._keys(place, entry, required, required)
            numbers = {k: self._number(f"{place}.{k}", entry[k]) for k in _DIMENSION_NUMBERS}
            if not 0 < numbers["minimum"] <= numbers["nominal"] <= numbers["maximum"]:
                raise self._error(place, "expected 0 < minimum <= nominal <= maximum")
            if numbers["maximum"] > 2 * _FARTHEST_M:
                raise self._error(place, f"expected at most {2 * _FARTHEST_M:g} m")
            value = self._number(place, self.chosen.get(name, numbers["nominal"]))
            if not numbers["minimum"] <= value <= numbers["maximum"]:
                raise self._error(
                    place,
                    f"{value:g} m is outside the range of the rules,"
                    f" {numbers['minimum']:g} to {numbers['maximum']:g} m",
                )
            yield Dimension(name, self._text(f"{place}.title", entry["title"]), value, **numbers)

    def _elements(self) -> Iterable[Element]:
        entries = self.data["elements"]
        if not isinstance(entries, list) or not entries:
            raise self._error("elements", "expected at least one [[elements]] table")
        if len(entries) > _MOST_ELEMENTS:
            raise self._error(
                "elements", f"expected at most {_MOST_ELEMENTS}, found {len(entries)}"
            )
        seen: dict[str, set[str]] = {"name": set(), "shortcut": set()}
        for number, entry in enumerate(entries, 1):
            name = entry.get("name") if isinstance(entry, dict) else None
            named = isinstance(name, str) and name
            place = f"element {_shown(name) if named else number}"
            if not isinstance(entry, dict):
                raise self._error(place, "expected a table")
            kind = entry.get("kind")
            if not isinstance(kind, str) or kind not in _GEOMETRY_KEYS:
                kinds = ", ".join(_GEOMETRY_KEYS)
                raise self._error(f"{place}.kind", f"expected one of {kinds}, found {_shown(kind)}")
            required = {*_ELEMENT_TEXTS, "kind", *_GEOMETRY_KEYS[kind]}
            self._keys(place, entry, required, required)
            texts = {
                k: self._text(f"{place}.{k}", entry[k], may_be_empty=k == "shortcut")
                for k in _ELEMENT_TEXTS
            }
            if not _COLOUR.match(texts["colour"]):
                found = _shown(texts["colour"])
                raise self._error(f"{place}.colour", f"expected #rrggbb, found {found}")
            for key, used in (
                ("name", texts["name"].strip()),
                ("shortcut", texts["shortcut"].casefold()),  # keys have no case
            ):
                if used and used in seen[key]:
                    raise self._error(f"{place}.{key}", f"{_shown(texts[key])} is used twice")
                seen[key].add(used)
            yield Element(**texts, geometry=self._geometry(place, kind, entry))

    def _geometry(self, place: str, kind: str, entry: Mapping[str, Any]) -> Geometry:
        if kind == "line":
            line = Line(
                self._vector(f"{place}.start", entry["start"]),
                self._vector(f"{place}.end", entry["end"]),
            )
            if math.dist(line.start, line.end) < _SAME_PLACE_M:
                raise self._error(f"{place}.end", "a line needs two different ends")
            return line
        centre = self._vector(f"{place}.centre", entry["centre"])
        radius = self._number(f"{place}.radius", entry["radius"])
        if radius <= 0:
            raise self._error(f"{place}.radius", f"expected a positive radius, found {radius:g}")
        if not _SMALLEST_RADIUS_M <= radius <= _FARTHEST_M:
            raise self._error(
                f"{place}.radius",
                f"expected {_SMALLEST_RADIUS_M:g} to {_FARTHEST_M:g} m, found {radius:g}",
            )
        if kind == "circle":
            return Circle(centre, radius)
        start = self._number(f"{place}.start", entry["start"])
        end = self._number(f"{place}.end", entry["end"])
        if not start < end < start + 2 * math.pi:
            raise self._error(f"{place}.end", "an arc runs from a smaller to a larger angle")
        return Arc(centre, radius, start, end)

    def _mirror(self, elements: tuple[Element, ...]) -> dict[str, str]:
        geometries = {e.name: e.geometry for e in elements}
        mirror: dict[str, str] = {}
        for name, partner in self._table("mirror").items():
            for class_name in (name, partner):
                if not isinstance(class_name, str) or class_name not in geometries:
                    hint = _did_you_mean(class_name, geometries)
                    raise self._error(
                        f"mirror.{_shown(name)}", f"no element {_shown(class_name)}{hint}"
                    )
            for a, b in ((name, partner), (partner, name)):
                if mirror.setdefault(a, b) != b:
                    raise self._error(
                        f"mirror.{_shown(name)}",
                        f"{_shown(a)} already pairs with {_shown(mirror[a])}",
                    )
        for name in geometries:
            if name not in mirror:
                raise self._error(f"element {_shown(name)}", "has no partner in [mirror]")
            if not _is_turned(geometries[name], geometries[mirror[name]]):
                raise self._error(
                    f"mirror.{_shown(name)}",
                    f"half a turn of the field does not take it to {_shown(mirror[name])}",
                )
        return {name: mirror[name] for name in geometries}

    def _vector(self, place: str, value: object) -> Vector:
        if not isinstance(value, list) or len(value) != 3:
            raise self._error(place, "expected three formulas, [x, y, z]")
        x, y, z = (self._coordinate(f"{place}[{i}]", v) for i, v in enumerate(value))
        return (x, y, z)

    def _coordinate(self, place: str, value: object) -> float:
        number = self._number(place, value)
        if abs(number) > _FARTHEST_M:
            raise self._error(
                place, f"expected at most {_FARTHEST_M:g} m from the centre, found {number:g}"
            )
        return number

    def _number(self, place: str, value: object) -> float:
        if isinstance(value, str):
            value = self._evaluated(place, value)
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self._error(place, f"expected a number or a formula, found {_shown(value)}")
        try:
            number = float(value)
        except OverflowError as error:
            raise self._error(place, "expected a finite number, found a far larger one") from error
        if not math.isfinite(number):
            raise self._error(place, f"expected a finite number, found {number!r}")
        return number + 0.0  # turns -0.0 into 0.0

    def _evaluated(self, place: str, formula: str) -> float:
        try:
            return evaluate(formula, self.names)
        except FormulaError as error:
            hint = ""
            if isinstance(error, UnknownWordError):
                hint = _did_you_mean(error.word, error.known)
            raise self._error(place, f"{error}{hint}") from error

    def _text(self, place: str, value: object, *, may_be_empty: bool = False) -> str:
        if not isinstance(value, str) or not (value.strip() or (may_be_empty and not value)):
            raise self._error(place, f"expected text, found {_shown(value)}")
        return value

    def _table(self, key: str) -> dict[str, Any]:
        table = self.data[key]
        if not isinstance(table, dict):
            raise self._error(key, f"expected a table [{key}]")
        return table

    def _keys(
        self, place: str, table: Mapping[str, Any], allowed: set[str], required: set[str]
    ) -> None:
        for key in table:
            if key not in allowed:
                hint = _did_you_mean(key, allowed)
                raise self._error(f"{place}.{key}" if place else key, f"unknown key{hint}")
        for key in sorted(required - set(table)):
            raise self._error(place or "the file", f"the key {key!r} is missing")

    def _error(self, place: str, problem: str) -> FieldError:
        return FieldError(self.path, problem, place=_printable(place))


def _is_turned(geometry: Geometry, partner: Geometry) -> bool:
    """Whether half a turn about the vertical takes one geometry to the other, in any direction."""
    if isinstance(geometry, Line) and isinstance(partner, Line):
        ends = (_turned(geometry.start), _turned(geometry.end))
        there = (partner.start, partner.end)
        return any(
            math.dist(ends[0], a) < _SAME_PLACE_M and math.dist(ends[1], b) < _SAME_PLACE_M
            for a, b in (there, there[::-1])
        )
    if isinstance(geometry, Line) or isinstance(partner, Line):
        return False
    same = (
        math.dist(_turned(geometry.centre), partner.centre) < _SAME_PLACE_M
        and abs(geometry.radius - partner.radius) < _SAME_PLACE_M
    )
    if isinstance(geometry, Arc) and isinstance(partner, Arc):
        span = geometry.end_rad - geometry.start_rad
        ahead = partner.start_rad - (geometry.start_rad + math.pi)
        return (
            same
            and abs(partner.end_rad - partner.start_rad - span) < _SAME_PLACE_M
            and abs(math.remainder(ahead, 2 * math.pi)) < _SAME_PLACE_M
        )
    return same and isinstance(geometry, Circle) and isinstance(partner, Circle)


def _turned(point: Vector) -> Vector:
    return (-point[0], -point[1], point[2])


def _did_you_mean(word: object, known: Iterable[str]) -> str:
    # Comparing takes time by the square of the length, and both sides may come from the file.
    if not isinstance(word, str) or len(word) > _LONGEST_WORD:
        return ""
    short = [name for name in known if len(name) <= _LONGEST_WORD]
    close = difflib.get_close_matches(word, short, n=1)
    return f"; did you mean {close[0]!r}?" if close else ""


def _shown(value: object) -> str:
    """A value of the file in an error message; never one that is itself too large to be shown."""
    if isinstance(value, dict | list):
        return "a table" if isinstance(value, dict) else "a list"
    if isinstance(value, int) and abs(value) >= 1 << 64:
        return "a far larger number"
    text = repr(value[: _LONGEST_WORD + 1] if isinstance(value, str) else value)
    return text if len(text) <= _LONGEST_WORD + 2 else f"{text[: _LONGEST_WORD - 3]}..."


def _printable(place: str) -> str:
    """Keys of a file may hold characters that a terminal would obey; and be of any length."""
    short = place if len(place) <= 3 * _LONGEST_WORD else f"{place[: 3 * _LONGEST_WORD]}..."
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in short)
