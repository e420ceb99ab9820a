"""What changed from one release of a dataset to the next: frames, and elements within them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.words import count_words

_WIDTH_PX, _HEIGHT_PX = 959, 539  # that moves are told in
_LISTED = 200


@dataclass(frozen=True)
class ChangedFrame:
    """A frame whose elements are others now.

    Attributes:
        added, removed: elements.
        moved: element -> how far its farthest point is from the nearest one before, px at 960x540.
    """

    name: str
    added: tuple[str, ...]
    removed: tuple[str, ...]
    moved: tuple[tuple[str, float], ...]

    @property
    def in_words(self) -> str:
        """``+Circle central; -Goal left crossbar; Middle line (up to 2.4 px)``."""
        parts = [f"+{name}" for name in self.added] + [f"-{name}" for name in self.removed]
        parts += [f"{name} (up to {far:.1f} px)" for name, far in self.moved]
        return "; ".join(parts)


@dataclass(frozen=True)
class Changes:
    """From the release before to this one.

    Attributes:
        pictures: frames of both whose picture is another file now.
    """

    before: str
    added: tuple[str, ...]
    removed: tuple[str, ...]
    changed: tuple[ChangedFrame, ...]
    moved_splits: tuple[str, ...]
    pictures: tuple[str, ...]
    other_field: bool

    @property
    def any(self) -> bool:
        """Whether anything did."""
        frames = (self.added, self.removed, self.changed, self.moved_splits, self.pictures)
        return self.other_field or any(frames)


def changed_frame(name: str, before: FrameAnnotation, now: FrameAnnotation) -> ChangedFrame | None:
    """How a frame's elements differ; None where no point does."""
    was, is_ = _points(before), _points(now)
    moved = tuple(
        (element, _farthest(was[element], is_[element]))
        for element in is_
        if element in was and was[element] != is_[element]
    )
    added = tuple(element for element in is_ if element not in was)
    removed = tuple(element for element in was if element not in is_)
    return ChangedFrame(name, added, removed, moved) if added or removed or moved else None


def changelog(version: str, date: str, changes: Changes | None, earlier: str = "") -> str:
    """Markdown, the newest release first.

    Args:
        changes: against the release before; None for a first one.
        earlier: the changelog of the release before, without its heading.
    """
    lines = ["# Changelog", "", f"## {version} ({date})", ""]
    if changes is None:
        lines += ["The first release.", ""]
    elif not changes.any:
        lines += [f"No frame and no element differs from {changes.before}.", ""]
    else:
        lines += [f"Against {changes.before}:", "", *_lines(changes), ""]
    return "\n".join(lines) + (f"\n{earlier.strip()}\n" if earlier.strip() else "")


def _lines(changes: Changes) -> Sequence[str]:
    found = ["- **the field is another one**: scores do not compare"] if changes.other_field else []
    for what, names in (
        ("added", changes.added),
        ("removed", changes.removed),
        ("in another split", changes.moved_splits),
        ("with another picture", changes.pictures),
    ):
        if names:
            found.append(f"- {count_words(len(names), 'frame')} {what}: {_listed(names)}")
    if changes.changed:
        found.append(f"- elements of {count_words(len(changes.changed), 'frame')} changed:")
        found += [f"  - {one.name}: {one.in_words}" for one in changes.changed[:_LISTED]]
        if (more := len(changes.changed) - _LISTED) > 0:
            found.append(f"  - and {more} more frames")
    return found


def _listed(names: Sequence[str]) -> str:
    return ", ".join(names[:_LISTED]) + (", ..." if len(names) > _LISTED else "")


def _points(annotation: FrameAnnotation) -> Mapping[str, tuple[tuple[float, float], ...]]:
    return {
        line.class_name.strip(): tuple((p.u, p.v) for p in line.points)
        for line in annotation.polylines
        if line.points
    }


def _farthest(before: Sequence[tuple[float, float]], now: Sequence[tuple[float, float]]) -> float:
    return max(
        min(math.hypot((u - a) * _WIDTH_PX, (v - b) * _HEIGHT_PX) for a, b in before)
        for u, v in now
    )
