"""``procc-annotator track``: the camera of every frame of a video, or of the videos of a season."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

from procc_annotator.assist.track_anchors import TrackAnchors
from procc_annotator.batch.execution.executor import InProcess, make_executor
from procc_annotator.batch.match_tracking import (
    MatchToTrack,
    TrackedMatch,
    find_positions,
    track_match,
)
from procc_annotator.batch.season_run import Attempt, Plan, SeasonRun
from procc_annotator.batch.tracking import TRACK, UNREADABLE, TrackTask, TrackUnit, ignore_progress
from procc_annotator.batch.unit_store import (
    DONE,
    FAILED,
    Unit,
    UnitStore,
    field_settings,
    hex_digest,
)
from procc_annotator.calibration.single_image.proposal import KnownPosition
from procc_annotator.calibration.tracking.shot_tracker import track_shot as follow_shot
from procc_annotator.calibration.tracking.track import MIN_COVERAGE, TrackedFrame
from procc_annotator.cli import options, outputs, remarks
from procc_annotator.cli.console import progress_bar, stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.matches import place_of_match
from procc_annotator.dataset import remote_files
from procc_annotator.dataset.dataset_field import with_dataset_pixels
from procc_annotator.dataset.season import Match, list_matches
from procc_annotator.dataset.sequence import PictureSource, open_pictures
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX, PackedCameras, read_packed
from procc_annotator.formats.file_source import read_file
from procc_annotator.messages import pluralize
from procc_annotator.report.tracking import gaps_table, season_table, shots_table, tracked_words

STORE_FILE = "track.sqlite"

HELP = """\
SOURCE is a video, whose frames are named as the window names them (match_000123), a folder, .zip
or .tar of consecutive pictures, or a season: a folder in which such files lie, or a .csv with a row
a match: video, match, stadium, field, start (all but the first may be absent). With the extra cloud
these, and OUT, may be URLs (docs/season.md). Each is cut into its shots,
these into pieces of at most a minute; in each the camera is followed forwards and backwards from
the frames whose camera is known: annotated ones (--annotations) and those of files (--cameras), of
a season from folders called like the matches. The track passes through them. Where none is known,
one is found in the picture, as propose does. Pieces of a shot hand their cameras on to each other;
where none is found, one is looked for where those of the match's other shots stand, or those of
earlier matches in the stadium.

OUT gets MATCH.npz, which every command reads as cameras: of each frame the camera in px of the
picture with its standard deviations, its shot, state (anchor; followed on paint; bridged by the
picture's motion, where too little paint is seen; lost), why it should be looked at, coverage (share
of the visible model on paint), residual in px, frames to the nearest anchor (docs/season.md).
convert writes a file a frame from it.

OUT/track.sqlite says which pieces are done: a run that was stopped or killed is started again to go
on, with other workers too. A piece that failed three times is set aside and named; --only failed
tries those again, --only doubtful those with little of their lines on paint.

--from FRAME follows only the shot of that frame (its name or number), in both directions.

Exit code: 0; 1 if some pictures, annotations or cameras were unreadable (listed); 2 if there was
nothing to do. A frame that is lost is no error.
"""

EXAMPLE = """\
  procc-annotator track match.mp4 tracked/ --annotations match_frames/
  procc-annotator track season/ tracked/ --workers 8
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
    int | None,
    typer.Option("--workers", min=1, metavar="N", help="Processes that share the work."),
]
Progress = Callable[[int, int], None]
ONLY = ("missing", "failed", "doubtful")
Only = Annotated[
    str,
    typer.Option(
        metavar="|".join(ONLY), help="Which pieces: missing ones, or those also that failed or ..."
    ),
]
LOGS = ("text", "json")
_LOGGED = ("match", "kind", "state", "tries", "frames", "evidence", "error")
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
    for given in (annotations, cameras):
        if given is not None and not given.exists():
            raise UsageError(f"{given}: does not exist")
    if cache is not None:
        os.environ[remote_files.CACHE_VARIABLE] = str(cache.absolute())
    season = list_matches(source)
    name = source.name if source.is_dir() else remote_files.file_name(source).stem
    matches = season or (Match(name, source),)
    if season and begin is not None:
        raise UsageError("--from is for the frames of one video")
    url, out = out, remote_files.working_folder(out)
    outputs.check_camera_folder(out, [source, annotations, cameras])
    anchors = _Anchors(
        annotations, cameras, camera_format, options.shown_size(camera_size), bool(season)
    )
    tracking = _Tracking(matches, out, field_options, anchors, begin)
    store_file = out / STORE_FILE
    if url != out:
        echo(f"note: {store_file} is uploaded at the end", err=True)
    if not overwrite:
        _require_free(out, matches, store_file)
    with (
        ExitStack() as at_end,
        UnitStore(store_file, tracking.terms, resume=not overwrite) as store,
        make_executor(workers or (None if dask else 1), dask) as executor,
        progress_bar("following") as progress,
    ):
        at_end.callback(remote_files.upload, url, STORE_FILE)
        store.restart(
            failed=only == "failed", evidence_below=MIN_COVERAGE if only == "doubtful" else None
        )
        told = isinstance(executor, InProcess)
        task = TrackTask(
            tracking.fields, follow_shot, tracking.on_frame(progress) if told else ignore_progress
        )
        run = SeasonRun[TrackedMatch](
            task, store, executor, _evidence, partial(tracking.attempted, progress, told, log)
        )
        try:
            done = {one.match for one in store.matches() if one.state == DONE}
            done = set() if only != "missing" or annotations or cameras else done
            stadiums = {
                match.name: match.stadium
                for match in matches
                if match.name not in done or not tracking.is_kept(match)
            }
            for name, found in run.run(stadiums, tracking.begin, tracking.recover):
                store.announce(name, tracking.write(name, found), DONE)
                store.forget(name, TRACK)
                remote_files.upload(url, f"{name}{PACKED_SUFFIX}")
                remote_files.remove_copies(tracking.matches[name].pictures)
        except KeyboardInterrupt:
            raise KeyboardInterrupt(
                f"{pluralize(len(store), 'unit')} of the work are kept in {store_file}; run it"
                " again to go on"
            ) from None
        problems = tracking.problems + [
            f"set aside: {unit.key}: {unit.error}" for unit in store.units(FAILED)
        ]
        if season:
            stdout_console().print(season_table(store.matches()))
    raise typer.Exit(remarks.report_unreadable(problems))


