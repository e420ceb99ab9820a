"""``procc-annotator track``: the camera of every frame of a video."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.assist.track_anchors import TrackAnchors
from procc_annotator.batch.execution.executor import Executor, make_executor
from procc_annotator.batch.tracking import ShotToTrack, TrackRun, damaged_pictures
from procc_annotator.calibration.single_image.candidates import warm_up_caches
from procc_annotator.calibration.tracking.shot_tracker import track_shot as follow_shot
from procc_annotator.cli import options, outputs, remarks
from procc_annotator.cli.console import progress_bar, stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.dataset.annotation_source import FrameAnnotations
from procc_annotator.dataset.picture_sizes import picture_size
from procc_annotator.dataset.sequence import PictureSource, find_shots, open_pictures
from procc_annotator.errors import ImageError, InputError, UsageError
from procc_annotator.field.load import field_for_stadium, stadium_of
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.messages import pluralize
from procc_annotator.report.outputs import Interrupted
from procc_annotator.report.tracking import (
    TABLE_FILE,
    TrackTable,
    find_positions,
    gaps_table,
    read_table,
    shots_table,
    tracked_words,
    write_tracks,
)

HELP = """\
SOURCE is a video, whose frames are named as the window names them (match_000123), or a folder of
consecutive pictures. It is cut into its shots; in each the camera is followed forwards and
backwards from the frames whose camera is known: annotated ones (--annotations) and those of files
(--cameras). The track passes through them. Where none is known, one is found in the picture, as
propose does; shots in which none is found are looked at once more for one that stands where those
of the other shots do.

OUT gets camera_FRAME.json for every frame that is followed, SoccerNet JSON in px of the picture,
and track.csv, a row a frame: shot (its first frame), state (anchor; followed on paint; bridged by
the picture's motion, where too little paint is seen; lost), the reason, coverage (share of the
visible model on paint), residual in px, standard deviations, frames to the nearest anchor.

Cameras are written as they come, and once more when their shot is done, refined over all of it; its
rows come with that. A run that was interrupted is started again to go on: shots whose frames all
have a row are not followed again, unless they have new anchors, or --overwrite.

--from FRAME follows only the shot of that frame (its name or number), in both directions.

Exit code: 0; 1 if some pictures, annotations or cameras were unreadable (listed); 2 if there was
nothing to do. A frame that is lost is no error.
"""

EXAMPLE = """\
  procc-annotator track match.mp4 tracked/
  procc-annotator track match.mp4 tracked/ --annotations match_frames/ --from match_000123
