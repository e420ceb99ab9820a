"""Read the geometry and the line marking of one element of a field file."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from procc_annotator.field.formulas import MAX_COORDINATE_M, FieldFileValues, short_repr
from procc_annotator.field.geometry import (
    SAME_PLACE_M,
    Arc,
    Chain,
    Circle,
    Geometry,
    Line,
    Spot,
    Vector,
    ends_of,
    is_on_ground,
    vector_of,
)
from procc_annotator.field.model import (
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

# Keys that a kind of geometry must and may have.
GEOMETRY_KEYS: dict[str, tuple[set[str], set[str]]] = {
    "line": ({"start", "end"}, set()),
    "arc": ({"centre", "radius", "start", "end"}, {"normal", "zero"}),
    "circle": ({"centre", "radius"}, {"normal", "zero"}),
    "polyline": ({"points"}, set()),
    "chain": ({"parts"}, set()),
    "point": ({"position"}, set()),
}
_CHAIN_PART_KINDS = ("line", "arc")
_MIN_RADIUS_M = 0.01
_MAX_PARTS = 64
# Parts of a chain that are given in centimetres may fail to meet by a rounding.
_JOINT_TOLERANCE_M = 0.001


def read_geometry(
    values: FieldFileValues, place: str, kind: str, entry: Mapping[str, Any]
) -> Geometry:
    """The geometry of an element.

    Args:
        values: evaluates the formulas of the file.
        place: where the entry stands, for errors.
        kind: a key of `GEOMETRY_KEYS`.
        entry: the element's table; its keys are known to be right.

    Raises:
        FieldError: names the place and what was expected.
    """
    return _GEOMETRY_READERS[kind](values, place, entry)


def _read_line(values: FieldFileValues, place: str, entry: Mapping[str, Any]) -> Line:
    line = Line(
        values.vector(f"{place}.start", entry["start"]),
        values.vector(f"{place}.end", entry["end"]),
    )
    if math.dist(line.start, line.end) < SAME_PLACE_M:
        raise values.error(f"{place}.end", "a line needs two different ends")
    return line


def _read_spot(values: FieldFileValues, place: str, entry: Mapping[str, Any]) -> Spot:
    return Spot(values.vector(f"{place}.position", entry["position"]))


def _read_circle(values: FieldFileValues, place: str, entry: Mapping[str, Any]) -> Circle:
    return Circle(*_read_round(values, place, entry), *_read_plane(values, place, entry))


def _read_arc(values: FieldFileValues, place: str, entry: Mapping[str, Any]) -> Arc:
    start = values.number(f"{place}.start", entry["start"])
    end = values.number(f"{place}.end", entry["end"])
    if not start < end < start + 2 * math.pi:
        raise values.error(f"{place}.end", "an arc runs from a smaller to a larger angle")
    return Arc(*_read_round(values, place, entry), start, end, *_read_plane(values, place, entry))


def _read_chain_arc(values: FieldFileValues, place: str, entry: Mapping[str, Any]) -> Arc:
    """An arc of a chain may also run towards smaller angles: then its plane is turned over."""
    start = values.number(f"{place}.start", entry["start"])
    end = values.number(f"{place}.end", entry["end"])
    if not 0 < abs(end - start) < 2 * math.pi:
        raise values.error(f"{place}.end", "expected two angles less than a full turn apart")
    centre, radius = _read_round(values, place, entry)
    ahead, aside = _read_plane(values, place, entry)
    if end < start:
        x, y, z = aside
        return Arc(centre, radius, -start, -end, ahead, (-x + 0.0, -y + 0.0, -z + 0.0))
    return Arc(centre, radius, start, end, ahead, aside)


def _read_polyline(values: FieldFileValues, place: str, entry: Mapping[str, Any]) -> Chain:
    points = entry["points"]
    if not isinstance(points, list) or not 2 <= len(points) <= _MAX_PARTS + 1:
        raise values.error(f"{place}.points", f"expected 2 to {_MAX_PARTS + 1} places [x, y, z]")
    places = [values.vector(f"{place}.points[{i}]", p) for i, p in enumerate(points)]
    for i, (one, other) in enumerate(pairwise(places), 1):
        if math.dist(one, other) < SAME_PLACE_M:
            raise values.error(f"{place}.points[{i}]", "is the same place as the point before it")
    return Chain(tuple(Line(a, b) for a, b in pairwise(places)))


def _read_chain(values: FieldFileValues, place: str, entry: Mapping[str, Any]) -> Chain:
    parts = entry["parts"]
    if not isinstance(parts, list) or not 2 <= len(parts) <= _MAX_PARTS:
        raise values.error(
            f"{place}.parts", f"expected a list of 2 to {_MAX_PARTS} tables with a kind"
        )
    found: list[Line | Arc] = []
    for i, part in enumerate(parts):
        here = f"{place}.parts[{i}]"
        kind = part.get("kind") if isinstance(part, dict) else None
        if kind not in _CHAIN_PART_KINDS:
            raise values.error(
                here, f"expected a table with kind = {' or '.join(_CHAIN_PART_KINDS)}"
            )
        required, more = GEOMETRY_KEYS[kind]
        values.keys(here, part, {"kind", *required, *more}, {"kind", *required})
        one = (
            _read_line(values, here, part)
            if kind == "line"
            else _read_chain_arc(values, here, part)
        )
        if found:
            _check_joint(values, here, found[-1], one)
        found.append(one)
    return Chain(tuple(found))


def _check_joint(values: FieldFileValues, place: str, before: Line | Arc, part: Line | Arc) -> None:
    last, first = ends_of(before), ends_of(part)
    if last is None or first is None:
        raise values.error(place, "an arc of a chain cannot be a full turn")
    apart = math.dist(last[1], first[0])
    if apart > _JOINT_TOLERANCE_M:
        ended = ", ".join(f"{v:.4g}" for v in last[1])
        begins = ", ".join(f"{v:.4g}" for v in first[0])
        raise values.error(
            place, f"begins at ({begins}), the part before it ends {apart:.3g} m away at ({ended})"
        )


def _read_round(
    values: FieldFileValues, place: str, entry: Mapping[str, Any]
) -> tuple[Vector, float]:
    centre = values.vector(f"{place}.centre", entry["centre"])
    radius = values.number(f"{place}.radius", entry["radius"])
    if radius <= 0:
        raise values.error(f"{place}.radius", f"expected a positive radius, found {radius:g}")
    if not _MIN_RADIUS_M <= radius <= MAX_COORDINATE_M:
        raise values.error(
            f"{place}.radius",
            f"expected {_MIN_RADIUS_M:g} to {MAX_COORDINATE_M:g} m, found {radius:g}",
        )
    return centre, radius


def _read_plane(
    values: FieldFileValues, place: str, entry: Mapping[str, Any]
) -> tuple[Vector, Vector]:
    """``ahead`` and ``aside`` of a curve: horizontal unless the file names a normal."""
    if "normal" not in entry:
        if "zero" in entry:
            raise values.error(f"{place}.zero", "is of use only together with normal")
        return (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)
    normal = np.array(values.vector(f"{place}.normal", entry["normal"]))
    length = float(np.linalg.norm(normal))
    if length < SAME_PLACE_M:
        raise values.error(f"{place}.normal", "expected a direction, found (0, 0, 0)")
    normal = normal / length
    if "zero" in entry:
        zero = np.array(values.vector(f"{place}.zero", entry["zero"]))
    else:
        zero = np.array((1.0, 0.0, 0.0) if abs(normal[0]) < 0.9 else (0.0, 1.0, 0.0))
    ahead = zero - (zero @ normal) * normal
    length = float(np.linalg.norm(ahead))
    if length < SAME_PLACE_M:
        raise values.error(f"{place}.zero", "expected a direction that differs from the normal")
    ahead = ahead / length
    return vector_of(ahead), vector_of(np.cross(normal, ahead))


_GEOMETRY_READERS: dict[str, Callable[[FieldFileValues, str, Mapping[str, Any]], Geometry]] = {
    "line": _read_line,
    "arc": _read_arc,
    "circle": _read_circle,
    "polyline": _read_polyline,
    "chain": _read_chain,
    "point": _read_spot,
}


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
    """Content of a file on all its elements, and on each.

    Args:
        lines: its table ``[paint]``: what holds for all elements on the ground.
        bars: its table ``[bars]``: what holds for all that are not on the ground.

    Raises:
        FieldError: names the place of what is wrong.
    """

    def __init__(
        self, values: FieldFileValues, lines: Mapping[str, Any], bars: Mapping[str, Any]
    ) -> None:
        self._values = values
        self._lines, self._bars = lines, bars
        # A mistake in what holds for all elements is reported here, not at the first of them.
        values.keys("paint", dict(lines), _LINE_KEYS, {"line_width"} if lines else set())
        values.keys("bars", dict(bars), _BAR_KEYS, set())
        for place, table in (("paint", lines), ("bars", bars)):
            self._width(f"{place}.line_width", table.get("line_width", 0.0))
            self._width(f"{place}.diameter", table.get("diameter", 0.0))
            self._one_of(f"{place}.measured", table.get("measured", "centre"), _MEASURED_AT)
            self._look(place, LINE, 0.0, table, {})

    def of(self, place: str, geometry: Geometry, entry: Mapping[str, Any]) -> MarkingProperties:
        """Return what an element's own table says, and what is said of all such elements;
        `FieldError`, with the place, if something is wrong."""
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
    return geometry.centre if isinstance(geometry, Arc | Circle) else (0.0, 0.0, 0.0)


def _lies_on(geometry: Geometry, place: Vector) -> bool:
    if not isinstance(geometry, Line):
        return False
    (ax, ay, _), (bx, by, _) = geometry.start, geometry.end
    twice_area = (bx - ax) * (place[1] - ay) - (by - ay) * (place[0] - ax)
    return abs(twice_area) < _ON_LINE_TOLERANCE_M
