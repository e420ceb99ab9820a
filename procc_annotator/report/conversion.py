"""Annotations from one format to another, for the command line and the window."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from procc_annotator.errors import ImageError
from procc_annotator.field.model import Field
from procc_annotator.image.suffixes import PICTURE_SUFFIXES
from procc_annotator.io.annotation_files.annotation_formats import format_named
from procc_annotator.io.annotation_files.exchange import (
    ExchangedFrame,
    ReadContext,
    Size,
)
from procc_annotator.io.annotation_files.label_map import LabelMap
from procc_annotator.io.annotation_files.read_set import ReadSet, SetReader, read_set
from procc_annotator.io.source import FileSource
from procc_annotator.report.conversion_output import (
    Converted,
    ConversionRequest,
    check_paths_apart,
    write_converted,
)
from procc_annotator.session.dataset.annotation_source import open_files
from procc_annotator.session.dataset.dataset_folder import annotations_or_path
from procc_annotator.session.dataset.picture_names import PicturesByName
from procc_annotator.session.dataset.picture_sizes import (
    PictureSizes,
    picture_folders,
    picture_size,
    picture_tree,
)
from procc_annotator.session.dataset.what_lies_there import refuse_other_content
from procc_annotator.session.dataset.workspace import Workspace

Progress = Callable[[int, int], None]


def convert_annotations(
    path: Path,
    out: Path,
    wanted: ConversionRequest,
    field: Field,
    *,
    fmt: str = "auto",
    names: LabelMap | None = None,
    size: Size | None = None,
    progress: Progress | None = None,
) -> Converted:
    """Write the annotations of a dataset, folder, archive or file in another format.

    Args:
        path: what is read; a dataset may keep its annotations in ``annotations/``.
        out: a folder, an archive if it ends in ``.zip``, or the file of a format of one file.
        wanted: the format and its options.
        field: knows the official names.
        fmt: format of what is read, or ``auto``.
        names: which classes the labels of the files stand for.
        size: of pictures that are not there and whose size no file tells.
        progress: called with frames done and frames in all.

    Returns:
        Figures; ``frames`` is 0 if nothing was left to write, and then nothing was written.

    Raises:
        UsageError: nothing to read, formats that cannot be told, an output that is an input.
        InputError: what is read cannot be opened or listed.
        SaveError: writing failed.
    """
    target = format_named(wanted.to)
    folder = annotations_or_path(path)
    check_paths_apart(path, out)
    with open_files(folder) as source:
        if fmt == "auto":
            refuse_other_content(source)
        sizes = PictureSizes(picture_folders(path, folder), size, picture_tree(path))
        reader = SetReader(
            source, field, names,
            fmt=fmt, size_of=sizes.size, pictures=sizes.names(), called=sizes.called,
        )  # fmt: skip
        complete = (
            replace(f, size=f.size or sizes.size(f.name), picture=f.picture or sizes.name(f.name))
            for f in reader.frames(progress)
        )
        inputs = _input_files(source, reader.files) | {
            os.path.realpath(path) for path in sizes.files()
        }
        if wanted.into is not None:
            inputs.add(os.path.realpath(wanted.into))
        done = write_converted(
            complete, out, target, wanted, field, inputs,
            lambda frame: _picture_among(sizes, frame),
        )  # fmt: skip
    done.source = reader.format.title
    done.problems = [*reader.reading.problems, *done.problems]
    done.losses = [*reader.losses, *done.losses]
    done.unknown = dict(reader.reading.unknown.most_common())
    return done


def export_as(
    workspace: Workspace,
    out: Path,
    wanted: ConversionRequest,
    *,
    drafts: Collection[str] = (),
    progress: Progress | None = None,
) -> Converted:
    """Write a dataset's annotations in any format.

    Args:
        workspace: the dataset.
        out: as for `convert_annotations`.
        wanted: the format and its options.
        drafts: frames with unconfirmed elements, which are not written.
        progress: called with frames done and frames in all.

    Raises:
        UsageError: the output lies in the dataset's annotations.
        SaveError: writing failed.
    """
    target = format_named(wanted.to)
    reading = ReadContext(workspace.field, total=len(workspace.frames))
    inputs = {os.path.realpath(f.annotation_path) for f in workspace.frames}
    sized = target.in_pixels or bool(target.one_file)
    frames = _frames_of(workspace, reading, set(drafts), progress, sized=sized)
    done = write_converted(
        frames, out, target, wanted, workspace.field, inputs,
        lambda frame: _picture_in(workspace, frame.name),
    )  # fmt: skip
    done.source = "the dataset"
    done.problems = [*reading.problems, *done.problems]
    done.losses = [*reading.remarks.lines(), *done.losses]
    return done


def read_annotations(
    path: Path,
    workspace: Workspace,
    *,
    fmt: str = "auto",
    names: LabelMap | None = None,
    progress: Progress | None = None,
) -> ReadSet:
    """Annotations of any format, to be taken into a dataset whose pictures tell their sizes.

    Raises:
        UsageError, InputError: as for `convert_annotations`.
    """
    with open_files(annotations_or_path(path)) as source:
        return read_set(
            source,
            workspace.field,
            names,
            fmt=fmt,
            size_of=lambda name: _size_in(workspace, name),
            pictures=sorted(frame.picture for frame in workspace.frames),
            called=PicturesByName(workspace.index).called,
            progress=progress,
        )


# ------------------------------------------------------------------------------------- reading


def _frames_of(
    workspace: Workspace,
    reading: ReadContext,
    drafts: set[str],
    progress: Progress | None,
    *,
    sized: bool,
) -> Iterator[ExchangedFrame]:
    """Every frame of a dataset that has an annotation, however short."""
    for index, frame in enumerate(workspace.frames):
        with reading.going_on():
            annotation = workspace.read(index)
            if frame.name in drafts:
                reading.remarks.add("unconfirmed elements are not written", frame.name)
            if annotation.polylines or annotation.extra or workspace.has_file(index):
                # A video's frame is kept as a png when it is kept.
                known = os.path.splitext(frame.image_file)[1].lower() in PICTURE_SUFFIXES
                picture = frame.picture if known else f"{frame.name}.png"
                size = _size_in(workspace, frame.name) if sized else None
                yield ExchangedFrame(frame.name, annotation, size, picture)
        if progress is not None:
            progress(index + 1, len(workspace.frames))


def _size_in(workspace: Workspace, name: str) -> Size | None:
    index = workspace.index.get(name)
    try:
        return None if index is None else picture_size(workspace.frames[index].image_path)
    except ImageError:
        return None


def _picture_among(sizes: PictureSizes, frame: ExchangedFrame) -> Path | None:
    """The picture that a file tells, or else the one that is called like its frame."""
    folder, slash, _ = frame.name.rpartition("/")
    told = folder + slash + Path(frame.picture or "").stem
    return sizes.path(told) or sizes.path(frame.name)


def _picture_in(workspace: Workspace, name: str) -> Path | None:
    """The file of a frame's picture; None for frames of a video, which have none."""
    path = workspace.frames[workspace.index[name]].image_path
    return path if path.is_file() else None


def _input_files(source: FileSource, read: Sequence[str]) -> set[str]:
    files = {os.path.realpath(source.display(name)) for name in (*source.files(), *read)}
    return files | {os.path.realpath(source.path)}
