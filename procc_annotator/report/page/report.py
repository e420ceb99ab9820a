"""Write the files of a report from a dataset and camera methods."""

from __future__ import annotations

import platform
from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from hashlib import sha256
from importlib import metadata
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.errors import UsageError, printable
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_source import FileSource
from procc_annotator.messages import condensed
from procc_annotator.regular_file import read_head
from procc_annotator.report.comparison import ComparisonScene
from procc_annotator.report.overlay_scene import Scene
from procc_annotator.report.page.charts import draw_charts, jitter_chart
from procc_annotator.report.page.findings import findings
from procc_annotator.report.page.overlays import OverlayDrawer, OverlayPicture, choose_frames
from procc_annotator.report.page.pairs import (
    Pairs,
    ReportedPair,
    disagreement_section,
    legacy_section,
)
from procc_annotator.report.page.report_data import AuditReport, ReportWork, without_folders
from procc_annotator.report.page.report_tables import (
    classes_section,
    comparison_table,
    errors_table,
    every_frame_table,
    fits_table,
    frames_table,
    report_csv,
    report_json,
    terms,
    without_intervals,
)
from procc_annotator.report.tables.data_files import latex_tables
from procc_annotator.report.tables.metrics import FN, FP, JAC, TP
from procc_annotator.report.tables.table import MetricTable, definitions, display_table
from procc_annotator.report.temporal import TemporalMetrics, breaks_table, terminal_tables
from procc_annotator.resources import resources_dir
from procc_annotator.version import __version__

if TYPE_CHECKING:
    from jinja2 import Template

REPORT_SUFFIXES = (".html", ".csv", ".json", ".tex")
_IN_COMPARISON = ("intervals", "ranks")  # columns of the page's first table
_COMPARED = ("differences", "held_out_differences")
_MOST_BREAKS = 100  # on the page; all are in the files
_MOST_FAILURES = 200
_MOST_FRAMES = 2000  # of the table of all frames
_GENERATOR = "procc-annotator report"  # in the page's head, within so many bytes
_HEAD = 2000
_LIBRARIES = ("numpy", "opencv-python-headless", "matplotlib", "PySide6-Essentials")


@dataclass(frozen=True, slots=True)
class ReportRequest:
    """Request for a report.

    Attributes:
        worst: frames a source to draw; lot: frames to draw at random, with ``seed``.
        disagreement: pairs of sources; pictures: how many of each.
        reference: the source that the metrics of earlier papers take as true; empty for none.
        manifest: name of the run manifest; empty for none.
        notes: further findings, such as what could not be measured.
    """

    title: str
    date: str
    worst: int = 4
    lot: int = 3
    seed: int = 1
    disagreement: tuple[tuple[str, str], ...] = ()
    pictures: int = 3
    reference: str = ""
    manifest: str = ""
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class ReportPainters:
    """Painters of one frame under one source and of the disagreement of two (None leaves these
    pictures out), and colours of a page."""

    overlays: Callable[[Scene], bytes]
    pairs: Callable[[ComparisonScene], bytes] | None
    colours: Sequence[str]


@dataclass(frozen=True)
class ReportInputs:
    """Inputs of figures and pictures.

    Attributes:
        cameras: of the report's sources, in their order.
        over_time: the sources over their shots; none unless that was asked.
    """

    annotations: FileSource
    cameras: Sequence[CameraSet]
    pictures: Mapping[str, Path]
    over_time: tuple[TemporalMetrics, ...] = ()


def report_kind(path: Path) -> str:
    """``html``, ``csv``, ``json`` or ``tex``, by suffix. `UsageError` for another suffix."""
    suffix = path.suffix.lower()
    if suffix not in REPORT_SUFFIXES:
        raise UsageError(
            f"{path}: a report is written as {', '.join(REPORT_SUFFIXES)}, end the name so"
        )
    return suffix[1:]


def check_request(request: ReportRequest, names: Sequence[str]) -> None:
    """Fail before the work, not after it. `UsageError` for a pair or a reference that names no
    source."""
    wanted = [name for pair in request.disagreement for name in pair]
    for name in [*wanted, *([request.reference] if request.reference else [])]:
        if name not in names:
            raise UsageError(f"there is no source called {name!r}: there are {', '.join(names)}")
    if any(a == b for a, b in request.disagreement):
        raise UsageError("a source never disagrees with itself: name two")


