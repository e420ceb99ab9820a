"""Frames of one instant from several cameras: ``views.csv`` and groups from frame names."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import takewhile
from pathlib import Path

from natsort import natsorted

from procc_annotator.errors import InputError, SaveError, UsageError
from procc_annotator.field.formulas import did_you_mean, short_repr
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.csv_tables import encode_rows, escape_formula, read_frame_table
from procc_annotator.formats.file_source import read_optional
from procc_annotator.formats.frame_names import FrameTable

_FRAME, _INSTANT, _VIEW = "frame", "instant", "view"
_ADVICE = "the file needs a header like: frame,instant,view"


@dataclass(frozen=True, slots=True)
class ViewAssignment:
    """Instant and camera of a frame; "" if not stated."""

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
        """Return when a frame was taken; None if not stated."""
        found = self.frames.get(frame)
        return None if found is None else found.instant

    def view_of(self, frame: str) -> str:
        """The camera of a frame; "" if not stated."""
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
        """The frames that rows name and which are not among all there are, in the file's order."""
        there = FrameTable.fromkeys(frames)
        return tuple(name for name in self.lines if name not in there)

    def unknown_rows(self, frames: Iterable[str], most: int | None = None) -> tuple[str, ...]:
        """One sentence for each row that names a frame which is not among all there are; ``most``
        sentences at most: finding what was meant takes long in a large set."""
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
    """Read a ``views.csv``; one that is not there groups nothing. `InputError`, with the reason and
    the place, if it cannot be read."""
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
    """Write a ``views.csv`` in one step; `SaveError` if it could not be written."""
    rows = [(f, groups.frames[f].instant, groups.frames[f].view) for f in natsorted(groups.frames)]
    cells = ([escape_formula(cell) for cell in row] for row in rows)
    data = encode_rows([(_FRAME, _INSTANT, _VIEW), *cells])
    write_atomic(path, data, inside=path.parent)


