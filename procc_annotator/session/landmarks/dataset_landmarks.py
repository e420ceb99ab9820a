"""The landmarks of a dataset, in its field: ``landmarks.json`` and ``views.csv`` in its folder."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from procc_annotator.errors import FieldError, InputError
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.model import Field
from procc_annotator.io.collections import ANNOTATIONS_FOLDER, frame_in_tree
from procc_annotator.io.folders import walk
from procc_annotator.io.frame_names import FrameTable
from procc_annotator.io.landmark_file import LANDMARKS_FILE, LandmarkFile, load_landmarks
from procc_annotator.session.dataset.dataset_folder import VIEWS_FILE, folder_of_dataset
from procc_annotator.session.dataset.picture_tree import suffix_of
from procc_annotator.session.landmarks.view_groups import ViewGroups, load_views

if TYPE_CHECKING:
    from procc_annotator.session.dataset.workspace import Workspace


def read_dataset_landmarks(dataset: Path) -> tuple[LandmarkFile, ViewGroups]:
    """What the files of a dataset say; nothing where there are none.

    Args:
        dataset: see `folder_of_dataset`.

    Raises:
        InputError: one of them cannot be used.
    """
    folder = folder_of_dataset(dataset)
    return (LandmarkFile(), ViewGroups()) if folder is None else read_landmarks_in(folder)


def read_landmarks_in(folder: Path) -> tuple[LandmarkFile, ViewGroups]:
    """What the files in a dataset's folder say; nothing where there are none.

    Raises:
        InputError: one of them cannot be used.
    """
    return load_landmarks(folder / LANDMARKS_FILE), load_views(folder / VIEWS_FILE)


def unknown_frames_message(groups: ViewGroups, workspace: Workspace) -> str:
    """What is to say of rows that name a frame which a dataset has not, in one sentence; empty
    where there are none.

    Args:
        groups: of its ``views.csv``.
        workspace: its frames; safe from any thread.
    """
    if not workspace.frames or not groups.unknown_frames(workspace.index):
        return ""
    there = {*workspace.index, *_annotated_in(workspace.annotations)}
    count = len(groups.unknown_frames(there))
    if not count:
        return ""
    (first,) = groups.unknown_rows(there, 1)
    if count == 1:
        return first
    return f"{first} (and {count - 1:,} more {'row' if count == 2 else 'rows'} like it)"


def _annotated_in(folder: Path) -> Iterator[str]:
    """The frames that annotations in a folder or below it belong to, with a picture or without."""
    for below, names in walk(folder, lambda _: None) if folder.is_dir() else ():
        for name in names:
            if suffix_of(name) == ".json":
                yield frame_in_tree(below + name, ANNOTATIONS_FOLDER)


def field_with(field: Field, landmarks: LandmarkFile, groups: ViewGroups, path: Path) -> Field:
    """The field with a dataset's landmarks.

    Args:
        path: of the landmarks' file, for errors.

    Raises:
        InputError: a landmark has the name of a class of the field; which entry it is.
    """
    instants = FrameTable((frame, of.instant) for frame, of in groups.frames.items())
    try:
        return with_landmarks(field, landmarks.landmarks, None, instants)
    except FieldError as error:
        raise InputError(path, error.problem, place=error.place, advice=error.advice) from error


def field_of_dataset_with_landmarks(field: Field, *datasets: Path) -> Field:
    """The field with the landmarks of the first of these datasets that has any.

    Raises:
        InputError: their file cannot be used.
    """
    for dataset in datasets:
        landmarks, groups = read_dataset_landmarks(dataset)
        if landmarks.landmarks:
            folder = folder_of_dataset(dataset) or dataset
            return field_with(field, landmarks, groups, folder / LANDMARKS_FILE)
    return field
