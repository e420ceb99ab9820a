"""What lies in a dataset's folder: its pictures, and where their annotations are."""

from __future__ import annotations

import os
from pathlib import Path

from natsort import natsort_keygen

from procc_annotator.errors import InputError
from procc_annotator.image.decode import PICTURE_SUFFIXES

ANNOTATIONS_FOLDER = "annotations"


def pictures_in(folder: Path) -> list[str]:
    """File names of a folder's pictures in natural order; those below it are not looked for.

    Raises:
        InputError: the folder cannot be listed.
    """
    try:
        with os.scandir(folder) as entries:
            names = [
                entry.name
                for entry in entries
                if os.path.splitext(entry.name)[1].lower() in PICTURE_SUFFIXES
                and not entry.name.startswith(".")
                and _is_file(entry)
            ]
    except OSError as error:
        raise InputError(folder, f"cannot be listed: {error.strerror or error}") from error
    return sorted(names, key=natsort_keygen())


def _is_file(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_file()
    except OSError:  # a link that leads nowhere or in a circle does not end the listing
        return False


def annotation_folder(root: Path) -> Path:
    """Where annotations of a folder's pictures are: in its ``annotations/`` if that holds any JSON,
    or beside them."""
    inner = root / ANNOTATIONS_FOLDER
    return inner if json_stems(inner) else root


def dataset_folder_of(folder: Path) -> Path | None:
    """The dataset's folder that holds these annotations: itself, or the one above where it is that
    one's ``annotations/``; None where neither holds pictures or ``annotations/``.

    Raises:
        InputError: a folder cannot be listed.
    """
    if pictures_in(folder) or annotation_folder(folder) != folder:
        return folder
    own = folder.resolve()
    return own.parent if annotation_folder(own.parent) == own else None


def json_stems(folder: Path) -> list[str]:
    """Names of a folder's JSON files without their suffix; none of a folder that is not there."""
    try:
        with os.scandir(folder) as entries:
            return [e.name[:-5] for e in entries if e.name.lower().endswith(".json")]
    except OSError:  # usually: no such folder
        return []
