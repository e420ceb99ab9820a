"""The comparison of two camera sources: tables, files, and pictures painted by who is handed in."""

from __future__ import annotations

import csv
import io
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import msgspec

from procc_annotator.errors import ImageError, InputError, SaveError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.atomic import write_atomic
from procc_annotator.metric.contours import OFFSIDE_ACCURACY_M
from procc_annotator.metric.disagreement import Disagreement
from procc_annotator.metric.legacy import Average
from procc_annotator.metric.spread import Spread
from procc_annotator.report.field_terms import field_terms
from procc_annotator.report.scores.score_files import score_format
from procc_annotator.report.scores.tables import percent_text
from procc_annotator.report.sheet.figure import DASH
from procc_annotator.session.runs.comparison_run import (
    CameraPair,
    ComparedFrame,
    ComparisonRun,
    ComparisonSummary,
    worst_frames,
)
from procc_annotator.words import count_of

if TYPE_CHECKING:
    from rich.table import Table

WORST = 10
FAR = 1000.0  # metres or px: whatever lies beyond says no more than this

# Figure of a frame -> its title, unit, and factor from the value.
LEGACY_ROWS: dict[str, tuple[str, str, float]] = {
    "iou_part": ("IoU part", "%", 100.0),
    "iou_whole": ("IoU whole", "%", 100.0),
    "projection_m": ("projection error", "m", 1.0),
    "reprojection": ("reprojection error, of image height", "%", 100.0),
    "six_point_rmse_cm": ("six points, root mean square", "cm", 1.0),
}

CSV_COLUMNS = (
    "name", "field", "width", "height",
    "metres_min", "metres_median", "metres_max", "pixels_min", "pixels_median", "pixels_max",
    "within_offside_accuracy", "compared_share",
    "iou_whole", "iou_part", "projection_m", "projection_lost",
    "reprojection", "reprojection_lost", "six_point_mse_cm2", "six_point_rmse_cm", "error",
)  # fmt: skip

Progress = Callable[[Iterable[ComparedFrame], int, str], Iterator[ComparedFrame]]


@dataclass(frozen=True)
class ComparisonScene:
    """Everything a disagreement picture shows.

    ``image_path`` is None where the dataset has no picture of the frame.
    """

    compared: ComparedFrame
    image_path: Path | None
    names: tuple[str, str]
    cameras: CameraPair
    disagreement: Disagreement
    field: Field


Paint = Callable[[ComparisonScene], bytes]
"""Turns a scene into an encoded picture; raises ImageError for one that cannot be decoded."""


@dataclass
class ComparisonReport:
    """A comparison, what has to be said about it, and what was written."""

    names: tuple[str, str]
    described: str
    summary: ComparisonSummary
    frames: list[ComparedFrame]
    errors: list[str] = field(default_factory=list)
    notices: Counter[str] = field(default_factory=Counter)
    pictures: list[Path] = field(default_factory=list)


def _no_progress(
    items: Iterable[ComparedFrame], _total: int, _what: str
) -> Iterator[ComparedFrame]:
    return iter(items)


def compare_sources(
    comparison: ComparisonRun, progress: Progress = _no_progress
) -> ComparisonReport:
    """Compare every frame.

    Args:
        comparison: what to compare.
        progress: wraps the frames as they come, given their number and a word for the work.

    Raises:
        UsageError: a source without ground, or no frame whose cameras can be read.
    """
    frames = list(progress(comparison, comparison.total, "comparing"))
    errors = [error for frame in frames for error in frame.errors]
    if all(frame.statistics is None for frame in frames):
        raise UsageError(
            f"of none of the {len(frames)} frames both cameras can be read; the first: {errors[0]}"
        )
    return ComparisonReport(
        (comparison.a.name, comparison.b.name),
        comparison.describe(),
        comparison.summary(),
        frames,
        errors,
        Counter(notice for frame in frames for notice in frame.notices),
    )


# -------------------------------------------------------------------------------------- pictures


def paint_frames(
    compared: ComparisonReport,
    comparison: ComparisonRun,
    out: Path,
    paint: Paint,
    *,
    pictures: dict[str, Path],
    count: int | None,
    suffix: str = ".png",
) -> Iterator[Path]:
    """Write the pictures of the frames that disagree most, yielding each file when it is there.

    Args:
        out: folder of the pictures, made if needed.
        pictures: frame name -> picture, of those frames that have one.
        count: how many; None for all.

    Raises:
        SaveError: a picture cannot be written.
        UsageError: the pictures would replace those of the dataset.
    """
    if any(path.parent.resolve() == out.resolve() for path in pictures.values()):
        raise UsageError(f"{out}: this is the dataset itself, choose another folder")
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise SaveError(f"{out}: cannot be made: {error.strerror or error}") from error
    for frame in worst_frames(compared.frames, count):
        try:
            cameras = comparison.cameras(frame.name)
            scene = ComparisonScene(
                frame,
                pictures.get(frame.name),
                compared.names,
                cameras,
                comparison.map_for_picture(cameras),
                comparison.field,
            )
            data = paint(scene)
        except (ImageError, InputError) as error:
            compared.errors.append(str(error))
            continue
        target = out / f"{frame.name}{suffix}"
        write_atomic(target, data)
        compared.pictures.append(target)
        yield target


# ---------------------------------------------------------------------------------------- tables


def disagreement_table(compared: ComparisonReport) -> Table:
    """Metres and pixels over the set."""
    summary = compared.summary
    a, b = compared.names
    count = count_of(summary.frames, "frame")
    table = _table(f"Disagreement of {a} and {b} in {count}", compared.described)
    table.add_column("")
    for heading in ("min", "median of frames", "max"):
        table.add_column(heading, justify="right")
    table.add_column(f"within {OFFSIDE_ACCURACY_M:g} m", justify="right")
    table.add_row("on the ground, m", *spread_cells(summary.metres), _share(summary.within))
    table.add_row("in the picture, px", *spread_cells(summary.pixels), "")
    return table


