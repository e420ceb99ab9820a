"""Collect and write a release as a folder or an archive."""

from __future__ import annotations

import hashlib
import json
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import msgspec

from procc_annotator.dataset.layout import STADIUMS_FILE
from procc_annotator.dataset.picture_sizes import PictureSizes, picture_size
from procc_annotator.errors import ImageError, InputError, SaveError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.registry import read_plain
from procc_annotator.formats.atomic import remove
from procc_annotator.formats.csv_tables import read_table
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import RELEASE_FILE, FileSource, read_file
from procc_annotator.formats.frame_names import FrameTable, escapes_folder
from procc_annotator.formats.strict_json import decode_as, is_unicode, printable
from procc_annotator.report.outputs import is_archive, open_target
from procc_annotator.report.release.contents import (
    AGREEMENT_FILE,
    ANNOTATIONS,
    CARD_FILE,
    CHANGES_FILE,
    CROISSANT_FILE,
    FIELD_COPY,
    FINDINGS_FILE,
    INDEX_FILE,
    ONE_SPLIT,
    PICTURES,
    PROVENANCE_FILE,
    RELEASE_FORMAT,
    SPLITS,
    Release,
    ReleasedFrame,
    ReleasedPicture,
    index_table,
)
from procc_annotator.report.release.metadata import (
    Changes,
    changed_frame,
    changelog,
    croissant_bytes,
    dataset_card,
)
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes
from procc_annotator.version import __version__

Progress = Callable[[int, int], None]


@dataclass
class Gathered:
    """Frames on their way into a release, and what cannot be used of them, one line each."""

    frames: list[ReleasedFrame] = field(default_factory=list)
    problems: list[str] = field(default_factory=list)


def gather_frames(
    source: FileSource,
    known: Field,
    splits: Mapping[str, str],
    pictures: PictureSizes,
    progress: Progress,
) -> Gathered:
    """Read every annotation, and hash it and its picture.

    Args:
        known: the elements.
        splits: frame -> split; where it is empty, all frames are in one.
    """
    found = Gathered()
    files = list_annotations(source)
    for number, (name, file) in enumerate(files.items(), 1):
        progress(number, len(files))
        if splits and name not in splits:
            found.problems.append(f"{name}: is in no split; left out")
            continue
        if not is_unicode(name):
            found.problems.append(
                f"{printable(name)}: is no valid Unicode; left out (rename the file)"
            )
            continue
        try:
            data = source.read(file)
            annotation = read_plain(data, source.display(file), known)
        except InputError as error:
            found.problems.append(str(error))
            continue
        path = pictures.path(name)
        picture = None
        if path is not None:
            try:
                picture = _picture(path, pictures.name(name) or path.name)
            except InputError as error:
                found.problems.append(str(error))
        split = splits.get(name, ONE_SPLIT)
        found.frames.append(ReleasedFrame(name, split, data, _sha256(data), annotation, picture))
    if not found.frames:
        raise UsageError(f"nothing to do: no annotation of {source.path} can be released")
    return found


def origins_of(provenance: bytes) -> dict[str, int]:
    """Return how many points came to be in which way, the most frequent first.

    Args:
        provenance: as `report.release.contents` writes it.
    """
    content: dict[str, Any] = json.loads(provenance)
    counts = Counter(
        "from a file" if point is None else str(point[0])
        for elements in content["frames"].values()
        for points in elements.values()
        for point in points
    )
    return dict(counts.most_common())


def write_release(
    release: Release,
    out: Path,
    before: Path | None,
    picture_of: Callable[[str], Path | None],
    progress: Progress,
) -> Changes | None:
    """Write everything; returns what changed since the release before.

    What a release in the same folder has, and this one does not, is removed.

    Args:
        out: a folder, or an archive if it ends in ``.zip``.
        before: folder of the release before.
        picture_of: frame -> its picture's path.

    Raises:
        InputError: the release before, or a picture, cannot be read.
        SaveError: writing failed; an archive is then not there.
    """
    changes = None if before is None else changes_since(before, release)
    earlier = "" if before is None else _earlier_changes(before)
    index = csv_bytes(index_table(release.frames))
    older = () if is_archive(out) else _files_of_release(out)
    with open_target(out) as target:
        for number, frame in enumerate(release.frames, 1):
            progress(number, len(release.frames))
            target.write(f"{ANNOTATIONS}/{frame.name}.json", frame.data)
            path = picture_of(frame.name) if release.with_pictures else None
            if path is not None and frame.picture is not None:
                target.write(f"{PICTURES}/{frame.picture.file}", read_file(path, ImageError))
        for split, names in release.splits.items():
            target.write(f"{SPLITS}/{split}.txt", "".join(f"{n}\n" for n in names).encode())
        for name, data in release.files:
            target.write(name, data)
        target.write(INDEX_FILE, index)
        target.write(CROISSANT_FILE, croissant_bytes(release, index, _sha256(index)))
        target.write(CHANGES_FILE, changelog(release.terms, changes, earlier))
        target.write(RELEASE_FILE, _release_bytes(release))
        target.write(CARD_FILE, dataset_card(release))
    _remove(out, set(older) - _own_files(release))
    return changes


