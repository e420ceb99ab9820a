"""The folders that the frames of a tree lie in, as a list of frames shows them."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby


@dataclass(frozen=True, slots=True)
class Folder:
    """A folder of frames.

    Attributes:
        path: below the dataset, without a slash at its end.
        label: what it is called in the folder shown above it; folders that hold nothing but one
            other are one with it (``season/game``).
        depth: how many folders are shown above it.
        first, past: the frames in it and below it.
        own_past: the first of those that lies deeper.
        end: the place of the next folder in the list that is not below it.
    """

    path: str
    label: str
    depth: int
    first: int
    past: int
    own_past: int
    end: int = 0

    def __contains__(self, frame: int) -> bool:
        return self.first <= frame < self.past


@dataclass
class _Node:
    path: str
    first: int = -1
    own_past: int = -1
    past: int = -1
    inner: dict[str, _Node] = field(default_factory=dict)


def folders_of(names: Sequence[str]) -> tuple[Folder, ...]:
    """The folders of a tree, each before those in it; none of a flat dataset.

    Args:
        names: of the frames, folder after folder, a folder's own before those of the folders in it.
    """
    root, at = _Node(""), 0
    for folder, group in groupby(names, key=lambda name: name.rpartition("/")[0]):
        past = at + sum(1 for _ in group)
        node = root
        for part in folder.split("/") if folder else ():
            node = node.inner.setdefault(part, _Node(f"{node.path}/{part}".lstrip("/"), at, at))
            node.past = past
        if folder:
            node.own_past = past
        at = past
    found: list[Folder] = []
    for node in root.inner.values():
        _add(node, "", 0, found)
    return tuple(found)


def _add(node: _Node, above: str, depth: int, found: list[Folder]) -> None:
    while node.own_past == node.first and len(node.inner) == 1:
        (node,) = node.inner.values()
    label = node.path.removeprefix(above).lstrip("/")
    place = len(found)
    found.append(Folder(node.path, label, depth, node.first, node.past, node.own_past))
    for inner in node.inner.values():
        _add(inner, f"{node.path}/", depth + 1, found)
    found[place] = replace(found[place], end=len(found))


def rows_of(
    folders: Sequence[Folder], folded: Collection[str], shown: Sequence[int] | None
) -> list[int]:
    """What a list shows, row by row: a frame, or -1 - k for folder k; folders without a frame that
    is shown are left out.

    Args:
        folders: of `folders_of`.
        folded: paths of those whose content is not shown.
        shown: ascending, the frames that a filter lets through; None: all.
    """
    rows: list[int] = []
    place = 0
    while place < len(folders):
        folder = folders[place]
        first, own_past, past = (
            at if shown is None else bisect_left(shown, at)
            for at in (folder.first, folder.own_past, folder.past)
        )
        if first < past:
            rows.append(-1 - place)
        if first == past or folder.path in folded:
            place = folder.end
            continue
        rows += range(first, own_past) if shown is None else shown[first:own_past]
        place += 1
    return rows
