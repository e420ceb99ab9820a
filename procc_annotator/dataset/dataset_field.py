"""The field of a dataset: stored choice, dimensions, line convention, and ``stadiums.csv``."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Literal, TypeVar

import msgspec

from procc_annotator.dataset.database.location import read_settings
from procc_annotator.dataset.layout import FIELD_FILE, STADIUMS_FILE, folder_of_dataset
from procc_annotator.dataset.season import annotated_matches
from procc_annotator.errors import FieldError, ImageError, InputError, UsageError
from procc_annotator.field.formulas import did_you_mean
from procc_annotator.field.load import (
    is_builtin_field,
    load_field,
    load_field_of,
    with_dimensions,
    with_lines,
    with_stadiums,
)
from procc_annotator.field.model import Field, PixelAspect, Stadiums
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.csv_tables import encode_rows, escape_formula, read_frame_table
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.image.headers import VIDEO_SUFFIXES

if TYPE_CHECKING:
    from procc_annotator.dataset.database.database import WorkspaceDatabase


FRAME, STADIUM = "frame", "stadium"
_ADVICE = "the file needs a header like: frame,stadium,length,width"


def field_with_stadiums(field: Field, folder: Path) -> Field:
    """The field with what the file in a dataset's folder says; itself without a file. `InputError`,
    with the place and the reason, if the file cannot be used."""
    path = folder / STADIUMS_FILE
    return with_stadiums(field, read_stadiums(path, field)) if path.is_file() else field


def read_stadiums(path: Path, field: Field) -> Stadiums:
    """Read such a file. `InputError` if it is another file, or gives this field dimensions that it
    cannot have."""
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
    """Write such a file; it appears when it is complete. `SaveError` if it cannot be written."""
    names = list(dict.fromkeys(name for own in stadiums.dimensions.values() for name in own))
    lines = [[FRAME, STADIUM, *names]]
    for frame, stadium in stadiums.frames.items():
        own = stadiums.dimensions[stadium]
        sizes = (repr(own[name]) if name in own else "" for name in names)
        lines.append([escape_formula(frame), escape_formula(stadium), *sizes])
    write_atomic(path, encode_rows(lines))


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


LINES_SETTING = "field_lines"


class _Dimensions(msgspec.Struct):
    field: str
    dimensions: dict[str, float]


class _Lines(msgspec.Struct):
    field: str
    lines: Literal["measured", "middle"]


@dataclass(frozen=True)
class FieldSettings:
    """Field settings of a workspace, as far as they can be used.

    Attributes:
        dimensions: metres, by name; empty where all are nominal.
        lines: one of `LINE_POSITIONS`; empty where nothing is kept.
        problems: why the rest cannot be used, one line each.
    """

    dimensions: Mapping[str, float]
    lines: str
    problems: tuple[str, ...]


K = TypeVar("K", _Dimensions, _Lines)


def field_settings(settings: Mapping[str, str], field: Field) -> FieldSettings:
    """The field settings, by key, of a workspace; what was kept for another field is nothing."""
    problems = []

    def read(key: str, kind: type[K], what: str) -> K | None:
        try:
            kept = msgspec.json.decode(settings[key], type=kind) if key in settings else None
        except (msgspec.DecodeError, UnicodeEncodeError) as error:
            problems.append(f"{what} kept with the dataset cannot be read: {error}")
            return None
        return kept if kept is not None and kept.field == field.name else None

    sized = read(DIMENSIONS_SETTING, _Dimensions, "the dimensions of the field")
    dimensions = {} if sized is None else sized.dimensions
    try:
        with_dimensions(field, dimensions)
    except FieldError as error:
        dimensions = {}
        problems.append(f"the dimensions of the field kept with the dataset are not used: {error}")
    lines = read(LINES_SETTING, _Lines, "the position of the field's lines")
    return FieldSettings(dimensions, "" if lines is None else lines.lines, tuple(problems))


def store_dimensions(database: WorkspaceDatabase, field: Field) -> None:
    """Let a dataset have the dimensions of this field; nominal ones are kept as nothing."""
    own = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    text = json.dumps({"field": field.name, "dimensions": own}) if own else None
    database.set_setting(DIMENSIONS_SETTING, text)


def add_dimensions(database: WorkspaceDatabase, field: Field, found: Mapping[str, float]) -> Field:
    """Let a dataset have dimensions, metres by name, that were found, and otherwise those it was
    given before; return its field.

    Args:
        field: what they were found with; dimensions of it that are not nominal were asked for.

    Raises:
        FieldError: together they are no field.
    """
    asked_for = {d.name: d.value for d in field.dimensions if d.value != d.nominal}
    before = field_settings(database.settings(), field).dimensions
    sized = with_dimensions(field, {**before, **asked_for, **found})
    store_dimensions(database, sized)
    return sized


def store_lines(database: WorkspaceDatabase, field: Field) -> None:
    """Let a dataset have its lines where this field has them; as its file has them is nothing."""
    own = {"field": field.name, "lines": field.lines}
    usual = field.lines == field.usual_lines
    database.set_setting(LINES_SETTING, None if usual else json.dumps(own))


def video_pixel_aspect(picture: Path) -> PixelAspect | None:
    """The pixels of the video that a frame is of, where its metadata say that they are not square;
    of one that cannot be read nothing is known."""
    # Loads FFmpeg, which most commands do without.
    from procc_annotator.image.video import open_shared_video, video_frame_of_path

    try:
        found = video_frame_of_path(picture)
        aspect = 1.0 if found is None else open_shared_video(found[0]).pixel_aspect
    except ImageError:  # reading its frames says why
        return None
    return None if aspect == 1 else PixelAspect(aspect, 1.0)


MAX_PIXEL_ASPECT = 10.0  # anything wider is no picture
ASPECT_SETTING = "pixel_aspect"  # the key under which a dataset keeps its pixel aspect


def stored_pixel_aspect(setting: str | None) -> PixelAspect | None:
    """The pixel aspect that a dataset keeps; None without one that can be read."""
    try:
        value, probability = (float(part) for part in (setting or "").split())
    except ValueError:
        return None
    return (
        PixelAspect(value, probability)
        if 0 < value < MAX_PIXEL_ASPECT and 0 < probability <= 1
        else None
    )


def aspect_setting(pixels: PixelAspect) -> str:
    """What `stored_pixel_aspect` reads."""
    return f"{pixels.value!r} {pixels.probability!r}"


def with_dataset_pixels(field: Field, place: Path) -> Field:
    """The field with the pixels of a dataset's pictures, as far as a video's metadata or its
    workspace say; for the place see `folder_of_dataset`."""
    is_video = place.is_file() and place.suffix.lower() in VIDEO_SUFFIXES
    pixels = video_pixel_aspect(place / "0") if is_video else None
    if pixels is None and (folder := folder_of_dataset(place)) is not None:
        pixels = stored_pixel_aspect(_settings_of(folder)[0].get(ASPECT_SETTING))
    return field if pixels is None else replace(field, pixels=pixels)


def _settings_of(folder: Path) -> tuple[Mapping[str, str], tuple[str, ...]]:
    """What a dataset's workspace keeps, and why not."""
    try:
        settings, notice = read_settings(folder)
    except InputError as error:
        return {}, (str(error),)
    return settings, tuple(filter(None, (notice,)))


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
    """Return what `load_field` takes for a dataset, a name or a file, by the settings of its
    workspace; None where it does not say. `FieldError` if what is kept cannot be read."""
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
    """The field of a dataset, as its folder and the settings of its workspace say, with its
    stadiums. `FieldError` if it cannot be used: another one in its place would be wrong."""
    source = stored_field_source(folder, settings)
    field = load_field(source)
    kept = field_settings(settings, field)
    notices = [*kept.problems]
    field = with_dimensions(field, kept.dimensions) if kept.dimensions else field
    field = with_lines(field, kept.lines or field.lines)
    try:
        field = field_with_stadiums(field, folder)
    except InputError as error:
        notices.append(f"the stadiums' dimensions are not used: {error}")
    chosen = source is not None or bool(kept.dimensions or kept.lines or field.stadiums)
    return DatasetField(field, chosen, tuple(notices))


