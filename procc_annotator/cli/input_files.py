"""Open datasets, their annotations and cameras; report problems with them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli.remarks import report_mismatch, report_mismatch_of, report_remarks
from procc_annotator.dataset.annotation_source import (
    FrameAnnotations,
    open_annotations,
    own_label_map,
)
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.diagnostics import (
    MOST_FRAMES,
    classes_in,
    found_instead_of_cameras,
    found_instead_of_pictures,
    has_packed_pictures,
)
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.layout import (
    annotations_of,
    find_pictures,
    has_pictures,
    has_pictures_below,
    pictures_in,
)
from procc_annotator.dataset.sequence import open_pictures
from procc_annotator.dataset.workspace import (
    AnnotatedFrames,
    Workspace,
    dataset_frames,
    file_frames,
)
from procc_annotator.errors import UsageError, require_existing
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LabelMap, read_label_map
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import FileSource, open_source, suffix_of
from procc_annotator.image.archive import is_archive_file
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES

Dataset = Annotated[
    Path,
    typer.Argument(
        help="Folder of pictures, annotations next to them or in annotations/; or one picture."
    ),
]
Annotations = Annotated[
    Path | None,
    typer.Option(
        "--annotations", metavar="DIR", help="Folder of the annotation files, if elsewhere."
    ),
]
Cameras = Annotated[
    Path | None, typer.Option("--cameras", metavar="PATH", help="Folder, zip or file of cameras.")
]


def open_dataset(
    path: Path, field: Field, annotations: Path | None = None, names: LabelMap | None = None
) -> Workspace:
    """The dataset, to be read: pictures with annotations of any format, the frames of a video, or
    annotations without pictures.

    Args:
        path, field: of the dataset.
        annotations: where they are, if elsewhere.
        names: what their labels stand for; None: as the dataset's own map says, if it has one.

    Raises:
        UsageError: no such folder, or nothing in it.
        InputError: none of the annotations can be read, or the dataset's map cannot be used.
    """
    require_existing(path, annotations)
    if path.is_file() and path.suffix.lower() in VIDEO_SUFFIXES:
        video = open_pictures(path, annotations)
        workspace = Workspace(path, video.frames, field, video.notices, video.folder)
        workspace.given = FrameAnnotations()  # of the folder of its frames
        if annotations is not None:
            workspace.given = video.annotated(annotations, field, names)
        report_remarks((*workspace.notices, *video.problems, *workspace.given.notices))
        return workspace
    if annotations is None and _is_unpictured(path):
        source = open_annotations(annotations_of(path), field, names)  # stays open
        frames = tuple(Frame(name, "", path, path) for name in list_annotations(source))
        if frames:
            report_mismatch(source, field)
            workspace = Workspace(path, frames, field, ())
            workspace.given = FrameAnnotations(source)
            return workspace
    workspace = Workspace.open(path, field, annotations)
    if not workspace.frames:
        raise UsageError(f"nothing to do: no picture in {path}{found_instead_of_pictures(path)}")
    workspace.given = kept = FrameAnnotations.of(path, annotations, field, names)
    report_remarks((*workspace.notices, *kept.notices))
    report_mismatch_of(_classes_of(workspace), field, workspace.folder, unknown=kept.unknown)
    return workspace


def _classes_of(workspace: Workspace) -> frozenset[str]:
    readers = [partial(workspace.read, index) for index in range(len(workspace.frames))]
    return classes_in(readers[:: max(1, len(readers) // MOST_FRAMES)])


def _is_unpictured(path: Path) -> bool:
    """Return whether annotations are all there is, and no pictures are still packed."""
    if _is_pictured(path):
        return False
    with open_source(path) as source:
        return not has_packed_pictures(source)


def _is_pictured(path: Path) -> bool:
    if is_archive_file(path):
        with open_source(path) as source:
            others = {suffix_of(name) for name in source.tree()} - PICTURE_SUFFIXES - {".tar"}
        return not others and bool(find_pictures(path).folders)
    if path.is_file():
        return path.suffix.lower() in PICTURE_SUFFIXES
    return path.is_dir() and bool(
        pictures_in(path) or (has_pictures_below(path) and has_pictures(path))
    )


@contextmanager
def annotated_frames(
    path: Path, field: Field, annotations: Path | None = None, labels: Path | None = None
) -> Iterator[tuple[AnnotatedFrames, FileSource | None]]:
    """The frames of a dataset; of annotations of any format where there is no picture, or where a
    map (``labels``, else the dataset's own) says what their labels stand for.

    Yields them, and what they are read from where that is not a dataset with pictures; raises as
    `open_dataset`."""
    pictured = _is_pictured(path)
    names = own_label_map(path, field) if labels is None else read_label_map(labels, field)
    if (pictured and names is None) or not path.exists():
        yield dataset_frames(open_dataset(path, field, annotations)), None
        return
    with open_annotations(annotations or annotations_of(path), field, names) as source:
        frames = file_frames(source, field)
        if not frames.names:
            raise UsageError(f"nothing to do: no picture and no annotation in {path}")
        report_mismatch(source, field)
        yield frames, source


def open_cameras(
    path: Path | None, camera_format: str, camera_size: tuple[int, int] | None, field: Field
) -> CameraSet | None:
    """The cameras, if any were asked for, of pictures that show a field; remarks on their files go
    to stderr. UsageError for no such folder or file, or no camera in it."""
    if path is None:
        return None
    require_existing(path)
    cameras = CameraSet.open(path, camera_format, camera_size=camera_size, field=field)
    if not cameras.frames:
        raise UsageError(
            f"nothing to do: no camera (format {camera_format}) in"
            f" {path}{found_instead_of_cameras(path)}"
        )
    report_remarks(cameras.notices)
    return cameras
