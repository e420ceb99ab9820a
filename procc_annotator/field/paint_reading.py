"""Read how elements are painted: where their paint lies, how wide it is, what it looks like."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from procc_annotator.field.appearance import (
    ANY,
    BAR,
    COLOURS,
    EDGE,
    KINDS,
    LINE,
    NOTHING,
    TONES,
    Appearance,
)
from procc_annotator.field.geometry import Arc, Circle, Geometry, Line, Spot, Vector, is_on_ground
from procc_annotator.field.values import FieldFileValues
from procc_annotator.field.words import short_repr

_APPEARANCE_KEYS = ("tone", "paint_colour")
_LINE_KEYS = {"line_width", "measured", *_APPEARANCE_KEYS}
_BAR_KEYS = {"diameter", *_APPEARANCE_KEYS}
MARKING_KEYS = _LINE_KEYS | _BAR_KEYS | {"inside", "seen_as"}  # of an element
_MEASURED_AT = ("centre", "outer")
_MAX_WIDTH_M = 2.0
_ON_LINE_TOLERANCE_M = 1e-6


@dataclass(frozen=True, slots=True)
class MarkingProperties:
    """See `Element`."""

    line_width: float
    inside: Vector | None
    appearance: Appearance


class MarkingReader:
    """What a file says of all its elements, and of each.

    Args:
        values: of the file.
        lines: its table ``[paint]``: what holds for all elements on the ground.
        bars: its table ``[bars]``: what holds for all that are not on the ground.

    Raises:
        FieldError: names the place of what is wrong.
    """

    def __init__(self, values: FieldFileValues, lines: Mapping[str, Any], bars: Mapping[str, Any]) -> None:
        self._values = values
        self._lines, self._bars = lines, bars
        # A mistake in what holds for all elements is told here, not at the first of them.
        values.keys("paint", dict(lines), _LINE_KEYS, {"line_width"} if lines else set())
        values.keys("bars", dict(bars), _BAR_KEYS, set())
        for place, table in (("paint", lines), ("bars", bars)):
            self._width(f"{place}.line_width", table.get("line_width", 0.0))
            self._width(f"{place}.diameter", table.get("diameter", 0.0))
            self._one_of(f"{place}.measured", table.get("measured", "centre"), _MEASURED_AT)
            self._look(place, LINE, 0.0, table, {})

    def of(self, place: str, geometry: Geometry, entry: Mapping[str, Any]) -> MarkingProperties:
        """What an element's own table says, and what is said of all such elements.

        Raises:
            FieldError: names the place of what is wrong.
        """
        spot, on_ground = isinstance(geometry, Spot), is_on_ground(geometry)
        usual = self._lines if on_ground and not spot else {}
        width = entry.get("line_width", usual.get("line_width", 0.0))
        width = self._width(f"{place}.line_width", width)
        inside = self._inside(place, geometry, entry, usual)
        kind = NOTHING if spot else LINE if width > 0 else EDGE if on_ground else BAR
        kind = self._one_of(f"{place}.seen_as", entry.get("seen_as", kind), KINDS)
        if kind == BAR:
            usual = self._bars
        elif "diameter" in entry:
            raise self._values.error(f"{place}.diameter", 'is of use only with seen_as = "bar"')
        elif width == 0:
            usual = {}  # nothing is painted: it looks as it likes
        return MarkingProperties(width, inside, self._look(place, kind, width, entry, usual))

    def _inside(
        self, place: str, geometry: Geometry, entry: Mapping[str, Any], usual: Mapping[str, Any]
    ) -> Vector | None:
        """A place on the side the paint lies on; None where it lies on both."""
        measured = entry.get("measured", usual.get("measured", "centre"))
        if self._one_of(f"{place}.measured", measured, _MEASURED_AT) == "centre":
            if "inside" in entry:
                raise self._values.error(
                    f"{place}.inside", 'is of use only with measured = "outer"'
                )
            return None
        inside = _default_inside(geometry)
        if "inside" in entry:
            inside = self._values.vector(f"{place}.inside", entry["inside"])
        if _lies_on(geometry, inside):
            raise self._values.error(
                f"{place}.inside",
                "lies on the element: name a place on the side of the paint,"
                ' or say measured = "centre"',
            )
        return inside

    def _look(
        self,
        place: str,
        kind: str,
        width: float,
        entry: Mapping[str, Any],
        usual: Mapping[str, Any],
    ) -> Appearance:
        tone, colour = (entry.get(key, usual.get(key, ANY)) for key in _APPEARANCE_KEYS)
        tone = self._one_of(f"{place}.tone", tone, TONES)
        colour = self._one_of(f"{place}.paint_colour", colour, COLOURS)
        if kind == BAR:
            diameter = entry.get("diameter", usual.get("diameter", width))
            width = self._width(f"{place}.diameter", diameter)
        return Appearance(kind, tone, colour, width)

    def _width(self, place: str, value: object) -> float:
        width = self._values.number(place, value)
        if not 0 <= width <= _MAX_WIDTH_M:
            raise self._values.error(place, f"expected 0 to {_MAX_WIDTH_M:g} m, found {width:g}")
        return width

    def _one_of(self, place: str, value: object, allowed: tuple[str, ...]) -> str:
        if not isinstance(value, str) or value not in allowed:
            raise self._values.error(
                place, f"expected one of {', '.join(allowed)}, found {short_repr(value)}"
            )
        return value


def _default_inside(geometry: Geometry) -> Vector:
    """Of a round element its own centre, else the centre of the field."""
    return geometry.centre if isinstance(geometry, Arc | Circle) else (0.0, 0.0, 0.0)


def _lies_on(geometry: Geometry, place: Vector) -> bool:
    if not isinstance(geometry, Line):
        return False
    (ax, ay, _), (bx, by, _) = geometry.start, geometry.end
    twice_area = (bx - ax) * (place[1] - ay) - (by - ay) * (place[0] - ax)
    return abs(twice_area) < _ON_LINE_TOLERANCE_M
