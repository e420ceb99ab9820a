"""Frames of a dataset with their annotation files, and the folder rows of the frame list."""

from __future__ import annotations

import os
from bisect import bisect_left
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import groupby
from pathlib import Path

from procc_annotator.dataset.layout import (
    PictureTree,
    annotation_folder,
    camera_name_remark,
    find_pictures,
    frames_folder,
    holds_annotations,
    json_names,
    json_stems,
)
from procc_annotator.errors import AnnotationError, InputError, UsageError
from procc_annotator.formats.annotations.registry import PLAIN, detect_json_format
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER, OWN_FILES, frame_in_tree
from procc_annotator.formats.file_source import read_optional, suffix_of, walk
from procc_annotator.formats.frame_names import PICTURE_FOLDERS, ByFrame, FrameTable
from procc_annotator.formats.unread_formats import unread_format
from procc_annotator.image.archive import is_archive_file
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES, is_turned_jpeg
from procc_annotator.messages import list_names

_LOOKED_INTO = 20  # pictures of a set


@dataclass(frozen=True, slots=True)
class Folder:
    """A folder of frames.

    Attributes:
        path: below the dataset, without a slash at its end.
        label: what it is called in the folder shown above it; folders that hold nothing but one
            other are one with it (``season/game``).
        depth: how many folders are shown above it.
        first, past: the frames in it and below it.
        own_past: the first of those that lies deeper.
        end: the place of the next folder in the list that is not below it.
    """

    path: str
    label: str
    depth: int
    first: int
    past: int
    own_past: int
    end: int = 0

    def __contains__(self, frame: int) -> bool:
        return self.first <= frame < self.past


@dataclass
class _Node:
    path: str
    first: int = -1
    own_past: int = -1
    past: int = -1
    inner: dict[str, _Node] = field(default_factory=dict)


def folders_of(names: Sequence[str]) -> tuple[Folder, ...]:
    """The folders of a tree, each before those in it; none of a flat dataset. The names of the
    frames come folder after folder, a folder's own before those of the folders in it."""
    root, at = _Node(""), 0
    for folder, group in groupby(names, key=lambda name: name.rpartition("/")[0]):
        past = at + sum(1 for _ in group)
        node = root
        for part in folder.split("/") if folder else ():
            node = node.inner.setdefault(part, _Node(f"{node.path}/{part}".lstrip("/"), at, at))
            node.past = past
        if folder:
            node.own_past = past
        at = past
    found: list[Folder] = []
    for node in root.inner.values():
        _add(node, "", 0, found)
    return tuple(found)


def _add(node: _Node, above: str, depth: int, found: list[Folder]) -> None:
    while node.own_past == node.first and len(node.inner) == 1:
        (node,) = node.inner.values()
    label = node.path.removeprefix(above).lstrip("/")
    place = len(found)
    found.append(Folder(node.path, label, depth, node.first, node.past, node.own_past))
    for inner in node.inner.values():
        _add(inner, f"{node.path}/", depth + 1, found)
    found[place] = replace(found[place], end=len(found))


def rows_of(
    folders: Sequence[Folder], folded: Collection[str], shown: Sequence[int] | None
) -> list[int]:
    """Return what a list shows, row by row: a frame, or -1 - k for folder k; folders without a
    frame that is shown are left out.

    Args:
        folded: paths of those that are shown without their content.
        shown: ascending, the frames that a filter lets through; None: all.
    """
    rows: list[int] = []
    place = 0
    while place < len(folders):
        folder = folders[place]
        first, own_past, past = (
            at if shown is None else bisect_left(shown, at)
            for at in (folder.first, folder.own_past, folder.past)
        )
        if first < past:
            rows.append(-1 - place)
        if first == past or folder.path in folded:
            place = folder.end
            continue
        rows += range(first, own_past) if shown is None else shown[first:own_past]
        place += 1
    return rows


