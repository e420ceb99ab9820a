"""Temporal stability tables: shots, frames, jumps and outages."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from procc_annotator.batch.execution.executor import Executor
from procc_annotator.batch.grouping import ShotFrames
from procc_annotator.batch.temporal import OverTimeRun, ShotOverTime, require_shots
from procc_annotator.formats.cameras.fit_record import FITTED_KEYS, NOT_FITTED, name_with_mark
from procc_annotator.messages import pluralize
from procc_annotator.metrics.temporal.discontinuities import FrameOffset
from procc_annotator.metrics.temporal.jitter import shot_rms
from procc_annotator.report.scores.score_files import score_format
from procc_annotator.report.scores.scoring import EvaluationRequest
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes, table_entry
from procc_annotator.report.tables.table import (
    Column,
    MetricTable,
    Value,
    count_column,
    metric_column,
)

_OF_SHOT = (
    Column("set", "set"),
    Column("source", "source"),
    Column("shot", "shot"),
    count_column("frames"),
    *map(count_column, FITTED_KEYS[:2]),  # of so many frames
    metric_column(metrics.MEAN_JAC),
    metric_column(metrics.JITTER_PX),
    metric_column(metrics.JITTER_M),
    *(metric_column(figure) for figure in metrics.POSE_JITTER),
    count_column("jumps"),
    count_column("jumps_that_stay", "stay"),
    count_column("outages"),
    count_column("longest_outage", "longest"),
    metric_column(metrics.OUTAGE_SHARE),
    Column("back_after", "back after", "number"),
    Column("offset", "offset"),
    count_column("offset_frames", "frames late"),
    Column("offset_sure", "sure", "yes_no"),
    metric_column(metrics.OFFSET_COST),
    metric_column(metrics.OFFSET_AS_IS),
    metric_column(metrics.OFFSET_MARGIN),
    Column("picture_offset", "offset of pictures"),
    count_column("picture_offset_frames", "frames late"),
    Column("picture_offset_sure", "sure", "yes_no"),
    metric_column(metrics.OFFSET_MARGIN, key="picture_offset_margin_px"),
)
_SHOWN = (
    (
        "set", "source", "shot", "frames", "mean_jac", "jitter_px", "jitter_m", "jumps",
        "outages", "longest_outage", "outage_share", "back_after",
    ),
    (
        "set", "source", "shot", "jitter_pan_degrees", "jitter_tilt_degrees",
        "jitter_zoom", "jitter_position_m",
    ),
    (
        "set", "source", "shot", "offset", "offset_cost_px", "offset_cost_as_is_px",
        "offset_margin_px", "picture_offset", "picture_offset_margin_px",
    ),
)  # fmt: skip
_TITLES = ("Over time", "Over time: poses", "Over time: are cameras late?")

_OF_FRAME = (
    Column("set", "set"),
    Column("source", "source"),
    Column("shot", "shot"),
    Column("frame", "frame"),
    count_column("number"),
    Column("camera", "camera", "yes_no"),
    *(Column(key, kind="yes_no") for key in FITTED_KEYS[:2]),
    metric_column(metrics.JAC),
    metric_column(metrics.STEP_PX),
    metric_column(metrics.JITTER_PX),
    metric_column(metrics.JITTER_M),
    Column("jump", "jump", "yes_no"),
    *(
        Column(key, key, "number")
        for key in (
            "pan_degrees", "tilt_degrees", "roll_degrees", "focal_px", "x_m", "y_m", "z_m",
        )
    ),
)  # fmt: skip

_OF_BREAK = (
    Column("set", "set"),
    Column("source", "source"),
    Column("shot", "shot"),
    Column("frame", "frame"),
    Column("what", "what"),
    Column("size_px", "px", "number", written=".2f"),
    count_column("length", "frames"),
    count_column("back_after", "back after"),
)


@dataclass(frozen=True, eq=False)
class TemporalMetrics:
    """One source of cameras over the shots of a set.

    Attributes:
        told_by: what says which frames follow each other.
        described: protocol, size and options, in words.
        threshold: px, of JaC.
    """

    set_name: str
    source: str
    shots: tuple[ShotOverTime, ...]
    told_by: str
    described: str
    threshold: float

    @property
    def marked_name(self) -> str:
        """Its name as tables and charts give it next to others."""
        return name_with_mark(self.source, sum((shot.fits for shot in self.shots), NOT_FITTED))

    @property
    def errors(self) -> list[str]:
        """Return what could not be read, one line each."""
        return [error for one in self.shots for error in one.errors]


def terms_over_time(found: Sequence[TemporalMetrics]) -> str:
    """Protocol, size and options behind the figures; of several sources what goes for all."""
    return min((one.described for one in found), key=len)


def measure_over_time(
    one: EvaluationRequest,
    known: tuple[Sequence[ShotFrames], str, Mapping[str, Path]],
    threshold: float,
    executor: Executor,
    progress: Callable[[int, int], None] = lambda _done, _total: None,
) -> TemporalMetrics:
    """Measure a source over the shots of a set; ``known``: the shots, what says so, and pictures by
    frame; the threshold, px, is that of JaC. `UsageError` for frames that do not follow each
    other."""
    shots, told_by, pictures = known
    run = OverTimeRun(
        shots, one.annotations, one.cameras, one.setup, threshold,
        camera_size=one.camera_size, pictures=pictures, executor=executor,
    )  # fmt: skip
    measured = []
    for shot in run:
        measured.append(shot)
        progress(len(measured), run.total)
    require_shots(measured, told_by)
    described = one.setup.describe(any(shot.ground_only for shot in measured))
    return TemporalMetrics(one.set_name, one.method, tuple(measured), told_by, described, threshold)


def shots_over_time_table(found: Sequence[TemporalMetrics]) -> MetricTable:
    """Every figure: a row a source and shot; above those of several shots one of all of them."""
    rows: list[tuple[Value, ...]] = []
    for one in found:
        if len(one.shots) > 1:
            rows.append(_all_shots_row(one))
        rows += [_shot_row(one, shot) for shot in one.shots]
    first = found[0]
    described = f"{terms_over_time(found)}, JaC@{first.threshold:g}, shots {first.told_by}"
    notes = (
        "Jitter: second differences as the error of one frame; what the camera itself does by fits"
        " and starts counts for every source alike.",
        *(
            ("Positions of homographies are implied: square pixels, a centred lens.",)
            if any(shot.poses.implied for one in found for shot in one.shots)
            else ()
        ),
    )
    return MetricTable("over_time", "Over time", _OF_SHOT, tuple(rows), described, notes)


def terminal_tables(found: Sequence[TemporalMetrics]) -> list[MetricTable]:
    """The same in tables that fit a terminal; columns that say nothing are left out, and a source
    that was fitted to the clicks is marked."""
    whole_sheet = shots_over_time_table(found)
    keys = [column.key for column in whole_sheet.columns]
    marked = {(one.set_name, one.source): one.marked_name for one in found}
    named = [(row[0], marked[str(row[0]), str(row[1])], *row[2:]) for row in whole_sheet.rows]
    parts = []
    for number, (title, chosen) in enumerate(zip(_TITLES, _SHOWN, strict=True)):
        places = [keys.index(key) for key in chosen]
        kept = [
            at
            for at in places
            if at < 4 or any(row[at] not in (None, "") for row in whole_sheet.rows)
        ]
        if len({row[0] for row in whole_sheet.rows}) < 2:
            kept.remove(0)
        rows = tuple(tuple(row[at] for at in kept) for row in named)
        columns = tuple(whole_sheet.columns[at] for at in kept)
        described = "" if number else whole_sheet.described
        notes = () if number else whole_sheet.notes
        if any(at > 3 for at in kept):
            parts.append(MetricTable(f"over_time_{number}", title, columns, rows, described, notes))
    return parts


def frames_over_time_table(found: Sequence[TemporalMetrics]) -> MetricTable:
    """A row a source and frame."""
    rows = [row for one in found for shot in one.shots for row in _frame_rows(one, shot)]
    return MetricTable("over_time_frames", "Frames over time", _OF_FRAME, tuple(rows))


def breaks_table(found: Sequence[TemporalMetrics], *, shown: bool = False) -> MetricTable:
    """A row a jump or outage, in the order of the frames; where it is shown, a source that was
    fitted to the clicks is marked."""
    rows: list[tuple[Value, ...]] = []
    for one in found:
        for shot in one.shots:
            names = shot.shot.frames
            events: list[tuple[int, tuple[Value, ...]]] = [
                (j.frame, ("jump", j.size_px, None, j.back_after)) for j in shot.broken.jumps
            ]
            events += [
                (o.frame, ("outage", None, o.length, o.back_after)) for o in shot.broken.outages
            ]
            name = one.marked_name if shown else one.source
            rows += [
                (one.set_name, name, shot.shot.name, names[at], *rest)
                for at, rest in sorted(events, key=lambda event: event[0])
            ]
    return MetricTable("over_time_breaks", "Jumps and outages", _OF_BREAK, tuple(rows))


def over_time_bytes(found: Sequence[TemporalMetrics], path: Path) -> bytes:
    """A file of figures over time: as JSON all of them, as CSV a row a source and frame.
    `UsageError` for another suffix."""
    if score_format(path) == "json":
        return json_bytes(over_time_entries(found))
    return csv_bytes(frames_over_time_table(found))


def over_time_entries(found: Sequence[TemporalMetrics]) -> dict[str, Any]:
    """All figures over time, for a file: shots, jumps and outages, frames."""
    sheets = (shots_over_time_table(found), breaks_table(found), frames_over_time_table(found))
    return {sheet.name: table_entry(sheet) for sheet in sheets}


# --- rows -----------------------------------------------------------------------------------------


def _shot_row(one: TemporalMetrics, shot: ShotOverTime) -> tuple[Value, ...]:
    pose, broken = shot.pose_jitter, shot.broken
    ends = [jump.back_after for jump in broken.jumps] + [o.back_after for o in broken.outages]
    backs = [frames for frames in ends if frames is not None]
    return (
        one.set_name,
        one.source,
        shot.shot.name,
        len(shot.shot.frames),
        *shot.fits.values[:2],
        shot.mean_jac,
        shot.jitter_px,
        shot.jitter_m,
        pose.pan_deg, pose.tilt_deg, pose.roll_deg, pose.zoom, pose.position_m,
        len(broken.jumps),
        sum(jump.back_after is None for jump in broken.jumps),
        len(broken.outages),
        max((outage.length for outage in broken.outages), default=0),
        shot.outage_share,
        median(backs) if backs else None,
        *_offset_values(shot.offset, costs=True),
        *_offset_values(shot.picture_offset, costs=False),
    )  # fmt: skip


def _offset_values(offset: FrameOffset | None, *, costs: bool) -> tuple[Value, ...]:
    if offset is None:
        return (None,) * (6 if costs else 4)
    shift = offset.shift if offset.is_sure else None
    more = (offset.cost_px, offset.cost_as_is_px) if costs else ()
    return offset.in_words, shift, offset.is_sure, *more, offset.margin_px


def _all_shots_row(one: TemporalMetrics) -> tuple[Value, ...]:
    """Over the frames of all shots together; what belongs to a shot alone is left open."""
    shots = one.shots
    row: dict[str, Any] = dict.fromkeys((column.key for column in _OF_SHOT), None)
    frames = sum(len(shot.shot.frames) for shot in shots)
    jac = np.concatenate([shot.jac for shot in shots])
    left_out = np.concatenate([shot.broken.unsteady for shot in shots])
    row |= {
        "set": one.set_name,
        "source": one.source,
        "shot": f"all {pluralize(len(shots), 'shot')}",
        "frames": frames,
        **dict.fromkeys(FITTED_KEYS[:2], 0),
        **sum((shot.fits for shot in shots), NOT_FITTED).entry(),
        "mean_jac": float(np.nanmean(jac)) if np.isfinite(jac).any() else None,
        "jitter_px": shot_rms(np.concatenate([shot.steady.px for shot in shots]), left_out),
        "jitter_m": shot_rms(np.concatenate([shot.steady.ground_m for shot in shots]), left_out),
        "outage_share": sum(shot.outage_share * len(shot.shot.frames) for shot in shots) / frames,
    }
    for key in ("jumps", "outages"):
        row[key] = sum(len(getattr(shot.broken, key)) for shot in shots)
    return tuple(row[column.key] for column in _OF_SHOT)


def _frame_rows(one: TemporalMetrics, shot: ShotOverTime) -> list[tuple[Value, ...]]:
    poses = shot.poses
    gone = np.zeros(len(shot.shot.frames), dtype=bool)
    for outage in shot.broken.outages:
        gone[outage.frame : outage.frame + outage.length] = True
    numbers = np.column_stack(
        (
            shot.jac, shot.steady.step_px, shot.steady.px, shot.steady.ground_m, poses.pan_deg,
            poses.tilt_deg, poses.roll_deg, np.exp(poses.log_focal), poses.position_world,
        )
    )  # fmt: skip
    rows: list[tuple[Value, ...]] = []
    for at, (name, number) in enumerate(zip(shot.shot.frames, shot.shot.numbers, strict=True)):
        values = [float(v) if np.isfinite(v) else None for v in numbers[at]]
        named = (one.set_name, one.source, shot.shot.name, name, number)
        known = (not gone[at], *shot.fitted[at].of_frame[:2])
        rows.append((*named, *known, *values[:4], bool(shot.broken.unsteady[at]), *values[4:]))
    return rows
