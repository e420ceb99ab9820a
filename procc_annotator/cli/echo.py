"""Print lines safely and condense problems of many files."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from itertools import groupby

import typer

from procc_annotator.errors import printable
from procc_annotator.messages import pluralize


def echo(text: object = "", *, err: bool = False) -> None:
    """Print a line; what a terminal would obey, in a name of a file for instance, is escaped."""
    typer.echo(printable(str(text), keep="\n"), err=err)  # noqa: TID251


def example_epilog(commands: str) -> str:
    """The end of a command's help: examples, as they are typed, under their heading."""
    return f"\nExamples:\n\n\b\n{commands}"


_MAX_LISTED = 5
_LONGEST_PLACE = 60  # characters of a place in a file

# A problem -> where it is, and what many of them share.
_OF_FRAME = re.compile(r"(.*?: )frame (\d+)(: .*)")


def condense_problems(problems: Iterable[str]) -> list[str]:
    """The problems (``file: what is wrong`` or ``file: place: what is wrong``), those of more than
    a few files, or places of a file, that have the same words in one line."""
    return _condensed(_condensed(_by_frames(dict.fromkeys(problems)), _by_file), _by_place)


def _by_frames(problems: Iterable[str]) -> list[str]:
    """Frames of a video with the same problem in one line: ``3 frames (20 to 21, 40)``."""
    numbers: dict[str | tuple[str, str], list[int]] = {}
    for problem in problems:
        found = _OF_FRAME.fullmatch(problem)
        same = numbers.setdefault(problem if found is None else (found[1], found[3]), [])
        if found is not None:
            same.append(int(found[2]))
    return [
        same if isinstance(same, str) else f"{same[0]}{_frames_words(sorted(own))}{same[1]}"
        for same, own in numbers.items()
    ]


def _frames_words(numbers: list[int]) -> str:
    if len(numbers) == 1:
        return f"frame {numbers[0]}"
    runs = [list(run) for _, run in groupby(numbers, lambda n: n - numbers.index(n))]
    named = (f"{run[0]} to {run[-1]}" if len(run) > 1 else str(run[0]) for run in runs)
    return f"{pluralize(len(numbers), 'frame')} ({', '.join(named)})"


def _condensed(problems: Iterable[str], parted: Callable[[str], tuple[str, str]]) -> list[str]:
    alike: dict[str, list[str]] = {}
    for problem in problems:
        alike.setdefault(parted(problem)[1], []).append(problem)
    lines = []
    for some in alike.values():
        if len(some) <= _MAX_LISTED:
            lines += some
            continue
        first = parted(some[0])[0]
        lines.append(f"{first} and {len(some) - 1} more{some[0][len(first) :]}")
    return lines


def _by_file(problem: str) -> tuple[str, str]:
    file, colon, words = problem.partition(": ")
    return (file, words) if colon else ("", problem)


def _by_place(problem: str) -> tuple[str, str]:
    """Only places of one file are shared."""
    file, colon, rest = problem.partition(": ")
    place, second, words = rest.partition(": ")
    if not colon or not second or len(place) > _LONGEST_PLACE or " (" in place:
        return "", problem
    return f"{file}: {place}", f"{file}: {words}"
