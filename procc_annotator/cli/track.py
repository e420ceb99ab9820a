"""``procc-annotator track``: the camera of every frame of a video, or of the videos of a season."""

from __future__ import annotations

import json
import os
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.execution.executor import Executor, InProcess, make_executor
from procc_annotator.batch.match_tracking import TrackedMatch
from procc_annotator.batch.season_run import SeasonRun
from procc_annotator.batch.tracking import TrackTask, ignore_progress
from procc_annotator.batch.unit_store import DONE, SOURCE, UnitStore, only_run
from procc_annotator.calibration.tracking.shot_tracker import track_shot as follow_shot
from procc_annotator.calibration.tracking.track import MIN_COVERAGE
from procc_annotator.cli import options, outputs, remarks
from procc_annotator.cli.console import progress_bar, stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.tracked_matches import (
    Anchors,
    Progress,
    TrackedMatches,
    evidence_of,
    set_aside,
)
from procc_annotator.dataset import remote_files
from procc_annotator.dataset.season import STORE_FILE, Match, list_matches
from procc_annotator.errors import UsageError, require_existing
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX
from procc_annotator.messages import pluralize
from procc_annotator.report.tracking import season_table

HELP = """\
SOURCE is a video (frames match_000123), a folder, .zip or .tar of consecutive pictures, or a
season: a folder with such files, or a .csv with the columns video, match, stadium, field, start
(only video is required). With the extra cloud they, and OUT, may be URLs. Videos are cut into
shots, and these into pieces of up to a minute. The camera is tracked in both directions from frames
where it is known: annotated ones (--annotations) or those of --cameras; the track passes through
them. Elsewhere a camera is found in a picture, as by propose. Pieces of a shot are joined; where
none is found, the positions of the match's other shots, and of earlier matches in the stadium, are
tried.

OUT gets MATCH.npz, which all commands read as cameras; convert writes a file per frame from it.

OUT/track.sqlite stores finished pieces: a stopped run continues with the same command, with other
workers as well. A piece that failed three times is set aside and listed.

Exit code: 0; 1 if some pictures, annotations or cameras were unreadable (listed); 2 if there was
nothing to do. A lost frame is no error.
"""

EXAMPLE = """\
  procc-annotator track sample_data/shot/match.mp4 tracked/
  procc-annotator track sample_data/shot/ season/ --workers 2
"""

Source = Annotated[
    Path, typer.Argument(help="Video, folder or archive of pictures, season, or a URL of one.")
]
Out = Annotated[Path, typer.Argument(help="Folder to write the cameras to.")]
Annotations = Annotated[
    Path | None,
    typer.Option(
        "--annotations",
        metavar="DIR",
        help="Folder of annotations: the frames that have one are anchors.",
    ),
]
Cameras = Annotated[
    Path | None,
    typer.Option(
        "--cameras",
        metavar="PATH",
        help="Folder, zip or file of cameras: the frames that have one are anchors.",
    ),
]
From = Annotated[
    str | None, typer.Option("--from", metavar="FRAME", help="Follow only the shot of this frame.")
]
Workers = Annotated[
    int | None, typer.Option("--workers", min=1, metavar="N", help="Processes that share the work.")
]
ONLY = ("missing", "failed", "doubtful")
Only = Annotated[
    str,
    typer.Option(
        metavar="|".join(ONLY),
        help="Pieces to track: missing ones; also those that failed, or with few lines on paint.",
    ),
]
LOGS = ("text", "json")
Log = Annotated[
    str, typer.Option(metavar="|".join(LOGS), help="How lines on units of work are written.")
]
Cache = Annotated[
    Path | None, typer.Option("--cache", metavar="DIR", help="Where files of URLs are kept.")
]
Overwrite = Annotated[
    bool, typer.Option("--overwrite", help="Follow again what OUT has a track of.")
]


