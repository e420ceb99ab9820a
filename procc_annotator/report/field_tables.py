"""A field as tables on the terminal: what is known of it before anybody annotates."""

from __future__ import annotations

import math
from collections.abc import Iterable

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
from procc_annotator.field.model import MIDDLE_LINE, Element, Field
from procc_annotator.field.paint import marking_side
from procc_annotator.report.sheet.figure import Metric
from procc_annotator.report.sheet.sheet import Column, Row, MetricTable, metric_column, count_column

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


def list_table(fields: Iterable[Field]) -> MetricTable:
    """One row a field."""
    columns = (
        Column("name", "name"), Column("sport", "sport"), Column("size", "size by the rules"),
        count_column("elements"), Column("rules", "rules"),
    )  # fmt: skip
    rows = []
    for field in fields:
        is_default = field.name == default_field_name()
        name = f"{field.name} (default)" if is_default else field.name
        rows.append((name, field.title, size_of(field), len(field.elements), field.rules))
    return MetricTable("fields", "Fields", columns, tuple(rows))


def elements_table(field: Field) -> MetricTable:
    """One row an element: what people and files call it, where and how long it is."""
    length = metric_column(Metric("length", "length"))
    columns = (
        Column("element", "element"), Column("class", "class in files"), Column("group", "group"),
        Column("shortcut", "key"), Column("kind", "kind"), length, Column("height", "height"),
        Column("paint", "paint"),
    )  # fmt: skip
    rows: list[Row] = [
        (
            element.title,
            repr(element.name) if element.name != element.name.strip() else element.name,
            element.group,
            element.shortcut,
            _kind(element.geometry) + (", optional" if element.optional else ""),
            None if element.is_spot else float(length_of(element.geometry)),
            _heights(element.geometry),
            _paint(element),
        )
        for element in field.elements
    ]
    rows += [
        (None, name, None, None, "without geometry", None, None, None)
        for name in field.classes_without_geometry
    ]
    sided = any(marking_side(element) for element in field.elements)
    notes = (_PAINT_CAPTION,) if sided else ()
    return MetricTable(
        "elements", f"Elements of {field.title} (m)", columns, tuple(rows), notes=notes
    )  # fmt: skip


def dimensions_table(field: Field) -> MetricTable:
    """One row a dimension, with what the rules allow."""
    columns = (
        Column("dimension", "dimension"), Column("name", "name"), Column("here", "here", "number"),
        Column("nominal", kind="number", joined=" (nominal {})"), Column("rules", "rules"),
    )  # fmt: skip
    rows = tuple(
        (
            d.title, d.name, d.value, None if d.value == d.nominal else d.nominal,
            _range(d, " to ") if d.is_open else "fixed",
        )
        for d in field.dimensions
    )  # fmt: skip
    return MetricTable("dimensions", "Dimensions (m)", columns, rows)


def facts(field: Field) -> list[str]:
    """Lines about the field as a whole: rules, relations, symmetries, cameras."""
    said = []
    if field.rules:
        said.append(f"rules: {field.rules}")
    if field.relations:
        said.append(f"between dimensions: {', '.join(map(str, field.relations))}")
    if field.lines == MIDDLE_LINE:
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
    side = marking_side(element)
    return f"{element.line_width:.3g}{', ' if side else ''}{side}"