def field_of_dataset(place: Path) -> DatasetField:
    """The field of a dataset that is on the disk, see `folder_of_dataset`; nothing is written, and
    what has no folder (an archive) says nothing. `FieldError` if the field cannot be used."""
    folder = folder_of_dataset(place)
    if folder is None:
        return DatasetField(load_field(None))
    settings, notices = _settings_of(folder)
    found = field_of_settings(folder, settings)
    field = with_dataset_pixels(found.field, place)
    return replace(found, field=field, notices=notices + found.notices)


def field_of_datasets(places: Iterable[Path]) -> DatasetField:
    """The field that all these datasets show; those that do not say which follow the others.

    Raises:
        FieldError: a dataset's field cannot be used.
        UsageError: they show different fields.
    """
    found = dict[Path, DatasetField]()
    for place in dict.fromkeys(places):
        found[place] = field_of_dataset(place)
        for match, folder in annotated_matches(place):
            named = DatasetField(load_field_of(match.field), True) if match.field else None
            found[folder] = named or field_of_dataset(folder)
    notices = tuple(dict.fromkeys(n for one in found.values() for n in one.notices))
    said = {place: one.field for place, one in found.items() if one.chosen}
    if not said:
        pixels = next((one.field.pixels for one in found.values()), None)
        return DatasetField(replace(load_field(None), pixels=pixels), False, notices)
    field = next(iter(said.values()))
    if any(replace(other, pixels=field.pixels) != field for other in said.values()):
        words = ", ".join(f"{place}: {other.described}" for place, other in said.items())
        raise UsageError(
            f"the sets show different fields ({words}): name one with --field, or take them one by"
            " one"
        )
    return DatasetField(field, True, notices)


def store_field(database: WorkspaceDatabase, folder: Path, field: Field) -> None:
    """Let a dataset remember its field as it was loaded, with its dimensions and where its lines
    are; the path of a file inside the dataset's folder is kept relative to it."""
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
