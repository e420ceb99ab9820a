"""Field picture and field tables."""

from __future__ import annotations

import io
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.errors import UsageError
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
from procc_annotator.field.markings import marking_side
from procc_annotator.field.model import MIDDLE_LINE, Element, Field
from procc_annotator.report.page.chart_style import drawing_settings
from procc_annotator.report.tables.table import (
    Column,
    Metric,
    MetricTable,
    Row,
    count_column,
    metric_column,
)

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


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
        else "symmetries: none, its sides can be distinguished"
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


SUFFIXES = (".png", ".svg")
_DPI = 160
_WIDTH_IN, _SIDE_IN, _TOP_IN, _FOOT_IN = 11.0, 0.55, 0.55, 0.6
_HIGHEST_MAP_IN, _LINE_IN = 7.5, 0.17
_COLUMNS, _LONGEST_NAME = 4, 36
_DASHES = (0, (5, 2.5))
_FLOOR, _INK, _FAINT, _RIM = "#E9EDF0", "#1B1F24", "#5B6670", "#2A2F36"
_SETTINGS: dict[str, Any] = {
    "svg.fonttype": "none",
    "svg.hashsalt": "procc-annotator",
    "font.size": 8.0,
    "lines.scale_dashes": False,
    "text.parse_math": False,  # titles come from files: a dollar sign in one is no formula
}


@dataclass(frozen=True, eq=False)
class FlatField:
    """Elements laid flat.

    Attributes:
        lines: (E,) arrays (n, 2) of metres, x along the field, y across towards the main camera,
            in the field's order; a single row for a spot.
        ground: (left, far, right, near) metres of what is on the ground.
    """

    lines: Sequence[FloatArray]
    ground: tuple[float, float, float, float]


def check_picture_suffix(path: PurePath) -> None:
    """Fail before the work. `UsageError` if it is no picture that can be written."""
    if path.suffix.lower() not in SUFFIXES:
        raise UsageError(f"{path}: expected a name that ends in {' or '.join(SUFFIXES)}")


def field_picture(field: Field, flat: FlatField, suffix: str) -> bytes:
    """The picture of a field on a map as a file of its own, with one of `SUFFIXES`."""
    with drawing_settings(_SETTINGS):
        figure = _figure(field, flat)
        stream = io.BytesIO()
        kind = suffix.lower().removeprefix(".")
        nothing: Any = {"Date": None, "Creator": None} if kind == "svg" else {"Software": None}
        figure.savefig(stream, format=kind, dpi=_DPI, metadata=nothing)
    return stream.getvalue()


def _figure(field: Field, flat: FlatField) -> Figure:
    from matplotlib.figure import Figure

    reach = np.concatenate([*flat.lines, np.reshape(flat.ground, (2, 2))])
    room = 0.02 * float(np.ptp(reach, axis=0).max())
    (left, top), (right, bottom) = reach.min(axis=0) - room, reach.max(axis=0) + room
    wide = _WIDTH_IN - 2 * _SIDE_IN
    high = min(_HIGHEST_MAP_IN, wide * (bottom - top) / (right - left))
    columns = _columns(field)
    rows = max(len(column) for column in columns)
    height = _TOP_IN + high + _FOOT_IN + rows * _LINE_IN + 0.2
    figure = Figure(figsize=(_WIDTH_IN, height))
    axes = figure.add_axes(
        (_SIDE_IN / _WIDTH_IN, 1 - (_TOP_IN + high) / height, wide / _WIDTH_IN, high / height)
    )
    axes.set_xlim(left, right)
    axes.set_ylim(bottom, top)  # the main camera's side is below
    axes.set_aspect("equal")
    _draw_map(axes, field, flat)
    at = (_SIDE_IN / _WIDTH_IN, 1 - 0.28 / height)
    figure.text(*at, _heading(field), fontsize=11, color=_INK, va="center")
    if field.rules:
        right_at = (1 - at[0], at[1])
        figure.text(*right_at, field.rules, fontsize=8, color=_FAINT, va="center", ha="right")
    below = figure.add_axes((at[0], 0.1 / height, wide / _WIDTH_IN, rows * _LINE_IN / height))
    _draw_names(below, columns, rows)
    return figure


