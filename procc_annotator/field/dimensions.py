"""Measures of a field, and rules that relate them to one another: ``length > width``."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, product

from procc_annotator.field.formulas import (
    FieldFileValues,
    FormulaError,
    Formulas,
    UnknownNameError,
    did_you_mean,
)

_RELATION_PATTERN = re.compile(r"([^<>=]+)(<=|>=|<|>)([^<>=]+)\Z")
# What is kept of a dimension and what formulas make of it differ by less; no one measures as much.
_EQUAL_TOLERANCE_M = 1e-9
_MAX_RELATIONS = 32
_MAX_COMBINATIONS = 2000


@dataclass(frozen=True, slots=True)
class Dimension:
    """A measure of the field, metres: its value here, the nominal one, the range of the rules."""

    name: str
    title: str
    value: float
    nominal: float
    minimum: float
    maximum: float

    @property
    def is_open(self) -> bool:
        """Return whether the rules leave it a range."""
        return self.minimum < self.maximum


@dataclass(frozen=True, slots=True)
class Relation:
    """Two formulas over dimensions, and which side the rules want to be larger."""

    left: str
    sign: str
    right: str

    def __str__(self) -> str:
        return f"{self.left} {self.sign} {self.right}"

    def sides(self, values: Mapping[str, float]) -> tuple[float, float]:
        """Both sides for these dimensions, metres by name; `FormulaError` if a side is no formula
        of them, or has no finite value."""
        formulas = Formulas({"pi": math.pi, **values})
        left, right = formulas.value(self.left), formulas.value(self.right)
        for value in (left, right):
            if not math.isfinite(value):
                raise FormulaError(f"expected a finite number on both sides, found {value!r}")
        return left, right

    def violation(self, values: Mapping[str, float]) -> str:
        """Return what is wrong with these dimensions, metres by name; empty if nothing is."""
        asked = f"the rules ask for {self}"
        try:
            left, right = self.sides(values)
        except FormulaError as error:
            return f"{asked}: {error}"
        less, more = (right, left) if ">" in self.sign else (left, right)
        if more - less > (-_EQUAL_TOLERANCE_M if "=" in self.sign else _EQUAL_TOLERANCE_M):
            return ""
        return f"{asked}, and {left:.10g} {self.sign} {right:.10g} does not hold"


def read_relations(
    values: FieldFileValues, texts: object, dimensions: tuple[Dimension, ...]
) -> tuple[Relation, ...]:
    """The relations of a field file, which may name its dimensions; the nominal ones must be so.
    `FieldError`, with the file and the relation, if one is wrong."""
    if not isinstance(texts, list) or len(texts) > _MAX_RELATIONS:
        raise values.error("relations", 'expected a list of relations, as ["length > width"]')
    nominal = {d.name: d.nominal for d in dimensions}
    found = []
    for i, text in enumerate(texts):
        place = f"relations[{i}]"
        try:
            relation = _relation_of(values.text(place, text))
            relation.sides(nominal)
        except FormulaError as error:
            hint = ""
            if isinstance(error, UnknownNameError):
                hint = did_you_mean(error.word, error.known)
            raise values.error(place, f"{error}{hint}") from error
        if broken := relation.violation(nominal):
            raise values.error(place, f"the nominal dimensions break it: {broken}")
        found.append(relation)
    return tuple(found)


def _relation_of(text: str) -> Relation:
    found = _RELATION_PATTERN.match(text)
    if found is None:
        raise FormulaError("expected two formulas with one of < <= > >= between them")
    left, sign, right = (part.strip() for part in found.groups())
    return Relation(left, sign, right)


def violated_relation(relations: tuple[Relation, ...], values: Mapping[str, float]) -> str:
    """Return what is wrong by the first relation that does not hold for all dimensions of a field,
    metres by name; empty where all do."""
    return next(filter(None, (relation.violation(values) for relation in relations)), "")


def allowed_dimensions(
    relations: tuple[Relation, ...],
    dimensions: tuple[Dimension, ...],
    name: str,
    value: float,
) -> dict[str, float] | None:
    """Dimensions with which one of them may have a value, metres by name; None if there are none.

    The others are nominal where that is allowed, else at an end of their range.
    """
    for tried in islice(_combinations(dimensions, name, value), _MAX_COMBINATIONS):
        if not violated_relation(relations, tried):
            return tried
    return None


def _combinations(
    dimensions: tuple[Dimension, ...], name: str, value: float
) -> Iterator[dict[str, float]]:
    nominal = {d.name: d.nominal for d in dimensions} | {name: value}
    others = [d for d in dimensions if d.is_open and d.name != name]
    yield nominal
    for chosen in product(*((d.nominal, d.minimum, d.maximum) for d in others)):
        yield nominal | {d.name: v for d, v in zip(others, chosen, strict=True)}