def _own_files(release: Release) -> set[str]:
    """Return what a release has, but for the files that every release has."""
    pictures = [f.picture.file for f in release.frames if f.picture and release.with_pictures]
    return {
        *(f"{ANNOTATIONS}/{frame.name}.json" for frame in release.frames),
        *(f"{PICTURES}/{file}" for file in pictures),
        *(f"{SPLITS}/{split}.txt" for split in release.splits),
        *(name for name, _ in release.files),
    }


def _files_of_release(folder: Path) -> set[str]:
    """The same of a release that was written to a folder; nothing if absent."""
    if not (folder / RELEASE_FILE).exists():
        return set()
    frames = _read_release(folder).frames
    _, rows = read_table(folder / INDEX_FILE, (), "")
    pictures = [row.get("picture", "") for _, row in rows]
    return {
        *(f"{ANNOTATIONS}/{name}.json" for name in frames),
        *(f"{PICTURES}/{file}" for file in pictures if file and not escapes_folder(file)),
        *(f"{SPLITS}/{one.split}.txt" for one in frames.values() if not escapes_folder(one.split)),
        *(FINDINGS_FILE, AGREEMENT_FILE, PROVENANCE_FILE, FIELD_COPY, STADIUMS_FILE),
    }


def _remove(folder: Path, names: Iterable[str]) -> None:
    """Remove files of a folder, those that are there."""
    for name in names:
        try:
            remove(folder / name)
        except OSError as error:
            raise SaveError(f"{folder / name}: could not be removed: {error.strerror}") from error


def changes_since(before: Path, release: Release) -> Changes:
    """Return what changed since a release.

    Raises:
        InputError: it is no release, or cannot be read.
    """
    known = _read_release(before)
    then = FrameTable(known.frames)
    now = FrameTable((frame.name, frame) for frame in release.frames)
    changed = []
    for name, frame in now.items():
        entry = then.get(name)
        if entry is None or entry.sha256 == frame.sha256:
            continue
        path = before / ANNOTATIONS / f"{then.name_there(name)}.json"
        was = read_plain(read_file(path), str(path), release.field)
        if (found := changed_frame(name, was, frame.annotation)) is not None:
            changed.append(found)
    splits = (n for n, f in now.items() if n in then and then[n].split != f.split)
    pictures = (n for n, f in now.items() if n in then and _is_another(then[n], f.picture))
    return Changes(
        f"version {known.version}",
        tuple(name for name in now if name not in then),
        tuple(name for name in then if name not in now),
        tuple(changed),
        tuple(splits),
        tuple(pictures),
        known.field_sha256 != release.fingerprint,
    )


def _is_another(then: _Entry, picture: ReleasedPicture | None) -> bool:
    """Return whether a frame has another picture than before; not where either has none."""
    known = picture is not None and then.picture_sha256 is not None
    return known and picture is not None and then.picture_sha256 != picture.sha256


@dataclass(frozen=True)
class _Entry:
    split: str
    sha256: str
    picture_sha256: str | None = None


@dataclass(frozen=True)
class _Known:
    """Content of `RELEASE_FILE`."""

    format: str
    name: str
    version: str
    date: str
    field: str
    field_sha256: str
    frames: dict[str, _Entry]
    program: str = ""


def _release_bytes(release: Release) -> bytes:
    frames = {
        frame.name: _Entry(
            frame.split, frame.sha256, None if frame.picture is None else frame.picture.sha256
        )
        for frame in release.frames
    }
    terms = release.terms
    known = _Known(
        RELEASE_FORMAT, terms.name, terms.version, terms.date, release.field.described,
        release.fingerprint, frames, f"procc-annotator {__version__}",
    )  # fmt: skip
    return json_bytes(msgspec.to_builtins(known))


def _read_release(folder: Path) -> _Known:
    path = folder / RELEASE_FILE
    known = decode_as(read_file(path), _Known, "release", path=path)
    if known.format != RELEASE_FORMAT:
        raise InputError(path, f"is of format {known.format[:60]!r}, expected {RELEASE_FORMAT!r}")
    for name in known.frames:
        if not name or escapes_folder(name):
            raise InputError(path, f"{name[:60]!r} is no name of a frame")
    return known


def _earlier_changes(before: Path) -> str:
    path = before / CHANGES_FILE
    if not path.exists():
        return ""
    text = read_file(path).decode("utf-8", "replace")
    return text.partition("\n## ")[2] and "## " + text.partition("\n## ")[2]


def _picture(path: Path, file: str) -> ReleasedPicture:
    data = read_file(path, ImageError)
    width, height = picture_size(path)
    return ReleasedPicture(file, _sha256(data), len(data), width, height)


def _sha256(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()


def severities(found: Iterable[str]) -> dict[str, int]:
    """Severity -> number of findings, the gravest first."""
    counts = Counter(found)
    return {name: counts[name] for name in ("error", "warning", "hint") if counts[name]}