def _heading(field: Field) -> str:
    sides = [field.dimension(name) for name in ("length", "width")]
    size = " x ".join(f"{side.value:.6g}" for side in sides if side is not None)
    return f"{field.title}, {size} m" if size else field.title


def _draw_map(axes: Axes, field: Field, flat: FlatField) -> None:
    from matplotlib.patches import Rectangle

    left, top, right, bottom = flat.ground
    axes.add_patch(Rectangle((left, top), right - left, bottom - top, color=_FLOOR, zorder=0))
    for element, line in zip(field.elements, flat.lines, strict=True):
        if len(line) == 1 or element.is_spot:
            _draw_spot(axes, float(line[0, 0]), float(line[0, 1]), element)
            continue
        dashes = _DASHES if element.optional else "-"
        for colour, width in ((_RIM, 2.6), (element.colour, 1.7)):
            axes.plot(
                line[:, 0], line[:, 1], color=colour, linewidth=width, linestyle=dashes,
                solid_capstyle="round", zorder=2 if colour == _RIM else 3,
            )  # fmt: skip
    for spine in axes.spines.values():
        spine.set_visible(False)
    axes.tick_params(color=_FAINT, labelcolor=_FAINT, labelsize=7, length=3, width=0.6)
    said = "metres from the centre; what stands upright lies folded outwards"
    if any(e.optional and not e.is_spot for e in field.elements):
        said += "; dashes: judged only where annotated"
    axes.set_xlabel(said, color=_FAINT, fontsize=7.5)


def _draw_spot(axes: Axes, x: float, y: float, element: Element) -> None:
    axes.plot(
        [x], [y], "o", markersize=5, color=element.colour, markeredgecolor=_RIM,
        markeredgewidth=0.6, zorder=4,
    )  # fmt: skip


def _columns(field: Field) -> list[list[Element | str]]:
    """Elements by group, each group under its name, in columns of about one height."""
    groups: dict[str, list[Element]] = {}
    for element in field.elements:
        groups.setdefault(element.group, []).append(element)
    entries: list[Element | str] = []
    for group, elements in groups.items():
        entries += [group, *elements]
    rows = -(-len(entries) // _COLUMNS)
    while len(columns := _broken(entries, rows)) > _COLUMNS:
        rows += 1
    return columns


def _broken(entries: Sequence[Element | str], rows: int) -> list[list[Element | str]]:
    """Entries in columns of some rows; no column ends with the name of a group."""
    columns: list[list[Element | str]] = [[]]
    for entry in entries:
        full = len(columns[-1]) == rows
        if full or (isinstance(entry, str) and len(columns[-1]) == rows - 1 and rows > 1):
            columns.append([])
        columns[-1].append(entry)
    return columns


def _draw_names(axes: Axes, columns: Sequence[Sequence[Element | str]], rows: int) -> None:
    axes.set_axis_off()
    axes.set_xlim(0, _COLUMNS)
    axes.set_ylim(rows, 0)
    for x, column in enumerate(columns):
        for row, entry in enumerate(column):
            _draw_name(axes, x, row + 0.5, entry)


def _draw_name(axes: Axes, x: float, y: float, entry: Element | str) -> None:
    if isinstance(entry, str):
        axes.text(x, y, _short(entry), fontsize=7.5, fontweight="bold", color=_INK, va="center")
        return
    if entry.is_spot:
        _draw_spot(axes, x + 0.04, y, entry)
    else:
        for colour, width in ((_RIM, 4.4), (entry.colour, 3.2)):
            axes.plot([x + 0.01, x + 0.07], [y, y], color=colour, linewidth=width)
    key = f"  ({entry.shortcut})" if entry.shortcut else ""
    axes.text(x + 0.1, y, _short(entry.title) + key, fontsize=7.5, color=_INK, va="center")


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST_NAME else f"{text[: _LONGEST_NAME - 1]}…"
