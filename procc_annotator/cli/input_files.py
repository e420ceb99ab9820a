"""Open datasets, their annotations and cameras; report problems with them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from procc_annotator.cli.echo import condense_problems, echo
from procc_annotator.dataset.annotation_source import (
    FrameAnnotations,
    ReadSource,
    open_annotations,
    own_label_map,
)
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.dataset_field import field_of_dataset
from procc_annotator.dataset.diagnostics import (
    MOST_FRAMES,
    Mismatch,
    classes_in,
    classes_of_source,
    found_instead_of_cameras,
    found_instead_of_pictures,
    loadable,
    mismatch_of,
)
from procc_annotator.dataset.layout import (
    annotations_of,
    camera_name_remark_in,
    has_pictures,
    has_pictures_below,
    pictures_in,
)
from procc_annotator.dataset.workspace import AnnotatedFrames, DatasetFrames, FileFrames, Workspace
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LabelMap, read_label_map
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.strict_json import printable
from procc_annotator.image.headers import PICTURE_SUFFIXES
from procc_annotator.messages import condensed, pluralize

_LABELS = 12  # are listed at most

Dataset = Annotated[
    Path,
    typer.Argument(
        help="Folder of pictures, annotations beside them or in annotations/; or one picture.",
    ),
]
Annotations = Annotated[
    Path | None,
    typer.Option(
        "--annotations", metavar="DIR", help="Folder of the annotation files, if elsewhere."
    ),
]
Cameras = Annotated[
    Path | None,
    typer.Option("--cameras", metavar="PATH", help="Folder, zip or file of cameras."),
]


def open_dataset(
    path: Path, field: Field, annotations: Path | None = None, names: LabelMap | None = None
) -> Workspace:
    """The dataset, to be read: its annotations may be of any format. It has a picture.

    Args:
        path, field: of the dataset.
        annotations: where they are, if elsewhere.
        names: what their labels stand for; None: as the dataset's own map says, if it has one.

    Raises:
        UsageError: no such folder, or no picture in it.
        InputError: none of the annotations can be read, or the dataset's map cannot be used.
    """
    for given in (path, annotations):
        if given is not None and not given.exists():
            raise UsageError(f"{given}: does not exist")
    held = "" if path.is_dir() else found_instead_of_pictures(path)
    if held:
        raise UsageError(f"nothing to do: there is no picture in {path}{held}")
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


@contextmanager
def annotated_frames(
    path: Path, field: Field, annotations: Path | None = None, labels: Path | None = None
) -> Iterator[tuple[AnnotatedFrames, FileSource | None]]:
    """The frames of a dataset; of annotations of any format where there is no picture, or where a
    map says what their labels stand for.

    Args:
        path, field, annotations: as of `open_dataset`.
        labels: such a map; None: the dataset's own, if it has one.

    Yields:
        Them, and what they are read from where that is not a dataset with pictures.

    Raises:
        UsageError: no such folder, or nothing annotated in it.
        InputError: annotations that cannot be opened or listed, or the map cannot be used.
    """
    if path.is_file() and path.suffix.lower() in PICTURE_SUFFIXES:
        pictured = True
    else:
        pictured = path.is_dir() and bool(
            pictures_in(path) or (has_pictures_below(path) and has_pictures(path))
        )
    names = own_label_map(path, field) if labels is None else read_label_map(labels, field)
    if (pictured and names is None) or not path.exists():
        yield DatasetFrames(open_dataset(path, field, annotations)), None
        return
    with open_annotations(annotations or annotations_of(path), field, names) as source:
        frames = FileFrames(source, field)
        if not frames.names:
            raise UsageError(f"nothing to do: no picture and no annotation in {path}")
        report_mismatch(source, field)
        yield frames, source


def open_cameras(
    path: Path | None,
    camera_format: str,
    camera_size: tuple[int, int] | None,
    field: Field,
) -> CameraSet | None:
    """The cameras, if any were asked for, of pictures that show a field; remarks on their files go
    to stderr.

    Raises:
        UsageError: no such folder or file, or no camera in it.
    """
    if path is None:
        return None
    if not path.exists():
        raise UsageError(f"{path}: does not exist")
    cameras = CameraSet.open(path, camera_format, camera_size=camera_size, field=field)
    if not cameras.frames:
        raise UsageError(
            f"nothing to do: no camera (format {camera_format}) in"
            f" {path}{found_instead_of_cameras(path)}"
        )
    report_remarks(cameras.notices)
    return cameras


def report_notices(notices: Mapping[str, int]) -> None:
    """One line each on stderr: the remark and for how many cameras, where it is for several; of
    many alike the first few."""
    for notice, count in condensed(notices).items():
        echo(f"note: {notice}" + (f" ({count} cameras)" if count > 1 else ""), err=True)


def report_remarks(remarks: Iterable[str]) -> None:
    """One line each on stderr."""
    for remark in remarks:
        echo(f"note: {remark}", err=True)


def report_mismatch(source: FileSource, field: Field, of: str = "") -> Mismatch | None:
    """One line on stderr where the field does not know most classes of a set, or another knows
    more of them; and one where files among the annotations are none.

    Args:
        source: annotations.
        field: what they are taken for.
        of: which set it is, where there are several.

    Returns:
        What was said.
    """
    report_remarks(f"{of}{notice}" for notice in list_annotations(source).notices)
    unknown = source.unknown if isinstance(source, ReadSource) else {}
    return report_mismatch_of(classes_of_source(source, field), field, source.path, of, unknown)


def report_camera_names(source: FileSource, of: str = "") -> None:
    """One line on stderr where pictures bear a camera's name, so that a set lacks their frames.

    Args:
        source: annotations.
        of: as of `report_mismatch`.
    """
    if remark := camera_name_remark_in(source.path):
        echo(f"note: {of}{remark}", err=True)


def report_mismatch_of(
    classes: Collection[str],
    field: Field,
    place: Path,
    of: str = "",
    unknown: Mapping[str, int] | None = None,
) -> Mismatch | None:
    """The same of classes that are known.

    Args:
        classes: names as in files.
        field: what they are taken for.
        place: where they are from; the field of that dataset may fit better.
        of: as of `report_mismatch`.
        unknown: labels of another program that stand for no class, and how many shapes have them.
    """
    mismatch, own = mismatch_at(classes, field, place)
    if unknown and (mismatch is None or mismatch.better is None):
        report_remarks([f"{of}{place}: {_unknown_words(unknown, field)}"])
        return mismatch
    if mismatch is None or not mismatch.is_worth_reporting:
        return None
    if mismatch.better is None:
        try_it = "; name the field they belong to: --field NAME or a .toml file"
    elif own is not None and mismatch.better.name == loadable(own):
        try_it = ", the dataset's own field: leave --field out"
    else:
        try_it = f": --field {mismatch.better.name}"
    echo(f"note: {of}{mismatch.words()}{try_it}", err=True)
    return mismatch


def _unknown_words(unknown: Mapping[str, int], field: Field) -> str:
    """Return the remark on labels that stand for no class, and what helps."""
    counts = [f"{printable(label)} ({count})" for label, count in unknown.items()]
    more = f", and {len(counts) - _LABELS} more" if len(counts) > _LABELS else ""
    return (
        f"the field {field.title} does not know {pluralize(len(counts), 'label')}:"
        f" {', '.join(counts[:_LABELS])}{more}; procc-annotator propose-map writes a labels.toml"
        " that says what they may stand for, for --map"
    )


def mismatch_at(
    classes: Collection[str], field: Field, place: Path
) -> tuple[Mismatch | None, Field | None]:
    """Return the remark on the classes of a set, and the field that its dataset says it shows.

    Args: as of `report_mismatch_of`.
    """
    mismatch = mismatch_of(classes, field)
    if mismatch is None:
        return None, None
    try:
        found = field_of_dataset(place)
    except InputError:  # a field file that is broken fits nothing
        return mismatch, None
    if not found.chosen:
        return mismatch, None
    if found.field != field:
        mismatch = mismatch_of(classes, field, (found.field,))
    return mismatch, found.field


def report_unreadable(problems: list[str], word: str = "unreadable") -> int:
    """One line each on stderr, after a word that says what they are, and one line for many files
    with the same problem; returns the exit code."""
    for problem in condense_problems(problems):
        echo(f"{word}: {problem}", err=True)
    return 1 if problems else 0
