"""Formulas of field files: arithmetic on floats and nothing else.

A field file may come from anywhere. Python's whole numbers grow without end (``9**3999999`` takes
seconds, a division of two such numbers hours) and its texts have methods that fill the memory, so
that only floats, names and a few functions are let in: each formula takes microseconds.
"""

from __future__ import annotations

import ast
import math
import operator
import threading
import warnings
from collections.abc import Callable, Mapping
from functools import lru_cache

import simpleeval

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
            raise FormulaError(f"bad formula: longer than {_MAX_FORMULA_LENGTH} characters; use [formulas]")
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
            raise UnknownNameError(_formula_error(formula, why), error.name, tuple(self._names)) from error
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
