"""Contents of a release: frames, index, provenance of points."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import Origin, PointKey
from procc_annotator.dataset.review import BlindCommit, read_commit, setting_of
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.report.export import Exported
from procc_annotator.report.tables.table import Column, MetricTable, count_column

PROVENANCE_FORMAT = "procc-annotator provenance 1"


@dataclass(frozen=True)
class FrameProvenance:
    """Origins of a frame's clicks.

    Attributes:
        origins: of its points.
        blind: its first commit, if that was in blind mode.
    """

    name: str
    annotation: FrameAnnotation
    origins: Mapping[PointKey, Origin]
    blind: BlindCommit | None = None


def export_provenance(
    workspace: Workspace,
    database: WorkspaceDatabase | None,
    path: Path,
    progress: Callable[[int, int], None] | None = None,
    *,
    only: Container[str] | None = None,
) -> Exported:
    """Write how every point of the annotated frames came to be; see `provenance_json`.

    Args:
        only: names of frames, where nothing is to be reported of others.

    Raises:
        InputError: the database cannot be read, as once another dataset was opened.
        SaveError: it could not be written.
    """
    exported = Exported(path)

    def frames() -> Iterator[FrameProvenance]:
        for index, frame in enumerate(workspace.frames):
            if progress is not None and index % 100 == 0:
                progress(index, len(workspace.frames))
            if only is not None and frame.name not in only:
                continue
            try:
                annotation = workspace.read(index)
            except InputError as error:
                exported.problems.append(str(error))
                continue
            if annotation.annotated:
                exported.annotations += 1
                yield _known(frame.name, annotation, database)

    write_atomic(path, provenance_json(frames()))
    return exported


def _known(
    name: str, annotation: FrameAnnotation, database: WorkspaceDatabase | None
) -> FrameProvenance:
    if database is None:
        return FrameProvenance(name, annotation, {})
    commit = read_commit(database.setting(setting_of(name)))
    return FrameProvenance(name, annotation, database.read_origins(name, complete=True), commit)


def provenance_json(frames: Iterable[FrameProvenance]) -> bytes:
    """``frames``: one entry a frame and class, in the order of the points: ``[origin, author, unix
    time]``. Points that nothing is known of are ``null``: they come from a file. ``blind``: one
    entry a frame that was committed in blind mode: whether it still is as it was then, or edited
    after the cameras were shown, who committed it, and when.
    """
    lines, blind = [], []
    for frame in frames:
        if frame.annotation.annotated:
            lines.append(f"  {_json(frame.name)}: {_json(_frame(frame.annotation, frame.origins))}")
            if (commit := frame.blind) is not None:
                entry = [commit.work(frame.annotation).value, commit.author, commit.time]
                blind.append(f"  {_json(frame.name)}: {_json(entry)}")
    parts = [f'  "format": {_json(PROVENANCE_FORMAT)}']
    for key, entries in (("frames", lines), ("blind", blind)):
        body = ",\n".join(entries)
        parts.append(f'  "{key}": {{\n{body}\n  }}')
    text = ",\n".join(parts)
    return f"{{\n{text}\n}}\n".encode()


def _frame(
    annotation: FrameAnnotation, origins: Mapping[PointKey, Origin]
) -> dict[str, list[list[object] | None]]:
    return {
        polyline.class_name: [_entry(origins.get((p.u, p.v))) for p in polyline.points]
        for polyline in annotation.polylines
        if polyline.points
    }


def _entry(origin: Origin | None) -> list[object] | None:
    return None if origin is None else [origin.kind.value, origin.author, origin.time]


def _json(value: object) -> str:
    return json.dumps(value, ensure_ascii=False)


INDEX_FILE, CARD_FILE = "index.csv", "README.md"
CHANGES_FILE, CROISSANT_FILE = "CHANGELOG.md", "croissant.json"
FINDINGS_FILE, AGREEMENT_FILE = "findings.csv", "agreement.json"
PROVENANCE_FILE, FIELD_COPY = "provenance.json", "field.toml"
ANNOTATIONS, PICTURES, SPLITS = "annotations", "images", "splits"
RELEASE_FORMAT = "procc-annotator release 1"
ONE_SPLIT = "all"


@dataclass(frozen=True)
class ReleaseDescription:
    """Statements of a dataset's maintainer.

    Attributes:
        name: of the dataset; title: for people.
        version: of this release. date: ``2026-05-01``.
        licence: SPDX identifier or URL; empty where none is given.
        creators: who made it.
        url: where it is found; empty if not stated.
        description: a paragraph.
        citation: BibTeX; empty for none.
    """

    name: str
    title: str
    version: str
    date: str
    licence: str = ""
    creators: tuple[str, ...] = ()
    url: str = ""
    description: str = ""
    citation: str = ""


@dataclass(frozen=True)
class ReleasedPicture:
    """A frame's picture: its file name, what is in it, and its size in bytes and px."""

    file: str
    sha256: str
    bytes: int
    width: int
    height: int


