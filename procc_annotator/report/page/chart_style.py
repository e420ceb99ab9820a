"""Charts as inline SVG: shared style, legends, panel layout."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from procc_annotator.batch.audit import Points, gather
from procc_annotator.field.model import hex_colour, linear_rgb
from procc_annotator.formats.cameras.fit_record import MARKS
from procc_annotator.report.page.report_data import AuditReport, ReportedSource

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


WIDTH_IN = 7.1  # what an A4 page has between its margins

# Stand-ins that become the page's own colours, light or dark.
INK, FAINT = "#010203", "#040506"
_PAGE_COLOURS = {INK: "currentColor", FAINT: "var(--faint, #888888)"}

_SETTINGS: dict[str, Any] = {
    "svg.fonttype": "none",
    "svg.hashsalt": "procc-annotator",
    "font.size": 8.0,
    "axes.edgecolor": FAINT,
    "axes.labelcolor": INK,
    "axes.titlecolor": INK,
    "axes.titlesize": 8.5,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.linewidth": 0.6,
    "axes.facecolor": "none",
    "figure.facecolor": "none",
    "grid.color": FAINT,
    "grid.alpha": 0.3,
    "grid.linewidth": 0.5,
    "legend.frameon": False,
    "text.color": INK,
    "text.parse_math": False,  # names come from files: a dollar sign in one is no formula
    "xtick.color": FAINT,
    "ytick.color": FAINT,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
}


@dataclass(frozen=True, slots=True)
class Chart:
    """A drawn chart.

    Attributes:
        svg: an ``<svg>`` element.
        title: short. text: what to see in it, and how it was made.
    """

    svg: str
    title: str
    text: str


def draw_chart(
    number: int, title: str, text: str, height_in: float, draw: Callable[[Figure], None]
) -> Chart:
    """Draw a chart.

    Args:
        number: distinguishes the ids of the page's charts.
        title, text: see `Chart`; the title is also what a screen reader says.
        height_in: inches; the width is that of the page.
        draw: puts axes on an empty figure.
    """
    import warnings

    import matplotlib
    from matplotlib.backends.backend_svg import FigureCanvasSVG
    from matplotlib.figure import Figure

    # A matplotlibrc of the user must not change the report.
    settings: Any = {
        key: value
        for key, value in matplotlib.rcParamsDefault.items()
        if not key.startswith("backend")
    }
    with warnings.catch_warnings(), matplotlib.rc_context(settings | _SETTINGS):
        # Names in scripts that its own font lacks: the browser has a font for them.
        warnings.filterwarnings("ignore", message="Glyph")
        figure = Figure(figsize=(WIDTH_IN, height_in), dpi=72)
        canvas: Any = FigureCanvasSVG(figure)
        draw(figure)
        stream = io.StringIO()
        canvas.print_svg(stream, metadata=dict.fromkeys(("Date", "Creator", "Format", "Type")))
    return Chart(_inline(stream.getvalue(), number, title), title, text)


def _inline(svg: str, number: int, title: str) -> str:
    """Cut a file down to its element and make it one of a page."""
    svg = svg[svg.index("<svg") :].strip()
    head, _, body = svg.partition(">")
    found = re.search(r'viewBox="([^"]*)"', head)
    if found is None:
        raise ValueError("matplotlib wrote an SVG without a viewBox")
    body = re.sub(r"<metadata>.*?</metadata>\s*", "", body, flags=re.DOTALL)
    body = re.sub(r"<!--.*?-->\s*", "", body, flags=re.DOTALL)
    used = set(re.findall(r'(?:xlink:href="#|url\(#)([^")]+)', body))

    def own_id(match: re.Match[str]) -> str:
        return f' id="c{number}-{match[1]}"' if match[1] in used else ""

    body = re.sub(r' id="([^"]*)"', own_id, body)
    body = body.replace('xlink:href="#', f'href="#c{number}-').replace("url(#", f"url(#c{number}-")
    body = re.sub(r"font: (?:[a-z]+ )?([0-9.]+px) [^;\"]*", r"font-size: \1", body)
    body = re.sub(r"\n\s*", "\n", body)
    for stand_in, colour in _PAGE_COLOURS.items():
        body = body.replace(stand_in, colour)
    start = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{found[1]}" role="img"'
    return f'{start} aria-label="{escape(title)}">{body}'


# Between them a line has a contrast of 3:1 (WCAG 1.4.11) with white and with the dark page.
_LIGHTEST, _DARKEST = 0.29, 0.14
_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
_DASHES = ("-", (0, (5, 2)), (0, (1, 1.3)), (0, (6, 2, 1, 2)), (0, (3, 1)), (0, (8, 3)))
_MARKERS = ("o", "s", "^", "D", "v", "P")


@dataclass(frozen=True, eq=False)
class ChartedMethod:
    """A source that has numbers to draw, with its look in all charts: never by colour alone."""

    source: ReportedSource
    colour: str
    dash: Any
    marker: str
    points: Points

    @property
    def label(self) -> str:
        """Its name in charts."""
        return chart_label(self.source.marked_name)

    @property
    def line(self) -> dict[str, Any]:
        """Arguments of matplotlib for its lines."""
        return {"color": self.colour, "ls": self.dash, "lw": 1.4, "label": self.label}


def charted_sources(report: AuditReport, colours: Sequence[str]) -> list[ChartedMethod]:
    """The sources with scores; dashes and markers go by their place among all."""
    return [
        ChartedMethod(
            source,
            readable_on_both_themes(colours[i % len(colours)]),
            _DASHES[i % len(_DASHES)],
            _MARKERS[i % len(_MARKERS)],
            gather(list(source.audits.values())),
        )
        for i, source in enumerate(report.sources)
        if source.audits and source in report.detailed
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


def panels(
    figure: Figure, rows: int, columns: int = 1, *, between_in: float = 0.26, top_in: float = 0.28
) -> list[Axes]:
    """Add axes row by row; constrained layout of as many takes seconds."""
    width, height = figure.get_size_inches()
    left_in, right_in, bottom_in, beside_in = 0.6, 0.18, 0.45, 0.14
    high_in = (height - top_in - bottom_in + between_in) / rows - between_in
    wide_in = (width - left_in - right_in + beside_in) / columns - beside_in
    margins = {
        "left": left_in / width, "right": 1 - right_in / width,
        "bottom": bottom_in / height, "top": 1 - top_in / height,
        "hspace": between_in / high_in, "wspace": beside_in / wide_in,
    }  # fmt: skip
    found = figure.subplots(rows, columns, squeeze=False, gridspec_kw=margins)
    return list(found.flat)


def legend_above(figure: Figure, charted: Sequence[ChartedMethod]) -> None:
    """Add one legend for all panels."""
    from matplotlib.lines import Line2D

    lines = [Line2D([], [], **one.line) for one in charted]
    figure.legend(handles=lines, loc="upper center", ncols=4, handlelength=4, borderaxespad=0.1)


def chart_label(name: str) -> str:
    """A name as a label; matplotlib leaves out labels that begin with an underscore."""
    if len(name) > 40:
        end = name[len(name.rstrip("".join(MARKS))) :]
        name = f"{name[:37]}…{end}"
    return f" {name}" if name.startswith("_") else name
