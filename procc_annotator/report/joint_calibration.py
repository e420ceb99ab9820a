"""Tables and CSV of joint adjustment: shared positions, stadium dimensions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

from procc_annotator.batch.joint_calibration import FieldSize, JointRun, SharedCameraPosition
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.report.tables.data_files import csv_bytes
from procc_annotator.report.tables.metrics import MEAN_ERROR, MEAN_JAC
from procc_annotator.report.tables.table import (
    Column,
    Metric,
    MetricTable,
    Row,
    count_column,
    metric_column,
    shortened,
)

POSITIONS_FILE = "positions.csv"
_AXES = "xyz"
_FRAMES_SHOWN = 20
_METRES = Metric("m", "m", "m")


def positions_csv(places: Sequence[SharedCameraPosition]) -> bytes:
    """A row a shared position: where it is, how surely, and how the frames' own positions lay."""
    kinds = ("", "sd_", "scatter_", "predicted_sd_")
    keys = [f"{kind}{axis}_m" for kind in kinds for axis in _AXES]
    columns = (
        Column("position"),
        count_column("frames"),
        *(Column(k, kind="number") for k in keys),
    )
    rows: tuple[Row, ...] = tuple(
        (place.name, place.frames, *(float(v) for of_kind in _axes(place) for v in of_kind))
        for place in places
    )
    return csv_bytes(MetricTable("positions", "", columns, rows))


def _axes(place: SharedCameraPosition) -> tuple[Iterable[float], ...]:
    """Position, its standard deviation, scatter and what was predicted, each along x, y and z."""
    found = place.tripod
    return found.position_m, found.deviations_m, found.scatter_m, found.predicted_m


def positions_table(run: JointRun) -> MetricTable:
    """The shared positions, and how the frames' own positions scattered before."""
    columns = (
        Column("position", "position"),
        count_column("frames"),
        Column("axis", "axis"),
        metric_column(_METRES, key="place", heading="place"),
        metric_column(_METRES, key="sd", joined=" ± {}"),
        metric_column(_METRES, key="scatter", heading="scatter"),
        metric_column(_METRES, key="predicted", heading="predicted"),
    )
    rows = tuple(
        (place.name, place.frames, axis, *map(float, along))
        for place in run.places
        for axis, *along in zip(_AXES, *_axes(place), strict=True)
    )
    notes = (
        "scatter: of the frames' own positions, standard deviation; predicted: what their fits"
        " said of it",
    )
    parts = tuple(range(len(_AXES), len(rows), len(_AXES)))
    return MetricTable("positions", "Shared positions (m)", columns, rows, notes=notes, parts=parts)


def before_after_table(
    before: Mapping[float, SetSummary], after: Mapping[float, SetSummary], words: tuple[str, str]
) -> MetricTable:
    """Return how a set scores one way and the other, on the points both were fitted to."""
    columns = (
        Column("way"), *(metric_column(MEAN_JAC, f"@{threshold:g}") for threshold in before),
        metric_column(MEAN_ERROR, heading="error px"), count_column("evaluated", "with camera"),
        count_column("images", joined=" of {}"),
    )  # fmt: skip
    rows = []
    for word, summaries in zip(words, (before, after), strict=True):
        first = next(iter(summaries.values()))
        jacs = (s.mean_jac for s in summaries.values())
        rows.append((word, *jacs, first.mean_error, first.evaluated, first.images))
    return MetricTable("before_after", "On the fitted points", columns, tuple(rows))


def not_shared_table(apart: Mapping[str, str]) -> MetricTable:
    """Frames that share no position and the reason, the first ones of many."""
    columns = (Column("frame", "frame"), Column("why", "why"))
    title = f"Own positions: {len(apart)}"
    return shortened(MetricTable("apart", title, columns, tuple(apart.items())), _FRAMES_SHOWN)


def field_sizes_table(sizes: Sequence[FieldSize], described: str) -> MetricTable:
    """The dimensions of every group's stadium, and the scores before and after."""
    thresholds = next((list(size.before) for size in sizes if size.before), [])
    scores = [
        *(metric_column(MEAN_JAC, f"@{tau:g}", key=f"jac@{tau:g}") for tau in thresholds),
        metric_column(replace(MEAN_ERROR, digits=3), key="error", heading="error px"),
    ]
    after = (replace(c, key=f"{c.key}_after", joined=" → {}") for c in scores)
    columns = (
        Column("group", "group"),
        Column("dimension", "dimension"),
        metric_column(_METRES, key="value", heading="value m"),
        Column("undetermined", joined=" ({})"),
        metric_column(_METRES, key="sd", heading="sd m"),
        count_column("frames"),
        count_column("of_frames", joined=" of {}"),
        Column("low", "range of the rules", "number"),
        Column("high", kind="number", joined=" to {}"),
        *(column for pair in zip(scores, after, strict=True) for column in pair),
    )
    rows: list[Row] = []
    for size in sizes:
        for number, found in enumerate(size.stadium.dimensions if size.stadium else ()):
            d, sure = found.dimension, found.is_determined
            shown = _scores(size) if number == 0 else (None,) * (2 * len(scores))
            rows.append((
                size.group, d.title, d.value, None if sure else "not determined",
                found.sd_m if sure else None, found.frames,
                size.stadium.frames if size.stadium else 0, d.minimum, d.maximum, *shown,
            ))  # fmt: skip
    if not any(row[0] for row in rows):
        columns, rows = columns[1:], [row[1:] for row in rows]
    notes = (f"{described}; JaC and error on the fitted points, before → after",)
    return MetricTable("dimensions", "Dimensions of the field", columns, tuple(rows), notes=notes)


def remarks(size: FieldSize) -> list[str]:
    """Return remarks on a group's dimensions, one line each."""
    where = f"{size.group}: " if size.group else ""
    if size.stadium is None:
        return [f"{where}{size.failure}"]
    return [f"{where}{remark}" for remark in size.stadium.remarks]


def _scores(size: FieldSize) -> Row:
    """Before and after, of JaC at each threshold and of the mean error."""
    pairs = [(size.before[tau].mean_jac, size.after[tau].mean_jac) for tau in size.before]
    first = next(iter(size.before))
    error = tuple(s[first].mean_error for s in (size.before, size.after))
    return tuple(value for pair in (*pairs, error) for value in pair)