"""

Source = Annotated[Path, typer.Argument(help="Video, or folder of consecutive pictures.")]
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
    int, typer.Option("--workers", min=1, metavar="N", help="Processes that share the shots.")
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
    workers: Workers = 1,
    overwrite: Overwrite = False,
) -> None:
    for given in (annotations, cameras):
        if given is not None and not given.exists():
            raise UsageError(f"{given}: does not exist")
    shown = field_options.of(source)
    names = field_options.names(shown)
    pictures = open_pictures(source, annotations)
    remarks.report_remarks(pictures.notices)
    shown = options.with_estimated_pixels(
        shown, [(frame.name, frame.image_path) for frame in pictures.frames]
    )
    start = None if begin is None else _number_of(begin, pictures)
    called = tuple(frame.name for frame in pictures.frames)
    outputs.check_camera_folder(out, [source, annotations, cameras])
    table = _table(out, called, overwrite=overwrite)
    size = options.shown_size(camera_size)
    clicked = None if annotations is None else pictures.annotated(annotations, shown, names)
    anchors = _anchors(pictures, shown, clicked, cameras, camera_format, size)
    places = [str(given) for given in (annotations, cameras) if given is not None]
    if places and not anchors.cameras:
        echo(f"note: no frame here has a camera in {' and '.join(places)}", err=True)
    with ThreadPoolExecutor(1, thread_name_prefix="preparing") as aside:
        prepared = None
        if workers == 1 and not anchors.cameras and (overwrite or not table.rows):
            prepared = aside.submit(_prepare, pictures, shown)
        shots = _shots(pictures, anchors, start)
    if prepared is not None:
        prepared.result()
    for shot in shots:
        if overwrite or _has_new_anchors(shot, table):
            table.forget(shot.frames)
    kept = [shot for shot in shots if table.has_all(shot.frames)]
    for shot in kept:
        table.errors += damaged_pictures(shot, table.lost(shot.frames))
    try:
        with make_executor(workers) as executor:
            new = [shot for shot in shots if shot not in kept]
            _track_shots(new, shown, executor, out, table, "following")
            # Of a run that goes on, also those that it lost before it was stopped.
            again = _shots_to_retry(shots if new else [], out, table)
            for shot in again:  # until it was followed again, nothing is known of it
                table.forget(shot.frames)
            _track_shots(again, shown, executor, out, table, "looking where other shots stand")
    except Interrupted as stopped:
        raise KeyboardInterrupt(_interrupted_message(stopped, out)) from None
    raise typer.Exit(_report(table, [*pictures.problems, *anchors.errors], len(kept), out))


def _track_shots(
    shots: Sequence[ShotToTrack],
    shown: Field,
    executor: Executor,
    out: Path,
    table: TrackTable,
    label: str,
) -> None:
    run = TrackRun(shots, shown, follow_shot)
    run.executor = executor
    with progress_bar(label) as progress:
        write_tracks(run, out, table, progress)


def _has_new_anchors(shot: ShotToTrack, table: TrackTable) -> bool:
    """Return whether a shot that was followed before has anchors that it had not then."""
    names = (shot.frames[number - shot.first].name for number in shot.anchors)
    return any(row["state"] != "anchor" for name in names if (row := table.rows.get(name)))


def _shots_to_retry(
    shots: Sequence[ShotToTrack], out: Path, table: TrackTable
) -> list[ShotToTrack]:
    """Shots in which no camera was found, with where those of the others stand."""
    nothing = [shot for shot in shots if len(table.lost(shot.frames)) == len(shot.frames)]
    places = find_positions(out, table) if nothing else ()
    return [replace(shot, known=places) for shot in nothing] if places else []


def _number_of(text: str, pictures: PictureSource) -> int:
    for number, frame in enumerate(pictures.frames):
        if frame.name == text:
            return number
    if text.isascii() and text.isdigit() and int(text) < len(pictures.frames):
        return int(text)
    last = len(pictures.frames) - 1
    raise UsageError(
        f"--from {text}: there is no such frame (they are called"
        f" {pictures.frames[0].name} to {pictures.frames[-1].name}, numbers 0 to {last})"
    )


def _table(out: Path, names: tuple[str, ...], *, overwrite: bool) -> TrackTable:
    """The table in OUT; a new one in place of one of something else. UsageError if OUT holds
    cameras without a table."""
    if not overwrite and not (out / TABLE_FILE).exists() and outputs.holds_cameras(out, names):
        raise UsageError(
            f"{out}: holds cameras but no {TABLE_FILE}; choose another place, or --overwrite to"
            " replace them"
        )
    try:
        return read_table(out, names)
    except InputError:
        if not overwrite:
            raise
        return TrackTable(names)


def _anchors(
    pictures: PictureSource,
    field: Field,
    clicked: FrameAnnotations | None,
    cameras: Path | None,
    camera_format: str,
    camera_size: tuple[int, int] | None,
) -> TrackAnchors:
    found = TrackAnchors()
    if clicked is not None:
        remarks.report_remarks(clicked.notices)
        found.add_annotated(pictures.frames, clicked, field)
    if cameras is not None:
        with CameraCollection.open(cameras, camera_format, field=field) as collection:
            remarks.report_remarks(collection.notices)
            found.add_cameras(pictures.frames, collection, camera_size)
    remarks.report_remarks(found.remarks)
    return found


def _prepare(pictures: PictureSource, shown: Field) -> None:
    """Work out what the search for a first camera looks up."""
    first = pictures.frames[0]
    try:
        size = picture_size(first.image_path)
    except ImageError:  # told when its shot is followed
        return
    warm_up_caches(field_for_stadium(shown, stadium_of(shown, first.name)), size)


def _shots(pictures: PictureSource, anchors: TrackAnchors, start: int | None) -> list[ShotToTrack]:
    with progress_bar("looking for cuts") as progress:
        ranges = find_shots(pictures, progress)
    if start is not None:
        ranges = [own for own in ranges if start in own]
    return [
        ShotToTrack(
            own[0],
            pictures.frames[own[0] : own[-1] + 1],
            {n: camera for n, camera in anchors.cameras.items() if n in own},
            {n: clicks for n, clicks in anchors.clicks.items() if n in own},
        )
        for own in ranges
    ]


def _interrupted_message(stopped: Interrupted, out: Path) -> str:
    return (
        f"{stopped.written} of {pluralize(stopped.total, 'frame')} are in {out}/{TABLE_FILE};"
        " run it"
        " again: shots that are done stay, the others are followed from their beginning"
    )


_NAMED_ANCHORS = 3


def _report(table: TrackTable, problems: list[str], kept: int, out: Path) -> int:
    console = stdout_console()
    console.print(shots_table(table))
    if (gaps := gaps_table(table)).rows:
        console.print(gaps)
    if kept:
        echo(f"followed before: {pluralize(kept, 'shot')} (--overwrite follows them again)")
    anchors = [(name, row) for name, row in table.rows.items() if row["state"] == "anchor"]
    if unseen := [name for name, row in anchors if not row["coverage"]]:
        count, some = pluralize(len(unseen), "anchor"), ", ".join(unseen[:_NAMED_ANCHORS])
        echo(f"{count} without any line on paint: cameras of other pictures? {some}")
    echo(f"{tracked_words(table)}; written to {out}, with {TABLE_FILE}")
    return remarks.report_unreadable([*problems, *table.errors])