def _evidence(result: Any) -> float | None:
    """Mean coverage of a piece; frames without a camera count as 0."""
    if not isinstance(result, PackedCameras):
        return None
    return float(np.nan_to_num(result.coverage).mean())


def _require_free(out: Path, matches: tuple[Match, ...], store_file: Path) -> None:
    """UsageError where OUT holds cameras that no run of this command left."""
    if store_file.exists():
        return
    names = [match.name for match in matches]
    packed = any((out / f"{name}{PACKED_SUFFIX}").exists() for name in names)
    if packed or outputs.holds_cameras(out, names):
        raise UsageError(
            f"{out}: holds cameras but no {STORE_FILE}; choose another place, or --overwrite to"
            " replace them"
        )


@dataclass(frozen=True)
class _Anchors:
    """Where cameras that are known beforehand are found; those of a season in folders called like
    its matches."""

    annotations: Path | None
    cameras: Path | None
    camera_format: str
    camera_size: tuple[int, int] | None
    by_match: bool

    def place(self, root: Path | None, match: Match) -> Path | None:
        """Return where those of a match are, if there are any."""
        return place_of_match(root, match) if self.by_match else root

    def of(
        self, match: Match, pictures: PictureSource, shown: Field, given: options.FieldOptions
    ) -> TrackAnchors:
        """The anchors of a match; remarks on them are told."""
        found = TrackAnchors()
        annotations = self.place(self.annotations, match)
        cameras = self.place(self.cameras, match)
        if annotations is not None:
            clicked = pictures.annotated(annotations, shown, given.names(shown))
            remarks.report_remarks(clicked.notices)
            found.add_annotated(pictures.frames, clicked, shown)
        if cameras is not None:
            with CameraCollection.open(cameras, self.camera_format, field=shown) as collection:
                remarks.report_remarks(collection.notices)
                found.add_cameras(pictures.frames, collection, self.camera_size)
        remarks.report_remarks(found.remarks)
        places = [str(one) for one in (annotations, cameras) if one is not None]
        if places and not found.cameras:
            echo(f"note: no frame here has a camera in {' and '.join(places)}", err=True)
        return found