def replace_views(path: Path, groups: ViewGroups, known: bytes | None = None) -> bytes | None:
    """Write a ``views.csv`` unless there is one that says something else than what is ``known``
    and may be replaced. `SaveError` if it could not be written.

    Returns:
        None where the file says so now; else what is there, and was left as it is.
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


INSTANT, VIEW = "instant", "view"

_PLACES = re.compile(r"\{([^{}]*)\}")
_SEPARATORS = "_- ."
# Nothing between the two: the character of the view that touches the instant.
_TOGETHER = {"{instant}{view}": 0, "{view}{instant}": -1}
# So many cameras may take a single instant; more views than instants are no cameras.
_MOST_VIEWS = 12


@dataclass(frozen=True)
class NamedViews:
    """Groups that a pattern makes of the names of frames.

    Attributes:
        groups: of the names that fit it.
        alone: the names that do not, in natural order.
        problem: why no frames can be grouped so, in one sentence; empty if they can.
    """

    groups: ViewGroups
    alone: tuple[str, ...] = ()
    problem: str = ""


def groups_by_name(names: Iterable[str], pattern: str) -> ViewGroups:
    """Groups given by the names of frames.

    Args:
        names: of all frames; those that do not fit the pattern stand alone.
        pattern: such as ``{instant}_{view}``, or a regular expression for the whole name with a
            group ``(?P<instant>...)`` and perhaps ``(?P<view>...)``.

    Raises:
        UsageError: the pattern names no instant, or cannot be understood; or no two frames are of
            one instant by it, or two are of one view.
    """
    found = views_by_name(names, pattern)
    if found.problem:
        raise UsageError(found.problem)
    return found.groups


def views_by_name(names: Iterable[str], pattern: str) -> NamedViews:
    """As `groups_by_name`, as far as names fit the pattern, with what is wrong with it.
    `UsageError` if the pattern names no instant, or cannot be understood."""
    expression = _expression(pattern)
    found: dict[str, ViewAssignment] = {}
    alone = []
    for name in names:
        if (of := _view_of(name, expression)) is None:
            alone.append(name)
        else:
            found[name] = of
    groups = ViewGroups(FrameTable(found), f"the pattern {pattern!r}")
    problem = _same_view(groups, pattern) or _no_group(groups, pattern, len(found) + len(alone))
    return NamedViews(groups, tuple(natsorted(alone)), problem)


def suggested_pattern(names: Sequence[str]) -> str:
    """A pattern that most of the names fit and that groups them; "" where none is plausible.

    Instants are rather numbers, and there are fewer cameras than instants.
    """
    best, suggestion = None, ""
    for pattern in _candidates(names):
        worth = _pattern_score(names, pattern)
        if worth is not None and (best is None or worth > best):
            best, suggestion = worth, pattern
    return suggestion


def _view_of(name: str, expression: re.Pattern[str]) -> ViewAssignment | None:
    match = expression.fullmatch(name)
    if match is None or not match[INSTANT]:
        return None
    return ViewAssignment(match[INSTANT], match.groupdict().get(VIEW) or "")


def _no_group(groups: ViewGroups, pattern: str, total: int) -> str:
    if any(len(frames) > 1 for frames in groups.groups.values()):
        return ""
    fitting = len(groups.frames)
    fit = f"{fitting} of {total} names fit it" if fitting else "no name fits it"
    return f"the pattern {pattern!r} groups no frames: {fit}"


def _same_view(groups: ViewGroups, pattern: str) -> str:
    seen: dict[ViewAssignment, str] = {}
    for name, of in groups.frames.items():
        if of.view and (other := seen.setdefault(of, name)) != name:
            return (
                f"the pattern {pattern!r} takes {other} and {name} both for the view {of.view!r} at"
                f" instant {of.instant!r}: a camera takes one frame at a time"
            )
    return ""


def _expression(pattern: str) -> re.Pattern[str]:
    source = pattern if "(?P<" in pattern else _template(pattern)
    try:
        expression = re.compile(source)
    except re.error as error:
        raise UsageError(f"the pattern {pattern!r} cannot be understood: {error}") from error
    if INSTANT not in expression.groupindex:
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
        if place not in (INSTANT, VIEW) or place in places[:i]:
            raise UsageError(
                f"the pattern {pattern!r} has {{{place}}}: {{instant}} and {{view}} may stand in it"
                " once each"
            )
        found.append(f"(?P<{place}>{_what_fits(place, texts[i], texts[i + 1])})")
        found.append(re.escape(texts[i + 1]))
    return "".join(found)


def _what_fits(place: str, before: str, after: str) -> str:
    if place == VIEW:
        return ".+?"
    borders = "".join(dict.fromkeys(before[-1:] + after[:1]))
    return f"[^{re.escape(borders)}]+" if borders else r"\d+"


# --- a pattern that fits ---


def _candidates(names: Sequence[str]) -> Iterator[str]:
    """Patterns that people name frames by, the plainest first."""
    if len(names) < 2:
        return
    pairs = zip(min(names), max(names), strict=False)
    shared = "".join(a for a, _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
    for separator in _SEPARATORS:
        if separator not in names[0]:
            continue
        # What all names begin with is no part of the instant; but then the instant may be in it.
        begin = shared[: shared.rfind(separator) + 1]
        if any(sign in begin for sign in ("{", "}", "(?P<")):
            begin = ""  # it would mean something else in a pattern
        for before in dict.fromkeys(("", begin)):
            yield f"{before}{{instant}}{separator}{{view}}"
            yield f"{before}{{view}}{separator}{{instant}}"
        known = re.escape(separator)
        yield f"(?P<instant>.+){known}(?P<view>[^{known}]+)"
        yield f"(?P<view>[^{known}]+){known}(?P<instant>.+)"
    yield from _TOGETHER


def _pattern_score(names: Sequence[str], pattern: str) -> tuple[int, int, int] | None:
    """Return how well a pattern groups names, larger is better; None if it is not plausible."""
    expression = _expression(pattern)
    found = [of for name in names if (of := _view_of(name, expression)) is not None]
    instants = Counter(of.instant for of in found)
    views = {of.view for of in found}
    grouped = sum(count for count in instants.values() if count > 1)
    if 2 * grouped <= len(names) or len(set(found)) < len(found):
        return None
    if pattern in _TOGETHER and not all(view[_TOGETHER[pattern]].isalpha() for view in views):
        return None  # it would cut a number or a date in two
    numbers = min(2 * i.isdigit() or any(map(str.isdigit, i)) for i in instants)
    if len(views) > len(instants):
        # One instant or a few: cameras have names then, and frames of one camera have numbers.
        named = not any(view[:1].isdigit() for view in views)
        if not (named and numbers and len(views) <= _MOST_VIEWS):
            return None
    return grouped, int(numbers), -len(views)
