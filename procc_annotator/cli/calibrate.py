"""``procc-annotator calibrate``: fit a camera to the annotation of every frame."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.calibration import CalibrationRun
from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.joint_calibration import JointRun
from procc_annotator.batch.set_run import WORTH_WORKERS, annotation_files
from procc_annotator.batch.unit_store import UnitStore, field_settings, unfinished_path
from procc_annotator.calibration.fitting import require_known_model
from procc_annotator.calibration.result import ILL_CONDITIONED_LIMITS
from procc_annotator.cli import options, outputs, remarks
from procc_annotator.cli.console import progress_bar, stdout_console, with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.resuming import is_resuming, resumable
from procc_annotator.cli.set_fits import FittedFrames, fit_set, fit_sizes
from procc_annotator.dataset.annotation_source import open_annotations
from procc_annotator.dataset.layout import annotations_of
from procc_annotator.dataset.picture_sizes import FitSizes
from procc_annotator.errors import UsageError
from procc_annotator.formats.cameras.fit_record import LEFT_OUT_FILE, TABLE_FILE
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import FileSource
from procc_annotator.messages import first_names, pluralize
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report import calibration, joint_calibration
from procc_annotator.report.calibration import CalibrationReport, calibrate_set
from procc_annotator.report.joint_calibration import POSITIONS_FILE
from procc_annotator.report.outputs import is_archive
from procc_annotator.report.scores import score_tables

HELP = """\
DATASET is a dataset folder, or a folder or zip archive of annotations. OUT, a folder or .zip, gets
camera_00037.json for frame 00037 (00037.npy with --model H, 00037.yml for a fisheye) and
calibration.csv with JaC, error, standard deviations, or the reason why there is no camera.

Only the shape of the pictures is used: a camera is for 960 px in that shape (4:3 is 960x720), for
960x540 without pictures, or for --size.

Models: P, a pinhole with one focal length; R, P and one radial coefficient; R+, R with aspect ratio
and principal point; R2, R+ and a second radial coefficient; F, OpenCV's fisheye; H, a homography of
the ground without goals; auto, the simplest of P, R and R+ that the points support, or R2 or F
where lines bend more than these explain.

--shared-position estimates one position for frames of a fixed camera (per group with --groups).
Elements that were not annotated are then predicted better, annotated ones fit a little less
closely, and two elements are enough. positions.csv holds the positions.

The JaC compares cameras with the points they were fitted to, so it is in sample.
--leave-one-out evaluates each element with the camera of the others, in about ten times the time;
held_out.csv stores the distances for evaluate and report.

--resume continues a stopped run with identical options; changed files are fitted again.

Exit code: 0; 1 if some annotations were unreadable (listed); 2 if there was nothing to do. A frame
without a camera is listed with the reason and is no error.
"""

EXAMPLE = """\
  procc-annotator calibrate sample_data fitted/ --model R -t 2 -t 5
  procc-annotator calibrate sample_data together/ --shared-position
