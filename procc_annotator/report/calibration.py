"""Calibrated cameras as files, CSV and terminal tables."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from natsort import natsorted

from procc_annotator.batch.calibration import Calibrated, CalibrationRun
from procc_annotator.batch.execution.executor import Progress
from procc_annotator.batch.joint_calibration import JointRun
from procc_annotator.batch.scoring import passed
from procc_annotator.calibration.result import PoseStandardDeviations
from procc_annotator.formats.cameras.fit_record import (
    COLUMNS,
    DIGEST,
    LEFT_OUT_FILE,
    TABLE_FILE,
    LeftOutElement,
    camera_hash,
)
from procc_annotator.formats.file_listing import CAMERA_PREFIX, camera_names
from procc_annotator.messages import pluralize
from procc_annotator.metrics.official import fold_back_warnings
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.report.outputs import Interrupted, is_archive, open_target
from procc_annotator.report.scores.score_tables import FrameRow, WorstFrames
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_bytes
from procc_annotator.report.tables.table import (
    TAU,
    Column,
    MetricTable,
    Row,
    count_column,
    metric_column,
    shortened,
)

DEVIATION_COLUMNS = tuple(map(metric_column, metrics.DEVIATIONS))


def deviation_values(deviations: PoseStandardDeviations | None) -> tuple[float | None, ...]:
    """Standard deviations in the order of `DEVIATION_COLUMNS`: degrees, px, metres."""
    if deviations is None:
        return (None,) * len(DEVIATION_COLUMNS)
    angles = (deviations.pan_rad, deviations.tilt_rad, deviations.roll_rad)
    return (*map(math.degrees, angles), deviations.focal_px, *deviations.position_m)


_FAILURES_SHOWN = 20


@dataclass
class CalibrationReport:
    """Summary of a calibrated set.

    Attributes:
        described: model, protocol and size, to stand next to every figure.
        frames, cameras: number of readable annotations, and of cameras written.
        failures: frames without a camera, and why.
        errors: annotations that cannot be read, one line each.
        left_out: number of frames with an element that was taken for a mistake.
        stale: cameras of earlier runs: of these frames but of another kind, or of other frames.
        open: frames whose cameras the points hardly determine.
        folded: frames whose cameras the official evaluation folds into the picture.
        held_out: elements left out in turn, of all frames.
        remarks: on the sizes of the pictures, and on these, one line each.
    """

    described: str = ""
    frames: int = 0
    cameras: int = 0
    summaries: dict[float, SetSummary] = field(default_factory=dict)
    worst: list[FrameRow] = field(default_factory=list)
    failures: list[tuple[str, str]] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)
    left_out: int = 0
    deviations: list[tuple[float | None, ...]] = field(default_factory=list)
    stale: list[str] = field(default_factory=list)
    open: list[str] = field(default_factory=list)
    folded: list[str] = field(default_factory=list)
    remarks: list[str] = field(default_factory=list)
    held_out: list[LeftOutElement] = field(default_factory=list)


def calibrate_set(
    run: CalibrationRun | JointRun,
    out: Path,
    progress: Progress[Calibrated],
    more: Mapping[str, bytes] | None = None,
    *,
    hold_out: bool = False,
) -> CalibrationReport:
    """Calibrate a set, write its cameras and the table of figures.

    Every file appears in one step, whole; an archive only when all of it is written.

    Args:
        out: folder, or archive if the name ends in .zip.
        more: further files for OUT, by name.
        hold_out: whether the table lists elements left out.

    Raises:
        SaveError: writing failed.
        Interrupted: in place of a KeyboardInterrupt; the cameras so far stay, in a folder.
    """
    report = CalibrationReport()
    thresholds = run.thresholds
    worst = WorstFrames()
    written: set[str] = set()
    with open_target(out) as target:
        rows: list[Row] = []
        element_rows: list[Row] = []
        try:
            for result in progress(run, run.total, "calibrating"):
                if result.has_camera:
                    target.write(result.file_name, result.data)
                    written.add(result.file_name)
                    worst.add(FrameRow.of(result.name, result.scores[thresholds[0]]))
                left_out = _held_out_row(result, thresholds) if hold_out else ()
                rows.append((*_row(result, thresholds), *left_out))
                element_rows += _element_rows(result)
                _note(result, report)
        except KeyboardInterrupt:
            raise Interrupted(len(written), run.total) from None
        columns = _columns(thresholds)
        columns += _held_out_columns(thresholds) if hold_out else ()
        table = MetricTable("calibration", "", columns, tuple(rows))
        target.write(TABLE_FILE, csv_bytes(table))
        if hold_out:
            elements = MetricTable("held_out", "", _ELEMENT_COLUMNS, tuple(element_rows))
            target.write(LEFT_OUT_FILE, csv_bytes(elements))
        for file_name, data in (more or {}).items():
            target.write(file_name, data)
    report.described, report.summaries = run.describe(), run.summary()
    report.frames, report.cameras = run.counted, run.with_camera
    report.worst = worst.rows()
    report.remarks = [*run.sizes.remarks(), *fold_back_warnings(report.folded)]
    if not is_archive(out):
        report.stale = list(_stale(out, run.names, written))
    return report


def _note(result: Calibrated, report: CalibrationReport) -> None:
    if result.error is not None:
        report.errors.append(result.error)
    elif result.failure is not None:
        report.failures.append((result.name, result.failure))
    report.left_out += bool(result.left_out)
    report.held_out += result.held_out.elements if result.held_out else ()
    if result.open:
        report.open.append(result.name)
    if result.folds:
        report.folded.append(result.name)
    if result.deviations is not None:
        report.deviations.append(deviation_values(result.deviations))


def _stale(out: Path, names: Iterable[str], written: set[str]) -> Iterator[str]:
    """Cameras that this run did not write: no one should take them for its own."""
    folders = {""}
    for name in names:
        folders.add(name.rpartition("/")[0])
        _, *others = camera_names(name)
        yield from (file for file in others if file not in written and (out / file).exists())
    for folder in sorted(folders):
        found = (path.relative_to(out) for path in (out / folder).glob(f"{CAMERA_PREFIX}*.json"))
        yield from natsorted({file.as_posix() for file in found} - written)


def _columns(thresholds: tuple[float, ...]) -> tuple[Column, ...]:
    return (
        Column("name"),
        Column("model"),
        count_column("elements"),
        Column("left_out"),
        *(metric_column(metrics.JAC, key=f"jac_{threshold:g}") for threshold in thresholds),
        metric_column(metrics.FRAME_ERROR_COUNTED),
        metric_column(metrics.FRAME_ERROR),
        *DEVIATION_COLUMNS,
        Column("camera"),
        Column("failure"),
        Column("position"),
        count_column("width"),
        count_column("height"),
        Column("hardly_determined"),
        Column(DIGEST),
    )


def _row(result: Calibrated, thresholds: tuple[float, ...]) -> Row:
    size = (None, None) if result.size is None else result.size.fitted
    deviations = deviation_values(result.deviations if result.has_camera else None)
    if not result.has_camera:
        why = result.error or result.failure
        empty = (None,) * (len(thresholds) + 4)
        return (result.name, result.model, *empty, *deviations, None, why, None, *size, None, None)
    scores = [result.scores[threshold] for threshold in thresholds]
    jacs = (score.jac for score in scores)
    return (
        result.name, result.model, result.elements, "; ".join(result.left_out), *jacs,
        scores[0].mean_reprojection_error, scores[0].mean_error, *deviations, result.file_name,
        None, result.place, *size, result.open, result.digest,
    )  # fmt: skip


def _held_out_columns(thresholds: tuple[float, ...]) -> tuple[Column, ...]:
    passed_at = (count_column(f"held_out_passed_{threshold:g}") for threshold in thresholds)
    return (count_column("held_out_elements"), *passed_at)


def _held_out_row(result: Calibrated, thresholds: tuple[float, ...]) -> Row:
    if not result.has_camera:
        return (None,) * (1 + len(thresholds))
    predicted = [e.predicted_px for e in result.held_out.elements] if result.held_out else []
    return (len(predicted), *(passed(predicted, threshold) for threshold in thresholds))


# Those of `held_out_table.COLUMNS`, after the name.
_ELEMENT_COLUMNS = (
    Column("name"), *(
        count_column(key) if key in ("width", "height")
        else Column(key, kind="number" if key.endswith("_px") else "text")
        for key in COLUMNS
    ),
)  # fmt: skip


def _element_rows(result: Calibrated) -> Iterator[Row]:
    """A row an element left out; one without an element for a frame of which none counts."""
    if result.held_out is None or not result.has_camera:
        return
    terms = result.held_out.terms
    said = (terms.protocol, *terms.size, terms.field_sha256, camera_hash(result.data))
    for e in result.held_out.elements:
        yield (result.name, e.name, e.predicted_px, e.explained_px, *said)
    if not result.held_out.elements:
        yield (result.name, None, None, None, *said)


def held_out_table(report: CalibrationReport) -> MetricTable:
    """The share of elements that the camera of the others shows well, next to that of all."""
    count = len(report.held_out)
    rows = []
    for tau in report.summaries:
        found = (
            passed((e.predicted_px for e in report.held_out), tau),
            passed((e.explained_px for e in report.held_out), tau),
        )
        rows.append((tau, count, *(n / count if count else None for n in found)))
    columns = (
        TAU,
        count_column("elements", "elements"),
        metric_column(metrics.LEFT_OUT_SCORE),
        metric_column(metrics.IN_SAMPLE),
    )
    return MetricTable(
        "held_out", "Elements left out in turn", columns, tuple(rows), report.described
    )


def deviations_table(report: CalibrationReport) -> MetricTable:
    """Return how surely the cameras are known: median and 95th percentile of their standard
    deviations."""
    values = np.array(report.deviations, dtype=np.float64)
    rows = tuple(
        (label, *np.percentile(values, share, axis=0).tolist())
        for label, share in (("median", 50), ("95 % of them below", 95))
    )
    title = f"Standard deviations of {pluralize(len(report.deviations), 'camera')}"
    columns = (Column("share"), *DEVIATION_COLUMNS)
    return MetricTable("deviations", title, columns, rows, notes=(report.described,))


def failures_table(report: CalibrationReport) -> MetricTable:
    """Frames without a camera and the reason, the first ones of many."""
    title = f"{pluralize(len(report.failures), 'frame')} without a camera"
    columns = (Column("frame", "frame"), Column("why", "why"))
    table = MetricTable("failures", title, columns, tuple(report.failures))
    return shortened(table, _FAILURES_SHOWN, f"in {TABLE_FILE}")
