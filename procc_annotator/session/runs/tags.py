"""Groups of frames: by tags from a CSV file, or by the model of their camera.

The file has a header; its column ``frame`` holds frame names and every other column is a tag. With
a column ``set`` its rows count only for the set of that name.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from procc_annotator.errors import InputError, UsageError
from procc_annotator.io.csv_text import read_frame_table
from procc_annotator.io.frame_names import FrameTable

MODEL = "model"  # group by the model of the camera
_TAG_FRAME, _SET = "frame", "set"
_TAGS_ADVICE = "the file needs a header like: frame,stadium,camera type"


@dataclass(frozen=True)
class Grouping:
    """What the frames of one set are grouped by.

    Attributes:
        by: columns of tags, or `MODEL`.
        values: frame name -> its value of each of these, None where it has none.
    """

    by: tuple[str, ...] = ()
    values: Mapping[str, tuple[str | None, ...]] = field(default_factory=dict)

    def of(self, frame: str) -> tuple[str | None, ...]:
        """The values of a frame; the model of its camera is not known yet."""
        return self.values.get(frame) or (None,) * len(self.by)


@dataclass(frozen=True)
class Tags:
    """A file of tags.

    Attributes:
        path: of the file.
        columns: names of the tags.
        rows: (set, frame) -> one value a column, empty where there is none; the set is None where
            the file names no sets.
    """

    path: Path
    columns: tuple[str, ...]
    rows: Mapping[tuple[str | None, str], tuple[str, ...]]

    @classmethod
    def read(cls, path: Path) -> Tags:
        """Read a CSV file, separated by commas, semicolons or tabs.

        Raises:
            InputError: it cannot be read, or is not such a file.
        """
        names, table = read_frame_table(path, (), _TAGS_ADVICE, in_sets=True)
        columns = tuple(name for name in names if name not in (_TAG_FRAME, _SET))
        problem = "" if columns else f"has no column of tags beside {_TAG_FRAME!r}"
        problem = f"column {names.index('') + 1} has no name" if "" in names else problem
        if problem:
            raise InputError(path, problem, place="line 1", advice=_TAGS_ADVICE)
        rows = {
            (row.get(_SET), row[_TAG_FRAME]): tuple(row[name] for name in columns) for _, row in table
        }
        return cls(path, columns, rows)

    def grouping(self, by: Sequence[str], of_set: str) -> Grouping:
        """The groups of one set.

        Args:
            by: some of `columns`, or `MODEL`.
            of_set: name of the set.
        """
        at = [None if name == MODEL else self.columns.index(name) for name in by]
        return Grouping(
            tuple(by),
            FrameTable(
                (frame, tuple(None if i is None else row[i] or None for i in at))
                for (named, frame), row in self.rows.items()
                if named in (None, of_set)
            ),
        )

    def values(self, column: str | None, of_set: str) -> FrameTable[str | None]:
        """Frame -> its value of a tag in one set; empty if there is no such tag."""
        if column not in self.columns:
            return FrameTable()
        found = self.grouping((column,), of_set).values
        return FrameTable((frame, own[0]) for frame, own in found.items())


def check_by(by: Sequence[str], tags: Tags | None, further: Sequence[str] = ()) -> tuple[str, ...]:
    """What to group by, each once.

    Args:
        further: what else a person may ask for, to be named where something is asked for that
            there is not.

    Raises:
        UsageError: there is no such tag.
    """
    columns = () if tags is None else tags.columns
    if MODEL in columns and MODEL in by:
        raise UsageError(
            f"{tags.path if tags else ''}: the tag {MODEL!r} cannot be told from the model of the"
            " camera (rename the column)"
        )
    for name in by:
        if name != MODEL and name not in columns:
            there = ", ".join((MODEL, *further, *columns))
            more = "" if tags else "; further ones come from --tags FILE"
            raise UsageError(f"cannot group by {name!r}: there is {there}{more}")
    return tuple(dict.fromkeys(by))
