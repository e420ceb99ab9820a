"""Frames of one instant, taken by different cameras: told by ``views.csv`` or by their names.

``views.csv`` lies in the dataset's folder. It has a header; ``frame`` and ``instant`` are needed,
``view`` names the camera. Frames of the same instant are one group. A pattern of names is only a
way to write that file: who has the dataset has the groups.
"""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from natsort import natsorted

from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.words import did_you_mean, shown
from procc_annotator.io.atomic import write_atomic
from procc_annotator.io.csv_text import csv_cells, formula_text, no_formula

VIEWS_FILE = "views.csv"

_FRAME, _INSTANT, _VIEW = "frame", "instant", "view"
_ADVICE = "the file needs a header like: frame,instant,view"
_PLACES = re.compile(r"\{([^{}]*)\}")


@dataclass(frozen=True, slots=True)
class ViewOf:
    """When a frame was taken, and by which camera; "" where nobody says."""

    instant: str
    view: str = ""


@dataclass(frozen=True)
class ViewGroups:
    """The groups of a dataset; a frame that is in none stands alone.

    Attributes:
        frames: frame -> when and by which camera it was taken.
        told_by: what says so, in words; "" where nothing does.
        lines: frame -> its line in the file that says so.
    """

    frames: Mapping[str, ViewOf] = field(default_factory=dict)
    told_by: str = field(default="", compare=False)
    lines: Mapping[str, int] = field(default_factory=dict, compare=False)

    def instant_of(self, frame: str) -> str | None:
        """When a frame was taken; None where nobody says."""
        found = self.frames.get(frame)
        return None if found is None else found.instant

    def view_of(self, frame: str) -> str:
        """The camera of a frame; "" where nobody says."""
        found = self.frames.get(frame)
        return "" if found is None else found.view

    def others(self, frame: str) -> tuple[str, ...]:
        """The other frames of a frame's instant, in natural order."""
        instant = self.instant_of(frame)
        group = () if instant is None else self.groups[instant]
        return tuple(name for name in group if name != frame)

    def strange_rows(self, frames: Iterable[str]) -> tuple[str, ...]:
        """One sentence for each row that names a frame which there is not.

        Args:
            frames: names of all there are.
        """
        there = set(frames)
        return tuple(
            f"{self.told_by}: line {line}: there is neither a picture nor an annotation of"
            f" {shown(name)}{did_you_mean(name, there)}"
            for name, line in self.lines.items()
            if name not in there
        )

    @cached_property
    def groups(self) -> dict[str, tuple[str, ...]]:
        """Instant -> its frames; both in natural order."""
        found: dict[str, list[str]] = {}
        for frame in natsorted(self.frames):
            found.setdefault(self.frames[frame].instant, []).append(frame)
        return {instant: tuple(found[instant]) for instant in natsorted(found)}


def load_views(path: Path) -> ViewGroups:
    """Read a ``views.csv``; one that is not there groups nothing.

    Raises:
        InputError: it cannot be read, or what is wrong and where.
    """
    try:
        table = csv_cells(path)
    except InputError as error:
        if isinstance(error.__cause__, FileNotFoundError):
            return ViewGroups()
        raise
    return _read(path, table)


def save_views(path: Path, groups: ViewGroups) -> None:
    """Write a ``views.csv`` in one step.

    Raises:
        SaveError: it could not be written.
    """
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow((_FRAME, _INSTANT, _VIEW))
    for frame in natsorted(groups.frames):
        of = groups.frames[frame]
        writer.writerow([no_formula(cell) for cell in (frame, of.instant, of.view)])
    write_atomic(path, text.getvalue().encode(), inside=path.parent)


