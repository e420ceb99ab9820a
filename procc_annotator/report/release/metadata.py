"""Texts of a release: README card, changelog, Croissant metadata."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.layout import STADIUMS_FILE
from procc_annotator.errors import printable
from procc_annotator.messages import pluralize
from procc_annotator.report.release.contents import (
    AGREEMENT_FILE,
    ANNOTATIONS,
    CHANGES_FILE,
    CROISSANT_FILE,
    FIELD_COPY,
    FINDINGS_FILE,
    INDEX_FILE,
    PICTURES,
    PROVENANCE_FILE,
    SPLITS,
    Release,
)
from procc_annotator.report.run_manifest import CITATION
from procc_annotator.report.tables.data_files import json_bytes
from procc_annotator.version import __version__

_SIZES = ((1_000, "n<1K"), (10_000, "1K<n<10K"), (100_000, "10K<n<100K"), (10**6, "100K<n<1M"))
_HUB_LICENCE = re.compile(r"[a-z0-9][a-z0-9.\-]*")


def markdown_bytes(text: str) -> bytes:
    """Markdown as a file; names and texts in it stay text: no HTML, nothing a terminal obeys."""
    return printable(text, keep="\n").replace("<", "&lt;").encode()


def dataset_card(release: Release) -> bytes:
    """The whole README."""
    terms = release.terms
    parts = [
        f"# {_one_line(terms.title)}",
        terms.description.strip(),
        _facts(release),
        "## Splits",
        _table(("split", "frames"), ((_cell(s), len(f)) for s, f in release.splits.items())),
        "## Elements",
        _table(("element", "frames"), ((_cell(e), n) for e, n in release.elements.most_common())),
        "## Files",
        _files(release),
        "## How good the labels are",
        _quality(release),
        "## Changes",
        f"See `{CHANGES_FILE}`.",
        "## Citation",
        "\n\n".join(
            f"```bibtex\n{text.strip()}\n```"
            for text in (terms.citation, *CITATION.values())
            if text.strip()
        ),
        f"Made by ProCC Annotator {__version__}.",
    ]
    text = "\n\n".join(part for part in parts if part) + "\n"
    return f"{_header(release)}\n\n".encode() + markdown_bytes(text)


def _header(release: Release) -> str:
    terms, count = release.terms, len(release.frames)
    hub = terms.licence.lower()
    licence = hub if _HUB_LICENCE.fullmatch(hub) and hub else "other"
    size = next((name for most, name in _SIZES if count < most), "n>1M")
    lines = [
        "---",
        f"pretty_name: {_quoted(terms.title)}",
        f"license: {licence}",
        *([f"license_name: {_quoted(terms.licence)}"] if licence == "other" else []),
        "task_categories:",
        "- keypoint-detection",
        "tags:",
        *(f"- {tag}" for tag in ("camera-calibration", "sports", "sports-field-registration")),
        f"- {_quoted(release.field.name)}",
        "size_categories:",
        f"- {size}",
        "configs:",
        "- config_name: default",
        f"  data_files: {INDEX_FILE}",
        "---",
    ]
    return "\n".join(lines)


def _facts(release: Release) -> str:
    terms = release.terms
    points = sum(frame.points for frame in release.frames)
    sizes = ", ".join(f"{size} ({n})" for size, n in release.picture_sizes.most_common())
    rows = [
        ("version", terms.version),
        ("date", terms.date),
        ("licence", terms.licence or "not said"),
        ("by", ", ".join(terms.creators)),
        ("found at", terms.url),
        ("frames", str(len(release.frames))),
        ("elements, points", f"{sum(release.elements.values())}, {points}"),
        ("field", f"{release.field.described} (SHA-256 `{release.fingerprint}`)"),
        ("picture sizes", sizes or "no picture at hand when this was made"),
    ]
    return _table(("", ""), ((name, _cell(value)) for name, value in rows if value))


def _files(release: Release) -> str:
    passed_on = (
        f"`{PICTURES}/`: the pictures"
        if release.with_pictures
        else "The pictures are not passed on. Who has them can tell by the SHA-256 in"
        f" `{INDEX_FILE}` that they are the same"
    )
    there = {name for name, _ in release.files}
    lines = [
        f"- `{ANNOTATIONS}/FRAME.json`: class -> points, each a share of the picture's width and"
        " height: pixel = share x (size - 1)",
        f"- `{SPLITS}/NAME.txt`: the frames of a split, one a line",
        f"- `{INDEX_FILE}`: a row a frame, with the SHA-256 of annotation and picture",
        f"- {passed_on}",
        f"- `{CROISSANT_FILE}`: this dataset as Croissant metadata",
    ]
    more = {
        PROVENANCE_FILE: "how every point came to be",
        AGREEMENT_FILE: "how near two annotators are, frame by frame",
        FINDINGS_FILE: "findings of the label check that are still open",
        FIELD_COPY: "the field that is annotated",
        STADIUMS_FILE: "the stadium of each frame, and the dimensions of its field in metres",
    }
    lines += [f"- `{name}`: {what}" for name, what in more.items() if name in there]
    return "\n".join(lines)


def _quality(release: Release) -> str:
    lines = []
    if release.findings is not None:
        found = ", ".join(pluralize(n, severity) for severity, n in release.findings.items() if n)
        lines.append(f"- Label check, still open: {found or 'nothing'}.")
    if release.agreement:
        lines.append(f"- Two annotators: {release.agreement}")
    if release.provenance:
        total = sum(release.provenance.values())
        origins = ", ".join(
            f"{_cell(name)} {100 * n / total:.0f} %" for name, n in release.provenance.items()
        )
        lines.append(f"- How the {total} points came to be: {origins}.")
    return "\n".join(lines) or "Nobody looked: no label check, no second annotator, no provenance."


def _table(header: tuple[str, str], rows: Iterable[tuple[object, object]]) -> str:
    lines = [f"| {header[0]} | {header[1]} |", "|---|---|"]
    return "\n".join([*lines, *(f"| {a} | {b} |" for a, b in rows)])


def _one_line(text: str) -> str:
    return " ".join(text.split())


def _quoted(text: str) -> str:
    return json.dumps(_one_line(text)).replace("<", "\\u003c")


def _cell(text: str) -> str:
    return _one_line(text).replace("\\", "\\\\").replace("|", "\\|")


_WIDTH_PX, _HEIGHT_PX = 959, 539  # that moves are told in
_LISTED = 200


@dataclass(frozen=True)
class ChangedFrame:
    """A frame whose elements are others now.

    Attributes:
        added, removed: elements.
        moved: element -> how far its farthest point is from the nearest one before, px at 960x540.
    """

    name: str
    added: tuple[str, ...]
    removed: tuple[str, ...]
    moved: tuple[tuple[str, float], ...]

    @property
    def in_words(self) -> str:
        """``+Circle central; -Goal left crossbar; Middle line (up to 2.4 px)``."""
        parts = [f"+{name}" for name in self.added] + [f"-{name}" for name in self.removed]
        parts += [f"{name} (up to {far:.1f} px)" for name, far in self.moved]
        return "; ".join(parts)


@dataclass(frozen=True)
class Changes:
    """From the release before to this one.

    Attributes:
        pictures: frames of both whose picture is another file now.
    """

    before: str
    added: tuple[str, ...]
    removed: tuple[str, ...]
    changed: tuple[ChangedFrame, ...]
    moved_splits: tuple[str, ...]
    pictures: tuple[str, ...]
    other_field: bool

    @property
    def any(self) -> bool:
        """Whether anything did."""
        frames = (self.added, self.removed, self.changed, self.moved_splits, self.pictures)
        return self.other_field or any(frames)


def changed_frame(name: str, before: FrameAnnotation, now: FrameAnnotation) -> ChangedFrame | None:
    """How a frame's elements differ; None where no point does."""
    was, is_ = _points(before), _points(now)
    moved = tuple(
        (element, _farthest(was[element], is_[element]))
        for element in is_
        if element in was and was[element] != is_[element]
    )
    added = tuple(element for element in is_ if element not in was)
    removed = tuple(element for element in was if element not in is_)
    return ChangedFrame(name, added, removed, moved) if added or removed or moved else None


