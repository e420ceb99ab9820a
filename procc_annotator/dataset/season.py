"""The matches of a season: a tree of videos and archives of frames, or a list of them."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from natsort import natsorted

from procc_annotator.dataset.layout import (
    annotations_of,
    find_pictures,
    frames_folder,
    holds_annotations,
    json_names,
)
from procc_annotator.dataset.remote_files import file_name, local_path, url_of
from procc_annotator.errors import InputError, ProccError, require_existing
from procc_annotator.field.load import load_field_of
from procc_annotator.formats.csv_tables import read_table
from procc_annotator.formats.file_listing import ANNOTATIONS_FOLDER
from procc_annotator.formats.file_source import suffix_of, walk
from procc_annotator.formats.frame_names import is_file_name
from procc_annotator.image.archive import ARCHIVE_SUFFIXES
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.regular_file import read_head

FEWEST_PICTURES = 10  # of a match: fewer are posters and logos
STORE_FILE = "track.sqlite"  # in the folder that track writes to
COLUMNS = ("video", "match", "stadium", "field", "start")
_EXPECTED = f"a list of matches: columns {', '.join(COLUMNS)}, of which the last four may be absent"


@dataclass(frozen=True)
class Match:
    """A video, or a folder or archive of consecutive pictures.

    Attributes:
        name: distinguishes it in its season, without a suffix; may contain slashes.
        pictures: the video, archive or folder, or a URL.
        stadium: name of it, whose tripods and dimensions its matches share; empty if unknown.
        field: name or file of a field; empty for that of the command.
        start: when it began, as it is written.
    """

    name: str
    pictures: Path
    stadium: str = ""
    field: str = ""
    start: str = ""


def is_list(path: Path) -> bool:
    """Return whether a path may list matches: a CSV, or a folder that ``track`` writes to."""
    return path.suffix.lower() == ".csv" or (path / STORE_FILE).is_file()


def kinds_met_first(path: Path) -> frozenset[str]:
    """Suffixes of pictures, videos and archives in the first folder that has some, from a folder
    down, or of a file its own."""
    wanted = PICTURE_SUFFIXES | VIDEO_SUFFIXES | ARCHIVE_SUFFIXES
    with suppress(InputError):  # said when it is opened
        for _, names in walk(path) if path.is_dir() else [("", [path.name])]:
            if kinds := wanted.intersection(map(suffix_of, names)):
                return kinds
    return frozenset()


def list_matches(
    path: Path, remark: Callable[[str], None] = lambda _: None
) -> tuple[Match, ...] | None:
    """The matches of a season; None for a single one: a video, a folder of pictures, with fewer
    videos beside them, or of folders of pictures alone.

    Args:
        path: folder in which videos, archives and folders of pictures lie, at any depth, or a
            ``.csv`` that lists them, relative to its own folder; or a URL.
        remark: called with what a person should know of a list.

    Raises:
        UsageError: nothing there.
        InputError: a list that cannot be used, a folder that cannot be listed.
    """
    if url_of(path):
        is_list = file_name(path).suffix.lower() == ".csv"
        return tuple(_in_list(local_path(path), path.parent, remark)) if is_list else None
    require_existing(path)
    if path.is_dir():
        return _in_tree(path)
    return tuple(_in_list(path, path.parent, remark)) if path.suffix.lower() == ".csv" else None


def annotated_matches(path: Path) -> list[tuple[Match, Path]]:
    """The annotated matches of a season, each with the folder of its annotations: ``match_frames``
    next to ``match.mp4``. None of a single match, or of a folder with annotations of its own.

    Raises:
        UsageError, InputError: as of `list_matches`.
    """
    is_csv = path.suffix.lower() == ".csv" and path.is_file()
    if path.is_dir():
        if any(json_names(place) for place in (path, path / ANNOTATIONS_FOLDER)):
            return []
    elif not is_csv or b"video" not in read_head(path, 4096).partition(b"\n")[0]:  # points of VIA
        return []
    found = [(match, annotations_beside(match)) for match in list_matches(path) or ()]
    return [(match, place) for match, place in found if holds_annotations(place)]


def annotations_beside(match: Match) -> Path:
    """Return where a match's own annotations belong."""
    is_folder = match.pictures.is_dir()
    return annotations_of(match.pictures) if is_folder else frames_folder(match.pictures)


def _in_tree(root: Path) -> tuple[Match, ...] | None:
    found: list[Path] = []
    pictures: Counter[Path] = Counter()

    def refused(error: OSError) -> None:
        raise InputError(error.filename, f"cannot be listed: {error.strerror}") from error

    for folder, below, files in os.walk(root, onerror=refused):
        below[:] = [name for name in below if not name.startswith(".")]
        for name in files:
            suffix = "" if name.startswith(".") else suffix_of(name)
            if suffix in VIDEO_SUFFIXES or _holds_pictures(Path(folder, name), suffix):
                found.append(Path(folder, name))
            elif suffix in PICTURE_SUFFIXES:
                pictures[Path(folder)] += 1
    if not found or pictures[root] >= max(sum(place.parent == root for place in found), 1):
        return None
    kept = set(map(frames_folder, found))
    found += [place for place, n in pictures.items() if n >= FEWEST_PICTURES and place not in kept]
    called = Counter(place.with_suffix("") for place in found)
    matches = []
    for place in natsorted(found):
        alone = called[place.with_suffix("")] == 1 and not place.is_dir()
        named = place.relative_to(root)
        matches.append(Match((named.with_suffix("") if alone else named).as_posix(), place))
    return tuple(matches)


def _holds_pictures(path: Path, suffix: str) -> bool:
    """Return whether a file is an archive of pictures; a damaged one fails when it is opened."""
    try:
        return suffix in ARCHIVE_SUFFIXES and bool(find_pictures(path).folders)
    except InputError:
        return True


def _in_list(path: Path, folder: Path, remark: Callable[[str], None]) -> Iterator[Match]:
    names, rows = read_table(path, ("video",), _EXPECTED)
    if others := [name for name in names if name not in COLUMNS]:
        remark(f"{path}: columns left out: {', '.join(others)} (known: {', '.join(COLUMNS)})")
    lines: dict[str, int] = {}
    fields = {""}  # that can be used
    for line, row in rows:
        cells = {name: row.get(name, "").strip() for name in COLUMNS}
        place = f"line {line}"
        if not cells["video"]:
            raise InputError(path, "names no video", place=place)
        video = Path(cells["video"])
        video = video if url_of(video) else folder / video
        parts = [part.strip() for part in (cells["match"] or file_name(video).stem).split("/")]
        name = "/".join(parts)
        if (before := lines.get(name.casefold())) is not None:
            why = f"is the second match called {name!r}, after line {before}"
            raise InputError(path, why, place=place, advice="give them different names (match)")
        if not all(map(is_file_name, parts)):
            why = f"match {name!r} is no name of a file on every system"
            raise InputError(path, why, place=place)
        if cells["field"] not in fields:
            try:
                load_field_of(cells["field"])
            except ProccError as error:
                raise InputError(path, f"field: {error}", place=place) from error
            fields.add(cells["field"])
        lines[name.casefold()] = line
        yield Match(name, video, cells["stadium"], cells["field"], cells["start"])
    if not lines:
        raise InputError(path, f"lists no match, expected {_EXPECTED}")
