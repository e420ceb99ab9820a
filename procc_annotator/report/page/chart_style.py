"""Charts as inline SVG: shared style, legends, panel layout."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.batch.audit import Points, gather
from procc_annotator.field.model import hex_colour, linear_rgb
from procc_annotator.formats.cameras.fit_record import MARKS
from procc_annotator.report.page.report_data import AuditReport, ReportedSource

if TYPE_CHECKING:
    from matplotlib.figure import Figure


WIDTH_IN = 3.6  # of a panel: two next to each other on A4, one on a phone

# Stand-ins that become the page's own colours, light or dark.
INK, FAINT = "#010203", "#040506"
_PAGE_COLOURS = {INK: "currentColor", FAINT: "var(--faint, #888888)"}

_SETTINGS: dict[str, Any] = {
    "svg.fonttype": "none",
    "svg.hashsalt": "procc-annotator",
    "font.size": 7.5,
    "axes.edgecolor": FAINT,
    "axes.labelcolor": INK,
    "axes.titlecolor": INK,
    "axes.titlesize": 8.0,
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
        svgs: an ``<svg>`` element for each panel.
        title: short. text: what to see in it, and how it was made.
        part: of the page: curves, errors or frames.
    """

    svgs: tuple[str, ...]
    title: str
    text: str
    part: str = ""


@dataclass(frozen=True)
class Panel:
    """A panel of a chart: a picture of its own, so that a narrow page stacks them.

    Attributes:
        title: above them; empty for none. height_in, left_in: of the panel and its left margin.
    """

    draw: Callable[[Any], None]
    title: str = ""
    height_in: float = 2.3
    polar: bool = False
    left_in: float = 0.55


@contextmanager
def drawing_settings(own: dict[str, Any]) -> Iterator[None]:
    """Draw with these settings of matplotlib and its defaults: a matplotlibrc of the user must not
    change what comes out. Scripts that the font lacks are no warning."""
    import warnings

    import matplotlib

    usual: Any = {
        k: v for k, v in matplotlib.rcParamsDefault.items() if not k.startswith("backend")
    }
    with warnings.catch_warnings(), matplotlib.rc_context(usual | own):
        warnings.filterwarnings("ignore", message="Glyph")  # the browser has a font for them
        yield


def draw_chart(number: int, title: str, text: str, panels: Sequence[Panel]) -> Chart:
    """Draw a chart of at least one panel; ``number`` distinguishes the ids of the page's charts,
    and a screen reader says the title."""
    from matplotlib.backends.backend_svg import FigureCanvasSVG

    svgs = []
    with drawing_settings(_SETTINGS):
        for place, panel in enumerate(panels):
            canvas: Any = FigureCanvasSVG(panel_figure(panel))
            stream = io.StringIO()
            canvas.print_svg(stream, metadata=dict.fromkeys(("Date", "Creator", "Format", "Type")))
            called = f"{title}: {panel.title}" if panel.title else title
            svgs.append(_inline(stream.getvalue(), f"c{number}-{place}", called))
    return Chart(tuple(svgs), title, text)


def panel_figure(panel: Panel) -> Figure:
    """A figure with the axes of a panel; constrained layout would take seconds."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(WIDTH_IN, panel.height_in), dpi=72)
    top, bottom = (0.3, 0.42) if not panel.polar else (0.62, 0.25)
    left, right = panel.left_in, 0.12
    high = panel.height_in - bottom - (top if panel.title else 0.1)
    size = (1 - (left + right) / WIDTH_IN, high / panel.height_in)
    place = (left / WIDTH_IN, bottom / panel.height_in, *size)
    axes: Any = figure.add_axes(place, projection="polar" if panel.polar else None)
    if panel.title:
        axes.set_title(chart_label(panel.title), y=1.0, **({"pad": 18} if panel.polar else {}))
    panel.draw(axes)
    return figure


def _inline(svg: str, prefix: str, title: str) -> str:
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
        return f' id="{prefix}-{match[1]}"' if match[1] in used else ""

    body = re.sub(r' id="([^"]*)"', own_id, body)
    body = body.replace('xlink:href="#', f'href="#{prefix}-').replace("url(#", f"url(#{prefix}-")
    body = re.sub(r"font: (?:[a-z]+ )?([0-9.]+px) [^;\"]*", r"font-size: \1", body)
    body = re.sub(r"font-family: [^;\"]*; ?", "", body)  # the page's
    body = re.sub(r"\s*\n\s*", "\n", body)
    body = re.sub(r'"[^"<>]*"', lambda m: re.sub(r"(\.\d\d)\d+", r"\1", m[0]), body)  # 0.01 pt
    for stand_in, colour in _PAGE_COLOURS.items():
        body = body.replace(stand_in, colour)
    start = f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{found[1]}" role="img"'
    return f'{start} aria-label="{escape(title)}">{body}'


# Between them a line has a contrast of 3:1 (WCAG 1.4.11) with white and with the dark page.
_LIGHTEST, _DARKEST = 0.29, 0.14
_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
_DASHES = ("-", (0, (5, 2)), (0, (1, 1.3)), (0, (6, 2, 1, 2)), (0, (3, 1)), (0, (8, 3)))
_FEW = 50  # values, all of which are shown
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


def inner_range(values: Sequence[FloatArray]) -> tuple[tuple[float, float] | None, int]:
    """Limits of an axis that leave out the outer hundredths of each row of many values, and how
    many values lie beyond; None if nothing does."""
    known = [row[np.isfinite(row)] for row in values]
    ends = [
        np.quantile(row, (0.01, 0.99) if len(row) >= _FEW else (0, 1)) for row in known if len(row)
    ]
    if not ends:
        return None, 0
    low, high = min(end[0] for end in ends), max(end[1] for end in ends)
    margin = 0.08 * (high - low) or 1.0
    low, high = float(low - margin), float(high + margin)
    beyond = sum(int(((row < low) | (row > high)).sum()) for row in known)
    return ((low, high), beyond) if beyond else (None, 0)


def chart_label(name: str) -> str:
    """A name as a label; matplotlib leaves out labels that begin with an underscore."""
    if len(name) > 40:
        end = name[len(name.rstrip("".join(MARKS))) :]
        name = f"{name[:37]}…{end}"
    return f" {name}" if name.startswith("_") else name