def changelog(version: str, date: str, changes: Changes | None, earlier: str = "") -> str:
    """Markdown, the newest release first.

    Args:
        changes: against the release before; None for a first one.
        earlier: the changelog of the release before, without its heading.
    """
    lines = ["# Changelog", "", f"## {version} ({date})", ""]
    if changes is None:
        lines += ["The first release.", ""]
    elif not changes.any:
        lines += [f"No frame and no element differs from {changes.before}.", ""]
    else:
        lines += [f"Against {changes.before}:", "", *_lines(changes), ""]
    return "\n".join(lines) + (f"\n{earlier.strip()}\n" if earlier.strip() else "")


def _lines(changes: Changes) -> Sequence[str]:
    found = ["- **the field is another one**: scores do not compare"] if changes.other_field else []
    for what, names in (
        ("added", changes.added),
        ("removed", changes.removed),
        ("in another split", changes.moved_splits),
        ("with another picture", changes.pictures),
    ):
        if names:
            found.append(f"- {pluralize(len(names), 'frame')} {what}: {_listed(names)}")
    if changes.changed:
        found.append(f"- elements of {pluralize(len(changes.changed), 'frame')} changed:")
        found += [f"  - {one.name}: {one.in_words}" for one in changes.changed[:_LISTED]]
        if (more := len(changes.changed) - _LISTED) > 0:
            found.append(f"  - and {more} more frames")
    return found


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:_LISTED]) + (", ..." if len(names) > _LISTED else "")