@dataclass(frozen=True, slots=True)
class Frame:
    """One picture of the dataset and the file its annotation belongs in.

    ``annotation_stem`` is what that file is called below its folder where that is not the frame's
    name: its letters are composed otherwise, or it lies next to the picture in a tree.
    ``annotation_suffix`` is as the file there has it.
    """

    name: str
    image_file: str
    image_folder: Path
    annotation_folder: Path
    annotation_stem: str = ""
    annotation_suffix: str = ".json"

    # Paths are made when asked for: making them for 20,000 frames costs more than listing those.
    @property
    def image_path(self) -> Path:
        """The picture."""
        return self.image_folder / self.image_file

    @property
    def picture(self) -> str:
        """The name of the picture as files give it: with its path, if the frame is called so."""
        folder, slash, _ = self.name.rpartition("/")
        return folder + slash + self.image_file

    @property
    def annotation_path(self) -> Path:
        """Return where its annotation is or will be."""
        return self.annotation_folder / (
            f"{self.annotation_stem or self.name}{self.annotation_suffix}"
        )


def list_frames(
    path: Path, annotations: Path | None = None
) -> tuple[Path, tuple[Frame, ...], tuple[str, ...]]:
    """List a dataset's pictures in natural order, see `find_pictures`, or take a single picture.

    Annotations of pictures in an archive lie next to it, as those of a video: `frames_folder`.

    Args:
        path: folder, archive or picture.
        annotations: folder of the annotation files, if it is not where it would be looked for.

    Returns:
        The dataset's folder, its frames, and what the user should know of it.

    Raises:
        UsageError: no such folder, or a file that is no picture.
        InputError: a folder that cannot be listed.
    """
    if path.is_dir():
        root, found = path, find_pictures(path)
    elif is_archive_file(path):
        root, found, annotations = path, find_pictures(path), annotations or frames_folder(path)
    elif not path.exists():
        raise UsageError(f"{path}: no such file or folder")
    elif path.suffix.lower() in VIDEO_SUFFIXES:
        raise UsageError(
            f"{path}: is a video, and pictures are needed: keep frames of it in the window"
            f" (Ctrl+Shift+S), then name {frames_folder(path)}"
        )
    elif path.suffix.lower() not in PICTURE_SUFFIXES:
        if (known := unread_format(path.name)) is not None:
            raise UsageError(f"{path}: {known.problem} ({known.advice})")
        kinds = ", ".join(sorted(PICTURE_SUFFIXES))
        raise UsageError(f"{path}: not a picture (expected {kinds}) and not a folder")
    else:
        root, found = path.parent, PictureTree((("", (path.name,)),))
    listing = _Listing(root, found, annotations)
    for below, names in found.folders:
        listing.add(below, names)
    frames = tuple(listing.frames.values())
    notices = [*found.notices, *listing.notices]
    if remark := camera_name_remark(frame.image_file for frame in frames):
        notices.insert(0, remark)  # the window shows the first three
    if turned := [one.name for one in frames[:_LOOKED_INTO] if is_turned_jpeg(one.image_path)]:
        notices.append(f"{list_names(turned, 'frame')}: shown turned, as EXIF data of the file say")
    if annotations is None and not found.in_tree and not listing.beside_others:
        notices += _not_used(root, found.only_folder, frames)
    return frames_folder(path) if is_archive_file(path) else root, frames, tuple(notices)


class _Listing:
    def __init__(self, root: Path, found: PictureTree, annotations: Path | None) -> None:
        self.frames: dict[str, Frame] = {}
        self.notices: list[str] = []
        self._root, self._found = root, found
        self._apart = annotations
        if annotations is None and found.in_tree:
            inner = root / ANNOTATIONS_FOLDER
            self._apart = inner if found.container or holds_annotations(inner) else None
        self.beside_others = self._apart is None and _taken_by_others(root, found)
        if self.beside_others:
            self._apart = root / ANNOTATIONS_FOLDER

    def add(self, below: str, names: Iterable[str]) -> None:
        """Take down the pictures of a folder."""
        called = self._found.called(below)
        in_tree = self._found.in_tree
        folder = self._apart or _folder_of(self._root, below, names, in_tree=in_tree)
        # Next to its picture an annotation file has no path in its name.
        prefix = called if self._apart is not None else ""
        image_folder = self._root / below if below else self._root
        stems, suffixes = self._files_apart if prefix else _files_in(folder, names)
        for file_name in names:
            stem = os.path.splitext(file_name)[0]
            name = called + stem
            if (own := f"{stem}.json") in OWN_FILES:
                self.notices.append(
                    f"{called}{file_name} is left out: {own} is not its annotation; rename it"
                )
            elif name in self.frames:
                kept = self.frames[name].image_file
                self.notices.append(
                    f"{called}{file_name} is left out: {kept} already is frame {name}"
                )
            else:
                there = stems.get(prefix + stem, prefix + stem)
                written = "" if there == name else there
                suffix = suffixes.get(there, ".json")
                self.frames[name] = Frame(name, file_name, image_folder, folder, written, suffix)

    @cached_property
    def _files_apart(self) -> tuple[ByFrame[str], dict[str, str]]:
        """As `_files_in`, of the whole tree of annotations that lies apart, by the names of their
        frames."""
        files = []
        folder = self._apart or self._root
        for below, names in walk(folder, lambda _: None) if folder.is_dir() else ():
            files += [below + name for name in names if suffix_of(name) == ".json"]
        stems = ((frame_in_tree(file, ANNOTATIONS_FOLDER), file[:-5]) for file in files)
        return FrameTable(stems), _unusual_suffixes(files)


