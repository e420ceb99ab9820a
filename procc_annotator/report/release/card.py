"""The card of a dataset: Markdown with the header that dataset hubs read."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable

from procc_annotator.errors import printable
from procc_annotator.report.recipe import CITATION
from procc_annotator.report.release.released import (
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
from procc_annotator.session.dataset.dataset_folder import STADIUMS_FILE
from procc_annotator.version import __version__
from procc_annotator.words import count_words

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
        found = ", ".join(count_words(n, severity) for severity, n in release.findings.items() if n)
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
