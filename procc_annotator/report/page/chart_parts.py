"""What the charts of a report share: how sources look, where panels go."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.colours import hex_colour, linear_rgb
from procc_annotator.io.camera_files.fitted_on import MARKS
from procc_annotator.report.page.audit_report import AuditReport, ReportedSource
from procc_annotator.session.runs.audit_figures import Points, gather

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Floats = NDArray[np.floating[Any]]

# Between them a line has a contrast of 3:1 (WCAG 1.4.11) with white and with the dark page.
_LIGHTEST, _DARKEST = 0.29, 0.14
_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
_DASHES = ("-", (0, (5, 2)), (0, (1, 1.3)), (0, (6, 2, 1, 2)), (0, (3, 1)), (0, (8, 3)))
_MARKERS = ("o", "s", "^", "D", "v", "P")


@dataclass(frozen=True, slots=True)
class MethodStyle:
    """How a source is drawn, whichever chart: never by colour alone."""

    name: str
    colour: str
    dash: Any
    marker: str


@dataclass(frozen=True, eq=False)
class ChartedMethod:
    """A source that has numbers to draw."""

    source: ReportedSource
    look: MethodStyle
    points: Points


def charted_sources(report: AuditReport, colours: Sequence[str]) -> list[ChartedMethod]:
    """The sources with scores; dashes and markers go by their place among all."""
    return [
        ChartedMethod(
            source,
            MethodStyle(
                source.marked_name,
                readable_on_both_themes(colours[i % len(colours)]),
                _DASHES[i % len(_DASHES)],
                _MARKERS[i % len(_MARKERS)],
            ),
            gather(list(source.audits.values())),
        )
        for i, source in enumerate(report.sources)
        if source.audits and (source in report.detailed)
    ]


def readable_on_both_themes(colour: str) -> str:
    """A colour ``#rrggbb`` as it is seen on the light and on the dark page, lines being thin.

    One that is too light or too dark is mixed with black or white as far as it takes.
    """
    linear = linear_rgb(colour)
    luminance = float(linear @ _LUMINANCE)
    if luminance > _LIGHTEST:
        linear = linear * (_LIGHTEST / luminance)
    elif luminance < _DARKEST:
        share = (_DARKEST - luminance) / (1 - luminance)
        linear = linear + share * (1 - linear)
    return hex_colour(linear)


def panels(figure: Figure, rows: int, *, between_in: float, top_in: float = 0.28) -> list[Axes]:
    """Small panels one below the other; matplotlib's own layout of many takes seconds."""
    size = figure.get_size_inches()
    boxes = panel_boxes(size, rows, 1, between_in=between_in, top_in=top_in)
    figure.set_layout_engine(None)
    return [figure.add_axes(tuple(box)) for box in boxes / np.tile(size, 2)]


def only_panel(figure: Figure) -> Axes:
    """One panel as large as the figure; without a title."""
    (axes,) = panels(figure, 1, between_in=0.0, top_in=0.08)
    return axes


def panel_boxes(
    size: Floats,
    rows: int,
    columns: int,
    *,
    between_in: float,
    top_in: float,
    bottom_in: float = 0.42,
) -> Floats:
    """Left, bottom, width and height (N, 4) of panels row by row; all in inches."""
    width, height = size
    left, right, beside = 0.6, 0.18, 0.14
    high = (height - top_in - bottom_in - between_in * (rows - 1)) / rows
    wide = (width - left - right - beside * (columns - 1)) / columns
    return np.array(
        [
            (
                left + column * (wide + beside),
                height - top_in - high - row * (high + between_in),
                wide,
                high,
            )
            for row in range(rows)
            for column in range(columns)
        ]
    )


def legend_above(figure: Figure, charted: Sequence[ChartedMethod]) -> None:
    """One legend for all panels."""
    from matplotlib.lines import Line2D

    lines = [Line2D([], [], **line_style(one.look)) for one in charted]
    figure.legend(handles=lines, loc="upper center", ncols=4, handlelength=4, borderaxespad=0.1)


def line_style(look: MethodStyle) -> dict[str, Any]:
    """How matplotlib is to draw the source's lines."""
    return {"color": look.colour, "ls": look.dash, "lw": 1.4, "label": chart_label(look.name)}


def chart_label(name: str) -> str:
    """A name as a label; matplotlib leaves out labels that begin with an underscore."""
    if len(name) > 40:
        end = next((f" ({mark})" for mark in MARKS if name.endswith(f" ({mark})")), "")
        name = f"{name.removesuffix(end)[: max(38 - len(end), 12)]}…{end}"
    return f" {name}" if name.startswith("_") else name
