"""The values of one field file: numbers, formulas, places, texts; every error names its place."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from procc_annotator.errors import FieldError
from procc_annotator.field.formula import FormulaError, Formulas, UnknownNameError
from procc_annotator.field.geometry import Vector
from procc_annotator.field.words import did_you_mean, printable_place, short_repr

# Far beyond any sports field. Samples lie centimetres apart: without a limit a slip of the pen (or
# a hostile file) would fill the memory with them.
MAX_COORDINATE_M = 1000.0
# Names stand in tables, on terminals and in tooltips.
_MAX_TEXT_LENGTH = 200


class FieldFileValues:
    """What formulas of one file may name, and the file's path for errors."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._names: dict[str, float] = {"pi": math.pi}
        self._coming: frozenset[str] = frozenset()

    def announce(self, names: Iterable[str]) -> None:
        """What will be defined, so that a formula that names it too early is told so."""
        self._coming = frozenset(names)
        self._formulas = Formulas(self._names)

    def define(self, place: str, name: str, value: float) -> None:
        """Make a name known to the formulas that follow; a second meaning would hide the first."""
        if not name.isidentifier():
            raise self.error(
                place, f"{short_repr(name)} cannot be used in formulas; expected a plain word"
            )
        if name in self._names:
            raise self.error(place, f"the name {short_repr(name)} is taken already")
        self._names[name] = value

    def vector(self, place: str, value: object) -> Vector:
        """Three formulas, metres from the field's centre."""
        if not isinstance(value, list) or len(value) != 3:
            raise self.error(place, "expected three formulas, [x, y, z]")
        x, y, z = (self._coordinate(f"{place}[{i}]", v) for i, v in enumerate(value))
        return (x, y, z)

    def _coordinate(self, place: str, value: object) -> float:
        number = self.number(place, value)
        if abs(number) > MAX_COORDINATE_M:
            raise self.error(
                place, f"expected at most {MAX_COORDINATE_M:g} m from the centre, found {number:g}"
            )
        return number

    def number(self, place: str, value: object) -> float:
        """A number or a formula; finite."""
        if isinstance(value, str):
            value = self._evaluated(place, value)
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise self.error(place, f"expected a number or a formula, found {short_repr(value)}")
        try:
            number = float(value)
        except OverflowError as error:
            raise self.error(place, "expected a finite number, found a far larger one") from error
        if not math.isfinite(number):
            raise self.error(place, f"expected a finite number, found {number!r}")
        return number + 0.0  # turns -0.0 into 0.0

    def _evaluated(self, place: str, formula: str) -> float:
        try:
            return self._formulas.value(formula)
        except FormulaError as error:
            raise self.error(place, f"{error}{self._hint(place, error)}") from error

    def _hint(self, place: str, error: FormulaError) -> str:
        if not isinstance(error, UnknownNameError):
            return ""
        if error.word not in self._coming:
            return did_you_mean(error.word, error.known)
        if place == f"formulas.{error.word}":
            return "; a formula cannot name itself"
        return "; it is defined further down: move it above"

    def text(self, place: str, value: object, *, may_be_empty: bool = False) -> str:
        """A text that says something."""
        if not isinstance(value, str) or not (value.strip() or (may_be_empty and not value)):
            raise self.error(place, f"expected text, found {short_repr(value)}")
        if not value.isprintable() or len(value) > _MAX_TEXT_LENGTH:
            raise self.error(
                place,
                f"expected a line of at most {_MAX_TEXT_LENGTH} letters, found {short_repr(value)}",
            )
        return value

    def flag(self, place: str, value: object) -> bool:
        """true or false."""
        if not isinstance(value, bool):
            raise self.error(place, f"expected true or false, found {short_repr(value)}")
        return value

    def table(self, place: str, value: object) -> dict[str, Any]:
        """A table."""
        if not isinstance(value, dict):
            raise self.error(place, f"expected a table [{place}]")
        return value

    def keys(
        self, place: str, table: Mapping[str, Any], allowed: set[str], required: set[str]
    ) -> None:
        """Refuse keys that are not allowed, and miss those that are required."""
        for key in table:
            if key not in allowed:
                hint = did_you_mean(key, allowed)
                raise self.error(f"{place}.{key}" if place else key, f"unknown key{hint}")
        for key in sorted(required - set(table)):
            raise self.error(place or "the file", f"the key {key!r} is missing")

    def error(self, place: str, problem: str) -> FieldError:
        """An error to raise."""
        return FieldError(self.path, problem, place=printable_place(place))
