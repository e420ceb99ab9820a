"""Gold frames: those whose annotation is known to be right, named in the dataset's ``gold.csv``.

The file belongs to the keeper of the dataset, who does not pass it on: the window knows nothing of
it, and no export holds it.
"""

from __future__ import annotations

from pathlib import Path

from procc_annotator.errors import InputError
from procc_annotator.io.csv_text import read_frame_table

REFERENCE_FRAMES_FILE = "gold.csv"
_ADVICE = "the file needs a header with a column 'frame', and a row for each gold frame"


def read_reference_frames(path: Path) -> tuple[str, ...]:
    """The names of gold frames, in the file's order.

    Raises:
        InputError: it cannot be read, or what is wrong and where.
    """
    _, rows = read_frame_table(path, (), _ADVICE)
    if not rows:
        raise InputError(path, "names no frame", advice=_ADVICE)
    return tuple(row["frame"] for _, row in rows)
