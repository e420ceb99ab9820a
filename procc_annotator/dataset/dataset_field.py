"""The field of a dataset: stored choice, dimensions, line convention, and ``stadiums.csv``."""

from __future__ import annotations

import csv
import io
import json
import math
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from procc_annotator.dataset.database.location import read_settings
from procc_annotator.dataset.layout import FIELD_FILE, STADIUMS_FILE, folder_of_dataset
from procc_annotator.errors import FieldError, InputError, UsageError
from procc_annotator.field.formulas import did_you_mean
from procc_annotator.field.load import (
    is_builtin_field,
    load_field,
    with_dimensions,
    with_lines,
    with_stadiums,
)
from procc_annotator.field.model import LINE_POSITIONS, Field, Stadiums
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.csv_tables import escape_formula, read_frame_table
from procc_annotator.formats.frame_names import FrameTable

if TYPE_CHECKING:
    from procc_annotator.dataset.database.database import WorkspaceDatabase


FRAME, STADIUM = "frame", "stadium"
_ADVICE = "the file needs a header like: frame,stadium,length,width"


def field_with_stadiums(field: Field, folder: Path) -> Field:
    """The field with what the file in a dataset's folder says; itself without a file.

    Raises:
        InputError: the file cannot be used; says where and why.
    """
    path = folder / STADIUMS_FILE
    return with_stadiums(field, read_stadiums(path, field)) if path.is_file() else field


def read_stadiums(path: Path, field: Field) -> Stadiums:
    """Read such a file.

    Raises:
        InputError: it is none, or gives this field dimensions that it cannot have.
    """
    header, table = read_frame_table(path, (STADIUM,), _ADVICE)
    _check_header(path, header, field)
    frames: dict[str, str] = {}
    found: dict[str, tuple[int, dict[str, float]]] = {}
    for line, row in table:
        frame, stadium = row.pop(FRAME), row.pop(STADIUM)
        if not stadium:
            continue
        own = {name: _metres(path, line, name, cell) for name, cell in row.items() if cell}
        first, known = found.setdefault(stadium, (line, own))
        if known != own:
            problem = f"the stadium {stadium!r} has other dimensions than in line {first}"
            raise InputError(path, problem, place=f"line {line}", advice="give it the same ones")
        frames[frame] = stadium
    _check_sizes(path, field, found)
    return Stadiums(FrameTable(frames), {stadium: own for stadium, (_, own) in found.items()})


def write_stadiums(path: Path, stadiums: Stadiums) -> None:
    """Write such a file; it appears when it is complete.

    Raises:
        SaveError: it cannot be written.
    """
    names = list(dict.fromkeys(name for own in stadiums.dimensions.values() for name in own))
    lines = [[FRAME, STADIUM, *names]]
    for frame, stadium in stadiums.frames.items():
        own = stadiums.dimensions[stadium]
        sizes = (repr(own[name]) if name in own else "" for name in names)
        lines.append([escape_formula(frame), escape_formula(stadium), *sizes])
    text = io.StringIO(newline="")
    csv.writer(text, lineterminator="\n").writerows(lines)
    write_atomic(path, text.getvalue().encode("utf-8", "backslashreplace"))


def _check_header(path: Path, header: list[str], field: Field) -> None:
    known = [d.name for d in field.dimensions]
    for name in header:
        if name not in (FRAME, STADIUM, *known):
            problem = f"{name!r} is no dimension of {field.name}{did_you_mean(name, known)}"
            there = f"there is {', '.join(known)}" if known else "it has none"
            raise InputError(path, problem, place="line 1", advice=there)


def _metres(path: Path, line: int, name: str, cell: str) -> float:
    try:
        value = float(cell)
        if math.isfinite(value):
            return value
    except ValueError:
        pass
    problem = f"{name} is {cell[:40]!r}, expected metres"
    raise InputError(path, problem, place=f"line {line}")


def _check_sizes(
    path: Path, field: Field, found: Mapping[str, tuple[int, Mapping[str, float]]]
) -> None:
    for stadium, (line, own) in found.items():
        try:
            with_stadiums(field, Stadiums({}, {stadium: own}))
        except FieldError as error:
            raise InputError(
                path, f"the stadium {stadium!r}: {error.problem}", place=f"line {line}",
                advice=error.advice,
            ) from error  # fmt: skip