@dataclass(frozen=True, eq=False)
class ReleasedFrame:
    """An annotated frame.

    Attributes:
        data: its annotation file as it is.
        picture: None if absent.
    """

    name: str
    split: str
    data: bytes
    sha256: str
    annotation: FrameAnnotation
    picture: ReleasedPicture | None

    @property
    def elements(self) -> int:
        """Return how many are annotated."""
        return sum(bool(line.points) for line in self.annotation.polylines)

    @property
    def points(self) -> int:
        """Of all elements."""
        return sum(len(line.points) for line in self.annotation.polylines)


@dataclass(frozen=True, eq=False)
class Release:
    """Everything that is published.

    Attributes:
        frames: in natural order.
        field: the elements; fingerprint: see `field.load`.
        findings: of the label check that are still open, by severity; None where no one looked.
        agreement: in words; empty without a second annotator.
        provenance: origin -> number of points; None where nothing is known of them.
        with_pictures: whether they are passed on.
        files: further files: name -> content.
    """

    terms: ReleaseDescription
    frames: tuple[ReleasedFrame, ...]
    field: Field
    fingerprint: str
    findings: Mapping[str, int] | None = None
    agreement: str = ""
    provenance: Mapping[str, int] | None = None
    with_pictures: bool = False
    files: tuple[tuple[str, bytes], ...] = ()

    @cached_property
    def splits(self) -> dict[str, list[str]]:
        """Split -> its frames, in the order they first appear."""
        found: dict[str, list[str]] = {}
        for frame in self.frames:
            found.setdefault(frame.split, []).append(frame.name)
        return found

    @cached_property
    def elements(self) -> Counter[str]:
        """Element -> number of frames it is annotated in."""
        return Counter(
            line.class_name for frame in self.frames
            for line in frame.annotation.polylines if line.points
        )  # fmt: skip

    @cached_property
    def picture_sizes(self) -> Counter[str]:
        """``1920x1080`` -> number of pictures."""
        sizes = (frame.picture for frame in self.frames if frame.picture is not None)
        return Counter(f"{one.width}x{one.height}" for one in sizes)


def index_table(frames: Sequence[ReleasedFrame]) -> MetricTable:
    """A row a frame: its files by their SHA-256."""
    columns = (
        Column("frame"),
        Column("split"),
        Column("annotation"),
        Column("annotation_sha256"),
        count_column("elements"),
        count_column("points"),
        Column("picture"),
        Column("picture_sha256"),
        count_column("picture_bytes"),
        count_column("width"),
        count_column("height"),
    )
    rows = []
    for frame in frames:
        one = frame.picture
        known = (None,) * 5 if one is None else (
            one.file, one.sha256, one.bytes, one.width, one.height
        )  # fmt: skip
        file = f"{ANNOTATIONS}/{frame.name}.json"
        rows.append(
            (frame.name, frame.split, file, frame.sha256, frame.elements, frame.points, *known)
        )
    return MetricTable("index", "Frames", columns, tuple(rows))
