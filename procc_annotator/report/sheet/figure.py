"""What a figure is: how it is called, in what it is measured, how it is shown and defined."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

DASH = "–"  # for what is undefined

Better = Literal["higher", "lower"]


@dataclass(frozen=True, slots=True)
class Metric:
    """One figure, wherever it is told.

    Attributes:
        key: in files.
        title: for people.
        unit: ``%`` for a share, which is kept as 0 to 1 and shown times 100; else what follows the
            title: px, m, °. Empty for a count or a plain number.
        better: whether a higher or a lower value is the better one; None where neither is.
        digits: decimals it is shown with; ``significant`` ones where that is said.
        definition: a sentence or two for who has not met it.
        signed: whether values above 0 are shown with a plus.
        most: what lies beyond says no more than this; shown as ``> 1000``.
        attribute: of the values it is taken from, where that is not called like the key.
    """

    key: str
    title: str
    unit: str = ""
    better: Better | None = None
    digits: int = 2
    definition: str = ""
    significant: bool = False
    signed: bool = False
    most: float = math.inf
    attribute: str = ""

    def of(self, values: object) -> float | None:
        """The figure, taken from values that have it as an attribute."""
        found: float | None = getattr(values, self.attribute or self.key)
        return found

    def text(self, value: float | None) -> str:
        """The value as it is shown, without its unit; a dash where it is undefined."""
        if value is None or math.isnan(value):
            return DASH
        number = 100 * value if self.unit == "%" else value
        if number > self.most:
            return f"> {self.most:.0f}"
        kind = "g" if self.significant else "f"
        shown = f"{number:{'+' if self.signed else ''}.{self.digits}{kind}}"
        return shown if float(shown) else shown.lstrip("+-")  # no sign before 0.00


def metric_values(figures: Iterable[Metric], values: object) -> tuple[float | None, ...]:
    """Figures taken from values that have them as attributes; all are None where there are none."""
    return tuple(None if values is None else figure.of(values) for figure in figures)


def shortest_number(value: float) -> str:
    """A number as short as it is exact: ``5``, ``2.5``."""
    short = f"{value:g}"
    return short if float(short) == value and "e" not in short else repr(value)
