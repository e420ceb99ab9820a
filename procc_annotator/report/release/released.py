"""What is published of a dataset, as values, and its index as a sheet."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.model import Field
from procc_annotator.report.sheet.sheet import Column, MetricTable, count_column

INDEX_FILE, CARD_FILE = "index.csv", "README.md"
CHANGES_FILE, CROISSANT_FILE = "CHANGELOG.md", "croissant.json"
FINDINGS_FILE, AGREEMENT_FILE = "findings.csv", "agreement.json"
PROVENANCE_FILE, FIELD_COPY = "provenance.json", "field.toml"
ANNOTATIONS, PICTURES, SPLITS = "annotations", "images", "splits"
RELEASE_FORMAT = "procc-annotator release 1"
ONE_SPLIT = "all"


@dataclass(frozen=True)
class ReleaseDescription:
    """What its keeper says of a dataset.

    Attributes:
        name: of the dataset; title: for people.
        version: of this release. date: ``2026-05-01``.
        licence: SPDX identifier or URL; empty where none is given.
        creators: who made it.
        url: where it is found; empty where nobody says.
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
        picture: None where there is none.
    """

    name: str
    split: str
    data: bytes
    sha256: str
    annotation: FrameAnnotation
    picture: ReleasedPicture | None

    @property
    def elements(self) -> int:
        """How many are annotated."""
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
        field: the elements; fingerprint: see `field.fingerprint`.
        findings: of the label check that are still open, by severity; None where nobody looked.
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
        Column("frame"), Column("split"), Column("annotation"), Column("annotation_sha256"),
        count_column("elements"), count_column("points"), Column("picture"), Column("picture_sha256"),
        count_column("picture_bytes"), count_column("width"), count_column("height"),
    )  # fmt: skip
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