def write_report(
    report: AuditReport,
    material: ReportInputs,
    request: ReportRequest,
    drawing: ReportPainters | None,
    outputs: Sequence[Path],
    work: ReportWork,
) -> list[str]:
    """Write every file; each appears when it is complete.

    Args:
        drawing: needed for a page only.

    Returns:
        One line each for what could not be used when pictures were drawn.

    Raises:
        SaveError: a file cannot be written.
    """
    kinds = [report_kind(path) for path in outputs]
    setup = report.setup
    pairs = Pairs(
        material.cameras, setup.field, setup.size, report.frames, work.executor, work.progress
    )
    legacy = _legacy_pairs(request, report, pairs)
    disagreeing = tuple(pairs.compared(a, b) for a, b in request.disagreement)
    tables: list[MetricTable] = []
    if disagreeing:
        tables.append(disagreement_section(_marked(disagreeing, report)))
    if legacy:
        marked = _marked(legacy, report)
        tables.append(legacy_section(marked[0].a, marked))
    steady = terminal_tables(material.over_time) if material.over_time else []
    every_pair = tuple({(p.a, p.b): p for p in (*disagreeing, *legacy)}.values())
    problems = [problem for pair in every_pair for problem in pair.problems]
    problems += [f"{pair.a}, {pair.b}: {pair.failure}" for pair in every_pair if pair.failure]
    contents: dict[str, bytes] = {}
    if "csv" in kinds:
        contents["csv"] = report_csv(report)
    if "json" in kinds:
        contents["json"] = report_json(report, every_pair, material.over_time)
    if "tex" in kinds:
        contents["tex"] = _latex(report, request, [*steady, *tables])
    if "html" in kinds and drawing is not None:
        shown = _pictures(report, material, request, drawing, pairs, work)
        folders = [material.annotations.path, *(c.path for c in material.cameras)]
        folders += [path.parent for path in material.pictures.values()]
        named = without_folders(folders)
        problems = [named(problem) for problem in (*problems, *shown.pop("problems"))]
        contents["html"] = _html(
            report, request, problems, pair_tables=tables, **shown,
            **_over_time(material.over_time, steady, drawing.colours),
        )  # fmt: skip
    for path, kind in zip(outputs, kinds, strict=True):
        write_atomic(path, contents[kind])
    return list(dict.fromkeys(problems))


def _latex(report: AuditReport, request: ReportRequest, further: Sequence[MetricTable]) -> bytes:
    remarks = [request.title, request.date, terms(report), f"procc-annotator {__version__}"]
    remarks += [f"manifest: {request.manifest}"] if request.manifest else []
    fits = fits_table(report)
    comparison = without_intervals(comparison_table(report))  # these are tables of their own
    first = [comparison, *([fits] if fits else []), *report.statistics.sheets]
    return latex_tables([*first, *further], remarks).encode("utf-8", "backslashreplace")


def _marked(pairs: Sequence[ReportedPair], report: AuditReport) -> list[ReportedPair]:
    names = {source.name: source.marked_name for source in report.sources}
    return [replace(p, a=names.get(p.a, p.a), b=names.get(p.b, p.b)) for p in pairs]


def _over_time(
    found: Sequence[TemporalMetrics], tables: list[MetricTable], colours: Sequence[str]
) -> dict[str, Any]:
    """Tables and charts of temporal metrics, with the jumps and outages unless they are many."""
    if not found:
        return {"over_time": [], "over_time_charts": []}
    breaks = breaks_table(found, shown=True)
    more = [breaks] if 0 < len(breaks.rows) <= _MOST_BREAKS else []
    return {"over_time": [*tables, *more], "over_time_charts": [jitter_chart(found, colours)]}


def _html(report: AuditReport, request: ReportRequest, problems: list[str], **shown: Any) -> bytes:
    """The page, UTF-8; ``problems`` are files not used that the report does not list, ``shown``
    the charts, pictures and tables by their names in the template."""
    failures = list(dict.fromkeys([*report.failures(), *problems]))
    notices = [
        (source.name, text, count)
        for source in report.sources
        for text, count in condensed(source.notices).items()
    ]
    fits, sheets = fits_table(report), report.statistics.sheets
    tables = {
        "comparison": [comparison_table(report), *(s for s in sheets if s.name in _COMPARED)],
        "parts": [s for s in sheets if s.name not in _COMPARED and s.name not in _IN_COMPARISON],
        "classes": [classes_section(report), errors_table(report)],
        "frames": [frames_table(report)],
        "pairs": shown.pop("pair_tables"),
        "over_time": shown.pop("over_time"),
    }
    tables["comparison"][1:1] = [fits] if fits is not None else []
    told: set[str] = set()

    def untold(notes: Sequence[str]) -> list[str]:
        """Notes that no table above has."""
        new = [note for note in notes if note not in told]
        told.update(new)
        return new

    text = page_template("report.html").render(
        request=request,
        settings=_settings(report, request),
        report=report,
        terms=terms(report),
        tables=tables,
        findings=findings(report),
        untold=untold,
        every_frame=every_frame_table(report) if len(report.frames) <= _MOST_FRAMES else None,
        definitions=definitions(chain(*tables.values()), also=(TP, FP, FN, JAC)),
        failures=failures[:_MOST_FAILURES],
        more_failures=max(0, len(failures) - _MOST_FAILURES),
        notices=notices,
        **shown,
    )
    return text.encode("utf-8", "replace")


