"""``procc-annotator annotate``: the paint under given cameras as annotations."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.batch.auto_annotation import AnnotationRun
from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.set_run import WORTH_WORKERS
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.cli import options, outputs, remarks
from procc_annotator.cli.console import with_progress
from procc_annotator.cli.echo import echo
from procc_annotator.cli.matches import for_each_match, place_of_match
from procc_annotator.dataset.annotation_source import FrameAnnotations
from procc_annotator.dataset.diagnostics import found_instead_of_cameras
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.layout import annotation_folder, folder_of_dataset, holds_annotations
from procc_annotator.dataset.season import Match, annotations_beside
from procc_annotator.dataset.sequence import PictureSource, open_pictures
from procc_annotator.errors import CameraError, UsageError, require_existing
from procc_annotator.formats.atomic import make_folder
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX
from procc_annotator.formats.cameras.writers import OFFICIAL_SIZE
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER
from procc_annotator.messages import list_names, pluralize
from procc_annotator.metrics.sets import most_distinct_views
from procc_annotator.report.auto_annotation import Annotated as Done
from procc_annotator.report.auto_annotation import annotate_pictures

HELP = """\
SOURCE is a folder of pictures, a picture, a video (frames match_000123) or a season (see track).
OUT gets FRAME.json (SoccerNet JSON) with the elements that the frame's camera shows and that are
seen in the picture. It may be where the window reads annotations: match/annotations, match_frames/
for match.mp4, or the season's folder.

The points have the provenance "proposed", in the workspaces of the dataset and of OUT: a person
should confirm them. Existing files are never replaced, so a stopped run continues when repeated.

--views 20 selects the 20 frames with the most different pan and zoom.

Exit code: 0; 1 if some pictures or cameras were unreadable (listed); 2 if there was nothing to do.
"""

EXAMPLE = """\
  procc-annotator annotate sample_data annotated/ --cameras sample_data/cameras/true
  procc-annotator annotate sample_data few/ --cameras sample_data/cameras/true --views 2
