"""Write a converted set, per game if the format needs it, without overwriting."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from dataclasses import field as attribute
from functools import partial
from itertools import chain
from pathlib import Path, PurePath
from typing import Any

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.diagnostics import classes_in, mismatch_of
from procc_annotator.errors import AnnotationError, ImageError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.exchange import ExchangedFrame, Remarks, WriteContext
from procc_annotator.formats.annotations.masks import check_line_width
from procc_annotator.formats.annotations.registry import FORMATS, LABELME, AnnotationFormat
from procc_annotator.formats.annotations.soccernet_set import official_frames, require_soccernet
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.frame_names import is_file_name
from procc_annotator.formats.strict_json import printable
from procc_annotator.report.outputs import Target, is_archive, open_target


@dataclass
class Game:
    """The frames of one folder.

    Attributes:
        folder: below the output; empty for its top.
        frames: called without the folder, as the file of the game calls them.
        whole: how each is called in the set, by its name here.
    """

    folder: str
    frames: list[ExchangedFrame] = attribute(default_factory=list)
    whole: dict[str, ExchangedFrame] = attribute(default_factory=dict)

    def called(self, name: str) -> str:
        """Return how a frame of this game is called in the set."""
        return self.whole[name].name if name in self.whole else name


def games_of(frames: Iterable[ExchangedFrame], pictures: str) -> list[Game]:
    """The frames by their folders, in the order they come in.

    Args:
        frames: of a set, which may be in a tree.
        pictures: the folder that the format has the pictures of a game in (``img1``): it is no
            part of the game's name.
    """
    games: dict[str, Game] = {}
    for frame in frames:
        folder, _, name = frame.name.rpartition("/")
        if folder == pictures or folder.endswith(f"/{pictures}"):
            folder = folder[: -len(pictures)].rstrip("/")
        game = games.setdefault(folder, Game(folder))
        picture = None if frame.picture is None else frame.picture.rpartition("/")[2]
        game.frames.append(replace(frame, name=name, picture=picture))
        game.whole[name] = frame
    return list(games.values())


def write_game(game: Game, writing: WriteContext, write: Callable[[WriteContext], None]) -> None:
    """Write a game into its folder by `write`, and count and report what became of it with the
    whole set."""

    def put(name: str, data: bytes) -> bool:
        return writing.put(f"{game.folder}/{name}" if game.folder else name, data)

    own = replace(writing, put=put, problems=[], remarks=Remarks(), frames=0, elements=0, points=0)
    write(own)
    prefix = f"{game.folder}/" if game.folder else ""
    writing.problems += [prefix + problem for problem in own.problems]
    writing.remarks.take(own.remarks, game.called)
    writing.frames += own.frames
    writing.elements += own.elements
    writing.points += own.points


@dataclass(frozen=True)
class ConversionRequest:
    """Target of a conversion of annotations.

    Attributes:
        to: name of the format.
        line_width: of masks, px.
        folder: the split: a folder inside the output for files of single frames, or part of a
            file's name; may be empty.
        into: an existing file of the format whose other content is kept; it is not changed itself.
        overwrite: whether files that are there are replaced (never those that are read).
        keep_optional: whether formats of SoccerNet get a field's optional elements as well, which
            the official evaluation does not know.
    """

    to: str
    line_width: float = 4.0
    folder: str = ""
    into: Path | None = None
    overwrite: bool = False
    keep_optional: bool = False
    pictures: bool = False


@dataclass
class Converted:
    """Result of a conversion, with problems.

    Attributes:
        path: the file, folder or archive.
        source: title of the format that was read.
        title: title of the format that was written.
        frames, elements, points: how many were written.
        classes: those of the first frames that have any, as far as it was looked.
        unknown: labels of another program that stand for no class, and how many shapes have them.
        problems: one line for each frame or file that could not be read or written.
        losses: what the formats could not carry over, one line each.
    """

    path: Path
    source: str
    title: str
    frames: int = 0
    elements: int = 0
    points: int = 0
    classes: frozenset[str] = frozenset()
    unknown: Mapping[str, int] = attribute(default_factory=dict)
    problems: list[str] = attribute(default_factory=list)
    losses: list[str] = attribute(default_factory=list)


class _NothingWrittenError(Exception):
    """No frame was left to be written; whatever was begun is dropped."""


def check_paths_apart(path: Path, out: Path) -> None:
    """An output must not be what is read, nor lie in it."""
    own, other = path.resolve(), out.resolve()
    if own == other or (path.is_dir() and other.is_relative_to(own)):
        raise UsageError(f"{out}: lies in what is read, write to another place than {path}")


def write_converted(
    frames: Iterable[ExchangedFrame],
    out: Path,
    target: AnnotationFormat,
    wanted: ConversionRequest,
    field: Field,
    inputs: set[str],
    picture_of: Callable[[ExchangedFrame], Path | None] = lambda _: None,
) -> Converted:
    """Write frames in a format.

    Args:
        out: a folder, an archive if it ends in ``.zip``, or the file of a format of one file.
        inputs: real paths of the files that are read.
        picture_of: where a frame's picture is; None if nowhere.

    Raises:
        UsageError: a place or an option that makes no sense, an output that is an input, a format
            of SoccerNet's own for another sport or for classes that are another sport's.
        AnnotationError: the existing file is not of the format.
        SaveError: writing failed; an archive is then not there.
    """
    check_line_width(wanted.line_width)
    if target.classes == "soccernet":
        require_soccernet(field, target.title)
    one_file = _is_one_file(out, target)
    _check_place(out, one_file, wanted.overwrite)
    writing = WriteContext(
        field,
        lambda name, data: False,
        file_name=out.name if one_file else None,
        line_width=wanted.line_width,
        folder=_folder_name(wanted.folder) or target.split,
        into=_existing(wanted.into, target),
    )
    classes, frames = _looked_into(frames)
    if target.classes == "soccernet":
        _require_classes(classes, field, target)
    if target.classes != "any" and not wanted.keep_optional:
        frames = official_frames(frames, field, writing.remarks)
    done = Converted(out, "", target.title, classes=classes)
    with suppress(_NothingWrittenError):
        if is_archive(out):
            with open_target(out) as archive:
                writing.put = _into_archive(archive)
                _write(frames, target, writing, wanted, picture_of)
                if not writing.frames:
                    raise _NothingWrittenError
        else:
            folder = out.parent if one_file else out
            with open_target(folder) as files:
                writing.put = _into_folder(files, folder, writing, inputs, wanted.overwrite)
                _write(frames, target, writing, wanted, picture_of)
    done.frames, done.elements, done.points = writing.frames, writing.elements, writing.points
    done.problems, done.losses = writing.problems, writing.remarks.lines()
    return done


def _write(
    frames: Iterable[ExchangedFrame],
    target: AnnotationFormat,
    writing: WriteContext,
    wanted: ConversionRequest,
    picture_of: Callable[[ExchangedFrame], Path | None],
) -> None:
    """Write the set, or each game of a tree by itself where that is what the format's file is."""
    if not target.by_game or writing.file_name is not None or writing.into is not None:
        if wanted.pictures:
            frames = _with_pictures(frames, target, writing, picture_of)
        target.write(frames, writing)
        return
    for game in games_of(frames, target.pictures or ""):
        write_game(game, writing, partial(_write_game, game, target, wanted, picture_of))


