"""A release of a dataset: annotations, splits, hashes, dataset card, Croissant, changelog."""

from __future__ import annotations

import hashlib
import json
import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import astuple, dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.layout import STADIUMS_FILE
from procc_annotator.dataset.picture_sizes import PictureSizes, picture_size
from procc_annotator.errors import ImageError, InputError, UsageError, printable
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.registry import read_plain
from procc_annotator.formats.atomic import remove
from procc_annotator.formats.csv_tables import read_table
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import RELEASE_FILE, FileSource, read_file
from procc_annotator.formats.frame_names import FrameTable, escapes_folder
from procc_annotator.formats.strict_json import decode_as, is_unicode
from procc_annotator.formats.strict_json import printable as with_escapes
from procc_annotator.messages import pluralize
from procc_annotator.report.outputs import is_archive, open_target
from procc_annotator.report.tables.data_files import csv_bytes, json_bytes
from procc_annotator.report.tables.table import Column, MetricTable, count_column
from procc_annotator.resources import resources_dir
from procc_annotator.version import __version__

if TYPE_CHECKING:
    from jinja2 import Environment

Progress = Callable[[int, int], None]  # frames done, frames in all

FINDINGS_FILE, AGREEMENT_FILE = "findings.csv", "agreement.json"
PROVENANCE_FILE, FIELD_COPY = "provenance.json", "field.toml"
_INDEX, _CARD, _CHANGES, _CROISSANT = "index.csv", "README.md", "CHANGELOG.md", "croissant.json"
_ANNOTATIONS, _PICTURES, _SPLITS = "annotations", "images", "splits"
_FORMAT = "procc-annotator release 1"
_ONE_SPLIT = "all"
_WIDTH_PX, _HEIGHT_PX = 959, 539  # distances in the changelog are px at 960x540
_LISTED = 200  # frames in the changelog


@dataclass(frozen=True)
class ReleaseDescription:
    """Statements of a dataset's maintainer.

    Attributes:
        date: ``2026-05-01``.
        licence: SPDX identifier or URL; empty for none.
        url: of the dataset; empty for none.
        citation: BibTeX; empty for none.
    """

    name: str
    version: str
    date: str
    licence: str = ""
    creators: tuple[str, ...] = ()
    url: str = ""
    description: str = ""
    citation: str = ""


@dataclass(frozen=True)
class ReleasedPicture:
    """A frame's picture: its file name, SHA-256, and size in bytes and px."""

    file: str
    sha256: str
    bytes: int
    width: int
    height: int


@dataclass(frozen=True, eq=False)
class ReleasedFrame:
    """An annotated frame; ``data`` is its annotation file."""

    name: str
    split: str
    data: bytes
    sha256: str
    annotation: FrameAnnotation
    picture: ReleasedPicture | None


@dataclass(frozen=True, eq=False)
class Release:
    """Everything that is published.

    Attributes:
        frames: in natural order.
        fingerprint: of the field, see `field.load`.
        findings: severity -> open findings of the label check; None where it was not run.
        agreement: in words; empty without a second annotator.
        provenance: origin -> number of points; None where nothing is known of them.
        with_pictures: whether they are passed on.
        files: further files: name -> content.
    """

    terms: ReleaseDescription
    frames: tuple[ReleasedFrame, ...]
    field: Field
    fingerprint: str
    findings: Mapping[str, int] | None
    agreement: str
    provenance: Mapping[str, int] | None
    with_pictures: bool
    files: Mapping[str, bytes]

    @property
    def splits(self) -> dict[str, list[str]]:
        """Split -> its frames, in the order they first appear."""
        found: dict[str, list[str]] = {}
        for frame in self.frames:
            found.setdefault(frame.split, []).append(frame.name)
        return found