"""


def annotate(
    source: options.PicturesOrVideo,
    out: Annotated[Path, typer.Argument(help="Folder to write the annotations to.")],
    cameras: Annotated[
        Path, typer.Option("--cameras", metavar="PATH", help="Folder, zip or file of cameras.")
    ],
    given: options.FieldOptions,
    every: options.Every = 1,
    views: Annotated[
        int | None,
        typer.Option(min=1, metavar="K", help="The K frames whose views differ most only."),
    ] = None,
    camera_format: options.CameraFormat = "auto",
    camera_size: options.CameraSize = None,
    workers: options.FitWorkers = None,
    dask: options.Dask = None,
) -> None:
    require_existing(cameras)

    def of_match(match: Match) -> None:
        packed = place_of_match(cameras, Match(match.name or source.stem, source), PACKED_SUFFIX)
        if (theirs := packed or place_of_match(cameras, match)) is None:
            raise UsageError(f"no cameras called {match.name} in {cameras}")
        season = source if source.is_dir() else source.parent
        is_beside = match.name and out.resolve() == season.resolve()
        place = annotations_beside(match) if is_beside else out / match.name
        own = replace(given, field=match.field or given.field)
        shown = own.of(match.pictures)
        pictures = open_pictures(match.pictures, place)
        remarks.report_remarks(pictures.notices)
        with CameraCollection.open(theirs, camera_format, field=shown) as collection:
            outputs.check_is_folder(place)
            outputs.check_folder_apart(place, [collection])
            remarks.report_remarks(collection.notices)
            chosen = _with_camera(pictures.frames[::every], collection, theirs)
            if views is not None:
                chosen = _most_different(chosen, collection, views)
            frames = _not_annotated(chosen, pictures.annotated(place, shown, own.names(shown)))
            run = AnnotationRun(frames, collection, shown, options.shown_size(camera_size))
            done, folders, count = Done(), _workspaces(pictures, place), len(frames)
            try:
                with make_executor(workers, dask, frames=count, worth_from=WORTH_WORKERS) as who:
                    run.executor = who
                    annotate_pictures(run, frames, folders, with_progress, done)
            except KeyboardInterrupt:
                raise KeyboardInterrupt(_interrupted_message(done, count, place)) from None
        raise typer.Exit(_report(done, len(chosen) - count, pictures, place))

    for_each_match(source, of_match)


def _with_camera(
    frames: Sequence[Frame], collection: CameraCollection, cameras: Path
) -> list[Frame]:
    found = [frame for frame in frames if frame.name in collection.frames]
    if not found:
        if instead := found_instead_of_cameras(cameras):
            raise UsageError(f"nothing to do: no camera in {cameras}{instead}")
        some = f", e.g. for {next(iter(collection.frames))}" if collection.frames else ""
        raise UsageError(
            f"nothing to do: {cameras} holds no camera of these frames (it holds"
            f" {pluralize(len(collection.frames), 'camera')}{some}; a frame here is called"
            f" {frames[0].name})"
        )
    return found


def _not_annotated(frames: Sequence[Frame], given: FrameAnnotations) -> list[Frame]:
    """The frames that have no annotation in OUT, whether in a file of another format."""
    remarks.report_remarks(given.notices)
    bare = [frame for frame in frames if not os.path.lexists(frame.annotation_path)]
    return [frame for frame in bare if given.bytes_of(frame) is None]


def _most_different(
    frames: Sequence[Frame], collection: CameraCollection, count: int
) -> list[Frame]:
    """The frames whose views differ most, in their order; those whose cameras cannot be read, or
    have no pan, are none of them."""
    found, seen, widths = [], [], []
    for frame in frames:
        try:
            loaded = collection.read(frame.name)
        except CameraError:
            continue
        camera = loaded.camera
        if isinstance(camera, PinholeCamera):
            found.append(frame)
            seen.append(camera)
            widths.append((loaded.size or OFFICIAL_SIZE)[0])
    if not found:
        raise UsageError("--views needs cameras with pan and zoom (pinhole cameras)")
    chosen = most_distinct_views(seen, widths, count)
    return [found[place] for place in sorted(chosen)]


def _workspaces(pictures: PictureSource, out: Path) -> dict[Path, bool]:
    """The datasets that the annotations belong to, that of the pictures and what OUT is one of, and
    whether OUT is where it has its annotations."""
    make_folder(out)
    found = [folder for folder in (pictures.folder, folder_of_dataset(out)) if folder is not None]
    there = {os.path.realpath(folder): folder for folder in found if folder.is_dir()}
    usual = _is_usual(pictures, out)
    return {folder: usual or folder != pictures.folder for folder in there.values()}


def _interrupted_message(done: Done, total: int, out: Path) -> str:
    looked_at = len(done.frames) + len(done.bare) + len(done.kept) + len(done.errors)
    return (
        f"{looked_at} of {pluralize(total, 'frame')} examined,"
        f" {pluralize(len(done.frames), 'annotation')} written to {out}; run it again to go on"
    )


def _report(done: Done, passed_over: int, pictures: PictureSource, out: Path) -> int:
    written = pluralize(len(done.frames), "annotation")
    what = f"{pluralize(done.elements, 'element')}, {pluralize(done.points, 'point')}"
    echo(f"written: {written} ({what}) to {out}, their points as proposed")
    if kept := passed_over + len(done.kept):
        echo(f"not touched: {pluralize(kept, 'frame')} annotated already")
    if done.bare:
        echo(f"no paint found under the camera: {list_names(done.bare, 'frame')}")
    remarks.report_remarks(done.remarks)
    if done.frames and not _is_usual(pictures, out) and holds_annotations(out):
        echo(
            f"note: the window looks for annotations of {pictures.path} in {_usual(pictures)}; open"
            f" these with --annotations {out}",
            err=True,
        )
    return remarks.report_unreadable([*pictures.problems, *done.errors])


def _usual(pictures: PictureSource) -> Path:
    """Return where the window looks for annotations of these pictures."""
    if pictures.is_video or pictures.folder.is_file():  # an archive
        return annotations_beside(Match("", pictures.path))
    apart = pictures.folder / ANNOTATIONS_FOLDER
    return apart if holds_annotations(apart) else annotation_folder(pictures.folder)


def _is_usual(pictures: PictureSource, out: Path) -> bool:
    usual = _usual(pictures)
    return usual.is_dir() and out.is_dir() and usual.samefile(out)
