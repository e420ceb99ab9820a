"""A field as tables on the terminal: what is known of it before anybody annotates."""

from __future__ import annotations

import math
from collections.abc import Iterable

from rich.table import Table

from procc_annotator.field.dimensions import Dimension
from procc_annotator.field.geometry import (
    Arc,
    Chain,
    Circle,
    Geometry,
    Line,
    Spot,
    length_of,
    outline_of,
)
from procc_annotator.field.load import default_field_name
from procc_annotator.field.model import MIDDLE, Element, Field
from procc_annotator.field.paint import side_of_paint

_KINDS: dict[type, str] = {
    Line: "line",
    Arc: "arc",
    Circle: "circle",
    Spot: "point",
}
_PAINT_CAPTION = (
    "paint: its width and, where an edge of it is measured, the side it lies on: of a line the"
    " field's centre is inside, of a curve its own"
)


def size_of(field: Field) -> str:
    """Length and width in metres, what the rules leave open as a range: ``60 x 26-30 m``."""
    sides = [field.dimension(name) for name in ("length", "width")]
    known = [_range(side, "-") for side in sides if side is not None]
    return f"{' x '.join(known)} m" if known else ""


def list_table(fields: Iterable[Field]) -> Table:
    """One row a field."""
    table = _table("Fields")
    for heading in ("name", "sport", "size by the rules", "elements", "rules"):
        table.add_column(heading, justify="right" if heading == "elements" else "left")
    for field in fields:
        elements = str(len(field.elements))
        is_default = field.name == default_field_name()
        name = f"{field.name} (default)" if is_default else field.name
        table.add_row(name, field.title, size_of(field), elements, field.rules)
    return table


def elements_table(field: Field) -> Table:
    """One row an element: what people and files call it, where and how long it is."""
    table = _table(f"Elements of {field.title} (m)")
    if any(side_of_paint(element) for element in field.elements):
        table.caption = _PAINT_CAPTION
        table.caption_justify = "left"
    headings = ("element", "class in files", "group", "key", "kind", "length", "height", "paint")
    for heading in headings:
        table.add_column(heading, justify="right" if heading == "length" else "left")
    for element in field.elements:
        kind = _kind(element.geometry) + (", optional" if element.optional else "")
        length = "" if element.is_spot else f"{length_of(element.geometry):.2f}"
        table.add_row(
            element.title,
            repr(element.name) if element.name != element.name.strip() else element.name,
            element.group,
            element.shortcut,
            kind,
            length,
            _heights(element.geometry),
            _paint(element),
        )
    for name in field.classes_without_geometry:
        table.add_row("", name, "", "", "without geometry", "", "", "")
    return table


def dimensions_table(field: Field) -> Table:
    """One row a dimension, with what the rules allow."""
    table = _table("Dimensions (m)")
    for heading in ("dimension", "name", "here", "rules"):
        table.add_column(heading, justify="right" if heading == "here" else "left")
    for dimension in field.dimensions:
        allowed = _range(dimension, " to ") if dimension.is_open else "fixed"
        here = f"{dimension.value:.10g}"
        if dimension.value != dimension.nominal:
            here += f" (nominal {dimension.nominal:.10g})"
        table.add_row(dimension.title, dimension.name, here, allowed)
    return table


def facts(field: Field) -> list[str]:
    """Lines about the field as a whole: rules, relations, symmetries, cameras."""
    said = []
    if field.rules:
        said.append(f"rules: {field.rules}")
    if field.relations:
        said.append(f"between dimensions: {', '.join(map(str, field.relations))}")
    if field.lines == MIDDLE:
        said.append("lines: in the middle of their paint, not where the rules measure them")
    turns = [f"{math.degrees(s.turn_rad):g}" for s in field.symmetries]
    said.append(
        f"symmetries: looks the same turned by {' and '.join(turns)} degrees"
        if turns
        else "symmetries: none, its sides can be told apart"
    )
    if field.cameras is not None:
        places = field.cameras
        near, usual, far = places.distance
        low, eye, high = places.height
        line = (
            f"cameras: {near:g} to {far:g} m from the field (usually {usual:g}),"
            f" {low:g} to {high:g} m high (usually {eye:g})"
        )
        said.append(line + (f", at the roof {places.ceiling:g} m" if places.ceiling else ""))
    return said


def _range(dimension: Dimension, between: str) -> str:
    if not dimension.is_open:
        return f"{dimension.nominal:.6g}"
    return f"{dimension.minimum:.6g}{between}{dimension.maximum:.6g}"


def _kind(geometry: Geometry) -> str:
    """As a field file calls it."""
    if isinstance(geometry, Chain):
        straight = all(isinstance(part, Line) for part in geometry.parts)
        return "polyline" if straight else "chain"
    return _KINDS[type(geometry)]


def _heights(geometry: Geometry) -> str:
    heights = -outline_of(geometry)[:, 2]
    low, high = float(heights.min()) + 0.0, float(heights.max()) + 0.0
    if high - low < 0.005:
        return "" if abs(high) < 0.005 else f"{high:.2f}"
    return f"{low:.2f} to {high:.2f}"


def _paint(element: Element) -> str:
    if not element.line_width:
        return ""
    side = side_of_paint(element)
    return f"{element.line_width:.3g}{', ' if side else ''}{side}"


def _table(title: str) -> Table:
    return Table(title=title, title_justify="left")