def is_foreign_file(path: Path) -> bool:
    """Return whether there is a file, and no report wrote it."""
    try:
        return f'"{_GENERATOR}"'.encode() not in read_head(path, _HEAD)
    except FileNotFoundError:
        return False
    except OSError:  # a folder, or nothing that may be read
        return True


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


def _data_uri(picture: bytes) -> str:
    return f"data:image/jpeg;base64,{b64encode(picture).decode('ascii')}"


def _settings(report: AuditReport, request: ReportRequest) -> list[tuple[str, str]]:
    """Name and value of everything the metrics depend on, and versions."""
    taus = ", ".join(f"{tau:g}" for tau in report.thresholds)
    settings = [
        ("Field", report.setup.field.title),
        ("Protocol, evaluation size", terms(report)),
        ("Thresholds", f"{taus} px; the first one leads"),
        *(
            (f"Source {source.name}", f"{source.folder} (format {source.format})")
            for source in report.sources
        ),
        ("Intervals", report.certainty.described),
        ("Worst frames a source", str(request.worst)),
        ("Random frames", f"{request.lot}, seed {request.seed}"),
    ]
    if len(report.detailed) < len(report.evaluated):
        few = f"the {len(report.detailed)} sources of {len(report.evaluated)} with the highest JaC"
        settings.append(("Shown in charts and pictures", few))
    if request.reference:
        settings.append(("Reference of the metrics of earlier papers", request.reference))
    versions = [("procc-annotator", __version__), ("Python", platform.python_version())]
    return settings + versions + [(name, _version(name)) for name in _LIBRARIES]


def _pictures(
    report: AuditReport,
    material: ReportInputs,
    request: ReportRequest,
    drawing: ReportPainters,
    pairs: Pairs,
    work: ReportWork,
) -> dict[str, Any]:
    """Charts, overlays and pairs by their names in the template, and problems with them."""
    charts = draw_charts(report, drawing.colours)
    chosen = choose_frames(report, request.worst, request.lot, request.seed)
    drawer = OverlayDrawer(
        report, material.annotations, material.cameras, material.pictures, drawing.overlays
    )
    sources = [source.name for source in report.detailed]
    worst = [(source, frame) for source, frames in chosen.worst.items() for frame in frames]
    lot = [(source, frame) for frame in chosen.random for source in sources]
    drawn_now = (drawer.draw(*one) for one in [*worst, *lot])
    total = len(worst) + len(lot)
    figures: list[OverlayPicture] = list(work.progress(drawn_now, total, "drawing"))
    shown = [
        ReportedPair(
            a,
            b,
            None,
            pairs.compared(a, b).described,
            pairs.pictures(a, b, request.pictures, drawing.pairs, material.pictures),
        )
        for a, b in request.disagreement
        if drawing.pairs is not None
    ]
    drawn, by_lot = figures[: len(worst)], figures[len(worst) :]
    return {
        "charts": charts,
        "worst": [(s, [f for f in drawn if f.source == s]) for s in chosen.worst] if drawn else [],
        "lot": [(n, [f for f in by_lot if f.frame == n]) for n in chosen.random],
        "pairs": shown,
        "problems": drawer.problems,
    }


def _legacy_pairs(
    request: ReportRequest, report: AuditReport, pairs: Pairs
) -> tuple[ReportedPair, ...]:
    if not request.reference:
        return ()
    others = [source.name for source in report.sources if source.name != request.reference]
    return tuple(pairs.compared(request.reference, other) for other in others)


def _version(library: str) -> str:
    try:
        return metadata.version(library)
    except metadata.PackageNotFoundError:
        return "not installed"
