"""Which frames of a set follow each other: by a table, or by their names.

The table, ``frames.csv``, lies in the dataset's folder. It has a header; ``frame`` and ``shot`` or
``number`` are needed: the shot a frame belongs to, and its number within it or in its video. The
``track.csv`` of a track is such a table, too.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from natsort import natsorted

from procc_annotator.errors import InputError, UsageError
from procc_annotator.io.csv_text import read_frame_table
from procc_annotator.io.frame_names import FrameTable

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
    """What a table says of frames.

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
            raise InputError(path, f"has no columns {_ORDER_FRAME!r} and {_SHOT!r}", advice=_ORDER_ADVICE)
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
        """The shots that some frames make; frames that the table does not name are in none.

        A row is of one frame: of that with the very name, or else of the first that it may mean.

        Args:
            frames: names.
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

    Args:
        frames: names.
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