DIMENSIONS_SETTING = "field_dimensions"


@dataclass(frozen=True)
class StoredDimensions:
    """Field settings that a workspace keeps.

    Attributes:
        values: metres, by name; empty where all are nominal.
        problem: why what is kept cannot be used; empty if it can.
    """

    values: Mapping[str, float]
    problem: str = ""


def stored_dimensions(database: WorkspaceDatabase, field: Field) -> StoredDimensions:
    """The dimensions that a dataset was given.

    Args:
        database: of its workspace.
        field: the one that is annotated; what was kept for another field is none.
    """
    return dimensions_in_settings(database.settings(), field)


def dimensions_in_settings(settings: Mapping[str, str], field: Field) -> StoredDimensions:
    """The same from the settings of a workspace, by key."""
    text = settings.get(DIMENSIONS_SETTING)
    if text is None:
        return StoredDimensions({})
    try:
        kept = json.loads(text)
        name, values = kept["field"], {str(k): float(v) for k, v in kept["dimensions"].items()}
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        said = f"the dimensions of the field kept with the dataset cannot be read: {error!r}"
        return StoredDimensions({}, said)
    if name != field.name:
        return StoredDimensions({})
    try:
        with_dimensions(field, values)
    except FieldError as error:
        said = f"the dimensions of the field kept with the dataset are not used: {error}"
        return StoredDimensions({}, said)
    return StoredDimensions(values)


def store_dimensions(database: WorkspaceDatabase, field: Field) -> None:
    """Let a dataset have the dimensions of this field; nominal ones are kept as nothing."""
    own = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    text = json.dumps({"field": field.name, "dimensions": own}) if own else None
    database.set_setting(DIMENSIONS_SETTING, text)


def add_dimensions(database: WorkspaceDatabase, field: Field, found: Mapping[str, float]) -> Field:
    """Let a dataset have dimensions that were found, and otherwise those it was given before.

    Args:
        database: of its workspace.
        field: what they were found with; dimensions of it that are not nominal were asked for.
        found: metres, by name.

    Returns:
        The dataset's field.

    Raises:
        FieldError: together they are no field.
    """
    asked_for = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    before = stored_dimensions(database, field).values
    sized = with_dimensions(field, {**before, **asked_for, **found})
    store_dimensions(database, sized)
    return sized


LINES_SETTING = "field_lines"


@dataclass(frozen=True)
class StoredLines:
    """Line settings that a workspace keeps.

    Attributes:
        lines: one of `LINES`; empty where nothing is kept.
        problem: why what is kept cannot be used; empty if it can.
    """

    lines: str = ""
    problem: str = ""


def lines_in_settings(settings: Mapping[str, str], field: Field) -> StoredLines:
    """Return where a dataset's clicks lie on the lines.

    Args:
        settings: of its workspace, by key.
        field: the one that is annotated; what was kept for another field is nothing.
    """
    text = settings.get(LINES_SETTING)
    if text is None:
        return StoredLines()
    try:
        kept = json.loads(text)
        name, lines = kept["field"], kept["lines"]
        if lines not in LINE_POSITIONS:
            raise ValueError(lines)
    except (ValueError, TypeError, KeyError) as error:
        said = f"where the lines of the field lie, kept with the dataset, cannot be read: {error!r}"
        return StoredLines(problem=said)
    return StoredLines(lines) if name == field.name else StoredLines()


def store_lines(database: WorkspaceDatabase, field: Field) -> None:
    """Let a dataset have its lines where this field has them; as its file has them is nothing."""
    own = {"field": field.name, "lines": field.lines}
    usual = field.lines == field.usual_lines
    database.set_setting(LINES_SETTING, None if usual else json.dumps(own))


FIELD_SETTING = "field"  # what the choice is kept under with the dataset


@dataclass(frozen=True)
class DatasetField:
    """The field of a dataset.

    Attributes:
        field: with the dimensions that the dataset keeps, its lines where it keeps them.
        chosen: whether the dataset says which field it is; else it is the default one.
        notices: what of it cannot be used, one line each.
    """

    field: Field
    chosen: bool = False
    notices: tuple[str, ...] = ()


