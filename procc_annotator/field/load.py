"""Read a field description (TOML) into a `Field`; every formula is evaluated, every name checked.

A description holds ``name``, ``title``, ``source``, ``[dimensions]`` (metres, with the rules'
range), ``[formulas]`` (shared expressions), ``[mirror]`` (the half-turn symmetry) and
``[[elements]]``.
"""

from __future__ import annotations

import difflib
import math
import re
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import simpleeval

from procc_annotator.errors import FieldError
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
_FUNCTIONS = {
    name: getattr(math, name)
    for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan2", "radians", "hypot")
}
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
                str(name_or_path), f"no such field{_did_you_mean(str(name_or_path), known)}"
            )
        path = resources_dir() / "field" / f"{name_or_path}.toml"
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise FieldError(path, f"cannot be read as UTF-8 text: {error}") from error
    try:
        data = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise FieldError(path, f"is not valid TOML: {error}") from error
    return _Reader(path, data, dimensions).read()


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
        self.names |= {d.name: d.value for d in dimensions}
        for name, formula in self._table("formulas").items():
            self.names[name] = self._number(f"formulas.{name}", formula)
        elements = tuple(self._elements())
        extra = self.data.get("classes_without_geometry", [])
        if not isinstance(extra, list) or not all(isinstance(c, str) and c for c in extra):
            raise self._error("classes_without_geometry", "expected a list of class names")
        for name in extra:
            if name in {e.name for e in elements}:
                raise self._error("classes_without_geometry", f"{name!r} is an element as well")
        return Field(
            name=self._text("name", self.data["name"]),
            title=self._text("title", self.data["title"]),
            dimensions=dimensions,
            elements=elements,
            mirror=self._mirror([e.name for e in elements]),
            classes_without_geometry=tuple(extra),
        )

    def _dimensions(self) -> Iterable[Dimension]:
        table = self._table("dimensions")
        for name in self.chosen:
            if name not in table:
                raise self._error(
                    "dimensions", f"no dimension {name!r}{_did_you_mean(name, table)}"
                )
        for name, entry in table.items():
            place = f"dimensions.{name}"
            if not isinstance(entry, dict):
                raise self._error(place, "expected a table with title, nominal, minimum, maximum")
            required = {"title", *_DIMENSION_NUMBERS}
            self._keys(place, entry, required, required)
            numbers = {k: self._number(f"{place}.{k}", entry[k]) for k in _DIMENSION_NUMBERS}
            if not 0 < numbers["minimum"] <= numbers["nominal"] <= numbers["maximum"]:
                raise self._error(place, "expected 0 < minimum <= nominal <= maximum")
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
        seen: dict[str, set[str]] = {"name": set(), "shortcut": {""}}
        for number, entry in enumerate(entries, 1):
            name = entry.get("name") if isinstance(entry, dict) else None
            place = f"element {name!r}" if isinstance(name, str) and name else f"element {number}"
            if not isinstance(entry, dict):
                raise self._error(place, "expected a table")
            kind = entry.get("kind")
            if kind not in _GEOMETRY_KEYS:
                raise self._error(
                    f"{place}.kind", f"expected one of {', '.join(_GEOMETRY_KEYS)}, found {kind!r}"
                )
            required = {*_ELEMENT_TEXTS, "kind", *_GEOMETRY_KEYS[kind]}
            self._keys(place, entry, required, required)
            texts = {
                k: self._text(f"{place}.{k}", entry[k], may_be_empty=k == "shortcut")
                for k in _ELEMENT_TEXTS
            }
            if not _COLOUR.match(texts["colour"]):
                raise self._error(f"{place}.colour", f"expected #rrggbb, found {texts['colour']!r}")
            for key in seen:
                if texts[key] and texts[key].strip() in seen[key]:
                    raise self._error(f"{place}.{key}", f"{texts[key]!r} is used twice")
                seen[key].add(texts[key].strip())
            yield Element(**texts, geometry=self._geometry(place, kind, entry))

    def _geometry(self, place: str, kind: str, entry: Mapping[str, Any]) -> Geometry:
        if kind == "line":
            line = Line(
                self._vector(f"{place}.start", entry["start"]),
                self._vector(f"{place}.end", entry["end"]),
            )
            if line.start == line.end:
                raise self._error(f"{place}.end", "a line needs two different ends")
            return line
        centre = self._vector(f"{place}.centre", entry["centre"])
        radius = self._number(f"{place}.radius", entry["radius"])
        if radius <= 0:
            raise self._error(f"{place}.radius", f"expected a positive radius, found {radius:g}")
        if kind == "circle":
            return Circle(centre, radius)
        start = self._number(f"{place}.start", entry["start"])
        end = self._number(f"{place}.end", entry["end"])
        if not start < end < start + 2 * math.pi:
            raise self._error(f"{place}.end", "an arc runs from a smaller to a larger angle")
        return Arc(centre, radius, start, end)

    def _mirror(self, names: list[str]) -> dict[str, str]:
        mirror: dict[str, str] = {}
        for name, partner in self._table("mirror").items():
            for class_name in (name, partner):
                if class_name not in names:
                    hint = _did_you_mean(str(class_name), names)
                    raise self._error(f"mirror.{name!r}", f"no element {class_name!r}{hint}")
            for a, b in ((name, partner), (partner, name)):
                if mirror.setdefault(a, b) != b:
                    raise self._error(f"mirror.{name!r}", f"{a!r} already pairs with {mirror[a]!r}")
        for name in names:
            if name not in mirror:
                raise self._error(f"element {name!r}", "has no partner in [mirror]")
        return {name: mirror[name] for name in names}

    def _vector(self, place: str, value: object) -> Vector:
        if not isinstance(value, list) or len(value) != 3:
            raise self._error(place, "expected three formulas, [x, y, z]")
        x, y, z = (self._number(f"{place}[{i}]", v) for i, v in enumerate(value))
        return (x, y, z)

    def _number(self, place: str, value: object) -> float:
        if isinstance(value, str):
            try:
                value = simpleeval.simple_eval(value, names=self.names, functions=_FUNCTIONS)
            except (
                simpleeval.InvalidExpression,
                SyntaxError,
                ArithmeticError,
                ValueError,
                TypeError,
            ) as error:
                hint = ""
                if isinstance(error, simpleeval.NameNotDefined):
                    hint = _did_you_mean(error.name, self.names)
                raise self._error(place, f"bad formula {value!r}: {error}{hint}") from error
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self._error(place, f"expected a number or a formula, found {value!r}")
        if not math.isfinite(value):
            raise self._error(place, f"expected a finite number, found {value!r}")
        return float(value) + 0.0  # turns -0.0 into 0.0

    def _text(self, place: str, value: object, *, may_be_empty: bool = False) -> str:
        if not isinstance(value, str) or not (value or may_be_empty):
            raise self._error(place, f"expected text, found {value!r}")
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
        return FieldError(self.path, problem, place=place)


def _did_you_mean(word: str, known: Iterable[str]) -> str:
    close = difflib.get_close_matches(word, list(known), n=1)
    return f"; did you mean {close[0]!r}?" if close else ""
