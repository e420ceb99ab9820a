"""``stadiums.csv`` of a dataset: the stadium of each frame, and the dimensions of its field.

A row a frame: ``frame``, ``stadium``, and a column for each dimension in metres. What is empty, and
what has no column, is as the dataset has it.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping
from pathlib import Path

from procc_annotator.errors import FieldError, InputError
from procc_annotator.field.model import Field, Stadiums
from procc_annotator.field.stadiums import with_stadiums
from procc_annotator.field.words import did_you_mean
from procc_annotator.io.atomic import write_atomic
from procc_annotator.io.csv_text import escape_formula, read_frame_table
from procc_annotator.io.frame_names import FrameTable
from procc_annotator.session.dataset.dataset_folder import STADIUMS_FILE

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