"""


@dataclass(frozen=True, kw_only=True)
class CalibrateOptions:
    """Options of `calibrate`."""

    dataset: options.AnnotatedSet
    out: Annotated[Path, typer.Argument(help="Folder or .zip to write the cameras to.")]
    model: options.Model = "R"
    threshold: options.Thresholds = None
    protocol: options.Protocol = "soccernet"
    size: options.FitSize = None
    field_options: options.PictureFieldOptions
    off_plane: options.OffPlane = "left_out"
    mirrored: options.Mirrored = False
    workers: options.FitWorkers = None
    dask: options.Dask = None
    shared_position: Annotated[
        bool,
        typer.Option(
            "--shared-position", help="One position for the frames that a camera took from there."
        ),
    ] = False
    groups: options.Groups = None
    held_out: Annotated[
        bool,
        typer.Option(
            "--leave-one-out",
            help="Also leave out every element in turn, and judge it by the camera of the others.",
        ),
    ] = False
    resume: options.Resume = False
    overwrite: options.Overwrite = False


def calibrate(given: CalibrateOptions) -> None:
    require_known_model(given.model)
    if given.groups is not None and not given.shared_position:
        raise UsageError("--groups is for --shared-position")
    if given.held_out and given.shared_position:
        raise UsageError("--leave-one-out is for cameras of their own, not for --shared-position")
    field = given.field_options.of(given.dataset)
    setup = options.setup_for(field, given.size, given.protocol, given.off_plane, given.mirrored)
    thresholds = options.thresholds_or_default(given.threshold)
    place = annotations_of(given.dataset)
    with open_annotations(place, field, given.field_options.names(field)) as source:
        left = unfinished_path(given.out, "calibrate")
        going_on = is_resuming(
            left, given.out / TABLE_FILE, given.out, resume=given.resume, overwrite=given.overwrite
        )
        _check_out(
            given.out,
            source,
            overwrite=given.overwrite or going_on,
            positions=given.shared_position,
        )
        remarks.report_set(source, field)
        sizes = fit_sizes(source, place, given.dataset, given.size)
        pictures = [(name, sizes.picture_of(name)) for name, _ in annotation_files(source)]
        setup = replace(setup, field=options.with_estimated_pixels(field, pictures, given.size))
        asked = _terms(given, setup, thresholds, sizes)
        with resumable(left, asked, given.out, TABLE_FILE, "camera", resume=going_on) as kept:
            code = _calibrate(given, source, setup, sizes, thresholds, kept)
        raise typer.Exit(code)


def _calibrate(
    given: CalibrateOptions,
    source: FileSource,
    setup: EvaluationSetup,
    sizes: FitSizes,
    thresholds: tuple[float, ...],
    kept: UnitStore,
) -> int:
    if given.shared_position:
        fits = fit_set(
            source, given.dataset, setup, sizes,
            given.model, given.groups, given.workers, given.dask, kept,
        )  # fmt: skip
        return _fit_jointly(fits, setup, thresholds, given.out)
    each = CalibrationRun(source, setup, sizes, thresholds, given.model, hold_out=given.held_out)
    each.kept = kept
    return _fit_individually(each, given.out, given.workers, given.dask)


def _terms(
    given: CalibrateOptions, setup: EvaluationSetup, thresholds: tuple[float, ...], sizes: FitSizes
) -> dict[str, str]:
    """Return what a run has to share with the one that it goes on with."""
    shared = "shared position" if given.shared_position else ""
    return {
        "way to calibrate": "held out" if given.held_out else shared,
        "model": given.model,
        "thresholds": ", ".join(f"{tau:g}" for tau in thresholds),
        "scoring": setup.describe(ground_only=True),
        "field": field_settings(setup.field),
        "size": f"{sizes.asked}, of frames without picture {sizes.otherwise}",
    }


def _fit_individually(run: CalibrationRun, out: Path, workers: int | None, dask: str | None) -> int:
    with make_executor(workers, dask, frames=run.total, worth_from=WORTH_WORKERS) as executor:
        run.executor = executor
        hold_out = run.task.hold_out
        report = calibrate_set(run, out, with_progress, hold_out=hold_out)
    _print_report(report, out)
    if hold_out:
        stdout_console().print(calibration.held_out_table(report))
        echo(f"written: {LEFT_OUT_FILE}, which evaluate and report use with these cameras")
    if (out / POSITIONS_FILE).exists():
        echo(
            f"note: {out} holds {POSITIONS_FILE} of cameras with shared positions, not of these;"
            " it was not touched",
            err=True,
        )
    return _report_problems(report, out)


def _fit_jointly(
    fits: FittedFrames, setup: EvaluationSetup, thresholds: tuple[float, ...], out: Path
) -> int:
    with progress_bar("sharing positions") as progress:
        run = JointRun(fits.fits, fits.frames, setup, thresholds, progress)
    positions = {joint_calibration.POSITIONS_FILE: joint_calibration.positions_csv(run.places)}
    report = calibrate_set(run, out, with_progress, positions)
    _print_report(report, out)
    console = stdout_console()
    if run.places:
        console.print(joint_calibration.positions_table(run))
    words = ("each frame alone", "shared positions")
    console.print(joint_calibration.before_after_table(run.before, run.summary(), words))
    if run.apart:
        console.print(joint_calibration.not_shared_table(run.apart))
    if run.gained:
        have = pluralize(len(run.gained), "frame has", "frames have")
        echo(f"{have} a camera now that the position is known: {first_names(run.gained)}")
    return _report_problems(report, out)


def _check_out(out: Path, source: FileSource, *, overwrite: bool, positions: bool) -> None:
    """Fail before the work: nothing may be written over what is read or among it, or over cameras
    (with ``positions`` also a table of positions) no one asked to replace."""
    if is_archive(out):
        if out.is_dir():
            raise UsageError(f"{out}: is a folder, an archive is asked for")
    elif out.exists() and not out.is_dir():
        raise UsageError(f"{out}: is a file, a folder is needed")
    outputs.check_place(out, [source])
    if out.is_dir():
        outputs.check_no_annotations(out)
    tables = [TABLE_FILE, *([POSITIONS_FILE] if positions else []), LEFT_OUT_FILE]
    there = any((out / table).exists() for table in tables) or outputs.holds_cameras(
        out, list_annotations(source), ("camera_*.json", "*.npy", "*.yml")
    )
    if (there or out.is_file()) and not overwrite:
        finished = (out / TABLE_FILE).exists() or out.is_file()
        stopped = "" if finished else f" but no {TABLE_FILE}"
        why = ", as an interrupted run leaves them" if stopped else ""
        raise UsageError(
            f"{out}: holds cameras or their tables already{stopped}{why}; choose another"
            " place, or --overwrite to replace them"
        )


def _print_report(report: CalibrationReport, out: Path) -> None:
    console = stdout_console()
    frames = pluralize(report.frames, "frame")
    title = f"Calibrated {frames}, {pluralize(report.cameras, 'has', 'have')} a camera"
    told = [score_tables.summary_table(report.summaries, report.described, title=title)]
    if report.worst:
        first = next(iter(report.summaries))
        told.append(score_tables.worst_frames_table(report.worst, first, report.described))
    for table in told:
        console.print(table)
    if report.deviations:
        console.print(calibration.deviations_table(report))
    if report.failures:
        console.print(calibration.failures_table(report))
    cameras = pluralize(report.cameras, "camera")
    echo(f"written: {cameras} and {TABLE_FILE} to {out}")


def _report_problems(report: CalibrationReport, out: Path) -> int:
    remarks.report_remarks(report.remarks)
    if report.open:
        echo(
            f"note: {pluralize(len(report.open), 'camera is', 'cameras are')} hardly determined"
            f" ({ILL_CONDITIONED_LIMITS}; column hardly_determined): {first_names(report.open)}",
            err=True,
        )
    if report.left_out:
        echo(
            f"note: frames with elements that fit no camera together with the others, and were left"
            f" out: {report.left_out} (column left_out of the table; are the labels right?)",
            err=True,
        )
    if report.stale:
        echo(
            f"note: {out} holds {pluralize(len(report.stale), 'other camera')}, not written now and"
            f" not touched: {first_names(report.stale)}",
            err=True,
        )
    return remarks.report_unreadable(report.errors)