@dataclass(frozen=True)
class Changes:
    """Changes since the previous release, by frame name.

    Attributes:
        before: ``version 1.0``.
        changed: frames with their elements that were added, removed or moved, in words.
        pictures: frames of both whose picture is another file now.
    """

    before: str
    added: tuple[str, ...]
    removed: tuple[str, ...]
    changed: tuple[tuple[str, str], ...]
    moved_splits: tuple[str, ...]
    pictures: tuple[str, ...]
    other_field: bool

    @property
    def any(self) -> bool:
        """Return whether anything changed."""
        frames = (self.added, self.removed, self.changed, self.moved_splits, self.pictures)
        return self.other_field or any(frames)


def gather_frames(
    source: FileSource,
    field: Field,
    splits: Mapping[str, str],
    pictures: PictureSizes,
    progress: Progress,
) -> tuple[tuple[ReleasedFrame, ...], list[str]]:
    """Read every annotation, and hash it and its picture.

    Args:
        splits: frame -> split; where it is empty, all frames are in one.

    Returns:
        The frames, and one line for each file that is left out.
    """
    frames: list[ReleasedFrame] = []
    problems: list[str] = []
    files = list_annotations(source)
    for number, (name, file) in enumerate(files.items(), 1):
        progress(number, len(files))
        if splits and name not in splits:
            problems.append(f"{name}: is in no split; left out")
            continue
        if not is_unicode(name):
            problems.append(
                f"{with_escapes(name)}: is no valid Unicode; left out (rename the file)"
            )
            continue
        try:
            data = source.read(file)
            annotation = read_plain(data, source.display(file), field)
        except InputError as error:
            problems.append(str(error))
            continue
        path, picture = pictures.path(name), None
        if path is not None:
            try:
                content = read_file(path, ImageError)
                picture = ReleasedPicture(
                    pictures.name(name) or path.name, _sha256(content), len(content),
                    *picture_size(path),
                )  # fmt: skip
            except InputError as error:
                problems.append(str(error))
        split = splits.get(name, _ONE_SPLIT)
        frames.append(ReleasedFrame(name, split, data, _sha256(data), annotation, picture))
    if not frames:
        raise UsageError(f"nothing to do: no annotation of {source.path} can be released")
    return tuple(frames), problems


