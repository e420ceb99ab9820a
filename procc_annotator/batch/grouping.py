"""Group frames: tags from CSV, shots and frame order, clusters for resampling."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path

import numpy as np
from natsort import natsorted

from procc_annotator.arrays import IntArray
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.csv_tables import read_frame_table
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.messages import pluralize

_ORDER_FRAME, _SHOT, _NUMBER = "frame", "shot", "number"
_ORDER_ADVICE = "the file needs a header like: frame,shot,number"
_NUMBERED = re.compile(r"(.*?)([0-9]+)")
# Numbers that go up by more than so many usual steps begin another shot.
_MOST_STEPS_MISSING = 25


class NotInOrderError(UsageError):
    """Frames that do not follow each other in time."""


@dataclass(frozen=True)
class ShotFrames:
    """Frames of one camera without a cut.

    Attributes:
        name: of the shot.
        frames: names, in order.
        numbers: of each, ascending: when it was taken, counted in frames.
    """

    name: str
    frames: tuple[str, ...]
    numbers: tuple[int, ...]


@dataclass(frozen=True)
class FrameOrder:
    """Content of a table of frames.

    Attributes:
        told_by: the file.
        shots: frame -> its shot, "" where the table has none.
        numbers: frame -> its number; the place of its row in the table, where that has none.
    """

    told_by: str
    shots: Mapping[str, str]
    numbers: Mapping[str, int]

    @classmethod
    def read(cls, path: Path) -> FrameOrder:
        """Read a ``frames.csv``.

        Raises:
            InputError: it cannot be read, or what is wrong and where.
        """
        names, table = read_frame_table(path, (), _ORDER_ADVICE)
        if not {_SHOT, _NUMBER} & set(names):
            raise InputError(
                path, f"has no columns {_ORDER_FRAME!r} and {_SHOT!r}", advice=_ORDER_ADVICE
            )
        shots: dict[str, str] = {}
        numbers: dict[str, int] = {}
        for place, (line, row) in enumerate(table):
            frame = row[_ORDER_FRAME]
            number = row.get(_NUMBER, str(place))
            if not re.fullmatch("[0-9]{1,12}", number):
                raise InputError(path, f"{number!r} is no number", place=f"line {line}")
            shots[frame] = row.get(_SHOT, "")
            numbers[frame] = int(number)
        return cls(path.name, shots, numbers)

    def shots_of(self, frames: Iterable[str]) -> list[ShotFrames]:
        """The shots that frames, by name, make; those that the table does not name are in none.

        A row is of one frame: of that with the very name, or else of the first that it may mean.
        """
        rows, frame_of = FrameTable(self.shots), dict[str, str]()
        for frame in frames:
            row = rows.name_there(frame)
            if row is not None and (frame == row or row not in frame_of):
                frame_of[row] = frame
        found: dict[str, list[str]] = {}
        for row in frame_of:
            found.setdefault(self.shots[row], []).append(row)
        return [
            ShotFrames(
                name or self.told_by,
                tuple(frame_of[row] for row in own),
                tuple(self.numbers[row] for row in own),
            )
            for name in natsorted(found)
            for own in [sorted(found[name], key=self.numbers.__getitem__)]
        ]


def require_in_order(shots: Sequence[ShotFrames]) -> None:
    """Refuse shots that have no order in time.

    Raises:
        NotInOrderError: no shot has three frames, or two frames of one have the same number, which
            would be held against each other's cameras.
    """
    if all(len(shot.frames) < 3 for shot in shots):
        raise NotInOrderError(
            "no three frames follow each other (their names end with"
            " no numbers that count on); say which do in a frames.csv: frame,shot,number"
        )
    for shot in shots:
        for place, (before, number) in enumerate(pairwise(shot.numbers)):
            if before == number:
                one, other = shot.frames[place : place + 2]
                raise NotInOrderError(
                    f"the frames {one} and {other} of the shot {shot.name}"
                    f" both have the number {number}; say in frames.csv which shots they belong to:"
                    " frame,shot,number"
                )


def shots_in(frames: Iterable[str], order: FrameOrder | None) -> list[ShotFrames]:
    """The shots of frames: as the dataset's table has them, or without one by their names."""
    return shots_by_name(frames) if order is None else order.shots_of(frames)


def shots_by_name(frames: Iterable[str]) -> list[ShotFrames]:
    """Shots by the names of frames: what comes before a number names the shot.

    Where numbers leave more than 25 usual steps out, another shot begins. Frames whose names do not
    end with a number follow no other.
    """
    found: dict[str, list[tuple[int, str]]] = {}
    for frame in frames:
        if match := _NUMBERED.fullmatch(frame):
            found.setdefault(match[1], []).append((int(match[2]), frame))
    shots = []
    for name in natsorted(found):
        runs = _without_gaps(sorted(found[name]))
        for own in runs:
            first = own[0][1]
            named = first if len(runs) > 1 or not name.strip("_- .") else name.rstrip("_- .")
            shots.append(ShotFrames(named, tuple(f for _, f in own), tuple(n for n, _ in own)))
    return shots


def shots_from(begins: Sequence[range], frames: Sequence[str]) -> list[ShotFrames]:
    """Shots between the cuts of a video or a folder of pictures.

    Args:
        begins: the numbers of the frames of each shot.
        frames: names of all frames, by number.
    """
    return [
        ShotFrames(frames[own[0]], tuple(frames[n] for n in own), tuple(own))
        for own in begins
        if len(own)
    ]