def legacy_table(compared: ComparisonReport) -> Table:
    """The metrics of earlier papers over the set."""
    a, b = compared.names
    table = _table(f"{b} against {a} as reference", compared.described)
    table.add_column("metric")
    for heading in ("mean", "median", "frames"):
        table.add_column(heading, justify="right")
    for name, (title, unit, factor) in LEGACY_ROWS.items():
        found = compared.summary.legacy.get(name, Average(None, None, 0))
        values = (shown_number(value, factor) for value in (found.mean, found.median))
        table.add_row(f"{title}, {unit}", *values, str(found.frames))
    return table


def worst_comparison_table(compared: ComparisonReport, count: int = WORST) -> Table:
    """The frames to look at first: largest median disagreement."""
    worst = worst_frames(compared.frames, count)
    shown = count_of(len(worst), "frame")
    table = _table(f"Largest disagreement, {shown}", compared.described)
    table.add_column("frame")
    for heading in (
        "min m", "median m", "max m", f"within {OFFSIDE_ACCURACY_M:g} m", "median px", "max px",
        "IoU part %", "IoU whole %", "projection m",
    ):  # fmt: skip
        table.add_column(heading, justify="right")
    for frame in worst:
        if frame.statistics is None or frame.legacy is None:
            continue
        metres, pixels, legacy = frame.statistics.metres, frame.statistics.pixels, frame.legacy
        table.add_row(
            frame.name,
            *spread_cells(metres),
            _share(frame.within),
            *spread_cells(pixels)[1:],
            percent_text(legacy.iou_part),
            percent_text(legacy.iou_whole),
            shown_number(legacy.projection_m),
        )
    return table


def spread_cells(spread: Spread) -> tuple[str, str, str]:
    """Least, median, largest with two decimals; dashes where there is none.

    Next to a horizon distances are as large as one likes: above `FAR` only that is said.
    """
    return shown_number(spread.minimum), shown_number(spread.median), shown_number(spread.maximum)


def shown_number(value: float | None, factor: float = 1.0) -> str:
    """A distance or a share with two decimals, as everywhere disagreement is told."""
    if value is None:
        return DASH
    number = factor * value
    return f"{number:.2f}" if number <= FAR else f"> {FAR:.0f}"


def _share(value: float | None) -> str:
    return DASH if value is None else f"{100 * value:.1f} %"


def _table(title: str, described: str) -> Table:
    from rich.table import Table
    from rich.text import Text

    heading = Text.assemble((title, "bold"), "  ", (f"({described})", "dim"))
    return Table(title=heading, title_justify="left", title_style="", header_style="bold")


# ----------------------------------------------------------------------------------------- files


def write_comparison(compared: ComparisonReport, comparison: ComparisonRun, path: Path) -> None:
    """Write every figure as JSON or CSV; the file appears when it is complete.

    Raises:
        UsageError: another suffix.
        SaveError: it cannot be written.
    """
    if score_format(path) == "json":
        write_atomic(path, _json(compared, comparison))
    else:
        write_atomic(path, _csv(compared, comparison))


def _json(compared: ComparisonReport, comparison: ComparisonRun) -> bytes:
    summary = compared.summary
    content = {
        **field_terms(comparison.field),
        "size": list(comparison.size),
        "a": {"name": compared.names[0], "path": str(comparison.a.path)},
        "b": {"name": compared.names[1], "path": str(comparison.b.path)},
        "offside_accuracy_m": OFFSIDE_ACCURACY_M,
        "images": [_entry(frame) for frame in compared.frames],
        "only_a": list(comparison.only_a),
        "only_b": list(comparison.only_b),
        "neither": list(comparison.neither),
        "summary": {
            "frames": summary.frames,
            "blank": list(summary.blank),
            "metres": asdict(summary.metres),
            "pixels": asdict(summary.pixels),
            "within_offside_accuracy": summary.within,
            "legacy": {name: asdict(average) for name, average in summary.legacy.items()},
        },
    }
    return msgspec.json.format(msgspec.json.encode(content), indent=1) + b"\n"


def _entry(frame: ComparedFrame) -> dict[str, Any]:
    entry: dict[str, Any] = {"name": frame.name, "errors": list(frame.errors)}
    if frame.statistics is not None and frame.legacy is not None:
        entry |= {
            "metres": asdict(frame.statistics.metres),
            "pixels": asdict(frame.statistics.pixels),
            "within_offside_accuracy": frame.within,
            "compared_share": frame.compared_share,
            "legacy": asdict(frame.legacy),
        }
    return entry


def _csv(compared: ComparisonReport, comparison: ComparisonRun) -> bytes:
    text = io.StringIO()
    rows = csv.DictWriter(text, CSV_COLUMNS, lineterminator="\n")
    rows.writeheader()
    terms = {
        "field": comparison.field.described,
        "width": comparison.size[0],
        "height": comparison.size[1],
    }
    for frame in compared.frames:
        row: dict[str, Any] = {"name": frame.name, "error": "; ".join(frame.errors)} | terms
        if frame.statistics is not None and frame.legacy is not None:
            for unit in ("metres", "pixels"):
                spread: Spread = getattr(frame.statistics, unit)
                row |= {
                    f"{unit}_min": spread.minimum,
                    f"{unit}_median": spread.median,
                    f"{unit}_max": spread.maximum,
                }
            row |= {
                "within_offside_accuracy": frame.within,
                "compared_share": frame.compared_share,
            }
            row |= asdict(frame.legacy)
        rows.writerow(row)
    return text.getvalue().encode()
