"""Frames of one instant, taken by different cameras: told by ``views.csv``.

``views.csv`` lies in the dataset's folder. It has a header; ``frame`` and ``instant`` are needed,
``view`` names the camera. Frames of the same instant are one group. A pattern of names (see
`session.landmarks.view_names`) is only a way to write that file: who has the dataset has the
groups.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path

from natsort import natsorted

from procc_annotator.errors import InputError, SaveError
from procc_annotator.field.words import did_you_mean, short_repr
from procc_annotator.io.atomic import write_atomic
from procc_annotator.io.csv_text import escape_formula, read_frame_table
from procc_annotator.io.frame_names import FrameTable
from procc_annotator.io.source import read_optional

_FRAME, _INSTANT, _VIEW = "frame", "instant", "view"
_ADVICE = "the file needs a header like: frame,instant,view"


@dataclass(frozen=True, slots=True)
class ViewAssignment:
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

    frames: FrameTable[ViewAssignment] = field(default_factory=FrameTable)
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
        """The other frames of a frame's instant, in natural order, as they are called here."""
        own = self.frames.name_there(frame)
        if own is None:
            return ()
        group = self.groups[self.frames[own].instant]
        return tuple(name for name in group if name != own)

    def unknown_frames(self, frames: Iterable[str]) -> tuple[str, ...]:
        """The frames that rows name and which there are not, in the file's order.

        Args:
            frames: names of all there are.
        """
        there = FrameTable.fromkeys(frames)
        return tuple(name for name in self.lines if name not in there)

    def unknown_rows(self, frames: Iterable[str], most: int | None = None) -> tuple[str, ...]:
        """One sentence for each row that names a frame which there is not.

        Args:
            frames: names of all there are.
            most: so many sentences at most; finding what was meant takes long in a large set.
        """
        there = FrameTable.fromkeys(frames)
        return tuple(
            f"{self.told_by}: line {self.lines[name]}: there is neither a picture nor an annotation"
            f" of {short_repr(name)}{did_you_mean(name, there)}"
            for name in self.unknown_frames(there)[:most]
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
    if not path.exists():
        return ViewGroups()
    _, table = read_frame_table(path, (_INSTANT,), _ADVICE)
    found: dict[str, ViewAssignment] = {}
    taken: dict[ViewAssignment, int] = {}
    for line, row in table:
        if not row[_INSTANT]:
            continue  # the frame stands alone
        of = found[row[_FRAME]] = ViewAssignment(row[_INSTANT], row.get(_VIEW, ""))
        if of.view and (first := taken.setdefault(of, line)) != line:
            raise InputError(
                path,
                f"the view {of.view!r} at instant {of.instant!r} again, after line {first}",
                place=f"line {line}",
                advice="a camera takes one frame at a time: correct one of them",
            )
    lines = {row[_FRAME]: line for line, row in table}
    return ViewGroups(FrameTable(found), path.name, lines)


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
        writer.writerow([escape_formula(cell) for cell in (frame, of.instant, of.view)])
    write_atomic(path, text.getvalue().encode("utf-8", "backslashreplace"), inside=path.parent)


def replace_views(path: Path, groups: ViewGroups, known: bytes | None = None) -> bytes | None:
    """Write a ``views.csv`` unless there is one that says something else.

    Args:
        path: of the file.
        groups: what it is to say.
        known: the content that may be replaced; None: nothing may.

    Returns:
        None where the file says so now; else what is there, and was left as it is.

    Raises:
        SaveError: it could not be written.
    """
    try:
        there = read_optional(path)
    except InputError as error:
        raise SaveError(str(error)) from error
    if there is not None and there != known:
        try:
            same = load_views(path) == groups
        except InputError:
            same = False
        return None if same else there
    save_views(path, groups)
    return None