def _write_game(
    game: Game,
    target: AnnotationFormat,
    wanted: ConversionRequest,
    picture_of: Callable[[ExchangedFrame], Path | None],
    writing: WriteContext,
) -> None:
    frames: Iterable[ExchangedFrame] = game.frames
    if wanted.pictures:
        frames = _with_pictures(
            frames, target, writing, lambda frame: picture_of(game.whole[frame.name])
        )
    target.write(frames, writing)


def _is_one_file(out: Path, target: AnnotationFormat) -> bool:
    suffix = PurePath(target.one_file).suffix
    one_file = bool(target.one_file) and out.suffix == suffix
    if target.one_file and not one_file and out.suffix in (".json", ".xml") and not out.is_dir():
        raise UsageError(
            f"{out}: expected a name that ends in {suffix} for the file of {target.name}, .zip for"
            " an archive, or a folder"
        )
    return one_file


def _looked_into(
    frames: Iterable[ExchangedFrame],
) -> tuple[frozenset[str], Iterable[ExchangedFrame]]:
    """The classes of the first frames that have any, and all frames again."""
    rest = iter(frames)
    ahead: list[ExchangedFrame] = []

    def read() -> Iterator[Callable[[], FrameAnnotation]]:
        for frame in rest:
            ahead.append(frame)
            yield lambda: ahead[-1].annotation

    return classes_in(read()), chain(ahead, rest)


def _with_pictures(
    frames: Iterable[ExchangedFrame],
    target: AnnotationFormat,
    writing: WriteContext,
    picture_of: Callable[[ExchangedFrame], Path | None],
) -> Iterator[ExchangedFrame]:
    """The frames; the picture of each that the writer takes is copied into the output."""
    if target.pictures is None:
        raise UsageError(f"{target.title} goes without pictures")
    folder = target.pictures.format(split=writing.folder)
    for frame in frames:
        before = len(writing.problems)
        yield frame
        if len(writing.problems) > before:  # it was not written
            continue
        path = picture_of(frame)
        if path is None:
            writing.remarks.add("pictures were not found and are not copied", frame.name)
            continue
        # labelme reads the very name; the others know a picture by its frame.
        name = (writing.picture if target.name == LABELME else writing.picture_of_frame)(frame)
        writing.put(f"{folder}/{name}".lstrip("/"), read_file(path, ImageError))


def _require_classes(classes: Collection[str], field: Field, target: AnnotationFormat) -> None:
    """A set without a field of its own may be of another sport all the same."""
    mismatch = mismatch_of(classes, field)
    if mismatch is not None and mismatch.is_worth_reporting:
        raise UsageError(
            f"{target.title} is for the classes of SoccerNet, but {mismatch.words()}; choose"
            " soccernet, labelme, cvat or coco, which hold any class"
        )


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
    files: Target, folder: Path, writing: WriteContext, inputs: set[str], overwrite: bool
) -> Callable[[str, bytes], bool]:
    def put(name: str, data: bytes) -> bool:
        path = folder / name
        if os.path.realpath(path) in inputs:
            raise UsageError(f"{path}: is one of the files that are read, write to another place")
        if not overwrite and path.exists():
            if path.stat().st_size == len(data) and read_file(path) == data:
                return True  # as a run that was stopped has left it
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
    if name and not is_file_name(name):
        raise UsageError(f"{printable(name)!r} is not the name of a folder")
    return name
