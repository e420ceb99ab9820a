"""Read a parsed field file into a Field, and find the line an error is about."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Mapping
from itertools import pairwise
from pathlib import Path
from typing import Any

from procc_annotator.errors import FieldError
from procc_annotator.field.dimensions import Dimension, read_relations, violated_relation
from procc_annotator.field.element_reader import (
    GEOMETRY_KEYS,
    MARKING_KEYS,
    MarkingReader,
    read_geometry,
)
from procc_annotator.field.formulas import (
    MAX_COORDINATE_M,
    FieldFileValues,
    did_you_mean,
    short_repr,
)
from procc_annotator.field.model import (
    LINE_POSITIONS,
    MEASURED_LINE,
    CameraPlacement,
    Element,
    Field,
    NoPartnerError,
    Symmetry,
    find_symmetry,
)

_HEADER_PATTERN = re.compile(r"\s*\[{1,2}\s*([^\]]+?)\s*\]{1,2}\s*(#.*)?$")
_MAX_HEADER_LENGTH = 200  # looking at longer lines would take time by their square
_ELEMENT_PATTERN = re.compile(r"element ('(?:[^'\\]|\\.)*'|\"(?:[^\"\\]|\\.)*\"|\d+)")


def line_number_of(text: str, place: str) -> int | None:
    """The line of a place that an error of `field.file_reader` names, counted from 1.

    Args:
        place: as ``element 'Net'.start[2]``, ``dimensions.length``, ``symmetries[0]``.

    Returns:
        The line of the key, else of the element or table; None where the file gives no hint.
    """
    lines = text.splitlines()
    blocks = _table_blocks(lines)
    if found := _ELEMENT_PATTERN.match(place):
        return _line_in_element(
            lines, blocks, found[1], _key_in_line(place[found.end() :].lstrip("."))
        )
    table, dot, rest = place.partition(".")
    for header, start, end in blocks:
        if dot and header == table:
            return _line_of_key(lines, start, end, _key_in_line(rest))
        if (
            not dot
            and header == ""
            and (line := _line_of_key(lines, start, end, _key_in_line(table)))
        ):
            return line
        if not dot and header == table != "":
            return start + 1
    return None


def _table_blocks(lines: list[str]) -> list[tuple[str, int, int]]:
    """(header, first line, line behind the last) of each table, the keys before any as ""."""
    short = [(i, line) for i, line in enumerate(lines) if len(line) <= _MAX_HEADER_LENGTH]
    heads = [(i, found[1]) for i, line in short if (found := _HEADER_PATTERN.match(line))]
    marks = [(0, ""), *heads, (len(lines), "")]
    return [(header, start, end) for (start, header), (end, _) in pairwise(marks)]


def _line_in_element(
    lines: list[str], blocks: list[tuple[str, int, int]], wanted: str, key: str
) -> int | None:
    elements = [(start, end) for header, start, end in blocks if header == "elements"]
    if wanted.isdigit():
        chosen = elements[int(wanted) - 1 : int(wanted)]
    else:  # of two elements with one name the later one is wrong
        chosen = [
            (start, end)
            for start, end in elements
            if short_repr(_block_name(lines[start:end])) == wanted
        ][-1:]
    if not chosen:
        return None
    ((start, end),) = chosen
    return _line_of_key(lines, start, end, key) or start + 1


def _block_name(block: list[str]) -> object:
    for line in block:
        if re.match(r"\s*name\s*=", line):
            try:
                return tomllib.loads(line)["name"]
            except ValueError:  # a text of several lines
                return None
    return None


def _line_of_key(lines: list[str], start: int, end: int, key: str) -> int | None:
    if not key:
        return None
    pattern = re.compile(rf"\s*[\"']?{re.escape(key)}[\"']?\s*[=.]")
    return next((i + 1 for i in range(start, end) if pattern.match(lines[i])), None)


def _key_in_line(rest: str) -> str:
    return re.split(r"[.\[]", rest, maxsplit=1)[0]


_REQUIRED_KEYS = {"name", "title", "elements"}
_ALLOWED_KEYS = {
    *_REQUIRED_KEYS,
    "rules",
    "dimensions",
    "relations",
    "formulas",
    "paint",
    "bars",
    "symmetries",
    "cameras",
    "classes_without_geometry",
    "lines",
}
_ELEMENT_TEXTS = ("name", "title", "group", "colour", "shortcut")
_DIMENSION_NUMBERS = ("nominal", "minimum", "maximum")
_MAX_ELEMENTS = 200
_MAX_SYMMETRIES = 8
_OWN_FILE_ADVICE = "a field file of your own may allow it"
_NAME_PATTERN = re.compile(r"[\w-]+\Z")
_COLOUR_PATTERN = re.compile(r"#[0-9a-fA-F]{6}\Z")


def read_field(
    path: Path, data: dict[str, Any], chosen: Mapping[str, float], *, related: bool = True
) -> Field:
    """The field of a parsed description.

    Args:
        path: for errors, and to be read again.
        data: as the TOML reader gives it.
        chosen: metres, by name of a dimension: what to use instead of the nominal value.
        related: whether what is chosen must be as the file relates dimensions to one another.

    Raises:
        FieldError: names the file, the element and the key that is wrong.
    """
    return _Reader(path, data, chosen).read(related)


class _Reader:
    """One reading of one description."""

    def __init__(self, path: Path, data: dict[str, Any], chosen: Mapping[str, float]) -> None:
        self.data = data
        self.chosen = chosen
        self.values = FieldFileValues(path)

    def read(self, related: bool) -> Field:
        values, data = self.values, self.data
        values.keys("", data, _ALLOWED_KEYS, _REQUIRED_KEYS)
        dimensions = tuple(self._dimensions())
        for dimension in dimensions:
            values.define(f"dimensions.{dimension.name}", dimension.name, dimension.value)
        relations = read_relations(values, data.get("relations", []), dimensions)
        if related and (
            broken := violated_relation(relations, {d.name: d.value for d in dimensions})
        ):
            raise self._refused(broken, _OWN_FILE_ADVICE)
        formulas = self._table("formulas")
        values.announce(formulas)
        for name, formula in formulas.items():
            place = f"formulas.{name}"
            values.define(place, name, values.number(place, formula))
        elements = tuple(self._elements())
        return Field(
            name=self._name(),
            title=values.text("title", data["title"]),
            dimensions=dimensions,
            elements=elements,
            symmetries=tuple(self._symmetries(elements)),
            classes_without_geometry=self._classes_without_geometry(elements),
            cameras=self._cameras(),
            relations=relations,
            rules=values.text("rules", data.get("rules", ""), may_be_empty=True),
            source=values.path,
            usual_lines=self._lines(),
        )

    def _name(self) -> str:
        name = self.values.text("name", self.data["name"])
        if not _NAME_PATTERN.match(name):
            raise self._error(
                "name", f"expected letters, digits, _ and - alone, found {short_repr(name)}"
            )
        return name

    def _lines(self) -> str:
        """Return where elements are to lie; those read here lie where the file has them."""
        lines = self.data.get("lines", MEASURED_LINE)
        if lines not in LINE_POSITIONS:
            raise self._error(
                "lines", f"expected one of {', '.join(LINE_POSITIONS)}, found {short_repr(lines)}"
            )
        return str(lines)

    def _table(self, key: str) -> dict[str, Any]:
        return self.values.table(key, self.data.get(key, {}))

    def _classes_without_geometry(self, elements: tuple[Element, ...]) -> tuple[str, ...]:
        place = "classes_without_geometry"
        extra = self.data.get(place, [])
        if not isinstance(extra, list):
            raise self._error(place, "expected a list of class names")
        # Files are read with and without spaces around a name, so these must differ without them.
        seen = {e.name.strip() for e in elements}
        for i, name in enumerate(extra):
            if self.values.text(f"{place}[{i}]", name).strip() in seen:
                raise self._error(f"{place}[{i}]", f"{short_repr(name)} is used twice")
            seen.add(name.strip())
        return tuple(extra)

    def _dimensions(self) -> Iterable[Dimension]:
        values, table = self.values, self._table("dimensions")
        for name in self.chosen:
            if name not in table:
                hint = did_you_mean(name, table)
                known = "" if hint or not table else f"there are {', '.join(table)}"
                raise self._refused(f"no dimension {short_repr(name)}{hint}", known)
        for name, entry in table.items():
            place = f"dimensions.{name}"
            if not isinstance(entry, dict):
                own = f"; {name} stands above the first [table]" if name in _ALLOWED_KEYS else ""
                raise self._error(
                    place, f"expected a table with title, nominal, minimum, maximum{own}"
                )
            required = {"title", *_DIMENSION_NUMBERS}
            values.keys(place, entry, required, required)
            numbers = {k: values.number(f"{place}.{k}", entry[k]) for k in _DIMENSION_NUMBERS}
            if not 0 < numbers["minimum"] <= numbers["nominal"] <= numbers["maximum"]:
                raise self._error(place, "expected 0 < minimum <= nominal <= maximum")
            if numbers["maximum"] > 2 * MAX_COORDINATE_M:
                raise self._error(place, f"expected at most {2 * MAX_COORDINATE_M:g} m")
            value = self._value(name, numbers)
            title = values.text(f"{place}.title", entry["title"])
            yield Dimension(name, title, value, **numbers)

    def _value(self, name: str, numbers: Mapping[str, float]) -> float:
        """Return what is asked for, within what the rules allow, or the nominal value."""
        if name not in self.chosen:
            return numbers["nominal"]
        try:
            value = self.values.number(name, self.chosen[name])
        except FieldError as error:
            raise self._refused(f"{name}: {error.problem}", "") from error
        least, most = numbers["minimum"], numbers["maximum"]
        if least <= value <= most:
            return value
        if least == most:
            raise self._refused(
                f"{name} cannot be {value:g} m: the rules fix it at {least:g} m", _OWN_FILE_ADVICE
            )
        raise self._refused(
            f"{name}: {value:g} m is outside the range of the rules, {least:g} to {most:g} m",
            _OWN_FILE_ADVICE,
        )

    def _refused(self, problem: str, advice: str) -> FieldError:
        return FieldError(self.values.path, problem, advice=advice)

    def _elements(self) -> Iterable[Element]:
        entries = self.data["elements"]
        if isinstance(entries, dict):
            raise self._error(
                "elements", "expected [[elements]] with two brackets, before each element"
            )
        if not isinstance(entries, list) or not entries:
            raise self._error("elements", "expected at least one [[elements]] table")
        if len(entries) > _MAX_ELEMENTS:
            raise self._error("elements", f"expected at most {_MAX_ELEMENTS}, found {len(entries)}")
        paint = MarkingReader(self.values, self._table("paint"), self._table("bars"))
        seen: dict[str, dict[str, Element]] = {"name": {}, "shortcut": {}}
        for number, entry in enumerate(entries, 1):
            name = entry.get("name") if isinstance(entry, dict) else None
            named = isinstance(name, str) and name
            place = f"element {short_repr(name) if named else number}"
            if not isinstance(entry, dict):
                raise self._error(place, "expected a table")
            element = self._element(place, entry, paint)
            for key, used in (
                ("name", element.name.strip()),
                ("shortcut", element.shortcut.casefold()),  # keys have no case
            ):
                if used and (other := seen[key].get(used)) is not None:
                    by = f", by {short_repr(other.name)} too" if key == "shortcut" else ""
                    raise self._error(
                        f"{place}.{key}", f"{short_repr(entry[key])} is used twice{by}"
                    )
                seen[key][used] = element
            yield element

    def _element(self, place: str, entry: Mapping[str, Any], paint: MarkingReader) -> Element:
        kind = entry.get("kind")
        if not isinstance(kind, str) or kind not in GEOMETRY_KEYS:
            kinds = ", ".join(GEOMETRY_KEYS)
            raise self._error(f"{place}.kind", f"expected one of {kinds}, found {short_repr(kind)}")
        needed, more = GEOMETRY_KEYS[kind]
        required = {*_ELEMENT_TEXTS, "kind", *needed}
        self.values.keys(place, entry, {*required, *more, *MARKING_KEYS, "optional"}, required)
        texts = {
            k: self.values.text(f"{place}.{k}", entry[k], may_be_empty=k == "shortcut")
            for k in _ELEMENT_TEXTS
        }
        if not _COLOUR_PATTERN.match(texts["colour"]):
            found = short_repr(texts["colour"])
            raise self._error(f"{place}.colour", f"expected #rrggbb, found {found}")
        optional = self.values.flag(f"{place}.optional", entry.get("optional", False))
        geometry = read_geometry(self.values, place, kind, entry)
        own = paint.of(place, geometry, entry)
        name, title, group, colour, shortcut = (texts[k] for k in _ELEMENT_TEXTS)
        return Element(
            name,
            title,
            group,
            colour,
            shortcut,
            geometry,
            optional,
            line_width=own.line_width,
            inside=own.inside,
            appearance=own.appearance,
        )

    def _symmetries(self, elements: tuple[Element, ...]) -> Iterable[Symmetry]:
        turns = self.data.get("symmetries", [])
        if not isinstance(turns, list) or len(turns) > _MAX_SYMMETRIES:
            raise self._error(
                "symmetries", "expected a list of turns in degrees, as [180]; [] for none"
            )
        for i, turn in enumerate(turns):
            place = f"symmetries[{i}]"
            degrees = self.values.number(place, turn)
            if not 0 < degrees < 360 or turn in turns[:i]:
                raise self._error(
                    place, f"expected another turn between 0 and 360 degrees, found {degrees:g}"
                )
            try:
                yield find_symmetry(elements, degrees)
            except NoPartnerError as error:
                raise self._error(
                    place,
                    f"a turn by {degrees:g} degrees does not take the field to itself: {error}",
                ) from error

    def _cameras(self) -> CameraPlacement | None:
        if "cameras" not in self.data:
            return None
        table = self._table("cameras")
        self.values.keys(
            "cameras", table, {"distance", "height", "ceiling"}, {"distance", "height"}
        )
        ceiling = self.values.number("cameras.ceiling", table.get("ceiling", 0.0))
        if not 0 <= ceiling <= MAX_COORDINATE_M:
            raise self._error(
                "cameras.ceiling", f"expected 0 to {MAX_COORDINATE_M:g} m, found {ceiling:g}"
            )
        return CameraPlacement(self._three("distance"), self._three("height"), ceiling)

    def _three(self, key: str) -> tuple[float, float, float]:
        place, three = f"cameras.{key}", self.data["cameras"][key]
        if not isinstance(three, list) or len(three) != 3:
            raise self._error(place, "expected three lengths in metres, [least, usual, most]")
        least, usual, most = (self.values.number(f"{place}[{i}]", v) for i, v in enumerate(three))
        if not 0 <= least <= usual <= most <= MAX_COORDINATE_M:
            raise self._error(
                place, f"expected 0 <= least <= usual <= most <= {MAX_COORDINATE_M:g} m"
            )
        return least, usual, most

    def _error(self, place: str, problem: str) -> FieldError:
        return self.values.error(place, problem)
