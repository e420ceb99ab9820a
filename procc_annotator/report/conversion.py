"""Annotations from one format to another, for the command line and the window."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from pathlib import Path, PurePath
from typing import Any

from procc_annotator.errors import AnnotationError, ImageError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.image.decode import PICTURE_SUFFIXES
from procc_annotator.io.annotation_formats import (
    FORMATS,
    AnnotationFormat,
    find_annotations,
    format_named,
)
from procc_annotator.io.exchange import ExchangedFrame, Reading, Size, Writing
from procc_annotator.io.json_text import printable
from procc_annotator.io.masks import WIDEST
from procc_annotator.io.source import FileSource, open_source, read_file
from procc_annotator.report.picture_sizes import PictureSizes, picture_size
from procc_annotator.report.targets import Target, is_archive, open_target
from procc_annotator.session.workspace import ANNOTATIONS_FOLDER, Workspace

Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class Wanted:
    """What annotations are to become.

    Attributes:
        to: name of the format.
        line_width: of masks, px.
        folder: a folder inside the output for files of single frames; may be empty.
        into: an existing file of the format whose other content is kept; it is not changed itself.
        overwrite: whether files that are there are replaced (never those that are read).
    """

    to: str
    line_width: float = 4.0
    folder: str = ""
    into: Path | None = None
    overwrite: bool = False


@dataclass
class Converted:
    """What a conversion wrote and what it could not.

    Attributes:
        path: the file, folder or archive.
        source: title of the format that was read.
        title: title of the format that was written.
        frames, elements, points: how many were written.
        problems: one line for each frame or file that could not be read or written.
        losses: what the formats could not carry over, one line each.
    """

    path: Path
    source: str
    title: str
    frames: int = 0
    elements: int = 0
    points: int = 0
    problems: list[str] = attribute(default_factory=list)
    losses: list[str] = attribute(default_factory=list)


@dataclass
class Imported:
    """What was read to be taken into a dataset.

    Attributes:
        title: of the format.
        frames: frame -> what is annotated in it.
        problems, losses: as of `Converted`.
    """

    title: str
    frames: dict[str, ExchangedFrame] = attribute(default_factory=dict)
    problems: list[str] = attribute(default_factory=list)
    losses: list[str] = attribute(default_factory=list)


class _NothingWrittenError(Exception):
    """No frame was left to be written; whatever was begun is dropped."""


def convert_annotations(
    path: Path,
    out: Path,
    wanted: Wanted,
    field: Field,
    *,
    fmt: str = "auto",
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
    folder = _annotation_folder(path)
    _keep_apart(path, out)
    with open_source(folder) as source:
        known, files = find_annotations(source, fmt)
        sizes = PictureSizes(_picture_folders(path, folder), size)
        reading = Reading(field, sizes.size)
        assert known.read is not None
        frames = _once(known.read(source, files, reading), reading, progress)
        complete = (
            replace(f, size=f.size or sizes.size(f.name), picture=f.picture or sizes.name(f.name))
            for f in frames
        )
        inputs = _input_files(source)
        if wanted.into is not None:
            inputs.add(os.path.realpath(wanted.into))
        done = _write(complete, out, target, wanted, field, inputs)
    done.source = known.title
    return _with_reading(done, reading)


def export_as(
    workspace: Workspace,
    out: Path,
    wanted: Wanted,
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
    reading = Reading(workspace.field, total=len(workspace.frames))
    inputs = {os.path.realpath(f.annotation_path) for f in workspace.frames}
    sized = target.in_pixels or bool(target.one_file)
    frames = _frames_of(workspace, reading, set(drafts), progress, sized=sized)
    done = _write(frames, out, target, wanted, workspace.field, inputs)
    done.source = "the dataset"
    return _with_reading(done, reading)


def read_annotations(
    path: Path,
    workspace: Workspace,
    *,
    fmt: str = "auto",
    progress: Progress | None = None,
) -> Imported:
    """Annotations of any format, to be taken into a dataset whose pictures tell their sizes.

    Raises:
        UsageError, InputError: as for `convert_annotations`.
    """
    with open_source(_annotation_folder(path)) as source:
        known, files = find_annotations(source, fmt)
        reading = Reading(workspace.field, lambda name: _size_in(workspace, name))
        assert known.read is not None
        done = Imported(known.title)
        for frame in _once(known.read(source, files, reading), reading, progress):
            done.frames[frame.name] = frame
    done.problems, done.losses = reading.problems, reading.remarks.lines()
    return done


def check_line_width(width: float) -> float:
    """The width of a mask's lines, if it can be drawn.

    Raises:
        UsageError: it cannot.
    """
    if not 1 <= width <= WIDEST:
        raise UsageError(f"a line width is 1 to {WIDEST:g} px, not {width:g}")
    return width


# ------------------------------------------------------------------------------------- reading


def _once(
    frames: Iterable[ExchangedFrame], reading: Reading, progress: Progress | None
) -> Iterator[ExchangedFrame]:
    """The frames, each name once; the first one stays."""
    seen: set[str] = set()
    for done, frame in enumerate(frames, start=1):
        if progress is not None:
            progress(done, max(done, reading.total or 0))
        if frame.name in seen:
            reading.problems.append(
                f"{printable(frame.name)}: a second annotation of this frame is left out"
                " (rename one of the pictures)"
            )
            continue
        seen.add(frame.name)
        yield frame


def _frames_of(
    workspace: Workspace,
    reading: Reading,
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
            if annotation.polylines or annotation.extra or frame.annotation_path.exists():
                # A video's frame is kept as a png when it is kept.
                known = os.path.splitext(frame.image_file)[1].lower() in PICTURE_SUFFIXES
                picture = frame.image_file if known else f"{frame.name}.png"
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


def _annotation_folder(path: Path) -> Path:
    """Where the annotations of a dataset are; anything else is itself."""
    inner = path / ANNOTATIONS_FOLDER
    try:
        names = os.listdir(inner) if path.is_dir() else []
    except OSError:  # usually: no such folder
        return path
    return inner if any(name.lower().endswith((".json", ".xml")) for name in names) else path


def _picture_folders(path: Path, folder: Path) -> list[Path]:
    found = [folder, path] if path.is_dir() else []
    if not path.is_dir() or path.resolve().name == ANNOTATIONS_FOLDER:
        found.append(path.resolve().parent)
    return found


def _input_files(source: FileSource) -> set[str]:
    files = {os.path.realpath(source.display(name)) for name in source.files()}
    return files | {os.path.realpath(source.path)}


# ------------------------------------------------------------------------------------- writing


def _keep_apart(path: Path, out: Path) -> None:
    """An output must not be what is read, nor lie in it."""
    own, other = path.resolve(), out.resolve()
    if own == other or (path.is_dir() and other.is_relative_to(own)):
        raise UsageError(f"{out}: lies in what is read, write to another place than {path}")


def _write(
    frames: Iterable[ExchangedFrame],
    out: Path,
    target: AnnotationFormat,
    wanted: Wanted,
    field: Field,
    inputs: set[str],
) -> Converted:
    check_line_width(wanted.line_width)
    one_file = bool(target.one_file) and out.suffix == PurePath(target.one_file).suffix
    _check_place(out, one_file, wanted.overwrite)
    writing = Writing(
        field,
        lambda name, data: False,
        file_name=out.name if one_file else None,
        line_width=wanted.line_width,
        folder=_folder_name(wanted.folder),
        into=_existing(wanted.into, target),
    )
    done = Converted(out, "", target.title)
    with suppress(_NothingWrittenError):
        if is_archive(out):
            with open_target(out) as archive:
                writing.put = _into_archive(archive)
                target.write(frames, writing)
                if not writing.frames:
                    raise _NothingWrittenError
        else:
            folder = out.parent if one_file else out
            with open_target(folder) as files:
                writing.put = _into_folder(files, folder, writing, inputs, wanted.overwrite)
                target.write(frames, writing)
    done.frames, done.elements, done.points = writing.frames, writing.elements, writing.points
    done.problems, done.losses = writing.problems, writing.remarks.lines()
    return done


def _check_place(out: Path, one_file: bool, overwrite: bool) -> None:
    if one_file or is_archive(out):
        if out.is_dir():
            raise UsageError(f"{out}: is a folder, expected a file to write")
        if out.exists() and not overwrite:
            raise UsageError(f"{out}: exists already, choose another name or ask to overwrite it")
    elif out.exists() and not out.is_dir():
        raise UsageError(f"{out}: is a file, expected a folder to write to")


def _into_archive(archive: Target) -> Callable[[str, bytes], bool]:
    def put(name: str, data: bytes) -> bool:
        archive.write(name, data)
        return True

    return put


def _into_folder(
    files: Target, folder: Path, writing: Writing, inputs: set[str], overwrite: bool
) -> Callable[[str, bytes], bool]:
    def put(name: str, data: bytes) -> bool:
        path = folder / name
        if os.path.realpath(path) in inputs:
            raise UsageError(f"{path}: is one of the files that are read, write to another place")
        if not overwrite and path.exists():
            writing.problems.append(
                f"{path}: exists already and was not overwritten (choose another folder, or ask to"
                " overwrite)"
            )
            return False
        files.write(name, data)
        return True

    return put


def _existing(path: Path | None, target: AnnotationFormat) -> Any:
    if path is None:
        return None
    if target.decode_existing is None:
        kinds = ", ".join(f.name for f in FORMATS if f.decode_existing is not None)
        raise UsageError(f"only files of {kinds} can be written into, not {target.name}")
    return target.decode_existing(read_file(path, AnnotationError), str(path))


def _folder_name(name: str) -> str:
    if name and (PurePath(name).name != name or name in (".", "..") or not name.isprintable()):
        raise UsageError(f"{printable(name)!r} is not the name of a folder")
    return name


def _with_reading(done: Converted, reading: Reading) -> Converted:
    done.problems = [*reading.problems, *done.problems]
    done.losses = [*reading.remarks.lines(), *done.losses]
    return done