def own_field_file(folder: Path) -> Path | None:
    """The description of a field in a dataset's folder, which decides what its field is."""
    path = folder / FIELD_FILE
    return path if os.path.lexists(path) else None  # one that cannot be read is an error


def stored_field_source(folder: Path, settings: Mapping[str, str]) -> str | Path | None:
    """Return what `load_field` takes for a dataset: a name or a file; None where the dataset does
    not say.

    Args:
        folder: of the dataset.
        settings: of its workspace.

    Raises:
        FieldError: what is kept cannot be read.
    """
    if (own := own_field_file(folder)) is not None:
        return own
    text = settings.get(FIELD_SETTING)
    if text is None:
        return None
    try:
        kept = json.loads(text)
        if "file" in kept:
            return folder / str(kept["file"])
        return str(kept["name"])
    except (ValueError, TypeError, KeyError) as error:
        raise FieldError(
            folder, "the field kept with the dataset cannot be read", advice="choose it again"
        ) from error


def field_of_settings(folder: Path, settings: Mapping[str, str]) -> DatasetField:
    """The field of a dataset, as its folder and its workspace say, with its stadiums.

    Args:
        folder: of the dataset.
        settings: of its workspace.

    Raises:
        FieldError: the field cannot be used; another one in its place would be wrong.
    """
    source = stored_field_source(folder, settings)
    field = load_field(source)
    kept = dimensions_in_settings(settings, field)
    lines = lines_in_settings(settings, field)
    field = with_dimensions(field, kept.values) if kept.values else field
    field = with_lines(field, lines.lines or field.lines)
    problem = ""
    try:
        field = field_with_stadiums(field, folder)
    except InputError as error:
        problem = f"the stadiums' dimensions are not used: {error}"
    chosen = source is not None or bool(kept.values or lines.lines or field.stadiums)
    return DatasetField(field, chosen, tuple(filter(None, (kept.problem, lines.problem, problem))))


def field_of_dataset(place: Path) -> DatasetField:
    """The field of a dataset that is on the disk; nothing is written.

    Args:
        place: see `folder_of_dataset`; what has no folder (an archive) says nothing.

    Raises:
        FieldError: the dataset's field cannot be used.
    """
    folder = folder_of_dataset(place)
    if folder is None:
        return DatasetField(load_field(None))
    settings: Mapping[str, str] = {}
    notices: tuple[str, ...] = ()
    try:
        settings, notice = read_settings(folder)
        notices = tuple(filter(None, (notice,)))
    except InputError as error:
        notices = (str(error),)
    found = field_of_settings(folder, settings)
    return replace(found, notices=notices + found.notices)


def field_of_datasets(places: Iterable[Path]) -> DatasetField:
    """The field that all these datasets show; those that do not say which follow the others.

    Raises:
        FieldError: a dataset's field cannot be used.
        UsageError: they show different fields.
    """
    found = {place: field_of_dataset(place) for place in dict.fromkeys(places)}
    notices = tuple(dict.fromkeys(n for one in found.values() for n in one.notices))
    said = {place: one.field for place, one in found.items() if one.chosen}
    if not said:
        return DatasetField(load_field(None), False, notices)
    field = next(iter(said.values()))
    if any(other != field for other in said.values()):
        words = ", ".join(f"{place}: {other.described}" for place, other in said.items())
        raise UsageError(
            f"the sets show different fields ({words}): name one with --field, or take them one by"
            " one"
        )
    return DatasetField(field, True, notices)


def store_field(database: WorkspaceDatabase, folder: Path, field: Field) -> None:
    """Let a dataset remember its field, with its dimensions and where its lines are.

    Args:
        database: of its workspace.
        folder: of the dataset; the path of a file inside it is kept relative to it.
        field: as it was loaded, with any dimensions.
    """
    database.set_setting(FIELD_SETTING, json.dumps(_stored(folder, field)))
    store_dimensions(database, field)
    store_lines(database, field)


def _stored(folder: Path, field: Field) -> dict[str, str]:
    if field.source is None or is_builtin_field(field.source):
        return {"name": field.name}
    path = field.source.absolute()
    try:
        return {"file": path.relative_to(folder.absolute()).as_posix()}
    except ValueError:
        return {"file": str(path)}
