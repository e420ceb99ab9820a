"""A dataset as Croissant 1.0 metadata: JSON-LD that dataset hubs and their tools read."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from procc_annotator.report.release.released import (
    ANNOTATIONS,
    INDEX_FILE,
    PICTURES,
    Release,
)
from procc_annotator.report.sheet.as_json import json_bytes

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