def track(
    source: Source,
    out: Out,
    field_options: options.PictureFieldOptions,
    annotations: Annotations = None,
    cameras: Cameras = None,
    begin: From = None,
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
    workers: Workers = None,
    dask: options.Dask = None,
    only: Only = "missing",
    overwrite: Overwrite = False,
    log: Log = "text",
    cache: Cache = None,
) -> None:
    for option, value, known in ("only", only, ONLY), ("log", log, LOGS):
        if value not in known:
            raise UsageError(f"--{option} {value}: expected {', '.join(known)}")
    require_existing(annotations, cameras)
    if cache is not None:
        os.environ[remote_files.CACHE_VARIABLE] = str(cache.absolute())
    season = list_matches(source, lambda text: remarks.report_remarks([text]))
    name = source.name if source.is_dir() else remote_files.file_name(source).stem
    matches = season or (Match(name, source),)
    if season and begin is not None:
        raise UsageError("--from is for the frames of one video")
    url, out = out, remote_files.working_folder(out)
    outputs.check_camera_folder(out, [source, annotations, cameras])
    anchors = Anchors(
        annotations, cameras, camera_format, options.shown_size(camera_size), bool(season)
    )
    tracking = TrackedMatches(matches, out, field_options, anchors, begin)
    store_file = out / STORE_FILE
    if url != out:
        echo(f"note: {store_file} is uploaded at the end", err=True)
    terms = {SOURCE: remote_files.url_of(source) or str(source.absolute())}
    if not overwrite:
        _require_free(out, tracking, store_file, terms[SOURCE])
    with (
        ExitStack() as at_end,
        only_run(out),
        UnitStore(store_file, terms, resume=not overwrite) as store,
        make_executor(workers or (None if dask else 1), dask) as executor,
        progress_bar("following") as progress,
    ):
        at_end.callback(remote_files.upload, url, STORE_FILE)
        has_anchors = bool(annotations or cameras)
        _track_matches(tracking, store, executor, progress, only, log, has_anchors, url)
        failed = set_aside(store, tracking.matches)
        if season:
            listed = [one for one in store.matches() if one.match in tracking.matches]
            stdout_console().print(season_table(listed))
    if log == "json":
        for problem in (*tracking.problems, *failed):
            echo(json.dumps({"problem": problem}), err=True)
        raise typer.Exit(1 if tracking.problems or failed else 0)
    unreadable = remarks.report_unreadable(tracking.problems)
    raise typer.Exit(max(unreadable, remarks.report_unreadable(failed, "set aside")))


def _track_matches(
    tracking: TrackedMatches, store: UnitStore, executor: Executor, progress: Progress, only: str,
    log: str, has_anchors: bool, out: Path,
) -> None:  # fmt: skip
    """Track the matches that are left, and write each to OUT, which may be a URL, when it is
    done."""
    store.restart(
        failed=only == "failed", evidence_below=MIN_COVERAGE if only == "doubtful" else None
    )
    in_process = isinstance(executor, InProcess)
    task = TrackTask(
        tracking.fields, follow_shot, tracking.on_frame(progress) if in_process else ignore_progress
    )
    run = SeasonRun[TrackedMatch](
        task, store, executor, evidence_of, partial(tracking.attempted, progress, in_process, log)
    )
    try:
        done = {one.match for one in store.matches() if one.state == DONE}
        done = set() if only != "missing" or has_anchors else done
        stadiums = {
            match.name: match.stadium
            for match in tracking.matches.values()
            if match.name not in done or not tracking.is_kept(match)
        }
        for name, found in run.run(stadiums, partial(tracking.begin, store), tracking.recover):
            tracking.write(store, name, found)
            remote_files.upload(out, f"{name}{PACKED_SUFFIX}")
            remote_files.remove_copies(tracking.matches[name].pictures)
    except KeyboardInterrupt:
        raise KeyboardInterrupt(
            f"{pluralize(len(store), 'unit')} of the work are kept in {store.path}; run it"
            " again to go on"
        ) from None


def _require_free(out: Path, tracking: TrackedMatches, store_file: Path, source: str) -> None:
    """UsageError where OUT holds cameras of other pictures, or that no run of this command left."""
    if store_file.exists():
        with UnitStore.read(store_file) as store:
            if store.terms.get(SOURCE) != source:
                tracking.require_same(store)
        return
    names = list(tracking.matches)
    if any(tracking.path(name).exists() for name in names) or outputs.holds_cameras(out, names):
        raise UsageError(
            f"{out}: holds cameras but no {STORE_FILE}; choose another place, or --overwrite to"
            " replace them"
        )
