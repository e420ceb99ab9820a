"""Gold frames: those whose annotation is known to be right, named in the dataset's ``gold.csv``.

The file belongs to the keeper of the dataset, who does not pass it on: the window knows nothing of
it, and no export holds it.
"""

from __future__ import annotations

from pathlib import Path

from procc_annotator.errors import InputError
from procc_annotator.io.csv_text import csv_cells, formula_text

GOLD_FILE = "gold.csv"
_FRAME = "frame"
_ADVICE = "the file needs a header with a column 'frame', and a row for each gold frame"


def read_gold(path: Path) -> tuple[str, ...]:
    """The names of gold frames, in the file's order.

    Raises:
        InputError: it cannot be read, or what is wrong and where.
    """
    table = csv_cells(path)
    if not table:
        raise InputError(path, "is empty", advice=_ADVICE)
    header = [cell.strip() for cell in table[0][1]]
    if header.count(_FRAME) != 1:
        raise InputError(path, f"has no column {_FRAME!r}", place="line 1", advice=_ADVICE)
    at = header.index(_FRAME)
    found: dict[str, int] = {}
    for line, cells in table[1:]:
        frame = formula_text(cells[at].strip()) if at < len(cells) else ""
        if not frame:
            raise InputError(path, "names no frame", place=f"line {line}", advice=_ADVICE)
        if frame in found:
            problem = f"frame {frame!r} again, after line {found[frame]}"
            raise InputError(path, problem, place=f"line {line}", advice="keep one of them")
        found[frame] = line
    if not found:
        raise InputError(path, "names no frame", advice=_ADVICE)
    return tuple(found)