def groups_by_name(names: Iterable[str], pattern: str) -> ViewGroups:
    """Groups told by the names of frames.

    Args:
        names: of all frames; those that do not fit the pattern stand alone.
        pattern: such as ``{instant}_{view}``, or a regular expression for the whole name with a
            group ``(?P<instant>...)`` and perhaps ``(?P<view>...)``.

    Raises:
        UsageError: the pattern names no instant, or cannot be understood; or no two frames are of
            one instant by it.
    """
    expression = _expression(pattern)
    found: dict[str, ViewOf] = {}
    total = 0
    for name in names:
        total += 1
        if (match := expression.fullmatch(name)) is not None:
            parts = match.groupdict()
            if parts[_INSTANT]:
                found[name] = ViewOf(parts[_INSTANT], parts.get(_VIEW) or "")
    groups = ViewGroups(found, f"the pattern {pattern!r}")
    _refuse_the_same_view(groups, pattern)
    if not any(len(frames) > 1 for frames in groups.groups.values()):
        fit = f"{len(found)} of {total} names fit it" if found else "no name fits it"
        raise UsageError(f"the pattern {pattern!r} groups no frames: {fit}")
    return groups


def _refuse_the_same_view(groups: ViewGroups, pattern: str) -> None:
    seen: dict[ViewOf, str] = {}
    for name, of in groups.frames.items():
        if of.view and (other := seen.setdefault(of, name)) != name:
            raise UsageError(
                f"the pattern {pattern!r} takes {other} and {name} both for the view {of.view!r} at"
                f" instant {of.instant!r}: a camera takes one frame at a time"
            )


def _expression(pattern: str) -> re.Pattern[str]:
    source = pattern if "(?P<" in pattern else _template(pattern)
    try:
        expression = re.compile(source)
    except re.error as error:
        raise UsageError(f"the pattern {pattern!r} cannot be understood: {error}") from error
    if _INSTANT not in expression.groupindex:
        raise UsageError(
            f"the pattern {pattern!r} names no instant: write e.g. {{instant}}_{{view}},"
            " or a regular expression with a group (?P<instant>...)"
        )
    return expression


def _template(pattern: str) -> str:
    """The expression of ``{instant}_{view}``: an instant goes up to the text that ends it."""
    parts = _PLACES.split(pattern)
    texts, places = parts[::2], parts[1::2]
    found = [re.escape(texts[0])]
    for i, place in enumerate(places):
        if place not in (_INSTANT, _VIEW) or place in places[:i]:
            raise UsageError(
                f"the pattern {pattern!r} has {{{place}}}: {{instant}} and {{view}} may stand in it"
                " once each"
            )
        found.append(f"(?P<{place}>{_what_fits(place, texts[i], texts[i + 1])})")
        found.append(re.escape(texts[i + 1]))
    return "".join(found)


def _what_fits(place: str, before: str, after: str) -> str:
    if place == _VIEW:
        return ".+?"
    borders = "".join(dict.fromkeys(before[-1:] + after[:1]))
    return f"[^{re.escape(borders)}]+" if borders else r"\d+"


def _read(path: Path, table: list[tuple[int, list[str]]]) -> ViewGroups:
    if not table:
        raise InputError(path, "is empty", advice=_ADVICE)
    header = [cell.strip() for cell in table[0][1]]
    for needed in (_FRAME, _INSTANT):
        if header.count(needed) != 1:
            problem = "no column" if needed not in header else "two columns"
            raise InputError(
                path, f"has {problem} {needed!r}", place=f"line {table[0][0]}", advice=_ADVICE
            )
    found: dict[str, ViewOf] = {}
    lines: dict[str, int] = {}
    taken: dict[ViewOf, int] = {}
    for line, cells in table[1:]:
        place = f"line {line}"
        if len(cells) != len(header):
            problem = f"has {len(cells)} cells, expected {len(header)} as in the header"
            raise InputError(path, problem, place=place)
        row = {k: formula_text(c.strip()) for k, c in zip(header, cells, strict=True)}
        frame = row[_FRAME]
        if not frame:
            raise InputError(path, "names no frame", place=place)
        if frame in lines:
            problem = f"frame {frame!r} again, after line {lines[frame]}"
            raise InputError(path, problem, place=place, advice="keep one of them")
        lines[frame] = line
        if not row[_INSTANT]:
            continue  # the frame stands alone
        of = found[frame] = ViewOf(row[_INSTANT], row.get(_VIEW, ""))
        if of.view and (first := taken.setdefault(of, line)) != line:
            raise InputError(
                path,
                f"the view {of.view!r} at instant {of.instant!r} again, after line {first}",
                place=place,
                advice="a camera takes one frame at a time: correct one of them",
            )
    return ViewGroups(found, path.name, lines)