class _Tracking:
    """What is known of the matches of a run, and what was written.

    Attributes:
        fields: the elements, by the names of matches.
        problems: what was unreadable, one line each.
    """

    def __init__(
        self,
        matches: tuple[Match, ...],
        out: Path,
        given: options.PictureFieldOptions,
        anchors: _Anchors,
        start: str | None,
    ) -> None:
        self.matches = {match.name: match for match in matches}
        self._out, self._given, self._anchors, self._start = out, given, anchors, start
        self.fields = {
            match.name: options.chosen_field(
                match.field or given.field,
                match.pictures,
                lines=given.lines,
                pixel_aspect=given.pixel_aspect,
            )
            for match in matches
        }
        self.problems: list[str] = []
        self._names: dict[str, tuple[str, ...]] = {}  # of the frames of matches under way
        self._known: dict[str, tuple[KnownPosition, ...]] = {}  # by stadium
        self._frames = 0  # that were followed

    @property
    def terms(self) -> dict[str, str]:
        """What the run was asked for, see `UnitStore`."""
        fields = {field_settings(field): None for field in self.fields.values()}
        return {"field": next(iter(fields)) if len(fields) == 1 else hex_digest(*fields)[:12]}

    def path(self, name: str) -> Path:
        """The file of a match."""
        return self._out / f"{name}{PACKED_SUFFIX}"

    def begin(self, name: str) -> Plan[TrackedMatch]:
        """The plan of a match."""
        match, shown = self.matches[name], self.fields[name]
        annotations = self._anchors.place(self._anchors.annotations, match)
        pictures = open_pictures(match.pictures, annotations)
        remarks.report_remarks(pictures.notices)
        self.problems += pictures.problems
        anchors = self._anchors.of(match, pictures, shown, self._given)
        self.problems += anchors.errors
        self._names[name] = names = tuple(frame.name for frame in pictures.frames)
        url = remote_files.url_of(match.pictures)
        place = match.pictures if url else pictures.path.absolute()
        pixels = shown.pixels or with_dataset_pixels(shown, pictures.path).pixels
        return track_match(
            MatchToTrack(
                name, place, pictures.stamp(), replace(shown, pixels=pixels), name, names,
                anchors.cameras, anchors.clicks,
                self._known.get(match.stadium, ()) if match.stadium else (), pixels,
                only=None if self._start is None else _number_of(self._start, names),
            )
        )  # fmt: skip

    def is_kept(self, match: Match) -> bool:
        """Return whether a match that is done need not be fetched from its URL to be left alone."""
        there = self._written(match.name) if remote_files.url_of(match.pictures) else None
        self._know(match, there)
        return there is not None

    def _know(self, match: Match, cameras: PackedCameras | None) -> None:
        if match.stadium and cameras is not None:
            places = find_positions([cameras])
            self._known[match.stadium] = places or self._known.get(match.stadium, ())

    def recover(self, unit: Any) -> PackedCameras | None:
        """A piece that was followed before, from the file of its match."""
        if not isinstance(unit, TrackUnit) or (there := self._written(unit.match)) is None:
            return None
        names = self._names[unit.match][unit.numbers.start : unit.numbers.stop]
        if names[0] not in there.frame:
            return None
        first = there.frame.index(names[0])
        rows = there.rows(range(first, min(first + len(names), len(there))))
        return rows if rows.frame == names else None

    def _written(self, name: str) -> PackedCameras | None:
        path = self.path(name)
        return read_packed(read_file(path), str(path)) if path.exists() else None

    def write(self, name: str, found: TrackedMatch) -> int:
        """Write what a match came to, with the shots that were followed before; returns how many
        frames it has."""
        cameras, before = found.cameras, self._written(name)
        if before is not None and len(cameras) < len(self._names[name]):
            cameras = cameras.merged(before, self._names[name])
        make_folder(self.path(name).parent)
        write_atomic(self.path(name), cameras.encoded())
        self._know(self.matches[name], cameras)
        self.problems += [
            reason
            for state, reason in zip(cameras.state, cameras.reason, strict=True)
            if state == UNREADABLE
        ]
        _report(name, cameras, found.jumps, self.path(name), alone=len(self.matches) == 1)
        return len(self._names.pop(name))

    def on_frame(self, progress: Progress) -> Callable[[TrackedFrame], None]:
        """Tells of frames as they are followed, in this process."""

        def followed(_: TrackedFrame) -> None:
            self._frames += 1
            progress(min(self._frames, self._total), self._total)

        return followed

    def attempted(
        self, progress: Progress, told: bool, log: str, attempt: Attempt, kept: Unit
    ) -> None:
        """Tell of a unit that was tried."""
        unit = attempt.unit
        if not told and unit.kind == TRACK:
            self._frames += unit.frames
            progress(min(self._frames, self._total), self._total)
        if log == "json":
            about = {name: getattr(kept, name) for name in _LOGGED}
            about |= {"time": kept.changed, "unit": kept.key, "seconds": attempt.seconds}
            echo(json.dumps(about), err=True)
        elif attempt.error or not sys.stderr.isatty():
            what = attempt.error or f"{unit.frames} frames in {attempt.seconds:.1f} s"
            echo(f"{unit.match}: {unit.kind} {unit.key.split('/')[-1]}: {what}", err=True)

    @property
    def _total(self) -> int:
        return sum(map(len, self._names.values()))


def _number_of(text: str, names: Sequence[str]) -> int:
    if text in names:
        return names.index(text)
    last = len(names) - 1
    if text.isascii() and text.isdigit() and int(text) <= last:
        return int(text)
    raise UsageError(
        f"--from {text}: there is no such frame (they are called {names[0]} to {names[-1]},"
        f" numbers 0 to {last})"
    )


_NAMED = 3


def _report(
    name: str, cameras: PackedCameras, jumps: Mapping[int, float], path: Path, *, alone: bool
) -> None:
    if alone:
        console = stdout_console()
        console.print(shots_table(cameras))
        if (gaps := gaps_table(cameras)).rows:
            console.print(gaps)
    unseen = [
        frame
        for frame, state, coverage in zip(
            cameras.frame, cameras.state, cameras.coverage.tolist(), strict=True
        )
        if state == "anchor" and not coverage
    ]
    if unseen:
        some = ", ".join(unseen[:_NAMED])
        what = pluralize(len(unseen), "anchor")
        echo(f"{name}: {what} without any line on paint: cameras of other pictures? {some}")
    if (aspect := float(cameras.pixel_aspect.max(initial=1.0))) != 1:
        echo(f"{name}: pixels are {aspect:.3f} times as wide as high")
    for number, px in jumps.items():
        echo(f"{name}: at frame {number} two pieces of a shot are {px:.1f} px apart", err=True)
    echo(f"{name}: {tracked_words(cameras)}; written to {path}")
