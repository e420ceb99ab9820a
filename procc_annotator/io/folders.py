"""What lies in a folder, and in the folders below it.

Hidden files and macOS's resource forks do not count.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path, PurePosixPath

from natsort import natsorted

from procc_annotator.errors import InputError

# A folder with such a name stands where a file was expected; any other may be a split (``v1.2``).
_FILE_SUFFIXES = frozenset(
    {".json", ".npy", ".npz", ".mat", ".txt", ".homographymatrix", ".yml", ".yaml", ".xml"}
)
# Deeper folders, or more files than any set has, are a whole disk or a trap.
DEEPEST = 24
_MOST_ENTRIES = 1_000_000
_RESOURCE_FORKS = "__MACOSX"


def walk(
    root: Path, on_unread: Callable[[InputError], None] | None = None
) -> Iterator[tuple[str, list[str]]]:
    """Every folder below a place with the names in it that are not folders: the place itself
    first, then each folder before those in it, in natural order.

    A folder that is a link is not gone into: it may lead out, or in a circle.

    Args:
        root: the place.
        on_unread: told of each folder below it that cannot be listed, which is then left out; None:
            that is raised.

    Yields:
        The folder below the place with a slash at its end (``game/img1/``; empty for the place
        itself), and its files' names in no order.

    Raises:
        InputError: a folder cannot be listed, or there are more, or deeper ones, than any set has.
    """
    waiting, met = [""], 0
    while waiting:
        folder = waiting.pop()
        if folder.count("/") > DEEPEST:
            raise too_deep_message(root)
        try:
            names, folders = entries(root / folder)
        except InputError as error:
            if on_unread is None or not folder:
                raise
            on_unread(error)
            continue
        met += len(names) + len(folders)
        if met > _MOST_ENTRIES:
            raise InputError(
                root,
                f"holds more than {_MOST_ENTRIES} files and folders",
                advice="name a folder further down",
            )
        yield folder, names
        inner = [f"{folder}{name}/" for name in natsorted(folders, reverse=True)]
        waiting += (name for name in inner if not os.path.islink(root / name.rstrip("/")))


def too_deep_message(path: Path) -> InputError:
    """What is said of a tree with folders deeper than `DEEPEST`."""
    return InputError(
        path, f"holds folders more than {DEEPEST} deep", advice="name a folder further down"
    )


def entries(folder: Path) -> tuple[list[str], list[str]]:
    """Names of everything that is not a folder, and of the folders; hidden ones left out.

    A folder named like a file (``00001.json/``) counts as a file, so that reading it is an error.
    """
    names: list[str] = []
    folders: list[str] = []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if entry.name[0] == "." or entry.name == _RESOURCE_FORKS:
                    continue
                is_folder = _is_folder(entry) and not _named_like_file(entry.name)
                (folders if is_folder else names).append(entry.name)
    except OSError as error:
        raise InputError(folder, f"cannot be listed: {error.strerror or error}") from error
    return names, folders


def _is_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:  # a link in a circle is one file that cannot be read, not the end of the rest
        return False


def _named_like_file(name: str) -> bool:
    return PurePosixPath(name).suffix.lower() in _FILE_SUFFIXES


def is_listed(name: str) -> bool:
    """Whether a file or folder of this name, in an archive, is one to be listed."""
    parts = PurePosixPath(name).parts
    return (
        bool(parts) and _RESOURCE_FORKS not in parts and not any(p.startswith(".") for p in parts)
    )
