"""Notes on stderr: remarks on inputs, classes of another field, unreadable files."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from pathlib import Path

from procc_annotator.cli.echo import condense_problems, echo
from procc_annotator.dataset.annotation_source import ReadSource
from procc_annotator.dataset.dataset_field import field_of_dataset
from procc_annotator.dataset.diagnostics import Mismatch, classes_of_source, loadable, mismatch_of
from procc_annotator.dataset.layout import camera_name_remark_in
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.strict_json import printable
from procc_annotator.messages import condensed, pluralize

_LABELS = 12  # are listed at most


def report_notices(notices: Mapping[str, int]) -> None:
    """One line each on stderr: the remark and for how many cameras, where it is for several; of
    many alike the first few."""
    for notice, count in condensed(notices).items():
        echo(f"note: {notice}" + (f" ({count} cameras)" if count > 1 else ""), err=True)


def report_remarks(remarks: Iterable[str]) -> None:
    """One line each on stderr."""
    for remark in remarks:
        echo(f"note: {remark}", err=True)


def report_mismatch(source: FileSource, field: Field, of: str = "") -> Mismatch | None:
    """One line on stderr where the field does not know most classes of a set, or another knows more
    of them; and one where files among the annotations are none. Returns what was said.

    Of several sets, ``of`` names this one in front of each line."""
    report_remarks(f"{of}{notice}" for notice in list_annotations(source).notices)
    unknown = source.unknown if isinstance(source, ReadSource) else {}
    return report_mismatch_of(classes_of_source(source, field), field, source.path, of, unknown)


def report_set(source: FileSource, field: Field, of: str = "") -> Mismatch | None:
    """As `report_mismatch`; and one line on stderr where pictures bear a camera's name, so that the
    set lacks their frames."""
    mismatch = report_mismatch(source, field, of)
    if remark := camera_name_remark_in(source.path):
        echo(f"note: {of}{remark}", err=True)
    return mismatch


def report_mismatch_of(
    classes: Collection[str],
    field: Field,
    place: Path,
    of: str = "",
    unknown: Mapping[str, int] | None = None,
) -> Mismatch | None:
    """The same of classes that are known, as they are named in files.

    The field of the dataset they are from (``place``) may fit better. ``unknown``: labels of
    another program that stand for no class, and how many shapes have them."""
    mismatch, own = mismatch_at(classes, field, place)
    if unknown and (mismatch is None or mismatch.better is None):
        report_remarks([f"{of}{place}: {_unknown_words(unknown, field)}"])
        return mismatch
    if mismatch is None or not mismatch.is_worth_reporting:
        return None
    if mismatch.better is None:
        try_it = "; name the field they belong to: --field NAME or a .toml file"
    elif own is not None and mismatch.better.name == loadable(own):
        try_it = ", the dataset's own field: leave --field out"
    else:
        try_it = f": --field {mismatch.better.name}"
    echo(f"note: {of}{mismatch.words()}{try_it}", err=True)
    return mismatch


def _unknown_words(unknown: Mapping[str, int], field: Field) -> str:
    """Return the remark on labels that stand for no class, and what helps."""
    counts = [f"{printable(label)} ({count})" for label, count in unknown.items()]
    more = f", and {len(counts) - _LABELS} more" if len(counts) > _LABELS else ""
    return (
        f"the field {field.title} does not know {pluralize(len(counts), 'label')}:"
        f" {', '.join(counts[:_LABELS])}{more}; procc-annotator propose-map writes a labels.toml"
        " that says what they may stand for, for --map"
    )


def mismatch_at(
    classes: Collection[str], field: Field, place: Path
) -> tuple[Mismatch | None, Field | None]:
    """Return the remark on the classes of a set, and the field that its dataset says it shows."""
    mismatch = mismatch_of(classes, field)
    if mismatch is None:
        return None, None
    try:
        found = field_of_dataset(place)
    except InputError:  # a field file that is broken fits nothing
        return mismatch, None
    if not found.chosen:
        return mismatch, None
    if found.field != field:
        mismatch = mismatch_of(classes, field, (found.field,))
    return mismatch, found.field


def report_unreadable(problems: list[str], word: str = "unreadable") -> int:
    """One line each on stderr, after a word that says what they are, and one line for many files
    with the same problem; returns the exit code."""
    for problem in condense_problems(problems):
        echo(f"{word}: {problem}", err=True)
    return 1 if problems else 0