def _points(annotation: FrameAnnotation) -> Mapping[str, tuple[tuple[float, float], ...]]:
    return {
        line.class_name.strip(): tuple((p.u, p.v) for p in line.points)
        for line in annotation.polylines
        if line.points
    }


def _farthest(before: Sequence[tuple[float, float]], now: Sequence[tuple[float, float]]) -> float:
    return max(
        min(math.hypot((u - a) * _WIDTH_PX, (v - b) * _HEIGHT_PX) for a, b in before)
        for u, v in now
    )


CONFORMS_TO = "http://mlcommons.org/croissant/1.0"
_CROISSANT = (
    "citeAs", "column", "dataBiases", "dataCollection", "equivalentProperty", "extract", "field",
    "fileProperty", "fileObject", "fileSet", "format", "includes", "isLiveDataset", "jsonPath",
    "key", "md5", "parentField", "path", "personalSensitiveInformation", "recordSet", "references",
    "regex", "repeated", "replace", "samplingRate", "separator", "source", "subField", "transform",
)  # fmt: skip
_CONTEXT: dict[str, Any] = {
    "@language": "en",
    "@vocab": "https://schema.org/",
    "conformsTo": "dct:conformsTo",
    "cr": "http://mlcommons.org/croissant/",
    "data": {"@id": "cr:data", "@type": "@json"},
    "dataType": {"@id": "cr:dataType", "@type": "@vocab"},
    "dct": "http://purl.org/dc/terms/",
    "examples": {"@id": "cr:examples", "@type": "@json"},
    "rai": "http://mlcommons.org/croissant/RAI/",
    "sc": "https://schema.org/",
    **{name: f"cr:{name}" for name in _CROISSANT},
}
_TYPES = {
    "elements": "sc:Integer", "points": "sc:Integer", "picture_bytes": "sc:Integer",
    "width": "sc:Integer", "height": "sc:Integer",
}  # fmt: skip
_MAINTAINER_KEYS = {
    "frame": "Name of the frame.",
    "split": "Split it belongs to.",
    "annotation": "Its annotation file.",
    "annotation_sha256": "SHA-256 of that file.",
    "elements": "How many elements are annotated.",
    "points": "How many points they have.",
    "picture": "File name of its picture.",
    "picture_sha256": "SHA-256 of the picture.",
    "picture_bytes": "Its size in bytes.",
    "width": "Its width, px.",
    "height": "Its height, px.",
}


