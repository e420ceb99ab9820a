"""Which field ``--field`` and ``--lines`` name, or else the datasets of a command."""

from __future__ import annotations

from pathlib import Path, PurePosixPath

from procc_annotator.cli.echo import echo
from procc_annotator.errors import FieldError, InputError, UsageError
from procc_annotator.field.load import load_field, with_lines
from procc_annotator.field.model import Field
from procc_annotator.io.source import ZipSource
from procc_annotator.session.dataset.dataset_field import field_of_datasets
from procc_annotator.session.dataset.dataset_folder import FIELD_FILE
from procc_annotator.session.landmarks.dataset_landmarks import field_of_dataset_with_landmarks


def chosen_field(text: str | None, *datasets: Path | None, lines: str | None = None) -> Field:
    """The field an option names, with its dimensions if any are given; without it the datasets'
    own, with the dimensions they keep; with their landmarks either way.

    Args:
        text: of the option.
        datasets: what has no folder says nothing.
        lines: where its lines lie; None: as the dataset keeps it, or the file of the field says.

    Raises:
        FieldError: the field's description or a dimension cannot be used.
        InputError: the file of their landmarks cannot be used.
        UsageError: dimensions that are not written as ``name=metres``; datasets of several fields.
    """
    field = _own_field(*datasets) if text is None else _named_field(text)
    field = field if lines is None else with_lines(field, lines)
    return field_of_dataset_with_landmarks(field, *(place for place in datasets if place))


def _named_field(text: str) -> Field:
    name, dimensions = named_field(text)
    return load_field(name, **dimensions)


def named_field(text: str) -> tuple[str, dict[str, float]]:
    """What the option names: a field, and dimensions in metres by name.

    Raises:
        UsageError: dimensions that are not written as ``name=metres``.
    """
    name, colon, given = text.rpartition(":")
    if not name or ("=" not in given and not _is_dimension(name, colon, given)):
        return text, {}
    dimensions: dict[str, float] = {}
    for part in given.split(","):
        key, _, value = (word.strip() for word in part.partition("="))
        if key in dimensions:
            raise UsageError(f"--field {text}: {key} is given twice")
        try:
            dimensions[key] = float(value)
        except ValueError as error:
            wanted = _dimension_example(name, key)
            said = f"{part!r} is no dimension, write" if part else "write"
            raise UsageError(f"--field {text}: {said} e.g. {wanted} (metres)") from error
    return name, dimensions


def _is_dimension(name: str, colon: str, given: str) -> bool:
    """Whether what follows a colon can only be meant for a dimension: it belongs to no path."""
    return bool(colon) and not any(mark in given for mark in "/\\.") and len(name) > 1


def _dimension_example(name: str, key: str) -> str:
    """How a dimension is written: the one that was meant, if the field has it."""
    try:
        field = load_field(name)
    except FieldError:
        return f"{name}:length=28"
    shown = field.dimension(key) or next(iter(field.dimensions), None)
    return f"{name}:{shown.name}={shown.value:g}" if shown is not None else name


def _own_field(*datasets: Path | None) -> Field:
    places = [place for place in datasets if place is not None]
    found = field_of_datasets(places)
    packed = [
        f"{place} holds a field.toml, which is not used: unpack it and name it with --field"
        for place in places
        if _packs_field_file(place)
    ]
    for notice in (*found.notices, *packed):
        echo(f"note: {notice}", err=True)
    return found.field


def _packs_field_file(place: Path) -> bool:
    """Whether an archive holds a field's description; one that cannot be read says so elsewhere."""
    if place.suffix.lower() != ".zip" or not place.is_file():
        return False
    try:
        with ZipSource(place) as archive:
            return any(PurePosixPath(name).name == FIELD_FILE for name in archive.names())
    except InputError:
        return False
