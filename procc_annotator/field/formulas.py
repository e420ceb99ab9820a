"""Formulas and checked values of field files; every error names its place in the file."""

from __future__ import annotations

import ast
import difflib
import math
import operator
import threading
import warnings
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

import simpleeval

from procc_annotator.errors import FieldError
from procc_annotator.field.geometry import Vector

_MAX_FORMULA_LENGTH = 200
# Fields are read in several threads. Python 3.11 keeps count of one tree at a time only while it
# makes syntax trees, and the filters of warnings are common to all threads.
_PARSER_LOCK = threading.Lock()
FUNCTIONS: dict[str, Callable[..., float]] = {
    name: getattr(math, name)
    for name in ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan2", "radians", "hypot")
}


def _as_float_operator(function: Callable[..., object]) -> Callable[..., object]:
    return lambda *values: function(*map(float, values))


_OPERATORS = {
    ast.Add: _as_float_operator(operator.add),
    ast.Sub: _as_float_operator(operator.sub),
    ast.Mult: _as_float_operator(operator.mul),
    ast.Div: _as_float_operator(operator.truediv),
    ast.FloorDiv: _as_float_operator(operator.floordiv),
    ast.Mod: _as_float_operator(operator.mod),
    ast.Pow: _as_float_operator(operator.pow),
    ast.UAdd: _as_float_operator(operator.pos),
    ast.USub: _as_float_operator(operator.neg),
}
_ALLOWED_NODES = (ast.BinOp, ast.UnaryOp, ast.Call, ast.Name, ast.Load, ast.Constant, *_OPERATORS)


class FormulaError(ValueError):
    """A formula that gives no number; the text says why."""


class UnknownNameError(FormulaError):
    """A formula names something that does not exist; ``known`` are the words it may name."""

    def __init__(self, problem: str, word: str, known: tuple[str, ...]) -> None:
        super().__init__(problem)
        self.word = word
        self.known = known


class Formulas:
    """Formulas that know the same names."""

    def __init__(self, names: Mapping[str, float]) -> None:
        """``names`` may grow: what a name stands for is looked up when a formula has it."""
        self._names = names
        # Making one takes longer than most formulas do, and a description has hundreds of those.
        self._evaluator = simpleeval.SimpleEval(
            names=names, functions=FUNCTIONS, operators=dict(_OPERATORS)
        )

    def value(self, formula: str) -> float:
        """The value of a formula, which may be infinite or not a number.

        Args:
            formula: numbers, names, ``+ - * / // % **``, brackets, and calls of `FUNCTIONS`.

        Raises:
            FormulaError: the formula is too long, no such expression, or has no real value.
        """
        if len(formula) > _MAX_FORMULA_LENGTH:
            raise FormulaError(
                f"bad formula: longer than {_MAX_FORMULA_LENGTH} characters; use [formulas]"
            )
        parsed = _parse_formula(formula)
        if isinstance(parsed, ast.Name) and parsed.id in self._names:
            return self._names[parsed.id]
        try:
            value = self._evaluator.eval(formula, previously_parsed=parsed)
            if isinstance(value, complex):
                raise FormulaError(f"expected a number or a formula, found {value}")
            return float(value)
        except OverflowError as error:
            raise FormulaError("expected a finite number, found a far larger one") from error
        except simpleeval.NameNotDefined as error:
            why = f"{error.name!r} is not defined"
            raise UnknownNameError(
                _formula_error(formula, why), error.name, tuple(self._names)
            ) from error
        except simpleeval.FunctionNotDefined as error:
            why, known = f"there is no function {error.func_name!r}", tuple(FUNCTIONS)
            raise UnknownNameError(_formula_error(formula, why), error.func_name, known) from error
        except (
            simpleeval.InvalidExpression,
            ArithmeticError,
            TypeError,
            RecursionError,
        ) as error:
            raise FormulaError(_formula_error(formula, error)) from error
        except FormulaError:
            raise
        except ValueError as error:  # the root of a negative number
            raise FormulaError(_formula_error(formula, error)) from error


# A description says "0" and "half_length" hundreds of times.
@lru_cache(maxsize=1024)
def _parse_formula(formula: str) -> ast.expr:
    try:
        # What Python thinks of unusual spelling is no business of the user's terminal.
        with _PARSER_LOCK, warnings.catch_warnings():
            warnings.simplefilter("ignore")
            # One expression: left to itself simpleeval drops what follows a semicolon or stands
            # before an equals sign, with a warning only.
            parsed = ast.parse(formula.strip(), mode="eval").body
    except SyntaxError as error:
        raise FormulaError(_formula_error(formula, error.msg)) from error
    except (ValueError, RecursionError, MemoryError) as error:
        raise FormulaError(_formula_error(formula, error)) from error
    for node in ast.walk(parsed):
        if not _check_node(node):
            raise FormulaError(
                "expected a number or a formula of numbers, names, + - * / ** and functions,"
                f" found {formula!r}"
            )
    return parsed


def _check_node(node: ast.AST) -> bool:
    if isinstance(node, ast.Constant):
        return type(node.value) in (int, float)
    if isinstance(node, ast.Call):
        return isinstance(node.func, ast.Name) and not node.keywords
    return isinstance(node, _ALLOWED_NODES)


def _formula_error(formula: str, why: object) -> str:
    return f"bad formula {formula!r}: {why}"


_MAX_SUGGESTION_LENGTH = 60


def did_you_mean(word: object, known: Iterable[str]) -> str:
    """Return what was meant by an unknown word, to end an error with; "" where nothing is near."""
    # Comparing takes time by the square of the length, and both sides may come from the file.
    if not isinstance(word, str) or len(word) > _MAX_SUGGESTION_LENGTH:
        return ""
    short = [name for name in known if len(name) <= _MAX_SUGGESTION_LENGTH]
    close = difflib.get_close_matches(word, short, n=1)
    return f"; did you mean {close[0]!r}?" if close else ""


def short_repr(value: object) -> str:
    """A value of the file in an error message; never one that is itself too large to be shown."""
    if isinstance(value, dict | list):
        return "a table" if isinstance(value, dict) else "a list"
    if isinstance(value, int) and abs(value) >= 1 << 64:
        return "a far larger number"
    text = repr(value[: _MAX_SUGGESTION_LENGTH + 1] if isinstance(value, str) else value)
    return (
        text
        if len(text) <= _MAX_SUGGESTION_LENGTH + 2
        else f"{text[: _MAX_SUGGESTION_LENGTH - 3]}..."
    )


def printable_place(place: str) -> str:
    """Keys of a file may hold characters that a terminal would obey; and be of any length."""
    short = (
        place
        if len(place) <= 3 * _MAX_SUGGESTION_LENGTH
        else f"{place[: 3 * _MAX_SUGGESTION_LENGTH]}..."
    )
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in short)


# Far beyond any sports field. Samples lie centimetres apart: without a limit a slip of the pen (or
# a hostile file) would fill the memory with them.
MAX_COORDINATE_M = 1000.0
# Names stand in tables, on terminals and in tooltips.
_MAX_TEXT_LENGTH = 200


class FieldFileValues:
    """Names that formulas of one file may use, and the file's path for errors."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._names: dict[str, float] = {"pi": math.pi}
        self._coming: frozenset[str] = frozenset()

    def announce(self, names: Iterable[str]) -> None:
        """Announce what will be defined: a formula that names it too early is an error."""
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