def croissant_bytes(release: Release, index: bytes, index_sha256: str) -> bytes:
    """The metadata file.

    Args:
        index: the file of `released.index_sheet`, whose columns become fields.
    """
    terms = release.terms
    content: dict[str, Any] = {
        "@context": _CONTEXT,
        "@type": "sc:Dataset",
        "name": _plain_name(terms.name),
        "description": terms.description or terms.title,
        "conformsTo": CONFORMS_TO,
        "datePublished": terms.date,
        "version": _semantic(terms.version),
        "isLiveDataset": False,
        **_maintainer_entries(release),
        "distribution": _distribution(release, len(index), index_sha256),
        "recordSet": [_frames(release)],
    }
    return json_bytes(content)


def _maintainer_entries(release: Release) -> Mapping[str, Any]:
    terms = release.terms
    found: dict[str, Any] = {
        "url": terms.url,
        "license": terms.licence,
        "citeAs": terms.citation.strip() or _citation(release),
        "creator": [{"@type": "sc:Person", "name": name} for name in terms.creators],
    }
    return {key: value for key, value in found.items() if value}


def _distribution(release: Release, size: int, sha256: str) -> list[dict[str, Any]]:
    index = {
        "@type": "cr:FileObject",
        "@id": INDEX_FILE,
        "name": INDEX_FILE,
        "description": "A row a frame, with the SHA-256 of annotation and picture.",
        "contentUrl": INDEX_FILE,
        "contentSize": f"{size} B",
        "encodingFormat": "text/csv",
        "sha256": sha256,
    }
    sets = [(ANNOTATIONS, "application/json", "*.json", "Class -> points, shares of the picture.")]
    if release.with_pictures:
        kinds = sorted({f.picture.file.rsplit(".", 1)[-1] for f in release.frames if f.picture})
        sets += [
            (PICTURES, f"image/{kind.lower().replace('jpg', 'jpeg')}", f"*.{kind}", "")
            for kind in kinds
        ]
    return [index, *(_file_set(*one) for one in sets)]


def _file_set(folder: str, kind: str, pattern: str, said: str) -> dict[str, Any]:
    named = f"{folder}-{pattern.removeprefix('*.')}" if folder == PICTURES else folder
    return {
        "@type": "cr:FileSet",
        "@id": named,
        "name": named,
        "description": said or "The pictures of the frames.",
        "encodingFormat": kind,
        "includes": f"{folder}/{pattern}",
    }


def _frames(release: Release) -> dict[str, Any]:
    return {
        "@type": "cr:RecordSet",
        "@id": "frames",
        "name": "frames",
        "description": f"The {len(release.frames)} annotated frames.",
        "key": {"@id": "frames/frame"},
        "field": [
            {
                "@type": "cr:Field",
                "@id": f"frames/{column}",
                "name": column,
                "description": said,
                "dataType": _TYPES.get(column, "sc:Text"),
                "source": {"fileObject": {"@id": INDEX_FILE}, "extract": {"column": column}},
            }
            for column, said in _MAINTAINER_KEYS.items()
        ],
    }


def _citation(release: Release) -> str:
    terms = release.terms
    title, by = (re.sub("[{}]", "", text) for text in (terms.title, " and ".join(terms.creators)))
    lines = [
        f"  title = {{{title}}}",
        *([f"  author = {{{by}}}"] if by else []),
        f"  year = {{{terms.date[:4]}}}",
        f"  version = {{{terms.version}}}",
    ]
    return f"@misc{{{_plain_name(terms.name)},\n" + ",\n".join(lines) + "\n}"


def _plain_name(name: str) -> str:
    return re.sub(r"[^A-Za-z0-9_.\-]+", "-", name).strip("-") or "dataset"


def _semantic(version: str) -> str:
    """``1.2`` as ``1.2.0``: tools want three numbers."""
    numbers = re.fullmatch(r"v?(\d+)(?:\.(\d+))?(?:\.(\d+))?", version)
    return ".".join(n or "0" for n in numbers.groups()) if numbers else version