def _files_in(folder: Path, names: Iterable[str]) -> tuple[ByFrame[str], dict[str, str]]:
    """The JSON files in a folder, with letters perhaps composed otherwise than in the names of
    pictures, by their stems, and `_unusual_suffixes`."""
    files = json_names(folder)
    plain = all(map(str.isascii, names))
    stems = ByFrame[str]() if plain else ByFrame((n[:-5], n[:-5]) for n in files)
    return stems, _unusual_suffixes(files)


def _unusual_suffixes(names: Sequence[str]) -> dict[str, str]:
    """Stems of the JSON files that have a suffix in capital letters, with it; not where there is
    the usual one next to it."""
    found = {name[:-5]: name[-5:] for name in names if not name.endswith(".json")}
    for name in names if found else ():
        if name.endswith(".json"):
            found.pop(name[:-5], None)
    return found


def _folder_of(root: Path, below: str, names: Iterable[str], *, in_tree: bool) -> Path:
    if in_tree:
        return _folder_in_tree(root, below, names)
    if not below:
        return annotation_folder(root)
    usual = annotation_folder(root)
    if usual != root or _has_any_of(root, names):
        return usual
    beside = annotation_folder(root / below)
    return beside if json_stems(beside) else root / ANNOTATIONS_FOLDER


def _folder_in_tree(root: Path, below: str, names: Iterable[str]) -> Path:
    """The same in a tree: next to the pictures; next to the folder that only keeps pictures, where
    annotations of them are there and none is next to them."""
    beside = annotation_folder(root / below)
    inner = next((name for name in PICTURE_FOLDERS if f"/{below}".endswith(f"/{name}/")), "")
    if not inner or json_stems(beside):
        return beside
    above = annotation_folder(root / below.removesuffix(f"{inner}/"))
    return above if _has_any_of(above, names) else beside


def _has_any_of(folder: Path, names: Iterable[str]) -> bool:
    stems = _stems_in(folder)
    return any(os.path.splitext(name)[0] in stems for name in names)


def _stems_in(folder: Path) -> ByFrame[str]:
    return ByFrame((stem, stem) for stem in json_stems(folder))


def _taken_by_others(root: Path, found: PictureTree) -> bool:
    """Return whether a file of another program has the name that an annotation next to its picture
    would have, as labelme's have: those that are made here go to ``annotations/``. The first such
    file says."""
    for below, names in found.folders:
        folder = root / below
        stems = _stems_in(folder) if annotation_folder(folder) == folder else ByFrame[str]()
        if first := next(filter(None, (stems.get(os.path.splitext(n)[0]) for n in names)), None):
            try:
                told = detect_json_format(
                    read_optional(folder / f"{first}.json", AnnotationError) or b""
                )
            except InputError:  # is told where the frame is read
                return False
            return told is not None and told.name != PLAIN
    return False


def _not_used(root: Path, only_folder: str, frames: Sequence[Frame]) -> Iterator[str]:
    folder = frames[0].annotation_folder if frames else root
    beside = root / only_folder if only_folder else root
    if folder == beside:
        return
    names = ByFrame((frame.name, None) for frame in frames)
    if unused := sum(stem in names for stem in json_stems(beside)):
        yield f"annotations are those in {folder}; {unused} next to the pictures are not used"


def video_frame(video: Path, number: int) -> Frame:
    """A frame of a video as one of its dataset, with its annotation in `frames_folder`."""
    name = f"{video.stem}_{number:06d}"
    return Frame(name, f"{number:08d}", video, frames_folder(video))
