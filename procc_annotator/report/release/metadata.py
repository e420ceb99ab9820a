"""Texts of a release: README card, changelog, Croissant metadata."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import printable
from procc_annotator.messages import pluralize
from procc_annotator.report.release.contents import (
    ANNOTATIONS,
    INDEX_FILE,
    PICTURES,
    Release,
    ReleaseDescription,
)
from procc_annotator.report.tables.data_files import json_bytes
from procc_annotator.resources import resources_dir
from procc_annotator.version import __version__

if TYPE_CHECKING:
    from jinja2 import Environment


_WIDTH_PX, _HEIGHT_PX = 959, 539  # that moves are told in


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
        """Return whether anything did."""
        frames = (self.added, self.removed, self.changed, self.moved_splits, self.pictures)
        return self.other_field or any(frames)


def changed_frame(name: str, before: FrameAnnotation, now: FrameAnnotation) -> ChangedFrame | None:
    """Return how a frame's elements differ; None where no point does."""
    was, is_ = _points(before), _points(now)
    moved = tuple(
        (element, _farthest(was[element], is_[element]))
        for element in is_
        if element in was and was[element] != is_[element]
    )
    added = tuple(element for element in is_ if element not in was)
    removed = tuple(element for element in was if element not in is_)
    return ChangedFrame(name, added, removed, moved) if added or removed or moved else None


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


_HUB_LICENCE = re.compile(r"[a-z0-9][a-z0-9.\-]*")
_LISTED = 200


def dataset_card(release: Release) -> bytes:
    """Return the README."""
    terms = release.terms
    points = sum(frame.points for frame in release.frames)
    sizes = ", ".join(f"{size} ({n})" for size, n in release.picture_sizes.most_common())
    facts = (
        ("version", terms.version),
        ("date", terms.date),
        ("licence", terms.licence or "not said"),
        ("by", ", ".join(terms.creators)),
        ("found at", terms.url),
        ("frames", str(len(release.frames))),
        ("elements, points", f"{sum(release.elements.values())}, {points}"),
        ("field", f"{release.field.described} (SHA-256 `{release.fingerprint}`)"),
        ("picture sizes", sizes or "no picture at hand when this was made"),
    )
    hub = terms.licence.lower()
    found = (release.findings or {}).items()
    return _rendered(
        "README.md", release=release, terms=terms, facts=facts, version=__version__,
        hub_licence=hub if _HUB_LICENCE.fullmatch(hub) else "",
        files={name for name, _ in release.files},
        findings=", ".join(pluralize(n, severity) for severity, n in found if n),
    )  # fmt: skip


def changelog(terms: ReleaseDescription, changes: Changes | None, earlier: str = "") -> bytes:
    """Return the changelog, the newest release first.

    Args:
        changes: since the release before; None for a first one.
        earlier: the changelog of the release before, without its heading.
    """
    return _rendered("CHANGELOG.md", terms=terms, changes=changes, earlier=earlier, most=_LISTED)


def _rendered(name: str, **values: Any) -> bytes:
    return _environment().get_template(name).render(values).encode()


@cache
def _environment() -> Environment:
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(resources_dir() / "release"),
        autoescape=False,  # Markdown, see finalize
        undefined=StrictUndefined,
        finalize=_plain,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["one_line"] = _one_line
    environment.filters["quoted"] = lambda text: json.dumps(_one_line(text)).replace("<", "\\u003c")
    environment.filters["cell"] = lambda text: (
        _one_line(text).replace("\\", "\\\\").replace("|", "\\|")
    )
    environment.filters["frames"] = lambda number: pluralize(number, "frame")
    return environment


def _plain(value: Any) -> Any:
    """Keep names and texts text: no HTML, nothing that a terminal obeys."""
    return printable(value, keep="\n").replace("<", "&lt;") if type(value) is str else value


def _one_line(text: str) -> str:
    return " ".join(text.split())


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
        "citeAs": terms.citation.strip() or _citation(terms),
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


def _citation(terms: ReleaseDescription) -> str:
    title, by = (re.sub("[{}]", "", text) for text in (terms.title, " and ".join(terms.creators)))
    author = f"  author = {{{by}}},\n" if by else ""
    return (
        f"@misc{{{_plain_name(terms.name)},\n  title = {{{title}}},\n{author}"
        f"  year = {{{terms.date[:4]}}},\n  version = {{{terms.version}}}\n}}"
    )


def _plain_name(name: str) -> str:
    return re.sub(r"[^A-Za-z0-9_.\-]+", "-", name).strip("-") or "dataset"


def _semantic(version: str) -> str:
    """``1.2`` as ``1.2.0``: tools want three numbers."""
    numbers = re.fullmatch(r"v?(\d+)(?:\.(\d+))?(?:\.(\d+))?", version)
    return ".".join(n or "0" for n in numbers.groups()) if numbers else version
