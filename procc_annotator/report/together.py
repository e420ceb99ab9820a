"""What fitting frames together found, as tables on the terminal and as CSV."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rich.table import Table

from procc_annotator.metric.sets import SetSummary
from procc_annotator.report.camera_tables import csv_bytes
from procc_annotator.report.sheet.figure import DASH
from procc_annotator.session.runs.together_run import FieldSize, SharedPlace, SharedRun

POSITIONS_FILE = "positions.csv"
_AXES = "xyz"
_FRAMES_SHOWN = 20


def positions_csv(places: Sequence[SharedPlace]) -> bytes:
    """A row a shared position: where it is, how surely, and how the frames' own positions lay."""
    kinds = ("", "sd_", "scatter_", "predicted_sd_")
    header = ["position", "frames", *(f"{kind}{axis}_m" for kind in kinds for axis in _AXES)]
    rows: list[list[object]] = [
        [
            place.name,
            place.frames,
            *(float(v) for v in place.tripod.position_m),
            *(float(v) for v in place.tripod.deviations_m),
            *(float(v) for v in place.tripod.scatter_m),
            *(float(v) for v in place.tripod.predicted_m),
        ]
        for place in places
    ]
    return csv_bytes([header, *rows])


def positions_table(run: SharedRun) -> Table:
    """The shared positions, and how the frames' own positions scattered before."""
    table = Table(
        title="Shared positions (m)",
        caption="scatter: of the frames' own positions, standard deviation; predicted: what their"
        " fits said of it",
        title_justify="left",
        caption_justify="left",
    )
    table.add_column("position")
    table.add_column("frames", justify="right")
    table.add_column("axis")
    for heading in ("place", "scatter", "predicted"):
        table.add_column(heading, justify="right")
    for place in run.places:
        tripod = place.tripod
        of_axes = zip(
            _AXES,
            tripod.position_m,
            tripod.deviations_m,
            tripod.scatter_m,
            tripod.predicted_m,
            strict=True,
        )
        for axis, at, sd, own, said in of_axes:
            named = (place.name, str(place.frames)) if axis == _AXES[0] else ("", "")
            table.add_row(*named, axis, f"{at:.2f} ± {sd:.2f}", f"{own:.2f}", f"{said:.2f}")
        table.add_section()
    return table


def before_after_table(
    before: Mapping[float, SetSummary], after: Mapping[float, SetSummary], words: tuple[str, str]
) -> Table:
    """How a set scores one way and the other, on the points both were fitted to."""
    table = Table(title="On the fitted points", title_justify="left")
    table.add_column("")
    for threshold in before:
        table.add_column(f"JaC@{threshold:g} %", justify="right")
    table.add_column("error px", justify="right")
    table.add_column("with camera", justify="right")
    for word, summaries in zip(words, (before, after), strict=True):
        first = next(iter(summaries.values()))
        table.add_row(
            word,
            *(_percent(s.mean_jac) for s in summaries.values()),
            DASH if (error := first.mean_error) is None else f"{error:.2f}",
            f"{first.evaluated} of {first.images}",
        )
    return table


def apart_table(apart: Mapping[str, str]) -> Table:
    """Frames that share no position and the reason, the first ones of many."""
    table = Table(title=f"Own positions: {len(apart)}", title_justify="left")
    table.add_column("frame")
    table.add_column("why")
    for name, why in list(apart.items())[:_FRAMES_SHOWN]:
        table.add_row(name, why)
    if len(apart) > _FRAMES_SHOWN:
        table.add_row("...", f"{len(apart) - _FRAMES_SHOWN} more")
    return table


def field_sizes_table(sizes: Sequence[FieldSize], described: str) -> Table:
    """The dimensions of every group's stadium, and the scores before and after."""
    several = len(sizes) > 1 or any(size.group for size in sizes)
    table = Table(
        title="Dimensions of the field",
        caption=f"{described}; JaC and error on the fitted points, before → after",
        title_justify="left",
        caption_justify="left",
    )
    if several:
        table.add_column("group")
    for heading in ("dimension", "value m", "sd m", "frames", "range of the rules"):
        table.add_column(heading, justify="left" if heading == "dimension" else "right")
    thresholds = next((list(size.before) for size in sizes if size.before), [])
    for threshold in thresholds:
        table.add_column(f"JaC@{threshold:g} %", justify="right")
    table.add_column("error px", justify="right")
    for size in sizes:
        group = [size.group or DASH] if several else []
        for row, found in enumerate(size.stadium.dimensions if size.stadium else ()):
            d = found.dimension
            scores = _scores(size) if row == 0 else [""] * (len(thresholds) + 1)
            table.add_row(
                *(group if row == 0 else [""] * len(group)),
                d.title,
                f"{d.value:.2f}" if found.is_determined else f"({d.value:.1f})",
                f"{found.sd_m:.2f}" if found.is_determined else "not determined",
                f"{found.frames} of {size.stadium.frames if size.stadium else 0}",
                f"{d.minimum:g} to {d.maximum:g}",
                *scores,
            )
    return table


def remarks(size: FieldSize) -> list[str]:
    """What to know of a group's dimensions, one line each."""
    where = f"{size.group}: " if size.group else ""
    if size.stadium is None:
        return [f"{where}{size.failure}"]
    return [f"{where}{remark}" for remark in size.stadium.remarks]


def _scores(size: FieldSize) -> list[str]:
    pairs = [
        f"{_percent(size.before[t].mean_jac)} → {_percent(size.after[t].mean_jac)}"
        for t in size.before
    ]
    first = next(iter(size.before))
    errors = [s[first].mean_error for s in (size.before, size.after)]
    shown = [DASH if error is None else f"{error:.3f}" for error in errors]
    return [*pairs, " → ".join(shown)]


def _percent(share: float | None) -> str:
    return DASH if share is None else f"{100 * share:.2f}"
