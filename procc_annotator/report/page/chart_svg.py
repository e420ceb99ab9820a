"""Charts as SVG that stands within a page: its text is text, its ink the page's, its bytes stable.

matplotlib is imported when a chart is drawn; nobody else pays for it.
"""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
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
        number: tells the ids of the page's charts apart.
        title, text: see `Chart`; the title is also what a screen reader says.
        height_in: inches; the width is that of the page.
        draw: puts axes on an empty figure, laid out by constraint.
    """
    import warnings

    _load_undocumented()
    import matplotlib
    from matplotlib.backends.backend_svg import FigureCanvasSVG
    from matplotlib.figure import Figure

    # The settings of whoever runs this must not change the report.
    settings: Any = {
        key: value
        for key, value in matplotlib.rcParamsDefault.items()
        if not key.startswith("backend")
    }
    with warnings.catch_warnings(), matplotlib.rc_context(settings | _SETTINGS):
        # Names in scripts its own font lacks: whoever shows the page has a font for them.
        warnings.filterwarnings("ignore", message="Glyph")
        figure = Figure(figsize=(WIDTH_IN, height_in), dpi=72, layout="constrained")
        canvas: Any = FigureCanvasSVG(figure)
        draw(figure)
        # Laid out here, without the drawing on trial that saving a figure does for it.
        engine = figure.get_layout_engine()
        if engine is not None:
            engine.execute(figure)
            figure.set_layout_engine("none")
        stream = io.StringIO()
        canvas.print_svg(stream, metadata=dict.fromkeys(("Date", "Creator", "Format", "Type")))
    return Chart(_inline(stream.getvalue(), number, title), title, text)


@lru_cache(maxsize=1)
def _load_undocumented() -> None:
    """Load matplotlib without the docstrings of setters that it puts together for every artist: a
    third of what loading it takes, and nobody reads them here."""
    import matplotlib.artist as artists

    written = artists.kwdoc
    artists.kwdoc = lambda artist: ""
    try:
        import matplotlib.backends.backend_svg
        import matplotlib.figure  # noqa: F401
    finally:
        artists.kwdoc = written


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
    return f'{start} aria-label="{_attribute(title)}">{body}'


def _attribute(text: str) -> str:
    from html import escape

    return escape(text, quote=True)