def count_origins(provenance: bytes) -> dict[str, int]:
    """Number of points by origin, the most frequent first, in a file of `report.provenance`."""
    counts = Counter(
        "from a file" if point is None else str(point[0])
        for elements in json.loads(provenance)["frames"].values()
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
    """Write everything; returns the changes since the previous release.

    Files that a release in the same folder has, and this one does not, are removed.

    Args:
        out: a folder, or an archive if it ends in ``.zip``.
        before: folder of the previous release.
        picture_of: frame -> its picture's path.

    Raises:
        InputError: the previous release, or a picture, cannot be read.
        SaveError: writing failed; an archive is then not there.
    """
    changes = None if before is None else changes_since(before, release)
    earlier = "" if before is None else _earlier_changes(before)
    older = set() if is_archive(out) else _files_of_release(out)
    index = csv_bytes(_index_table(release.frames))
    own = {f"{_SPLITS}/{split}.txt": "".join(f"{name}\n" for name in names).encode()
           for split, names in release.splits.items()}  # fmt: skip
    own |= {
        **release.files,
        _INDEX: index,
        _CROISSANT: croissant_bytes(release, index),
        _CHANGES: _rendered(
            _CHANGES, terms=release.terms, changes=changes, earlier=earlier, most=_LISTED
        ),
        RELEASE_FILE: _release_bytes(release),
        _CARD: _dataset_card(release),
    }
    written = set(own)
    with open_target(out) as target:
        for number, frame in enumerate(release.frames, 1):
            progress(number, len(release.frames))
            files = {f"{_ANNOTATIONS}/{frame.name}.json": frame.data}
            path = picture_of(frame.name) if release.with_pictures else None
            if path is not None and frame.picture is not None:
                files[f"{_PICTURES}/{frame.picture.file}"] = read_file(path, ImageError)
            written |= files.keys()
            for name, data in files.items():
                target.write(name, data)
        for name, data in own.items():
            target.write(name, data)
    for name in older - written:
        remove(out / name)
    return changes


def _index_table(frames: Iterable[ReleasedFrame]) -> MetricTable:
    columns = (
        *map(Column, ("frame", "split", "annotation", "annotation_sha256")),
        *map(count_column, ("elements", "points")),
        *map(Column, ("picture", "picture_sha256")),
        *map(count_column, ("picture_bytes", "width", "height")),
    )
    rows = []
    for frame in frames:
        counts = [len(line.points) for line in frame.annotation.polylines if line.points]
        picture = (None,) * 5 if frame.picture is None else astuple(frame.picture)
        file = f"{_ANNOTATIONS}/{frame.name}.json"
        own = (frame.name, frame.split, file, frame.sha256, len(counts), sum(counts))
        rows.append((*own, *picture))
    return MetricTable("index", "Frames", columns, tuple(rows))


def croissant_bytes(release: Release, index: bytes) -> bytes:
    """The Croissant metadata; ``index`` is the table whose columns become its fields."""
    terms = release.terms
    numbers = re.fullmatch(r"v?(\d+)(?:\.(\d+))?(?:\.(\d+))?", terms.version)
    pictures = [frame.picture.file for frame in release.frames if frame.picture is not None]
    values = {
        "terms": terms,
        "release": release,
        "plain_name": re.sub(r"[^A-Za-z0-9_.\-]+", "-", terms.name).strip("-") or "dataset",
        # Readers of Croissant expect three numbers.
        "version": ".".join(n or "0" for n in numbers.groups()) if numbers else terms.version,
        "index": index,
        "index_sha256": _sha256(index),
        "kinds": sorted({file.rsplit(".", 1)[-1] for file in pictures if release.with_pictures}),
    }
    citation = terms.citation.strip() or _rendered("citation.bib", **values).decode().strip()
    return json_bytes(json.loads(_rendered(_CROISSANT, citation=citation, **values)))


def _dataset_card(release: Release) -> bytes:
    terms = release.terms
    lines = [line for f in release.frames for line in f.annotation.polylines if line.points]
    elements = Counter(line.class_name for line in lines)
    sizes = Counter(f"{f.picture.width}x{f.picture.height}" for f in release.frames if f.picture)
    facts = (
        ("version", terms.version),
        ("date", terms.date),
        ("licence", terms.licence or "not said"),
        ("by", ", ".join(terms.creators)),
        ("found at", terms.url),
        ("frames", str(len(release.frames))),
        ("elements, points", f"{len(lines)}, {sum(len(line.points) for line in lines)}"),
        ("field", f"{release.field.described} (SHA-256 `{release.fingerprint}`)"),
        (
            "picture sizes",
            ", ".join(f"{size} ({n})" for size, n in sizes.most_common())
            or "no picture at hand when this was made",
        ),
    )
    hub = terms.licence.lower()
    found = (release.findings or {}).items()
    return _rendered(
        _CARD, release=release, terms=terms, facts=facts, version=__version__, elements=elements,
        hub_licence=hub if re.fullmatch(r"[a-z0-9][a-z0-9.\-]*", hub) else "",
        files=release.files,
        findings=", ".join(pluralize(n, severity) for severity, n in found if n),
    )  # fmt: skip


def _rendered(name: str, **values: Any) -> bytes:
    return _environment().get_template(name).render(values).encode()


@cache
def _environment() -> Environment:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    def plain(value: Any) -> Any:
        """Keep names and texts text: no HTML, nothing that a terminal obeys."""
        return printable(value, keep="\n").replace("<", "&lt;") if type(value) is str else value

    def one_line(text: str) -> str:
        return " ".join(text.split())

    environment = Environment(
        loader=FileSystemLoader(resources_dir() / "release"),
        autoescape=False,  # Markdown, see finalize
        undefined=StrictUndefined,
        finalize=plain,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters |= {
        "one_line": one_line,
        "quoted": lambda text: json.dumps(one_line(text)).replace("<", "\\u003c"),
        "cell": lambda text: one_line(text).replace("\\", "\\\\").replace("|", "\\|"),
        "frames": lambda number: pluralize(number, "frame"),
        "without_braces": lambda text: re.sub("[{}]", "", text),
    }
    return environment


def _files_of_release(folder: Path) -> set[str]:
    """Files of the release in a folder, but for those that every release has; none if absent."""
    if not (folder / RELEASE_FILE).exists():
        return set()
    frames = _read_release(folder).frames
    _, rows = read_table(folder / _INDEX, (), "")
    pictures = [row.get("picture", "") for _, row in rows]
    return {
        *(f"{_ANNOTATIONS}/{name}.json" for name in frames),
        *(f"{_PICTURES}/{file}" for file in pictures if file and not escapes_folder(file)),
        *(f"{_SPLITS}/{one.split}.txt" for one in frames.values() if not escapes_folder(one.split)),
        *(FINDINGS_FILE, AGREEMENT_FILE, PROVENANCE_FILE, FIELD_COPY, STADIUMS_FILE),
    }


def changes_since(before: Path, release: Release) -> Changes:
    """Compare a release with a previous one. `InputError` if the previous one is no release, or
    cannot be read."""
    known = _read_release(before)
    then = FrameTable(known.frames)
    now = FrameTable((frame.name, frame) for frame in release.frames)
    both = {name: (then[name], frame) for name, frame in now.items() if name in then}
    changed = []
    for name, (entry, frame) in both.items():
        if entry.sha256 != frame.sha256:
            path = before / _ANNOTATIONS / f"{then.name_there(name)}.json"
            was = read_plain(read_file(path), str(path), release.field)
            if words := _changed_elements(was, frame.annotation):
                changed.append((name, words))
    return Changes(
        f"version {known.version}",
        tuple(name for name in now if name not in then),
        tuple(name for name in then if name not in now),
        tuple(changed),
        tuple(name for name, (entry, frame) in both.items() if entry.split != frame.split),
        tuple(
            name for name, (entry, frame) in both.items()
            if entry.picture_sha256 and frame.picture is not None
            and entry.picture_sha256 != frame.picture.sha256
        ),
        known.field_sha256 != release.fingerprint,
    )  # fmt: skip


def _changed_elements(before: FrameAnnotation, now: FrameAnnotation) -> str:
    """``+Circle central; -Goal left crossbar; Middle line (up to 2.4 px)``; empty if none is."""
    was, is_ = ({line.class_name.strip(): [(p.u, p.v) for p in line.points]
                 for line in one.polylines if line.points} for one in (before, now))  # fmt: skip
    parts = [f"+{name}" for name in is_ if name not in was]
    parts += [f"-{name}" for name in was if name not in is_]
    for name, points in is_.items():
        if name in was and was[name] != points:
            far = max(
                min(math.hypot((u - a) * _WIDTH_PX, (v - b) * _HEIGHT_PX) for a, b in was[name])
                for u, v in points
            )
            parts.append(f"{name} (up to {far:.1f} px)")
    return "; ".join(parts)


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
        _FORMAT, terms.name, terms.version, terms.date, release.field.described,
        release.fingerprint, frames, f"procc-annotator {__version__}",
    )  # fmt: skip
    return json_bytes(known)


def _read_release(folder: Path) -> _Known:
    path = folder / RELEASE_FILE
    known = decode_as(read_file(path), _Known, "release", path=path)
    if known.format != _FORMAT:
        raise InputError(path, f"is of format {known.format[:60]!r}, expected {_FORMAT!r}")
    for name in known.frames:
        if not name or escapes_folder(name):
            raise InputError(path, f"{name[:60]!r} is no name of a frame")
    return known


def _earlier_changes(before: Path) -> str:
    """Entries of the previous changelog, without its heading."""
    path = before / _CHANGES
    if not path.exists():
        return ""
    _, found, entries = read_file(path).decode("utf-8", "replace").partition("\n## ")
    return f"## {entries}" if found else ""


def _sha256(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()