def _without_gaps(numbered: list[tuple[int, str]]) -> list[list[tuple[int, str]]]:
    steps = sorted(b[0] - a[0] for a, b in pairwise(numbered) if b[0] > a[0])
    most = _MOST_STEPS_MISSING * (steps[(len(steps) - 1) // 2] if steps else 1)
    runs = [[numbered[0]]]
    for before, now in pairwise(numbered):
        if now[0] == before[0]:
            continue  # 7 and 007
        if now[0] - before[0] > most:
            runs.append([])
        runs[-1].append(now)
    return runs


MODEL = "model"  # group by the model of the camera
_TAG_FRAME, _SET = "frame", "set"
_TAGS_ADVICE = "the file needs a header like: frame,stadium,camera type"


@dataclass(frozen=True)
class Grouping:
    """Groups of the frames of one set.

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
        rows: (set, frame) -> one value a column, empty if absent; the set is None where
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
        problem = "" if columns else f"has no column of tags next to {_TAG_FRAME!r}"
        problem = f"column {names.index('') + 1} has no name" if "" in names else problem
        if problem:
            raise InputError(path, problem, place="line 1", advice=_TAGS_ADVICE)
        rows = {
            (row.get(_SET), row[_TAG_FRAME]): tuple(row[name] for name in columns)
            for _, row in table
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
    """Return what to group by, each once.

    Args:
        further: what else a person may ask for, to be named where something is asked for that
            there is not.

    Raises:
        UsageError: there is no such tag.
    """
    columns = () if tags is None else tags.columns
    if MODEL in columns and MODEL in by:
        raise UsageError(
            f"{tags.path if tags else ''}: the tag {MODEL!r} cannot be distinguished from the model"
            " of the camera (rename the column)"
        )
    for name in by:
        if name != MODEL and name not in columns:
            there = ", ".join((MODEL, *further, *columns))
            more = "" if tags else "; further ones come from --tags FILE"
            raise UsageError(f"cannot group by {name!r}: there is {there}{more}")
    return tuple(dict.fromkeys(by))


SHOT = "shot"  # by the names of the frames, or the dataset's frames.csv
NONE = "none"  # every frame for itself
_MIN_RELIABLE = 5


@dataclass(frozen=True, eq=False)
class Clusters:
    """The clusters of F frames.

    Attributes:
        numbers: (F,) the cluster of each frame, from 0 on.
        described: what they were found by, in words.
        by: a tag, `SHOT`, or `NONE`.
    """

    numbers: IntArray
    described: str
    by: str

    @property
    def count(self) -> int:
        """Return their number."""
        return int(self.numbers.max()) + 1 if len(self.numbers) else 0

    @property
    def thing(self) -> str:
        """Return what there are so many of."""
        return "frame" if self.by == NONE else "cluster"

    @property
    def caution(self) -> str:
        """A sentence where there are too few for any interval, else empty."""
        if self.count >= _MIN_RELIABLE:
            return ""
        return f"Of fewer than {_MIN_RELIABLE} {self.thing}s no interval is to be relied on."


def clusters_of(
    frames: Sequence[str],
    by: str | None,
    values: Mapping[str, str | None],
    order: FrameOrder | None = None,
) -> Clusters:
    """The clusters of frames.

    Args:
        frames: names.
        by: a tag, `SHOT`, `NONE`; None for shots if there are any to be found.
        values: of the tag, by frame. A frame without one is a cluster of its own. A tag called
            `SHOT` counts rather than table and names.
        order: the dataset's table of frames; without it names give the shots.

    Raises:
        UsageError: a tag that no frame has, or shots where none can be found.
    """
    if by == NONE:
        return _alone(frames, "every frame for itself")
    if by not in (None, SHOT) or (by == SHOT and values):
        if not any(values.get(frame) for frame in frames):
            raise UsageError(f"no frame has a value of {by!r} to cluster by")
        return _by_value(frames, [values.get(frame) for frame in frames], f"by {by}", by or "")
    found = shots_in(frames, order)
    shot_of = {frame: str(n) for n, shot in enumerate(found) for frame in shot.frames}
    told_by = "by names" if order is None else f"by {order.told_by}"
    if len(found) > 1 and any(len(shot.frames) > 1 for shot in found):
        return _by_value(
            frames, [shot_of.get(f) for f in frames], f"of one shot each, {told_by}", SHOT
        )
    if by == SHOT:
        raise UsageError("names of frames contain no shots to cluster by: give a tag with --tags")
    if order is not None and len(frames) > 1 and len(shot_of) == len(frames):
        words = f"all frames are of one shot, {told_by}, and true intervals are wider"
        return _alone(frames, f"not clustered: {words}")
    return _alone(
        frames,
        "not clustered: neither tag nor names say which frames are alike, and where some are, true"
        " intervals are wider",
    )


def _by_value(frames: Sequence[str], values: Sequence[str | None], words: str, by: str) -> Clusters:
    places: dict[tuple[bool, str], int] = {}
    keys = [
        (False, frame) if not value else (True, value)
        for frame, value in zip(frames, values, strict=True)
    ]
    numbers = np.array([places.setdefault(key, len(places)) for key in keys], dtype=np.intp)
    alone = sum(not tagged for tagged, _ in keys)
    rest = f", {pluralize(alone, 'frame')} without" if alone else ""
    return Clusters(numbers, f"{pluralize(len(places), 'cluster')} {words}{rest}", by)


def _alone(frames: Sequence[str], words: str) -> Clusters:
    return Clusters(np.arange(len(frames), dtype=np.intp), words, NONE)
