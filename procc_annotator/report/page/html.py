"""The report as one self-contained HTML page."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

from procc_annotator.errors import printable
from procc_annotator.messages import condensed
from procc_annotator.regular_file import read_head
from procc_annotator.report.page.chart_style import Chart
from procc_annotator.report.page.overlays import OverlayPicture
from procc_annotator.report.page.pairs import ReportedPair
from procc_annotator.report.page.report_data import AuditReport
from procc_annotator.report.page.report_tables import (
    classes_section,
    comparison_table,
    errors_table,
    every_frame_table,
    fits_table,
    frames_table,
    terms,
)
from procc_annotator.report.tables.metrics import FN, FP, JAC, TP
from procc_annotator.report.tables.table import (
    MetricTable,
    definitions,
    display_table,
)
from procc_annotator.resources import resources_dir

if TYPE_CHECKING:
    from jinja2 import Template


MOST_FAILURES = 200
MOST_FRAMES = 2000  # of the table of all frames

_GENERATOR = "procc-annotator report"  # stands in the page's head, within so many bytes
_HEAD = 2000


@dataclass(frozen=True, slots=True)
class Heading:
    """Head of a report.

    Attributes:
        title: of the report.
        date: as it is printed.
        settings: name and value of everything the figures and the choice of frames depend on.
        versions: name and version of the programs that made it.
    """

    title: str
    date: str
    settings: tuple[tuple[str, str], ...]
    versions: tuple[tuple[str, str], ...]


@dataclass(frozen=True, eq=False)
class Page:
    """Everything on the page besides the figures of the report itself.

    Attributes:
        charts: in their order.
        worst: source -> pictures of its worst frames, the worst first.
        lot: frame -> pictures of a frame drawn at random, one a source.
        pairs: disagreement of pairs of sources, with pictures.
        pair_tables: their tables.
        over_time, over_time_charts: how steady sources are over their shots, where that was asked.
        failures: what could not be used, besides what the report itself lists.
    """

    charts: Sequence[Chart] = ()
    worst: Sequence[tuple[str, Sequence[OverlayPicture]]] = ()
    lot: Sequence[tuple[str, Sequence[OverlayPicture]]] = ()
    pairs: Sequence[ReportedPair] = ()
    pair_tables: Sequence[MetricTable] = ()
    failures: Sequence[str] = ()
    over_time: Sequence[MetricTable] = ()
    over_time_charts: Sequence[Chart] = ()


def is_foreign_file(path: Path) -> bool:
    """Return whether there is a file, and no report wrote it."""
    try:
        return f'"{_GENERATOR}"'.encode() not in read_head(path, _HEAD)
    except FileNotFoundError:
        return False
    except OSError:  # a folder, or nothing that may be read
        return True


def report_html(report: AuditReport, heading: Heading, page: Page) -> bytes:
    """The page, UTF-8; the same input gives the same bytes."""
    failures = list(dict.fromkeys([*report.failures(), *page.failures]))
    notices = [
        (source.name, text, count)
        for source in report.sources
        for text, count in condensed(source.notices).items()
    ]
    tables = [comparison_table(report), fits_table(report), frames_table(report)]
    tables.append(errors_table(report))
    shown = [table for table in tables if table is not None]
    classes = classes_section(report)
    every = every_frame_table(report) if len(report.frames) <= MOST_FRAMES else None
    explained = [*shown, *report.statistics.sheets, *page.over_time, classes, *page.pair_tables]
    text = page_template("report.html").render(
        heading=heading,
        report=report,
        page=page,
        terms=terms(report),
        tables=shown,
        chance=report.statistics.sheets,
        classes=classes,
        frames=every,
        definitions=definitions(explained, also=(TP, FP, FN, JAC)),
        failures=failures[:MOST_FAILURES],
        more_failures=max(0, len(failures) - MOST_FAILURES),
        notices=notices,
    )
    return text.encode("utf-8", "replace")


@cache
def page_template(name: str) -> Template:
    """A template of the page; ``table.html`` has the macro of tables."""
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    sorting = (resources_dir() / "report" / "sort.js").read_text(encoding="utf-8")
    environment = Environment(
        loader=FileSystemLoader(resources_dir() / "report"),
        autoescape=True,
        undefined=StrictUndefined,
        finalize=lambda value: printable(value, keep="\n") if type(value) is str else value,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["shown"] = display_table
    environment.filters["data_uri"] = _data_uri
    environment.globals["generator"] = _GENERATOR
    environment.globals["sorting"] = sorting
    environment.globals["sorting_hash"] = b64encode(sha256(sorting.encode()).digest()).decode()
    return environment.get_template(name)


def _data_uri(picture: bytes, kind: str) -> str:
    return f"data:{kind};base64,{b64encode(picture).decode('ascii')}"
